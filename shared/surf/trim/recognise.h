#pragma once
// The faces of a chart that lines bound: drawn loops and lines, curves from intersections, the sides of the chart. They
// may cross, touch, overlap and end anywhere. Which faces there are is decided by the planar subdivision of
// shared/topo on chords of the lines, whose crossings were found on the lines themselves. Source: [miranda2009surface],
// [cavalcante1991hed]. Page: docs/algorithms/trimming.md.

#include <map>
#include <memory>
#include <span>
#include <tuple>

#include "shared/surf/trim/finding.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::trim {

/// What is drawn in a chart. Its edges follow each other, each ending where the next begins, to the tolerance `close`.
struct TrimLine {
  ChartLine line;       ///< `kind` is of what of it lies inside a face.
  bool closed = false;  ///< The last edge ends where the first begins; else it may.
  bool bounds = true;   ///< Faces end there; else it is a line inside, whether closed or not.
};

/// Gives numbers to parts of curves that faces share; kept from surface to surface of one model.
class SharedNumbers {
 public:
  /// @param first  above all numbers that edges have already
  explicit SharedNumbers(SharedCurveId first = 1U << 20U) : next_(first) {}
  SharedCurveId fresh() { return next_++; }
  /// Of the part of curve `whole` between two parameters: the same on all surfaces.
  SharedCurveId of(SharedCurveId whole, double from, double to);

 private:
  SharedCurveId next_;
  std::vector<std::tuple<SharedCurveId, double, double, SharedCurveId>> parts_;
};

struct RecogniseOptions {
  double same = 1e-7;   ///< Points nearer than this are one, by parts of the chart's ranges; so below.
  double close = 2e-3;  ///< Gaps between edges that follow each other in a line are closed up to this, and told.
  double chord = 0.02;  ///< Longest chord that stands for a line; halved where chords would cross otherwise than lines.
  bool name_sides = true;    ///< Sides of the chart that bound are called "left", "right", "bottom", "top".
  bool across_seams = true;  ///< What lies on both sides of a seam is one face.
  /// Parameters at which shared curves are cut besides, so that they are alike on all their surfaces.
  std::map<SharedCurveId, std::vector<double>> cuts = {};
};

enum class CommonLines : std::uint8_t {
  Keep,  ///< Lines between united faces become lines inside.
  Drop,  ///< They vanish.
};

/// A piece that a crack and other lines have in common. It is opened, and is in the set of the crack alone.
struct OnCrack {
  std::string crack;
  std::vector<std::string> others;
  geom::Point at;  ///< Its middle, in the chart.
};

class Recognised {
 public:
  /// By their largest outer loop, from the least (u, v) of it. Of each the outer loops come first, then its holes;
  /// lines inside are those that bound nothing there. An edge is its line's curve between the parameters where it was
  /// cut. It has a number if it had one (a part of it gets its own), lies on a seam or between two faces.
  [[nodiscard]] const std::vector<TrimmedSurface>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// Where shared curves were cut: for `cuts` of their other surfaces.
  [[nodiscard]] const std::map<SharedCurveId, std::vector<double>>& cuts() const { return cuts_; }

  /// The face in which a point lies; beyond a closed direction by whole periods.
  /// @error OutsideDomain: beside the chart, or on a line or so near to it that its side is not known.
  [[nodiscard]] base::Result<std::size_t> pick(geom::Point uv) const;
  /// Some faces as one. @pre numbers of faces
  [[nodiscard]] TrimmedSurface united(std::span<const std::size_t> faces, CommonLines common) const;

  /// On which side of closed lines, taken as one drawing, each of faces() lies: 0 or 1, and the other one across them.
  /// It follows from the arcs between the faces, so that no face is too thin. Which number is inside is not told.
  /// @param lines  numbers of lines as they were given
  /// @error CannotMesh with the place: the lines do not close.
  [[nodiscard]] base::Result<std::vector<std::uint8_t>> sides_of(std::span<const std::size_t> lines) const;
  /// Within some faces, or between them. @pre numbers of faces
  [[nodiscard]] std::vector<OnCrack> on_cracks(std::span<const std::size_t> faces) const;

  struct State;
  Recognised(std::shared_ptr<const State> state, std::vector<Finding> findings);

 private:
  std::shared_ptr<const State> state_;
  std::vector<TrimmedSurface> faces_;
  std::vector<Finding> findings_;
  std::map<SharedCurveId, std::vector<double>> cuts_;
};

/// @error CannotMesh: a line that does not close, or edges further apart than `close`; lines that touch too closely to
/// be
///        told apart; DegenerateCurve: a closed line that encloses nothing; OutsideDomain: a line that leaves the chart
///        (over a seam it may). Each with the place.
/// @cost  the square of the number of lines, and log of the accuracy a crossing
base::Result<Recognised> recognise(const Surface& surface, std::span<const TrimLine> lines, SharedNumbers& numbers,
                                   const RecogniseOptions& options = {});
base::Result<Recognised> recognise(const Surface& surface, std::span<const TrimLine> lines,
                                   const RecogniseOptions& options = {});

}  // namespace dobra::surf::trim
