#include "recon/maps/shear_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/place.h"

namespace recon::maps {

namespace {

/// A line as a function w(q), q increasing.
struct Graph {
  std::vector<double> q;
  std::vector<double> w;

  /// w at q; beyond the ends the end pieces go on straight. `i` is a piece at or before that of q, moved on.
  [[nodiscard]] double at(double where, std::size_t& i) const {
    while (i + 2 < q.size() && where > q[i + 1]) ++i;
    return w[i] + (where - q[i]) * slope(i);
  }
  [[nodiscard]] double slope(std::size_t i) const { return (w[i + 1] - w[i]) / (q[i + 1] - q[i]); }
};

/// A piece that advances less than this part of its length runs along the direction of shear.
constexpr double least_advance = 1e-9;

/// " (it does not at angles from A to B degrees)": where every piece advances; empty if there is no such angle.
/// A piece (dx, dz) advances where tan a dz < dx.
std::string sound_angles(const geom::Polyline& line) {
  double low = -infinity;
  double high = infinity;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Vector v = line.segment(i).vector();
    if (v.y > 0.0) high = std::min(high, v.x / v.y);
    if (v.y < 0.0) low = std::max(low, v.x / v.y);
    if (v.y == 0.0 && v.x <= 0.0) return {};
  }
  // A tenth of a degree within, where the map is not at its limit.
  const double from = std::ceil(10.0 * base::Angle::from_radians(std::atan(low)).degrees() + 1.0) / 10.0;
  const double to = std::floor(10.0 * base::Angle::from_radians(std::atan(high)).degrees() - 1.0) / 10.0;
  return from <= to ? fmt::format(" (it does not at angles from {:.1f} to {:.1f} degrees)", from, to) : std::string();
}

base::Result<Graph> graph_of(const geom::Polyline& given, double cosine, double sine, const char* item) {
  const auto q_of = [&](geom::Point p) { return cosine * p.x - sine * p.y; };
  geom::Polyline line = given;
  // From left to right: a shear beyond the dip would turn the section round, with all pieces in one direction.
  const geom::Vector along = line.points.back() - line.points.front();
  if (along.x < 0.0 || (along.x == 0.0 && along.y * sine > 0.0)) line = geom::reversed(std::move(line));
  Graph graph;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const geom::Point p = line.points[i];
    if (i > 0 && !(q_of(p) - graph.q.back() > least_advance * geom::distance(line.points[i - 1], p))) {
      return base::Error{base::ErrorCode::CannotRestore,
                         fmt::format("the {} turns against the direction of shear here{}, so that the shear is not "
                                     "single-valued; choose another angle, a simpler {}, or another method",
                                     item, sound_angles(line), item),
                         place_at(line.points[i - 1], "shear")};
    }
    graph.q.push_back(q_of(p));
    graph.w.push_back(sine * p.x + cosine * p.y);
  }
  return graph;
}

}  // namespace

base::Result<ShearMap> ShearMap::make(const geom::Polyline& top, const geom::Polyline& target, base::Angle angle,
                                      geom::Point pin, geom::Point goal, const MapOptions& options, const char* what) {
  ShearMap map;
  map.cosine_ = std::cos(angle.radians());
  map.sine_ = std::sin(angle.radians());
  map.travel_ = map.q_of(goal) - map.q_of(pin);
  DOBRA_TRY(const Graph from, graph_of(top, map.cosine_, map.sine_, what));
  DOBRA_TRY(Graph to, graph_of(target, map.cosine_, map.sine_, "target"));
  for (double& q : to.q) q -= map.travel_;
  map.first_ = from.q.front();
  map.last_ = from.q.back();
  map.tolerances_ = tolerances_for(top.box(), target.box(), options);
  std::vector<double> corners = from.q;
  corners.insert(corners.end(), to.q.begin(), to.q.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::size_t i = 0;
  std::size_t j = 0;
  map.strips_.reserve(corners.size() + 1);
  map.strips_.push_back(
      {corners.front(), from.at(corners.front(), i), from.slope(0), to.at(corners.front(), j), to.slope(0)});
  for (const double q : corners) {
    Strip strip{q, from.at(q, i), 0.0, to.at(q, j), 0.0};
    // A corner belongs to the piece that ends there; the strip after it has the slope of the next.
    std::size_t next_i = i;
    std::size_t next_j = j;
    if (next_i + 2 < from.q.size() && from.q[next_i + 1] <= q) ++next_i;
    if (next_j + 2 < to.q.size() && to.q[next_j + 1] <= q) ++next_j;
    strip.top_slope = from.slope(next_i);
    strip.goal_slope = to.slope(next_j);
    map.strips_.push_back(strip);
  }
  return map;
}

ShearMap ShearMap::swapped() const {
  ShearMap back = *this;
  for (Strip& strip : back.strips_) {
    std::swap(strip.top, strip.goal);
    std::swap(strip.top_slope, strip.goal_slope);
    strip.begin += travel_;
  }
  back.first_ += travel_;
  back.last_ += travel_;
  back.travel_ = -travel_;
  return back;
}

ShearMap ShearMap::part(double part) const {
  ShearMap way = *this;
  for (Strip& strip : way.strips_) {
    strip.goal = (1.0 - part) * strip.top + part * strip.goal;
    strip.goal_slope = (1.0 - part) * strip.top_slope + part * strip.goal_slope;
  }
  way.travel_ *= part;
  return way;
}

Spot ShearMap::locate(geom::Point p, Cell hint) const {
  const double q = q_of(p);
  const std::size_t last = strips_.size() - 1;
  std::size_t strip = std::min<std::size_t>(hint.first, last);
  for (int step = 0; step < 8; ++step) {
    if (strip < last && q > strips_[strip + 1].begin) {
      ++strip;
    } else if (strip > 0 && q <= strips_[strip].begin) {
      --strip;
    } else {
      return {{static_cast<std::uint32_t>(strip), 0}, 0.0, Foot::InColumn};
    }
  }
  const auto after = std::lower_bound(strips_.begin() + 1, strips_.end(), q,
                                      [](const Strip& s, double value) { return s.begin < value; });
  return {{static_cast<std::uint32_t>(after - strips_.begin() - 1), 0}, 0.0, Foot::InColumn};
}

std::array<double, 2> ShearMap::beyond(Cell cell, geom::Point p) const {
  const double q = q_of(p);
  const std::size_t strip = cell.first;
  return {strip == 0 ? -infinity : strips_[strip].begin - q,
          strip + 1 == strips_.size() ? -infinity : q - strips_[strip + 1].begin};
}

Carried ShearMap::carry(Cell cell, geom::Point p) const {
  const Strip& strip = strips_[cell.first];
  const double along = q_of(p) - strip.begin;
  const double top = strip.top + along * strip.top_slope;
  const double goal = strip.goal + along * strip.goal_slope;
  const double depth = top - (sine_ * p.x + cosine_ * p.y);
  return {{ColumnId(cell.first), along, depth}, shifted(p, goal - top, travel_)};
}

geom::Point ShearMap::back(geom::Point image, Cell& hint) const {
  const geom::Point across = shifted(image, 0.0, -travel_);
  hint = locate(across, hint).cell;
  const Strip& strip = strips_[hint.first];
  const double along = q_of(across) - strip.begin;
  return shifted(across, strip.top - strip.goal + along * (strip.top_slope - strip.goal_slope), 0.0);
}

bool ShearMap::is_outer(Cell, geom::Point p) const {
  return q_of(p) < first_ - tolerances_.side || q_of(p) > last_ + tolerances_.side;
}

}  // namespace recon::maps
