#include "shared/cli/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shared/base/text.h"
#include "shared/io/formats/line_files.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;
using base::Result;
using solid::Matrix;

namespace {

Result<std::vector<double>> numbers_in(const char* option, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : io::formats::words_between_commas(text)) {
    const auto value = base::parse_number(base::trimmed(word));
    if (!value || !std::isfinite(*value))
      return Error{ErrorCode::BadUsage, fmt::format("{}: '{}' is not a finite number", option, base::trimmed(word))};
    numbers.push_back(*value);
  }
  return numbers;
}

}  // namespace

Result<Matrix> parse_matrix(const std::string& text) {
  Matrix matrix{};
  DOBRA_TRY(const std::vector<double> numbers, numbers_in("--place", text));
  if (numbers.size() != matrix.size()) {
    return Error{ErrorCode::BadUsage,
                 fmt::format("--place: give the 16 numbers of a matrix, row by row, with commas between them, not {}",
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
  DOBRA_TRY(const std::vector<double> numbers, numbers_in("--cut", text));
  if (numbers.size() != 4) {
    return Error{
        ErrorCode::BadUsage,
        fmt::format("--cut: give the 4 numbers a,b,c,d of the plane a x + b y + c z + d = 0, not {}", numbers.size())};
  }
  const solid::CutPlane plane{numbers[0], numbers[1], numbers[2], numbers[3]};
  if (const auto frame = solid::frame_of(plane); !frame)
    return Error{ErrorCode::BadUsage, "--cut: " + frame.error().message};
  return plane;
}

}  // namespace dobra::cli
