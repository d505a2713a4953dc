#pragma once
// What is found wrong in drawn geometry, and the limits within which it is repaired. Page:
// docs/algorithms/domain_repair.md.

#include <optional>
#include <string>

#include "shared/geom/point.h"

namespace quebra::sketch {

/// What was wrong with the drawn geometry (repair.h).
enum class Wrong {
  RepeatedPoint,
  NearlyRepeatedPoint,
  NoExtent,
  CurveTwice,
  Spike,
  Gap,
  Crossing,
  Sliver,
  NearlyTouching,
  CutThrough,
  Outside,
  Apart
};

struct Finding {
  Wrong wrong = Wrong::RepeatedPoint;
  dobra::geom::Point at;
  std::string curve;  ///< Or both, "a, b".
  std::string mend;   ///< What was done; "left as it is: ..." with what to do by hand.
};

const char* name_of(Wrong wrong);

/// What repair.h mends.
struct RepairOptions {
  static constexpr double gap_fraction = 1e-3;
  static constexpr double greatest_gap_fraction = 0.1;
  double same_point = 1e-7;  ///< Points nearer than this fraction of the drawing's diagonal are one.
  /// Ends nearer than this that meet nothing are joined, m; otherwise gap_fraction of the diagonal.
  std::optional<double> gap = std::nullopt;
  double spike = 0.01;  ///< Corners sharper than this are spikes, degrees.
};

/// The widest gap that is closed, m.  @param size  the drawing's diagonal, m
double gap_limit(const RepairOptions& options, double size);

}  // namespace quebra::sketch
