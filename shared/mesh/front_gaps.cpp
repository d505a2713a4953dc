#include "shared/mesh/front_gaps.h"

#include "shared/mesh/planar_domain.h"

// 1. The sides that stand, and loose nodes, as the input of a constrained Delaunay triangulation: local numbers.
// 2. Flood from the left of every side: the gaps. A cell of a gap must end at sides that look into it.
// 3. Interior points. 4. Copy the cells, join them to what lies behind the sides.

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Progress;
using base::Result;
using Kernel = DelaunayKernel;

namespace {

class GapFiller {
 public:
  GapFiller(Kernel& kernel, Front& front) : kernel_(kernel), front_(front) {}

  Result<void> run(const SizeField& field, const FrontalOptions& options, const Progress& progress);

 private:
  void collect();
  Result<void> flood();
  void copy();
  [[nodiscard]] Kernel::Half half_of_side(std::size_t i) const {
    return gaps_.kernel.find(gaps_.vertex_of_point[input_.edges[i].nodes[0].index()],
                             gaps_.vertex_of_point[input_.edges[i].nodes[1].index()]);
  }

  Kernel& kernel_;
  Front& front_;
  std::vector<std::uint32_t> sides_;          ///< Sides of the front that stand; edge i of the input is sides_[i].
  std::vector<Kernel::Vertex> global_point_;  ///< Vertex of each input point.
  MeshInput input_;
  PlanarDomain gaps_;
};

void GapFiller::collect() {
  std::vector<std::uint32_t> local(kernel_.vertex_count(), Kernel::none);
  const auto number = [&](Kernel::Vertex v) {
    if (local[v] == Kernel::none) {
      local[v] = static_cast<std::uint32_t>(input_.points.size());
      input_.points.push_back(kernel_.point(v));
      global_point_.push_back(v);
    }
    return NodeId(local[v]);
  };
  input_.sets.push_back({"front", EdgeKind::Constraint});
  for (std::uint32_t s = 0; s < front_.sides.size(); ++s) {
    const FrontSide& side = front_.sides[s];
    if (side.from == FrontSide::free) continue;
    sides_.push_back(s);
    const NodeId from = number(side.from);
    input_.edges.push_back({{from, number(front_.to(side))}, 0});
  }
  for (const Kernel::Vertex v : front_.loose) number(v);
}

Result<void> GapFiller::flood() {
  Kernel& gaps = gaps_.kernel;
  for (Kernel::Cell c = 0; c < gaps.cell_count(); ++c) gaps.set_region(c, -1);
  std::vector<std::uint8_t> stands(4 * gaps.cell_count(), 0);
  std::vector<Kernel::Cell> todo;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Kernel::Half e = half_of_side(i);
    // An edge that passes through a node is no side.
    if (e == Kernel::none || gaps.mark(e) == 0 || stands[e] != 0) return front_crossed();
    stands[e] = 1;
    if (gaps.is_ghost(Kernel::cell_of(e))) return front_crossed();
    gaps.set_region(Kernel::cell_of(e), front_.sides[sides_[i]].region);
    todo.push_back(Kernel::cell_of(e));
  }
  while (!todo.empty()) {
    const Kernel::Cell c = todo.back();
    todo.pop_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if (gaps.mark(e) != 0) {
        if (stands[e] == 0) return front_crossed();
        continue;
      }
      const Kernel::Cell other = Kernel::cell_of(gaps.twin(e));
      if (gaps.is_ghost(other)) return front_crossed();
      if (gaps.cell(other).region >= 0) continue;
      gaps.set_region(other, gaps.cell(c).region);
      todo.push_back(other);
    }
  }
  return {};
}

void GapFiller::copy() {
  const Kernel& gaps = gaps_.kernel;
  std::vector<Kernel::Vertex> global(gaps.vertex_count(), Kernel::none);
  for (std::size_t p = 0; p < global_point_.size(); ++p) global[gaps_.vertex_of_point[p]] = global_point_[p];
  for (Kernel::Vertex v = 0; v < gaps.vertex_count(); ++v) {
    if (global[v] == Kernel::none) global[v] = kernel_.add_vertex(gaps.point(v));
  }
  std::vector<Kernel::Cell> copied(gaps.cell_count(), Kernel::none);
  for (Kernel::Cell c = 0; c < gaps.cell_count(); ++c) {
    const Kernel::Triangle& cell = gaps.cell(c);
    if (cell.region < 0) continue;
    copied[c] =
        kernel_.add_triangle(global[cell.vertex[0]], global[cell.vertex[1]], global[cell.vertex[2]], cell.region);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      const Kernel::Half f = gaps.twin(e);
      if (gaps.mark(e) != 0 || Kernel::cell_of(f) >= c) continue;
      kernel_.link(Kernel::half(copied[c], i), Kernel::half(copied[Kernel::cell_of(f)], f & 3U), 0);
    }
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Kernel::Half e = half_of_side(i);
    front_.attach(kernel_, sides_[i], Kernel::half(copied[Kernel::cell_of(e)], e & 3U));
  }
}

Result<void> GapFiller::run(const SizeField& field, const FrontalOptions& options, const Progress& progress) {
  collect();
  if (!sides_.empty()) {
    auto gaps = build_domain(input_, Outside::KeepHull, progress.part(0.0, 0.2));
    if (!gaps) return gaps.error().code == ErrorCode::Cancelled ? gaps.error() : front_crossed();
    gaps_ = std::move(*gaps);
    DOBRA_TRY_VOID(flood());
    DOBRA_TRY_VOID(place_points(gaps_.kernel, field, options, progress.part(0.2, 1.0)));
    copy();
  }
  kernel_.remove_cells(replaced_region);
  kernel_.legalise_all();
  return {};
}

}  // namespace

Result<void> fill_gaps(Kernel& kernel, Front& front, const SizeField& field, const FrontalOptions& options,
                       const Progress& progress) {
  return GapFiller(kernel, front).run(field, options, progress);
}

}  // namespace dobra::mesh
