#include "shared/surf/remesh/slits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "shared/geom/box3.h"
#include "shared/surf/remesh/flatten.h"
#include "shared/surf/remesh/triangle_tree.h"

namespace dobra::surf::remesh {

using geom::Box3;
using geom::Point3;
using param::HalfEdge;

namespace {

constexpr double of_extent = 1e-6, of_side = 0.01;

/// A side of a border; its first end is a point of the border as well.
struct BorderSide {
  std::uint32_t sheet = 0, start = 0, end = 0, across = 0;  ///< Points; that across the triangle is no slit with it.
  Point3 from, to;
};

/// A distance at which the first end of one side lies from another side.
class SlitSearch {
 public:
  SlitSearch(std::vector<BorderSide> sides, double tolerance) : sides_(std::move(sides)), tolerance_(tolerance) {
    all_.resize(sides_.size());
    for (std::uint32_t i = 0; i < all_.size(); ++i) all_[i] = i;
    off_.assign(sides_.size(), -1.0);
    std::vector<std::uint32_t> points = all_;
    descend(all_, points);
  }

  std::size_t count = 0;
  double greatest = 0.0;
  bool within_one = false;  ///< Some lie on a border of their own piece.
  [[nodiscard]] Point3 first() const {
    const auto at = std::ranges::find_if(off_, [](double off) { return off >= 0.0; });
    return sides_[static_cast<std::size_t>(at - off_.begin())].from;
  }

 private:
  /// Looks at the sides and those points that are near their box; halves the sides along the box.
  void descend(std::span<std::uint32_t> sides, const std::vector<std::uint32_t>& points) {
    Box3 box;
    for (const std::uint32_t s : sides) box.add(sides_[s].from), box.add(sides_[s].to);
    const geom::Vector3 margin{tolerance_, tolerance_, tolerance_};
    const Box3 wide{box.low - margin, box.high + margin};
    std::vector<std::uint32_t> near;
    for (const std::uint32_t p : points) {
      if (wide.contains(sides_[p].from)) near.push_back(p);
    }
    constexpr std::size_t few = 8;
    if (near.empty()) return;
    if (sides.size() <= few) {
      for (const std::uint32_t p : near) {
        for (const std::uint32_t s : sides) look(p, s);
      }
      return;
    }
    const geom::Vector3 extent = box.high - box.low;
    const auto along = [&](std::uint32_t s) {
      const Point3 m = sides_[s].from + 0.5 * (sides_[s].to - sides_[s].from);
      return extent.x >= extent.y && extent.x >= extent.z ? m.x : extent.y >= extent.z ? m.y : m.z;
    };
    const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
    std::ranges::nth_element(sides, middle, {}, along);
    descend({sides.begin(), middle}, near);
    descend({middle, sides.end()}, near);
  }

  void look(std::uint32_t point, std::uint32_t side) {
    const BorderSide& p = sides_[point];
    const BorderSide& s = sides_[side];
    if (p.sheet == s.sheet && (p.start == s.start || p.start == s.end || p.start == s.across)) return;
    if (p.from == s.from || p.from == s.to) return;  // copies of one point
    const double off = geom::distance(p.from, nearest_on(p.from, s.from, s.to, s.to));
    const double shorter = std::min(geom::distance(s.from, s.to), geom::distance(p.from, p.to));
    if (off > std::min(tolerance_, of_side * shorter)) return;
    if (off_[point] < 0.0) ++count;
    off_[point] = std::max(off_[point], off);
    greatest = std::max(greatest, off);
    within_one = within_one || p.sheet == s.sheet;
  }

  std::vector<BorderSide> sides_;
  double tolerance_;
  std::vector<std::uint32_t> all_;
  std::vector<double> off_;  ///< One a side: of its first end; less than nought where there is none.
};

}  // namespace

std::optional<base::Finding> slits_of(const std::vector<param::SheetMade>& sheets) {
  std::vector<BorderSide> sides;
  Box3 box;
  for (std::uint32_t i = 0; i < sheets.size(); ++i) {
    const param::Sheet& sheet = sheets[i].sheet;
    for (const Point3 p : sheet.points) box.add(p);
    for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
      if (sheet.twins[h] != param::no_half_edge) continue;
      const std::uint32_t a = sheet.start(h), b = sheet.end(h);
      sides.push_back({i, a, b, sheet.start(param::previous(h)), sheet.points[a], sheet.points[b]});
    }
  }
  if (sides.empty()) return std::nullopt;
  const SlitSearch search(std::move(sides), of_extent * box.diagonal());
  if (search.count == 0) return std::nullopt;
  if (!search.within_one) {
    return base::Finding{
        "slit",
        fmt::format(
            "points of borders of one piece that lie on borders of another, at most {:.2g} off, and are not "
            "joined: {}; surfaces that only meet, such as a horizon and a fault that cuts it, stay so; pieces of "
            "one surface need the same coordinates for points that are one, and sides divided at points that "
            "lie on them",
            search.greatest, search.count),
        place_of(search.first())};
  }
  return base::Finding{
      "slit",
      fmt::format("points of borders that lie on other borders, at most {:.2g} off, and are not joined, so that the "
                  "mesh is open there: {}; give points that are one the same coordinates and divide sides at points "
                  "that lie on them, as `quebra solid --repair` does with closed meshes",
                  search.greatest, search.count),
      place_of(search.first())};
}

}  // namespace dobra::surf::remesh
