#pragma once
// The neutral file of the original QUEBRA 2D (.nf): sections that begin with '%', each followed by the number of its
// entries. Source: [carvalho2005offset] and the list of sections in the project's fracture notes.
//
//   %HEADER  %NODE  %NODE.COORD  %MATERIAL.ISOTROPIC  %THICKNESS  %INTEGRATION.ORDER  %ELEMENT  %ELEMENT.T3 .T6 .Q4 .Q8
//   %END
//
// An element's line is its number, material, thickness and integration order by number, then its nodes in the order of
// element_mesh.h. Materials are numbered as the regions are. Sections of ours keep what the original had not: %REGION
// (material, tag, name), %NODE.SET and %SIDE.SET ('name' and count, then nodes, or element and side).

#include <map>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/meshes/file_elements.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

struct NeutralMaterial {
  double young = 1.0;  ///< Pa.
  double poisson = 0.3;
  friend bool operator==(const NeutralMaterial&, const NeutralMaterial&) = default;
};

struct NeutralFile {
  mesh::ElementMesh mesh;
  std::map<std::int32_t, NeutralMaterial> materials;  ///< By region; those of NeutralMaterial where none is given.
  double thickness = 1.0;                             ///< m.
  FileElements elements = {};                         ///< Of what was read.
  friend bool operator==(const NeutralFile&, const NeutralFile&) = default;
};

/// @error NotFinite; CannotMesh: no elements; InvalidOption: a set that refers to what does not exist, a name with a
///        quote or line end.
base::Result<std::string> neutral_text(const NeutralFile& file);
/// @error those of neutral_text, CannotWrite
base::Result<void> write_neutral(const std::string& path, const NeutralFile& file);

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column.
base::Result<NeutralFile> read_neutral(const std::string& path);
base::Result<NeutralFile> parse_neutral(std::string_view text, const std::string& file);

}  // namespace dobra::io::meshes
