#include "shared/io/lines/text_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <random>

#include "shared/io/file.h"
#include "tests/shared/io/io_examples.h"
#include "tests/support/corpus.h"

namespace dobra::io::lines {
namespace {

using base::ErrorCode;
using geom::Point;
using geom::Polyline;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Point> points_of(const base::Result<TextPoints>& read) {
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : base::to_string(read.error()));
  EXPECT_EQ(read.ok() ? read->lines.size() : 0U, 1U);
  return read.ok() && !read->lines.empty() ? read->lines[0].points : std::vector<Point>{};
}

TEST(TextPoints, EverySeparatorIsFoundByItself) {
  const std::vector<Point> expected{{1.5, -2.0}, {3.0, 4e3}};
  const std::pair<const char*, Separator> cases[] = {{"1.5 -2\n3   4e3\n", Separator::Blank},
                                                     {"  1.5 -2\n 3\t4e3", Separator::Blank},
                                                     {"1.5\t-2\n3\t4e3\n", Separator::Tab},
                                                     {"1.5,-2\n3, 4e3\n", Separator::Comma},
                                                     {"1.5;-2;bed, upper\n3;4e3;bed\n", Separator::Semicolon}};
  for (const auto& [text, separator] : cases) {
    const auto read = parse_text_points(text, "f");
    EXPECT_EQ(points_of(read), expected) << text;
    EXPECT_EQ(read->separator, separator) << text;
  }
}

TEST(TextPoints, HeaderCommentsByteOrderMarkAndEveryLineEndAreRead) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "\xEF\xBB\xBF# digitised, by hand" + end + "x [m],z [m]" + end + "0,1" + end + end + "2,3";
    EXPECT_THAT(points_of(parse_text_points(text, "f")), ElementsAre(Point{0, 1}, Point{2, 3}));
  }
}

TEST(TextPoints, AForcedHeaderIsLeftOutEvenWhenItIsNumbers) {
  EXPECT_THAT(points_of(parse_text_points("2020 2021\n0 1\n2 3\n", "f", {.header = Header::Present})),
              ElementsAre(Point{0, 1}, Point{2, 3}));
}

TEST(TextPoints, ColumnsAreChosenAndQuotedFieldsMayHoldTheSeparator) {
  EXPECT_THAT(points_of(parse_text_points("\"bed 1, top\",5,\"6\"\n\"b\",7,8\n", "f", {.columns = {"3", "2"}})),
              ElementsAre(Point{6, 5}, Point{8, 7}));
}

TEST(TextPoints, ColumnsAreChosenByTheirHeadersAndNamesSplitLines) {
  const std::string text = "layer;part;z_m;x_m\n1;0;5;0\n1;0;6;1\n1;1;7;2\n1;1;8;3\n";
  const auto read = parse_text_points(text, "f", {.columns = {"x_m", "z_m"}, .name_columns = {"layer", "2"}});
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_THAT(read->names, ElementsAre("1 0", "1 1"));
  EXPECT_THAT(read->begins, ElementsAre(2U, 4U));
  EXPECT_THAT(read->lines[1].points, ElementsAre(Point{2, 7}, Point{3, 8}));
  const auto missing = parse_text_points(text, "f", {.columns = {"x_n", "z_m"}});
  ASSERT_FALSE(missing.ok());
  EXPECT_THAT(missing.error().message, HasSubstr("did you mean 'x_m'?"));
  const auto named =
      parse_text_points("x,z,name,kind\n0,0,top,horizon\n1,0,top,horizon\n0,5,F1,fault\n1,6,F1,fault\n", "f");
  EXPECT_THAT(named->names, ElementsAre("top", "F1"));
  EXPECT_THAT(named->kinds, ElementsAre("horizon", "fault"));
}

TEST(TextPoints, AThirdColumnIsAHeight) {
  const auto read = parse_text_points("1 2 3\n1 2 4\n1 2 4\n", "f", {.columns = {"1", "2", "3"}});
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_THAT(read->lines[0].points, ElementsAre(Point{1, 2}, Point{1, 2}));
  EXPECT_THAT(read->heights[0], ElementsAre(3.0, 4.0));
}

TEST(TextPoints, BlankLinesSplitLinesOnlyWhenAsked) {
  const std::string text = "0 0\n1 0\n\n\n5 5\n6 5\n7 5\n";
  const auto split = parse_text_points(text, "f", {.blank_lines = BlankLines::SplitLines});
  ASSERT_TRUE(split.ok());
  ASSERT_EQ(split->lines.size(), 2U);
  EXPECT_EQ(split->lines[1].points.size(), 3U);
  EXPECT_EQ(points_of(parse_text_points(text, "f")).size(), 5U);
}

