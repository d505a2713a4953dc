// The rows. What a row needs beyond the reader and the writer of the format stands above it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "shared/io/drawings/dxf_paths.h"
#include "shared/io/file.h"
#include "shared/io/formats/drawing.h"
#include "shared/io/formats/format.h"
#include "shared/io/formats/line_files.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/formats/text_lines.h"
#include "shared/io/gis/dxf.h"
#include "shared/io/gis/geojson.h"
#include "shared/io/gis/ogr_file.h"
#include "shared/io/lines/gocad.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/lines/move_ascii.h"
#include "shared/io/lines/wkt.h"
#include "shared/io/meshes/bdf.h"
#include "shared/io/meshes/dxf_faces.h"
#include "shared/io/meshes/mesh_polygons.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/neutral.h"
#include "shared/io/meshes/node_ele.h"
#include "shared/io/meshes/ply.h"
#include "shared/io/meshes/polygon_file.h"
#include "shared/io/meshes/stl.h"
#include "shared/io/meshes/tsurf.h"
#include "shared/io/meshes/vtp.h"
#include "shared/io/meshes/vtu.h"
#include "shared/io/scan.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Result;
using lines::Feature;
using lines::Heights;
using mesh::ElementId;
using mesh::ElementMesh;
using meshes::InpElement;

