#include "shared/scenario/color_table.h"

#include <gtest/gtest.h>

namespace dobra::scenario {
namespace {

void expect_k2p(const base::Result<scene::ColorTable>& table) {
  ASSERT_TRUE(table) << base::to_string(table.error());
  ASSERT_EQ(table->entries.size(), 2U);
  const scene::ColorEntry& entry = table->entries[0];
  EXPECT_EQ(entry.name, "K2p");
  EXPECT_EQ(entry.color, (scene::Color{210, 180, 140}));
  EXPECT_EQ(entry.pattern, scene::Pattern::Bricks);
  EXPECT_EQ(entry.age, "Upper Cretaceous");
  EXPECT_EQ(entry.lithology, "limestone");
  EXPECT_EQ(table->entries[1].name, "J3");
  EXPECT_FALSE(table->entries[1].color);
}

TEST(ColorTable, CommaSemicolonTabAndTomlSayTheSame) {
  expect_k2p(parse_color_table(
      "name,colour,pattern,age,lithology\nK2p,\"210, 180, 140\",bricks,Upper Cretaceous,limestone\nJ3\n", "a.csv"));
  expect_k2p(
      parse_color_table("# a survey's\r\nNome;Cor;Padrao;Idade;Litologia;fonte\r\nK2p;#D2B48C;Bricks;Upper "
                        "Cretaceous;limestone;x\r\n\r\nJ3;;;;;\r\n",
                        "a.csv"));
  expect_k2p(parse_color_table(
      "code\tcolor\tpattern\tage\tlithology\nK2p\ttan\tbricks\tUpper Cretaceous\tlimestone\nJ3\t\t\t\t\n", "a.txt"));
  expect_k2p(parse_color_table(
      "[[unit]]\nname = \"K2p\"\ncolour = \"#d2b48c\"\npattern = \"bricks\"\nage = \"Upper Cretaceous\"\n"
      "lithology = \"limestone\"\n[[unit]]\nname = \"J3\"\n",
      "a.toml"));
}

TEST(ColorTable, WhatIsWrongIsToldWithItsLine) {
  struct Case {
    const char* text;
    const char* file;
    const char* told;
  };
  for (const Case& bad : {Case{"name,colour\nA,#fff\nB,#12345\n", "a.csv", "a.csv:3: 'B': '#12345' is not a colour"},
                          Case{"name,pattern\nA,brick\n", "a.csv", "a.csv:2: 'A': 'brick' is not a pattern"},
                          Case{"name,colour\nA,#fff\nA,#000\n", "a.csv", "a.csv:3: 'A' has a colour already in line 2"},
                          Case{"name,colour\n,#fff\n", "a.csv", "a.csv:2: a unit needs a name"},
                          Case{"colour,age\n#fff,1\n", "a.csv", "a.csv:1: the first line names the columns"},
                          Case{"name,colour\nA,210,180,140\n", "a.csv", "a.csv:2: 4 cells under 2 headings"},
                          Case{"name,colour\n", "a.csv", "the table names no unit"},
                          Case{"[[unit]]\nname = \"A\"\ncolour = \"redd\"\n", "a.toml", "a.toml:1"},
                          Case{"[[unit]]\nname = \"A\"\ncolr = \"red\"\n", "a.toml", "a.toml:3"},
                          Case{"[[unit]]\nname = 3\n", "a.toml", "a.toml:2"},
                          Case{"[units]\nA = \"red\"\n", "a.toml", "write [[unit]] tables"},
                          Case{"name = = 3\n", "a.toml", "not valid TOML"}}) {
    const auto table = parse_color_table(bad.text, bad.file);
    ASSERT_FALSE(table) << bad.text;
    EXPECT_NE(base::to_string(table.error()).find(bad.told), std::string::npos) << base::to_string(table.error());
    EXPECT_EQ(base::exit_code(table.error().code), 3) << bad.text;
  }
}

TEST(ColorTable, AFileThatIsNotThereIsTold) {
  EXPECT_EQ(read_color_table("no such file.csv").error().code, base::ErrorCode::FileNotFound);
}

}  // namespace
}  // namespace dobra::scenario
