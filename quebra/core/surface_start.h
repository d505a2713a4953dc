#pragma once
// A first document for a boundary model that is opened on its own.

#include <filesystem>
#include <span>

#include "shared/scenario/document.h"
#include "shared/scenario/field.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::core {

/// What an ASCII .brep is called in dialogs.
dobra::scenario::FileKind brep_files();

/// Most that sides turn in degrees where nothing is asked: 10, by which spheres and their borders keep 99 % of their
/// area; 20 or 40 where it would make a face of some hundred thousand triangles.
/// @param size  of sides, m; 0 where each face has its own
double usual_turn(std::span<const dobra::surf::trim::TrimmedSurface> faces, double size);

/// A document that reads the file and meshes its faces: sides of about a thirtieth of the diagonal of their borders,
/// turning by usual_turn at most.
/// @error those of reading the file: it is no boundary model in text, or none of its faces can be meshed
dobra::base::Result<dobra::scenario::Document> document_of_brep(const std::filesystem::path& file);

}  // namespace quebra::core
