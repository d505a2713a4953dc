#include "recon/kinematics/trishear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "tests/recon/kinematics/draws.h"
#include "tests/support/corpus.h"

namespace recon::kinematics {
namespace {

using test::degrees;

struct Case {
  geom::Point tip;
  double ramp, apical, propagation, concentration, slip;  ///< Ramp and apical angle in degrees.
};

geom::Vector direction_of(const Case& one) {
  return {std::cos(degrees(one.ramp).radians()), std::sin(degrees(one.ramp).radians())};
}

BlockMap map_of(const Case& one) {
  const TrishearParams params{degrees(one.apical), one.propagation, one.concentration};
  return BlockMap(TrishearMap::make(one.tip, direction_of(one), Side::Left, one.slip, params).value());
}

/// The raw field in tip coordinates, a metre of slip.
geom::Vector field(double x, double y, double m, double s, double sense) {
  if (x > 0.0 && std::abs(y) < m * x) {
    const double e = std::abs(y) / (m * x);
    const double root = std::pow(e, 1.0 / s);
    const double vx = 0.5 * sense * ((y > 0.0 ? root : y < 0.0 ? -root : 0.0) + 1.0);
    return {vx, 0.5 * sense * m / (1.0 + s) * (std::pow(e, (1.0 + s) / s) - 1.0)};
  }
  return y >= 0.0 ? geom::Vector{sense, 0.0} : geom::Vector{};
}

/// Classical Runge-Kutta steps of the raw field in the section's frame, the tip going on.
geom::Point by_small_steps(const Case& one, geom::Point p, int steps) {
  const geom::Vector along = direction_of(one);
  const geom::Vector out = geom::left_of(along);
  const double m = std::tan(degrees(0.5 * one.apical).radians());
  const double h = std::abs(one.slip) / steps;
  const double sense = one.slip < 0.0 ? -1.0 : 1.0;
  double x = geom::dot(p - one.tip, along);
  double y = geom::dot(p - one.tip, out);
  const auto rate = [&](double a, double b, double t) {
    return field(a - one.propagation * t, b, m, one.concentration, sense);
  };
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    const geom::Vector a = rate(x, y, t);
    const geom::Vector b = rate(x + 0.5 * h * a.x, y + 0.5 * h * a.y, t + 0.5 * h);
    const geom::Vector c = rate(x + 0.5 * h * b.x, y + 0.5 * h * b.y, t + 0.5 * h);
    const geom::Vector d = rate(x + h * c.x, y + h * c.y, t + h);
    x += h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x);
    y += h / 6.0 * (a.y + 2.0 * b.y + 2.0 * c.y + d.y);
  }
  return one.tip + x * along + y * out;
}

TEST(Trishear, APointOfKnownEndGoesThere) {
  Case one{{1000, 0}, 30, 60, 2, 1, 400};
  test::expect_near(map_of(one).forward(geom::Point{1500, 500}), {1807.10441635, 644.61474701}, 2e-8);
  one.concentration = 2.0;
  test::expect_near(map_of(one).forward(geom::Point{1500, 500}), {1824.13795175, 668.92490862}, 1e-6);
}

TEST(Trishear, PointsEndWhereSmallStepsOfTheRawFieldTakeThem) {
  test::Draws draws(51);
  for (int i = 0; i < 24; ++i) {
    const double concentrations[] = {0.5, 1.0, 2.0, 3.0};
    const double propagations[] = {0.0, 0.6, 1.0, 2.5};
    const Case one{{0, 0},
                   draws.in(-20, 60),
                   draws.in(20, 120),
                   propagations[(i / 4) % 4],
                   concentrations[i % 4],
                   i % 5 == 0 ? -300.0 : 300.0};
    const geom::Point p = one.tip + draws.in(100, 1200) * direction_of(one) + geom::Vector{0.0, draws.in(-200, 400)};
    // Steps over the sides of the zone, and over its middle, where the field is not smooth, cost them digits.
    test::expect_near(map_of(one).forward(p), by_small_steps(one, p, 4000), 2e-4);
  }
}

TEST(Trishear, WhatTheFieldKeepsInTheFrameOfTheTipIsKept) {
  // With s = 1 the stream function in that frame is x g(y / (m x)): no step of any integration goes into this.
  test::Draws draws(52);
  const Case one{{0, 0}, 0, 70, 1.7, 1, 350};
  const double m = std::tan(degrees(35).radians());
  const BlockMap map = map_of(one);
  const auto stream = [&](geom::Point p, double tip) {
    const double x = p.x - tip;
    const double e = p.y / (m * x);
    return std::abs(e) < 1.0 && x > 0.0 ? x * (0.25 * e * e + 0.5 * e + 0.25 - one.propagation * e) : std::nan("");
  };
  int kept = 0;
  for (int i = 0; i < 400; ++i) {
    const geom::Point p = draws.in_box({50, -400}, {1500, 600});
    const double before = stream(p, 0.0);
    const double after = stream(map.forward(p), one.propagation * one.slip);
    if (std::isnan(before) || std::isnan(after)) continue;
    EXPECT_NEAR(after, before, 1e-9);
    ++kept;
  }
  EXPECT_GT(kept, 100);
}

