// Surfaces in space from and to TSurf, DXF faces and VTP.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "shared/io/base64.h"
#include "shared/io/formats/format.h"
#include "shared/io/meshes/dxf_faces.h"
#include "shared/io/meshes/tsurf.h"
#include "shared/io/meshes/vtp.h"

namespace dobra::io::meshes {
namespace {

using geom::Point3;
using testing::AllOf;
using testing::HasSubstr;

void refused(const base::Result<std::vector<TSurf>>& read, std::size_t line, const std::string& part) {
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, HasSubstr(part));
  ASSERT_TRUE(read.error().place);
  EXPECT_EQ(read.error().place->line, line);
}

TEST(TSurfFile, WhatIsWrongIsRefusedWithItsLine) {
  refused(parse_tsurfs("GOCAD PLine 1\nVRTX 1 0 0 0\nEND\n", "f"), 3, "no triangle surface");
  refused(parse_tsurfs("GOCAD TSurf 1\nVRTX 1 0 0 0\n", "f"), 2, "before END");
  refused(parse_tsurfs("GOCAD TSurf 1\nVRTX 1 0 zero 0\nEND\n", "f"), 2, "zero");
  refused(parse_tsurfs("GOCAD TSurf 1\nVRTX 1 0 0 0\nTRGL 1 2 3\nEND\n", "f"), 3, "no vertex 2");
  refused(parse_tsurfs("GOCAD TSurf 1\nVRTX 1 0 0\nEND\n", "f"), 2, "z");
  EXPECT_FALSE(parse_tsurfs("", "f").ok());
}

TEST(TSurfFile, OtherSpellingsAreRead) {
  const auto read = parse_tsurfs(
      "GOCAD TSurf 1.0\nHEADER {*solid*color:0 1 0\n*name: Top of A \n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\n"
      "AXIS_UNIT \"km\" \"km\" \"km\"\nZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\nGEOLOGICAL_TYPE top\n"
      "PROPERTIES t\nTFACE\nPVRTX 7 0 0 1 5.0\nPVRTX 8 1 0 1 5.0\nVRTX 9 0 1 1 CNXYZ\nTRGL 7 8 9\nTFACE\n"
      "PATOM 10 8 5.0\nATOM 11 9\nVRTX 12 1 1 2\nTRGL 10 12 11\nBSTONE 7\nBORDER 13 7 8\nEND\n"
      "GOCAD VSet 1\nVRTX 1 0 0 0\nEND\nGOCAD TSurf 1\nHEADER {name:F}\nGEOLOGICAL_TYPE fault\n"
      "VRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n",
      "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].name, "Top of A");
  EXPECT_EQ((*read)[0].kind, "horizon");
  ASSERT_EQ((*read)[0].mesh.points.size(), 6u);
  EXPECT_EQ((*read)[0].mesh.points[3], (Point3{1000.0, 0.0, -1000.0}));
  EXPECT_EQ((*read)[0].mesh.points[5], (Point3{1000.0, 1000.0, -2000.0}));
  EXPECT_EQ((*read)[0].mesh.faces.size(), 2u);
  EXPECT_EQ((*read)[1].name, "F");
  EXPECT_EQ((*read)[1].kind, "fault");
  EXPECT_EQ(
      parse_tsurf("GOCAD TSurf 1\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n", "f")->faces.size(), 1u);
}

std::string with_units(const std::string& units) {
  return "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT " + units +
         "\nEND_ORIGINAL_COORDINATE_SYSTEM\nVRTX 1 0 0 0\nVRTX 2 2 0 0\nVRTX 3 2 4 -8\nTRGL 1 2 3\nEND\n";
}

TEST(TSurfFile, EachAxisHasItsUnit) {
  const auto last = [](const std::string& units) {
    const auto read = parse_tsurf(with_units(units), "f");
    EXPECT_TRUE(read.ok()) << units;
    return read.ok() ? read->points[2] : Point3{};
  };
  EXPECT_EQ(last("m m ft"), (Point3{2, 4, -8 * 0.3048}));
  EXPECT_EQ(last("\"M\" \" m \" \"FEET\""), (Point3{2, 4, -8 * 0.3048}));
  EXPECT_EQ(last("ft ft m"), (Point3{2 * 0.3048, 4 * 0.3048, -8}));
  EXPECT_EQ(last("km km m"), (Point3{2000, 4000, -8}));
  EXPECT_EQ(last("\"\" \"\" \"\""), (Point3{2, 4, -8})) << "no unit is stated";
  refused(parse_tsurfs(with_units("m m ms"), "f"), 3, "'ms' is not m, km or ft");
  refused(parse_tsurfs(with_units("inch m m"), "f"), 3, "'inch' is not m");
  refused(parse_tsurfs(with_units("m m"), "f"), 3, "each of x, y and z");
  refused(parse_tsurfs("GOCAD TSurf 1\nZPOSITIVE Downwards\nEND\n", "f"), 2, "neither Elevation nor Depth");
}

TEST(TSurfFile, WhatIsWrittenComesBackToTheBit) {
  const std::vector<TSurf> all{
      {"A {1}", "horizon", {{{0.1, 1.0 / 3.0, -7e5}, {1, 0, 0}, {1, 1, 1e-9}, {0, 1, 0}}, {{0, 1, 2, 3}}}},
      {"F", "fault", {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}}}};
  const std::string text = tsurfs_text(all);
  const auto read = parse_tsurfs(text, "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(tsurfs_text(*read), text);
  EXPECT_EQ((*read)[0].mesh.points, all[0].mesh.points);
  EXPECT_EQ((*read)[0].mesh.faces.size(), 2u);
}

std::string face(const std::vector<Point3>& corners) {
  std::string text = "  0\n3DFACE\n  8\nTOP\n";
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3 p = corners[std::min(k, corners.size() - 1)];
    text += std::to_string(10 + k) + "\n" + std::to_string(p.x) + "\n" + std::to_string(20 + k) + "\n" +
            std::to_string(p.y) + "\n" + std::to_string(30 + k) + "\n" + std::to_string(p.z) + "\n";
  }
  return text;
}
std::string drawing(const std::string& entities) {
  return "  0\nSECTION\n  2\nENTITIES\n" + entities + "  0\nENDSEC\n  0\nEOF\n";
}

TEST(DxfFaces, TrianglesAndQuadrilateralsShareTheirCorners) {
  const auto read = parse_dxf_faces(
      drawing("  0\nLINE\n  8\n0\n 10\n5\n 20\n5\n" + face({{0, 0, 0}, {1, 0, 0}, {1, 1, 2}}) +
              face({{0, 0, 0}, {1, 1, 2}, {0, 1, 1}, {-1, 0.5, 0}}) + face({{3, 3, 3}, {3, 3, 3}, {4, 4, 4}})),
      "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->faces.size(), 2u);
  EXPECT_EQ(read->faces[0], (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(read->faces[1], (std::vector<std::uint32_t>{0, 2, 3, 4}));
  EXPECT_EQ(read->points[2], (Point3{1, 1, 2}));
}

TEST(DxfFaces, DrawingsWithoutFacesAndBrokenOnesAreRefused) {
  EXPECT_FALSE(parse_dxf_faces(drawing(""), "f").ok());
  EXPECT_FALSE(parse_dxf_faces("  0\nSECTION\n  2\nENTITIES\n" + face({{0, 0, 0}, {1, 0, 0}, {1, 1, 2}}), "f").ok());
  std::string text = drawing(face({{0, 0, 0}, {1, 0, 0}, {1, 1, 2}}));
  text.replace(text.find("0.000000"), 8, "nought!!");
  const auto broken = parse_dxf_faces(text, "f");
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().place->line, 10u);
}

/// A foot is 0.3048 m.
TEST(TSurfFile, UnitsThatAreTakenToMetresAreToldWithTheirLine) {
  const auto surface = [](const std::string& units) {
    return "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT " + units +
           "\nEND_ORIGINAL_COORDINATE_SYSTEM\nVRTX 1 0 0 10\nVRTX 2 1 0 10\nVRTX 3 0 1 10\nTRGL 1 2 3\nEND\n";
  };
  const std::string feet = surface("\"ft\" \"ft\" \"m\"");
  EXPECT_NEAR(parse_tsurf(feet, "f")->points[1].x, 0.3048, 1e-15);
  const auto told = tsurf_remarks(surface("\"m\" \"m\" \"m\"") + feet, "f.ts");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].place.file, "f.ts");
  EXPECT_EQ(told[0].place.line, 12U);
  EXPECT_THAT(told[0].message, HasSubstr("in ft, ft and m"));
  EXPECT_THAT(to_string(told[0]), AllOf(HasSubstr("f.ts:12"), HasSubstr("taken to m")));
  EXPECT_TRUE(tsurf_remarks(surface("m m m"), "f").empty());
  EXPECT_TRUE(tsurf_remarks(surface("\"\" \"\" \"\""), "f").empty());
}

TEST(SurfaceFormats, TheTableKnowsSurfacesOfGocadAndFacesOfDxf) {
  EXPECT_EQ(formats::format_of("a.ts", formats::Use::ReadPolygons)->name, "tsurf");
  EXPECT_EQ(formats::format_of("a.ts", formats::Use::WriteSpaceMesh)->name, "tsurf");
  EXPECT_EQ(formats::format_of("a.dxf", formats::Use::ReadPolygons)->name, "dxf");
  EXPECT_EQ(formats::format_of("a.dxf", formats::Use::WriteSpaceMesh), nullptr);
  EXPECT_EQ(formats::format_of("a.dxf", formats::Use::ReadLines)->name, "dxf");
}

TEST(VtpFile, HoldsPointsFacesAndFieldsAndRefusesWhatDoesNotFit) {
  const mesh::PolygonMesh two{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const auto text = vtp_text(two, {{}, {{"dip", 1, {10.0, 20.5}}}});
  ASSERT_TRUE(text.ok());
  EXPECT_THAT(*text, HasSubstr("NumberOfPoints=\"4\""));
  EXPECT_THAT(*text, HasSubstr("NumberOfPolys=\"2\""));
  EXPECT_THAT(*text, HasSubstr("0 1 2 \n0 2 3 \n"));
  EXPECT_THAT(*text, HasSubstr("\n3\n6\n</DataArray>"));
  EXPECT_THAT(*text, HasSubstr("20.5"));
  EXPECT_FALSE(vtp_text(two, {{}, {{"dip", 1, {10.0}}}}).ok());
  mesh::PolygonMesh bad = two;
  bad.points[0].z = std::nan("");
  EXPECT_FALSE(vtp_text(bad).ok());
}

TEST(VtpFile, IsReadAsItWasWritten) {
  const mesh::PolygonMesh mixed{{{0, 0, 0}, {1, 0, 1.0 / 3.0}, {1, 1, 0.25}, {0, 1, -1e-17}, {0.5, 2, 1e9}},
                                {{0, 1, 2, 3}, {3, 2, 4}}};
  const auto text = vtp_text(mixed, {{{"height", 1, {1, 2, 3, 4, 5}}}, {{"dip", 1, {10.0, 20.5}}}});
  ASSERT_TRUE(text.ok());
  const auto read = parse_vtp(*text, "f");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->points, mixed.points);
  EXPECT_EQ(read->faces, mixed.faces);
  EXPECT_EQ(*vtp_text(*read), *vtp_text(mixed));
}

/// As other programs write it: two kinds of lengths in front, numbers of other widths, points and lines beside.
template <class Length, class Number, class Index>
std::string binary_vtp(const char* header, const char* number, const char* index) {
  const auto bytes = [](const auto& values) {
    std::string text;
    const Length size = static_cast<Length>(values.size() * sizeof(values[0]));
    text.append(reinterpret_cast<const char*>(&size), sizeof(size));
    text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    return base64(text);
  };
  const auto array = [&](const char* type, const char* name, const char* more, const auto& values) {
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" {}format=\"binary\">\n{}\n</DataArray>\n", type, name, more,
                       bytes(values));
  };
  return fmt::format(
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"{}\">\n<PolyData>\n<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">\n<Points>\n",
             header) +
         array(number, "P", "NumberOfComponents=\"3\" ",
               std::vector<Number>{0, 0, 0, 1, 0, 0, 1, 1, Number(0.25), 0, 1, 0}) +
         "</Points>\n<Lines>\n" + array(index, "connectivity", "", std::vector<Index>{0, 1}) +
         array(index, "offsets", "", std::vector<Index>{2}) + "</Lines>\n<Polys>\n" +
         array(index, "connectivity", "", std::vector<Index>{0, 1, 2, 0, 2, 3}) +
         array(index, "offsets", "", std::vector<Index>{3, 6}) + "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

TEST(VtpFile, InlineBinaryIsRead) {
  for (const std::string& text : {binary_vtp<std::uint32_t, float, std::int32_t>("UInt32", "Float32", "Int32"),
                                  binary_vtp<std::uint64_t, double, std::int64_t>("UInt64", "Float64", "Int64")}) {
    const auto read = parse_vtp(text, "f");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->points, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}}));
    EXPECT_EQ(read->faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}}));
  }
}

