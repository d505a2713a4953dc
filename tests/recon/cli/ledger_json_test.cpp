#include "recon/cli/ledger_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

class LedgerJson : public dobra::test::CommandLine {
 protected:
  LedgerJson() : CommandLine(core::program(), {restore_command(), balance_command()}) {}

  [[nodiscard]] std::string section(const std::string& more = "") const {
    return put("section.csv",
               "x,z,name,kind\n0,0,top,horizon\n50,10,top,horizon\n100,0,top,horizon\n"
               "0,-20,base,horizon\n50,-10,base,horizon\n100,-20,base,horizon\n" +
                   more);
  }
  [[nodiscard]] OrderedJson json(const std::vector<std::string>& args) const {
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? OrderedJson::parse(outcome.out) : OrderedJson();
  }
  static std::vector<std::string> keys_of(const OrderedJson& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
  }
};

TEST_F(LedgerJson, ARestorationHasTheKeysOfTheManual) {
  const OrderedJson made = json({"restore", section(), "--json"});
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
  const OrderedJson made = json({"restore",
                                 section("40,20,F,fault\n60,-40,F,fault\n10,12,P,pin\n10,-30,P,pin\n"
                                         "20,-5,U,unit\n30,-5,U,unit\n30,0,U,unit\n20,-5,U,unit\n"),
                                 "--json", "--geometry"});
  ASSERT_TRUE(made.contains("restored"));
  std::vector<std::string> found;
  for (const OrderedJson& entry : made["restored"]) {
    EXPECT_EQ(keys_of(entry), (std::vector<std::string>{"name", "kind", "points"}));
    found.push_back(entry["kind"].get<std::string>() + ' ' + entry["name"].get<std::string>());
    for (const OrderedJson& point : entry["points"]) {
      ASSERT_EQ(point.size(), 2u);
      EXPECT_TRUE(point[0].is_number() && point[1].is_number());
    }
  }
  EXPECT_EQ(found, (std::vector<std::string>{"horizon top", "horizon base", "fault F", "pin P", "unit U"}));
  // Constant thickness about the left end of the top: flat at its height.
  for (const OrderedJson& point : made["restored"][0]["points"]) EXPECT_NEAR(point[1].get<double>(), 0.0, 1e-9);
}

TEST_F(LedgerJson, APolygonIsAnEntryOfItsOwn) {
  const OrderedJson made =
      json({"restore", section("0,-10,U,unit\n100,-10,U,unit\n50,0,U,unit\n0,-10,U,unit\n"), "--json"});
  ASSERT_EQ(made["ledger"].size(), 3u);
  EXPECT_EQ(made["ledger"][2]["kind"], "unit");
  EXPECT_NEAR(made["ledger"][2]["area_before"].get<double>(), 500.0, 1e-9);
}

TEST_F(LedgerJson, BalanceHasTheKeysOfTheManual) {
  const std::string lower = "0,-50,third,horizon\n50,-45,third,horizon\n100,-50,third,horizon\n";
  const OrderedJson made = json({"balance", section(lower), "--confidence", "50", "--json"});
  EXPECT_EQ(keys_of(made), (std::vector<std::string>{"ledger", "fit", "layers", "inconsistency_percent",
                                                     "tolerance_percent", "verdict"}));
  EXPECT_EQ(keys_of(made["ledger"][0]), (std::vector<std::string>{"name", "length", "width", "shortening", "level",
                                                                  "excess_area", "detachment_depth", "layer_strain"}));
  EXPECT_EQ(keys_of(made["fit"]), (std::vector<std::string>{"displacement", "displacement_error", "detachment",
                                                            "detachment_error", "r_squared", "confidence_percent"}));
}

TEST_F(LedgerJson, WhatCannotBeToldOfABalanceHasNoKey) {
  // Beds of one shape have one excess area, which tells no detachment.
  const OrderedJson alike = json({"balance", section(), "--json"});
  EXPECT_FALSE(alike.contains("fit"));
  EXPECT_FALSE(alike["ledger"][0].contains("layer_strain"));
  const OrderedJson two = json(
      {"balance", put("two.csv", "x,z,name\n0,0,top\n50,10,top\n100,0,top\n0,-20,base\n50,-14,base\n100,-20,base\n"),
       "--json"});
  EXPECT_EQ(keys_of(two["fit"]), (std::vector<std::string>{"displacement", "detachment"}));
  // One bed: nothing to compare, and that is no error.
  const std::string one = put("one.csv", "x,z,name\n0,0,top\n50,10,top\n100,0,top\n");
  EXPECT_EQ(json({"balance", one, "--json"})["verdict"], "not judged");
  EXPECT_EQ(json({"restore", one, "--json"})["verdict"], "not judged");
}

