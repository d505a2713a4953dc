// Options made from descriptions: what is typed becomes the table that a scenario would have.

#include "shared/cli/parameter_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <filesystem>

namespace dobra::cli {
namespace {

using testing::HasSubstr;

enum class Way { There, Back };

struct Params {
  int draws = 10;
  double pick_error = 0.5;
  base::Angle angle;
  Way way = Way::There;
  std::string base;
  std::string file;
  std::optional<geom::Point> target_pin;
  std::vector<double> thickness;
  std::vector<std::string> kind;
  bool keep = false;
  template <class D>
  static void describe(D& d) {
    d.field("draws", &Params::draws, {.title = "Draws", .help = "How many.", .at_least = 1});
    d.field("pick_error", &Params::pick_error, {.title = "Error of picks", .unit = "m", .at_least = 0.0});
    d.field("angle", &Params::angle, {.title = "Angle"});
    d.choice("way", &Params::way, {"there", "back"}, {.title = "Way"});
    d.field("base", &Params::base, {.title = "Base"});
    d.file("file", &Params::file, {.title = "File"});
    d.field("target_pin", &Params::target_pin, {.title = "Pin"});
    d.field("thickness", &Params::thickness, {.title = "Thickness"});
    d.field("kind", &Params::kind, {.title = "Kinds"});
    d.field("keep", &Params::keep, {.title = "Keep"});
  }
};

struct Typed {
  scenario::Table table;
  std::string error;
  base::ErrorCode code = base::ErrorCode::Cancelled;
  std::string help;
  bool any = false;
};

Typed typed(std::vector<std::string> words, const std::vector<OptionOf>& keys = {}) {
  CLI::App app;
  ParameterOptions options;
  options.add(app, scenario::fields_of<Params>(), keys);
  Typed result;
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
  } catch (const CLI::Error& error) {
    result.error = error.what();
    return result;
  }
  const auto set = options.set(scenario::fields_of<Params>(), result.table);
  if (!set) {
    result.code = set.error().code;
    result.error = set.error().message;
  }
  result.help = app.help();
  result.any = options.any();
  return result;
}

TEST(ParameterOptions, WhatIsTypedBecomesTheParametersOfTheStep) {
  const Typed made =
      typed({"--draws",  "3",        "--pick-error", "1e-3",   "--angle", "-30",         "--way", "back",
             "--base",   "a, \"b\"", "--target-pin", "-1",     "2.5",     "--thickness", "3,4",   "--kind",
             "F*=fault", "--kind",   "a b",          "--keep", "--file",  "x.csv"});
  EXPECT_EQ(made.error, "");
  EXPECT_TRUE(made.any);
  const auto params = scenario::from_table<Params>(made.table);
  EXPECT_EQ(params.draws, 3);
  EXPECT_EQ(params.pick_error, 1e-3);
  EXPECT_DOUBLE_EQ(params.angle.degrees(), -30.0);
  EXPECT_EQ(params.way, Way::Back);
  EXPECT_EQ(params.base, "a, \"b\"");
  EXPECT_EQ(params.target_pin, (geom::Point{-1.0, 2.5}));
  EXPECT_EQ(params.thickness, (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(params.kind, (std::vector<std::string>{"F*=fault", "a b"}));
  EXPECT_TRUE(params.keep);
  EXPECT_EQ(params.file, (std::filesystem::current_path() / "x.csv").string());
}

TEST(ParameterOptions, APointMayBeOneWord) {
  EXPECT_EQ(scenario::from_table<Params>(typed({"--target-pin", "3,-4"}).table).target_pin, (geom::Point{3.0, -4.0}));
}

TEST(ParameterOptions, WhatIsNotTypedIsNotInTheTable) {
  const Typed made = typed({});
  EXPECT_TRUE(made.table.entries().empty());
  EXPECT_FALSE(made.any);
}

TEST(ParameterOptions, BadValuesNameTheOptionAndTheRange) {
  EXPECT_THAT(typed({"--draws", "0"}).error, testing::AllOf(HasSubstr("--draws"), HasSubstr("at least 1")));
  EXPECT_THAT(typed({"--draws", "1.5"}).error, HasSubstr("--draws"));
  EXPECT_THAT(typed({"--pick-error", "-1"}).error, testing::AllOf(HasSubstr("--pick-error"), HasSubstr("m")));
  EXPECT_THAT(typed({"--pick-error", "nan"}).error, HasSubstr("--pick-error"));
  EXPECT_THAT(typed({"--way", "bak"}).error, testing::AllOf(HasSubstr("--way"), HasSubstr("back")));
  EXPECT_THAT(typed({"--target-pin", "1"}).error, HasSubstr("--target-pin"));
  EXPECT_THAT(typed({"--thickness", "1,x"}).error, HasSubstr("--thickness"));
}

TEST(ParameterOptions, WhatIsNoValueIsWrongUsageAndANumberOutOfRangeABadOne) {
  for (const char* const bad : {"x", "1.5", ""})
    EXPECT_EQ(typed({"--draws", bad}).code, base::ErrorCode::BadUsage) << bad;
  EXPECT_EQ(typed({"--way", "bak"}).code, base::ErrorCode::BadUsage);
  EXPECT_EQ(typed({"--draws", "0"}).code, base::ErrorCode::BadValue);
  EXPECT_EQ(typed({"--pick-error", "-1"}).code, base::ErrorCode::BadValue);
}

TEST(ParameterOptions, HelpTellsWhatTheDescriptionTellsOfTheChosenFieldsOnly) {
  const std::string help = typed({}, {"draws", "way"}).help;
  EXPECT_THAT(help, HasSubstr("--draws"));
  EXPECT_THAT(help, HasSubstr("How many"));
  EXPECT_THAT(help, HasSubstr("default 10"));
  EXPECT_THAT(help, HasSubstr("there"));
  EXPECT_EQ(help.find("--angle"), std::string::npos);
}

}  // namespace
}  // namespace dobra::cli
