#pragma once
// The filling of gaps of front_gaps.h in a space of its own: the plane, or a surface (space.h). What crosses is found
// in the chart.

#include <algorithm>
#include <memory>
#include <vector>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"
#include "shared/mesh/delaunay/planar_domain.h"
#include "shared/mesh/front/front_gaps.h"
#include "shared/mesh/front/point_placer.h"
#include "shared/mesh/front/retreat.h"

// 1. The sides that stand, and loose nodes, as the input of a constrained Delaunay triangulation: local numbers.
// 2. Flood from the left of every side: the gaps. A cell of a gap must end at sides that look into it, and every loose
//    node be in a gap or in a triangle of the front.
// 3. Where 1 or 2 fail, the triangles behind the sides to blame are removed: one layer the first time, then two, four,
//    and so on. What they leave are sides again. Back to 1.
// 4. Interior points. 5. Copy the cells, join them to what lies behind the sides.

namespace dobra::mesh::front {

template <class Space>
class GapFiller final : public FillEngine {
 public:
  using Kernel = delaunay::DelaunayKernel;

  GapFiller(Kernel& kernel, Space& space, Front& front, const sizing::SizeField& field, const FrontalOptions& options)
      : kernel_(kernel), space_(space), front_(front), field_(field), options_(options) {}

  base::Result<void> step(std::size_t count, const base::Progress& progress) override;
  [[nodiscard]] bool done() const override { return done_; }
  [[nodiscard]] std::vector<geom::Segment> front() const override;

 private:
  void take_front();
  base::Result<void> triangulate(const base::Progress& progress);
  base::Result<void> enter_space();
  void collect();
  std::vector<std::uint32_t> crossed() const;
  std::vector<std::uint32_t> flood();
  [[nodiscard]] std::vector<Kernel::Vertex> covered() const;
  [[nodiscard]] std::vector<std::uint32_t> nearest_to(const std::vector<Kernel::Vertex>& nodes) const;
  void copy();
  [[nodiscard]] Kernel::Half half_of_side(std::size_t s) const {
    const Kernel::Vertex from = gaps_.vertex_of_point[input_.edges[s].nodes[0].index()];
    return gaps_.kernel.find(from, gaps_.vertex_of_point[input_.edges[s].nodes[1].index()]);
  }

  static constexpr std::uint32_t none = Kernel::none;

