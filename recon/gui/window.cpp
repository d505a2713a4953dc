#include "recon/gui/window.h"

#include "recon/core/operations.h"

namespace recon::gui {

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  dobra::gui::WindowOptions ours = options;
  if (ours.about.empty()) ours.about = "Restores deformed geological sections.";
  return dobra::gui::run_window(core::program(), file, ours);
}

}  // namespace recon::gui