TEST_F(LedgerJson, OneHorizonOrAPolygonBelowItIsEnough) {
  const std::string top = "x,z,name,kind\n0,0,top,horizon\n50,10,top,horizon\n100,0,top,horizon\n";
  const std::string unit = "20,-20,U,unit\n60,-20,U,unit\n60,-10,U,unit\n20,-20,U,unit\n";
  const double length = 2.0 * std::hypot(50.0, 10.0);
  for (const std::string method : {"constant", "variable", "flexural"}) {
    for (const std::string& more : {std::string(), unit}) {
      const OrderedJson made = json({"restore", put("one.csv", top + more), "--json", "--method", method});
      ASSERT_EQ(made["ledger"].size(), more.empty() ? 1u : 2u);
      EXPECT_NEAR(made["ledger"][0]["width_after"].get<double>(), length, 1e-9);
    }
  }
}

TEST_F(LedgerJson, AreaBalanceHasValueErrorAndMost) {
  const OrderedJson made = json({"balance", put("polygon.txt", "0 0 1 1\n100 0 1 1\n100 20 1 1\n0 20 1 1\n"), "--json",
                                 "--thickness", "10", "--thickness-error", "0.5"});
  const OrderedJson& area = made["area_balance"];
  EXPECT_EQ(keys_of(area),
            (std::vector<std::string>{"area", "initial_width", "width", "shortening", "shortening_percent"}));
  EXPECT_EQ(area["area"]["value"], 2000.0);
  EXPECT_EQ(area["initial_width"]["value"], 200.0);
  EXPECT_EQ(keys_of(area["area"]), (std::vector<std::string>{"value", "error", "most"}));
}

TEST_F(LedgerJson, ALayerStandsWithTheHorizonAboveItWhicheverIsTheTop) {
  const std::string file = put("three.csv",
                               "x,z,name\n0,0,C\n50,10,C\n100,0,C\n0,-20,B\n50,-10,B\n100,-20,B\n"
                               "0,-50,A\n50,-40,A\n100,-50,A\n");
  for (const std::string top : {"A", "B", "C"}) {
    for (const std::string method : {"constant", "flexural"}) {
      const OrderedJson made = json({"restore", file, "--json", "--top", top, "--method", method});
      const OrderedJson& ledger = made["ledger"];
      ASSERT_EQ(ledger.size(), 3u) << top;
      EXPECT_EQ(ledger[0]["layer"], "C - B") << top;
      EXPECT_NEAR(ledger[0]["area_before"].get<double>(), 2000.0, 1e-9);
      EXPECT_EQ(ledger[1]["layer"], "B - A") << top;
      EXPECT_NEAR(ledger[1]["area_before"].get<double>(), 3000.0, 1e-9);
      EXPECT_FALSE(ledger[2].contains("layer")) << top;
    }
  }
}

TEST_F(LedgerJson, PolygonsOfOneUnitAreOneRowWithTheirSum) {
  const std::string first = "10,-10,K_1,unit\n20,-10,K_1,unit\n20,-5,K_1,unit\n10,-5,K_1,unit\n10,-10,K_1,unit\n";
  const std::string second = "60,-10,K_2,unit\n80,-10,K_2,unit\n80,-5,K_2,unit\n60,-5,K_2,unit\n60,-10,K_2,unit\n";
  const std::string other = "40,-10,J,unit\n50,-10,J,unit\n50,-5,J,unit\n40,-5,J,unit\n40,-10,J,unit\n";
  const std::string file = section(first + other + second);
  for (const std::string method : {"constant", "flexural", "shear"}) {
    const OrderedJson made = json({"restore", file, "--json", "--geometry", "--method", method});
    ASSERT_EQ(made["ledger"].size(), 4u);
    const OrderedJson& whole = made["ledger"][2];
    EXPECT_EQ(whole["name"], "K");
    EXPECT_EQ(whole["pieces"], 2);
    EXPECT_NEAR(whole["area_before"].get<double>(), 150.0, 1e-9);
    EXPECT_EQ(made["ledger"][3]["name"], "J");
    EXPECT_FALSE(made["ledger"][3].contains("pieces"));
    // The sum of the restored polygons, by the shoelace formula.
    double after = 0.0;
    for (const OrderedJson& thing : made["restored"]) {
      if (!thing["name"].get<std::string>().starts_with("K_")) continue;
      double area = 0.0;
      const OrderedJson& points = thing["points"];
      for (std::size_t i = 0; i < points.size(); ++i) {
        const OrderedJson& p = points[i];
        const OrderedJson& q = points[(i + 1) % points.size()];
        area += 0.5 * (p[0].get<double>() * q[1].get<double>() - q[0].get<double>() * p[1].get<double>());
      }
      after += std::abs(area);
    }
    EXPECT_NEAR(whole["area_after"].get<double>(), after, 1e-6 * after) << method;
    EXPECT_LE(whole["dilatation_min_percent"].get<double>(), whole["area_change_percent"].get<double>() + 1e-6);
    EXPECT_GE(whole["dilatation_max_percent"].get<double>(), whole["area_change_percent"].get<double>() - 1e-6);
  }
  const auto table = call({"restore", file});
  EXPECT_NE(table.out.find("K (2 pieces)"), std::string::npos) << table.out;
}