  Kernel& kernel_;
  Space& space_;
  Front& front_;
  const sizing::SizeField& field_;
  const FrontalOptions& options_;
  std::vector<GapSide> sides_;                ///< Edge i of the input is sides_[i].
  std::vector<Kernel::Vertex> global_point_;  ///< Vertex of each input point.
  delaunay::MeshInput input_;
  delaunay::PlanarDomain gaps_;
  Space gap_space_;
  std::unique_ptr<FillEngine> points_;
  bool retreated_ = false;
  bool done_ = false;
};

template <class Space>
void GapFiller<Space>::take_front() {
  std::vector<std::uint32_t> number(front_.sides.size(), none);
  const auto standing = [](const FrontSide& side) { return side.from != FrontSide::free; };
  sides_.reserve(static_cast<std::size_t>(std::count_if(front_.sides.begin(), front_.sides.end(), standing)));
  for (std::uint32_t s = 0; s < front_.sides.size(); ++s) {
    const FrontSide& side = front_.sides[s];
    if (side.from == FrontSide::free) continue;
    number[s] = static_cast<std::uint32_t>(sides_.size());
    sides_.push_back({side.from, front_.to(side), none, none, side.region, side.mark});
  }
  for (std::uint32_t s = 0; s < front_.sides.size(); ++s) {
    if (number[s] == none) continue;
    GapSide& side = sides_[number[s]];
    (front_.sides[s].paired ? side.partner : side.back) =
        front_.sides[s].paired ? number[front_.sides[s].back] : front_.sides[s].back;
  }
  front_.sides = std::vector<FrontSide>();
}

template <class Space>
void GapFiller<Space>::collect() {
  input_ = {};
  global_point_.clear();
  std::vector<std::uint32_t> local(kernel_.vertex_count(), none);
  const auto number = [&](Kernel::Vertex v) {
    if (local[v] == none) {
      local[v] = static_cast<std::uint32_t>(input_.points.size());
      input_.points.push_back(kernel_.point(v));
      global_point_.push_back(v);
    }
    return NodeId(local[v]);
  };
  input_.sets.push_back({"front", delaunay::EdgeKind::Constraint});
  for (const GapSide& side : sides_) {
    const NodeId from = number(side.from);
    input_.edges.push_back({{from, number(side.to)}, 0});
  }
  for (const Kernel::Vertex v : front_.loose) number(v);
}

/// Sides that meet others elsewhere than at a node they share, and sides at nodes that stand in the same place.
template <class Space>
std::vector<std::uint32_t> GapFiller<Space>::crossed() const {
  const auto meets = [&](std::size_t s, std::size_t t) {
    const GapSide& a = sides_[s];
    const GapSide& b = sides_[t];
    if (a.from == b.to && a.to == b.from) return false;
    const geom::Segment first{kernel_.point(a.from), kernel_.point(a.to)};
    const geom::Segment second{kernel_.point(b.from), kernel_.point(b.to)};
    const bool share = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
    const auto kind = geom::intersect(first, second).kind;
    return share ? kind == geom::IntersectionKind::Overlap : kind != geom::IntersectionKind::None;
  };
  std::vector<geom::Box> boxes;
  for (const GapSide& side : sides_)
    boxes.push_back(geom::Segment{kernel_.point(side.from), kernel_.point(side.to)}.box());
  std::vector<std::uint32_t> wrong;
  for (const auto& [s, t] : geom::SpatialIndex(boxes).overlapping_pairs()) {
    if (meets(s, t)) wrong.insert(wrong.end(), {static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(t)});
  }
  return wrong;
}

/// Marks the gaps. @return the sides that cannot be: beside no triangle, or with another gap behind them.
template <class Space>
std::vector<std::uint32_t> GapFiller<Space>::flood() {
  Kernel& gaps = gaps_.kernel;
  std::vector<std::uint32_t> wrong;
  for (Kernel::Cell c = 0; c < gaps.cell_count(); ++c) gaps.set_region(c, -1);
  std::vector<std::uint32_t> side_of(4 * gaps.cell_count(), none);
  std::vector<std::uint32_t> reached_from(gaps.cell_count(), none);
  std::vector<Kernel::Cell> todo;
  for (std::uint32_t s = 0; s < sides_.size(); ++s) {
    const Kernel::Half e = half_of_side(s);
    // An edge that passes through a node is no side.
    if (e == none || gaps.mark(e) == 0 || side_of[e] != none || gaps.is_ghost(Kernel::cell_of(e))) {
      wrong.push_back(s);
      continue;
    }
    side_of[e] = s;
    const Kernel::Cell c = Kernel::cell_of(e);
    if (reached_from[c] != none) continue;
    gaps.set_region(c, sides_[s].region);
    reached_from[c] = s;
    todo.push_back(c);
  }
  while (!todo.empty()) {
    const Kernel::Cell c = todo.back();
    todo.pop_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      const Kernel::Cell other = Kernel::cell_of(gaps.twin(e));
      if (gaps.mark(e) != 0 || gaps.is_ghost(other)) {
        if (gaps.mark(e) != 0 && side_of[e] != none) continue;
        wrong.push_back(reached_from[c]);
        if (gaps.mark(e) != 0 && side_of[gaps.twin(e)] != none) wrong.push_back(side_of[gaps.twin(e)]);
        continue;
      }
      if (reached_from[other] != none) continue;
      gaps.set_region(other, gaps.cell(c).region);
      reached_from[other] = reached_from[c];
      todo.push_back(other);
    }
  }
  return wrong;
}

/// Loose nodes that neither a triangle of the front has nor a gap: the front went over them.
template <class Space>
std::vector<delaunay::DelaunayKernel::Vertex> GapFiller<Space>::covered() const {
  std::vector<std::uint8_t> held(kernel_.vertex_count(), 0);
  const auto hold = [&](const Kernel& kernel, const auto& number_of) {
    for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
      if (kernel.cell(c).region < 0) continue;
      for (const Kernel::Vertex v : kernel.cell(c).vertex) held[number_of(v)] = 1;
    }
  };
  hold(kernel_, [](Kernel::Vertex v) { return v; });
  if (!sides_.empty()) {
    std::vector<Kernel::Vertex> global(gaps_.kernel.vertex_count(), 0);
    for (std::size_t p = 0; p < global_point_.size(); ++p) global[gaps_.vertex_of_point[p]] = global_point_[p];
    hold(gaps_.kernel, [&](Kernel::Vertex v) { return global[v]; });
  }
  std::vector<Kernel::Vertex> nodes;
  for (const Kernel::Vertex v : front_.loose) {
    if (held[v] == 0) nodes.push_back(v);
  }
  return nodes;
}

/// The sides nearest to nodes.
template <class Space>
std::vector<std::uint32_t> GapFiller<Space>::nearest_to(const std::vector<Kernel::Vertex>& nodes) const {
  std::vector<std::uint32_t> nearest;
  for (const Kernel::Vertex v : nodes) {
    const auto distance = [&](const GapSide& side) {
      return geom::distance(geom::Segment{kernel_.point(side.from), kernel_.point(side.to)}, kernel_.point(v));
    };
    const auto found = std::min_element(sides_.begin(), sides_.end(),
                                        [&](const GapSide& a, const GapSide& b) { return distance(a) < distance(b); });
    nearest.push_back(static_cast<std::uint32_t>(found - sides_.begin()));
  }
  return nearest;
}

