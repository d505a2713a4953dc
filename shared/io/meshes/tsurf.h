#pragma once
// GOCAD triangle surfaces (TSurf), as GOCAD, SKUA and others write them: header in one line or in several, VRTX, PVRTX,
// ATOM, PATOM, TRGL, parts (TFACE), elevations or depths. Source: [gocad].

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/remark.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

struct TSurf {
  std::string name = {};
  std::string kind = {};  ///< GEOLOGICAL_TYPE in small letters, top as "horizon"; empty: not said.
  mesh::PolygonMesh mesh = {};
};

/// The surfaces of a file, z up, metres: ZPOSITIVE Depth turns heights, and AXIS_UNIT says for each axis
/// whether it is in m, km or ft. Other objects, properties of vertices, borders and their stones are passed over.
/// @error BadFormat with line and column: no TSurf, a vertex or triangle that is not well formed, a vertex that is not
///        there, another unit, the end missing; NotFinite.
/// @cost  O(file size)
base::Result<std::vector<TSurf>> parse_tsurfs(std::string_view text, const std::string& file);
/// All of them as one mesh.
base::Result<mesh::PolygonMesh> parse_tsurf(std::string_view text, const std::string& file);

/// What is taken to metres from another unit: one a surface, with the line that names its units.
/// @pre the text was read
std::vector<Remark> tsurf_remarks(std::string_view text, const std::string& file);

/// With every digit: what is read from it gives the same text again. Faces of more than three corners are fans.
std::string tsurfs_text(std::span<const TSurf> surfaces);

}  // namespace dobra::io::meshes
