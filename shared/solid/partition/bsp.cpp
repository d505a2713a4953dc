#include "shared/solid/partition/bsp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/solid/mesh_solid.h"
#include "shared/solid/partition/convex_cell.h"
#include "shared/solid/triangulate.h"

namespace dobra::solid::partition {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Sign;
using Polygons = std::vector<ConvexPolygon>;

/// The plane in which one coordinate has a value; above is where it is greater.
Plane across(std::size_t axis, double value) {
  return {{Point3{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}, {}, {}}, -value};
}

PlaneId taken_over(Space& space, const Space& from, PlaneId plane) { return space.add(from.plane(plane)); }

/// All faces as triangles of another space.
Result<Polygons> triangles_of(const Solid& solid, Space& space) {
  const Soup& soup = solid.boundary().soup;
  Polygons polygons;
  for (std::uint32_t f = 0; f < soup.facets.size(); ++f) {
    const Facet& facet = soup.facets[f];
    const PlaneId plane = taken_over(space, soup.space, facet.plane);
    const auto add = [&](std::span<const PointId> corners) {
      ConvexPolygon& polygon = polygons.emplace_back(ConvexPolygon{plane, {}});
      for (const PointId p : corners) polygon.corners.push_back(space.add(soup.space, p));
    };
    const auto corners = soup.corners_of(facet);
    if (corners.size() == 3) {
      add(corners);
      continue;
    }
    const Projection onto = soup.space.projection(facet.plane);
    const auto triangles = triangulate(soup.space, onto, sorted_loops(soup, facet, onto));
    if (!triangles) {
      const Point3 at = soup.space.rounded(corners[0]);
      return Error{ErrorCode::CannotMesh, fmt::format("face {} of the solid cannot be cut into triangles", f),
                   base::Place{.x = at.x, .y = at.y, .z = at.z}};
    }
    for (const auto& t : *triangles) add(t);
  }
  return polygons;
}

/// The box with a margin on all sides, so that no face lies in its border.
Box<3> widened(const Box3& box) {
  Box<3> wide;
  double margin = 0.0;
  for (std::size_t k = 0; k < 3; ++k) margin = std::max(margin, 0.125 * (box.high[k] - box.low[k]));
  for (std::size_t k = 0; k < 3; ++k) {
    wide.low[k] = std::nextafter(box.low[k] - margin, -INFINITY);
    wide.high[k] = std::nextafter(box.high[k] + margin, INFINITY);
  }
  return wide;
}

}  // namespace

struct Bsp::Builder {
  Space& space;
  std::vector<Node>& nodes;
  const PointLocator& locator;
  const BspOptions& options;

