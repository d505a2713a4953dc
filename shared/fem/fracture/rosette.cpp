#include "shared/fem/fracture/rosette.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace dobra::fem::fracture {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Vector;

base::Result<Rosette> make_rosette(Point tip, Vector ahead, const RosetteOptions& options) {
  const auto wrong = [](const char* message) {
    return Error{ErrorCode::InvalidOption, message, base::Place{.item = "rosette"}};
  };
  if (options.sectors < 6 || options.sectors % 2 != 0)
    return wrong("the number of sectors must be even and at least 6");
  if (!(options.radius > 0.0)) return wrong("the radius must be positive");
  if (options.rings < 1 || !(options.growth > 0.0))
    return wrong("there must be one ring at least, and a positive growth");
  Rosette rosette{tip, {}};
  double radius = 0.0;
  double thickness = options.radius;
  for (int k = 0; k < options.rings; ++k, thickness *= options.growth) {
    radius += thickness;
    std::vector<Point> ring;
    for (int i = 0; i <= options.sectors; ++i) {
      const double angle = std::numbers::pi * (2.0 * i / options.sectors - 1.0);
      const bool on_crack = i == 0 || i == options.sectors;
      const Vector direction = on_crack                   ? -ahead
                               : 2 * i == options.sectors ? ahead
                                                          : std::cos(angle) * ahead + std::sin(angle) * left_of(ahead);
      ring.push_back(tip + radius * direction);
    }
    rosette.rings.push_back(std::move(ring));
  }
  return rosette;
}

namespace {

/// The sides of filled sectors on their first and last spoke, from the tip outwards.
struct Spokes {
  std::vector<mesh::ElementSide> first;
  std::vector<mesh::ElementSide> last;
};

/// Triangles of the sectors `first` .. `last` - 1; all of them close into a ring.
base::Result<Spokes> fill_sectors(mesh::ElementMesh& mesh, const Rosette& rosette, std::size_t first, std::size_t last,
                                  const std::string& crack, std::int32_t region) {
  using mesh::ElementType;
  using mesh::NodeId;
  const std::size_t sectors = rosette.rings.front().size() - 1;
  const bool closed = last - first == sectors;
  std::map<Point, NodeId> known;
  for (std::size_t n = 0; n < mesh.points.size(); ++n) known.try_emplace(mesh.points[n], n);
  std::vector<std::vector<NodeId>> rings{std::vector<NodeId>(sectors + 1, NodeId(mesh.points.size()))};  // the tip
  mesh.points.push_back(rosette.tip);
  for (const auto& points : rosette.rings) {
    const bool outermost = &points == &rosette.rings.back();
    std::vector<NodeId> ring(sectors + 1);
    for (std::size_t i = first; i <= last; ++i) {
      if (closed && i == last) {
        ring[i] = ring[first];
        continue;
      }
      const auto found = known.find(points[i]);
      if (outermost && found == known.end())
        return Error{ErrorCode::BadCrack, "the mesh has no node on the ring of the rosette",
                     base::Place{.item = "crack '" + crack + "'", .x = points[i].x, .y = points[i].y}};
      ring[i] = outermost ? found->second : NodeId(mesh.points.size());
      if (!outermost) mesh.points.push_back(points[i]);
    }
    rings.push_back(std::move(ring));
  }
  Spokes spokes;
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    const auto& in = rings[k];
    const auto& out = rings[k + 1];
    for (std::size_t i = first; i < last; ++i) {
      // The diagonals on the right of the crack's line mirror those on its left: a symmetric problem keeps K_II = 0.
      const bool mirrored = k > 0 && 2 * i < sectors;
      const auto inner =
          add_element(mesh, ElementType::T3, std::vector{in[i], out[i], mirrored ? in[i + 1] : out[i + 1]}, region);
      const auto outer = k == 0 ? inner
                                : add_element(mesh, ElementType::T3,
                                              std::vector{mirrored ? out[i] : in[i], out[i + 1], in[i + 1]}, region);
      if (i == first) spokes.first.push_back({inner, 0});
      if (i + 1 == last) spokes.last.push_back({outer, k == 0 ? 2U : 1U});
    }
  }
  return spokes;
}

}  // namespace

base::Result<void> fill_rosette(mesh::ElementMesh& mesh, const Rosette& rosette, const std::string& crack, CrackEnd end,
                                std::int32_t region) {
  const std::size_t sectors = rosette.rings.front().size() - 1;
  DOBRA_TRY(const Spokes spokes, fill_sectors(mesh, rosette, 0, sectors, crack, region));
  auto& set = mesh.side_sets[crack];
  if (end == CrackEnd::Start) {
    set.insert(set.begin(), spokes.first.begin(), spokes.first.end());
  } else {
    set.insert(set.end(), spokes.last.rbegin(), spokes.last.rend());
  }
  return {};
}

std::vector<Point> rim_of(const Rosette& rosette, RosetteHalf half) {
  const auto& ring = rosette.rings.back();
  const auto middle = ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2);  // straight ahead
  return half == RosetteHalf::Left ? std::vector<Point>(middle, ring.end())
                                   : std::vector<Point>(ring.begin(), middle + 1);
}

base::Result<void> fill_half_rosette(mesh::ElementMesh& mesh, const Rosette& rosette, RosetteHalf half,
                                     const std::string& lip, const std::string& ahead, std::int32_t region) {
  const std::size_t sectors = rosette.rings.front().size() - 1;
  const bool left = half == RosetteHalf::Left;
  DOBRA_TRY(const Spokes spokes,
            fill_sectors(mesh, rosette, left ? sectors / 2 : 0, left ? sectors : sectors / 2, lip, region));
  const auto append = [&](const std::string& name, const std::vector<mesh::ElementSide>& sides) {
    auto& set = mesh.side_sets[name];
    set.insert(set.end(), sides.begin(), sides.end());
  };
  append(left ? ahead : lip, spokes.first);
  append(left ? lip : ahead, spokes.last);
  return {};
}

base::Result<std::size_t> set_quarter_points(mesh::ElementMesh& mesh) {
  std::set<mesh::NodeId> tips;
  for (const mesh::CrackTip& tip : mesh.tips) tips.insert(tip.node);
  std::set<mesh::NodeId> moved;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const mesh::ElementId element(e);
    const std::size_t corners = mesh::corner_count(mesh.types[e]);
    for (std::uint32_t side = 0; side < corners; ++side) {
      const auto [from, to, middle] = side_nodes(mesh, {element, side});
      const bool at_from = tips.contains(from);
      const bool at_to = tips.contains(to);
      if (!at_from && !at_to) continue;
      const Point p = mesh.point(at_from ? from : to);
      if (!middle.valid())
        return Error{ErrorCode::BadCrack, "the elements at a crack tip must be quadratic to take quarter points",
                     base::Place{.x = p.x, .y = p.y}};
      if (at_from && at_to)
        return Error{ErrorCode::BadCrack, "one element side joins two crack tips; make the mesh finer between them",
                     base::Place{.x = p.x, .y = p.y}};
      mesh.points[middle.index()] = geom::interpolate(p, mesh.point(at_from ? to : from), 0.25);
      moved.insert(middle);
    }
  }
  return moved.size();
}

}  // namespace dobra::fem::fracture
