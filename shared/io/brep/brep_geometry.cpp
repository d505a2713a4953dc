#include "shared/io/brep/brep_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dobra::io::brep {

using base::Result;

namespace {

constexpr int deepest = 32;  ///< Curves of curves; each is read by a call within a call.
constexpr long highest_degree = 25;

/// A knot vector, each knot once.
struct Knots {
  std::vector<double> at;
  std::vector<std::size_t> times;
};

Result<Knots> read_knots(Tokens& tokens, std::size_t count, std::size_t degree) {
  Knots knots;
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY(const double knot, tokens.number("a knot"));
    if (i > 0 && knot <= knots.at.back())
      return tokens.error(
          fmt::format("knot {} of {} is {}, not above the one before, {}", i + 1, count, knot, knots.at.back()));
    DOBRA_TRY(const long times, tokens.integer("how often a knot stands", 1, static_cast<long>(degree) + 1));
    knots.at.push_back(knot);
    knots.times.push_back(static_cast<std::size_t>(times));
  }
  return knots;
}

/// The knots as often as they stand.
/// @param wrapped  how many control points stand again at the end, of a periodic spline; set here.
Result<std::vector<double>> written_out(const Tokens& tokens, const Knots& knots, bool periodic, std::size_t degree,
                                        std::size_t points, std::size_t& wrapped) {
  const std::size_t sum = std::accumulate(knots.times.begin(), knots.times.end(), std::size_t{0});
  const std::size_t first = knots.times.front(), last = knots.times.back();
  const std::size_t fitting = periodic ? sum - last : sum - std::min(sum, degree + 1);
  if (fitting != points || (periodic && (first != last || first > degree)))
    return tokens.error(fmt::format(
        "{} knots, counted as often as they stand, do not fit {} control points and degree {}", sum, points, degree));
  std::vector<double> all;
  for (std::size_t i = 0; i < knots.at.size(); ++i) all.insert(all.end(), knots.times[i], knots.at[i]);
  wrapped = 0;
  if (!periodic) return all;
  // Before the first knot those before the last one, a period earlier; behind the last those behind the first.
  wrapped = degree + 1 - first;
  const double period = knots.at.back() - knots.at.front();
  const std::size_t a_period = sum - last;
  const auto knot = [&](std::ptrdiff_t i) {
    const auto size = static_cast<std::ptrdiff_t>(a_period);
    const std::ptrdiff_t turns = i >= 0 ? i / size : -((-i + size - 1) / size);
    return all[static_cast<std::size_t>(i - turns * size)] + static_cast<double>(turns) * period;
  };
  std::vector<double> out;
  const auto before = static_cast<std::ptrdiff_t>(wrapped);
  for (std::ptrdiff_t i = -before; i < static_cast<std::ptrdiff_t>(sum) + before; ++i)
    out.push_back(i >= 0 && i < static_cast<std::ptrdiff_t>(sum) ? all[static_cast<std::size_t>(i)] : knot(i));
  return out;
}

std::vector<double> bezier_knots(std::size_t degree) {
  std::vector<double> knots(2 * (degree + 1), 0.0);
  std::fill(knots.begin() + static_cast<std::ptrdiff_t>(degree) + 1, knots.end(), 1.0);
  return knots;
}

Result<void> read_pole(Tokens& tokens, Room room, bool rational, Spline& spline) {
  DOBRA_TRY(const geom::Point3 at,
            room == Room::Chart ? tokens.point_of_chart("a control point") : tokens.point("a control point"));
  spline.points.push_back(at);
  if (!rational) return {};
  DOBRA_TRY(const double weight, tokens.number("a weight"));
  if (!(weight > 0.0)) return tokens.error(fmt::format("a weight is {}; it must be positive", weight));
  spline.weights.push_back(weight);
  return {};
}

Result<std::size_t> read_degree(Tokens& tokens) {
  DOBRA_TRY(const long degree, tokens.integer("a degree", 1, highest_degree));
  return static_cast<std::size_t>(degree);
}

Result<Spline> read_bezier(Tokens& tokens, Room room) {
  DOBRA_TRY(const bool rational, tokens.flag("whether it is rational"));
  Spline spline;
  DOBRA_TRY(spline.degree, read_degree(tokens));
  for (std::size_t i = 0; i <= spline.degree; ++i) DOBRA_TRY_VOID(read_pole(tokens, room, rational, spline));
  spline.knots = bezier_knots(spline.degree);
  return spline;
}

