#include "shared/io/formats/curves.h"

#include <gtest/gtest.h>

#include "shared/io/file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::formats {
namespace {

using geom::Point;

class CurvesOfFiles : public ::testing::Test {
 protected:
  base::Result<Curves> read(const std::string& name, const std::string& text) const {
    EXPECT_TRUE(write_file(folder.file(name), text).ok());
    return read_curves(folder.file(name));
  }
  test::TemporaryFolder folder;
};

TEST_F(CurvesOfFiles, ColumnsOfNumbersSplitAtBlankLinesAndCloseOnTheirFirstPoint) {
  for (const char* name : {"a.txt", "a.csv", "a.dat", "a.tsv", "A.CSV"}) {
    const auto curves = read(name, "0\t0\n4\t1\n\n0\t0\n2\t0\n2\t2\n0\t0\n");
    ASSERT_TRUE(curves.ok()) << base::to_string(curves.error());
    ASSERT_EQ(curves->curves.size(), 2U) << name;
    EXPECT_EQ(curves->curves[0].name, "curve 1");
    EXPECT_EQ(curves->curves[0].line.points, (std::vector<Point>{{0, 0}, {4, 1}}));
    EXPECT_FALSE(curves->curves[0].line.closed);
    EXPECT_EQ(curves->curves[1].name, "curve 2");
    EXPECT_TRUE(curves->curves[1].line.closed);
    EXPECT_EQ(curves->curves[1].line.points.size(), 3U);
  }
}

TEST_F(CurvesOfFiles, PolygonsGiveAllTheirRingsClosed) {
  const auto curves = read("a.wkt", "POLYGON ((0 0, 0 9, 9 9, 9 0, 0 0), (2 2, 4 2, 4 4, 2 2))\nPOINT (1 1)\n");
  ASSERT_TRUE(curves.ok()) << base::to_string(curves.error());
  ASSERT_EQ(curves->curves.size(), 2U);
  EXPECT_TRUE(curves->curves[0].line.closed && curves->curves[1].line.closed);
  EXPECT_EQ(geom::signed_area(curves->curves[0].line), 81.0);
  EXPECT_EQ(geom::signed_area(curves->curves[1].line), -2.0);
  ASSERT_EQ(curves->remarks.size(), 1U);
  EXPECT_NE(curves->remarks[0].find("1 feature of points left out"), std::string::npos);
}

TEST_F(CurvesOfFiles, NamesComeFromTheFileAndPartsAreNumbered) {
  const std::string text =
      R"({"type":"Feature","properties":{"name":"top"},"geometry":{"type":"MultiLineString","coordinates":[[[0,0],[1,0]],[[2,0],[3,0]]]}})";
  for (const char* name : {"a.geojson", "a.json"}) {
    const auto curves = read(name, text);
    ASSERT_TRUE(curves.ok()) << base::to_string(curves.error());
    ASSERT_EQ(curves->curves.size(), 2U);
    EXPECT_EQ(curves->curves[0].name, "top");
    EXPECT_EQ(curves->curves[1].name, "top (2)");
  }
  const auto drawn =
      read("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nBASE\n10\n1\n20\n2\n11\n3\n21\n4\n0\nENDSEC\n0\nEOF\n");
  ASSERT_TRUE(drawn.ok()) << base::to_string(drawn.error());
  EXPECT_EQ(drawn->curves.at(0).name, "BASE");
}

TEST_F(CurvesOfFiles, AnUnknownEndingAndAFileWithoutLinesAreRefused) {
  const auto unknown = read("a.xyz", "x");
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, base::ErrorCode::UnknownFormat);
  for (const char* ending : {".txt", ".csv", ".tsv", ".dat", ".wkt", ".geojson", ".json", ".dxf"}) {
    EXPECT_NE(unknown.error().message.find(ending), std::string::npos) << ending;
  }
  EXPECT_EQ(base::exit_code(unknown.error().code), 3);
  EXPECT_EQ(read("p.wkt", "POINT (1 1)").error().code, base::ErrorCode::BadFormat);
  EXPECT_EQ(read_curves(folder.file("none.csv")).error().code, base::ErrorCode::FileNotFound);
}

}  // namespace
}  // namespace dobra::io::formats
