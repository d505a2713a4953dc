#pragma once
// The operation `cut`.

#include "recon/model/model.h"
#include "recon/space/cut.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// A new section from the surfaces; the steps behind work on it. @error CannotRestore: no step surface before it; those
/// of cut_section()
base::Result<model::Model> run_cut(const model::Model& model, const space::CutParams& params,
                                   const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: cut.length, cut.horizons. The file section.toml is a document of the new section.
dobra::scenario::Operation cut_step();

/// The document that holds the new section.
dobra::scenario::Document document_of(const space::CutSection& cut, const std::string& title);

}  // namespace recon::core
