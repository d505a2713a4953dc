#include "shared/offset/types/distances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dobra::offset {
namespace {

void expect_distances(const DistanceRule& rule, const std::vector<double>& expected) {
  const auto got = distances(rule);
  ASSERT_TRUE(got.ok()) << got.error().message;
  ASSERT_EQ(got->size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR((*got)[k], expected[k], 1e-6);
}

TEST(Distances, FiguresEightAndNineOfThePaper) {
  expect_distances({5, 0.3, 1.0}, {0.3, 0.6, 0.9, 1.2, 1.5});
  expect_distances({6, 0.1, 1.3}, {0.1, 0.23, 0.399, 0.6187, 0.90431, 1.275603});
  expect_distances({7, 0.18, 1.0}, {0.18, 0.36, 0.54, 0.72, 0.90, 1.08, 1.26});
  expect_distances({8, 0.05, 1.25}, {0.05, 0.1125, 0.190625, 0.288281, 0.410352, 0.562939, 0.753674, 0.992093});
}

TEST(Distances, GapsGrowByTheFactor) {
  const auto d = distances({9, 0.7, 1.5}).value();
  for (std::size_t k = 2; k < d.size(); ++k) EXPECT_NEAR((d[k] - d[k - 1]) / (d[k - 1] - d[k - 2]), 1.5, 1e-12);
  EXPECT_EQ(d[0], 0.7);
}

TEST(Distances, BadRulesAreRefusedByName) {
  const auto message = [](const DistanceRule& rule) {
    const auto got = distances(rule);
    return got.ok() ? std::string() : got.error().message;
  };
  EXPECT_NE(message({0, 1.0, 1.0}).find("number of offset curves"), std::string::npos);
  EXPECT_NE(message({3, 0.0, 1.0}).find("initial distance is 0"), std::string::npos);
  EXPECT_NE(message({3, -2.0, 1.0}).find("initial distance is -2"), std::string::npos);
  EXPECT_NE(message({3, std::nan(""), 1.0}).find("initial distance"), std::string::npos);
  EXPECT_NE(message({3, 1.0, 0.0}).find("factor"), std::string::npos);
  EXPECT_NE(message({3, 1.0, INFINITY}).find("factor"), std::string::npos);
  EXPECT_NE(message({5000, 1.0, 2.0}).find("fewer curves"), std::string::npos);  // overflows
  EXPECT_NE(message({5000, 1.0, 0.5}).find("fewer curves"), std::string::npos);  // gaps shrink to nothing
}

}  // namespace
}  // namespace dobra::offset
