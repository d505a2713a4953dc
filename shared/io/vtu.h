#pragma once
// VTK's XML unstructured grid (.vtu), serial: a triangle mesh with numbers at its points and triangles, for ParaView
// and the like. Reads back what it writes, and other files of triangles that are ASCII or inline, uncompressed base64.
// Source: [vtkfileformats].

#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::io {

/// Named numbers, `components` of them an item: item i has values[i * components] and the following.
struct MeshField {
  std::string name;
  std::size_t components = 1;
  std::vector<double> values;
  friend bool operator==(const MeshField&, const MeshField&) = default;
};

struct MeshFields {
  std::vector<MeshField> at_points;
  std::vector<MeshField> at_triangles;
  friend bool operator==(const MeshFields&, const MeshFields&) = default;
};

enum class VtuEncoding { Ascii, Base64 };

struct VtuContents {
  mesh::TriangleMesh mesh;  ///< Points, triangles and regions; the format carries no sets.
  MeshFields fields;
};

/// The text of a .vtu; regions go as the triangles' field "region", every number with all its digits.
/// @error NotFinite; InvalidOption: a field whose length is not components times the number of items.
base::Result<std::string> vtu_text(const mesh::TriangleMesh& mesh, const MeshFields& fields = {},
                                   VtuEncoding encoding = VtuEncoding::Ascii);
/// @error NotFinite, InvalidOption, CannotWrite
base::Result<void> write_vtu(const std::string& path, const mesh::TriangleMesh& mesh, const MeshFields& fields = {},
                             VtuEncoding encoding = VtuEncoding::Ascii);

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column; UnknownFormat:
///        appended or compressed data, cells that are not triangles.
base::Result<VtuContents> read_vtu(const std::string& path);
base::Result<VtuContents> parse_vtu(std::string_view text, const std::string& file);

}  // namespace dobra::io
