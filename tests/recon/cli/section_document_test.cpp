#include "recon/cli/section_document.h"

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

class SectionDocument : public dobra::test::CommandLine {
 protected:
  SectionDocument() : CommandLine(core::program(), {restore_command(), balance_command()}) {}
  [[nodiscard]] dobra::base::Result<dobra::scenario::Document> document(const std::string& file,
                                                                        dobra::cli::LineOptionTexts lines = {}) const {
    dobra::cli::Session session(core::program(), {.verbosity = dobra::cli::Verbosity::Quiet}, {});
    return section_document(session, {file, std::move(lines)});
  }
};

TEST_F(SectionDocument, EveryKindOfLineGoesToItsTable) {
  const auto made = document(put("all.csv",
                                 "x,z,name,kind\n0,0,A,horizon\n9,0,A,horizon\n1,1,F,fault\n2,-9,F,fault\n"
                                 "0,5,P,pin\n0,-5,P,pin\n9,5,L,loose\n9,-5,L,loose\n"
                                 "0,0,U,unit\n9,0,U,unit\n9,-5,U,unit\n0,-5,U,unit\n0,0,U,unit\n"
                                 "0,-9,R,border\n9,-9,R,border\n9,9,R,border\n0,-9,R,border\n3,3,B,\n4,4,B,\n"));
  ASSERT_TRUE(made) << to_string(made.error());
  for (const char* const key : {"horizon", "fault", "pin", "loose", "polygon", "border"}) {
    EXPECT_NE(made->input.find(key), nullptr) << key;
  }
  EXPECT_TRUE(dobra::scenario::check(*made, core::program()));
}

TEST_F(SectionDocument, AHorizonWhoseNameComesTwiceIsInPiecesFromTheLeft) {
  const std::string file = put("twice.csv",
                               "x,z,name,kind\n6,0,A,\n9,0,A,\n\n0,-5,A,\n5,-5,A,\n\n5,1,F,fault\n5,0,F,fault\n"
                               "\n5,-1,F,fault\n5,-6,F,fault\n\n0,2,Top,\n9,2,Top,\n");
  const auto made = document(file);
  ASSERT_TRUE(made) << to_string(made.error());
  const auto text = dobra::scenario::document_text(*made);
  EXPECT_NE(text.find("\"A (2)\"\npoints = [[6.0, 0.0]"), std::string::npos) << text;
  EXPECT_NE(text.find("\"A (1)\"\npoints = [[0.0, -5.0]"), std::string::npos) << text;
  EXPECT_NE(text.find("piece_of = \"A\""), std::string::npos);
  EXPECT_NE(text.find("\"F (2)\""), std::string::npos);  // no horizon: another of the name
  EXPECT_TRUE(dobra::scenario::check(*made, core::program()));
  const auto run = call({"restore", file, "--top", "Top", "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("\"horizon_in_pieces\""), std::string::npos);
  EXPECT_NE(run.err.find("horizon 'A' is in 2 pieces, numbered from the left: 'A (1)' to 'A (2)'"), std::string::npos);
}

TEST_F(SectionDocument, AScenarioLendsItsInputAndTakesNoLineOptions) {
  const std::string file = put("s.toml",
                               "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"A\"\n"
                               "points = [[0, 0], [9, 1]]\n[[step]]\noperation = \"grid\"\n");
  const auto made = document(file);
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_TRUE(made->steps.empty());
  dobra::cli::LineOptionTexts kilometres;
  kilometres.unit = "km";
  const auto refused = document(file, kilometres);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, dobra::base::ErrorCode::BadUsage);
  refuses({"restore", path("none.csv")}, 3, {"none.csv"});
}

TEST_F(SectionDocument, ATargetFileHoldsOneLine) {
  const auto one = only_line(put("one.csv", "0 0\n5 1\n"), {});
  ASSERT_TRUE(one) << to_string(one.error());
  EXPECT_EQ(one->size(), 2u);
  const auto two = only_line(put("two.csv", "0 0\n5 1\n\n0 3\n5 3\n"), {});
  ASSERT_FALSE(two);
  EXPECT_NE(to_string(two.error()).find("2 lines in the file"), std::string::npos);
}

}  // namespace
}  // namespace recon::cli
