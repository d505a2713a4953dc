#include "recon/unfold/methods.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "shared/geom/contour.h"
#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

using std::numbers::pi;

const std::vector<RestoreMethod> all_methods = {RestoreMethod::Constant,     RestoreMethod::Variable,
                                                RestoreMethod::Proportional, RestoreMethod::Flexural,
                                                RestoreMethod::Shear,        RestoreMethod::LineLength};

/// Chords round an arc about (0, -radius), from -half to half, left to right, the hinge at the origin: each touches the
/// arc in its middle, the first and the last are halves, so that the ends stand square to the arc and parallels are
/// alike.
geom::Polyline hinge_arc(double radius, double depth, double half, int chords) {
  geom::Polyline line;
  const double step = 2.0 * half / chords;
  const auto add = [&](double angle, double r) {
    line.points.push_back({r * std::sin(angle), r * std::cos(angle) - radius});
  };
  add(-half, radius - depth);
  for (int i = 0; i < chords; ++i) add(-half + step * (i + 0.5), (radius - depth) / std::cos(0.5 * step));
  add(half, radius - depth);
  return line;
}

/// A concentric fold: R = 1000, t = 300, half angle 40 degrees.
section::Section concentric_fold(int chords = 60000) {
  const double half = 40.0 * pi / 180.0;
  return test::section_of({hinge_arc(1000.0, 0.0, half, chords), hinge_arc(1000.0, 300.0, half, chords)});
}

