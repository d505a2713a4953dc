#include "shared/surf/triangular_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Vector3;

namespace {

/// Below it differences of a curve with its end are taken from their Taylor series there.
constexpr double near = 1e-3;
/// Ends meet to this part of the size.
constexpr double meeting = 1e-9;

struct TriangularShape : Surface::Shape {
  TriangularPatch patch;
  explicit TriangularShape(TriangularPatch of) : patch(std::move(of)) {}

  void jets(std::span<const geom::Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet(uv[i].x, uv[i].y);
  }
  /// By the chain rule from area coordinates ((1 - s) (1 - t), s (1 - t), t).
  [[nodiscard]] Jet jet(double s, double t) const {
    const std::array c{(1.0 - s) * (1.0 - t), s * (1.0 - t), t};
    const TriangularPatch::Corner of = patch.jet(c[0], c[1], c[2]);
    const std::array by_s{-(1.0 - t), 1.0 - t, 0.0}, by_t{-(1.0 - s), -s, 1.0};
    const std::array first{of.by_u, of.by_v, of.by_w};
    Jet jet{of.at, {}, {}, {}, of.by_u - of.by_v, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      jet.u = jet.u + by_s[k] * first[k];
      jet.v = jet.v + by_t[k] * first[k];
      for (std::size_t m = 0; m < 3; ++m) {
        jet.uu = jet.uu + by_s[k] * by_s[m] * of.second[k][m];
        jet.uv = jet.uv + by_s[k] * by_t[m] * of.second[k][m];
        jet.vv = jet.vv + by_t[k] * by_t[m] * of.second[k][m];
      }
    }
    return jet;
  }
  [[nodiscard]] Bend bend(const geom::Box& part) const override {
    constexpr int places = 17;
    constexpr double safe = 1.5;
    Bend most;
    for (int i = 0; i < places * places; ++i) {
      const Jet at = jet(std::lerp(part.low.x, part.high.x, static_cast<double>(i / places) / (places - 1)),
                         std::lerp(part.low.y, part.high.y, static_cast<double>(i % places) / (places - 1)));
      most = {std::max(most.uu, safe * geom::length(at.uu)), std::max(most.uv, safe * geom::length(at.uv)),
              std::max(most.vv, safe * geom::length(at.vv))};
    }
    return most;
  }
};

}  // namespace

Curve::Jet TriangularPatch::Side::jet(double t) const {
  const double by = to - from;
  const Curve::Jet jet = curve.jet(t == 1.0 ? to : from + t * by);
  return {jet.at, by * jet.first, by * by * jet.second};
}

TriangularPatch::TriangularPatch(std::vector<Side> sides) : sides_(std::move(sides)) {
  // Where ends differ within the tolerance, the curve that begins there says where the corner is.
  for (std::size_t k = 0; k < 3; ++k) corner_[k] = sides_[k].jet(0.0).at;
}

base::Result<TriangularPatch> TriangularPatch::make(const Curve& first, const Curve& second, const Curve& third) {
  const std::array curves{first, second, third};
  std::vector<Point3> seen;
  for (const Curve& curve : curves) {
    for (int i = 0; i <= 4; ++i) seen.push_back(curve.at(std::lerp(curve.low(), curve.high(), i / 4.0)));
  }
  double size = 0.0;
  for (const Point3 p : seen) size = std::max(size, geom::distance(seen[0], p));
  std::vector<Side> best;
  double least = 0.0;
  Point3 place;
  for (unsigned turned = 0; turned < 8; ++turned) {
    std::vector<Side> sides;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool back = ((turned >> k) & 1U) != 0;
      sides.push_back(
          {curves[k], back ? curves[k].high() : curves[k].low(), back ? curves[k].low() : curves[k].high()});
    }
    double widest = -1.0;
    Point3 at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 end = sides[k].jet(1.0).at, begin = sides[(k + 1) % 3].jet(0.0).at;
      if (geom::distance(end, begin) > widest) widest = geom::distance(end, begin), at = geom::midpoint(end, begin);
    }
    if (best.empty() || widest < least) best = std::move(sides), least = widest, place = at;
  }
  if (!(least <= meeting * size)) {
    return Error{ErrorCode::DegenerateCurve,
                 fmt::format("the three curves do not meet: ends are {:.6g} m apart; move them together", least),
                 base::Place{.x = place.x, .y = place.y, .z = place.z}};
  }
  TriangularPatch patch(std::move(best));
  const auto& p = patch.corner_;
  if (!(geom::length(cross(p[1] - p[0], p[2] - p[0])) > meeting * size * size)) {
    return Error{ErrorCode::DegenerateCurve, "the three corners of the patch lie on a line",
                 base::Place{.x = p[0].x, .y = p[0].y, .z = p[0].z}};
  }
  return patch;
}

