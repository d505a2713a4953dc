// The arrows of docs/architecture.md: a file may include only what its folder is allowed to use.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Direct arrows; what can be reached over them may be included too.
const std::map<std::string, std::set<std::string>>& arrows() {
  static const std::map<std::string, std::set<std::string>> table = {
      {"shared/base", {}},
      {"shared/geom", {"shared/base"}},
      {"shared/topo", {"shared/geom"}},
      {"shared/offset", {"shared/topo"}},
      {"shared/mesh", {"shared/topo"}},
      {"shared/scene", {"shared/geom"}},
      {"shared/io", {"shared/mesh", "shared/scene"}},
      {"shared/scenario", {"shared/io"}},
      {"shared/render", {"shared/scene", "shared/io"}},
      {"shared/cli", {"shared/render", "shared/scenario"}},
      {"shared/gui", {"shared/render", "shared/scenario"}},
      {"recon/core", {"shared/offset", "shared/mesh", "shared/scene", "shared/io", "shared/scenario"}},
      {"quebra/core", {"shared/offset", "shared/mesh", "shared/scene", "shared/io", "shared/scenario"}},
      {"recon/gui", {"recon/core", "shared/gui"}},
      {"quebra/gui", {"quebra/core", "shared/gui"}},
      {"recon", {"recon/core", "recon/gui", "shared/cli"}},
      {"quebra", {"quebra/core", "quebra/gui", "shared/cli"}},
  };
  return table;
}

bool reaches(const std::string& from, const std::string& to) {
  if (from == to) return true;
  const auto& direct = arrows().at(from);
  return std::any_of(direct.begin(), direct.end(), [&](const std::string& next) { return reaches(next, to); });
}

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

/// Only these may see the toolkits.
bool may_include_vtk(const std::string& folder) { return folder == "shared/render" || folder == "shared/gui"; }
bool may_include_qt(const std::string& folder) { return folder == "shared/gui" || folder.ends_with("/gui"); }

/// What is wrong with one include of a file in `folder`; empty if nothing is.
std::string objection(const std::string& folder, const std::string& included) {
  static const std::regex own("(shared|recon|quebra)/.*");
  if (std::regex_match(included, own)) {
    const std::string target = folder_of(included);
    if (!arrows().contains(target)) return "is in a folder that the arrows do not know";
    if (!reaches(folder, target)) return "is against the arrows";
  }
  if (included.starts_with("vtk") && !may_include_vtk(folder)) return "is VTK outside render and gui";
  if (std::regex_match(included, std::regex("Q[A-Z].*|Qt.*")) && !may_include_qt(folder)) return "is Qt outside gui";
  return {};
}

TEST(Arrows, NoFileIncludesAgainstThem) {
  const fs::path root = DOBRA_SOURCE_DIR;
  const std::regex include_line("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"].*");
  std::size_t files = 0;
  for (const char* top : {"shared", "recon", "quebra"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      ++files;
      const std::string file = fs::relative(entry.path(), root).generic_string();
      ASSERT_TRUE(arrows().contains(folder_of(file))) << file << " is in a folder that the arrows do not know";
      std::ifstream in(entry.path());
      std::string line;
      for (std::size_t number = 1; std::getline(in, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, include_line)) continue;
        const std::string trouble = objection(folder_of(file), match[1]);
        EXPECT_TRUE(trouble.empty()) << file << ':' << number << ": " << match[1] << ' ' << trouble;
      }
    }
  }
  EXPECT_GT(files, 50U);
}

TEST(Arrows, AnIncludeAgainstThemIsNoticed) {
  EXPECT_FALSE(objection("shared/geom", "shared/topo/subdivision.h").empty());
  EXPECT_FALSE(objection("recon/core", "quebra/core/domain.h").empty());
  EXPECT_FALSE(objection("shared/scene", "vtkActor.h").empty());
  EXPECT_FALSE(objection("shared/render", "QWidget").empty());
  EXPECT_TRUE(objection("shared/offset", "shared/geom/point.h").empty());
  EXPECT_TRUE(objection("recon/gui", "QWidget").empty());
}

}  // namespace