model::Model with_target(const section::Section& section, const TargetParams& target = {}) {
  model::Model model;
  model.section = section;
  GridParams grid;
  grid.count = 1;
  auto with_grid = core::run_grid(model, grid, {}, {});
  EXPECT_TRUE(with_grid) << to_string(with_grid.error());
  auto made = core::run_target(*with_grid, target, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  return std::move(*made);
}

Restoration restored(const model::Model& model, const RestoreParams& params) {
  auto made = core::run_restore(model, params, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  return std::move(*made->restoration);
}

RestoreParams by(RestoreMethod method) {
  RestoreParams params;
  params.method = method;
  return params;
}

MethodParams map_by(RestoreMethod method, double percent = 100.0, double shear_degrees = 0.0) {
  MethodParams params;
  params.method = method;
  params.percent = percent;
  params.shear_angle = base::Angle::from_degrees(shear_degrees);
  return params;
}

TargetParams pinned_at(double x) {
  TargetParams target;
  target.pin = x;
  return target;
}

maps::SectionMap map_of(const model::Model& model, const MethodParams& params) {
  auto made = make_method_map(model.section, *model.source, *model.target, params);
  EXPECT_TRUE(made) << to_string(made.error());
  return std::move(made->map);
}

// Closed forms of docs/algorithms/unfold.md and flexural_slip.md for concentric_fold().

TEST(Methods, ConstantThicknessOfTheConcentricFoldGainsThePublishedArea) {
  const Restoration flat = restored(with_target(concentric_fold()), by(RestoreMethod::Constant));
  EXPECT_NEAR(flat.ledger.units[0].area_before, 356047.167, 5e-4);
  EXPECT_NEAR(flat.ledger.units[0].area_after, 418879.020, 5e-4);
  EXPECT_NEAR(flat.ledger.units[0].change_percent, 100.0 * 300.0 / 1700.0, 1e-6);  // t / (2R - t): + 17.65 %
  EXPECT_NEAR(flat.lengths[0].length_after, 1396.263, 5e-4);
  EXPECT_NEAR(flat.lengths[1].length_after, 1396.263, 5e-4);
  EXPECT_NEAR(flat.ledger.units[0].dilatation->mean, 300.0 / 1700.0, 1e-3);
}

TEST(Methods, FlexuralSlipOfTheConcentricFoldKeepsLengthsAndAreaAndLeansTheEnds) {
  const Restoration flat = restored(with_target(concentric_fold(), pinned_at(0.0)), by(RestoreMethod::Flexural));
  EXPECT_NEAR(flat.lengths[0].length_before, 1396.263, 5e-4);
  EXPECT_NEAR(flat.lengths[0].length_after, 1396.263, 5e-4);
  EXPECT_NEAR(flat.lengths[1].length_before, 977.384, 5e-4);
  EXPECT_NEAR(flat.lengths[1].length_after, 977.384, 5e-4);
  EXPECT_NEAR(flat.ledger.units[0].area_before, 356047.167, 5e-4);
  EXPECT_NEAR(flat.ledger.units[0].area_after, 356047.167, 5e-4);
  EXPECT_NEAR(flat.lean_left, -0.698132, 5e-7);  // beds are shorter below: the ends lean inwards
  EXPECT_NEAR(flat.lean_right, -0.698132, 5e-7);
  EXPECT_NEAR(flat.ledger.units[0].dilatation->least, 0.0, 1e-8);
  EXPECT_NEAR(flat.ledger.units[0].dilatation->greatest, 0.0, 1e-8);
  // Shortening R (2 a - 2 sin a) grows with the radius: the beds do not agree with each other.
  const double half = 40.0 * pi / 180.0;
  EXPECT_NEAR(flat.balance.consistency.worst.percent, 30.0 * (1.0 - std::sin(half) / half), 1e-6);
  EXPECT_NE(flat.balance.verdict, balance::BalanceVerdict::Balanced);
}

TEST(Methods, InterbedSlipOfAKinkIsTwiceTheTangentOfHalfItsTurn) {
  const double turn = 30.0 * pi / 180.0;
  const geom::Point end{100.0 + 100.0 * std::cos(turn), -100.0 * std::sin(turn)};
  const geom::Polyline top{{{0, 0}, {100, 0}, end}, false};
  const model::Model model = with_target(test::section_of({top, test::parallel(top, 10.0)}));
  const maps::SectionMap map = map_of(model, map_by(RestoreMethod::Flexural));
  const maps::Gradient beyond = map.gradient({120.0, -18.0});
  EXPECT_NEAR(beyond.determinant(), 1.0, 1e-8);
  // In the frame of the limb the shear is the displacement along the bed a metre of depth.
  const geom::Vector along{std::cos(turn), -std::sin(turn)};
  const geom::Vector down{-std::sin(turn), -std::cos(turn)};
  const geom::Vector moved{beyond.xx * down.x + beyond.xy * down.y, beyond.yx * down.x + beyond.yy * down.y};
  EXPECT_NEAR(moved.x, -2.0 * std::tan(0.5 * turn), 1e-8);
  EXPECT_NEAR(moved.y, -1.0, 1e-8);
  EXPECT_NEAR(beyond.xx * along.x + beyond.xy * along.y, 1.0, 1e-8);
}

TEST(Methods, FlexuralSlipToABentTargetKeepsEveryBedAndTheArea) {
  const section::Section section =
      test::section_of({test::cosine(), test::parallel(test::cosine(), 0.3), test::parallel(test::cosine(), 0.6)});
  TargetParams target;
  target.shape = TargetShape::Line;
  target.points = {{-5, 1}, {3, 0.5}, {6, -0.5}, {14, 0.3}, {30, 3}};
  target.pin = 5.0;
  const Restoration bent = restored(with_target(section, target), by(RestoreMethod::Flexural));
  for (const balance::LineLength& row : bent.lengths)
    EXPECT_NEAR(row.length_after, row.length_before, 1e-9 * row.length_before);
  for (const balance::UnitRow& row : bent.ledger.units)
    EXPECT_NEAR(row.area_after, row.area_before, 1e-9 * row.area_before);
}

TEST(Methods, REC_e_VariableThicknessKeepsTheAreaAboveEveryBed) {
  const geom::Polyline top = test::arc();
  const section::Section section =
      test::section_of({top, test::parallel(top, 0.5), test::parallel(top, 1.0), test::parallel(top, 2.0)});
  const model::Model model = with_target(section);
  const Restoration flat = restored(model, by(RestoreMethod::Variable));
  const std::vector<double> mean_depths = {0.0, 0.487694, 0.950778, 1.803110};
  const std::vector<double> areas = {0.0, 7.660493, 14.934404, 28.322478};
  for (std::size_t i = 1; i < 4; ++i) {
    const double before = std::abs(geom::signed_area(contour_between(top, section.horizons[i].line)));
    const double after =
        std::abs(geom::signed_area(contour_between(flat.section.horizons[0].line, flat.section.horizons[i].line)));
    EXPECT_NEAR(before, areas[i], 1e-6);
    EXPECT_NEAR(after, before, 1e-9 * before);
    EXPECT_NEAR(after / flat.lengths[0].length_after, mean_depths[i], 1e-6);
  }
}

TEST(Methods, REC_a_EveryMethodLeavesTheSectionInPlaceWhereTheTopIsItsOwnTarget) {
  const geom::Polyline top = test::cosine();
  const section::Section section = test::section_of({top, test::parallel(top, 0.3), test::parallel(top, 0.6)});
  TargetParams target;
  target.shape = TargetShape::Line;
  target.points = top.points;
  const model::Model model = with_target(section, target);
  for (const RestoreMethod method :
       {RestoreMethod::Constant, RestoreMethod::Variable, RestoreMethod::Flexural, RestoreMethod::Shear}) {
    const Restoration same = restored(model, by(method));
    for (const maps::MappedLine& line : same.lines)
      EXPECT_LT(test::greatest_distance(line.before.points, line.after.points), 1e-9) << method_name(method);
  }
}

TEST(Methods, VerticalShearOfASineKeepsAreaAndGivesBedsTheirWidth) {
  geom::Polyline top;
  geom::Polyline base;
  for (int i = 0; i <= 400; ++i) {
    const double x = 1000.0 * i / 400.0;
    top.points.push_back({x, 60.0 * std::sin(2.0 * pi * x / 500.0)});
    base.points.push_back({x, top.points.back().y - 80.0});
  }
  const section::Section section = test::section_of({top, base});
  const Restoration flat = restored(with_target(section), by(RestoreMethod::Shear));
  EXPECT_NEAR(flat.ledger.units[0].area_before, 80000.0, 1e-8);
  EXPECT_NEAR(flat.ledger.units[0].area_after, 80000.0, 1e-8);
  for (const balance::LineLength& row : flat.lengths) {
    EXPECT_NEAR(row.length_before, geom::length(top), 1e-9);
    EXPECT_NEAR(row.length_after, 1000.0, 1e-9);
  }
  // t_orth = t_v cos(dip) at the inflection, where the bed is straightest.
  const double dip = std::atan(2.0 * pi * 60.0 / 500.0);
  EXPECT_NEAR(flat.ledger.units[0].thickness_before->least, 80.0 * std::cos(dip), 0.5);
  EXPECT_NEAR(flat.ledger.units[0].thickness_after->mean, 80.0, 1e-9);
}

TEST(Methods, InclinedShearMovesPointsAlongItsDirectionOnly) {
  const section::Section section = test::section_of({test::cosine(), test::parallel(test::cosine(), 0.4)});
  const model::Model model = with_target(section);
  for (const double degrees : {-40.0, -20.0, 25.0}) {
    const MethodParams params = map_by(RestoreMethod::Shear, 100.0, degrees);
    const maps::SectionMap map = map_of(model, params);
    const geom::Vector along{std::sin(params.shear_angle.radians()), std::cos(params.shear_angle.radians())};
    for (const geom::Point p : section.horizons[1].line.points) {
      const geom::Point image = map.forward(p).at;
      EXPECT_NEAR(geom::cross(image - p, along), 0.0, 1e-12);
      EXPECT_NEAR(map.gradient(p + geom::Vector{0.01, 0.0}).determinant(), 1.0, 1e-8);
    }
    for (const geom::Point p : section.horizons[0].line.points)
      EXPECT_NEAR(map.forward(p).at.y, model.target->target_pin.y, 1e-12);
  }
}

TEST(Methods, ProportionalThicknessMakesARectangleOfTheSameArea) {
  const geom::Polyline top = test::cosine();
  geom::Polyline base;
  for (const geom::Point p : top.points) base.points.push_back({p.x, 0.6 * p.y - 2.0});
  geom::Polyline middle;
  for (const geom::Point p : top.points) middle.points.push_back({p.x, 0.8 * p.y - 1.0});
  const Restoration flat =
      restored(with_target(test::section_of({top, middle, base})), by(RestoreMethod::Proportional));
  const auto& lines = flat.section.horizons;
  const double depth = lines[0].line.points.front().y - lines[2].line.points.front().y;
  for (const geom::Point p : lines[2].line.points) EXPECT_NEAR(p.y, lines[2].line.points.front().y, 1e-9);
  const double area = flat.ledger.units[0].area_before + flat.ledger.units[1].area_before;
  EXPECT_NEAR(depth * flat.lengths[0].length_after, area, 1e-9 * area);
  EXPECT_NEAR(flat.lengths[2].length_after, flat.lengths[0].length_after, 1e-9);
  EXPECT_GT(lines[1].line.points[40].y, lines[2].line.points[40].y);
  EXPECT_LT(lines[1].line.points[40].y, lines[0].line.points[40].y);
}

TEST(Methods, LineLengthUnfoldingGivesEveryHorizonItsLength) {
  const section::Section section =
      test::section_of({test::cosine(), test::parallel(test::cosine(), 0.3), test::parallel(test::cosine(), 0.7)});
  const Restoration flat = restored(with_target(section, pinned_at(2.0 * pi)), by(RestoreMethod::LineLength));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(flat.lengths[i].length_after, flat.lengths[i].length_before, 1e-9);
    for (const geom::Point p : flat.section.horizons[i].line.points)
      EXPECT_NEAR(p.y, flat.section.horizons[i].line.points.front().y, 1e-9);
  }
}

TEST(Methods, REC_g_ForwardThenBackwardIsTheIdentityForEveryMethod) {
  TargetParams bent;
  bent.shape = TargetShape::Line;
  bent.points = {{-2000, 300}, {3000, 100}, {5200, 250}, {9000, 0}, {14000, 200}};
  bent.target_pin = {5200, 250};
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const section::Section section = test::random_section(seed);
    TargetParams target = seed % 2 == 0 ? bent : TargetParams{};
    target.pin = 4800.0 + 100.0 * seed;
    const model::Model model = with_target(section, target);
    std::vector<geom::Point> points;
    for (const section::Horizon& horizon : section.horizons)
      points.insert(points.end(), horizon.line.points.begin(), horizon.line.points.end());
    for (const RestoreMethod method : all_methods) {
      for (const double percent : {100.0, 37.0}) {
        const maps::SectionMap map = map_of(model, map_by(method, percent, 10.0));
        std::vector<geom::Point> there(points.size());
        std::vector<geom::Point> home(points.size());
        ASSERT_TRUE(map.forward(points, there));
        ASSERT_TRUE(map.inverse(there, home));
        for (std::size_t i = 0; i < points.size(); ++i) {
          EXPECT_LE(geom::distance(points[i], home[i]), 1e-9 * 10000.0)
              << method_name(method) << " seed " << seed << " at " << points[i] << ' ' << percent;
          EXPECT_EQ(there[i], map.forward(points[i]).at);  // in a batch as alone
        }
      }
    }
  }
}

