// Files of surfaces, read by our own readers: the checks find nothing, nothing is to be mended, regions have the names
// of the surfaces, and the remesher meshes them anew.
#include "recon/space/surface_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/mesh_polygons.h"
#include "shared/io/meshes/tsurf.h"
#include "shared/mesh/polygon_repair.h"
#include "shared/mesh/polygon_surface.h"
#include "shared/surf/remesh/remesh.h"

namespace recon::space {
namespace {

namespace io = dobra::io;
namespace loft = dobra::surf::loft;
namespace mesh = dobra::mesh;
using Height = std::function<double(double x, double y)>;

constexpr double centimetres = 100.0;

double written(double value) { return std::round(value * centimetres) / centimetres; }

/// A section with two horizons written to centimetres, n + 1 vertices each.
PlacedSection section_of(const std::string& name, std::vector<geom::Point> corners, const Height& height, int n) {
  PlacedSection made{name, {}, loft::PlanTrace::make(std::move(corners)).value()};
  for (const auto& [line, depth] : {std::pair("Top sand", 0.0), {"Base", -80.0}}) {
    section::Horizon h;
    h.id = section::HorizonId(made.section.horizons.size());
    h.name = line;
    for (int i = 0; i <= n; ++i) {
      const double s = written(made.trace.length() * i / n);
      const geom::Point p = made.trace.on_map(s);
      h.line.points.push_back({s, written(height(p.x, p.y) + depth)});
    }
    made.section.horizons.push_back(std::move(h));
  }
  return made;
}

double fold(double x, double y) { return 60.0 * std::sin(x / 150.0) + 0.05 * y; }

PlacedSections slanted() {
  PlacedSections all;
  for (int k = 0; k < 4; ++k) {
    const double y = 300.0 * k, rise = 130.0 + 20.0 * k;
    all.sections.push_back(
        section_of("S" + std::to_string(k), {{0.0, y}, {500.0, y + rise}, {1000.0, y + rise}}, fold, 24));
  }
  return all;
}

PlacedSections crossing() {
  PlacedSections all;
  int n = 11;
  for (const double at : {0.0, 410.0, 1000.0}) {
    all.sections.push_back(section_of("E" + std::to_string(n), {{0.0, at}, {1000.0, at}}, fold, n));
    n += 3;
    all.sections.push_back(section_of("N" + std::to_string(n), {{at, 0.0}, {at, 1000.0}}, fold, n));
    n += 2;
  }
  return all;
}

class SurfaceFile : public ::testing::TestWithParam<PlacedSections (*)()> {
 protected:
  SurfaceFile()
      : folder_(std::filesystem::temp_directory_path() / ("recon_surface_file_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~SurfaceFile() override {
    std::error_code unread;
    std::filesystem::remove_all(folder_, unread);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

void expect_clean(const mesh::PolygonMesh& polygons, std::size_t parts, const std::string& what) {
  SCOPED_TRACE(what);
  const mesh::PolygonSurface surface = mesh::surface_of(polygons, mesh::Closedness::Sheet);
  for (const auto& fault : surface.faults) ADD_FAILURE() << fault.message;
  EXPECT_EQ(surface.parts, parts);
  EXPECT_EQ(surface.borders, parts);
  EXPECT_EQ(surface.shared_places, 0U);
  // Half a millimetre merges nothing.
  mesh::PolygonRepairOptions options;
  options.merge = 5e-4;
  options.fill = false;
  for (const auto& repair : mesh::repaired(polygons, options).repairs) ADD_FAILURE() << repair.message;
}

TEST_P(SurfaceFile, OurOwnReadersFindNothingToMend) {
  const auto made = make_surfaces(GetParam()(), {});
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_EQ(made->rows.size(), 2U);
  const std::size_t triangles = made->rows[0].triangles + made->rows[1].triangles;
  for (const std::string ending : {".ts", ".obj", ".ply", ".off", ".vtp"}) {
    ASSERT_TRUE(write_surfaces(path("all" + ending), *made)) << ending;
    const auto read = io::formats::read_polygons(path("all" + ending));
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->faces.size(), triangles) << ending;
    expect_clean(*read, 2, ending);
  }
  const auto named = io::meshes::parse_tsurfs(io::read_text(path("all.ts")).value(), "all.ts");
  ASSERT_TRUE(named) << to_string(named.error());
  ASSERT_EQ(named->size(), 2U);
  EXPECT_EQ((*named)[0].name, "Top sand");
  EXPECT_EQ((*named)[1].mesh.faces.size(), made->rows[1].triangles);
  const std::string obj = io::read_text(path("all.obj")).value();
  EXPECT_NE(obj.find("g Top_sand\n"), std::string::npos);
  EXPECT_NE(obj.find("g Base\n"), std::string::npos);
}

TEST_P(SurfaceFile, FormatsOfElementsHaveARegionForEachSurface) {
  const auto made = make_surfaces(GetParam()(), {});
  ASSERT_TRUE(made) << to_string(made.error());
  for (const std::string ending : {".vtu", ".msh", ".inp", ".bdf"}) {
    SCOPED_TRACE(ending);
    const auto done = write_surfaces(path("all" + ending), *made);
    ASSERT_TRUE(done) << to_string(done.error());
    const auto read = io::formats::read_mesh_in_space(path("all" + ending));
    ASSERT_TRUE(read) << to_string(read.error());
    std::map<std::string, std::size_t> counts;
    for (const std::int32_t region : read->mesh.regions) {
      const auto name = read->mesh.region_names.find(region);
      ASSERT_NE(name, read->mesh.region_names.end()) << region;
      ++counts[name->second];
    }
    ASSERT_EQ(counts.size(), 2U);
    // Labels of Abaqus have no blanks.
    EXPECT_EQ(counts[ending == ".inp" ? "Top_sand" : "Top sand"], made->rows[0].triangles);
    EXPECT_EQ(counts["Base"], made->rows[1].triangles);
    EXPECT_EQ(read->heights.size(), read->mesh.points.size());
    expect_clean(io::meshes::polygons_of(read->mesh, read->heights), 2, "as polygons");
  }
  ASSERT_TRUE(write_surfaces(path("all.vtp"), *made));
  EXPECT_NE(io::read_text(path("all.vtp")).value().find("Name=\"dip\""), std::string::npos);
}

TEST_P(SurfaceFile, TheRemesherMeshesThemAnew) {
  auto made = make_surfaces(GetParam()(), {});
  ASSERT_TRUE(made) << to_string(made.error());
  made->made.surfaces.resize(1);
  ASSERT_TRUE(write_surfaces(path("one.ts"), *made));
  const auto read = io::formats::read_polygons(path("one.ts"));
  ASSERT_TRUE(read) << to_string(read.error());
  dobra::surf::remesh::RemeshOptions options;
  options.size = 60.0;
  const auto anew = dobra::surf::remesh::remesh(*read, options);
  ASSERT_TRUE(anew) << to_string(anew.error());
  EXPECT_EQ(anew->flipped, 0U);
  const double before = mesh::surface_of(*read, mesh::Closedness::Sheet).area;
  EXPECT_NEAR(anew->area_before, before, 1e-6 * before);
  EXPECT_LT(anew->deviation, 5.0);
}

INSTANTIATE_TEST_SUITE_P(Rows, SurfaceFile, ::testing::Values(&slanted));
INSTANTIATE_TEST_SUITE_P(Grids, SurfaceFile, ::testing::Values(&crossing));

TEST(SurfaceNames, AHorizonAndAFaultOfOneNameAreTwoRegions) {
  PlacedSections all;
  for (const double y : {0.0, 300.0}) {
    PlacedSection one = section_of("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {1000.0, y}}, fold, 8);
    section::SectionLine fault;
    fault.id = section::LineId(0);
    fault.name = "Base";
    fault.line.points = {{400.0, -300.0}, {600.0, -900.0}};
    one.section.lines.push_back(fault);
    all.sections.push_back(std::move(one));
  }
  const auto made = make_surfaces(all, {});
  ASSERT_TRUE(made) << to_string(made.error());
  const std::string file = (std::filesystem::temp_directory_path() / "recon_two_of_one_name.msh").string();
  ASSERT_TRUE(write_surfaces(file, *made));
  const auto read = io::formats::read_mesh_in_space(file);
  ASSERT_TRUE(read) << to_string(read.error());
  std::vector<std::string> names;
  for (const auto& [tag, name] : read->mesh.region_names) names.push_back(name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"Base (fault)", "Base (horizon)", "Top sand"}));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace recon::space
