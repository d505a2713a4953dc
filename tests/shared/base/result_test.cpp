#include "shared/base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace dobra::base {
namespace {

Result<int> half(int value) {
  if (value % 2 != 0) return Error{ErrorCode::BadValue, "odd"};
  return value / 2;
}

Result<void> even(int value) {
  DOBRA_TRY_VOID(half(value));
  return {};
}

Result<std::string> quarter_text(int value) {
  DOBRA_TRY(const int once, half(value));
  DOBRA_TRY(const int twice, half(once));
  return std::to_string(twice);
}

TEST(Result, HoldsAValueOrAnError) {
  EXPECT_TRUE(half(4).ok());
  EXPECT_EQ(*half(4), 2);
  EXPECT_FALSE(half(3));
  EXPECT_EQ(half(3).error().message, "odd");
}

TEST(Result, TryHandsTheValueOnAndTheErrorUp) {
  EXPECT_EQ(quarter_text(12).value(), "3");
  EXPECT_EQ(quarter_text(6).error().code, ErrorCode::BadValue);
  EXPECT_TRUE(even(2).ok());
  EXPECT_EQ(even(1).error().message, "odd");
}

TEST(Result, ValueCanBeMovedOut) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 5);
}

TEST(ResultDeathTest, AskingForWhatIsNotThereStopsTheProgram) {
  EXPECT_DEATH((void)half(3).value(), "ok\\(\\) does not hold");
  EXPECT_DEATH((void)half(4).error(), "!ok\\(\\) does not hold");
}

TEST(CheckDeathTest, BrokenPromiseNamesTheConditionAndThePlace) {
  DOBRA_CHECK(1 + 1 == 2);
  EXPECT_DEATH(DOBRA_CHECK(1 + 1 == 3), "result_test.cpp:[0-9]+: internal error.*1 \\+ 1 == 3 does not hold");
}

}  // namespace
}  // namespace dobra::base
