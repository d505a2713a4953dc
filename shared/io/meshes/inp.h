#pragma once
// The mesh part of an Abaqus or CalculiX input deck (.inp): *NODE, *ELEMENT of triangles and quadrilaterals of first
// and second order, *NSET, *ELSET, *SURFACE. Materials, loads and steps are the deck's business. Source:
// [calculix-ccx], [abaqus-keywords].
//
// Names in the file: every side set is an *NSET (its nodes) and a *SURFACE (its element faces) of its name, every node
// set an *NSET; a region is the *ELSET REGION_TAG, and one more of its name that holds that set. All nodes are NALL,
// all elements EALL.

#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/file_elements.h"
#include "shared/io/meshes/heights.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

enum class InpElement { PlaneStress, PlaneStrain, Axisymmetric, Shell };  ///< CPS3, CPE3, CAX3, S3 and so on
/// CalculiX looks at the first 20 characters of a number only. TwentyColumns writes every digit where they fit in 20
/// and else rounds to the most that do (relative error below 1e-12); Exact always writes every digit.
enum class InpNumbers { TwentyColumns, Exact };

struct InpOptions {
  InpElement element;
  InpNumbers numbers = InpNumbers::TwentyColumns;
  Heights heights = {};
};

struct InpContents {
  mesh::ElementMesh mesh;
  std::vector<std::string> remarks;  ///< Keywords left out, one line each.
  FileElements elements = {};
  std::vector<double> heights = {};  ///< z of the nodes, m, of a mesh in space; empty: it is plane.
};

/// A name that a label cannot hold (letters, digits, _ and -, at most 80), or that another set has already but for its
/// cases, and what stands there instead. Sets of elements (regions) and of nodes (node and side sets) may share a name.
struct InpRenaming {
  std::string kind;  ///< "region", "set of sides", "set of nodes"
  std::string name, label;
};
std::vector<InpRenaming> inp_renamings(const mesh::ElementMesh& mesh);

/// The text of a deck's mesh part; node and element numbers are the positions in the mesh, from 1. Characters that a
/// label cannot hold become '_'; a comment line and inp_renamings say so.
/// @error NotFinite; CannotMesh: no elements; InvalidOption: a set that refers to what does not exist.
base::Result<std::string> inp_text(const mesh::ElementMesh& mesh, const InpOptions& options);
/// @error those of inp_text, CannotWrite
base::Result<void> write_inp(const std::string& path, const mesh::ElementMesh& mesh, const InpOptions& options);

/// The mesh of a deck; keywords beside those above are left out with a remark.
/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column; UnknownFormat:
///        other elements.
base::Result<InpContents> read_inp(const std::string& path);
base::Result<InpContents> parse_inp(std::string_view text, const std::string& file,
                                    Flatness flatness = Flatness::Plane);

/// `value` as InpNumbers::TwentyColumns writes it.
std::string twenty_columns(double value);

}  // namespace dobra::io::meshes
