// Both sides of an open line. Travelled there and back it is a closed contour, whose right side is the wanted curve:
// the engine's round joins go with round caps, its bevels across U-turns with square ones. Any other cap changes the
// area only within 2 D of an end, so that the stretch of line there is taken by itself: as the sum of the rectangles on
// its segments, of what fills its corners, and of its cap, which is what the winding number of one walk round all of
// them is above 0 in. The stretches and the middle of the line are then joined.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/offset/area_parts.h"
#include "shared/topo/region.h"

namespace dobra::offset {

using base::Result;
using geom::Point;
using geom::Polyline;
using geom::Vector;

namespace {

/// p0 .. pn .. p1, closed.
Polyline there_and_back(Polyline line) {
  if (line.points.size() == 2) {
    const Point a = line.points[0];
    const Point b = line.points[1];
    line.points.insert(line.points.begin() + 1, {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y});
  }
  for (std::size_t i = line.points.size() - 1; i-- > 1;) line.points.push_back(line.points[i]);
  line.closed = true;
  return line;
}

enum class AtEnd { Cap, Flat };

/// The walk round the rectangles, corners and caps of a line.
class Walk {
 public:
  Walk(const Polyline& line, double distance, const AreaOptions& options)
      : line_(there_and_back(line)), d_(distance), options_(options) {}

  /// @param first, last  at the two ends of the line.
  Polyline run(AtEnd first, AtEnd last) {
    const std::size_t count = line_.points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Point from = line_.points[i];
      const Point to = line_.points[(i + 1) % count];
      const Vector u = unit(to - from);
      add(from, d_ * right_of(u));
      add(to, d_ * right_of(u));
      const bool at_last = 2 * (i + 1) == count;
      const bool at_first = i + 1 == count;
      if (at_first || at_last) {
        if ((at_last ? last : first) == AtEnd::Cap) cap(to, u);
      } else {
        corner(to, u, unit(line_.points[(i + 2) % count] - to));
      }
    }
    return geom::without_repeated_points(std::move(walk_));
  }

 private:
  static Vector unit(Vector v) {
    const double size = geom::length(v);
    return {v.x / size, v.y / size};
  }
  static Vector right_of(Vector v) { return {v.y, -v.x}; }
  void add(Point p, Vector by) { walk_.points.push_back(p + by); }

  /// From the right normal of u on, anticlockwise.
  void arc(Point centre, Vector u, double angle) {
    const double step = 2 * std::acos(1 - options_.arc_tolerance);
    const long parts = std::max(1L, std::lround(std::ceil(angle / step)));
    for (long k = 1; k < parts; ++k) {
      const double t = angle * static_cast<double>(k) / static_cast<double>(parts);
      add(centre, d_ * (std::cos(t) * right_of(u) + std::sin(t) * u));
    }
  }
  void cap(Point end, Vector u) {
    if (options_.cap == Cap::Round) arc(end, u, std::numbers::pi);
    if (options_.cap != Cap::Square) return;
    add(end, d_ * (right_of(u) + u));
    add(end, d_ * (u - right_of(u)));
  }
  /// To be followed by the right side of v.
  void corner(Point at, Vector u, Vector v) {
    const double sine = geom::cross(u, v);
    const double cosine = geom::dot(u, v);
    if (sine < 0.0) return add(at, {});  // the two rectangles overlap
    const double angle = std::atan2(sine, cosine);
    if (options_.join == Join::Round) return arc(at, u, angle);
    if (options_.join == Join::Bevel) return;
    const OffsetOptions limits{.join = options_.join, .mitre_limit = options_.mitre_limit};
    const bool mitre = 1.0 <= limits.tip_limit() * std::cos(0.5 * angle) * (1 + 1e-14);
    const double reach = mitre ? std::tan(0.5 * angle) : std::tan(0.25 * angle);
    add(at, d_ * (right_of(u) + reach * u));
    if (!mitre) add(at, d_ * (right_of(v) - reach * v));
  }

  Polyline line_;
  double d_;
  const AreaOptions& options_;
  Polyline walk_{{}, true};
};

/// The first point far enough from the first one that the disc about it holds nothing beyond that end of the line; n if
/// none is.
std::size_t beyond_end(const std::vector<Point>& points, double distance) {
  if (geom::distance(points[0], points[1]) > distance * (1 + 1e-9)) return 1;
  for (std::size_t k = 2; k < points.size(); ++k) {
    if (geom::distance(points[0], points[k]) > 2 * distance * (1 + 1e-9)) return k;
  }
  return points.size();
}

Polyline part_of(const Polyline& line, std::size_t first, std::size_t last) {
  const auto begin = line.points.begin();
  return {{begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last + 1)}, false};
}

/// With the caps that the engine has itself.
Result<std::vector<Area>> whole(const Polyline& line, std::span<const double> distances, const AreaOptions& options,
                                UTurn u_turn, const base::Progress& progress) {
  const OffsetOptions settings{.join = options.join, .mitre_limit = options.mitre_limit, .u_turn = u_turn};
  return beside(there_and_back(line), settings, distances, options, progress);
}

Result<Area> with_caps(const Polyline& line, double distance, const AreaOptions& options,
                       const base::Progress& progress) {
  const std::size_t last = line.points.size() - 1;
  const std::vector<Point> backwards(line.points.rbegin(), line.points.rend());
  const std::size_t k = beyond_end(line.points, distance);
  const std::size_t back = beyond_end(backwards, distance);
  std::vector<Polyline> rings;
  if (k + back >= last || back > last) {
    rings.push_back(Walk(line, distance, options).run(AtEnd::Cap, AtEnd::Cap));
  } else {
    const std::size_t l = last - back;
    rings.push_back(Walk(part_of(line, 0, k + 1), distance, options).run(AtEnd::Cap, AtEnd::Flat));
    rings.push_back(Walk(part_of(line, l - 1, last), distance, options).run(AtEnd::Flat, AtEnd::Cap));
    DOBRA_TRY(const std::vector<Area> middle,
              whole(part_of(line, k, l), {&distance, 1}, options, UTurn::ChordBevel, progress));
    rings.insert(rings.end(), middle[0].rings.begin(), middle[0].rings.end());
  }
  DOBRA_TRY(std::vector<Polyline> joined, topo::region(rings, topo::Inside::Positive, progress));
  return measured(std::move(joined));
}

}  // namespace

Result<std::vector<Area>> around_line(const Polyline& line, std::span<const double> distances,
                                      const AreaOptions& options, const base::Progress& progress) {
  const Polyline clean = geom::without_repeated_points(line);
  DOBRA_TRY_VOID(geom::validate(clean));
  const bool round = options.join == Join::Round && options.cap == Cap::Round;
  const bool square = (options.join == Join::Mitre || options.join == Join::Bisector) && options.cap == Cap::Square;
  if (round || square) return whole(clean, distances, options, UTurn::TangentBevel, progress);
  // The engine's checks of sizes go for the walks too.
  DOBRA_TRY_VOID(offset(clean, distances, {.treatment = Treatment::Untreated}, progress));
  std::vector<Area> all;
  for (const double distance : distances) {
    DOBRA_TRY_VOID(progress.check());
    DOBRA_TRY(Area made, with_caps(clean, distance, options, progress));
    all.push_back(std::move(made));
  }
  return all;
}

}  // namespace dobra::offset
