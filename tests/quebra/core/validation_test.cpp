#include "quebra/core/validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace quebra::core {
namespace {

TEST(Validation, TheBookMeetsItsTolerances) {
  // All of it takes a minute: with DOBRA_VALIDATE set, or by `quebra validate`. Here a few that cover every kind.
  std::vector<ValidationCase> cases = validation_cases();
  if (std::getenv("DOBRA_VALIDATE") == nullptr) {
    const std::set<std::string> few{"Finite plate with a hole, d/W = 0.5, Kt", "Cook's membrane, energy", "Edge crack, a/W = 0.5, crack closure",
                                    "Compact tension, a/W = 0.5", "Edge crack under shear, K_II"};
    std::erase_if(cases, [&](const ValidationCase& one) { return !few.contains(one.name); });
    ASSERT_EQ(cases.size(), few.size());
  }
  const auto results = validate(cases, {});
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  for (const ValidationResult& result : *results)
    EXPECT_TRUE(result.met()) << result.what.name << ": " << result.value << " against " << result.what.reference;
  const std::string csv = validation_csv(*results);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<std::ptrdiff_t>(cases.size() + 1));
  EXPECT_THAT(validation_html(*results), testing::HasSubstr(cases.front().name.substr(0, 4)));
}

TEST(Validation, AScenarioThatFailsIsNamed) {
  ValidationCase wrong = validation_cases().front();
  wrong.name = "wrong";
  wrong.quantity = "nothing";
  EXPECT_THAT(to_string(validate({wrong}, {}).error()), testing::HasSubstr("wrong"));
}

}  // namespace
}  // namespace quebra::core
