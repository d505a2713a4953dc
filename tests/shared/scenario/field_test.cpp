#include "shared/scenario/field.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/fake_program.h"

namespace dobra::scenario {
namespace {

using base::ErrorCode;

const std::vector<Field>& scale_fields() {
  static const std::vector<Field> fields = fields_of<fake::Scale>();
  return fields;
}

const Field& field_named(const std::string& key) {
  for (const Field& field : scale_fields()) {
    if (field.key == key) return field;
  }
  throw std::logic_error("no field " + key);
}

std::string field_complaint(const std::string& key, Value value) {
  Table table;
  base::Place place;
  place.file = "f.toml";
  place.line = 7;
  place.column = 3;
  table.set(key, std::move(value), place);
  const auto judged = check(table, scale_fields(), "step 2 (scale)");
  return judged ? "" : base::to_string(judged.error());
}

TEST(Field, DescribeListsKindsDefaultsChoicesAndNestedFields) {
  EXPECT_EQ(scale_fields().size(), 8U);
  EXPECT_EQ(field_named("times").kind, Kind::Integer);
  EXPECT_EQ(field_named("turn").kind, Kind::Degrees);
  EXPECT_EQ(std::get<double>(*field_named("turn").default_value), 30.0);
  EXPECT_FALSE(field_named("limit").default_value);
  EXPECT_EQ(std::get<std::string>(*field_named("join").default_value), "mitre");
  EXPECT_EQ(field_named("join").choices.size(), 3U);
  const auto input = fields_of<fake::Input>();
  EXPECT_EQ(input.back().kind, Kind::Tables);
  EXPECT_EQ(input.back().fields.size(), 3U);
  EXPECT_EQ(input.back().fields[1].kind, Kind::File);
}

TEST(Field, AMisspeltKeyGetsASuggestionWithFileLineAndColumn) {
  EXPECT_EQ(field_complaint("facctor", 1.0),
            "f.toml:7:3: step 2 (scale): unknown key 'facctor'; did you mean 'factor'?");
  EXPECT_EQ(field_complaint("zzzzzzzz", 1.0),
            "f.toml:7:3: step 2 (scale): unknown key 'zzzzzzzz'; known keys: factor, times, limit, turn, join, "
            "reverse, pin, path");
}

TEST(Field, AWrongTypeSaysWhatIsWantedAndWhatWasFound) {
  const std::string start = "f.toml:7:3: step 2 (scale): ";
  EXPECT_EQ(field_complaint("factor", std::string("two")), start + "'factor' must be a number, found the text \"two\"");
  EXPECT_EQ(
      field_complaint("factor", std::string("3 m")),
      start + "'factor' must be a number, found the text \"3 m\": numbers stand without quotes and without units");
  EXPECT_EQ(field_complaint("times", 2.5), start + "'times' must be a whole number, found 2.5");
  EXPECT_EQ(field_complaint("reverse", std::int64_t{1}), start + "'reverse' must be true or false, found 1");
  EXPECT_EQ(field_complaint("pin", std::vector<double>{1, 2, 3}),
            start + "'pin' must be a point [x, y], found a list of 3 numbers");
  EXPECT_EQ(field_complaint("path", std::vector<double>{1, 2}),
            start + "'path' must be a list of points [[x, y], ...], found a list of 2 numbers");
  EXPECT_EQ(field_complaint("join", true), start + "'join' must be one of 'mitre', 'bisector', 'round', found true");
  EXPECT_EQ(field_complaint("join", std::string("miter")),
            start + "'join' must be one of 'mitre', 'bisector', 'round', found 'miter'; did you mean 'mitre'?");
}

TEST(Field, RangesAreStated) {
  const std::string start = "f.toml:7:3: step 2 (scale): ";
  EXPECT_EQ(field_complaint("factor", 0.0), start + "'factor' must be greater than 0 m, found 0.0 m");
  EXPECT_EQ(field_complaint("times", std::int64_t{0}), start + "'times' must be at least 1 and at most 1000, found 0");
  EXPECT_EQ(field_complaint("times", std::int64_t{1001}),
            start + "'times' must be at least 1 and at most 1000, found 1001");
  EXPECT_EQ(field_complaint("times", std::int64_t{3000000000}),
            start + "'times' must be between -2147483648 and 2147483647, found 3000000000");
  EXPECT_EQ(field_complaint("times", std::int64_t{1000}), "");
  EXPECT_EQ(field_complaint("turn", std::int64_t{-180}), "");
  EXPECT_NE(field_complaint("turn", -180.5), "");
}

TEST(Field, NotANumberAndInfinityAreRefusedWhereverTheyStand) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::string start = "f.toml:7:3: step 2 (scale): ";
  EXPECT_EQ(field_complaint("factor", nan), start + "'factor' must be a finite number, found nan");
  EXPECT_EQ(field_complaint("limit", -inf), start + "'limit' must be a finite number, found -inf");
  EXPECT_EQ(field_complaint("pin", std::vector<double>{nan, 2}),
            start + "'pin' must have finite coordinates, found [nan, 2.0]");
  EXPECT_EQ(field_complaint("path", std::vector<geom::Point>{{0, 0}, {1, inf}}),
            start + "point 2 of 'path' must have finite coordinates, found [1.0, inf]");
  Table input;
  input.set("numbers", std::vector<double>{1, 2, nan});
  const auto judged = check(input, fields_of<fake::Input>(), "input");
  ASSERT_FALSE(judged.ok());
  EXPECT_EQ(judged.error().message, "number 3 of 'numbers' must be a finite number, found nan");
}

TEST(Field, MissingKeysAndNestedTablesAreJudged) {
  Table nameless;
  nameless.own_place.file = "f.toml";
  nameless.own_place.line = 12;
  Table named;
  named.set("name", std::string("top"));
  Table input;
  input.set("horizon", std::vector<Table>{named, nameless});
  const auto judged = check(input, fields_of<fake::Input>(), "input");
  ASSERT_FALSE(judged.ok());
  EXPECT_EQ(judged.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(base::to_string(judged.error()),
            "f.toml:12: input, horizon 2: the key 'name' is missing; it must be a text in quotes");
}

TEST(Field, FromTableFillsTheStructAndKeepsDefaults) {
  Table table;
  table.set("factor", std::int64_t{3});
  table.set("turn", std::int64_t{90});
  table.set("pin", std::vector<double>{5.0, 6.0});
  table.set("path", std::vector<double>{});
  table.set("join", std::string("round"));
  table.set("limit", std::int64_t{7});
  ASSERT_TRUE(check(table, scale_fields(), "").ok());
  const auto params = from_table<fake::Scale>(table);
  EXPECT_EQ(params.factor, 3.0);
  EXPECT_NEAR(params.turn.degrees(), 90.0, 1e-12);
  EXPECT_EQ(params.pin, (geom::Point{5.0, 6.0}));
  EXPECT_TRUE(params.path.empty());
  EXPECT_EQ(params.join, fake::Join::Round);
  EXPECT_EQ(params.limit, 7.0);
  EXPECT_EQ(params.times, 1);
}

TEST(Field, AnEmptyListDoesForEveryKindOfList) {
  const Value empty = std::vector<double>{};
  EXPECT_TRUE(std::holds_alternative<Points>(*as_kind(empty, Kind::Points)));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::string>>(*as_kind(empty, Kind::Texts)));
  EXPECT_TRUE(std::holds_alternative<std::vector<Table>>(*as_kind(empty, Kind::Tables)));
  EXPECT_TRUE(std::holds_alternative<std::vector<double>>(*as_kind(Value(std::vector<std::string>{}), Kind::Numbers)));
  EXPECT_FALSE(as_kind(empty, Kind::Point));
  EXPECT_FALSE(as_kind(empty, Kind::Text));
  EXPECT_FALSE(as_kind(Value(std::string()), Kind::Texts));
}

TEST(Field, WhatTheUserTypesIsReadAndItsTextReadsBack) {
  EXPECT_EQ(std::get<double>(*parse_value(field_named("factor"), " 0.4 ")), 0.4);
  EXPECT_EQ(std::get<double>(*parse_value(field_named("factor"), "3")), 3.0);
  EXPECT_EQ(std::get<std::int64_t>(*parse_value(field_named("times"), "12")), 12);
  EXPECT_EQ(std::get<bool>(*parse_value(field_named("reverse"), "true")), true);
  EXPECT_EQ(std::get<std::string>(*parse_value(field_named("join"), "round")), "round");
  EXPECT_EQ(std::get<geom::Point>(*parse_value(field_named("pin"), "1, 2.5")), (geom::Point{1.0, 2.5}));
  EXPECT_EQ(std::get<geom::Point>(*parse_value(field_named("pin"), "[1, 2.5]")), (geom::Point{1.0, 2.5}));
  const Value path = *parse_value(field_named("path"), "[0, 0], [1, 2]");
  EXPECT_EQ(std::get<Points>(path).size(), 2U);
  EXPECT_EQ(value_text(*parse_value(field_named("path"), value_text(path))), value_text(path));
  EXPECT_EQ(std::get<Points>(*parse_value(field_named("path"), "[]")).size(), 0U);
}

TEST(Field, WhatTheUserTypesWronglyIsRefusedWithTheReason) {
  const auto message = [](const char* key, const std::string& text) {
    const auto value = parse_value(field_named(key), text);
    return value ? std::string("accepted") : value.error().message;
  };
  EXPECT_EQ(message("factor", "0,4"), "'factor' must be a number, found '0,4'");
  EXPECT_EQ(message("factor", "nan"), "'factor' must be a finite number, found nan");
  EXPECT_EQ(message("factor", "-1"), "'factor' must be greater than 0 m, found -1.0 m");
  EXPECT_EQ(message("times", "1.5"), "'times' must be a whole number, found '1.5'");
  EXPECT_EQ(message("pin", "1"), "'pin' must be a point [x, y], found '1'");
  EXPECT_EQ(message("pin", "1, 2]\nx = [3"), "'pin' must be a point [x, y], found '1, 2]\nx = [3'");
  EXPECT_EQ(message("join", "rund"),
            "'join' must be one of 'mitre', 'bisector', 'round', found 'rund'; did you mean 'round'?");
  EXPECT_EQ(message("join", "\xFF"), "the text given for 'join' is not UTF-8");
}

TEST(Field, SummariesNameKindRangeUnitAndDefault) {
  EXPECT_EQ(field_summary(field_named("factor")), "number > 0 [m], default 2.0");
  EXPECT_EQ(field_summary(field_named("times")), "whole number >= 1 and <= 1000, default 1");
  EXPECT_EQ(field_summary(field_named("join")), "one of 'mitre', 'bisector', 'round', default \"mitre\"");
  EXPECT_EQ(field_summary(fields_of<fake::Import>()[0]), "file name, required");
  Field file = fields_of<fake::Import>()[0];
  file.options.files = {{"Text", {".csv", ".txt"}}, {"Neutral file", {".nf"}}};
  EXPECT_EQ(field_summary(file), "file name: .csv .txt .nf, required");
  Field word{"format", Kind::Text, {.words = {"text", "dxf"}}, {}, Value(std::string()), {}};
  EXPECT_EQ(field_summary(word), "one of text, dxf, default \"\"");
}

}  // namespace
}  // namespace dobra::scenario
