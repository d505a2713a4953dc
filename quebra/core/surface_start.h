#pragma once
// A first document for a boundary model that is opened on its own.

#include <filesystem>

#include "shared/scenario/document.h"
#include "shared/scenario/field.h"

namespace quebra::core {

/// What an ASCII .brep is called in dialogs.
dobra::scenario::FileKind brep_files();

/// Most that sides turn in degrees where nothing is asked: spheres and their borders keep 99 % of their area.
inline constexpr double usual_turn_of_brep = 10.0;

/// A document that reads the file and meshes its faces: sides of about a thirtieth of the diagonal of their borders,
/// turning by usual_turn_of_brep at most.
/// @error those of reading the file: it is no boundary model in text, or none of its faces can be meshed
dobra::base::Result<dobra::scenario::Document> document_of_brep(const std::filesystem::path& file);

}  // namespace quebra::core
