#pragma once
// Meshes in files, in the units that the user asked for.

#include <string>

#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/vtu.h"
#include "shared/scenario/units.h"
#include "shared/surf/mesh/surface_elements.h"

namespace quebra::model {

/// A mesh as a file in these units holds it, and the line that says so.
dobra::mesh::ElementMesh in_units(dobra::mesh::ElementMesh mesh, const dobra::scenario::UnitSystem& units);
std::string note_of(const dobra::scenario::UnitSystem& units);
/// io::formats::write_mesh and io::meshes::write_vtu of a mesh in SI, in these units and with that line.
dobra::base::Result<void> write_mesh(const std::string& path, const dobra::mesh::ElementMesh& mesh,
                                     dobra::io::meshes::InpElement element, const dobra::scenario::UnitSystem& units);
/// Of surfaces, as shells.
dobra::base::Result<void> write_mesh(const std::string& path, const dobra::surf::mesh::SurfaceElements& elements,
                                     const dobra::scenario::UnitSystem& units);
dobra::base::Result<void> write_vtu(const std::string& path, const dobra::surf::mesh::SurfaceElements& elements,
                                    const dobra::io::meshes::MeshFields& fields,
                                    const dobra::scenario::UnitSystem& units);
dobra::surf::mesh::SurfaceElements in_units(dobra::surf::mesh::SurfaceElements elements,
                                            const dobra::scenario::UnitSystem& units);
dobra::base::Result<void> write_vtu(const std::string& path, const dobra::mesh::ElementMesh& mesh,
                                    const dobra::io::meshes::MeshFields& fields,
                                    const dobra::scenario::UnitSystem& units);

}  // namespace quebra::model
