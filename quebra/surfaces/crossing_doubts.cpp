// 1. One tree of triangles for each face; where those of two faces meet otherwise than in common nodes and sides is
//    found by the contacts of shared/solid. Each meeting is a crossing, or it is none.
// 2. A second tree, of boxes grown by what triangles are off their surfaces and by the gap up to which surfaces lie on
//    each other, gives the pairs that may overlap.
// 3. Of each pair of faces the first of either counts.
// 4. Within one face the same is done with triangles that have no corner in common and that no plane of either parts.
#include "quebra/surfaces/crossing_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "shared/geom/box3.h"
#include "shared/solid/contacts.h"
#include "shared/surf/closest.h"
#include "shared/surf/measure.h"
#include "shared/surf/trim/open.h"

namespace quebra::surfaces {

using namespace dobra;

namespace {

/// Surfaces nearer than this part of the smaller one's size lie on each other. Files of six digits keep no smaller gap,
/// and no two shells stand so near: they would be thinner than a hundred thousandth of their size.
constexpr double same_place = 1e-5;
/// Surfaces whose curvatures differ by more than this, over the smaller one's size, touch along a line or in a point:
/// they are within that gap in a strip of less than a thirtieth of the size.
constexpr double same_bend = 0.1;

using Weights = std::array<double, 3>;

struct Triangle {
  std::array<geom::Point3, 3> at;
  std::array<geom::Point, 3> places;
  const surf::trim::TrimmedSurface* face = nullptr;

