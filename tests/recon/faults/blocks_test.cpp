#include "recon/faults/blocks.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "tests/recon/faults/sections.h"

namespace recon::faults {
namespace {

using test::faulted;
using test::item;

const std::vector<test::NamedPoints> beds{{"A", {{0, 0}, {1000, 0}}}, {"B", {{0, -400}, {1000, -400}}}};

struct Made {
  std::vector<Fault> faults;
  Blocks blocks;
};

Made made_of(const section::Section& section) {
  Made made;
  made.faults = faults_of(section, {}).value();
  auto blocks = Blocks::make(section, made.faults, {});
  EXPECT_TRUE(blocks) << to_string(blocks.error());
  made.blocks = std::move(blocks).value();
  return made;
}

double total(const Blocks& blocks) {
  double area = 0.0;
  for (const Block& block : blocks.all()) area += block.area;
  return area;
}

using Names = std::vector<std::string>;

TEST(Blocks, TwoParallelFaultsPartThree) {
  // 45 degrees, through the whole height of 400 m: trapezia of mean widths 300, 400 and 300.
  const Made made = made_of(faulted(beds, {item("F", {{50, 50}, {600, -500}}), item("G", {{450, 50}, {1000, -500}})}));
  const auto& blocks = made.blocks.all();
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_NEAR(blocks[0].area, 400.0 * 300.0, 1e-6);
  EXPECT_NEAR(blocks[1].area, 400.0 * 400.0, 1e-6);
  EXPECT_NEAR(blocks[2].area, 400.0 * 300.0, 1e-6);
  EXPECT_NEAR(total(made.blocks), 400000.0, 1e-6);
  EXPECT_EQ(blocks[0].faults, Names({"F"}));
  EXPECT_EQ(blocks[1].faults, Names({"F", "G"}));
  EXPECT_EQ(blocks[1].name, "block 2");
  EXPECT_EQ(made.blocks.at({10, -10}), blocks[0].id);
  EXPECT_EQ(made.blocks.at({400, -200}), blocks[1].id);
  EXPECT_EQ(made.blocks.at({300, -200}), BlockId());  // on F
  EXPECT_EQ(made.blocks.at({10, 0}), blocks[0].id);   // on the top
  EXPECT_EQ(made.blocks.at({10, 30}), blocks[0].id);  // in the air over it
  const auto hanging = made.blocks.hanging_wall(made.faults[0]);
  ASSERT_TRUE(hanging);
  EXPECT_EQ(*hanging, std::vector<BlockId>({blocks[1].id, blocks[2].id}));
}

TEST(Blocks, ABedWithRockOnNeitherSideIsTold) {
  // Of the two beds of the left wall the hanging wall has one.
  const section::Section lone =
      faulted({{"A/1", {{0, 0}, {500, 0}}}, {"B/1", {{0, -200}, {500, -200}}}, {"B/2", {{500, -240}, {900, -240}}}},
              {item("F", {{500, 100}, {499, -1000}})});
  const Made made = made_of(lone);
  EXPECT_EQ(made.blocks.all().size(), 1U);
  const std::vector<std::string> remarks = made.blocks.remarks_on_beds(lone);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("horizon 'B/2' has rock on neither side at (700, -240)"), std::string::npos) << remarks[0];
}

TEST(Blocks, AnXOfFaultsPartsFourAndTheHangingWallHasTwo) {
  const Made made = made_of(faulted(beds, {item("F", {{250, 50}, {800, -500}}), item("G", {{750, 50}, {200, -500}})}));
  ASSERT_EQ(made.blocks.all().size(), 4U);
  EXPECT_NEAR(total(made.blocks), 400000.0, 1e-6);
  const auto hanging = made.blocks.hanging_wall(made.faults[0]);
  ASSERT_TRUE(hanging);
  EXPECT_EQ(*hanging, std::vector<BlockId>({made.blocks.at({500, -50}), made.blocks.at({900, -100})}));
}

TEST(Blocks, AFaultThatEndsOnAnotherPartsAlongItAndWhatItJoins) {
  for (const double gap : {0.0, 1.0, -1.0}) {  // drawn onto it, short of it and past it
    const Made made =
        made_of(faulted(beds, {item("F", {{50, 50}, {600, -500}}), item("G", {{650, 50}, {350 + gap, -250 + gap}})}));
    ASSERT_EQ(made.blocks.all().size(), 3U) << gap;
    const auto hanging = made.blocks.hanging_wall(made.faults[1]);
    ASSERT_TRUE(hanging) << to_string(hanging.error());
    // Above G and F below it: the wedge, and over F above the junction its footwall.
    EXPECT_EQ(*hanging, std::vector<BlockId>({made.blocks.at({50, -200}), made.blocks.at({400, -50})})) << gap;
    EXPECT_NE(made.blocks.at({800, -200}), made.blocks.at({400, -50}));
  }
}

TEST(Blocks, AFaultShortOfTheBorderPartsAndATipDoesNot) {
  const Made near = made_of(faulted(beds, {item("F", {{100, -0.001}, {500, -399.999}})}));
  EXPECT_EQ(near.blocks.all().size(), 2U);
  const Made tip = made_of(faulted(beds, {item("F", {{100, 0}, {300, -200}})}));
  ASSERT_EQ(tip.blocks.all().size(), 1U);
  const auto refused = tip.blocks.hanging_wall(tip.faults[0]);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("it ends in rock, 200 m from the border"), std::string::npos);
  EXPECT_EQ(refused.error().place->x, 300.0);
}