/// Units between parallel horizons keep their areas under flexural slip, their ends bent at the corners of the target.
void expect_areas_kept(const Restoration& state) {
  for (const balance::UnitRow& row : state.ledger.units)
    EXPECT_NEAR(row.area_after, row.area_before, 1e-9 * row.area_before) << row.name << ' ' << state.params.percent;
}

TEST(Methods, StatesOnTheWayKeepWhatTheMethodKeeps) {
  const section::Section section = test::section_of({test::cosine(), test::parallel(test::cosine(), 0.3)});
  const model::Model model = with_target(section, pinned_at(5.0));
  for (const SlipBeds beds : {SlipBeds::Horizons, SlipBeds::Parallel}) {
    for (const double percent : {0.0, 25.0, 50.0, 90.0, 100.0}) {
      RestoreParams params = by(RestoreMethod::Flexural);
      params.beds = beds;
      params.percent = percent;
      const Restoration state = restored(model, params);
      for (const balance::LineLength& row : state.lengths)
        EXPECT_NEAR(row.length_after, row.length_before, 1e-9) << percent;
      expect_areas_kept(state);
      if (percent > 0.0) continue;
      for (const maps::MappedLine& line : state.lines)
        EXPECT_LT(test::greatest_distance(line.before.points, line.after.points), 1e-9);
    }
  }
}