TEST(TextPoints, RepeatedPointsAreDroppedAndSaidWithTheirLines) {
  const auto read = parse_text_points("0 0\n0 0\n1 0\n# c\n1 0\n0 0\n", "f.txt");
  EXPECT_THAT(points_of(read), ElementsAre(Point{0, 0}, Point{1, 0}, Point{0, 0}));
  EXPECT_THAT(read->remarks, ElementsAre("f.txt: lines 2 and 5: repeated points dropped"));
}

TEST(TextPoints, AContourIsClosedByItsRepeatedFirstPointWhenAsked) {
  const auto read = parse_text_points("0 0\n1 0\n1 1\n0 0\n", "f", {.closing = Closing::WhenFirstPointRepeats});
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->lines[0], (Polyline{{{0, 0}, {1, 0}, {1, 1}}, true}));
}

TEST(TextPoints, BadTextIsRefusedWithItsPlace) {
  struct Case {
    std::string text;
    ErrorCode code;
    std::string place;
    std::string says;
  };
  const Case cases[] = {
      {"0 1\n2 abc\n", ErrorCode::BadFormat, "f:2:3", "y 'abc' is not a number"},
      {"0 1\n2 3x\n", ErrorCode::BadFormat, "f:2:3", "'3x'"},
      {"0 1\nnan 3\n", ErrorCode::NotFinite, "f:2:1", "x 'nan' is not finite"},
      {"0 1\n2 -inf\n", ErrorCode::NotFinite, "f:2:3", "'-inf'"},
      {"0 1\n2 1e999\n", ErrorCode::BadFormat, "f:2:3", "'1e999'"},
      {"0 1\n\n2\n", ErrorCode::BadFormat, "f:3:2", "column 2, but this line has 1 separated by"},
      {"0;1\n2;\n", ErrorCode::BadFormat, "f:2:3", "y is missing"},
      {"1,5;2,5\n1,6.2;2,6\n", ErrorCode::BadFormat, "f:2:1", "write '.' as the decimal sign"},
      {"x y\na b\n", ErrorCode::BadFormat, "f:2:1", "x 'a' is not a number"},
      {"x z\n1 2\n1 b\n", ErrorCode::BadFormat, "f:3:3", "z 'b' is not a number"},
      {"0 1\n2 \x01\x02\n", ErrorCode::BadFormat, "f:2:3",
       "'?"
       "?'"},
      {std::string("0 1\n2 3\n\0\n", 10), ErrorCode::BadFormat, "f:3:1", "binary"},
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {" \n\t\r\n", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"# only\n", ErrorCode::EmptyFile, "f:0:0", "no points"},
      {"x y\n", ErrorCode::EmptyFile, "f:0:0", "no points"},
      {"1 1\n", ErrorCode::DegenerateCurve, "f:1:0", "at least two distinct points"},
      {"# c\n1 1\n1 1\n", ErrorCode::DegenerateCurve, "f:2:0", "at least two distinct points"},
  };
  for (const Case& c : cases) {
    const auto read = parse_text_points(c.text, "f");
    ASSERT_FALSE(read.ok()) << c.text;
    EXPECT_EQ(read.error().code, c.code) << c.text;
    EXPECT_EQ(place_text(read.error()), c.place) << c.text;
    EXPECT_THAT(read.error().message, HasSubstr(c.says)) << c.text;
    EXPECT_EQ(base::exit_code(read.error().code), 3);
  }
}

TEST(TextPoints, BadOptionsAreRefused) {
  for (const TextPointsOptions& options :
       {TextPointsOptions{.columns = {"0", "2"}}, TextPointsOptions{.columns = {"2", "2"}},
        TextPointsOptions{.columns = {"1"}}, TextPointsOptions{.columns = {"1", "2", "1"}},
        TextPointsOptions{.columns = {"x", "2"}}, TextPointsOptions{.name_columns = {"bed"}}}) {
    const auto read = parse_text_points("0 1\n2 3\n", "f", options);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::InvalidOption);
  }
}

TEST(TextPoints, MissingFilesAndFoldersAreRefused) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_text_points(folder.file("none.txt")).error().code, ErrorCode::FileNotFound);
  EXPECT_EQ(read_text_points(folder.path()).error().code, ErrorCode::NotAFile);
  std::ofstream(folder.file("empty.txt"));
  EXPECT_EQ(read_text_points(folder.file("empty.txt")).error().code, ErrorCode::EmptyFile);
}

TEST(TextPoints, WhatIsWrittenReadsBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Polyline> lines(20);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].closed = i % 2 == 0;
    for (std::size_t k = 0; k < 3 + i; ++k) {
      lines[i].points.push_back(
          {uniform(random) * 1e5, std::ldexp(uniform(random), static_cast<int>(random() % 400) - 200)});
    }
  }
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_points_csv(folder.file("p.csv"), lines, "x", "z").ok());
  const auto read = read_text_points(
      folder.file("p.csv"), {.blank_lines = BlankLines::SplitLines, .closing = Closing::WhenFirstPointRepeats});
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->lines, lines);
  EXPECT_EQ(*points_csv(read->lines, "x", "z"), *read_text(folder.file("p.csv")));
  const Polyline bad{{{0, 0}, {std::numeric_limits<double>::infinity(), 0}}, false};
  EXPECT_EQ(write_points_csv(folder.file("q.csv"), {&bad, 1}).error().code, ErrorCode::NotFinite);
  EXPECT_FALSE(std::filesystem::exists(folder.file("q.csv")));
}

