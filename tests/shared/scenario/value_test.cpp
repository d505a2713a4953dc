#include "shared/scenario/value.h"

#include <gtest/gtest.h>

namespace dobra::scenario {
namespace {

base::Place at_line(std::size_t line) {
  base::Place place;
  place.line = line;
  return place;
}

TEST(Value, ATableKeepsTheOrderAndThePlaceOfItsKeys) {
  Table table;
  table.own_place = at_line(1);
  table.set("b", 1.5, at_line(2));
  table.set("a", std::string("x"), at_line(3));
  table.set("b", 2.5);
  ASSERT_EQ(table.entries().size(), 2U);
  EXPECT_EQ(table.entries()[0].key, "b");
  EXPECT_EQ(std::get<double>(*table.find("b")), 2.5);
  EXPECT_EQ(table.place("b").line, 2U);
  EXPECT_EQ(table.place("missing").line, 1U);
  EXPECT_EQ(table.find("missing"), nullptr);
  table.erase("b");
  EXPECT_EQ(table.find("b"), nullptr);
  EXPECT_EQ(table.entries().size(), 1U);
}

TEST(Value, EqualityIgnoresPlacesAndCommentsAndComparesWhatIsWritten) {
  Table a;
  a.set("p", geom::Point{1.0, 2.0}, at_line(2));
  a.set("empty", std::vector<geom::Point>{});
  Table b;
  b.set("p", std::vector<double>{1.0, 2.0}, at_line(9));
  b.set_comment("p", "a comment");
  b.set("empty", std::vector<double>{});
  EXPECT_EQ(a, b);
  b.set("p", std::vector<double>{1.0, 3.0});
  EXPECT_FALSE(a == b);
}

TEST(Value, TheOrderOfPlainKeysCountsButNestedTablesAreAlwaysLast) {
  Table row;
  row.set("name", std::string("top"));
  Table a;
  a.set("x", true);
  a.set("row", std::vector<Table>{row});
  a.set("y", false);
  Table b;
  b.set("x", true);
  b.set("y", false);
  b.set("row", std::vector<Table>{row});
  Table c;
  c.set("y", false);
  c.set("x", true);
  c.set("row", std::vector<Table>{row});
  EXPECT_EQ(a, b);
  EXPECT_FALSE(b == c);
}

}  // namespace
}  // namespace dobra::scenario
