#include "recon/block/block_mesh.h"

#include <algorithm>
#include <cmath>

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
      const dobra::solid::shape::Shape shape = shape_on_map(block_, unit);
      for (std::size_t f = 0; f < shape.mesh.faces.size(); ++f) {
        std::vector<std::vector<PointId>> loops;
        for (const auto& loop : shape.mesh.faces[f]) {
          auto& corners = loops.emplace_back();
          for (const std::uint32_t p : loop) corners.push_back(space_.add(shape.mesh.points[p]));
        }
        const std::string group = without_blanks(unit.name) + ' ' + without_blanks(shape.names[f]);
        if (loops.size() == 1 && loops[0].size() <= most_corners_) {
          add(loops[0], group);
        } else if (!cut(loops, group)) {
          return base::Error{base::ErrorCode::CannotMesh, "its faces across strike cannot be cut into triangles",
                             base::Place{.item = "unit '" + unit.name + '\''}};
        }
      }
    }
    for (std::size_t p = 0; p < space_.point_count(); ++p) made_.mesh.points.push_back(space_.rounded(PointId(p)));
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

dobra::solid::shape::Shape shape_on_map(const Block& block, const BlockUnit& unit) {
  dobra::solid::shape::Shape shape = unit.shape;
  const dobra::io::lines::Trace& trace = block.trace;
  if (trace.x == 0.0 && trace.y == 0.0 && trace.north == 0.0 && trace.east == 1.0) return shape;
  if (block.sheets.empty()) {  // lofted: its faces along strike are triangles
    for (geom::Point3& p : shape.mesh.points) p = block.on_map(p);
    return shape;
  }
  // The same for all units: of the greatest coordinate that any point may have.
  double reach = std::abs(trace.x) + std::abs(trace.y) + block.length;
  for (const Sheet& sheet : block.sheets) {
    for (const geom::Point3 p : sheet.stations[0])
      reach = std::max(reach, std::abs(trace.x) + std::abs(trace.y) + block.length + std::abs(p.x));
  }
  const double grid = std::exp2(std::ceil(std::log2(reach)) - 52.0);
  const auto on_grid = [grid](double value) { return grid * std::nearbyint(value / grid); };
  const geom::Vector3 along{on_grid(-block.length * trace.north), on_grid(block.length * trace.east), 0.0};
  for (geom::Point3& p : shape.mesh.points) {
    const geom::Point3 start = block.on_map({p.x, 0.0, p.z});
    const geom::Point3 near{on_grid(start.x), on_grid(start.y), p.z};
    p = p.y == 0.0 ? near : near + along;
  }
  return shape;
}

base::Result<BlockMesh> mesh_of(const Block& block, std::size_t most_corners) {
  return Maker(block, most_corners).make();
}

}  // namespace recon::block
