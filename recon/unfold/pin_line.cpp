#include "recon/unfold/pin_line.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "recon/unfold/grid.h"

namespace recon::unfold {

namespace {

/// A place of a bed counts as pinned if the top's nearest point is not nearer than this part of its depth.
constexpr double nearest_part = 0.5;

}  // namespace

PinLine::PinLine(const maps::Columns& top, double arc) : top_(&top) {
  std::size_t column = 1;
  while (column < top.inner_count() && top.frame(maps::ColumnId(column + 1)).arc <= arc) ++column;
  const maps::Columns::Frame& frame = top.frame(maps::ColumnId(column));
  const maps::Columns::Frame& last = top.frame(maps::ColumnId(top.inner_count()));
  const double total = last.arc + last.length;
  at_ = frame.foot + (arc - frame.arc) * frame.tangent;
  down_ = geom::right_of(frame.tangent);
  for (const std::size_t rung : {column - 1, column}) {
    const double there = rung == column ? frame.arc + frame.length : frame.arc;
    if (std::abs(there - arc) > 1e-12 * total) continue;
    at_ = top.foot(rung);
    down_ = top.rung_vector(rung);
  }
  tolerance_ = bed_tolerance * top.base_line().box().diagonal();
}

double PinLine::depth(geom::Point p) const { return geom::dot(p - at_, down_) / geom::length_squared(down_); }

std::optional<double> PinLine::meets(const geom::Polyline& line, const std::vector<double>& arc) const {
  const double length = geom::length(down_);
  const auto before = [&](std::size_t i) {
    const double distance = geom::cross(line.points[i] - at_, down_) / length;
    return std::abs(distance) <= tolerance_ ? 0.0 : distance;
  };
  std::optional<double> best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::size_t i, double part) {
    const geom::Point p = part > 0.0 ? geom::interpolate(line.points[i], line.points[i + 1], part) : line.points[i];
    const double there = std::abs(depth(p));
    if (there >= least || top_->find(p, tolerance_).distance < nearest_part * there - tolerance_) return;
    least = there;
    best = part > 0.0 ? (1.0 - part) * arc[i] + part * arc[i + 1] : arc[i];
  };
  double side = 1.0;      // of the last vertex beside the pin line; the end itself may lie on it
  std::size_t first = 0;  // of the vertices on the pin line since then
  double last = 0.0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double here = before(i);
    if (here == 0.0) {
      if (i == 0 || last != 0.0) first = i;
    } else {
      if (here < 0.0 && side > 0.0 && i > 0) {
        const bool on_it = last == 0.0;
        consider(on_it ? first : i - 1, on_it ? 0.0 : last / (last - here));
      }
      side = here;
    }
    last = here;
  }
  if (last == 0.0 && side > 0.0) consider(first, 0.0);
  return best;
}

double askew_at(const geom::Polyline& top, const std::vector<double>& arcs, double arc) {
  const double total = arcs.back();
  const auto way = [&](double from, double to) {
    return geom::normalised(geom::point_at(top, arcs, to) - geom::point_at(top, arcs, from));
  };
  const auto turn = [](geom::Vector a, geom::Vector b) { return std::atan2(geom::cross(a, b), geom::dot(a, b)); };
  const double step = 1e-6 * total;
  const geom::Vector here = way(std::max(arc - step, 0.0), std::min(arc + step, total));
  double from = arc, to = arc;  // the stretch that dips as the top does here
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i) {
    const bool holds = arcs[i] <= arc && arc <= arcs[i + 1];
    if (!holds || std::abs(turn(here, geom::normalised(top.points[i + 1] - top.points[i]))) > askew_tolerance) continue;
    from = std::min(from, arcs[i]);
    to = std::max(to, arcs[i + 1]);
  }
  const double side = 0.05 * total;
  if (from < side || to > total - side) return 0.0;
  const double before = turn(way(from - side, from), here);
  const double behind = turn(way(to, to + side), here);
  return before * behind > 0.0 ? std::min(std::abs(before), std::abs(behind)) : 0.0;
}

double place_on(const maps::Columns& top, const maps::Located& located, geom::Point p) {
  const maps::Columns::Frame& frame = top.frame(located.at.column);
  const double x = geom::dot(p - frame.foot, frame.tangent);
  const std::size_t column = located.at.column.index();
  if (column == 0) return frame.arc + x;
  if (column > top.inner_count()) return frame.arc + x;
  return frame.arc + std::clamp(x, 0.0, frame.length);
}

base::Result<DefaultPin> default_pin(const section::Section& section, const SourceGrid& source) {
  DOBRA_TRY(const maps::Columns top, maps::Columns::along(source.base));
  const bool left_first = source.side == section::LayerSide::Below;
  const double length = geom::length(source.base);
  const double tolerance = bed_tolerance * source.base.box().diagonal();
  // Where the count of beds can grow: at the left end of the top, and where a piece of a bed begins.
  std::vector<double> places{left_first ? 0.0 : length};
  std::vector<std::vector<geom::Polyline>> beds;
  std::vector<section::HorizonId> ids;
  const std::string& top_name = whole_name(*find_horizon(section, source.top));
  for (const section::Horizon& horizon : section.horizons) {
    if (whole_name(horizon) == top_name) continue;
    const geom::Point left = horizon.line.points.front();
    const double place = place_on(top, top.locate(left, tolerance), left);
    if (place > 0.0 && place < length) places.push_back(place);
    const section::Horizon* first = first_piece(section, whole_name(horizon));
    const auto known = std::find(ids.begin(), ids.end(), first->id);
    const auto bed = static_cast<std::size_t>(known - ids.begin());
    if (known == ids.end()) {
      ids.push_back(first->id);
      beds.emplace_back();
    }
    beds[bed].push_back(left_first ? horizon.line : geom::reversed(horizon.line));
  }
  left_first ? std::sort(places.begin(), places.end()) : std::sort(places.begin(), places.end(), std::greater<>());
  const auto misses = [&](double place) {
    const PinLine pin(top, place);
    std::vector<section::HorizonId> off;
    for (std::size_t i = 0; i < beds.size(); ++i) {
      const auto met = [&](const geom::Polyline& piece) { return pin.meets(piece, geom::arc_lengths(piece)); };
      if (std::none_of(beds[i].begin(), beds[i].end(), met)) off.push_back(ids[i]);
    }
    return off;
  };
  DefaultPin best{places.front(), misses(places.front())};
  for (std::size_t i = 1; i < places.size() && !best.off.empty(); ++i) {
    std::vector<section::HorizonId> off = misses(places[i]);
    if (off.size() < best.off.size()) best = {places[i], std::move(off)};
  }
  return best;
}

}  // namespace recon::unfold
