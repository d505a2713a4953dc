#include "recon/kinematics/flow_domains.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <queue>
#include <tuple>

#include "recon/kinematics/refuse.h"
#include "recon/maps/columns.h"

namespace recon::kinematics {

namespace {

/// Directions whose sine of angle is below this count as one.
constexpr double parallel_sine = 1e-13;

/// Whether the tangents of all segments lie within less than half a turn; the first point where they do not.
std::optional<geom::Point> turns_back(const std::vector<FlowDomains::Domain>& domains) {
  double heading = 0.0;
  double least = 0.0;
  double greatest = 0.0;
  for (std::size_t i = 1; i < domains.size(); ++i) {
    const geom::Vector a = domains[i - 1].along;
    const geom::Vector b = domains[i].along;
    heading += std::atan2(geom::cross(a, b), geom::dot(a, b));
    least = std::min(least, heading);
    greatest = std::max(greatest, heading);
    if (greatest - least >= std::numbers::pi * (1.0 - 1e-9)) return domains[i].foot;
  }
  return std::nullopt;
}

/// Domains of the segments, joined where neighbours have one direction and one speed.
std::vector<FlowDomains::Domain> domains_of(const FaultPath& path, const std::vector<double>& speeds) {
  std::vector<FlowDomains::Domain> domains;
  for (std::size_t i = 0; i < path.line.segment_count(); ++i) {
    const geom::Segment segment = path.line.segment(i);
    const geom::Vector along = geom::normalised(segment.vector());
    if (!domains.empty() && domains.back().speed == speeds[i] && geom::dot(domains.back().along, along) > 0.0 &&
        std::abs(geom::cross(domains.back().along, along)) <= parallel_sine) {
      domains.back().length += segment.length();
      continue;
    }
    const geom::Vector out = path.hanging == Side::Left ? geom::left_of(along) : geom::right_of(along);
    domains.push_back({segment.from, along, out, speeds[i], segment.length(), {}, {}});
  }
  return domains;
}

}  // namespace

base::Result<FlowDomains> FlowDomains::make(const FaultPath& path, const std::vector<double>& speeds) {
  DOBRA_CHECK(speeds.size() == path.line.segment_count());
  FlowDomains flow;
  flow.domains_ = domains_of(path, speeds);
  if (const auto at = turns_back(flow.domains_)) {
    return refused(
        "the fault turns back here, so that no direction is one in which all of it advances; cut it there into "
        "two faults, draw it simpler, or take rigid or shear",
        *at);
  }
  std::vector<geom::Segment> segments;
  for (const Domain& d : flow.domains_) segments.push_back({d.foot, d.foot + d.length * d.along});
  flow.tree_ = geom::SegmentTree(std::move(segments));
  flow.size_ = path.line.box().diagonal();
  DOBRA_TRY_VOID(flow.raise_walls());
  return flow;
}

base::Result<std::uint32_t> FlowDomains::add_wall(std::size_t before, std::size_t behind, geom::Point at, double psi) {
  const Domain& a = domains_[before];
  const Domain& b = domains_[behind];
  // A metre of psi goes 1 / u out of either segment: r.out_a = 1 / u_a, r.out_b = 1 / u_b.
  const geom::Vector sum = a.out + b.out;
  const geom::Vector difference = a.out - b.out;
  const double slower = 1.0 / a.speed - 1.0 / b.speed;
  geom::Vector rise = ((1.0 / a.speed + 1.0 / b.speed) / geom::length_squared(sum)) * sum;
  if (std::abs(slower) > 1e-15) {
    if (geom::length(difference) <= parallel_sine) {
      return refused(
          fmt::format("the rock on both sides of this place moves in one direction, by {:.6g} and {:.6g} for "
                      "1 of slip, so that no wall between keeps areas; draw the fault with other bends here, or "
                      "take fault_parallel_flow",
                      a.speed, b.speed),
          at);
    }
    rise = rise + (slower / geom::length_squared(difference)) * difference;
  }
  walls_.push_back({DomainId(before), DomainId(behind), psi, maps::infinity, at, rise});
  const auto id = static_cast<std::uint32_t>(walls_.size() - 1);
  domains_[before].upper.push_back(id);
  domains_[behind].lower.push_back(id);
  return id;
}

double FlowDomains::ends_at(std::size_t domain, std::uint32_t lower, std::uint32_t upper) const {
  const Domain& d = domains_[domain];
  const FlowWall& l = walls_[lower];
  const FlowWall& u = walls_[upper];
  const double now = std::max(l.from, u.from);
  const double room = geom::dot(u.point(now) - l.point(now), d.along);
  const double widening = geom::dot(u.rise - l.rise, d.along);
  return widening < -1e-15 ? now + std::max(room, 0.0) / -widening : maps::infinity;
}

base::Result<void> FlowDomains::raise_walls() {
  const std::size_t n = domains_.size();
  for (std::size_t i = 1; i < n; ++i) DOBRA_TRY_VOID(add_wall(i - 1, i, domains_[i].foot, 0.0));
  struct End {
    double psi;
    std::size_t domain;
    std::uint32_t lower, upper;
    bool operator>(const End& other) const { return std::tie(psi, domain) > std::tie(other.psi, other.domain); }
  };
  std::priority_queue<End, std::vector<End>, std::greater<>> ends;
  const auto expect = [&](std::size_t i) {
    if (domains_[i].lower.empty() || domains_[i].upper.empty()) return;
    const End end{ends_at(i, domains_[i].lower.back(), domains_[i].upper.back()), i, domains_[i].lower.back(),
                  domains_[i].upper.back()};
    if (end.psi < maps::infinity) ends.push(end);
  };
  for (std::size_t i = 1; i + 1 < n; ++i) expect(i);
  while (!ends.empty()) {
    const End end = ends.top();
    ends.pop();
    FlowWall& lower = walls_[end.lower];
    FlowWall& upper = walls_[end.upper];
    if (lower.to < maps::infinity || upper.to < maps::infinity) continue;  // one of them has met another wall before
    lower.to = upper.to = end.psi;
    const std::size_t before = lower.before.index();
    const std::size_t behind = upper.behind.index();
    const geom::Point place = geom::midpoint(lower.point(end.psi), upper.point(end.psi));
    merges_.push_back({place, DomainId(end.domain), end.psi});
    DOBRA_TRY_VOID(add_wall(before, behind, place, end.psi));
    expect(before);
    expect(behind);
  }
  return {};
}

const FlowWall* FlowDomains::wall_at(const std::vector<std::uint32_t>& side, double psi) const {
  const auto wall = std::partition_point(side.begin(), side.end(), [&](std::uint32_t w) { return walls_[w].to < psi; });
  return wall == side.end() ? nullptr : &walls_[*wall];
}

bool FlowDomains::contains(std::size_t domain, geom::Point p) const {
  const Domain& d = domains_[domain];
  const double psi = level(DomainId(domain), p);
  const double tolerance = 1e-13 * size_;
  if (psi < -tolerance) return false;
  const FlowWall* lower = wall_at(d.lower, psi);
  const FlowWall* upper = wall_at(d.upper, psi);
  if ((lower == nullptr && !d.lower.empty()) || (upper == nullptr && !d.upper.empty())) return false;
  if (lower != nullptr && geom::dot(p - lower->point(psi), d.along) < -tolerance) return false;
  return upper == nullptr || geom::dot(upper->point(psi) - p, d.along) >= -tolerance;
}

DomainId FlowDomains::domain_at(geom::Point p, DomainId hint) const {
  if (hint.valid() && contains(hint.index(), p)) return hint;
  if (const auto found = tree_.nearest(p, [&](std::size_t i) { return contains(i, p); })) {
    return DomainId(found->index);
  }
  return DomainId(tree_.nearest(p, [](std::size_t) { return true; })->index);
}

geom::Polyline FlowDomains::flow_line(double psi, double beyond) const {
  geom::Polyline line;
  std::size_t i = 0;
  const Domain& first = domains_.front();
  const auto on_level = [&](const Domain& d, double along) {
    return d.foot + along * d.along + (psi / d.speed) * d.out;
  };
  if (domains_.size() == 1) {
    line.points = {on_level(first, -beyond), on_level(first, first.length + beyond)};
    return line;
  }
  while (const FlowWall* wall = wall_at(domains_[i].upper, psi)) {
    const geom::Point at = wall->point(psi);
    if (line.points.empty()) line.points.push_back(at - beyond * first.along);
    line.points.push_back(at);
    i = wall->behind.index();
  }
  line.points.push_back(line.points.back() + beyond * domains_[i].along);
  return line;
}

}  // namespace recon::kinematics
