// Rollovers by the closed form of inclined shear, and angles of folds by equations that the code does not use.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "recon/inversion/fold_angles.h"
#include "recon/inversion/predict.h"
#include "recon/inversion/rollover.h"
#include "tests/recon/inversion/folded_beds.h"

namespace recon::inversion {
namespace {

using std::numbers::pi;

base::Angle deg(double value) { return base::Angle::from_degrees(value); }

/// The fault w = W(q) of straight pieces and the bed that a level regional z = 0 becomes over it, every point moved by
/// the closed form; mirrored: x turned round.
struct KnownRollover {
  double shear = 0.0;    ///< Degrees.
  double shift = 300.0;  ///< Across the shear.
  double flat = -1000.0;
  bool mirrored = false;
  std::vector<geom::Point> corners{{0, 0}, {200, -350}, {500, -650}, {900, -850}, {1500, -1000}, {9000, -1000}};

  [[nodiscard]] geom::Point axes(geom::Point p) const {
    const double a = shear * pi / 180.0;
    return {p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a)};
  }
  [[nodiscard]] geom::Point back(geom::Point p) const {
    const double a = shear * pi / 180.0;
    return {p.x * std::cos(a) + p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a)};
  }
  [[nodiscard]] double fault_at(double q) const {
    std::size_t i = 0;
    while (i + 2 < corners.size() && axes(corners[i + 1]).x < q) ++i;
    const geom::Point a = axes(corners[i]), b = axes(corners[i + 1]);
    return a.y + (q - a.x) / (b.x - a.x) * (b.y - a.y);
  }
  [[nodiscard]] geom::Point moved(geom::Point p) const {
    const geom::Point at = axes(p);
    return back({at.x + shift, at.y + fault_at(at.x + shift) - fault_at(at.x)});
  }
  [[nodiscard]] geom::Point seen(geom::Point p) const { return {mirrored ? -p.x : p.x, p.y}; }
  /// From the hanging-wall cutoff to `last`, with all its corners: where fault corners stand before or after the shift.
  [[nodiscard]] std::vector<geom::Point> bed(double last) const {
    std::vector<double> xs{0.0, last};
    const double c = std::cos(shear * pi / 180.0);
    for (const geom::Point corner : corners) {
      for (const double q : {axes(corner).x, axes(corner).x - shift}) {
        if (q > 0.0 && q / c < last) xs.push_back(q / c);
      }
    }
    std::sort(xs.begin(), xs.end());
    xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
    std::vector<geom::Point> points;
    for (const double x : xs) points.push_back(seen(moved({x, 0})));
    return points;
  }
  /// The fault from the footwall cutoff to the hanging-wall cutoff.
  [[nodiscard]] std::vector<geom::Point> known() const {
    std::vector<geom::Point> part;
    for (const geom::Point corner : corners) {
      if (axes(corner).x < shift) part.push_back(seen(corner));
    }
    part.push_back(seen(moved({0, 0})));
    return part;
  }
};

class RolloverOver : public testing::TestWithParam<std::pair<double, bool>> {};

