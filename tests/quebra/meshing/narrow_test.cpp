#include "quebra/meshing/narrow.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quebra/meshing/meshing.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::meshing {
namespace {

const std::string rim = R"(
[[input.curve]]
name = "rim"
kind = "polygon"
points = [[0, 0], [4, 0], [4, 4], [0, 4]]
)";

std::string hole_at(const std::string& name, double x, double radius) {
  return "[[input.curve]]\nname = \"" + name + "\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [" +
         std::to_string(x) + ", 2.0]\nradius = " + std::to_string(radius) + "\n";
}

std::string drawn_line(const std::string& name, const std::string& points) {
  return "[[input.curve]]\nname = \"" + name + "\"\nkind = \"line\"\nrole = \"internal\"\npoints = " + points + "\n";
}

std::string crack_of(const std::string& points) {
  return "[[input.crack]]\nname = \"crack\"\npoints = " + points + "\n";
}

std::string point(const std::string& name, const std::string& at) {
  return "[[input.point]]\nname = \"" + name + "\"\npoint = " + at + "\n";
}

std::string polygon(const std::string& points) {
  return "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = " + points + "\n";
}

std::string meshed(const std::string& size, const std::string& more = "") {
  return "[[step]]\noperation = \"mesh\"\nsize = " + size + "\n" + more;
}

std::string across(int elements) { return "narrow = " + std::to_string(elements) + ".0\n"; }

model::Model model_of(const std::string& text) {
  const auto run = test::run(text);
  EXPECT_TRUE(run.complete()) << text << (run.error ? to_string(*run.error) : "");
  return run.complete() ? test::last(run) : model::Model{};
}

const dobra::mesh::MeshQuality& quality(const model::Model& model) { return model.meshes.back()->quality; }

/// Two holes, a tip above a side, a crack along one, near polygons, near lines, a point beside a side, a slot.
const std::vector<std::pair<std::string, std::string>> narrow_ones = {
    {"holes 0.05 apart", rim + hole_at("a", 1.475, 0.5) + hole_at("b", 2.525, 0.5)},
    {"holes 0.001 apart", rim + hole_at("a", 1.4995, 0.5) + hole_at("b", 2.5005, 0.5)},
    {"tip 0.1 above a side", rim + crack_of("[[2, 0.1], [2, 2]]")},
    {"crack 0.1 above a side", rim + crack_of("[[1, 0.1], [3, 0.1]]")},
    {"lines that lean on each other",
     rim + drawn_line("a", "[[1, 2], [3, 2]]") + drawn_line("b", "[[1.5, 2.07], [3.2, 2.3]]")},
    {"point beside a side", rim + "[[input.point]]\nname = \"gauge\"\npoint = [1.2, 3.95]\n"},
    {"hole near the rim", rim + hole_at("a", 3.45, 0.5)},
    {"points 0.003 apart", rim + point("a", "[2, 2]") + point("b", "[2.003, 2]")},
    {"three points 0.02 apart", rim + point("a", "[2, 2]") + point("b", "[2.02, 2]") + point("c", "[2.04, 2]")},
};

TEST(Narrow, NarrowPlacesGetGoodElementsWithBothEngines) {
  for (const auto& [name, input] : narrow_ones) {
    for (const std::string engine : {"front", "delaunay"}) {
      const model::Model fine = model_of(input + meshed("0.5", "engine = \"" + engine + "\"\n"));
      const model::Model off = model_of(input + meshed("0.5", "narrow = 0.0\nengine = \"" + engine + "\"\n"));
      ASSERT_FALSE(fine.meshes.empty());
      ASSERT_FALSE(off.meshes.empty());
      std::printf("| %s | %s | %zu | %.3f | %zu | %.3f |\n", name.c_str(), engine.c_str(), quality(off).triangles,
                  quality(off).alpha_min, quality(fine).triangles, quality(fine).alpha_min);
      EXPECT_GE(quality(fine).alpha_min, 0.55) << name << " " << engine;
      EXPECT_LT(quality(off).alpha_min, quality(fine).alpha_min) << name << " " << engine;
      EXPECT_LE(quality(fine).triangles, 2500U) << name;  // growth leads away again
    }
  }
}

