#include "shared/scenario/condition.h"

#include <gtest/gtest.h>

namespace dobra::scenario {
namespace {

enum class Method { Constant, Shear, Flexural };

struct Work {
  Method method = Method::Constant;
  bool jigsaw = false;
  double angle = 0.0;
  std::string file;
  std::string feature;
  std::vector<std::string> block;
  double top = 0.0;
  double depth = 0.0;
  double deeper = 0.0;
  template <class D>
  static void describe(D& d) {
    d.choice("method", &Work::method, {"constant", "shear", "flexural"}, {.title = "Method"});
    d.field("jigsaw", &Work::jigsaw, {.title = "Jigsaw"});
    d.field("angle", &Work::angle, {.title = "Angle", .when = "method in shear, flexural"});
    d.field("file", &Work::file, {.title = "File"});
    d.field("feature", &Work::feature, {.title = "Feature", .when = "file is set"});
    d.field("block", &Work::block, {.title = "Blocks", .when = "jigsaw = false"});
    d.field("top", &Work::top, {.title = "Top", .when = "jigsaw = true and method != shear or block is set"});
    d.field("depth", &Work::depth, {.title = "Depth", .when = "method not in constant, shear"});
    d.field("deeper", &Work::deeper, {.title = "Deeper", .when = "feature is set"});
  }
};

bool matters(const std::string& key, const Table& table, const std::vector<Field>& fields = fields_of<Work>()) {
  for (const Field& field : fields) {
    if (field.key == key) return !unmet(field, table, fields).has_value();
  }
  throw std::logic_error("no field " + key);
}

Field bare(const std::string& key, const std::string& when) {
  Field field{key, Kind::Number, {}, {}, std::nullopt, {}};
  field.options.when = when;
  return field;
}

TEST(Condition, WhatCannotBeReadOrNamesNothingIsTold) {
  std::vector<Field> fields = fields_of<Work>();
  EXPECT_EQ(condition_faults(fields), std::vector<std::string>{});
  const auto faults_with = [&](const std::string& when) {
    std::vector<Field> more = fields;
    more.push_back(bare("x", when));
    return condition_faults(more);
  };
  using Faults = std::vector<std::string>;
  EXPECT_EQ(faults_with("methd = shear"), Faults{"'x': there is no field 'methd'"});
  EXPECT_EQ(faults_with("method = sheer"), Faults{"'x': 'sheer' is no choice of 'method'"});
  EXPECT_EQ(faults_with("method in shear, sheer"), Faults{"'x': 'sheer' is no choice of 'method'"});
  EXPECT_EQ(faults_with("jigsaw = yes"), Faults{"'x': 'yes' is no choice of 'jigsaw'"});
  EXPECT_EQ(faults_with("x = shear"), Faults{"'x': it hangs on itself"});
  EXPECT_EQ(faults_with("method"), Faults{"'x': it says nothing of 'method'"});
  EXPECT_EQ(faults_with("what is this"), Faults{"'x': there is no field 'what is this'"});
  EXPECT_EQ(faults_with("angle = 3"), Faults{"'x': '3' is no choice of 'angle'"});
  EXPECT_EQ(faults_with("method = shear and file is sett").size(), 1U);
  EXPECT_EQ(faults_with("method = shear or nothing = 1").size(), 1U);
  Field inside{"rows", Kind::Tables, {}, {}, std::nullopt, {bare("a", "b = c")}};
  EXPECT_EQ(condition_faults({inside}), Faults{"rows, 'a': there is no field 'b'"});
  Field unit = bare("u", "");
  unit.options.unit = "Pa, N if kind = force";
  EXPECT_EQ(condition_faults({unit}), Faults{"'u': there is no field 'kind'"});
}

TEST(Condition, AFieldMattersForItsChoicesTheirDefaultsToo) {
  Table table;
  EXPECT_FALSE(matters("angle", table));
  EXPECT_FALSE(matters("depth", table));
  table.set("method", std::string("shear"));
  EXPECT_TRUE(matters("angle", table));
  EXPECT_FALSE(matters("depth", table));
  table.set("method", std::string("flexural"));
  EXPECT_TRUE(matters("angle", table));
  EXPECT_TRUE(matters("depth", table));
  EXPECT_TRUE(matters("method", Table{}));
}

TEST(Condition, SetMeansMoreThanAnEmptyText) {
  Table table;
  EXPECT_FALSE(matters("feature", table));
  table.set("file", std::string());
  EXPECT_FALSE(matters("feature", table));
  table.set("file", std::string("a.csv"));
  EXPECT_TRUE(matters("feature", table));
  table.set("block", std::vector<std::string>{});
  EXPECT_FALSE(matters("top", table));
  table.set("block", std::vector<std::string>{"b"});
  EXPECT_TRUE(matters("top", table));
}

TEST(Condition, AndBindsMoreThanOr) {
  Table table;
  table.set("jigsaw", true);
  EXPECT_TRUE(matters("top", table));
  table.set("method", std::string("shear"));
  EXPECT_FALSE(matters("top", table));
  table.set("jigsaw", false);
  table.set("block", std::vector<std::string>{"b"});
  EXPECT_TRUE(matters("top", table));
}

TEST(Condition, WhatDoesNotMatterItselfMeetsNothing) {
  Table table;
  table.set("feature", std::string("f"));
  EXPECT_FALSE(matters("deeper", table));
  table.set("file", std::string("a.csv"));
  EXPECT_TRUE(matters("deeper", table));
  const std::vector<Field> circle{bare("a", "b is set"), bare("b", "a is set")};
  Table both;
  both.set("a", 1.0);
  both.set("b", 1.0);
  EXPECT_FALSE(matters("a", both, circle));
}

TEST(Condition, WhatIsSetInVainIsNamedWithWhatItMissesInRowsToo) {
  Table table;
  table.set("angle", 3.0);
  table.set("feature", std::string("f"));
  table.set("top", 1.0);
  EXPECT_EQ(
      without_effect(table, fields_of<Work>()),
      (std::vector<std::string>{"'angle' has no effect with method = constant", "'feature' has no effect without file",
                                "'top' has no effect with jigsaw = false"}));
  const Field rows{"work", Kind::Tables, {}, {}, std::nullopt, fields_of<Work>()};
  Table outer;
  Table second;
  second.set("angle", 3.0);
  outer.set("work", std::vector<Table>{Table{}, second});
  EXPECT_EQ(without_effect(outer, {rows}),
            (std::vector<std::string>{"work 2: 'angle' has no effect with method = constant"}));
}

TEST(Condition, HelpStatesIt) {
  EXPECT_EQ(field_summary(fields_of<Work>()[2]), "number, default 0.0; only if method in shear, flexural");
}

}  // namespace
}  // namespace dobra::scenario
