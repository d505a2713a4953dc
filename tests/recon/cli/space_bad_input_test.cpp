// Bad input to recon surface, recon cut and recon block on sections in space: each ends with its code, its place and
// what to change, in text and in JSON, and writes nothing.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "recon/cli/block_commands.h"
#include "recon/cli/space_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

/// A document whose second section is bad, or that is called badly.
struct BadCase {
  const char* what;
  std::string input;               ///< What stands in [input] behind the first section.
  std::vector<std::string> words;  ///< In the message, with the place before it.
  std::string code;
  std::string file = "d.toml";  ///< Where it is told.
  std::size_t line = 0;         ///< There; 0: none.
  std::string command = "surface";
  std::vector<std::string> options = {};
  int exit = 3;
};

std::string second(const std::string& file, const std::string& trace = "[0, 500, 1000, 500]") {
  return "[[input.section]]\nname = \"second\"\nfile = \"" + file + "\"\n" +
         (trace.empty() ? "" : "trace = " + trace + "\n");
}

/// The first section stands in lines 4 to 7, the second in 8 to 11.
std::vector<BadCase> bad_cases() {
  const std::string good = second("a.csv");
  return {
      {"no file", second("none.csv"), {"second", "no such file", "d.toml:8"}, "file_not_found", "none.csv"},
      {"a folder", second("."), {"second", "is a folder", "give a file"}, "not_a_file", "."},
      {"an empty file", second("empty.csv"), {"second", "is empty", "d.toml:8"}, "empty_file", "empty.csv"},
      {"a header alone",
       second("header.csv"),
       {"second", "no points", "give at least two"},
       "empty_file",
       "header.csv"},
      {"no key file", "[[input.section]]\nname = \"second\"\n", {"'file' is missing"}, "missing_key", "d.toml", 8},
      {"a line of one point",
       second("point.csv"),
       {"second", "two distinct points"},
       "degenerate_curve",
       "point.csv",
       2},
      {"a NaN", second("nan.csv"), {"second", "not finite", "remove"}, "not_finite", "nan.csv", 3},
      {"a text for a number", second("text.csv"), {"second", "'abc'", "correct"}, "bad_format", "text.csv", 3},
      {"a row too short", second("short.csv"), {"second", "column 2"}, "bad_format", "short.csv", 3},
      {"bytes", second("bytes.csv"), {"second", "text file"}, "bad_format", "bytes.csv", 1},
      {"a kind misspelt", second("kind.csv"), {"second", "did you mean 'horizon'"}, "bad_format", "kind.csv", 2},
      {"faults alone", second("faults.csv"), {"second", "no horizon"}, "bad_section", "faults.csv"},
      {"a scenario that is none", second("broken.toml"), {"second", "TOML"}, "bad_syntax", "broken.toml", 2},
      {"a scenario of QUEBRA", second("quebra.toml"), {"second", "of recon"}, "wrong_program", "quebra.toml"},
      {"itself", second("d.toml"), {"second", "itself", "name the files"}, "bad_section", "d.toml"},
      {"a scenario without horizon", second("bare.toml"), {"second", "no horizon"}, "bad_section", "bare.toml"},
      {"a scenario with a wrong unit", second("unit.toml"), {"'furlong'", "'km'"}, "bad_value", "unit.toml", 4},
      {"no trace", second("a.csv", ""), {"second", "give its trace"}, "missing_key", "d.toml", 8},
      {"a trace of one point", second("a.csv", "[0, 500]"), {"second", "2 numbers"}, "bad_value", "d.toml", 8},
      {"a trace of three numbers", second("a.csv", "[0, 5, 9]"), {"3 numbers", "x0, y0"}, "bad_value", "d.toml", 8},
      {"a trace with NaN", second("a.csv", "[0, nan, 9, 9]"), {"number 2", "finite"}, "bad_value", "d.toml", 11},
      {"a trace in one place", second("a.csv", "[0, 9, 0, 9]"), {"second", "one place"}, "bad_value", "d.toml", 8},
      {"a trace that turns back", second("a.csv", "[0, 9, 9, 9, 0, 9]"), {"part it"}, "bad_value", "d.toml", 8},
      {"a trace too far off", second("a.csv", "[0, 1e300, 1000, 1e300]"), {"origin"}, "bad_value", "d.toml", 8},
      {"twice the same trace", second("a.csv", "[0, 0, 1000, 0]"), {"'second'", "leave one"}, "bad_section"},
      {"traces that overlap", second("a.csv", "[1500, 0, 500, 0]"), {"'second'", "part it"}, "bad_section"},
      {"lines beside the trace", second("far.csv"), {"second", "no part", "5000"}, "bad_value", "d.toml", 8},
      {"no line in common", second("others.csv"), {"'first' alone", "one name"}, "bad_section"},
      {"names by case", second("case.csv"), {"'A'", "'a'", "'second'", "write"}, "bad_section"},
      {"one section", "", {"two sections at least"}, "bad_section", "d.toml", 3},
      {"a name twice",
       "[[input.section]]\nname = \"first\"\nfile = \"a.csv\"\ntrace = [0, 9, 9, 9]\n",
       {"'first'", "name of its own"},
       "bad_section",
       "d.toml",
       8},
      {"a key unknown", good + "azimuth = 3\n", {"unknown key 'azimuth'"}, "unknown_key", "d.toml", 12},
      {"a unit unknown", good + "#unit = \"furlong\"\n", {"'unit'", "'km'"}, "bad_value", "d.toml", 4},
      {"a block of several",
       good + "#along_strike = 50\n",
       {"'along_strike'", "one section"},
       "bad_section",
       "d.toml",
       3},
      {"a trace of all", good + "#trace = [0, 0, 9, 9]\n", {"'trace'", "one section"}, "bad_section", "d.toml", 3},
      {"a horizon beside",
       good + "[[input.horizon]]\nname = \"Q\"\npoints = [[0, 0], [1, 1]]\n",
       {"a file of their own"},
       "bad_section",
       "d.toml",
       3},
      {"contours apart by less than nothing",
       good,
       {"greater than 0"},
       "bad_usage",
       "",
       0,
       "surface",
       {"--contours", "-5"},
       2},
      {"contours without end",
       good,
       {"greater interval"},
       "too_many_elements",
       "d.toml",
       0,
       "surface",
       {"--contours", "1e-12"},
       4},
      {"no rows", good, {"at least 1"}, "bad_usage", "", 0, "surface", {"--rows", "0"}, 2},
      {"too many rows", good, {"--rows", "at most 100"}, "bad_usage", "", 0, "surface", {"--rows", "101"}, 2},
      {"a tolerance below 0", good, {"at least 0"}, "bad_usage", "", 0, "surface", {"--mistie-tolerance", "-1"}, 2},
      {"an ending unknown", good, {".docx", ".ts"}, "bad_usage", "", 0, "surface", {"--out", "h.docx"}, 2},
      {"a cut beside all",
       good,
       {"no horizon lies under"},
       "bad_section",
       "d.toml",
       0,
       "cut",
       {"--trace", "0,9000,1000,9000"}},
      {"a cut without a trace", good, {"--trace", "x0,y0"}, "bad_usage", "", 0, "cut", {}, 2},
      {"a cut in one place", good, {"--trace", "one place"}, "bad_usage", "", 0, "cut", {"--trace", "3,3,3,3"}, 2},
      {"a cut of one place", good, {"--trace: 2 numbers"}, "bad_usage", "", 0, "cut", {"--trace", "3,3"}, 2},
      {"a cut of NaN", good, {"finite"}, "bad_usage", "", 0, "cut", {"--trace", "nan,3,3,3"}, 2},
      {"a cut of words", good, {"'west'", "number"}, "bad_usage", "", 0, "cut", {"--trace", "west,3,3,3"}, 2},
      {"less than nothing",
       good,
       {"at least 0"},
       "bad_usage",
       "",
       0,
       "cut",
       {"--trace", "0,90,900,90", "--simplify", "-1"},
       2},
      {"a block's length",
       good,
       {"one section"},
       "bad_usage",
       "",
       0,
       "cut",
       {"--trace", "0,90,900,90", "--along-strike", "5"},
       2},
      {"a cut of no file",
       second("none.csv"),
       {"second", "no such file"},
       "file_not_found",
       "none.csv",
       0,
       "cut",
       {"--trace", "0,90,900,90"}},
      {"a block of other units",
       second("others.csv"),
       {"section 'first'", "the same units in the same order"},
       "invalid_option",
       "d.toml",
       0,
       "block",
       {}},
      {"a block of a length",
       good,
       {"one section", "trace of its own"},
       "bad_section",
       "d.toml",
       0,
       "block",
       {"--along-strike", "50"}},
      {"a block of no length", good, {"greater than 0"}, "bad_usage", "", 0, "block", {"--along-strike", "0"}, 2},
  };
}

