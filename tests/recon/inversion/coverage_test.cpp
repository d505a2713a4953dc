// How often the truth lies in the region and between the limits of confidence when the errors of neighbouring points
// hang together: brute force over seeds, on a model of two values whose distances are known functions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/inversion/fit.h"
#include "shared/base/counter_random.h"

namespace recon::inversion {
namespace {

constexpr double length = 2000.0;
constexpr double true_a = 60.0, true_b = -25.0;

double shape(double x, double a, double b) {
  return 4.0 * a * x * (1.0 - x) + b * std::sin(2.0 * std::numbers::pi * x);
}

/// Takes a bed of that shape back to a line; a and b, m, are sought.
Model flattening() {
  return [](std::span<const double> v, Precision) -> std::optional<Restore> {
    return [a = v[0], b = v[1]](geom::Point p) { return geom::Point{p.x, p.y - shape(p.x / length, a, b)}; };
  };
}

/// What a bed's errors of 1 m are.
struct Noise {
  double points = 0.0;  ///< Over which their correlation falls to 1 / e.
  double jitter = 0.0;  ///< Independent errors on top, m.
};

/// @param correlation  of neighbours: a chain of the first order.
BedShape noisy_bed(std::uint32_t seed, std::uint32_t bed, int count, Noise noise) {
  BedShape made{"bed " + std::to_string(bed), {}, std::vector<double>(static_cast<std::size_t>(count), 1.0)};
  const double kept = noise.points > 0.0 ? std::exp(-1.0 / noise.points) : 0.0;
  double error = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto fresh = base::normal_pair({static_cast<std::uint32_t>(i), bed, 5, 0}, seed);
    error = i == 0 ? fresh[0] : kept * error + std::sqrt(1.0 - kept * kept) * fresh[0];
    const double x = static_cast<double>(i) / (count - 1);
    made.points.push_back({x * length, shape(x, true_a, true_b) + error + noise.jitter * fresh[1]});
  }
  return made;
}

/// Parts of all seeds in which the truth was within.
struct Coverage {
  double region = 0.0, a = 0.0, b = 0.0;
};

Coverage coverage(std::uint32_t seeds, std::uint32_t beds, int count, Noise noise) {
  const auto within = [](const Estimate& e, double truth) {
    return e.low.value_or(e.unknown.low) <= truth && truth <= e.high.value_or(e.unknown.high);
  };
  Coverage part;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    std::vector<BedShape> shapes;
    for (std::uint32_t b = 0; b < beds; ++b) shapes.push_back(noisy_bed(seed, b, count, noise));
    const FitOptions options{1, 4, 95.0, {}, 1.0};
    const Fit fit =
        fit_beds(shapes, {{{"a", "m", -200, 200}, {"b", "m", -200, 200}}}, flattening(), options, {}).value();
    const double rms = misfit_of(shapes, flattening(), std::vector<double>{true_a, true_b}, {}).value();
    part.region += rms <= *fit.region ? 1.0 / seeds : 0.0;
    part.a += within(fit.estimates[0], true_a) ? 1.0 / seeds : 0.0;
    part.b += within(fit.estimates[1], true_b) ? 1.0 / seeds : 0.0;
  }
  return part;
}

TEST(Confidence, IndependentErrorsHaveTheTruthInTheRegionAsOftenAsItSays) {
  const Coverage part = coverage(150, 2, 40, {});
  for (const double one : {part.region, part.a, part.b}) {
    EXPECT_GE(one, 0.91);
    EXPECT_LE(one, 0.99);  // nor is the region too wide
  }
}

TEST(Confidence, ErrorsThatHangTogetherHaveItThereAsOften) {
  for (const Noise noise : {Noise{8.0}, Noise{6.0, 0.5}}) {
    SCOPED_TRACE(noise.points);
    const Coverage part = coverage(80, 3, 60, noise);
    for (const double one : {part.region, part.a, part.b}) EXPECT_GE(one, 0.88);  // 95 % but three deviations
    EXPECT_LE(std::min({part.region, part.a, part.b}), 0.99);
  }
}

TEST(Confidence, TheLengthOverWhichErrorsHangTogetherIsFoundThoughTheFitTookItsShare) {
  double found = 0.0;
  constexpr std::uint32_t seeds = 40;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const Fit fit = fit_beds({noisy_bed(seed, 0, 150, {4.0})}, {{{"a", "m", -200, 200}, {"b", "m", -200, 200}}},
                             flattening(), {1, 4, 95.0, {}, 1.0}, {})
                        .value();
    found += fit.beds[0].correlation_length / seeds;
    EXPECT_NEAR(fit.effective, 150.0 / fit.beds[0].correlation, 1e-9);
  }
  const double spacing = length / 149.0;
  EXPECT_GT(found, 3.0 * spacing);
  EXPECT_LT(found, 6.0 * spacing);
}

}  // namespace
}  // namespace recon::inversion
