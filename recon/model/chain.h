#pragma once
// The ledger of a chain of stages: what became of beds and units between any two of its states. State 0 is the input;
// state k is the section after k restorations and moves. Page: docs/algorithms/chain.md

#include <string>
#include <vector>

#include "recon/model/stage.h"

namespace recon::model {

/// A length or an area in two states of the chain. m or m2.
struct Compared {
  std::string name;
  double before = 0.0;
  double after = 0.0;
  section::BedRole role = section::BedRole::Judged;
  [[nodiscard]] double change_percent() const { return 100.0 * (after - before) / before; }
};
struct Comparison {
  std::vector<Compared> beds;   ///< Lengths of horizons.
  std::vector<Compared> units;  ///< Areas.
};
/// What a chain as a whole kept.
struct ChainVerdict {
  bool balanced = false;
  const Compared* bed = nullptr;   ///< The judged bed whose length changed most.
  const Compared* unit = nullptr;  ///< Likewise the unit's area.
};
/// Balanced: no judged bed or unit changed by more than the tolerance, percent. Points into the comparison.
ChainVerdict judge(const Comparison& comparison, double tolerance);
/// That of the last restoration; where nothing but moves was done, the one by default. Percent.
double balance_tolerance(const std::vector<const Stage*>& chain);
/// In words, by that tolerance; empty where the chain has one stage or none.
std::string verdict_since_input(const std::vector<const Stage*>& chain);

/// The ledger between two states: beds and units that all stages between them have.
/// @pre from < to <= chain.size()
Comparison compare(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to);

}  // namespace recon::model
