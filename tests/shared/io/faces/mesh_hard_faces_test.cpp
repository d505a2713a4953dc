// From a file to a mesh: seeded faces are imported, opened at their poles, divided, meshed and joined.
// DOBRA_HARD_MESHES is how many, DOBRA_HARD_FIRST the first seed; DOBRA_HARD_PRINT=1 prints a line for each.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>

#include "shared/io/faces/import.h"
#include "tests/support/hard_faces.h"
#include "tests/support/meshed_faces.h"

namespace dobra::io::faces {
namespace {

std::uint32_t asked(const char* name, std::uint32_t otherwise) {
  const char* said = std::getenv(name);
  return said != nullptr ? static_cast<std::uint32_t>(std::strtoul(said, nullptr, 10)) : otherwise;
}

/// The greatest alpha, 4 sqrt(3) area / (sum of squares of the sides), of a triangle with an angle: both of its sides
/// are one length.
double best_alpha_at(double corner) {
  if (corner >= std::numbers::pi / 3.0) return 1.0;
  return std::numbers::sqrt3 * std::sin(corner) / (2.0 - std::cos(corner));
}

/// The least angle in space between edges that follow each other round the face, seen from inside.
double least_corner(const surf::trim::TrimmedSurface& face) {
  double least = std::numbers::pi;
  for (const surf::trim::ChartLoop& loop : face.loops) {
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
      const surf::trim::ChartEdge &a = loop.edges[i], &b = loop.edges[(i + 1) % loop.edges.size()];
      const geom::Point3 at = face.surface.at(b.start());
      const geom::Point3 before = face.surface.at(a.at(std::lerp(a.to, a.from, 1e-3)));
      const geom::Point3 after = face.surface.at(b.at(std::lerp(b.from, b.to, 1e-3)));
      const geom::Vector3 p = before - at, q = after - at;
      const double size = geom::length(p) * geom::length(q);
      if (size > 0.0) least = std::min(least, std::acos(std::clamp(dot(p, q) / size, -1.0, 1.0)));
    }
  }
  return least;
}

/// Whether each finding says where: a face or an edge, a line of the file or a point.
bool all_have_places(const std::vector<surf::mesh::Finding>& findings) {
  return std::all_of(findings.begin(), findings.end(), [](const surf::mesh::Finding& finding) {
    const base::Place& place = finding.place;
    return !finding.code.empty() && !finding.message.empty() && (!place.item.empty() || place.x || place.line > 0);
  });
}

/// Closed curves of the outline: components of its edges.
int circles_of(const support::HardFace& hard) {
  std::map<std::size_t, std::size_t> parent;
  const auto root = [&](std::size_t v) {
    while (parent.try_emplace(v, v).first->second != v) v = parent[v];
    return v;
  };
  for (const support::HardEdge& edge : hard.outline) {
    const std::size_t from = root(edge.a), to = root(edge.b);
    parent[from] = to;
  }
  std::set<std::size_t> roots;
  for (const support::HardEdge& edge : hard.outline) roots.insert(root(edge.a));
  return static_cast<int>(roots.size());
}

/// A face that is left out is named with its line and its number, by a code that begins with face_.
void expect_named(const Imported& made, const std::string& name) {
  ASSERT_EQ(made.refused, 1U) << name;
  const auto is_reason = [](const surf::mesh::Finding& finding) { return finding.code.rfind("face_", 0) == 0; };
  const auto reason = std::find_if(made.findings.begin(), made.findings.end(), is_reason);
  ASSERT_NE(reason, made.findings.end()) << name;
  EXPECT_EQ(reason->place.item, "face 1") << name;
  EXPECT_GT(reason->place.line, 0U) << name;
}

/// Of the box round the edges of a face.
double diagonal_of_edges(const surf::trim::TrimmedSurface& face) {
  geom::Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const surf::trim::ChartLoop& loop : face.loops) {
    for (const surf::trim::ChartEdge& edge : loop.edges) {
      for (int i = 0; i <= 16; ++i) {
        const geom::Point3 p = face.surface.at(edge.at(std::lerp(edge.from, edge.to, i / 16.0)));
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
  }
  return geom::distance(low, high);
}

/// A refusal says a place in space and, where it says one of the chart, that it belongs to.
void expect_place_on_face(const base::Error& refused, const surf::trim::TrimmedSurface& face, const std::string& name) {
  EXPECT_FALSE(refused.message.empty()) << name;
  ASSERT_TRUE(refused.place) << name << ": " << base::to_string(refused);
  const base::Place& place = *refused.place;
  ASSERT_TRUE(place.x && place.y && place.z) << name << ": " << base::to_string(refused);
  if (!place.u || !place.v) return;
  const geom::Point3 at{*place.x, *place.y, *place.z};
  EXPECT_NEAR(geom::distance(at, face.surface.at({*place.u, *place.v})), 0.0, 1e-6 * face.surface.size())
      << name << ": " << base::to_string(refused);
}

#ifdef __SANITIZE_ADDRESS__
constexpr double longest_seconds = 100.0;
#else
constexpr double longest_seconds = 10.0;
#endif

struct Tally {
  std::size_t sound = 0, refused = 0;
};

void mesh_one(std::uint32_t seed, double part, Tally& tally) {
  const support::HardFace hard = support::hard_face(seed);
  const std::string name = fmt::format("seed {} ({}) at 1/{}", seed, hard.kind, std::lround(1.0 / part));
  const auto model = brep::parse_brep(hard.text, "hard.brep");
  ASSERT_TRUE(model.ok()) << name;
  const auto begin = std::chrono::steady_clock::now();
  const auto imported = faces_of_model(*model);
  ASSERT_TRUE(imported.ok()) << name;
  EXPECT_TRUE(all_have_places(imported->findings)) << name;
  if (!hard.sound) {
    EXPECT_FALSE(imported->findings.empty()) << name << ": " << hard.wrong;
  } else {
    ++tally.sound;
  }
  if (imported->faces.empty()) {
    expect_named(*imported, name);
    if (hard.sound) ++tally.refused;
    return;
  }
  const surf::trim::TrimmedSurface& face = imported->faces[0];
  const support::MeshedFaces made = support::mesh_faces(imported->faces, part * diagonal_of_edges(face));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // A corner's triangle has sides of two edges, whose lengths are not quite the same.
  const double bound = std::min(0.1, 0.98 * best_alpha_at(least_corner(face)));
  if (asked("DOBRA_HARD_PRINT", 0) != 0)
    fmt::print("{}: {} triangles {} alpha {:.3f} .. {:.3f} (bound {:.3f}) area {:.3e} turned {:.1f} in {:.2f} s\n",
               name, made.refused ? base::to_string(*made.refused) : "meshed", made.quality.triangles,
               made.quality.alpha_min, made.quality.alpha_mean, bound, made.quality.area / hard.area - 1.0, made.turned,
               seconds);
  EXPECT_LT(seconds, longest_seconds) << name;
  if (made.refused) {
    expect_place_on_face(*made.refused, face, name);
    if (hard.sound) ++tally.refused;
    return;
  }
  EXPECT_LT(made.turned, 90.0) << name;
  if (!hard.sound) return;
  EXPECT_EQ(made.quality.euler, 2 - 2 * hard.handles - circles_of(hard)) << name;
  EXPECT_NEAR(made.quality.area, hard.area, (0.01 + hard.unsure) * hard.area) << name;
  EXPECT_GE(made.quality.alpha_min, bound) << name;
  EXPECT_LE(made.quality.gauss_bonnet, 1e-7) << name;
}

TEST(MeshesOfHardFaces, OfKinksTipsAndThinFacesAreClean) {
  Tally tally;
  // A kink; tips; long and thin.
  for (const std::uint32_t seed : {66U, 125U, 95U, 245U, 75U}) mesh_one(seed, 1.0 / 30.0, tally);
  EXPECT_EQ(tally.sound, 5U);
  EXPECT_EQ(tally.refused, 0U);
}

TEST(MeshesOfHardFaces, AreCleanOrTheFaceIsRefused) {
  const std::uint32_t first = asked("DOBRA_HARD_FIRST", 0),
                      count = asked("DOBRA_HARD_MESHES", support::hard_face_kinds);
  Tally tally;
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    for (const double part : {1.0 / 30.0, 1.0 / 100.0}) mesh_one(seed, part, tally);
  }
  EXPECT_LE(static_cast<double>(tally.refused), 0.05 * static_cast<double>(tally.sound))
      << tally.refused << " of " << tally.sound << " sound ones";
}

}  // namespace
}  // namespace dobra::io::faces
