// The arrows of docs/architecture.md: a file may include only what its folder is allowed to use.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Direct arrows; what can be reached over them may be included too.
const std::map<std::string, std::set<std::string>>& arrows() {
  static const std::map<std::string, std::set<std::string>> table = {
      {"shared/base", {}},
      {"shared/geom", {"shared/base"}},
      {"shared/geom/fit", {"shared/geom"}},
      {"shared/surf", {"shared/geom"}},
      {"shared/topo", {"shared/geom"}},
      {"shared/offset/types", {"shared/geom"}},
      {"shared/offset/kernel", {"shared/offset/types"}},
      {"shared/offset/monotone", {"shared/offset/kernel"}},
      {"shared/offset/general", {"shared/offset/kernel"}},
      {"shared/offset/verifier", {"shared/offset/types"}},
      {"shared/offset/stepper", {"shared/offset/kernel", "shared/topo"}},
      {"shared/offset",
       {"shared/offset/monotone", "shared/offset/general", "shared/offset/verifier", "shared/offset/stepper"}},
      {"shared/mesh", {"shared/topo"}},
      {"shared/solid", {"shared/topo", "shared/mesh"}},
      {"shared/solid/shape", {"shared/solid"}},
      {"shared/solid/check", {"shared/solid"}},
      {"shared/solid/csg", {"shared/solid/shape", "shared/solid/check"}},
      {"shared/solid/partition", {"shared/solid"}},
      {"shared/mesh/delaunay", {"shared/mesh"}},
      {"shared/mesh/sizing", {"shared/mesh/delaunay"}},
      {"shared/mesh/front", {"shared/mesh/sizing"}},
      {"shared/surf/trim", {"shared/surf", "shared/topo"}},
      {"shared/surf/mesh", {"shared/surf/trim", "shared/mesh/front"}},
      {"shared/surf/paper", {"shared/surf/mesh"}},
      {"shared/surf/param", {"shared/surf", "shared/mesh", "shared/geom/fit"}},
      {"shared/surf/loft", {"shared/surf"}},
      {"shared/surf/remesh", {"shared/surf/param", "shared/surf/mesh"}},
      {"shared/fem", {"shared/mesh"}},
      {"shared/fem/error", {"shared/fem", "shared/geom/fit"}},
      {"shared/fem/fracture", {"shared/fem/error"}},
      {"shared/scene", {"shared/geom"}},
      {"shared/scene/space", {"shared/scene"}},
      {"shared/canvas", {"shared/scene"}},
      {"shared/io", {"shared/geom"}},
      {"shared/io/lines", {"shared/io"}},
      {"shared/io/gis", {"shared/io/lines", "shared/scene"}},
      {"shared/io/drawings", {"shared/io"}},
      {"shared/io/brep", {"shared/io"}},
      {"shared/io/faces", {"shared/io/brep", "shared/surf/mesh"}},
      {"shared/io/meshes", {"shared/io", "shared/mesh/delaunay"}},
      {"shared/io/formats", {"shared/io/gis", "shared/io/drawings", "shared/io/meshes"}},
      {"shared/scenario", {"shared/io", "shared/scene/space"}},
      {"shared/render", {"shared/scene/space", "shared/io"}},
      {"shared/scenario/lines", {"shared/scenario", "shared/io/formats"}},
      {"shared/operations", {"shared/scenario/lines", "shared/offset"}},
      {"shared/cli", {"shared/render", "shared/operations", "shared/solid/partition", "shared/solid/check"}},
      {"shared/gui/words", {"shared/base"}},
      {"shared/gui/documents", {"shared/scenario"}},
      {"shared/gui/theme", {"shared/scene"}},
      {"shared/gui/frames", {"shared/base"}},
      {"shared/gui/heard", {"shared/base"}},
      {"shared/gui/numbers", {"shared/scenario", "shared/gui/words"}},
      {"shared/gui/labels", {"shared/gui/theme", "shared/gui/words"}},
      {"shared/gui/mending", {"shared/gui/theme", "shared/gui/words"}},
      {"shared/gui/view", {"shared/canvas", "shared/gui/words"}},
      {"shared/gui/actions", {"shared/gui/theme"}},
      {"shared/gui/catalogue", {"shared/scene"}},
      {"shared/gui/welcome", {"shared/io", "shared/gui/words"}},
      {"shared/gui/sheet", {"shared/canvas", "shared/gui/theme"}},
      {"shared/gui/vertices", {"shared/gui/documents", "shared/canvas", "shared/gui/words"}},
      {"shared/gui/importing", {"shared/scenario/lines", "shared/gui/theme", "shared/gui/words"}},
      {"shared/gui/stage",
       {"shared/gui/words", "shared/gui/frames", "shared/gui/theme", "shared/canvas", "shared/render"}},
      {"shared/gui",
       {"shared/gui/stage", "shared/gui/words", "shared/gui/documents", "shared/gui/frames", "shared/gui/numbers",
        "shared/gui/labels", "shared/gui/mending", "shared/gui/actions", "shared/gui/theme", "shared/gui/view",
        "shared/gui/vertices", "shared/gui/sheet", "shared/gui/catalogue", "shared/gui/importing", "shared/gui/heard",
        "shared/gui/welcome", "shared/render", "shared/scenario", "shared/canvas"}},
      {"recon/section", {"shared/topo", "shared/scene"}},
      {"recon/input", {"recon/section", "recon/faults", "shared/scenario/lines"}},
      {"recon/block", {"recon/input", "shared/solid/shape"}},
      {"recon/maps", {"shared/geom"}},
      {"recon/balance", {"recon/section", "recon/maps", "shared/mesh/front", "shared/scenario", "shared/io/formats"}},
      {"recon/space", {"recon/input", "shared/surf/loft"}},
      {"recon/unfold", {"recon/input", "recon/maps", "recon/balance", "shared/offset"}},
      {"recon/kinematics", {"recon/maps", "shared/offset"}},
      {"recon/faults", {"recon/section", "recon/kinematics", "shared/scenario"}},
      {"recon/moving", {"recon/faults", "recon/balance"}},
      {"recon/jigsaw", {"recon/unfold", "recon/moving"}},
      {"recon/inversion", {"recon/moving"}},
      {"recon/model", {"recon/jigsaw"}},
      {"recon/core", {"recon/model", "recon/inversion", "recon/block", "recon/space", "shared/operations"}},
      {"quebra/sketch", {"shared/scenario/lines"}},
      {"quebra/domain", {"quebra/sketch"}},
      {"quebra/repair", {"quebra/domain"}},
      {"quebra/model", {"quebra/domain", "shared/mesh/sizing", "shared/fem/fracture", "shared/surf/mesh"}},
      {"quebra/meshing", {"quebra/model", "shared/mesh/front", "shared/surf/paper", "shared/offset"}},
      {"quebra/surfaces", {"quebra/meshing", "shared/io/faces", "shared/solid"}},
      {"quebra/solids", {"quebra/meshing", "shared/io/formats", "shared/solid/csg"}},
      {"quebra/analysis", {"quebra/meshing"}},
      {"quebra/core", {"quebra/repair", "quebra/analysis", "quebra/surfaces", "quebra/solids", "shared/operations"}},
      {"quebra/validation", {"quebra/core"}},
      {"recon/gui", {"recon/core", "shared/gui"}},
      {"recon/cli", {"recon/core", "shared/cli", "shared/solid/csg"}},
      {"quebra/gui", {"quebra/core", "shared/gui"}},
      {"recon", {"recon/core", "recon/cli", "recon/gui", "shared/cli"}},
      {"quebra/cli", {"quebra/validation", "shared/cli", "shared/surf/remesh"}},
      {"quebra", {"quebra/core", "quebra/cli", "quebra/gui", "shared/cli"}},
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
bool may_include_gdal(const std::string& folder) { return folder == "shared/io/gis"; }
bool may_include_vtk(const std::string& folder) { return folder == "shared/render" || folder == "shared/gui/stage"; }
bool may_include_qt(const std::string& folder) { return folder.starts_with("shared/gui") || folder.ends_with("/gui"); }

/// The name between the quotes or angle brackets of an #include line.
std::optional<std::string> included_by(const std::string& line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line[hash] != '#') return std::nullopt;
  const std::size_t word = line.find_first_not_of(" \t", hash + 1);
  if (word == std::string::npos || line.compare(word, 7, "include") != 0) return std::nullopt;
  const std::size_t open = line.find_first_of("<\"", word);
  const std::size_t close = line.find_first_of(">\"", open + 1);
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  return line.substr(open + 1, close - open - 1);
}

/// What is wrong with one include of a file in `folder`; empty if nothing is.
std::string objection(const std::string& folder, const std::string& included) {
  if (included.starts_with("shared/") || included.starts_with("recon/") || included.starts_with("quebra/")) {
    const std::string target = folder_of(included);
    if (!arrows().contains(target)) return "is in a folder that the arrows do not know";
    if (!reaches(folder, target)) return "is against the arrows";
  }
  if (included.starts_with("vtk") && !may_include_vtk(folder)) return "is VTK outside render and gui";
  const bool is_qt =
      included.size() > 1 && included[0] == 'Q' && (std::isupper(included[1]) != 0 || included[1] == 't');
  if (is_qt && !may_include_qt(folder)) return "is Qt outside gui";
  const bool is_gdal = included.starts_with("gdal") || included.starts_with("ogr") || included.starts_with("cpl_");
  if (is_gdal && !may_include_gdal(folder)) return "is GDAL outside io/gis";
  return {};
}

TEST(Arrows, NoFileIncludesAgainstThem) {
  const fs::path root = DOBRA_SOURCE_DIR;
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
        const auto included = included_by(line);
        if (!included) continue;
        const std::string trouble = objection(folder_of(file), *included);
        EXPECT_TRUE(trouble.empty()) << file << ':' << number << ": " << *included << ' ' << trouble;
      }
    }
  }
  EXPECT_GT(files, 50U);
}

