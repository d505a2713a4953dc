#pragma once
// The values with which a model takes beds back to straight lines best: found globally, then locally, with limits of
// confidence and a map of the misfit.
//   S(v)  sum over the beds of the weighted squared distances of the restored points from the bed's straight line
// Page: docs/algorithms/inversion.md

#include <array>
#include <cstdint>
#include <span>

#include "recon/inversion/bed_shapes.h"
#include "recon/inversion/correlated_errors.h"
#include "shared/base/progress.h"

namespace recon::inversion {

/// One value of a model. Low = high: it is fixed.
struct Unknown {
  std::string key;
  std::string unit;
  double low = 0.0, high = 0.0;  ///< Between which it is sought.
  [[nodiscard]] bool fixed() const { return low == high; }
};

/// Search: true to a millionth of the size, for many candidates.
enum class Precision { Search, Full };
/// What takes a point back with these values; nothing where they make no map. Called from many threads.
using Model = std::function<std::optional<Restore>(std::span<const double> values, Precision precision)>;

struct FitOptions {
  std::uint64_t seed = 1;
  int generations = 120;
  double confidence = 95.0;            ///< %
  std::optional<base::Angle> bedding;  ///< Direction of the restored beds; each has its own where it is not said.
  double size = 0.0;                   ///< Of what was digitised, m: coordinates are known to a millionth of it.
};

enum class AtLimit { No, Low, High };

struct Estimate {
  Unknown unknown;
  double best = 0.0;
  AtLimit at_limit = AtLimit::No;  ///< The best lies on a limit of the search.
  /// Of confidence, by the profile of S; nothing: the data do not end it within the limits of the search.
  std::optional<double> low, high;
};

struct BedMisfit {
  std::string name;
  std::size_t points = 0;
  double before = 0.0;              ///< Root of the mean squared distance from its line as it lies, m.
  double after = 0.0;               ///< Restored.
  base::Angle dip;                  ///< Of the line of the restored bed, anticlockwise from +x, in (-90, 90] degrees.
  double correlation = 1.0;         ///< Points over which the errors hang together.
  double correlation_length = 0.0;  ///< Over which their correlation falls to 1 / e, m; 0: they do not hang together.
};

struct Fit {
  std::vector<Estimate> estimates;  ///< In the order of the unknowns.
  std::vector<BedMisfit> beds;
  double sum = 0.0;     ///< S, m2
  double rms = 0.0;     ///< Root of S over the number of points, m.
  double before = 0.0;  ///< The same of the beds as they lie.
  std::size_t points = 0;
  double effective = 0.0;   ///< Points that are independent of each other.
  CorrelatedErrors errors;  ///< What that makes of the confidence.
  /// The rms up to which values are in the region of confidence of all free ones together; nothing if none is free.
  std::optional<double> region;
  std::vector<std::string> remarks;
  [[nodiscard]] std::vector<double> values() const;
};

/// The root of the mean squared distance of the beds restored with some values, m; nothing where they make no map.
std::optional<double> misfit_of(const std::vector<BedShape>& beds, const Model& model, std::span<const double> values,
                                std::optional<base::Angle> bedding);

/// @param alternatives  lists of the same unknowns between other limits, of which the best is taken.
/// @error BadSection: fewer points than it takes; beds that are straight as they are. CannotRestore: no values between
///        the limits make a map. Cancelled.
base::Result<Fit> fit_beds(const std::vector<BedShape>& beds, const std::vector<std::vector<Unknown>>& alternatives,
                           const Model& model, const FitOptions& options, const base::Progress& progress);

/// The least misfit over two values, the others at their best for each pair.
struct MisfitMap {
  std::array<std::size_t, 2> axes{};      ///< Which unknowns.
  std::array<std::vector<double>, 2> at;  ///< Their values.
  std::vector<double> rms;                ///< m, row by row: the second value grows slowest; not finite: no map.
  double region = 0.0;                    ///< The rms that bounds the region of confidence of the two, m.
};
/// On some 240 points of all beds.  @error Cancelled
base::Result<MisfitMap> map_misfit(const std::vector<BedShape>& beds, const std::vector<Unknown>& unknowns,
                                   const Model& model, const Fit& fit, std::array<std::size_t, 2> axes,
                                   std::size_t count, const FitOptions& options, const base::Progress& progress);

}  // namespace recon::inversion