Result<Spline> read_spline(Tokens& tokens, Room room) {
  DOBRA_TRY(const bool rational, tokens.flag("whether it is rational"));
  DOBRA_TRY(const bool periodic, tokens.flag("whether it is periodic"));
  Spline spline;
  DOBRA_TRY(spline.degree, read_degree(tokens));
  DOBRA_TRY(const std::size_t points, tokens.count("the number of control points", 2));
  DOBRA_TRY(const std::size_t knots, tokens.count("the number of knots", 2));
  if (points < 2 || knots < 2) return tokens.error("a spline has two control points and two knots at least");
  for (std::size_t i = 0; i < points; ++i) DOBRA_TRY_VOID(read_pole(tokens, room, rational, spline));
  DOBRA_TRY(const Knots once, read_knots(tokens, knots, spline.degree));
  std::size_t wrapped = 0;
  DOBRA_TRY(spline.knots, written_out(tokens, once, periodic, spline.degree, points, wrapped));
  for (std::size_t i = 0; i < wrapped; ++i) {
    spline.points.push_back(spline.points[i % points]);
    if (rational) spline.weights.push_back(spline.weights[i % points]);
  }
  return spline;
}

Result<double> read_radius(Tokens& tokens, std::string_view what) {
  DOBRA_TRY(const double radius, tokens.number(what));
  if (radius < 0.0) return tokens.error(fmt::format("{} is {}; it cannot be negative", what, radius));
  return radius;
}

Result<Conic> read_conic(Tokens& tokens, Room room, Conic::Kind kind) {
  Conic conic{kind, {}, {}, {}, 0.0, 0.0};
  if (room == Room::Chart) {
    DOBRA_TRY(conic.at, tokens.point_of_chart("the centre of a conic"));
    DOBRA_TRY(const geom::Point3 x, tokens.point_of_chart("an axis of a conic"));
    DOBRA_TRY(const geom::Point3 y, tokens.point_of_chart("an axis of a conic"));
    conic.x = x - geom::Point3{};
    conic.y = y - geom::Point3{};
  } else {
    DOBRA_TRY(conic.at, tokens.point("the centre of a conic"));
    DOBRA_TRY_VOID(tokens.vector("the normal of a conic"));
    DOBRA_TRY(conic.x, tokens.vector("an axis of a conic"));
    DOBRA_TRY(conic.y, tokens.vector("an axis of a conic"));
  }
  DOBRA_TRY(conic.a, read_radius(tokens, "a radius"));
  conic.b = conic.a;
  if (kind == Conic::Kind::Ellipse || kind == Conic::Kind::Hyperbola) {
    DOBRA_TRY(conic.b, read_radius(tokens, "a radius"));
  }
  return conic;
}

Result<CurvePtr> read_curve(Tokens& tokens, Room room, int depth) {
  const auto made = [](auto&& is) { return std::make_shared<const Curve>(Curve{std::forward<decltype(is)>(is)}); };
  DOBRA_TRY(const long kind, tokens.integer("the kind of a curve", 1, 9));
  if (depth > deepest) return tokens.error(fmt::format("curves of curves are more than {} deep", deepest));
  switch (kind) {
    case 1: {
      Line line;
      if (room == Room::Chart) {
        DOBRA_TRY(line.at, tokens.point_of_chart("a point of a line"));
        DOBRA_TRY(const geom::Point3 along, tokens.point_of_chart("the direction of a line"));
        line.along = along - geom::Point3{};
      } else {
        DOBRA_TRY(line.at, tokens.point("a point of a line"));
        DOBRA_TRY(line.along, tokens.vector("the direction of a line"));
      }
      return made(line);
    }
    case 2:
    case 3:
    case 4:
    case 5: {
      constexpr std::array kinds{Conic::Kind::Circle, Conic::Kind::Ellipse, Conic::Kind::Parabola,
                                 Conic::Kind::Hyperbola};
      DOBRA_TRY(const Conic conic, read_conic(tokens, room, kinds[static_cast<std::size_t>(kind - 2)]));
      return made(conic);
    }
    case 6:
    case 7: {
      DOBRA_TRY(Spline spline, kind == 6 ? read_bezier(tokens, room) : read_spline(tokens, room));
      return made(std::move(spline));
    }
    case 8: {
      TrimmedCurve trimmed;
      DOBRA_TRY(trimmed.from, tokens.number("where a curve begins"));
      DOBRA_TRY(trimmed.to, tokens.number("where a curve ends"));
      DOBRA_TRY(trimmed.of, read_curve(tokens, room, depth + 1));
      return made(trimmed);
    }
    default: {
      OffsetCurve offset;
      DOBRA_TRY(offset.distance, tokens.number("an offset"));
      if (room == Room::Space) {
        DOBRA_TRY(offset.direction, tokens.vector("the direction of an offset"));
      }
      DOBRA_TRY(offset.of, read_curve(tokens, room, depth + 1));
      return made(offset);
    }
  }
}

