#include "shared/solid/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/geom/predicates.h"
#include "shared/solid/dyadic.h"

namespace dobra::solid {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

/// The sign of the determinant of its first three rows and columns: 1, -1, or 0.
int turn_of(const Matrix& m) {
  const auto at = [&](std::size_t row, std::size_t column) { return Dyadic(m[4 * row + column]); };
  const auto minor = [&](std::size_t i, std::size_t j) { return at(1, i) * at(2, j) - at(1, j) * at(2, i); };
  const Dyadic determinant = at(0, 0) * minor(1, 2) - at(0, 1) * minor(0, 2) + at(0, 2) * minor(0, 1);
  return static_cast<int>(determinant.sign());
}

/// Columns x, y, z of the turned axes, and the place of the origin.
Matrix of_columns(geom::Vector3 x, geom::Vector3 y, geom::Vector3 z, geom::Vector3 origin = {}) {
  return {x.x, y.x, z.x, origin.x, x.y, y.y, z.y, origin.y, x.z, y.z, z.z, origin.z, 0, 0, 0, 1};
}

Matrix about_point(geom::Point3 about, const Matrix& matrix) {
  const geom::Vector3 to = about - geom::Point3{};
  return product(moved_by(to), product(matrix, moved_by(-to)));
}

}  // namespace

std::array<double, 2> circle_at(double degrees) {
  const double quarters = degrees / 90.0;
  if (quarters == std::floor(quarters)) {
    constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const double turn = std::fmod(quarters, 4.0);
    return exact[static_cast<std::size_t>(turn < 0.0 ? turn + 4.0 : turn)];
  }
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

Matrix product(const Matrix& outer, const Matrix& inner) {
  Matrix m{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t k = 0; k < 4; ++k) m[4 * row + column] += outer[4 * row + k] * inner[4 * k + column];
    }
  }
  return m;
}

Matrix moved_by(geom::Vector3 by) { return of_columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by); }

Matrix turned(geom::Point3 about, geom::Vector3 axis, double degrees) {
  const geom::Vector3 n = normalised(axis);
  const auto turn = circle_at(degrees);
  const auto column = [&](geom::Vector3 e) {
    const auto& [c, s] = turn;
    return c * e + s * cross(n, e) + (1.0 - c) * dot(n, e) * n;
  };
  return about_point(about, of_columns(column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})));
}

Matrix scaled(geom::Point3 about, geom::Vector3 factors) {
  return about_point(about, of_columns({factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}));
}

Matrix along(geom::Vector3 direction) {
  const geom::Vector3 z = normalised(direction);
  if (z == geom::Vector3{0, 0, 1}) return identity;
  if (z == geom::Vector3{0, 0, -1}) return of_columns({1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  // x stays level, so that rings of prisms lie alike for all directions.
  const geom::Vector3 x = normalised(cross({0, 0, 1}, z));
  return of_columns(x, cross(z, x), z);
}

Result<void> check_matrix(const Matrix& matrix) {
  if (!std::all_of(matrix.begin(), matrix.end(), [](double x) { return std::isfinite(x); }))
    return Error{ErrorCode::BadValue, "the numbers of a matrix must be finite"};
  if (matrix[12] != 0.0 || matrix[13] != 0.0 || matrix[14] != 0.0 || matrix[15] != 1.0)
    return Error{ErrorCode::BadValue, "the last row of the matrix must be 0,0,0,1"};
  if (turn_of(matrix) == 0)
    return Error{ErrorCode::BadValue, "the matrix makes every solid flat (its determinant is 0)"};
  return {};
}

bool mirrors(const Matrix& matrix) { return turn_of(matrix) < 0; }

Result<std::size_t> place(std::vector<geom::Point3>& points, const Matrix& matrix) {
  std::size_t count = 0;
  if (matrix == identity) return count;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const geom::Point3 at = points[p];
    std::array<double, 3> moved{};
    bool exact = true;
    for (std::size_t row = 0; row < 3; ++row) {
      const double* const m = matrix.data() + 4 * row;
      const Dyadic value =
          Dyadic(m[0]) * Dyadic(at.x) + Dyadic(m[1]) * Dyadic(at.y) + Dyadic(m[2]) * Dyadic(at.z) + Dyadic(m[3]);
      moved[row] = rounded(value);
      if (!std::isfinite(moved[row]))
        return Error{ErrorCode::NotFinite, fmt::format("the matrix moves point {} beyond the largest number", p)};
      exact = exact && (value - Dyadic(moved[row])).sign() == geom::Sign::Zero;
    }
    points[p] = {moved[0], moved[1], moved[2]};
    count += exact ? 0 : 1;
  }
  return count;
}

Result<void> put_error(Error& error, const Matrix& matrix) {
  if (!error.place || !error.place->x || !error.place->y || !error.place->z) return {};
  std::vector<geom::Point3> at{{*error.place->x, *error.place->y, *error.place->z}};
  DOBRA_TRY_VOID(place(at, matrix));
  error.place->x = at[0].x;
  error.place->y = at[0].y;
  error.place->z = at[0].z;
  return {};
}

}  // namespace dobra::solid
