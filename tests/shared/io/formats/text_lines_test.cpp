// What the headers and the words of a text say of its lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/io/formats/line_files.h"

namespace dobra::io::formats {
namespace {

using base::ErrorCode;
using geom::Point;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LineWork read_text_lines(const std::string& text, const LineOptions& options = {}) {
  auto read = parse_any_lines(text, "f.csv", options);
  EXPECT_TRUE(read.ok()) << text << (read.ok() ? "" : base::to_string(read.error()));
  return read.ok() ? *std::move(read) : LineWork{};
}

std::vector<std::string> names_of(const LineWork& work) {
  std::vector<std::string> names;
  for (const lines::Feature& feature : work.features) names.push_back(feature.name);
  return names;
}

std::string refused(const std::string& text, const LineOptions& options = {}) {
  const auto read = parse_any_lines(text, "f.csv", options);
  EXPECT_TRUE(read.ok() || read.error().code == ErrorCode::Unclear);
  return read.ok() ? "read" : base::to_string(read.error());
}

const std::string two_lines = "0;0;A\n10;1;A\n20;0;A\n0;-5;B\n10;-4;B\n20;-5;B\n";

TEST(TextLines, AHeaderThatIsAWordForLinesNamesThem) {
  for (const char* const word :
       {"Camada", "horizon", "LAYER", "unit", "Formation", "feature", "id", "horizonte", "Unidade",
        "Forma\xC3\xA7\xC3\xA3o", "Nome da camada", "layer_name", "\"Horizons\"", "line", "contato"}) {
    const LineWork read = read_text_lines("X;Z;" + std::string(word) + "\n" + two_lines);
    EXPECT_THAT(names_of(read), ElementsAre("A", "B")) << word;
    EXPECT_THAT(read.remarks, ElementsAre(AllOf(HasSubstr("column 3 ("), HasSubstr("--name-columns")))) << word;
  }
  const LineWork behind =
      read_text_lines("x,z,dip,horizon,kind\n0,0,5,A,horizon\n1,0,5,A,horizon\n0,1,5,F,fault\n1,2,5,F,fault\n");
  EXPECT_THAT(names_of(behind), ElementsAre("A", "F"));
  EXPECT_EQ(behind.features.at(1).kind, "fault");
  // A column "name" goes before, without a remark.
  const LineWork named = read_text_lines("x,z,layer,name\n0,0,A,p\n1,0,A,p\n0,1,A,q\n1,1,A,q\n");
  EXPECT_THAT(names_of(named), ElementsAre("p", "q"));
  EXPECT_THAT(named.remarks, IsEmpty());
}

TEST(TextLines, ColumnsOfXAndHeightAreFoundByTheirHeaders) {
  struct Case {
    const char* header;
    const char* rows;
  };
  for (const Case& one : {Case{"name,kind,x,z", "A,horizon,0,5\nA,horizon,10,6\n"},
                          {"id;X;Y", "A;0;5\nA;10;6\n"},
                          {"z,name,x", "5,A,0\n6,A,10\n"},
                          {"Camada\tDist (m)\tCota (m)", "A\t0\t5\nA\t10\t6\n"},
                          {"name x elevation", "A 0 5\nA 10 6\n"}}) {
    const LineWork read = read_text_lines(std::string(one.header) + '\n' + one.rows);
    ASSERT_EQ(read.features.size(), 1U) << one.header;
    EXPECT_EQ(read.features[0].name, "A") << one.header;
    EXPECT_THAT(read.features[0].parts[0].points, ElementsAre(Point{0, 5}, Point{10, 6})) << one.header;
    EXPECT_THAT(read.remarks, testing::Contains(AllOf(HasSubstr("by their headers"), HasSubstr("--columns"))))
        << one.header;
  }
  EXPECT_EQ(read_text_lines("name,kind,x,z\nF,fault,0,5\nF,fault,9,6\n").features[0].kind, "fault");
  // Depths by their header go down, wherever the column stands.
  EXPECT_THAT(read_text_lines("name,x,depth\nA,0,5\nA,10,6\n").features[0].parts[0].points,
              ElementsAre(Point{0, -5}, Point{10, -6}));
  // In their usual places there is nothing to tell.
  EXPECT_THAT(read_text_lines("x,z,name\n0,5,A\n10,6,A\n").remarks, IsEmpty());
}

TEST(TextLines, HeadersThatDoNotTellXAndHeightAreAskedAbout) {
  EXPECT_THAT(refused("name,x,y,z\nA,0,1,5\nA,10,1,6\n"),
              AllOf(HasSubstr("f.csv"), HasSubstr("names x, y and z"), HasSubstr("--columns x,z")));
  // Where x and height were found by their headers, the answer to another question names these.
  EXPECT_THAT(refused("id,x,z\n1,0,5\n1,10,6\n2,0,3\n2,10,2\n"),
              AllOf(HasSubstr("--name-columns 1"), HasSubstr("--columns 2,3")));
  const auto unknown = parse_any_lines("name,kind,east,alt\nA,bed,0,5\nA,bed,9,5\n", "f.csv", {});
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(base::to_string(unknown.error()),
              AllOf(HasSubstr("f.csv:2:1"), HasSubstr("columns name, kind, east, alt"), HasSubstr("--columns")));
  // A bad cell under a known header is a bad cell.
  const auto bad = parse_any_lines("x,z\n0,5\n1O,6\n", "f.csv", {});
  ASSERT_FALSE(bad.ok());
  EXPECT_THAT(base::to_string(bad.error()), testing::Not(HasSubstr("--columns")));
}

TEST(TextLines, NamesOfSeveralWordsBetweenBlanksAreReadToTheEnd) {
  const LineWork read = read_text_lines(
      "x z name\n0 0 Red Marl\n9 0 Red Marl # base\n0 -5 Red Sand\n9 -5 \"Red Sand\"\n0 -7 Unit 3\n"
      "9 -7 Unit 3\n");
  EXPECT_THAT(names_of(read), ElementsAre("Red Marl", "Red Sand", "Unit 3"));
  LineOptions third;
  third.text.columns = {"1", "2"};
  third.text.name_columns = {"3"};
  EXPECT_THAT(names_of(read_text_lines("0 0 Red Marl\n9 0 Red Marl\n0 -5 Red Sand\n9 -5 Red Sand\n", third)),
              ElementsAre("Red Marl", "Red Sand"));
  // A number behind it is of another column.
  EXPECT_THAT(names_of(read_text_lines("0 0 Marl 12\n9 0 Marl 13\n", third)), ElementsAre("Marl"));
  const auto shifted = parse_any_lines("x z name kind\n0 0 Red Marl bed\n9 0 Red Marl bed\n", "f.txt", {});
  ASSERT_FALSE(shifted.ok());
  EXPECT_THAT(base::to_string(shifted.error()), AllOf(HasSubstr("f.txt:2"), HasSubstr("5 fields"), HasSubstr("tabs")));
}

TEST(TextLines, WordsUnderAnotherHeaderOrNoneAreAskedAbout) {
  for (const std::string header : {"", "X;Z;Foo\n", "X;Z\n", "a;b;c\n"}) {
    const std::string said = refused(header + two_lines);
    const std::string line = header.empty() ? ":4:" : ":5:";
    EXPECT_THAT(said, AllOf(HasSubstr("f.csv" + line), HasSubstr("'A' in line"), HasSubstr("'B' here"),
                            HasSubstr("--name-columns 3"), HasSubstr("--columns 1,2")))
        << header;
  }
  EXPECT_THAT(refused("0 0 A\n1 0 A\n0 1\n1 1\n"), HasSubstr("'A' in line 1 and '' here"));
  EXPECT_THAT(refused("x,z,layer\n0,0,1\n1,0,1\n0,1,2\n1,1,2\n"), HasSubstr("'1' in line 2 and '2' here"));
  LineOptions names;
  names.text.name_columns = {"3"};
  EXPECT_THAT(names_of(read_text_lines(two_lines, names)), ElementsAre("A", "B"));
  LineOptions none;
  none.text.columns = {"1", "2"};
  EXPECT_EQ(read_text_lines(two_lines, none).features.size(), 1U);
}

TEST(TextLines, WordsThatTellNoLinesApartAreLeftOutOrNoneAtAll) {
  EXPECT_THAT(read_text_lines("0,0,A\n1,0,A\n2,0,A\n").remarks, ElementsAre(HasSubstr("'A' in every row")));
  const LineWork points = read_text_lines("x,z,id\n0,0,P1\n1,0,P2\n2,0,P3\n");
  EXPECT_THAT(names_of(points), ElementsAre(""));
  EXPECT_THAT(points.remarks, ElementsAre(HasSubstr("another in every row")));
  for (const char* const text : {"0 0\n10 1 # here\n20 0\n", "x,z,dip\n0,0,30\n1,0,-\n2,0,40\n3,0,40\n",
                                 "x,z,id\n0,0,1\n1,0,2\n2,0,3\n", "x,z,layer\n0,0,0\n1,0,0\n2,0,0\n"}) {
    const LineWork read = read_text_lines(text);
    EXPECT_EQ(read.features.size(), 1U) << text;
    EXPECT_THAT(read.remarks, IsEmpty()) << text;
  }
}

TEST(TextLines, AHeaderThatSaysDepthTurnsTheHeights) {
  for (const char* const word : {"depth", "Profundidade (m)", "prof", "TVD", "Depth_m", "tvdss"}) {
    const LineWork read = read_text_lines("x," + std::string(word) + ",name\n0,100,A\n5,300,A\n");
    ASSERT_EQ(read.features.size(), 1U);
    EXPECT_THAT(read.features[0].parts[0].points, ElementsAre(Point{0, -100}, Point{5, -300})) << word;
    EXPECT_THAT(read.remarks, ElementsAre(HasSubstr("depths, as the file says")));
  }
  const std::string text = "x,depth\n0,100\n5,300\n";
  EXPECT_EQ(read_text_lines(text, {.y_direction = lines::YDirection::Up}).features.at(0).parts[0].points[1].y, 300.0);
  // Columns that were asked for stay as they stand, and are told.
  LineOptions by_name;
  by_name.text.columns = {"x", "prof"};
  const LineWork asked_for = read_text_lines("prof,x\n100,0\n300,5\n", by_name);
  EXPECT_THAT(asked_for.features.at(0).parts[0].points, ElementsAre(Point{0, 100}, Point{5, 300}));
  EXPECT_THAT(asked_for.remarks, ElementsAre(AllOf(HasSubstr("'prof'"), HasSubstr("--y-axis down"))));
  by_name.y_direction = lines::YDirection::Down;
  EXPECT_EQ(read_text_lines("prof,x\n100,0\n300,5\n", by_name).features.at(0).parts[0].points[1].y, -300.0);
  // Some places stand above the datum; where all do, or depths are written as negative heights, nobody knows.
  EXPECT_EQ(read_text_lines("x,depth\n0,-20\n5,300\n").features.at(0).parts[0].points[0].y, 20.0);
  EXPECT_THAT(refused("x,depth\n0,-100\n5,-300\n"), AllOf(HasSubstr("'depth'"), HasSubstr("--y-axis")));
  for (const char* const word : {"z", "profile", "elevation", "height", "cota"}) {
    const LineWork up = read_text_lines("x," + std::string(word) + "\n0,100\n5,300\n");
    EXPECT_EQ(up.features.at(0).parts[0].points[1].y, 300.0) << word;
    EXPECT_THAT(up.remarks, IsEmpty());
  }
}

}  // namespace
}  // namespace dobra::io::formats
