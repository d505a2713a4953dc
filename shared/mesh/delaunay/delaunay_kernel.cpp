#include "shared/mesh/delaunay/delaunay_kernel.h"

#include <algorithm>

#include "shared/base/check.h"
#include "shared/mesh/delaunay/filtered_predicates.h"

// Key: a half-edge e runs from origin(e) to target(e) with its cell on the left; apex(e) is the third vertex of that
// cell.

namespace dobra::mesh::delaunay {

using geom::Point;
using geom::Sign;

bool DelaunayKernel::is_ghost(Cell c) const {
  const auto& v = cells_[c].vertex;
  return v[0] == at_infinity || v[1] == at_infinity || v[2] == at_infinity;
}

void DelaunayKernel::set_vertex(Half e, Vertex v) {
  cells_[cell_of(e)].vertex[e & 3U] = v;
  if (v != at_infinity) half_of_[v] = e;
}

void DelaunayKernel::link(Half e, Half f, Mark mark) {
  cells_[cell_of(e)].twin[e & 3U] = f;
  cells_[cell_of(e)].mark[e & 3U] = mark;
  if (f == none) return;
  cells_[cell_of(f)].twin[f & 3U] = e;
  cells_[cell_of(f)].mark[f & 3U] = mark;
}

DelaunayKernel::Vertex DelaunayKernel::add_vertex(Point p) {
  points_.push_back(p);
  half_of_.push_back(none);
  return static_cast<Vertex>(points_.size() - 1);
}

DelaunayKernel::Cell DelaunayKernel::add_triangle(Vertex a, Vertex b, Vertex c, std::int32_t region) {
  const Cell cell = add_cell(region);
  replace_triangle(cell, a, b, c, region);
  return cell;
}

void DelaunayKernel::replace_triangle(Cell cell, Vertex a, Vertex b, Vertex c, std::int32_t region) {
  cells_[cell] = {{a, b, c}, {none, none, none}, region, {}};
  half_of_[a] = half(cell, 0);
  half_of_[b] = half(cell, 1);
  half_of_[c] = half(cell, 2);
}

void DelaunayKernel::remove_cells(std::int32_t region) {
  Cell last = static_cast<Cell>(cells_.size());
  for (Cell c = 0; c < last; ++c) {
    if (cells_[c].region != region) continue;
    do {
      --last;
    } while (last > c && cells_[last].region == region);
    if (last == c) break;
    cells_[c] = cells_[last];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Half other = cells_[c].twin[i];
      if (other != none) cells_[cell_of(other)].twin[other & 3U] = half(c, i);
      if (cells_[c].vertex[i] != at_infinity) half_of_[cells_[c].vertex[i]] = half(c, i);
    }
  }
  cells_.resize(last);
}

void DelaunayKernel::renew_half_of() {
  half_of_.assign(points_.size(), none);
  for (Cell c = 0; c < cells_.size(); ++c) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (cells_[c].vertex[i] != at_infinity) half_of_[cells_[c].vertex[i]] = half(c, i);
    }
  }
}

DelaunayKernel::Cell DelaunayKernel::add_cell(std::int32_t region) {
  cells_.push_back({{none, none, none}, {none, none, none}, region, {}});
  return static_cast<Cell>(cells_.size() - 1);
}

void DelaunayKernel::reserve(std::size_t points, std::size_t cells) {
  points_.reserve(points);
  half_of_.reserve(points);
  cells_.reserve(cells);
}

void DelaunayKernel::set_mark(Half e, Mark mark) { link(e, twin(e), mark); }

std::uint32_t DelaunayKernel::random() {
  random_state_ ^= random_state_ << 13U;
  random_state_ ^= random_state_ >> 17U;
  random_state_ ^= random_state_ << 5U;
  return random_state_;
}

void DelaunayKernel::start(Point a, Point b, Point c) {
  DOBRA_CHECK(points_.empty() && filtered_orientation(a, b, c) == Sign::Positive);
  points_ = {a, b, c};
  half_of_.assign(3, none);
  const Cell real = add_cell(0);
  for (std::uint32_t i = 0; i < 3; ++i) set_vertex(half(real, i), i);
  std::array<Cell, 3> ghost{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    // The ghost beyond side i runs along it the other way, with infinity on its left.
    ghost[i] = add_cell(-1);
    cells_[ghost[i]].vertex = {(i + 1) % 3, i, at_infinity};
    link(half(real, i), half(ghost[i], 0), 0);
  }
  for (std::uint32_t i = 0; i < 3; ++i) link(half(ghost[i], 1), half(ghost[(i + 2) % 3], 2), 0);
}

void DelaunayKernel::take(std::vector<Point> points, std::span<const std::array<Vertex, 3>> corners) {
  DOBRA_CHECK(points_.empty());
  points_ = std::move(points);
  half_of_.assign(points_.size(), none);
  // The half-edges that start at each vertex and have met no twin yet, as linked lists.
  std::vector<Half> head(points_.size(), none);
  std::vector<Half> rest(4 * corners.size(), none);
  cells_.reserve(corners.size());
  for (const auto& corner : corners) {
    const Cell c = add_cell(0);
    for (std::uint32_t i = 0; i < 3; ++i) set_vertex(half(c, i), corner[i]);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Half e = half(c, i);
      Half* other = &head[corner[(i + 1) % 3]];
      while (*other != none && target(*other) != corner[i]) other = &rest[*other];
      if (*other != none) {
        link(e, *other, 0);
        *other = rest[*other];
      } else {
        rest[e] = head[corner[i]];
        head[corner[i]] = e;
      }
    }
  }
}