/// The narrow places of a text, of its curves divided at `size`.
std::size_t mesh_count(const std::string& input, const std::string& size, const std::string& more = "") {
  return quality(model_of(input + meshed(size, more))).triangles;
}

TEST(Narrow, WhatIsNotNarrowIsMeshedAsWithout) {
  const std::vector<std::pair<std::string, std::string>> wide = {
      {"plate with a hole", rim + hole_at("a", 2.0, 0.5)},
      {"a slot is narrow outside the material", rim + "[[input.curve]]\nname = \"slot\"\nkind = \"polygon\"\nrole = "
                                                      "\"hole\"\npoints = [[1, 1], [3, 1], [3, 3], [1, 3]]\n"},
      {"an edge crack's lips coincide", rim + crack_of("[[0, 2], [2, 2]]")},
      {"a corner of 20 degrees is an input angle",
       "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 1.4559]]\n"},
      {"lines that leave a point at 15 degrees",
       rim + drawn_line("a", "[[1, 2], [3, 2]]") + drawn_line("b", "[[1, 2], [3, 2.5359]]")},
  };
  for (const auto& [name, input] : wide)
    EXPECT_EQ(mesh_count(input, "0.25"), mesh_count(input, "0.25", "narrow = 0.0\n")) << name;
}

TEST(Narrow, AcrossAHoleIsNotThroughTheMaterial) {
  const std::string slit = rim +
                           "[[input.curve]]\nname = \"slot\"\nkind = \"polygon\"\nrole = \"hole\"\npoints = [[1, 2], "
                           "[3, 2], [3, 2.3], [1, 2.3]]\n";
  // The slot's ends are 0.3 long, so that its sides are 0.3 at its corners either way.
  EXPECT_EQ(mesh_count(slit, "0.5"), mesh_count(slit, "0.5", "narrow = 0.0\n"));
}

TEST(Narrow, MoreElementsAcrossOnDemand) {
  const std::string input = rim + hole_at("a", 1.4, 0.5) + hole_at("b", 2.6, 0.5);
  const std::size_t one = mesh_count(input, "0.5");
  // The sides of the holes are shorter than these 0.2 m as they bend; elements elsewhere are larger.
  const std::size_t four = mesh_count(input, "0.5", across(4));
  EXPECT_GT(four, one + one / 8);
  EXPECT_GT(mesh_count(input, "0.5", across(8)), 3 * four / 2);
}

TEST(Narrow, WhatIsNarrowDoesNotDependOnTheElementsAskedFor) {
  const std::vector<std::pair<std::string, std::string>> wide = {
      {"square", rim},
      {"disc", "[[input.curve]]\nname = \"o\"\nkind = \"circle\"\ncentre = [0, 0]\nradius = 2\n"},
      {"oval",
       "[[input.curve]]\nname = \"o\"\nkind = \"spline\"\nrole = \"boundary\"\npoints = [[4, 0], [2.8, 1.4], [0, 2], "
       "[-2.8, 1.4], [-4, 0], [-2.8, -1.4], [0, -2], [2.8, -1.4], [4, 0]]\n"},
      {"plate with a hole", rim + hole_at("a", 2.0, 0.5)},
      {"cut corner", polygon("[[0, 0], [3.8, 0], [4, 0.2], [4, 4], [0, 4]]")},
      {"crack from side to side", rim + crack_of("[[0, 2], [4, 2]]")},
      {"crack with a short kink", rim + crack_of("[[1, 2], [1.8, 2], [1.8, 2.1], [2.6, 2.1]]")},
  };
  for (const auto& [name, input] : wide) {
    const std::size_t one = mesh_count(input, "0.4");
    for (const int more : {2, 3, 20}) EXPECT_EQ(mesh_count(input, "0.4", across(more)), one) << name << " " << more;
  }
  // Nor on the length of sides that a formula has yet to divide.
  const std::string formula = "[[step]]\noperation = \"mesh\"\nsize_formula = \"0.4\"\n";
  const std::string plate = rim + hole_at("a", 2.0, 0.5);
  EXPECT_EQ(quality(model_of(plate + formula + across(20))).triangles, quality(model_of(plate + formula)).triangles);
}

