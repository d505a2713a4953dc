#include "shared/io/meshes/vtp.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/base/text.h"

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

}  // namespace

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
