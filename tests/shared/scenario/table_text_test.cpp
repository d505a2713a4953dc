#include "shared/scenario/table_text.h"

#include <gtest/gtest.h>

namespace dobra::scenario {
namespace {

TEST(TableText, NumbersReadBackAndTextsAreQuotedWhereNeeded) {
  const DataTable table{
      "t", {"name", "length [m]"}, {{std::string("a, \"b\""), 1.0 / 3.0}, {std::string("plain"), 2.0}}};
  EXPECT_EQ(csv_text(table), "name,length [m]\n\"a, \"\"b\"\"\",0.3333333333333333\nplain,2.0\n");
}

}  // namespace
}  // namespace dobra::scenario
