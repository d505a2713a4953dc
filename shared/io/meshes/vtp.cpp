#include "shared/io/meshes/vtp.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "shared/base/text.h"
#include "shared/io/meshes/vtk_arrays.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

/// @error as vtp_text
Result<void> add_fields(const std::vector<MeshField>& fields, std::size_t items, std::string& text) {
  for (const MeshField& field : fields) {
    if (field.components == 0 || field.values.size() != items * field.components)
      return Error{ErrorCode::InvalidOption, fmt::format("field '{}' has {} values where {} x {} are due", field.name,
                                                         field.values.size(), items, field.components)};
    text += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                        field.name, field.components);
    for (const double value : field.values) {
      if (!std::isfinite(value))
        return Error{ErrorCode::NotFinite, fmt::format("field '{}' has a value that is not finite", field.name)};
      text += base::number_text(value) + '\n';
    }
    text += "</DataArray>\n";
  }
  return {};
}

/// A whole number below `limit`.
std::optional<std::size_t> index(double value, std::size_t limit) {
  if (!(value >= 0.0) || value >= static_cast<double>(limit) || value != std::floor(value)) return std::nullopt;
  return static_cast<std::size_t>(value);
}

/// What the piece states of them, where that is another number than it holds.
std::optional<std::string> other_count(const VtkArrays& arrays, const char* attribute, std::size_t held) {
  const std::string stated = arrays.piece().attribute(attribute).value();
  const std::optional<double> count = base::parse_number(stated);
  if (stated.empty() || (count && *count == static_cast<double>(held))) return std::nullopt;
  return count ? stated : shown(stated);
}

Result<void> read_points(VtkArrays& arrays, mesh::PolygonMesh& mesh) {
  DOBRA_TRY(const VtkArray array, arrays.take("Points", ""));
  const std::vector<double>& values = array.field.values;
  if (array.field.components != 3 || values.size() % 3 != 0)
    return arrays.error(array.node, "points need three coordinates each");
  if (values.size() / 3 >= std::numeric_limits<std::uint32_t>::max())
    return arrays.error(array.node, "there are too many points");
  for (std::size_t i = 0; i < values.size(); i += 3) mesh.points.push_back({values[i], values[i + 1], values[i + 2]});
  if (const auto stated = other_count(arrays, "NumberOfPoints", mesh.points.size())) {
    return arrays.error(arrays.piece(),
                        fmt::format("the piece says {} points and holds {}", *stated, mesh.points.size()));
  }
  return {};
}

Result<void> read_faces(VtkArrays& arrays, mesh::PolygonMesh& mesh) {
  DOBRA_TRY(const VtkArray corners, arrays.take("Polys", "connectivity"));
  DOBRA_TRY(const VtkArray offsets, arrays.take("Polys", "offsets"));
  const std::vector<double>& values = corners.field.values;
  std::size_t at = 0;
  for (std::size_t f = 0; f < offsets.field.values.size(); ++f) {
    const auto end = index(offsets.field.values[f], values.size() + 1);
    if (!end || *end < at)
      return arrays.error(offsets.node, fmt::format("the offset of polygon {} does not fit the corners", f));
    std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
    for (; at < *end; ++at) {
      const auto corner = index(values[at], mesh.points.size());
      if (!corner) return arrays.error(corners.node, fmt::format("polygon {}: there is no point {}", f, values[at]));
      face.push_back(static_cast<std::uint32_t>(*corner));
    }
  }
  if (at != values.size()) return arrays.error(corners.node, "corners follow the last polygon");
  if (mesh.faces.empty()) return arrays.error(offsets.node, "the file holds no polygons");
  if (const auto stated = other_count(arrays, "NumberOfPolys", mesh.faces.size())) {
    return arrays.error(arrays.piece(),
                        fmt::format("the piece says {} polygons and holds {}", *stated, mesh.faces.size()));
  }
  return {};
}

}  // namespace

Result<mesh::PolygonMesh> parse_vtp(std::string_view text, const std::string& file) {
  DOBRA_TRY(VtkArrays arrays, VtkArrays::read(text, file, ".vtp", "PolyData", {"Points", "Strips", "Polys"}));
  mesh::PolygonMesh mesh;
  DOBRA_TRY_VOID(read_points(arrays, mesh));
  for (const VtkArray& strips : arrays.of("Strips")) {
    if (!strips.field.values.empty())
      return arrays.error(strips.node, "strips of triangles are not read; save them as triangles",
                          ErrorCode::UnknownFormat);
  }
  DOBRA_TRY_VOID(read_faces(arrays, mesh));
  return mesh;
}

Result<std::string> vtp_text(const mesh::PolygonMesh& mesh, const MeshFields& fields) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<PointData>\n",
      mesh.points.size(), mesh.faces.size());
  DOBRA_TRY_VOID(add_fields(fields.at_points, mesh.points.size(), text));
  text += "</PointData>\n<CellData>\n";
  DOBRA_TRY_VOID(add_fields(fields.at_elements, mesh.faces.size(), text));
  text +=
      "</CellData>\n<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const geom::Point3 p = mesh.points[i];
    if (!geom::is_finite(p))
      return Error{ErrorCode::NotFinite, fmt::format("point {} is not finite and cannot be written", i + 1)};
    text += fmt::format("{} {} {}\n", base::number_text(p.x), base::number_text(p.y), base::number_text(p.z));
  }
  text += "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::string offsets;
  std::size_t end = 0;
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t c : face) text += fmt::format("{} ", c);
    text += '\n';
    end += face.size();
    offsets += fmt::format("{}\n", end);
  }
  text += "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" + offsets;
  return text + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace dobra::io::meshes