/// (curve - corner) / x at x along the side from `corner` towards another, with its derivatives by x.
TriangularPatch::Quotient TriangularPatch::quotient(std::size_t corner, std::size_t towards, double x) const {
  const bool along = towards == (corner + 1) % 3;
  const Side& side = sides_[along ? corner : towards];
  const double at = std::max(x, near);
  const Curve::Jet jet = side.jet(along ? at : 1.0 - at);
  const Vector3 slope = along ? jet.first : -jet.first;
  Quotient q;
  q.value = (jet.at - corner_[corner]) / at;
  q.first = (slope - q.value) / at;
  q.second = (jet.second - 2.0 * q.first) / at;
  if (x < near) {
    const double back = x - near;
    q.value = q.value + back * q.first + 0.5 * back * back * q.second;
    q.first = q.first + back * q.second;
  }
  return q;
}

TriangularPatch::Corner TriangularPatch::jet(double u, double v, double w) const {
  const std::array c{u, v, w};
  std::array<std::array<Quotient, 3>, 3> q{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (j != k) q[k][j] = quotient(k, j, 1.0 - c[k]);
    }
  }
  Vector3 sum;
  std::array<Vector3, 3> first{};
  Corner made;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 corner = corner_[k] - Point3{};
    sum = sum + (1.0 - c[k]) * corner;
    first[k] = first[k] - corner;
    for (std::size_t j = 0; j < 3; ++j) {
      if (j == k) continue;
      sum = sum + c[j] * q[k][j].value;
      first[k] = first[k] - c[j] * q[k][j].first + q[j][k].value;
      made.second[k][k] = made.second[k][k] + 0.5 * c[j] * q[k][j].second;
      made.second[k][j] = -0.5 * (q[k][j].first + q[j][k].first);
    }
  }
  made.at = Point3{} + 0.5 * sum;
  made.by_u = 0.5 * first[0];
  made.by_v = 0.5 * first[1];
  made.by_w = 0.5 * first[2];
  return made;
}

Point3 TriangularPatch::at(double u, double v, double w) const { return jet(u, v, w).at; }

base::Result<Surface> TriangularPatch::surface() const {
  return Surface::of(std::make_shared<const TriangularShape>(*this), {{0.0, 0.0}, {1.0, 1.0}});
}

TriangularGrid grid(const TriangularPatch& patch, std::uint32_t n) {
  TriangularGrid made;
  const auto number = [n](std::uint32_t i, std::uint32_t k) { return k * (2 * n + 3 - k) / 2 + i; };
  for (std::uint32_t k = 0; k <= n; ++k) {
    for (std::uint32_t i = 0; i + k <= n; ++i) {
      const std::array<double, 3> place{static_cast<double>(n - i - k) / n, static_cast<double>(i) / n,
                                        static_cast<double>(k) / n};
      made.places.push_back(place);
      made.points.push_back(patch.at(place[0], place[1], place[2]));
      if (i + k < n) made.triangles.push_back({number(i, k), number(i + 1, k), number(i, k + 1)});
      if (i + k + 1 < n) made.triangles.push_back({number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)});
    }
  }
  return made;
}

}  // namespace dobra::surf
