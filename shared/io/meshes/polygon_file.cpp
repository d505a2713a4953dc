#include "shared/io/meshes/polygon_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "shared/base/text.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using mesh::PolygonMesh;

namespace {

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

/// @error BadFormat: a record follows the last one that the header counts
Result<void> expect_end(Records& records, std::size_t points, std::size_t faces) {
  if (!records.next()) return {};
  return records.error(0, fmt::format("the header counts {} points and {} faces, and here is one more record: mend the "
                                      "counts, or take it out",
                                      points, faces));
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
    DOBRA_TRY(const std::size_t corners, records.count(0, "the number of corners", most_items));
    if (corners > records.size() - 1) {
      return records.error(records.size(),
                           fmt::format("face {} of {} has {} corners, and the line ends after {} of them; "
                                       "the file may have been cut short",
                                       f + 1, faces, corners, records.size() - 1));
    }
    std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
    for (std::size_t i = 1; i <= corners; ++i) {
      DOBRA_TRY(const std::size_t corner, records.count(i, "the corner", most_items));
      if (corner >= mesh.points.size()) return records.error(i, fmt::format("there is no point {}", corner));
      face.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  DOBRA_TRY_VOID(expect_end(records, points, faces));
  return mesh;
}

std::string polygons_text(const PolygonMesh& mesh, PolygonFormat format, std::span<const std::string> groups) {
  const bool obj = format == PolygonFormat::Obj;
  std::string text;
  if (format == PolygonFormat::Off) text = fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.faces.size());
  if (format == PolygonFormat::Ply) {
    text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.points.size(), mesh.faces.size());
  }
  for (const Point3& p : mesh.points) {
    text += fmt::format("{}{} {} {}\n", obj ? "v " : "", base::number_text(p.x), base::number_text(p.y),
                        base::number_text(p.z));
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    if (obj && !groups.empty() && (f == 0 || groups[f] != groups[f - 1])) text += fmt::format("g {}\n", groups[f]);
    text += obj ? std::string("f") : fmt::format("{}", face.size());
    for (const std::uint32_t corner : face) text += fmt::format(" {}", corner + (obj ? 1 : 0));
    text += '\n';
  }
  return text;
}

}  // namespace dobra::io::meshes