  [[nodiscard]] geom::Vector3 normal() const {
    const geom::Vector3 n = cross(at[1] - at[0], at[2] - at[0]);
    return n / geom::length(n);
  }
  [[nodiscard]] geom::Point3 point(const Weights& w) const {
    return at[0] + w[1] * (at[1] - at[0]) + w[2] * (at[2] - at[0]);
  }
  [[nodiscard]] geom::Point place(const Weights& w) const {
    return places[0] + w[1] * (places[1] - places[0]) + w[2] * (places[2] - places[0]);
  }
  /// Of the point of its plane that is nearest.
  [[nodiscard]] Weights weights(geom::Point3 p) const {
    const geom::Vector3 n = cross(at[1] - at[0], at[2] - at[0]);
    const double b = dot(cross(p - at[0], at[2] - at[0]), n) / dot(n, n);
    const double c = dot(cross(at[1] - at[0], p - at[0]), n) / dot(n, n);
    return {1.0 - b - c, b, c};
  }
  /// How far its surface is off it, of the middle and those of the sides the greatest, m.
  [[nodiscard]] double off() const {
    constexpr double third = 1.0 / 3.0;
    double most = 0.0;
    for (const Weights& w : {Weights{third, third, third}, {0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}})
      most = std::max(most, std::abs(dot(face->surface.at(place(w)) - point(w), normal())));
    return most;
  }
  [[nodiscard]] double longest_side() const {
    return std::max({distance(at[0], at[1]), distance(at[1], at[2]), distance(at[2], at[0])});
  }
  /// How far it reaches to the side of `other`'s plane where it reaches less, m.
  [[nodiscard]] double depth(const Triangle& other) const {
    const geom::Vector3 n = other.normal();
    double above = 0.0, below = 0.0;
    for (const geom::Point3& p : at) {
      const double height = dot(p - other.at[0], n);
      above = std::max(above, height);
      below = std::max(below, -height);
    }
    return std::min(above, below);
  }
};

/// What of `other`, seen along the normal of `own`, lies over it: corners anticlockwise in its plane.
std::vector<geom::Point3> common_part(const Triangle& own, const Triangle& other) {
  const geom::Vector3 n = own.normal();
  std::vector<geom::Point3> part;
  for (const geom::Point3& p : other.at) part.push_back(p - dot(p - own.at[0], n) * n);
  if (dot(other.normal(), n) < 0.0) std::reverse(part.begin(), part.end());
  for (std::size_t i = 0; i < 3 && !part.empty(); ++i) {
    const geom::Point3 a = own.at[i];
    const geom::Vector3 inwards = cross(n, own.at[(i + 1) % 3] - a);
    std::vector<geom::Point3> kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const geom::Point3 p = part[k], q = part[(k + 1) % part.size()];
      const double side_p = dot(p - a, inwards), side_q = dot(q - a, inwards);
      if (side_p >= 0.0) kept.push_back(p);
      if ((side_p > 0.0 && side_q < 0.0) || (side_p < 0.0 && side_q > 0.0))
        kept.push_back(p + side_p / (side_p - side_q) * (q - p));
    }
    part = std::move(kept);
  }
  return part;
}

/// What a surface bends along the first, the second and both of two unit steps, 1/m, to the side of `side`.
std::optional<std::array<double, 3>> bends(const surf::Jet& jet, geom::Vector3 first, geom::Vector3 second,
                                           geom::Vector3 side) {
  const auto normal = surf::normal(jet);
  if (!normal) return std::nullopt;
  const surf::Metric m = surf::metric(jet);
  const double square = m.e * m.g - m.f * m.f;
  const auto in_chart = [&](geom::Vector3 step) {
    const double u = dot(step, jet.u), v = dot(step, jet.v);
    return geom::Vector{(m.g * u - m.f * v) / square, (m.e * v - m.f * u) / square};
  };
  const geom::Vector a = in_chart(first), b = in_chart(second);
  const double way = dot(*normal, side) < 0.0 ? -1.0 : 1.0;
  const auto form = [&](geom::Vector p, geom::Vector q) {
    return way * dot(*normal, p.x * q.x * jet.uu + (p.x * q.y + p.y * q.x) * jet.uv + p.y * q.y * jet.vv);
  };
  return std::array{form(a, a), form(b, b), form(a, b)};
}

/// By how much the curvatures of both surfaces differ there, 1/m; 0 where one has none.
double differing_bend(const surf::Jet& own, const surf::Jet& other) {
  const auto side = surf::normal(own);
  if (!side) return 0.0;
  const geom::Vector3 first = own.u / geom::length(own.u), second = cross(*side, first);
  const auto a = bends(own, first, second, *side), b = bends(other, first, second, *side);
  if (!a || !b) return 0.0;
  return std::hypot((*a)[0] - (*b)[0], (*a)[1] - (*b)[1], std::sqrt(2.0) * ((*a)[2] - (*b)[2]));
}

struct Nearness {
  double strip = 0.0;  ///< What is covered in a width up to this counts for nothing, m.
  double gap = 0.0;    ///< Up to which surfaces lie on each other, m.
  double size = 0.0;   ///< Of the smaller one, m.
  double room = 0.0;   ///< How far apart the planes of the triangles can be where the surfaces lie so, m.
};

/// A place that both surfaces cover, if they do at three places of what both triangles cover.
std::optional<geom::Point3> overlap(const Triangle& own, const Triangle& other, const Nearness& near) {
  const std::vector<geom::Point3> part = common_part(own, other);
  if (part.size() < 3) return std::nullopt;
  geom::Vector3 sum{}, twice{};
  double round = 0.0;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const geom::Point3 p = part[k], q = part[(k + 1) % part.size()];
    sum = sum + (p - part[0]);
    twice = twice + cross(p - part[0], q - part[0]);
    round += geom::length(q - p);
  }
  if (geom::length(twice) <= near.strip * round) return std::nullopt;
  const geom::Point3 middle = part[0] + sum / static_cast<double>(part.size());
  if (std::abs(dot(middle - other.at[0], other.normal())) > near.room) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    const geom::Point3 p = middle + 0.5 * (part[k * part.size() / 3] - middle);
    const geom::Point place = own.place(own.weights(p));
    const surf::Jet on_own = own.face->surface.jet(place);
    const surf::Foot foot = closest(other.face->surface, on_own.at, other.place(other.weights(on_own.at)));
    if (foot.distance > near.gap) return std::nullopt;
    if (differing_bend(on_own, other.face->surface.jet(foot.uv)) * near.size > same_bend) return std::nullopt;
  }
  return middle;
}

/// Whether a place of the chart is over a triangle or next to it: elsewhere on its own surface a foot says nothing.
bool is_beside(geom::Point uv, const Triangle& triangle) {
  constexpr double beside = 0.5;
  const geom::Box box = geom::box_of(triangle.places);
  const double u = beside * box.width(), v = beside * box.height();
  return uv.x >= box.low.x - u && uv.x <= box.high.x + u && uv.y >= box.low.y - v && uv.y <= box.high.y + v;
}

