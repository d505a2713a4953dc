#include "recon/unfold/grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "recon/input/join.h"
#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/place.h"
#include "shared/geom/simplify.h"
#include "shared/offset/offset.h"

namespace recon::unfold {

namespace {

/// Relative to the base line's box: how much farther than the nearest segment still counts as nearest.
constexpr double nearest_tolerance = 1e-12;

/// Depth down to which the rung belongs to its own corner: where no other part of the base is nearer.
double rung_end(const maps::Columns& columns, std::size_t rung, double deepest, double tolerance, int most_halvings) {
  const geom::Point foot = columns.foot(rung);
  const geom::Vector along = columns.rung_vector(rung);
  const maps::ColumnId before(rung);
  const maps::ColumnId after(rung + 1);
  const auto own = [&](double depth) {
    const geom::Point p = foot + depth * along;
    const maps::Located nearest = columns.locate(p, tolerance, after);
    const double distance = std::min(columns.distance_to_base(before, p), columns.distance_to_base(after, p));
    return nearest.foot == maps::Foot::InColumn && distance <= nearest.distance + tolerance;
  };
  if (own(deepest)) return deepest;
  double low = 0.0;
  double high = deepest;
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (own(middle) ? low : high) = middle;
  }
  return low;
}

std::vector<geom::Polyline> rungs_of(const maps::Columns& columns, const GridOptions& options) {
  const double deepest = options.distances.back();
  const double tolerance = nearest_tolerance * (columns.base_line().box().diagonal() + deepest);
  return base::parallel_map<geom::Polyline>(
      columns.rung_count(),
      [&](std::size_t i) {
        const double end = options.treatment == Treatment::Untreated
                               ? deepest
                               : rung_end(columns, i, deepest, tolerance, options.most_halvings);
        return geom::Polyline{{columns.foot(i), columns.foot(i) + end * columns.rung_vector(i)}, false};
      },
      64);
}

}  // namespace

namespace {

dobra::offset::Join offset_join(CornerJoin join) {
  switch (join) {
    case CornerJoin::Bisector:
      return dobra::offset::Join::Bisector;
    case CornerJoin::Round:
      return dobra::offset::Join::Round;
    case CornerJoin::Bevel:
      return dobra::offset::Join::Bevel;
    case CornerJoin::Mitre:
      break;
  }
  return dobra::offset::Join::Mitre;
}

}  // namespace

base::Result<Grid> make_grid(const geom::Polyline& line, const maps::Columns& columns, const GridOptions& options,
                             const base::Progress& progress) {
  dobra::offset::OffsetOptions how;
  how.treatment =
      options.treatment == Treatment::Treated ? dobra::offset::Treatment::Treated : dobra::offset::Treatment::Untreated;
  how.join = offset_join(options.join);
  DOBRA_TRY(auto curves, dobra::offset::offset(line, options.distances, how, progress));
  Grid grid;
  for (auto& curve : curves) {
    GridCurve made{curve.distance, {}};
    for (const auto& piece : curve.pieces) made.pieces.push_back(dobra::offset::chords(piece, line).polyline);
    if (made.pieces.empty()) ++grid.vanished;
    grid.left_out += curve.dropped;
    grid.curves.push_back(std::move(made));
  }
  DOBRA_TRY_VOID(progress.check());
  grid.rungs = rungs_of(columns, options);
  return grid;
}

namespace {

/// Where the points of a line lie in the columns of the top in its given direction.
std::vector<maps::ColumnPoint> places_of(const geom::Polyline& line, const maps::Columns& columns) {
  const double tolerance = nearest_tolerance * columns.base_line().box().diagonal();
  std::vector<maps::ColumnPoint> places;
  places.reserve(line.points.size());
  maps::ColumnId hint;
  for (const geom::Point p : line.points) {
    places.push_back(columns.locate(p, tolerance, hint).at);
    hint = places.back().column;
  }
  return places;
}

/// What the section has beyond the ends of the top.
struct Beyond {
  double distance = 0.0;  ///< m
  std::string item;
  std::string file;
  geom::Point place;
};

/// The farthest point of a line beyond the ends, if it is farther than what is known: beyond the normal of the end, and
/// beside the top. What lies under the steep limb of a fold, or along the normal of a dipping end, is no lack of the
/// top.
void measure_beyond(const geom::Polyline& line, const std::vector<maps::ColumnPoint>& places,
                    const maps::Columns& columns, const std::string& item, const base::Place& source, Beyond& beyond) {
  const geom::Box top = columns.base_line().box();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const geom::Point p = line.points[i];
    const double beside = std::max(top.low.x - p.x, p.x - top.high.x);
    const double distance = std::min(beside, std::abs(places[i].along));  // metres from the rung
    if (columns.is_outer(places[i].column) && distance > beyond.distance) beyond = {distance, item, source.file, p};
  }
}

