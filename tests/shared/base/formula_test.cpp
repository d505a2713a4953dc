#include "shared/base/formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <thread>

namespace dobra::base {
namespace {

using testing::HasSubstr;

const std::vector<std::string> names{"x", "y"};

double value(const std::string& text, double x = 2.0, double y = 3.0) {
  const auto formula = Formula::make(text, names);
  EXPECT_TRUE(formula.ok()) << (formula ? "" : to_string(formula.error()));
  return formula ? formula->at(std::array{x, y}) : std::nan("");
}

std::string trouble(const std::string& text) {
  const auto formula = Formula::make(text, names);
  EXPECT_FALSE(formula.ok()) << text;
  return formula ? "" : to_string(formula.error());
}

TEST(Formula, OperatorsBindAsInMathematics) {
  EXPECT_EQ(value("1 + 2 * 3"), 7.0);
  EXPECT_EQ(value("(1 + 2) * 3"), 9.0);
  EXPECT_EQ(value("8 - 3 - 2"), 3.0);
  EXPECT_EQ(value("8 / 4 / 2"), 1.0);
  EXPECT_EQ(value("2 ^ 3 ^ 2"), 512.0);
  EXPECT_EQ(value("-x^2"), -4.0);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("-x + +y"), 1.0);
  EXPECT_EQ(value("2 - -1"), 3.0);
  EXPECT_EQ(value("1.5e1"), 15.0);
}

TEST(Formula, NamesConstantsAndFunctionsHaveTheirValues) {
  EXPECT_EQ(value("x * y"), 6.0);
  EXPECT_NEAR(value("sin(pi / x)"), 1.0, 1e-15);
  EXPECT_NEAR(value("log(e)"), 1.0, 1e-15);
  EXPECT_EQ(value("max(x, min(y, 7))"), 3.0);
  EXPECT_EQ(value("hypot(3, 4) + abs(-1) + sign(-x) + floor(2.7)"), 7.0);
  EXPECT_NEAR(value("atan2(1, -1)"), 0.75 * M_PI, 1e-15);
  EXPECT_NEAR(value("pow(cbrt(8), 0.5) - sqrt(2)"), 0.0, 1e-15);
  EXPECT_TRUE(std::isinf(value("1 / (x - 2)")));
}

TEST(Formula, ChoicesTakeOneBranch) {
  EXPECT_EQ(value("x < y ? 10 : 20"), 10.0);
  EXPECT_EQ(value("x >= y ? 10 : 20"), 20.0);
  EXPECT_EQ(value("x > 5 ? 1 : x > 1 ? 2 : 3"), 2.0);
  EXPECT_EQ(value("1 + (x <= 2 ? y : 1 / 0)"), 4.0);
}

TEST(Formula, DeepNestingStaysWithinTheStack) {
  std::string text = "x";
  for (int i = 0; i < 20; ++i) text = "1 < 2 + 3 * 2 ^ max(0, " + text + ")";
  EXPECT_EQ(value(text), 1.0);
  EXPECT_EQ(value(std::string(1000, '(') + "x" + std::string(1000, ')')), 2.0);
  EXPECT_THAT(trouble(std::string(20000, '(') + "x" + std::string(20000, ')')), HasSubstr("the formula is too long"));
}

TEST(Formula, ManyThreadsMayAskAtOnce) {
  const Formula formula = Formula::make("x^2 + y", names).value();
  std::vector<std::thread> threads;
  std::array<double, 4> sums{};
  for (std::size_t t = 0; t < sums.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 1000; ++i) sums[t] += formula.at(std::array{static_cast<double>(i), static_cast<double>(t)});
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < sums.size(); ++t) EXPECT_EQ(sums[t], 332833500.0 + 1000.0 * static_cast<double>(t));
}

TEST(Formula, WhatCannotBeReadIsNamedWithItsPlace) {
  EXPECT_THAT(trouble("x +"), HasSubstr("missing at the end"));
  EXPECT_THAT(trouble("x + * y"), HasSubstr("character 5: '*' is not expected here"));
  EXPECT_THAT(trouble("(x"), HasSubstr("a ')' is missing"));
  EXPECT_THAT(trouble("x y"), HasSubstr("character 3: 'y' is not expected here"));
  EXPECT_THAT(trouble("sinn(x)"), HasSubstr("'sinn' is not known here; did you mean 'sin'?"));
  EXPECT_THAT(trouble("z"), HasSubstr("'z' is not known here"));
  EXPECT_THAT(trouble("hypot(x)"), HasSubstr("'hypot' lacks an argument"));
  EXPECT_THAT(trouble("sin(x, y)"), HasSubstr("'sin' has an argument too many"));
  EXPECT_THAT(trouble("sin x"), HasSubstr("the arguments of 'sin' are missing"));
  EXPECT_THAT(trouble("x ? 1"), HasSubstr("lacks its ':'"));
  EXPECT_THAT(trouble("x = 3"), HasSubstr("character 3: '=' is not expected here"));
  EXPECT_THAT(trouble("x, y"), HasSubstr("',' is not expected here"));
  EXPECT_THAT(trouble(""), HasSubstr("missing at the end"));
  EXPECT_THAT(trouble("x \u2265 1"), HasSubstr("character 3: '\u2265' is not known here; write '>='"));
}

TEST(Formula, WordsThatNothingIsNearToGetNoSuggestion) {
  for (const char* word : {"foo", "lft", "or", "and", "xx", "mm"})
    EXPECT_THAT(trouble(word),
                testing::AllOf(HasSubstr("there is x, y, pi, e"), testing::Not(HasSubstr("did you mean"))))
        << word;
  EXPECT_THAT(trouble("X"), HasSubstr("did you mean 'x'?"));
  EXPECT_THAT(trouble("SIN(x)"), HasSubstr("did you mean 'sin'?"));
  EXPECT_THAT(trouble("sni(x)"), HasSubstr("did you mean 'sin'?"));
  for (const char* word : {"nan", "inf", "1e400"}) EXPECT_THAT(trouble(word), HasSubstr("is no finite number")) << word;
}

TEST(Formula, AnErrorInAPartOfATextCountsFromTheBeginningOfTheText) {
  const auto read = Formula::make(" foo", names, {"the condition", "\u00e9 = foo", 4});
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, HasSubstr("the condition '\u00e9 = foo', character 5: 'foo' is not known"));
}

}  // namespace
}  // namespace dobra::base
