// Numbers as users type them: none, infinite, negative, of no extent, greater than the model.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shared/scenario/units.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::core {
namespace {

using namespace dobra;
using scenario::Field;
using scenario::Kind;
using scenario::Table;
using scenario::Value;
using testing::AllOf;
using testing::HasSubstr;

/// The message about a field's value, which stands in the tables `keys` lead to; empty if there is none.
std::string message(const std::vector<Field>& fields, const std::vector<std::string>& keys, const std::string& key,
                    Value value) {
  Table table;
  table.set(key, std::move(value));
  for (auto outer = keys.rbegin(); outer != keys.rend(); ++outer) {
    Table row = std::move(table);
    table = Table();
    table.set(*outer, std::vector<Table>{std::move(row)});
  }
  const auto judged = scenario::check(table, fields, "");
  return judged ? "" : judged.error().message;
}

/// Every number that a description takes is judged; says how many they were.
int judge_all(const std::vector<Field>& all, const std::vector<Field>& fields, const std::vector<std::string>& keys) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  int count = 0;
  for (const Field& field : fields) {
    if (field.kind == Kind::Tables) {
      std::vector<std::string> inner = keys;
      inner.push_back(field.key);
      count += judge_all(all, field.fields, inner);
      continue;
    }
    const std::string named = "'" + field.key + "'";
    const bool number = field.kind == Kind::Number || field.kind == Kind::Degrees;
    if (!number && field.kind != Kind::Integer && field.kind != Kind::Point && field.kind != Kind::Numbers) continue;
    ++count;
    for (const double bad : {std::nan(""), inf, -inf}) {
      const Value value = number                      ? Value(bad)
                          : field.kind == Kind::Point ? Value(geom::Point{0, bad})
                                                      : Value(std::vector<double>{1.0, bad});
      if (field.kind == Kind::Integer) continue;
      EXPECT_THAT(message(all, keys, field.key, value), AllOf(HasSubstr(named), HasSubstr("finite"))) << field.key;
    }
    if (!number) continue;
    const std::string& units = field.options.unit;  // "Pa, N if kind = force": the first where no kind is said
    const std::string unit = units.empty() ? "" : " " + units.substr(0, units.find(", "));
    const auto refused = [&](double value, double limit, const char* relation) {
      const std::string text = message(all, keys, field.key, value);
      EXPECT_THAT(text,
                  AllOf(HasSubstr(named), HasSubstr(fmt::format("{} {}", relation, limit)), testing::EndsWith(unit)))
          << field.key;
      EXPECT_THAT(text, HasSubstr(unit + ", found ")) << "the range has the unit of the value";
    };
    if (field.options.above) refused(*field.options.above, *field.options.above, "greater than");
    if (field.options.at_least) refused(*field.options.at_least - 1.0, *field.options.at_least, "at least");
    if (field.options.at_most) refused(*field.options.at_most + 1.0, *field.options.at_most, "at most");
    EXPECT_THAT(scenario::parse_value(field, "1e400").error().message,
                AllOf(HasSubstr(named), HasSubstr("beyond 1.8e308")));
    EXPECT_THAT(scenario::parse_value(field, "12 mm").error().message, AllOf(HasSubstr(named), HasSubstr("must be a")));
  }
  return count;
}

TEST(Numbers, EveryParameterOfEveryOperationRefusesThemWithNameValueRangeAndUnit) {
  for (const char* system : {"SI", "mm, N, MPa"}) {
    const scenario::UnitSystem units = scenario::UnitSystem::make(system).value();
    const auto in_units = [&](const std::vector<Field>& fields) {
      const auto all = scenario::fields_in(fields, units);
      return judge_all(all, all, {});
    };
    int count = in_units(program().input_fields);
    for (const scenario::Operation& operation : program().operations) count += in_units(operation.fields);
    EXPECT_GT(count, 80);
  }
}

