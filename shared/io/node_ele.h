#pragma once
// Triangle's .node and .ele files: numbered points and triangles, with attributes and boundary markers.
// Comments run from '#' to the end of the line; numbering starts at 0 or 1, as the first number says.
// Source: [shewchuk1996triangle].

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/scan.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::io {

struct NodeFile {
  std::vector<geom::Point> points;
  std::size_t attribute_count = 0;    ///< Attributes a point.
  std::vector<double> attributes;     ///< Those of point i stand at i * attribute_count.
  std::vector<std::int64_t> markers;  ///< One a point, or empty where the file has none.
  std::size_t first_number = 0;       ///< 0 or 1: the number of the first point in the file.
  friend bool operator==(const NodeFile&, const NodeFile&) = default;
};

struct EleFile {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Indices of points, from 0.
  std::size_t attribute_count = 0;                      ///< Attributes a triangle.
  std::vector<double> attributes;
  friend bool operator==(const EleFile&, const EleFile&) = default;
};

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column.
base::Result<NodeFile> read_node(const std::string& path);
base::Result<NodeFile> parse_node(std::string_view text, const std::string& file);

/// @param nodes  the points that the triangles number. Triangles of 3 nodes.
/// @error as read_node; BadFormat for a number that no point has.
base::Result<EleFile> read_ele(const std::string& path, const NodeFile& nodes);
base::Result<EleFile> parse_ele(std::string_view text, const std::string& file, const NodeFile& nodes);

/// The mesh as points and triangles; a point's marker is the position (1, 2, ...) of the first boundary set that holds
/// it and 0 inside, a triangle's attribute is its region. Names and constraint sets have no room in this format.
NodeFile node_file_of(const mesh::TriangleMesh& mesh);
EleFile ele_file_of(const mesh::TriangleMesh& mesh);
/// Regions from the first attribute, 0 without. Triangles are turned anticlockwise.
mesh::TriangleMesh mesh_of(const NodeFile& nodes, const EleFile& elements);

/// Texts with every digit. @error NotFinite
base::Result<std::string> node_text(const NodeFile& nodes);
base::Result<std::string> ele_text(const EleFile& elements, std::size_t first_number = 0);

/// Writes `stem`.node and `stem`.ele. @error NotFinite, CannotWrite
base::Result<void> write_node_ele(const std::string& stem, const mesh::TriangleMesh& mesh);
/// Reads `stem`.node and `stem`.ele.
base::Result<mesh::TriangleMesh> read_node_ele(const std::string& stem);

/// For the .poly reader: the node section that starts with the current record of `records`.
base::Result<NodeFile> parse_node_section(Records& records, std::string_view text);
/// For the .poly writer.
std::string node_section_text(const NodeFile& nodes);

}  // namespace dobra::io
