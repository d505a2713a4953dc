// 1. The boundary of the unbounded face: undersides of polygons, and upper sides.
// 2. Under each underside the first upper side: trapezoids between neighbouring ends of either. What has rock on its
// left
//    and its right is found in the same way, with x and height exchanged.
// 3. Trapezoids that share part of a side are one gap, and so are those of both ways that overlap; what they have in
//    common counts once.

#include "recon/section/open_gaps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// Upwards: rock over rock. Sideways: rock on the left and on the right; x and height are exchanged, so that "left" is
/// low, "roof" is the rock on the right, and "floor" the one on the left.
enum class Way : std::uint8_t { Upwards, Sideways };

geom::Point seen(Way way, geom::Point p) { return way == Way::Upwards ? p : geom::Point{p.y, p.x}; }

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
  [[nodiscard]] geom::Point middle_at(double x) const { return {x, 0.5 * (floor->at(x) + roof->at(x))}; }
  /// As a contour of the section, either way round.
  [[nodiscard]] std::vector<geom::Point> corners(Way way) const {
    return {seen(way, {left, floor->at(left)}), seen(way, {right, floor->at(right)}),
            seen(way, {right, roof->at(right)}), seen(way, {left, roof->at(left)})};
  }
};

double area_of(const std::vector<geom::Point>& corners) {
  return corners.size() < 3 ? 0.0 : std::abs(geom::signed_area(geom::Polyline{corners, true}));
}

/// What two trapezoids, each as corners round it, have in common.
double common_area(std::vector<geom::Point> a, std::vector<geom::Point> b) {
  if (geom::signed_area(geom::Polyline{b, true}) < 0.0) std::reverse(b.begin(), b.end());
  for (std::size_t k = 0; k < b.size() && a.size() > 2; ++k) {
    const geom::Point from = b[k];
    const geom::Vector way = b[(k + 1) % b.size()] - from;
    if (way.x == 0.0 && way.y == 0.0) continue;
    std::vector<geom::Point> within;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const geom::Point p = a[i], q = a[(i + 1) % a.size()];
      const double at_p = geom::cross(way, p - from), at_q = geom::cross(way, q - from);
      if (at_p >= 0.0) within.push_back(p);
      if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
        within.push_back(geom::interpolate(p, q, at_p / (at_p - at_q)));
    }
    a = std::move(within);
  }
  return area_of(a);
}