/// The namespace that a folder must have: shared/io/lines is dobra::io::lines.
std::string namespace_of(const std::string& folder) {
  std::string name;
  for (const fs::path& part : fs::path(folder)) {
    name += (name.empty() ? "" : "::") + (part == "shared" ? std::string("dobra") : part.string());
  }
  return name;
}

/// The namespaces that a file opens at the margin; an inline one with the one around it.
std::vector<std::string> namespaces_in(std::istream& in) {
  const std::string opens = "namespace ", opens_inline = "inline namespace ";
  std::vector<std::string> found;
  for (std::string line; std::getline(in, line);) {
    if (!line.ends_with(" {") || line == "namespace {") continue;
    const auto name = [&](const std::string& words) {
      return line.substr(words.size(), line.size() - words.size() - 2);
    };
    if (line.starts_with(opens)) found.push_back(name(opens));
    if (line.starts_with(opens_inline) && !found.empty()) found.push_back(found.back() + "::" + name(opens_inline));
  }
  return found;
}

TEST(Arrows, FolderIsNamespaceAndHoldsNoMoreThanFortyFiles) {
  const fs::path root = DOBRA_SOURCE_DIR;
  std::map<std::string, int> files;
  for (const char* top : {"shared", "recon", "quebra"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string folder = folder_of(fs::relative(entry.path(), root).generic_string());
      ++files[folder];
      std::ifstream in(entry.path());
      const std::vector<std::string> names = namespaces_in(in);
      const bool own = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return name == namespace_of(folder) || name.starts_with(namespace_of(folder) + "::");
      });
      EXPECT_TRUE(own || entry.path().filename() == "main.cpp") << entry.path() << ": " << namespace_of(folder);
    }
  }
  for (const auto& [folder, count] : files) EXPECT_LE(count, 40) << folder;
}