base::Result<void> refuse_uncovered(const Beyond& beyond, const section::Horizon& top, const GridParams& params) {
  const double percent = 100.0 * beyond.distance / top.line.box().width();
  if (params.uncovered == Uncovered::Continue || percent <= params.cover_tolerance) return {};
  base::Place place = place_at(beyond.place, beyond.item);
  place.file = beyond.file;
  return base::Error{
      base::ErrorCode::BadSection,
      fmt::format("the top '{}' does not cover the section: this reaches {:.6g} m beyond its end, {:.3g} "
                  "% of its width; lengthen the top, take another one, or set uncovered = \"continue\" "
                  "(--uncovered continue) to go on straight there{}",
                  top.name, beyond.distance, percent,
                  top.piece_of.empty()
                      ? ""
                      : fmt::format("; it is one piece of horizon '{}': join its pieces before (step join, join_gaps) "
                                    "where no fault displaces it any more; a section that faults still part is "
                                    "restored block by block (--jigsaw)",
                                    top.piece_of)),
      place};
}

section::LayerSide side_of(const std::vector<double>& depths, section::LayerSide wish) {
  if (wish != section::LayerSide::Auto) return wish;
  std::ptrdiff_t below = 0;
  for (const double depth : depths) below += depth > 0.0 ? 1 : depth < 0.0 ? -1 : 0;
  return below < 0 ? section::LayerSide::Above : section::LayerSide::Below;
}

/// First distance d such that `count` curves with the given factor end at `deepest`: D_count = d (1 + f + ... +
/// f^(count-1)).
double distance_to_reach(double deepest, double factor, int count) {
  double sum = 0.0;
  for (int k = 0; k < count; ++k) sum = factor * sum + 1.0;
  return deepest / sum;
}

constexpr int most_curves = 10000;

/// How many curves it takes to reach `deepest`.
base::Result<int> count_to_reach(double deepest, double distance, double factor) {
  double reached = 0.0;
  for (int count = 1; count <= most_curves; ++count) {
    reached = factor * reached + distance;
    if (reached >= deepest * (1.0 - 1e-12)) return count;
  }
  return base::Error{base::ErrorCode::InvalidOption,
                     fmt::format("{} curves from {:.6g} m with factor {:.6g} only reach {:.6g} m of {:.6g} m; take a "
                                 "larger distance or factor",
                                 most_curves, distance, factor, reached, deepest)};
}

/// How deep a grid reaches below a top that has nothing on that side, of the top's extent.
constexpr double empty_depth = 0.1;

base::Result<std::vector<double>> distances_for(const GridParams& params, double deepest, double extent) {
  int count = params.count;
  const double reach = deepest > 0.0 ? deepest : empty_depth * extent;
  const double distance = params.distance.value_or(distance_to_reach(reach, params.factor, count));
  if (params.distance && params.extent == GridExtent::Base) {
    if (deepest <= 0.0) {
      return base::Error{base::ErrorCode::InvalidOption,
                         "no horizon or unit lies on that side of the top; set extent = \"count\""};
    }
    DOBRA_TRY(count, count_to_reach(deepest, distance, params.factor));
  }
  return dobra::offset::distances({static_cast<std::size_t>(count), distance, params.factor});
}

}  // namespace

namespace {

/// Why a name is that of no horizon.
std::string why_no_horizon(const section::Section& section, const std::string& name) {
  for (const section::SectionLine& line : section.lines) {
    if (line.name == name) return fmt::format(": it is the name of a line of kind '{}'", kind_name(line.kind));
  }
  for (const section::Unit& unit : section.units) {
    if (unit.name == name || unit.piece_of == name)
      return fmt::format(": it is a unit whose top is no horizon; the horizons are {}",
                         fmt::join(horizon_names(section), ", "));
  }
  return base::did_you_mean(name, horizon_names(section));
}

std::string top_in_pieces(const std::string& whole, const std::vector<section::Horizon>& pieces) {
  const std::string one =
      fmt::format("to grid a part of the section alone, name the piece, such as '{}'", pieces.front().name);
  if (pieces.size() == 1) return fmt::format("the top '{}' is one piece of a horizon; {}", whole, one);
  return fmt::format(
      "the top is one line, and horizon '{}' is {}; join them before (step join, or join_gaps, with a "
      "tolerance above that), where faults displace the bed after moving it back; {}",
      whole, input::in_pieces(pieces), one);
}

base::Result<const section::Horizon*> top_of(const section::Section& section, const GridParams& params) {
  if (section.horizons.empty()) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("the section has no horizon to be the top{}",
                                   section.units.empty() ? ""
                                                         : "; the edges that its polygons share become horizons with "
                                                           "--horizons-from-units (horizons_from_units = true)")};
  }
  const section::Horizon* top = params.top.empty() ? &section.horizons.front() : find_horizon(section, params.top);
  if (top != nullptr) return top;
  std::vector<section::Horizon> pieces;
  std::copy_if(section.horizons.begin(), section.horizons.end(), std::back_inserter(pieces),
               [&](const section::Horizon& horizon) { return horizon.piece_of == params.top; });
  if (!pieces.empty()) return base::Error{base::ErrorCode::BadSection, top_in_pieces(params.top, pieces)};
  return base::Error{base::ErrorCode::BadSection, fmt::format("there is no horizon '{}' to be the top{}", params.top,
                                                              why_no_horizon(section, params.top))};
}

