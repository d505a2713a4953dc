#include "quebra/gui/window.h"

#include "quebra/core/operations.h"

namespace quebra::gui {

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  dobra::gui::WindowOptions ours = options;
  if (ours.about.empty()) ours.about = "Prepares finite-element meshes of fractured plane solids.";
  if (ours.examples.empty()) {
    ours.examples = {
        {"plate_with_hole.toml", "Plate with a hole", "A quarter of it, meshed with and without offset curves."},
        {"cracked_plate.toml", "Branched crack", "A crack through two materials, with small elements at its tips."},
        {"edge_crack.toml", "Edge crack in tension", "Mesh, analysis and stress intensity factors."},
    };
  }
  return dobra::gui::run_window(core::program(), file, ours);
}

}  // namespace quebra::gui