class SpaceBadInput : public dobra::test::CommandLine {
 protected:
  SpaceBadInput() : CommandLine(core::program(), {surface_command(), cut_command(), block_command()}) {
    const std::string head = "x,z,name,kind\n";
    const auto two = [&](const std::string& a, const std::string& b, int from) {
      return fmt::format("{0}{3},0,{1},horizon\n{4},9,{1},horizon\n\n{3},-100,{2},horizon\n{4},-90,{2},horizon\n", head,
                         a, b, from, from + 1000);
    };
    (void)put("a.csv", two("A", "B", 0));
    (void)put("others.csv", two("C", "D", 0));
    (void)put("case.csv", two("a", "b", 0));
    (void)put("far.csv", two("A", "B", 5000));
    (void)put("empty.csv", "");
    (void)put("header.csv", head);
    (void)put("point.csv", head + "0,0,A,horizon\n");
    (void)put("nan.csv", head + "0,0,A,horizon\n5,nan,A,horizon\n");
    (void)put("text.csv", head + "0,0,A,horizon\n5,abc,A,horizon\n");
    (void)put("short.csv", head + "0,0,A,horizon\n5\n");
    (void)put("bytes.csv", std::string("a\0b\1\2\3", 6));
    (void)put("kind.csv", head + "0,0,A,horzon\n9,0,A,horzon\n");
    (void)put("faults.csv", head + "0,0,F,fault\n9,-9,F,fault\n");
    (void)put("broken.toml", "dobra = 1\nprogram = \n");
    (void)put("quebra.toml", "dobra = 1\nprogram = \"quebra\"\n");
    (void)put("bare.toml", "dobra = 1\nprogram = \"recon\"\n[input]\n");
    (void)put("unit.toml", "dobra = 1\nprogram = \"recon\"\n[input]\nunit = \"furlong\"\n");
  }
};

