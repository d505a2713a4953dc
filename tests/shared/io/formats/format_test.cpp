#include "shared/io/formats/format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "shared/io/formats/mesh_file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::formats {
namespace {

using testing::HasSubstr;

TEST(Formats, NamesAndEndingsAreOfOneRowEach) {
  std::set<std::string> names, endings;
  for (const Format& format : all_formats()) {
    EXPECT_TRUE(names.insert(std::string(format.name)).second) << format.name;
    ASSERT_FALSE(format.endings.empty()) << format.name;
    for (const std::string& ending : format.endings) {
      EXPECT_TRUE(endings.insert(ending).second) << ending;
      EXPECT_TRUE(ending.size() > 1 && ending[0] == '.') << ending;
    }
  }
}

TEST(Formats, ARowSaysWhatItDoes) {
  for (const Format& format : all_formats()) {
    const bool reads = is_for(format, Use::ReadLines) || is_for(format, Use::ReadMesh) || format.drawing;
    const bool writes = is_for(format, Use::WriteLines) || is_for(format, Use::WriteMesh);
    EXPECT_TRUE(reads || writes) << format.name;
    EXPECT_EQ(!format.read.empty(), reads) << format.name;
    EXPECT_EQ(!format.written.empty(), writes) << format.name;
    EXPECT_EQ(!format.kept.empty(), writes) << format.name;
  }
}

TEST(Formats, AFileIsOfTheFormatOfItsEndingInCapitalsOrNotForTheUseAskedOnly) {
  EXPECT_EQ(format_of("a/b.GeoJSON", Use::ReadLines)->name, "geojson");
  EXPECT_EQ(format_of("b.nas", Use::WriteMesh)->name, "bdf");
  EXPECT_EQ(format_of("b.poly", Use::ReadDrawing)->name, "poly");
  EXPECT_EQ(format_of("b.poly", Use::ReadMesh), nullptr);
  EXPECT_EQ(format_of("b.node", Use::ReadMesh), nullptr);
  EXPECT_EQ(format_of("b.svg", Use::WriteLines), nullptr);
  EXPECT_EQ(format_of("b", Use::ReadLines), nullptr);
  EXPECT_EQ(format_named("vtu", Use::ReadLines), nullptr);
}

TEST(Formats, EveryMeshThatIsReadAndWrittenComesBackWithItsElements) {
  const test::TemporaryFolder folder;
  const mesh::ElementMesh mesh = test::example_mesh(3);
  std::size_t count = 0;
  for (const Format& format : all_formats()) {
    if (!is_for(format, Use::ReadMesh) || !is_for(format, Use::WriteMesh)) continue;
    for (const std::string& ending : format.endings) {
      const std::string file = folder.file("m" + ending);
      ASSERT_TRUE(write_mesh(file, mesh, meshes::InpElement::PlaneStress).ok()) << ending;
      const auto read = read_mesh(file);
      ASSERT_TRUE(read.ok()) << ending << ": " << base::to_string(read.error());
      EXPECT_EQ(read->mesh.element_count(), mesh.element_count()) << ending;
      ++count;
    }
  }
  EXPECT_GT(count, 8U);
}

TEST(Formats, TheTableOfTheManualIsThatOfTheProgram) {
  std::ifstream page(std::string(DOBRA_SOURCE_DIR) + "/docs/user/formats.md");
  std::stringstream text;
  text << page.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(formats_markdown()));
}

}  // namespace
}  // namespace dobra::io::formats
