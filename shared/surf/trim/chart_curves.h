#pragma once
// Curves in a chart made of others.

#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::trim {

/// The curve as it is, elsewhere.
Curve moved(const Curve& curve, geom::Vector by);

/// The curve with its ends at `from` and `to` in other places: what they are off is added, less and less along it.
Curve with_ends(const Curve& curve, double from, double to, geom::Point start, geom::Point end);

/// The edge with its ends in given places, from which it is rounding away or more; borders of the chart are met
/// exactly.
/// @param rounding  part of the chart's ranges
ChartEdge with_ends(const ChartEdge& edge, const geom::Box& chart, geom::Point start, geom::Point end, double rounding);

/// The same place of a closed surface by whole periods, in its chart; elsewhere it stays.
geom::Point in_period(const Surface& surface, geom::Point uv);

/// A straight edge. @pre the points differ
ChartEdge straight(geom::Point from, geom::Point to, const std::string& name = {});

}  // namespace dobra::surf::trim
