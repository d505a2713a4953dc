#pragma once
// What surfaces and their meshes look like, measure and write.

#include "quebra/model/model.h"
#include "shared/scenario/program.h"
#include "shared/scene/space/picture.h"

namespace quebra::core {

/// @pre model.surfaces, here and below
void draw_surfaces(const model::Model& model, dobra::scene::Picture& picture);
/// The panel of one chart, m. @pre face < number of faces. @cost O(triangles of all faces)
dobra::scene::Panel chart_of(const model::Model& model, std::size_t face);
/// The mesh with its quality, borders, lines inside and cracks in space; before any mesh the borders alone.
void draw_surfaces_in_space(const model::Model& model, dobra::scene::space::SpacePicture& picture);
/// Counts, area, quality: of the last mesh by their plain names, of each as "mesh.1.elements".
void add_surface_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);
/// What was found and mended: of the surfaces, and of the last mesh.
void add_surface_finding_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
void add_surface_mesh_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
void add_surface_mesh_outputs(const std::shared_ptr<const model::Model>& model,
                              std::vector<dobra::scenario::Output>& outputs);

/// All findings of a model, those of its last mesh last; u and v as the user writes them.
std::vector<dobra::surf::mesh::Finding> findings_of(const model::Model& model);

}  // namespace quebra::core
