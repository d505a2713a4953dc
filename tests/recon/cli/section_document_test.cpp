#include "recon/cli/section_document.h"

#include <set>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

class SectionDocument : public dobra::test::CommandLine {
 protected:
  SectionDocument() : CommandLine(core::program(), {restore_command(), balance_command()}) {}
  [[nodiscard]] dobra::base::Result<dobra::scenario::Document> document(const std::string& file,
                                                                        dobra::scenario::Table lines = {}) const {
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

TEST_F(SectionDocument, LinesCalledAsPiecesAreTakenForPiecesIfNoneIsMissing) {
  const auto made = document(put("numbered.csv",
                                 "x,z,name\n0,0,A (2)\n5,0,A (2)\n6,1,A (1)\n9,1,A (1)\n0,-5,B (1)\n9,-5,B (1)\n"
                                 "0,-7,C (1)\n9,-7,C (1)\n0,-8,C (3)\n9,-8,C (3)\n"));
  ASSERT_TRUE(made) << to_string(made.error());
  const auto text = dobra::scenario::document_text(*made);
  // The names stay, though the first is not the left one.
  EXPECT_NE(text.find("\"A (2)\"\npoints = [[0.0, 0.0]"), std::string::npos) << text;
  std::size_t pieces = 0;
  for (std::size_t at = text.find("piece_of"); at != std::string::npos; at = text.find("piece_of", at + 1)) ++pieces;
  EXPECT_EQ(pieces, 2U) << text;
}

TEST_F(SectionDocument, AScenarioLendsItsInputAndTakesNoLineOptions) {
  const std::string file = put("s.toml",
                               "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"A\"\n"
                               "points = [[0, 0], [9, 1]]\n[[step]]\noperation = \"grid\"\n");
  const auto made = document(file);
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_TRUE(made->steps.empty());
  dobra::scenario::Table kilometres;
  kilometres.set("unit", std::string("km"));
  const auto refused = document(file, kilometres);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, dobra::base::ErrorCode::BadUsage);
  refuses({"restore", path("none.csv")}, 3, {"none.csv"});
}

TEST_F(SectionDocument, OptionsAboutLinesSayWhatTheKeysOfTheScenarioSay) {
  std::set<std::string> seen;
  for (const char* const command : {"restore", "balance"}) {
    const std::string help = call({command, "--help"}).out;
    for (const auto& field : core::program().input_fields) {
      for (const char* const key : {"y_axis", "reference", "unit", "exaggeration", "trace", "fold_axis",
                                    "plane_tolerance", "snap_to_faults", "share_edges", "slivers"}) {
        if (field.key != key) continue;
        std::string words = field.options.help;
        words.pop_back();
        EXPECT_NE(help.find(words), std::string::npos) << command << " " << key << "\n" << help;
        seen.insert(key);
      }
    }
  }
  EXPECT_EQ(seen.size(), 10U);
}

TEST_F(SectionDocument, ATargetFileHoldsOneLine) {
  const auto one = only_line(put("one.csv", "0 0\n5 1\n"), {});
  ASSERT_TRUE(one) << to_string(one.error());
  EXPECT_EQ(one->size(), 2u);
  const auto two = only_line(put("two.csv", "0 0\n5 1\n\n0 3\n5 3\n"), {});
  ASSERT_FALSE(two);
  EXPECT_NE(to_string(two.error()).find("2 lines in the file"), std::string::npos);
}

TEST_F(SectionDocument, LinesInSpaceSayWhatStandsOverTheEnds) {
  const std::string file = put("space.asc", "1000\t2000\t-5\ttop\t1\n1300\t2400\t-6\ttop\t1\n1600\t2800\t-9\ttop\t1\n");
  dobra::scenario::Table lines;
  lines.set("trace", std::vector<double>{1000, 2000, 1600, 2800});
  const auto made = document(file, lines);
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_NE(dobra::scenario::document_text(*made).find("orientation = \"SW - NE\""), std::string::npos);
  const auto flat = document(put("flat.csv", "x,z,name\n0,0,A\n9,1,A\n"));
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->input.find("orientation"), nullptr);
}

TEST_F(SectionDocument, ATableOfColoursAndTheOrientationGoToTheSheet) {
  const std::string file = put("two.csv", "x,z,name\n0,0,A\n90,5,A\n\n0,-9,B\n90,-4,B\n");
  const std::string table = put("colours.csv", "name,colour,age\nA,#010203,Jurassic\nC,#fff,\n");
  const auto made = call(
      {"restore", file, "--method", "shear", "--out", path("a.svg"), "--colours", table, "--orientation", "WSW - ENE"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find("nothing of the name 'C'"), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("does not name 'B'"), std::string::npos) << made.err;
  for (const char* const wanted : {"rgb(0.392157%,0.784314%,1.176471%)", "A - B (Jurassic)", ">WSW<", ">ENE<", ">two<"})
    EXPECT_NE(text("a.svg").find(wanted), std::string::npos) << wanted;
  const auto one = call({"restore", file, "--orientation", "west", "--out", path("b.svg")});
  EXPECT_EQ(one.code, 3);
  EXPECT_NE(one.err.find("needs two ends"), std::string::npos) << one.err;
  const auto bad = call({"restore", file, "--colours", put("bad.csv", "name,colour\nA,blu\n"), "--out", path("b.svg")});
  EXPECT_EQ(bad.code, 3);
  EXPECT_NE(bad.err.find("'A': 'blu' is not a colour"), std::string::npos) << bad.err;
}

}  // namespace
}  // namespace recon::cli
