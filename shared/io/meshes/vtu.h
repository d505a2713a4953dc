#pragma once
// VTK's XML unstructured grid (.vtu), serial: a mesh with numbers at its points and elements, for ParaView and the
// like. Reads back what it writes, and other files of triangles and quadrilaterals (first and second order) that are
// ASCII or binary. Source: [vtkfileformats].
//
// Sets stand in the FieldData: "side_set NAME" (element, side), "node_set NAME" (nodes), "tip NAME" (node, direction),
// "region NAME" (tag), numbers from 0. Elements carry their region's tag as the field "region".

#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/heights.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

/// Named numbers, `components` of them an item: item i has values[i * components] and the following.
struct MeshField {
  std::string name;
  std::size_t components = 1;
  std::vector<double> values;
  friend bool operator==(const MeshField&, const MeshField&) = default;
};

struct MeshFields {
  std::vector<MeshField> at_points;
  std::vector<MeshField> at_elements;
  friend bool operator==(const MeshFields&, const MeshFields&) = default;
};

enum class VtuEncoding { Ascii, Base64 };

struct VtuContents {
  mesh::ElementMesh mesh;
  MeshFields fields;
  std::vector<double> heights = {};  ///< z of the nodes, m, of a mesh in space; empty: it is plane.
};

/// The text of a .vtu; every number with all its digits.
/// @error CannotMesh: no elements; NotFinite; InvalidOption: a field whose length is not components times the number of
/// items.
base::Result<std::string> vtu_text(const mesh::ElementMesh& mesh, const MeshFields& fields = {},
                                   VtuEncoding encoding = VtuEncoding::Ascii, Heights heights = {});
/// @error NotFinite, InvalidOption, CannotWrite
base::Result<void> write_vtu(const std::string& path, const mesh::ElementMesh& mesh, const MeshFields& fields = {},
                             VtuEncoding encoding = VtuEncoding::Ascii, Heights heights = {});

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column; UnknownFormat:
///        data compressed by another library than zlib, cells that are neither triangles nor quadrilaterals.
base::Result<VtuContents> read_vtu(const std::string& path);
base::Result<VtuContents> parse_vtu(std::string_view text, const std::string& file,
                                    Flatness flatness = Flatness::Plane);

}  // namespace dobra::io::meshes