Result<Elementary> read_elementary(Tokens& tokens, Elementary::Kind kind) {
  using Kind = Elementary::Kind;
  Elementary surface;
  surface.kind = kind;
  DOBRA_TRY(surface.at, tokens.point("the origin of a surface"));
  DOBRA_TRY(surface.z, tokens.vector("an axis of a surface"));
  DOBRA_TRY(surface.x, tokens.vector("an axis of a surface"));
  DOBRA_TRY(surface.y, tokens.vector("an axis of a surface"));
  if (kind != Kind::Plane) {
    DOBRA_TRY(surface.radius, read_radius(tokens, "a radius"));
  }
  if (kind == Kind::Cone) {
    DOBRA_TRY(surface.other, tokens.number("the half angle of a cone"));
  }
  if (kind == Kind::Torus) {
    DOBRA_TRY(surface.other, read_radius(tokens, "a radius"));
  }
  return surface;
}

/// @param own_knots  of a B-spline patch; a Bezier patch has those of its degrees.
Result<SplinePatch> read_patch(Tokens& tokens, bool own_knots) {
  DOBRA_TRY(const bool rational_u, tokens.flag("whether it is rational"));
  DOBRA_TRY(const bool rational_v, tokens.flag("whether it is rational"));
  bool periodic_u = false, periodic_v = false;
  if (own_knots) {
    DOBRA_TRY(periodic_u, tokens.flag("whether it is periodic"));
    DOBRA_TRY(periodic_v, tokens.flag("whether it is periodic"));
  }
  SplinePatch patch;
  DOBRA_TRY(patch.degree_u, read_degree(tokens));
  DOBRA_TRY(patch.degree_v, read_degree(tokens));
  std::size_t points_u = patch.degree_u + 1, points_v = patch.degree_v + 1, count_u = 0, count_v = 0;
  if (own_knots) {
    DOBRA_TRY(points_u, tokens.count("the number of control points", 3));
    DOBRA_TRY(points_v, tokens.count("the number of control points", 3));
    DOBRA_TRY(count_u, tokens.count("the number of knots", 2));
    DOBRA_TRY(count_v, tokens.count("the number of knots", 2));
    if (std::min({points_u, points_v, count_u, count_v}) < 2)
      return tokens.error("a patch has two control points and two knots each way at least");
  }
  Spline poles;  // of all rows; memory grows with what is read
  for (std::size_t i = 0; i < points_u * points_v; ++i)
    DOBRA_TRY_VOID(read_pole(tokens, Room::Space, rational_u || rational_v, poles));
  std::size_t wrapped_u = 0, wrapped_v = 0;
  if (own_knots) {
    DOBRA_TRY(const Knots once_u, read_knots(tokens, count_u, patch.degree_u));
    DOBRA_TRY(patch.knots_u, written_out(tokens, once_u, periodic_u, patch.degree_u, points_u, wrapped_u));
    DOBRA_TRY(const Knots once_v, read_knots(tokens, count_v, patch.degree_v));
    DOBRA_TRY(patch.knots_v, written_out(tokens, once_v, periodic_v, patch.degree_v, points_v, wrapped_v));
  } else {
    patch.knots_u = bezier_knots(patch.degree_u);
    patch.knots_v = bezier_knots(patch.degree_v);
  }
  for (std::size_t i = 0; i < points_u + wrapped_u; ++i) {
    for (std::size_t j = 0; j < points_v + wrapped_v; ++j) {
      const std::size_t pole = (i % points_u) * points_v + j % points_v;
      patch.points.push_back(poles.points[pole]);
      if (!poles.weights.empty()) patch.weights.push_back(poles.weights[pole]);
    }
  }
  return patch;
}

