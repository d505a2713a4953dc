// The paper's construction: against the engine on closed contours, to the letter on open curves.

#include "shared/offset/stepper/stepper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"
#include "shared/topo/validate.h"

namespace dobra::offset::stepper {
namespace {

using namespace verifier;
using geom::Point;
using geom::Polyline;

double total_length(const OffsetCurve& curve) {
  double sum = 0.0;
  for (const OffsetPiece& piece : curve.pieces) sum += geom::length(Polyline{piece.points, piece.closed});
  return sum;
}

double total_area(const OffsetCurve& curve) {
  double sum = 0.0;
  for (const OffsetPiece& piece : curve.pieces) sum += geom::signed_area(Polyline{piece.points, piece.closed});
  return sum;
}

OffsetCurve engine(const Polyline& base, double d, const OffsetOptions& options) {
  const double distances[] = {d};
  return offset(base, distances, options).value().front();
}

OffsetCurve stepped(const Polyline& base, double d, const OffsetOptions& options) {
  return run_stepper(base, d, options).value();
}

/// Simple, since seen from its middle; teeth and bays as deep as `depth`.
Polyline star(std::uint32_t seed, int n, double depth) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(1.0 - depth, 1.0);
  Polyline made{{}, true};
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    const double r = radius(random);
    made.points.push_back({3.0 + r * std::cos(angle), r * std::sin(angle)});
  }
  return made;
}

/// A band along a wave: two long sides near each other, so that bays close to pockets.
Polyline ribbon(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> real(0.0, 1.0);
  Polyline made{{}, true};
  const double amplitude = 0.5 + real(random);
  const double wide = 0.2 + 0.3 * real(random);
  const double pace = 1.0 + 2.0 * real(random);
  for (int i = 0; i <= 40; ++i)
    made.points.push_back({0.1 * i, amplitude * std::sin(pace * 0.1 * i) + 0.05 * real(random)});
  for (int i = 40; i >= 0; --i)
    made.points.push_back({0.1 * i, amplitude * std::sin(pace * 0.1 * i) + wide + 0.05 * real(random)});
  return made;
}

void expect_same(const Polyline& base, double d, const OffsetOptions& options, const std::string& what) {
  const OffsetCurve mine = stepped(base, d, options);
  const OffsetCurve theirs = engine(base, d, options);
  const double size = 1.0 + total_length(theirs);
  EXPECT_EQ(mine.pieces.size(), theirs.pieces.size()) << what;
  EXPECT_NEAR(total_length(mine), total_length(theirs), 1e-8 * size) << what;
  EXPECT_NEAR(total_area(mine), total_area(theirs), 1e-8 * size) << what;
  for (const OffsetPiece& piece : mine.pieces) EXPECT_TRUE(piece.closed) << what;
}

TEST(Stepper, OFF_c_GivesTheEnginesCurvesOnRandomSimpleContours) {
  std::size_t with_parts = 0;
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    const Polyline base =
        seed % 3 == 2 ? ribbon(seed) : star(seed, 8 + static_cast<int>(seed % 29), seed % 2 == 0 ? 0.5 : 0.85);
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      for (const double d : {0.03, 0.1, 0.22, 0.5}) {
        OffsetOptions options;
        options.side = side;
        if (seed % 5 == 1) options.join = Join::Bisector;
        expect_same(base, d, options,
                    "seed " + std::to_string(seed) + " side " + std::to_string(int(side)) + " d " + std::to_string(d));
        with_parts += engine(base, d, options).pieces.size() > 1 ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(with_parts, 50U);
}

TEST(Stepper, OFF_m_StartAndDirectionOfAContourDoNotMatter) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Polyline base = star(seed, 20, 0.7);
    const OffsetCurve first = stepped(base, 0.15, {});
    for (std::size_t k = 1; k < base.points.size(); k += 3) {
      Polyline turned = base;
      std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(k), turned.points.end());
      const OffsetCurve other = stepped(turned, 0.15, {});
      EXPECT_EQ(first.pieces.size(), other.pieces.size());
      EXPECT_NEAR(total_area(first), total_area(other), 1e-9);
      EXPECT_NEAR(total_length(first), total_length(other), 1e-9);
    }
    OffsetOptions left;
    left.side = Side::LeftOfTravel;
    const OffsetCurve back = stepped(geom::reversed(base), 0.15, left);
    EXPECT_NEAR(total_area(first), -total_area(back), 1e-9);
  }
}

