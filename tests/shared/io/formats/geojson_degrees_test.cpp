// GeoJSON in longitudes and latitudes is no section.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/io/formats/line_files.h"

namespace dobra::io::formats {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string geojson_of(const std::string& crs, const std::string& points) {
  return R"({"type":"FeatureCollection",)" + (crs.empty() ? "" : R"("crs":)" + crs + ",") +
         R"("features":[{"type":"Feature","properties":{"name":"A"},"geometry":{"type":"LineString","coordinates":)" +
         points + "}}]}";
}

std::string crs_of(const std::string& name) { return R"({"type":"name","properties":{"name":")" + name + R"("}})"; }

std::string geojson_refusal(const std::string& text, const LineOptions& options = {}) {
  const auto read = parse_any_lines(text, "f.geojson", options);
  return read.ok() ? "read" : base::to_string(read.error());
}

TEST(GeoJsonInDegrees, AStatedSystemInDegreesIsRefused) {
  for (const char* const name : {"EPSG:4326", "urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326",
                                 "EPSG:4674", "urn:ogc:def:crs:EPSG::4618"}) {
    for (const char* const points :
         {"[[-43.1,-22.9],[-43.2,-22.8]]", "[[-43.1,-22.9,100],[-43.2,-22.8,50]]", "[[0,0],[10,5]]"}) {
      const std::string text = geojson_of(crs_of(name), points);
      EXPECT_THAT(geojson_refusal(text), AllOf(HasSubstr("f.geojson: the coordinates are in degrees ("),
                                               HasSubstr("project the file"), HasSubstr("--coordinates section")));
      EXPECT_EQ(geojson_refusal(text, {.coordinates = Coordinates::Section}), "read");
    }
  }
  for (const std::string& crs : {std::string("null"), crs_of("local"), crs_of("my mine grid")})
    EXPECT_EQ(geojson_refusal(geojson_of(crs, "[[0,0],[10,5]]")), "read") << crs;
  EXPECT_EQ(geojson_refusal(geojson_of(crs_of("EPSG:31983"), "[[-43.1,-22.9],[-43.2,-22.8]]")), "read");
  const auto feet = parse_any_lines(geojson_of(crs_of("EPSG:2225"), "[[1000,0],[2000,100]]"), "f.geojson", {});
  ASSERT_TRUE(feet.ok());
  EXPECT_NEAR(feet->features[0].parts[0].points[1].x, 2000.0 * 1200.0 / 3937.0, 1e-9);
}

TEST(GeoJsonInDegrees, WithoutASystemTheCoordinatesAreAskedAboutWhereTheyLookLikeDegrees) {
  for (const char* const points : {"[[-43.1,-22.9],[-43.2,-22.8]]", "[[151.2,-33.8],[151.3,-33.7],[151.25,-33.6]]",
                                   "[[-43.1,-22.9,100],[-43.2,-22.8,50]]", "[[-105.1,39.9],[-105.4,40.2]]"}) {
    EXPECT_THAT(geojson_refusal(geojson_of("", points)),
                AllOf(HasSubstr("degrees"), HasSubstr("--coordinates section")))
        << points;
    EXPECT_EQ(geojson_refusal(geojson_of("", points), {.coordinates = Coordinates::Section}), "read");
    EXPECT_EQ(geojson_refusal(geojson_of("null", points)), "read") << points;  // null: none can be assumed
  }
  for (const char* const points :
       {"[[0,0],[10,5]]", "[[-2,1],[3,1.5]]", "[[10,10],[11,11]]", "[[100,50],[101,50]]",
        "[[640000,-800],[641000,-750]]", "[[20,-80],[45,-79]]", "[[200.1,50.1],[200.2,50.2]]"}) {
    EXPECT_EQ(geojson_refusal(geojson_of("", points)), "read") << points;
  }
}

}  // namespace
}  // namespace dobra::io::formats
