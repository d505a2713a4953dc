#pragma once
// What an unrestored section tells of its balance: excess area of every horizon over its regional, shortening of its
// bed, depth to the detachment by each horizon alone (Chamberlin) and by all together (area-depth-strain).
//   A_excess(h) = D (h - h_d):   slope D = displacement on the detachment, h_d = its elevation
// Source: [chamberlin1910], [epard1993].  Page: docs/algorithms/ledger.md

#include <optional>
#include <string>
#include <vector>

#include "recon/balance/fold_class.h"
#include "recon/balance/shortening.h"
#include "recon/section/section.h"
#include "recon/section/section_check.h"
#include "shared/base/result.h"

namespace recon::balance {

/// Parameters of the step `balance`.
struct BalanceParams {
  double tolerance = 2.0;
  double confidence = 95.0;
  section::Crossings crossings = section::Crossings::Refuse;
  template <class D>
  static void describe(D& d) {
    d.field("tolerance", &BalanceParams::tolerance,
            {.title = "Balance tolerance",
             .help = "Greatest difference of shortening between the beds of a balanced section.",
             .unit = "%",
             .at_least = 0.0});
    d.field(
        "confidence", &BalanceParams::confidence,
        {.title = "Confidence", .help = "Of the intervals of the fit.", .unit = "%", .above = 0.0, .at_most = 99.9});
    d.choice("crossings", &BalanceParams::crossings, {"refuse", "allow"},
             {.title = "Horizons that cross", .help = section::crossings_help});
  }
};

/// One horizon, or a piece of one; its regional is the straight line between its ends. Lengths in metres, areas in m2.
struct BedBalance {
  section::HorizonId horizon;
  std::string name;
  double length = 0.0;
  double width = 0.0;           ///< Along the regional.
  double level = 0.0;           ///< Mean elevation of the regional.
  double excess_area = 0.0;     ///< Above the regional less below it.
  double shortening = 0.0;      ///< length - width.
  std::string piece_of = {};    ///< See Horizon: the line between the ends of a piece is a limb's, no regional.
  std::optional<double> depth;  ///< excess_area / shortening: of the detachment below the level, by this horizon alone;
                                ///< nothing for a piece.
  std::optional<double> layer_strain;  ///< (shortening - D) / (width + D): parallel to the bed, negative where it got
                                       ///< shorter; nothing without a detachment, or for a piece.
};

/// Straight line through (level, excess area) with the half-widths of the confidence intervals.
struct AreaDepthFit {
  double displacement = 0.0;                 ///< D, m
  std::optional<double> detachment;          ///< h_d, elevation, m; nothing where D may be 0 by its interval.
  std::optional<double> displacement_error;  ///< Half-widths; nothing with two horizons, which some line always fits.
  std::optional<double> detachment_error;
  std::optional<double> r_squared;  ///< Likewise.
};

/// The layer between two horizons that follow each other in the section; of horizons in pieces, between two pieces that
/// lie over each other.
struct LayerClass {
  std::string name;
  FoldClass fold;
};

struct AreaDepth {
  BalanceParams params;
  std::vector<BedBalance> beds;
  std::vector<LayerClass> layers;   ///< Those that are folded enough to have a class.
  std::optional<AreaDepthFit> fit;  ///< Of the whole horizons; nothing with one level or without displacement.
  Consistency consistency;          ///< Of the shortening of the beds, as `restore` has it too.
  BalanceVerdict verdict = BalanceVerdict::NotJudged;
  std::vector<std::string> remarks;
};

/// @error BadSection without a horizon.
base::Result<AreaDepth> area_depth(const section::Section& section, const BalanceParams& params);

/// Least squares with the given confidence in percent. @pre sizes equal. Nothing if all levels or all areas are the
/// same within the rounding of coordinates.
/// @param size  of what was digitised, m: coordinates are known to a millionth of it.
std::optional<AreaDepthFit> fit_area_depth(const std::vector<double>& levels, const std::vector<double>& areas,
                                           double confidence_percent, double size = 0.0);

}  // namespace recon::balance
