#include "shared/surf/mesh/tips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "shared/surf/mesh/chart_sizes.h"
#include "shared/surf/trim/open.h"

namespace dobra::surf::mesh {

using dobra::mesh::NodeId;
using geom::Point;
using geom::Point3;
using geom::Vector;
using geom::Vector3;

namespace {

constexpr double pi = std::numbers::pi;

/// A tip and the ways out of it.
class Wheel {
 public:
  Wheel(const ChartInput& input, std::size_t tip, double radius)
      : surface_(input.surface), tip_(input.chart.points[tip]), at_(input.at[tip]), step_(near * radius) {}

  /// The angle round the tip in space, after each of the steps round it in the chart, between two angles of it; empty
  /// where there is none.
  [[nodiscard]] std::vector<double> developed(double from = 0.0, double to = 2.0 * pi) const {
    std::vector<double> angles{0.0};
    std::optional<Vector3> before;
    for (int i = 0; i <= ways; ++i) {
      const Vector3 way = surface_.at(tip_ + step_ * out(std::lerp(from, to, 1.0 * i / ways))) - at_;
      if (!geom::is_finite(at_ + way) || !(geom::length(way) > 0.0)) return {};
      if (before) angles.push_back(angles.back() + std::atan2(geom::length(cross(*before, way)), dot(*before, way)));
      before = way;
    }
    return angles;
  }
  /// The place at a distance in space from the tip.
  [[nodiscard]] Point place(double angle, double distance) const {
    constexpr int rounds = 3;
    double r = step_;
    for (int round = 0; round < rounds; ++round) {
      const double reached = geom::distance(surface_.at(tip_ + r * out(angle)), at_);
      if (!(reached > 0.0)) break;
      r *= distance / reached;
    }
    return tip_ + r * out(angle);
  }
  /// The least size that shape and formula ask for at a distance.
  [[nodiscard]] double size_at(double distance, const SizeOptions& sizes) const {
    constexpr int looks = 8;
    double size = std::numeric_limits<double>::infinity();
    for (int i = 0; i < looks; ++i) {
      const Point uv = place(2.0 * pi * i / looks, distance);
      const Jet jet = surface_.jet(uv);
      size = std::min({size, size_by_shape(jet, sizes), sizes.wanted_at(uv, jet.at)});
    }
    return size;
  }

  static constexpr int ways = 96;

 private:
  static constexpr double near = 1e-4;  // of half of the face's diagonal in the chart
  static Vector out(double angle) { return {std::cos(angle), std::sin(angle)}; }
  const Surface& surface_;
  Point tip_;
  Point3 at_;
  double step_;
};

/// As many triangles as there is room for at 60 degrees, but so many that the normals do not turn by more than 45
/// degrees from one to the next, unless angles at the tip became sharper than these.
std::size_t spokes_of(double whole_angle) {
  constexpr double turn = pi / 4.0, sharpest = 0.15;
  const double narrowing = std::min(1.0, whole_angle / (2.0 * pi));  // the sine of a cone's half angle
  const double turning = 2.0 * pi * std::sqrt(1.0 - narrowing * narrowing);
  const double fits = std::round(3.0 * whole_angle / pi);
  const double wanted = std::max(fits, std::min(std::ceil(turning / turn), std::floor(whole_angle / sharpest)));
  constexpr double least = 6.0, most = 24.0;
  return static_cast<std::size_t>(std::clamp(wanted, least, most));
}

/// Angles of the chart at equal parts of the developed one, its end left out.
std::vector<double> spokes(const std::vector<double>& developed, double from, double to, std::size_t count) {
  std::vector<double> made;
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = developed.back() * static_cast<double>(k) / static_cast<double>(count);
    while (developed[i + 1] < wanted) ++i;
    const double within = (wanted - developed[i]) / (developed[i + 1] - developed[i]);
    made.push_back(std::lerp(from, to, (static_cast<double>(i) + within) / Wheel::ways));
  }
  return made;
}

double nearest_side(const ChartInput& input, Point3 at) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& edge : input.chart.edges) {
    const Point3 a = input.at[edge.nodes[0].index()], b = input.at[edge.nodes[1].index()];
    const Vector3 way = b - a;
    const double square = dot(way, way);
    const double t = square > 0.0 ? std::clamp(dot(at - a, way) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, geom::distance(at, a + t * way));
  }
  return nearest;
}

void add_wheel(const ChartInput& given, std::size_t tip, double radius, const SizeOptions& sizes, double largest,
               Tips& tips) {
  constexpr double clear = 0.3;  // of the way to the nearest side
  const Point3 at = given.at[tip];
  const Wheel wheel(given, tip, radius);
  const std::vector<double> angles = wheel.developed();
  if (angles.empty() || !(angles.back() > 0.0)) return;
  const double whole = angles.back();
  const std::size_t count = spokes_of(whole);
  const double side = std::max(sizes.least, std::min(largest, wheel.size_at(tip_seen * largest, sizes)));
  if (!(side > 0.0)) return;
  tips.tips.push_back({at, side});
  ChartInput& made = tips.input;
  const double part = whole / static_cast<double>(count);
  const double length = std::min(0.5 * side / std::sin(0.5 * part), clear * nearest_side(given, at));
  if (!(length > 0.0) || !std::isfinite(length)) return;
  std::vector<Point> rim;
  for (const double angle : spokes(angles, 0.0, 2.0 * pi, count)) {
    const Point place = wheel.place(angle, length);
    if (!given.surface.chart().contains(place)) return;
    rim.push_back(place);
  }
  const std::size_t first = made.chart.points.size();
  const auto set = static_cast<std::uint32_t>(made.chart.sets.size());
  made.chart.sets.push_back({"", dobra::mesh::delaunay::EdgeKind::Constraint});
  for (std::size_t k = 0; k < count; ++k) {
    made.chart.points.push_back(rim[k]);
    made.at.push_back(given.surface.at(rim[k]));
    made.chart.edges.push_back({{NodeId(tip), NodeId(first + k)}, set});
    made.chart.edges.push_back({{NodeId(first + k), NodeId(first + (k + 1) % count)}, set});
  }
}

