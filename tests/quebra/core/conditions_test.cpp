// What the forms of QUEBRA say of fields that have no effect, against what its input and operations refuse.

#include <gtest/gtest.h>

#include "quebra/core/input.h"
#include "quebra/core/operations.h"
#include "quebra/sketch/specimen.h"
#include "shared/scenario/condition.h"

namespace quebra::core {
namespace {

namespace scenario = dobra::scenario;
using scenario::Field;
using scenario::Table;

TEST(Conditions, OfQuebraNameFieldsAndChoicesThatThereAre) {
  EXPECT_EQ(scenario::condition_faults(program().input_fields), std::vector<std::string>{});
  for (const scenario::Operation& operation : program().operations)
    EXPECT_EQ(scenario::condition_faults(operation.fields), std::vector<std::string>{}) << operation.name;
}

TEST(Conditions, SpecimensRefuseTheSizesThatTheFormLeavesOut) {
  const std::vector<Field> fields = scenario::fields_of<InputParams>();
  const std::vector<std::string> specimens = sketch::specimen_names();
  std::size_t taken = 0;
  for (std::size_t s = 0; s < specimens.size(); ++s) {
    for (const Field& field : fields) {
      if (!field.options.when.starts_with("specimen")) continue;
      Table table;
      table.set("specimen", specimens[s]);
      table.set(field.key, 1.0);
      const InputParams input = scenario::from_table<InputParams>(table);
      sketch::SpecimenParams sizes{.kind = static_cast<sketch::SpecimenKind>(s),
                                   .width = input.width,
                                   .height = input.height,
                                   .radius = input.radius,
                                   .crack = input.crack,
                                   .position = input.position,
                                   .angle = input.angle};
      const bool effect = !scenario::unmet(field, table, fields);
      EXPECT_EQ(sketch::check_sizes(sizes).ok(), effect) << specimens[s] << ", " << field.key;
      taken += effect ? 1 : 0;
    }
  }
  EXPECT_EQ(taken, 31U);  // counted in docs/user/specimens.md
}

}  // namespace
}  // namespace quebra::core
