#include "quebra/meshing/band.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quebra/domain/domain.h"
#include "shared/geom/intersect.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::meshing {
namespace {

using namespace dobra;
using geom::Point;
using geom::Polyline;
using geom::Segment;

std::string bands(const std::string& curve, int count, double distance, const std::string& more = "") {
  return fmt::format("[[step]]\noperation = \"constraints\"\ncurves = [\"{}\"]\ncount = {}\ndistance = {}\n{}", curve,
                     count, distance, more);
}
const std::string band_mesh_step = "[[step]]\noperation = \"mesh\"\n";
const std::string beam = "[input]\nspecimen = \"pmma_beam\"\n";
const std::string band_plate =
    "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[0, 0], [8, 0], [8, 4], [0, 4]]\n";
std::string band_hole(const std::string& name, double x, double radius) {
  return fmt::format("[[input.curve]]\nname = \"{}\"\nkind = \"circle\"\ncentre = [{}, 2]\nradius = {}\n", name, x,
                     radius);
}

/// Segments of different constraints that meet anywhere but in a common end.
std::size_t bad_meetings(const std::vector<model::Constraint>& constraints) {
  std::vector<Segment> segments;
  for (const model::Constraint& constraint : constraints) {
    for (std::size_t i = 0; i < constraint.line.segment_count(); ++i) segments.push_back(constraint.line.segment(i));
  }
  std::size_t bad = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const auto meeting = intersect(segments[i], segments[j]);
      if (meeting.kind == geom::IntersectionKind::None) continue;
      const bool in_ends =
          meeting.start.on_first != geom::At::Interior && meeting.start.on_second != geom::At::Interior;
      if (meeting.kind == geom::IntersectionKind::Overlap || !in_ends) ++bad;
    }
  }
  return bad;
}

/// Runs a mesh with bands: valid, every curve of them in it, nothing crosses.
scenario::Run meshed(const std::string& text, double least_alpha) {
  const scenario::Run done = test::run(text + band_mesh_step);
  const auto values = test::figures(done);
  if (!done.complete()) return done;
  const model::Model& model = test::last(done);
  EXPECT_EQ(bad_meetings(model.constraints), 0U);
  EXPECT_TRUE(mesh::check(model.meshes.back()->mesh).ok());
  const auto triangles = triangle_mesh_of(model.meshes.back()->mesh);
  for (const model::Constraint& constraint : model.constraints)
    EXPECT_TRUE(triangles.constraint_sets.contains(constraint.name)) << constraint.name;
  EXPECT_GT(values.at("alpha_min"), least_alpha);
  EXPECT_GT(values.at("alpha_mean"), 0.9);
  return done;
}

TEST(Band, RingsOfThreeHolesOfTheBeamMeetInCommonNodes) {
  const auto done = meshed(beam + bands("hole_1", 3, 0.3) + bands("hole_2", 3, 0.3) + bands("hole_3", 3, 0.3), 0.35);
  if (!done.complete()) return;
  // The centres are 2 apart, so that rings of radius 0.55 and 0.85 are whole and those of 1.15 open towards each other.
  const auto& constraints = test::last(done).constraints;
  std::map<Point, int> ends;
  for (const model::Constraint& constraint : constraints) {
    EXPECT_EQ(constraint.line.closed, constraint.distance < 0.8) << constraint.name;
    if (!constraint.line.closed && constraint.feet.empty()) {
      ++ends[constraint.line.points.front()];
      ++ends[constraint.line.points.back()];
    }
  }
  EXPECT_GE(ends.size(), 2U);
  for (const auto& [at, count] : ends) EXPECT_EQ(count, 2) << "rings of two holes end in one node";
}

TEST(Band, RingsThatJustTouchAndRingsFarTooManyAreMeshed) {
  meshed(beam + bands("hole_1", 2, 0.375) + bands("hole_2", 2, 0.375), 0.25);
  meshed(beam + bands("hole_1", 4, 0.2) + bands("hole_2", 9, 0.2) + bands("hole_3", 5, 0.25), 0.3);
}

TEST(Band, ACrackAndTheBoundaryItStartsFromShareTheirCurves) {
  const auto done =
      meshed("[input]\nspecimen = \"single_edge_notch\"\n" + bands("crack", 2, 0.06) + bands("left", 2, 0.1), 0.35);
  if (!done.complete()) return;
  const model::Model& model = test::last(done);
  const Polyline crack =
      trace(*std::find_if(model.domain.curves.begin(), model.domain.curves.end(), [](const sketch::Curve& c) {
        return c.name == "crack";
      })).line;
  for (const model::Constraint& constraint : model.constraints) {
    const bool of_left = constraint.name.starts_with("left");
    const double rank = std::round(constraint.distance / (of_left ? 0.1 : 0.06));
    for (const Point p : constraint.line.points) {
      if (!of_left) continue;
      EXPECT_GE(distance(crack, p), 0.97 * rank * 0.06) << "no curve of the side runs into the crack's";
    }
  }
}

TEST(Band, CracksThatBranchHaveOneSetOfCurvesRoundBoth) {
  meshed(band_plate +
             "[[input.crack]]\nname = \"crack\"\npoints = [[0, 2], [3, 2.2]]\n[[input.crack]]\nname = "
             "\"branch\"\npoints = [[1.5, 2.1], [2.3, 1.2]]\n" +
             bands("crack", 3, 0.1) + bands("branch", 3, 0.1),
         0.25);
}

TEST(Band, AMuchFinerBandStaysWholeAndTheCoarseOneEndsAtIt) {
  const auto done = meshed(band_plate + band_hole("fine", 3, 0.5) + band_hole("coarse", 5.5, 0.5) +
                               bands("fine", 4, 0.1) + bands("coarse", 2, 0.5),
                           0.3);
  if (!done.complete()) return;
  for (const model::Constraint& constraint : test::last(done).constraints) {
    if (constraint.name.starts_with("fine")) {
      EXPECT_TRUE(constraint.line.closed);
    } else {
      for (const Point p : constraint.line.points) EXPECT_GE(distance(p, Point{3, 2}), 0.9 - 0.01);
    }
  }
}

TEST(Band, ACurveThatGivesWayEverywhereGetsARemark) {
  const auto done = test::run(band_plate + band_hole("small", 4.5, 0.05) + band_hole("big", 6.2, 1.5) +
                              bands("small", 1, 0.3) + bands("big", 1, 0.59));
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  const auto& remarks = test::last(done).remarks;
  EXPECT_TRUE(std::any_of(remarks.begin(), remarks.end(),
                          [](const std::string& text) { return text.find("small_1") != std::string::npos; }));
  const auto apart = test::run(band_plate + bands("plate", 3, 0.6) + bands("plate", 3, 0.6));
  EXPECT_TRUE(apart.complete()) << "the same curves twice are the user's";
}

}  // namespace
}  // namespace quebra::meshing
