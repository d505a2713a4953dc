#pragma once
// Where faults cut horizons: the cutoffs on both walls, and what separates them. Page: docs/algorithms/cutoffs.md

#include <optional>
#include <string>
#include <vector>

#include "recon/faults/fault.h"

namespace recon::faults {

struct Cutoff {
  section::HorizonId piece;
  section::LineEnd end = section::LineEnd::First;  ///< Of the piece; of no meaning where that passes.
  geom::Point at;                                  ///< On the fault.
  double arc = 0.0;                                ///< Along the fault's path, m.
  double extended = 0.0;  ///< What the horizon is lengthened by to reach the fault, m; < 0: trimmed by.
  bool passes = false;    ///< The horizon runs across the fault: both walls have this point.
};

/// One horizon at one fault. Positive where the hanging wall is down; nothing where a wall is missing. m.
struct CutoffPair {
  std::string horizon;  ///< Of its whole.
  std::optional<Cutoff> hanging_wall, footwall;
  std::optional<double> separation;  ///< Along the fault.
  std::optional<double> throw_;      ///< Of heights.
  std::optional<double> heave;       ///< Level; what it opens.
  std::optional<double> gap;         ///< The heave where it opens, else 0.
  std::optional<double> overlap;     ///< The heave where it closes, else 0.
  double distance = 0.0;             ///< From the fault's higher end to the middle of both cutoffs, along it.
};

struct FaultCutoffs {
  std::string fault;
  std::vector<CutoffPair> pairs;     ///< From the higher end down.
  Sense sense = Sense::Unknown;      ///< By the mean separation.
  std::vector<std::string> remarks;  ///< What was extended, stops short, has no partner; with places.
};

/// At one of the faults: of several the nearest takes an end of a horizon. One whose hanging wall nothing tells has no
/// pairs.  @cost  O(points of the fault x points of the horizons that its box meets)
FaultCutoffs cutoffs_at(const section::Section& section, const std::vector<Fault>& faults, std::size_t which,
                        const FaultOptions& options);
/// In the order of the faults.
std::vector<FaultCutoffs> cutoffs_of(const section::Section& section, const std::vector<Fault>& faults,
                                     const FaultOptions& options);

/// That a pair lacks a wall, in words.
std::string partner_missing(const CutoffPair& pair, const std::string& fault);

/// Takes the horizon's ends to the faults that cut it off, and `past` metres farther.
void reach_faults(const std::vector<FaultCutoffs>& cutoffs, double past, section::Horizon& horizon);

}  // namespace recon::faults
