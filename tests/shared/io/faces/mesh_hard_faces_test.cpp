// From a file to a mesh: seeded faces are imported, opened at their poles, divided, meshed and joined.
// DOBRA_HARD_MESHES is how many, DOBRA_HARD_FIRST the first seed; DOBRA_HARD_PRINT=1 prints a line for each.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "shared/io/faces/import.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/mesh/division.h"
#include "shared/surf/trim/area.h"
#include "shared/surf/trim/open.h"
#include "tests/support/hard_faces.h"

namespace dobra::io::faces {
namespace {

namespace sm = surf::mesh;

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

struct Meshed {
  std::string refused;  ///< Why, where there is no mesh.
  sm::SurfaceQuality quality;
  double turned = 0.0;  ///< Greatest angle between a triangle's normal and its surface's, degrees.
};

Meshed refused_by(const char* step, const base::Error& error) {
  return {fmt::format("{}: {}", step, base::to_string(error)), {}, 0.0};
}

Meshed mesh_of(const std::vector<surf::trim::TrimmedSurface>& faces, double size) {
  std::vector<surf::trim::TrimmedSurface> parts;
  surf::trim::SharedNumbers numbers;
  for (const surf::trim::TrimmedSurface& face : faces) {
    const auto opened = surf::trim::open(face, numbers);
    if (!opened) return refused_by("open", opened.error());
    for (const surf::trim::Opened& part : *opened) parts.push_back(part.face);
  }
  sm::SizeOptions sizes;
  sizes.largest = size;
  sizes.turn = 10.0;
  const auto division = sm::divide(parts, {.sizes = sizes});
  if (!division) return refused_by("divide", division.error());
  std::vector<sm::FaceMesh> meshes;
  for (const sm::ChartInput& input : division->faces) {
    auto mesh = sm::mesh_chart(input, {.sizes = sizes});
    if (!mesh) return refused_by("mesh", mesh.error());
    meshes.push_back(*std::move(mesh));
  }
  const auto whole = sm::assemble(parts, *division, meshes);
  if (!whole) return refused_by("assemble", whole.error());
  if (const auto fine = sm::check(*whole); !fine) return refused_by("check", fine.error());
  Meshed made{"", sm::quality_of(*whole), 0.0};
  for (std::size_t i = 0; i < whole->triangles.size(); ++i) {
    const auto& places = whole->places[i];
    const geom::Point middle{(places[0].x + places[1].x + places[2].x) / 3.0,
                             (places[0].y + places[1].y + places[2].y) / 3.0};
    const auto normal = surf::normal(parts[whole->faces[i]].surface, middle);
    const auto& corners = whole->triangles[i];
    geom::Vector3 own =
        cross(whole->point(corners[1]) - whole->point(corners[0]), whole->point(corners[2]) - whole->point(corners[0]));
    if (parts[whole->faces[i]].reversed) own = -own;
    if (!normal || !(geom::length(own) > 0.0)) continue;
    const double cosine = std::clamp(dot(*normal, own) / geom::length(own), -1.0, 1.0);
    made.turned = std::max(made.turned, std::acos(cosine) * 180.0 / std::numbers::pi);
  }
  return made;
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
  if (!hard.sound) {
    EXPECT_FALSE(imported->findings.empty()) << name << ": " << hard.wrong;
    if (imported->faces.empty()) return;
  } else {
    ++tally.sound;
  }
  if (imported->faces.empty()) {
    ++tally.refused;
    EXPECT_FALSE(imported->findings.empty()) << name;
    return;
  }
  const surf::trim::TrimmedSurface& face = imported->faces[0];
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
  const Meshed made = mesh_of(imported->faces, part * geom::distance(low, high));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double bound = std::min(0.1, 0.5 * best_alpha_at(least_corner(face)));
  if (asked("DOBRA_HARD_PRINT", 0) != 0)
    fmt::print("{}: {} triangles {} alpha {:.3f} .. {:.3f} (bound {:.3f}) area {:.3e} turned {:.1f} in {:.2f} s\n",
               name, made.refused.empty() ? "meshed" : made.refused, made.quality.triangles, made.quality.alpha_min,
               made.quality.alpha_mean, bound, made.quality.area / hard.area - 1.0, made.turned, seconds);
  EXPECT_LT(seconds, longest_seconds) << name;
  if (!made.refused.empty()) {
    if (hard.sound) ++tally.refused;
    return;
  }
  if (!hard.sound) return;
  EXPECT_NEAR(made.quality.area, hard.area, (0.01 + hard.unsure) * hard.area) << name;
  EXPECT_GE(made.quality.alpha_min, bound) << name;
  EXPECT_LE(made.quality.gauss_bonnet, 1e-7) << name;
  EXPECT_LT(made.turned, 90.0) << name;
}

TEST(MeshesOfHardFaces, OfSeedsThatOnceDidNotEndAreClean) {
  Tally tally;
  for (const std::uint32_t seed : {66U, 125U}) mesh_one(seed, 1.0 / 30.0, tally);  // a kink; a tip
  EXPECT_EQ(tally.sound, 2U);
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