TEST(Stepper, KeepsThePocketThatArmsOfTheBaseClose) {
  // A ring with a slit: from outside at D = 0.5 the slit closes and leaves a pocket in the middle.
  Polyline ring{{}, true};
  const auto arc = [&](double r, int from, int step, int count) {
    for (int i = 0; i < count; ++i) {
      const double a = (from + step * i) * std::numbers::pi / 60.0;
      ring.points.push_back({r * std::cos(a), r * std::sin(a)});
    }
  };
  arc(4.0, 2, 1, 117);
  arc(3.0, 118, -1, 117);
  OffsetOptions outside;
  const OffsetCurve curve = stepped(ring, 0.5, outside);
  ASSERT_EQ(curve.pieces.size(), 2U);
  const double a = geom::signed_area(Polyline{curve.pieces[0].points, true});
  const double b = geom::signed_area(Polyline{curve.pieces[1].points, true});
  EXPECT_LT(a * b, 0.0);
  EXPECT_NEAR(std::max(a, b), std::numbers::pi * 4.5 * 4.5, 0.2);
  EXPECT_NEAR(std::min(a, b), -std::numbers::pi * 2.5 * 2.5, 0.2);
  expect_same(ring, 0.5, outside, "ring");
}

TEST(Stepper, OFF_d_LeavesTheTailThatThePapersRuleLeavesAtAnOpenEnd) {
  Polyline wave{{}, false};
  for (int i = 0; i <= 128; ++i) {
    const double x = 4.0 * std::numbers::pi * i / 128.0;
    wave.points.push_back({x, std::sin(x)});
  }
  for (const auto& [d, nearest] : {std::pair{2.4, 1.58}, {2.6, 1.62}}) {
    const OffsetCurve curve = stepped(wave, d, {});
    ASSERT_EQ(curve.pieces.size(), 1U);
    double least = d;
    for (const Point p : curve.pieces[0].points) least = std::min(least, geom::distance(wave, p));
    EXPECT_NEAR(least, nearest, 0.01);
  }
}

TEST(Stepper, IsATreeAfterEveryStepOfAnOpenCurveAndSoundAfterAll) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    Polyline walk{{{0, 0}}, false};
    double heading = 0.0;
    for (int i = 0; i < 60; ++i) {
      heading += 0.9 * real(random);
      walk.points.push_back(walk.points.back() + geom::Vector{0.3 * std::cos(heading), 0.3 * std::sin(heading)});
    }
    Stepper stepper = Stepper::start(walk, 0.6, {}).value();
    while (!stepper.done()) {
      const Stepper::Step step = stepper.step().value();
      EXPECT_EQ(step.deleted.size(), step.deleted_edges.size());
      EXPECT_EQ(stepper.subdivision().face_count(), 1U);
      EXPECT_EQ(stepper.subdivision().component_count(), 1U);
    }
    for (const std::string& wrong : topo::violations(stepper.subdivision())) ADD_FAILURE() << wrong;
    EXPECT_LE(stepper.result().pieces.size(), 1U);
  }
}

/// Raw edges that start or run on earlier ones but for rounding: unless the region closes at once, what comes later is
/// rounded to the same place, and edges stay that run against their base.
TEST(Stepper, RegionsCloseWhereTheCurveTouchesItselfButForRounding) {
  const Polyline twice{{{0, 0}, {13, 6}, {-2, 0}, {4, 0}, {0, 0}, {13, 6}, {-2, 8}, {4, -14}}, false};
  for (const Side side : {Side::LeftOfTravel, Side::RightOfTravel}) {
    for (const Join join : {Join::Mitre, Join::Bevel, Join::Round}) {
      OffsetOptions options{.side = side, .join = join};
      options.mitre_limit = 1.0;
      options.ends = Ends::Paper;
      const auto verified = verify(twice, options, engine(twice, 0.5, options));
      ASSERT_TRUE(verified.ok());
      EXPECT_TRUE(verified->ok()) << to_string(verified->findings.front());
    }
  }
}

}  // namespace
}  // namespace dobra::offset::stepper