/// The top in the middle: two parallels above it, two below.
section::Section with_layers_above() {
  const geom::Polyline top = test::cosine();
  return test::section_of(
      {top, test::parallel(top, -0.2), test::parallel(top, -0.4), test::parallel(top, 0.3), test::parallel(top, 0.6)});
}

TEST(Methods, FlexuralSlipAlongHorizonsKeepsTheUnitsAboveTheTopToo) {
  TargetParams bent;
  bent.shape = TargetShape::Line;
  bent.points = {{-5, 1}, {3, 0.5}, {6, -0.5}, {14, 0.3}, {30, 3}};
  bent.pin = 5.0;
  // On the way to the bent target a corner of it stands next to one of the top, and the column between closes above
  // the beds: only to the straight one.
  for (const auto& [target, percent] : {std::pair(pinned_at(5.0), 40.0), {pinned_at(5.0), 100.0}, {bent, 100.0}}) {
    const model::Model model = with_target(with_layers_above(), target);
    RestoreParams params = by(RestoreMethod::Flexural);
    params.percent = percent;
    const Restoration state = restored(model, params);
    ASSERT_EQ(state.ledger.units.size(), 4u);
    EXPECT_EQ(state.ledger.units[0].name, "bed2 - bed1");
    for (const balance::LineLength& row : state.lengths)
      EXPECT_NEAR(row.length_after, row.length_before, 1e-9) << row.name;
    expect_areas_kept(state);
  }
}

