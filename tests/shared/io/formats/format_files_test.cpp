// docs/contributing.md says of every format in which files it stands and which others include its headers: so it is,
// and nothing else in the tree knows an ending.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "shared/io/file.h"
#include "shared/io/formats/format.h"

namespace dobra::io::formats {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

constexpr const char* table_file = "shared/io/formats/format_table.cpp";

/// What the page says of some formats that stand in the same files.
struct Told {
  std::set<std::string> formats, files, includers;
  std::string reason;
};

std::set<std::string> quoted_in(const std::string& cell) {
  static const std::regex quoted("`([^`]*)`");
  std::set<std::string> words;
  for (std::sregex_iterator match(cell.begin(), cell.end(), quoted); match != std::sregex_iterator(); ++match)
    words.insert((*match)[1]);
  return words;
}

std::vector<Told> told_by_the_page() {
  std::istringstream page(read_text(std::string(DOBRA_SOURCE_DIR) + "/docs/contributing.md").value());
  std::vector<Told> all;
  bool here = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) here = line == "## A new format";
    if (!here || !line.starts_with("| `")) continue;
    std::istringstream row(line.substr(1));
    std::string formats, files, others;
    std::getline(row, formats, '|');
    std::getline(row, files, '|');
    std::getline(row, others, '|');
    all.push_back({quoted_in(formats), quoted_in(files), quoted_in(others), others});
  }
  return all;
}

/// The code of the programs and of what they share, by path from the root.
const std::map<std::string, std::string>& tree() {
  static const std::map<std::string, std::string> texts = [] {
    std::map<std::string, std::string> all;
    const fs::path root = DOBRA_SOURCE_DIR;
    for (const char* const top : {"shared", "recon", "quebra"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        all[fs::relative(entry.path(), root).generic_string()] = read_text(entry.path().string()).value();
      }
    }
    return all;
  }();
  return texts;
}

/// What stands between double quotes outside comments and #include lines.
std::vector<std::string> literals_of(const std::string& text) {
  std::vector<std::string> literals;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool comment = text.compare(i, 2, "//") == 0;
    if (comment || text.compare(i, 8, "#include") == 0) {
      i = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 3, "'\"'") == 0) {
      i += 2;
    } else if (text[i] == '"') {
      std::string literal;
      for (++i; i < text.size() && text[i] != '"'; ++i) {
        if (text[i] == '\\') ++i;
        literal += text[i];
      }
      literals.push_back(literal);
    }
  }
  return literals;
}

/// The endings of formats that a literal knows: ".svg", "*.svg", "a file (.svg .dxf)"; but not "restored.csv", which is
/// the name of a file that is written.
std::vector<std::string> endings_in(const std::string& literal) {
  static const std::set<std::string> known = [] {
    std::set<std::string> endings;
    for (const Format& format : all_formats()) endings.insert(format.endings.begin(), format.endings.end());
    return endings;
  }();
  std::vector<std::string> found;
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t dot = literal.find('.'); dot != std::string::npos; dot = literal.find('.', dot + 1)) {
    if (dot > 0 && (is_word(literal[dot - 1]) || literal[dot - 1] == '}')) continue;
    std::size_t end = dot + 1;
    while (end < literal.size() && is_word(literal[end])) ++end;
    if (const std::string ending = literal.substr(dot, end - dot); known.contains(ending)) found.push_back(ending);
  }
  return found;
}

TEST(FormatFiles, ThePageNamesEveryFormatOnceAndItsFilesAreThere) {
  std::set<std::string> formats, files;
  for (const Told& told : told_by_the_page()) {
    for (const std::string& format : told.formats) EXPECT_TRUE(formats.insert(format).second) << format;
    for (const std::string& file : told.files) {
      EXPECT_TRUE(files.insert(file).second) << file;
      EXPECT_TRUE(tree().contains(file)) << file;
    }
  }
  std::set<std::string> rows;
  for (const Format& format : all_formats()) rows.insert(std::string(format.name));
  EXPECT_EQ(formats, rows);
}

TEST(FormatFiles, AFormatIsAHeaderAndASourceOrThePageSaysWhyNot) {
  std::size_t pairs = 0;
  for (const Told& told : told_by_the_page()) {
    const bool pair =
        told.files.size() == 2 && fs::path(*told.files.begin()).stem() == fs::path(*told.files.rbegin()).stem();
    pairs += pair ? 1 : 0;
    const std::string words = std::regex_replace(told.reason, std::regex("`[^`]*`"), "");
    const bool reason = std::any_of(words.begin(), words.end(), [](char c) { return c != ' ' && c != ','; });
    EXPECT_TRUE(pair || reason) << *told.formats.begin();
  }
  EXPECT_GE(pairs, 9U);
}

TEST(FormatFiles, OnlyTheTableAndWhomThePageNamesIncludeTheHeadersOfAFormat) {
  for (const Told& told : told_by_the_page()) {
    std::set<std::string> includers;
    for (const auto& [file, text] : tree()) {
      if (file == table_file || told.files.contains(file)) continue;
      for (const std::string& header : told.files) {
        if (header.ends_with(".h") && text.find("#include \"" + header + '"') != std::string::npos)
          includers.insert(file);
      }
    }
    EXPECT_EQ(includers, told.includers) << *told.formats.begin();
  }
}

TEST(FormatFiles, NoOtherFileKnowsAnEnding) {
  std::map<std::string, std::set<std::string>> own;
  for (const Told& told : told_by_the_page()) {
    for (const std::string& name : told.formats) {
      for (const Format& format : all_formats()) {
        if (format.name != name) continue;
        for (const std::string& file : told.files) own[file].insert(format.endings.begin(), format.endings.end());
      }
    }
  }
  // A picture that is drawn is no row: what cairo writes.
  for (const char* const file : {"shared/render/cairo.h", "shared/render/cairo.cpp", "shared/render/space_file.cpp"})
    own[file].insert(".svg");
  for (const auto& [file, text] : tree()) {
    if (file == table_file) continue;
    for (const std::string& literal : literals_of(text)) {
      for (const std::string& ending : endings_in(literal))
        EXPECT_TRUE(own[file].contains(ending)) << file << " knows " << ending << ": \"" << literal << '"';
    }
  }
}

TEST(FormatFiles, AnEndingThatIsKnownElsewhereIsNoticed) {
  const auto found = [](const std::string& code) {
    std::vector<std::string> all;
    for (const std::string& literal : literals_of(code)) {
      for (const std::string& ending : endings_in(literal)) all.push_back(ending);
    }
    return all;
  };
  EXPECT_THAT(found(R"x(if (ending == ".svg" || path.ends_with(".msh2")) return;)x"), ElementsAre(".svg", ".msh2"));
  EXPECT_THAT(found(R"x(help = "Lines (*.dxf *.shp)")x"), ElementsAre(".dxf", ".shp"));
  EXPECT_THAT(found(R"x(c == '"' ? "x" : ".geo")x"), ElementsAre(".geo"));
  EXPECT_THAT(found(R"x(write("restored.csv"); // not ".csv")x"), ElementsAre());
  EXPECT_THAT(found(R"x(fmt::format("{}.csv", name) + ".docx" + "3.5" + "...")x"), ElementsAre());
}

}  // namespace
}  // namespace dobra::io::formats
