// `quebra mesh` on surfaces: what its JSON says, where it refuses too, and that the stand-ins are scenarios.

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "quebra/cli/mesh_command.h"
#include "quebra/core/operations.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

const std::string head = "dobra = 1\nprogram = \"quebra\"\n";
const std::string plate = head + "[[input.surface]]\nname = \"plate\"\nkind = \"plane\"\nu = [0, 10]\nv = [0, 10]\n";

class SurfaceCommand : public dobra::test::CommandLine {
 protected:
  SurfaceCommand() : CommandLine(core::program(), {mesh_command()}) {}

  [[nodiscard]] json told(const std::vector<std::string>& args, int code = 0) const {
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
};

TEST_F(SurfaceCommand, GrowthThatIsLeftOutIsThatOfThePlaneOrThatOfSurfaces) {
  const std::string hole =
      "[[input.trim]]\nname = \"hole\"\nkind = \"circle\"\nrole = \"hole\"\n"
      "centre = [5, 5]\nradius = 0.2\n";
  const std::string surface = put("plate.toml", plate + hole);
  const std::string plane = put("square.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,9],[0,0]],)"
                                                  R"([[4,4],[4,4.1],[4.1,4.1],[4.1,4],[4,4]]]})");
  const auto elements = [&](const std::string& file, const std::string& growth) {
    std::vector<std::string> args{"mesh", file, "--size", "1", "--json"};
    if (!growth.empty()) args.insert(args.end(), {"--growth", growth});
    return told(args)["elements"].get<int>();
  };
  EXPECT_EQ(elements(surface, ""), elements(surface, "1.17"));
  EXPECT_NE(elements(surface, ""), elements(surface, "1.3"));
  EXPECT_EQ(elements(plane, ""), elements(plane, "1.3"));
  EXPECT_NE(elements(plane, ""), elements(plane, "1.17"));
  for (const auto& operation : core::program().operations) {
    for (const auto& field : operation.fields) {
      if (operation.name == "mesh" && field.key == "growth") {
        EXPECT_FALSE(field.default_value.has_value());
      }
    }
  }
}

TEST_F(SurfaceCommand, TellsCountsAreasQualityAndFindings) {
  const std::string file = put("plate.toml", plate +
                                                 "[[input.trim]]\nname = \"hole\"\nkind = \"circle\"\nrole = \"hole\"\n"
                                                 "centre = [5, 5]\nradius = 2\n");
  for (const std::string engine : {"front", "paper"}) {
    const json json =
        told({"mesh", file, "--size", "0.5", "--turn", "15", "--engine", engine, "--out", path("m.vtu"), "--json"});
    for (const char* const key :
         {"elements", "nodes", "area", "area_surface", "alpha_mean", "alpha_90", "alpha_min", "findings"})
      ASSERT_TRUE(json.contains(key)) << key;
    EXPECT_NEAR(json["area_surface"].get<double>(), 100 - 4 * pi, 1e-6);
    EXPECT_NEAR(json["area"].get<double>(), 100 - 4 * pi, 0.3);
    EXPECT_GT(json["alpha_mean"].get<double>(), 0.9);
    EXPECT_TRUE(json["findings"].is_array());
    // One hole: NE = 2 NN - B - 2 + 2 h, B from the counts of Euler's formula.
    EXPECT_GT(json["elements"].get<double>(), json["nodes"].get<double>());
  }
  EXPECT_THAT(text("m.vtu"), HasSubstr("side_set hole"));
}

TEST_F(SurfaceCommand, WhatTheEnginePaperDoesNotLookAtIsTold) {
  const std::string file = put("plate.toml", plate);
  const auto unused = [&](std::vector<std::string> options) {
    std::vector<std::string> args{"mesh", file, "--size", "2", "--json"};
    args.insert(args.end(), options.begin(), options.end());
    const json outcome = told(args);
    std::vector<std::string> keys;
    for (const json& finding : outcome["findings"]) {
      EXPECT_EQ(finding["code"], "option_unused");
      const auto message = finding["message"].get<std::string>();
      const std::size_t from = message.find('`') + 1;
      keys.push_back(message.substr(from, message.find('`', from) - from));
    }
    return keys;
  };
  using testing::ElementsAre;
  EXPECT_THAT(unused({"--engine", "paper", "--chord", "0.1"}), ElementsAre("chord"));
  EXPECT_THAT(unused({"--engine", "paper", "--growth", "1.17", "--narrow", "2", "--size-formula", "1"}),
              ElementsAre("growth", "narrow", "size_formula"));
  EXPECT_THAT(unused({"--engine", "paper", "--turn", "5", "--chord", "0"}), ElementsAre());
  EXPECT_THAT(unused({"--engine", "front", "--chord", "0.1", "--growth", "1.2"}), ElementsAre());
}

TEST_F(SurfaceCommand, MeshesOfClosedSurfacesAreClosedOrRefusedWithThePlace) {
  // T = 2 (N - chi), by 3 T = 2 E and Euler.
  const std::string surface = head + "[[input.surface]]\nname = \"s\"\nradius = 5\nkind = ";
  const std::string sphere = put("sphere.toml", surface + "\"sphere\"\n");
  const std::string torus = put("torus.toml", surface + "\"torus\"\nminor_radius = 2\n");
  const auto mesh = [&](const std::string& file, const std::string& size, const std::string& engine) {
    return call({"mesh", file, "--size", size, "--turn", "90", "--engine", engine, "--json"});
  };
  std::size_t refused = 0;
  for (const std::string engine : {"front", "paper"}) {
    for (const std::string size : {"50", "12", "8", "6", "5", "4", "3", "2"}) {
      for (const auto& [file, euler] : {std::pair{sphere, 2}, std::pair{torus, 0}}) {
        const auto outcome = mesh(file, size, engine);
        const json told = json::parse(outcome.out, nullptr, false);
        if (outcome.code == 0) {
          EXPECT_EQ(told["elements"].get<int>(), 2 * (told["nodes"].get<int>() - euler)) << file << ' ' << size;
          continue;
        }
        ++refused;
        EXPECT_EQ(outcome.code, 4) << outcome.err;
        EXPECT_TRUE(told["findings"].back()["place"].contains("point")) << file << ' ' << size;
      }
    }
  }
  EXPECT_LT(refused, 16U);
  const auto bag = mesh(sphere, "50", "paper");
  EXPECT_EQ(bag.code, 4) << bag.out;
  EXPECT_THAT(bag.err, HasSubstr("ask for a smaller size"));
}

TEST_F(SurfaceCommand, RefusalsEndWithTheirCodeAndStillPrintFindings) {
  const std::string bad = put("bad.toml", plate +
                                              "[[input.trim]]\nname = \"hole\"\nkind = \"circle\"\nrole = \"hole\"\n"
                                              "centre = [9, 5]\nradius = 2\n");
  const json json = told({"mesh", bad, "--json"}, 3);
  ASSERT_EQ(json["findings"].size(), 1U);
  const auto& finding = json["findings"][0];
  EXPECT_THAT(finding["message"].get<std::string>(), HasSubstr("leaves the chart"));
  EXPECT_EQ(finding["code"], "bad_domain");
  EXPECT_EQ(finding["place"]["line"], 8);
  EXPECT_NEAR(finding["place"]["uv"][0].get<double>(), 10.0, 1.1);
  const nlohmann::json delaunay = told({"mesh", put("good.toml", plate), "--engine", "delaunay", "--json"}, 3);
  EXPECT_THAT(delaunay["findings"][0]["message"].get<std::string>(), HasSubstr("front"));
  EXPECT_EQ(delaunay["findings"][0]["code"], "not_supported");
  const nlohmann::json missing = told({"mesh", path("no.brep"), "--json"}, 3);
  EXPECT_EQ(missing["findings"][0]["code"], "file_not_found");
}

TEST_F(SurfaceCommand, TrimsWithoutASurfaceAreRefusedWithTheirLine) {
  const std::string lines =
      "[[input.trim]]\nname = \"h\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [1, 1]\nradius = 1\n";
  auto outcome = call({"mesh", put("alone.toml", head + lines)});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("alone.toml:3:"), HasSubstr("there is no [[input.surface]]")));
  outcome = call({"mesh", put("beside.toml", head + "[input]\nfile = \"part.brep\"\n" + lines)});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("meshed as the file bounds them"));
}