/// The other ends of the two boundary edges of each point where both sides of a seam end; none elsewhere.
std::vector<std::array<std::size_t, 2>> ends_of_seams(const ChartInput& input) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::array<std::size_t, 2>> ends(input.chart.points.size(), {none, none});
  if (input.node.size() != ends.size()) return ends;  // a chart alone
  std::vector<std::size_t> count(ends.size(), 0);
  for (const auto& edge : input.chart.edges) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t p = edge.nodes[i].index();
      const bool boundary = input.chart.sets[edge.set].kind == dobra::mesh::delaunay::EdgeKind::Boundary;
      if (boundary && count[p] < 2) ends[p][count[p]] = edge.nodes[1 - i].index();
      count[p] += boundary ? 1 : 3;  // of a line: it is no end of a seam alone
    }
  }
  for (std::size_t p = 0; p < ends.size(); ++p) {
    const auto& [a, b] = ends[p];
    if (count[p] != 2 || a == b || a == none || b == none || input.node[a] != input.node[b]) ends[p] = {none, none};
  }
  return ends;
}

/// Fills the sector at the end of a seam, whose two sides there are one in space.
void add_sector(const ChartInput& given, std::size_t tip, std::array<std::size_t, 2> ends, double radius, Tips& tips) {
  const Point at = given.chart.points[tip];
  const auto angle_to = [&](std::size_t p) {
    const Vector way = given.chart.points[p] - at;
    return std::atan2(way.y, way.x);
  };
  double from = angle_to(ends[0]), to = angle_to(ends[1]);
  if (to < from) std::swap(from, to), std::swap(ends[0], ends[1]);
  if (to - from > pi) std::swap(from, to), std::swap(ends[0], ends[1]), to += 2.0 * pi;
  const Wheel wheel(given, tip, radius);
  const std::vector<double> angles = wheel.developed(from, to);
  if (angles.empty() || !(angles.back() > 0.0)) return;
  const std::size_t count = spokes_of(angles.back());
  const double length = geom::distance(given.at[tip], given.at[ends[0]]);
  tips.tips.push_back({given.at[tip], 2.0 * length * std::sin(0.5 * angles.back() / static_cast<double>(count))});
  ChartInput& made = tips.input;
  const auto set = static_cast<std::uint32_t>(made.chart.sets.size());
  made.chart.sets.push_back({"", dobra::mesh::delaunay::EdgeKind::Constraint});
  const std::vector<double> ways = spokes(angles, from, to, count);
  std::size_t before = ends[0];
  for (std::size_t k = 1; k < count; ++k) {
    const Point place = wheel.place(ways[k], length);
    const std::size_t here = made.chart.points.size();
    made.chart.points.push_back(place);
    made.at.push_back(given.surface.at(place));
    made.chart.edges.push_back({{NodeId(tip), NodeId(here)}, set});
    made.chart.edges.push_back({{NodeId(before), NodeId(here)}, set});
    before = here;
  }
  made.chart.edges.push_back({{NodeId(before), NodeId(ends[1])}, set});
}

}  // namespace

bool is_corner_tip(const Surface& surface, Point at) {
  const geom::Box& chart = surface.chart();
  const bool pole = at == Point{} && chart.low.x < 0.0 && chart.high.x > 0.0 && chart.low.y < 0.0 && chart.high.y > 0.0;
  return pole && trim::has_tip(surface, at, 0.5 * chart.diagonal());
}

double first_way_from_tip(double half_angle, double size) {
  const double whole = 2.0 * pi * std::sin(half_angle);
  return 0.5 * size / std::sin(0.5 * whole / static_cast<double>(spokes_of(whole)));
}

Tips with_wheels(const ChartInput& input, const SizeOptions& sizes, double largest) {
  Tips tips{input, {}};
  std::vector<std::uint8_t> on_edge(input.chart.points.size(), 0);
  for (const auto& edge : input.chart.edges) {
    for (const NodeId node : edge.nodes) on_edge[node.index()] = 1;
  }
  const double radius = 0.5 * geom::box_of(input.chart.points).diagonal();
  for (std::size_t p = 0; p < on_edge.size(); ++p) {
    if (on_edge[p] != 0 || !trim::has_tip(input.surface, input.chart.points[p], radius)) continue;
    add_wheel(input, p, radius, sizes, largest, tips);
  }
  const auto seams = ends_of_seams(input);
  for (std::size_t p = 0; p < seams.size(); ++p) {
    if (on_edge[p] == 0 || !is_corner_tip(input.surface, input.chart.points[p])) continue;
    if (seams[p][0] < seams.size()) {
      add_sector(input, p, seams[p], radius, tips);
    } else {
      const double size = Wheel(input, p, radius).size_at(tip_seen * largest, sizes);
      tips.tips.push_back({input.at[p], std::max(sizes.least, std::min(largest, size))});
    }
  }
  return tips;
}

}  // namespace dobra::surf::mesh
