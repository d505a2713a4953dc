#include "quebra/gui/window.h"

#include <QPainter>
#include <QPolygonF>

#include "quebra/core/operations.h"
#include "quebra/core/solid_layers.h"
#include "quebra/core/surface_marks.h"
#include "quebra/core/surface_start.h"
#include "quebra/gui/control_drag.h"
#include "quebra/gui/crack_panel.h"
#include "quebra/gui/crack_tool.h"
#include "quebra/gui/part_tool.h"
#include "quebra/gui/solids_shown.h"
#include "quebra/gui/surfaces_shown.h"
#include "shared/gui/window_part.h"

namespace quebra::gui {

namespace {

void draw_normals(QPainter& painter) {
  painter.drawPolyline(QPolygonF({{3, 19}, {9, 15}, {15, 15}, {21, 19}}));
  for (const double x : {7.0, 12.0, 17.0}) {
    painter.drawLine(QPointF(x, 15), QPointF(x, 5));
    painter.drawPolyline(QPolygonF({{x - 2, 8}, {x, 5}, {x + 2, 8}}));
  }
}

void draw_isocurves(QPainter& painter) {
  for (const double shift : {5.0, 12.0, 19.0}) {
    painter.drawPolyline(QPolygonF({{3, shift}, {9, shift - 2}, {15, shift + 1}, {21, shift - 1}}));
    painter.drawPolyline(QPolygonF({{shift, 3}, {shift - 1, 9}, {shift + 1, 15}, {shift, 21}}));
  }
}

void draw_controls(QPainter& painter) {
  const QPolygonF net({{4, 18}, {9, 6}, {16, 6}, {20, 17}});
  painter.drawPolyline(net);
  painter.setBrush(painter.pen().color());
  for (const QPointF& point : net) painter.drawEllipse(point, 2, 2);
}

/// Two blocks, apart.
void draw_shells(QPainter& painter) {
  painter.drawRect(QRectF(3, 4, 7, 16));
  painter.drawRect(QRectF(14, 4, 7, 16));
  painter.drawLine(QPointF(10.5, 12), QPointF(13.5, 12));
}

}  // namespace

dobra::gui::WindowPart window_part() {
  return {
      .about =
          "Prepares finite-element meshes of fractured plane solids and of surfaces and shells in space, and "
          "analyses the plane ones.",
      .examples =
          {
              {"plate_with_hole.toml", "Plate with a hole", "A quarter of it, meshed with and without offset curves."},
              {"cracked_plate.toml", "Branched crack",
               "A crack through two materials, with small elements at its tips."},
              {"edge_crack.toml", "Edge crack in tension", "Mesh, analysis and stress intensity factors."},
              {"surfaces/cracked_shell.toml", "Trimmed shell with a crack",
               "A panel of a cylinder with a window, in its chart and in space, and its decks for CalculiX and "
               "Nastran."},
              {"solids/pillar.toml", "Mine pillar of solids",
               "Blocks, a dyke and bores, combined step by step; its section is meshed and analysed."},
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
      .space =
          {.clicked =
               [](const dobra::gui::Desk& desk, const dobra::gui::stage::ItemAt& item) {
                 choose_part(desk, item);
                 tell_face(desk, item);
               },
           .draggable = {core::controls_layer},
           .switches =
               {
                   {"normals", "Normals", "Which way the triangles face", draw_normals, {core::normals_layer}},
                   {"isocurves", "u, v lines", "Lines of constant u and v", draw_isocurves, {core::isocurves_layer}},
                   {"controls",
                    "Control points",
                    "The points that curves and surfaces are given by; drag them",
                    draw_controls,
                    {core::controls_layer, "control_lines"}},
                   {"exploded",
                    "Shells apart",
                    "Draws the shells of a solid away from each other",
                    draw_shells,
                    {core::exploded_layer, core::exploded_edges_layer},
                    {"space/solid", "space/solid_edges"}},
               },
           .panel_of = chart_with,
           .panel = chart_panel,
           .section = make_solid_section(),
           .dragged = make_control_drag()},
      .files = {{core::brep_files(), core::document_of_brep}}};
}

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  return dobra::gui::run_window(core::program(), window_part(), file, options);
}

}  // namespace quebra::gui