// The two triangles with all arrays appended: `at` are the offsets of the points, corners and ends in `data`.
std::string appended_vtp(const std::string& attributes, const std::string& encoding, std::array<std::size_t, 3> at,
                         const std::string& data) {
  const auto array = [](const char* type, const char* name, const char* more, std::size_t offset) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" {}format=\"appended\" offset=\"{}\"><InformationKey name=\"k\"/>"
        "</DataArray>\n",
        type, name, more, offset);
  };
  return fmt::format(
             "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" {}>\n<PolyData>\n"
             "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">\n<Points>\n",
             attributes) +
         array("Float64", "P", "NumberOfComponents=\"3\" ", at[0]) + "</Points>\n<Polys>\n" +
         array("Int64", "connectivity", "", at[1]) + array("Int64", "offsets", "", at[2]) +
         fmt::format(
             "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n"
             "</VTKFile>\n",
             encoding, data);
}

template <class T>
std::string raw(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// What ParaView saves: raw data behind the markup, with any bytes in them, also those of tags.
std::string raw_vtp() {
  const auto array = [](const std::string& bytes) { return raw(std::vector<std::uint64_t>{bytes.size()}) + bytes; };
  const std::string points = array(raw(std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0.25, 0, 1, 0}));
  const std::string corners = array(raw(std::vector<std::int64_t>{0, 1, 2, 0, 2, 3}));
  const std::string between = "</AppendedData> <_ \"";
  return appended_vtp("header_type=\"UInt64\"", "raw",
                      {0, points.size() + between.size(), points.size() + between.size() + corners.size()},
                      points + between + corners + array(raw(std::vector<std::int64_t>{3, 6})));
}

