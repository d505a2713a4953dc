#pragma once
// What a model of QUEBRA looks like, measures and writes.

#include <array>

#include "quebra/model/model.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/vtu.h"
#include "shared/scenario/program.h"

namespace quebra::core {

/// Of outlines and of figures.
inline constexpr dobra::scene::Color ink{38, 50, 56};

/// The name of a mesh as pictures show it: "Mesh 2" and "Cycle 2", which the program gives, in the user's language.
std::string shown_name(const std::string& name);

/// The domain, or the last two meshes, or the mesher at work.
void draw(const model::Model& model, dobra::scene::Picture& picture);
void add_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);
/// What was found and mended.
void add_finding_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
/// What the step mesh has: table of quality, histograms, files of the last mesh.
void add_mesh_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
void add_mesh_outputs(const std::shared_ptr<const model::Model>& model, std::vector<dobra::scenario::Output>& outputs);

/// The domain with the names of its curves, lips, points and regions, each where it belongs.
dobra::scene::Picture names_picture(const model::Model& model);

/// The elements of an .inp file: as the problem of the model says; plane stress where there is none.
dobra::io::meshes::InpElement inp_element_of(const model::Model& model);

/// How many of the elements have which quality: bars over alpha as high as their share of all, 0 .. 1; both axes to one
/// scale.
dobra::scene::Picture histogram_picture(const model::Meshed& meshed);

/// The sizes that a mesh was to have, with the quadtree that carries them. The window and `draw` have both as hidden
/// layers "size_field" and "quadtree".  @pre meshed.sizes
dobra::scene::Picture size_field_picture(const model::Model& model, const model::Meshed& meshed);

/// The triangles that draw an element: those of its corners and, of second order, of its mid-sides too.
void add_triangles(const dobra::mesh::ElementMesh& mesh, std::size_t element,
                   std::vector<std::array<std::uint32_t, 3>>& triangles);
/// The boundary in pictures of meshes and of results, which then share one entry of the legend; points.
constexpr double boundary_width = 1.8;
/// Outlines thin out as elements get many, so that they do not hide the colours; points.
double outline_width(const dobra::mesh::ElementMesh& mesh);

}  // namespace quebra::core