Result<SurfacePtr> read_surface(Tokens& tokens, int depth) {
  const auto made = [](auto&& is) { return std::make_shared<const Surface>(Surface{std::forward<decltype(is)>(is)}); };
  DOBRA_TRY(const long kind, tokens.integer("the kind of a surface", 1, 11));
  if (depth > deepest) return tokens.error(fmt::format("surfaces of surfaces are more than {} deep", deepest));
  switch (kind) {
    case 6: {
      Extrusion extrusion;
      DOBRA_TRY(extrusion.along, tokens.vector("the direction of an extrusion"));
      DOBRA_TRY(extrusion.of, read_curve(tokens, Room::Space, depth + 1));
      return made(extrusion);
    }
    case 7: {
      Revolution revolution;
      DOBRA_TRY(revolution.at, tokens.point("a point of an axis"));
      DOBRA_TRY(revolution.axis, tokens.vector("the direction of an axis"));
      DOBRA_TRY(revolution.of, read_curve(tokens, Room::Space, depth + 1));
      return made(revolution);
    }
    case 8:
    case 9: {
      DOBRA_TRY(SplinePatch patch, read_patch(tokens, kind == 9));
      return made(std::move(patch));
    }
    case 10: {
      TrimmedPatch trimmed;
      DOBRA_TRY(trimmed.low.x, tokens.number("where a patch begins"));
      DOBRA_TRY(trimmed.high.x, tokens.number("where a patch ends"));
      DOBRA_TRY(trimmed.low.y, tokens.number("where a patch begins"));
      DOBRA_TRY(trimmed.high.y, tokens.number("where a patch ends"));
      DOBRA_TRY(trimmed.of, read_surface(tokens, depth + 1));
      return made(trimmed);
    }
    case 11: {
      OffsetPatch offset;
      DOBRA_TRY(offset.distance, tokens.number("an offset"));
      DOBRA_TRY(offset.of, read_surface(tokens, depth + 1));
      return made(offset);
    }
    default: {
      constexpr std::array kinds{Elementary::Kind::Plane, Elementary::Kind::Cylinder, Elementary::Kind::Cone,
                                 Elementary::Kind::Sphere, Elementary::Kind::Torus};
      DOBRA_TRY(const Elementary surface, read_elementary(tokens, kinds[static_cast<std::size_t>(kind - 1)]));
      return made(surface);
    }
  }
}

/// Powers of locations before, the last one applied last.
Result<Placement> read_product(Tokens& tokens, const std::vector<Placement>& before) {
  Placement product;
  while (tokens.peek() != "0") {
    DOBRA_TRY(const std::size_t factor, tokens.index("location", before.size()));
    DOBRA_TRY(const long power, tokens.integer("the power of a location", -1'000, 1'000));
    const Placement one = power < 0 ? before[factor].inverse() : before[factor];
    for (long i = 0; i < std::abs(power); ++i) product = one * product;
  }
  DOBRA_TRY_VOID(tokens.expect("0"));
  return product;
}

}  // namespace

Result<std::vector<CurvePtr>> read_curves(Tokens& tokens, Room room) {
  DOBRA_TRY_VOID(tokens.expect(room == Room::Chart ? "Curve2ds" : "Curves"));
  DOBRA_TRY(const std::size_t count, tokens.count("the number of curves", 5));
  std::vector<CurvePtr> curves;
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY(CurvePtr curve, read_curve(tokens, room, 0));
    curves.push_back(std::move(curve));
  }
  return curves;
}

Result<std::vector<SurfacePtr>> read_surfaces(Tokens& tokens) {
  DOBRA_TRY_VOID(tokens.expect("Surfaces"));
  DOBRA_TRY(const std::size_t count, tokens.count("the number of surfaces", 9));
  std::vector<SurfacePtr> surfaces;
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY(SurfacePtr surface, read_surface(tokens, 0));
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

Result<std::vector<Placement>> read_locations(Tokens& tokens) {
  DOBRA_TRY_VOID(tokens.expect("Locations"));
  DOBRA_TRY(const std::size_t count, tokens.count("the number of locations", 2));
  std::vector<Placement> locations;
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY(const long kind, tokens.integer("the kind of a location", 1, 2));
    Placement placement;
    if (kind == 1) {
      std::array<double, 12> rows{};
      for (double& number : rows) {
        DOBRA_TRY(number, tokens.number("a location"));
      }
      placement = {{rows[0], rows[4], rows[8]},
                   {rows[1], rows[5], rows[9]},
                   {rows[2], rows[6], rows[10]},
                   {rows[3], rows[7], rows[11]}};
    } else {
      DOBRA_TRY(placement, read_product(tokens, locations));
    }
    if (!std::isnormal(placement.scale_of_volume()) || !geom::is_finite(placement.origin))
      return tokens.error(fmt::format("location {} makes things flat or endless", i + 1));
    locations.push_back(placement);
  }
  return locations;
}

}  // namespace dobra::io::brep
