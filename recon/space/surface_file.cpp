#include "recon/space/surface_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shared/io/file.h"
#include "shared/io/formats/format.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/tsurf.h"
#include "shared/io/meshes/vtp.h"

namespace recon::space {

namespace io = dobra::io;
namespace loft = dobra::surf::loft;
namespace mesh = dobra::mesh;
using base::Result;
using io::formats::Use;

namespace {

constexpr const char* polygons_of_vtk = ".vtp";

/// One surface with its patches one after another.
mesh::PolygonMesh mesh_of(const loft::NamedSurface& surface) {
  mesh::PolygonMesh made;
  for (const loft::Patch& patch : surface.patches) {
    const auto first = static_cast<std::uint32_t>(made.points.size());
    made.points.insert(made.points.end(), patch.points.begin(), patch.points.end());
    for (const auto& t : patch.triangles) made.faces.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return made;
}

struct AllFaces {
  mesh::PolygonMesh mesh;
  io::meshes::MeshFields fields;  ///< At faces: the number of the surface, dip and azimuth.
};

AllFaces all_faces(const MadeSurfaces& surfaces) {
  AllFaces all;
  io::meshes::MeshField number{"surface", 1, {}}, dip{"dip", 1, {}}, azimuth{"azimuth", 1, {}};
  double which = 0.0;
  for (const loft::NamedSurface& surface : surfaces.made.surfaces) {
    const auto first = static_cast<std::uint32_t>(all.mesh.points.size());
    mesh::PolygonMesh one = mesh_of(surface);
    all.mesh.points.insert(all.mesh.points.end(), one.points.begin(), one.points.end());
    for (auto& face : one.faces) {
      for (std::uint32_t& corner : face) corner += first;
      all.mesh.faces.push_back(std::move(face));
      number.values.push_back(which);
    }
    for (const loft::Patch& patch : surface.patches) {
      for (const loft::Dip& at : loft::dips(patch)) {
        dip.values.push_back(at.dip.degrees());
        azimuth.values.push_back(at.azimuth.degrees());
      }
    }
    which += 1.0;
  }
  all.fields.at_elements = {std::move(number), std::move(dip), std::move(azimuth)};
  return all;
}

Result<void> write_elements(const std::string& path, const AllFaces& all) {
  mesh::TriangleMesh plane;
  std::vector<double> heights;
  for (const geom::Point3 p : all.mesh.points) {
    plane.points.push_back({p.x, p.y});
    heights.push_back(p.z);
  }
  for (const auto& f : all.mesh.faces)
    plane.triangles.push_back({mesh::NodeId(f[0]), mesh::NodeId(f[1]), mesh::NodeId(f[2])});
  plane.regions.assign(plane.triangles.size(), 0);
  const mesh::ElementMesh elements = mesh::element_mesh_of(plane);
  if (io::formats::format_of(path, Use::ReadFields) != nullptr)
    return io::meshes::write_vtu(path, elements, all.fields, io::meshes::VtuEncoding::Ascii, heights);
  return io::formats::write_mesh(path, elements, io::meshes::InpElement::Shell, heights);
}

bool holds_names(const std::string& path) {
  const io::formats::Format* format = io::formats::format_of(path, Use::WriteSpaceMesh);
  return format != nullptr && format->name == "tsurf";
}

}  // namespace

std::vector<std::string> surface_endings() {
  std::vector<std::string> endings = io::formats::endings_for(Use::WriteSpaceMesh);
  endings.emplace_back(polygons_of_vtk);
  return endings;
}

Result<void> check_surface_ending(const std::string& path) {
  if (io::formats::format_of(path, Use::WriteSpaceMesh) != nullptr || io::ending_of(path) == polygons_of_vtk) return {};
  return base::Error{base::ErrorCode::BadUsage,
                     fmt::format("{}: surfaces are written to {}", path, fmt::join(surface_endings(), " "))};
}

Result<void> write_surfaces(const std::string& path, const MadeSurfaces& surfaces) {
  DOBRA_TRY_VOID(check_surface_ending(path));
  if (holds_names(path)) {
    std::vector<io::meshes::TSurf> named;
    for (const loft::NamedSurface& surface : surfaces.made.surfaces)
      named.push_back({surface.name, loft::kind_name(surface.kind), mesh_of(surface)});
    return io::write_text(path, io::meshes::tsurfs_text(named));
  }
  const AllFaces all = all_faces(surfaces);
  if (io::ending_of(path) != polygons_of_vtk) return write_elements(path, all);
  DOBRA_TRY(const std::string text, io::meshes::vtp_text(all.mesh, all.fields));
  return io::write_text(path, text);
}

}  // namespace recon::space
