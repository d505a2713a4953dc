#include "recon/faults/between.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/intersect.h"

namespace recon::faults {

namespace {

using kinematics::Wall;
using section::LineEnd;

/// Of the section's diagonal: 0.1 mm on a sheet a metre wide.
constexpr double drawing_accuracy = 1e-4;
/// Of the distance between the ends: what picks that stop short of a fault leave open along it.
constexpr double share_of_gap = 0.05;
/// Of the distance to the next bed along the fault: the largest misfit of a move that joins beds all the same.
constexpr double share_of_spacing = 0.1;

/// From the end inwards.
std::vector<geom::Point> inwards(const PieceEnd& end) {
  std::vector<geom::Point> points = end.piece.line.points;
  if (end.end == LineEnd::Last) std::reverse(points.begin(), points.end());
  return points;
}

/// Where a straight line meets the fault first.
std::optional<geom::Point> first_meeting(const geom::Segment& segment, const geom::Polyline& fault) {
  std::optional<geom::Point> first;
  for (std::size_t i = 0; i < fault.segment_count(); ++i) {
    const geom::Intersection hit = geom::intersect(segment, fault.segment(i));
    if (hit.kind == geom::IntersectionKind::None) continue;
    if (!first || geom::distance(segment.from, hit.start.point) < geom::distance(segment.from, *first))
      first = hit.start.point;
  }
  return first;
}

/// A move back leaves the bed that it closes without a separation, and of several closed together some on either side.
bool is_taken_back(const FaultCutoffs& cutoffs, double none) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const CutoffPair& pair : cutoffs.pairs) {
    if (!pair.separation || pair.hanging_wall->passes) continue;
    least = std::min(least, *pair.separation);
    greatest = std::max(greatest, *pair.separation);
  }
  return least <= none && greatest >= -none;
}

}  // namespace

geom::Point PieceEnd::at() const {
  return end == LineEnd::First ? piece.line.points.front() : piece.line.points.back();
}

base::Result<FaultsBetween> FaultsBetween::make(const section::Section& section) {
  FaultsBetween between;
  const double size = box_of(section).diagonal();
  between.drawn_ = drawing_accuracy * size;
  between.rounding_ = 1e-9 * size;
  DOBRA_TRY(between.faults_, faults_of(section, {}));
  for (Fault& fault : between.faults_) fault.undecided.reset();  // opposite walls are all that counts here
  const std::vector<FaultCutoffs> cutoffs = cutoffs_of(section, between.faults_, {});
  for (std::size_t i = 0; i < between.faults_.size(); ++i) {
    OneFault& one = between.at_.emplace_back();
    one.fault = &between.faults_[i];
    one.own = own_line(*one.fault);
    one.taken_back = is_taken_back(cutoffs[i], between.drawn_);
    for (const CutoffPair& pair : cutoffs[i].pairs) {
      for (const auto& [cutoff, wall] : {std::pair(&pair.hanging_wall, Wall::Hanging), {&pair.footwall, Wall::Foot}}) {
        if (*cutoff && !(*cutoff)->passes)
          one.ends[{(*cutoff)->piece, (*cutoff)->end}] = {wall, (*cutoff)->arc, pair.horizon};
      }
    }
  }
  return between;
}

/// Its cutoff, or where it would be if the piece went on straight.
std::optional<FaultsBetween::AtFault> FaultsBetween::end_at(const OneFault& one, const PieceEnd& end,
                                                            double reach) const {
  const auto known = one.ends.find({end.piece.id, end.end});
  if (known != one.ends.end()) return known->second;
  const std::vector<geom::Point> points = inwards(end);
  const auto off = std::find_if(points.begin(), points.end(), [&](geom::Point p) {
    return std::abs(kinematics::nearest(one.fault->path, p).distance) > rounding_;
  });
  if (off == points.end()) return std::nullopt;
  const auto wall = kinematics::wall_of(one.fault->path, *off);
  if (!wall) return std::nullopt;
  const geom::Vector way = geom::normalised(points[0] - points[1]);
  const geom::Point met = first_meeting({points[0], points[0] + reach * way}, one.own).value_or(points[0]);
  return AtFault{*wall, kinematics::nearest(one.fault->path, met).arc, whole_name(end.piece)};
}

double FaultsBetween::spacing(const OneFault& one, const AtFault& at) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [key, other] : one.ends) {
    if (other.horizon != at.horizon && other.wall == at.wall) least = std::min(least, std::abs(other.arc - at.arc));
  }
  return least;
}

std::optional<FaultBetween> FaultsBetween::of(const PieceEnd& a, const PieceEnd& b) const {
  const double gap = geom::distance(a.at(), b.at());
  std::optional<FaultBetween> found;
  for (const OneFault& one : at_) {
    const bool cut_off = one.ends.contains({a.piece.id, a.end}) || one.ends.contains({b.piece.id, b.end});
    if (!cut_off && !first_meeting({a.at(), b.at()}, one.own)) continue;
    const auto at_a = end_at(one, a, 2.0 * gap);
    const auto at_b = end_at(one, b, 2.0 * gap);
    if (!at_a || !at_b || at_a->wall == at_b->wall) continue;
    const double separation = std::abs(at_a->arc - at_b->arc);
    const double misfit = one.taken_back ? share_of_spacing * std::min(spacing(one, *at_a), spacing(one, *at_b)) : 0.0;
    const bool coincide = separation <= std::max({drawn_, share_of_gap * gap, misfit});
    if (!found || !coincide) found = {one.fault->name, separation, !coincide};
    if (!coincide) break;
  }
  return found;
}

}  // namespace recon::faults