DelaunayKernel::Half DelaunayKernel::find(Vertex a, Vertex b) const {
  const Half first = half_of_[a];
  Half e = first;
  do {
    if (target(e) == b) return e;
    e = around(e);
  } while (e != first && e != none);
  return none;
}

bool DelaunayKernel::in_circle(Cell c, Point p) const {
  const auto& v = cells_[c].vertex;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (v[i] != at_infinity) continue;
    return filtered_orientation(points_[v[(i + 1) % 3]], points_[v[(i + 2) % 3]], p) == Sign::Positive;
  }
  return filtered_incircle(points_[v[0]], points_[v[1]], points_[v[2]], p) == Sign::Positive;
}

// ---- location ----

DelaunayKernel::Location DelaunayKernel::brute_force(Point p) const {
  for (Cell c = 0; c < cells_.size(); ++c) {
    if (is_ghost(c)) continue;
    std::uint32_t on = 0;
    Half zero = none;
    bool outside = false;
    for (std::uint32_t i = 0; i < 3 && !outside; ++i) {
      const Sign sign = filtered_orientation(points_[origin(half(c, i))], points_[target(half(c, i))], p);
      outside = sign == Sign::Negative;
      if (sign != Sign::Zero) continue;
      zero = on == 1 && next(half(c, i)) == zero ? zero : half(c, i);
      ++on;
    }
    if (outside) continue;
    if (on == 0) return {Where::Inside, half(c, 0)};
    // Two sides meet at the vertex where the later one (in the order of travel) starts.
    return {on == 1 ? Where::OnSide : Where::OnVertex, zero};
  }
  for (Cell c = 0; c < cells_.size(); ++c) {
    if (is_ghost(c) && in_circle(c, p)) return {Where::Outside, half(c, 0)};
  }
  return {Where::Blocked, none};
}

DelaunayKernel::Location DelaunayKernel::locate(Point p, Cell start, Walls walls) {
  if (is_ghost(start)) {
    const auto& v = cells_[start].vertex;
    std::uint32_t i = 0;
    while (v[i] != at_infinity) ++i;
    start = cell_of(twin(half(start, (i + 1) % 3)));
  }
  Cell c = start;
  Half entered = none;
  // The walk ends with probability 1; where marked sides make it wander, a linear search ends it for certain.
  for (std::size_t steps = 0; steps <= 4 * cells_.size() + 64; ++steps) {
    const std::uint32_t first = random() % 3;
    std::uint32_t zeros = 0;
    Half zero = none;
    Half out = none;
    for (std::uint32_t k = 0; k < 3 && out == none; ++k) {
      const Half e = half(c, (first + k) % 3);
      if (e == entered) continue;
      const Sign sign = filtered_orientation(points_[origin(e)], points_[target(e)], p);
      if (sign == Sign::Negative) out = e;
      if (sign != Sign::Zero) continue;
      zero = zeros == 1 && next(e) == zero ? zero : e;
      ++zeros;
    }
    if (out == none) {
      if (zeros == 0) return {Where::Inside, half(c, 0)};
      return {zeros == 1 ? Where::OnSide : Where::OnVertex, zero};
    }
    if (walls == Walls::Stop && mark(out) != 0) return {Where::Blocked, out};
    entered = twin(out);
    if (entered == none) return {Where::Outside, out};
    c = cell_of(entered);
    if (is_ghost(c)) return {Where::Outside, entered};
  }
  return walls == Walls::Stop ? Location{Where::Blocked, none} : brute_force(p);
}

// ---- insertion ----

// e: a -> b with apex c, its twin b -> a with apex d. Afterwards e: d -> c and twin: c -> d.
void DelaunayKernel::flip(Half e) {
  const Half f = twin(e);
  const Half e1 = next(e);
  const Half e2 = previous(e);
  const Half f1 = next(f);
  const Half f2 = previous(f);
  const Vertex a = origin(e);
  const Vertex b = origin(f);
  const Vertex c = origin(e2);
  const Vertex d = origin(f2);
  const std::array<Half, 4> outer{twin(e1), twin(e2), twin(f1), twin(f2)};
  const std::array<Mark, 4> marks{mark(e1), mark(e2), mark(f1), mark(f2)};
  set_vertex(e, d);
  set_vertex(e1, c);
  set_vertex(e2, a);
  set_vertex(f, c);
  set_vertex(f1, d);
  set_vertex(f2, b);
  link(e, f, 0);
  link(e1, outer[1], marks[1]);
  link(e2, outer[2], marks[2]);
  link(f1, outer[3], marks[3]);
  link(f2, outer[0], marks[0]);
}

