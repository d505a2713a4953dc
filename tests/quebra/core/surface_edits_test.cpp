#include "quebra/core/surface_edits.h"

#include <gtest/gtest.h>

#include "quebra/core/surface_start.h"
#include "shared/scenario/entries.h"
#include "tests/support/brep_writer.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::core {
namespace {

using namespace dobra;
using geom::Point;
using geom::Point3;

/// A plate of three strips with a hole in the right one.
const std::string strips =
    "[[input.surface]]\nname = \"plate\"\nkind = \"plane\"\nu = [0, 9]\nv = [0, 3]\n"
    "[[input.trim]]\nname = \"first\"\nrole = \"cut\"\npoints = [[3, 0], [3, 3]]\n"
    "[[input.trim]]\nname = \"second\"\nrole = \"cut\"\npoints = [[6, 0], [6, 3]]\n"
    "[[input.trim]]\nname = \"window\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [7.5, 1.5]\nradius = 0.5\n";

class Strips {
 public:
  explicit Strips(const std::string& more = "", const std::string& before = strips)
      : text_("dobra = 1\nprogram = \"quebra\"\n" + before + more) {
    auto read = scenario::parse_document(text_, "test.toml");
    EXPECT_TRUE(read.ok());
    document_ = *read;
  }
  explicit Strips(scenario::Document document) : document_(std::move(document)) {}
  const scenario::Document& document() const { return document_; }
  /// The surfaces of the document.
  std::shared_ptr<const model::SurfaceSet> set() const {
    scenario::Runner runner(program());
    const scenario::Run run = runner.run(document_);
    EXPECT_FALSE(run.error) << to_string(*run.error);
    return run.states.empty() ? nullptr : scenario::model_of<model::Model>(run.states.back()).surfaces;
  }
  /// Of a plane in the plane, by its loops: chords of curves are short enough.
  double area() const {
    double sum = 0.0;
    const auto all = set();
    for (const auto& loop : all->faces[0].loops) {
      std::vector<Point> points;
      for (const auto& edge : loop.edges) {
        for (int i = 0; i < 500; ++i) points.push_back(edge.at(edge.from + (edge.to - edge.from) * i / 500.0));
      }
      for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
        sum += 0.5 * (points[j].x * points[i].y - points[i].x * points[j].y);
    }
    return sum;
  }
  Strips turned(Point uv) const {
    auto edited = with_part_turned(document_, *set(), 0, uv);
    EXPECT_TRUE(edited.ok()) << (edited ? "" : to_string(edited.error()));
    return Strips(std::move(edited->document));
  }
  base::Error refused(Point uv) const {
    auto edited = with_part_turned(document_, *set(), 0, uv);
    EXPECT_FALSE(edited.ok());
    return edited ? base::Error{} : edited.error();
  }
  std::size_t entries() const { return scenario::entries_of(document_.input, "part").size(); }

