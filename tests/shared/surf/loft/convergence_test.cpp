// How near surfaces through sections come to the shapes that these were sampled from. The tests print their figures:
// dobra_surf_loft_test --gtest_filter='LoftConvergence.*'

#include <gtest/gtest.h>

#include <cstdio>

#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

constexpr double wide = 500.0, stretch_of_sections = 1000.0;  // across the sections, along them

/// Nothing of it is straight across the sections, whatever way they run.
double bent_fold(double x, double y) {
  return 80.0 * std::sin(0.003 * x + 0.4 * std::sin(0.006 * y)) * std::exp(-0.001 * y) + 0.1 * y;
}

/// Sections that run `turned` degrees north of east, equally far apart, and another trace at 30 degrees to them.
struct Oblique {
  double turned = 0.0;
  [[nodiscard]] Point at(double along, double across) const {
    const double a = turned * 0.017453292519943295;
    return {along * std::cos(a) - across * std::sin(a), along * std::sin(a) + across * std::cos(a)};
  }
  [[nodiscard]] std::vector<loft::Section> sections(int intervals, int n) const {
    std::vector<loft::Section> made;
    for (int k = 0; k <= intervals; ++k) {
      const double t = wide * k / intervals;
      made.push_back(section("S" + std::to_string(k), {at(0.0, t), at(stretch_of_sections, t)}));
      add(made.back(), "top", sampled(made.back(), bent_fold, n));
    }
    return made;
  }
  [[nodiscard]] double miss(int intervals) const {
    loft::ThroughOptions options;
    options.rows = 1;
    const auto made = through(sections(intervals, 6000), options);
    const auto along = trace({at(60.0, 0.0), at(60.0 + wide * std::sqrt(3.0), wide)});
    const auto cut = loft::cut_along(made.surfaces, along, made.size);
    EXPECT_EQ(cut.lines.size(), 1u);
    double most = cut.lines.empty() ? 1e300 : 0.0;
    for (const auto& line : cut.lines) {
      for (const Point p : line.line.points) {
        const Point on = along.on_map(p.x);
        most = std::max(most, std::abs(p.y - bent_fold(on.x, on.y)));
      }
    }
    return most;
  }
};

TEST(LoftConvergence, ACutAt30DegreesComesNearerByTheFourthPowerOfTheSpacing) {
  for (const double turned : {0.0, 30.0}) {
    const Oblique oblique{turned};
    double before = 0.0, order = 0.0;
    for (const int intervals : {4, 8, 16, 32}) {
      const double miss = oblique.miss(intervals);
      order = before > 0.0 ? std::log2(before / miss) : 0.0;
      std::printf("sections at %g degrees, spacing %8.4f m: misses by %.3e m, order %.2f\n", turned, wide / intervals,
                  miss, order);
      before = miss;
    }
    EXPECT_GT(order, 3.8) << turned;
  }
}

TEST(LoftConvergence, ItsOwnTraceGivesASectionBack) {
  for (const double turned : {0.0, 30.0}) {
    const auto sections = Oblique{turned}.sections(8, 600);
    const auto made = through(sections);
    double most = 0.0;
    for (const auto& s : sections) {
      const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
      ASSERT_EQ(cut.lines.size(), 1u);
      most = std::max({most, away(cut.lines[0].line, s.lines[0].line), away(s.lines[0].line, cut.lines[0].line)});
    }
    std::printf("sections at %g degrees, their own traces: off by %.3e m, %.3e of the size\n", turned, most,
                most / made.size);
    EXPECT_LT(most, 1e-9 * made.size);
  }
}

TEST(LoftConvergence, VolumesComeToTheClosedForm) {
  const double pi = 3.14159265358979323846, a = 1000.0, b = 800.0, k = 0.006;
  const auto upper = [&](double x, double y) { return 40.0 * std::sin(pi * x / a) * std::cos(k * y) + 100.0; };
  const auto lower = [&](double x, double y) { return -30.0 * std::sin(pi * x / a) + 0.1 * y; };
  const double exact =
      40.0 * (2.0 * a / pi) * std::sin(k * b) / k + 100.0 * a * b + 30.0 * (2.0 * a / pi) * b - 0.05 * a * b * b;
  double off = 0.0;
  for (const int count : {5, 9, 17, 33}) {
    auto sections = row(count, a, b, upper, 2500, "upper");
    for (auto& s : sections) add(s, "lower", sampled(s, lower, 1900));
    loft::ThroughOptions options;
    options.rows = 1;
    const auto made = through(std::move(sections), options);
    off = std::abs(loft::volume_between(made.surfaces[0], made.surfaces[1]).value().value / exact - 1.0);
    std::printf("%d sections: the volume is off by %.3e of it\n", count, off);
  }
  EXPECT_LT(off, 1e-6);
}

}  // namespace
}  // namespace dobra::test
