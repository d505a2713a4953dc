#include "recon/cli/ledger_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using Json = nlohmann::ordered_json;

class LedgerJson : public dobra::test::CommandLine {
 protected:
  LedgerJson() : CommandLine(core::program(), {restore_command(), balance_command()}) {}

  [[nodiscard]] std::string section(const std::string& more = "") const {
    return put("section.csv",
               "x,z,name,kind\n0,0,top,horizon\n50,10,top,horizon\n100,0,top,horizon\n"
               "0,-20,base,horizon\n50,-10,base,horizon\n100,-20,base,horizon\n" +
                   more);
  }
  [[nodiscard]] Json json(const std::vector<std::string>& args) const {
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? Json::parse(outcome.out) : Json();
  }
  static std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
  }
};

TEST_F(LedgerJson, ARestorationHasTheKeysOfTheManual) {
  const Json made = json({"restore", section(), "--json"});
  EXPECT_EQ(keys_of(made),
            (std::vector<std::string>{"method", "keeps", "percent", "ledger", "greatest_length_change_percent",
                                      "greatest_area_change_percent", "inconsistency_percent", "tolerance_percent",
                                      "lean_left", "lean_right", "verdict", "remarks"}));
  EXPECT_EQ(made["method"], "constant");
  EXPECT_TRUE(made["verdict"] == "balanced" || made["verdict"] == "not balanced");
  ASSERT_EQ(made["ledger"].size(), 2u);
  const std::vector<std::string> wanted{"name",
                                        "kind",
                                        "length_before",
                                        "length_after",
                                        "change_percent",
                                        "width_before",
                                        "width_after",
                                        "shortening",
                                        "shortening_percent",
                                        "torn",
                                        "depth_min",
                                        "depth_mean",
                                        "depth_max",
                                        "layer",
                                        "area_before",
                                        "area_after",
                                        "area_change_percent",
                                        "thickness_min_before",
                                        "thickness_mean_before",
                                        "thickness_max_before",
                                        "thickness_min_after",
                                        "thickness_mean_after",
                                        "thickness_max_after",
                                        "dilatation_min_percent",
                                        "dilatation_mean_percent",
                                        "dilatation_max_percent"};
  EXPECT_EQ(keys_of(made["ledger"][0]), wanted);
  // Below the last one lies nothing, and what is not there has no key.
  EXPECT_EQ(keys_of(made["ledger"][1]), (std::vector<std::string>{wanted.begin(), wanted.begin() + 13}));
  EXPECT_EQ(made["ledger"][0]["name"], "top");
  EXPECT_EQ(made["ledger"][0]["kind"], "horizon");
  EXPECT_EQ(made["ledger"][0]["layer"], "top - base");
  EXPECT_NEAR(made["ledger"][0]["area_before"].get<double>(), 2000.0, 1e-9);
  EXPECT_FALSE(made.contains("restored"));
}

TEST_F(LedgerJson, GeometryAddsEveryRestoredThingWithItsKindAndPoints) {
  const Json made = json({"restore",
                          section("40,20,F,fault\n60,-40,F,fault\n10,12,P,pin\n10,-30,P,pin\n"
                                  "20,-5,U,unit\n30,-5,U,unit\n30,0,U,unit\n20,-5,U,unit\n"),
                          "--json", "--geometry"});
  ASSERT_TRUE(made.contains("restored"));
  std::vector<std::string> found;
  for (const Json& entry : made["restored"]) {
    EXPECT_EQ(keys_of(entry), (std::vector<std::string>{"name", "kind", "points"}));
    found.push_back(entry["kind"].get<std::string>() + ' ' + entry["name"].get<std::string>());
    for (const Json& point : entry["points"]) {
      ASSERT_EQ(point.size(), 2u);
      EXPECT_TRUE(point[0].is_number() && point[1].is_number());
    }
  }
  EXPECT_EQ(found, (std::vector<std::string>{"horizon top", "horizon base", "fault F", "pin P", "unit U"}));
  // Constant thickness about the left end of the top: flat at its height.
  for (const Json& point : made["restored"][0]["points"]) EXPECT_NEAR(point[1].get<double>(), 0.0, 1e-9);
}

