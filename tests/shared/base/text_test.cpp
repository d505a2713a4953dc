#include "shared/base/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace dobra::base {
namespace {

TEST(Text, NumbersAreShortAndLookLikeNumbers) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(3), "3.0");
  EXPECT_EQ(number_text(-0.0), "-0.0");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(std::nan("")), "nan");
}

TEST(Text, NumbersReadBackToTheSameBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(value)) continue;
    const auto back = parse_number(number_text(value));
    ASSERT_TRUE(back.has_value()) << number_text(value);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << number_text(value);
  }
  for (const double value :
       {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), -0.0, 1e23}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*parse_number(number_text(value))), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(Text, OnlyAWholeNumberIsParsed) {
  EXPECT_EQ(parse_number("+1.5e3"), 1500.0);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  for (const char* text : {"", "+", "-", " 1", "1 ", "1,5", "1.5m", "0x10", "+-1", "++1", "1e999", "abc"}) {
    EXPECT_FALSE(parse_number(text).has_value()) << '\'' << text << '\'';
  }
}

TEST(Text, MisspeltNameSuggestsTheNearest) {
  const std::vector<std::string> names{"distance", "direction", "tolerance"};
  EXPECT_EQ(suggestion("distanse", names), "distance");
  EXPECT_EQ(suggestion("tolerence", names), "tolerance");
  EXPECT_EQ(suggestion("distance", names), "distance");
  EXPECT_FALSE(suggestion("colour", names).has_value());
  EXPECT_FALSE(suggestion("x", {}).has_value());
  EXPECT_EQ(did_you_mean("directon", names), "; did you mean 'direction'?");
  EXPECT_EQ(did_you_mean("colour", names), "");
  const std::vector<std::string> short_names{"cos", "tan", "left"};
  for (const char* word : {"or", "x", "lt", "foo", "and"})
    EXPECT_FALSE(suggestion(word, short_names).has_value()) << word;
  EXPECT_EQ(suggestion("LFET", short_names), "left");
  EXPECT_EQ(suggestion("TAN", short_names), "tan");
}

TEST(Text, TranslatorReplacesTheSourceText) {
  EXPECT_EQ(translated("fold"), "fold");
  set_translator([](const char* text) { return "<" + std::string(text) + ">"; });
  EXPECT_EQ(translated("fold"), "<fold>");
  set_translator(nullptr);
  EXPECT_EQ(translated("fold"), "fold");
}

}  // namespace
}  // namespace dobra::base
