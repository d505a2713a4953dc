#include "shared/scenario/program.h"

#include <gtest/gtest.h>

#include "tests/support/fake_program.h"

namespace dobra::scenario {
namespace {

std::string program_complaint(const std::string& body, const std::string& program = "fake") {
  const auto document = parse_document("dobra = 1\nprogram = \"" + program + "\"\n" + body, "f.toml");
  EXPECT_TRUE(document.ok());
  const auto judged = check(*document, fake::program());
  return judged ? "" : base::to_string(judged.error());
}

TEST(Program, AScenarioForAnotherProgramIsRefused) {
  EXPECT_EQ(program_complaint("", "quebra"),
            "f.toml: this scenario is for 'quebra', not for 'fake'; run it with quebra");
}

TEST(Program, ASheetWithoutATitleIsCalledAfterItsDocument) {
  scene::Picture sheet;
  sheet.paper = scene::Paper::A4Landscape;
  Document document;
  document.file = "folder/anticline.toml";
  EXPECT_EQ(titled(sheet, document).title, "anticline");
  EXPECT_EQ(titled({}, document).title, "");  // no sheet
  document.title = "An anticline";
  EXPECT_EQ(titled(sheet, document).title, "An anticline");
  sheet.title = "Its own";
  EXPECT_EQ(titled(sheet, document).title, "Its own");
}

TEST(Program, AnUnknownOperationGetsASuggestion) {
  EXPECT_EQ(program_complaint("[[step]]\noperation = \"scael\"\n"),
            "f.toml:3:1: step 1: unknown operation 'scael'; did you mean 'scale'?");
  EXPECT_EQ(program_complaint("[[step]]\noperation = \"xxxxxxxxxx\"\n"),
            "f.toml:3:1: step 1: unknown operation 'xxxxxxxxxx'; known operations: scale, import, wait, fail");
}

TEST(Program, InputAndParametersOfEveryStepAreJudgedBeforeAnythingRuns) {
  fake::calls().clear();
  EXPECT_EQ(program_complaint("[input]\nnumber = 1\n"),
            "f.toml:4:1: input: unknown key 'number'; did you mean 'numbers'?");
  EXPECT_EQ(program_complaint("[[step]]\noperation = \"scale\"\n[[step]]\noperation = \"scale\"\nfactor = -1\n"),
            "f.toml:7:1: step 2 (scale): 'factor' must be greater than 0 m, found -1 m");
  EXPECT_EQ(program_complaint("[[step]]\noperation = \"import\"\n"),
            "f.toml:3:1: step 1 (import): the key 'file' is missing; it must be a file name in quotes");
  EXPECT_TRUE(fake::calls().empty());
}

TEST(Program, NamesOfStepsAreUniqueAndExpectationsReferToThem) {
  EXPECT_EQ(program_complaint(
                "[[step]]\noperation = \"scale\"\nname = \"a\"\n[[step]]\noperation = \"scale\"\nname = \"a\"\n"),
            "f.toml:6:1: step 2 (scale): another step is called 'a' already; give this one another name");
  EXPECT_EQ(
      program_complaint("[[step]]\noperation = \"scale\"\nname = \"grid\"\n[[expect]]\nquantity = \"sum\"\nstep = "
                        "\"gird\"\nvalue = 1\n"),
      "f.toml:6:1: expectation 1: there is no step 'gird' among the 1 steps; did you mean 'grid'?");
  EXPECT_EQ(program_complaint(
                "[[step]]\noperation = \"scale\"\n[[expect]]\nquantity = \"sum\"\nrate_from = \"a\"\nvalue = 1\n"),
            "f.toml:5:1: expectation 1: there is no step 'a' among the 1 steps");
  EXPECT_EQ(program_complaint("[[step]]\noperation = \"scale\"\n[[expect]]\nquantity = \"sum\"\nstep = 1\nvalue = 1\n"),
            "");
}

}  // namespace
}  // namespace dobra::scenario