TEST(Methods, REC_g_FlexuralSlipAlongHorizonsComesBackAboveTheTopToo) {
  const section::Section section = with_layers_above();
  const model::Model model = with_target(section, pinned_at(5.0));
  for (const double percent : {40.0, 100.0}) {
    const maps::SectionMap map = map_of(model, map_by(RestoreMethod::Flexural, percent));
    for (const section::Horizon& horizon : section.horizons) {
      for (const double down : {-0.05, 0.0, 0.05}) {
        for (const geom::Point vertex : horizon.line.points) {
          const geom::Point p = vertex + geom::Vector{0.0, -down};
          EXPECT_LE(geom::distance(map.inverse(map.forward(p).at), p), 1e-9 * 4.0 * pi) << horizon.name << ' ' << p;
        }
      }
    }
  }
}

TEST(Methods, HorizonsGoVertexByVertexWhereTheMethodTakesThemAsBeds) {
  const section::Section section = test::random_section(3);
  const model::Model model = with_target(section, pinned_at(4800.0));
  for (const RestoreMethod method : {RestoreMethod::Flexural, RestoreMethod::LineLength}) {
    const Restoration flat = restored(model, by(method));
    for (std::size_t h = 0; h < section.horizons.size(); ++h) {
      const maps::MappedLine& line = flat.lines[h];
      ASSERT_EQ(line.given.size(), section.horizons[h].line.points.size());
      ASSERT_EQ(line.names.size(), line.before.points.size());
      for (std::size_t i = 0; i < line.given.size(); ++i) {
        const geom::Point vertex = section.horizons[h].line.points[i];
        EXPECT_EQ(line.before.points[line.given[i]], vertex);
        // The line's own arc length and the map of the stack agree.
        EXPECT_LT(geom::distance(flat.map.forward(vertex).at, line.after.points[line.given[i]]), 1e-8);
        const maps::ColumnPoint name = model.target->map.locate(vertex).at;
        EXPECT_NEAR(line.names[line.given[i]].depth, h == 0 ? 0.0 : name.depth, 1e-9);
      }
    }
  }
}

