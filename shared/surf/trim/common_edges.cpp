#include "shared/surf/trim/common_edges.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "shared/surf/measure.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

/// Places in both charts: u, v of the first, u, v of the second.
using Four = Eigen::Vector4d;
/// A place in space and in both charts.
using Seven = Eigen::Matrix<double, 7, 1>;

Eigen::Vector3d eigen(Vector3 v) { return {v.x, v.y, v.z}; }
Vector3 unit_or_nought(Vector3 v) {
  const double size = geom::length(v);
  return size > 0.0 ? v / size : Vector3{};
}
Four places(const SharedPoint& p) { return {p.first.x, p.first.y, p.second.x, p.second.y}; }
Vector3 space(const Seven& s) { return {s[0], s[1], s[2]}; }

/// What is common to the three curves of a piece: points of the chain with derivatives, between which the guess is a
/// polynomial of degree five, and the way from the guess to the surfaces.
class Piece {
 public:
  Piece(const Surface& first, const Surface& second, std::span<const SharedPoint> chain);

  /// All places and their first and second derivatives by the parameter.
  struct Found {
    Four x, first, second;
    Jet a, b;
    [[nodiscard]] Vector3 gap() const { return a.at - b.at; }
  };
  [[nodiscard]] Found at(double t) const;
  [[nodiscard]] const std::vector<double>& knots() const { return t_; }
  [[nodiscard]] double size() const { return size_; }

 private:
  [[nodiscard]] Eigen::Matrix4d matrix(const Jet& a, const Jet& b, Vector3 way) const;
  [[nodiscard]] Four solve(const Eigen::Matrix4d& scaled, const Four& right) const;
  [[nodiscard]] static Vector3 square(const Jet& j, double u, double v) {
    return u * u * j.uu + 2.0 * u * v * j.uv + v * v * j.vv;
  }
  void place_knots(std::span<const SharedPoint> chain);
  void differentiate(std::span<const SharedPoint> chain);
  void settle_poles();
  void hold_borders();
  [[nodiscard]] std::array<Seven, 4> guess(std::size_t k, double t) const;
  [[nodiscard]] Four inside(Four x, std::size_t k, const Four& wanted) const;

  Surface first_, second_;
  double size_, enough_;
  Four scale_, low_, high_;
  std::vector<double> t_;
  std::vector<Seven> value_, slope_, bend_;
  std::vector<std::array<bool, 4>> held_;     ///< One an interval: which parameters stay on a border.
  std::vector<std::array<bool, 4>> guessed_;  ///< Which are those of the guess: along a pole, beside it.
};

/// So far from a pole, of the smaller surface's size, the parameter along it is known well: the rest of the way is
/// guessed from there. Beside the pole the surfaces hold it to rounding divided by the distance.
constexpr double beside_pole = 1e-3;
/// An end so near to a pole may be the pole, of the smaller surface's size.
constexpr double taken_as_pole = 1e-5;

Piece::Piece(const Surface& first, const Surface& second, std::span<const SharedPoint> chain)
    : first_(first), second_(second), size_(std::min(first.size(), second.size())) {
  const double far = std::max(geom::distance(chain.front().at, {}), std::max(first.size(), second.size()));
  enough_ = 1e-15 * far;
  low_ << first.chart().low.x, first.chart().low.y, second.chart().low.x, second.chart().low.y;
  high_ << first.chart().high.x, first.chart().high.y, second.chart().high.x, second.chart().high.y;
  scale_ = high_ - low_;
  place_knots(chain);
  differentiate(chain);
  guessed_.assign(t_.size() - 1, {});
  settle_poles();
  held_.assign(t_.size() - 1, {});
  hold_borders();
}

void Piece::place_knots(std::span<const SharedPoint> chain) {
  t_.push_back(0.0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Seven s;
    s << chain[i].at.x, chain[i].at.y, chain[i].at.z, places(chain[i]);
    value_.push_back(s);
    if (i > 0) t_.push_back(t_.back() + geom::distance(chain[i - 1].at, chain[i].at));
  }
}

