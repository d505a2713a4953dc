// Texts as they come out of spreadsheets and other programs: units in headers, decimal commas, values that are none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/io/formats/line_files.h"

namespace dobra::io::formats {
namespace {

using geom::Point;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// "READ" with its points where it is read, else what is said.
struct Untidy {
  std::vector<Point> points;
  std::vector<std::string> remarks;
  std::string error;
};

Untidy untidy(const std::string& text, const LineOptions& options = {}) {
  const auto read = parse_any_lines(text, "f.csv", options);
  if (!read.ok()) return {{}, {}, base::to_string(read.error())};
  Untidy made{{}, read->remarks, {}};
  for (const lines::Feature& feature : read->features) {
    for (const geom::Polyline& part : feature.parts)
      made.points.insert(made.points.end(), part.points.begin(), part.points.end());
  }
  return made;
}

void expect_points(const Untidy& read, const std::vector<Point>& points, const std::string& text) {
  ASSERT_EQ(read.error, "") << text;
  ASSERT_EQ(read.points.size(), points.size()) << text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_DOUBLE_EQ(read.points[i].x, points[i].x) << text;
    EXPECT_DOUBLE_EQ(read.points[i].y, points[i].y) << text;
  }
}

TEST(UntidyText, UnitsInHeadersAreTakenAndTold) {
  struct Case {
    const char* header;
    double x, y;  // metres of 10 and 2
  };
  for (const Case& one : {Case{"x_ft,z_ft", 3.048, 0.6096},
                          {"x_km,z_km", 10000, 2000},
                          {"x (km),z (km)", 10000, 2000},
                          {"x [ft],depth [ft]", 3.048, -0.6096},
                          {"X(FT),Elev(FT)", 3.048, 0.6096},
                          {"Dist. (km),Prof. (km)", 10000, -2000},
                          {"x em quil\xC3\xB4metros,cota em quil\xC3\xB4metros", 10000, 2000},
                          {"x p\xC3\xA9s,z p\xC3\xA9s", 3.048, 0.6096},
                          {"x_cm,z_cm", 0.1, 0.02}}) {
    const Untidy read = untidy(std::string(one.header) + "\n10,2\n20,2\n");
    expect_points(read, {{one.x, one.y}, {2 * one.x, one.y}}, one.header);
    EXPECT_THAT(read.remarks, Contains(HasSubstr("unit"))) << one.header;
  }
}

TEST(UntidyText, TheKindIsReadUnderEitherOfItsHeaders) {
  for (const std::string header : {"kind", "tipo", "Tipo"}) {
    const auto read = parse_any_lines(
        "horizonte;x;z;" + header + "\nA;0;1;horizonte\nA;2;1;horizonte\nF;1;0;falha\nF;1;3;falha\n", "f.csv", {});
    ASSERT_TRUE(read.ok()) << header << ": " << base::to_string(read.error());
    ASSERT_EQ(read->features.size(), 2u) << header;
    EXPECT_EQ(read->features[0].kind, "horizon") << header;
    EXPECT_EQ(read->features[1].kind, "fault") << header;
  }
  const auto other = parse_any_lines("horizonte;x;z;tipos\nA;0;1;falha\nA;2;1;falha\n", "f.csv", {});
  ASSERT_TRUE(other.ok());
  EXPECT_EQ(other->features[0].kind, "");
}

TEST(UntidyText, MetresAndUnknownSuffixesAreNoNews) {
  for (const char* const header : {"x_m,elev_m", "x (m),z (m)", "x_old,z_new", "x (a),z (b)", "x_1,z_1", "x_m2,z_m2"}) {
    const Untidy read = untidy(std::string(header) + "\n10,2\n20,2\n");
    expect_points(read, {{10, 2}, {20, 2}}, header);
    EXPECT_THAT(read.remarks, Not(Contains(HasSubstr("unit")))) << header;
  }
  // Metres that the header states go before the unit of a scenario that does not speak of files.
  LineOptions kilometres;
  kilometres.silent_unit = 1000.0;
  expect_points(untidy("x_m,z_m\n10,2\n20,2\n", kilometres), {{10, 2}, {20, 2}}, "x_m");
}

TEST(UntidyText, UnitsThatDifferAreConvertedEachAndTold) {
  const Untidy read = untidy("x_km,depth_m\n1,250\n2,300\n");
  expect_points(read, {{1000, -250}, {2000, -300}}, "km, m");
  EXPECT_THAT(read.remarks, Contains(AllOf(HasSubstr("'x_km'"), HasSubstr("'depth_m'"), HasSubstr("km"))));
  // One unit for both goes against what the headers say.
  LineOptions one;
  one.unit = 1000.0;
  EXPECT_THAT(untidy("x_km,depth_m\n1,250\n2,300\n", one).error,
              AllOf(HasSubstr("f.csv:1"), HasSubstr("'x_km'"), HasSubstr("'depth_m'")));
  one.unit.reset();
  one.unit_wanted = UnitWanted::OfTheFile;
  EXPECT_THAT(untidy("x_km,depth_m\n1,250\n2,300\n", one).error, HasSubstr("'depth_m'"));
}

TEST(UntidyText, AUnitOfOneColumnAloneIsAskedAbout) {
  const std::string text = "x,z_ft\n10,2\n20,2\n";
  EXPECT_THAT(untidy(text).error, AllOf(HasSubstr("'z_ft'"), HasSubstr("'x'"), HasSubstr("--unit")));
  LineOptions feet;
  feet.unit = 0.3048;
  expect_points(untidy(text, feet), {{3.048, 0.6096}, {6.096, 0.6096}}, text);
  // Metres are the rule for what says nothing.
  expect_points(untidy("x,depth_m\n10,2\n20,2\n"), {{10, -2}, {20, -2}}, "depth_m");
}

TEST(UntidyText, AUnitThatIsAskedForGoesBeforeTheHeaderAndIsTold) {
  LineOptions metres;
  metres.unit = 1.0;
  const Untidy read = untidy("x_ft,z_ft\n10,2\n20,2\n", metres);
  expect_points(read, {{10, 2}, {20, 2}}, "x_ft");
  EXPECT_THAT(read.remarks, Contains(AllOf(HasSubstr("0.3048"), HasSubstr("as asked for"))));
}

TEST(UntidyText, TimesAndDegreesAreRefusedWithTheReason) {
  for (const char* const header : {"x,TWT_ms", "x,TWT", "x (m),TWT (s)", "x,time", "x,z_ms", "x,tempo (ms)", "x,z [s]"})
    EXPECT_THAT(untidy(std::string(header) + "\n10,250\n20,300\n").error,
                AllOf(HasSubstr("f.csv:1"), HasSubstr("time"), HasSubstr("depth"), Not(HasSubstr("--unit"))))
        << header;
  for (const char* const header : {"lon,lat", "x (deg),z", "longitude,elev", "x (graus),z (m)"})
    EXPECT_THAT(untidy(std::string(header) + "\n10,250\n20,300\n").error,
                AllOf(HasSubstr("f.csv:1"), HasSubstr("degrees")))
        << header;
  // A column that is asked for is no less a time.
  LineOptions chosen;
  chosen.text.columns = {"1", "3"};
  EXPECT_THAT(untidy("x,z,TWT_ms\n10,5,250\n20,5,300\n", chosen).error, HasSubstr("'TWT_ms'"));
  chosen.text.columns = {"1", "2"};
  expect_points(untidy("x,z,TWT_ms\n10,5,250\n20,5,300\n", chosen), {{10, 5}, {20, 5}}, "x,z,TWT_ms");
}

TEST(UntidyText, ARowOfUnitsBelowTheHeaderIsRead) {
  const Untidy read = untidy("x;z;name\nkm;km;-\n1;0,5;A\n2;0,5;A\n");
  expect_points(read, {{1000, 500}, {2000, 500}}, "km;km");
  expect_points(untidy("x,z,name\n(m),(m),\n1,5,A\n2,5,A\n"), {{1, 5}, {2, 5}}, "(m)");
  expect_points(untidy("x z\nft ft\n10 2\n20 2\n"), {{3.048, 0.6096}, {6.096, 0.6096}}, "ft ft");
  EXPECT_THAT(untidy("x,z\nm,ms\n10,250\n20,300\n").error, HasSubstr("time"));
  // Units between blanks behind their headers are no columns.
  expect_points(untidy("x (ft) depth (ft)\n10 2\n20 2\n"), {{3.048, -0.6096}, {6.096, -0.6096}}, "blanks");
}

TEST(UntidyText, DecimalCommasAreReadWhereNothingElseCanBeMeant) {
  const std::vector<Point> points{{12.5, 3.25}, {1250, -4}, {1300.125, 0.5}};
  for (const std::string& sign : std::vector<std::string>{";", "\t", " ", "   ", " ; ", "; "}) {
    for (const std::string& header : {std::string(), "x" + sign + "z\n"}) {
      const std::string text = header + "12,5" + sign + "3,25\n1250" + sign + "-4\n1300,125" + sign + "0,5\n";
      const Untidy read = untidy(text);
      expect_points(read, points, text);
      EXPECT_THAT(read.remarks, Contains(AllOf(HasSubstr("f.csv"), HasSubstr("decimal commas")))) << text;
    }
  }
  expect_points(untidy("\"12,5\",\"3,25\"\n\"1250\",\"-4\"\n"), {{12.5, 3.25}, {1250, -4}}, "quotes");
  expect_points(untidy("1,5E3;2,5e-1\n0;1\n"), {{1500, 0.25}, {0, 1}}, "exponents");
}

TEST(UntidyText, MarksOfThousandsAreLeftOutWhereNothingElseCanBeMeant) {
  const std::vector<Point> points{{1234.5, 10}, {21234.5, 1000000}};
  for (const char* const text :
       {"1,234.5 10\n21,234.5 1,000,000\n", "\"1,234.5\",10\n\"21,234.5\",\"1,000,000\"\n",
        "1.234,5;10\n21.234,5;1.000.000\n", "1 234,5;10\n21 234,5;1 000 000\n", "1 234.5;10\n21 234.5;1 000 000\n",
        "1\xC2\xA0"
        "234,5 10\n21\xC2\xA0"
        "234,5 1\xC2\xA0"
        "000\xC2\xA0"
        "000\n",
        "1\xE2\x80\xAF"
        "234,5\t10\n21\xE2\x80\xAF"
        "234,5\t1000000\n"})
    expect_points(untidy(text), points, text);
  // Points are decimals elsewhere in the file, so that the comma cannot be.
  expect_points(untidy("1,234 567.8\n2,345 9\n"), {{1234, 567.8}, {2345, 9}}, "1,234 567.8");
}

TEST(UntidyText, NumbersThatMayBeTwoThingsAreRefusedWithThePlace) {
  for (const char* const text : {"1,234 5,678\n2,345 6,789\n", "1;2\n1,234;3\n", "\"1,234\",5\n7,8\n"}) {
    EXPECT_THAT(untidy(text).error,
                AllOf(HasSubstr("f.csv:"), HasSubstr("'1,234'"), HasSubstr("1.234"), HasSubstr("1234")))
        << text;
  }
  // Decimal commas and decimal points in one file; a point that may be either beside decimal commas.
  EXPECT_THAT(untidy("12,5;3\n13.5;4\n").error,
              AllOf(HasSubstr("f.csv:2:1"), HasSubstr("'13.5'"), HasSubstr("'12,5'")));
  EXPECT_THAT(untidy("12,5;3\n1.234;4\n").error, AllOf(HasSubstr("f.csv:2:1"), HasSubstr("'1.234'")));
  // Commas that part the columns and are the decimal sign, too.
  EXPECT_THAT(untidy("x,z\n12,5,3,25\n13,5,4,25\n").error, AllOf(HasSubstr("f.csv:2"), HasSubstr("decimal")));
  EXPECT_THAT(untidy("12,5,3,25\n13,5,4,25\n").error, HasSubstr("4 columns"));
}

TEST(UntidyText, PointsAloneAreDecimalAsEver) {
  const Untidy read = untidy("1.234,5.678\n2.345,6.789\n");
  expect_points(read, {{1.234, 5.678}, {2.345, 6.789}}, "points");
  EXPECT_THAT(read.remarks, IsEmpty());
  expect_points(untidy("1,234\n5,678\n"), {{1, 234}, {5, 678}}, "columns");
}

TEST(UntidyText, ValuesThatStandForNoneAreRefused) {
  for (const char* const none : {"-999.25", "-999.2500", "1e30", "1.0E+30", "-1e30", "-9999", "-99999", "9999900"}) {
    const std::string text = "0 -10\n5 -12\n10 " + std::string(none) + "\n15 -11\n";
    EXPECT_THAT(untidy(text).error, AllOf(HasSubstr("f.csv:3:4"), HasSubstr("no value"), HasSubstr(none))) << text;
  }
  EXPECT_THAT(untidy("0 -10\n1e30 -12\n10 -11\n").error, HasSubstr("f.csv:2:1"));
  // Among others that are as deep it is a depth.
  expect_points(untidy("0 -800\n5 -999.25\n10 -1100\n"), {{0, -800}, {5, -999.25}, {10, -1100}}, "-999.25");
  expect_points(untidy("0 -9000\n5 -9999\n10 -10400\n"), {{0, -9000}, {5, -9999}, {10, -10400}}, "-9999");
  EXPECT_THAT(untidy("0 5\n5 NaN\n9 6\n").error, AllOf(HasSubstr("f.csv:2:3"), HasSubstr("NaN")));
}

TEST(UntidyText, SeparatorsAtTheEndEmptyColumnsAndCommentsSayNothing) {
  const std::vector<Point> points{{0, 5}, {10, 6}};
  for (const char* const text :
       {"x;z;\n0;5;\n10;6;\n", "0,5,,\n10,6,,\n", "0\t5\t\t\n10\t6\t\t\n", "x,,z\n0,,5\n10,,6\n",
        "\xEF\xBB\xBFx,z\r\n0,5\r\n# between\r\n10,6\r\n", "x;z\r0;5\r10;6\r", "Dist\xC3\xA2ncia;Cota\n0;5\n10;6\n"})
    expect_points(untidy(text), points, text);
  expect_points(untidy("dist\xC3\xA2ncia (m);profundidade (m)\n0;5\n10;6\n"), {{0, -5}, {10, -6}}, "profundidade");
}

TEST(UntidyText, SeparatorsThatChangeAndDegreesMinutesSecondsAreRefusedWithThePlace) {
  EXPECT_THAT(untidy("0;5\n10,6\n20;7\n").error, AllOf(HasSubstr("f.csv:2"), HasSubstr("';'")));
  EXPECT_THAT(untidy("0\t5\n10;6\n20\t7\n").error, HasSubstr("f.csv:2"));
  EXPECT_THAT(untidy("x,z\n48\xC2\xB0"
                     "51'30\",2\n48\xC2\xB0"
                     "52'30\",3\n")
                  .error,
              HasSubstr("f.csv:2"));
  EXPECT_THAT(untidy("48 51 30 2\n48 52 30 3\n").error, HasSubstr("4 columns"));
}

}  // namespace
}  // namespace dobra::io::formats
