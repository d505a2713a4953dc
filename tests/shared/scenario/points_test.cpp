#include "shared/scenario/points.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "shared/scenario/document.h"
#include "shared/scenario/toml_text.h"

#if defined(__SANITIZE_ADDRESS__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace dobra::scenario {
namespace {

using List = std::vector<geom::Point>;

std::size_t bytes_in_use() {
#if defined(__SANITIZE_ADDRESS__)
  return __sanitizer_get_current_allocated_bytes();
#else
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

List line_of(std::size_t count) {
  List list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back({static_cast<double>(i), std::sin(0.01 * static_cast<double>(i))});
  return list;
}

void expect_same(const Points& points, const List& list) {
  ASSERT_EQ(points.size(), list.size());
  ASSERT_EQ(points.list(), list);
  std::size_t i = 0;
  for (const geom::Point& p : points) ASSERT_EQ(p, list[i++]);
  for (i = 0; i < list.size(); i += 1 + list.size() / 50) ASSERT_EQ(points[i], list[i]) << i;
  if (list.empty()) return;
  ASSERT_EQ(points.front(), list.front());
  ASSERT_EQ(points.back(), list.back());
}

TEST(Points, RandomEditsGiveWhatAPlainListGives) {
  std::mt19937 random(21);
  const auto below = [&](std::size_t limit) { return static_cast<std::ptrdiff_t>(random() % limit); };
  for (const std::size_t start : {0u, 1u, 511u, 512u, 513u, 5000u}) {
    List list = line_of(start);
    Points points(list);
    std::vector<std::pair<Points, List>> before;
    for (int k = 0; k < 300; ++k) {
      before.emplace_back(points, list);
      const auto what = random() % 5;
      const geom::Point p{static_cast<double>(k), -1.0};
      if (what == 0 || list.empty()) {
        list.insert(list.begin() + below(list.size() + 1), p);
      } else if (what == 1) {
        list.erase(list.begin() + below(list.size()));
      } else if (what == 2) {
        const auto first = below(list.size());
        list.erase(list.begin() + first, list.begin() + first + below(list.size() - static_cast<std::size_t>(first)));
      } else if (what == 3) {
        list.insert(list.begin() + below(list.size() + 1), 40, p);
      } else {
        list[static_cast<std::size_t>(below(list.size()))] = p;
      }
      points = Points(list, points);
      ASSERT_NO_FATAL_FAILURE(expect_same(points, list)) << "edit " << k << " of " << start;
      ASSERT_TRUE(points == Points(list));
    }
    // What was copied before is what it was.
    for (const auto& [was, its_list] : before) ASSERT_EQ(was.list(), its_list);
  }
}

TEST(Points, AreEqualWhereTheirTextIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> numbers{0.0, -0.0, 1.0, 1.0 + 1e-16, 1.0 + 3e-16, nan, -nan, 1e300, INFINITY, -INFINITY};
  for (const double a : numbers) {
    for (const double b : numbers) {
      const Points one{{1.0, 2.0}, {a, 0.5}};
      const Points other{{1.0, 2.0}, {b, 0.5}};
      EXPECT_EQ(one == other, value_toml(one) == value_toml(other)) << a << ' ' << b;
    }
  }
  EXPECT_FALSE((Points{{1.0, 2.0}}) == (Points{{1.0, 2.0}, {3.0, 4.0}}));
  EXPECT_TRUE(Points() == Points(List{}));
}

/// The document with vertex `i` of its only horizon moved, by way of the tables, as an edit on the canvas does it.
Document with_vertex_moved(Document document, std::size_t i, double by) {
  auto tables = std::get<std::vector<Table>>(*document.input.find("horizon"));
  List list = std::get<Points>(*tables[3].find("points")).list();
  list[i].y += by;
  tables[3].set("points", list);
  document.input.set("horizon", std::move(tables));
  return document;
}

TEST(Points, AThousandEditsOfAVertexAmongTwoHundredThousandTakeLessThanAHundredMegabytes) {
  constexpr std::size_t count = 200000;
  auto first = std::make_shared<Document>();
  std::vector<Table> tables(8);
  for (Table& table : tables) table.set("name", std::string("a bed with a rather long name"));
  tables[3].set("points", line_of(count));
  first->input.set("horizon", std::move(tables));
  std::vector<std::shared_ptr<const Document>> history{first};
  std::mt19937 random(5);
  const std::size_t before = bytes_in_use();
  ASSERT_GT(before, count * sizeof(geom::Point));
  for (int k = 0; k < 1000; ++k)
    history.push_back(std::make_shared<const Document>(with_vertex_moved(*history.back(), random() % count, 0.5)));
  const std::size_t added = bytes_in_use() - before;
  RecordProperty("bytes_an_edit", std::to_string(added / 1000));
  EXPECT_LT(added, 100'000'000u);
  EXPECT_GT(added, 1000 * sizeof(geom::Point));  // they are all there
  // The oldest is still what it was, and the newest is all of the edits.
  EXPECT_EQ(
      std::get<Points>(*std::get<std::vector<Table>>(*history[0]->input.find("horizon"))[3].find("points")).list(),
      line_of(count));
  double moved = 0.0;
  const Points last =
      std::get<Points>(*std::get<std::vector<Table>>(*history[1000]->input.find("horizon"))[3].find("points"));
  const List start = line_of(count);
  for (std::size_t i = 0; i < count; ++i) moved += last[i].y - start[i].y;
  EXPECT_NEAR(moved, 500.0, 1e-6);
}

TEST(Points, CopiesOfATableShareItAndChangeAlone) {
  Table table;
  table.set("name", std::string("a"));
  table.set("points", line_of(3000));
  Table copy = table;
  EXPECT_EQ(&copy.entries(), &table.entries());
  copy.set("name", std::string("b"));
  EXPECT_EQ(std::get<std::string>(*table.find("name")), "a");
  EXPECT_EQ(std::get<std::string>(*copy.find("name")), "b");
  EXPECT_FALSE(table == copy);
  Table gone = table;
  gone.erase("points");
  EXPECT_NE(table.find("points"), nullptr);
  EXPECT_EQ(gone.find("points"), nullptr);
  Table said = table;
  said.set_comment("name", "a comment");
  EXPECT_TRUE(table.entries()[0].comment.empty());
  EXPECT_TRUE(said == table);  // comments do not count
  // The place of a key stays when its value is set, also where the entries become a copy.
  table.set("points", List{{1, 2}, {3, 4}}, {"file.toml", 7, 3, {}, {}, {}});
  Table edited = table;
  edited.set("points", List{{1, 2}, {3, 5}});
  EXPECT_EQ(edited.place("points").line, 7u);
}

}  // namespace
}  // namespace dobra::scenario
