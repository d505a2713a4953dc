// Trims that share a piece of their way, and holes that overlap a little: what is left, by closed forms.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "quebra/surfaces/mesh_surfaces.h"
#include "shared/surf/trim/area.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::shared_trims_test {
namespace {

using namespace dobra;
using test::plate;
using test::surfaces_of;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

std::string line(const char* name, const char* role, const std::string& points) {
  return fmt::format("[[input.trim]]\nname = \"{}\"\nkind = \"line\"\nrole = \"{}\"\npoints = {}\n", name, role,
                     points);
}
std::string circle(const char* name, const char* role, double x, double y, double radius) {
  return fmt::format(
      "[[input.trim]]\nname = \"{}\"\nkind = \"circle\"\nrole = \"{}\"\ncentre = [{:.17g}, {:.17g}]\nradius = "
      "{:.17g}\n",
      name, role, x, y, radius);
}

struct Seen {
  std::size_t components = 0;  ///< Of triangles that share sides.
  double border = 0.0;         ///< Length of sides of one triangle.
  std::map<std::string, double> sets;
  std::vector<std::string> codes;
};

Seen seen(const std::string& text) {
  Seen all;
  const auto made = surfaces_of(text);
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  if (!made) return all;
  for (const auto& finding : made->findings) all.codes.push_back(finding.code);
  model::SurfaceSet set;
  set.faces = made->faces;
  set.chart_units.assign(made->faces.size(), {1.0, 1.0});
  const auto meshed = mesh_surfaces(set, {.sizes = {.largest = 1.0, .turn = 30.0}});
  EXPECT_TRUE(meshed) << (meshed ? "" : to_string(meshed.error()));
  if (!meshed) return all;
  const auto& mesh = meshed->mesh;
  std::vector<std::size_t> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto top = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> beside;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = mesh.triangles[t][i].index(), b = mesh.triangles[t][(i + 1) % 3].index();
      beside[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
  }
  for (const auto& [side, triangles] : beside) {
    if (triangles.size() == 1) all.border += geom::distance(mesh.points[side.first], mesh.points[side.second]);
    for (const std::size_t t : triangles) parent[top(t)] = top(triangles.front());
  }
  for (std::size_t t = 0; t < parent.size(); ++t) all.components += parent[t] == t ? 1U : 0U;
  for (const auto* sets : {&mesh.constraint_sets, &mesh.boundary_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const auto& edge : edges) all.sets[name] += geom::distance(mesh.point(edge[0]), mesh.point(edge[1]));
    }
  }
  return all;
}

/// Two holes of a plate: the plate less both, with their lens, which is in both, once.
double less_two(double radius, double other, double apart) {
  const double a = (apart * apart + radius * radius - other * other) / (2.0 * apart), b = apart - a;
  const auto cap = [](double r, double off) { return r * r * std::acos(off / r) - off * std::sqrt(r * r - off * off); };
  return 100.0 - pi * radius * radius - pi * other * other + cap(radius, a) + cap(other, b);
}
double area_of(const std::string& text) {
  const auto made = surfaces_of(text);
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  double area = 0.0;
  for (std::size_t i = 0; made && i < made->faces.size(); ++i) area += surf::trim::area(made->faces[i]).value;
  return area;
}

TEST(SharedTrims, ACrackAlongAnotherLineOpensItselfAlone) {
  for (const char* const role : {"internal", "interface", "cut"}) {
    const std::string wall = line("w", role, "[[5, 0], [5, 10]]");
    for (const char* const way : {"[[5, 3], [5, 7]]", "[[5, 7], [5, 3]]"}) {
      const std::string crack = line("k", "crack", way);
      for (const bool crack_first : {true, false}) {
        const Seen got = seen(plate + (crack_first ? crack + wall : wall + crack));
        const auto told = fmt::format("{} {} {}", role, way, crack_first);
        EXPECT_EQ(got.components, 1U) << told;
        EXPECT_NEAR(got.border, 48.0, 1e-9) << told;
        EXPECT_NEAR(got.sets.at("w"), 6.0, 1e-9) << told;
        EXPECT_EQ(got.codes, std::vector<std::string>{"line_on_crack"}) << told;
      }
    }
  }
}

TEST(SharedTrims, ACrackThatGoesOnBeyondALineOpensAllOfItself) {
  const std::string wall = line("w", "internal", "[[5, 2], [5, 5]]");
  for (const char* const way : {"[[5, 3], [5, 7]]", "[[5, 7], [5, 3]]"}) {
    const Seen got = seen(plate + wall + line("k", "crack", way));
    EXPECT_EQ(got.components, 1U);
    EXPECT_NEAR(got.border, 48.0, 1e-9);
    EXPECT_NEAR(got.sets.at("w"), 1.0, 1e-9);
  }
}

