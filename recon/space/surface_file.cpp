#include "recon/space/surface_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "shared/io/file.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/io/formats/format.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/tsurf.h"
#include "shared/io/meshes/vtp.h"
#include "shared/surf/loft/joined.h"

namespace recon::space {

namespace io = dobra::io;
namespace loft = dobra::surf::loft;
namespace mesh = dobra::mesh;
using base::Result;
using io::formats::Use;

namespace {

mesh::PolygonMesh polygons_of(const loft::JoinedMesh& joined) {
  mesh::PolygonMesh made{joined.points, {}};
  for (const auto& t : joined.triangles) made.faces.push_back({t[0], t[1], t[2]});
  return made;
}

/// Of the regions and groups of a file: those of a horizon and a fault of one name differ by the kind.
std::vector<std::string> names_of(const std::vector<loft::NamedSurface>& surfaces) {
  std::vector<std::string> names;
  for (const loft::NamedSurface& surface : surfaces) {
    const bool twice = std::count_if(surfaces.begin(), surfaces.end(),
                                     [&](const loft::NamedSurface& other) { return other.name == surface.name; }) > 1;
    names.push_back(twice ? fmt::format("{} ({})", surface.name, loft::kind_name(surface.kind)) : surface.name);
  }
  return names;
}

struct AllFaces {
  mesh::PolygonMesh mesh;
  std::vector<std::size_t> surface;  ///< Of each face.
  std::vector<std::string> names;    ///< Of each surface.
  io::meshes::MeshFields fields;     ///< At faces: the number of the surface, dip and azimuth.
};

AllFaces all_faces(const MadeSurfaces& surfaces) {
  AllFaces all;
  all.names = names_of(surfaces.made.surfaces);
  io::meshes::MeshField number{"surface", 1, {}}, dip{"dip", 1, {}}, azimuth{"azimuth", 1, {}};
  for (std::size_t which = 0; which < surfaces.made.surfaces.size(); ++which) {
    const loft::JoinedMesh joined = loft::joined(surfaces.made.surfaces[which], surfaces.made.size);
    const auto first = static_cast<std::uint32_t>(all.mesh.points.size());
    all.mesh.points.insert(all.mesh.points.end(), joined.points.begin(), joined.points.end());
    for (const auto& t : joined.triangles) {
      all.mesh.faces.push_back({t[0] + first, t[1] + first, t[2] + first});
      all.surface.push_back(which);
      number.values.push_back(static_cast<double>(which));
    }
    for (const loft::Dip& at : loft::dips(joined.points, joined.triangles)) {
      dip.values.push_back(at.dip.degrees());
      azimuth.values.push_back(at.azimuth.degrees());
    }
  }
  all.fields.at_elements = {std::move(number), std::move(dip), std::move(azimuth)};
  return all;
}

/// A region for each surface, from 1 on.
Result<void> write_elements(const std::string& path, const AllFaces& all) {
  mesh::ElementMesh elements;
  std::vector<double> heights;
  for (const geom::Point3 p : all.mesh.points) {
    elements.points.push_back({p.x, p.y});
    heights.push_back(p.z);
  }
  elements.first = {0};
  const auto tag = [](std::size_t surface) { return static_cast<std::int32_t>(surface + 1); };
  for (std::size_t f = 0; f < all.mesh.faces.size(); ++f) {
    const auto& face = all.mesh.faces[f];
    const std::array nodes{mesh::NodeId(face[0]), mesh::NodeId(face[1]), mesh::NodeId(face[2])};
    mesh::add_element(elements, mesh::ElementType::T3, nodes, tag(all.surface[f]));
  }
  for (std::size_t k = 0; k < all.names.size(); ++k) elements.region_names[tag(k)] = all.names[k];
  if (io::formats::format_of(path, Use::ReadFields) != nullptr)
    return io::meshes::write_vtu(path, elements, all.fields, io::meshes::VtuEncoding::Ascii, heights);
  return io::formats::write_mesh(path, elements, io::meshes::InpElement::Shell, heights);
}

/// The group of each face; blanks would part their names.
std::vector<std::string> groups_of(const AllFaces& all) {
  std::vector<std::string> groups;
  for (const std::size_t surface : all.surface) {
    std::string name = all.names[surface];
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) != 0; }, '_');
    groups.push_back(std::move(name));
  }
  return groups;
}

bool is_format(const std::string& path, std::string_view name) {
  const io::formats::Format* format = io::formats::format_of(path, Use::WriteSpaceMesh);
  return format != nullptr && format->name == name;
}

}  // namespace

std::vector<std::string> surface_endings() { return io::formats::endings_for(Use::WriteSpaceMesh); }

Result<void> check_surface_ending(const std::string& path) {
  if (io::formats::format_of(path, Use::WriteSpaceMesh) != nullptr) return {};
  return base::Error{base::ErrorCode::BadUsage,
                     fmt::format("{}: surfaces are written to {}", path, fmt::join(surface_endings(), " "))};
}

Result<void> write_surfaces(const std::string& path, const MadeSurfaces& surfaces) {
  DOBRA_TRY_VOID(check_surface_ending(path));
  if (is_format(path, "tsurf")) {
    std::vector<io::meshes::TSurf> named;
    for (const loft::NamedSurface& surface : surfaces.made.surfaces)
      named.push_back(
          {surface.name, loft::kind_name(surface.kind), polygons_of(loft::joined(surface, surfaces.made.size))});
    return io::write_text(path, io::meshes::tsurfs_text(named));
  }
  const AllFaces all = all_faces(surfaces);
  if (is_format(path, "obj")) return io::formats::write_boundary(path, all.mesh, groups_of(all));
  if (!is_format(path, "vtp")) return write_elements(path, all);
  DOBRA_TRY(const std::string text, io::meshes::vtp_text(all.mesh, all.fields));
  return io::write_text(path, text);
}

}  // namespace recon::space
