#include "shared/io/formats/mesh_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "shared/io/file.h"
#include "shared/io/formats/drawing.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::ElementId;
using mesh::ElementMesh;

Result<void> check_mesh_ending(const std::string& path, Use use) {
  if (format_of(path, use) != nullptr) return {};
  if (use == Use::WriteSpaceMesh && format_of(path, Use::WriteMesh) != nullptr) {
    return Error{ErrorCode::BadUsage, fmt::format("{}: such a file holds plane meshes; meshes of surfaces are written "
                                                  "to files that end in {}",
                                                  path, fmt::join(endings_for(use), " "))};
  }
  return Error{ErrorCode::BadUsage, fmt::format("{}: meshes are written to files that end in {}", path,
                                                fmt::join(endings_for(Use::WriteMesh), " "))};
}

namespace {

/// @param what  such as "polygon meshes"
Result<const Format*> format_for(const std::string& path, Use use, std::string_view what) {
  if (const Format* format = format_of(path, use)) return format;
  return Error{ErrorCode::UnknownFormat,
               fmt::format("{}: {} are read from {}", path, what, fmt::join(endings_for(use), " "))};
}

Result<std::string> contents_of(const std::string& path, const MeshRow& row) {
  return row.binary ? read_bytes(path) : read_text(path);
}

}  // namespace

Result<Drawing> read_drawing(const std::string& path) {
  DOBRA_TRY(const Format* const format, format_for(path, Use::ReadDrawing, "drawings"));
  return format->drawing(path);
}

Result<MeshAndFields> read_fields(const std::string& path) {
  DOBRA_TRY(const Format* const format, format_for(path, Use::ReadFields, "fields"));
  DOBRA_TRY(const std::string contents, contents_of(path, *format->mesh));
  return format->mesh->fields(contents, path);
}

Result<PolygonsAndRemarks> read_polygons_told(const std::string& path) {
  DOBRA_TRY(const Format* const format, format_for(path, Use::ReadPolygons, "polygon meshes"));
  DOBRA_TRY(const std::string contents, contents_of(path, *format->mesh));
  DOBRA_TRY(mesh::PolygonMesh mesh, format->mesh->polygons(contents, path));
  PolygonsAndRemarks all{std::move(mesh), {}};
  if (format->mesh->polygon_remarks != nullptr) all.remarks = format->mesh->polygon_remarks(contents, path);
  return all;
}

Result<mesh::PolygonMesh> read_polygons(const std::string& path) {
  DOBRA_TRY(PolygonsAndRemarks all, read_polygons_told(path));
  return std::move(all.mesh);
}

namespace {

void tell_turned(const std::string& path, MeshContents& contents) {
  const std::size_t turned = contents.elements.turned.size();
  if (turned == 0) return;
  contents.remarks.push_back(fmt::format("{}: {} of {} elements run clockwise and are turned round", path, turned,
                                         contents.mesh.element_count()));
}

}  // namespace

Result<MeshContents> read_mesh(const std::string& path) {
  DOBRA_TRY(const Format* const format, format_for(path, Use::ReadMesh, "meshes"));
  const auto read = [&]() -> Result<MeshContents> {
    if (format->mesh->read != nullptr) return format->mesh->read(path);
    DOBRA_TRY(const std::string contents, contents_of(path, *format->mesh));
    return format->mesh->parse(contents, path);
  };
  DOBRA_TRY(MeshContents contents, read());
  tell_turned(path, contents);
  return contents;
}

Result<MeshContents> read_mesh_in_space(const std::string& path) {
  DOBRA_TRY(const Format* const format, format_for(path, Use::ReadMesh, "meshes"));
  if (format->mesh->parse_in_space == nullptr) return read_mesh(path);
  DOBRA_TRY(const std::string bytes, contents_of(path, *format->mesh));
  DOBRA_TRY(MeshContents contents, format->mesh->parse_in_space(bytes, path));
  tell_turned(path, contents);
  return contents;
}

Result<void> write_mesh(const std::string& path, const ElementMesh& mesh, meshes::InpElement element,
                        meshes::Heights heights) {
  DOBRA_TRY_VOID(check_mesh_ending(path, heights.empty() ? Use::WriteMesh : Use::WriteSpaceMesh));
  const MeshRow& row = *format_of(path, Use::WriteMesh)->mesh;
  return row.write != nullptr ? row.write(path, mesh) : write_text(path, row.text(mesh, element, heights));
}

Result<void> add_note(const std::string& path, const std::string& note) {
  const Format* format = format_of(path, Use::WriteMesh);
  if (format == nullptr || format->mesh->note.empty()) return {};
  const MeshRow& row = *format->mesh;
  DOBRA_TRY(std::string text, read_text(path));
  const std::size_t at = text.find(row.note_behind);
  if (at == std::string::npos) return {};
  return write_text(path, text.insert(at + row.note_behind.size(), fmt::format(fmt::runtime(row.note), note)));
}

std::vector<std::string> losses(const std::string& path, const ElementMesh& mesh) {
  const Format* format = format_of(path, Use::WriteMesh);
  std::vector<std::string> remarks;
  if (format == nullptr) return remarks;
  const auto say = [&](const std::string& loss) { remarks.push_back(fmt::format("{}: {}", path, loss)); };
  if (format->mesh->surface) {
    const std::string ending = ending_of(path);
    if (std::any_of(mesh.types.begin(), mesh.types.end(), mesh::is_quadratic))
      say(fmt::format("a {} file holds corners only; the nodes at mid-sides are left out", ending));
    say(fmt::format("a {} file holds no names; sets and regions are left out", ending));
  }
  if (format->mesh->losses != nullptr) {
    for (const std::string& loss : format->mesh->losses(mesh)) say(loss);
  }
  return remarks;
}

std::vector<Error> inverted_elements(const MeshContents& contents) {
  const ElementMesh& mesh = contents.mesh;
  std::vector<std::uint8_t> clockwise(mesh.element_count(), 0);
  for (const ElementId element : contents.elements.turned) clockwise[element.index()] = 1;
  struct Count {
    std::size_t all = 0, clockwise = 0;
  };
  std::map<std::int32_t, Count> regions;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    Count& own = regions[mesh.regions[e]];
    ++own.all;
    own.clockwise += clockwise[e];
  }
  const Count whole{mesh.element_count(), contents.elements.turned.size()};
  std::vector<Error> errors;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const Count& own = regions[mesh.regions[e]];
    const Count& others = own.all == 1 ? whole : own;
    const bool most = 2 * others.clockwise > others.all;
    if ((clockwise[e] != 0) == most) continue;
    const auto nodes = mesh.nodes_of(ElementId(e)).first(mesh::corner_count(mesh.types[e]));
    base::Place place;
    place.item =
        fmt::format("element {} of the file", contents.elements.numbers.empty() ? e + 1 : contents.elements.numbers[e]);
    place.x = place.y = 0.0;
    for (const mesh::NodeId node : nodes) {
      *place.x += mesh.point(node).x / static_cast<double>(nodes.size());
      *place.y += mesh.point(node).y / static_cast<double>(nodes.size());
    }
    errors.push_back({ErrorCode::CannotMesh,
                      fmt::format("it is inverted: its corners run {}, those of most others {}",
                                  most ? "anticlockwise" : "clockwise", most ? "clockwise" : "anticlockwise"),
                      place});
  }
  return errors;
}

}  // namespace dobra::io::formats
