#pragma once
// The shared corpus of contours and sections: where it is, and readers of its two formats of contours. Tests that need
// it skip where DOBRA_TEST_DATA does not name its folder (the one that holds `contours` and `sections`).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/base/text.h"
#include "shared/geom/polyline.h"

namespace dobra::test {

/// The folder that the environment variable DOBRA_TEST_DATA names; nothing where it is unset or no folder.
inline std::optional<std::filesystem::path> data_folder() {
  const char* const folder = std::getenv("DOBRA_TEST_DATA");
  std::error_code ignored;
  if (folder == nullptr || !std::filesystem::is_directory(folder, ignored)) return std::nullopt;
  return std::filesystem::path(folder);
}

/// What a test says that needs the folder and is skipped.
inline constexpr const char* no_data = "SKIPPED: DOBRA_TEST_DATA names no folder; set it to the folder of the data";

/// Points and edges (indices of points, from 0) of a contour of artem-ogre/CDT.
struct CdtFile {
  std::vector<geom::Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
};

namespace detail {

/// The words of a file as numbers, with the line of each.
struct Numbers {
  std::vector<double> values;
  std::vector<std::size_t> lines;
  std::vector<std::size_t> holes;  ///< Positions in `values` where a line "HOLE" stands.
  std::string file;

  [[nodiscard]] base::Error error(std::size_t i, std::string message) const {
    const std::size_t line = lines.empty() ? 0 : lines[i < lines.size() ? i : lines.size() - 1];
    return {base::ErrorCode::BadFormat, std::move(message), base::Place{.file = file, .line = line}};
  }
};

inline base::Result<Numbers> read_numbers(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (!stream)
    return base::Error{base::ErrorCode::FileNotFound, "cannot be opened", base::Place{.file = path.string()}};
  Numbers numbers{.values = {}, .lines = {}, .holes = {}, .file = path.string()};
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (line.starts_with("HOLE")) {
      numbers.holes.push_back(numbers.values.size());
      continue;
    }
    for (std::size_t at = line.find_first_not_of(" \t\r"); at != std::string::npos;) {
      const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
      const auto value = base::parse_number(std::string_view(line).substr(at, end - at));
      numbers.lines.push_back(number);
      if (!value) return numbers.error(numbers.lines.size() - 1, "not a number: " + line);
      numbers.values.push_back(*value);
      at = line.find_first_not_of(" \t\r", end);
    }
  }
  return numbers;
}

}  // namespace detail

/// "nPoints nEdges", then "x y" a point, then "i j" an edge. @error FileNotFound, BadFormat with the line.
inline base::Result<CdtFile> read_cdt_file(const std::filesystem::path& path) {
  DOBRA_TRY(const detail::Numbers numbers, detail::read_numbers(path));
  const std::vector<double>& values = numbers.values;
  if (!numbers.holes.empty()) return numbers.error(numbers.holes[0], "this is an outline; use read_outline");
  if (values.size() < 2 || !(values[0] >= 0.0) || !(values[1] >= 0.0)) return numbers.error(0, "two counts are due");
  if (static_cast<double>(values.size()) != 2.0 * (1.0 + values[0] + values[1])) {
    return numbers.error(values.size(), "the counts do not fit the number of values");
  }
  CdtFile file;
  const auto points = static_cast<std::size_t>(values[0]);
  for (std::size_t i = 2; i < 2 + 2 * points; i += 2) file.points.push_back({values[i], values[i + 1]});
  for (std::size_t i = 2 + 2 * points; i < values.size(); i += 2) {
    for (std::size_t k = i; k < i + 2; ++k) {
      if (!(values[k] >= 0.0 && values[k] < values[0]))
        return numbers.error(k, "an edge names a point that is not there");
    }
    file.edges.push_back({static_cast<std::size_t>(values[i]), static_cast<std::size_t>(values[i + 1])});
  }
  return file;
}

/// A closed contour and its holes as they stand in the file: their directions may be either.
struct Outline {
  geom::Polyline contour;
  std::vector<geom::Polyline> holes;
};

/// "x y" a line; a line "HOLE" starts a hole. @error FileNotFound, BadFormat, and those of geom::validate.
inline base::Result<Outline> read_outline(const std::filesystem::path& path) {
  DOBRA_TRY(detail::Numbers numbers, detail::read_numbers(path));
  Outline outline;
  std::size_t begin = 0;
  numbers.holes.push_back(numbers.values.size());
  for (const std::size_t end : numbers.holes) {
    if ((end - begin) % 2 != 0) return numbers.error(end, "a point lacks its y");
    geom::Polyline contour{.points = {}, .closed = true};
    for (std::size_t i = begin; i < end; i += 2) contour.points.push_back({numbers.values[i], numbers.values[i + 1]});
    contour = geom::without_repeated_points(std::move(contour));
    DOBRA_TRY_VOID(geom::validate(contour));
    if (begin == 0)
      outline.contour = std::move(contour);
    else
      outline.holes.push_back(std::move(contour));
    begin = end;
  }
  return outline;
}

}  // namespace dobra::test