// VTK 9.1 wrote these arrays of the same triangles: heads and data by zlib in base64, of one block each.
const char zlib_points[] = "AQAAAAAQAABgAAAAFwAAAA==eF5jYMAHPtjjF4fRF9DUIfQBAM6TBcw=";
const char zlib_corners[] = "AQAAAAAQAAAwAAAAFgAAAA==eF5jYIAARijNxIAKYHxmKA0AANAACQ==";
const char zlib_ends[] = "AQAAAAAQAAAQAAAADgAAAA==eF5jZoAANigNAABwAAo=";

std::string zlib_vtp() {
  const std::string points = zlib_points;
  const std::string corners = zlib_corners;
  return appended_vtp("compressor=\"vtkZLibDataCompressor\"", "base64",
                      {0, points.size(), points.size() + corners.size()}, points + corners + zlib_ends);
}

void holds_two(const std::string& text) {
  const auto read = parse_vtp(text, "f");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->points, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}}));
  EXPECT_EQ(read->faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(VtpFile, WhatVtkWritesIsRead) {
  holds_two(raw_vtp());
  holds_two(zlib_vtp());
  std::string in_place = zlib_vtp();
  const auto put = [&](const std::string& name, const std::string& data) {
    const std::size_t at = in_place.find("format=\"appended\"", in_place.find("Name=\"" + name));
    in_place.replace(at, in_place.find('>', at) + 1 - at, "format=\"binary\">\n  " + data + "\n");
  };
  put("P", zlib_points);
  put("connectivity", zlib_corners);
  put("offsets", zlib_ends);
  holds_two(in_place);
}

// Cut anywhere, or with any byte changed, it is refused or read; never more.
TEST(VtpFile, DamagedDataAreRefused) {
  const auto said = [](const std::string& text) {
    const auto read = parse_vtp(text, "f");
    return read.ok() ? std::string("read") : to_string(read.error());
  };
  EXPECT_THAT(said(raw_vtp().substr(0, raw_vtp().size() - 30)), AllOf(HasSubstr("f:13"), HasSubstr("cut short")));
  for (const std::string& good : {raw_vtp(), zlib_vtp()}) {
    for (std::size_t size = 0; size + 12 < good.size(); size += 3)
      EXPECT_FALSE(parse_vtp(good.substr(0, size), "f").ok()) << size;
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (const char byte : {'\xff', '9'}) {
        std::string bad = good;
        bad[at] = byte;
        (void)parse_vtp(bad, "f");
      }
    }
  }
  std::string bad = zlib_vtp();
  bad.replace(bad.find("eF5jYMAHPtjj"), 12, "eF5jYMAHPujj");
  EXPECT_THAT(said(bad), AllOf(HasSubstr("f:5"), HasSubstr("zlib cannot unpack")));
  bad = zlib_vtp();
  bad.replace(bad.find("offset=\"0\""), 10, "offset=\"900\"");
  EXPECT_THAT(said(bad), AllOf(HasSubstr("f:5"), HasSubstr("offset '900' does not lie")));
  bad = zlib_vtp();
  bad.replace(bad.find("_AQAAAAAQAABgAAAA"), 17, "_AQAAAAAQAABg////");  // a block of four thousand million bytes
  EXPECT_THAT(said(bad), AllOf(HasSubstr("f:5"), HasSubstr("zlib cannot unpack")));
}