TEST(Trishear, DetFIsOneAtPoints) {
  test::Draws draws(53);
  for (const double s : {0.5, 1.0, 2.0, 3.0}) {
    for (const double propagation : {0.0, 0.7, 1.0, 3.0}) {
      const Case one{{0, 0}, 25, 60, propagation, s, 300};
      const BlockMap map = map_of(one);
      for (int i = 0; i < 6; ++i) {
        // Inside the triangle to begin with, away from its sides and its middle.
        const double x = draws.in(800, 1500);
        const double e = draws.in(0.25, 0.8);
        const geom::Vector along = direction_of(one);
        const geom::Point p = one.tip + x * along + (e * x * std::tan(degrees(30).radians())) * geom::left_of(along);
        const double determinant = map.gradient(p).determinant();
        EXPECT_NEAR(determinant, 1.0, 1e-9) << s << ' ' << propagation << ' ' << p;
      }
    }
  }
}

TEST(Trishear, AreasOfPolygonsComeOutAtSecondOrder) {
  const BlockMap map = map_of({{0, 0}, 30, 60, 1.5, 1, 400});
  const auto off = [&](int parts) {
    geom::Polyline ring{{}, true};
    const geom::Point corners[] = {{800, 100}, {1900, 400}, {1700, 1700}, {850, 1100}};
    for (int side = 0; side < 4; ++side) {
      for (int k = 0; k < parts; ++k) {
        ring.points.push_back(geom::interpolate(corners[side], corners[(side + 1) % 4], double(k) / parts));
      }
    }
    geom::Polyline image = ring;
    for (geom::Point& p : image.points) p = map.forward(p);
    return std::abs(geom::signed_area(image) / geom::signed_area(ring) - 1.0);
  };
  EXPECT_LT(off(160), off(10) / 200.0);
  EXPECT_LT(off(640), 2e-9);
}

TEST(Trishear, LinesAreTrueToTheChordTolerance) {
  TrishearTolerances tolerances;
  tolerances.chord = 0.01;
  const TrishearParams params{degrees(60), 1.5, 1.0};
  const TrishearMap map = TrishearMap::make({0, 0}, {1, 0}, Side::Left, 400, params, tolerances).value();
  const MovedLine bed = map.line({{{-1000, 300}, {3000, 300}}, false});
  ASSERT_EQ(bed.before.points.size(), bed.after.points.size());
  EXPECT_GT(bed.before.points.size(), 20U);
  EXPECT_LT(bed.before.points.size(), 2000U);
  double worst = 0.0;
  for (int i = 0; i <= 3000; ++i) {
    worst = std::max(worst, geom::distance(bed.after, map(geom::Point{-1000.0 + i * 4000.0 / 3000, 300})));
  }
  EXPECT_LE(worst, 0.03);
}

TEST(Trishear, RestoringIsTheInverseForRandomParametersAndPoints) {
  test::Draws draws(54);
  double worst = 0.0;
  int on_fault = 0;
  for (int i = 0; i < 10000; ++i) {  // one point each: integration is dear
    const double concentrations[] = {1.0, 0.5, 2.0, 1.0, 3.0};
    const Case one{{draws.in(-500, 500), draws.in(-500, 500)},
                   draws.in(-60, 60),
                   draws.in(15, 140),
                   draws.in(0, 4),
                   concentrations[i % 5],
                   draws.in(-500, 500)};
    const BlockMap map = map_of(one);
    const BlockMap back = map.swapped();
    geom::Point p = one.tip + geom::Vector{draws.in(-1500, 1500), draws.in(-1500, 1500)};
    const Wall wall = i % 2 == 0 ? Wall::Hanging : Wall::Foot;
    // On the fault; where the tip is slower than the hanging wall, that comes to lie in the other wall.
    if (i % 12 < 2 && (one.propagation > 1.0 || one.slip < 0.0)) {
      p = one.tip - draws.in(0, 300) * direction_of(one);
      ++on_fault;
    }
    worst = std::max(worst, geom::distance(back.forward(map.forward(p, wall), wall), p));
  }
  EXPECT_GT(on_fault, 1000);
  EXPECT_LE(worst, 1e-9 * 1000.0);
}

TEST(Trishear, TheFootwallBehindTheTipStaysAndTheHangingWallSlips) {
  const Case one{{0, 0}, 0, 60, 2, 1, 100};
  const BlockMap map = map_of(one);
  test::expect_near(map.forward(geom::Point{-500, -1}), {-500, -1}, 1e-12);
  test::expect_near(map.forward(geom::Point{-500, 1}), {-400, 1}, 1e-10);
  test::expect_near(map.forward(geom::Point{-500, 0}, Wall::Foot), {-500, 0}, 1e-9);
  test::expect_near(map.forward(geom::Point{-500, 0}, Wall::Hanging), {-400, 0}, 1e-9);
  EXPECT_EQ(map.tip()->after, geom::Point(200, 0));
  EXPECT_EQ(map.swapped().tip()->after, geom::Point(0, 0));
}