TEST(TextPoints, EverySectionOfTheCorpusIsRead) {
  const auto folder = test::data_folder();
  if (!folder) GTEST_SKIP() << test::no_data;
  const std::pair<const char*, std::size_t> counts[] = {{"ragan_isogon_fold/layer1.txt", 114},
                                                        {"ragan_isogon_fold/layer4.txt", 278},
                                                        {"catskill_fpf/bed1.txt", 402},
                                                        {"broadhaven_fold/layer2.txt", 218},
                                                        {"subandean_area_balance/subandean.txt", 30}};
  for (const auto& [name, lines] : counts) {
    const auto read = read_text_points((*folder / "sections" / name).string());
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_EQ(read->lines.size(), 1U);
    EXPECT_EQ(read->lines[0].points.size(), lines) << name;
    EXPECT_TRUE(read->remarks.empty()) << name;
  }
}

TEST(Corpus, EveryContourOfTheCorpusIsRead) {
  const auto folder = test::data_folder();
  if (!folder) GTEST_SKIP() << test::no_data;
  const std::pair<const char*, std::size_t> graphs[] = {
      {"cdt_guitar_no_box.txt", 144}, {"cdt_island.txt", 95}, {"cdt_kidney.txt", 50}};
  for (const auto& [name, points] : graphs) {
    const auto read = test::read_cdt_file(*folder / "contours" / name);
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->points.size(), points) << name;
    EXPECT_EQ(read->edges.size(), read->points.size()) << name;
  }
  const std::tuple<const char*, std::size_t, std::size_t> outlines[] = {
      {"poly2tri_bird.dat", 275, 0}, {"poly2tri_dude.dat", 94, 2}, {"poly2tri_tank.dat", 55, 0}};
  for (const auto& [name, points, holes] : outlines) {
    const auto read = test::read_outline(*folder / "contours" / name);
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->contour.points.size(), points) << name;
    ASSERT_EQ(read->holes.size(), holes) << name;
    for (const Polyline& hole : read->holes) {
      for (const Point p : hole.points) EXPECT_EQ(geom::locate(read->contour, p), geom::Side::Inside) << name;
    }
  }
}

TEST(TextPoints, ExtraColumnsComeWithTheirPointsAndAShortRowHasNought) {
  TextPointsOptions options;
  options.extra_columns = {"3", "4"};
  const auto read = parse_text_points("0 0 1 2 tag\n5 1 3 4\n5 1 3 4\n9 9\n", "f", options);
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->lines[0].points.size(), 3U);
  EXPECT_THAT(read->extras, ElementsAre(ElementsAre(1, 2, 3, 4, 0, 0)));
  const auto bad = parse_text_points("0 0 1 2\n5 1 x 4\n", "f", options);
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().place->line, 2U);
  EXPECT_EQ(bad.error().place->column, 5U);
  options.extra_columns = {"dx"};
  const auto named = parse_text_points("x,z,dx\n0,0,7\n1,1,8\n", "f", options);
  ASSERT_TRUE(named.ok()) << base::to_string(named.error());
  EXPECT_THAT(named->extras, ElementsAre(ElementsAre(7, 8)));
}

TEST(TextPoints, ARowWhoseKindIsMisspeltIsToldAsThat) {
  const auto message = [](const std::string& rows) {
    const auto read = parse_text_points("x,z,name,kind\n" + rows, "f");
    EXPECT_FALSE(read.ok()) << rows;
    return read.ok() ? std::string() : base::to_string(read.error());
  };
  EXPECT_THAT(message("0,0,top,horizon\n5,1,top,Horizonn\n9,0,top,horizon\n"),
              testing::AllOf(HasSubstr("f:3"),
                             HasSubstr("unknown kind 'Horizonn', in this row only; did you mean 'horizon'?")));
  EXPECT_THAT(message("0,0,top,horizon\n5,1,top,horizon\n5,4,F,fautl\n"), HasSubstr("did you mean 'fault'?"));
  // A kind that there is: the name and the kind are told.
  EXPECT_THAT(message("0,0,top,horizon\n5,1,top,fault\n9,0,top,horizon\n"),
              HasSubstr("this one 'top' of kind 'horizon' has 1"));
  EXPECT_THAT(message("0,0,top,\n5,1,tpo,\n9,0,top,\n"), HasSubstr("this one 'top' has 1"));
}

}  // namespace
}  // namespace dobra::io::lines
