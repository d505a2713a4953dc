#include "shared/surf/param/parametrise.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/base/check.h"
#include "shared/geom/box.h"
#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"

namespace dobra::surf::param {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

Eigen::Vector3d eigen(Vector3 v) { return {v.x, v.y, v.z}; }

/// The mean plane of some points, its first axis along the step from the first to the second.
struct Plane {
  Point3 origin;
  Vector3 x, y;
  [[nodiscard]] Point of(Point3 p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

Result<Plane> plane_of(const std::vector<Point3>& stones) {
  Vector3 sum;
  for (const Point3 p : stones) sum = sum + (p - stones[0]);
  const Point3 centre = stones[0] + sum / static_cast<double>(stones.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point3 p : stones) spread += eigen(p - centre) * eigen(p - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Eigen::Vector3d& values = axes.eigenvalues();
  constexpr double line = 1e-12;
  const Eigen::Vector3d least = axes.eigenvectors().col(0);
  const Vector3 normal{least(0), least(1), least(2)};
  const Vector3 step = stones[1] - stones[0];
  const Vector3 along = step - dot(step, normal) * normal;
  if (!(values(1) > line * values(2)) || !(geom::length(along) > 0.0)) {
    return Error{ErrorCode::CannotMesh, "the border stones lie on a line, so they span no plane",
                 base::Place{.x = centre.x, .y = centre.y, .z = centre.z}};
  }
  const Vector3 x = normalised(along);
  return Plane{stones[0], x, cross(normal, x)};
}

bool crosses_itself(const std::vector<Point>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const geom::Segment a{polygon[i], polygon[(i + 1) % n]};
    if (a.length() == 0.0) return true;
    for (std::size_t j = i + 1; j < n; ++j) {
      const geom::Segment b{polygon[j], polygon[(j + 1) % n]};
      const auto meeting = geom::intersect(a, b);
      if (meeting.kind == geom::IntersectionKind::None) continue;
      const bool beside = j == i + 1 || (i == 0 && j + 1 == n);
      if (!beside || meeting.kind == geom::IntersectionKind::Overlap) return true;
    }
  }
  return false;
}

double signed_area(const std::vector<Point>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i] - Point{}, polygon[(i + 1) % polygon.size()] - Point{});
  return 0.5 * twice;
}

/// Length along the loop up to each of its vertices, and of all of it.
std::vector<double> lengths_along(const Sheet& sheet, const std::vector<std::uint32_t>& loop) {
  std::vector<double> along(loop.size() + 1, 0.0);
  for (std::size_t i = 0; i < loop.size(); ++i)
    along[i + 1] = along[i] + geom::distance(sheet.points[loop[i]], sheet.points[loop[(i + 1) % loop.size()]]);
  return along;
}

/// Moves and scales into the unit square, both axes alike. @return units of before in one of the new
double normalise(std::vector<Point>& uv, const std::vector<std::uint32_t>& loop) {
  geom::Box box;
  for (const std::uint32_t v : loop) box.add(uv[v]);
  const double scale = std::max(box.width(), box.height());
  for (const std::uint32_t v : loop) uv[v] = {(uv[v].x - box.low.x) / scale, (uv[v].y - box.low.y) / scale};
  return scale;
}

void on_circle(const Sheet& sheet, std::vector<Point>& uv) {
  const auto& loop = sheet.loops[0];
  const std::vector<double> along = lengths_along(sheet, loop);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * along[i] / along.back();
    uv[loop[i]] = {0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)};
  }
}

/// Vertices between two stones, on the straight line between them, by arc length.
void on_line(const Sheet& sheet, std::size_t from, std::size_t steps, std::vector<Point>& uv) {
  const auto& loop = sheet.loops[0];
  std::vector<double> along{0.0};
  const auto vertex = [&](std::size_t k) { return loop[(from + k) % loop.size()]; };
  for (std::size_t k = 0; k < steps; ++k)
    along.push_back(along.back() + geom::distance(sheet.points[vertex(k)], sheet.points[vertex(k + 1)]));
  const Point begin = uv[vertex(0)], end = uv[vertex(steps)];
  for (std::size_t k = 1; k < steps; ++k) uv[vertex(k)] = geom::interpolate(begin, end, along[k] / along.back());
}

