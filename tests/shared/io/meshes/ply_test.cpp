#include "shared/io/meshes/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace dobra::io::meshes {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The bytes of values one after another, as this machine has them or turned.
struct Bytes {
  bool big = false;
  std::string text = {};
  template <class T>
  Bytes& operator<<(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
    return *this;
  }
};

/// Two triangles, a quadrilateral and much that is passed over: colours, a list of vertices, of faces, edges.
std::string header(const std::string& format, const std::string& end = "\n") {
  std::string made;
  for (const std::string& line :
       {std::string("ply"), "format " + format + " 1.0", std::string("comment end_header comes later"),
        std::string("element vertex 5"), std::string("property uchar red"), std::string("property float y"),
        std::string("property list uchar short marks"), std::string("property double x"),
        std::string("property int16 z"), std::string("element edge 2"), std::string("property int a"),
        std::string("property uint8 b"), std::string("element face 3"),
        std::string("property list uint8 float texcoord"), std::string("property list int uint vertex_indices"),
        std::string("property char flag"), std::string("end_header")})
    made += line + end;
  return made;
}

std::string body(bool big, float y = 0.1F) {
  using U8 = std::uint8_t;
  using I16 = std::int16_t;
  Bytes b{big};
  for (int i = 0; i < 5; ++i) {
    b << U8(10) << (i == 3 ? y : 0.5F * float(i)) << U8(i % 3);
    for (int k = 0; k < i % 3; ++k) b << I16(k);
    b << double(i) / 3.0 << I16(-300 * i);
  }
  b << 1 << U8(2) << 3 << U8(4);
  const std::vector<std::vector<std::uint32_t>> faces{{0, 1, 2}, {1, 2, 3, 4}, {4, 0, 1}};
  for (const auto& face : faces) {
    b << U8(2) << 0.5F << 0.25F << std::int32_t(face.size());
    for (const std::uint32_t c : face) b << c;
    b << std::int8_t(-1);
  }
  return b.text;
}

std::string said(const base::Result<mesh::PolygonMesh>& read) { return read.ok() ? "" : base::to_string(read.error()); }

TEST(PlyFile, BinaryOfEitherByteOrderIsTheTextOfTheSameNumbers) {
  std::string text = header("ascii");
  for (int i = 0; i < 5; ++i) {
    text += "10 " + std::to_string(i == 3 ? 0.0 : 0.5 * i) + " " + std::to_string(i % 3);
    for (int k = 0; k < i % 3; ++k) text += " " + std::to_string(k);
    text += " 0.5 " + std::to_string(-300 * i) + "\n";
  }
  text += "1 2\n3 4\n2 .5 .25 3 0 1 2 -1\n2 .5 .25 4 1 2 3 4 -1\n2 .5 .25 3 4 0 1 -1\n";
  const auto of_text = parse_ply(text, "t.ply");
  ASSERT_TRUE(of_text.ok()) << said(of_text);
  EXPECT_EQ(of_text->points[4], (geom::Point3{0.5, 2.0, -1200}));
  for (const bool big : {false, true}) {
    for (const char* const end : {"\n", "\r\n", "\r"}) {
      const std::string head = header(big ? "binary_big_endian" : "binary_little_endian", end);
      const auto read = parse_ply(head + body(big), "b.ply");
      ASSERT_TRUE(read.ok()) << said(read);
      ASSERT_EQ(read->points.size(), 5U);
      for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(read->points[i].x, double(i) / 3.0);
        EXPECT_EQ(read->points[i].z, -300.0 * double(i));
      }
      EXPECT_EQ(read->points[3].y, double{0.1F});
      EXPECT_EQ(read->points[4].y, 2.0);
      EXPECT_EQ(read->faces, of_text->faces);
      EXPECT_THAT(read->faces[1], ElementsAre(1, 2, 3, 4));
    }
  }
}

TEST(PlyFile, ABodyThatBeginsAsALineEndsIsReadWhole) {
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar n\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  for (const std::uint8_t first : {std::uint8_t('\n'), std::uint8_t('\r'), std::uint8_t(0)}) {
    const auto read = parse_ply(head + (Bytes{} << first << 1.0F << 2.0F << 3.0F).text, "b.ply");
    ASSERT_TRUE(read.ok()) << said(read);
    EXPECT_EQ(read->points[0], (geom::Point3{1, 2, 3}));
  }
}

