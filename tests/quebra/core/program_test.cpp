// QUEBRA's main job through its table of operations, as the window, the command line and scenario files call it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <set>

#include "quebra/core/operations.h"
#include "quebra/model/model.h"
#include "shared/geom/predicates.h"
#include "shared/io/formats/format.h"
#include "shared/io/meshes/bdf.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/neutral.h"
#include "shared/io/meshes/node_ele.h"
#include "shared/io/meshes/vtu.h"
#include "shared/scenario/runner.h"

namespace quebra::core {
namespace {

using namespace dobra;
namespace fs = std::filesystem;

scenario::Document example() {
  return scenario::read_document(fs::path(DOBRA_SOURCE_DIR) / "resources/examples/quebra/plate_with_hole.toml").value();
}

scenario::Run run(const scenario::Document& document) {
  scenario::Runner runner(program());
  scenario::Run run = runner.run(document);
  EXPECT_TRUE(run.complete()) << to_string(*run.error);
  return run;
}

scenario::Document parse(const std::string& text) {
  auto document = scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "test.toml");
  EXPECT_TRUE(document.ok()) << (document ? "" : to_string(document.error()));
  return *document;
}

const model::Model& final_model(const scenario::Run& run) {
  return scenario::model_of<model::Model>(run.states.back());
}

std::map<std::string, double> quantities(const scenario::Run& run) {
  std::map<std::string, double> values;
  for (const auto& quantity : program().quantities_of(run.states.back())) values[quantity.name] = quantity.value;
  return values;
}

const std::string unit_square =
    "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";

TEST(QuebraProgram, TheFileOfTheInputMayBeOfEveryFormatThatIsRead) {
  const auto field = std::find_if(program().input_fields.begin(), program().input_fields.end(),
                                  [](const scenario::Field& one) { return one.key == "file"; });
  ASSERT_NE(field, program().input_fields.end());
  std::set<std::string> offered;
  for (const scenario::FileKind& kind : field->options.files) {
    for (const std::string& ending : kind.endings) EXPECT_TRUE(offered.insert(ending).second) << ending;
  }
  for (const auto& format : io::formats::all_formats()) {
    for (const std::string& ending : format.endings) EXPECT_EQ(offered.contains(ending), ending != ".node") << ending;
  }
}

TEST(QuebraProgram, EveryExampleMeetsItsExpectations) {
  for (const auto& entry : fs::directory_iterator(fs::path(DOBRA_SOURCE_DIR) / "resources/examples/quebra")) {
    const auto document = scenario::read_document(entry.path()).value();
    const auto done = run(document);
    for (const auto& verdict : scenario::judge(document, program(), done))
      EXPECT_TRUE(verdict.met) << entry.path() << ": " << verdict.message;
  }
}

TEST(QuebraProgram, QUE_d_TheFreeMeshIsValidAndItsQualityIsReported) {
  const auto done = run(example());
  const auto& meshed = *final_model(done).meshes.front();
  EXPECT_EQ(meshed.mesh.side_sets.at("hole").size(), 24U);
  for (const char* side : {"bottom", "right", "top", "left"})
    EXPECT_EQ(meshed.mesh.side_sets.at(side).size(), 5U) << side;
  EXPECT_TRUE(mesh::check(meshed.mesh).ok());
  EXPECT_GE(quantities(done).at("mesh.1.alpha_mean"), 0.9);
}

TEST(QuebraProgram, QUE_e_ConstraintsAreEdgesAndGradeTheMesh) {
  const auto done = run(example());
  const model::Model& model = final_model(done);
  const auto& with = *model.meshes.back();
  ASSERT_EQ(model.constraints.size(), 6U);
  EXPECT_NEAR(model.constraints.back().distance, 0.065 * (std::pow(1.3, 6) - 1) / 0.3, 1e-12);

  std::set<std::pair<mesh::NodeId, mesh::NodeId>> edges;
  const mesh::TriangleMesh triangles = triangle_mesh_of(with.mesh);
  for (const auto& [a, b] : mesh::all_edges(triangles)) edges.insert({a, b});
  for (const model::Constraint& constraint : model.constraints) {
    double along = 0.0;
    for (const auto& [a, b] : triangles.constraint_sets.at(constraint.name)) {
      EXPECT_TRUE(edges.contains({std::min(a, b), std::max(a, b)}));
      along += distance(with.mesh.point(a), with.mesh.point(b));
    }
    EXPECT_NEAR(along, length(constraint.line), 1e-12 * along) << "the edges make up the whole constraint";
  }
  const auto values = quantities(done);
  EXPECT_GT(values.at("mesh.2.elements"), values.at("mesh.1.elements"));
  EXPECT_LT(values.at("mesh.2.gradation_p95"), values.at("mesh.1.gradation_p95"));
  EXPECT_LE(values.at("mesh.2.gradation_p95"), 3.0);
  EXPECT_GE(values.at("mesh.2.alpha_mean"), 0.90);
}

TEST(QuebraProgram, ConstraintsOfAnArcAreConcentricAndEndOnTheBoundary) {
  const auto done = run(example());
  for (const model::Constraint& constraint : final_model(done).constraints) {
    for (const auto p : constraint.line.points) {
      // The arc is followed by chords of at most 2 degrees, mitred: vertices lie outside the true offset by less than
      // this.
      const double excess =
          (1.0 + constraint.distance) / std::cos(std::numbers::pi / 180.0) - (1.0 + constraint.distance);
      EXPECT_NEAR(std::hypot(p.x, p.y), 1.0 + constraint.distance, excess + 1e-12);
    }
    ASSERT_EQ(constraint.feet.size(), 2U);
    EXPECT_EQ(std::min(constraint.line.points.front().x, constraint.line.points.back().x), 0.0);
    EXPECT_EQ(std::min(constraint.line.points.front().y, constraint.line.points.back().y), 0.0);
  }
}

TEST(QuebraProgram, ConstraintsOfAClosedHoleAreClosedRings) {
  const auto done =
      run(parse(unit_square + "[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = [2, 2]\nradius = 0.5\n"
                              "[[step]]\noperation = \"constraints\"\ncurves = [\"hole\"]\ncount = 3\ndistance = 0.2\n"
                              "[[step]]\noperation = \"mesh\"\nsize = 0.4\n"));
  const model::Model& model = final_model(done);
  ASSERT_EQ(model.constraints.size(), 3U);
  for (const auto& constraint : model.constraints) {
    EXPECT_TRUE(constraint.line.closed);
    EXPECT_TRUE(constraint.feet.empty());
  }
  EXPECT_TRUE(mesh::check(model.meshes.back()->mesh).ok());
}

TEST(QuebraProgram, ConstraintsAreCutWhereTheyLeaveTheDomain) {
  // Rings of the hole at 1.2 reach beyond the right side, 1 m away from its rim.
  const auto done =
      run(parse(unit_square + "[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = [2.5, 2]\nradius = 0.5\n"
                              "[[step]]\noperation = \"constraints\"\ncurves = [\"hole\"]\ncount = 1\ndistance = 1.2\n"
                              "[[step]]\noperation = \"mesh\"\nsize = 0.4\n"));
  const model::Model& model = final_model(done);
  ASSERT_EQ(model.constraints.size(), 1U);
  const auto& ring = model.constraints.front();
  EXPECT_FALSE(ring.line.closed);
  EXPECT_EQ(ring.feet.size(), 2U);
  for (const auto p : ring.line.points) EXPECT_LE(p.x, 4.0);
  EXPECT_EQ(ring.line.points.front().x, 4.0);
  EXPECT_EQ(ring.line.points.back().x, 4.0);
  EXPECT_TRUE(mesh::check(model.meshes.back()->mesh).ok());
}

TEST(QuebraProgram, ConstraintsFartherThanTheDomainGetARemark) {
  const auto done = run(
      parse(unit_square + "[[step]]\noperation = \"constraints\"\ncurves = [\"plate\"]\ncount = 1\ndistance = 9.0\n"));
  EXPECT_TRUE(final_model(done).constraints.empty());
  ASSERT_EQ(final_model(done).remarks.size(), 1U);
  EXPECT_NE(final_model(done).remarks.front().find("left out"), std::string::npos);
}

TEST(QuebraProgram, QUE_i_EveryExportReadsBackWithTheSameCounts) {
  const auto done = run(example());
  const auto& mesh = final_model(done).meshes.back()->mesh;
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_export";
  fs::create_directories(folder);
  for (const auto& output : program().outputs_of(done.states.back()))
    ASSERT_TRUE(output.write(folder / output.file_name).ok()) << output.file_name;
  const auto counts = [&](const mesh::ElementMesh& read, const char* what) {
    EXPECT_EQ(read.points, mesh.points) << what;
    EXPECT_EQ(read.nodes, mesh.nodes) << what;
  };
  counts(io::meshes::read_vtu((folder / "mesh.vtu").string()).value().mesh, "vtu");
  counts(io::meshes::read_msh((folder / "mesh.msh").string()).value().mesh, "msh");
  counts(io::meshes::read_inp((folder / "mesh.inp").string()).value().mesh, "inp");
  counts(io::meshes::read_neutral((folder / "mesh.nf").string()).value().mesh, "nf");
  EXPECT_EQ(io::meshes::read_bdf((folder / "mesh.bdf").string()).value().mesh.nodes, mesh.nodes)
      << "its coordinates are rounded";
  counts(io::meshes::read_node_ele((folder / "mesh").string()).value(), "node, ele");
  fs::remove_all(folder);
}

TEST(QuebraProgram, ExportsThatRenameSetsTellIt) {
  const auto done =
      run(parse("[[input.curve]]\nname = \"left side\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, "
                "4]]\n[[step]]\noperation = \"mesh\"\nsize = 1.0\n"));
  for (const auto& output : program().outputs_of(done.states.back())) {
    if (output.file_name != "mesh.inp") {
      EXPECT_TRUE(output.losses.empty()) << output.file_name << output.losses.front();
      continue;
    }
    ASSERT_EQ(output.losses.size(), 1U);
    EXPECT_NE(output.losses.front().find("left side"), std::string::npos) << output.losses.front();
  }
}

TEST(QuebraProgram, ADeckOfTheMeshHasTheElementsOfTheScenario) {
  const fs::path file = fs::temp_directory_path() / "dobra_quebra_plane.inp";
  const auto deck = [&](const std::string& problem, const std::string& order) {
    const auto done =
        run(parse(unit_square + problem + "[[step]]\noperation = \"mesh\"\nsize = 1.0\norder = \"" + order + "\"\n"));
    for (const auto& output : program().outputs_of(done.states.back())) {
      if (output.file_name != "mesh.inp") continue;
      EXPECT_TRUE(output.write(file).ok());
    }
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto state = [](const std::string& name) {
    return "[[step]]\noperation = \"problem\"\nstate = \"" + name +
           "\"\n[[step.material]]\nyoung = 1.0\npoisson = 0.3\n";
  };
  for (const char* const order : {"1", "2"}) {
    const std::string nodes = order[0] == '1' ? "3" : "6";
    EXPECT_NE(deck(state("strain"), order).find("TYPE=CPE" + nodes), std::string::npos) << order;
    EXPECT_NE(deck(state("stress"), order).find("TYPE=CPS" + nodes), std::string::npos) << order;
    EXPECT_NE(deck("", order).find("TYPE=CPS" + nodes), std::string::npos) << order;
  }
  fs::remove(file);
}

TEST(QuebraProgram, AnAnalysisThatNoDeckHoldsIsToldWhereTheDeckWouldBeWritten) {
  const auto outputs = [](const std::string& poisson) {
    const auto done = run(parse(
        unit_square +
        "[[step]]\noperation = \"problem\"\nstate = \"strain\"\n[[step.material]]\nyoung = 1.0\npoisson = " + poisson +
        "\n[[step.support]]\nwhere = \"plate\"\nx = 0.0\ny = 0.0\n[[step.load]]\nkind = \"body\"\ny = "
        "-1.0\n[[step]]\noperation = \"mesh\"\nsize = 1.0\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n"));
    for (const std::string& remark : final_model(done).remarks)
      EXPECT_EQ(remark.find("analysis.inp"), std::string::npos)
          << remark;  // no command but one that writes files says it
    std::map<std::string, std::vector<std::string>> losses;
    for (const auto& output : program().outputs_of(done.states.back())) losses[output.file_name] = output.losses;
    return losses;
  };
  const auto locked = outputs("0.4999");
  EXPECT_FALSE(locked.contains("analysis.inp"));
  ASSERT_EQ(locked.at("results.vtu").size(), 1U);
  EXPECT_EQ(locked.at("results.vtu").front().rfind("analysis.inp is not written: ", 0), 0U);
  const auto plain = outputs("0.3");
  EXPECT_TRUE(plain.contains("analysis.inp"));
  EXPECT_TRUE(plain.at("results.vtu").empty());
}

TEST(QuebraProgram, APolyFileWithAHoleIsMeshedWithoutTheHole) {
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_poly";
  fs::create_directories(folder);
  std::ofstream(folder / "plate.poly")
      << "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
         "5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n1\n1 1.5 1.5\n";
  auto document = parse("[input]\nfile = \"plate.poly\"\n[[step]]\noperation = \"mesh\"\nsize = 0.5\n");
  document.file = folder / "test.toml";
  EXPECT_NEAR(quantities(run(document)).at("area"), 15.0, 1e-12);
  fs::remove_all(folder);
}

TEST(QuebraProgram, APolyFileWithoutHolePointKeepsTheInnerLoopAsInterface) {
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_poly2";
  fs::create_directories(folder);
  std::ofstream(folder / "plate.poly") << "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n8 0\n1 1 "
                                          "2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n0\n";
  auto document = parse("[input]\nfile = \"plate.poly\"\n[[step]]\noperation = \"mesh\"\nsize = 0.5\n");
  document.file = folder / "test.toml";
  EXPECT_NEAR(quantities(run(document)).at("area"), 16.0, 1e-12);
  fs::remove_all(folder);
}

TEST(QuebraProgram, ChangingTheLastStepKeepsTheFirstStates) {
  scenario::Runner runner(program());
  auto document = example();
  ASSERT_TRUE(runner.run(document).complete());
  document.steps.back().params.set("smoothing", std::int64_t{1});
  ASSERT_TRUE(runner.run(document).complete());
  EXPECT_EQ(runner.computed(), 1U);
}

TEST(QuebraProgram, ACancelledMeshSaysSo) {
  base::CancelToken token;
  token.cancel();
  scenario::Runner runner(program());
  const auto done = runner.run(example(), base::Progress(token, {}));
  ASSERT_FALSE(done.complete());
  EXPECT_EQ(done.error->code, base::ErrorCode::Cancelled);
}

}  // namespace
}  // namespace quebra::core
