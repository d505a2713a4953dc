#include "shared/surf/trim/meetings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Vector;

namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// A smooth part of an arc. Its points are within `sag` of the chord.
struct Part {
  std::size_t strand = 0, arc = 0;
  double from = 0.0, to = 1.0;
  Point start, end;
  Arcs::At middle;
  double bend = 0.0;
  std::size_t first = nowhere, last = nowhere;  ///< Joints: vertices, or where it was divided from its neighbour.

  [[nodiscard]] double range() const { return to - from; }
  [[nodiscard]] double sag() const { return bend * range() * range() / 8.0; }
  /// The first derivative is nowhere further from that in the middle.
  [[nodiscard]] double turn() const { return 0.5 * bend * range(); }
  [[nodiscard]] double extent() const {
    return 0.5 * geom::distance(start, middle.at) + 0.5 * geom::distance(middle.at, end);
  }
  [[nodiscard]] Box box() const {
    Box box;
    box.add(start);
    box.add(end);
    return box.grown(sag());
  }
};

/// A touching, and the disk in which the curves are one point.
struct Touch {
  Point at;
  double reach = 0.0;
};

class Finder {
 public:
  Finder(const Surface& surface, const Arcs& arcs, double same) : surface_(surface), arcs_(arcs), same_(same) {}

