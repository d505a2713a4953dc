#pragma once
// Every point of the hanging wall flows along its flow line. Page: docs/algorithms/fault_flow.md.
// Source: [egan1997].

#include <memory>

#include "recon/kinematics/flow_domains.h"

namespace recon::kinematics {

/// Fields of flow one after the other: exact, affine in pieces, det F = 1 in the hanging wall. What lies below the path
/// goes with the nearest point of it.
class FlowMap {
 public:
  FlowMap() = default;
  /// @param amount  slip of the first segment, m, > 0 along the path.
  FlowMap(std::shared_ptr<const FlowDomains> domains, double amount);

  /// This one first, then `next`.  @pre both of paths with the same first point.
  [[nodiscard]] FlowMap then(const FlowMap& next) const;
  [[nodiscard]] FlowMap swapped() const;

  /// The formula at p.  @cost O(log n + walls that p passes)
  void piece(geom::Point p, Wall on_fault, AffinePiece& here) const;
  [[nodiscard]] double size() const { return legs_.empty() ? 1.0 : legs_.front().domains->size(); }

 private:
  struct Leg {
    std::shared_ptr<const FlowDomains> domains;
    double amount;
  };
  std::vector<Leg> legs_;
};

/// All of the hanging wall moves as far as the fault slips, m.  @error those of FlowDomains::make().
base::Result<FlowMap> fault_parallel_flow(const FaultPath& path, double slip);

}  // namespace recon::kinematics