TEST(Blocks, AFaultBelowAllBedsPartsNoneOfThem) {
  const Made blind = made_of(faulted(beds, {item("F", {{200, -700}, {400, -550}})}));
  EXPECT_EQ(blind.faults[0].upper.kind, EndKind::Tip);
  EXPECT_EQ(blind.blocks.all().size(), 1U);
  EXPECT_FALSE(blind.blocks.hanging_wall(blind.faults[0]));
}

TEST(Blocks, NamesAndGroupsAreThoseOfTheirPoints) {
  const std::vector<input::FaultInput> two{item("F", {{50, 50}, {600, -500}}), item("G", {{450, 50}, {1000, -500}})};
  const Made made = made_of(faulted(beds, two, {}, {{"graben", {450, -200}, "basin"}, {"east", {900, -50}, "basin"}}));
  EXPECT_EQ(made.blocks.all()[0].name, "block 1");
  EXPECT_EQ(made.blocks.all()[1].name, "graben");
  const auto basin = made.blocks.named(Names{"basin"});
  ASSERT_TRUE(basin);
  EXPECT_EQ(basin->size(), 2U);
  EXPECT_NE(made.blocks.named(Names{"grabem"}).error().message.find("did you mean 'graben'"), std::string::npos);
  const auto refused = [&](std::vector<input::BlockInput> names) {
    const auto section = faulted(beds, two, {}, std::move(names));
    const auto faults = faults_of(section, {}).value();
    const auto blocks = Blocks::make(section, faults, {});
    return blocks ? std::string() : blocks.error().message;
  };
  EXPECT_NE(refused({{"x", {450, -200}, ""}, {"y", {460, -200}, ""}}).find("is called 'x'"), std::string::npos);
  EXPECT_NE(refused({{"x", {300, -200}, ""}}).find("on a fault or outside"), std::string::npos);
  EXPECT_NE(refused({{"x", {450, -2000}, ""}}).find("on a fault or outside"), std::string::npos);
}

