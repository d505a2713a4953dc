#include "recon/maps/area_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "shared/geom/contour.h"
#include "shared/geom/simplify.h"

namespace recon::maps {

namespace {

/// Walks along lines and keeps the extremes of what it meets on one side of them.
class Search {
 public:
  explicit Search(const SectionMap& map) : map_(map) {}

  /// @param side  +1: the cells on the left of the line, -1: on the right.
  void follow(const geom::Polyline& line, double side) { follow(line, side, 0, line.segment_count()); }

  /// Of its segments those in [first, last).
  void follow(const geom::Polyline& line, double side, std::size_t first, std::size_t last) {
    // The line itself may be a side of cells: it is traced a little beside itself, each segment alone.
    geom::Polyline beside;
    std::vector<geom::Vector> steps;
    for (std::size_t i = first; i < last; ++i) {
      const geom::Segment segment = line.segment(i);
      const geom::Vector along = segment.vector();
      const double part = std::min(1e-3, map_.tolerances().chord / std::hypot(along.x, along.y));
      steps.push_back(side * part * geom::Vector{-along.y, along.x});
      beside.points.push_back(segment.from + steps.back());
      beside.points.push_back(segment.to + steps.back());
    }
    const MappedLine traced = map_.through_cells(beside);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      for (std::size_t k = traced.given[2 * i]; k < traced.given[2 * i + 1]; ++k) {
        const geom::Segment part{traced.before.points[k], traced.before.points[k + 1]};
        if (!line.closed || !is_cut_off(line, first + i, part)) piece(part, -steps[i]);
      }
    }
  }

  /// A piece of a line that lies in the cell.
  void in_cell(const geom::Segment& segment, Cell cell) {
    const double tear = map_.tolerances().tear;
    if (geom::length_squared(segment.vector()) <= tear * tear) return;
    if (map_.columns() == nullptr || map_.columns()->law() != ColumnLaw::Thickness) return along(segment, cell);
    // One function of the depth, monotone: its ends decide.
    for (const geom::Point p : {segment.from, segment.to}) count(map_.columns()->determinant(cell, p), p);
  }

  void count(double value, geom::Point at) {
    if (std::isfinite(value)) include(found_, value - 1.0, at);
  }

  [[nodiscard]] const std::optional<AreaChange>& found() const { return found_; }

 private:
  /// Whether a piece beside segment i of a contour lies outside of it, at a corner where the contour turns inwards.
  static bool is_cut_off(const geom::Polyline& contour, std::size_t i, const geom::Segment& piece) {
    const std::size_t count = contour.segment_count();
    const geom::Vector along = contour.segment(i).vector();
    const geom::Segment before = contour.segment((i + count - 1) % count);
    const geom::Segment after = contour.segment((i + 1) % count);
    const geom::Point p = geom::midpoint(piece.from, piece.to);
    const auto right_of = [&](const geom::Segment& s) { return geom::cross(s.vector(), p - s.from) <= 0.0; };
    return (geom::cross(before.vector(), along) > 0.0 && right_of(before)) ||
           (geom::cross(along, after.vector()) > 0.0 && right_of(after));
  }

  /// A piece that lies in one cell, and as much beside the line.
  void piece(const geom::Segment& segment, geom::Vector to_line) {
    if (segment.length() <= map_.tolerances().tear) return;  // where the line is torn; a cell of rounding
    const std::optional<Cell> cell = map_.cell_of(geom::midpoint(segment.from, segment.to), hint_);
    if (cell) along({segment.from + to_line, segment.to + to_line}, *cell);
  }

  void along(const geom::Segment& segment, Cell cell) {
    const auto point = [&](double t) { return geom::interpolate(segment.from, segment.to, t); };
    const std::array<geom::Point, 5> points{segment.from, point(0.25), point(0.5), point(0.75), segment.to};
    std::array<double, 5> values{};
    map_.determinants(cell, points, values);
    for (std::size_t k = 0; k < points.size(); ++k) count(values[k], points[k]);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const double before = values[k] - values[k - 1];
      const double after = values[k + 1] - values[k];
      const double rounding = 1e-9 * std::abs(values[k]);
      if (!(before * after < 0.0) || std::min(std::abs(before), std::abs(after)) < rounding) continue;
      const double sign = before > 0.0 ? 1.0 : -1.0;
      polish(cell, points[k - 1], points[k + 1], sign);
    }
  }

