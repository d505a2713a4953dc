#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/io/faces/geometry.h"

namespace dobra::io::faces {

using base::Result;
using geom::Point3;
using geom::Vector3;

namespace {

template <class... Kinds>
struct Match : Kinds... {
  using Kinds::operator()...;
};
template <class... Kinds>
Match(Kinds...) -> Match<Kinds...>;

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double closes = 1e-9;  ///< Part of its size by which the ends of a closed curve are apart at most.

Result<surf::Curve> conic_of(const brep::Conic& conic, double from, double to) {
  using Kind = brep::Conic::Kind;
  if (!(conic.a > 0.0) || !(conic.b > 0.0))
    return base::Error{base::ErrorCode::DegenerateCurve,
                       fmt::format("a conic has radii of {} and {}; both must be above 0", conic.a, conic.b)};
  switch (conic.kind) {
    case Kind::Parabola:
      return surf::Curve::conic(surf::Curve::Conic::Parabola, conic.at, 0.25 / conic.a * conic.x, conic.y, from, to);
    case Kind::Hyperbola:
      return surf::Curve::conic(surf::Curve::Conic::Hyperbola, conic.at, conic.a * conic.x, conic.b * conic.y, from,
                                to);
    default:
      return surf::Curve::conic(surf::Curve::Conic::Ellipse, conic.at, conic.a * conic.x, conic.b * conic.y, from, to);
  }
}

Result<surf::Curve> whole_spline(const brep::Spline& spline) {
  return surf::Curve::nurbs(spline.degree, spline.knots, spline.points, spline.weights);
}

}  // namespace

Result<CurveRange> range_of(const brep::Curve& curve) {
  return std::visit(
      Match{[](const brep::Line&) -> Result<CurveRange> { return CurveRange{}; },
            [](const brep::Conic& conic) -> Result<CurveRange> {
              using Kind = brep::Conic::Kind;
              if (conic.kind == Kind::Circle || conic.kind == Kind::Ellipse) return CurveRange{0.0, turn, turn};
              return CurveRange{};
            },
            [](const brep::Spline& spline) -> Result<CurveRange> {
              DOBRA_TRY(const surf::Curve made, whole_spline(spline));
              double size = 0.0;
              for (int i = 1; i <= 16; ++i)
                size = std::max(size,
                                distance(made.at(made.low()), made.at(std::lerp(made.low(), made.high(), i / 17.0))));
              const bool closed = distance(made.at(made.low()), made.at(made.high())) <= closes * size;
              return CurveRange{made.low(), made.high(), closed ? made.high() - made.low() : 0.0};
            },
            [](const brep::TrimmedCurve& trimmed) -> Result<CurveRange> {
              DOBRA_TRY(const CurveRange of, range_of(*trimmed.of));
              return CurveRange{std::min(trimmed.from, trimmed.to), std::max(trimmed.from, trimmed.to), of.period};
            },
            [](const brep::OffsetCurve& offset) { return range_of(*offset.of); }},
      curve.is);
}

Result<surf::Curve> to_curve(const brep::Curve& curve, double from, double to) {
  return std::visit(Match{[&](const brep::Line& line) { return surf::Curve::line(line.at, line.along, from, to); },
                          [&](const brep::Conic& conic) { return conic_of(conic, from, to); },
                          [&](const brep::Spline& spline) -> Result<surf::Curve> {
                            DOBRA_TRY(const surf::Curve made, whole_spline(spline));
                            return made.over(from, to);
                          },
                          [&](const brep::TrimmedCurve& trimmed) { return to_curve(*trimmed.of, from, to); },
                          [&](const brep::OffsetCurve& offset) -> Result<surf::Curve> {
                            DOBRA_TRY(const surf::Curve of, to_curve(*offset.of, from, to));
                            return of.offset(offset.distance, offset.direction);
                          }},
                    curve.is);
}

surf::Curve placed(const surf::Curve& curve, const brep::Placement& placement) {
  if (placement == brep::Placement{}) return curve;
  return curve.moved(placement.x, placement.y, placement.z, placement.origin);
}

}  // namespace dobra::io::faces