/// The sine of the angle at which the surfaces stand to each other there; 1 where one has no normal.
double tilt(const Triangle& own, const Triangle& other, geom::Point3 place) {
  const auto normal = [&](const Triangle& t) { return surf::normal(t.face->surface, t.place(t.weights(place))); };
  const auto a = normal(own), b = normal(other);
  return a && b ? geom::length(cross(*a, *b)) : 1.0;
}

/// Whether the surface over a triangle has places on both sides of the other one's, farther off than the tolerance and
/// over its face; over the other triangle, where both are of one face.
bool passes(const Triangle& own, const Triangle& other, double tolerance, bool of_one_face = false) {
  constexpr int parts = 6;
  bool above = false, below = false;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j) {
      const double b = i / double{parts}, c = j / double{parts};
      const geom::Point3 p = own.face->surface.at(own.place({1.0 - b - c, b, c}));
      const surf::Foot foot = closest(other.face->surface, p, other.place(other.weights(p)));
      if (foot.distance <= tolerance) continue;
      const auto normal = surf::normal(other.face->surface, foot.uv);
      if (!normal || !contains(*other.face, foot.uv)) continue;
      const double height = dot(p - foot.at, *normal);
      const double upright = of_one_face ? 0.99 : 0.9;
      if (std::abs(height) < upright * foot.distance) continue;  // no perpendicular: it lies beside the face
      if (of_one_face && !is_beside(foot.uv, other)) continue;
      (height > 0.0 ? above : below) = true;
    }
  }
  return above && below;
}

struct Pairs {
  std::map<std::pair<std::size_t, std::size_t>, geom::Point3> crossing, overlapping;
};

/// The triangles of a mesh as facets of one operand, so that contacts tells the pairs.
class Facets {
 public:
  explicit Facets(const surf::mesh::SurfaceMesh& mesh) : mesh_(mesh) {
    soup_.space.reserve(mesh.points.size(), mesh.triangles.size());
    soup_.reserve(mesh.triangles.size(), 3 * mesh.triangles.size(), mesh.triangles.size());
    points_.reserve(mesh.points.size());
    for (const geom::Point3& p : mesh.points) points_.push_back(soup_.space.add(p));
  }

  /// A tree of some triangles; those without area are left out.
  void add_tree(std::span<const std::uint32_t> triangles) {
    firsts_.push_back(size());
    for (const std::uint32_t t : triangles) {
      std::array<solid::PointId, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = point(t, i);
      if (soup_.space.collinear(corners[0], corners[1], corners[2])) continue;
      const auto at = [&](std::size_t i) { return mesh_.point(mesh_.triangles[t][i]); };
      soup_.begin(soup_.space.add(solid::Plane{.through = {at(0), at(1), at(2)}, .constant = std::nullopt}), 0, t);
      soup_.begin_loop();
      for (const solid::PointId corner : corners) soup_.add_corner(corner, {});
    }
    trees_.emplace_back(soup_, firsts_.back(), size());
  }
  [[nodiscard]] const std::vector<solid::BoxTree>& trees() const { return trees_; }
  /// The trees once more, each facet's box grown by its room.
  [[nodiscard]] std::vector<solid::BoxTree> grown_trees(std::span<const double> room) const {
    std::vector<solid::BoxTree> grown;
    for (std::size_t i = 0; i < firsts_.size(); ++i) {
      const std::uint32_t end = i + 1 < firsts_.size() ? firsts_[i + 1] : size();
      grown.emplace_back(soup_, firsts_[i], end, room.subspan(firsts_[i]));
    }
    return grown;
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(soup_.facets.size()); }
  [[nodiscard]] std::uint32_t triangle(std::uint32_t facet) const { return soup_.facets[facet].name; }
  [[nodiscard]] geom::Point3 rounded(solid::PointId p) const { return soup_.space.rounded(p); }
  /// Both lips of a crack have one.
  [[nodiscard]] bool have_common_corner(std::uint32_t t, std::uint32_t other) const {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (point(t, i) == point(other, k)) return true;
      }
    }
    return false;
  }
  /// @param inner  whether pairs within a tree are looked for, or those of two
  solid::Contacts contacts(solid::Inner inner) {
    soup_.inner.assign(trees_.size(), inner);
    return solid::contacts(soup_, trees_);
  }

 private:
  [[nodiscard]] solid::PointId point(std::uint32_t t, std::size_t corner) const {
    return points_[mesh_.triangles[t][corner].index()];
  }

  const surf::mesh::SurfaceMesh& mesh_;
  solid::Soup soup_;
  std::vector<solid::PointId> points_;
  std::vector<std::uint32_t> firsts_;  // the first facet of each tree
  std::vector<solid::BoxTree> trees_;
};

