// 1. One tree of triangles for each face; where those of two faces meet otherwise than in common nodes and sides is
//    found by the contacts of shared/solid.
// 2. Each meeting is judged: a crossing, an overlap, or neither.
// 3. Of each pair of faces the first of either counts.
#include "quebra/surfaces/crossing_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// A place that both surfaces cover, if they do at three places of what both triangles cover.
std::optional<geom::Point3> overlap(const Triangle& own, const Triangle& other, double tolerance) {
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
  if (geom::length(twice) <= tolerance * round) return std::nullopt;  // a strip of that width
  const geom::Point3 middle = part[0] + sum / static_cast<double>(part.size());
  for (std::size_t k = 0; k < 3; ++k) {
    const geom::Point3 p = middle + 0.5 * (part[k * part.size() / 3] - middle);
    const geom::Point3 on_own = own.face->surface.at(own.place(own.weights(p)));
    if (closest(other.face->surface, on_own, other.place(other.weights(on_own))).distance > tolerance)
      return std::nullopt;
  }
  return middle;
}

/// Whether the surface over a triangle has places on both sides of the other one's, farther off than the tolerance and
/// over its face.
bool passes(const Triangle& own, const Triangle& other, double tolerance) {
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
      (dot(p - foot.at, *normal) > 0.0 ? above : below) = true;
    }
  }
  return above && below;
}

struct Pairs {
  std::map<std::pair<std::size_t, std::size_t>, geom::Point3> crossing, overlapping;
};

Pairs judged(const model::SurfaceMeshed& meshed, std::span<const surf::trim::TrimmedSurface> charts,
             std::span<const std::size_t> owner, std::size_t face_count) {
  const surf::mesh::SurfaceMesh& mesh = meshed.mesh;
  // All facets are of one operand, so that contacts tells the pairs; each face has a tree.
  solid::Soup soup;
  soup.space.reserve(mesh.points.size(), mesh.triangles.size());
  soup.reserve(mesh.triangles.size(), 3 * mesh.triangles.size(), mesh.triangles.size());
  std::vector<solid::PointId> points;
  points.reserve(mesh.points.size());
  geom::Box3 box;
  for (const geom::Point3& p : mesh.points) {
    points.push_back(soup.space.add(p));
    box.add(p);
  }
  std::vector<std::vector<std::uint32_t>> triangles(face_count);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) triangles[owner[mesh.faces[t]]].push_back(t);
  std::vector<solid::BoxTree> trees;
  for (const auto& list : triangles) {
    const auto first = static_cast<std::uint32_t>(soup.facets.size());
    for (const std::uint32_t t : list) {
      std::array<solid::PointId, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = points[mesh.triangles[t][i].index()];
      if (soup.space.collinear(corners[0], corners[1], corners[2])) continue;
      const auto at = [&](std::size_t i) { return mesh.point(mesh.triangles[t][i]); };
      soup.begin(soup.space.add(solid::Plane{.through = {at(0), at(1), at(2)}, .constant = std::nullopt}), 0, t);
      soup.begin_loop();
      for (const solid::PointId corner : corners) soup.add_corner(corner, {});
    }
    trees.emplace_back(soup, first, static_cast<std::uint32_t>(soup.facets.size()));
  }
  soup.inner.assign(trees.size(), solid::Inner::Trusted);
  const solid::Contacts meetings = solid::contacts(soup, trees);

  const double tolerance = 1e-6 * box.diagonal();
  const auto triangle = [&](std::uint32_t facet) {
    const std::uint32_t t = soup.facets[facet].name;
    Triangle made{.at = {}, .places = mesh.places[t], .face = &charts[mesh.faces[t]]};
    for (std::size_t i = 0; i < 3; ++i) made.at[i] = mesh.point(mesh.triangles[t][i]);
    return made;
  };
  Pairs found;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> looks;
  const auto judge = [&](std::uint32_t f, std::uint32_t g, std::optional<geom::Point3> met) {
    const auto face = [&](std::uint32_t facet) { return owner[mesh.faces[soup.facets[facet].name]]; };
    const std::pair faces = std::minmax({face(f), face(g)});
    if (found.crossing.contains(faces) && found.overlapping.contains(faces)) return;
    const Triangle a = triangle(f), b = triangle(g);
    if (met && !found.crossing.contains(faces)) {
      const double depth = std::min(a.depth(b), b.depth(a));
      constexpr std::size_t most_looks = 300;  // where faces only touch there are many
      const double off = 2.0 * (a.off() + b.off());
      if (depth > tolerance &&
          (depth > off || (looks[faces]++ < most_looks && (passes(a, b, tolerance) || passes(b, a, tolerance)))))
        found.crossing.emplace(faces, *met);
    }
    if (found.overlapping.contains(faces)) return;
    if (const auto place = overlap(a, b, tolerance)) found.overlapping.emplace(faces, *place);
  };
  for (const auto& [f, g] : meetings.coplanar) judge(f, g, std::nullopt);
  for (const solid::Contacts::Inside& pair : meetings.inside) judge(pair.f, pair.g, soup.space.rounded(pair.at));
  return found;
}

}  // namespace

void doubt_crossings(model::SurfaceMeshed& meshed, const model::SurfaceSet& set,
                     std::span<const surf::trim::TrimmedSurface> charts, std::span<const std::size_t> owner) {
  if (set.faces.size() < 2) return;
  const Pairs found = judged(meshed, charts, owner, set.faces.size());
  const auto name = [&](std::size_t face) {
    return set.faces[face].name.empty() ? fmt::format("{}", face + 1) : set.faces[face].name;
  };
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
