#include "recon/core/shear_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/section.h"

namespace recon::core {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// Of a line that is passed more than once somewhere, the pass that comes first from its left end.
base::Result<Graph> graph_of(const geom::Polyline& given, double cosine, double sine, Doubt doubt,
                             std::vector<std::string>& remarks) {
  const auto q_of = [&](geom::Point p) { return cosine * p.x - sine * p.y; };
  const auto w_of = [&](geom::Point p) { return sine * p.x + cosine * p.y; };
  geom::Polyline line = given;
  if (q_of(line.points.front()) > q_of(line.points.back())) line = geom::reversed(std::move(line));
  Graph graph;
  std::size_t hidden = 0;
  std::optional<geom::Point> first_hidden;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const geom::Point p = line.points[i];
    if (graph.q.empty() || q_of(p) > graph.q.back()) {
      const bool after_hidden = i > 0 && !graph.q.empty() && q_of(line.points[i - 1]) < graph.q.back();
      if (after_hidden) {  // where the line comes out again: a step, drawn over the least width that doubles resolve
        const geom::Point before = line.points[i - 1];
        const double t = (graph.q.back() - q_of(before)) / (q_of(p) - q_of(before));
        const double step = std::nextafter(graph.q.back(), infinity);
        if (step < q_of(p)) {
          graph.q.push_back(step);
          graph.w.push_back(w_of(geom::interpolate(before, p, t)));
        }
      }
      graph.q.push_back(q_of(p));
      graph.w.push_back(w_of(p));
      continue;
    }
    ++hidden;
    if (!first_hidden) first_hidden = p;
  }
  if (graph.q.size() < 2) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "the line runs along the direction of shear; choose another angle",
                       place_at(given.points.front())};
  }
  if (hidden > 0 && doubt == Doubt::Refuse) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "the line is overturned here against the direction of shear, so that the shear is not "
                       "single-valued; choose another angle, or outside = \"nearest\"",
                       place_at(*first_hidden)};
  }
  if (hidden > 0) {
    remarks.push_back(
        fmt::format("{} points of the line are overturned against the direction of shear, the first at ({:.6g}, "
                    "{:.6g}): there the limb that comes first was taken",
                    hidden, first_hidden->x, first_hidden->y));
  }
  return graph;
}

}  // namespace

base::Result<ShearMap> ShearMap::make(const geom::Polyline& top, const geom::Polyline& target, base::Angle angle,
                                      Doubt doubt, std::vector<std::string>& remarks, const MapOptions& options) {
  ShearMap map;
  map.cosine_ = std::cos(angle.radians());
  map.sine_ = std::sin(angle.radians());
  DOBRA_TRY(const Graph from, graph_of(top, map.cosine_, map.sine_, doubt, remarks));
  DOBRA_TRY(const Graph to, graph_of(target, map.cosine_, map.sine_, doubt, remarks));
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
  }
  return back;
}

ShearMap ShearMap::part(double part) const {
  ShearMap way = *this;
  for (Strip& strip : way.strips_) {
    strip.goal = (1.0 - part) * strip.top + part * strip.goal;
    strip.goal_slope = (1.0 - part) * strip.top_slope + part * strip.goal_slope;
  }
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
  return {{ColumnId(cell.first), along, depth}, shifted(p, goal - top)};
}

geom::Point ShearMap::back(geom::Point image, Cell& hint) const {
  hint = locate(image, hint).cell;
  const Strip& strip = strips_[hint.first];
  const double along = q_of(image) - strip.begin;
  return shifted(image, strip.top - strip.goal + along * (strip.top_slope - strip.goal_slope));
}

bool ShearMap::is_outer(Cell cell) const {
  const Strip& strip = strips_[cell.first];
  return cell.first == 0 || strip.begin >= last_ || strip.begin < first_;
}

}  // namespace recon::core
