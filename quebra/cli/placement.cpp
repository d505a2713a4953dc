#include "quebra/cli/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shared/base/text.h"
#include "shared/geom/predicates.h"
#include "shared/solid/dyadic.h"

namespace quebra::cli {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using solid::Dyadic;

namespace {

/// The sign of the determinant of its first three rows and columns: 1, -1, or 0.
int turn_of(const Matrix& m) {
  const auto at = [&](std::size_t row, std::size_t column) { return Dyadic(m[4 * row + column]); };
  const auto minor = [&](std::size_t i, std::size_t j) { return at(1, i) * at(2, j) - at(1, j) * at(2, i); };
  const Dyadic determinant = at(0, 0) * minor(1, 2) - at(0, 1) * minor(0, 2) + at(0, 2) * minor(0, 1);
  return static_cast<int>(determinant.sign());
}

}  // namespace

Result<Matrix> parse_matrix(const std::string& text) {
  Matrix matrix{};
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= text.size(); ++count) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const auto value = base::parse_number(word);
    if (!value || !std::isfinite(*value))
      return Error{ErrorCode::BadValue, fmt::format("--place: '{}' is not a finite number", word)};
    if (count < matrix.size()) matrix[count] = *value;
    begin = end + 1;
  }
  if (count != matrix.size()) {
    return Error{
        ErrorCode::BadValue,
        fmt::format("--place has {} numbers: give the 16 of a matrix, row by row, with commas between them", count)};
  }
  if (matrix[12] != 0.0 || matrix[13] != 0.0 || matrix[14] != 0.0 || matrix[15] != 1.0)
    return Error{ErrorCode::BadValue, "--place: the last row of the matrix must be 0,0,0,1"};
  if (turn_of(matrix) == 0)
    return Error{ErrorCode::BadValue, "--place: the matrix makes every solid flat (its determinant is 0)"};
  return matrix;
}

Result<Placed> place(const mesh::PolygonMesh& mesh, const Matrix& matrix) {
  Placed out{mesh, 0};
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const geom::Point3 at = mesh.points[p];
    std::array<double, 3> moved{};
    bool exact = true;
    for (std::size_t row = 0; row < 3; ++row) {
      const double* const m = matrix.data() + 4 * row;
      const Dyadic value =
          Dyadic(m[0]) * Dyadic(at.x) + Dyadic(m[1]) * Dyadic(at.y) + Dyadic(m[2]) * Dyadic(at.z) + Dyadic(m[3]);
      moved[row] = rounded(value);
      if (!std::isfinite(moved[row])) {
        return Error{ErrorCode::NotFinite, fmt::format("--place moves point {} beyond the largest number", p)};
      }
      exact = exact && (value - Dyadic(moved[row])).sign() == geom::Sign::Zero;
    }
    out.mesh.points[p] = {moved[0], moved[1], moved[2]};
    out.rounded += exact ? 0 : 1;
  }
  if (turn_of(matrix) < 0) {
    for (auto& face : out.mesh.faces) std::reverse(face.begin(), face.end());
  }
  return out;
}

}  // namespace quebra::cli