TEST(Arrows, EveryFormOfIncludeIsRead) {
  EXPECT_EQ(included_by("#include \"shared/geom/point.h\""), "shared/geom/point.h");
  EXPECT_EQ(included_by("  #  include <QWidget>  // why"), "QWidget");
  EXPECT_EQ(included_by("// #include <vector>"), std::nullopt);
}

TEST(Arrows, AnIncludeAgainstThemIsNoticed) {
  EXPECT_FALSE(objection("shared/geom", "shared/topo/subdivision.h").empty());
  EXPECT_FALSE(objection("recon/core", "quebra/domain/domain.h").empty());
  EXPECT_FALSE(objection("shared/scene", "vtkActor.h").empty());
  EXPECT_FALSE(objection("shared/render", "QWidget").empty());
  EXPECT_FALSE(objection("shared/io/lines", "ogrsf_frmts.h").empty());
  EXPECT_FALSE(objection("shared/io/lines", "shared/mesh/element_mesh.h").empty());
  EXPECT_TRUE(objection("shared/offset", "shared/geom/point.h").empty());
  EXPECT_TRUE(objection("recon/gui", "QWidget").empty());
}

/// A path of one machine in a source, a test or a page is found on no other.
TEST(Arrows, NoFileNamesAFolderOutsideTheTree) {
  const fs::path root = DOBRA_SOURCE_DIR;
  const std::set<std::string> read{".h", ".cpp", ".md", ".txt", ".cmake", ".toml", ".py", ".json"};
  std::vector<std::string> folders;
  for (const char* name : {"work", "home", "root", "Users"}) folders.push_back(std::string("/") + name + "/");
  std::size_t files = 0;
  for (const char* top : {"shared", "recon", "quebra", "tests", "docs", "resources", "scripts"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const bool is_text = read.contains(entry.path().extension().string()) || std::string(top) == "scripts";
      if (!entry.is_regular_file() || !is_text) continue;
      ++files;
      std::ifstream stream(entry.path());
      std::size_t number = 0;
      for (std::string line; std::getline(stream, line);) {
        ++number;
        for (const std::string& folder : folders) {
          const std::size_t at = line.find(folder);
          if (at == std::string::npos) continue;
          const bool begins = at == 0 || std::string(" \"'(=<`").find(line[at - 1]) != std::string::npos;
          EXPECT_FALSE(begins) << fs::relative(entry.path(), root).generic_string() << ':' << number << ": " << line;
        }
      }
    }
  }
  EXPECT_GT(files, 500U);
}