double tolerance_of(const surf::mesh::SurfaceMesh& mesh) {
  geom::Box3 box;
  for (const geom::Point3& p : mesh.points) box.add(p);
  return 1e-6 * box.diagonal();
}

Triangle triangle_of(const surf::mesh::SurfaceMesh& mesh, std::span<const surf::trim::TrimmedSurface> charts,
                     std::uint32_t t) {
  Triangle made{.at = {}, .places = mesh.places[t], .face = &charts[mesh.faces[t]]};
  for (std::size_t i = 0; i < 3; ++i) made.at[i] = mesh.point(mesh.triangles[t][i]);
  return made;
}

/// Whether the plane of a triangle, or one through a side of it upright on it, has all of the other one beyond it, for
/// sure.
bool lies_apart(const Triangle& own, const Triangle& other) {
  constexpr double rounding = 1e-12;
  const geom::Vector3 normal = cross(own.at[1] - own.at[0], own.at[2] - own.at[0]);
  const auto beyond = [&](geom::Vector3 out, geom::Point3 from) {
    double least = std::numeric_limits<double>::infinity(), size = 0.0;
    for (const geom::Point3& p : other.at) {
      least = std::min(least, dot(out, p - from));
      size = std::max(size, geom::length(p - from));
    }
    return least > rounding * size * geom::length(out);
  };
  if (beyond(normal, own.at[0]) || beyond(-normal, own.at[0])) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (beyond(cross(own.at[(i + 1) % 3] - own.at[i], normal), own.at[i])) return true;
  }
  return false;
}

/// Of each face whose surface cuts through itself a place where it does.
std::map<std::size_t, geom::Point3> crossing_themselves(const surf::mesh::SurfaceMesh& mesh,
                                                        std::span<const surf::trim::TrimmedSurface> charts,
                                                        const Facets& all) {
  const double tolerance = tolerance_of(mesh);
  std::map<std::size_t, geom::Point3> found;
  for (std::size_t face = 0; face < all.trees().size(); ++face) {
    std::vector<std::uint32_t> near;
    all.trees()[face].inner_pairs([&](std::uint32_t f, std::uint32_t g) {
      const std::uint32_t t = all.triangle(f), s = all.triangle(g);
      if (all.have_common_corner(t, s)) return;
      const Triangle a = triangle_of(mesh, charts, t), b = triangle_of(mesh, charts, s);
      if (lies_apart(a, b) || lies_apart(b, a)) return;
      near.push_back(t);
      near.push_back(s);
    });
    if (near.empty()) continue;
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    Facets own(mesh);
    own.add_tree(near);
    std::size_t looks = 0;
    for (const solid::Contacts::Inside& pair : own.contacts(solid::Inner::Searched).inside) {
      const std::uint32_t t = own.triangle(pair.f), s = own.triangle(pair.g);
      if (own.have_common_corner(t, s)) continue;
      const Triangle a = triangle_of(mesh, charts, t), b = triangle_of(mesh, charts, s);
      if (std::min(a.depth(b), b.depth(a)) <= tolerance) continue;
      constexpr std::size_t most_looks = 300;
      if (looks++ == most_looks) break;
      if (!passes(a, b, tolerance, true) && !passes(b, a, tolerance, true)) continue;
      found.emplace(face, own.rounded(pair.at));
      break;
    }
  }
  return found;
}

