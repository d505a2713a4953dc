#pragma once
// The table of formats: what a format is called, which endings it has, what it holds, how it is read and written, and
// what it loses. Readers, writers, help texts, file filters, docs/user/formats.md and the fuzz targets go by it. A new
// format is its two files (reader and writer behind a header) and a row in format_table.cpp.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"
#include "shared/io/meshes/file_elements.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/remark.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::mesh {
struct PolygonMesh;
}
namespace dobra::io::drawings {
struct SvgPath;
}
namespace dobra::io::meshes {
struct MeshFields;
struct PolyFile;
}  // namespace dobra::io::meshes

namespace dobra::io::formats {

struct LineOptions;
struct LineWriteOptions;
struct Drawing;
struct MeshAndFields;

/// The coordinates that lines are written with: x and height of the section, or x, y and height of the map.
enum class WrittenAs { Either, SectionOnly, MapOnly };
/// The reference system of the coordinates. IfCoded: one that has a code.
enum class SystemKept { No, IfCoded, Yes };

/// Lines, polygons and points in and out. A format that is text has `parse` and `text`, another one `read` and `write`.
struct LineRow {
  using Features = base::Result<lines::Features>;
  Features (*parse)(std::string_view text, const std::string& file, const LineOptions& options) = nullptr;
  Features (*read)(const std::string& path, const LineOptions& options) = nullptr;
  base::Result<std::string> (*text)(std::span<const lines::Feature> features,
                                    const LineWriteOptions& options) = nullptr;
  /// @return remarks on what was changed.
  base::Result<std::vector<std::string>> (*write)(const std::string& path, std::span<const lines::Feature> features,
                                                  const LineWriteOptions& options) = nullptr;
  WrittenAs written_as = WrittenAs::Either;
  bool keeps_names = true;
  bool repeats_names = true;  ///< Several lines of one name come back with that name.
  bool keeps_properties = true;
  std::vector<std::string_view> own_properties = {};  ///< Kept all the same.
  bool keeps_holes = true;
  bool keeps_points = true;
  SystemKept system = SystemKept::No;
  bool one_type = false;  ///< Points, lines or polygons, not several of them.
  bool to_scale = false;  ///< A drawing on paper too: in millimetres where a scale is given.
  /// A name as it is read back, and what makes it another one; nothing: it stays.
  std::string (*name)(const lines::Feature& feature) = nullptr;
  std::string_view not_in_names = {};
  /// The kind as it is read back; nothing: it stays.
  std::string (*kind)(const lines::Feature& feature) = nullptr;
  /// Whether a unit of so many metres can be stated; nothing: none can.
  bool (*keeps_unit)(double metres) = nullptr;

  /// For the geometry of a domain: the same file with its arcs and splines as they are drawn; nothing where its lines
  /// must do. Of the remarks on the lines those that end with `chords` are then untrue.
  std::optional<std::vector<drawings::SvgPath>> (*true_curves)(std::string_view text,
                                                               const std::string& file) = nullptr;
  std::string_view chords = {};
  /// The graph that a text may be instead of lines; nothing where it is none.
  std::optional<meshes::PolyFile> (*graph)(std::string_view text, const std::string& file) = nullptr;
};

struct MeshContents {
  mesh::ElementMesh mesh;
  std::vector<std::string> remarks;  ///< What was left out, one line each.
  meshes::FileElements elements = {};
  std::vector<double> heights = {};  ///< z of the nodes, m, of a mesh in space; empty: it is plane.
};

/// Meshes in and out. A format that is one text has `parse` and `text`, another one `read` and `write`.
struct MeshRow {
  base::Result<MeshContents> (*parse)(std::string_view text, const std::string& file) = nullptr;
  base::Result<MeshContents> (*read)(const std::string& path) = nullptr;
  /// As `parse`, of a mesh that may lie in space; nothing: the format holds none of elements.
  base::Result<MeshContents> (*parse_in_space)(std::string_view text, const std::string& file) = nullptr;
  /// @param element  of .inp, which alone says what kind of elements they are.
  /// @param heights  of a mesh in space; none where not `space`.
  base::Result<std::string> (*text)(const mesh::ElementMesh& mesh, meshes::InpElement element,
                                    meshes::Heights heights) = nullptr;
  base::Result<void> (*write)(const std::string& path, const mesh::ElementMesh& mesh) = nullptr;
  /// The same with the fields of numbers at its points and elements; nothing: the format holds none.
  base::Result<MeshAndFields> (*fields)(std::string_view text, const std::string& file) = nullptr;
  /// The polygons in space as they stand, to be checked; nothing: the format holds elements.
  base::Result<mesh::PolygonMesh> (*polygons)(std::string_view text, const std::string& file) = nullptr;
  /// What `polygons` changes in what it reads; nothing: nothing.
  std::vector<Remark> (*polygon_remarks)(std::string_view text, const std::string& file) = nullptr;
  bool binary = false;   ///< May be no text; then `parse` and `polygons` take bytes.
  bool space = false;    ///< Its nodes have a third coordinate, which is written.
  bool surface = false;  ///< Corners alone, as polygons: no sets, no regions, no nodes at mid-sides.
  /// What else is left out or renamed, one line each; nothing: all is kept.
  std::vector<std::string> (*losses)(const mesh::ElementMesh& mesh) = nullptr;
  /// A comment at the head: behind the first `note_behind` of the file; empty: the format has none.
  std::string_view note = {};
  std::string_view note_behind = {};
};

struct Format {
  std::string_view name;                 ///< As options take it.
  const char* title;                     ///< As windows show it; English source text.
  std::vector<std::string> endings;      ///< Each with its dot, in small letters; the first is what it is written with.
  std::string_view read, written, kept;  ///< For people: what is read and written, and what of it comes back.
  std::optional<LineRow> lines = std::nullopt;
  std::optional<MeshRow> mesh = std::nullopt;
  /// Geometry of a domain: true curves and their groups, for quebra.
  base::Result<Drawing> (*drawing)(const std::string& path) = nullptr;
};

/// Formats of lines first, then of meshes, then of drawings.
const std::vector<Format>& all_formats();

/// What a command wants to do with a file.
enum class Use {
  ReadLines,
  WriteLines,
  WritePlaneLines,  ///< With two coordinates.
  WriteLinesToScale,
  ReadMesh,
  ReadFields,    ///< A mesh with numbers at its points and elements.
  ReadPolygons,  ///< In space.
  WriteMesh,
  WriteSpaceMesh,  ///< Of surfaces.
  ReadDrawing
};
bool is_for(const Format& format, Use use);
/// Of all formats for the use, in the order of the table.
std::vector<std::string> endings_for(Use use);
std::vector<std::string> names_for(Use use);
/// By the ending of a name, capitals or not; nothing if none is for the use.
const Format* format_of(const std::string& path, Use use);
/// By its name; nothing for another name.
const Format* format_named(std::string_view name, Use use);

/// The table as Markdown, one row a format: docs/user/formats.md.
std::string formats_markdown();

}  // namespace dobra::io::formats