Eigen::Matrix4d Piece::matrix(const Jet& a, const Jet& b, Vector3 way) const {
  Eigen::Matrix4d m;
  m.block<3, 1>(0, 0) = scale_[0] * eigen(a.u);
  m.block<3, 1>(0, 1) = scale_[1] * eigen(a.v);
  m.block<3, 1>(0, 2) = -scale_[2] * eigen(b.u);
  m.block<3, 1>(0, 3) = -scale_[3] * eigen(b.v);
  m.row(3) << scale_[0] * dot(a.u, way), scale_[1] * dot(a.v, way), 0.0, 0.0;
  return m;
}

Four Piece::solve(const Eigen::Matrix4d& scaled, const Four& right) const {
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> solver;
  solver.setThreshold(1e-12);
  solver.compute(scaled);
  return scale_.cwiseProduct(Four(solver.solve(right)));
}

/// By the length: exactly where the surfaces cross, by the points around elsewhere (poles, contacts).
void Piece::differentiate(std::span<const SharedPoint> chain) {
  const std::size_t n = chain.size();
  slope_.assign(n, Seven::Zero());
  bend_.assign(n, Seven::Zero());
  const bool round = n > 3 && places(chain.front()) == places(chain.back());
  for (std::size_t k = 0; k < n; ++k) {
    const Jet a = first_.jet(chain[k].first), b = second_.jet(chain[k].second);
    const Vector3 across = cross(unit_or_nought(cross(a.u, a.v)), unit_or_nought(cross(b.u, b.v)));
    std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, n - 1);
    const Vector3 chord = chain[after].at - chain[before].at;
    const double poor = std::min(geom::length(cross(a.u, a.v)) * scale_[0] * scale_[1],
                                 geom::length(cross(b.u, b.v)) * scale_[2] * scale_[3]);
    if (geom::length(across) > 1e-4 && poor > 1e-6 * size_ * size_) {
      const Vector3 way = dot(across, chord) < 0.0 ? -unit_or_nought(across) : unit_or_nought(across);
      const Eigen::Matrix4d m = matrix(a, b, way);
      const Four x = solve(m, Four(0, 0, 0, 1));
      const Vector3 qa = square(a, x[0], x[1]), qb = square(b, x[2], x[3]);
      Four right;
      right << eigen(qb - qa), -dot(qa, way);
      const Four xx = solve(m, right);
      slope_[k] << eigen(x[0] * a.u + x[1] * a.v), x;
      bend_[k] << eigen(qa + xx[0] * a.u + xx[1] * a.v), xx;
      continue;
    }
    // The parabola through three points that follow each other.
    std::size_t middle = std::clamp<std::size_t>(k, 1, n - 1);
    if (n == 2) {
      slope_[k] = (value_[1] - value_[0]) / (t_[1] - t_[0]);
      continue;
    }
    double shift = 0.0;
    if (round && (k == 0 || k == n - 1)) {
      before = n - 2, middle = 0, after = 1, shift = t_.back();
    } else {
      middle = std::min(middle, n - 2);
      before = middle - 1, after = middle + 1;
    }
    const double h = t_[middle] - (t_[before] - shift), g = t_[after] - t_[middle];
    const Seven p = (value_[middle] - value_[before]) / h, q = (value_[after] - value_[middle]) / g;
    const Seven half = (q - p) / (h + g);
    const double off = t_[k] - (k == n - 1 && round ? t_.back() : 0.0) - t_[middle];
    slope_[k] = p + h * half + 2.0 * off * half;
    bend_[k] = 2.0 * half;
  }
}