namespace {

// --- lines

using LinesIn = const LineOptions&;
using LinesOut = const LineWriteOptions&;
using Features = std::span<const Feature>;

/// The graphs of CDT's test files end in .txt.
std::optional<meshes::PolyFile> graph_of_text(std::string_view text, const std::string& file) {
  return ending_of(file) == ".txt" ? meshes::counted_graph(text) : std::nullopt;
}

LineRow text_row() {
  return {.parse = features_of_text,
          .text = [](Features features, LinesOut) { return text_of(features); },
          .keeps_properties = false,
          .keeps_holes = false,
          .keeps_points = false,
          .graph = graph_of_text};
}

LineRow wkt_row() {
  return {.parse = [](std::string_view text, const std::string& file,
                      LinesIn options) { return lines::parse_wkt(text, file, options.faulty); },
          .text = [](Features features, LinesOut) { return lines::wkt(features); },
          .written_as = WrittenAs::SectionOnly,
          .keeps_names = false,
          .keeps_properties = false,
          .kind = [](const Feature&) { return std::string(); }};
}

LineRow geojson_row() {
  return {.parse = [](std::string_view text, const std::string& file,
                      LinesIn options) { return gis::parse_geojson(text, file, Heights::Keep, options.faulty); },
          .text = [](Features features, LinesOut options) { return gis::geojson(features, options.system); },
          .system = SystemKept::IfCoded};
}

/// "TOP 2" is on layer TOP.
std::string name_in_dxf(const Feature& feature) {
  const std::string layer = gis::dxf_layer(feature);
  return feature.name.empty() || feature.name.starts_with(layer + ' ') ? feature.name : layer;
}

bool is_dxf_unit(double metres) {
  return std::any_of(gis::dxf_units.begin(), gis::dxf_units.end(),
                     [&](const auto& known) { return known.second == metres; });
}

LineRow dxf_row() {
  return {
      .parse = [](std::string_view text, const std::string& file,
                  LinesIn options) { return gis::parse_dxf(text, file, Heights::Keep, options.faulty); },
      .text = [](Features features, LinesOut options) { return gis::dxf(features, options.unit); },
      .repeats_names = false,
      .keeps_properties = false,
      .keeps_holes = false,
      .keeps_points = false,
      .to_scale = true,
      .name = name_in_dxf,
      .not_in_names = R"(a control character, a blank at an end or one of <>/\":;?*|=,`)",
      .kind = [](const Feature& feature) { return lines::known_kind(gis::dxf_layer(feature)).value_or(std::string()); },
      .keeps_unit = is_dxf_unit,
      .true_curves = drawings::dxf_paths,
      .chords = gis::read_as_chords};
}

constexpr std::string_view not_in_words = "a line break, a tab, a brace or a blank at an end";

LineRow move_row() {
  return {.parse = [](std::string_view text, const std::string& file,
                      LinesIn) { return lines::parse_move_ascii(text, file); },
          .text = [](Features features, LinesOut) { return lines::move_ascii(features); },
          .written_as = WrittenAs::MapOnly,
          .keeps_properties = false,
          .own_properties = {"id", "attribute"},
          .keeps_holes = false,
          .name = [](const Feature& feature) { return lines::move_name(feature.name); },
          .not_in_names = not_in_words};
}

LineRow gocad_row() {
  return {
      .parse = [](std::string_view text, const std::string& file, LinesIn) { return lines::parse_gocad(text, file); },
      .text = [](Features features, LinesOut) { return lines::gocad(features); },
      .written_as = WrittenAs::MapOnly,
      .keeps_properties = false,
      .own_properties = {"geological_feature"},
      .keeps_holes = false,
      .name = [](const Feature& feature) { return lines::gocad_name(feature.name); },
      .not_in_names = not_in_words};
}

Result<lines::Features> read_ogr(const std::string& path, LinesIn options) {
  return gis::read_ogr_file(path, options.faulty);
}

LineRow shapefile_row() {
  return {.read = read_ogr,
          .write = [](const std::string& path, Features features,
                      LinesOut options) { return gis::write_shapefile(path, features, options.system); },
          .system = SystemKept::Yes,
          .one_type = true};
}

LineRow geopackage_row() {
  return {.read = read_ogr,
          .write = [](const std::string& path, Features features,
                      LinesOut options) { return gis::write_geopackage(path, features, options.system); },
          .system = SystemKept::Yes};
}

// --- meshes

using Losses = std::vector<std::string>;

template <class Contents>
MeshContents contents_of(Contents&& all) {
  MeshContents contents;
  contents.mesh = std::move(all.mesh);
  if constexpr (requires { all.remarks; }) contents.remarks = std::move(all.remarks);
  if constexpr (requires { all.elements; }) contents.elements = std::move(all.elements);
  if constexpr (requires { all.heights; }) contents.heights = std::move(all.heights);
  return contents;
}

template <auto parse>
Result<MeshContents> plane(std::string_view text, const std::string& file) {
  if constexpr (requires { parse(text, file, meshes::Flatness::Plane); }) {
    DOBRA_TRY(auto all, parse(text, file, meshes::Flatness::Plane));
    return contents_of(std::move(all));
  } else {
    DOBRA_TRY(auto all, parse(text, file));
    return contents_of(std::move(all));
  }
}

template <auto parse>
Result<MeshContents> in_space(std::string_view text, const std::string& file) {
  DOBRA_TRY(auto all, parse(text, file, meshes::Flatness::Any));
  return contents_of(std::move(all));
}

MeshRow vtu_row() {
  return {
      .parse = plane<meshes::parse_vtu>,
      .parse_in_space = in_space<meshes::parse_vtu>,
      .text = [](const ElementMesh& mesh, InpElement,
                 meshes::Heights heights) { return meshes::vtu_text(mesh, {}, meshes::VtuEncoding::Ascii, heights); },
      .fields = [](std::string_view text, const std::string& file) -> Result<MeshAndFields> {
        DOBRA_TRY(meshes::VtuContents contents, meshes::parse_vtu(text, file));
        return MeshAndFields{std::move(contents.mesh), std::move(contents.fields)};
      },
      .binary = true,
      .space = true,
      .note = "<!-- {} -->\n",
      .note_behind = "\n"};
}

template <meshes::MshVersion version>
MeshRow msh_row() {
  return {.parse = plane<meshes::parse_msh>,
          .parse_in_space = in_space<meshes::parse_msh>,
          .text = [](const ElementMesh& mesh, InpElement,
                     meshes::Heights heights) { return meshes::msh_text(mesh, version, heights); },
          .space = true,
          .losses =
              [](const ElementMesh& mesh) {
                Losses told;
                for (const auto& [name, written] : meshes::msh_renamings(mesh)) {
                  told.push_back(
                      fmt::format("the name '{}' is written as '{}': names in a .msh stand in quotes, on "
                                  "one line",
                                  name, written));
                }
                return told;
              },
          .note = "$Comments\n{}\n$EndComments\n",
          .note_behind = "$EndMeshFormat\n"};
}

MeshRow inp_row() {
  return {
      .parse = plane<meshes::parse_inp>,
      .parse_in_space = in_space<meshes::parse_inp>,
      .text = [](const ElementMesh& mesh, InpElement element,
                 meshes::Heights heights) { return meshes::inp_text(mesh, {.element = element, .heights = heights}); },
      .space = true,
      .losses =
          [](const ElementMesh& mesh) {
            Losses told;
            for (const auto& [kind, name, label] : meshes::inp_renamings(mesh)) {
              told.push_back(
                  fmt::format("the {} {} is written as {}: labels are letters, digits, _ and -, begin with a "
                              "letter, are no longer than 80 and differ not only by cases",
                              kind, shown(name), label));
            }
            return told;
          },
      .note = "** {}\n"};
}

MeshRow bdf_row() {
  return {.parse = plane<meshes::parse_bdf>,
          .parse_in_space = in_space<meshes::parse_bdf>,
          .text = [](const ElementMesh& mesh, InpElement,
                     meshes::Heights heights) { return meshes::bdf_text(mesh, heights); },
          .space = true,
          .note = "$ {}\n"};
}

MeshRow neutral_row() {
  return {.parse = plane<meshes::parse_neutral>, .text = [](const ElementMesh& mesh, InpElement, meshes::Heights) {
            return meshes::neutral_text({mesh, {}, 1.0});
          }};
}

Result<MeshContents> read_pair(const std::string& path) {
  const std::string stem = std::filesystem::path(path).replace_extension().string();
  DOBRA_TRY(const meshes::NodeFile nodes, meshes::read_node(stem + ".node"));
  DOBRA_TRY(const meshes::EleFile triangles, meshes::read_ele(stem + ".ele", nodes));
  MeshContents contents{meshes::mesh_of(nodes, triangles), {}};
  for (std::size_t e = 0; e < triangles.count(); ++e) {
    contents.elements.numbers.push_back(nodes.first_number + e);
    // Turning keeps the first corner and swaps the others.
    const bool kept = contents.mesh.nodes_of(ElementId(e))[1].index() == triangles.nodes[e * triangles.nodes_each + 1];
    if (!kept) contents.elements.turned.emplace_back(e);
  }
  return contents;
}

/// .node and .ele are written together, whichever is named; .ele is read, with the .node beside it.
MeshRow node_row() {
  return {.write =
              [](const std::string& path, const ElementMesh& mesh) {
                return meshes::write_node_ele(std::filesystem::path(path).replace_extension().string(), mesh);
              },
          .losses = [](const ElementMesh& mesh) -> Losses {
            if (mesh.side_sets.empty() && mesh.node_sets.empty() && mesh.region_names.empty()) return {};
            return {
                "a .node and .ele pair holds no names: sets of nodes and names of regions are left out, nodes of side "
                "sets are marked 1, 2 ... in the order of their names"};
          },
          .note = "# {}\n"};
}

MeshRow ele_row() {
  MeshRow row = node_row();
  row.read = read_pair;
  return row;
}

MeshRow poly_row() {
  return {.text = [](const ElementMesh& mesh, InpElement, meshes::Heights) -> Result<std::string> {
            DOBRA_TRY_VOID(meshes::check_writable(mesh));
            return meshes::poly_text(meshes::poly_of(mesh));
          },
          .losses = [](const ElementMesh&) -> Losses {
            return {
                "a .poly file holds the lines of the geometry: elements, named points and the lips of cracks are left "
                "out, side sets are marked 1, 2 ... in the order of their names"};
          },
          .note = "# {}\n"};
}

template <auto parse, meshes::PolygonFormat format>
MeshRow polygon_row(std::string_view note = {}, bool binary = false) {
  return {.parse = [](std::string_view text, const std::string& file) -> Result<MeshContents> {
            DOBRA_TRY(const mesh::PolygonMesh polygons, parse(text, file));
            DOBRA_TRY(ElementMesh mesh, meshes::elements_of(polygons, file));
            return MeshContents{std::move(mesh), {}};
          },
          .text = [](const ElementMesh& mesh, InpElement, meshes::Heights heights) -> Result<std::string> {
            DOBRA_TRY_VOID(meshes::check_writable(mesh, heights));
            return meshes::polygons_text(meshes::polygons_of(mesh, heights), format);
          },
          .polygons = parse,
          .binary = binary,
          .space = true,
          .surface = true,
          .note = note};
}

MeshRow vtp_row() {
  return {.parse = [](std::string_view text, const std::string& file) -> Result<MeshContents> {
            DOBRA_TRY(const mesh::PolygonMesh polygons, meshes::parse_vtp(text, file));
            DOBRA_TRY(ElementMesh mesh, meshes::elements_of(polygons, file));
            return MeshContents{std::move(mesh), {}};
          },
          .text = [](const ElementMesh& mesh, InpElement, meshes::Heights heights) -> Result<std::string> {
            DOBRA_TRY_VOID(meshes::check_writable(mesh, heights));
            return meshes::vtp_text(meshes::polygons_of(mesh, heights));
          },
          .polygons = meshes::parse_vtp,
          .binary = true,
          .space = true,
          .surface = true,
          .note = "<!-- {} -->\n",
          .note_behind = "\n"};
}

MeshRow tsurf_row() {
  return {.parse = [](std::string_view text, const std::string& file) -> Result<MeshContents> {
            DOBRA_TRY(const mesh::PolygonMesh polygons, meshes::parse_tsurf(text, file));
            DOBRA_TRY(ElementMesh mesh, meshes::elements_of(polygons, file));
            MeshContents contents{std::move(mesh), {}};
            for (const Remark& remark : meshes::tsurf_remarks(text, file))
              contents.remarks.push_back(to_string(remark));
            return contents;
          },
          .text = [](const ElementMesh& mesh, InpElement, meshes::Heights heights) -> Result<std::string> {
            DOBRA_TRY_VOID(meshes::check_writable(mesh, heights));
            const std::vector<meshes::TSurf> one{{"mesh", "", meshes::polygons_of(mesh, heights)}};
            return meshes::tsurfs_text(one);
          },
          .polygons = meshes::parse_tsurf,
          .polygon_remarks = meshes::tsurf_remarks,
          .space = true,
          .surface = true,
          .note = "# {}\n"};
}

MeshRow stl_row() {
  return {.parse = [](std::string_view text, const std::string& file) -> Result<MeshContents> {
            DOBRA_TRY(const mesh::TriangleMesh triangles, meshes::parse_stl(text, file));
            return MeshContents{element_mesh_of(triangles), {}};
          },
          .text = [](const ElementMesh& mesh, InpElement, meshes::Heights heights) -> Result<std::string> {
            DOBRA_TRY_VOID(meshes::check_writable(mesh, heights));
            if (!heights.empty()) return meshes::stl_text(meshes::polygons_of(mesh, heights));
            return meshes::stl_text(triangle_mesh_of(mesh));
          },
          .space = true,
          .surface = true,
          .losses = [](const ElementMesh& mesh) -> Losses {
            const auto quads = std::count_if(mesh.types.begin(), mesh.types.end(),
                                             [](auto type) { return mesh::corner_count(type) == 4; });
            if (quads == 0) return {};
            return {fmt::format("an .stl file holds triangles only; {} quadrilaterals are cut in two", quads)};
          }};
}

// --- drawings

template <auto read>
Result<Drawing> drawing_of(const std::string& path) {
  DOBRA_TRY(auto all, read(path));
  return Drawing{std::move(all)};
}

}  // namespace

