#include "shared/surf/mesh/chart_space.h"

#include <algorithm>
#include <cmath>

namespace dobra::surf::mesh {

using dobra::mesh::sizing::QuadCellId;
using geom::Vector3;

ChartSpace::Place ChartSpace::between(Vertex a, Vertex b, double t) const {
  return {nodes_[a].at + t * (nodes_[b].at - nodes_[a].at), geom::interpolate(kernel_->point(a), kernel_->point(b), t),
          nodes_[a].u(), nodes_[a].v()};
}

/// A place of the chart to the left of the middle of a side, so near that no kink lies between.
geom::Point ChartSpace::left_of_middle(Vertex a, Vertex b) const {
  constexpr double hair = 1e-6;  // of the side
  const geom::Point p = kernel_->point(a), q = kernel_->point(b);
  return geom::midpoint(p, q) + hair * geom::left_of(q - p);
}

geom::Point ChartSpace::centroid(Vertex a, Vertex b, Vertex c) const {
  const geom::Point p = kernel_->point(a), q = kernel_->point(b), r = kernel_->point(c);
  return {(p.x + q.x + r.x) / 3.0, (p.y + q.y + r.y) / 3.0};
}

ChartSpace::Frame ChartSpace::normal(geom::Point in_chart) const {
  const Jet jet = chart_->jet(in_chart);
  return unit(geom::cross(jet.u, jet.v));
}

ChartSpace::Place ChartSpace::beside(Vertex a, Vertex b, Vector by) const {
  if (on_kink(a) || on_kink(b)) {
    const Jet jet = chart_->jet(left_of_middle(a, b));
    return {geom::midpoint(nodes_[a].at, nodes_[b].at) + by,
            geom::midpoint(kernel_->point(a), kernel_->point(b)) + in_chart(jet.u, jet.v, by), jet.u, jet.v};
  }
  const Vector u = 0.5 * (nodes_[a].u() + nodes_[b].u());
  const Vector v = 0.5 * (nodes_[a].v() + nodes_[b].v());
  return {geom::midpoint(nodes_[a].at, nodes_[b].at) + by,
          geom::midpoint(kernel_->point(a), kernel_->point(b)) + in_chart(u, v, by), u, v};
}

ChartSpace::Place ChartSpace::in_plane(Vertex a, Vertex b, Vertex c, Vector from_a) const {
  const geom::Vector part = in_chart(at(b) - at(a), at(c) - at(a), from_a);
  const geom::Point p = kernel_->point(a);
  return {at(a) + from_a, p + (part.x * (kernel_->point(b) - p) + part.y * (kernel_->point(c) - p)), nodes_[a].u(),
          nodes_[a].v()};
}

bool ChartSpace::ground(Place& place) const {
  if (place.grounded) return true;
  if (!geom::is_finite(place.in_chart) || !chart_->holds(place.in_chart)) return false;
  const Jet jet = chart_->jet(place.in_chart);
  const Vector normal = geom::cross(jet.u, jet.v);
  constexpr double flattest = 1e-12;  // sine of the angle between the derivatives, squared, times their ratio
  const double u = dot(jet.u, jet.u), v = dot(jet.v, jet.v);
  if (!geom::is_finite(jet.at) || !(dot(normal, normal) > flattest * std::max(u, v) * std::max(u, v))) return false;
  place = {jet.at, place.in_chart, jet.u, jet.v, true};
  return true;
}

bool ChartSpace::settle(Vertex a, Vertex b, double height, Place& place) const {
  const Point middle = geom::midpoint(nodes_[a].at, nodes_[b].at);
  const Vector by = place.at - middle;
  Place given = place;
  const bool found = approach(a, b, height, place);
  if (found && dot(place.at - middle, by) > 0.0) return true;
  const geom::Point start = geom::midpoint(kernel_->point(a), kernel_->point(b));
  if (!std::isfinite(size_by_chart(chart_->jet(start), {}))) return found;
  // On a steep flank that bends, a straight way of the chart leaves the plane of the step at once: so it is gone in
  // parts, each from where the one before has led.
  given.in_chart = start;
  constexpr int parts = 6;
  for (int left = parts; left > 0; --left) {
    Place here = given;
    here.grounded = false;
    if (!ground(here)) return false;
    const Vector rest = middle + by - here.at;
    given.in_chart = here.in_chart + in_chart(here.u, here.v, rest / static_cast<double>(left));
    given.grounded = false;
  }
  if (!approach(a, b, height, given) || !(dot(given.at - middle, by) > 0.0)) return false;
  place = given;
  return true;
}

bool ChartSpace::approach(Vertex a, Vertex b, double height, Place& place) const {
  constexpr double close_enough = 0.01;
  constexpr double far_off = 0.1;
  constexpr int rounds = 3;
  const Point middle = geom::midpoint(nodes_[a].at, nodes_[b].at);
  const Vector along = unit(nodes_[b].at - nodes_[a].at);
  double missed = 1.0;
  for (int round = 0; round <= rounds; ++round) {
    if (!ground(place)) return false;
    const Vector over = place.at - middle;
    const double aside = dot(over, along);
    const double squared = dot(over, over);
    missed = std::max(std::abs(aside) / height, std::abs(std::sqrt(squared) / height - 1.0));
    if (missed <= close_enough || round == rounds) break;
    // One step of Newton's for both.
    const double uu = dot(place.u, along), uv = dot(place.v, along), vu = dot(place.u, over), vv = dot(place.v, over);
    const double first = -aside, second = 0.5 * (height * height - squared);
    const double det = uu * vv - uv * vu;
    const geom::Vector step{(first * vv - uv * second) / det, (uu * second - vu * first) / det};
    if (!std::isfinite(step.x) || !std::isfinite(step.y)) return false;
    place.in_chart = place.in_chart + step;
    place.grounded = false;
  }
  return missed <= far_off;
}

void ChartSpace::enter(Vertex v, Point at, bool on_kink) {
  if (on_kink) {
    on_kink_.resize(v + 1, 0);
    on_kink_[v] = 1;
  }
  Place place{at, kernel_->point(v), {}, {}};
  const Jet jet = chart_->jet(place.in_chart);
  place.u = jet.u;
  place.v = jet.v;
  announce(place);
}

bool ChartSpace::same_sheet(const Place& place, Vertex v, double distance) const {
  constexpr double longer = 3.0;
  const geom::Vector step = place.in_chart - kernel_->point(v);
  const Vector along = step.x * nodes_[v].u() + step.y * nodes_[v].v();
  return dot(along, along) < longer * longer * distance * distance;
}

double ChartSpace::to_side(Point from, Point to, Point p) {
  const Vector along = to - from;
  const double t = std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
  return geom::distance(from + t * along, p);
}

double ChartSpace::estimated_triangles(const SizeField& /*field*/) const {
  double sum = 0.0;
  for (const double each : sizes_->triangles) sum += each;
  return sum;
}

double ChartSpace::expected_triangles() const {
  const auto& tree = sizes_->field.quadtree();
  double sum = 0.0;
  Kernel::Cell last = 0;
  for (const QuadCellId leaf : tree.leaves()) {
    const double wanted = sizes_->triangles[leaf.index()];
    if (wanted == 0.0) continue;
    // As many places as the leaf has many triangles, up to sixteen.
    const int rows = wanted < 8.0 ? 1 : wanted < 64.0 ? 2 : 4;
    const geom::Box box = tree.box(leaf);
    int inside = 0;
    for (int k = 0; k < rows * rows; ++k) {
      const geom::Point p{box.low.x + (k % rows + 0.5) / rows * box.width(),
                          box.low.y + (k / rows + 0.5) / rows * box.height()};
      const Kernel::Location found = kernel_->locate(p, last, Kernel::Walls::Ignore);
      if (found.where == Kernel::Where::Outside || found.half == Kernel::none) continue;
      last = Kernel::cell_of(found.half);
      if (kernel_->cell(last).region >= 0) ++inside;
    }
    sum += wanted * inside / (rows * rows);
  }
  return sum;
}

std::size_t ChartSpace::make_room(const SizeField& /*field*/, const dobra::mesh::front::FrontalOptions& options) {
  if (!whole_) return kernel_->cell_count();
  constexpr double reserve = 1.15;
  const double expected = std::min(reserve * expected_triangles(), static_cast<double>(options.max_triangles));
  const std::size_t cells = kernel_->cell_count() + static_cast<std::size_t>(expected);
  const std::size_t vertices = kernel_->vertex_count() + static_cast<std::size_t>(0.5 * expected);
  kernel_->reserve(vertices, cells);
  nodes_.reserve(vertices);
  return cells;
}

ChartSpace ChartSpace::part(Kernel& kernel, std::span<const Vertex> node) const {
  ChartSpace part(*chart_, *sizes_, kernel);
  part.whole_ = false;
  part.nodes_.reserve(node.size());
  for (std::size_t v = 0; v < node.size(); ++v) {
    part.nodes_.push_back(nodes_[node[v]]);
    if (!on_kink(node[v])) continue;
    part.on_kink_.resize(v + 1, 0);
    part.on_kink_[v] = 1;
  }
  return part;
}

namespace {

/// Cosines of the angles of a triangle: the greatest is that of its least angle.
double least_angle_cosine(geom::Point3 a, geom::Point3 b, geom::Point3 c) {
  const Vector3 u = b - a, v = c - b, w = a - c;
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  // The least angle faces the shortest side.
  if (uu <= vv && uu <= ww) return -dot(v, w) / std::sqrt(vv * ww);
  if (vv <= ww) return -dot(w, u) / std::sqrt(ww * uu);
  return -dot(u, v) / std::sqrt(uu * vv);
}

}  // namespace

bool ChartSpace::flips(Vertex a, Vertex b, Vertex c, Vertex d) const {
  const geom::Point qa = kernel_->point(a), qb = kernel_->point(b), qc = kernel_->point(c), qd = kernel_->point(d);
  const auto by_chart = [&] {
    return dobra::mesh::delaunay::filtered_incircle(qa, qb, qc, qd) == geom::Sign::Positive;
  };
  // Two rules beside each other need not end: the chart's is taken so often and no more.
  constexpr std::size_t often = 64;
  const Point pa = at(a), pb = at(b), pc = at(c), pd = at(d);
  if (unfolding_) {
    const double before = folded_area(a, b, c) + folded_area(b, a, d);
    if (before > 0.0) {
      constexpr double less = 0.9;
      return turns_left(qa, qd, qc) && turns_left(qd, qb, qc) &&
             folded_area(a, d, c) + folded_area(d, b, c) < less * before;
    }
  }
  const bool turned = coarse_ && (turns(a, b, c) || turns(a, b, d) || turns(c, d, c));
  if (turned && by_chart_ < often * (kernel_->vertex_count() + often)) {
    if (!by_chart()) return false;
    ++by_chart_;
    return true;
  }
  // The angles at c and d together are less than half a turn: as good as it can be in a plane.
  const Vector ca = pa - pc, cb = pb - pc, da = pa - pd, db = pb - pd;
  const Vector area_c = geom::cross(ca, cb), area_d = geom::cross(db, da);
  const double cos_c = dot(ca, cb), cos_d = dot(da, db);
  if (cos_c >= 0.0 && cos_d >= 0.0) return false;
  const double sin_c = std::sqrt(dot(area_c, area_c)), sin_d = std::sqrt(dot(area_d, area_d));
  if (sin_c * cos_d + cos_c * sin_d >= 0.0) return false;
  if (!turns_left(qa, qd, qc) || !turns_left(qd, qb, qc)) return false;
  // The least of all six angles grows: so it ends.
  constexpr double margin = 1e-9;
  const double before = std::max(least_angle_cosine(pa, pb, pc), least_angle_cosine(pb, pa, pd));
  const double after = std::max(least_angle_cosine(pa, pd, pc), least_angle_cosine(pd, pb, pc));
  if (after >= before - margin) return false;
  if (folded_area(a, d, c) + folded_area(d, b, c) > folded_area(a, b, c) + folded_area(b, a, d)) return false;
  // Across a cone chords are short: there both must agree.
  return (!turned && !turns(a, b, c) && !turns(a, b, d) && !turns(c, d, c)) || by_chart();
}

double ChartSpace::folded_area(Vertex a, Vertex b, Vertex c) const {
  if (on_kink(a) || on_kink(b) || on_kink(c)) return 0.0;
  return std::max(0.0, -dot(geom::cross(at(b) - at(a), at(c) - at(a)), frame(a) + frame(b) + frame(c)) / 6.0);
}

bool ChartSpace::turns(Vertex a, Vertex b, Vertex c) const {
  constexpr double most = 0.5;  // the cosine of 60 degrees
  const geom::Point middle = on_kink(a) || on_kink(b) || on_kink(c) ? centroid(a, b, c) : geom::Point{};
  // On a kink the normal is that of the triangle's side.
  const auto at_corner = [&](Vertex v) {
    constexpr double hair = 1e-6;
    return on_kink(v) ? normal(geom::interpolate(kernel_->point(v), middle, hair)) : frame(v);
  };
  const Vector p = at_corner(a), q = at_corner(b), r = at_corner(c);
  return dot(p, q) < most || dot(q, r) < most || dot(r, p) < most;
}

}  // namespace dobra::surf::mesh