TEST_F(SurfaceCommand, ManyNamesThatAFormatChangesAreThreeLines) {
  const std::string file =
      (std::filesystem::path(DOBRA_SOURCE_DIR) / "tests/shared/io/brep/data/box_fillet.brep").string();
  const auto lines = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("is written as"); at != std::string::npos; at = text.find("is written as", at + 1))
      ++count;
    return count;
  };
  const auto brief = call({"mesh", file, "--size", "1", "--out", path("m.inp")});
  EXPECT_EQ(lines(brief.err), 6U);  // regions and sets of sides
  EXPECT_THAT(brief.err, HasSubstr("more like these (--verbose prints them"));
  const auto whole = call({"mesh", file, "--size", "1", "--out", path("m.inp"), "--verbose"});
  EXPECT_GT(lines(whole.err), 20U);
  EXPECT_GT(told({"mesh", file, "--size", "1", "--out", path("m.inp"), "--json"})["remarks"].size(), 20U);
}

TEST_F(SurfaceCommand, SizesTooSmallForMemoryAreRefused) {
  const auto outcome = call({"mesh", put("good.toml", plate), "--size", "1e-9", "--json"});
  EXPECT_TRUE(outcome.code == 3 || outcome.code == 4) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("findings"));
}

/// Doubles there are 2e-9 and 1e-8 m apart: what is nearer is no progress of a search.
TEST_F(SurfaceCommand, ASphereFarFromTheOriginIsMeshedAsOneAtIt) {
  const auto elements = [&](const std::string& at) {
    const std::string file = put("ball.toml", head + "[[input.surface]]\nname = \"s\"\nkind = \"sphere\"\norigin = [" +
                                                  at + ", 0, 0]\nradius = 1\nu = [0, 360]\nv = [-90, 90]\n");
    const json json = told({"mesh", file, "--size", "0.5", "--json"});
    EXPECT_NEAR(json["area_surface"].get<double>(), 4.0 * pi, 1e-6) << at;
    EXPECT_GT(json["alpha_min"].get<double>(), 0.8) << at;
    return json["elements"].get<double>();
  };
  const double near = elements("0");
  for (const char* at : {"1e7", "1e8"}) EXPECT_NEAR(elements(at), near, 0.05 * near) << at;
}

