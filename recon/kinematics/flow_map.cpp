#include "recon/kinematics/flow_map.h"

#include <algorithm>
#include <cmath>

namespace recon::kinematics {

namespace {

/// A point on its way along its flow line, as an affine function of where it began.
class Flow {
 public:
  Flow(const FlowDomains& domains, geom::Vector v, AffinePiece& piece) : domains_(domains), v_(v), piece_(piece) {}

  void go(double amount) {
    const geom::Point p = domains_.origin() + geom::Vector{piece_.image.x(v_), piece_.image.y(v_)};
    domain_ = domains_.domain_at(p);
    const FlowDomains::Domain& d = domains_.domains()[domain_.index()];
    at_ = piece_.image;
    psi_ = d.speed * from_foot(d, d.out);
    LinearPoint foot;
    const bool below = psi_(v_) < 0.0;
    piece_.sides.push_back(psi_);
    if (below) foot = at_ = on_path(d, p);
    start(d);
    rest_ = LinearForm{0.0, 0.0, amount};
    while (pass(amount > 0.0)) {
    }
    const FlowDomains::Domain& last = domains_.domains()[domain_.index()];
    at_ = at_.moved(last.speed * rest_, last.along);
    piece_.image = below ? LinearPoint{piece_.image.x + at_.x - foot.x, piece_.image.y + at_.y - foot.y} : at_;
  }

 private:
  /// (at - foot of the domain) along a direction.
  [[nodiscard]] LinearForm from_foot(const FlowDomains::Domain& d, geom::Vector unit) const {
    return at_.along(unit) + -geom::dot(d.foot - domains_.origin(), unit);
  }

  /// The point of the segment nearest to p, which lies below it.
  LinearPoint on_path(const FlowDomains::Domain& d, geom::Point p) {
    const LinearForm along = from_foot(d, d.along);
    const geom::Vector foot = d.foot - domains_.origin();
    const double place = geom::dot(p - d.foot, d.along);
    psi_ = {};
    const bool before = !d.lower.empty() && place < 0.0;
    const bool behind = !d.upper.empty() && place > d.length;
    if (!d.lower.empty()) piece_.sides.push_back(along);
    if (!d.upper.empty()) piece_.sides.push_back(along + -d.length);
    const LinearForm at = before ? LinearForm{} : behind ? LinearForm{0.0, 0.0, d.length} : along;
    return {d.along.x * at + foot.x, d.along.y * at + foot.y};
  }

  /// Where the walls of the start stand.
  void start(const FlowDomains::Domain& d) {
    for (const auto* side : {&d.lower, &d.upper}) {
      if (const FlowWall* wall = domains_.wall_at(*side, psi_(v_))) {
        piece_.sides.push_back(at_.along(d.along) - on_wall(*wall).along(d.along));
        note_levels(*wall);
      }
    }
  }

  [[nodiscard]] LinearPoint on_wall(const FlowWall& wall) const {
    const geom::Vector at = wall.at - domains_.origin();
    const LinearForm up = psi_ + -wall.from;
    return {wall.rise.x * up + at.x, wall.rise.y * up + at.y};
  }

  void note_levels(const FlowWall& wall) {
    if (wall.from > 0.0) piece_.sides.push_back(psi_ + -wall.from);
    if (std::isfinite(wall.to)) piece_.sides.push_back(psi_ + -wall.to);
  }

  /// Goes to the wall ahead and past it; false if the flow ends before.
  bool pass(bool up) {
    const FlowDomains::Domain& d = domains_.domains()[domain_.index()];
    const FlowWall* wall = domains_.wall_at(up ? d.upper : d.lower, std::max(psi_(v_), 0.0));
    if (wall == nullptr) return false;
    const LinearPoint there = on_wall(*wall);
    const LinearForm rest = rest_ - (1.0 / d.speed) * (there.along(d.along) - at_.along(d.along));
    piece_.sides.push_back(rest);
    note_levels(*wall);
    if (up ? rest(v_) <= 0.0 : rest(v_) >= 0.0) return false;
    at_ = there;
    rest_ = rest;
    domain_ = up ? wall->behind : wall->before;
    return true;
  }

  const FlowDomains& domains_;
  geom::Vector v_;
  AffinePiece& piece_;
  DomainId domain_;
  LinearPoint at_;
  LinearForm psi_;
  LinearForm rest_;  ///< Amount that is left.
};

}  // namespace

FlowMap::FlowMap(std::shared_ptr<const FlowDomains> domains, double amount) {
  legs_.push_back({std::move(domains), amount});
}

FlowMap FlowMap::then(const FlowMap& next) const {
  FlowMap both = *this;
  both.legs_.insert(both.legs_.end(), next.legs_.begin(), next.legs_.end());
  return both;
}

FlowMap FlowMap::swapped() const {
  FlowMap back = *this;
  std::reverse(back.legs_.begin(), back.legs_.end());
  for (Leg& leg : back.legs_) leg.amount = -leg.amount;
  return back;
}

void FlowMap::piece(geom::Point p, Wall, AffinePiece& here) const {
  here.sides.clear();
  here.image = {};
  here.origin = legs_.empty() ? geom::Point{} : legs_.front().domains->origin();
  for (const Leg& leg : legs_) Flow(*leg.domains, p - here.origin, here).go(leg.amount);
}

base::Result<FlowMap> fault_parallel_flow(const FaultPath& path, double slip) {
  DOBRA_TRY(FlowDomains domains, FlowDomains::make(path, std::vector<double>(path.line.segment_count(), 1.0)));
  return FlowMap(std::make_shared<const FlowDomains>(std::move(domains)), slip);
}

}  // namespace recon::kinematics