TEST(PlyFile, CutAnywhereItIsRefused) {
  const std::string whole = header("binary_big_endian") + body(true);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read = parse_ply(whole.substr(0, size), "b.ply");
    ASSERT_FALSE(read.ok()) << size;
    EXPECT_THAT(said(read), HasSubstr("b.ply")) << size;
  }
  EXPECT_THAT(said(parse_ply(whole.substr(0, whole.size() - 1), "b.ply")),
              HasSubstr("face 3 of 3: the file ends here"));
  EXPECT_THAT(said(parse_ply(whole + "x", "b.ply")), HasSubstr("counts 5 points and 3 faces"));
}

TEST(PlyFile, AnyByteChangedIsReadOrRefusedInWords) {
  const std::string whole = header("binary_little_endian") + body(false);
  std::size_t refusals = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char value : {'\0', '\n', '9', '\x7f', '\xff'}) {
      std::string changed = whole;
      changed[at] = value;
      const auto read = parse_ply(changed, "b.ply");
      if (read.ok()) continue;
      EXPECT_THAT(said(read), HasSubstr("b.ply")) << at;
      ++refusals;
    }
  }
  EXPECT_GT(refusals, whole.size());
}

TEST(PlyFile, WhatIsWrongNamesItsRecordOrLine) {
  const std::string head = header("binary_little_endian");
  EXPECT_THAT(said(parse_ply(head + body(false, std::numeric_limits<float>::quiet_NaN()), "b.ply")),
              HasSubstr("vertex 4 of 5: y is not a finite number"));
  EXPECT_FALSE(parse_ply(head + body(true), "b.ply").ok()) << "the other byte order";
  const auto one = [](const std::string& format, const std::string& vertex, const std::string& face,
                      const std::string& rest = "") {
    return parse_ply("ply\nformat " + format + " 1.0\nelement vertex 1\n" + vertex + "element face 1\n" + face +
                         "end_header\n" + rest,
                     "f.ply");
  };
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string corners = "property list uchar int vertex_index\n";
  const std::string little = "binary_little_endian";
  const auto point = [] { return Bytes{} << 0.0F << 0.0F << 0.0F; };
  EXPECT_EQ(said(one(little, xyz, corners, (point() << std::uint8_t(1) << 0).text)), "");
  EXPECT_THAT(said(one(little, xyz, corners, (point() << std::uint8_t(1) << 7).text)),
              HasSubstr("face 1 of 1: there is no point 7"));
  EXPECT_THAT(said(one(little, xyz, corners, (point() << std::uint8_t(1) << -1).text)), HasSubstr("less than 0"));
  EXPECT_THAT(said(one("binary_middle_endian", xyz, corners)), HasSubstr("f.ply:2:8"));
  EXPECT_THAT(said(one("ascii", "property float x\nproperty float y\n", corners)), HasSubstr("no number z"));
  EXPECT_THAT(said(one("ascii", xyz, "property int a\n")), HasSubstr("no list of corners"));
  EXPECT_THAT(said(one("ascii", xyz, "property list uchar float vertex_index\n")), HasSubstr("f.ply:8:21"));
  EXPECT_THAT(said(one("ascii", xyz, "property list uchar float c\n")), HasSubstr("not whole numbers"));
  EXPECT_THAT(said(one("ascii", "property real x\n", corners)), HasSubstr("f.ply:4:10"));
  EXPECT_THAT(said(one("ascii", xyz, corners, "0 0 0\n3 0 0\n")),
              HasSubstr("f.ply:11:6: face 1 of 1 has 3 corners, and the line ends after 2"));
  EXPECT_THAT(said(one("ascii", xyz, corners, "0 0 0\n3 0 0 7\n")), HasSubstr("there is no point 7"));
  EXPECT_FALSE(one("ascii", xyz, corners, "0 0 0\n").ok());
  EXPECT_FALSE(one("ascii", xyz, corners, "0 0\n3 0 0 0\n").ok());
}

TEST(PlyFile, CountsBeyondTheFileNeitherHangNorFillTheMemory) {
  const std::string little = "ply\nformat binary_little_endian 1.0\n";
  EXPECT_TRUE(parse_ply(little + "element nothing 4294967294\nelement vertex 0\nproperty float x\nproperty float y\n"
                                 "property float z\nelement face 0\nend_header\n",
                        "f.ply")
                  .ok());
  EXPECT_THAT(said(parse_ply(little + "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float "
                                      "z\nend_header\n",
                             "f.ply")),
              HasSubstr("vertex 1 of 4000000000: the file ends here"));
}

}  // namespace
}  // namespace dobra::io::meshes