TEST(Narrow, AsManyElementsAcrossAsAskedFor) {
  // The widths are not far above the smallest that is asked for, a thousandth of the side.
  for (const double width : {0.02, 0.0008}) {
    const std::string strip = polygon(fmt::format("[[0, 0], [1, 0], [1, {0}], [0, {0}]]", width));
    for (const int n : {1, 2, 3, 5}) {
      if (width < 0.01 && n == 5) continue;
      const double ideal = 4.0 / std::sqrt(3.0) * n * n / width;
      const auto count = static_cast<double>(mesh_count(strip, "0.5", across(n)));
      EXPECT_GT(count, 0.7 * ideal) << width << " " << n;
      EXPECT_LT(count, 1.4 * ideal) << width << " " << n;
    }
  }
  const std::string cracks =
      rim + crack_of("[[1, 2], [3, 2]]") + "[[input.crack]]\nname = \"other\"\npoints = [[1, 2.02], [3, 2.02]]\n";
  std::size_t before = 0;
  for (const int n : {1, 2, 3, 4, 6}) {
    const model::Model model = model_of(cracks + meshed("0.5", across(n)));
    EXPECT_GT(quality(model).triangles, before + before / 4) << n;
    EXPECT_GE(quality(model).alpha_min, 0.55) << n;
    before = quality(model).triangles;
  }
}

TEST(Narrow, BentSidesThatFirstChordsKeepApartAreSeen) {
  const std::string input = rim + hole_at("a", 0.50005, 0.5);
  for (const std::string turn : {"15.0", "30.0", "45.0"}) {
    const model::Model model = model_of(input + meshed("0.25", "turn = " + turn + "\n"));
    EXPECT_GE(quality(model).alpha_min, 0.55) << turn;
    EXPECT_TRUE(model.remarks.empty()) << turn << model.remarks[0];
  }
}

TEST(Narrow, WhatIsTooNarrowIsTold) {
  const model::Model strip = model_of(polygon("[[0, 0], [4, 0], [4, 0.0003], [0, 0.0003]]") + meshed("0.5"));
  EXPECT_LT(quality(strip).triangles, 200U);
  ASSERT_EQ(strip.remarks.size(), 1U);
  EXPECT_NE(strip.remarks[0].find("curve 'rim', with sides of 0.5 m at ("), std::string::npos) << strip.remarks[0];
  EXPECT_NE(strip.remarks[0].find("is 0.0003 m from another part of it: too near for `narrow`"), std::string::npos)
      << strip.remarks[0];
  // Told already as a sliver of the domain.
  const model::Model film = model_of(rim + drawn_line("a", "[[0, 2], [4, 2]]") +
                                     drawn_line("b", "[[0, 2.0002], [4, 2.0002]]") + meshed("0.5"));
  ASSERT_EQ(film.remarks.size(), 1U) << film.remarks[1];
  EXPECT_NE(film.remarks[0].find("sliver at (0, 2) of a, b"), std::string::npos) << film.remarks[0];
}

TEST(Narrow, SteepGrowthIsTold) {
  const std::string input = rim + hole_at("a", 1.475, 0.5) + hole_at("b", 2.525, 0.5);
  const model::Model model = model_of(input + meshed("0.5", "growth = 2.0\n"));
  ASSERT_EQ(model.remarks.size(), 1U);
  EXPECT_NE(model.remarks[0].find("growth = 2 leads away from narrow places"), std::string::npos) << model.remarks[0];
  EXPECT_TRUE(model_of(rim + meshed("0.5", "growth = 2.0\n")).remarks.empty());
  EXPECT_TRUE(model_of(input + meshed("0.5", "growth = 1.6\n")).remarks.empty());
}

TEST(Narrow, PlacesBelowTheSmallestAreLeftAndTold) {
  const model::Model model = model_of(
      "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [2.0001, 4], [2, "
      "0.00001], [1.9999, 4], [0, 4]]\n" +
      meshed("0.5"));
  EXPECT_LT(quality(model).triangles, 2000U);
  EXPECT_FALSE(model.findings.empty());
}

