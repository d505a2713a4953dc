#include "shared/io/gis/geojson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "shared/io/file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::gis {
namespace {

using base::ErrorCode;
using geom::Polyline;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string feature(const std::string& geometry, const std::string& properties = "{}") {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" + geometry + "}";
}

TEST(Geojson, LinesPolygonsAndPointsAreReadWithTheirProperties) {
  const auto read = parse_geojson(
      collection(
          feature(R"({"type":"LineString","coordinates":[[0,1.5],[1e3,-2]]})",
                  R"({"name":"top","kind":"horizon","age":12,"dip":1.25,"sure":true,"note":"2020-01-01"})") +
          "," +
          feature(R"({"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,2],[3,3]]]})",
                  R"({"name":"F1","kind":"fault"})") +
          "," +
          feature(R"({"type":"Polygon","coordinates":[[[0,0],[0,9],[9,9],[9,0],[0,0]],[[1,1],[2,1],[2,2],[1,1]]]})") +
          "," + feature(R"({"type":"Point","coordinates":[7,8]})")),
      "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->features.size(), 4U);
  const lines::Feature& top = read->features[0];
  EXPECT_EQ(top.name, "top");
  EXPECT_EQ(top.kind, "horizon");
  EXPECT_EQ(top.parts, (std::vector<Polyline>{{{{0, 1.5}, {1000, -2}}, false}}));
  EXPECT_THAT(top.properties,
              ElementsAre(std::pair<std::string, lines::PropertyValue>{"age", std::int64_t{12}},
                          std::pair<std::string, lines::PropertyValue>{"dip", 1.25},
                          std::pair<std::string, lines::PropertyValue>{"sure", true},
                          std::pair<std::string, lines::PropertyValue>{"note", std::string("2020-01-01")}));
  EXPECT_EQ(read->features[1].parts.size(), 2U);
  EXPECT_EQ(geom::signed_area(read->features[2].parts[0]), 81.0);
  EXPECT_EQ(geom::signed_area(read->features[2].parts[1]), -0.5);
  EXPECT_EQ(read->features[3].type, lines::FeatureType::Points);
  EXPECT_TRUE(read->remarks.empty());
}

TEST(Geojson, BareGeometriesAndSingleFeaturesAreRead) {
  const std::string line = R"({"type":"LineString","coordinates":[[0,0],[1,1]]})";
  EXPECT_EQ(parse_geojson(line, "f")->features.size(), 1U);
  EXPECT_EQ(parse_geojson("\xEF\xBB\xBF" + feature(line), "f")->features.size(), 1U);
}

