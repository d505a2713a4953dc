#pragma once
// The mesh part of a Nastran bulk data file (.bdf): GRID, CTRIA3, CTRIA6, CQUAD4, CQUAD8, SET1, in small and large
// field; read in free field too. Properties and materials are the deck's business. Source: [nastran-qrg].
//
// The property number of an element is the position of its region, from 1. What Nastran has no card for stands in
// comments:
//   "$DOBRA REGION number tag name"
//   "$DOBRA NODESET number name" before its SET1
//   "$DOBRA SIDESET name" and, for each side, "$DOBRA SIDE element side"

#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/file_elements.h"
#include "shared/io/meshes/heights.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

struct BdfContents {
  mesh::ElementMesh mesh;
  std::vector<std::string> remarks;  ///< Cards left out, one line each.
  FileElements elements = {};
  std::vector<double> heights = {};  ///< z of the nodes, m, of a mesh in space; empty: it is plane.
};

/// A card is in small fields of 8 characters where they hold all that large ones of 16 would, else in large ones.
/// Coordinates are rounded to these; what is read and written again stays.
/// @error NotFinite; CannotMesh: no elements; InvalidOption: a set that refers to what does not exist, a name with a
/// line end.
base::Result<std::string> bdf_text(const mesh::ElementMesh& mesh, Heights heights = {});
/// @error those of bdf_text, CannotWrite
base::Result<void> write_bdf(const std::string& path, const mesh::ElementMesh& mesh);

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column.
base::Result<BdfContents> read_bdf(const std::string& path);
base::Result<BdfContents> parse_bdf(std::string_view text, const std::string& file,
                                    Flatness flatness = Flatness::Plane);

/// A real number in at most `width` characters, with a point; the same text for what is read from it.
std::string bdf_number(double value, std::size_t width);

}  // namespace dobra::io::meshes