 private:
  std::string text_;
  scenario::Document document_;
};

constexpr double strip = 9.0;
constexpr double hole = 3.14159265358979 * 0.25;

TEST(SurfaceEdits, GUI_b_AClickLeavesAPartOutAndAnotherTakesItIn) {
  const Strips whole;
  EXPECT_NEAR(whole.area(), 3.0 * strip - hole, 1e-3);
  const Strips two = whole.turned({1.0, 1.0});
  EXPECT_NEAR(two.area(), 2.0 * strip - hole, 1e-3);
  const Strips one = two.turned({7.0, 2.5});
  EXPECT_NEAR(one.area(), strip, 1e-9);
  const Strips back = one.turned({2.9, 0.1}).turned({6.1, 0.1});
  EXPECT_NEAR(back.area(), 3.0 * strip - hole, 1e-3);
  // Nothing is left of it in the document.
  EXPECT_EQ(back.entries(), 0u);
  EXPECT_EQ(scenario::document_text(back.document()), scenario::document_text(whole.document()));
}

TEST(SurfaceEdits, GUI_b_IsWhatIsTypedByHand) {
  const Strips typed("[[input.part]]\nfate = \"drop\"\nat = [1.2, 1]\n");
  EXPECT_EQ(scenario::document_text(Strips().turned({1.2, 1.0}).document()), scenario::document_text(typed.document()));
}

TEST(SurfaceEdits, PartsThatAreKeptByNameLoseOrGetTheirEntry) {
  const Strips two("[[input.part]]\nat = [1, 1]\n[[input.part]]\nat = [4, 1]\nname = \"middle\"\n");
  EXPECT_NEAR(two.area(), 2.0 * strip, 1e-9);
  const Strips one = two.turned({2.0, 2.0});  // the first of them goes: that nobody keeps it is enough
  EXPECT_NEAR(one.area(), strip, 1e-9);
  EXPECT_EQ(one.entries(), 1u);
  EXPECT_NE(one.refused({5.0, 1.0}).message.find("the only part"), std::string::npos);
  const Strips other = one.turned({8.5, 0.5});
  EXPECT_NEAR(other.area(), 2.0 * strip - hole, 1e-3);
  EXPECT_EQ(other.entries(), 2u);
  // One that is kept and dropped is out; it comes in by the loss of what drops it.
  const Strips both(
      "[[input.part]]\nat = [1, 1]\n[[input.part]]\nat = [4, 1]\n[[input.part]]\nat = [1, 2]\nfate = \"drop\"\n");
  EXPECT_NEAR(both.area(), strip, 1e-9);
  EXPECT_NEAR(both.turned({1.0, 1.0}).area(), 2.0 * strip, 1e-9);
  EXPECT_EQ(both.turned({1.0, 1.0}).entries(), 2u);
}

TEST(SurfaceEdits, PlacesThatNameNoPartAreRefusedWithTheReason) {
  const Strips whole;
  EXPECT_NE(whole.refused({7.5, 1.5}).message.find("hole"), std::string::npos);
  EXPECT_NE(whole.refused({3.0, 1.0}).message.find("click inside a part"), std::string::npos);
  EXPECT_NE(whole.refused({12.0, 1.0}).message.find("click inside a part"), std::string::npos);
}

/// The last places of a thin part need more digits than those of a wide one.
TEST(SurfaceEdits, PlacesAreWrittenInFewDigitsThatLieInThePart) {
  // Without the hole: near chords of a circle a place is on no known side.
  const Strips thin("[[input.trim]]\nname = \"third\"\nrole = \"cut\"\npoints = [[3.004, 0], [3.004, 3]]\n",
                    strips.substr(0, strips.find("[[input.trim]]\nname = \"window\"")));
  const Strips without = thin.turned({3.00223456789, 1.23456789});
  EXPECT_NEAR(thin.area() - without.area(), 3.0 * 0.004, 1e-9);
  const auto point_of = [](const Strips& of) {
    const auto entries = scenario::entries_of(of.document().input, "part");
    return std::get<Point>(*entries.at(0).find("at"));
  };
  EXPECT_EQ(point_of(without), (Point{3.002, 1.235}));
  const Strips wide = Strips().turned({1.23456789, 2.3456789});
  EXPECT_EQ(point_of(wide), (Point{1.23, 2.35}));
}

TEST(SurfaceEdits, PlacesOfRoundSurfacesAreWrittenInDegreesWithinTheirRange) {
  const std::string tube =
      "[[input.surface]]\nname = \"tube\"\nkind = \"cylinder\"\nradius = 1\nv = [0, 4]\n"
      "[[input.trim]]\nname = \"ring\"\nkind = \"plane\"\nrole = \"cut\"\nat = [0, 0, 2]\nnormal = [0, 0, 1]\n";
  const Strips whole("", tube);
  ASSERT_EQ(whole.set()->parts[0].in.size(), 2u);
  // Once more round the axis than the chart goes: a mesh over the seam has such places.
  const Strips half = whole.turned({2.0 * 3.14159265358979 + 0.5, 3.0});
  const auto entries = scenario::entries_of(half.document().input, "part");
  const Point at = std::get<Point>(*entries.at(0).find("at"));
  EXPECT_NEAR(at.x, 0.5 * 180.0 / 3.14159265358979, 1.0);
  EXPECT_EQ(at.y, 3.0);
  EXPECT_EQ(half.set()->parts[0].in.size(), 1u);
  EXPECT_EQ(half.set()->parts[0].left_out.size(), 1u);
}

/// Four borders that share their corners.
const std::string coons =
    "[[input.space_curve]]\nname = \"bottom\"\nkind = \"bezier\"\npoints = [[0, 0, 0], [3, 0, 4], [6, 0, 4], [10, 0, "
    "0]]\n"
    "[[input.space_curve]]\nname = \"top\"\nkind = \"line\"\npoints = [[0, 10, 0], [10, 10, 0]]\n"
    "[[input.space_curve]]\nname = \"left\"\nkind = \"line\"\npoints = [[0, 0, 0], [0, 10, 0]]\n"
    "[[input.space_curve]]\nname = \"right\"\nkind = \"line\"\npoints = [[10, 0, 0], [10, 10, 0]]\n"
    "[[input.surface]]\nname = \"patch\"\nkind = \"coons\"\ncurves = [\"bottom\", \"top\", \"left\", \"right\"]\n";

std::vector<Point3> points_of(const scenario::Document& document, const char* table, std::size_t entry) {
  return std::get<std::vector<Point3>>(*scenario::entries_of(document.input, table).at(entry).find("points"));
}

TEST(SurfaceEdits, GUI_b_AControlPointMovesAloneOrWithTheCornerThatItIs) {
  const Strips patch("", coons);
  const auto set = patch.set();
  ASSERT_EQ(set->controls.size(), 10u);
  EXPECT_EQ(set->control_lines.size(), 4u);
  const auto moved = with_control_moved(patch.document(), *set, 1, {3.0, 0.5, 7.25});
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(points_of(*moved, "space_curve", 0)[1], (Point3{3.0, 0.5, 7.25}));
  const std::string typed = std::string(coons).replace(coons.find("[3, 0, 4]"), 9, "[3, 0.5, 7.25]");
  EXPECT_EQ(scenario::document_text(*moved), scenario::document_text(Strips("", typed).document()));
  // A corner is a point of two borders: a surface without gaps goes on to be one.
  const auto corner = with_control_moved(patch.document(), *set, 0, {-1.0, 0.0, 2.0});
  ASSERT_TRUE(corner.ok());
  EXPECT_EQ(points_of(*corner, "space_curve", 0)[0], (Point3{-1.0, 0.0, 2.0}));
  EXPECT_EQ(points_of(*corner, "space_curve", 2)[0], (Point3{-1.0, 0.0, 2.0}));
  EXPECT_EQ(Strips(*corner).set()->faces.size(), 1u);
}

TEST(SurfaceEdits, ControlPointsOfNetsAreInTheUnitsOfTheDocument) {
  std::string net =
      "unit_system = \"mm, N, MPa\"\n[[input.surface]]\nname = \"net\"\nkind = \"nurbs\"\ndegree = 2\n"
      "knots_u = [0, 0, 0, 1, 1, 1]\nknots_v = [0, 0, 0, 0.5, 1, 1, 1]\npoints = [";
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) net += "[" + std::to_string(100 * i) + ", " + std::to_string(50 * j) + ", 0],";
  }
  const Strips patch("", net + "]\n");
  const auto set = patch.set();
  ASSERT_EQ(set->controls.size(), 12u);
  EXPECT_EQ(set->control_lines.size(), 7u);  // three rows and four columns
  EXPECT_NEAR(set->controls[5].at.x, 0.1, 1e-15);
  EXPECT_EQ(set->control_lines[1], (std::vector<std::size_t>{4, 5, 6, 7}));
  EXPECT_EQ(set->control_lines[3 + 1], (std::vector<std::size_t>{1, 5, 9}));
  const auto moved = with_control_moved(patch.document(), *set, 5, {100.0, 50.0, 33.5});
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(points_of(*moved, "surface", 0)[5], (Point3{100.0, 50.0, 33.5}));
}

TEST(SurfaceEdits, APointThatIsNotThereAnyMoreIsRefused) {
  const Strips patch("", coons);
  const auto set = patch.set();
  scenario::Document other = patch.document();
  scenario::set_entries(other.input, "space_curve", {});
  EXPECT_FALSE(with_control_moved(other, *set, 1, {0.0, 0.0, 0.0}).ok());
}

}  // namespace
}  // namespace quebra::core