TEST(Geojson, WhatIsDroppedIsSaid) {
  const auto read = parse_geojson(
      collection(feature(R"({"type":"LineString","coordinates":[[0,0,3],[1,1,4],[1,1,4]]})", R"({"name":"a"})") + "," +
                 feature("null")),
      "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->features.size(), 1U);
  EXPECT_THAT(read->remarks,
              ElementsAre("f: feature 1 'a': third coordinates dropped", "f: feature 1 'a': 1 repeated point dropped",
                          "f: feature 2: no geometry, left out"));
}

TEST(Geojson, BadTextIsRefusedWithItsPlace) {
  const std::string line = R"({"type":"LineString","coordinates":[[0,0],[1,1]]})";
  const std::tuple<std::string, ErrorCode, std::string, std::string> cases[] = {
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"{\"type\":\"FeatureCollection\",\n \"features\":[\n  oops]}", ErrorCode::BadFormat, "f:3:3",
       "not valid JSON at"},
      {collection(feature(line)).substr(0, 60), ErrorCode::BadFormat, "f:1:61", "cut short"},
      {feature(R"({"type":"LineString","coordinates":[[0,NaN],[1,1]]})"), ErrorCode::BadFormat, "f:1:85",
       "not valid JSON"},
      {feature(R"({"type":"LineString","coordinates":[[0,1e999],[1,1]]})"), ErrorCode::BadFormat, "f:1:85",
       "not valid JSON"},
      {"[1,2,3]", ErrorCode::BadFormat, "f:0:0", "not GeoJSON"},
      {R"({"a":1})", ErrorCode::BadFormat, "f:0:0", "not GeoJSON"},
      {collection(feature(line) + "," + feature(R"({"type":"LineString","coordinates":[[0,0],["a",1]]})")),
       ErrorCode::BadFormat, "f:0:0", "GeoJSON"},
      {collection(feature(line) + "," +
                  feature(R"({"type":"LineString","coordinates":[[0,0],[0,0]]})", R"({"name":"b"})")),
       ErrorCode::DegenerateCurve, "f:0:0", "at least 2 distinct points"},
      {feature(R"({"type":"GeometryCollection","geometries":[)" + line + "," +
               R"({"type":"GeometryCollection","geometries":[]})" + "]}"),
       ErrorCode::BadFormat, "f:0:0", "GEOMETRYCOLLECTION is not read"},
      {std::string("{\"a\":\0}", 7), ErrorCode::BadFormat, "f:1:6", "binary"},
  };
  for (const auto& [text, code, place, says] : cases) {
    testing::internal::CaptureStderr();
    const auto read = parse_geojson(text, "f");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << text;
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, code) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(Geojson, AnErrorNamesNoFileThatTheUserDoesNotKnow) {
  for (const char* const text : {R"({"a":1})", R"({"type":"Topology"})", R"({"type":"FeatureCollection"})", "{}"}) {
    const auto read = parse_geojson(text, "f.geojson");
    if (read.ok()) continue;
    EXPECT_THAT(base::to_string(read.error()), testing::Not(HasSubstr("vsimem"))) << text;
  }
  EXPECT_THAT(base::to_string(parse_geojson(R"({"a":1})", "f.geojson").error()), HasSubstr("(the file not recognized"));
}

TEST(Geojson, AnErrorNamesTheFeature) {
  const auto read = parse_geojson(
      collection(feature(R"({"type":"LineString","coordinates":[[3,4],[3,4]]})", R"({"name":"b"})")), "f");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(base::to_string(read.error()),
            "f: feature 1 'b': a line needs at least 2 distinct points and has 1 (at 3, 4)");
}

std::vector<lines::Feature> random_features() {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<lines::Feature> features;
  for (int i = 0; i < 30; ++i) {
    lines::Feature f{.type = lines::FeatureType::Lines,
                     .parts = {},
                     .name = "línea \"" + std::to_string(i) + "\"\n",
                     .kind = "horizon"};
    f.properties = {
        {"n", std::int64_t{i}}, {"value", uniform(random)}, {"ok", i % 2 == 0}, {"text", std::string("a\\b")}};
    for (int part = 0; part < 1 + i % 3; ++part) {
      Polyline line;
      for (int k = 0; k < 2 + i; ++k) {
        line.points.push_back(
            {1e4 * uniform(random), std::ldexp(uniform(random), static_cast<int>(random() % 200) - 100)});
      }
      f.parts.push_back(line);
    }
    features.push_back(f);
  }
  features.push_back({.type = lines::FeatureType::Polygons,
                      .parts = {{{{0, 0}, {9, 0}, {9, 9}}, true},
                                {{{5, 1}, {6, 2}, {6, 1}}, true},
                                {{{20, 0}, {21, 0}, {20, 1}}, true}},
                      .name = "p",
                      .kind = ""});
  features.push_back({.type = lines::FeatureType::Points, .parts = {{{{0.1, 0.2}}, false}}, .name = "q", .kind = ""});
  features.push_back(
      {.type = lines::FeatureType::Points, .parts = {{{{0.1, 0.2}, {1, 2}}, false}}, .name = "r", .kind = ""});
  return features;
}

TEST(Geojson, WhatIsWrittenReadsBackToTheSameBitsAndBytes) {
  const std::vector<lines::Feature> features = random_features();
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_geojson(folder.file("a.geojson"), features).ok());
  const auto read = read_geojson(folder.file("a.geojson"));
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->features.size(), features.size());
  for (std::size_t i = 0; i < features.size(); ++i) EXPECT_EQ(read->features[i], features[i]) << i;
  EXPECT_EQ(*geojson(read->features), *read_text(folder.file("a.geojson")));
  EXPECT_TRUE(read->remarks.empty());
}

TEST(Geojson, NumbersThatAreNotFiniteAreNotWritten) {
  lines::Feature bad{.type = lines::FeatureType::Lines, .parts = {{{{0, 0}, {1, 1}}, false}}, .name = "a", .kind = ""};
  bad.properties = {{"v", std::nan("")}};
  EXPECT_EQ(geojson({&bad, 1}).error().code, ErrorCode::NotFinite);
  bad.properties.clear();
  bad.parts[0].points[1].x = INFINITY;
  EXPECT_EQ(geojson({&bad, 1}).error().code, ErrorCode::NotFinite);
}

TEST(Geojson, ThreadsReadAtTheSameTime) {
  const std::string text = *geojson(random_features());
  std::vector<std::size_t> counts(4);
  std::vector<std::thread> threads;
  for (std::size_t& count : counts) {
    threads.emplace_back([&] {
      for (int i = 0; i < 5; ++i) {
        const auto read = parse_geojson(text, "f");
        const auto bad = parse_geojson("[1]", "f");
        count += (read.ok() ? read->features.size() : 0) + (bad.ok() ? 1000 : 0);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(counts, ElementsAre(165, 165, 165, 165));
}

}  // namespace
}  // namespace dobra::io::gis
