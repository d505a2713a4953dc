// What the forms of RECON say of fields that have no effect, against what its operations refuse.

#include <gtest/gtest.h>

#include <set>

#include "recon/core/operations.h"
#include "recon/moving/move_params.h"
#include "shared/scenario/condition.h"
#include "shared/scenario/runner.h"

namespace recon::core {
namespace {

namespace scenario = dobra::scenario;
using scenario::Field;
using scenario::Table;
using scenario::Value;

TEST(Conditions, OfReconNameFieldsAndChoicesThatThereAre) {
  EXPECT_EQ(scenario::condition_faults(program().input_fields), std::vector<std::string>{});
  std::size_t seen = 0;
  for (const scenario::Operation& operation : program().operations) {
    EXPECT_EQ(scenario::condition_faults(operation.fields), std::vector<std::string>{}) << operation.name;
    for (const Field& field : operation.fields) seen += field.options.when.empty() ? 0 : 1;
  }
  EXPECT_GT(seen, 45U);
}

/// A value that is not the field's default.
Value other_than_default(const Field& field) {
  switch (field.kind) {
    case scenario::Kind::Point:
      return dobra::geom::Point{1.0, 2.0};
    case scenario::Kind::Texts:
      return std::vector<std::string>{"a"};
    case scenario::Kind::Text:
      return std::string("a");
    default:
      return 17.0;
  }
}

TEST(Conditions, TheMovesRefuseWhatTheFormLeavesOut) {
  const std::vector<Field> fields = scenario::fields_of<moving::MoveParams>();
  const std::vector<std::string>& methods = fields[1].choices;
  ASSERT_EQ(methods.size(), 7U);
  std::size_t refused = 0;
  std::size_t taken = 0;
  for (const std::string& method : methods) {
    for (const Field& field : fields) {
      if (field.options.when.empty()) continue;
      Table table;
      table.set("fault", std::string("f"));
      table.set("slip", 3.0);
      table.set("method", method);
      if (method == "trishear") table.set("apical", 60.0);
      if (field.key == "pivot" && method == "rigid") table.set("angle", 10.0);
      if (field.key == "angle" && method == "rigid") table.set("pivot", dobra::geom::Point{0.0, 0.0});
      table.set(field.key, other_than_default(field));
      const auto judged = moving::check_params(scenario::from_table<moving::MoveParams>(table));
      const bool effect = !scenario::unmet(field, table, fields);
      EXPECT_EQ(judged.ok(), effect) << method << ", " << field.key << ": "
                                     << (judged ? "accepted" : judged.error().message);
      (effect ? taken : refused) += 1;
    }
  }
  EXPECT_GT(refused, 40U);
  EXPECT_GT(taken, 14U);
}

TEST(Conditions, WhatARunTellsHasItsStep) {
  const auto document = scenario::parse_document(
      "dobra = 1\nprogram = \"recon\"\n[input]\nreference = 5.0\n"
      "[[input.horizon]]\nname = \"a\"\npoints = [[0.0, 0.0], [1.0, 0.0]]\nweights = [1.0, 2.0]\n"
      "[[step]]\noperation = \"restore\"\nmethod = \"constant\"\nangle = 5.0\n",
      "test.toml");
  ASSERT_TRUE(document);
  EXPECT_EQ(scenario::without_effect(*document, program()),
            (std::vector<std::string>{"input: 'reference' has no effect with y_axis = up",
                                      "input: horizon 1: 'weights' has no effect with curve = line",
                                      "step 1 (restore): 'angle' has no effect with method = constant"}));
}

}  // namespace
}  // namespace recon::core
