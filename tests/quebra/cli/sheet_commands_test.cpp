// `quebra parametrise` and `quebra remesh`: refusals with their findings first, then figures that are known otherwise.

#include "quebra/cli/sheet_commands.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "quebra/core/operations.h"
#include "shared/io/file.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/io/meshes/vtu.h"
#include "shared/surf/remesh/remesh.h"
#include "tests/support/command_line.h"
#include "tests/support/sheets.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using nlohmann::json;
using testing::HasSubstr;

class SheetCommands : public dobra::test::CommandLine {
 protected:
  SheetCommands() : CommandLine(core::program(), {parametrise_command(), remesh_command()}) {}

  [[nodiscard]] json told(std::vector<std::string> args, int code = 0) const {
    args.emplace_back("--json");
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  [[nodiscard]] std::string put_mesh(const std::string& name, const mesh::PolygonMesh& mesh) const {
    EXPECT_TRUE(io::formats::write_boundary(path(name), mesh).ok());
    return path(name);
  }
  [[nodiscard]] static bool has(const json& told, const std::string& code) {
    return std::any_of(told["findings"].begin(), told["findings"].end(),
                       [&](const json& finding) { return finding["code"] == code; });
  }
};

mesh::PolygonMesh hill() {
  return surf::test::shaken_grid(20, 20, 0.5, 1, [](double u, double v) {
    return geom::Point3{4 * u, 4 * v, 0.5 * std::sin(2 * u) * std::cos(3 * v)};
  });
}

TEST_F(SheetCommands, MeshesThatAreNoSheetsAreRefusedWithThePlaceAndLeaveNoFile) {
  const std::string fan = put("fan.obj", "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 -1 0\nv 1 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  for (const char* command : {"parametrise", "remesh"}) {
    const json refused = told({command, fan, "--out", path("out.vtu")}, 3);
    ASSERT_EQ(refused["findings"].size(), 1U);
    EXPECT_EQ(refused["findings"][0]["code"], "bad_mesh");
    EXPECT_THAT(refused["findings"][0]["message"].get<std::string>(), HasSubstr("not manifold"));
    EXPECT_EQ(refused["findings"][0]["place"]["point"], json({1.0, 0.0, 0.0}));
    EXPECT_FALSE(std::filesystem::exists(path("out.vtu")));
    EXPECT_EQ(told({command, path("missing.stl")}, 3)["findings"][0]["code"], "file_not_found");
  }
}

TEST_F(SheetCommands, ElementsOnASurfaceAreMeshedAnew) {
  const std::string file = put_mesh("hill.ply", hill());
  const double area = told({"remesh", file, "--size", "0.3"})["area"];
  for (const std::string ending : {".vtu", ".msh", ".inp", ".bdf", ".vtp", ".ts"}) {
    ASSERT_EQ(call({"remesh", file, "--size", "0.3", "--out", path("m" + ending)}).code, 0) << ending;
    const json anew = told({"remesh", path("m" + ending), "--size", "0.4"});
    EXPECT_NEAR(anew["area"], area, 0.01 * area) << ending;
    EXPECT_EQ(anew["flipped"], 0) << ending;
    EXPECT_EQ(anew["borders"], 1) << ending;
  }
}

/// A square of 100 ft, 30.48 m.
TEST_F(SheetCommands, UnitsThatAreTakenToMetresAreTold) {
  const std::string file =
      put("top.ts",
          "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT \"ft\" \"ft\" \"ft\"\n"
          "END_ORIGINAL_COORDINATE_SYSTEM\nVRTX 1 0 0 5\nVRTX 2 100 0 5\nVRTX 3 100 100 5\nVRTX 4 0 100 5\n"
          "TRGL 1 2 3\nTRGL 1 3 4\nEND\n");
  for (const char* command : {"parametrise", "remesh"}) {
    const json made = told({command, file});
    ASSERT_FALSE(made["findings"].empty()) << command;
    EXPECT_EQ(made["findings"][0]["code"], "units_converted") << command;
    EXPECT_EQ(made["findings"][0]["place"]["line"], 3) << command;
    EXPECT_EQ(made["findings"][0]["place"]["file"], file) << command;
  }
  EXPECT_NEAR(told({"remesh", file, "--size", "10"})["area"].get<double>(), 30.48 * 30.48, 1e-6);
}

TEST_F(SheetCommands, OptionsThatMeanNothingAreWrongUsage) {
  const std::string file = put_mesh("hill.ply", hill());
  for (const std::vector<std::string>& bad : {std::vector<std::string>{"remesh", file, "--size", "0"},
                                              {"remesh", file, "--size", "-1"},
                                              {"remesh", file, "--chord", "-0.1"},
                                              {"remesh", file, "--out", path("m.txt")},
                                              {"parametrise", file, "--border", "square"},
                                              {"parametrise", file, "--out", path("uv.ply")}}) {
    EXPECT_EQ(call(bad).code, 2) << bad[2] << ' ' << bad[3];
  }
}

TEST_F(SheetCommands, TRI_d_TheOctantHasThreeStonesNothingFlippedAndAGapThatFalls) {
  double last = 1.0;
  for (const std::uint32_t n : {8U, 16U}) {
    const json made =
        told({"parametrise", put_mesh("octant.obj", surf::test::octant_mesh(n)), "--out", path("uv.vtu")});
    EXPECT_EQ(made["stones"], 3);
    EXPECT_EQ(made["flipped"], 0);
    EXPECT_GT(made["border_gap"].get<double>(), 0.0);
    EXPECT_LT(made["border_gap"].get<double>(), 0.6 * last);
    EXPECT_LT(made["border_gap_treated"].get<double>(), 1e-12);
    EXPECT_EQ(made["stone_places"].size(), 3U);
    last = made["border_gap"];
    const auto chart = io::meshes::read_vtu(path("uv.vtu"));
    ASSERT_TRUE(chart.ok()) << chart.error().message;
    EXPECT_EQ(chart->mesh.element_count(), n * n);
    EXPECT_EQ(chart->fields.at_points[0].name, "position");
  }
}

TEST_F(SheetCommands, FlippedTrianglesAreCountedAndThenThereIsNoGap) {
  mesh::PolygonMesh ear = surf::test::grid_mesh(4, 4, [](double u, double v) { return geom::Point3{u, v, 0}; });
  ear.points.push_back({0.375, -0.02, 0});
  ear.faces.push_back({1, static_cast<std::uint32_t>(ear.points.size() - 1), 2});
  const std::string file = put_mesh("ear.off", ear);
  const json made = told({"parametrise", file, "--border", "stones"});
  EXPECT_EQ(made["flipped"], 1);
  EXPECT_TRUE(made["border_gap"].is_null());
  EXPECT_TRUE(has(made, "flipped"));
  EXPECT_EQ(told({"parametrise", file})["border"], "circle");
}

TEST_F(SheetCommands, ARemeshedHillIsReadBackWithItsDeviation) {
  const std::string file = put_mesh("hill.stl", hill());
  const json made = told({"remesh", file, "--size", "0.3", "--chord", "0.02", "--out", path("m.ply")});
  EXPECT_EQ(made["flipped"], 0);
  EXPECT_LE(made["deviation"].get<double>(), 0.02);
  EXPECT_GE(made["alpha_mean"].get<double>(), 0.97);
  const auto before = surf::param::sheet_of(*io::formats::read_boundary(file));
  const auto after = surf::param::sheet_of(*io::formats::read_boundary(path("m.ply")));
  ASSERT_TRUE(before.ok() && after.ok());
  EXPECT_EQ(after->sheet.triangles.size(), made["elements"].get<std::size_t>());
  EXPECT_EQ(after->sheet.points.size(), made["nodes"].get<std::size_t>());
  EXPECT_NEAR(surf::remesh::deviation(before->sheet, after->sheet), made["deviation"].get<double>(), 1e-12);
  EXPECT_EQ(call({"remesh", file, "--size", "0.3", "--out", path("m.vtu")}).code, 0);
  const auto text = io::read_text(path("m.vtu"));
  ASSERT_TRUE(text.ok());
  EXPECT_THAT(*text, HasSubstr("NumberOfCells="));
}

TEST_F(SheetCommands, ATubeIsCutAndToldSo) {
  const auto tube = surf::test::tube(24, 12, false, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u;
    return geom::Point3{std::cos(a), std::sin(a), 2 * v};
  });
  const std::string file = put_mesh("tube.obj", tube);
  const json chart = told({"parametrise", file});
  EXPECT_TRUE(has(chart, "cut"));
  EXPECT_EQ(chart["cut_sides"], 12);
  EXPECT_NEAR(chart["cut_length"].get<double>(), 2.0, 1e-12);
  const json made = told({"remesh", file, "--size", "0.25", "--out", path("m.obj")});
  EXPECT_TRUE(has(made, "cut"));
  EXPECT_EQ(made["borders"], 2);
  EXPECT_EQ(made["euler"], 0);
  const auto closed = surf::param::sheet_of(*io::formats::read_boundary(path("m.obj")));
  ASSERT_TRUE(closed.ok());
  EXPECT_EQ(closed->sheet.loops.size(), 2U);
}

}  // namespace
}  // namespace quebra::cli
