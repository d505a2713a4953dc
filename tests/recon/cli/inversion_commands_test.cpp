// recon invert and recon predict: what they print, write and refuse.

#include "recon/cli/inversion_commands.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "recon/core/operations.h"
#include "tests/recon/inversion/folded_beds.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using Found = nlohmann::json;

class InversionCommands : public dobra::test::CommandLine {
 protected:
  InversionCommands() : CommandLine(core::program(), {invert_command(), predict_command()}) {}

  /// Two beds folded by trishear with its tip at (1000, 300), ramp 30, P/S 2, apical angle 50, slip 250.
  [[nodiscard]] std::string folded() const {
    std::string csv = "x,z,name\n";
    for (const section::Horizon& bed : test::folded_beds({}, {200, 400}, 31).horizons) {
      for (const geom::Point p : bed.line.points) csv += fmt::format("{},{},{}\n", p.x, p.y, bed.name);
      csv += '\n';
    }
    return put("folded.csv", csv);
  }
  [[nodiscard]] Found printed(const std::vector<std::string>& args) const {
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? Found::parse(outcome.out) : Found();
  }
};

TEST_F(InversionCommands, InvertPrintsValuesLimitsMisfitsAndTheMap) {
  const Found made =
      printed({"invert", folded(),      "--unit",        "m",      "--tip-x",      "1000",  "--tip-z", "300",
               "--ramp", "30",          "--propagation", "1,3",    "--apical",     "40,60", "--slip",  "150,400",
               "--map",  "propagation", "--map",         "apical", "--map-points", "3",     "--out",   path("map.png"),
               "--json", "--quiet"});
  EXPECT_EQ(made["method"], "trishear");
  ASSERT_EQ(made["values"].size(), 7U);
  EXPECT_TRUE(made["values"][0]["fixed"]);
  EXPECT_EQ(made["values"][3]["name"], "propagation");
  EXPECT_NEAR(made["values"][3]["best"], 2.0, 1e-3);
  EXPECT_NEAR(made["values"][5]["best"], 250.0, 0.1);
  EXPECT_LE(made["values"][5]["low"], 250.0);
  EXPECT_EQ(made["values"][5]["limits"], Found({150.0, 400.0}));
  EXPECT_LE(made["misfit"], 1e-3);
  EXPECT_EQ(made["beds"].size(), 2U);
  EXPECT_EQ(made["map"]["misfit"].size(), 9U);
  EXPECT_GT(std::filesystem::file_size(path("map.png")), 1000U);
}

TEST_F(InversionCommands, WithAllValuesFixedInvertTellsTheirMisfit) {
  const Found made = printed({"invert", folded(), "--unit", "m", "--tip-x", "1000", "--tip-z", "300", "--ramp", "30",
                              "--propagation", "2", "--apical", "50", "--slip", "250", "--json", "--quiet"});
  EXPECT_LE(made["misfit"], 1e-6);
  EXPECT_GT(made["misfit_before"], 10.0);
}

TEST_F(InversionCommands, PredictListsBothFoldsOfABacklimb) {
  const Found made = printed(
      {"predict", folded(), "--unit", "m", "--what", "fault_bend_fold", "--backlimb", "20", "--json", "--quiet"});
  ASSERT_EQ(made["solutions"].size(), 2U);
  EXPECT_NEAR(made["solutions"][0]["gamma"], 78.420, 5e-4);
  EXPECT_FALSE(made["remarks"].empty());
}

TEST_F(InversionCommands, BadValuesEndWithThreeAndUsageWithTwo) {
  const std::string file = folded();
  const auto reversed = call({"invert", file, "--unit", "m", "--slip", "300,100"});
  EXPECT_EQ(reversed.code, 3);
  EXPECT_NE(reversed.err.find("'slip' is one number"), std::string::npos);
  EXPECT_EQ(call({"invert", file, "--unit", "m", "--slip", "much"}).code, 2);
  EXPECT_EQ(call({"predict", file, "--unit", "m"}).code, 3);
  EXPECT_EQ(call({"predict", file, "--unit", "m", "--what", "fault_bend_fold", "--backlimb", "35"}).code, 4);
  EXPECT_EQ(call({"predict", file, "--unit", "m", "--what", "fault", "--fault", "F", "--horizon", "bed 1"}).code, 3);
}

}  // namespace
}  // namespace recon::cli
