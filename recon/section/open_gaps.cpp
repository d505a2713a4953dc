// 1. The boundary of the unbounded face: undersides of polygons, and upper sides.
// 2. Under each underside the first upper side: trapezoids between neighbouring ends of either.
// 3. Trapezoids that share part of an upright side are one gap.

#include "recon/section/open_gaps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "shared/geom/spatial_index.h"

namespace recon::section {

namespace {

using topo::HalfEdgeId;
using topo::Structure;

constexpr double rounded = 1e-9;  // of the size: what is thinner is no gap

/// A piece of boundary, from left to right.
struct Side {
  geom::Segment segment;
  std::size_t polygon = 0;
  [[nodiscard]] double at(double x) const {
    const double part = (x - segment.from.x) / (segment.to.x - segment.from.x);
    return part >= 1.0 ? segment.to.y : segment.from.y + part * (segment.to.y - segment.from.y);
  }
};

struct Trapezoid {
  double left = 0.0, right = 0.0;
  const Side *roof = nullptr, *floor = nullptr;
  [[nodiscard]] double height(double x) const { return roof->at(x) - floor->at(x); }
  [[nodiscard]] double area() const { return 0.5 * (right - left) * (height(left) + height(right)); }
};

class OpenGaps {
 public:
  OpenGaps(const Section& section, const Arrangement& arrangement,
           const std::vector<std::vector<std::uint32_t>>& holders)
      : section_(section) {
    collect(arrangement, holders);
    std::vector<geom::Box> boxes;
    for (const Side& side : floors_) boxes.push_back(side.segment.box());
    index_ = geom::SpatialIndex(boxes);
    for (const Unit& unit : section.units) box_.add(unit.contour.box());
  }

  std::vector<Misfit> find() {
    for (const Side& roof : roofs_) look_under(roof);
    std::vector<Misfit> gaps;
    for (const auto& [first, parts] : joined()) {
      if (auto gap = gap_of(parts)) gaps.push_back(std::move(*gap));
    }
    return gaps;
  }

 private:
  void collect(const Arrangement& arrangement, const std::vector<std::vector<std::uint32_t>>& holders) {
    const topo::Subdivision& sub = arrangement.subdivision();
    for (const topo::LoopId loop : sub.loops(Structure::unbounded())) {
      for (const HalfEdgeId h : sub.half_edges(loop)) {
        const auto& rock = holders[sub.face(Structure::twin(h)).index()];
        if (rock.empty()) continue;
        std::vector<geom::Point> course;
        arrangement.append(h, course);
        course.push_back(sub.point(sub.target(h)));
        for (std::size_t i = 0; i + 1 < course.size(); ++i) {
          const geom::Point p = course[i], q = course[i + 1];
          // Open ground lies on the left.
          if (p.x < q.x) floors_.push_back({{p, q}, rock.back()});
          if (p.x > q.x) roofs_.push_back({{q, p}, rock.back()});
        }
      }
    }
  }

  void look_under(const Side& roof) {
    const double from = roof.segment.from.x, to = roof.segment.to.x;
    const double top = std::max(roof.segment.from.y, roof.segment.to.y);
    std::vector<double> cuts{from, to};
    const geom::Box under{{from, box_.low.y}, {to, top}};
    index_.for_each_overlapping(under, [&](std::size_t i) {
      for (const double x : {floors_[i].segment.from.x, floors_[i].segment.to.x}) {
        if (x > from && x < to) cuts.push_back(x);
      }
    });
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
      const double height = roof.at(middle);
      const Side* floor = nullptr;
      index_.for_each_overlapping({{middle, box_.low.y}, {middle, height}}, [&](std::size_t k) {
        const double at = floors_[k].at(middle);
        if (at < height && (floor == nullptr || at > floor->at(middle))) floor = &floors_[k];
      });
      if (floor == nullptr || floor->polygon == roof.polygon) continue;  // a notch of one polygon
      if (!ground_between(middle, floor->at(middle), height))
        trapezoids_.push_back({cuts[i], cuts[i + 1], &roof, floor});
    }
  }

  /// Under a topography there is rock, over it there is air.
  [[nodiscard]] bool ground_between(double x, double low, double high) const {
    for (const SectionLine& line : section_.lines) {
      if (line.kind != LineKind::Topography) continue;
      for (std::size_t k = 0; k < line.line.segment_count(); ++k) {
        const geom::Segment s = line.line.segment(k);
        if ((s.from.x <= x) == (s.to.x <= x)) continue;
        const double y = geom::interpolate(s.from, s.to, (x - s.from.x) / (s.to.x - s.from.x)).y;
        if (y > low && y < high) return true;
      }
    }
    return false;
  }

  /// By the number of the first: trapezoids that hang together.
  std::map<std::size_t, std::vector<std::size_t>> joined() {
    std::vector<std::size_t> first(trapezoids_.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
      while (first[i] != i) i = first[i] = first[first[i]];
      return i;
    };
    std::map<double, std::vector<std::size_t>> beginning;
    for (std::size_t i = 0; i < trapezoids_.size(); ++i) beginning[trapezoids_[i].left].push_back(i);
    for (std::size_t i = 0; i < trapezoids_.size(); ++i) {
      const double x = trapezoids_[i].right;
      const auto next = beginning.find(x);
      if (next == beginning.end()) continue;
      for (const std::size_t k : next->second) {
        const Trapezoid &a = trapezoids_[i], &b = trapezoids_[k];
        const double low = std::max(a.floor->at(x), b.floor->at(x)), high = std::min(a.roof->at(x), b.roof->at(x));
        if (low < high) first[std::max(root(i), root(k))] = std::min(root(i), root(k));
      }
    }
    std::map<std::size_t, std::vector<std::size_t>> gaps;
    for (std::size_t i = 0; i < trapezoids_.size(); ++i) gaps[root(i)].push_back(i);
    return gaps;
  }

  [[nodiscard]] std::optional<Misfit> gap_of(const std::vector<std::size_t>& parts) const {
    std::set<std::string> names;
    double left = INFINITY, right = -INFINITY;
    Misfit gap{"gap", "", 0.0, {}};
    for (const std::size_t i : parts) {
      const Trapezoid& part = trapezoids_[i];
      gap.area += part.area();
      left = std::min(left, part.left), right = std::max(right, part.right);
      for (const Side* side : {part.roof, part.floor}) names.insert(section_.units[side->polygon].name);
    }
    gap.open_over = right - left;
    if (gap.open_over <= rounded * box_.diagonal() || gap.area <= rounded * box_.diagonal() * gap.open_over)
      return std::nullopt;
    const double middle = 0.5 * (left + right);
    double off = INFINITY;
    for (const std::size_t i : parts) {
      const Trapezoid& part = trapezoids_[i];
      const double x = std::clamp(middle, part.left, part.right);
      if (std::abs(x - middle) >= off) continue;
      off = std::abs(x - middle);
      gap.place = {x, 0.5 * (part.floor->at(x) + part.roof->at(x))};
    }
    gap.between = fmt::format("{}", fmt::join(names, ", "));
    return gap;
  }

  const Section& section_;
  std::vector<Side> roofs_, floors_;
  geom::SpatialIndex index_;
  geom::Box box_;
  std::vector<Trapezoid> trapezoids_;
};

}  // namespace

std::vector<Misfit> open_gaps(const Section& section, const Arrangement& arrangement,
                              const std::vector<std::vector<std::uint32_t>>& holders) {
  return OpenGaps(section, arrangement, holders).find();
}

}  // namespace recon::section
