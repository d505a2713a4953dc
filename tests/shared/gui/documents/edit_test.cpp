#include "shared/gui/documents/edit.h"

#include <gtest/gtest.h>

#include "tests/shared/gui/fake_program.h"

namespace dobra::gui::documents {
namespace {

scenario::Document two_steps() {
  scenario::Document document;
  document.program = "waves";
  document.steps.resize(2);
  document.steps[0].operation = "stack";
  document.steps[1].operation = "sleep";
  return document;
}

TEST(Edit, StepGoesBehindThePart) {
  const scenario::Document first = with_step(two_steps(), 0, "break");
  const scenario::Document last = with_step(two_steps(), 2, "break");
  EXPECT_EQ(first.steps.front().operation, "break");
  EXPECT_EQ(last.steps.back().operation, "break");
  EXPECT_TRUE(last.steps.back().params.empty());
}

TEST(Edit, RemovingWhatWasAddedIsTheIdentity) {
  const scenario::Document back = without_step(with_step(two_steps(), 1, "break"), 2);
  EXPECT_EQ(scenario::document_text(back), scenario::document_text(two_steps()));
}

TEST(Edit, ExchangingTwiceIsTheIdentity) {
  const scenario::Document once = with_step_lowered(two_steps(), 1);
  EXPECT_EQ(once.steps[0].operation, "sleep");
  EXPECT_EQ(scenario::document_text(with_step_lowered(once, 1)), scenario::document_text(two_steps()));
}

TEST(Edit, FileNamesKeepTheirFileWhenTheDocumentMoves) {
  const scenario::Program program = test::fake_program();
  scenario::Document document = two_steps();
  document.file = "/data/a/one.toml";
  document.input.set("file", std::string("curves/top.csv"));
  const scenario::Document moved = at_file(document, program, "/data/b/two.toml");
  EXPECT_EQ(std::get<std::string>(*moved.input.find("file")), "../a/curves/top.csv");
  const scenario::Document back = at_file(moved, program, "/data/a/one.toml");
  EXPECT_EQ(std::get<std::string>(*back.input.find("file")), "curves/top.csv");
}

TEST(Edit, AbsoluteFileNamesAndOtherTextsStay) {
  const scenario::Program program = test::fake_program();
  scenario::Document document = two_steps();
  document.file = "/data/a/one.toml";
  document.input.set("file", std::string("/curves/top.csv"));
  document.steps[0].params.set("note", std::string("curves/top.csv"));
  const scenario::Document moved = at_file(document, program, "/data/b/two.toml");
  EXPECT_EQ(std::get<std::string>(*moved.input.find("file")), "/curves/top.csv");
  EXPECT_EQ(std::get<std::string>(*moved.steps[0].params.find("note")), "curves/top.csv");
}

}  // namespace
}  // namespace dobra::gui::documents
