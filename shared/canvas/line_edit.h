#pragma once
// Edits of lines as pure functions: each takes a line and gives another. Page: docs/user/canvas.md.

#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::canvas {

/// Where an edit of a segment happens. @pre segment < line.segment_count()
struct OnSegment {
  std::size_t segment = 0;
  geom::Point at;
};

enum class End { First, Last };

/// With vertex `i` elsewhere. @pre i < number of points
geom::Polyline with_vertex_moved(geom::Polyline line, std::size_t i, geom::Point to);

/// With one more vertex behind the start of the segment.
geom::Polyline with_vertex(geom::Polyline line, const OnSegment& where);

/// @error DegenerateCurve where fewer than two (closed: three) vertices would be left.
base::Result<geom::Polyline> without_vertices(const geom::Polyline& line, const std::set<std::size_t>& vertices);

/// The two parts of an open line; a closed one becomes an open one that starts and ends there (second part: no points).
/// @error DegenerateCurve at an end of an open line.
base::Result<std::pair<geom::Polyline, geom::Polyline>> split_at(const geom::Polyline& line, const OnSegment& where);

/// Two open lines as one: their nearest ends meet, and a common point stands once. The first one's direction stays.
/// @error DegenerateCurve if one is closed.
base::Result<geom::Polyline> joined(const geom::Polyline& a, const geom::Polyline& b);

/// The end goes straight on to the nearest of the others.
/// @error DegenerateCurve: it meets none, or the line is closed.
base::Result<geom::Polyline> extended_to(geom::Polyline line, End end, std::span<const geom::Polyline> others);

/// The part between two meetings with the others that is pointed at goes; a line that meets them once loses the pointed
/// side. @return what is left: one part or two.
/// @error DegenerateCurve: it meets none of them, or is closed.
base::Result<std::vector<geom::Polyline>> trimmed(const geom::Polyline& line, std::span<const geom::Polyline> others,
                                                  const OnSegment& pointed);

/// Anticlockwise, sides along the axes.
geom::Polyline rectangle(geom::Point corner, geom::Point opposite);

/// A regular polygon with its first vertex given, anticlockwise. @pre sides >= 3
geom::Polyline regular_polygon(geom::Point centre, geom::Point vertex, std::size_t sides);

}  // namespace dobra::canvas