TEST(Numbers, InAScenarioTheyAreToldInItsUnits) {
  const std::string mm = "unit_system = \"mm, N, MPa\"\n";
  const std::string plate = mm + "[input]\nspecimen = \"plate_with_hole\"\nwidth = 100\n";
  EXPECT_THAT(test::trouble(plate + "radius = -2\n"),
              AllOf(HasSubstr("test.toml:7"), HasSubstr("'radius' must be greater than 0 mm, found -2 mm")));
  EXPECT_THAT(test::trouble(plate + "radius = 0.0\n"), HasSubstr("'radius' must be greater than 0 mm, found 0.0 mm"));
  EXPECT_THAT(test::trouble(plate + "radius = 60\n"),
              HasSubstr("`radius` is 60 mm and must lie above 0 mm and below 50 mm"));
  EXPECT_THAT(test::trouble(plate + "radius = inf\n"), HasSubstr("'radius' must be a finite number, found inf"));
  EXPECT_THAT(test::trouble(plate + "[[step]]\noperation = \"mesh\"\nsize = -3\n"),
              HasSubstr("'size' must be at least 0 mm, found -3 mm"));
  EXPECT_THAT(test::trouble(plate + "[[step]]\noperation = \"mesh\"\nturn = 100\n"),
              HasSubstr("at most 90 deg, found 100 deg"));
  EXPECT_THAT(test::trouble(plate + "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = -1\n"),
              HasSubstr("'young' must be greater than 0 MPa, found -1 MPa"));
}

TEST(Numbers, SizesOfSpecimensThatDoNotFitAreToldWithTheirLimit) {
  struct Case {
    std::string input, wanted;
  };
  for (const auto& [input, wanted] : std::vector<Case>{
           {"plate_with_hole\"\nradius = 5.0\n", "`radius` is 5 m and must lie above 0 m and below 5 m"},
           {"quarter_plate\"\nradius = 9.0\n", "`radius` is 9 m and must lie above 0 m and below 5 m"},
           {"single_edge_notch\"\ncrack_length = 0\n", "`crack_length` is 0 m and must lie above 0 m and below 1 m"},
           {"double_edge_notch\"\ncrack_length = 0.5\n",
            "`crack_length` is 0.5 m and must lie above 0 m and below 0.5 m"},
           {"centre_crack\"\ncrack_length = 12\nangle = 60\n",
            "`crack_length` is 12 m and must lie above 0 m and below 11.547 m"},
           {"compact_tension\"\ncrack_length = 1e300\n",
            "`crack_length` is 1e+300 m and must lie above 0 m and below 50 m"},
           {"three_point_bend\"\ncrack_length = 1\n", "below 1 m"},
           {"three_point_bend\"\nheight = 1\nwidth = 3\n", "`height` is 1 m and must lie above 0 m and below 0.75 m"},
           {"pmma_beam\"\nposition = -9.5\n", "`position` is 9.5 m"},
           {"double_cantilever\"\ncrack_length = 100\n", "below 100 m"},
           {"brazilian_disc\"\ncrack_length = 1\n", "`crack_length` is 1 m and must lie above 0 m and below 1 m"},
           {"single_edge_notch\"\nradius = 0.1\n",
            "`radius` is a size that nothing has: 'single_edge_notch' takes width, height, crack_length; remove it"},
           {"none\"\nradius = 0.1\n", "`radius` is a size that nothing has: no `specimen` is named"}}) {
    EXPECT_THAT(test::trouble("[input]\nspecimen = \"" + input), HasSubstr(wanted)) << input;
  }
}

TEST(Numbers, OptionsOfAFileThatIsNotThereAreRefused) {
  for (const char* option :
       {"exaggeration = 2.0", "reference = 1.0", "plane_tolerance = 0.1", "closed = \"yes\"", "columns = \"1,2\""})
    EXPECT_THAT(test::trouble("[input]\nspecimen = \"cook\"\n" + std::string(option) + "\n"),
                HasSubstr("there is no file"))
        << option;
}

TEST(Numbers, AModelMuchLongerThanASideSaysWhichLengthIsLost) {
  EXPECT_THAT(test::trouble("[input]\nspecimen = \"plate_with_hole\"\nwidth = 1e9\nheight = 3.0\nradius = 1.0\n"),
              AllOf(HasSubstr("curve 'right' is only 3 m long"), HasSubstr("within 100 m (join_tolerance)")));
}

}  // namespace
}  // namespace quebra::core
