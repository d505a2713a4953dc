#include "recon/kinematics/propagation_fold.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "recon/kinematics/refuse.h"
#include "recon/maps/columns.h"

namespace recon::kinematics {

namespace {

using std::numbers::pi;

geom::Vector direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Static rock in front, over the flat, over the ramp, and over the front limb above and below the branch point e.
enum class Part { Still, Flat, Ramp, Front, Limb };

/// A wall through velocity * slip along `run`. Both vectors in the frame of the fold (x along the flat, the bend at 0).
struct FoldWall {
  Part left, right;  ///< Left of `run`.
  geom::Vector velocity;
  geom::Vector run;
  double reach = maps::infinity;  ///< Along `run`, a metre of slip.
};

/// The pattern of velocities: similar to itself, its size grows with the slip t since the tip was at the bend.
struct FoldPattern {
  explicit FoldPattern(const PropagationAngles& a) : theta(a.theta.radians()), tip(a.propagation * direction(theta)) {
    const double kappa = pi - a.beta_2.radians() + theta;
    const double reach = a.propagation * std::sin(theta) / std::sin(2.0 * a.gamma_star.radians());
    branch = tip + reach * direction(kappa);
    const geom::Vector back = direction(pi - a.gamma_1.radians());
    const geom::Vector front = direction(a.gamma.radians());
    velocity = {geom::Vector{}, {1.0, 0.0}, direction(theta), a.r1 * front, a.r2 * front};
    walls = {FoldWall{Part::Flat, Part::Ramp, {}, back}, FoldWall{Part::Ramp, Part::Limb, tip, direction(kappa), reach},
             FoldWall{Part::Ramp, Part::Front, branch, back}, FoldWall{Part::Front, Part::Limb, branch, front},
             FoldWall{Part::Limb, Part::Still, tip, front}};
  }

  [[nodiscard]] Part part_at(geom::Vector p, double t) const {
    const auto left_of_wall = [&](const FoldWall& wall) { return geom::cross(wall.run, p - t * wall.velocity) > 0.0; };
    if (left_of_wall(walls[0])) return Part::Flat;
    if (!left_of_wall(walls[4])) return Part::Still;
    if (p.y < t * branch.y) return left_of_wall(walls[1]) ? Part::Ramp : Part::Limb;
    if (left_of_wall(walls[2])) return Part::Ramp;
    return left_of_wall(walls[3]) ? Part::Front : Part::Limb;
  }
  [[nodiscard]] geom::Vector velocity_of(Part part) const { return velocity[static_cast<std::size_t>(part)]; }

  double theta;
  geom::Vector tip;     ///< A metre of slip.
  geom::Vector branch;  ///< e, where the axial planes of the front meet, likewise.
  std::array<geom::Vector, 5> velocity;
  std::array<FoldWall, 5> walls;
};

/// A point on its way through the pattern while t goes from one value to another.
class Ride {
 public:
  Ride(const FoldPattern& fold, geom::Vector v, LinearPoint at, double from, double to, double size, AffinePiece& here)
      : fold_(fold), v_(v), at_(at), time_{0.0, 0.0, from}, to_(to), tolerance_(1e-12 * size), here_(here) {
    part_ = fold.part_at({at_.x(v), at_.y(v)}, from);
    for (const FoldWall& wall : fold.walls) here.sides.push_back(beside(wall, from * wall.velocity));
    const int most_legs = 8;
    const FoldWall* last = nullptr;
    for (int leg = 0; leg < most_legs; ++leg) {
      last = cross_wall(last);
      if (last == nullptr) break;
    }
    const geom::Vector flow = fold.velocity_of(part_);
    const LinearForm rest = LinearForm{0.0, 0.0, to} - time_;
    at_ = {at_.x + flow.x * rest, at_.y + flow.y * rest};
  }
  [[nodiscard]] const LinearPoint& at() const { return at_; }

 private:
  [[nodiscard]] LinearForm beside(const FoldWall& wall, geom::Vector foot) const {
    return wall.run.x * (at_.y + -foot.y) - wall.run.y * (at_.x + -foot.x);
  }

  /// Goes to the next wall, if it comes before the end of time, and past it.  @return that wall
  const FoldWall* cross_wall(const FoldWall* last) {
    const geom::Vector flow = fold_.velocity_of(part_);
    const bool up = to_ > time_(v_);
    // Where the point would have been at t = 0.
    const LinearPoint origin{at_.x - flow.x * time_, at_.y - flow.y * time_};
    for (const geom::Vector corner : {geom::Vector{}, fold_.tip, fold_.branch}) {
      const geom::Vector way = flow - corner;
      here_.sides.push_back(way.y * origin.x - way.x * origin.y);
    }
    const FoldWall* next = nullptr;
    LinearForm at_next;
    for (const FoldWall& wall : fold_.walls) {
      if (&wall == last || (wall.left != part_ && wall.right != part_)) continue;
      const double rate = geom::cross(wall.velocity - flow, wall.run);
      // A point only leaves its part: rate > 0 takes it to the left of the wall.
      if (std::abs(rate) < 1e-14 || ((rate > 0.0) == up) != (wall.right == part_)) continue;
      const LinearForm meets = (1.0 / rate) * (wall.run.y * origin.x - wall.run.x * origin.y);
      here_.sides.push_back(meets + -to_);
      const double t = meets(v_);
      if (up ? (t < time_(v_) - tolerance_ || t >= to_) : (t > time_(v_) + tolerance_ || t <= to_)) continue;
      const geom::Vector there = geom::Vector{origin.x(v_), origin.y(v_)} + t * (flow - wall.velocity);
      const double along = geom::dot(there, wall.run);
      if (along < -tolerance_ || along > wall.reach * t + tolerance_) continue;
      if (next != nullptr && (up ? t >= at_next(v_) : t <= at_next(v_))) continue;
      next = &wall;
      at_next = meets;
    }
    if (next == nullptr) return nullptr;
    const LinearForm gone = at_next - time_;
    at_ = {at_.x + flow.x * gone, at_.y + flow.y * gone};
    time_ = at_next;
    part_ = next->left == part_ ? next->right : next->left;
    return next;
  }