TEST_P(RolloverOver, GivesItsFaultAndTheDepthOfItsFlatBack) {
  KnownRollover known;
  known.shear = GetParam().first;
  known.mirrored = GetParam().second;
  const base::Angle shear = deg(known.mirrored ? -known.shear : known.shear);
  const PredictedFault found = fault_under({{known.known(), false}, {known.bed(4000), false}, {}, shear}).value();
  for (const geom::Point p : found.line.points) {
    const geom::Point at = known.axes(known.seen(p));
    EXPECT_NEAR(at.y, known.fault_at(at.x), 1e-6) << p;
  }
  EXPECT_NEAR(found.end_dip.degrees(), 0.0, 1e-9);
  EXPECT_NEAR(found.end.y, known.flat, 1e-6);
  // Over the flat the hanging wall goes level by h = H / cos a; the area that it leaves is h times the depth.
  EXPECT_NEAR(found.shift, known.shift / std::cos(known.shear * pi / 180.0), 1e-9);
  EXPECT_NEAR(found.area_depth, -known.flat, 1e-6);
  EXPECT_NEAR(found.area_place.y, known.flat, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Predict, RolloverOver,
                         testing::Values(std::pair{0.0, false}, std::pair{20.0, false}, std::pair{-20.0, false},
                                         std::pair{0.0, true}, std::pair{25.0, true}));

TEST(Predict, ARolloverThatEndsBeforeTheFlatSaysNoDepthByTheFault) {
  const KnownRollover known;
  const PredictedFault found = fault_under({{known.known(), false}, {known.bed(700), false}, {}, {}}).value();
  EXPECT_GT(found.end_dip.degrees(), 5.0);
}

TEST(Predict, RolloversThatTellNoFaultAreRefusedWithThePlace) {
  const KnownRollover known;
  const auto refused = [](const Rollover& rollover) {
    const auto found = fault_under(rollover);
    EXPECT_FALSE(found);
    EXPECT_TRUE(found || found.error().place);
    return found ? std::string() : found.error().message;
  };
  std::vector<geom::Point> folded = known.bed(4000);
  folded.push_back(folded.back() + geom::Vector{-200, 10});
  EXPECT_NE(refused({{known.known(), false}, {folded, false}, {}, {}}).find("the bed turns back"), std::string::npos);
  EXPECT_NE(refused({{known.known(), false}, {known.bed(100), false}, {}, {}}).find("give a longer part"),
            std::string::npos);
  EXPECT_NE(refused({{{{0, 0}, {0, -100}}, false}, {known.bed(400), false}, {}, {}}).find("on one line of shear"),
            std::string::npos);
}

/// The footwall bed, the rollover and the fault as a section.
section::Section section_of(const KnownRollover& known, double last) {
  section::Section section;
  const double far = known.mirrored ? 2000.0 : -2000.0;
  test::add_horizon("A (1)", {{far, 0}, {0, 0}}, section);
  test::add_horizon("A (2)", known.bed(last), section);
  section.horizons[0].piece_of = section.horizons[1].piece_of = "A";
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "F";
  for (const geom::Point p : known.corners) fault.line.points.push_back(known.seen(p));
  section.lines.push_back(fault);
  return section;
}

std::map<std::string, double> figures(const section::Section& section, const PredictParams& params, std::size_t i = 0) {
  const auto predicted = predict(section, params);
  EXPECT_TRUE(predicted) << predicted.error().message;
  std::map<std::string, double> found;
  if (predicted) found.insert(predicted->solutions.at(i).begin(), predicted->solutions.at(i).end());
  return found;
}

TEST(Predict, AFaultFromTheRolloverOfASectionAgreesWithTheFaultDrawn) {
  for (const bool mirrored : {false, true}) {
    KnownRollover known;
    known.mirrored = mirrored;
    PredictParams params;
    params.what = Prediction::Fault;
    params.fault = "F";
    params.horizon = "A";
    auto found = figures(section_of(known, 6000), params);
    EXPECT_NEAR(found.at("drawn_fault_misfit"), 0.0, 1e-6);
    EXPECT_NEAR(found.at("detachment_by_fault"), -1000.0, 1e-6);
    EXPECT_NEAR(found.at("detachment_by_area"), -1000.0, 1e-6);
  }
}

TEST(Predict, TheAreasLostByTwoBedsTellTheDetachmentAndTheDisplacement) {
  const KnownRollover known;
  section::Section section = section_of(known, 6000);
  // A second bed 300 m lower, by the closed form: its footwall cutoff is where the fault is at -300.
  const double cut = 200.0 * 300.0 / 350.0;
  test::add_horizon("B (1)", {{-2000, -300}, {cut, -300}}, section);
  std::vector<geom::Point> bed;
  for (int i = 0; i <= 600; ++i) bed.push_back(known.moved({cut + 10.0 * i, -300}));
  test::add_horizon("B (2)", bed, section);
  section.horizons[2].piece_of = section.horizons[3].piece_of = "B";
  PredictParams params;
  params.what = Prediction::Fault;
  params.fault = "F";
  params.horizon = "A";
  auto found = figures(section, params);
  EXPECT_NEAR(found.at("detachment_by_area_depth"), -1000.0, 0.5);  // 10 m chords at corners
  EXPECT_NEAR(found.at("displacement_by_area_depth"), 300.0, 0.3);
}

TEST(Predict, ARolloverOverAFaultIsThatOfTheClosedForm) {
  for (const bool mirrored : {false, true}) {
    KnownRollover known;
    known.shear = 20.0;
    known.mirrored = mirrored;
    const geom::Point cutoff = known.moved({0, 0});
    PredictParams params;
    params.what = Prediction::Rollover;
    params.fault = "F";
    params.elevation = 0.0;
    params.heave = -cutoff.x;
    params.angle = deg(mirrored ? -20.0 : 20.0);
    const auto predicted = predict(section_of(known, 4000), params);
    ASSERT_TRUE(predicted) << predicted.error().message;
    const geom::Polyline& bed = predicted->lines.at(0).line;
    EXPECT_NEAR(bed.points.front().y, cutoff.y, 1e-6);
    const std::vector<geom::Point> truth = known.bed(4000);
    for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
      double nearest = 1e9;
      for (std::size_t k = 0; k < bed.segment_count(); ++k)
        nearest = std::min(nearest, geom::distance(bed.segment(k), truth[i]));
      EXPECT_LE(nearest, 1e-6) << truth[i];
    }
  }
}