TEST(Trishear, BothCutoffsOfABedThatTheTipCutComeBackTogether) {
  // With P/S 2 and s = 1 the ray y = (3 - 2 sqrt 2) m x goes straight to the tip, which cuts what lies on it.
  const Case one{{0, 0}, 30, 50, 2, 1, 300};
  const BlockMap map = map_of(one);
  const geom::Vector along = direction_of(one);
  const geom::Vector up = geom::left_of(along);
  const double ray = (3.0 - 2.0 * std::sqrt(2.0)) * std::tan(degrees(25).radians());
  const geom::Point bed = one.tip + 250.0 * (along + ray * up);
  const geom::Point hanging = map.forward(bed + 1e-5 * up);
  const geom::Point foot = map.forward(bed - 1e-5 * up);
  EXPECT_GT(geom::distance(hanging, foot), 100.0);
  EXPECT_NEAR(geom::dot(hanging - one.tip, up), 0.0, 0.1);
  EXPECT_NEAR(geom::dot(foot - one.tip, up), 0.0, 0.1);
  test::expect_near(map.inverse(hanging), bed, 2e-5);
  test::expect_near(map.inverse(foot), bed, 2e-5);
}

/// Every fourth point of a bed of the Catskill section, restored with the parameters published for bed 6; the sum of
/// its squared distances from its line across the fault, m2, and the slope of that against the fault, degrees.
std::array<double, 2> restored_catskill_bed(const std::filesystem::path& file) {
  const geom::Vector along = direction_of({{}, 35, 0, 0, 0, 0});
  const FaultPath path = test::fault({geom::Point{260, 185} - 2000.0 * along, {260, 185}});
  const TrishearMap map = trishear(path, 290, {degrees(36), 2.4, 1.0}, DrawnTip::After).value().swapped();
  std::ifstream in(file);
  geom::Point p;
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (int i = 0; in >> p.x >> p.y; ++i) {
    if (i % 4 != 0) continue;
    const geom::Vector v = map(geom::Point{p.x, 400.0 - p.y}) - geom::Point{260, 185};
    const double x = geom::dot(v, along);
    const double y = geom::cross(along, v);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
  }
  sxx -= sx * sx / n, sxy -= sx * sy / n, syy -= sy * sy / n;
  const double slope = sxy / sxx;
  return {syy - slope * sxy, std::atan(slope) * 180.0 / std::numbers::pi};
}

TEST(Trishear, ThePublishedParametersStraightenTheBedsOfCatskill) {
  const auto folder = dobra::test::data_folder();
  if (!folder) GTEST_SKIP() << dobra::test::no_data;
  const double misfits[] = {3608.67, 1391, 415, 2119, 1053, 764};
  for (int bed = 1; bed <= 6; ++bed) {
    const auto file = *folder / "sections" / "catskill_fpf" / ("bed" + std::to_string(bed) + ".txt");
    const std::array<double, 2> line = restored_catskill_bed(file);
    EXPECT_NEAR(line[0], misfits[bed - 1], 0.51) << "bed " << bed;
    if (bed == 6) {
      EXPECT_NEAR(line[1], -35.06, 0.005);
    }
  }
}

TEST(Trishear, ADrawnTipIsTheOneBeforeOrTheOneAfter) {
  const TrishearParams params{degrees(60), 1.5, 1.0};
  const FaultPath path = test::fault({{0, 0}, {1000, 0}});
  EXPECT_EQ(trishear(path, 200, params, DrawnTip::Before).value().tip().after, geom::Point(1300, 0));
  EXPECT_EQ(trishear(path, 200, params, DrawnTip::After).value().tip().before, geom::Point(700, 0));
  // A tip at the lower end: the hanging wall comes down along the fault, and the tip goes down with it.
  FaultPath down = test::fault({{0, -1000}, {1000, 0}}, Side::Right);
  down.tip_at_begin = true;
  const TrishearMap map = trishear(down, -100, params, DrawnTip::Before).value();
  EXPECT_LT(map.tip().after.y, -1000.0);
  const geom::Point p = map(geom::Point{1000, -200});
  test::expect_near(p, {1000 - 100 / std::sqrt(2.0), -200 - 100 / std::sqrt(2.0)}, 1e-9);
}

TEST(Trishear, BadParametersAndABendTooNearAreRefusedWithThePlace) {
  const FaultPath path = test::fault({{0, 0}, {1000, 0}, {1200, 100}});
  const auto bent = trishear(path, 300, {degrees(60), 1.5, 1.0}, DrawnTip::Before);
  ASSERT_FALSE(bent);
  EXPECT_EQ(bent.error().place->x, 1000.0);
  EXPECT_NE(bent.error().message.find("bends here"), std::string::npos);
  EXPECT_FALSE(TrishearMap::make({}, {1, 0}, Side::Left, 1, {degrees(180), 1, 1}));
  EXPECT_FALSE(TrishearMap::make({}, {1, 0}, Side::Left, 1, {degrees(60), -1, 1}));
  EXPECT_FALSE(TrishearMap::make({}, {1, 0}, Side::Left, 1, {degrees(60), 1, 0}));
}

}  // namespace
}  // namespace recon::kinematics