/// In a pole the parameter along its side is what the curve comes with, by the nearest point of the chain. It is
/// guessed between both if they are near.
void Piece::settle_poles() {
  const std::size_t last = t_.size() - 1;
  for (const std::size_t end : {std::size_t{0}, last}) {
    const std::size_t next = end == 0 ? 1 : last - 1;
    for (int i = 0; i < 4; ++i) {
      const Surface& surface = i < 2 ? first_ : second_;
      const int across = i ^ 1;
      const bool along_u = i % 2 == 0;
      const Side low = along_u ? Side::Bottom : Side::Left, high = along_u ? Side::Top : Side::Right;
      const double at = value_[end][3 + across];
      if (!(at == low_[across] && surface.collapsed(low)) && !(at == high_[across] && surface.collapsed(high)))
        continue;
      const double h = t_[end] - t_[next], slope = slope_[next][3 + i], bend = bend_[next][3 + i];
      value_[end][3 + i] = std::clamp(value_[next][3 + i] + h * (slope + 0.5 * h * bend), low_[i], high_[i]);
      slope_[end][3 + i] = slope + h * bend;
      bend_[end][3 + i] = bend;
      guessed_[std::min(end, next)][static_cast<std::size_t>(i)] = std::abs(h) < 2.0 * beside_pole * size_;
    }
  }
}

/// A curve that runs along a border stays on it exactly.
void Piece::hold_borders() {
  for (std::size_t k = 0; k + 1 < t_.size(); ++k) {
    const Found middle = at(0.5 * (t_[k] + t_[k + 1]));
    for (int i = 0; i < 4; ++i) {
      const double here = value_[k][3 + i];
      const bool border = here == low_[i] || here == high_[i];
      held_[k][static_cast<std::size_t>(i)] =
          border && here == value_[k + 1][3 + i] && std::abs(middle.x[i] - here) <= 1e-9 * scale_[i];
    }
  }
}

/// Value and three derivatives of the guess. Source of the six functions: values, first and second derivatives at both
/// ends.
std::array<Seven, 4> Piece::guess(std::size_t k, double t) const {
  const double h = t_[k + 1] - t_[k], s = (t - t_[k]) / h;
  const Seven d = value_[k + 1] - value_[k], v0 = h * slope_[k], v1 = h * slope_[k + 1], a0 = h * h * bend_[k],
              a1 = h * h * bend_[k + 1];
  const Seven c2 = 0.5 * a0, c3 = 10.0 * d - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
              c4 = -15.0 * d + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1, c5 = 6.0 * d - 3.0 * (v0 + v1) - 0.5 * (a0 - a1);
  return {Seven(value_[k] + s * (v0 + s * (c2 + s * (c3 + s * (c4 + s * c5))))),
          Seven((v0 + s * (2.0 * c2 + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5)))) / h),
          Seven((2.0 * c2 + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5))) / (h * h)),
          Seven((6.0 * c3 + s * (24.0 * c4 + s * 60.0 * c5)) / (h * h * h))};
}

Four Piece::inside(Four x, std::size_t k, const Four& wanted) const {
  for (int i = 0; i < 4; ++i) {
    if (guessed_[k][static_cast<std::size_t>(i)]) x[i] = wanted[i];
  }
  x = x.cwiseMax(low_).cwiseMin(high_);
  for (int i = 0; i < 4; ++i) {
    if (held_[k][static_cast<std::size_t>(i)]) x[i] = value_[k][3 + i];
  }
  return x;
}