TEST(SharedTrims, LinesOnACrackAreTold) {
  const auto made =
      surfaces_of(plate + line("w", "internal", "[[5, 4], [5, 5]]") + line("k", "crack", "[[5, 3], [5, 7]]"));
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_EQ(made->findings.size(), 1U);
  EXPECT_EQ(made->findings[0].code, "line_on_crack");
  EXPECT_THAT(made->findings[0].message, HasSubstr("'w' runs along the crack 'k'"));
  EXPECT_NEAR(*made->findings[0].place.x, 5.0, 1e-9);
  EXPECT_GE(*made->findings[0].place.y, 4.0);
  EXPECT_LE(*made->findings[0].place.y, 5.0);
  // Lines that a crack crosses or ends on share nothing with it.
  EXPECT_TRUE(
      seen(plate + line("w", "internal", "[[2, 5], [8, 5]]") + line("k", "crack", "[[5, 3], [5, 7]]")).codes.empty());
  EXPECT_TRUE(
      seen(plate + line("w", "internal", "[[2, 5], [8, 5]]") + line("k", "crack", "[[5, 5], [5, 7]]")).codes.empty());
}

TEST(SharedTrims, ACrackOnTheRimOfAHoleLeavesTheRimItsName) {
  const std::string hole =
      "[[input.trim]]\nname = \"h\"\nkind = \"polygon\"\nrole = \"hole\"\npoints = [[3, 3], [7, 3], [7, 7], [3, 7]]\n";
  const std::string crack = line("k", "crack", "[[7, 5], [7, 9]]");
  for (const std::string& text : {hole + crack, crack + hole}) {
    const Seen got = seen(plate + text);
    EXPECT_NEAR(got.border, 40.0 + 16.0 + 4.0, 1e-9);
    EXPECT_NEAR(got.sets.at("h"), 16.0, 1e-9);
    EXPECT_TRUE(got.codes.empty());
  }
}

TEST(SharedTrims, HolesThatOverlapALittleAreBothTakenAway) {
  for (const double radius : {1.0, 1.5}) {
    for (const double over : {0.1, 0.02, 0.01, 1e-3, 5e-4, 2e-4, 1e-4, 1e-5}) {
      for (int turn = 0; turn < 12; ++turn) {
        const double apart = 1.0 + radius - over, angle = 2.0 * pi * turn / 12.0 + 0.07 * (turn % 3);
        const std::string text =
            plate + circle("a", "hole", 5.0, 5.0, 1.0) +
            circle("b", "hole", 5.0 + apart * std::cos(angle), 5.0 + apart * std::sin(angle), radius);
        EXPECT_NEAR(area_of(text), less_two(1.0, radius, apart), 1e-6) << radius << " " << over << " " << turn;
      }
    }
  }
}

TEST(SharedTrims, HolesBesideOutlinesAndBordersAreTakenAway) {
  for (const double over : {0.01, 1e-3, 1e-4, 1e-5}) {
    // Beyond the outline it takes nothing; the cap of the hole that is in it is what less_two counts twice.
    const std::string ring = circle("o", "outline", 5.0, 5.0, 2.0) + circle("b", "hole", 5.0, 8.0 - over, 1.0);
    const double lens = less_two(2.0, 1.0, 3.0 - over) - (100.0 - 5.0 * pi);
    EXPECT_NEAR(area_of(plate + ring), 4.0 * pi - lens, 1e-6) << over;
    // Three in a row.
    const double apart = 2.0 - over;
    const std::string row = circle("a", "hole", 5.0 - apart, 5.0, 1.0) + circle("b", "hole", 5.0, 5.0, 1.0) +
                            circle("c", "hole", 5.0 + apart, 5.0, 1.0);
    EXPECT_NEAR(area_of(plate + row), 2.0 * less_two(1.0, 1.0, apart) - (100.0 - pi), 1e-6) << over;
  }
}

/// The unrolled pipe is a plate: a circle of its chart in space is an ellipse of degrees by metres there.
TEST(SharedTrims, HolesThatOverlapOverASeamAreBothTakenAway) {
  const double degree = pi / 180.0, wide = 1.0 / degree;  // radius 1
  const std::string pipe =
      "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 1\nu = [0, 360]\nv = [0, 10]\n";
  for (const double at : {0.0, 3.0, 357.0, 180.0}) {
    for (const double over : {0.01, 1e-3, 1e-4}) {
      std::string text = pipe;
      for (const auto& [name, v] : {std::pair{"a", 3.0}, std::pair{"b", 5.0 - over}}) {
        text += fmt::format(
            "[[input.trim]]\nname = \"{}\"\nkind = \"ellipse\"\nrole = \"hole\"\ncentre = [{}, {:.17g}]\nradii = "
            "[{:.17g}, 1]\n",
            name, at, v, wide);
      }
      EXPECT_NEAR(area_of(text), less_two(1.0, 1.0, 2.0 - over) - 100.0 + 20.0 * pi, 1e-6) << at << " " << over;
    }
  }
}

}  // namespace
}  // namespace quebra::surfaces::shared_trims_test
