#pragma once
// What is chosen and dragged on surfaces in the window, as functions of the document. Page: docs/user/space_view.md.

#include <span>
#include <string>

#include "quebra/model/surface_meshed.h"
#include "shared/scenario/document.h"

namespace quebra::core {

struct PartEdit {
  dobra::scenario::Document document;
  bool taken_in = false;  ///< Else it was taken out.
};

/// The document that takes the part of a face round a place of its chart out of what is meshed, or into it: an
/// [[input.part]] more, or those that say otherwise less. The place is written in few digits that lie in the part.
/// @pre face < set.faces.size()
/// @error NotSupported: the face comes from a file; BadDomain: on a line, in a hole, beside the surface, or the only
///        part that is left.
dobra::base::Result<PartEdit> with_part_turned(dobra::scenario::Document document, const model::SurfaceSet& set,
                                               std::size_t face, dobra::geom::Point uv);

/// A point of a line that is drawn in a chart; one that was drawn to something else is written with all its digits.
struct ChartPoint {
  dobra::geom::Point uv;
  bool exact = false;
};
/// The document with one more [[input.trim]] of role "crack" along a line of a face. What lies beyond a side of the
/// chart is put onto that.
/// @pre face < set.faces.size(), two points or more
/// @error NotSupported: the face comes from a file.
dobra::base::Result<dobra::scenario::Document> with_crack_on(dobra::scenario::Document document,
                                                             const model::SurfaceSet& set, std::size_t face,
                                                             const std::string& name, std::span<const ChartPoint> line);

/// The document with a control point, and all others that stand at the very same place, somewhere else: borders that
/// share a corner keep it.
/// @param to  in the units of the document's results. @pre control < set.controls.size()
/// @error BadValue: the document has no such point any more.
dobra::base::Result<dobra::scenario::Document> with_control_moved(dobra::scenario::Document document,
                                                                  const model::SurfaceSet& set, std::size_t control,
                                                                  dobra::geom::Point3 to);

}  // namespace quebra::core
