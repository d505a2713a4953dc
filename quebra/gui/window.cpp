#include "quebra/gui/window.h"

#include "quebra/core/operations.h"
#include "quebra/core/surface_marks.h"
#include "quebra/core/surface_start.h"
#include "quebra/gui/control_drag.h"
#include "quebra/gui/crack_panel.h"
#include "quebra/gui/crack_tool.h"
#include "quebra/gui/part_tool.h"
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
                 .make = make_crack_tool},
                {.name = "part",
                 .text = "Choose parts",
                 .help =
                     "Leaves parts of surfaces out of the mesh, or takes them in, by clicks in the chart and in space",
                 .icon = draw_part,
                 .key = QKeySequence(Qt::Key_B),
                 .make = make_part_tool}},
      .panels = {{.name = "cracks",
                  .title = "Cracks",
                  .make = [](const dobra::gui::Desk& desk, QWidget* parent) -> QWidget* {
                    return new CrackPanel(desk, parent);
                  }}},
      .space = {.clicked = choose_part,
                .draggable = {core::controls_layer},
                .switches =
                    {
                        {"normals", "Normals", "Which way the triangles face", {core::normals_layer}},
                        {"isocurves", "u, v lines", "Lines of constant u and v", {core::isocurves_layer}},
                        {"controls",
                         "Control points",
                         "The points that curves and surfaces are given by; drag them",
                         {core::controls_layer, "control_lines"}},
                    },
                .dragged = make_control_drag()},
      .files = {{core::brep_files(), core::document_of_brep}}};
}

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  return dobra::gui::run_window(core::program(), window_part(), file, options);
}

}  // namespace quebra::gui
