#include "shared/canvas/entry.h"

#include <gtest/gtest.h>

namespace dobra::canvas {
namespace {

using geom::Point;

Point read(const char* text, const EntryContext& context = {}) {
  const auto place = parse_entry(text, context);
  EXPECT_TRUE(place) << text << ": " << (place ? "" : place.error().message);
  return place ? *place : Point{-1e9, -1e9};
}

bool refused(const char* text, const EntryContext& context = {}) { return !parse_entry(text, context); }

const EntryContext from_there{.last = Point{100, 200}, .towards = geom::Vector{3, 4}};
const EntryContext in_portuguese{.last = Point{100, 200}, .towards = geom::Vector{3, 4}, .mark = DecimalMark::Comma};

TEST(Entry, PlacesAreReadWithAnySeparator) {
  for (const char* text :
       {"12.5,-3", "12.5, -3", "12.5;-3", "12.5 -3", " 12.5  -3 ", "12,5;-3", "12,5 -3", "1.25e1,-3"})
    EXPECT_EQ(read(text), (Point{12.5, -3})) << text;
  EXPECT_EQ(read("+7,8"), (Point{7, 8}));
}

TEST(Entry, WaysAreFromTheLastPlace) {
  EXPECT_EQ(read("@10,-20", from_there), (Point{110, 180}));
  EXPECT_EQ(read("@10,5;-20", from_there), (Point{110.5, 180}));
  EXPECT_EQ(read("@50<90", from_there), (Point{100, 250}));
  EXPECT_EQ(read("@50<-180", from_there), (Point{50, 200}));
  EXPECT_EQ(read("@12,5<0", from_there), (Point{112.5, 200}));
  const Point slanted = read("@100<30", from_there);
  EXPECT_NEAR(slanted.x, 186.602540378443865, 1e-12);
  EXPECT_NEAR(slanted.y, 250.0, 1e-12);
  EXPECT_EQ(read("50", from_there), (Point{130, 240}));
}

TEST(Entry, ACommaInASingleNumberIsWhatTheLanguageSays) {
  EXPECT_EQ(read("12,5", from_there), (Point{12, 5}));
  EXPECT_EQ(read("12,5", in_portuguese), (Point{107.5, 210}));
  EXPECT_EQ(read("12.5", in_portuguese), (Point{107.5, 210}));
  EXPECT_EQ(read("12,5;7,25", in_portuguese), (Point{12.5, 7.25}));
  EXPECT_EQ(read("12,5 7,25", in_portuguese), (Point{12.5, 7.25}));
  EXPECT_EQ(read("12.5,7.25", in_portuguese), (Point{12.5, 7.25}));
}

TEST(Entry, WhatIsNoPlaceIsRefused) {
  for (const char* text : {"", "@", "a,b", "1,2,3", "1;2;3", "1;", ";1", "1,,2", "nan,1", "inf;2", "@1", "@<30", "@5<",
                           "@5<3<2", "1 2 3", "0x10,2", "1e999,0"})
    EXPECT_TRUE(refused(text, from_there)) << text;
  EXPECT_TRUE(refused("@1,2"));
  EXPECT_TRUE(refused("5<90"));
  EXPECT_TRUE(refused("5"));
  EXPECT_TRUE(refused("5", {.last = Point{0, 0}}));
  EXPECT_TRUE(refused("5", {.last = Point{0, 0}, .towards = geom::Vector{0, 0}}));
}

}  // namespace
}  // namespace dobra::canvas