TEST_F(SurfaceCommand, CoordinatesAreThoseOfTheUnits) {
  const json json = told(
      {"mesh",
       put("mm.toml", "dobra = 1\nprogram = \"quebra\"\nunit_system = \"mm, N, MPa\"\n" + plate.substr(head.size())),
       "--size", "3", "--out", path("m.obj"), "--json"});
  EXPECT_NEAR(json["area"].get<double>(), 100.0, 1e-9);
  EXPECT_THAT(text("m.obj"), HasSubstr("v 10.0 10.0 0.0"));
}

TEST_F(SurfaceCommand, FormatsOfPlaneMeshesAreRefused) {
  const auto outcome = call({"mesh", put("good.toml", plate), "--out", path("m.nf")});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("meshes of surfaces are written to files that end in"));
}

TEST_F(SurfaceCommand, SizesMayBeAFormulaOfSpaceAndOfTheChart) {
  const std::string file = put("good.toml", plate);
  const auto by = [&](const std::string& formula) {
    return told({"mesh", file, "--size", "2", "--size-formula", formula, "--json"})["elements"].get<double>();
  };
  EXPECT_NEAR(by("0.5 + 0 * z"), by("0.5 + 0 * u"), 1.0);
  EXPECT_GT(by("0.3 + 0.1 * x"), 3.0 * by("2"));
  EXPECT_GT(by("0.3 + 0.1 * u"), 3.0 * by("2"));
}

