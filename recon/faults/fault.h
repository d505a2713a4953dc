#pragma once
// The faults of a section as lines with a lower and a higher end, a hanging wall and a kind of end each.
// Page: docs/algorithms/cutoffs.md

#include <optional>
#include <string>
#include <vector>

#include "recon/kinematics/fault_path.h"
#include "recon/section/section.h"
#include "shared/base/result.h"

namespace recon::faults {

enum class Sense { Unknown, None, Normal, Reverse };
/// Border: leaves the section. Tip: ends in rock. Branch: joins another fault. Cut: ends on a younger one.
enum class EndKind { Border, Tip, Branch, Cut };
/// "unknown", "none", "normal", "reverse"; "border", "tip", "branch", "cut".
const char* name_of(Sense sense);
const char* name_of(EndKind kind);

struct FaultEnd {
  EndKind kind = EndKind::Border;
  geom::Point at;    ///< On the other fault, if it is a Branch or Cut.
  std::string on;    ///< That other fault.
  double gap = 0.0;  ///< Between the drawn end and the other fault, m.
};

struct Fault {
  std::string name;                     ///< Of its whole; of the piece, where the pieces of one fault do not meet.
  std::string whole;                    ///< What it and the other pieces are called together.
  std::vector<section::LineId> pieces;  ///< From the lower end to the higher one.
  int order = 0;                        ///< 1: the youngest; 0: not said.
  kinematics::FaultPath path;           ///< The own line; a branch goes on along what it joins.
  double own_from = 0.0;                ///< The own part of the path, arc lengths, m.
  double own_to = 0.0;
  FaultEnd lower, upper;
  std::optional<base::Error> undecided = std::nullopt;  ///< Why nothing tells the hanging wall.
};

/// That a method with a tip takes an end for one where the fault leaves the section; nothing where the fault has a tip.
std::optional<std::string> remark_on_taken_tip(const Fault& fault, geom::Point end);

/// The own part of its path.
geom::Polyline own_line(const Fault& fault);

struct FaultOptions {
  double tolerance = 0.0;  ///< m; 0: 0.005 of the diagonal of the section's box.
};
double tolerance_of(const section::Section& section, const FaultOptions& options);

/// All faults, the youngest first; those without an order behind, as the section has them.
/// @error BadSection with the place: a fault that crosses itself; a hanging wall said to be on a side that the fault
///        does not have; ages that contradict the cutting.
base::Result<std::vector<Fault>> faults_of(const section::Section& section, const FaultOptions& options);

/// @error BadSection: no fault, or several pieces that do not meet, have this name.
base::Result<const Fault*> find_fault(const std::vector<Fault>& faults, const std::string& name);

}  // namespace recon::faults
