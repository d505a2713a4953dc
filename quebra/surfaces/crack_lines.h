#pragma once
// Lines that go with a crack on a surface: bands at given distances round it, and rosettes at its ends. Offsets are
// made in the chart, scaled and sheared by the metric in the middle of the crack; then each place is moved along its
// foot until its distance from the crack in space is the one asked for. Page: docs/algorithms/surface_front.md.
// Sources: [carvalho2005offset], [miranda2009surface].

#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// A crack as it was drawn.
struct DrawnCrack {
  std::string name;
  bool closed = false;
  std::vector<dobra::surf::trim::ChartEdge> edges;
  std::vector<dobra::geom::Point> places;  ///< Along it, in the chart; ends first and last.
};

struct CrackLineOptions {
  std::vector<double> bands;  ///< Distances, m in space, above 0.
  double rosette = 0.0;       ///< Radius, m in space; 0: none.
  int sectors = 8;            ///< Triangles round an end.
  double most_skew = 4.0;     ///< Ratio of stretches along the crack, over which a band is told to be doubtful.
  double accuracy = 0.02;     ///< Part of a distance by which a band may miss it before that is told.
};

struct CrackLines {
  struct Line {
    std::string name;  ///< NAME_band_1, NAME_rosette.
    bool closed = false;
    std::vector<dobra::surf::trim::ChartEdge> edges;
  };
  struct Doubt {
    std::string code, message;
    dobra::geom::Point at;  ///< In the chart.
  };
  std::vector<Line> lines;
  std::vector<dobra::surf::trim::ChartPoint> tips;  ///< With the size of their rosettes.
  std::vector<Doubt> doubts;  ///< band_skewed, band_left_out, rosette_left_out; each says what was done.
};

/// @param bounds  places of lines that bound what is meant, in the chart: an end of the crack on one has no rosette.
/// @return bands as lines inside the chart, cut where they would leave it
/// @error  those of offset() and of the makers of surf::Curve
/// @cost   O(n m) for n places of the bands and m of the crack
dobra::base::Result<CrackLines> crack_lines(const dobra::surf::Surface& surface, const DrawnCrack& crack,
                                            const std::vector<std::vector<dobra::geom::Point>>& bounds,
                                            const CrackLineOptions& options);

}  // namespace quebra::surfaces
