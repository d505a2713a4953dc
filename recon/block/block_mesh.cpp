#include "recon/block/block_mesh.h"

#include <algorithm>
#include <unordered_map>

#include "shared/solid/triangulate.h"

namespace recon::block {
namespace {

using dobra::solid::PointId;

std::string without_blanks(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  return name;
}

class Maker {
 public:
  Maker(const Block& block, std::size_t most_corners) : block_(block), most_corners_(most_corners) {}

  base::Result<BlockMesh> make() {
    for (const BlockUnit& unit : block_.units) {
      for (std::size_t f = 0; f < unit.shape.mesh.faces.size(); ++f) {
        std::vector<std::vector<PointId>> loops;
        for (const auto& loop : unit.shape.mesh.faces[f]) {
          auto& corners = loops.emplace_back();
          for (const std::uint32_t p : loop) corners.push_back(space_.add(unit.shape.mesh.points[p]));
        }
        const std::string group = without_blanks(unit.name) + ' ' + without_blanks(unit.shape.names[f]);
        if (loops.size() == 1 && loops[0].size() <= most_corners_) {
          add(loops[0], group);
        } else if (!cut(loops, group)) {
          return base::Error{base::ErrorCode::CannotMesh, "its faces across strike cannot be cut into triangles",
                             base::Place{.item = "unit '" + unit.name + '\''}};
        }
      }
    }
    for (std::size_t p = 0; p < space_.point_count(); ++p)
      made_.mesh.points.push_back(block_.on_map(space_.rounded(PointId(p))));
    return std::move(made_);
  }

 private:
  template <class Corners>
  void add(const Corners& corners, const std::string& group) {
    auto& face = made_.mesh.faces.emplace_back();
    for (const PointId p : corners) face.push_back(static_cast<std::uint32_t>(p.index()));
    made_.groups.push_back(group);
  }

  bool cut(const std::vector<std::vector<PointId>>& loops, const std::string& group) {
    const auto& outer = loops[0];
    for (std::size_t i = 1; i + 1 < outer.size(); ++i) {
      if (space_.collinear(outer[0], outer[i], outer[i + 1])) continue;
      const auto plane =
          space_.add({{space_.rounded(outer[0]), space_.rounded(outer[i]), space_.rounded(outer[i + 1])}, {}});
      dobra::solid::Projection onto = space_.projection(plane);
      if (!runs_left(space_, onto, outer)) std::swap(onto.u, onto.v);
      const auto triangles = triangulate(space_, onto, loops);
      if (!triangles) return false;
      for (const auto& triangle : *triangles) add(triangle, group);
      return true;
    }
    return false;
  }

  const Block& block_;
  std::size_t most_corners_;
  dobra::solid::Space space_;
  BlockMesh made_;
};

}  // namespace

base::Result<BlockMesh> mesh_of(const Block& block, std::size_t most_corners) {
  return Maker(block, most_corners).make();
}

}  // namespace recon::block
