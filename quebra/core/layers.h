#pragma once
// What a model of QUEBRA looks like, measures and writes.

#include <array>

#include "quebra/core/model.h"
#include "shared/scenario/program.h"

namespace quebra::core {

dobra::scene::Picture picture_of(const Model& model);
std::vector<dobra::scenario::Quantity> quantities_of(const Model& model);
std::vector<dobra::scenario::DataTable> tables_of(const Model& model);
std::vector<dobra::scenario::Output> outputs_of(const std::shared_ptr<const Model>& model);

/// The triangles that draw an element: those of its corners and, of second order, of its mid-sides too.
void add_triangles(const dobra::mesh::ElementMesh& mesh, std::size_t element, std::vector<std::array<std::uint32_t, 3>>& triangles);
/// Outlines thin out as elements get many, so that they do not hide the colours; points.
double outline_width(const dobra::mesh::ElementMesh& mesh);

}  // namespace quebra::core