  base::Result<std::vector<Crossing>> run() {
    make_parts();
    std::vector<std::size_t> order(parts_.size());
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      order[i] = i;
      boxes.push_back(parts_[i].box().grown(same_));
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return boxes[a].low.x < boxes[b].low.x; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t k = i + 1; k < order.size() && boxes[order[k]].low.x <= boxes[order[i]].high.x; ++k) {
        if (!boxes[order[i]].overlaps(boxes[order[k]])) continue;
        const auto [a, b] = std::minmax(order[i], order[k]);
        touches_.clear();
        left_ = 40000;
        DOBRA_TRY_VOID(meet(parts_[a], parts_[b], 0));
      }
    }
    return std::move(found_);
  }

 private:
  void make_parts() {
    std::size_t joint = arcs_.vertices.size();
    for (std::size_t a = 0; a < arcs_.arcs.size(); ++a) {
      const Arc& arc = arcs_.arcs[a];
      std::vector<double> at = smooth_parts_of(arcs_, arc.strand, arc.from, arc.to);
      std::vector<Part> made;
      for (std::size_t k = 0; k + 1 < at.size(); ++k) {
        Part whole = part(arc.strand, a, at[k], at[k + 1]);
        whole.bend = arcs_.bend(arc.strand, at[k], at[k + 1]);
        divide(whole, 0, made);
      }
      for (std::size_t k = 0; k < made.size(); ++k) {
        made[k].first = k == 0 ? arc.start : joint;
        if (k + 1 < made.size()) ++joint;
        made[k].last = k + 1 == made.size() ? arc.end : joint;
      }
      ++joint;
      parts_.insert(parts_.end(), made.begin(), made.end());
    }
  }
  [[nodiscard]] Part part(std::size_t strand, std::size_t arc, double from, double to) const {
    Part p{strand, arc, from, to, arcs_.on(strand, from).at, arcs_.on(strand, to).at, {}, 0.0, nowhere, nowhere};
    p.middle = arcs_.on(strand, 0.5 * (from + to));
    return p;
  }
  /// Until none turns by more than a third of a right angle.
  void divide(const Part& whole, int depth, std::vector<Part>& made) const {
    if (depth >= 10 || whole.turn() <= 0.5 * length(whole.middle.first)) {
      made.push_back(whole);
      return;
    }
    for (const Part& half : halves(whole)) divide(half, depth + 1, made);
  }
  [[nodiscard]] std::array<Part, 2> halves(const Part& p) const {
    const double middle = 0.5 * (p.from + p.to);
    Part a = p, b = p;
    a.to = b.from = middle;
    a.end = b.start = p.middle.at;
    a.last = b.first = nowhere;
    a.middle = arcs_.on(p.strand, 0.5 * (a.from + a.to));
    b.middle = arcs_.on(p.strand, 0.5 * (b.from + b.to));
    return {a, b};
  }

  static bool apart_along(const Part& a, const Part& b, Vector axis) {
    const double size = length(axis);
    if (!(size > 0.0)) return false;
    const auto of = [&](Point p) { return (p.x * axis.x + p.y * axis.y) / size; };
    const auto [a0, a1] = std::minmax({of(a.start), of(a.end)});
    const auto [b0, b1] = std::minmax({of(b.start), of(b.end)});
    const double rest = a.sag() + b.sag();
    return a1 + rest < b0 || b1 + rest < a0;
  }
  static bool apart(const Part& a, const Part& b) {
    const Vector p = a.end - a.start, q = b.end - b.start;
    return apart_along(a, b, geom::left_of(p)) || apart_along(a, b, geom::left_of(q)) || apart_along(a, b, p) ||
           apart_along(a, b, q);
  }
  static bool transversal(const Part& a, const Part& b) {
    const double p = length(a.middle.first), q = length(b.middle.first);
    return std::abs(cross(a.middle.first, b.middle.first)) > a.turn() * q + b.turn() * p + a.turn() * b.turn();
  }
  /// From a joint that both have, the directions of one all lie beside those of the other.
  static bool only_a_joint(const Part& a, const Part& b) {
    for (const bool at_first_a : {true, false}) {
      for (const bool at_first_b : {true, false}) {
        const std::size_t p = at_first_a ? a.first : a.last, q = at_first_b ? b.first : b.last;
        if (p == nowhere || p != q) continue;
        const Vector out_a = at_first_a ? a.middle.first : -a.middle.first;
        const Vector out_b = at_first_b ? b.middle.first : -b.middle.first;
        const double lean_a = a.turn() / length(out_a), lean_b = b.turn() / length(out_b);
        if (!(lean_a < 1.0 && lean_b < 1.0)) continue;
        const double angle = std::atan2(std::abs(cross(out_a, out_b)), dot(out_a, out_b));
        if (angle > std::asin(lean_a) + std::asin(lean_b)) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool at_known_vertex(const Part& a, const Part& b, Point p) const {
    const auto has = [&](const Part& part) {
      const Arc& arc = arcs_.arcs[part.arc];
      return geom::distance(arcs_.vertices[arc.start], p) <= same_ ||
             geom::distance(arcs_.vertices[arc.end], p) <= same_;
    };
    return has(a) && has(b);
  }

  base::Result<void> meet(const Part& a, const Part& b, int depth) {
    if (apart(a, b) || only_a_joint(a, b)) return {};
    for (const Touch& touch : touches_) {
      const auto within = [&](const Part& p) {
        return geom::distance(p.start, touch.at) <= touch.reach && geom::distance(p.end, touch.at) <= touch.reach;
      };
      if (within(a) && within(b)) return {};
    }
    if (--left_ < 0 || depth > 120) return cannot_tell(a.middle.at);
    if (transversal(a, b)) {
      if (cross_once(a, b)) return {};
    } else if (std::max(a.extent(), b.extent()) < 0.05) {
      DOBRA_TRY(const bool touched, touch(a, b));
      if (touched) return meet(a, b, depth + 1);
    }
    if (std::max(a.extent(), b.extent()) < 0.01 * same_) {
      add(a, b, 0.5 * (a.from + a.to), 0.5 * (b.from + b.to));
      return {};
    }
    if (a.extent() >= b.extent()) {
      for (const Part& half : halves(a)) DOBRA_TRY_VOID(meet(half, b, depth + 1));
    } else {
      for (const Part& half : halves(b)) DOBRA_TRY_VOID(meet(a, half, depth + 1));
    }
    return {};
  }

  void add(const Part& a, const Part& b, double part_a, double part_b) {
    const Point p = arcs_.on(a.strand, part_a).at;
    if (!at_known_vertex(a, b, p)) found_.push_back({a.strand, b.strand, part_a, part_b, p});
  }

  /// Newton's rule for the only crossing that there may be; true if it is one of these parts.
  bool cross_once(const Part& a, const Part& b) {
    double s = 0.5 * (a.from + a.to), t = 0.5 * (b.from + b.to);
    for (int round = 0; round < 25; ++round) {
      const Arcs::At p = arcs_.on(a.strand, s), q = arcs_.on(b.strand, t);
      const Vector gap = p.at - q.at;
      const double det = cross(p.first, q.first);
      if (det == 0.0) return false;
      const double ds = -cross(gap, q.first) / det, dt = -cross(gap, p.first) / det;
      s += ds, t += dt;
      if (!(s >= a.from - a.range() && s <= a.to + a.range() && t >= b.from - b.range() && t <= b.to + b.range()))
        return false;
      if (std::abs(ds) < 1e-14 && std::abs(dt) < 1e-14) break;
    }
    const double hair_a = 1e-9 * a.range(), hair_b = 1e-9 * b.range();
    if (s < a.from - hair_a || s > a.to + hair_a || t < b.from - hair_b || t > b.to + hair_b) return false;
    s = std::clamp(s, 0.0, 1.0), t = std::clamp(t, 0.0, 1.0);
    if (geom::distance(arcs_.on(a.strand, s).at, arcs_.on(b.strand, t).at) > 1e-3 * same_) return false;
    add(a, b, s, t);
    return true;
  }

  /// A place where the tangents are parallel and the way between the curves is across them, and nought.
  base::Result<bool> touch(const Part& a, const Part& b) {
    double s = 0.5 * (a.from + a.to), t = 0.5 * (b.from + b.to);
    Arcs::At p, q;
    for (int round = 0; round < 20; ++round) {
      p = arcs_.on(a.strand, s), q = arcs_.on(b.strand, t);
      const Vector gap = p.at - q.at;
      const double f = dot(gap, p.first), g = cross(p.first, q.first);
      const double f_s = dot(p.first, p.first) + dot(gap, p.second), f_t = -dot(q.first, p.first);
      const double g_s = cross(p.second, q.first), g_t = cross(p.first, q.second);
      const double det = f_s * g_t - f_t * g_s;
      if (det == 0.0 || !std::isfinite(det)) return false;
      const double ds = -(f * g_t - f_t * g) / det, dt = -(f_s * g - f * g_s) / det;
      s += ds, t += dt;
      if (std::abs(s - 0.5 * (a.from + a.to)) > 2.0 * a.range() ||
          std::abs(t - 0.5 * (b.from + b.to)) > 2.0 * b.range())
        return false;
      if (std::abs(ds) < 1e-13 && std::abs(dt) < 1e-13) break;
    }
    if (s < -1e-6 || s > 1.0 + 1e-6 || t < -1e-6 || t > 1.0 + 1e-6) return false;
    s = std::clamp(s, 0.0, 1.0), t = std::clamp(t, 0.0, 1.0);
    p = arcs_.on(a.strand, s), q = arcs_.on(b.strand, t);
    if (geom::distance(p.at, q.at) > same_) return false;
    const double sine = std::abs(cross(p.first, q.first)) / (length(p.first) * length(q.first));
    if (!(sine < 1e-5)) return false;
    const auto curvature = [](const Arcs::At& c) { return cross(c.first, c.second) / std::pow(length(c.first), 3.0); };
    const double sense = dot(p.first, q.first) < 0.0 ? -1.0 : 1.0;
    const double apart = std::abs(curvature(p) - sense * curvature(q));
    const double reach = std::sqrt(8.0 * same_ / apart) + 10.0 * same_;
    if (!(reach < 0.02)) return cannot_tell(p.at);
    for (const Touch& known : touches_) {
      if (geom::distance(known.at, p.at) <= same_) return false;
    }
    touches_.push_back({p.at, reach});
    add(a, b, s, t);
    return true;
  }

  [[nodiscard]] Error cannot_tell(Point part) const {
    const Point uv = arcs_.uv(part);
    const base::Place place = place_of(surface_, uv);
    return {ErrorCode::CannotMesh,
            "lines of the chart touch so closely here that what they bound cannot be told; let them cross, part or "
            "coincide",
            place};
  }

  const Surface& surface_;
  const Arcs& arcs_;
  double same_;
  std::vector<Part> parts_;
  std::vector<Touch> touches_;
  std::vector<Crossing> found_;
  int left_ = 0;
};

}  // namespace

base::Result<std::vector<Crossing>> crossings(const Surface& surface, const Arcs& arcs, double same) {
  return Finder(surface, arcs, same).run();
}

}  // namespace dobra::surf::trim
