#pragma once
// From OGR's features to ours. Internal to io: the readers that go through OGR use it. Source: [gdal].

#include <string>
#include <vector>

#include "shared/io/lines/feature.h"

class OGRFeature;
class OGRSimpleCurve;
class OGRSpatialReference;

namespace dobra::io::gis {

/// Adds a curve as a further part of `feature`, with its heights where these are kept.
void add_part(const OGRSimpleCurve& curve, lines::Heights heights, lines::Feature& feature);

/// Adds one OGR feature to `result`, or a remark where it has no geometry. Its fields name and kind (capitals or not)
/// are the name and the kind, the others properties.
/// @param number  its number in the file, from 1.
/// @error BadFormat (a geometry that is not read), and those of normalise; the place's item is the feature. With
///        Faulty::Skip what is so is left out with a remark.
base::Result<void> add_ogr_feature(const OGRFeature& source, std::size_t number, const std::string& file,
                                   lines::Heights heights, lines::Faulty faulty, lines::Features& result);

/// What the reference system of a layer says of units: the linear one, or a question where it is in degrees.
void note_system(const OGRSpatialReference* system, lines::StatedConvention& stated);

/// What a system of OGR is to us; nothing for none, and for GeoPackage's words for none.
std::optional<lines::ReferenceSystem> reference_system(const OGRSpatialReference* system);

}  // namespace dobra::io::gis
