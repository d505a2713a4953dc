#include "quebra/validation/book.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "shared/io/file.h"
#include "tests/support/numbers.h"

namespace quebra::validation {
namespace {

namespace fs = std::filesystem;
using dobra::scenario::Document;
using dobra::scenario::Expect;
using testing::HasSubstr;

const fs::path folder = fs::path(DOBRA_SOURCE_DIR) / "resources/validation";

const std::vector<Document>& book() {
  static const std::vector<Document> read = read_book(folder).value();
  return read;
}

std::vector<std::string> sections() {
  std::vector<std::string> names;
  for (const Document& document : book()) {
    for (const Expect& expect : document.expects) {
      if (std::find(names.begin(), names.end(), expect.section) == names.end()) names.push_back(expect.section);
    }
  }
  return names;
}

const std::vector<std::string> all_sections = {
    "patch test",          "rates",    "effectivity", "3.1",   "3.2",   "3.3", "3.4",       "3.5",      "3.6",
    "3.7 compact tension", "3.7 beam", "3.8 a",       "3.8 b", "3.8 c", "3.9", "section 7", "section 8"};

/// The whole book, a test a section so that they run side by side. Their names stand above: the program of the tests
/// starts once a test and must not read the book each time.
class ValidationBook : public testing::TestWithParam<std::string> {};

TEST_P(ValidationBook, MeetsItsTolerances) {
  std::vector<Document> cases = book();
  std::erase_if(cases, [](const Document& one) { return one.expects.front().section != GetParam(); });
  std::size_t expected = 0;
  for (const Document& one : cases) expected += one.expects.size();
  const auto rows = validate(cases, {});
  ASSERT_TRUE(rows.ok()) << to_string(rows.error());
  EXPECT_EQ(rows->size(), expected);
  for (const Row& row : *rows)
    EXPECT_TRUE(row.met) << row.expect.name << ": " << row.value << " against " << *row.expect.value << ", "
                         << 100 * row.error << " %";
  const std::string text = csv(*rows);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<std::ptrdiff_t>(expected + 1));
  dobra::test::expect_numbers(json(*rows), "JSON of " + GetParam());
  dobra::test::expect_numbers(text, "CSV of " + GetParam());
  EXPECT_THAT(html(*rows), HasSubstr(rows->front().expect.name.substr(0, 4)));
}

INSTANTIATE_TEST_SUITE_P(Sections, ValidationBook, testing::ValuesIn(all_sections), [](const auto& section) {
  std::string name = "section_" + section.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == ' '; }, '_');
  return name;
});

TEST(Validation, HasEverySectionAndAReasonForEveryWideTolerance) {
  EXPECT_THAT(sections(), testing::ElementsAreArray(all_sections));
  std::set<std::string> names;
  for (const Document& document : book()) {
    for (const Expect& one : document.expects) {
      EXPECT_TRUE(names.insert(one.name).second) << one.name << " stands twice";
      EXPECT_EQ(one.section, document.expects.front().section) << one.name << ": a file belongs to one section";
      EXPECT_FALSE(one.source.empty()) << one.name;
      // K of the three methods; formulas have their own accuracy, in the source or the note.
      const double own = one.name.ends_with("interaction integral") ? 1e-3
                         : one.name.ends_with("crack closure")      ? 2e-3
                                                                    : 1e-2;
      EXPECT_TRUE(one.relative_tolerance <= own || !one.note.empty()) << one.name;
    }
  }
  EXPECT_EQ(names.size(), 328U);
}

TEST(Validation, AFileReadsBackToItself) {
  for (const Document& document : book())
    EXPECT_EQ(document_text(document), dobra::io::read_text(document.file).value()) << document.file;
}

TEST(Validation, AScenarioThatFailsIsNamedAndAWrongSignIsAnError) {
  Document wrong = book().front();
  wrong.expects.resize(1);
  Expect& claim = wrong.expects.front();
  *claim.value = -*claim.value;
  const auto negative = validate({wrong}, {});
  EXPECT_NEAR(negative->front().error, 2.0, 1e-3);
  EXPECT_FALSE(negative->front().met);
  for (const double reference : {0.0, std::nan("")}) {
    *claim.value = reference;
    const auto judged = validate({wrong}, {});
    ASSERT_FALSE(judged.ok());
    EXPECT_THAT(to_string(judged.error()), HasSubstr(claim.name));
  }
  *claim.value = 1.0;
  claim.rate_from = std::to_string(wrong.steps.size());  // log 1 / log 1
  EXPECT_THAT(to_string(validate({wrong}, {}).error()), HasSubstr("no finite number"));
  claim.rate_from = "1";  // the problem alone has nothing to fall
  EXPECT_THAT(to_string(validate({wrong}, {}).error()), HasSubstr("there is no quantity"));
  claim.rate_from.reset();
  claim.quantity = "nothing";
  claim.place.file = "wrong.toml";
  EXPECT_THAT(to_string(validate({wrong}, {}).error()), testing::AllOf(HasSubstr("wrong.toml"), HasSubstr("nothing")));
}

class BookOfOne : public testing::Test {
 protected:
  BookOfOne() {
    std::string name = (fs::temp_directory_path() / "dobra_book_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~BookOfOne() override { fs::remove_all(folder_); }
  /// The first case of the book with one text in the place of another, as a book of its own.
  [[nodiscard]] dobra::base::Result<std::vector<Document>> with(const std::string& from, const std::string& to) const {
    std::string text = dobra::io::read_text(book().front().file).value();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_TRUE(dobra::io::write_file(folder_ / "one.toml", text).ok());
    return read_book(folder_);
  }
  fs::path folder_;
};

TEST_F(BookOfOne, SaysNoWhereAFileExpectsAWrongValue) {
  const Expect& first = book().front().expects.front();
  const auto line = [](double value) { return fmt::format("value = {}\n", value); };
  const auto right = validate(with(line(*first.value), line(*first.value)).value(), {}).value();
  const auto wrong = validate(with(line(*first.value), line(*first.value * (1.0 + 1e-9))).value(), {}).value();
  ASSERT_EQ(right.size(), wrong.size());
  EXPECT_TRUE(right.front().met);
  EXPECT_FALSE(wrong.front().met) << "wrong by 1e-9, within 1e-12";
  EXPECT_NEAR(wrong.front().error, 1e-9, 1e-12);
  EXPECT_THAT(csv(wrong), HasSubstr(",no,"));
  EXPECT_TRUE(wrong.back().met) << "the other rows are as they were";
}

TEST_F(BookOfOne, RefusesAFolderOrAFileThatIsNoBook) {
  EXPECT_THAT(to_string(read_book(folder_).error()), HasSubstr("no scenario"));
  EXPECT_THAT(to_string(read_book(folder_ / "not_there").error()),
              testing::AllOf(HasSubstr("not_there"), HasSubstr("No such file")));
  EXPECT_THAT(to_string(with("name = \"Patch", "note = \"Patch").error()), HasSubstr("`name`"));
  EXPECT_THAT(to_string(with("operation = \"analyse\"", "operation = \"analyze\"").error()), HasSubstr("analyse"));
  EXPECT_THAT(to_string(with("[[expect]]\n", "[[expect]]\nrate_from = \"coarse\"\n").error()), HasSubstr("coarse"));
}

}  // namespace
}  // namespace quebra::validation