/// The character at a place, or a space beyond the ends.
char at_or_space(const std::string& line, std::size_t at) { return at < line.size() ? line[at] : ' '; }
bool is_alnum(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// The ID of a requirement: REC-4, OFF-a, E-11.
bool has_requirement_id(const std::string& line) {
  for (const std::string prefix : {"HED-", "OFF-", "REC-", "QUE-", "SUR-", "CRV-", "E-"}) {
    for (std::size_t at = line.find(prefix); at != std::string::npos; at = line.find(prefix, at + 1)) {
      const char next = at_or_space(line, at + prefix.size());
      const bool digit = std::isdigit(static_cast<unsigned char>(next)) != 0;
      const bool letter = prefix != "E-" && std::islower(static_cast<unsigned char>(next)) != 0 &&
                          !is_alnum(at_or_space(line, at + prefix.size() + 1));
      if ((digit || letter) && !is_alnum(at_or_space(line, at - 1))) return true;
    }
  }
  return false;
}

/// What a reader of the tree cannot look up: a document that is not in it, or the bare ID of a requirement. IDs stand
/// in names of tests, and as labels in what is told of ctest.
bool cites_what_is_elsewhere(const std::string& line) {
  if (line.find("ctest") != std::string::npos) return false;
  for (const char* document : {"estoration.md", "racture.md", "style.md", "equirements.md", "ocument 00"}) {
    if (line.find(document) != std::string::npos) return true;
  }
  for (const std::string word : {"equirement ", "equirements "}) {
    const std::size_t at = line.find(word);
    const char next = at == std::string::npos ? ' ' : at_or_space(line, at + word.size());
    if (std::isupper(static_cast<unsigned char>(next)) != 0) return true;
  }
  return has_requirement_id(line);
}

/// docs/source_coverage.md says what the IDs are; no other file may ask its reader to know them.
TEST(Arrows, NoFileCitesADocumentOutsideTheTree) {
  const fs::path root = DOBRA_SOURCE_DIR;
  const std::set<std::string> read{".h", ".cpp", ".md", ".toml", ".ts"};
  std::size_t files = 0;
  for (const char* top : {"shared", "recon", "quebra", "docs", "resources"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || !read.contains(entry.path().extension().string())) continue;
      if (entry.path().filename() == "source_coverage.md") continue;
      ++files;
      std::ifstream stream(entry.path());
      std::size_t number = 0;
      for (std::string line; std::getline(stream, line);) {
        ++number;
        EXPECT_FALSE(cites_what_is_elsewhere(line))
            << fs::relative(entry.path(), root).generic_string() << ':' << number << ": " << line;
      }
    }
  }
  EXPECT_GT(files, 500U);
}

