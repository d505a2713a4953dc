// The same problem stated in several systems of units.

#include "shared/scenario/units.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "quebra/core/layers.h"
#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::core {
namespace {

using namespace dobra;
using scenario::UnitSystem;
using testing::HasSubstr;

/// A cracked plate of 80 x 60 mm, 5 mm thick: every kind of number that has a unit. L, F, S: metres, newtons and
/// pascals in one unit of the system.
std::string cracked(const std::string& system, double L, double F, double S) {
  const auto l = [&](double mm) { return fmt::format("{}", mm * 1e-3 / L); };
  const auto p = [&](double x, double y) { return fmt::format("[{}, {}]", x * 1e-3 / L, y * 1e-3 / L); };
  const auto s = [&](double mpa) { return fmt::format("{}", mpa * 1e6 / S); };
  std::string text = system.empty() ? "" : "unit_system = \"" + system + "\"\n";
  text += "[[input.curve]]\nname = \"bottom\"\npoints = [" + p(0, 0) + ", " + p(80, 0) + "]\n";
  text += "[[input.curve]]\nname = \"right\"\npoints = [" + p(80, 0) + ", " + p(80, 60) + "]\n";
  text += "[[input.curve]]\nname = \"top\"\npoints = [" + p(80, 60) + ", " + p(0, 60) + "]\nsize = " + l(5) + "\n";
  text += "[[input.curve]]\nname = \"left\"\npoints = [" + p(0, 60) + ", " + p(0, 0) + "]\n";
  text += "[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = " + p(60, 30) + "\nradius = " + l(6) + "\n";
  text += "[[input.crack]]\nname = \"crack\"\npoints = [" + p(0, 30) + ", " + p(25, 32) + "]\n";
  text += "[[input.point]]\nname = \"pin\"\npoint = " + p(70, 50) + "\nsize = " + l(2) + "\n";
  text += "[[step]]\noperation = \"problem\"\nstate = \"strain\"\n[[step.material]]\nyoung = " + s(210000) +
          "\npoisson = 0.3\nthickness = " + l(5) + "\n";
  text += "[[step.support]]\nwhere = \"bottom\"\nx = 0.0\ny = 0.0\n";
  text += "[[step.spring]]\nwhere = \"right\"\nkind = \"bed\"\nx = " + fmt::format("{}", 5e9 * L * L * L / F) + "\n";
  text += "[[step.load]]\nwhere = \"top\"\ny_formula = \"" + s(30) + " * (1 + x / " + l(100) + ")\"\n";
  text += "[[step.load]]\nwhere = \"hole\"\nkind = \"pressure\"\nvalue = " + s(4) + "\n";
  text += "[[step.load]]\nkind = \"body\"\ny = " + fmt::format("{}", -78000.0 * L * L * L / F) + "\n";
  text += "[[step.load]]\nwhere = \"pin\"\nkind = \"force\"\nx = " + fmt::format("{}", 120.0 / F) + "\n";
  text += "[[step]]\noperation = \"mesh\"\nsize_formula = \"" + l(6) +
          " + 0.02 * hypot(x, y)\"\norder = \"2\"\nrosettes = \"yes\"\ntip_radius = " + l(0.5) + "\n";
  text += "[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"crack\"\n";
  text += "[[step]]\noperation = \"probe\"\nlabel = \"p\"\nat = " + p(40, 40) + "\n";
  text +=
      "[[step]]\noperation = \"line\"\nlabel = \"l\"\nfrom = " + p(30, 33) + "\nto = " + p(50, 33) + "\ncount = 3\n";
  return text;
}

std::vector<scenario::Quantity> quantity_list(const scenario::Run& run) {
  EXPECT_TRUE(run.complete()) << to_string(*run.error);
  return run.complete() ? program().quantities_of(run.states.back()) : std::vector<scenario::Quantity>{};
}

double value(const std::vector<scenario::Quantity>& all, const std::string& name, const std::string& unit) {
  for (const auto& q : all) {
    if (q.name != name) continue;
    EXPECT_EQ(q.unit, unit) << name;
    return q.value;
  }
  ADD_FAILURE() << "no " << name;
  return NAN;
}

struct Stated {
  const char* system;
  double length, force, stress;
};

TEST(UnitsOfScenarios, TheSameProblemHasTheSameResultsInEverySystem) {
  const auto si = quantity_list(test::run(cracked("", 1.0, 1.0, 1.0)));
  const double pound = 4.4482216152605;
  for (const auto& [system, length, force, stress] : {Stated{"mm, N, MPa", 1e-3, 1.0, 1e6},
                                                      {"m, kN, kPa", 1.0, 1e3, 1e3},
                                                      {"in, lbf, psi", 0.0254, pound, pound / 0.0254 / 0.0254}}) {
    const auto units = UnitSystem::make(system);
    ASSERT_TRUE(units.ok());
    const auto here = quantity_list(test::run(cracked(system, length, force, stress)));
    ASSERT_EQ(here.size(), si.size()) << system;
    for (std::size_t i = 0; i < si.size(); ++i) {
      ASSERT_EQ(here[i].name, si[i].name);
      EXPECT_EQ(here[i].unit, units->unit(si[i].unit)) << si[i].name;
      // The error is a difference of large numbers, and least of all the shear of a tip of mode I.
      const double tolerance = si[i].name.find("tip.") == 0 || si[i].name.find("eta") != std::string::npos ||
                                       si[i].name.find("error") != std::string::npos
                                   ? 1e-5
                                   : 1e-7;
      EXPECT_NEAR(units->to_si(here[i].value, si[i].unit), si[i].value, tolerance * std::abs(si[i].value) + 1e-12)
          << system << ": " << si[i].name;
    }
  }
}

TEST(UnitsOfScenarios, KInMegapascalsAndMillimetresIsTheRootOfAThousandTimesThatInMetres) {
  const auto mm = quantity_list(test::run(cracked("mm, N, MPa", 1e-3, 1.0, 1e6)));
  const auto si = quantity_list(test::run("result_units = \"SI\"\n" + cracked("mm, N, MPa", 1e-3, 1.0, 1e6)));
  const double k = value(mm, "tip.load.crack_end.K_I", "MPa sqrt(mm)");
  EXPECT_NEAR(k, value(si, "tip.load.crack_end.K_I", "Pa sqrt(m)") / 1e6 * 31.6227766016838, 1e-9 * k);
  EXPECT_GT(k, 1.0);
  EXPECT_NEAR(value(mm, "probe.p.load.s_yy", "MPa") * 1e6, value(si, "probe.p.load.s_yy", "Pa"), 1.0);
}

const std::string bar =
    "unit_system = \"mm, N, MPa\"\n[[input.curve]]\nname = \"bar\"\nkind = \"polygon\"\npoints = [[0, 0], [200, 0], "
    "[200, 50], [0, 50]]\n[[input.point]]\nname = \"o\"\npoint = [0, 0]\n[[input.point]]\nname = \"e\"\npoint = [200, "
    "0]\n"
    "[[input.point]]\nname = \"f\"\npoint = [200, 50]\n"
    "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 200000\npoisson = 0\n[[step.support]]\nwhere = "
    "\"o\"\nx = 0\ny = 0\n[[step.support]]\nwhere = \"e\"\ny = 0\n"
    "[[step.load]]\nwhere = \"bar\"\nkind = \"stress\"\nstress_xx = \"100\"\n[[step]]\noperation = \"mesh\"\nsize = "
    "25\n[[step]]\noperation = \"analyse\"\n";

TEST(UnitsOfScenarios, ABarUnderTensionIsAsLongAsHookeSaysAndExpectationsAreInTheScenariosUnits) {
  // 100 MPa / 200 GPa over 200 mm: 0.1 mm. Area 10 000 mm2, energy 1/2 sigma eps A t with t = 1 m: 250 000 N mm.
  const std::string expects =
      "[[expect]]\nquantity = \"case.load.point.e.u_x\"\nvalue = 0.1\nrelative_tolerance = 1e-9\n[[expect]]\nquantity "
      "= \"area\"\nvalue = 10000\ntolerance = 1e-6\n[[expect]]\nquantity = \"case.load.energy\"\nvalue = "
      "250000\nrelative_tolerance = 1e-9\n"
      "[[expect]]\nquantity = \"case.load.max_von_mises\"\nat_least = 99.99\nat_most = 100.01\n[[expect]]\nquantity = "
      "\"case.load.point.e.u_x\"\nvalue = 0.0001\nrelative_tolerance = 1e-3\n";
  for (const std::string results : {"", "result_units = \"SI\"\n", "result_units = \"in, lbf, psi\"\n"}) {
    const auto document =
        scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + results + bar + expects, "bar.toml");
    ASSERT_TRUE(document.ok());
    scenario::Runner runner(program());
    const scenario::Run done = runner.run(*document);
    ASSERT_TRUE(done.complete()) << to_string(*done.error);
    const auto verdicts = scenario::judge(*document, program(), done);
    ASSERT_EQ(verdicts.size(), 5U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(verdicts[i].met) << verdicts[i].message;
    EXPECT_FALSE(verdicts[4].met) << "a tenth of a millimetre is not a tenth of a micrometre";
    const auto report = nlohmann::json::parse(scenario::report_json(*document, program(), done));
    EXPECT_EQ(report["unit_system"], "mm, N, MPa");
    EXPECT_EQ(report["input"]["values"]["curve"][0]["points"][1][0], 200.0);
    EXPECT_EQ(report["steps"][0]["values"]["material"][0]["thickness"], 1000.0)
        << "the default in the scenario's units";
  }
  const auto remarks = program().remarks_of(test::run(bar).states.back());
  EXPECT_THAT(remarks, testing::Contains(HasSubstr("it is 1000 mm")));
}

TEST(UnitsOfScenarios, ExchangeFilesHoldThemAndSayWhich) {
  const scenario::Run done = test::run(bar);
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  std::string pattern = (std::filesystem::temp_directory_path() / "dobra_units_XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(pattern.data());
  std::size_t read = 0;
  for (const auto& output : program().outputs_of(done.states.back())) {
    const std::filesystem::path file = folder / output.file_name;
    ASSERT_TRUE(output.write(file).ok()) << output.file_name;
    const std::string text = *io::read_text(file);
    if (file.extension() != ".nf") {
      EXPECT_THAT(text.substr(0, 300), HasSubstr("units: mm, N, MPa")) << output.file_name;
    }
    if (output.file_name == "analysis.inp") {
      EXPECT_THAT(text, HasSubstr("*SOLID SECTION, ELSET=REGION_1, MATERIAL=MATERIAL_1\n1000"))
          << "the thickness of a metre";
    }
    if (io::formats::format_of(file.string(), io::formats::Use::ReadMesh) == nullptr || file.extension() == ".ele")
      continue;
    const auto mesh = io::formats::read_mesh(file.string());
    ASSERT_TRUE(mesh.ok()) << output.file_name << ": " << to_string(mesh.error());
    EXPECT_NEAR(geom::box_of(mesh->mesh.points).width(), 200.0, 1e-9) << output.file_name;
    ++read;
  }
  EXPECT_GE(read, 6U);
  const auto pair = io::formats::read_mesh((folder / "mesh.ele").string());
  ASSERT_TRUE(pair.ok()) << to_string(pair.error());
  EXPECT_NEAR(geom::box_of(pair->mesh.points).width(), 200.0, 1e-9);
  std::filesystem::remove_all(folder);
}

class FilesAndUnits : public testing::Test {
 protected:
  FilesAndUnits() {
    std::string pattern = (std::filesystem::temp_directory_path() / "dobra_units_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~FilesAndUnits() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  /// Width of the domain of a file, m; `keys` follow in the input.
  static double width(const std::string& system, const std::string& file, const std::string& keys = "") {
    const scenario::Run done = test::run((system.empty() ? "" : "unit_system = \"" + system + "\"\n") +
                                         "[input]\nfile = \"" + file + "\"\n" + keys);
    EXPECT_TRUE(done.complete()) << to_string(*done.error);
    return done.complete() ? test::last(done).domain.box().width() : NAN;
  }
  std::filesystem::path folder_;
};

TEST_F(FilesAndUnits, AFileThatDoesNotSayIsInTheScenariosUnits) {
  const std::string svg = put(
      "a.svg",
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"40\"><rect width=\"40\" height=\"20\"/></svg>");
  const std::string poly =
      put("a.poly", "4 2 0 0\n1 0 0\n2 40 0\n3 40 20\n4 0 20\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const std::string geo =
      put("a.geo",
          "Point(1)={0,0,0,5};Point(2)={40,0,0,5};Point(3)={40,20,0,5};Point(4)={0,20,0,5};Line(1)={1,2};Line(2)={2,3};"
          "Line(3)={3,4};Line(4)={4,1};Curve Loop(1)={1,2,3,4};Plane Surface(1)={1};\n");
  const std::string wkt = put("a.wkt", "POLYGON((0 0,40 0,40 20,0 20,0 0))\n");
  const std::string csv = put("a.csv", "x,y\n0,0\n40,0\n40,20\n0,20\n0,0\n");
  const std::string inp = put("a.inp", "*NODE\n1,0,0\n2,40,0\n3,0,20\n*ELEMENT,TYPE=CPS3\n1,1,2,3\n");
  for (const std::string& file : {svg, poly, geo, wkt, csv, inp}) {
    EXPECT_DOUBLE_EQ(width("", file), 40.0) << file;
    EXPECT_DOUBLE_EQ(width("mm, N, MPa", file), 0.04) << file;
    EXPECT_DOUBLE_EQ(width("in, lbf, psi", file), 1.016) << file;
  }
}

TEST_F(FilesAndUnits, WhatTheFileOrTheKeySaysCountsForTheFileAlone) {
  const std::string section = "0\nSECTION\n2\n";
  const auto dxf = [&](const char* units) {
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::string(units) + "\n0\nENDSEC\n" + section +
           "ENTITIES\n0\nLWPOLYLINE\n8\nA\n90\n4\n70\n1\n10\n0\n20\n0\n10\n40\n20\n0\n10\n40\n20\n20\n10\n0\n20\n20\n0"
           "\nENDSEC\n0\nEOF\n";
  };
  const std::string metres = put("m.dxf", dxf("6")), feet = put("ft.dxf", dxf("2")), silent = put("no.dxf", dxf("0"));
  EXPECT_DOUBLE_EQ(width("mm, N, MPa", metres), 40.0);
  EXPECT_DOUBLE_EQ(width("mm, N, MPa", feet), 40.0 * 0.3048);
  EXPECT_DOUBLE_EQ(width("mm, N, MPa", silent), 0.04);
  EXPECT_DOUBLE_EQ(width("mm, N, MPa", silent, "unit = \"in\"\n"), 40.0 * 0.0254);
  const scenario::Run both =
      test::run("unit_system = \"mm, N, MPa\"\n[input]\nfile = \"" + feet + "\"\nunit = \"m\"\n");
  ASSERT_TRUE(both.complete()) << to_string(*both.error);
  EXPECT_DOUBLE_EQ(test::last(both).domain.box().width(), 40.0);
  EXPECT_THAT(program().remarks_of(both.states.back()), testing::Contains(HasSubstr("as asked for")));
}

TEST_F(FilesAndUnits, AUnitOfNoFileIsAContradiction) {
  EXPECT_THAT(test::trouble("unit_system = \"mm, N, MPa\"\n[input]\nspecimen = \"l_shape\"\nunit = \"m\"\n"),
              HasSubstr("test.toml:6:1: input: `unit` is of the coordinates in `file`"));
}

TEST_F(FilesAndUnits, ABackgroundMeshIsInTheScenariosUnits) {
  const std::string background = put(
      "b.inp", "*NODE\n1,0,0\n2,20,0\n3,20,20\n4,0,20\n5,40,0\n6,40,20\n*ELEMENT,TYPE=CPS4\n1,1,2,3,4\n2,2,5,6,3\n");
  const auto mesh = [&](const std::string& head, double scale) {
    return test::figures(
               test::run(head +
                         fmt::format("[[input.curve]]\nname = \"a\"\nkind = \"polygon\"\npoints = [[0, 0], [{0}, 0], "
                                     "[{0}, {1}], [0, {1}]]\n[[step]]\noperation = \"mesh\"\nbackground = \"{2}\"\n",
                                     40 * scale, 20 * scale, background)))
        .at("elements");
  };
  EXPECT_EQ(mesh("unit_system = \"mm, N, MPa\"\n", 1.0), mesh("", 1.0));
}

TEST(UnitsOfScenarios, PlacesOfErrorsAreInTheScenariosUnits) {
  EXPECT_THAT(test::trouble(bar + "[[step]]\noperation = \"probe\"\nat = [250, 20]\n"), HasSubstr("(at 250, 20)"));
}

TEST(UnitsOfScenarios, PicturesAndTablesCarryThem) {
  const scenario::Run done = test::run(bar);
  ASSERT_TRUE(done.complete());
  const scene::Picture picture = program().picture_of(done.states.back());
  for (const scene::Panel& panel : picture.panels) EXPECT_EQ(panel.axes.x_title, "x [mm]");
  const auto& field = std::get<scene::Mesh>(picture.panels.back().layers.front().content);
  EXPECT_EQ(field.scale.title, "von Mises stress [MPa]");
  EXPECT_NEAR(field.values.front(), 100.0, 1e-6);
  for (const auto& table : program().tables_of(done.states.back())) {
    if (table.name != "analyses") continue;
    EXPECT_THAT(table.columns, testing::Contains("energy [N mm]"));
    EXPECT_THAT(table.columns, testing::Contains("true error [sqrt(N mm)]"));
  }
}

}  // namespace
}  // namespace quebra::core
