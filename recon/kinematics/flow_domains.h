#pragma once
// The field of velocities over a fault of straight segments: over segment i everything flows along it, u_i times as
// fast as over the first one. Walls part the domains. A wall starts at a bend and runs where the stream functions
// psi_i = u_i (distance from segment i) of its two domains are equal, so that as much flows in as out and areas are
// kept. Where two walls meet, the domain between them ends. Flow lines are lines of equal psi; where all speeds are 1
// they are the parallels of the fault and the walls bisect the bends. Page: docs/algorithms/fault_flow.md

#include <vector>

#include "recon/kinematics/affine_piece.h"
#include "shared/base/id.h"
#include "shared/geom/segment_tree.h"

namespace recon::kinematics {

struct DomainTag {
  static constexpr const char* prefix = "domain";
};
/// Domains stand in the order of the path's segments; neighbours in one direction and of one speed share a domain.
using DomainId = base::Id<DomainTag>;

/// What parts two domains between two levels; straight.
struct FlowWall {
  DomainId before, behind;      ///< Towards the lower and the higher end.
  double from = 0.0, to = 0.0;  ///< psi, m; `to` may be infinite.
  geom::Point at;               ///< At psi = from.
  geom::Vector rise;            ///< A metre of psi.
  [[nodiscard]] geom::Point point(double psi) const { return at + (psi - from) * rise; }
};

/// Where two walls meet, and the domain that ends there.
struct Merge {
  geom::Point place;
  DomainId ended;
  double psi = 0.0;  ///< m
};

class FlowDomains {
 public:
  /// @param speeds  one a segment of the path, > 0: how far it slips while the first one slips 1.
  /// @error CannotRestore with the place where the path turns back, so that there is no direction in which all segments
  ///        advance; or where domains meet that flow one way at different speeds, so that no wall between them keeps
  ///        areas.
  /// @cost  O(n log n)
  static base::Result<FlowDomains> make(const FaultPath& path, const std::vector<double>& speeds);

  /// One domain of a segment.
  struct Domain {
    geom::Point foot;    ///< First point of the segment.
    geom::Vector along;  ///< Unit.
    geom::Vector out;    ///< Unit, into the hanging wall.
    double speed = 1.0;
    double length = 0.0;                      ///< Of the segment, m.
    std::vector<std::uint32_t> lower, upper;  ///< Walls towards both ends, upwards in psi; none at the path's ends.
  };
  [[nodiscard]] const std::vector<Domain>& domains() const { return domains_; }
  [[nodiscard]] const std::vector<FlowWall>& walls() const { return walls_; }
  [[nodiscard]] const std::vector<Merge>& merges() const { return merges_; }  ///< By psi.
  [[nodiscard]] geom::Point origin() const { return domains_.front().foot; }
  [[nodiscard]] double size() const { return size_; }  ///< Of the path, m.

  /// The domain of p; below the path that of the nearest segment.  @param hint  of a point near p.  @cost O(log n)
  [[nodiscard]] DomainId domain_at(geom::Point p, DomainId hint = {}) const;
  /// psi of a domain at p, m.
  [[nodiscard]] double level(DomainId domain, geom::Point p) const {
    const Domain& d = domains_[domain.index()];
    return d.speed * geom::dot(p - d.foot, d.out);
  }
  /// The wall of `side` (lower or upper of a domain) at a level; nullptr if there is none.
  [[nodiscard]] const FlowWall* wall_at(const std::vector<std::uint32_t>& side, double psi) const;

  /// The line of a level >= 0 through all domains, whose ends go on straight for `beyond` m.
  [[nodiscard]] geom::Polyline flow_line(double psi, double beyond) const;

 private:
  [[nodiscard]] bool contains(std::size_t domain, geom::Point p) const;
  base::Result<void> raise_walls();
  base::Result<std::uint32_t> add_wall(std::size_t before, std::size_t behind, geom::Point at, double psi);
  [[nodiscard]] double ends_at(std::size_t domain, std::uint32_t lower, std::uint32_t upper) const;

  std::vector<Domain> domains_;
  std::vector<FlowWall> walls_;
  std::vector<Merge> merges_;
  geom::SegmentTree tree_;
  double size_ = 0.0;
};

}  // namespace recon::kinematics
