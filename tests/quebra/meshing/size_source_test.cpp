#include "quebra/meshing/size_source.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "quebra/core/layers.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/vtu.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::meshing {
namespace {

using namespace dobra;
using geom::Point;
using ::testing::HasSubstr;

const std::string sized_plate =
    "[[input.curve]]\nname = \"p\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";
std::string sized_mesh_step(const std::string& params) { return "[[step]]\noperation = \"mesh\"\n" + params; }

/// Mean over the elements of side length / size wanted at the centre, and its greatest deviation from 1.
std::pair<double, double> agreement(const mesh::ElementMesh& mesh, const std::function<double(Point)>& wanted) {
  double sum = 0.0, worst = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    const Point a = mesh.point(nodes[0]), b = mesh.point(nodes[1]), c = mesh.point(nodes[2]);
    const double ratio = (distance(a, b) + distance(b, c) + distance(c, a)) / 3.0 /
                         wanted({(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0});
    sum += ratio;
    worst = std::max(worst, std::abs(std::log(ratio)));
  }
  return {sum / static_cast<double>(mesh.element_count()), worst};
}

TEST(SizeSource, ElementsFollowAFormulaOfThePlace) {
  const auto done = test::run(sized_plate + sized_mesh_step("size_formula = \"0.05 + 0.1 * hypot(x - 1, y - 2)\"\n"));
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  const auto [mean, worst] = agreement(test::last(done).meshes.back()->mesh,
                                       [](Point p) { return 0.05 + 0.1 * std::hypot(p.x - 1, p.y - 2); });
  EXPECT_NEAR(mean, 1.0, 0.08);
  EXPECT_LE(worst, std::log(1.9));
  EXPECT_GT(test::figures(done).at("alpha_mean"), 0.95);
}

TEST(SizeSource, TheLeastOfAllSizesCountsAndGrowthIsBounded) {
  // A jump from 0.02 to 2, beside a greatest size of 0.3.
  const auto done = test::run(sized_plate + sized_mesh_step("size = 0.3\nsize_formula = \"x < 0.5 ? 0.04 : 2\"\n"));
  ASSERT_TRUE(done.complete());
  const model::Meshed& meshed = *test::last(done).meshes.back();
  EXPECT_NEAR(meshed.sizes->size_at({0.2, 2}), 0.04, 0.006);
  EXPECT_NEAR(meshed.sizes->size_at({3.9, 2}), 0.3, 0.01);
  EXPECT_LE(meshed.sizes->size_at({0.8, 2}), 0.04 + 0.3 * 0.35 + 0.02) << "growth 1.3";
  EXPECT_GT(meshed.quality.alpha_min, 0.4);
}

TEST(SizeSource, FormulasAreRefusedWithTheirPlace) {
  const auto trouble = [](const std::string& formula) {
    return test::trouble(sized_plate + sized_mesh_step("size_formula = \"" + formula + "\"\n"));
  };
  EXPECT_THAT(trouble("0.1 + 0.05 * sqr(x)"), HasSubstr("size_formula"));
  EXPECT_THAT(trouble("0.1 + 0.05 * sqr(x)"), HasSubstr("sqrt"));
  EXPECT_THAT(trouble("0.5 - x"), HasSubstr("gives the size"));
  EXPECT_THAT(trouble("hypot(x - 2, y - 2) - 0.3"), HasSubstr("gives the size -0.0204915 m here"))
      << "inside, not on the boundary";
  EXPECT_THAT(trouble("sqrt(x - 1)"), HasSubstr("has no finite value here"));
  EXPECT_THAT(trouble("0.5 + 1 / x"), HasSubstr("has no finite value here"));
  EXPECT_THAT(trouble("1e-7 + 0 * x"), HasSubstr("more than the 20000000 allowed"));
  EXPECT_THAT(trouble("0.2 + 0.199999999 * sin(100000 * x)"), HasSubstr("too small, or change too fast"));
}

/// A sheared L, and a loop of at most `cycles` on it.
std::string loop(int cycles, const std::string& rules) {
  return test::sheared_l + "[[step]]\noperation = \"adapt\"\ntarget = 3\nmax_cycles = " + std::to_string(cycles) +
         "\n" + rules;
}

TEST(SizeSource, QUE_4_ALoopBeginsWithTheMeshThatAMeshStepMakesByTheSameRules) {
  const std::string rules =
      "size_formula = \"4 + 0.1 * hypot(x - 100, y - 100)\"\nengine = \"delaunay\"\nsmoothing = 1\ngrowth = "
      "1.2\ndivision = \"halving\"\nturn = 20\norder = \"2\"\n";
  const auto looped = test::run(loop(1, rules));
  const auto meshed = test::run(test::sheared_l + sized_mesh_step(rules));
  ASSERT_FALSE(test::last(looped).meshes.empty());
  ASSERT_TRUE(meshed.complete()) << to_string(*meshed.error);
  const mesh::ElementMesh& first = test::last(looped).meshes.front()->mesh;
  const mesh::ElementMesh& same = test::last(meshed).meshes.front()->mesh;
  EXPECT_EQ(first.element_count(), same.element_count());
  EXPECT_EQ(first.points, same.points);
}

TEST(SizeSource, QUE_4_NoCycleOfALoopHasGreaterSizesThanFormulaAndBackgroundMeshAsk) {
  const auto wanted = [](Point p) { return 4 + 0.1 * std::hypot(p.x - 100, p.y - 100); };
  const std::string formula = "size_formula = \"4 + 0.1 * hypot(x - 100, y - 100)\"\n";
  const auto done = test::run(loop(3, formula));
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  const model::Model& model = test::last(done);
  ASSERT_GE(model.meshes.size(), 2u);
  for (const auto& own : model.meshes) {
    for (const Point at : {Point{10, 10}, Point{40, 80}, Point{90, 90}})
      EXPECT_LE(own->sizes->size_at(at), 1.1 * wanted(at)) << own->name;
  }
  EXPECT_LT(agreement(model.meshes.back()->mesh, wanted).first, 1.08);

  const auto file = std::filesystem::temp_directory_path() / "dobra_loop_background.msh";
  ASSERT_TRUE(
      io::formats::write_mesh(file.string(), model.meshes.front()->mesh, io::meshes::InpElement::PlaneStress).ok());
  const auto again = test::run(loop(1, "background = \"" + file.string() + "\"\n"));
  std::filesystem::remove(file);
  ASSERT_FALSE(test::last(again).meshes.empty());
  const double ratio = static_cast<double>(test::last(again).meshes.front()->mesh.element_count()) /
                       static_cast<double>(model.meshes.front()->mesh.element_count());
  EXPECT_NEAR(ratio, 1.0, 0.2);
}

TEST(SizeSource, ALoopRefusesWhatAMeshStepRefuses) {
  EXPECT_THAT(test::trouble(loop(1, "size_formula = \"10 - x\"\n")), HasSubstr("gives the size"));
  EXPECT_THAT(test::trouble(loop(1, "background_field = \"h\"\n")), HasSubstr("give `background` too"));
  EXPECT_THAT(test::trouble(loop(1, "size = 1\nmax_elements = 100\n")), HasSubstr("more than the 100 allowed"));
}

class BackgroundMesh : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto done = test::run(sized_plate + sized_mesh_step("size_formula = \"0.1 + 0.1 * x\"\n"));
    ASSERT_TRUE(done.complete());
    mesh_ = test::last(done).meshes.back()->mesh;
    folder_ = std::filesystem::temp_directory_path() / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }

  mesh::ElementMesh mesh_;
  std::filesystem::path folder_;
};