TEST(Predict, WhatIsMissingOrOfNoUseIsRefused) {
  const section::Section section = section_of({}, 4000);
  const auto refused = [&](const PredictParams& params) {
    const auto found = predict(section, params);
    return found ? std::string() : found.error().message;
  };
  PredictParams params;
  params.what = Prediction::Fault;
  EXPECT_NE(refused(params).find("name the 'fault'"), std::string::npos);
  params.fault = "F";
  EXPECT_NE(refused(params).find("name the 'horizon'"), std::string::npos);
  params.horizon = "B";
  EXPECT_NE(refused(params).find("horizon 'B' has no cutoff on the footwall"), std::string::npos);
  params.backlimb = deg(20);
  EXPECT_NE(refused(params).find("'backlimb' is of no use"), std::string::npos);
  params = {};
  params.what = Prediction::FaultBendFold;
  EXPECT_NE(refused(params).find("give the dip of the backlimb"), std::string::npos);
}

/// How far a bend is from keeping thickness on both sides of its axial plane, by projecting the unit bed: the beds
/// before and behind the plane are its mirror images, and the flux through the plane is kept.
double flux_step(const kinematics::BendFold& fold) {
  const double theta = fold.theta.radians(), gamma = fold.gamma.radians();
  return std::sin(gamma - theta) - fold.slip_ratio * std::sin(gamma - theta + fold.phi.radians());
}

TEST(Predict, ABacklimbHasAnOpenAndATightBendFoldAndBothSolveSuppesEquation) {
  for (const double theta : {5.0, 15.0, 20.0, 28.0}) {
    const auto folds = bend_folds_of({deg(theta), {}}).value();
    ASSERT_EQ(folds.size(), 2U);
    EXPECT_GT(folds[0].gamma.degrees(), folds[1].gamma.degrees());
    for (const kinematics::BendFold& fold : folds) {
      const double g = fold.gamma.radians();
      EXPECT_NEAR(std::tan(theta * pi / 180), std::sin(2 * g) / (2 * std::cos(g) * std::cos(g) + 1), 1e-12);
      EXPECT_NEAR(flux_step(fold), 0.0, 1e-12);
    }
    // By the forelimb each comes back, alone.
    for (const kinematics::BendFold& fold : folds) {
      const auto same = bend_folds_of({{}, deg(180.0 - 2.0 * fold.gamma.degrees())}).value();
      ASSERT_EQ(same.size(), 1U);
      EXPECT_NEAR(same[0].theta.degrees(), theta, 1e-9);
    }
  }
  EXPECT_EQ(bend_folds_of({deg(30), {}}).value().size(), 1U);
  EXPECT_FALSE(bend_folds_of({deg(31), {}}));
  // The table of Suppe (1983).
  EXPECT_NEAR(bend_folds_of({deg(20), {}}).value()[0].gamma.degrees(), 78.420, 5e-4);
}

TEST(Predict, BothDipsGiveTheBendOfTheFaultBySuppesOtherEquation) {
  for (const auto& [theta, phi] : {std::pair{20.0, 12.0}, {15.0, 25.0}, {30.0, 30.0}, {10.0, 60.0}}) {
    const kinematics::BendFold truth = kinematics::bend_fold(deg(theta), deg(phi)).value();
    const auto folds = bend_folds_of({deg(theta), deg(180.0 - 2.0 * truth.gamma.degrees())}).value();
    ASSERT_EQ(folds.size(), 1U);
    EXPECT_NEAR(folds[0].phi.degrees(), phi, 1e-6);
    const double g = folds[0].gamma.radians(), t = theta * pi / 180;
    const double bracket = std::sin(2 * g - t) - std::sin(t);
    const double by_suppe =
        std::atan(-std::sin(g - t) * bracket / (std::cos(g - t) * bracket - std::sin(g))) * 180 / pi;
    EXPECT_NEAR(by_suppe < 0 ? by_suppe + 180 : by_suppe, phi, 1e-6);
  }
  EXPECT_FALSE(bend_folds_of({deg(60), deg(100)}));
}

TEST(Predict, AForelimbGivesTheRampOfAPropagationFoldByTheEquationOfSuppeAndMedwedeff) {
  for (const double forelimb : {61.0, 80.0, 120.0, 150.0}) {
    const auto fold = propagation_fold_of({{}, deg(forelimb)});
    ASSERT_TRUE(fold);
    const double g = (90.0 - 0.5 * forelimb) * pi / 180, t = fold->angles.theta.radians();
    EXPECT_NEAR((1 + 2 * std::cos(g) * std::cos(g)) / std::sin(2 * g) + (std::cos(t) - 2) / std::sin(t), 0.0, 1e-9);
  }
  const auto both = propagation_fold_of({deg(25), deg(110)}).value();
  EXPECT_NEAR(both.angles.propagation, 1.8459, 5e-5);
  EXPECT_NEAR(both.misfit->degrees(), 180.0 - 2.0 * 33.627 - 110.0, 2e-3);
  EXPECT_FALSE(propagation_fold_of({deg(60), {}}));
  EXPECT_FALSE(propagation_fold_of({{}, deg(60)}));
}

}  // namespace
}  // namespace recon::inversion
