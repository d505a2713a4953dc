#include "quebra/gui/window.h"

#include "quebra/core/operations.h"

namespace quebra::gui {

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  dobra::gui::WindowOptions ours = options;
  if (ours.about.empty()) ours.about = "Prepares finite-element meshes of fractured plane solids.";
  return dobra::gui::run_window(core::program(), file, ours);
}

}  // namespace quebra::gui
