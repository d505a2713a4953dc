#include "shared/io/formats/boundary_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>

#include "shared/io/file.h"
#include "shared/io/formats/format.h"
#include "shared/io/meshes/ply.h"
#include "shared/io/meshes/polygon_file.h"
#include "shared/io/meshes/stl.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

struct Row {
  std::string_view format;   ///< Its name in the table of formats.
  bool binary;               ///< May be no text.
  std::size_t most_corners;  ///< Of a face.
  Result<mesh::PolygonMesh> (*parse)(std::string_view bytes, const std::string& file);
  std::string (*text)(const mesh::PolygonMesh& mesh, std::span<const std::string> groups);
};

template <meshes::PolygonFormat format>
std::string text_as(const mesh::PolygonMesh& mesh, std::span<const std::string> groups) {
  return meshes::polygons_text(mesh, format, groups);
}

constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
constexpr std::size_t in_a_byte = 255;  // The count of corners is one in a PLY that we write.

constexpr std::array rows{
    Row{"obj", false, any, meshes::parse_obj, text_as<meshes::PolygonFormat::Obj>},
    Row{"ply", true, in_a_byte, meshes::parse_ply, text_as<meshes::PolygonFormat::Ply>},
    Row{"off", false, any, meshes::parse_off, text_as<meshes::PolygonFormat::Off>},
    Row{"stl", true, 3, meshes::parse_stl_facets,
        [](const mesh::PolygonMesh& mesh, std::span<const std::string>) { return meshes::stl_text(mesh); }},
};

const Row* row_of(const std::string& path) {
  const Format* const format = format_of(path, Use::ReadMesh);
  if (format == nullptr) return nullptr;
  for (const Row& row : rows) {
    if (row.format == format->name) return &row;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> boundary_endings() {
  std::vector<std::string> endings;
  for (const Row& row : rows) {
    const Format* const format = format_named(row.format, Use::ReadMesh);
    endings.insert(endings.end(), format->endings.begin(), format->endings.end());
  }
  return endings;
}

std::size_t most_corners(const std::string& path) {
  const Row* const row = row_of(path);
  return row == nullptr ? any : row->most_corners;
}

Result<mesh::PolygonMesh> read_boundary(const std::string& path) {
  const Row* const row = row_of(path);
  if (row == nullptr) {
    return Error{ErrorCode::UnknownFormat,
                 fmt::format("{}: boundaries of solids are read from {}", path, fmt::join(boundary_endings(), " "))};
  }
  DOBRA_TRY(const std::string bytes, row->binary ? read_bytes(path) : read_text(path));
  DOBRA_TRY(mesh::PolygonMesh mesh, row->parse(bytes, path));
  if (mesh.faces.empty()) {
    return Error{ErrorCode::BadFormat, "holds no face: give the boundary of a solid", base::Place{.file = path}};
  }
  return mesh;
}

Result<void> check_boundary_ending(const std::string& path) {
  if (row_of(path) != nullptr) return {};
  return Error{ErrorCode::BadUsage, fmt::format("{}: boundaries of solids are written to files that end in {}", path,
                                                fmt::join(boundary_endings(), " "))};
}

Result<void> write_boundary(const std::string& path, const mesh::PolygonMesh& mesh,
                            std::span<const std::string> groups) {
  DOBRA_TRY_VOID(check_boundary_ending(path));
  return write_text(path, row_of(path)->text(mesh, groups));
}

}  // namespace dobra::io::formats