const std::vector<Format>& all_formats() {
  using meshes::MshVersion;
  using meshes::PolygonFormat;
  static const std::vector<Format> table = {
      {"text",
       "Text",
       {".csv", ".txt", ".tsv", ".dat"},
       "columns, any separator, with or without header",
       "`x,z[,name,kind]`",
       "names, kinds",
       text_row()},
      {"wkt",
       "WKT",
       {".wkt"},
       "points, lines, polygons and their MULTI forms",
       "the same, in section coordinates",
       "coordinates only; names and kinds that are lost are named",
       wkt_row()},
      {"geojson",
       "GeoJSON",
       {".geojson", ".json"},
       "every geometry of the two dimensions, with or without heights",
       "2D or with heights",
       "everything",
       geojson_row()},
      {"dxf",
       "DXF",
       {".dxf"},
       "LINE, POLYLINE, LWPOLYLINE (with elevation, code 38), ARC, CIRCLE, ELLIPSE, SPLINE; as a mesh, 3DFACE",
       "release 12, POLYLINE",
       "the layer is the name; kinds that are lost are named",
       dxf_row(),
       MeshRow{.polygons = meshes::parse_dxf_faces}},
      {"move",
       "MOVE",
       {".asc", ".move"},
       "tabs: x y z name id attribute; a blank line between lines",
       "the same",
       "names, ids, attribute (or kind)",
       move_row()},
      {"gocad",
       "GOCAD",
       {".pl", ".vs", ".gp", ".gocad"},
       "PLine, VSet, groups; every spelling of the header we know of",
       "PLine 1, VSet 1",
       "names, kinds",
       gocad_row()},
      {"shapefile",
       "Shapefile",
       {".shp"},
       "with its .shx and .dbf",
       ".shp .shx .dbf",
       "everything; field names of 10 bytes",
       shapefile_row()},
      {"geopackage",
       "GeoPackage",
       {".gpkg"},
       "all layers",
       "layers lines, polygons, points",
       "everything",
       geopackage_row()},
      {"vtu",
       "VTK",
       {".vtu"},
       "VTK's unstructured grid, one piece: ASCII or binary, in place or appended, plain or by zlib",
       "ASCII",
       "everything",
       {},
       vtu_row()},
      {"msh",
       "gmsh 4.1",
       {".msh"},
       "gmsh 4.1 and 2.2, ASCII",
       "gmsh 4.1",
       "everything",
       {},
       msh_row<MshVersion::V41>()},
      {"msh2", "gmsh 2.2", {".msh2"}, "the same", "gmsh 2.2", "everything", {}, msh_row<MshVersion::V22>()},
      {"inp",
       "Abaqus, CalculiX",
       {".inp"},
       "Abaqus, CalculiX: the mesh of a deck",
       "the same",
       "names as labels; numbers of 20 columns",
       {},
       inp_row()},
      {"bdf",
       "Nastran",
       {".bdf", ".nas"},
       "Nastran bulk data: small, large and free field",
       "small field where all digits fit, else large",
       "names in comments; numbers of 16 columns",
       {},
       bdf_row()},
      {"nf", "Neutral file", {".nf"}, "neutral file of QUEBRA", "the same", "everything", {}, neutral_row()},
      {"node",
       "Triangle: nodes",
       {".node"},
       "",
       "Triangle, with the .ele beside it",
       "sets as markers, without names",
       {},
       node_row()},
      {"ele",
       "Triangle: elements",
       {".ele"},
       "Triangle, with the .node beside it",
       "the same",
       "sets as markers, without names",
       {},
       ele_row()},
      {"poly",
       "Triangle: graph",
       {".poly"},
       "Triangle: a planar straight-line graph",
       "the boundary, internal lines and cracks",
       "sets as markers, without names",
       {},
       poly_row(),
       drawing_of<meshes::read_poly>},
      {"obj",
       "Wavefront OBJ",
       {".obj"},
       "polygons",
       "the same",
       "corners only",
       {},
       polygon_row<meshes::parse_obj, PolygonFormat::Obj>("# {}\n")},
      {"ply",
       "PLY",
       {".ply"},
       "polygons, ASCII or binary",
       "polygons, ASCII",
       "corners only",
       {},
       polygon_row<meshes::parse_ply, PolygonFormat::Ply>({}, true)},
      {"stl", "STL", {".stl"}, "triangles, ASCII", "the same", "corners only", {}, stl_row()},
      {"off",
       "OFF",
       {".off"},
       "polygons",
       "the same",
       "corners only",
       {},
       polygon_row<meshes::parse_off, PolygonFormat::Off>()},
      {"tsurf",
       "GOCAD: surfaces",
       {".ts"},
       "TSurf, one or several, elevations or depths",
       "TSurf 1",
       "corners; names and kinds of horizons and faults",
       {},
       tsurf_row()},
      {"vtp",
       "VTK: polygons",
       {".vtp"},
       "VTK's polygon data, one piece: ASCII or binary, in place or appended, plain or by zlib",
       "ASCII",
       "corners only",
       {},
       vtp_row()},
      {"geo",
       "gmsh: geometry",
       {".geo"},
       "gmsh: a plane geometry of the built-in kernel",
       "",
       "",
       {},
       {},
       drawing_of<drawings::read_geo>},
      {"svg", "SVG", {".svg"}, "the outlines that are displayed", "", "", {}, {}, drawing_of<drawings::read_svg>},
  };
  return table;
}

}  // namespace dobra::io::formats
