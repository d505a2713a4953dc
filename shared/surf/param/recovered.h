#pragma once
// The smooth surface of a sheet: disjoint patches of triangles, in each a quadratic polynomial of the chart fitted to
// its vertices by least squares, and between three vertices the barycentric mean of what the patches round each say.
// With a treatment of the border that makes it meet its curves. Page: docs/algorithms/recovered_surface.md.
// Sources: [miranda2005triangular] (4)-(11), [zienkiewicz1992spr].

#include <memory>
#include <optional>
#include <vector>

#include "shared/surf/curve.h"
#include "shared/surf/param/discrete_chart.h"

namespace dobra::surf::param {

/// Which points of the sheet the surface passes through exactly.
enum class Meets : std::uint8_t {
  Nothing,  ///< The paper: least squares alone.
  Border,   ///< All of the border: its vertices, and its curves between them.
  Points,   ///< That, and all vertices inside.
};

struct RecoverOptions {
  Meets meets = Meets::Border;
  /// Samples count by one over their distance from the middle of the patch, (6) of the source.
  enum class SampleWeights : std::uint8_t { Equal, InverseDistance } weights = SampleWeights::Equal;
};

/// The curve that a side of the border stands for, from its start to its end.
struct BorderPiece {
  Curve curve;
  double from = 0.0, to = 1.0;
};
/// One a half-edge, of the border only; nothing where the side itself is meant, or for all.
using BorderPieces = std::vector<std::optional<BorderPiece>>;

struct PatchReport {
  std::vector<std::uint32_t> patch_of;  ///< One a triangle.
  std::size_t patches = 0;
  std::size_t merged = 0;    ///< Patches that joined another: alone they determine no quadratic polynomial.
  std::size_t degraded = 0;  ///< Patches that determine a linear polynomial only, or just a mean.
};

/// Greatest jumps across sides, at three places of each.
struct Continuity {
  double value = 0.0;       ///< m.
  double recovered = 0.0;   ///< Of the recovered derivatives, m by units of the chart.
  double derivative = 0.0;  ///< Of the derivatives of the surface itself.
};

/// Cheap to copy; any number of threads may ask at once.
class Recovered {
 public:
  /// @pre pieces: none, or one a half-edge  @cost O(n)
  Recovered(std::shared_ptr<const DiscreteChart> chart, const RecoverOptions& options = {}, BorderPieces pieces = {});

  /// Value and derivatives of the surface.
  [[nodiscard]] Jet jet(geom::Point uv) const;
  [[nodiscard]] Jet jet(const Located& place) const;
  /// Derivatives by (11), the mean of those of the patches: continuous, and not those of the values between.
  [[nodiscard]] Jet recovered(const Located& place) const;

  /// Over the box of the chart; beyond the border its tangent plane goes on. Bounds of bend() are half as much again
  /// as those at seven places of each triangle.
  [[nodiscard]] base::Result<Surface> surface() const;
  [[nodiscard]] const PatchReport& patches() const;
  [[nodiscard]] const DiscreteChart& chart() const;
  /// @cost O(n)
  [[nodiscard]] Continuity continuity() const;
  /// Greatest distance between a place of the border in the surface and in its curve, at eight places of each side, m.
  [[nodiscard]] double border_gap() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace dobra::surf::param
