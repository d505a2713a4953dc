#include "recon/faults/pairing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/recon/faults/sections.h"

namespace recon::faults {
namespace {

using test::faulted;
using test::item;

std::vector<Cutoff> cutoffs_at_arcs(std::vector<double> arcs) {
  std::sort(arcs.begin(), arcs.end(), std::greater<>());
  std::vector<Cutoff> cutoffs;
  for (const double arc : arcs) {
    Cutoff cutoff;
    cutoff.arc = arc;
    cutoffs.push_back(cutoff);
  }
  return cutoffs;
}

/// All ways to leave out cutoffs of the longer list: the least sum.
double least_sum(const std::vector<double>& few, const std::vector<double>& many, double expected, std::size_t i = 0,
                 std::size_t from = 0) {
  if (i == few.size()) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = from; j < many.size(); ++j)
    least = std::min(least, std::abs(many[j] - few[i] - expected) + least_sum(few, many, expected, i + 1, j + 1));
  return least;
}

TEST(Pairing, HasTheLeastSumOfAllPairingsThatKeepTheOrder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> arc(0.0, 1000.0);
  for (int draw = 0; draw < 500; ++draw) {
    std::vector<double> one(1 + random() % 4), other(1 + random() % 6);
    for (double& a : one) a = arc(random);
    for (double& a : other) a = arc(random);
    const double expected = draw % 2 == 0 ? 0.0 : 250.0;
    ExpectedSeparation of_others;
    of_others.learn_from({cutoffs_at_arcs({500.0}), cutoffs_at_arcs({500.0 + expected})});
    const WallCutoffs walls{cutoffs_at_arcs(one), cutoffs_at_arcs(other)};
    double sum = 0.0;
    std::size_t pairs = 0;
    double last_hanging = 1e9, last_foot = 1e9;
    for (const auto& [hanging, foot] : partners_of(walls, of_others)) {
      if (!hanging || !foot) continue;
      ++pairs;
      sum += std::abs(foot->arc - hanging->arc - expected);
      EXPECT_TRUE(hanging->arc < last_hanging && foot->arc < last_foot);
      last_hanging = hanging->arc;
      last_foot = foot->arc;
    }
    EXPECT_EQ(pairs, std::min(one.size(), other.size()));
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    const double least =
        one.size() <= other.size() ? least_sum(one, other, expected) : least_sum(other, one, -expected);
    EXPECT_NEAR(sum, least, 1e-9) << draw;
  }
}

/// Level beds cut by a fault of 45 degrees that dips to +x and has 100 m of throw; D is doubled by an older thrust, its
/// upper sheet at -400 and its lower one at -500, which the fault cuts in the walls that are asked for.
section::Section doubled(bool upper_hanging, bool upper_foot, bool lower_hanging, bool lower_foot) {
  std::vector<test::NamedPoints> beds{{"A/1", {{0, 0}, {500, 0}}},
                                      {"A/2", {{600, -100}, {2500, -100}}},
                                      {"E/1", {{0, -800}, {1300, -800}}},
                                      {"E/2", {{1400, -900}, {2500, -900}}}};
  if (upper_foot) beds.push_back({"D/1", {{0, -400}, {900, -400}}});
  if (upper_hanging) beds.push_back({"D/2", {{1000, -500}, {1600, -500}}});
  if (lower_foot) beds.push_back({"D/3", {{700, -500}, {1000, -500}}});
  if (lower_hanging) beds.push_back({"D/4", {{1100, -600}, {2500, -600}}});
  return faulted(beds, {item("F", {{400, 100}, {1500, -1000}})});
}

TEST(Pairing, SheetsOfADoubledBedBelongTogetherByTheDisplacementOfTheOtherBeds) {
  const double slip = 100.0 * std::sqrt(2.0);
  for (int missing = 0; missing < 5; ++missing) {
    const section::Section section = doubled(missing != 0, missing != 1, missing != 2, missing != 3);
    const auto faults = faults_of(section, {});
    ASSERT_TRUE(faults) << to_string(faults.error());
    const FaultCutoffs found = cutoffs_at(section, *faults, 0, {});
    std::size_t alone = 0;
    for (const CutoffPair& pair : found.pairs) {
      if (pair.separation) {
        EXPECT_NEAR(*pair.separation, slip, 1e-9) << pair.horizon << missing;
        continue;
      }
      ++alone;
      EXPECT_EQ(std::count(found.remarks.begin(), found.remarks.end(), partner_missing(pair, "F")), 1);
      const geom::Point at = pair.hanging_wall ? pair.hanging_wall->at : pair.footwall->at;
      // The sheet whose other wall is missing stands alone.
      constexpr double heights[] = {-400, -500, -500, -600};
      EXPECT_NEAR(at.y, heights[missing], 1e-9);
    }
    EXPECT_EQ(alone, missing < 4 ? 1U : 0U);
  }
}

}  // namespace
}  // namespace recon::faults