/// Numbers that hang together, by the least of them.
class Groups {
 public:
  explicit Groups(std::size_t count) : first_(count) { std::iota(first_.begin(), first_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (first_[i] != i) i = first_[i] = first_[first_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { first_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }
  std::map<std::size_t, std::vector<std::size_t>> all() {
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < first_.size(); ++i) groups[root(i)].push_back(i);
    return groups;
  }

 private:
  std::vector<std::size_t> first_;
};

/// Open ground with rock on two opposite sides.
class Look {
 public:
  Look(Way way, const Section& section, const Arrangement& arrangement,
       const std::vector<std::vector<std::uint32_t>>& holders)
      : way_(way), section_(section) {
    collect(arrangement, holders);
    std::vector<geom::Box> boxes;
    for (const Side& side : floors_) boxes.push_back(side.segment.box());
    index_ = geom::SpatialIndex(boxes);
    for (const Unit& unit : section.units) {
      for (const geom::Point p : unit.contour.points) box_.add(seen(way_, p));
    }
    for (const Side& roof : roofs_) look_under(roof);
  }

  [[nodiscard]] const std::vector<Trapezoid>& trapezoids() const { return trapezoids_; }
  /// Whether a topography says that all of it is rock.
  [[nodiscard]] bool under_ground(const std::vector<std::size_t>& parts) const {
    return std::all_of(parts.begin(), parts.end(), [&](std::size_t i) {
      const double middle = 0.5 * (trapezoids_[i].left + trapezoids_[i].right);
      return !grounds_at(trapezoids_[i].middle_at(middle).y).empty();  // over it there would be none
    });
  }
  [[nodiscard]] Groups groups() const {
    Groups groups(trapezoids_.size());
    std::map<double, std::vector<std::size_t>> beginning;
    for (std::size_t i = 0; i < trapezoids_.size(); ++i) beginning[trapezoids_[i].left].push_back(i);
    for (std::size_t i = 0; i < trapezoids_.size(); ++i) {
      const double x = trapezoids_[i].right;
      const auto next = beginning.find(x);
      if (next == beginning.end()) continue;
      for (const std::size_t k : next->second) {
        const Trapezoid &a = trapezoids_[i], &b = trapezoids_[k];
        const double low = std::max(a.floor->at(x), b.floor->at(x)), high = std::min(a.roof->at(x), b.roof->at(x));
        if (low < high) groups.join(i, k);
      }
    }
    return groups;
  }
  /// Whether rock looks at a place from straight over or under it.
  [[nodiscard]] bool rock_over(geom::Point p) const { return meets(roofs_, {p, {p.x, box_.high.y}}); }
  [[nodiscard]] bool rock_under(geom::Point p) const { return meets(floors_, {{p.x, box_.low.y}, p}); }

 private:
  static bool meets(const std::vector<Side>& sides, const geom::Segment& upright) {
    return std::any_of(sides.begin(), sides.end(), [&](const Side& side) {
      const double x = upright.from.x;
      if (x < side.segment.from.x || x > side.segment.to.x) return false;
      return side.at(x) >= upright.from.y && side.at(x) <= upright.to.y;
    });
  }

  void collect(const Arrangement& arrangement, const std::vector<std::vector<std::uint32_t>>& holders) {
    const topo::Subdivision& sub = arrangement.subdivision();
    for (const topo::LoopId loop : sub.loops(Structure::unbounded())) {
      for (const HalfEdgeId h : sub.half_edges(loop)) {
        const auto& rock = holders[sub.face(Structure::twin(h)).index()];
        if (rock.empty()) continue;
        std::vector<geom::Point> course;
        arrangement.append(h, course);
        course.push_back(sub.point(sub.target(h)));
        // Open ground lies on the left; with x and height exchanged, on the right.
        if (way_ == Way::Sideways) std::reverse(course.begin(), course.end());
        for (std::size_t i = 0; i + 1 < course.size(); ++i) {
          const geom::Point p = seen(way_, course[i]), q = seen(way_, course[i + 1]);
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
      if (!is_air(middle, floor->at(middle), height)) trapezoids_.push_back({cuts[i], cuts[i + 1], &roof, floor});
    }
  }

  /// Under a topography there is rock, over it there is air.
  [[nodiscard]] bool is_air(double at, double low, double high) const {
    const std::vector<double> grounds = grounds_at(way_ == Way::Upwards ? at : 0.5 * (low + high));
    return std::any_of(grounds.begin(), grounds.end(), [&](double ground) {
      return way_ == Way::Upwards ? ground > low && ground < high : ground < at;
    });
  }
  [[nodiscard]] std::vector<double> grounds_at(double x) const {
    std::vector<double> grounds;
    for (const SectionLine& line : section_.lines) {
      if (line.kind != LineKind::Topography) continue;
      for (std::size_t k = 0; k < line.line.segment_count(); ++k) {
        const geom::Segment s = line.line.segment(k);
        if ((s.from.x <= x) == (s.to.x <= x)) continue;
        grounds.push_back(geom::interpolate(s.from, s.to, (x - s.from.x) / (s.to.x - s.from.x)).y);
      }
    }
    return grounds;
  }

  Way way_;
  const Section& section_;
  std::vector<Side> roofs_, floors_;
  geom::SpatialIndex index_;
  geom::Box box_;  // as it is seen
  std::vector<Trapezoid> trapezoids_;
};

class OpenGaps {
 public:
  OpenGaps(const Section& section, const Arrangement& arrangement,
           const std::vector<std::vector<std::uint32_t>>& holders)
      : section_(section),
        upwards_(Way::Upwards, section, arrangement, holders),
        sideways_(Way::Sideways, section, arrangement, holders) {
    for (const Unit& unit : section.units) box_.add(unit.contour.box());
    for (const Trapezoid& part : upwards_.trapezoids())
      parts_.push_back({Way::Upwards, part, part.corners(Way::Upwards)});
    for (const auto& [first, parts] : sideways_.groups().all()) {
      if (!is_valley(parts)) add_sideways(parts);
    }
  }

  std::vector<Misfit> find() {
    std::vector<Misfit> gaps;
    for (const auto& [first, parts] : joined().all()) {
      if (auto gap = gap_of(parts)) gaps.push_back(std::move(*gap));
    }
    return gaps;
  }

 private:
  struct Part {
    Way way;
    Trapezoid shape;
    std::vector<geom::Point> corners;
    double common = 0.0;      ///< With parts of the other way.
    std::size_t next_to = 0;  ///< A part of its own way that hangs together with it, or itself.
  };

  /// Ground that is open on one side alone, over rock or under it, is a gap if it is deeper than it is wide on the
  /// mean; else it is a valley, or what lies under a section that is not drawn equally deep.
  [[nodiscard]] bool is_valley(const std::vector<std::size_t>& parts) const {
    if (sideways_.under_ground(parts)) return false;
    const std::vector<Trapezoid>& all = sideways_.trapezoids();
    const Trapezoid *lowest = &all[parts.front()], *highest = lowest;
    double area = 0.0;
    for (const std::size_t i : parts) {
      area += all[i].area();
      if (all[i].left < lowest->left) lowest = &all[i];
      if (all[i].right > highest->right) highest = &all[i];
    }
    const double depth = highest->right - lowest->left;
    const bool closed = upwards_.rock_under(seen(Way::Sideways, lowest->middle_at(lowest->left))) ||
                        upwards_.rock_over(seen(Way::Sideways, highest->middle_at(highest->right)));
    return closed && depth * depth <= area;
  }

  void add_sideways(const std::vector<std::size_t>& parts) {
    const std::size_t first = parts_.size();
    for (const std::size_t i : parts) {
      const Trapezoid& part = sideways_.trapezoids()[i];
      parts_.push_back({Way::Sideways, part, part.corners(Way::Sideways), 0.0, first});
    }
  }

  /// Those of one way that hang together, and those of both ways that overlap.
  Groups joined() {
    Groups groups(parts_.size());
    const std::size_t upwards = upwards_.trapezoids().size();
    for (const auto& [first, parts] : upwards_.groups().all()) {
      for (const std::size_t i : parts) groups.join(first, i);
    }
    std::vector<geom::Box> boxes;
    for (std::size_t i = 0; i < upwards; ++i) boxes.push_back(box_of(parts_[i]));
    const geom::SpatialIndex index(boxes);
    for (std::size_t i = upwards; i < parts_.size(); ++i) {
      groups.join(i, parts_[i].next_to);
      index.for_each_overlapping(box_of(parts_[i]), [&](std::size_t k) {
        const double common = common_area(parts_[i].corners, parts_[k].corners);
        if (!(common > 0.0)) return;
        parts_[i].common += common;
        groups.join(i, k);
      });
    }
    return groups;
  }
  static geom::Box box_of(const Part& part) { return geom::Polyline{part.corners, true}.box(); }

  [[nodiscard]] std::optional<Misfit> gap_of(const std::vector<std::size_t>& parts) const {
    std::array<double, 2> areas{};
    std::set<std::string> names;
    Misfit gap{"gap", "", 0.0, {}};
    for (const std::size_t i : parts) {
      const Part& part = parts_[i];
      areas[static_cast<std::size_t>(part.way)] += part.shape.area();
      gap.area += part.shape.area() - part.common;
      for (const Side* side : {part.shape.roof, part.shape.floor}) names.insert(section_.units[side->polygon].name);
    }
    gap.upright = areas[1] > areas[0];
    const Way way = gap.upright ? Way::Sideways : Way::Upwards;
    double left = INFINITY, right = -INFINITY;
    for (const std::size_t i : parts) {
      if (parts_[i].way != way) continue;
      left = std::min(left, parts_[i].shape.left), right = std::max(right, parts_[i].shape.right);
    }
    gap.open_over = right - left;
    if (gap.open_over <= rounded * box_.diagonal() || gap.area <= rounded * box_.diagonal() * gap.open_over)
      return std::nullopt;
    const double middle = 0.5 * (left + right);
    double off = INFINITY;
    for (const std::size_t i : parts) {
      const Trapezoid& part = parts_[i].shape;
      const double at = std::clamp(middle, part.left, part.right);
      if (parts_[i].way != way || std::abs(at - middle) >= off) continue;
      off = std::abs(at - middle);
      gap.place = seen(way, part.middle_at(at));
    }
    gap.between = fmt::format("{}", fmt::join(names, ", "));
    return gap;
  }

  const Section& section_;
  Look upwards_, sideways_;
  std::vector<Part> parts_;
  geom::Box box_;
};

}  // namespace

std::vector<Misfit> open_gaps(const Section& section, const Arrangement& arrangement,
                              const std::vector<std::vector<std::uint32_t>>& holders) {
  return OpenGaps(section, arrangement, holders).find();
}

}  // namespace recon::section
