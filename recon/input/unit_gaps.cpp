#include "recon/input/unit_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "shared/geom/place.h"
#include "shared/geom/spatial_index.h"

namespace recon::input {

namespace {

constexpr std::size_t barrier = std::numeric_limits<std::size_t>::max();

struct Edge {
  geom::Segment segment;
  std::size_t polygon = barrier;  ///< Or a fault or a topography.
};

std::vector<Edge> edges_of(const section::Section& section) {
  std::vector<Edge> edges;
  const auto add = [&](const geom::Polyline& line, std::size_t polygon) {
    for (std::size_t k = 0; k < line.segment_count(); ++k) edges.push_back({line.segment(k), polygon});
  };
  for (std::size_t i = 0; i < section.units.size(); ++i) add(section.units[i].contour, i);
  for (const section::SectionLine& line : section.lines) {
    if (line.kind == section::LineKind::Fault || line.kind == section::LineKind::Topography) add(line.line, barrier);
  }
  return edges;
}

/// What two polygons have opposite each other.
struct Facing {
  double width = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  geom::Point place;  ///< Where it is least high.
};

class Gaps {
 public:
  Gaps(const section::Section& section, double tolerance)
      : edges_(edges_of(section)), index_(boxes_of(edges_)), box_(index_.box()), tolerance_(tolerance) {}

  /// From polygon to polygon below it.
  std::map<std::pair<std::size_t, std::size_t>, Facing> find() {
    constexpr double parts = 200.0;  // of the section, at least
    for (const Edge& edge : edges_) {
      const double width = edge.segment.to.x - edge.segment.from.x;
      if (edge.polygon == barrier || !(width > 0.0)) continue;  // contours run to the right below
      const double count = std::ceil(width * parts / box_.width());
      for (double k = 0.5; k < count; ++k)
        look_down(geom::interpolate(edge.segment.from, edge.segment.to, k / count), edge.polygon, width / count);
    }
    return std::move(facing_);
  }

 private:
  static std::vector<geom::Box> boxes_of(const std::vector<Edge>& edges) {
    std::vector<geom::Box> boxes;
    for (const Edge& edge : edges) boxes.push_back(edge.segment.box());
    return boxes;
  }

  void look_down(geom::Point from, std::size_t own, double width) {
    double nearest = std::numeric_limits<double>::infinity();
    const Edge* below = nullptr;
    const geom::Box way{{from.x, box_.low.y}, {from.x, from.y + tolerance_}};
    index_.for_each_overlapping(way, [&](std::size_t i) {
      const geom::Segment& s = edges_[i].segment;
      const double across = s.to.x - s.from.x;
      if (across == 0.0 || (edges_[i].polygon == own && across > 0.0)) return;
      const double height = from.y - geom::interpolate(s.from, s.to, (from.x - s.from.x) / across).y;
      if (height < -tolerance_ || height >= nearest) return;
      nearest = height;
      below = &edges_[i];
    });
    if (below == nullptr || below->polygon == barrier || below->polygon == own || nearest <= tolerance_) return;
    if (below->segment.to.x > below->segment.from.x) return;  // within it
    Facing& facing = facing_[{own, below->polygon}];
    facing.width += width;
    facing.greatest = std::max(facing.greatest, nearest);
    if (nearest >= facing.least) return;
    facing.least = nearest;
    facing.place = from;
  }

  std::vector<Edge> edges_;
  geom::SpatialIndex index_;
  geom::Box box_;
  double tolerance_ = 0.0;
  std::map<std::pair<std::size_t, std::size_t>, Facing> facing_;
};

}  // namespace

std::vector<std::string> wide_gaps(const section::Section& section, double tolerance) {
  std::vector<std::string> told;
  for (const auto& [pair, facing] : Gaps(section, tolerance).find()) {
    const section::Unit& upper = section.units[pair.first];
    const section::Unit& lower = section.units[pair.second];
    if (facing.width <= 0.5 * std::min(upper.contour.box().width(), lower.contour.box().width())) continue;
    told.push_back(fmt::format(
        "units '{}' and '{}' face each other over {:.6g} m without an edge in common, {:.4g} to {:.4g} m apart, least "
        "at {}: no horizon is made there; give share_edges (--edges M) where that is untidy drawing",
        upper.name, lower.name, facing.width, facing.least, facing.greatest, facing.place));
  }
  return told;
}

}  // namespace recon::input
