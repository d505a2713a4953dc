// The figure of loft.md.
#include <cmath>

#include "shared/surf/loft/cut.h"
#include "shared/surf/loft/through.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
namespace loft = surf::loft;

/// A fold whose axis bends and plunges.
double fold(double x, double y) {
  return 700.0 - 0.06 * y + (260.0 - 0.015 * y) * std::cos((x - 1100.0 - 0.15 * y) / 477.5);
}

base::Result<loft::Surfaces> fold_surfaces() {
  std::vector<loft::Section> sections;
  for (const auto& corners : {std::vector<Point>{{0, 0}, {6000, 0}},
                              {{0, 1500}, {6000, 1700}},
                              {{0, 3000}, {6000, 3100}},
                              {{0, 4600}, {6000, 4500}}}) {
    DOBRA_TRY(loft::PlanTrace trace, loft::PlanTrace::make(corners));
    loft::Section section{"", std::move(trace), {}};
    loft::SectionLine line{"top", loft::LineKind::Horizon, {}};
    for (int i = 0; i <= 80; ++i) {
      const double s = section.trace.length() * i / 80.0;
      const Point p = section.trace.on_map(s);
      line.line.points.push_back({s, fold(p.x, p.y)});
    }
    section.lines.push_back(std::move(line));
    section.name = "section";
    sections.push_back(std::move(section));
  }
  return loft::surfaces_through(std::move(sections));
}

base::Result<scene::Picture> loft_figure() {
  DOBRA_TRY(const loft::Surfaces made, fold_surfaces());
  DOBRA_TRY(const loft::PlanTrace along, loft::PlanTrace::make({{300, 700}, {5700, 3900}}));
  DOBRA_TRY(const std::vector<loft::Contour> contours, loft::contours(made.surfaces[0], 50.0));
  std::vector<geom::Polyline> levels, traces;
  for (const loft::Contour& contour : contours) {
    for (const auto& line : contour.lines) {
      geom::Polyline& level = levels.emplace_back();
      for (const auto p : line) level.points.push_back({p.x, p.y});
    }
  }
  for (const loft::Section& section : made.sections) traces.push_back(chain(section.trace.corners()));
  std::vector<geom::Polyline> cut;
  std::vector<Point> exact;
  for (const loft::CutLine& line : loft::cut_along(made.surfaces, along, made.size).lines) cut.push_back(line.line);
  for (int i = 0; i <= 60; ++i) {
    const double s = along.length() * i / 60.0;
    const Point p = along.on_map(s);
    exact.push_back({s, fold(p.x, p.y)});
  }
  scene::Picture picture;
  picture.panels = {
      panel("On the map",
            {lines("Contours every 50 m", stroke(grey, 0.7), levels), lines("Sections", stroke(blue, 1.6), traces),
             lines("Trace of the cut", stroke(red, 1.6, scene::Dash::Dashed), {chain(along.corners())})},
            200.0, {"x [m]", "y [m]"}),
      panel("The new section", {lines("Cut", stroke(red, 1.4), cut), markers("Fold", dots(ink, 2.6), exact)}, 150.0,
            {"distance [m]", "z [m]"})};
  picture.panels[1].vertical_exaggeration = 2.0;
  picture.arrangement = scene::Arrangement::Row;
  return picture;
}

}  // namespace

std::vector<Figure> loft_figures() { return {{"loft", loft_figure}}; }

}  // namespace dobra::figures
