#pragma once
// Curves, cracks, points and regions drawn and edited in the window, as functions of the document.
// Page: docs/user/canvas.md

#include <span>

#include "quebra/model/model.h"
#include "shared/scenario/program.h"

namespace quebra::core {

/// What a user may draw, and how the document changes.
dobra::scenario::Drawing drawing();

/// The document whose curves, cracks, points and regions `edits` have changed. What a file holds is taken into the
/// document, which then has no file; the file stays as it is. Of a line or polygon every vertex may move, and the parts
/// of a split are curves of their own; an arc, a circle or a spline moves as a whole, or goes.
/// @param edits  in the units of the document's results; numbers that have not changed stay as they are written.
/// @error BadValue: a curve that the document does not hold, or a change that its kind does not allow, with what to do.
dobra::base::Result<dobra::scenario::Document> with_curves_edited(dobra::scenario::Document document,
                                                                  const model::Model& model,
                                                                  std::span<const dobra::scene::LineEdit> edits);

/// The document with one more outline, hole, line of the boundary, internal line, crack, point or region. A regular
/// polygon of many sides is a circle.
/// @param kind  of Drawing::Kind::table.  @error BadValue: a name that is empty or taken.
dobra::base::Result<dobra::scenario::Document> with_curve(dobra::scenario::Document document, const std::string& kind,
                                                          const std::string& name, const dobra::geom::Polyline& line);

}  // namespace quebra::core
