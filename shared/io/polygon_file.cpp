#include "shared/io/polygon_file.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "shared/io/file.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::Point3;
using mesh::PolygonMesh;

namespace {

constexpr std::size_t most_items = std::numeric_limits<std::uint32_t>::max() - 1;

/// Words i, i + 1, i + 2 of the record.
Result<Point3> point_at(const Records& records, std::size_t i) {
  Point3 point;
  DOBRA_TRY(point.x, records.number(i, "x"));
  DOBRA_TRY(point.y, records.number(i + 1, "y"));
  DOBRA_TRY(point.z, records.number(i + 2, "z"));
  return point;
}

/// "7", "7/1", "7//2" or "-1" of an f statement as an index from 0.
Result<std::uint32_t> obj_corner(const Records& records, std::size_t i, std::size_t points) {
  const std::string_view word = records.word(i).substr(0, records.word(i).find('/'));
  std::int64_t number = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
  if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size() || number == 0) {
    return records.error(i, fmt::format("{} is not the number of a point", shown(word)));
  }
  const auto count = static_cast<std::int64_t>(points);
  if (number > count || number < -count) {
    return records.error(i, fmt::format("there is no point {} ({} points so far)", number, points));
  }
  const std::int64_t index = number > 0 ? number - 1 : count + number;
  return static_cast<std::uint32_t>(index);
}

}  // namespace

Result<PolygonMesh> parse_obj(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  PolygonMesh mesh;
  Records records(text, file);
  while (records.next()) {
    if (records.word(0) == "v") {
      DOBRA_TRY(const Point3 point, point_at(records, 1));
      mesh.points.push_back(point);
    } else if (records.word(0) == "f") {
      std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
      for (std::size_t i = 1; i < records.size(); ++i) {
        DOBRA_TRY(const std::uint32_t corner, obj_corner(records, i, mesh.points.size()));
        face.push_back(corner);
      }
    }
  }
  if (mesh.faces.empty())
    return base::located(Error{ErrorCode::BadFormat, "there is no face (f) in the file"}, {.file = file});
  return mesh;
}

Result<PolygonMesh> parse_off(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  Records records(text, file);
  DOBRA_TRY_VOID(records.expect("OFF"));
  if (records.word(0) != "OFF") return records.error(0, "an .off file begins with OFF");
  std::size_t at = 1;  // The counts may stand on the first line.
  if (records.size() == 1) {
    DOBRA_TRY_VOID(records.expect("the numbers of points and faces"));
    at = 0;
  }
  DOBRA_TRY(const std::size_t points, records.count(at, "the number of points", most_items));
  DOBRA_TRY(const std::size_t faces, records.count(at + 1, "the number of faces", most_items));
  PolygonMesh mesh;
  mesh.points.reserve(plausible_count(points, text, 6));
  for (std::size_t i = 0; i < points; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("point {} of {}", i + 1, points)));
    DOBRA_TRY(const Point3 point, point_at(records, 0));
    mesh.points.push_back(point);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    DOBRA_TRY_VOID(records.expect(fmt::format("face {} of {}", f + 1, faces)));
    DOBRA_TRY(const std::size_t corners, records.count(0, "the number of corners", records.size() - 1));
    std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
    for (std::size_t i = 1; i <= corners; ++i) {
      DOBRA_TRY(const std::size_t corner, records.count(i, "the corner", most_items));
      if (corner >= mesh.points.size()) return records.error(i, fmt::format("there is no point {}", corner));
      face.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  return mesh;
}

Result<PolygonMesh> read_polygons(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending != ".obj" && ending != ".off") {
    return Error{ErrorCode::UnknownFormat, fmt::format("{}: polygon meshes are read from .obj and .off", path)};
  }
  DOBRA_TRY(const std::string text, read_text(path));
  return ending == ".obj" ? parse_obj(text, path) : parse_off(text, path);
}

}  // namespace dobra::io
