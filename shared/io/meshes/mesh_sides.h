#pragma once
// Which element has a given directed edge as a side; for the mesh formats that know sets of edges, not of sides.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/heights.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

class MeshSides {
 public:
  /// @cost O(n log n) for n elements.
  explicit MeshSides(const mesh::ElementMesh& mesh);
  /// The side of the element on the left of `edge`; the one of lowest id if the mesh is wrong and has several. O(log
  /// n).
  [[nodiscard]] std::optional<mesh::ElementSide> left_of(const mesh::Edge& edge) const;

 private:
  std::vector<std::pair<std::uint64_t, mesh::ElementSide>> sides_;  // (from, to), ascending
};

/// What every writer asks first. @error CannotMesh: no elements; NotFinite; InvalidOption: a set or tip that refers to
/// what does not exist.
base::Result<void> check_writable(const mesh::ElementMesh& mesh, Heights heights = {});

/// For writers of names as text. @error InvalidOption: a name of a set or region with one of `forbidden`.
/// @param where  what it cannot stand in, and @param advice  what to use.
base::Result<void> check_names(const mesh::ElementMesh& mesh, std::string_view forbidden, std::string_view where,
                               std::string_view advice);

using EdgeSets = std::map<std::string, std::vector<mesh::Edge>>;

struct Finished {
  std::size_t lost = 0;                 ///< Edges that are no side of any element.
  std::vector<mesh::ElementId> turned;  ///< Elements that were clockwise, ascending.
};

/// For readers, last: turns clockwise elements, makes side sets of the edges (the element on the left, or else on the
/// right), and finds the tips of cracks by their names. Of a mesh in space it turns none.
Finished finish(mesh::ElementMesh& mesh, const EdgeSets& sets, Heights heights = {});

}  // namespace dobra::io::meshes