  /// The one extreme between two places (sign > 0: the greatest), by golden sections.
  void polish(Cell cell, geom::Point from, geom::Point to, double sign) {
    constexpr double part = 1.0 / std::numbers::phi;
    const auto value = [&](double t) {
      const geom::Point p = geom::interpolate(from, to, t);
      double found = 0.0;
      map_.determinants(cell, {&p, 1}, {&found, 1});
      count(found, p);
      return std::isfinite(found) ? sign * found : -std::numeric_limits<double>::infinity();
    };
    double low = 0.0;
    double high = 1.0;
    double left = high - part * (high - low);
    double right = low + part * (high - low);
    double at_left = value(left);
    double at_right = value(right);
    while (high - low > 1e-8) {
      if (at_left > at_right) {
        high = std::exchange(right, left);
        left = high - part * (high - low);
        at_right = std::exchange(at_left, value(left));
      } else {
        low = std::exchange(left, right);
        right = low + part * (high - low);
        at_left = std::exchange(at_right, value(right));
      }
    }
  }

  const SectionMap& map_;
  Cell hint_;
  std::optional<AreaChange> found_;
};

/// The contour between two horizons, with the region on its left, and which of its segments need not be followed.
class Contour {
 public:
  /// @param known  of the segments of the two lines.
  Contour(const MappedLine& upper, const std::vector<char>& known_upper, const MappedLine& lower,
          const std::vector<char>& known_lower, double least)
      : least_(least) {
    line_.closed = true;
    geom::Polyline outline = upper.before;
    outline.points.insert(outline.points.end(), lower.before.points.rbegin(), lower.before.points.rend());
    outline.closed = true;
    if (geom::signed_area(outline) >= 0.0) {
      add(upper.before, known_upper, lower.before, known_lower);
    } else {
      add(lower.before, known_lower, upper.before, known_upper);
    }
  }

  void follow(Search& search) const {
    const std::size_t count = line_.points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t first = i;
      while (i < count && !known_[i]) ++i;
      if (i > first) search.follow(line_, 1.0, first, i);
    }
  }

 private:
  void add(const geom::Polyline& there, const std::vector<char>& known_there, const geom::Polyline& back,
           const std::vector<char>& known_back) {
    for (std::size_t i = 0; i < there.points.size(); ++i)
      add(there.points[i], i < known_there.size() && known_there[i] != 0);
    for (std::size_t i = back.points.size(); i-- > 0;) add(back.points[i], i > 0 && known_back[i - 1] != 0);
    while (line_.points.size() > 1 && geom::distance(line_.points.back(), line_.points.front()) <= least_) {
      line_.points.pop_back();
      known_.pop_back();
    }
  }

  /// A point and whether the segment behind it is known.
  void add(geom::Point p, bool known) {
    if (line_.points.empty() || geom::distance(line_.points.back(), p) > least_) {
      line_.points.push_back(p);
      known_.push_back(known ? 1 : 0);
    } else if (!known) {
      known_.back() = 0;
    }
  }

  double least_;  ///< Vertices nearer than this have no direction between them, m.
  geom::Polyline line_;
  std::vector<char> known_;
};

/// Follows a line by the columns that its vertices are named by. @return which segments that has told.
std::vector<char> follow_names(const MappedLine& line, const SectionMap& map, Search& search) {
  const Columns& columns = map.columns()->source();
  const double tolerance = map.tolerances().side;
  std::vector<char> known(line.before.segment_count(), 1);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const geom::Segment piece = line.before.segment(i);
    const geom::Point middle = geom::midpoint(piece.from, piece.to);
    const auto beyond = [&](ColumnId column) {
      const Columns::Beyond out = columns.beyond(column, middle);
      return std::max(out.left, out.right);
    };
    // A vertex on a rung has the name of one of its two columns, mostly of that before.
    ColumnId column = line.names[i + 1].column;
    bool within = beyond(column) < -tolerance;
    if (!within && line.names[i].column != column) {
      column = line.names[i].column;
      within = beyond(column) < -tolerance;
    }
    known[i] = within ? 1 : 0;  // along a rung it is not the name that says on which side to look
    if (known[i] != 0) search.in_cell(piece, {static_cast<std::uint32_t>(column.index()), 0});
  }
  return known;
}

/// The places between which both of two lines of a stack are horizons.
struct Shared {
  double from = 0.0;
  double to = 0.0;
};

/// Which segments of a horizon bound strips between these places.
std::vector<char> within(const MappedLine& line, const Rulings& rulings, Shared shared) {
  const std::vector<double>& u = rulings.u[line.on_stack->line];
  std::vector<char> known(line.before.segment_count(), 0);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto [low, high] = std::minmax({u[line.on_stack->vertex(i)], u[line.on_stack->vertex(i + 1)]});
    known[i] = low >= shared.from - rulings.least && high <= shared.to + rulings.least ? 1 : 0;
  }
  return known;
}