TEST(Methods, PolygonsFaultsAndMarkersGoWithTheSection) {
  section::Section section = concentric_fold(400);
  section.units.push_back(
      {section::UnitId(0), "sand", contour_between(section.horizons[0].line, section.horizons[1].line), {}});
  section.lines.push_back(
      {section::LineId(0), section::LineKind::Fault, "F1", {{{100.0, -20.0}, {180.0, -280.0}}, false}, {}});
  section.markers.push_back({section::MarkerId(0), "well", {{0.0, -50.0}, {0.0, -150.0}}, {}});
  const Restoration flat = restored(with_target(section, pinned_at(0.0)), by(RestoreMethod::Flexural));
  ASSERT_EQ(flat.ledger.units.size(), 1u);
  EXPECT_EQ(flat.ledger.units[0].name, "sand");
  EXPECT_NEAR(flat.ledger.units[0].area_after, flat.ledger.units[0].area_before,
              1e-9 * flat.ledger.units[0].area_before);
  EXPECT_NEAR(std::abs(geom::signed_area(flat.section.units[0].contour)), flat.ledger.units[0].area_after, 1e-9);
  for (std::size_t i = 0; i < 2; ++i) {  // on the pin line, which stays
    EXPECT_NEAR(flat.section.markers[0].points[i].x, section.markers[0].points[i].x, 1e-9);
    EXPECT_NEAR(flat.section.markers[0].points[i].y, section.markers[0].points[i].y, 1e-6);
  }
  EXPECT_GT(flat.section.lines[0].line.points.size(), 2u);
}

TEST(Methods, DoubtIsRefusedWithThePlaceWhereTheUserWishes) {
  const geom::Polyline top = test::cosine();
  const model::Model model = with_target(test::section_of({top, {{{0, -3.6}, {12.0, -3.6}}, false}}));
  RestoreParams params = by(RestoreMethod::Constant);
  EXPECT_TRUE(core::run_restore(model, params, {}, {}));
  params.outside = Doubt::Refuse;
  const auto refused = core::run_restore(model, params, {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  ASSERT_TRUE(refused.error().place && refused.error().place->x);
  EXPECT_EQ(refused.error().place->item, "horizon 'bed1'");
}

TEST(Methods, ABedWhoseParallelDoesNotReachThePinIsRefusedWithThePlace) {
  // The pin line of the left limb has left the fold where the bed lies, of which only the right limb is there.
  const geom::Polyline top{{{0, 0}, {45, 90}, {55, 90}, {100, 0}}, false};
  const geom::Vector limb{1.0 / std::sqrt(5.0), -2.0 / std::sqrt(5.0)};
  const geom::Point inside = geom::Point{100, 0} + 35.0 * geom::Vector{limb.y, -limb.x};
  const geom::Polyline bed{{inside + -36.0 * limb, inside}, false};
  for (const RestoreMethod method : {RestoreMethod::Flexural, RestoreMethod::LineLength}) {
    const auto missed =
        core::run_restore(with_target(test::section_of({top, bed}), pinned_at(40.0)), by(method), {}, {});
    ASSERT_FALSE(missed);
    EXPECT_EQ(missed.error().code, base::ErrorCode::CannotRestore);
    ASSERT_TRUE(missed.error().place && missed.error().place->x);
    EXPECT_EQ(missed.error().place->item, "horizon 'bed1'");
    EXPECT_NE(missed.error().message.find("does not reach that either"), std::string::npos) << missed.error().message;
  }
}

TEST(Methods, RegionalAndHorizonTargetsAreFollowed) {
  const geom::Polyline top = test::cosine();
  geom::Polyline low;
  for (const geom::Point p : top.points) low.points.push_back({p.x, 0.1 * p.x - 3.0});
  const section::Section section = test::section_of({top, low});
  TargetParams target;
  target.shape = TargetShape::Horizon;
  target.horizon = "bed1";
  const Restoration to_bed = restored(with_target(section, target), by(RestoreMethod::Constant));
  for (const geom::Point p : to_bed.section.horizons[0].line.points) EXPECT_NEAR(p.y, 0.1 * p.x - 3.0, 1e-9);
  target.shape = TargetShape::Regional;
  const Restoration regional = restored(with_target(section, target), by(RestoreMethod::Flexural));
  for (const geom::Point p : regional.section.horizons[0].line.points) EXPECT_NEAR(p.y, 0.1 * p.x - 3.0, 1e-9);
}

}  // namespace
}  // namespace recon::unfold
