#include "shared/cli/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shared/base/text.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;
using base::Result;
using solid::Matrix;

namespace {

/// Blanks round them do not count. @error BadUsage naming the option
Result<std::vector<double>> numbers_of(const char* option, std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view word = base::trimmed(text.substr(begin, end - begin));
    const auto value = base::parse_number(word);
    if (!value || !std::isfinite(*value))
      return Error{ErrorCode::BadUsage, fmt::format("{}: '{}' is not a finite number", option, word)};
    numbers.push_back(*value);
    begin = end + 1;
  }
  return numbers;
}

}  // namespace

Result<Matrix> parse_matrix(const std::string& text) {
  DOBRA_TRY(const std::vector<double> numbers, numbers_of("--place", text));
  Matrix matrix{};
  if (numbers.size() != matrix.size()) {
    return Error{ErrorCode::BadUsage,
                 fmt::format("--place has {} numbers: give the 16 of a matrix, row by row, with commas between them",
                             numbers.size())};
  }
  std::copy(numbers.begin(), numbers.end(), matrix.begin());
  if (const auto good = solid::check_matrix(matrix); !good)
    return Error{ErrorCode::BadUsage, "--place: " + good.error().message};
  return matrix;
}

Result<Placed> place(const mesh::PolygonMesh& mesh, const Matrix& matrix) {
  Placed out{mesh, 0};
  auto rounded = solid::place(out.mesh.points, matrix);
  if (!rounded) return Error{ErrorCode::NotFinite, "--place: " + rounded.error().message};
  out.rounded = *rounded;
  if (solid::mirrors(matrix)) {
    for (auto& face : out.mesh.faces) std::reverse(face.begin(), face.end());
  }
  return out;
}

Result<solid::CutPlane> parse_plane(const std::string& text) {
  DOBRA_TRY(const std::vector<double> numbers, numbers_of("--cut", text));
  if (numbers.size() != 4) {
    return Error{
        ErrorCode::BadUsage,
        fmt::format("--cut has {} numbers: give a,b,c,d of the plane a x + b y + c z + d = 0", numbers.size())};
  }
  const solid::CutPlane plane{numbers[0], numbers[1], numbers[2], numbers[3]};
  if (const auto frame = solid::frame_of(plane); !frame)
    return Error{ErrorCode::BadUsage, "--cut: " + frame.error().message};
  return plane;
}

}  // namespace dobra::cli