/// The border straight between stones. @return m in a unit of the chart
/// @error CannotMesh: fewer than three stones, stones on a line, a polygon that crosses itself
Result<double> on_stones(const Sheet& sheet, const std::vector<std::uint32_t>& stones, std::vector<Point>& uv) {
  constexpr std::size_t most = 400;
  const auto& loop = sheet.loops[0];
  const Point3 somewhere = sheet.points[loop[0]];
  const auto refused = [&](std::string message) {
    return Error{ErrorCode::CannotMesh, std::move(message),
                 base::Place{.x = somewhere.x, .y = somewhere.y, .z = somewhere.z}};
  };
  if (stones.size() < 3)
    return refused(fmt::format("the border has {} sharp corners; three border stones are the least", stones.size()));
  if (stones.size() > most)
    return refused(fmt::format("the border has {} sharp corners, more than {}: it is jagged", stones.size(), most));
  std::vector<Point3> at;
  for (const std::uint32_t v : stones) at.push_back(sheet.points[v]);
  DOBRA_TRY(Plane plane, plane_of(at));
  std::vector<Point> polygon;
  for (const Point3 p : at) polygon.push_back(plane.of(p));
  if (signed_area(polygon) < 0.0) {
    plane.y = -plane.y;
    for (Point& p : polygon) p.y = -p.y;
  }
  if (crosses_itself(polygon)) return refused("the border stones, laid flat, make a polygon that crosses itself");
  for (std::size_t i = 0; i < stones.size(); ++i) uv[stones[i]] = polygon[i];
  std::vector<std::size_t> position;
  for (const std::uint32_t v : stones)
    position.push_back(static_cast<std::size_t>(std::find(loop.begin(), loop.end(), v) - loop.begin()));
  for (std::size_t i = 0; i < stones.size(); ++i) {
    const std::size_t from = position[i], to = position[(i + 1) % position.size()];
    on_line(sheet, from, (to + loop.size() - from) % loop.size(), uv);
  }
  return normalise(uv, loop);
}

Result<void> check_stones(const Sheet& sheet, const std::vector<std::uint32_t>& stones) {
  const auto& loop = sheet.loops[0];
  std::vector<std::ptrdiff_t> position;
  for (const std::uint32_t v : stones) {
    const auto found = std::find(loop.begin(), loop.end(), v);
    if (found == loop.end())
      return Error{ErrorCode::InvalidOption, fmt::format("point {}, given as a border stone, is not on the border", v)};
    position.push_back(found - loop.begin());
  }
  std::size_t wraps = 0;
  for (std::size_t i = 0; i < position.size(); ++i) wraps += position[(i + 1) % position.size()] <= position[i] ? 1 : 0;
  if (stones.size() < 3 || wraps != 1) {
    return Error{ErrorCode::InvalidOption,
                 "border stones are three at least, in the order of the border, the sheet on its left"};
  }
  return {};
}

}  // namespace

std::vector<std::uint32_t> border_stones(const Sheet& sheet, const std::vector<std::uint32_t>& loop,
                                         const StoneOptions& options) {
  std::vector<std::uint32_t> stones;
  const double straightest = std::cos(options.turn * std::numbers::pi / 180.0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point3 at = sheet.points[loop[i]];
    const Vector3 before = at - sheet.points[loop[(i + loop.size() - 1) % loop.size()]];
    const Vector3 after = sheet.points[loop[(i + 1) % loop.size()]] - at;
    if (dot(before, after) <= straightest * geom::length(before) * geom::length(after)) stones.push_back(loop[i]);
  }
  return stones;
}

std::vector<std::uint32_t> flipped_triangles(const Sheet& sheet, const std::vector<Point>& uv) {
  std::vector<std::uint32_t> flipped;
  for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t) {
    const auto& [a, b, c] = sheet.triangles[t];
    if (geom::orient2d(uv[a], uv[b], uv[c]) != geom::Sign::Positive) flipped.push_back(t);
  }
  return flipped;
}

Result<Parametrisation> parametrise(const Sheet& sheet, const ParametriseOptions& options) {
  DOBRA_CHECK(sheet.disk());
  Parametrisation made{std::vector<Point>(sheet.points.size()), options.given_stones, BorderShape::Stones, {}};
  if (made.stones.empty())
    made.stones = border_stones(sheet, sheet.loops[0], options.stones);
  else
    DOBRA_TRY_VOID(check_stones(sheet, made.stones));
  if (options.border != BorderShape::Circle) {
    const auto scale = on_stones(sheet, made.stones, made.uv);
    if (scale) {
      made.scale = *scale;
      DOBRA_TRY_VOID(solve_inside(sheet, options.weights, made.uv));
      made.flipped = flipped_triangles(sheet, made.uv);
      if (made.flipped.empty() || options.border == BorderShape::Stones) return made;
      made.why_circle =
          fmt::format("{} triangles are flipped between straight lines from stone to stone", made.flipped.size());
    } else if (options.border == BorderShape::Stones) {
      return scale.error();
    } else {
      made.why_circle = scale.error().message;
    }
  }
  made.stones.clear();
  made.border = BorderShape::Circle;
  made.scale = 0.0;
  on_circle(sheet, made.uv);
  DOBRA_TRY_VOID(solve_inside(sheet, options.weights, made.uv));
  made.flipped = flipped_triangles(sheet, made.uv);
  return made;
}

}  // namespace dobra::surf::param
