// docs/contributing.md says of one operation of each program in which code files it stands: these and no others.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// What stands between back quotes on a line.
std::vector<std::string> quoted_on(const std::string& line) {
  std::vector<std::string> quoted;
  std::istringstream parts(line);
  std::string part;
  for (bool inside = false; std::getline(parts, part, '`'); inside = !inside) {
    if (inside) quoted.push_back(part);
  }
  return quoted;
}

/// What the page tells of the operation whose section begins with this title.
struct Told {
  std::set<std::string> files;     ///< First column of its table.
  std::vector<std::string> names;  ///< Those that it says to stand in no other file.
};
Told told_under(const std::string& title) {
  Told told;
  std::istringstream page(text_of(fs::path(DOBRA_SOURCE_DIR) / "docs/contributing.md"));
  bool here = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) here = line.ends_with(title);
    if (!here) continue;
    const std::vector<std::string> quoted = quoted_on(line);
    if (line.starts_with("| `")) told.files.insert(quoted.front());
    if (line.starts_with("No other code file names")) told.names = quoted;
  }
  return told;
}

bool is_part_of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool names(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || !is_part_of_a_name(text[at - 1]);
    const std::size_t end = at + name.size();
    if (begins && (end == text.size() || !is_part_of_a_name(text[end]))) return true;
  }
  return false;
}

/// The code files of the programs and of what they share in which one of the names stands.
std::set<std::string> files_that_name(const std::vector<std::string>& wanted) {
  const fs::path root = DOBRA_SOURCE_DIR;
  std::set<std::string> found;
  for (const char* top : {"shared", "recon", "quebra"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string text = text_of(entry.path());
      const auto stands = [&](const std::string& name) { return names(text, name); };
      if (std::any_of(wanted.begin(), wanted.end(), stands))
        found.insert(fs::relative(entry.path(), root).generic_string());
    }
  }
  return found;
}

TEST(Contributing, AnOperationOfReconStandsInTheFilesThatThePageTells) {
  const Told told = told_under("An operation of RECON");
  EXPECT_GE(told.names.size(), 3U);
  EXPECT_LE(told.files.size(), 5U);
  EXPECT_EQ(files_that_name(told.names), told.files);
}

TEST(Contributing, AnOperationOfQuebraStandsInTheFilesThatThePageTells) {
  const Told told = told_under("An operation of QUEBRA");
  EXPECT_GE(told.names.size(), 2U);
  EXPECT_LE(told.files.size(), 5U);
  EXPECT_EQ(files_that_name(told.names), told.files);
}

TEST(Contributing, AFurtherFileThatNamesTheOperationIsNoticed) {
  EXPECT_TRUE(names("const CarryParams& params", "CarryParams"));
  EXPECT_FALSE(names("const OtherCarryParams& params", "CarryParams"));
  EXPECT_FALSE(names("CarryParamsOfOld", "CarryParams"));
  EXPECT_GT(files_that_name({"Result"}).size(), 100U);
}

}  // namespace
