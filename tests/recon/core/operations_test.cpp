#include "recon/core/operations.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "shared/scenario/runner.h"
#include "tests/recon/shapes.h"

namespace recon::core {
namespace {

namespace scenario = dobra::scenario;

const std::string head =
    "dobra = 1\nprogram = \"recon\"\n[input]\n"
    "[[input.horizon]]\nname = \"top\"\npoints = [[0.0, 0.0], [5.0, 2.0], [10.0, 0.0]]\n"
    "[[input.horizon]]\nname = \"base\"\npoints = [[0.0, -1.0], [5.0, 1.0], [10.0, -1.0]]\n";
const std::string grid_step = "[[step]]\noperation = \"grid\"\ncount = 3\ndistance = 0.25\n";
const std::string target_step = "[[step]]\noperation = \"target\"\n";
const std::string restore_step = "[[step]]\noperation = \"restore\"\n";

scenario::Run run_text(const std::string& text) {
  const auto document = scenario::parse_document(text, "test.toml");
  EXPECT_TRUE(document) << to_string(document.error());
  if (const auto checked = scenario::check(*document, program()); !checked) {
    scenario::Run failed;
    failed.error = checked.error();
    return failed;
  }
  return scenario::Runner(program()).run(*document);
}

std::string error_of(const std::string& text) {
  const scenario::Run run = run_text(text);
  return run.error ? to_string(*run.error) : "no error";
}

double quantity(const scenario::Run& run, const std::string& name) {
  for (const scenario::Quantity& q : program().quantities_of(run.states.back())) {
    if (q.name == name) return q.value;
  }
  ADD_FAILURE() << "no quantity " << name;
  return std::nan("");
}

TEST(Operations, AScenarioRunsGridTargetAndRestore) {
  const scenario::Run run = run_text(head + grid_step + target_step + restore_step);
  ASSERT_TRUE(run.complete()) << to_string(*run.error);
  EXPECT_EQ(quantity(run, "grid.curves"), 3.0);
  EXPECT_EQ(quantity(run, "target.curves"), 3.0);
  EXPECT_EQ(quantity(run, "columns"), 2.0);
  EXPECT_NEAR(quantity(run, "top.length_after"), 2.0 * std::sqrt(29.0), 1e-12);
  EXPECT_NEAR(quantity(run, "shortening"), 2.0 * std::sqrt(29.0) - 10.0, 1e-12);
  EXPECT_EQ(quantity(run, "points"), 6.0);
  const auto tables = program().tables_of(run.states.back());
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_EQ(tables[0].name, "line_length");
  ASSERT_EQ(tables[0].rows.size(), 2u);
  for (const auto& table : tables) {
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  }
}

TEST(Operations, StepsThatLackAnEarlierStepSayWhichOne) {
  EXPECT_NE(error_of(head + target_step).find("put a step 'grid' before it"), std::string::npos);
  EXPECT_NE(error_of(head + restore_step).find("put the steps 'grid' and 'target' before it"), std::string::npos);
  EXPECT_NE(error_of(head + grid_step + restore_step).find("put a step 'target' before it"), std::string::npos);
}

TEST(Operations, ALaterGridForgetsWhatStoodOnTheEarlierOne) {
  EXPECT_NE(error_of(head + grid_step + target_step + grid_step + restore_step).find("needs a target"),
            std::string::npos);
}

TEST(Operations, WrongParametersAreRefusedWithTheLine) {
  EXPECT_NE(error_of(head + "[[step]]\noperation = \"grid\"\ncuont = 3\n").find("did you mean 'count'?"),
            std::string::npos);
  EXPECT_NE(error_of(head + "[[step]]\noperation = \"grid\"\ncount = 0\n").find("test.toml:"), std::string::npos);
  EXPECT_NE(error_of(head + "[[step]]\noperation = \"grid\"\ndistance = 0.0\n").find("test.toml:"), std::string::npos);
  EXPECT_NE(error_of(head + "[[step]]\noperation = \"grid\"\nfactor = -1.0\n").find("test.toml:"), std::string::npos);
}

TEST(Operations, ThePinMustBeOnTheTopAndItsGoalOnTheTarget) {
  const std::string outside = error_of(head + grid_step + "[[step]]\noperation = \"target\"\npin = 11.0\n");
  EXPECT_NE(outside.find("the pin x = 11 is not on the top; take one from 0 to 10"), std::string::npos) << outside;
  const std::string beside = error_of(
      head + grid_step + "[[step]]\noperation = \"target\"\nshape = \"line\"\npoints = [[20.0, 0.0], [30.0, 1.0]]\n");
  EXPECT_NE(beside.find("target_pin"), std::string::npos) << beside;
}

TEST(Operations, ParametersOfATargetThatContradictEachOtherAreRefused) {
  const std::string step = "[[step]]\noperation = \"target\"\n";
  EXPECT_NE(error_of(head + grid_step + step + "points = [[0.0, 0.0], [1.0, 0.0]]\n").find("shape = \"line\""),
            std::string::npos);
  EXPECT_NE(error_of(head + grid_step + step + "elevation = 2.0\ntarget_pin = [0.0, 1.0]\n").find("different heights"),
            std::string::npos);
  EXPECT_NE(error_of(head + grid_step + step + "shape = \"line\"\n").find("needs file"), std::string::npos);
  EXPECT_NE(error_of(head + grid_step + step + "shape = \"line\"\nelevation = 1.0\npoints = [[0.0, 0.0], [1.0, 0.0]]\n")
                .find("flat target"),
            std::string::npos);
}

TEST(Operations, AShortTargetIsContinuedWithARemark) {
  const scenario::Run run = run_text(
      head + grid_step + "[[step]]\noperation = \"target\"\nshape = \"line\"\npoints = [[0.0, 5.0], [4.0, 5.0]]\n" +
      restore_step);
  ASSERT_TRUE(run.complete()) << to_string(*run.error);
  EXPECT_NEAR(quantity(run, "target.extended"), 2.0 * std::sqrt(29.0) - 4.0, 1e-12);
  bool remarked = false;
  for (const std::string& remark : program().remarks_of(run.states.back())) {
    remarked = remarked || remark.find("shorter than the top") != std::string::npos;
  }
  EXPECT_TRUE(remarked);
}

TEST(Operations, FilesAreWrittenForWhatTheModelHas) {
  const scenario::Run run = run_text(head + grid_step + target_step + restore_step);
  ASSERT_TRUE(run.complete());
  const auto names = [](const scenario::State& state) {
    std::set<std::string> found;
    for (const scenario::Output& output : program().outputs_of(state)) found.insert(output.file_name);
    return found;
  };
  EXPECT_TRUE(names(run.states[0]).empty());
  EXPECT_EQ(names(run.states[1]), (std::set<std::string>{"source_grid.geojson"}));
  EXPECT_EQ(names(run.states[3]),
            (std::set<std::string>{"source_grid.geojson", "target_grid.geojson", "restored.geojson", "restored.csv"}));
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "recon_operations_test";
  std::filesystem::create_directories(folder);
  for (const scenario::Output& output : program().outputs_of(run.states[3])) {
    const auto written = output.write(folder / output.file_name);
    ASSERT_TRUE(written) << to_string(written.error());
    EXPECT_GT(std::filesystem::file_size(folder / output.file_name), 100u);
  }
  std::ifstream csv(folder / "restored.csv");
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "horizon,x [m],z [m],x_before [m],z_before [m],depth [m]");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace recon::core