  const FoldPattern& fold_;
  geom::Vector v_;
  LinearPoint at_;
  LinearForm time_;
  double to_;
  double tolerance_;
  AffinePiece& here_;
  Part part_ = Part::Still;
};

}  // namespace

base::Result<PropagationAngles> propagation_angles(base::Angle angle) {
  const double theta = angle.radians();
  if (!(theta > 0.0) || angle.degrees() >= 60.0 - 1e-9) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("a parallel fault-propagation fold has ramps of 0 to 60 degrees, not of {:.2f}; take "
                    "trishear",
                    angle.degrees())};
  }
  const double t = std::tan(0.5 * theta);
  const double gamma_star = std::atan(3.0 * t);
  const double gamma_1 = 0.5 * (pi - theta);
  const double gamma = 0.5 * pi + gamma_star - gamma_1;
  const double beta_2 = pi - 2.0 * gamma_star;
  return PropagationAngles{angle,
                           base::Angle::from_radians(gamma_star),
                           base::Angle::from_radians(gamma_1),
                           base::Angle::from_radians(gamma),
                           base::Angle::from_radians(beta_2),
                           (3.0 + 3.0 * t * t) / (2.0 - 6.0 * t * t),
                           std::sin(gamma_1 + theta) / std::sin(gamma_1 + gamma),
                           std::sin(beta_2) / std::sin(beta_2 - theta + gamma)};
}

base::Result<PropagationMap> PropagationMap::make(const FaultPath& path, std::optional<base::Angle> ramp, double from,
                                                  double to) {
  const std::size_t segments = path.line.segment_count();
  const geom::Point bend = segments == 1 ? path.line.points.back() : path.line.points[1];
  if (from < 0.0 || to < 0.0) {
    return refused(
        "a fault-propagation fold grows by slip up the fault, and restores no more than it has grown; for "
        "extension take shear, fault_parallel_flow or trishear",
        bend);
  }
  if (segments > 2) {
    return refused(fmt::format("a parallel fault-propagation fold stands on one flat and one ramp; this fault has {} "
                               "bends; take trishear",
                               segments - 1),
                   path.line.points[2]);
  }
  if (segments == 1 && !ramp) {
    return refused("the fault has no ramp behind its flat; give the angle of one (ramp), or draw it", bend);
  }
  PropagationMap map;
  map.bend_ = bend;
  map.along_ = geom::normalised(path.line.segment(0).vector());
  map.out_ = path.hanging == Side::Left ? geom::left_of(map.along_) : geom::right_of(map.along_);
  double theta = ramp ? ramp->radians() : 0.0;
  if (segments == 2) {
    const geom::Vector up = path.line.segment(1).vector();
    theta = std::atan2(geom::dot(up, map.out_), geom::dot(up, map.along_));
  }
  auto angles = propagation_angles(base::Angle::from_radians(theta));
  if (!angles) return refused(angles.error().message, bend);
  map.angles_ = *angles;
  map.from_ = from;
  map.to_ = to;
  map.size_ = path.line.box().diagonal();
  return map;
}

PropagationMap PropagationMap::swapped() const {
  PropagationMap back = *this;
  std::swap(back.from_, back.to_);
  return back;
}

Tip PropagationMap::tip() const {
  const geom::Vector up = direction(angles_.theta.radians());
  const geom::Vector unit = up.x * along_ + up.y * out_;
  const double ratio = angles_.propagation;
  return {bend_ + ratio * from_ * unit, bend_ + ratio * to_ * unit};
}

void PropagationMap::piece(geom::Point p, Wall on_fault, AffinePiece& here) const {
  here.origin = bend_;
  here.image = {};
  here.sides.clear();
  const geom::Vector v = p - bend_;
  const geom::Vector up = direction(angles_.theta.radians());
  LinearPoint at{here.image.along(along_), here.image.along(out_)};
  const LinearForm over_flat = at.y;
  const LinearForm over_ramp = up.x * at.y - up.y * at.x;
  here.sides.insert(here.sides.end(), {over_flat, over_ramp});
  const double nudge = 1e-11 * size_;
  const double height = std::min(over_flat(v), over_ramp(v));
  if (height < -nudge || (height <= nudge && on_fault == Wall::Foot)) return;
  // What lies on the fault goes just above it.
  const double lift = height <= nudge ? nudge - height : 0.0;
  at.y = at.y + lift;
  const FoldPattern fold(angles_);
  const LinearPoint end = Ride(fold, v, at, from_, to_, size_, here).at();
  const LinearForm x = end.x;
  const LinearForm y = end.y + -lift;
  here.image = {along_.x * x + out_.x * y, along_.y * x + out_.y * y};
}

}  // namespace recon::kinematics
