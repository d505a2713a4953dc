#include "recon/gui/window.h"

#include "recon/core/operations.h"

namespace recon::gui {

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  dobra::gui::WindowOptions ours = options;
  if (ours.about.empty()) ours.about = "Restores deformed geological sections.";
  if (ours.examples.empty()) {
    ours.examples = {
        {"fold.toml", "Fold train", "Five horizons restored to a datum by constant thickness."},
        {"chain.toml", "Flattened and folded again", "A chain of two restorations, there and back."},
        {"listric.toml", "Two listric faults", "Normal faults undone by vertical shear, the younger first."},
        {"thrust.toml", "Thrust with a ramp", "A fault-bend fold moved back along its thrust."},
        {"cosine.toml", "Cosine fold", "Offset curves of a fold, flattened."},
    };
  }
  return dobra::gui::run_window(core::program(), file, ours);
}

}  // namespace recon::gui