TEST_F(BackgroundMesh, TheSizesOfItsElementsAreWantedAgain) {
  ASSERT_TRUE(io::formats::write_mesh(path("b.msh"), mesh_, io::meshes::InpElement::PlaneStress).ok());
  const auto done = test::run(sized_plate + sized_mesh_step("background = \"" + path("b.msh") + "\"\n"));
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  const auto& again = test::last(done).meshes.back()->mesh;
  EXPECT_NEAR(agreement(again, [](Point p) { return 0.1 + 0.1 * p.x; }).first, 1.0, 0.1);
  EXPECT_NEAR(static_cast<double>(again.element_count()) / static_cast<double>(mesh_.element_count()), 1.0, 0.2);
}

TEST_F(BackgroundMesh, AFieldAtItsPointsGivesTheSizes) {
  io::meshes::MeshField h{"h", 1, {}};
  io::meshes::MeshField bad{"bad", 1, {}};
  for (const Point p : mesh_.points) {
    h.values.push_back(0.05 + 0.05 * p.y);
    bad.values.push_back(p.y - 2.0);
  }
  ASSERT_TRUE(io::meshes::write_vtu(path("b.vtu"), mesh_, {{h, bad}, {}}).ok());
  const std::string background = "background = \"" + path("b.vtu") + "\"\n";
  const auto done = test::run(sized_plate + sized_mesh_step(background + "background_field = \"h\"\n"));
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  EXPECT_NEAR(agreement(test::last(done).meshes.back()->mesh, [](Point p) { return 0.05 + 0.05 * p.y; }).first, 1.0,
              0.08);
  EXPECT_THAT(test::trouble(sized_plate + sized_mesh_step(background + "background_field = \"bad\"\n")),
              HasSubstr("field 'bad'"));
  EXPECT_THAT(test::trouble(sized_plate + sized_mesh_step(background + "background_field = \"hh\"\n")),
              HasSubstr("it has: h, bad"));
  EXPECT_THAT(test::trouble(sized_plate + sized_mesh_step("background_field = \"h\"\n")),
              HasSubstr("give `background` too"));
}

