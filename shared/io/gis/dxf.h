#pragma once
// Lines and polylines of DXF drawings (R12 and later, text form): LINE, POLYLINE, LWPOLYLINE, and ARC, CIRCLE, ELLIPSE,
// SPLINE and bulges as chords. An own pass over the group codes finds what is broken, with its line; GDAL/OGR then
// reads the entities, those of inserted blocks included. Source: [gdal].

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::gis {

/// Codes of $INSUNITS that are known here, and metres in one of each.
inline constexpr std::array<std::pair<int, double>, 9> dxf_units{
    {{6, 1.0}, {1, 0.0254}, {2, 0.3048}, {4, 0.001}, {5, 0.01}, {7, 1000.0}, {10, 0.9144}, {14, 0.1}, {3, 1609.344}}};

/// How the remark ends that tells of entities which are not held as they were drawn.
inline constexpr std::string_view read_as_chords = "arcs or splines read as chords";

/// The lines of a drawing, one feature an entity, in drawing units (taken as metres), x right and y up.
/// A layer is the name, and the property "layer": the first entity of layer "TOP" is "TOP", the next "TOP 2"; layer
/// "0", which stands for none, gives neither. The kind is that of the layer where its name is one (known_kind). Closed
/// entities, and those whose last point repeats the first, are Polygons of one anticlockwise contour; the others are
/// Lines in the order of drawing. Heights (an elevation too) are kept where one is not 0, or dropped. A remark says
/// what was dropped: entities that are not displayed (invisible, or on a layer that is off or frozen), third
/// coordinates, repeated points, entities that are no lines (texts, points, hatches, ...). `stated` says the unit of
/// $INSUNITS, and asks where it is none of mm, cm, dm, m, km, in, ft, yd and mi.
/// @error EmptyFile; BadFormat with the line: binary, a group code or a coordinate that is no number, the end missing
///        (a file cut short), no section ENTITIES; NotFinite, DegenerateCurve: the place's item is the entity.
/// @cost  O(file size).
/// @param faulty  Skip: degenerate entities are left out with a remark.
base::Result<lines::Features> parse_dxf(std::string_view text, const std::string& file,
                                        lines::Heights heights = lines::Heights::Drop,
                                        lines::Faulty faulty = lines::Faulty::Refuse);
/// @error FileNotFound, NotAFile, CannotRead, and those of parse_dxf.
base::Result<lines::Features> read_dxf(const std::string& path, lines::Heights heights = lines::Heights::Drop);

/// A drawing of release 12: each part a POLYLINE on the layer of the feature's name, closed ones with the flag; with
/// heights, 3D polylines that repeat their first point. What is read from this text gives the same text again. Points
/// features are POINTs; holes of polygons become contours like others.
/// @param unit  metres in one unit of the drawing: stated as $INSUNITS (of release 2000) if it is among dxf_units.
/// @error NotFinite
base::Result<std::string> dxf(std::span<const lines::Feature> features, std::optional<double> unit = {});

/// The layer that a feature is written to: its name without what the format forbids; "0" without a name.
std::string dxf_layer(const lines::Feature& feature);

}  // namespace dobra::io::gis
