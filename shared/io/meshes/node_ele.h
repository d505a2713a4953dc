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
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

struct NodeFile {
  std::vector<geom::Point> points;
  std::size_t attribute_count = 0;    ///< Attributes a point.
  std::vector<double> attributes;     ///< Those of point i stand at i * attribute_count.
  std::vector<std::int64_t> markers;  ///< One a point, or empty where the file has none.
  std::size_t first_number = 0;       ///< 0 or 1: the number of the first point in the file.
  friend bool operator==(const NodeFile&, const NodeFile&) = default;
};

struct EleFile {
  std::size_t nodes_each = 3;        ///< 3, or 6: then the mid-side nodes opposite corners 1, 2, 3 follow the corners.
  std::vector<std::uint32_t> nodes;  ///< Indices of points, from 0; nodes_each a triangle.
  std::size_t attribute_count = 0;   ///< Attributes a triangle.
  std::vector<double> attributes;
  [[nodiscard]] std::size_t count() const { return nodes.size() / nodes_each; }
  friend bool operator==(const EleFile&, const EleFile&) = default;
};

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column.
base::Result<NodeFile> read_node(const std::string& path);
base::Result<NodeFile> parse_node(std::string_view text, const std::string& file);

/// @param nodes  the points that the triangles number. Triangles of 3 or 6 nodes.
/// @error as read_node; BadFormat for a number that no point has.
base::Result<EleFile> read_ele(const std::string& path, const NodeFile& nodes);
base::Result<EleFile> parse_ele(std::string_view text, const std::string& file, const NodeFile& nodes);

/// The mesh as points and triangles; a point's marker is the position (1, 2, ...) of the first side set that holds it
/// and 0 inside, a triangle's attribute is its region. Names have no room in this format.
NodeFile node_file_of(const mesh::ElementMesh& mesh);
/// @error InvalidOption if the mesh has quadrilaterals, or both T3 and T6.
base::Result<EleFile> ele_file_of(const mesh::ElementMesh& mesh);
/// Regions from the first attribute, 0 without. Triangles are turned anticlockwise.
mesh::ElementMesh mesh_of(const NodeFile& nodes, const EleFile& elements);

/// Texts with every digit. @error NotFinite
base::Result<std::string> node_text(const NodeFile& nodes);
base::Result<std::string> ele_text(const EleFile& elements, std::size_t first_number = 0);

/// Writes `stem`.node and `stem`.ele. @error NotFinite, InvalidOption, CannotWrite
base::Result<void> write_node_ele(const std::string& stem, const mesh::ElementMesh& mesh);
/// Reads `stem`.node and `stem`.ele.
base::Result<mesh::ElementMesh> read_node_ele(const std::string& stem);

/// For the .poly reader: the node section that starts with the current record of `records`.
base::Result<NodeFile> parse_node_section(Records& records, std::string_view text);
/// For the .poly writer.
std::string node_section_text(const NodeFile& nodes);

}  // namespace dobra::io::meshes
