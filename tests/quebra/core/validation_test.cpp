#include "quebra/core/validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/numbers.h"

namespace quebra::core {
namespace {

std::vector<std::string> sections() {
  std::vector<std::string> names;
  for (const ValidationCase& one : validation_cases()) {
    if (std::find(names.begin(), names.end(), one.section) == names.end()) names.push_back(one.section);
  }
  return names;
}

/// The whole book, a test a section so that they run side by side.
class ValidationBook : public testing::TestWithParam<std::string> {};

TEST_P(ValidationBook, MeetsItsTolerances) {
  std::vector<ValidationCase> cases = validation_cases();
  std::erase_if(cases, [](const ValidationCase& one) { return one.section != GetParam(); });
  const auto results = validate(cases, {});
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  for (const ValidationResult& result : *results)
    EXPECT_TRUE(result.met()) << result.what.name << ": " << result.value << " against " << result.what.reference
                              << ", " << 100 * result.error << " %";
  const std::string csv = validation_csv(*results);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<std::ptrdiff_t>(cases.size() + 1));
  dobra::test::expect_numbers(validation_json(*results), "JSON of " + GetParam());
  dobra::test::expect_numbers(csv, "CSV of " + GetParam());
  EXPECT_THAT(validation_html(*results), testing::HasSubstr(cases.front().name.substr(0, 4)));
}

INSTANTIATE_TEST_SUITE_P(Sections, ValidationBook, testing::ValuesIn(sections()), [](const auto& section) {
  std::string name = "section_" + section.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == ' '; }, '_');
  return name;
});

TEST(Validation, HasEverySectionAndAReasonForEveryWideTolerance) {
  EXPECT_THAT(sections(), testing::ElementsAre("patch test", "rates", "effectivity", "3.1", "3.2", "3.3", "3.4", "3.5",
                                               "3.6", "3.7 compact tension", "3.7 beam", "3.8 a", "3.8 b", "3.8 c",
                                               "3.9", "section 7", "section 8"));
  std::set<std::string> names;
  for (const ValidationCase& one : validation_cases()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name << " stands twice";
    // K of the three methods; formulas have their own accuracy, in the source or the note.
    const double own = one.name.ends_with("interaction integral") ? 1e-3
                       : one.name.ends_with("crack closure")      ? 2e-3
                                                                  : 1e-2;
    EXPECT_TRUE(one.tolerance <= own || !one.note.empty()) << one.name;
  }
}

TEST(Validation, AScenarioThatFailsIsNamedAndAWrongSignIsAnError) {
  ValidationCase wrong = validation_cases().front();
  wrong.reference = -wrong.reference;
  EXPECT_NEAR(validate({wrong}, {})->front().error, 2.0, 1e-3);
  for (const double reference : {0.0, std::nan("")}) {
    ValidationCase none = wrong;
    none.reference = reference;
    const auto judged = validate({none}, {});
    ASSERT_FALSE(judged.ok());
    EXPECT_THAT(to_string(judged.error()), testing::HasSubstr(none.name));
  }
  ValidationCase rate = wrong;
  rate.coarse = rate.scenario;  // log 1 / log 1
  EXPECT_THAT(to_string(validate({rate}, {}).error()), testing::HasSubstr("no finite number"));
  wrong.name = "wrong";
  wrong.quantity = "nothing";
  EXPECT_THAT(to_string(validate({wrong}, {}).error()), testing::HasSubstr("wrong"));
}

}  // namespace
}  // namespace quebra::core
