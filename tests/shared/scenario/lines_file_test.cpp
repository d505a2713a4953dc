#include "shared/scenario/lines_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "shared/scenario/entries.h"

namespace dobra::scenario {
namespace {

namespace fs = std::filesystem;

class LinesFile : public testing::Test {
 protected:
  LinesFile() {
    std::string name = (fs::temp_directory_path() / "dobra_lines_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~LinesFile() override { fs::remove_all(folder); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  std::string bytes(const std::string& name) const {
    std::ifstream in(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// What reading the scenario says against it; empty if nothing.
  std::string complaint(const std::string& own, const std::string& lines) const {
    write("side.toml", lines);
    const auto read = read_document(write("main.toml", own));
    return read ? "" : base::to_string(read.error());
  }
  fs::path folder;
};

const std::string own = R"(# by hand
dobra = 1
program = "fake"
lines_file = "side.toml"   # below

[input]
depth =   3.50
[[step]]
operation = "grid"
)";
const std::string lines = R"(dobra = 1
program = "fake"
# the top is doubtful
[[input.horizon]]
name = "top"
points = [[0, 0],  [1, 2]]
[[input.fault]]
name = "F"
points = [[0, 1], [1, 1]]
)";

TEST_F(LinesFile, ItsTablesAreThoseOfTheInput) {
  write("side.toml", lines);
  const auto read = read_document(write("main.toml", own));
  ASSERT_TRUE(read) << base::to_string(read.error());
  Entries horizons = entries_of(read->input, "horizon");
  ASSERT_EQ(horizons.size(), 1U);
  EXPECT_EQ(text_in(horizons[0], "name"), "top");
  EXPECT_EQ(horizons[0].place("points").file, (folder / "side.toml").string());
  EXPECT_EQ(horizons[0].place("points").line, 6U);
  EXPECT_EQ(read->steps.size(), 1U);
}

TEST_F(LinesFile, WhatHasNotChangedIsWrittenToTheByteInBoth) {
  write("side.toml", lines);
  const fs::path file = write("main.toml", own);
  auto read = read_document(file);
  ASSERT_TRUE(read);
  ASSERT_TRUE(write_document(*read, file));
  EXPECT_EQ(bytes("main.toml"), own);
  EXPECT_EQ(bytes("side.toml"), lines);
  Entries faults = entries_of(read->input, "fault");
  faults[0].set("points", std::vector<geom::Point>{{0, 1}, {9, 1}});
  set_entries(read->input, "fault", faults);
  ASSERT_TRUE(write_document(*read, file));
  EXPECT_EQ(bytes("main.toml"), own);
  std::string expected = lines;
  expected.replace(expected.find("[[0, 1], [1, 1]]"), 16, "[[0, 1], [9.0, 1.0]]");
  EXPECT_EQ(bytes("side.toml"), expected);
}

TEST_F(LinesFile, LinesMoveOutAndBackWithoutLoss) {
  const std::string whole =
      "# by hand\ndobra = 1\nprogram = \"fake\"\n\n[input]\ndepth =   3.50\n\n# doubtful\n"
      "[[input.horizon]]\nname = \"top\"\npoints = [[0, 0],  [1, 2]]\n\n[[step]]\noperation = \"grid\"\n";
  const fs::path file = write("main.toml", whole);
  const Document before = read_document(file).value();
  Document beside = before;
  beside.lines_file = lines_name(file);
  EXPECT_EQ(beside.lines_file, "main.lines.toml");
  ASSERT_TRUE(write_document(beside, file));
  EXPECT_EQ(bytes("main.toml").find("horizon"), std::string::npos) << bytes("main.toml");
  EXPECT_NE(bytes("main.toml").find("depth =   3.50"), std::string::npos);
  EXPECT_NE(bytes("main.lines.toml").find("# doubtful"), std::string::npos) << bytes("main.lines.toml");
  const Document again = read_document(file).value();
  EXPECT_EQ(again.input, before.input);
  // Undo is the document before: its bytes come back.
  ASSERT_TRUE(write_document(before, file));
  EXPECT_EQ(bytes("main.toml"), whole);
  // So they do from the file beside, but for the layout of what went there and back.
  Document back = again;
  back.lines_file.clear();
  ASSERT_TRUE(write_document(back, file));
  const Document last = read_document(file).value();
  EXPECT_EQ(last.input, before.input);
  EXPECT_EQ(document_text(last), document_text(before));
}

TEST_F(LinesFile, AFileThatIsNoneIsRefusedWithItsPlace) {
  EXPECT_EQ(complaint(own, lines), "");
  EXPECT_NE(complaint(own, lines + "[[step]]\noperation = \"grid\"\n").find("side.toml:10"), std::string::npos);
  EXPECT_NE(complaint(own, "dobra = 1\nprogram = \"fake\"\n[input]\ndepth = 4\n").find("side.toml:4"),
            std::string::npos);
  EXPECT_NE(complaint(own, "dobra = 1\nprogram = \"other\"\n").find("'other'"), std::string::npos);
  EXPECT_NE(complaint(own, "unit_system = \"km, Pa\"\n" + lines).find("unit_system"), std::string::npos);
  EXPECT_NE(complaint(own, "lines_file = \"x.toml\"\n" + lines).find("lines_file"), std::string::npos);
  EXPECT_NE(complaint(own, "").find("side.toml"), std::string::npos);
  EXPECT_NE(complaint(own, std::string("\0\1\2", 3)).find("side.toml"), std::string::npos);
  EXPECT_NE(complaint(own, "horizon = [\n").find("side.toml:"), std::string::npos);
  EXPECT_NE(complaint("dobra = 1\nprogram = \"fake\"\nlines_file = \"main.toml\"\n", lines).find("itself"),
            std::string::npos);
  EXPECT_NE(complaint("dobra = 1\nprogram = \"fake\"\nlines_file = 3\n", lines).find("main.toml:3"), std::string::npos);
  fs::remove(folder / "side.toml");
  const auto gone = read_document(write("main.toml", own));
  ASSERT_FALSE(gone);
  EXPECT_NE(base::to_string(gone.error()).find("'main.toml' names it as its lines_file"), std::string::npos)
      << base::to_string(gone.error());
}

TEST_F(LinesFile, NoLinesAreAnEmptyFileThatIsReadAgain) {
  Document document =
      parse_document("dobra = 1\nprogram = \"fake\"\n[input]\ndepth = 1\n", folder / "main.toml").value();
  document.lines_file = "side.toml";
  ASSERT_TRUE(write_document(document, document.file));
  const auto read = read_document(document.file);
  ASSERT_TRUE(read) << base::to_string(read.error());
  EXPECT_EQ(read->input, document.input);
}

}  // namespace
}  // namespace dobra::scenario