TEST_F(LedgerJson, ErrorBarsTellDrawsThatFailed) {
  const OrderedJson made = json({"restore", section(), "--json", "--draws", "10", "--pick-error", "0.01"});
  EXPECT_EQ(made["error_bars"]["failed"], 0);
}

TEST_F(LedgerJson, ADetachmentThatDoesNotLieUnderTheBedsIsRemarkedOn) {
  // Excess areas 0.5 * 100 * h grow with depth: the line through them meets zero above the upper bed.
  const auto folded = [](double upper, double lower) {
    return fmt::format("x,z,name\n0,0,up\n50,{},up\n100,0,up\n0,-40,low\n50,{},low\n100,-40,low\n", upper,
                       lower - 40.0);
  };
  // level: h_d = (h1 A2 - h2 A1) / (A2 - A1) of two points.
  const auto detachment = [](double a, double b) { return (0.0 * b + 40.0 * a) / (b - a); };
  for (const auto& [upper, lower] : {std::pair(10.0, 20.0), {5.0, 30.0}}) {
    EXPECT_GT(detachment(upper, lower), 0.0);
    const auto said = call({"balance", put("d.csv", folded(upper, lower))});
    EXPECT_NE(said.err.find("comes out above every regional, the highest that of 'up'"), std::string::npos) << said.err;
  }
  const auto between = call({"balance", put("d.csv", folded(-10.0, 10.0))});
  EXPECT_NE(between.err.find("comes out above the regional of 'low' (z = -40 m)"), std::string::npos) << between.err;
  EXPECT_NE(between.err.find("by itself 'up' gives a detachment above it"), std::string::npos) << between.err;
  const auto sound = call({"balance", put("d.csv", folded(20.0, 10.0))});
  EXPECT_EQ(sound.err.find("above"), std::string::npos) << sound.err;
}

TEST_F(LedgerJson, ANameThatIsNoHorizonIsToldForWhatItIs) {
  const std::string numbers = put("n.csv", "x,z,name\n0,0,1\n50,9,1\n100,0,1\n0,-20,2\n50,-11,2\n100,-20,2\n");
  const auto fault = call({"restore", numbers, "--kind", "1=fault", "--top", "1"});
  EXPECT_EQ(fault.code, 3);
  EXPECT_NE(fault.err.find("there is no horizon '1' to be the top: it is the name of a line of kind 'fault'"),
            std::string::npos)
      << fault.err;
  const auto square = [](const char* name, int z) {
    return fmt::format("0,{1},{0},unit\n90,{1},{0},unit\n90,{2},{0},unit\n0,{2},{0},unit\n0,{1},{0},unit\n", name, z,
                       z + 10);
  };
  const std::string units = put("u.csv", "x,z,name,kind\n" + square("U1", 0) + square("U2", -10) + square("U3", -20));
  const auto unit = call({"restore", units, "--horizons-from-units", "--top", "U1"});
  EXPECT_NE(unit.err.find("it is a unit whose top is no horizon; the horizons are U2, U3"), std::string::npos)
      << unit.err;
  const auto none = call({"restore", units, "--top", "U1"});
  EXPECT_NE(none.err.find("with --horizons-from-units"), std::string::npos) << none.err;
  const auto misspelt = call({"restore", section(), "--top", "tpo"});
  EXPECT_NE(misspelt.err.find("did you mean 'top'?"), std::string::npos) << misspelt.err;
}

TEST_F(LedgerJson, NamesThatRepeatAreToldOnce) {
  const std::string square = R"({"type":"Feature","properties":{"name":"R"},"geometry":)"
                             R"({"type":"Polygon","coordinates":[[[0,-9],[9,-9],[9,-5],[0,-9]]]}})";
  const std::string line =
      R"({"type":"Feature","properties":{"name":"R"},"geometry":{"type":"LineString","coordinates":[[0,0],[9,0]]}})";
  const std::string head = R"({"type":"FeatureCollection","features":[)";
  const std::string three = square + ',' + square + ',' + square;
  const auto told = call({"restore", put("r.geojson", head + line + ',' + three + "]}")});
  EXPECT_EQ(told.code, 0) << told.err;
  const std::string wanted =
      "3 polygons are called 'R': from the second on they are 'R (2)' and so on, pieces of one unit";
  EXPECT_NE(told.err.find(wanted), std::string::npos) << told.err;
  const auto once = call({"restore", put("r.geojson", head + line + ',' + square + "]}")});
  EXPECT_EQ(once.err.find("are called"), std::string::npos) << once.err;
}

TEST_F(LedgerJson, APolygonThatCrossesItselfWithEqualLobesIsToldSo) {
  const std::string bow = R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"bow"},)"
                          R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[10,10],[10,0],[0,10],[0,0]]]}}]})";
  const auto said = call({"restore", put("bow.geojson", bow)});
  EXPECT_EQ(said.code, 3);
  EXPECT_EQ(said.err.find("no area"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("bow"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("crosses or touches itself here; correct it (at 5, 5)"), std::string::npos) << said.err;
}

}  // namespace
}  // namespace recon::cli