/// Steps 1 to 3.
template <class Space>
base::Result<void> GapFiller<Space>::triangulate(const base::Progress& progress) {
  for (int layers = 1;; layers *= 2) {
    collect();
    if (sides_.empty()) {
      if (!covered().empty()) return front_crossed();
      global_point_.clear();  // nodes of the front
      return enter_space();
    }
    auto gaps = build_domain(input_, delaunay::Outside::KeepHull, progress);
    if (!gaps && gaps.error().code == base::ErrorCode::Cancelled) return gaps.error();
    std::vector<std::uint32_t> wrong;
    if (gaps && gaps->kernel.vertex_count() == input_.points.size()) {
      gaps_ = std::move(*gaps);
      wrong = flood();
      if (wrong.empty()) wrong = nearest_to(covered());
      if (wrong.empty()) return enter_space();
    } else {
      wrong = crossed();
    }
    if (Retreat(kernel_, sides_).run(std::move(wrong), layers) == 0) return front_crossed();
    retreated_ = true;
  }
}

/// The nodes of the gaps are nodes of the space.
template <class Space>
base::Result<void> GapFiller<Space>::enter_space() {
  std::vector<Kernel::Vertex> node(gaps_.kernel.vertex_count(), none);
  for (std::size_t p = 0; p < global_point_.size(); ++p) node[gaps_.vertex_of_point[p]] = global_point_[p];
  gap_space_ = space_.part(gaps_.kernel, node);
  if constexpr (Space::curved) {
    gap_space_.rule();
    gaps_.kernel.legalise_all();
  }
  return {};
}

/// The last of the cells go into those that the front has replaced, as long as there are such.
template <class Space>
void GapFiller<Space>::copy() {
  if (sides_.empty()) return;
  const Kernel& gaps = gaps_.kernel;
  std::vector<Kernel::Cell> spare;
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (kernel_.cell(c).region == replaced_region) spare.push_back(c);
  }
  std::vector<Kernel::Cell> inside;
  for (Kernel::Cell c = 0; c < gaps.cell_count(); ++c) {
    if (gaps.cell(c).region >= 0) inside.push_back(c);
  }
  const std::size_t appended = inside.size() - std::min(inside.size(), spare.size());
  kernel_.reserve(kernel_.vertex_count() + gaps.vertex_count() - global_point_.size(), kernel_.cell_count() + appended);
  std::vector<Kernel::Vertex> global(gaps.vertex_count(), none);
  for (std::size_t p = 0; p < global_point_.size(); ++p) global[gaps_.vertex_of_point[p]] = global_point_[p];
  for (Kernel::Vertex v = 0; v < gaps.vertex_count(); ++v) {
    if (global[v] == none) global[v] = space_.take(gap_space_, v);
  }
  std::vector<Kernel::Cell> copied(gaps.cell_count(), none);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const Kernel::Cell from = inside[i < appended ? i : inside.size() - 1 - (i - appended)];
    const auto& [vertex, twin, region, mark] = gaps.cell(from);
    const std::array<Kernel::Vertex, 3> corner{global[vertex[0]], global[vertex[1]], global[vertex[2]]};
    if (i < appended) {
      copied[from] = kernel_.add_triangle(corner[0], corner[1], corner[2], region);
    } else {
      copied[from] = spare[i - appended];
      kernel_.replace_triangle(copied[from], corner[0], corner[1], corner[2], region);
    }
  }
  for (const Kernel::Cell c : inside) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      const Kernel::Half f = gaps.twin(e);
      if (gaps.mark(e) != 0 || Kernel::cell_of(f) >= c) continue;
      kernel_.link(Kernel::half(copied[c], i), Kernel::half(copied[Kernel::cell_of(f)], f & 3U), 0);
    }
  }
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    const Kernel::Half e = half_of_side(s);
    const Kernel::Half half = Kernel::half(copied[Kernel::cell_of(e)], e & 3U);
    const GapSide& side = sides_[s];
    if (side.partner == none) {
      kernel_.link(half, side.back, side.mark);
    } else {
      sides_[side.partner].back = half;
      sides_[side.partner].partner = none;
    }
  }
}

template <class Space>
base::Result<void> GapFiller<Space>::step(std::size_t count, const base::Progress& progress) {
  if (!points_) {
    take_front();
    DOBRA_TRY_VOID(triangulate(progress.part(0.0, 0.2)));
    points_ = std::make_unique<PointPlacer<Space>>(gaps_.kernel, gap_space_, field_, options_);
  } else if (!points_->done()) {
    return points_->step(count, progress.part(0.2, 1.0));
  } else {
    points_.reset();
    copy();
    kernel_.remove_cells(replaced_region);
    if (retreated_) kernel_.renew_half_of();
    kernel_.legalise_all();
    done_ = true;
  }
  return {};
}

template <class Space>
std::vector<geom::Segment> GapFiller<Space>::front() const {
  if (points_) return points_->front();
  std::vector<geom::Segment> sides;
  for (const FrontSide& side : front_.sides) {
    if (side.from != FrontSide::free) sides.push_back({kernel_.point(side.from), kernel_.point(front_.to(side))});
  }
  return sides;
}

}  // namespace dobra::mesh::front
