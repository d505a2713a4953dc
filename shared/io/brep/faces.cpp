#include "shared/io/brep/faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dobra::io::brep {

using base::Result;

namespace {

constexpr std::size_t most_uses = 1'000'000;

/// The same but for rounding, by the size of what is moved.
bool same(const Placement& a, const Placement& b) {
  const double turn = std::max({length(a.x - b.x), length(a.y - b.y), length(a.z - b.z)});
  const double size = std::max({1.0, length(a.origin - geom::Point3{}), length(b.origin - geom::Point3{})});
  return turn <= 1e-9 && distance(a.origin, b.origin) <= 1e-9 * size;
}

class Walk {
 public:
  explicit Walk(const Model& model) : model_(model) {}

  Result<void> enter(const Use& use, Orientation whole, const Placement& at) {
    if (++uses_ > most_uses)
      return base::Error{base::ErrorCode::TooManyElements,
                         fmt::format("its shapes are used more than {} times in all", most_uses),
                         base::Place{.file = model_.file}};
    const Shape& shape = model_.shapes[use.shape];
    const Orientation orientation = whole * use.orientation;
    const Placement placement = at * use.placement;
    if (shape.kind == ShapeKind::Face) return add(use.shape, orientation, placement);
    if (shape.kind < ShapeKind::Face) return {};
    const bool solid = shape.kind == ShapeKind::Solid;
    if (solid) solid_ = solids_++;
    for (const Use& part : shape.parts) DOBRA_TRY_VOID(enter(part, orientation, placement));
    if (solid) solid_.reset();
    return {};
  }

  std::vector<TrimmedFace> faces;

 private:
  Result<void> add(Index number, Orientation orientation, const Placement& at) {
    const Shape& shape = model_.shapes[number];
    const Face& face = std::get<Face>(shape.is);
    const base::Place place{.file = model_.file, .line = shape.line, .item = fmt::format("face {}", faces.size() + 1)};
    TrimmedFace trimmed{
        number, face.surface, at * face.placement, orientation == Orientation::Reversed, face.natural, solid_,
        {},     place};
    for (const Use& part : shape.parts) {
      if (model_.shapes[part.shape].kind != ShapeKind::Wire) continue;  // an edge or a vertex by itself bounds nothing
      std::vector<LoopEdge> loop;
      add_edges(part, Orientation::Forward, {}, trimmed, at, loop);
      uses_ += loop.size();
      trimmed.loops.push_back(std::move(loop));
    }
    faces.push_back(std::move(trimmed));
    return {};
  }

  /// @param within  where the wire lies in the face's own frame.
  void add_edges(const Use& use, Orientation whole, const Placement& within, const TrimmedFace& face,
                 const Placement& at, std::vector<LoopEdge>& loop) const {
    const Orientation orientation = whole * use.orientation;
    const Placement placement = within * use.placement;
    const Shape& shape = model_.shapes[use.shape];
    if (shape.kind == ShapeKind::Wire) {
      for (const Use& part : shape.parts) add_edges(part, orientation, placement, face, at, loop);
    } else if (const Edge* edge = std::get_if<Edge>(&shape.is)) {
      loop.push_back({use.shape, orientation, at * placement,
                      chart_part(*edge, face, orientation == Orientation::Reversed, placement)});
    }
  }

  [[nodiscard]] std::optional<ChartPart> chart_part(const Edge& edge, const TrimmedFace& face, bool reversed,
                                                    const Placement& within) const {
    const Placement& own = std::get<Face>(model_.shapes[face.shape].is).placement;
    for (const ChartCurve& on : edge.chart_curves) {
      if (on.surface != face.surface || !same(within * on.placement, own)) continue;
      return ChartPart{reversed && on.reversed ? *on.reversed : on.curve, on.from, on.to};
    }
    return std::nullopt;
  }

  const Model& model_;
  std::size_t uses_ = 0, solids_ = 0;
  std::optional<std::size_t> solid_;  // that is being walked through
};

}  // namespace

Result<std::vector<TrimmedFace>> faces_of(const Model& model) {
  Walk walk(model);
  DOBRA_TRY_VOID(walk.enter(model.root, Orientation::Forward, {}));
  if (walk.faces.empty())
    return base::Error{base::ErrorCode::BadFormat, "the file has no face, only curves or points; save faces with it",
                       base::Place{.file = model.file}};
  if (std::none_of(walk.faces.begin(), walk.faces.end(), [](const TrimmedFace& f) { return f.surface.has_value(); }))
    return base::Error{base::ErrorCode::BadFormat,
                       "this face has no surface, only triangles; save the model with its surfaces",
                       walk.faces.front().place};
  return std::move(walk.faces);
}

}  // namespace dobra::io::brep