Pairs judged(const model::SurfaceMeshed& meshed, std::span<const surf::trim::TrimmedSurface> charts,
             std::span<const std::size_t> owner, Facets& all) {
  const surf::mesh::SurfaceMesh& mesh = meshed.mesh;
  const double tolerance = tolerance_of(mesh);
  const auto triangle = [&](std::uint32_t facet) { return triangle_of(mesh, charts, all.triangle(facet)); };
  const auto face = [&](std::uint32_t facet) { return owner[mesh.faces[all.triangle(facet)]]; };
  Pairs found;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> looks;
  for (const auto& [f, g, at] : all.contacts(solid::Inner::Trusted).inside) {
    const std::pair faces = std::minmax({face(f), face(g)});
    if (found.crossing.contains(faces)) continue;
    const Triangle a = triangle(f), b = triangle(g);
    const double depth = std::min(a.depth(b), b.depth(a));
    constexpr std::size_t most_looks = 300;  // where faces only touch there are many
    const double off = 2.0 * (a.off() + b.off());
    if (depth <= tolerance) continue;
    const geom::Point3 place = all.rounded(at);
    const bool clear = depth > off && tilt(a, b, place) * std::min(a.longest_side(), b.longest_side()) > off;
    if (clear || (looks[faces]++ < most_looks && (passes(a, b, tolerance) || passes(b, a, tolerance))))
      found.crossing.emplace(faces, place);
  }

  std::vector<geom::Box3> boxes(all.trees().size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const auto corner : mesh.triangles[t]) boxes[owner[mesh.faces[t]]].add(mesh.point(corner));
  }
  const auto size_of = [&](std::size_t i) { return boxes[i].diagonal(); };
  std::vector<double> room;  // of each facet, m
  for (std::uint32_t f = 0; f < all.size(); ++f)
    room.push_back(2.0 * triangle(f).off() + 0.5 * same_place * size_of(face(f)));
  const std::vector<solid::BoxTree> grown = all.grown_trees(room);
  for (std::size_t i = 0; i < grown.size(); ++i) {
    for (std::size_t j = i + 1; j < grown.size(); ++j) {
      const double size = std::min(size_of(i), size_of(j));
      grown[i].pairs(grown[j], [&](std::uint32_t f, std::uint32_t g) {
        if (found.overlapping.contains({i, j})) return;
        const Nearness near{
            .strip = tolerance, .gap = same_place * size, .size = size, .room = 2.0 * (room[f] + room[g])};
        if (const auto place = overlap(triangle(f), triangle(g), near))
          found.overlapping.emplace(std::pair(i, j), *place);
      });
    }
  }
  return found;
}

}  // namespace

void doubt_crossings(model::SurfaceMeshed& meshed, const model::SurfaceSet& set,
                     std::span<const surf::trim::TrimmedSurface> charts, std::span<const std::size_t> owner) {
  const surf::mesh::SurfaceMesh& mesh = meshed.mesh;
  std::vector<std::vector<std::uint32_t>> triangles(set.faces.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) triangles[owner[mesh.faces[t]]].push_back(t);
  Facets all(mesh);
  for (const auto& list : triangles) all.add_tree(list);
  const auto name = [&](std::size_t face) {
    return set.faces[face].name.empty() ? fmt::format("{}", face + 1) : set.faces[face].name;
  };
  const std::map<std::size_t, geom::Point3> themselves = crossing_themselves(mesh, charts, all);
  if (!themselves.empty()) {
    const auto& [face, at] = *themselves.begin();
    meshed.findings.push_back(
        {"surfaces_cross",
         fmt::format("surfaces that cut through themselves: {}; the first is '{}', here: trim away "
                     "what goes through",
                     themselves.size(), name(face)),
         {.x = at.x, .y = at.y, .z = at.z}});
  }
  if (set.faces.size() < 2) return;
  const Pairs found = judged(meshed, charts, owner, all);
  const auto tell = [&](const auto& pairs, const char* code, auto&& message) {
    if (pairs.empty()) return;
    const auto& [faces, at] = *pairs.begin();
    meshed.findings.push_back(
        {code, message(pairs.size(), name(faces.first), name(faces.second)), {.x = at.x, .y = at.y, .z = at.z}});
  };
  tell(found.crossing, "surfaces_cross", [](std::size_t count, const std::string& a, const std::string& b) {
    return fmt::format(
        "pairs of surfaces that cut through each other without a common line: {}; the first is '{}' and '{}', here: "
        "give each a trim of role \"internal\" where the other one cuts it",
        count, a, b);
  });
  tell(found.overlapping, "surfaces_overlap", [](std::size_t count, const std::string& a, const std::string& b) {
    return fmt::format(
        "pairs of surfaces that cover each other: {}; the first is '{}' and '{}', here: both have triangles there",
        count, a, b);
  });
}

}  // namespace quebra::surfaces