  /// A cell that is a box as long as no face's plane has cut it.
  Ref halve(Polygons polygons, const Box<3>& box, int left) {
    if (polygons.empty()) {
      const Point3 p{0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]),
                     0.5 * (box.low[2] + box.high[2])};
      return locator.locate(p) == Location::Inside ? inside : outside;
    }
    if (left == 0 || polygons.size() <= static_cast<std::size_t>(options.few)) return divide(std::move(polygons));
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
    }
    const double value = median(polygons, axis);
    if (!(value > box.low[axis] && value < box.high[axis])) return divide(std::move(polygons));
    const PlaneId plane = space.add(across(axis, value));
    auto [above, below] = parted(polygons, plane);
    // A plane that parts little from the rest would go on for ever.
    if (above.size() + below.size() > 2 * polygons.size() || std::max(above.size(), below.size()) >= polygons.size())
      return divide(std::move(polygons));
    polygons.clear();
    Box<3> upper = box;
    Box<3> lower = box;
    upper.low[axis] = lower.high[axis] = value;
    const Ref up = halve(std::move(above), upper, left - 1);
    const Ref down = halve(std::move(below), lower, left - 1);
    return join(plane, up, down);
  }

  /// By the planes of the faces: what is above a face and meets no other is outside, what is below is inside.
  Ref divide(Polygons polygons) {
    const PlaneId plane = polygons[best_of(polygons)].plane;
    auto [above, below] = parted(polygons, plane);
    polygons.clear();
    const Ref up = above.empty() ? outside : divide(std::move(above));
    const Ref down = below.empty() ? inside : divide(std::move(below));
    return join(plane, up, down);
  }

  Ref join(PlaneId plane, Ref up, Ref down) {
    if (up == down && up < 0) return up;
    nodes.push_back({plane, up, down});
    return static_cast<Ref>(nodes.size() - 1);
  }

 private:
  /// Of all corners, so that it passes through a corner in which many polygons meet.
  [[nodiscard]] double median(const Polygons& polygons, std::size_t axis) const {
    std::vector<double> values;
    for (const ConvexPolygon& polygon : polygons) {
      for (const PointId p : polygon.corners) values.push_back(space.coordinate(p, static_cast<int>(axis)));
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  std::pair<Polygons, Polygons> parted(const Polygons& polygons, PlaneId plane) {
    std::pair<Polygons, Polygons> parts;
    for (const ConvexPolygon& polygon : polygons) {
      if (polygon.plane == plane) continue;
      CutPolygon both = cut(space, polygon.corners, plane);
      if (!both.above.empty()) parts.first.push_back({polygon.plane, std::move(both.above)});
      if (!both.below.empty()) parts.second.push_back({polygon.plane, std::move(both.below)});
    }
    return parts;
  }

  /// Of a few polygons the one whose plane cuts the fewest others, and of these parts them best.
  [[nodiscard]] std::size_t best_of(const Polygons& polygons) const {
    std::size_t best = 0;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    const std::size_t tried = std::min<std::size_t>(polygons.size(), static_cast<std::size_t>(options.tried));
    for (std::size_t i = 0; i < tried; ++i) {
      const std::size_t candidate = i * polygons.size() / tried;
      std::size_t crossed = 0;
      std::size_t above = 0;
      std::size_t below = 0;
      for (const ConvexPolygon& other : polygons) {
        bool up = false;
        bool down = false;
        for (const PointId p : other.corners) {
          const Sign side = space.side(polygons[candidate].plane, p);
          up = up || side == Sign::Positive;
          down = down || side == Sign::Negative;
        }
        crossed += up && down ? 1 : 0;
        above += up ? 1 : 0;
        below += down ? 1 : 0;
      }
      const std::size_t cost = 4 * crossed + std::max(above, below);
      if (cost >= least) continue;
      least = cost;
      best = candidate;
    }
    return best;
  }
};

struct Bsp::Merger {
  Space& space;
  std::vector<Node>& nodes;
  const Bsp& a;
  const Bsp& b;
  SetOperation operation;

  Ref merge(Ref at, const ConvexCell& cell) {
    if (at >= 0) return with_halves(a, at, cell, [&](Ref part, const ConvexCell& half) { return merge(part, half); });
    const bool full = at == inside;
    if (operation == SetOperation::Union) return full ? inside : insert(b.root_, cell, false);
    return full ? insert(b.root_, cell, operation == SetOperation::Difference) : outside;
  }

 private:
  Ref insert(Ref at, const ConvexCell& cell, bool turned) {
    if (at < 0) return (at == inside) != turned ? inside : outside;
    return with_halves(b, at, cell, [&](Ref part, const ConvexCell& half) { return insert(part, half, turned); });
  }

  template <class Next>
  Ref with_halves(const Bsp& tree, Ref at, const ConvexCell& cell, Next&& next) {
    const Node& node = tree.nodes_[static_cast<std::size_t>(at)];
    const PlaneId plane = taken_over(space, *tree.space_, node.plane);
    const auto [above, below] = cell.halves(space, plane);
    if (above.empty()) return next(node.below, below);
    if (below.empty()) return next(node.above, above);
    const Ref up = next(node.above, above);
    const Ref down = next(node.below, below);
    if (up == down && up < 0) return up;
    nodes.push_back({plane, up, down});
    return static_cast<Ref>(nodes.size() - 1);
  }
};

Result<Bsp> Bsp::of(const Solid& solid, const BspOptions& options) {
  Bsp tree;
  const auto space = std::make_shared<Space>();
  tree.space_ = space;
  if (solid.empty()) return tree;
  Box3 box;
  for (const PointId p : solid.boundary().soup.corners) box.include(solid.space(), p);
  tree.box_ = widened(box);
  DOBRA_TRY(auto polygons, triangles_of(solid, *space));
  const PointLocator locator(solid);
  Builder builder{*space, tree.nodes_, locator, options};
  tree.root_ = builder.halve(std::move(polygons), tree.box_, options.halvings);
  return tree;
}

Location Bsp::locate(Point3 p) const { return locate(root_, p); }

Location Bsp::locate(Ref at, Point3 p) const {
  while (at >= 0) {
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    const Sign side = space_->side(node.plane, p);
    if (side == Sign::Zero) {
      const Location above = locate(node.above, p);
      const Location below = locate(node.below, p);
      return above == below ? above : Location::Boundary;
    }
    at = side == Sign::Positive ? node.above : node.below;
  }
  return at == inside ? Location::Inside : Location::Outside;
}

double Bsp::inner_volume() const {
  if (root_ == outside) return 0.0;
  Space space;
  double sum = 0.0;
  std::vector<std::pair<Ref, ConvexCell>> open;
  open.emplace_back(root_, ConvexCell(space, box_));
  while (!open.empty()) {
    auto [at, cell] = std::move(open.back());
    open.pop_back();
    if (cell.empty() || at == outside) continue;
    if (at == inside) {
      sum += cell.volume(space);
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    auto [above, below] = cell.halves(space, taken_over(space, *space_, node.plane));
    open.emplace_back(node.above, std::move(above));
    open.emplace_back(node.below, std::move(below));
  }
  return sum;
}

std::size_t Bsp::depth() const {
  std::size_t most = 0;
  std::vector<std::pair<Ref, std::size_t>> open{{root_, 0}};
  while (!open.empty()) {
    const auto [at, level] = open.back();
    open.pop_back();
    most = std::max(most, level);
    if (at < 0) continue;
    open.emplace_back(nodes_[static_cast<std::size_t>(at)].above, level + 1);
    open.emplace_back(nodes_[static_cast<std::size_t>(at)].below, level + 1);
  }
  return most;
}

Bsp combine(const Bsp& a, const Bsp& b, SetOperation operation) {
  Bsp tree;
  const auto space = std::make_shared<Space>();
  tree.space_ = space;
  tree.box_ = a.root_ == Bsp::outside ? b.box_ : a.box_;
  for (std::size_t k = 0; k < 3 && a.root_ != Bsp::outside && b.root_ != Bsp::outside; ++k) {
    tree.box_.low[k] = std::min(a.box_.low[k], b.box_.low[k]);
    tree.box_.high[k] = std::max(a.box_.high[k], b.box_.high[k]);
  }
  if (a.root_ == Bsp::outside && b.root_ == Bsp::outside) return tree;
  Bsp::Merger merger{*space, tree.nodes_, a, b, operation};
  tree.root_ = merger.merge(a.root_, ConvexCell(*space, tree.box_));
  return tree;
}

}  // namespace dobra::solid::partition