TEST(SizeSource, TheSizesAreDrawnAsHiddenLayersAndAsAPicture) {
  const auto done = test::run(sized_plate + sized_mesh_step("size_formula = \"0.01 + 0.2 * x\"\n"));
  ASSERT_TRUE(done.complete());
  const model::Model& model = test::last(done);
  const auto find = [](const scene::Picture& picture, const std::string& key) {
    const auto& layers = picture.panels.at(0).layers;
    return std::find_if(layers.begin(), layers.end(), [&](const scene::Layer& layer) { return layer.key == key; });
  };
  scene::Picture usual;
  core::draw(model, usual);
  EXPECT_FALSE(find(usual, "size_field")->visible);
  EXPECT_FALSE(find(usual, "quadtree")->visible);
  const scene::Picture picture = core::size_field_picture(model, *model.meshes.back());
  const auto field = find(picture, "size_field");
  ASSERT_TRUE(field->visible);
  EXPECT_TRUE(find(picture, "quadtree")->visible);
  EXPECT_FALSE(find(picture, "mesh")->visible);
  // 80 : 1, so the colours go by powers of ten.
  const auto& content = std::get<scene::Mesh>(field->content);
  EXPECT_EQ(content.scale.title, "size [m]");
  EXPECT_EQ(content.scale.ticks, scene::AxisScale::Log10);
  const geom::Box shown = extent(picture.panels[0]), box = model.domain.box();
  EXPECT_EQ(shown.low, box.low);
  EXPECT_EQ(shown.high, box.high) << "the tree ends with the domain";
  EXPECT_FALSE(picture.panels[0].extent.has_value()) << "and there is room round it";
  EXPECT_NEAR(content.scale.low, -2.0, 0.05);
  EXPECT_NEAR(content.scale.high, std::log10(0.81), 0.05);
}

TEST(SizeSource, JacobiansAndQuadrilateralsAreReported) {
  const std::string quarter = "[input]\nspecimen = \"quarter_plate\"\n[[step]]\noperation = \"mesh\"\nturn = 45\n";
  const auto straight = test::figures(test::run(quarter));
  EXPECT_EQ(straight.at("jacobian_min"), 1.0);
  EXPECT_FALSE(straight.contains("quad_shape_min"));
  const auto bent = test::figures(test::run(quarter + "order = \"2\"\n"));
  EXPECT_LT(bent.at("jacobian_min"), 0.95);
  EXPECT_GT(bent.at("jacobian_min"), 0.1);
  const auto quads = test::figures(test::run(quarter + "order = \"2\"\nquads = \"yes\"\n"));
  EXPECT_GT(quads.at("quad_shape_mean"), 0.7);
  EXPECT_GT(quads.at("quad_shape_min"), 0.1);
  EXPECT_LE(quads.at("quad_shape_min"), quads.at("quad_shape_mean"));
}

}  // namespace
}  // namespace quebra::meshing