TEST(Arrows, ACitationOfADocumentOutsideTheTreeIsNoticed) {
  EXPECT_TRUE(cites_what_is_elsewhere("// Source: restoration.md 2.11."));
  EXPECT_TRUE(cites_what_is_elsewhere("alpha of document 001, equation 9"));
  EXPECT_TRUE(cites_what_is_elsewhere("// Method: requirements C.3"));
  EXPECT_TRUE(cites_what_is_elsewhere("holds it (E-11), found"));
  EXPECT_TRUE(cites_what_is_elsewhere("Requirements REC-2, REC-4."));
  EXPECT_TRUE(cites_what_is_elsewhere("**Checked.** REC-e: mean depths"));
  EXPECT_FALSE(cites_what_is_elsewhere("`ctest --preset dev -L HED-a` runs them"));
  EXPECT_FALSE(cites_what_is_elsewhere("// two loops of one face, which become one. E+1 C-1."));
  EXPECT_FALSE(cites_what_is_elsewhere("Page: docs/algorithms/unfold.md"));
  EXPECT_FALSE(cites_what_is_elsewhere("a coordinate of 1E-9"));
}

/// What stands in square brackets on a line and may be a key of the bibliography: lower case, digits, dots and dashes.
std::vector<std::string> keys_on(const std::string& line) {
  std::vector<std::string> keys;
  for (std::size_t open = line.find('['); open != std::string::npos; open = line.find('[', open + 1)) {
    const std::size_t close = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-", open + 1);
    if (close != std::string::npos && close > open + 1 && line[close] == ']') {
      keys.push_back(line.substr(open + 1, close - open - 1));
    }
  }
  return keys;
}

/// True of a name with a year: only a citation has that form.
bool is_dated(const std::string& key) {
  const std::size_t year = key.find_first_of("0123456789");
  return year != std::string::npos && year >= 3 && key.find_first_not_of("0123456789", year) >= year + 4 &&
         key.size() >= year + 4;
}

TEST(Arrows, EveryKeyThatIsCitedStandsInTheBibliographyAndEveryEntryIsCited) {
  const fs::path root = DOBRA_SOURCE_DIR;
  const std::set<std::string> read{".h", ".cpp", ".md", ".toml", ".py"};
  std::set<std::string> entries;
  std::ifstream bibliography(root / "docs/bibliography.md");
  for (std::string line; std::getline(bibliography, line);) {
    if (line.starts_with("| [")) entries.insert(keys_on(line).front());
  }
  EXPECT_GT(entries.size(), 50U);
  std::set<std::string> cited;
  for (const char* top : {"shared", "recon", "quebra", "docs", "tests", "resources"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!read.contains(entry.path().extension().string()) || entry.path().filename() == "bibliography.md") continue;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        for (const std::string& key : keys_on(line)) {
          cited.insert(key);
          EXPECT_TRUE(!is_dated(key) || entries.contains(key))
              << fs::relative(entry.path(), root).generic_string() << ": " << key << " is not in docs/bibliography.md";
        }
      }
    }
  }
  for (const std::string& key : entries) EXPECT_TRUE(cited.contains(key)) << key << " is cited nowhere";
}

}  // namespace
