// Figures of docs/algorithms/offset.md: those of [carvalho2005offset], with stand-ins where its curves are not known.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "shared/offset/offset.h"
#include "shared/offset/stepper/stepper.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using offset::Treatment;

scene::Layer base_line(const geom::Polyline& base) { return lines("base", stroke(ink, 2.2), {base}); }

base::Result<scene::Panel> family(const std::string& title, const geom::Polyline& base,
                                  const offset::DistanceRule& rule, const offset::OffsetOptions& options,
                                  double margin) {
  DOBRA_TRY(const std::vector<double> distances, offset::distances(rule));
  DOBRA_TRY(const auto curves, offset::offset(base, distances, options));
  std::vector<geom::Polyline> pieces;
  for (const offset::OffsetCurve& curve : curves) {
    for (const offset::OffsetPiece& piece : curve.pieces) pieces.push_back(offset::chords(piece, base).polyline);
  }
  return panel(title, {lines("offset curves", stroke(blue, 0.8), std::move(pieces)), base_line(base)}, margin);
}

/// Untreated above treated.
base::Result<scene::Picture> both_treatments(const geom::Polyline& base, const offset::DistanceRule& rule) {
  scene::Picture picture{{}, {}, scene::Arrangement::Column};
  const offset::OffsetOptions raw{.treatment = Treatment::Untreated, .join = offset::Join::Bisector};
  DOBRA_TRY(scene::Panel untreated, family("Untreated", base, rule, raw, 0.2));
  DOBRA_TRY(scene::Panel treated, family("Treated", base, rule, {.join = offset::Join::Bisector}, 0.2));
  treated.extent->add(*untreated.extent);
  picture.panels = {std::move(untreated), std::move(treated)};
  return picture;
}

/// Two folds of different width; the curves lie below.
base::Result<scene::Picture> figures_3_and_6() {
  geom::Polyline base;
  for (int i = 0; i <= 150; ++i) {
    const double x = 0.08 * i;
    base.points.push_back(
        {x, 1.6 * std::exp(-std::pow((x - 3.2) / 0.9, 2)) + 1.1 * std::exp(-std::pow((x - 8.2) / 1.5, 2))});
  }
  return both_treatments(base, {4, 0.35, 1.0});
}

base::Result<scene::Picture> figure_7() { return both_treatments(cosine(), {13, 0.2, 1.0}); }

base::Result<scene::Picture> figure_8() {
  const geom::Polyline w = chain({{0, 0}, {1.5, -1.5}, {3, 0}, {4.5, -1.5}, {6, 0}});
  DOBRA_TRY(scene::Panel equal, family("8a: 5 curves, 0.30, factor 1.00", w, {5, 0.30, 1.00}, {}, 0.2));
  DOBRA_TRY(scene::Panel growing, family("8b: 6 curves, 0.10, factor 1.30", w, {6, 0.10, 1.30}, {}, 0.2));
  growing.extent = equal.extent;
  return scene::Picture{{}, {std::move(equal), std::move(growing)}};
}

base::Result<scene::Picture> figure_9() {
  geom::Polyline ellipse{{}, true};
  for (int i = 0; i < 128; ++i) {
    const double angle = -2.0 * std::numbers::pi * i / 128.0;
    ellipse.points.push_back({4.0 * std::cos(angle), 2.0 * std::sin(angle)});
  }
  DOBRA_TRY(scene::Panel equal, family("9a: 7 curves, 0.18, factor 1.00", ellipse, {7, 0.18, 1.00}, {}, 0.2));
  DOBRA_TRY(scene::Panel growing, family("9b: 8 curves, 0.05, factor 1.25", ellipse, {8, 0.05, 1.25}, {}, 0.2));
  return scene::Picture{{}, {std::move(equal), std::move(growing)}};
}

std::vector<geom::Polyline> chains(const std::vector<geom::Segment>& segments) {
  std::vector<geom::Polyline> all;
  for (const geom::Segment& segment : segments) all.push_back(chain({segment.from, segment.to}));
  return all;
}