TEST(Narrow, AnExplicitSubdivisionIsKeptAndTold) {
  const std::string input =
      "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\nsegments = "
      "16\n" +
      crack_of("[[2, 0.1], [2, 2]]");
  const model::Model model = model_of(input + meshed("0.5"));
  EXPECT_EQ(model.meshes.back()->mesh.side_sets.at("rim").size(), 16U);
  ASSERT_EQ(model.remarks.size(), 1U);
  EXPECT_NE(model.remarks[0].find("keeps its `segments`"), std::string::npos) << model.remarks[0];
  EXPECT_NE(model.remarks[0].find("0.1 m from 'crack'"), std::string::npos) << model.remarks[0];
}

TEST(Narrow, PointsThatAFormulaAlreadyMakesRoomForAskForNothing) {
  const std::string points = point("a", "[2, 2]") + point("b", "[2.2, 2]");
  const std::string formula = "[[step]]\noperation = \"mesh\"\nsize_formula = \"0.2\"\nnarrow = ";
  EXPECT_EQ(quality(model_of(rim + points + formula + "1.0\n")).triangles,
            quality(model_of(rim + points + formula + "0.0\n")).triangles);
}

TEST(Narrow, SizesFollowTheWidthAlongAChannel) {
  const auto run = test::run(
      "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 0.02], [0, 0.02]]\n" +
      meshed("0.5"));
  ASSERT_TRUE(run.complete());
  const auto& q = quality(test::last(run));
  EXPECT_GE(q.alpha_min, 0.55);
  EXPECT_GE(q.triangles, 250U);  // 4 / 0.02 long, about one across
  EXPECT_LE(q.triangles, 1000U);
}

/// A star-shaped contour with octaves of waves: inlets of every width.
std::string coast(int count) {
  std::string points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    double r = 1.0;
    for (int k = 3, octave = 0; k < count / 4; k = k * 8 / 5 + 1, ++octave)
      r += 0.3 * std::pow(3.0 / k, 0.75) * std::sin(k * angle + 2.4 * octave * octave);
    points += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", 100.0 * std::max(r, 0.1) * std::cos(angle),
                          100.0 * std::max(r, 0.1) * std::sin(angle));
  }
  return polygon("[" + points + "]");
}

TEST(Narrow, WhatStraightSidesAskForIsSettledAtOnce) {
  const model::Model model = model_of(coast(400) + meshed("5.0"));
  const domain::Domain& domain = model.domain;
  // The curves as a mesh without narrow places divides them: every side asks, and none is to be looked at again.
  dobra::mesh::delaunay::MeshInput divided;
  dobra::mesh::delaunay::add_chain(divided, std::get<dobra::geom::Polyline>(domain.curves[0].shape).points,
                                   dobra::mesh::delaunay::Closure::Closed,
                                   {"rim", dobra::mesh::delaunay::EdgeKind::Boundary});
  const std::vector<std::uint8_t> keeps(domain.curves.size(), 0);
  const NarrowPlaces places = narrow_places(domain, divided, keeps);
  EXPECT_GT(places.sizes.size(), 20U);
  EXPECT_TRUE(places.slight.empty());
  EXPECT_TRUE(places.again.empty());
  // And the mesh is as good as several looks made it.
  EXPECT_GT(quality(model).alpha_min, 0.2);
}

TEST(Narrow, NoSideOfTheMeshIsLeftMuchLongerThanItsPlaceIsWide) {
  for (const int count : {60, 200, 700}) {
    const model::Model model = model_of(coast(count) + meshed("8.0"));
    const auto& own = model.meshes.back()->mesh;
    dobra::mesh::delaunay::MeshInput divided;
    divided.points = own.points;
    divided.sets.push_back({"rim", dobra::mesh::delaunay::EdgeKind::Boundary});
    for (const auto& side : own.side_sets.at("rim")) {
      const auto nodes = side_nodes(own, side);
      divided.edges.push_back({{nodes[0], nodes[1]}, 0});
    }
    const std::vector<std::uint8_t> keeps(1, 0);
    NarrowOptions twice;
    twice.enough = 3.0;  // twice what they are left at
    EXPECT_TRUE(narrow_places(model.domain, divided, keeps, twice).sizes.empty()) << count;
  }
}

}  // namespace
}  // namespace quebra::meshing
