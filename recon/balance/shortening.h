#pragma once
// Shortening of beds, and whether it agrees between them: one definition for `balance` and `restore`. It is a matter of
// the section as it is, whatever restores it.
//   S = l0 - l1    l0  length of the bed
//                  l1  length along the regional, the straight line from end to end (of a bed in pieces: the sum of
//                      the straight lines of its pieces, as vectors)
// Two beds are compared over the part that both have, between the same material lines: through both ends where these
// lie on one border of the section, else square to the beds through the end of the one that is shorter there.
// Page: docs/algorithms/ledger.md

#include <string>
#include <vector>

#include "recon/section/section.h"

namespace recon::balance {

/// Lengths in metres.
struct BedLength {
  double length = 0.0;    ///< l0
  geom::Vector straight;  ///< From the first end to the last, summed up over pieces.
  [[nodiscard]] double regional() const { return geom::length(straight); }  ///< l1
  [[nodiscard]] double shortening() const { return length - regional(); }
  BedLength& operator+=(const BedLength& piece);
};
BedLength bed_length(const geom::Polyline& line);

/// How two beds differ over the part that they share.
struct ShorteningPair {
  std::string one;  ///< Names of the beds as wholes; `one` has the greater shortening.
  std::string other;
  double shortening_one = 0.0;  ///< Of the part, m.
  double shortening_other = 0.0;
  double shared = 0.0;   ///< Length l0 of the part, of the bed in which it is longer, m.
  double percent = 0.0;  ///< Difference of the shortenings, of `shared`.
};

struct Consistency {
  std::size_t compared = 0;             ///< Pairs of beds that share a part.
  ShorteningPair worst;                 ///< That with the greatest difference; empty where no pair was compared.
  std::vector<std::string> not_judged;  ///< Beds marked as growth.
};

/// On the balance of a section.
enum class BalanceVerdict {
  Balanced,
  NotBalanced,
  NotJudged,  ///< Nothing is beyond the tolerance, but no two beds share a part, so that nothing was compared.
};

/// @param greatest  the greatest of all changes and differences, %.
BalanceVerdict verdict_of(const Consistency& consistency, double greatest, double tolerance);

/// "balanced", "not balanced", "not judged": in results.
const char* verdict_name(BalanceVerdict verdict);

/// The same at the head of a sentence: "nothing to judge".
const char* verdict_words(BalanceVerdict verdict);

/// Horizons in pieces count as one bed, those marked as growth do not count.
/// @cost  O(n log n) for n points, and O(log n) a pair of horizons.
Consistency consistency_of(const std::vector<section::Horizon>& horizons);

/// "shortening differs by 4.6 % ...": the worst pair, in words.
std::string consistency_text(const Consistency& consistency);

}  // namespace recon::balance