scene::Panel step_panel(std::size_t number, const geom::Polyline& base, const offset::stepper::Stepper& stepper,
                        const offset::stepper::Stepper::Step& step) {
  std::vector<geom::Segment> edges;
  for (const topo::EdgeId e : stepper.subdivision().edges()) edges.push_back(stepper.subdivision().segment(e));
  std::string title = fmt::format("step {}", number);
  if (!step.formed.empty()) title += ": region removed";
  scene::Panel made =
      panel(title,
            {lines("base", stroke(grey, 1.4), {base}),
             lines("base segment of the step", stroke(ink, 2.4),
                   {chain({base.segment(step.base_segment).from, base.segment(step.base_segment).to})}),
             lines("raw edge of the step", stroke({240, 178, 92}, 4.5), {chain({step.edge.from, step.edge.to})}),
             lines("deleted", stroke(red, 1.3, scene::Dash::Dashed), chains(step.deleted_edges)),
             lines("curve so far", stroke(blue, 1.4), chains(edges))},
            0.0, {"", ""});
  made.extent = geom::Box{{-0.15, -0.75}, {2.75, 1.55}};
  return made;
}

base::Result<scene::Picture> figure_5() {
  const geom::Polyline base = chain({{0, 0}, {0.7, 0.05}, {1.0, 1.1}, {1.3, 1.4}, {1.6, 1.1}, {1.9, 0.05}, {2.6, 0}});
  DOBRA_TRY(offset::stepper::Stepper stepper, offset::stepper::Stepper::start(base, 0.55, {}));
  scene::Picture picture;
  while (!stepper.done()) {
    DOBRA_TRY(const offset::stepper::Stepper::Step step, stepper.step());
    picture.panels.push_back(step_panel(picture.panels.size() + 1, base, stepper, step));
  }
  return picture;
}

/// All points within d of a segment.
geom::Polyline stadium(const geom::Segment& segment, double d) {
  geom::Polyline round{{}, true};
  const geom::Vector n = geom::right_of(geom::normalised(segment.vector()));
  constexpr int steps = 24;
  for (int end = 0; end < 2; ++end) {
    for (int i = 0; i <= steps; ++i) {
      const double angle = std::numbers::pi * i / steps;
      const geom::Vector out = std::cos(angle) * n + std::sin(angle) * geom::left_of(n);
      round.points.push_back(end == 0 ? segment.to + d * out : segment.from - d * out);
    }
  }
  return round;
}

base::Result<geom::Polyline> round_curve(const geom::Polyline& base, double d) {
  DOBRA_TRY(const auto curves, offset::offset(base, std::vector{d}, {.join = offset::Join::Round}));
  return offset::chords(curves.front().pieces.front(), base).polyline;
}

base::Result<scene::Picture> monotone_engine() {
  const geom::Polyline base =
      chain({{0, 1.7}, {1.3, 0.5}, {2.1, 2.6}, {3.0, 3.0}, {3.5, 1.2}, {4.3, 1.5}, {5.2, 0.2}, {6.4, 1.3}});
  constexpr double d = 0.8;
  DOBRA_TRY(geom::Polyline curve, round_curve(base, d));
  std::vector<geom::Polyline> stadia;
  for (std::size_t i = 0; i < base.segment_count(); ++i) stadia.push_back(stadium(base.segment(i), d));
  return scene::Picture{
      {},
      {panel("Lower envelope of stadia",
             {lines("stadia", stroke(grey, 0.9), stadia), lines("curve", stroke(blue, 2.0), {curve}), base_line(base)},
             0.1, {"", ""})}};
}

}  // namespace

std::vector<Figure> offset_figures() {
  return {{"offset_monotone", monotone_engine, 480.0},
          {"offset_stages", offset_stages, 760.0},
          {"offset_3_6", figures_3_and_6},
          {"offset_5", figure_5, 1000.0},
          {"offset_7", figure_7},
          {"offset_8", figure_8},
          {"offset_9", figure_9}};
}

}  // namespace dobra::figures