TEST(Blocks, BedsThatStopShortOrRunPastWithinTheToleranceEncloseTheSameBlocks) {
  const double exact_left = 300.0 * 0.5 * (500.0 + 800.0), exact_right = 300.0 * 0.5 * (900.0 + 600.0);
  for (const double off : {0.0, 3.0, -3.0, 6.0}) {
    const auto section = faulted({{"A/1", {{0, 0}, {200, 0}, {500 - off, 0}}},
                                  {"A/2", {{600 + off, -100}, {1500, -100}}},
                                  {"B/1", {{0, -300}, {800 + off, -300}}},
                                  {"B/2", {{900 - off, -400}, {1500, -400}}}},
                                 {item("F", {{400, 100}, {1200, -700}})});
    const Made made = made_of(section);
    ASSERT_EQ(made.blocks.all().size(), 2U) << off;
    EXPECT_NEAR(made.blocks.all()[0].area, exact_left, 0.01) << off;
    EXPECT_NEAR(made.blocks.all()[1].area, exact_right, 0.01) << off;
  }
}

TEST(Blocks, BentLinesPartAsTheyRunNotAsTheirChords) {
  // A listric fault in one smooth run: points between its chord and itself lie above it.
  std::vector<geom::Point> listric;
  for (int k = 0; k <= 40; ++k) listric.push_back({100.0 + 25.0 * k, 50.0 - 500.0 * (1.0 - std::exp(-k / 8.0))});
  const Made made = made_of(faulted(beds, {item("F", listric)}));
  ASSERT_EQ(made.blocks.all().size(), 2U);
  for (std::size_t k = 2; k + 4 < listric.size(); ++k) {
    const geom::Point above = listric[k] + geom::Vector{0, 0.5};
    const geom::Point below = listric[k] - geom::Vector{0, 0.5};
    if (above.y > 0 || below.y < -399) continue;
    EXPECT_NE(made.blocks.at(above), made.blocks.at(below)) << k;
  }
}

/// Which of the cells of a raster hang together without a fault between them: by steps from cell to cell.
std::size_t regions_on_raster(const std::vector<geom::Segment>& faults, int n) {
  const double w = 1000.0 / n, h = 400.0 / n;
  const auto cell = [&](int i, int j) { return geom::Point{(i + 0.5) * w, -(j + 0.5) * h}; };
  const auto side = [](const geom::Segment& f, geom::Point p) { return geom::cross(f.to - f.from, p - f.from) > 0; };
  const auto parted = [&](geom::Point a, geom::Point b) {
    for (const geom::Segment& f : faults) {
      if (side(f, a) != side(f, b)) return true;  // these faults run through the whole section
    }
    return false;
  };
  std::vector<int> label(static_cast<std::size_t>(n * n), -1);
  std::size_t count = 0;
  for (int start = 0; start < n * n; ++start) {
    if (label[start] >= 0) continue;
    std::vector<int> open{start};
    label[start] = 0;
    std::size_t size = 0;
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      ++size;
      const int i = at % n, j = at / n;
      for (const auto& [di, dj] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const int x = i + di, y = j + dj;
        if (x < 0 || y < 0 || x >= n || y >= n || label[y * n + x] >= 0 || parted(cell(i, j), cell(x, y))) continue;
        label[y * n + x] = 0;
        open.push_back(y * n + x);
      }
    }
    if (size > 4) ++count;
  }
  return count;
}

TEST(Blocks, RandomFaultsThroughTheSectionPartAsARasterShows) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(50.0, 950.0);
  for (int draw = 0; draw < 20; ++draw) {
    std::vector<geom::Segment> lines;
    std::vector<input::FaultInput> faults;
    for (int k = 0; k < 1 + draw % 3; ++k) {
      lines.push_back({{x(random), 30}, {x(random), -430}});
      faults.push_back(item("F" + std::to_string(k), {lines.back().from, lines.back().to}));
    }
    const Made made = made_of(faulted(beds, faults));
    EXPECT_NEAR(total(made.blocks), 400000.0, 1e-6);
    std::size_t large = 0;
    for (const Block& block : made.blocks.all()) large += block.area > 5.0 * 400000.0 / (150 * 150) ? 1 : 0;
    EXPECT_LE(std::abs(static_cast<int>(large) - static_cast<int>(regions_on_raster(lines, 150))), 0) << draw;
  }
}

}  // namespace
}  // namespace recon::faults
