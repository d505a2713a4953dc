#pragma once
// Error bars of a restoration: the section is restored again and again with picks, pin and direction of shear drawn
// from normal distributions, and every number of the ledger gets its mean, deviation and quantiles. Each draw is a
// function of the seed and its number alone. Page: docs/algorithms/ledger.md

#include <string>
#include <vector>

#include "recon/unfold/grid.h"
#include "recon/unfold/restore.h"
#include "recon/unfold/target.h"

namespace recon::unfold {

/// Parameters of the step `monte_carlo`.
struct MonteCarloParams {
  int draws = 1000;
  std::int64_t seed = 1;
  double pick_error = 0.0;
  std::optional<double> correlation;
  double pin_error = 0.0;
  base::Angle angle_error;
  template <class D>
  static void describe(D& d) {
    d.field("draws", &MonteCarloParams::draws, {.title = "Draws", .at_least = 2, .at_most = 10000000});
    d.field("seed", &MonteCarloParams::seed, {.title = "Seed", .help = "The same seed gives the same numbers."});
    d.field("pick_error", &MonteCarloParams::pick_error,
            {.title = "Error of picks", .help = "Standard deviation of x and z.", .unit = "m", .at_least = 0.0});
    d.field(
        "correlation", &MonteCarloParams::correlation,
        {.title = "Correlation length",
         .help = "Errors of picks nearer than this along a horizon are alike; by default a twentieth of the section.",
         .unit = "m",
         .above = 0.0});
    d.field("pin_error", &MonteCarloParams::pin_error,
            {.title = "Error of the pin's x", .help = "Of a pin that is given.", .unit = "m", .at_least = 0.0});
    d.field("angle_error", &MonteCarloParams::angle_error,
            {.title = "Error of the direction of shear", .unit = "deg", .at_least = 0.0});
  }
};

/// One number of the ledger over all draws.
struct Spread {
  std::string name;  ///< As in quantities: "horizon.top.length_after".
  std::string unit;
  double mean = 0.0;
  double deviation = 0.0;
  double low = 0.0;  ///< 2.5 % of the draws lie below it.
  double median = 0.0;
  double high = 0.0;  ///< 97.5 %.
};

struct MonteCarlo {
  MonteCarloParams params;
  std::vector<Spread> spreads;
  std::optional<double> balanced_share;  ///< Part of the judged draws that balance, 0 .. 1; nothing if none is judged.
  std::size_t failed = 0;                ///< Draws that could not be restored; they are not counted.
  std::vector<std::string> remarks;
};

/// @error CannotRestore if no draw can be restored; Cancelled.
/// @cost  One restoration of the horizons a draw, in parallel.
base::Result<MonteCarlo> monte_carlo(const section::Section& section, const SourceGrid& source, const Target& target,
                                     const RestoreParams& restore, const MonteCarloParams& params,
                                     const base::Progress& progress);

}  // namespace recon::unfold