/// det F of a strip is a ratio of two linear functions of its two fractions: its corners have its extremes, and there
/// the area is that of the two sides that meet.
void count_corners(const RuledMap::Entered& at, double tear, Search& search) {
  const auto sides = [](const RuledStack::Strip& strip) {
    return std::array{strip.right.top - strip.left.top, strip.right.bottom - strip.left.bottom,
                      strip.left.bottom - strip.left.top, strip.right.bottom - strip.right.top};
  };
  const auto before = sides(at.from);
  const auto after = sides(at.to);
  std::array<double, 4> squared{};
  std::transform(before.begin(), before.end(), squared.begin(), [](geom::Vector v) { return geom::length_squared(v); });
  for (const std::size_t along : {0U, 1U}) {
    for (const std::size_t ruling : {2U, 3U}) {
      if (std::min(squared[along], squared[ruling]) <= tear * tear) continue;
      const double area = geom::cross(before[along], before[ruling]);
      if (area * area <= 1e-24 * squared[along] * squared[ruling]) continue;  // the two sides lie on one another
      const RuledStack::Ruling& place = ruling == 2 ? at.from.left : at.from.right;
      search.count(geom::cross(after[along], after[ruling]) / area, along == 0 ? place.top : place.bottom);
    }
  }
}

/// The strips that lie wholly between two horizons. @return where they are.
Shared follow_strips(const MappedLine& upper, const MappedLine& lower, const SectionMap& map, Search& search) {
  const RuledMap& ruled = *map.ruled();
  const Rulings& rulings = ruled.rulings();
  Shared shared{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const MappedLine* line : {&upper, &lower}) {
    const std::vector<double>& u = rulings.u[line->on_stack->line];
    const auto [low, high] = std::minmax({u[line->on_stack->first], u[line->on_stack->last]});
    shared = {std::max(shared.from, low), std::min(shared.to, high)};
  }
  const std::size_t band = std::min(upper.on_stack->line, lower.on_stack->line);
  for (std::size_t i = 1; i < rulings.bands[band].size(); ++i) {
    if (rulings.place(band, i - 1) < shared.from - rulings.least) continue;
    if (rulings.place(band, i) > shared.to + rulings.least) break;
    const Cell cell{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(band)};
    count_corners(ruled.enter(cell), map.tolerances().tear, search);
  }
  return shared;
}

/// Whether they are neighbours in a stack where every point has one strip.
bool is_band(const MappedLine& upper, const MappedLine& lower, const SectionMap& map) {
  if (map.ruled() == nullptr || map.ruled()->folded() || !upper.on_stack || !lower.on_stack) return false;
  return std::max(upper.on_stack->line, lower.on_stack->line) ==
         std::min(upper.on_stack->line, lower.on_stack->line) + 1;
}

}  // namespace

void include(std::optional<AreaChange>& change, double value, geom::Point at) {
  if (!change) change = AreaChange{value, value, at, at};
  if (value < change->least) {
    change->least = value;
    change->least_at = at;
  }
  if (value > change->greatest) {
    change->greatest = value;
    change->greatest_at = at;
  }
}

std::optional<AreaChange> area_change_in(std::span<const geom::Polyline> contours, const SectionMap& map,
                                         std::span<const geom::Polyline> lines) {
  Search search(map);
  if (contours.empty()) return std::nullopt;
  if (map.keeps_areas()) return AreaChange{0.0, 0.0, contours.front().points.front(), contours.front().points.front()};
  for (const geom::Polyline& contour : contours)
    search.follow(geom::without_near_points(contour, map.tolerances().tear), 1.0);
  const auto inside = [&](geom::Point p) {
    const auto winds = [&](const geom::Polyline& c) { return geom::locate(c, p) == geom::Side::Inside; };
    return std::count_if(contours.begin(), contours.end(), winds) % 2 == 1;
  };
  for (const geom::Polyline& line : lines) {
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const geom::Segment piece = line.segment(i);
      if (!inside(geom::midpoint(piece.from, piece.to))) continue;
      for (const double side : {1.0, -1.0}) search.follow({{piece.from, piece.to}, false}, side);
    }
  }
  return search.found();
}

std::optional<AreaChange> area_change_between(const MappedLine& upper, const MappedLine& lower, const SectionMap& map) {
  const bool by_names = map.columns() != nullptr && !map.keeps_areas();
  if (!by_names && !is_band(upper, lower, map)) {
    const geom::Polyline contour = contour_between(upper.before, lower.before);
    return area_change_in(std::span(&contour, 1), map);
  }
  Search search(map);
  std::vector<char> known_upper;
  std::vector<char> known_lower;
  if (by_names) {
    known_upper = follow_names(upper, map, search);
    known_lower = follow_names(lower, map, search);
  } else {
    const Shared shared = follow_strips(upper, lower, map, search);
    known_upper = within(upper, map.ruled()->rulings(), shared);
    known_lower = within(lower, map.ruled()->rulings(), shared);
  }
  Contour(upper, known_upper, lower, known_lower, map.tolerances().tear).follow(search);
  return search.found();
}

}  // namespace recon::maps
