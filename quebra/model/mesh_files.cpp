#include "quebra/model/mesh_files.h"

#include "shared/io/file.h"

namespace quebra::model {

using namespace dobra;

mesh::ElementMesh in_units(mesh::ElementMesh mesh, const scenario::UnitSystem& units) {
  if (units.si()) return mesh;
  for (geom::Point& p : mesh.points) p = {units.from_si(p.x, "m"), units.from_si(p.y, "m")};
  return mesh;
}

std::string note_of(const scenario::UnitSystem& units) { return "units: " + units.text(); }

base::Result<void> write_mesh(const std::string& path, const mesh::ElementMesh& mesh, io::meshes::InpElement element,
                              const scenario::UnitSystem& units) {
  DOBRA_TRY_VOID(io::formats::write_mesh(path, in_units(mesh, units), element));
  return io::formats::add_note(path, note_of(units));
}

surf::mesh::SurfaceElements in_units(surf::mesh::SurfaceElements elements, const scenario::UnitSystem& units) {
  elements.mesh = in_units(std::move(elements.mesh), units);
  if (!units.si()) {
    for (double& height : elements.heights) height = units.from_si(height, "m");
  }
  return elements;
}

base::Result<void> write_mesh(const std::string& path, const surf::mesh::SurfaceElements& elements,
                              const scenario::UnitSystem& units) {
  const surf::mesh::SurfaceElements written = in_units(elements, units);
  DOBRA_TRY_VOID(io::formats::write_mesh(path, written.mesh, io::meshes::InpElement::Shell, written.heights));
  return io::formats::add_note(path, note_of(units));
}

base::Result<void> write_vtu(const std::string& path, const surf::mesh::SurfaceElements& elements,
                             const io::meshes::MeshFields& fields, const scenario::UnitSystem& units) {
  const surf::mesh::SurfaceElements written = in_units(elements, units);
  DOBRA_TRY_VOID(io::meshes::write_vtu(path, written.mesh, fields, io::meshes::VtuEncoding::Ascii, written.heights));
  return io::formats::add_note(path, note_of(units));
}

base::Result<void> write_vtu(const std::string& path, const mesh::ElementMesh& mesh,
                             const io::meshes::MeshFields& fields, const scenario::UnitSystem& units) {
  DOBRA_TRY_VOID(io::meshes::write_vtu(path, in_units(mesh, units), fields));
  return io::formats::add_note(path, note_of(units));
}

}  // namespace quebra::model