TEST_F(LedgerJson, APolygonIsAnEntryOfItsOwn) {
  const Json made = json({"restore", section("0,-10,U,unit\n100,-10,U,unit\n50,0,U,unit\n0,-10,U,unit\n"), "--json"});
  ASSERT_EQ(made["ledger"].size(), 3u);
  EXPECT_EQ(made["ledger"][2]["kind"], "unit");
  EXPECT_NEAR(made["ledger"][2]["area_before"].get<double>(), 500.0, 1e-9);
}

TEST_F(LedgerJson, BalanceHasTheKeysOfTheManual) {
  const std::string lower = "0,-50,third,horizon\n50,-45,third,horizon\n100,-50,third,horizon\n";
  const Json made = json({"balance", section(lower), "--json"});
  EXPECT_EQ(keys_of(made), (std::vector<std::string>{"ledger", "fit", "layers", "inconsistency_percent",
                                                     "tolerance_percent", "verdict"}));
  EXPECT_EQ(keys_of(made["ledger"][0]), (std::vector<std::string>{"name", "length", "width", "shortening", "level",
                                                                  "excess_area", "detachment_depth", "layer_strain"}));
  EXPECT_EQ(keys_of(made["fit"]), (std::vector<std::string>{"displacement", "displacement_error", "detachment",
                                                            "detachment_error", "r_squared", "confidence_percent"}));
}

TEST_F(LedgerJson, WhatCannotBeToldOfABalanceHasNoKey) {
  // Beds of one shape have one excess area, which tells no detachment.
  const Json alike = json({"balance", section(), "--json"});
  EXPECT_FALSE(alike.contains("fit"));
  EXPECT_FALSE(alike["ledger"][0].contains("layer_strain"));
  const Json two = json(
      {"balance", put("two.csv", "x,z,name\n0,0,top\n50,10,top\n100,0,top\n0,-20,base\n50,-14,base\n100,-20,base\n"),
       "--json"});
  EXPECT_EQ(keys_of(two["fit"]), (std::vector<std::string>{"displacement", "detachment"}));
}

TEST_F(LedgerJson, OneHorizonOrAPolygonBelowItIsEnough) {
  const std::string top = "x,z,name,kind\n0,0,top,horizon\n50,10,top,horizon\n100,0,top,horizon\n";
  const std::string unit = "20,-20,U,unit\n60,-20,U,unit\n60,-10,U,unit\n20,-20,U,unit\n";
  const double length = 2.0 * std::hypot(50.0, 10.0);
  for (const std::string method : {"constant", "variable", "flexural"}) {
    for (const std::string& more : {std::string(), unit}) {
      const Json made = json({"restore", put("one.csv", top + more), "--json", "--method", method});
      ASSERT_EQ(made["ledger"].size(), more.empty() ? 1u : 2u);
      EXPECT_NEAR(made["ledger"][0]["width_after"].get<double>(), length, 1e-9);
    }
  }
}

TEST_F(LedgerJson, AreaBalanceHasValueErrorAndMost) {
  const Json made = json({"balance", put("polygon.txt", "0 0 1 1\n100 0 1 1\n100 20 1 1\n0 20 1 1\n"), "--json",
                          "--thickness", "10", "--thickness-error", "0.5"});
  const Json& area = made["area_balance"];
  EXPECT_EQ(keys_of(area),
            (std::vector<std::string>{"area", "initial_width", "width", "shortening", "shortening_percent"}));
  EXPECT_EQ(area["area"]["value"], 2000.0);
  EXPECT_EQ(area["initial_width"]["value"], 200.0);
  EXPECT_EQ(keys_of(area["area"]), (std::vector<std::string>{"value", "error", "most"}));
}

}  // namespace
}  // namespace recon::cli