TEST(VtpFile, WhatIsWrongIsRefusedWithItsLine) {
  const mesh::PolygonMesh two{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::string good = *vtp_text(two);
  ASSERT_TRUE(parse_vtp(good, "f").ok());
  const auto said = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    const auto at = bad.find(from);
    if (at == std::string::npos) return "no " + from;
    bad.replace(at, from.size(), to);
    const auto read = parse_vtp(bad, "f");
    return read.ok() ? std::string("read") : to_string(read.error());
  };
  EXPECT_THAT(said("1.0 1.0 0.25", "1.0 one 0.25"), AllOf(HasSubstr("f:13:5"), HasSubstr("one")));
  EXPECT_THAT(said("1.0 1.0 0.25", "1.0 nan 0.25"), HasSubstr("f:13:5"));
  EXPECT_THAT(said("1.0 1.0 0.25\n", "1.0 1.0\n"), AllOf(HasSubstr("f:10"), HasSubstr("three coordinates")));
  EXPECT_THAT(said("1.0 1.0 0.25\n", ""), AllOf(HasSubstr("f:4"), HasSubstr("4 points and holds 3")));
  EXPECT_THAT(said("0 2 3 \n", "0 2 4 \n"), AllOf(HasSubstr("f:18"), HasSubstr("polygon 1: there is no point 4")));
  EXPECT_THAT(said("0 2 3 \n", "0 2 -1 \n"), HasSubstr("there is no point -1"));
  EXPECT_THAT(said("0 2 3 \n", "0 2 3 1 \n"), HasSubstr("corners follow the last polygon"));
  EXPECT_THAT(said("\n3\n6\n", "\n3\n7\n"), HasSubstr("the offset of polygon 1"));
  EXPECT_THAT(said("\n3\n6\n", "\n6\n3\n"), HasSubstr("the offset of polygon 1"));
  EXPECT_THAT(said("\n3\n6\n", "\n3.5\n6\n"), HasSubstr("the offset of polygon 0"));
  EXPECT_THAT(said("\n3\n6\n", "\n6\n"), HasSubstr("2 polygons and holds 1"));
  EXPECT_THAT(said("Name=\"offsets\"", "Name=\"ends\""), AllOf(HasSubstr("offsets"), HasSubstr("in Polys")));
  EXPECT_THAT(said("type=\"PolyData\"", "type=\"ImageData\""), AllOf(HasSubstr("f:2"), HasSubstr("give PolyData")));
  EXPECT_THAT(said("format=\"ascii\"", "format=\"appended\" offset=\"0\""),
              AllOf(HasSubstr("f:10"), HasSubstr("appended")));
  EXPECT_THAT(said("format=\"ascii\"", "format=\"packed\""), AllOf(HasSubstr("f:10"), HasSubstr("packed")));
  EXPECT_THAT(said("header_type", "compressor=\"vtkLZ4DataCompressor\" header_type"),
              AllOf(HasSubstr("f:2"), HasSubstr("vtkLZ4DataCompressor"), HasSubstr("zlib")));
  EXPECT_THAT(said("<Polys>",
                   "<Strips>\n<DataArray type=\"Int64\" Name=\"connectivity\">0 1 2 3</DataArray>\n</Strips>\n<Polys>"),
              HasSubstr("strips of triangles"));
  EXPECT_THAT(said("</VTKFile>", ""), HasSubstr("f:"));
  // Cut short anywhere, it is never read.
  for (std::size_t size = 0; size + 12 < good.size(); size += 7)
    EXPECT_FALSE(parse_vtp(good.substr(0, size), "f").ok()) << size;
}

TEST(VtpFile, TheTableReadsAndWritesIt) {
  EXPECT_EQ(formats::format_of("a.vtp", formats::Use::ReadPolygons)->name, "vtp");
  EXPECT_EQ(formats::format_of("A.VTP", formats::Use::ReadMesh)->name, "vtp");
  EXPECT_EQ(formats::format_of("a.vtp", formats::Use::WriteSpaceMesh)->name, "vtp");
}

}  // namespace
}  // namespace dobra::io::meshes
