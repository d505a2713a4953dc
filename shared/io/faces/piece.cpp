#include "shared/io/faces/piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/geom/predicates.h"

namespace dobra::io::faces {

using geom::Point;
using geom::Point3;

Piece turned(Piece piece) {
  std::swap(piece.from, piece.to);
  std::swap(piece.start, piece.end);
  piece.against = !piece.against;
  return piece;
}

Loop turned(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  for (Piece& piece : loop) piece = turned(std::move(piece));
  return loop;
}

Piece shifted(Piece piece, geom::Vector by) {
  if (by == geom::Vector{}) return piece;
  piece.curve = piece.curve.moved({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {by.x, by.y, 0.0});
  return piece;
}

Loop shifted(Loop loop, geom::Vector by) {
  for (Piece& piece : loop) piece = shifted(std::move(piece), by);
  return loop;
}

Piece straight(Point from, Point to) {
  const auto line = surf::Curve::line({from.x, from.y, 0.0}, {to.x, to.y, 0.0});
  DOBRA_CHECK(line.ok());
  return {.curve = *line};
}

Piece reaching(const Piece& piece, Point begin, Point end) {
  Piece made = piece;
  const bool forward = piece.from < piece.to;
  const Point low = forward ? begin : end, high = forward ? end : begin;
  made.curve = piece.curve.reaching(std::min(piece.from, piece.to), {low.x, low.y, 0.0}, std::max(piece.from, piece.to),
                                    {high.x, high.y, 0.0});
  return made;
}

std::vector<double> parameters_along(const Piece& piece, int parts) {
  const double low = std::min(piece.from, piece.to), high = std::max(piece.from, piece.to);
  std::vector<double> knots{low};
  for (const double at : piece.curve.breaks()) {
    if (at > low && at < high) knots.push_back(at);
  }
  knots.push_back(high);
  std::vector<double> all{low};
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const int count = piece.curve.bend(knots[i - 1], knots[i]) == 0.0 ? 1 : parts;
    for (int k = 1; k < count; ++k) all.push_back(std::lerp(knots[i - 1], knots[i], static_cast<double>(k) / count));
    all.push_back(knots[i]);
  }
  if (piece.from > piece.to) std::reverse(all.begin(), all.end());
  return all;
}

std::vector<Point> spread(const Piece& piece) {
  constexpr int places = 16;
  std::vector<Point> all;
  for (const double t : parameters_along(piece)) all.push_back(piece.at(t));
  for (int i = 1; i < places; ++i) all.push_back(piece.at(std::lerp(piece.from, piece.to, i / 16.0)));
  return all;
}

std::vector<Point> outline(const Loop& loop) {
  std::vector<Point> places;
  for (const Piece& piece : loop) {
    const std::vector<double> along = parameters_along(piece);
    for (std::size_t i = 0; i + 1 < along.size(); ++i) places.push_back(piece.at(along[i]));
  }
  return places;
}

double area_of(const std::vector<Point>& outline) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    sum += 0.5 * cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return sum;
}

bool inside(const std::vector<Point>& outline, Point at) {
  bool in = false;
  for (std::size_t i = 0, last = outline.size() - 1; i < outline.size(); last = i++) {
    const Point a = outline[last], b = outline[i];
    if ((a.y > at.y) == (b.y > at.y)) continue;
    const geom::Sign side = geom::orient2d(a, b, at);
    if (side == (b.y > a.y ? geom::Sign::Positive : geom::Sign::Negative)) in = !in;
  }
  return in;
}

void Report::say(std::string code, std::string message, std::optional<Point> uv, std::optional<Point3> at) {
  findings_.push_back({std::move(code), std::move(message), place(uv, at)});
}

base::Place Report::place(std::optional<Point> uv, std::optional<Point3> at) const {
  base::Place made = place_;
  if (uv) made.u = uv->x, made.v = uv->y;
  if (at) made.x = at->x, made.y = at->y, made.z = at->z;
  return made;
}

}  // namespace dobra::io::faces
