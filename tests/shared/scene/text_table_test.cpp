#include "shared/scene/text_table.h"

#include <gtest/gtest.h>

namespace dobra::scene {
namespace {

const Font font{9.0, Weight::Regular};

const TextTable ledger{
    "Beds", {"horizon", "before [m]", "[%]"}, {{"Upper Sandstone", "6827.2", "+0.00"}, {"Marl", "6.1", "-12.25"}}};

std::vector<TextMark> texts_of(const Furniture& made) {
  std::vector<TextMark> texts;
  for (const Mark& mark : made.marks) {
    if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(*text);
  }
  return texts;
}

const TextMark& text(const std::vector<TextMark>& texts, const std::string& wanted) {
  for (const TextMark& mark : texts) {
    if (mark.text == wanted) return mark;
  }
  ADD_FAILURE() << "no text " << wanted;
  return texts.front();
}

double left(const TextMark& mark) { return mark.at.x - 0.5 * mark.size.width; }
double right(const TextMark& mark) { return mark.at.x + 0.5 * mark.size.width; }

TEST(TextTable, TheFirstColumnStandsToTheLeftAndTheOthersToTheRight) {
  const auto texts = texts_of(text_table(ledger, font, approximate_text_measure()));
  EXPECT_NEAR(left(text(texts, "horizon")), left(text(texts, "Upper Sandstone")), 1e-9);
  EXPECT_NEAR(left(text(texts, "Marl")), left(text(texts, "Upper Sandstone")), 1e-9);
  EXPECT_NEAR(right(text(texts, "6827.2")), right(text(texts, "6.1")), 1e-9);
  EXPECT_NEAR(right(text(texts, "before [m]")), right(text(texts, "6.1")), 1e-9);
  EXPECT_NEAR(right(text(texts, "-12.25")), right(text(texts, "[%]")), 1e-9);
}

TEST(TextTable, NoCellOverlapsAnotherAndAllLieWithinTheTable) {
  const Furniture made = text_table(ledger, font, approximate_text_measure());
  std::vector<geom::Box> boxes;
  for (const TextMark& mark : texts_of(made)) boxes.push_back(box_of(Mark{mark}));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].low.x, -1e-9);
    EXPECT_LE(boxes[i].high.x, made.width + 1e-9);
    EXPECT_LE(boxes[i].high.y, made.height + 1e-9);
    for (std::size_t j = i + 1; j < boxes.size(); ++j) EXPECT_FALSE(boxes[i].overlaps(boxes[j])) << i << ' ' << j;
  }
}

TEST(TextTable, RowsFollowUnderTheRule) {
  const Furniture made = text_table(ledger, font, approximate_text_measure());
  double rule = 0.0;
  for (const Mark& mark : made.marks) {
    if (const auto* line = std::get_if<LineMark>(&mark)) rule = line->from.y;
  }
  const auto texts = texts_of(made);
  EXPECT_LT(text(texts, "Beds").at.y, text(texts, "horizon").at.y);
  EXPECT_LT(text(texts, "horizon").at.y, rule);
  EXPECT_LT(rule, text(texts, "Upper Sandstone").at.y);
  EXPECT_LT(text(texts, "Upper Sandstone").at.y, text(texts, "Marl").at.y);
}

TEST(TextTable, ATableWithoutRowsOrWithShortRowsIsDrawnAllTheSame) {
  const TextTable empty{"Nothing", {"a", "b"}, {}};
  EXPECT_EQ(texts_of(text_table(empty, font, approximate_text_measure())).size(), 3u);
  const TextTable shorter{"", {"a", "b"}, {{"only"}}};
  EXPECT_EQ(texts_of(text_table(shorter, font, approximate_text_measure())).size(), 3u);
}

Picture with_two_tables(std::size_t rows) {
  Picture picture;
  TextTable beds = ledger;
  for (std::size_t i = beds.rows.size(); i < rows; ++i)
    beds.rows.push_back({"bed " + std::to_string(i), "1.0", "0.00"});
  picture.tables = {beds, {"Units", {"unit"}, {{"A - B"}}}};
  return picture;
}

TEST(TextTable, TablesStandSideBySideWhereTheyHaveRoomElseUnderEachOther) {
  const Picture picture = with_two_tables(2);
  const TextMeasure measure = approximate_text_measure();
  const auto wide = texts_of(tables_of(picture, {700.0, 500.0}, font, measure).furniture);
  EXPECT_EQ(text(wide, "Beds").at.y, text(wide, "Units").at.y);
  EXPECT_LT(right(text(wide, "[%]")), left(text(wide, "Units")));
  const Tables narrow = tables_of(picture, {250.0, 500.0}, font, measure);
  EXPECT_LT(text(texts_of(narrow.furniture), "Marl").at.y, text(texts_of(narrow.furniture), "Units").at.y);
  EXPECT_FALSE(narrow.cut);
}

TEST(TextTable, LongTablesAreCutAndSayHowManyRowsAreLeftOut) {
  const TextMeasure measure = approximate_text_measure();
  for (const std::size_t rows : {12U, 60U, 1000U}) {
    for (const double height : {90.0, 150.0}) {
      for (const double width : {250.0, 700.0}) {
        const Tables made = tables_of(with_two_tables(rows), {width, height}, font, measure);
        const std::string at = std::to_string(rows) + " rows in " + std::to_string(height);
        const double least = width > 600.0 ? height : 170.0;  // three rows of each remain whatever happens
        EXPECT_LE(made.furniture.height, least + 1e-9) << at;
        std::size_t shown = 0;
        std::size_t told = 0;
        for (const TextMark& mark : texts_of(made.furniture)) {
          shown += mark.text.starts_with("bed ") || mark.text == "Marl" || mark.text == "Upper Sandstone" ? 1 : 0;
          if (mark.text.starts_with("... ")) told += std::stoul(mark.text.substr(4));
        }
        EXPECT_EQ(shown + told, rows) << at;
        EXPECT_EQ(made.cut, told > 0) << at;
        EXPECT_GE(shown, 3U) << at;
      }
    }
  }
}

TEST(TextTable, AVeryLongNameIsCutAtALetter) {
  std::string name;
  for (int i = 0; i < 300; ++i) name += "\u00e3";
  const TextTable table{"Beds", {"horizon"}, {{name}, {name.substr(0, 96)}}};
  const auto texts = texts_of(text_table(table, font, approximate_text_measure()));
  EXPECT_EQ(texts[2].text, name.substr(0, 94) + "\u2026");
  EXPECT_EQ(texts[3].text, name.substr(0, 96));  // of 48 letters
}

TEST(TextTable, NotesStandUnderEachOther) {
  Picture picture;
  picture.notes = {"Both states to the same scale.", "Verdict: balanced."};
  const TextMeasure measure = approximate_text_measure();
  const auto texts = texts_of(notes_of(picture, 500.0, font, measure));
  EXPECT_LT(text(texts, "Both states to the same scale.").at.y, text(texts, "Verdict: balanced.").at.y);
  EXPECT_EQ(notes_of({}, 500.0, font, measure).height, 0.0);
}

}  // namespace
}  // namespace dobra::scene
