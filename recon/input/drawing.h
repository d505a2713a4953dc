#pragma once
// Lines drawn and edited in the window, as functions of the document: what came from a file is taken into the document.
// Page: docs/user/canvas.md.

#include <span>

#include "recon/section/section.h"
#include "shared/scenario/document.h"
#include "shared/scene/pick.h"

namespace recon::input {

/// The document whose lines `edits` have changed. A line from a file becomes points of the document; the file stays as
/// it is. Of a horizon or a fault that is split, the parts are its pieces.
/// @param section  what the input of the document makes.
/// @error BadValue: a line that the reading has made or changed (cut at the topography, say), with what to do;
///        BadSection and those of reading for a file of many lines that is taken into the document.
base::Result<dobra::scenario::Document> with_lines_edited(dobra::scenario::Document document,
                                                          const section::Section& section,
                                                          std::span<const dobra::scene::LineEdit> edits);

/// The document with one more [[input.TABLE]].
/// @error BadValue: a name that is empty or taken.
base::Result<dobra::scenario::Document> with_line(dobra::scenario::Document document, const std::string& table,
                                                  const std::string& name, const geom::Polyline& line);

/// Metres in one unit of the points of the document.
double unit_length(const dobra::scenario::Document& document);

}  // namespace recon::input
