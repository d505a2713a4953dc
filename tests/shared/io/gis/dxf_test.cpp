#include "shared/io/gis/dxf.h"

#include <gtest/gtest.h>

#include <random>

#include "shared/io/drawings/dxf_paths.h"
#include "shared/io/file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::gis {
namespace {

using geom::Point;

/// "0 SECTION" as two lines.
std::string pair(int code, const std::string& value) { return std::to_string(code) + '\n' + value + '\n'; }

std::string drawing(const std::string& entities) {
  return pair(0, "SECTION") + pair(2, "ENTITIES") + entities + pair(0, "ENDSEC") + pair(0, "EOF");
}

std::string vertex(const std::string& x, const std::string& y, const std::string& more = "") {
  return pair(0, "VERTEX") + pair(8, "TOP") + pair(10, x) + pair(20, y) + more;
}

/// An R12 POLYLINE of three points.
std::string polyline(const std::string& layer, int flags, const std::string& more = "") {
  return pair(0, "POLYLINE") + pair(8, layer) + pair(66, "1") + pair(70, std::to_string(flags)) + vertex("0.5", "1e1") +
         vertex("10", "12.25") + vertex("20", "30") + more + pair(0, "SEQEND");
}

std::string lwpolyline(const std::string& layer, int flags) {
  return pair(0, "LWPOLYLINE") + pair(100, "AcDbEntity") + pair(8, layer) + pair(100, "AcDbPolyline") + pair(90, "4") +
         pair(70, std::to_string(flags)) + pair(10, "0") + pair(20, "0") + pair(10, "4") + pair(20, "0") +
         pair(10, "4") + pair(20, "3") + pair(10, "0") + pair(20, "3");
}

const std::string line_entity =
    pair(0, "LINE") + pair(8, "FAULT") + pair(10, "1") + pair(20, "2") + pair(11, "3") + pair(21, "-4");

using Properties = std::vector<std::pair<std::string, lines::PropertyValue>>;

lines::Features parsed(const std::string& text) {
  auto read = parse_dxf(text, "f");
  EXPECT_TRUE(read.ok()) << base::to_string(read.error());
  return read.ok() ? *read : lines::Features{};
}

std::string refusal(const std::string& text) {
  const auto read = parse_dxf(text, "f");
  return read.ok() ? "read" : base::to_string(read.error());
}

TEST(Dxf, APolylineOfR12IsALineInItsOrderNamedByItsLayer) {
  const lines::Features read = parsed(drawing(polyline("TOP", 0)));
  ASSERT_EQ(read.features.size(), 1U);
  EXPECT_EQ(read.features[0].type, lines::FeatureType::Lines);
  EXPECT_EQ(read.features[0].name, "TOP");
  EXPECT_EQ(read.features[0].kind, "horizon");  // the layer's name is the word of a kind
  EXPECT_EQ(read.features[0].properties, (Properties{{"layer", "TOP"}}));
  EXPECT_EQ(read.features[0].parts.at(0).points, (std::vector<Point>{{0.5, 10}, {10, 12.25}, {20, 30}}));
  EXPECT_FALSE(read.features[0].parts[0].closed);
  EXPECT_TRUE(read.remarks.empty()) << read.remarks[0];
}

TEST(Dxf, AnLwpolylineWithTheClosedFlagIsAPolygon) {
  const lines::Features read = parsed(drawing(lwpolyline("PLATE", 1)));
  ASSERT_EQ(read.features.size(), 1U);
  EXPECT_EQ(read.features[0].type, lines::FeatureType::Polygons);
  EXPECT_TRUE(read.features[0].parts.at(0).closed);
  EXPECT_EQ(read.features[0].parts[0].points.size(), 4U);
  EXPECT_EQ(geom::signed_area(read.features[0].parts[0]), 12.0);
  EXPECT_EQ(parsed(drawing(lwpolyline("PLATE", 0))).features.at(0).type, lines::FeatureType::Lines);
  EXPECT_EQ(parsed(drawing(polyline("TOP", 1))).features.at(0).type, lines::FeatureType::Polygons);
}

TEST(Dxf, FurtherLinesOfALayerAreNumberedAndLayerZeroNamesNothing) {
  const lines::Features read = parsed(drawing(line_entity + polyline("0", 0) + line_entity));
  ASSERT_EQ(read.features.size(), 3U);
  EXPECT_EQ(read.features[0].name, "FAULT");
  EXPECT_EQ(read.features[0].parts[0].points, (std::vector<Point>{{1, 2}, {3, -4}}));
  EXPECT_EQ(read.features[1].name + read.features[1].kind, "");
  EXPECT_EQ(read.features[2].name, "FAULT 2");
  EXPECT_EQ(read.features[2].kind, "fault");
  EXPECT_EQ(read.features[2].properties, (Properties{{"layer", "FAULT"}}));
  EXPECT_EQ(parsed(drawing(polyline("H4", 0))).features.at(0).kind, "");
}

TEST(Dxf, LineEndsOfWindowsAndPaddedCodesAreRead) {
  std::string text;
  for (const char c : drawing(line_entity)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(parsed(text).features.size(), 1U);
  EXPECT_EQ(
      parsed(
          "  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n  8\nA\n 10\n  1.0\n 20\n2\n 11\n3\n 21\n4\n  0\nENDSEC\n  0\nEOF\n")
          .features.size(),
      1U);
}

TEST(Dxf, LayersWithAccentsKeepTheirNamesWhateverTheCodePage) {
  const std::string body = drawing(polyline("Forma\xC3\xA7\xC3\xA3o", 0));
  const std::string header = pair(0, "SECTION") + pair(2, "HEADER") + pair(9, "$ACADVER") + pair(1, "AC1009") +
                             pair(9, "$DWGCODEPAGE") + pair(3, "ANSI_1252") + pair(0, "ENDSEC");
  EXPECT_EQ(parsed(header + body).features.at(0).name, "Forma\xC3\xA7\xC3\xA3o");
  EXPECT_EQ(parsed(body).features.at(0).name, "Forma\xC3\xA7\xC3\xA3o");
}

/// A drawing with a table of layers: ON, OFF (a negative colour), FROZEN, NEW (frozen in new views only).
std::string layered(const std::string& entities) {
  std::string layers;
  for (const auto& [name, flags, color] :
       {std::tuple("ON", "0", "7"), {"OFF", "0", "-7"}, {"FROZEN", "65", "7"}, {"NEW", "2", "7"}})
    layers += pair(0, "LAYER") + pair(2, name) + pair(70, flags) + pair(62, color) + pair(6, "CONTINUOUS");
  return pair(0, "SECTION") + pair(2, "TABLES") + pair(0, "TABLE") + pair(2, "LAYER") + pair(70, "4") + layers +
         pair(0, "ENDTAB") + pair(0, "ENDSEC") + drawing(entities);
}
std::string line_on(const std::string& layer, const std::string& more = "") {
  return pair(0, "LINE") + pair(8, layer) + more + pair(10, "1") + pair(20, "2") + pair(11, "3") + pair(21, "-4");
}
std::string circle_on(const std::string& layer, const std::string& more = "") {
  return pair(0, "CIRCLE") + pair(8, layer) + more + pair(10, "0") + pair(20, "0") + pair(40, "2");
}

TEST(Dxf, WhatIsNotDisplayedIsNotThereAndSaid) {
  const lines::Features read = parsed(layered(line_on("OFF") + line_on("ON") + line_on("FROZEN") + line_on("NEW") +
                                              line_on("ON", pair(60, "1")) + line_on("ON", pair(60, "0")) +
                                              polyline("OFF", 1) + circle_on("FROZEN")));
  std::vector<std::string> names;
  for (const lines::Feature& feature : read.features) names.push_back(feature.name);
  EXPECT_EQ(names, (std::vector<std::string>{"ON", "NEW", "ON 2"}));
  EXPECT_EQ(read.remarks, (std::vector<std::string>{"f: 2 not displayed left out, of layer 'FROZEN'",
                                                    "f: 2 not displayed left out, of layer 'OFF'",
                                                    "f: 1 not displayed left out, of layer 'ON'"}));
  EXPECT_EQ(parsed(layered(line_on("ON") + circle_on("NEW"))).remarks,
            (std::vector<std::string>{"f: 1 arcs or splines read as chords"}));
}

TEST(Dxf, BlocksOfAHiddenLayerAreNotThere) {
  const std::string block = pair(0, "SECTION") + pair(2, "BLOCKS") + pair(0, "BLOCK") + pair(8, "0") + pair(2, "B") +
                            pair(70, "0") + pair(10, "0") + pair(20, "0") + line_on("0") + pair(0, "ENDBLK") +
                            pair(0, "ENDSEC");
  const auto inserted = [&](const std::string& layer) {
    std::string text = layered(pair(0, "INSERT") + pair(8, layer) + pair(2, "B") + pair(10, "0") + pair(20, "0"));
    text.insert(text.find(pair(0, "SECTION") + pair(2, "ENTITIES")), block);
    return parsed(text).features.size();
  };
  EXPECT_EQ(inserted("ON"), 1U);
  EXPECT_EQ(inserted("OFF"), 0U);
}

TEST(Dxf, TrueCurvesAreThoseOfTheSameEntities) {
  const std::string text = layered(circle_on("OFF") + polyline("FROZEN", 1) + circle_on("ON") +
                                   circle_on("ON", pair(60, "1")) + circle_on("NEW"));
  const auto paths = drawings::dxf_paths(text, "f");
  ASSERT_TRUE(paths.has_value());
  const lines::Features read = parsed(text);
  ASSERT_EQ(paths->size(), read.features.size());
  for (std::size_t i = 0; i < paths->size(); ++i) EXPECT_EQ((*paths)[i].name, read.features[i].name);
}

TEST(Dxf, WhatIsDroppedIsSaid) {
  const std::string text_entity =
      pair(0, "TEXT") + pair(8, "A") + pair(10, "0") + pair(20, "0") + pair(40, "1") + pair(1, "label");
  const std::string circle = pair(0, "CIRCLE") + pair(8, "HOLE") + pair(10, "0") + pair(20, "0") + pair(40, "2");
  const std::string high = pair(0, "LINE") + pair(8, "B") + pair(10, "0") + pair(20, "0") + pair(30, "5") +
                           pair(11, "1") + pair(21, "0") + pair(31, "6");
  const lines::Features read = parsed(drawing(text_entity + circle + high + polyline("TOP", 0, vertex("20", "30"))));
  ASSERT_EQ(read.features.size(), 3U);
  std::string remarks;
  for (const std::string& remark : read.remarks) remarks += remark + '\n';
  EXPECT_NE(remarks.find("1 of type POINT left out"), std::string::npos) << remarks;
  EXPECT_NE(remarks.find("1 arcs or splines read as chords"), std::string::npos) << remarks;
  EXPECT_NE(remarks.find("'B': third coordinates dropped"), std::string::npos) << remarks;
  EXPECT_NE(remarks.find("'TOP': 1 repeated point dropped"), std::string::npos) << remarks;
  // Chords of a circle of radius 2: a little less than its area.
  EXPECT_NEAR(geom::signed_area(read.features[0].parts[0]), 12.566, 0.05);
}

TEST(Dxf, BadInputIsRefusedWithItsLine) {
  EXPECT_NE(refusal("").find("f: "), std::string::npos);
  EXPECT_NE(refusal("hello\nworld\n").find("f:1: 'hello' is not a group code"), std::string::npos)
      << refusal("hello\nworld\n");
  EXPECT_NE(refusal(pair(0, "LINE")).find("f:2: not DXF"), std::string::npos);
  EXPECT_NE(refusal(drawing(pair(0, "LINE") + pair(10, "abc"))).find("f:8: group 10: "), std::string::npos);
  EXPECT_NE(refusal(drawing(pair(0, "LINE") + pair(10, "1,5"))).find("1,5"), std::string::npos);
  EXPECT_EQ(parse_dxf(drawing(pair(0, "LINE") + pair(10, "nan")), "f").error().code, base::ErrorCode::NotFinite);
  EXPECT_NE(refusal(pair(0, "SECTION") + pair(2, "HEADER") + pair(0, "ENDSEC") + pair(0, "EOF")).find("ENTITIES"),
            std::string::npos);
  EXPECT_NE(refusal(std::string("AutoCAD Binary DXF\r\n\x1a\0\0\0", 25)).find("f:"), std::string::npos);
  const auto flat = parse_dxf(
      drawing(pair(0, "LINE") + pair(8, "A") + pair(10, "1") + pair(20, "2") + pair(11, "1") + pair(21, "2")), "f");
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(flat.error().place.value().item, "entity 1 'A'");
}

TEST(Dxf, AFileCutShortAnywhereIsRefused) {
  const std::string whole = drawing(polyline("TOP", 0) + lwpolyline("PLATE", 1) + line_entity);
  // Only the last line end may be missing.
  EXPECT_EQ(refusal(whole.substr(0, whole.size() - 1)), "read");
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    const auto read = parse_dxf(whole.substr(0, length), "f");
    ASSERT_FALSE(read.ok()) << length;
    EXPECT_EQ(base::exit_code(read.error().code), 3) << length;
    EXPECT_EQ(read.error().place.value().file, "f");
  }
}

TEST(Dxf, DamagedFilesGiveAValueOrAnErrorOfOneLine) {
  const std::string whole = drawing(polyline("TOP", 0) + lwpolyline("PLATE", 1) + line_entity);
  std::mt19937_64 random(20241);
  std::size_t refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = whole;
    for (std::uint64_t hits = 1 + random() % 3; hits > 0; --hits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0)
        text[at] = static_cast<char>(random() % 256);
      else
        text.erase(at, random() % 20);
    }
    const auto read = parse_dxf(text, "f");
    if (read.ok()) continue;
    ++refused;
    EXPECT_EQ(base::exit_code(read.error().code), 3) << base::to_string(read.error());
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos) << read.error().message;
    ASSERT_TRUE(read.error().place.has_value());
    EXPECT_EQ(read.error().place->file, "f");
  }
  EXPECT_GT(refused, 200U);
}

TEST(Dxf, FilesAreReadWholeAndNamedInErrors) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_dxf(folder.file("none.dxf")).error().code, base::ErrorCode::FileNotFound);
  EXPECT_EQ(read_dxf(folder.path()).error().code, base::ErrorCode::NotAFile);
  ASSERT_TRUE(write_file(folder.file("a.dxf"), drawing(line_entity)).ok());
  EXPECT_EQ(read_dxf(folder.file("a.dxf"))->features.size(), 1U);
}

}  // namespace
}  // namespace dobra::io::gis