bool DelaunayKernel::must_flip(Half e) const {
  const Half f = twin(e);
  if (f == none || mark(e) != 0) return false;
  const Vertex a = origin(e);
  const Vertex b = origin(f);
  const Vertex c = apex(e);
  const Vertex d = apex(f);
  if (c == at_infinity || d == at_infinity) return false;
  if (b == at_infinity) return filtered_orientation(points_[c], points_[a], points_[d]) == Sign::Positive;
  if (a == at_infinity) return filtered_orientation(points_[d], points_[b], points_[c]) == Sign::Positive;
  if (rule_ != nullptr)
    return cells_[cell_of(e)].region >= 0 && cells_[cell_of(f)].region >= 0 && rule_->flips(a, b, c, d);
  return filtered_incircle(points_[a], points_[b], points_[c], points_[d]) == Sign::Positive;
}

/// Empties the stack, whose half-edges all have `p` as apex.
void DelaunayKernel::legalise(Vertex p) {
  while (!stack_.empty()) {
    const Half e = stack_.back();
    stack_.pop_back();
    if (apex(e) != p || !must_flip(e)) continue;
    const Half f = twin(e);
    flip(e);
    stack_.push_back(previous(e));
    stack_.push_back(next(f));
  }
}

void DelaunayKernel::split_cell(Cell c, Vertex p) {
  const Triangle old = cells_[c];
  const std::array<Cell, 3> part{c, add_cell(old.region), add_cell(old.region)};
  for (std::uint32_t i = 0; i < 3; ++i) {
    set_vertex(half(part[i], 0), old.vertex[i]);
    set_vertex(half(part[i], 1), old.vertex[(i + 1) % 3]);
    set_vertex(half(part[i], 2), p);
    link(half(part[i], 0), old.twin[i], old.mark[i]);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    link(half(part[i], 1), half(part[(i + 1) % 3], 2), 0);
    stack_.push_back(half(part[i], 0));
  }
}

// e: a -> b, apex c; f: b -> a, apex d. Cells: (a p c) (p b c) and, across, (b p d) (p a d).
void DelaunayKernel::split_side(Half e, Vertex p) {
  const Half f = twin(e);
  const Mark kept = mark(e);
  std::array<Half, 2> first{};
  std::array<Half, 2> second{};
  const std::array<Half, 2> side{e, f};
  for (std::size_t k = 0; k < 2; ++k) {
    if (side[k] == none) continue;
    const Half s = side[k];
    const Vertex to = target(s);
    const Vertex top = apex(s);
    const Half outer = twin(next(s));
    const Mark outer_mark = mark(next(s));
    const Cell added = add_cell(cells_[cell_of(s)].region);
    set_vertex(next(s), p);
    set_vertex(half(added, 0), p);
    set_vertex(half(added, 1), to);
    set_vertex(half(added, 2), top);
    link(half(added, 1), outer, outer_mark);
    link(next(s), half(added, 2), 0);
    stack_.push_back(previous(s));
    stack_.push_back(half(added, 1));
    first[k] = s;
    second[k] = half(added, 0);
  }
  link(first[0], f == none ? none : second[1], kept);
  link(second[0], f == none ? none : first[1], kept);
}

DelaunayKernel::Vertex DelaunayKernel::insert(Point p, Location at) {
  DOBRA_CHECK(at.where != Where::OnVertex && at.where != Where::Blocked && points_.size() < at_infinity - 1);
  const Vertex v = add_vertex(p);
  if (at.where == Where::OnSide) {
    split_side(at.half, v);
  } else {
    split_cell(cell_of(at.half), v);
  }
  legalise(v);
  return v;
}

/// Empties the stack; what a flip changes is looked at again.
std::size_t DelaunayKernel::legalise_stack(std::vector<Vertex>* changed) {
  std::size_t flips = 0;
  while (!stack_.empty()) {
    const Half e = stack_.back();
    stack_.pop_back();
    if (!must_flip(e)) continue;
    const Half f = twin(e);
    flip(e);
    ++flips;
    if (changed != nullptr) changed->insert(changed->end(), {origin(e), target(e), apex(e), apex(f)});
    for (const Half side : {next(e), previous(e), next(f), previous(f)}) stack_.push_back(side);
  }
  return flips;
}

std::size_t DelaunayKernel::legalise_all() {
  std::size_t flips = 0;
  for (Cell c = 0; c < cells_.size(); ++c) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      // A side is looked at from one of its cells; none is the greatest half-edge.
      if (half(c, i) > twin(half(c, i))) continue;
      stack_.push_back(half(c, i));
      flips += legalise_stack(nullptr);
    }
  }
  return flips;
}

std::size_t DelaunayKernel::legalise_near(std::span<const Vertex> vertices, std::vector<Vertex>& changed) {
  std::size_t flips = 0;
  for (const Vertex v : vertices) {
    const Half first = half_of_[v];
    Half e = first;
    do {
      stack_.push_back(e);
      stack_.push_back(next(e));
      e = around(e);
    } while (e != first && e != none);
    flips += legalise_stack(&changed);
  }
  return flips;
}

}  // namespace dobra::mesh::delaunay