base::Place item_of(const section::Horizon& horizon) {
  base::Place item;
  item.item = fmt::format("horizon '{}'", horizon.name);
  return item;
}

}  // namespace

base::Result<SourceGrid> make_base(const section::Section& section, const GridParams& params, section::LayerSide side) {
  DOBRA_TRY(const section::Horizon* top, top_of(section, params));
  SourceGrid source;
  source.params = params;
  source.top = top->id;
  source.side = side;
  source.base = top->line;
  if (params.simplify > 0.0) {
    auto simpler = geom::simplify(top->line, {.tolerance = params.simplify});
    if (!simpler) return base::located(simpler.error(), item_of(*top));
    source.base = std::move(*simpler);
    source.remarks.push_back(fmt::format("the grid stands on {} of the {} points of the top, within {:.4g} m of it",
                                         source.base.points.size(), top->line.points.size(), params.simplify));
  }
  if (side == section::LayerSide::Above) source.base = geom::reversed(std::move(source.base));
  return source;
}

base::Result<SourceGrid> make_source_grid(const section::Section& section, const GridParams& params,
                                          const base::Progress& progress) {
  DOBRA_TRY(const section::Horizon* top, top_of(section, params));
  DOBRA_TRY(SourceGrid source, make_base(section, params, section::LayerSide::Below));
  const base::Place item = item_of(*top);
  auto columns = maps::Columns::along(source.base);
  if (!columns) return base::located(columns.error(), item);
  std::vector<double> depths;
  Beyond beyond;
  const auto places = base::parallel_map<std::vector<maps::ColumnPoint>>(section.horizons.size(), [&](std::size_t h) {
    const section::Horizon& horizon = section.horizons[h];
    return horizon.id == top->id ? std::vector<maps::ColumnPoint>{} : places_of(horizon.line, *columns);
  });
  for (std::size_t h = 0; h < places.size(); ++h) {
    const section::Horizon& horizon = section.horizons[h];
    for (const maps::ColumnPoint& at : places[h]) depths.push_back(at.depth);
    if (!places[h].empty())
      measure_beyond(horizon.line, places[h], *columns, fmt::format("horizon '{}'", horizon.name), horizon.source,
                     beyond);
  }
  for (const section::Unit& unit : section.units) {
    const std::vector<maps::ColumnPoint> of_unit = places_of(unit.contour, *columns);
    for (const maps::ColumnPoint& at : of_unit) depths.push_back(at.depth);
    measure_beyond(unit.contour, of_unit, *columns, fmt::format("unit '{}'", unit.name), unit.source, beyond);
  }
  DOBRA_TRY_VOID(refuse_uncovered(beyond, *top, params));
  source.side = side_of(depths, params.side);
  if (source.side == section::LayerSide::Above) {
    source.base = geom::reversed(std::move(source.base));
    for (double& depth : depths) depth = -depth;
    DOBRA_TRY(*columns, maps::Columns::along(source.base));
  }
  for (const double depth : depths) source.deepest = std::max(source.deepest, depth);
  DOBRA_TRY(source.options.distances, distances_for(params, source.deepest, source.base.box().diagonal()));
  if (source.deepest <= 0.0 && !params.distance) {
    source.remarks.push_back(
        fmt::format("no horizon or unit lies on that side of the top; the grid reaches {:.4g} m, a "
                    "tenth of the top's extent",
                    source.options.distances.back()));
  }
  source.options.treatment = params.treatment;
  source.options.join = params.join;
  auto grid = make_grid(source.base, *columns, source.options, progress);
  if (!grid) return base::located(grid.error(), item);
  source.grid = std::move(*grid);
  if (source.grid.vanished > 0) {
    source.remarks.push_back(fmt::format("{} offset curves vanished: nothing of them is as far from the top as asked",
                                         source.grid.vanished));
  }
  if (source.grid.left_out > 0) {
    source.remarks.push_back(fmt::format("{} short pieces of offset curves were left out", source.grid.left_out));
  }
  return source;
}

}  // namespace recon::unfold
