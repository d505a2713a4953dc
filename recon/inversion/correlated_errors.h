#pragma once
// Confidence in least squares whose errors hang together along each bed, exp(-distance / length) of it. Lengths are
// those with which the residuals, from which the fit has taken its share, are as correlated as they are found to be.
// Page: docs/algorithms/inversion.md. Source: [worsley1995], [bayley1946].

#include <span>
#include <vector>

#include "recon/inversion/least_squares.h"

namespace recon::inversion {

/// The points of one bed, in order.
struct BedPoints {
  std::vector<double> steps;    ///< To the point before, m; the first is 0.
  std::vector<double> along;    ///< Of the restored points, along their line, m.
  std::vector<double> weights;  ///< Of their squares.
};

/// Whether the fit has turned the line of a bed, or shifted it alone.
enum class LineIs { Turned, Shifted };

class CorrelatedErrors {
 public:
  CorrelatedErrors() = default;
  /// @param residuals  weighted, of all beds one after the other.
  /// @param slopes     of the residuals, one column a free value.
  /// @cost  O(n (p^2 + c)) a bed for p columns and c correlated neighbours
  CorrelatedErrors(const std::vector<BedPoints>& beds, std::span<const double> residuals, Matrix slopes, LineIs line);

  /// One a bed, m; 0: points are independent.
  [[nodiscard]] const std::vector<double>& lengths() const { return lengths_; }
  /// Of each bed: how many independent points its mean is as well known from.
  [[nodiscard]] const std::vector<double>& effective() const { return effective_; }
  /// Degrees of freedom that the least sum has (Satterthwaite), >= 1.
  [[nodiscard]] double freedom() const { return freedom_; }
  /// The least sum that is expected, in variances of a point.
  [[nodiscard]] double expected() const { return expected_; }
  /// How far the sum may lie above the least one for the truth of some values to be there with this confidence, in
  /// variances of a point.
  /// @param values  which; the others at their best.
  [[nodiscard]] double allowance(std::span<const std::size_t> values, double confidence) const;
  [[nodiscard]] double joint_allowance(double confidence) const;

 private:
  std::vector<double> lengths_, effective_;
  double freedom_ = 0.0;
  double expected_ = 0.0;
  Matrix plain_, correlated_;  ///< Covariances of the values for errors of variance 1: independent ones, and these.
};

}  // namespace recon::inversion
