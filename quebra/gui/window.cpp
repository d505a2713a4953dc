#include "quebra/gui/window.h"

#include "quebra/core/operations.h"
#include "quebra/gui/crack_panel.h"
#include "quebra/gui/crack_tool.h"
#include "shared/gui/window_part.h"

namespace quebra::gui {

dobra::gui::WindowPart window_part() {
  return {
      .about = "Prepares finite-element meshes of fractured plane solids.",
      .examples =
          {
              {"plate_with_hole.toml", "Plate with a hole", "A quarter of it, meshed with and without offset curves."},
              {"cracked_plate.toml", "Branched crack",
               "A crack through two materials, with small elements at its tips."},
              {"edge_crack.toml", "Edge crack in tension", "Mesh, analysis and stress intensity factors."},
          },
      .tools = {{.name = "crack",
                 .text = "Crack",
                 .help = "Draws a crack, from the border or inside, with its length and its angle to the border",
                 .icon = draw_crack,
                 .key = QKeySequence(Qt::Key_K),
                 .make = make_crack_tool}},
      .panels = {
          {.name = "cracks", .title = "Cracks", .make = [](const dobra::gui::Desk& desk, QWidget* parent) -> QWidget* {
             return new CrackPanel(desk, parent);
           }}}};
}

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  return dobra::gui::run_window(core::program(), window_part(), file, options);
}

}  // namespace quebra::gui