TEST_F(SpaceBadInput, EndsWithItsCodePlaceAndWhatToChangeInTextAndInJson) {
  for (const BadCase& bad : bad_cases()) {
    SCOPED_TRACE(bad.what);
    std::string document = "dobra = 1\nprogram = \"recon\"\n[input]\n";
    std::string input = bad.input;
    if (const auto mark = input.find('#'); mark != std::string::npos) {  // a key of [input] itself
      document += input.substr(mark + 1);
      input.resize(mark);
    }
    document += "[[input.section]]\nname = \"first\"\nfile = \"a.csv\"\ntrace = [0, 0, 1000, 0]\n" + input;
    std::vector<std::string> args{bad.command, put("d.toml", document)};
    args.insert(args.end(), bad.options.begin(), bad.options.end());
    refuses(args, bad.exit, bad.words);
    args.emplace_back("--json");
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, bad.exit);
    const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
    if (json.is_discarded() || json["findings"].size() != 1) {
      ADD_FAILURE() << outcome.out << outcome.err;
      continue;
    }
    const auto& finding = json["findings"][0];
    EXPECT_EQ(finding["code"], bad.code);
    if (bad.file.empty()) continue;
    EXPECT_TRUE(finding["place"].contains("file") &&
                finding["place"]["file"].get<std::string>().ends_with(bad.file == "." ? "." : path(bad.file)))
        << finding;
    if (bad.line > 0) {
      EXPECT_EQ(finding["place"].value("line", 0U), bad.line) << finding;
    }
  }
}

/// One section: what is wrong in its input is told by the cut too, before anything is made of it.
TEST_F(SpaceBadInput, ValuesOfAWrongKindInASectionThatIsCutAreRefused) {
  const std::string head = "dobra = 1\nprogram = \"recon\"\n[input]\n";
  const std::string horizon = "[[input.horizon]]\nname = \"A\"\npoints = ";
  for (const auto& [input, word] : {std::pair("along_strike = \"far\"\n" + horizon + "[[0, 0], [9, 0]]\n", "d.toml:4"),
                                    {"along_strike = 50\n" + horizon + "3\n", "d.toml:7"},
                                    {"along_strike = 50\nunit = 3\n" + horizon + "[[0, 0], [9, 0]]\n", "d.toml:5"}})
    refuses({"cut", put("d.toml", head + input), "--trace", "0,0,9,0"}, 3, {word});
}

/// What is read all the same says where names differ by their capitals alone.
TEST_F(SpaceBadInput, NamesThatDifferByCaseAreTold) {
  (void)put("half.csv", "x,z,name,kind\n0,0,A,horizon\n1000,9,A,horizon\n\n0,-100,b,horizon\n1000,-90,b,horizon\n");
  const std::string document =
      put("d.toml",
          "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.section]]\nname = \"first\"\nfile = \"a.csv\"\ntrace = [0, "
          "0, 1000, 0]\n" +
              second("half.csv"));
  const auto outcome = call({"surface", document});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("horizon 'B' is in section 'first' alone; a surface takes two; section 'second' has 'b': "
                             "write both alike if they are one"),
            std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace recon::cli