Piece::Found Piece::at(double t) const {
  const auto next = std::upper_bound(t_.begin() + 1, t_.end() - 1, t);
  const std::size_t k = static_cast<std::size_t>(next - t_.begin()) - 1;
  const auto [g, g1, g2, g3] = guess(k, t);
  const Vector3 way = space(g1);
  const Point3 wanted{g[0], g[1], g[2]};
  Found f;
  const Four guessed = g.tail<4>();
  f.x = inside(guessed, k, guessed);
  const bool at_knot = t == t_[k] || t == t_[k + 1];
  if (at_knot) f.x = value_[t == t_[k] ? k : k + 1].tail<4>();
  double best = 1e300;
  Four best_x = f.x;
  for (int round = 0; round < 8; ++round) {
    f.a = first_.jet({f.x[0], f.x[1]});
    f.b = second_.jet({f.x[2], f.x[3]});
    if (at_knot) break;
    Four off;
    off << eigen(f.gap()), dot(f.a.at - wanted, way);
    if (!(off.norm() < best)) {
      f.x = best_x;
      f.a = first_.jet({f.x[0], f.x[1]});
      f.b = second_.jet({f.x[2], f.x[3]});
      break;
    }
    best = off.norm(), best_x = f.x;
    if (best <= enough_) break;
    f.x = inside(f.x - solve(matrix(f.a, f.b, way), off), k, guessed);
  }
  // What is held to nought: S1 - S2, and (S1 - g) . g'.
  const Eigen::Matrix4d m = matrix(f.a, f.b, way);
  const Vector3 from_guess = f.a.at - wanted, turning = space(g2);
  f.first = solve(m, Four(0, 0, 0, dot(way, way) - dot(from_guess, turning)));
  const auto take_guessed = [&](Four& derivative, const Seven& of_guess) {
    for (int i = 0; i < 4; ++i) {
      if (guessed_[k][static_cast<std::size_t>(i)]) derivative[i] = of_guess[3 + i];
    }
  };
  take_guessed(f.first, g1);
  const Vector3 qa = square(f.a, f.first[0], f.first[1]), qb = square(f.b, f.first[2], f.first[3]);
  const Vector3 moved = f.first[0] * f.a.u + f.first[1] * f.a.v;
  Four right;
  right << eigen(qb - qa), dot(turning - qa, way) - 2.0 * dot(moved - way, turning) - dot(from_guess, space(g3));
  f.second = solve(m, right);
  take_guessed(f.second, g2);
  if (geom::length(cross(unit_or_nought(cross(f.a.u, f.a.v)), unit_or_nought(cross(f.b.u, f.b.v)))) < 1e-6) {
    f.first = g1.tail<4>();  // no direction of its own there
    f.second = g2.tail<4>();
  }
  for (int i = 0; i < 4; ++i) {
    if (held_[k][static_cast<std::size_t>(i)]) f.first[i] = f.second[i] = 0.0;
  }
  return f;
}

/// One of the three curves: in the chart of the first (0) or second (1) surface, or in space (2).
struct CommonShape : Curve::Shape {
  std::shared_ptr<const Piece> piece;
  int of;
  CommonShape(std::shared_ptr<const Piece> common, int which) : piece(std::move(common)), of(which) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    const Piece::Found f = piece->at(t);
    if (of < 2) {
      const int i = 2 * of;
      return {{f.x[i], f.x[i + 1], 0.0}, {f.first[i], f.first[i + 1], 0.0}, {f.second[i], f.second[i + 1], 0.0}};
    }
    const double u = f.first[0], v = f.first[1];
    return {f.a.at, u * f.a.u + v * f.a.v,
            f.second[0] * f.a.u + f.second[1] * f.a.v + u * u * f.a.uu + 2.0 * u * v * f.a.uv + v * v * f.a.vv};
  }
  /// The greatest of five between two points of the chain, and half as much again.
  [[nodiscard]] double bend(double from, double to) const override {
    const std::vector<double>& knots = piece->knots();
    double most = 0.0;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
      const double a = std::max(from, knots[k]), b = std::min(to, knots[k + 1]);
      if (!(a < b)) continue;
      for (int i = 0; i <= 4; ++i) most = std::max(most, geom::length(jet(std::lerp(a, b, 0.25 * i)).second));
    }
    return 1.5 * most;
  }
};

base::Result<void> check(const Piece& piece, double residual) {
  const std::vector<double>& t = piece.knots();
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    for (const double part : {0.25, 0.5, 0.75}) {
      const Piece::Found f = piece.at(std::lerp(t[k], t[k + 1], part));
      const double apart = geom::length(f.gap());
      if (apart <= residual * piece.size()) continue;
      const Point3 p = f.a.at;
      return Error{ErrorCode::CannotMesh,
                   fmt::format("the surfaces are {:.3g} m apart along their common curve at ({:.6g}, {:.6g}, {:.6g}): "
                               "they touch there, or nearly so; move one",
                               apart, p.x, p.y, p.z),
                   base::Place{.x = p.x, .y = p.y, .z = p.z, .u = f.x[0], .v = f.x[1]}};
    }
  }
  return {};
}

