// The mesh step: the engine stopped on its way, and how good the meshes of specimens are, which no constant of the
// mesher was chosen on.

#include "quebra/meshing/meshing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "quebra/sketch/specimen.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::meshing {
namespace {

std::string mesh_of(const std::string& specimen, const std::string& parameters) {
  return "[input]\nspecimen = \"" + specimen + "\"\n[[step]]\noperation = \"mesh\"\n" + parameters;
}

TEST(Meshing, AnEngineStoppedOnItsWayIsShownWithItsFront) {
  for (const std::string engine : {"front", "delaunay"}) {
    std::size_t before = 0;
    for (const int steps : {1, 50, 200}) {
      const auto run = test::run(mesh_of(
          "plate_with_hole", "size = 0.4\nengine = \"" + engine + "\"\nstop_after = " + std::to_string(steps) + "\n"));
      ASSERT_TRUE(run.complete());
      const model::Model& model = test::last(run);
      ASSERT_TRUE(model.work);
      EXPECT_TRUE(model.meshes.empty());
      EXPECT_EQ(model.work->steps, static_cast<std::size_t>(steps));
      EXPECT_GE(model.work->triangles.size(), before);
      before = model.work->triangles.size();
      EXPECT_GT(model.work->front.size(), 20U);
      const auto picture = core::program().picture_of(run.states.back());
      EXPECT_EQ(picture.panels.back().key, "work");
      EXPECT_EQ(picture.panels.back().layers.back().key, "front");
      EXPECT_EQ(test::figures(run).at("work.front"), static_cast<double>(model.work->front.size()));
    }
    EXPECT_GT(before, 100U);
  }
}

TEST(Meshing, MoreStepsThanAreNeededGiveTheWholeMesh) {
  const auto stopped = test::run(mesh_of("l_shape", "stop_after = 1000000\n"));
  const auto whole = test::run(mesh_of("l_shape", ""));
  EXPECT_FALSE(test::last(stopped).work);
  EXPECT_EQ(test::last(stopped).meshes.back()->mesh.points, test::last(whole).meshes.back()->mesh.points);
}

TEST(Meshing, NothingButAMeshFollowsAMeshThatIsNotDone) {
  const std::string stopped = mesh_of("l_shape", "stop_after = 5\n");
  EXPECT_NE(test::trouble(stopped + "[[step]]\noperation = \"analyse\"\n").find("stop_after"), std::string::npos);
  const auto again = test::run(stopped + "[[step]]\noperation = \"mesh\"\n");
  EXPECT_FALSE(test::last(again).work);
  EXPECT_EQ(test::last(again).meshes.size(), 1U);
}

TEST(Meshing, SpecimensKeepTheFloorsOfQualityWithBothEngines) {
  for (const std::string& name : sketch::specimen_names()) {
    if (name == "none") continue;
    for (const std::string engine : {"front", "delaunay"}) {
      const auto run = test::run(mesh_of(name, "engine = \"" + engine + "\"\n"));
      ASSERT_TRUE(run.complete()) << name;
      const auto& q = test::last(run).meshes.back()->quality;
      std::printf("| %s | %s | %zu | %.4f | %.2f %% | %.3f |\n", name.c_str(), engine.c_str(), q.triangles,
                  q.alpha_mean, 100.0 * q.alpha_90, q.alpha_min);
      EXPECT_GE(q.alpha_min, 0.6) << name << " " << engine;
      EXPECT_GE(q.alpha_mean, 0.93) << name << " " << engine;
    }
  }
}

TEST(Meshing, PairsAlongAlternatingPathsLeaveFewTriangles) {
  for (const std::string name : {"quarter_plate", "l_shape", "compact_tension"}) {
    for (const std::string engine : {"front", "delaunay"}) {
      const auto run = test::run(mesh_of(name, "quads = \"yes\"\nengine = \"" + engine + "\"\n"));
      ASSERT_TRUE(run.complete()) << name;
      const auto& meshed = *test::last(run).meshes.back();
      ASSERT_TRUE(check(meshed.mesh).ok()) << name;
      const auto left = std::count(meshed.mesh.types.begin(), meshed.mesh.types.end(), dobra::mesh::ElementType::T3);
      EXPECT_LE(static_cast<double>(left), 0.08 * static_cast<double>(meshed.mesh.element_count()))
          << name << " " << engine;  // pairs by quality alone: 0.17 to 0.26
      EXPECT_NEAR(area(meshed.mesh), meshed.quality.area, 1e-9 * meshed.quality.area) << name;
    }
  }
}

/// Rounded apart by 1e-16 the contact would have two nodes, and flat triangles between them.
TEST(Meshing, RoundHolesThatTouchShareANode) {
  const auto circle = [](const std::string& name, double x, double y) {
    return "[[input.curve]]\nname = \"" + name + "\"\nkind = \"circle\"\nradius = 1.0\ncentre = [" +
           fmt::format("{}, {}", x, y) + "]\n";
  };
  const std::string rim =
      "[input]\n[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [10, 0], [10, 10], [0, 10]]\n";
  for (const double turned : {0.0, 0.25, 0.5, 1.0}) {
    const double x = 2.0 * std::cos(turned * std::numbers::pi), y = 2.0 * std::sin(turned * std::numbers::pi);
    const auto run =
        test::run(rim + circle("one", 4.0, 4.0) + circle("two", 4.0 + x, 4.0 + y) + "[[step]]\noperation = \"mesh\"\n");
    ASSERT_TRUE(run.complete()) << (run.error ? to_string(*run.error) : "");
    const auto& mesh = test::last(run).meshes.back()->mesh;
    const dobra::geom::Point contact{4.0 + 0.5 * x, 4.0 + 0.5 * y};
    EXPECT_EQ(
        std::count_if(mesh.points.begin(), mesh.points.end(), [&](auto p) { return distance(p, contact) < 1e-6; }), 1)
        << turned;
    EXPECT_GT(test::figures(run).at("alpha_min"), 0.2) << turned;
  }
}

}  // namespace
}  // namespace quebra::meshing
