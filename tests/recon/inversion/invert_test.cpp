#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <fstream>

#include "recon/inversion/trishear_fit.h"
#include "shared/base/parallel.h"
#include "tests/recon/inversion/folded_beds.h"
#include "tests/support/corpus.h"

namespace recon::inversion {
namespace {

using test::KnownTrishear;

Fit fit_of(const section::Section& section, const InvertParams& params) {
  auto found = invert(section, params, {});
  EXPECT_TRUE(found) << found.error().message;
  return found ? found->fit : Fit{};
}

std::string refusal(const section::Section& section, const InvertParams& params) {
  const auto found = invert(section, params, {});
  return found ? std::string() : found.error().message;
}

void expect_known(const Fit& fit, const KnownTrishear& known, double tolerance) {
  const std::array<std::pair<const char*, double>, 6> truth{{{"tip_x", known.tip.x},
                                                             {"tip_z", known.tip.y},
                                                             {"ramp", known.ramp},
                                                             {"propagation", known.propagation},
                                                             {"apical", known.apical},
                                                             {"slip", known.slip}}};
  for (const auto& [key, value] : truth)
    EXPECT_NEAR(test::estimate(fit, key).best, value, tolerance * std::abs(value)) << key;
}

TEST(Invert, BedsFoldedByTrishearGiveItsValuesBack) {
  const KnownTrishear known;
  const Fit fit = fit_of(test::folded_beds(known, {200, 350, 500}, 41), test::limits_about(known));
  expect_known(fit, known, 1e-4);
  EXPECT_LE(fit.rms, 1e-4);
  for (const BedMisfit& bed : fit.beds) EXPECT_NEAR(bed.dip.degrees(), 0.0, 1e-4) << bed.name;
}

TEST(Invert, OverturnedBedsAndFoldsTowardsMinusXAreFoundToo) {
  const KnownTrishear known{{900, 420}, 142, 1.4, 35, 500};
  const section::Section section = test::folded_beds(known, {150, 300}, 61);
  bool overturned = false;
  for (const section::Horizon& bed : section.horizons) {
    for (std::size_t i = 1; i < bed.line.points.size(); ++i)
      overturned = overturned || bed.line.points[i].x < bed.line.points[i - 1].x;
  }
  ASSERT_TRUE(overturned);
  expect_known(fit_of(section, test::limits_about(known)), known, 1e-4);
}

TEST(Invert, TheKnownValuesOfNoisyBedsLieWithinTheLimitsOfConfidence) {
  const KnownTrishear known;
  InvertParams params = test::limits_about(known);
  params.generations = 30;
  const Fit fit = fit_of(test::folded_beds(known, {200, 350, 500}, 41, 1.5), params);
  EXPECT_NEAR(fit.rms, 1.5, 0.3);
  ASSERT_TRUE(fit.region);
  for (const auto& [key, value] : {std::pair{"tip_x", known.tip.x},
                                   {"tip_z", known.tip.y},
                                   {"ramp", known.ramp},
                                   {"propagation", known.propagation},
                                   {"apical", known.apical},
                                   {"slip", known.slip}}) {
    const Estimate& one = test::estimate(fit, key);
    EXPECT_LE(one.low.value_or(one.unknown.low), value) << key;
    EXPECT_GE(one.high.value_or(one.unknown.high), value) << key;
  }
  // And the limits are limits: they are narrower than those of the search, and wider than nothing.
  const Estimate& slip = test::estimate(fit, "slip");
  ASSERT_TRUE(slip.low && slip.high);
  EXPECT_GT(*slip.high - *slip.low, 0.1);
}

TEST(Invert, LimitsThatExcludeTheTruthAreNamed) {
  const KnownTrishear known;
  InvertParams params = test::limits_about(known);
  params.ramp = {35, 60};
  params.tip_x = {known.tip.x};
  params.tip_z = {known.tip.y};
  const Fit fit = fit_of(test::folded_beds(known, {200, 400}, 31), params);
  EXPECT_EQ(test::estimate(fit, "ramp").at_limit, AtLimit::Low);
  EXPECT_EQ(test::estimate(fit, "ramp").best, 35.0);
  EXPECT_TRUE(test::tells(fit.remarks, "the best ramp lies at a limit of the search, 35 deg"));
}

TEST(Invert, ADrawnFaultGivesTipAndRampAndItsUpperEndIsTakenForTheTipWhereItLeavesTheSection) {
  const KnownTrishear known;
  section::Section section = test::folded_beds(known, {200, 400}, 31);
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "ramp";
  const double angle = known.ramp * std::numbers::pi / 180.0;
  fault.line.points = {known.tip - 1500.0 * geom::Vector{std::cos(angle), std::sin(angle)}, known.tip};
  section.lines.push_back(fault);
  InvertParams params = test::limits_about(known);
  params.tip_x = params.tip_z = params.ramp = {};
  params.fault = "ramp";
  const Fit fit = fit_of(section, params);
  EXPECT_TRUE(test::estimate(fit, "tip_x").unknown.fixed() && test::estimate(fit, "ramp").unknown.fixed());
  expect_known(fit, known, 1e-4);
  EXPECT_FALSE(test::tells(invert(section, params, {})->remarks, "taken for its tip"));
  // As `move` has it, with the same remark.
  const geom::Point far = known.tip + 1500.0 * geom::Vector{std::cos(angle), std::sin(angle)};
  section.lines[0].line.points.back() = far;
  params.generations = 5;
  const auto taken = invert(section, params, {});
  ASSERT_TRUE(taken) << taken.error().message;
  EXPECT_NEAR(test::estimate(taken->fit, "tip_x").best, far.x, 1e-9);
  EXPECT_NEAR(test::estimate(taken->fit, "ramp").best, known.ramp, 1e-9);
  EXPECT_TRUE(test::tells(taken->remarks, "fault 'ramp' leaves the section at"));
}

TEST(Invert, BeddingHoldsTheDirectionOfTheRestoredBeds) {
  const KnownTrishear known;
  const section::Section section = test::folded_beds(known, {200, 400}, 31);
  InvertParams params = test::limits_about(known);
  params.tip_x = {known.tip.x};
  params.tip_z = {known.tip.y};
  params.bedding = base::Angle::from_degrees(0);
  expect_known(fit_of(section, params), known, 1e-4);
  params.bedding = base::Angle::from_degrees(5);
  const Fit tilted = fit_of(section, params);
  EXPECT_GT(tilted.rms, 1.0);
  for (const BedMisfit& bed : tilted.beds) EXPECT_NEAR(bed.dip.degrees(), 5.0, 1e-9);
}

/// Two pieces of one bed on both sides of a straight fault that dips 45 degrees to +x; the hanging wall, to the right,
/// is down by `slip` along it.
section::Section cut_by_a_plane(double slip) {
  const double d = slip / std::sqrt(2.0);
  section::Section section;
  std::vector<geom::Point> foot, hanging;
  for (int i = 0; i <= 20; ++i) {
    foot.push_back({-1000.0 + 50.0 * i, 0});
    hanging.push_back({d + 50.0 * i, -d});
  }
  test::add_horizon("A (1)", foot, section);
  test::add_horizon("A (2)", hanging, section);
  section.horizons[0].piece_of = section.horizons[1].piece_of = "A";
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "F";
  fault.line.points = {{-800, 800}, {1000, -1000}};
  section.lines.push_back(fault);
  return section;
}

TEST(Invert, ShearOverAPlaneTellsTheSlipAndThatNothingTellsTheAngle) {
  InvertParams params;
  params.method = InvertMethod::Shear;
  params.fault = "F";
  params.angle = {-30, 40};
  params.slip = {-500, 100};
  const Fit fit = fit_of(cut_by_a_plane(200), params);
  EXPECT_NEAR(test::estimate(fit, "slip").best, -200.0, 1e-3);
  EXPECT_TRUE(test::estimate(fit, "slip").low && test::estimate(fit, "slip").high);
  EXPECT_FALSE(test::estimate(fit, "angle").low || test::estimate(fit, "angle").high);
  EXPECT_TRUE(test::tells(fit.remarks, "the beds do not determine angle"));
}

TEST(Invert, TheAngleOfShearOverAListricFaultComesBack) {
  // Hanging wall of z = -1000 (1 - exp(-x / 800)), pulled 300 m to +x by shear at 20 degrees; the closed form.
  constexpr double angle = 20.0 * std::numbers::pi / 180.0;
  section::Section section;
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "listric";
  for (int i = 0; i <= 80; ++i)
    fault.line.points.push_back({50.0 * i - 200, -1000.0 * (1.0 - std::exp(-(50.0 * i - 200) / 800.0))});
  section.lines.push_back(fault);
  const std::vector<geom::Point>& f = fault.line.points;
  const auto q_of = [&](geom::Point p) { return p.x * std::cos(angle) - p.y * std::sin(angle); };
  const auto w_of = [&](geom::Point p) { return p.x * std::sin(angle) + p.y * std::cos(angle); };
  const auto fault_at = [&](double q) {
    std::size_t i = 0;
    while (i + 2 < f.size() && q_of(f[i + 1]) < q) ++i;
    const double t = (q - q_of(f[i])) / (q_of(f[i + 1]) - q_of(f[i]));
    return w_of(f[i]) + t * (w_of(f[i + 1]) - w_of(f[i]));
  };
  for (const double height : {0.0, -200.0}) {
    std::vector<geom::Point> bed;
    for (int i = 0; i <= 40; ++i) {
      const geom::Point p{400.0 + 60.0 * i, height};
      const double q = q_of(p) + 300.0 * std::cos(angle);
      const double w = w_of(p) + fault_at(q) - fault_at(q_of(p));
      bed.push_back({q * std::cos(angle) + w * std::sin(angle), -q * std::sin(angle) + w * std::cos(angle)});
    }
    test::add_horizon(height == 0.0 ? "top" : "bottom", bed, section);
  }
  InvertParams params;
  params.method = InvertMethod::Shear;
  params.fault = "listric";
  params.angle = {-40, 50};
  params.slip = {-800, -50};
  const Fit fit = fit_of(section, params);
  EXPECT_NEAR(test::estimate(fit, "angle").best, 20.0, 2e-3);
  EXPECT_LE(fit.rms, 1e-3);
  for (const BedMisfit& bed : fit.beds) EXPECT_NEAR(bed.dip.degrees(), 0.0, 1e-3);
}

TEST(Invert, BedsThatReachPastTheFaultAreTakenToIt) {
  // The same fault, vertical shear; each bed begins 0.5 m behind the fault.
  const auto height = [](double x) { return -1000.0 * (1.0 - std::exp(-x / 800.0)); };
  section::Section section;
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "listric";
  for (int i = 0; i <= 400; ++i) fault.line.points.push_back({10.0 * i - 200, height(10.0 * i - 200)});
  section.lines.push_back(fault);
  for (const double z : {-100.0, -300.0}) {
    const double start = -800.0 * std::log(1.0 + z / 1000.0);
    std::vector<geom::Point> bed;
    for (int i = 0; i <= 80; ++i) {
      const double x = start + 30.0 * i;
      bed.push_back({x + 300.0, z + height(x + 300.0) - height(x)});
    }
    bed.insert(bed.begin(), bed[0] + 0.5 * geom::normalised(bed[0] - bed[1]));
    test::add_horizon(z == -100.0 ? "top" : "bottom", bed, section);
  }
  InvertParams params;
  params.method = InvertMethod::Shear;
  params.fault = "listric";
  params.angle = {-40, 50};
  params.slip = {-600, -100};
  const Fit fit = fit_of(section, params);
  EXPECT_NEAR(test::estimate(fit, "angle").best, 0.0, 0.1);
}

TEST(Invert, StraightBedsAndBedsTooShortAreRefused) {
  section::Section straight;
  test::add_horizon("A", {{0, 0}, {500, 50}, {1000, 100}, {2000, 200}}, straight);
  EXPECT_NE(refusal(straight, {}).find("the beds are straight as they are"), std::string::npos);
  section::Section two;
  test::add_horizon("A", {{0, 0}, {500, 50}}, two);
  EXPECT_NE(refusal(two, {}).find("horizon 'A' has 2 points"), std::string::npos);
  section::Section few;
  test::add_horizon("A", {{0, 0}, {500, 50}, {900, 40}, {1000, 0}, {1400, 30}}, few);
  EXPECT_NE(refusal(few, {}).find("the beds have 5 points, which do not determine 6 values"), std::string::npos);
  EXPECT_NE(refusal({}, {}).find("no horizon"), std::string::npos);
}

TEST(Invert, WhatTheMethodHasNoUseForAndLimitsThatAreNoneAreRefused) {
  const section::Section section = test::folded_beds({}, {200}, 31);
  InvertParams params;
  params.angle = {10};
  EXPECT_NE(refusal(section, params).find("'angle' is of shear"), std::string::npos);
  params = {};
  params.slip = {300, 100};
  EXPECT_NE(refusal(section, params).find("the lesser one first, not [300, 100]"), std::string::npos);
  params = {};
  params.map = {"apical", "concentration"};
  EXPECT_NE(refusal(section, params).find("'map' takes two different values of those that are sought"),
            std::string::npos);
  params = {};
  params.horizon = {"bed 2"};
  EXPECT_NE(refusal(section, params).find("no horizon 'bed 2'"), std::string::npos);
  params = {};
  params.method = InvertMethod::Shear;
  EXPECT_NE(refusal(section, params).find("name it as 'fault'"), std::string::npos);
}

TEST(Invert, EveryNumberIsTheSameAtOneThreadAndAtTwo) {
  const KnownTrishear known;
  const section::Section section = test::folded_beds(known, {250, 400}, 25, 3.0);
  InvertParams params = test::limits_about(known);
  params.tip_x = {known.tip.x};
  params.tip_z = {known.tip.y};
  params.generations = 15;
  params.map = {"propagation", "apical"};
  params.map_points = 4;
  std::array<std::vector<double>, 2> numbers;
  for (std::size_t i = 0; i < 2; ++i) {
    base::set_thread_count(i + 1);
    const Inversion found = invert(section, params, {}).value();
    for (const Estimate& one : found.fit.estimates)
      numbers[i].insert(numbers[i].end(), {one.best, one.low.value_or(0), one.high.value_or(0)});
    numbers[i].push_back(found.fit.rms);
    numbers[i].insert(numbers[i].end(), found.map->rms.begin(), found.map->rms.end());
  }
  base::set_thread_count(0);
  ASSERT_EQ(numbers[0].size(), numbers[1].size());
  EXPECT_EQ(std::memcmp(numbers[0].data(), numbers[1].data(), numbers[0].size() * sizeof(double)), 0);
}

TEST(Invert, TheMapHasItsLeastWhereTheBestLies) {
  const KnownTrishear known;
  InvertParams params = test::limits_about(known);
  params.tip_x = {known.tip.x};
  params.tip_z = {known.tip.y};
  params.propagation = {1.0, 3.0};
  params.apical = {40.0, 60.0};
  params.map = {"propagation", "apical"};
  params.map_points = 5;
  const Inversion found = invert(test::folded_beds(known, {200, 400}, 31), params, {}).value();
  ASSERT_EQ(found.map->rms.size(), 25U);
  const auto least = std::min_element(found.map->rms.begin(), found.map->rms.end()) - found.map->rms.begin();
  EXPECT_EQ(least, 12);  // P/S 2, 50 degrees: the middle
  EXPECT_LE(found.map->rms[12], 1e-2);
}

TEST(Invert, CancelStopsTheSearch) {
  const base::CancelToken token;
  const base::Progress progress(token, [&](double fraction, const std::string&) {
    if (fraction > 0.1) token.cancel();
  });
  const auto found = invert(test::folded_beds({}, {200, 400}, 31), test::limits_about({}), progress);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, base::ErrorCode::Cancelled);
}

section::Section catskill(const std::filesystem::path& folder, const std::vector<int>& beds) {
  section::Section section;
  for (const int bed : beds) {
    std::ifstream in(folder / "sections" / "catskill_fpf" / ("bed" + std::to_string(bed) + ".txt"));
    std::vector<geom::Point> points;
    for (geom::Point p; in >> p.x >> p.y;) points.push_back({p.x, 400.0 - p.y});
    test::add_horizon("bed" + std::to_string(bed), std::move(points), section);
  }
  return section;
}

constexpr std::array<double, 7> published{260, 185, 35, 2.4, 36, 290, 1};

TEST(Invert, CatskillFitsBetterThanByThePublishedValuesWhichLieInTheRegionOfConfidence) {
  const auto folder = dobra::test::data_folder();
  if (!folder) GTEST_SKIP() << dobra::test::no_data;
  const section::Section section = catskill(*folder, {6});
  InvertParams params;
  params.tip_x = {200, 300};
  params.tip_z = {150, 250};
  params.ramp = {20, 50};
  params.propagation = {1, 4};
  params.apical = {15, 70};
  params.slip = {100, 400};
  params.generations = 40;
  const Fit fit = fit_of(section, params);
  const auto beds = bed_shapes(section, {}).value();
  const double theirs = misfit_of(beds, trishear_model(500.0), published, {}).value();
  EXPECT_LE(fit.rms, theirs);
  ASSERT_TRUE(fit.region);
  EXPECT_LE(theirs, *fit.region);
  for (std::size_t i = 0; i < 6; ++i) {
    const Estimate& one = fit.estimates[i];
    EXPECT_LE(one.low.value_or(one.unknown.low), published[i]) << one.unknown.key;
    EXPECT_GE(one.high.value_or(one.unknown.high), published[i]) << one.unknown.key;
  }
}

TEST(Invert, ThePublishedValuesOfCatskillLieInTheRegionWithLimitsMadeFromTheBoxToo) {
  const auto folder = dobra::test::data_folder();
  if (!folder) GTEST_SKIP() << dobra::test::no_data;
  const section::Section section = catskill(*folder, {6});
  InvertParams params;
  params.ramp = {5, 85};
  params.generations = 30;
  const Fit fit = fit_of(section, params);
  const double theirs = misfit_of(bed_shapes(section, {}).value(), trishear_model(500.0), published, {}).value();
  EXPECT_LE(fit.rms, 0.5 * theirs);
  EXPECT_LE(theirs, *fit.region);
  EXPECT_LT(*fit.region, 0.5 * fit.before);  // and yet the fold is told from none
}

}  // namespace
}  // namespace recon::inversion