/// Pole of a surface beside a point: where its side is one point in space, nearer than `near`.
std::optional<Point> pole_beside(const Surface& surface, Point uv, Point3 at, double near) {
  const geom::Box& chart = surface.chart();
  for (const auto& [side, pole] :
       {std::pair{Side::Bottom, Point{uv.x, chart.low.y}}, std::pair{Side::Top, Point{uv.x, chart.high.y}},
        std::pair{Side::Left, Point{chart.low.x, uv.y}}, std::pair{Side::Right, Point{chart.high.x, uv.y}}}) {
    if (surface.collapsed(side) && geom::distance(surface.at(pole), at) <= near) return pole;
  }
  return std::nullopt;
}

/// An end hardly beside a pole is in it, if the pole is on both surfaces: a curve that comes along the seam meets the
/// seam at the root of the rounding.
void end_in_poles(const Surface& first, const Surface& second, std::vector<SharedPoint>& chain) {
  const double size = std::min(first.size(), second.size()), near = taken_as_pole * size, enough = 1e-12 * size;
  for (SharedPoint* const end : {&chain.front(), &chain.back()}) {
    if (first.in_pole(end->first) || second.in_pole(end->second)) continue;
    const auto settle = [&](const Surface& of, Point& uv, const Surface& other, Point& other_uv) {
      const std::optional<Point> pole = pole_beside(of, uv, end->at, near);
      if (!pole) return;
      const Point3 at = of.at(*pole);
      const Jet jet = other.jet(other_uv);
      const Metric m = metric(jet);
      const Vector3 way = at - jet.at;
      const double det = m.e * m.g - m.f * m.f, du = dot(way, jet.u), dv = dot(way, jet.v);
      if (!(det > 0.0)) return;
      const Point there = other_uv + geom::Vector{(du * m.g - dv * m.f) / det, (dv * m.e - du * m.f) / det};
      if (!other.chart().contains(there) || geom::distance(other.at(there), at) > enough) return;
      *end = {end->first, end->second, at};
      uv = *pole;
      other_uv = there;
    };
    settle(first, end->first, second, end->second);
    if (!first.in_pole(end->first)) settle(second, end->second, first, end->first);
  }
}

/// Puts one point of the chain beside each pole where it ends, and takes away those nearer to it, whose parameter along
/// its side is hardly known.
void thin_poles(const Surface& first, const Surface& second, std::vector<SharedPoint>& chain) {
  const double size = std::min(first.size(), second.size()), beside = beside_pole * size;
  for (int end = 0; end < 2; ++end) {
    std::reverse(chain.begin(), chain.end());
    if (!first.in_pole(chain.back().first) && !second.in_pole(chain.back().second)) continue;
    while (chain.size() > 2 && geom::distance(chain[chain.size() - 2].at, chain.back().at) < 1.5 * beside)
      chain.erase(chain.end() - 2);
    const Piece rough(first, second, chain);
    const std::vector<double>& t = rough.knots();
    if (t.back() - t[t.size() - 2] < 1.5 * beside) continue;
    const Piece::Found f = rough.at(t.back() - beside);
    if (geom::length(f.gap()) > 1e-12 * size) continue;
    chain.insert(chain.end() - 1, {{f.x[0], f.x[1]}, {f.x[2], f.x[3]}, f.a.at});
  }
}

