#pragma once
// Whether a fault lies between two pieces of a bed, and whether it still displaces the bed. Page:
// docs/algorithms/cutoffs.md

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recon/faults/cutoffs.h"

namespace recon::faults {

/// An end of a piece of a horizon.
struct PieceEnd {
  const section::Horizon& piece;
  section::LineEnd end = section::LineEnd::First;

  [[nodiscard]] geom::Point at() const;
};

struct FaultBetween {
  std::string fault;
  double separation = 0.0;  ///< Of both ends, taken to the fault, along it, m; >= 0.
  bool displaces = false;   ///< The separation is more than picks and a misfit left by a move may be.
};

class FaultsBetween {
 public:
  /// @error those of faults_of.
  static base::Result<FaultsBetween> make(const section::Section& section);

  /// Ends on opposite walls of a fault: one that displaces the bed, else one that does not, else nothing.
  [[nodiscard]] std::optional<FaultBetween> of(const PieceEnd& a, const PieceEnd& b) const;

 private:
  struct AtFault {
    kinematics::Wall wall = kinematics::Wall::Hanging;
    double arc = 0.0;
    std::string horizon;
  };
  using EndKey = std::pair<section::HorizonId, section::LineEnd>;
  struct OneFault {
    const Fault* fault = nullptr;
    geom::Polyline own;
    std::map<EndKey, AtFault> ends;
    bool taken_back = false;
  };

  [[nodiscard]] std::optional<AtFault> end_at(const OneFault& one, const PieceEnd& end, double reach) const;
  [[nodiscard]] double spacing(const OneFault& one, const AtFault& at) const;

  std::vector<Fault> faults_;
  std::vector<OneFault> at_;
  double drawn_ = 0.0;     ///< How exactly a section is drawn, m.
  double rounding_ = 0.0;  ///< m
};

}  // namespace recon::faults
