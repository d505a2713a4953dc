#include "shared/gui/numbers/numbers.h"

#include <gtest/gtest.h>

#include <limits>

#include "shared/scene/decimal_mark.h"
#include "shared/scene/ticks.h"

namespace dobra::gui::numbers {
namespace {

using scenario::Kind;
using scenario::Value;

class Numbers : public testing::Test {
 protected:
  ~Numbers() override { scene::set_decimal_mark(scene::DecimalMark::Point); }
  static void speak_portuguese() { scene::set_decimal_mark(scene::DecimalMark::Comma); }
  static std::string points(const char* text) {
    const auto read = points_from_text(text);
    return read ? text_of_points(*read) : read.error().message;
  }
};

TEST_F(Numbers, ListsThatAreNoListsStayWrong) {
  for (const bool comma : {false, true}) {
    if (comma) speak_portuguese();
    EXPECT_EQ(points("0, 0\n1, x\n"), "line 2: 'x' is not a number");
    EXPECT_EQ(points("0, 0, 0\n"), "line 1: a point has two numbers, x and y");
    EXPECT_EQ(points("1,5,2,5"), "line 1: a point has two numbers, x and y");
    EXPECT_EQ(points("7"), "line 1: a point has two numbers, x and y");
    EXPECT_EQ(points("1;;2"), "line 1: '' is not a number");
    EXPECT_EQ(points("1, nan"), "line 1: 'nan' is not a number");
    EXPECT_EQ(points("1.234,5 2"), "line 1: '1.234,5' is not a number");  // a mark between thousands is none
    EXPECT_EQ(points(" \n\n"), "");
  }
}

TEST_F(Numbers, PointsAreReadWithEitherMark) {
  EXPECT_EQ(points("1,5; 2,25\n1.5, 2.25\n1,5 2,25\n1,5, 2,25\n[1.5, 2.25],\n(1,5;2,25)\n1,5\t2,25"),
            "1.5, 2.25\n1.5, 2.25\n1.5, 2.25\n1.5, 2.25\n1.5, 2.25\n1.5, 2.25\n1.5, 2.25");
  speak_portuguese();
  EXPECT_EQ(points("1,5; 2,25\n3, 4\n3,4"), "1,5; 2,25\n3; 4\n3; 4");
}

TEST_F(Numbers, WhatIsShownReadsBackToTheSameBits) {
  for (const bool comma : {false, true}) {
    if (comma) speak_portuguese();
    const std::vector<double> hard{0.1,     1.0 / 3.0,
                                   -1e-300, 12345678.901234567,
                                   -0.0,    40.5,
                                   1e21,    5e-324,
                                   -7.0,    std::numeric_limits<double>::max()};
    scenario::Field list;
    list.key = "list";
    list.kind = Kind::Numbers;
    const auto read =
        scenario::parse_value(list, as_parsed(Kind::Numbers, field_text(Kind::Numbers, hard)).toStdString());
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(std::get<std::vector<double>>(*read), hard);
    for (const double each : hard) {
      scenario::Field alone;
      alone.key = "alone";
      alone.kind = Kind::Number;
      const QString shown = field_text(Kind::Number, each);
      EXPECT_EQ(shown.contains('.') && comma, false) << shown.toStdString();
      const auto back = scenario::parse_value(alone, as_parsed(Kind::Number, shown).toStdString());
      ASSERT_TRUE(back.ok()) << shown.toStdString();
      EXPECT_EQ(std::get<double>(*back), each);
      const std::vector<geom::Point> two{{each, 0.25}, {-0.75, each}};
      EXPECT_EQ(*points_from_text(text_of_points(two)), two);
    }
  }
}

TEST_F(Numbers, ACommaAloneIsADecimalMarkWhereTheLanguageWritesOne) {
  EXPECT_EQ(as_parsed(Kind::Numbers, "1,5"), "1, 5");
  EXPECT_EQ(as_parsed(Kind::Point, "1,5"), "1, 5");
  speak_portuguese();
  EXPECT_EQ(as_parsed(Kind::Numbers, "1,5"), "1.5");
  EXPECT_EQ(as_parsed(Kind::Numbers, "1, 5"), "1, 5");
  EXPECT_EQ(as_parsed(Kind::Numbers, "1,5; 2; 3,5"), "1.5, 2, 3.5");
  EXPECT_EQ(as_parsed(Kind::Point, "1,5"), "1, 5");
  EXPECT_EQ(as_parsed(Kind::Point, "1,5 2,5"), "1.5, 2.5");
  EXPECT_EQ(as_parsed(Kind::Number, "1,5e-3"), "1.5e-3");
  EXPECT_EQ(as_parsed(Kind::Number, "1.234,5"), "1.234,5");
  EXPECT_EQ(as_parsed(Kind::Text, "1,5"), "1,5");
}

TEST_F(Numbers, NamesStandWithoutQuotesWhereTheyReadBack) {
  scenario::Field names;
  names.key = "names";
  names.kind = Kind::Texts;
  const std::vector<std::vector<std::string>> all{
      {"hole"}, {"a b", "c"}, {"1.5"}, {"a,b", "c"}, {" x"}, {"say \"hello\""}, {}, {"", "y"}, {"[z]"}, {"true", "7"}};
  for (const std::vector<std::string>& each : all) {
    const QString shown = field_text(Kind::Texts, each);
    const auto back = scenario::parse_value(names, as_parsed(Kind::Texts, shown).toStdString());
    ASSERT_TRUE(back.ok()) << shown.toStdString();
    EXPECT_EQ(std::get<std::vector<std::string>>(*back), each) << shown.toStdString();
  }
  EXPECT_EQ(field_text(Kind::Texts, std::vector<std::string>{"hole", "tip"}), "hole, tip");
}

TEST_F(Numbers, ReadableNumbersHaveNoMarkBetweenThousands) {
  EXPECT_EQ(readable(14715897.3), "14715897");
  EXPECT_EQ(readable(2.1e11), "2.1e11");
  EXPECT_EQ(readable(1e-7), "1e-7");
  EXPECT_EQ(readable(6827.2240806), "6827.22");
  EXPECT_EQ(readable(-99999.96), "-100000");
  speak_portuguese();
  EXPECT_EQ(readable(44483.08), "44483,1");
  EXPECT_EQ(readable(123456.7), "123457");
  EXPECT_EQ(readable(2.15e-11), "2,15e-11");
  EXPECT_EQ(whole(40.0), "40");
  EXPECT_EQ(whole(0.1), "0,1");
  EXPECT_EQ(whole(1e-7), "1e-7");
}

TEST_F(Numbers, UnitsHaveTheirPowersSet) {
  EXPECT_EQ(unit_text("m2"), "m\u00b2");
  EXPECT_EQ(unit_text("N/m3"), "N/m\u00b3");
  EXPECT_EQ(unit_text("kg m2/s2"), "kg m\u00b2/s\u00b2");
  EXPECT_EQ(unit_text("Pa m^0.5"), "Pa m^0.5");
  EXPECT_EQ(unit_text("Pa sqrt(m)"), "Pa \u221am");
  EXPECT_EQ(unit_text(""), "");
}

TEST_F(Numbers, AxesHaveTheMarkToo) {
  speak_portuguese();
  EXPECT_EQ(scene::tick_label(-2.5, 1),
            "\u2212"
            "2,5");
  EXPECT_EQ(scene::nice_ticks(0.0, 1.0, 3).at(1).label, "0,5");
}

TEST_F(Numbers, StepsAreRoundNumbers) {
  EXPECT_EQ(stepped(0.3, 1), 0.31);
  EXPECT_EQ(stepped(0.3, -1), 0.29);
  EXPECT_EQ(stepped(50.0, 1), 51.0);
  EXPECT_EQ(stepped(-50.0, 1), -49.0);
  EXPECT_EQ(stepped(1234.5, 1), 1300.0);
  EXPECT_EQ(stepped(0.0, 2), 0.2);
  EXPECT_EQ(stepped(2e-7, 1), 2.1e-7);
}

}  // namespace
}  // namespace dobra::gui::numbers