/// The chain in pieces, each without two points in one place.
std::vector<std::vector<SharedPoint>> pieces_of(const Surface& first, const Surface& second, const SharedCurve& curve) {
  const double same = 1e-11 * std::min(first.size(), second.size());
  std::vector<SharedPoint> chain = curve.points;
  const auto breaks = [&](const SharedPoint& p, const SharedPoint& q) { return geom::distance(p.at, q.at) <= same; };
  if (curve.closed && !(places(chain.front()) == places(chain.back()))) {
    // It begins at a seam, where it may as well end.
  } else if (curve.closed) {
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      if (!breaks(chain[i - 1], chain[i])) continue;
      chain.pop_back();
      std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(i), chain.end());
      break;
    }
  }
  std::vector<std::vector<SharedPoint>> pieces(1);
  for (const SharedPoint& p : chain) {
    if (!pieces.back().empty() && breaks(pieces.back().back(), p)) {
      if (places(pieces.back().back()) == places(p)) continue;
      if (pieces.back().size() == 1) {
        pieces.back() = {p};
        continue;
      }
      pieces.emplace_back();
    }
    pieces.back().push_back(p);
  }
  std::erase_if(pieces, [](const auto& piece) { return piece.size() < 2; });
  for (auto& piece : pieces) end_in_poles(first, second, piece);
  // What went to the pole whole is none.
  std::erase_if(pieces, [&](const auto& piece) {
    return breaks(piece.front(), piece.back()) &&
           (first.in_pole(piece.front().first) || second.in_pole(piece.front().second)) &&
           std::all_of(piece.begin(), piece.end(), [&](const SharedPoint& p) {
             return geom::distance(p.at, piece.front().at) <= taken_as_pole * std::min(first.size(), second.size());
           });
  });
  for (auto& piece : pieces) thin_poles(first, second, piece);
  return pieces;
}

}  // namespace

base::Result<std::vector<CommonEdge>> common_edges(const Surface& first, const Surface& second,
                                                   const SharedCurve& curve, const CommonEdgeOptions& options) {
  std::vector<CommonEdge> edges;
  for (const std::vector<SharedPoint>& chain : pieces_of(first, second, curve)) {
    const auto piece = std::make_shared<const Piece>(first, second, chain);
    DOBRA_TRY_VOID(check(*piece, options.residual));
    const double last = piece->knots().back();
    const auto curve_of = [&](int which) {
      return Curve::of(std::make_shared<const CommonShape>(piece, which), {0.0, last});
    };
    const SharedCurveId number = options.number + static_cast<SharedCurveId>(edges.size());
    const auto edge = [&](int which) {
      return ChartEdge{curve_of(which), 0.0, last, options.name, number, false, options.residual * piece->size()};
    };
    edges.push_back({edge(0), edge(1), curve_of(2)});
  }
  return edges;
}

base::Result<std::vector<CommonEdge>> common_edges(const Surface& first, const Surface& second,
                                                   const CommonEdgeOptions& options) {
  DOBRA_TRY(const SharedSet set, intersect_surfaces(first, second));
  std::vector<CommonEdge> all;
  for (const SharedCurve& curve : set.curves) {
    CommonEdgeOptions next = options;
    next.number += static_cast<SharedCurveId>(all.size());
    DOBRA_TRY(std::vector<CommonEdge> edges, common_edges(first, second, curve, next));
    std::move(edges.begin(), edges.end(), std::back_inserter(all));
  }
  return all;
}

base::Result<std::vector<ChartEdge>> plane_edges(const Surface& surface, Point3 on_plane, Vector3 normal,
                                                 const CommonEdgeOptions& options) {
  DOBRA_TRY(SharedSet set, intersect_plane(surface, on_plane, normal));
  // The plane by axes of our own, as wide as the curves need.
  const Vector3 n = geom::normalised(normal);
  const Vector3 some = std::abs(n.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  const Vector3 x = geom::normalised(cross(some, n)), y = cross(n, x);
  geom::Box chart;
  for (SharedCurve& curve : set.curves) {
    for (SharedPoint& p : curve.points) {
      p.second = {dot(p.at - on_plane, x), dot(p.at - on_plane, y)};
      chart.add(p.second);
    }
  }
  std::vector<ChartEdge> edges;
  if (chart.empty()) return edges;
  DOBRA_TRY(const Surface plane, Surface::plane({on_plane, x, y, n}, chart.grown(0.1 * surface.size())));
  for (const SharedCurve& curve : set.curves) {
    CommonEdgeOptions next = options;
    next.number += static_cast<SharedCurveId>(edges.size());
    DOBRA_TRY(const std::vector<CommonEdge> found, common_edges(surface, plane, curve, next));
    for (const CommonEdge& edge : found) edges.push_back(edge.first);
  }
  return edges;
}

}  // namespace dobra::surf::trim
