#pragma once
// The charts of a sheet: a single one where that keeps its scale, else one for each of several parts. Internal to
// remesh.h. Page: docs/algorithms/remesh.md.

#include <memory>
#include <vector>

#include "shared/base/progress.h"
#include "shared/surf/param/discrete_chart.h"
#include "shared/surf/remesh/flatten.h"

namespace dobra::surf::remesh {

struct AtlasOptions {
  param::Weights weights = param::Weights::ShapePreserving;
  double crease = 180.0;       ///< Degrees, as OpenOptions.
  double relaxed_from = 4.0;   ///< A chart of more `stretch` has its border set free.
  double most_stretch = 15.0;  ///< A part of more `stretch` is parted again,
  std::size_t fewest = 8;      ///< unless it has no more triangles than these.
  double least_area = 0.0;     ///< m2. Pieces that creases part are parts, if they are not smaller.
};

struct Part {
  std::shared_ptr<const param::DiscreteChart> chart;
  std::vector<std::uint32_t> triangles;  ///< One a triangle of the chart: its number in the sheet.
};

struct Atlas {
  param::Sheet before;
  param::Opened opened;                 ///< Cut along the lines between parts too, so it has as many pieces as parts.
  std::vector<Part> parts;              ///< In the order of the least numbers of their triangles.
  std::vector<std::uint32_t> part;      ///< One a point of `opened.sheet`: the part whose it is,
  std::vector<geom::Point> uv;          ///< and its place in the chart of that.
  double stretch = 1.0;                 ///< The greatest of a part.
  std::vector<base::Finding> findings;  ///< Those of Charted, and "parted".
};

/// Ratio of the greatest and the least length in space that a unit of the chart stands for, at any two places in any
/// directions; the fiftieth of the triangles that is stretched most and the one that is stretched least do not count.
double stretch(const param::Sheet& sheet, const std::vector<geom::Point>& uv);

/// One chart. @error those of chart_sheet; CannotMesh with the place: a chart with flipped triangles
base::Result<Atlas> single_chart(const param::SheetMade& made, Holes holes, const AtlasOptions& options,
                                 const base::Progress& progress = {});

/// Parted by the creases first, which are lines of the new mesh anyway. Then parts are halved, by the distance of their
/// triangles from the one that is stretched most and from the one farthest from that, until each has a chart that keeps
/// its scale. Lines between parts are cuts.
/// @error as single_chart, and Cancelled  @cost O(n^1.5) for each chart that is tried
base::Result<Atlas> several_charts(const param::SheetMade& made, const AtlasOptions& options,
                                   const base::Progress& progress = {});

}  // namespace dobra::surf::remesh