TEST_F(SurfaceCommand, TheMesherOfThePaperTakesPlaneDomainsToo) {
  const std::string file = put("plane.toml", head +
                                                 "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\n"
                                                 "points = [[0, 0], [4, 0], [4, 4], [0, 4]]\n"
                                                 "[[input.curve]]\nname = \"hole\"\nkind = \"polygon\"\n"
                                                 "points = [[1, 1], [3, 1], [3, 2], [1, 2]]\n");
  const json json = told({"mesh", file, "--size", "0.4", "--engine", "paper", "--json"});
  EXPECT_NEAR(json["area"].get<double>(), 14.0, 1e-9);
  EXPECT_GT(json["alpha_mean"].get<double>(), 0.85);
  const auto outcome = call({"mesh", file, "--size", "0.4", "--engine", "paper", "--stop-after", "5"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("stop_after"));
}

TEST_F(SurfaceCommand, SUR_k_TheSameScenarioGivesTheSameFiles) {
  const std::string file = (std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/surfaces/8d.toml").string();
  for (const std::string engine : {"front", "paper"}) {
    for (const std::string ending : {".vtu", ".msh", ".inp", ".bdf"}) {
      for (const auto& [name, threads] : {std::pair{"one", "1"}, std::pair{"two", "2"}}) {
        const auto outcome = call({"mesh", file, "--size", "2", "--engine", engine, "--threads", threads, "--out",
                                   path(std::string(name) + ending)});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
      }
      EXPECT_GT(text("one" + ending).size(), 1000U);
      EXPECT_EQ(text("one" + ending), text("two" + ending)) << engine << ending;
    }
  }
}

TEST_F(SurfaceCommand, TheScenarioOfThePageRunsAndRaisesNoFinding) {
  const std::string page =
      dobra::io::read_text((std::filesystem::path(DOBRA_SOURCE_DIR) / "docs/user/surfaces.md").string()).value();
  const std::size_t begin = page.find("dobra = 1\n"), end = page.find("```", begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string file = put("shell.toml", page.substr(begin, end - begin));
  const auto run = call({"run", file, "--set", "steps.1.size=5", "--out", path("out")});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(text("out/shell.inp"), HasSubstr("*SHELL SECTION"));
  EXPECT_THAT(text("out/mesh.inp"), testing::AllOf(HasSubstr("crack_left"), HasSubstr("crack_right")));
  const json json = told({"mesh", file, "--size", "3", "--turn", "15", "--json"});
  EXPECT_EQ(json["findings"].size(), 0U) << json["findings"];
}

/// A stand-in with the size and turn of the table of the paper, or larger ones for the time that it takes.
struct Case {
  const char* name;
  const char* size;
  const char* turn;
};
class StandIns : public SurfaceCommand, public testing::WithParamInterface<Case> {};

TEST_P(StandIns, SUR_f_AreMeshedByBothEngines) {
  const auto& [name, size, turn] = GetParam();
  const std::string file =
      (std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/surfaces" / (std::string(name) + ".toml"))
          .string();
  for (const std::string engine : {"front", "paper"}) {
    const json json = told({"mesh", file, "--size", size, "--turn", turn, "--engine", engine, "--json"});
    ASSERT_TRUE(json.contains("area")) << engine;
    EXPECT_NEAR(json["area"].get<double>(), json["area_surface"].get<double>(),
                0.01 * json["area_surface"].get<double>())
        << engine;
    EXPECT_GE(json["alpha_mean"].get<double>(), engine == "front" ? 0.97 : 0.90) << engine;
    EXPECT_GE(json["alpha_90"].get<double>(), engine == "front" ? 95.0 : 75.0) << engine;
    EXPECT_GE(json["alpha_min"].get<double>(), engine == "front" ? 0.60 : 0.15) << engine;
  }
}
INSTANTIATE_TEST_SUITE_P(Surfaces, StandIns,
                         testing::Values(Case{"6", "1", "10"}, Case{"7a", "0.5", "10"}, Case{"7b", "1.5", "15"},
                                         Case{"7c", "0.5", "10"}, Case{"7d", "1", "15"}, Case{"7e", "1.5", "10"},
                                         Case{"7f", "1.5", "15"}, Case{"8a", "0.5", "15"}, Case{"8b", "0.5", "15"},
                                         Case{"8c", "0.5", "15"}, Case{"8d", "0.5", "10"}, Case{"8e", "1", "5"},
                                         Case{"8f", "1", "10"}),
                         [](const auto& stand_in) { return "of_figure_" + std::string(stand_in.param.name); });

}  // namespace
}  // namespace quebra::cli
