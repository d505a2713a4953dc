#include "quebra/sketch/svg_sketch.h"

#include <fmt/format.h>

#include <cmath>

#include "quebra/sketch/cubics.h"

namespace quebra::sketch {
namespace {

using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Orientation;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::io::drawings::SvgPath;
using dobra::io::drawings::SvgPiece;
using dobra::io::drawings::SvgPieceKind;

using Shape = decltype(Curve::shape);

/// Half axes that differ by less, as a fraction, and are as near to a right angle, make a circle.
constexpr double round = 1e-9;

Result<void> add_arc(const SvgPiece& piece, std::vector<Shape>& shapes) {
  const double size = length_squared(piece.u) + length_squared(piece.v);
  const bool circular = std::abs(length_squared(piece.u) - length_squared(piece.v)) <= round * size &&
                        std::abs(dot(piece.u, piece.v)) <= round * size;
  if (circular) {
    const bool anticlockwise = (cross(piece.u, piece.v) > 0.0) == (piece.sweep > 0.0);
    DOBRA_TRY(Arc arc, Arc::from_ends(piece.centre, piece.from, piece.to,
                                      anticlockwise ? Orientation::Anticlockwise : Orientation::Clockwise, 1e-6));
    shapes.emplace_back(std::move(arc));
    return {};
  }
  DOBRA_TRY(auto path, ellipse_arc({piece.centre, piece.u, piece.v, piece.start, piece.sweep}, piece.from, piece.to));
  DOBRA_TRY(Smooth smooth, Smooth::make(std::move(path)));
  shapes.emplace_back(std::move(smooth));
  return {};
}

/// The cubics from `piece` on that are one curve. @return the piece after them
Result<std::size_t> add_cubics(const std::vector<SvgPiece>& pieces, std::size_t piece, std::vector<Shape>& shapes) {
  std::vector<Point> chain{pieces[piece].from};
  do {
    chain.insert(chain.end(), {pieces[piece].control[0], pieces[piece].control[1], pieces[piece].to});
    ++piece;
  } while (piece < pieces.size() && pieces[piece].goes_on);
  DOBRA_TRY(auto path, bezier(std::move(chain)));
  DOBRA_TRY(Smooth smooth, Smooth::make(std::move(path)));
  shapes.emplace_back(std::move(smooth));
  return piece;
}

/// The curves of a path, in order.
Result<std::vector<Shape>> shapes_of(const SvgPath& path) {
  std::vector<Shape> shapes;
  Polyline* line = nullptr;
  for (std::size_t i = 0; i < path.pieces.size();) {
    const SvgPiece& piece = path.pieces[i];
    if (piece.kind != SvgPieceKind::Line) line = nullptr;
    if (piece.kind == SvgPieceKind::Cubic) {
      DOBRA_TRY(i, add_cubics(path.pieces, i, shapes));
      continue;
    }
    ++i;
    if (piece.kind == SvgPieceKind::Arc) {
      DOBRA_TRY_VOID(add_arc(piece, shapes));
      continue;
    }
    if (line == nullptr) {
      shapes.emplace_back(Polyline{{piece.from}, false});
      line = &std::get<Polyline>(shapes.back());
    }
    line->points.push_back(piece.to);
  }
  if (shapes.size() == 1 && line != nullptr && path.closed) {
    line->points.pop_back();
    line->closed = true;
  }
  for (Shape& shape : shapes) {
    if (const auto* own = std::get_if<Polyline>(&shape)) DOBRA_TRY_VOID(validate(*own));
  }
  return shapes;
}

}  // namespace

void scale(SvgPiece& piece, double x, double y) {
  for (Point* p : {&piece.from, &piece.to, &piece.control[0], &piece.control[1], &piece.centre})
    *p = {p->x * x, p->y * y};
  for (auto* v : {&piece.u, &piece.v}) *v = {v->x * x, v->y * y};
}

Result<Sketch> sketch_of(dobra::io::drawings::SvgFile file, double unit) {
  for (SvgPath& outline : file.paths) {
    for (SvgPiece& piece : outline.pieces) scale(piece, unit, unit);
  }
  DOBRA_TRY(Sketch sketch, sketch_of_paths(file.paths));
  sketch.remarks = std::move(file.remarks);
  // Shapes without an id name no material.
  for (Area& area : sketch.areas) {
    if (area.name.starts_with("path ")) area.name.clear();
  }
  return sketch;
}

Result<Sketch> sketch_of_paths(const std::vector<SvgPath>& paths) {
  Sketch sketch;
  dobra::base::Place last_element;
  for (const SvgPath& outline : paths) {
    auto shapes = shapes_of(outline);
    if (!shapes) return located(shapes.error(), outline.place);
    if (shapes->size() == 1 && closed({{}, Role::Boundary, shapes->front(), {}})) {
      // Further outlines of one element are holes in it.
      const bool further = !sketch.areas.empty() && outline.place.line > 0 && last_element.line == outline.place.line &&
                           last_element.column == outline.place.column;
      if (!further) sketch.areas.push_back({outline.name, {}, {}});
      sketch.areas.back().rings.push_back(outline.name);
      sketch.areas.back().outline.push_back(trace({{}, Role::Boundary, shapes->front(), {}}).line);
      last_element = outline.place;
    }
    for (std::size_t i = 0; i < shapes->size(); ++i) {
      std::string name = shapes->size() == 1 ? outline.name : fmt::format("{}_{}", outline.name, i + 1);
      sketch.curves.push_back({std::move(name), Role::Boundary, std::move((*shapes)[i]), {}});
      sketch.without_role.insert(sketch.curves.back().name);
      sketch.places.push_back(outline.place);
    }
  }
  return sketch;
}

}  // namespace quebra::sketch
