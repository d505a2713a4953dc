#pragma once
// The operations `surface` and `cut`, and what sections in space, surfaces through them and cuts look like. Page:
// docs/user/space.md.

#include "recon/model/model.h"
#include "recon/space/cut.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Surfaces through the sections of the document. @error CannotRestore: it has one section, not several in space; those
/// of make_surfaces()
base::Result<model::Model> run_surface(const model::Model& model, const space::SurfaceParams& params,
                                       const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: surfaces; surface.NAME.area, .dip_mean, .pieces, .greatest_mistie; between.UPPER.LOWER.volume. Tables
/// surfaces, misties and volumes; the file surfaces.ts, and contours.geojson where they are asked for.
dobra::scenario::Operation surface_step();

/// A new section from the surfaces; the steps behind work on it. @error CannotRestore: no step surface before it; those
/// of cut_section()
base::Result<model::Model> run_cut(const model::Model& model, const space::CutParams& params,
                                   const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: cut.length, cut.horizons. The file section.toml is a document of the new section.
dobra::scenario::Operation cut_step();

/// The document that holds the new section.
dobra::scenario::Document document_of(const space::CutSection& cut, const std::string& title);

/// In the plane: a panel for each section of the document, from the first.
void draw_placed(const model::Model& model, dobra::scene::Picture& picture);

/// In space: the sections as curtains on their traces, the surfaces, and the section cut from them, restored too
/// (hidden at first).
void draw_placed_in_space(const model::Model& model, dobra::scene::space::SpacePicture& picture);

}  // namespace recon::core
