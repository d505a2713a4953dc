#include "recon/jigsaw/rigid_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "shared/base/disjoint_sets.h"

namespace recon::jigsaw {

namespace {

using kinematics::FaultPath;

/// Of the size: matches that lie no wider apart say nothing of a turn.
constexpr double one_place = 1e-6;
/// Against the walls' own weight: so that the ends of the top meet.
constexpr double top_weight = 1e6;
constexpr int most_steps = 50;

/// A place on the path that both walls had, by arc length in each. m
struct Node {
  double hanging = 0.0, foot = 0.0;
};

/// What a block shows of a fault: from arc to arc.
struct Reach {
  std::size_t block = 0;
  double from = 0.0, to = 0.0;
  [[nodiscard]] bool holds(double arc, double near) const { return arc >= from - near && arc <= to + near; }
};

std::vector<Reach> reaches_of(const FaultSetting& setting, std::size_t fault, kinematics::Side side,
                              const std::vector<UnfoldedBlock>& blocks) {
  std::vector<Reach> reaches;
  for (const faults::FaultWall& wall : setting.walls) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (wall.fault != fault || wall.side != side || wall.block != blocks[b].id) continue;
      const FaultPath& path = setting.faults[fault].path;
      const double first = nearest(path, wall.line.points.front()).arc;
      const double last = nearest(path, wall.line.points.back()).arc;
      reaches.push_back({b, std::min(first, last), std::max(first, last)});
    }
  }
  return reaches;
}

bool is_growth(const UnfoldedBlock& block, section::HorizonId piece) {
  const section::Horizon* bed = find_horizon(block.restoration.section, piece);
  return bed != nullptr && bed->role == section::BedRole::Growth;
}

/// The cutoffs that two blocks share, upwards, and as far as both walls reach beyond them.
std::vector<Node> nodes_of(const FaultSetting& setting, std::size_t fault, const Reach& hanging, const Reach& foot,
                           const std::vector<UnfoldedBlock>& blocks, Fit fit) {
  const double near = one_place * setting.size;
  std::vector<Node> nodes;
  for (const faults::CutoffPair& pair : setting.cutoffs[fault].pairs) {
    if (!pair.hanging_wall || !pair.footwall || (fit == Fit::Top && pair.horizon != setting.top)) continue;
    if (!hanging.holds(pair.hanging_wall->arc, near) || !foot.holds(pair.footwall->arc, near)) continue;
    if (is_growth(blocks[hanging.block], pair.hanging_wall->piece)) continue;
    nodes.push_back({pair.hanging_wall->arc, pair.footwall->arc});
  }
  std::stable_sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.hanging < b.hanging; });
  std::vector<Node> rising;
  for (const Node& node : nodes) {
    if (rising.empty() || (node.hanging > rising.back().hanging && node.foot > rising.back().foot))
      rising.push_back(node);
  }
  if (rising.empty()) return rising;
  const double below = std::min(rising.front().hanging - hanging.from, rising.front().foot - foot.from);
  const double above = std::min(hanging.to - rising.back().hanging, foot.to - rising.back().foot);
  if (below > near) rising.insert(rising.begin(), {rising.front().hanging - below, rising.front().foot - below});
  if (above > near) rising.push_back({rising.back().hanging + above, rising.back().foot + above});
  return rising;
}

/// Parts of the way between two nodes at which neither wall bends.
std::vector<double> straight_parts(const std::vector<double>& arcs, const Node& from, const Node& to) {
  std::vector<double> parts{0.0, 1.0};
  for (const double Node::*wall : {&Node::hanging, &Node::foot}) {
    for (const double arc : arcs) {
      if (arc > from.*wall && arc < to.*wall) parts.push_back((arc - from.*wall) / (to.*wall - from.*wall));
    }
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// Simpson's rule, which is exact for the square of what is linear.
void match_stretch(const FaultPath& path, const std::vector<double>& arcs, const Node& from, const Node& to,
                   const Match& like, std::vector<Match>& matches) {
  const double length = 0.5 * ((to.hanging - from.hanging) + (to.foot - from.foot));
  const std::vector<double> parts = straight_parts(arcs, from, to);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const double low = parts[i], high = parts[i + 1];
    if (high <= low) continue;
    for (const auto& [part, weight] : {std::pair(low, 1.0 / 6.0), {0.5 * (low + high), 4.0 / 6.0}, {high, 1.0 / 6.0}}) {
      Match match = like;
      match.at_left = point_at(path, from.hanging + part * (to.hanging - from.hanging));
      match.at_right = point_at(path, from.foot + part * (to.foot - from.foot));
      match.weight = weight * (high - low) * length;
      matches.push_back(match);
    }
  }
}

}  // namespace

std::vector<Match> matches_of(const FaultSetting& setting, const std::vector<UnfoldedBlock>& blocks, Fit fit) {
  std::vector<Match> matches;
  for (std::size_t fault = 0; fault < setting.faults.size(); ++fault) {
    const FaultPath& path = setting.faults[fault].path;
    const std::vector<double> arcs = geom::arc_lengths(path.line);
    const kinematics::Side side = path.hanging;
    const kinematics::Side other = side == kinematics::Side::Left ? kinematics::Side::Right : kinematics::Side::Left;
    for (const Reach& hanging : reaches_of(setting, fault, side, blocks)) {
      for (const Reach& foot : reaches_of(setting, fault, other, blocks)) {
        if (hanging.block == foot.block) continue;
        const std::vector<Node> nodes = nodes_of(setting, fault, hanging, foot, blocks, fit);
        const Match like{hanging.block, foot.block, {}, {}, 1.0};
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
          match_stretch(path, arcs, nodes[i], nodes[i + 1], like, matches);
        if (fit == Fit::Walls) continue;
        for (const faults::CutoffPair& pair : setting.cutoffs[fault].pairs) {
          if (pair.horizon != setting.top || !pair.hanging_wall || !pair.footwall) continue;
          const double near = one_place * setting.size;
          if (!hanging.holds(pair.hanging_wall->arc, near) || !foot.holds(pair.footwall->arc, near)) continue;
          matches.push_back(
              {hanging.block, foot.block, pair.hanging_wall->at, pair.footwall->at, top_weight * setting.size});
        }
      }
    }
  }
  return matches;
}

namespace {

geom::Vector quarter_turn(geom::Vector v) { return {-v.y, v.x}; }

/// Of several places of one block that are to come to others: the motion of least squares.
class Procrustes {
 public:
  void add(geom::Point from, geom::Point to, double weight) {
    from_.push_back(from);
    to_.push_back(to);
    weights_.push_back(weight);
  }
  /// How far the places stand apart, root mean square, m.
  [[nodiscard]] double spread() const {
    const geom::Point centre = centre_of(from_);
    double sum = 0.0, all = 0.0;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      sum += weights_[i] * geom::dot(from_[i] - centre, from_[i] - centre);
      all += weights_[i];
    }
    return all > 0.0 ? std::sqrt(sum / all) : 0.0;
  }
  [[nodiscard]] RigidMotion motion() const {
    const geom::Point a = centre_of(from_), b = centre_of(to_);
    double along = 0.0, across = 0.0;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      along += weights_[i] * geom::dot(from_[i] - a, to_[i] - b);
      across += weights_[i] * geom::cross(from_[i] - a, to_[i] - b);
    }
    return {std::atan2(across, along), a, b - a};
  }

 private:
  [[nodiscard]] geom::Point centre_of(const std::vector<geom::Point>& points) const {
    geom::Vector sum;
    double all = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      sum = sum + weights_[i] * (points[i] - points.front());
      all += weights_[i];
    }
    return points.front() + (1.0 / all) * sum;
  }

  std::vector<geom::Point> from_, to_;
  std::vector<double> weights_;
};

/// Joins blocks whose matches lie wide enough apart to say how they are turned.
base::Result<void> refuse_loose(const std::vector<std::string>& names, std::size_t pinned,
                                const std::vector<Match>& matches, double size) {
  std::map<std::pair<std::size_t, std::size_t>, Procrustes> joints;
  for (const Match& m : matches) joints[std::minmax(m.left, m.right)].add(m.at_left, m.at_right, m.weight);
  base::DisjointSets sets(names.size());
  for (const auto& [blocks, joint] : joints) {
    // The points of both sides stand for each other here.
    if (joint.spread() > one_place * size) sets.join(blocks.first, blocks.second);
  }
  std::vector<std::string> loose;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (sets.root(i) != sets.root(pinned)) loose.push_back(fmt::format("'{}'", names[i]));
  }
  if (loose.empty()) return {};
  return base::Error{base::ErrorCode::CannotRestore,
                     fmt::format("no fault with cutoffs of one bed on both its walls joins {} to '{}', which is "
                                 "pinned, so that nothing says how to turn and shift; extend the beds to the faults "
                                 "between them, or take fit = \"walls\", which asks all beds",
                                 fmt::join(loose, ", "), names[pinned]),
                     base::Place{.item = "blocks"}};
}

/// Block by block from the pinned one outwards.
std::vector<RigidMotion> first_motions(std::size_t count, std::size_t pinned, const std::vector<Match>& matches,
                                       double size) {
  std::vector<std::optional<RigidMotion>> motions(count);
  motions[pinned] = RigidMotion{};
  for (bool placed = true; std::exchange(placed, false);) {
    std::map<std::size_t, Procrustes> next;
    for (const Match& m : matches) {
      if (motions[m.left] && !motions[m.right])
        next[m.right].add(m.at_right, motions[m.left]->forward(m.at_left), m.weight);
      if (motions[m.right] && !motions[m.left])
        next[m.left].add(m.at_left, motions[m.right]->forward(m.at_right), m.weight);
    }
    for (const auto& [block, joint] : next) {
      if (joint.spread() <= one_place * size) continue;
      motions[block] = joint.motion();
      placed = true;
    }
  }
  std::vector<RigidMotion> made;
  for (const auto& motion : motions) made.push_back(motion.value_or(RigidMotion{}));
  return made;
}

double sum_of_squares(const std::vector<RigidMotion>& motions, const std::vector<Match>& matches) {
  double sum = 0.0;
  for (const Match& m : matches) {
    const geom::Vector apart = motions[m.left].forward(m.at_left) - motions[m.right].forward(m.at_right);
    sum += m.weight * geom::dot(apart, apart);
  }
  return sum;
}

/// A step of Gauss and Newton: for every block but the pinned one its turn times the size, and its shift.
std::vector<double> step_of(const std::vector<RigidMotion>& motions, std::size_t pinned,
                            const std::vector<Match>& matches, double size) {
  const std::size_t n = 3 * (motions.size() - 1);
  std::vector<std::vector<double>> a(n, std::vector<double>(n, 0.0));
  std::vector<double> b(n, 0.0);
  struct Column {
    std::size_t row;
    geom::Vector change;  ///< Of the distance, by that unknown.
  };
  for (const Match& m : matches) {
    const geom::Vector apart = motions[m.left].forward(m.at_left) - motions[m.right].forward(m.at_right);
    std::vector<Column> columns;
    for (const auto& [block, at, sign] : {std::tuple(m.left, m.at_left, 1.0), std::tuple(m.right, m.at_right, -1.0)}) {
      if (block == pinned) continue;
      const std::size_t row = 3 * (block < pinned ? block : block - 1);
      const RigidMotion& motion = motions[block];
      columns.push_back({row, sign / size * quarter_turn(motion.turned(at - motion.about))});
      columns.push_back({row + 1, {sign, 0.0}});
      columns.push_back({row + 2, {0.0, sign}});
    }
    for (const Column& one : columns) {
      b[one.row] -= m.weight * geom::dot(one.change, apart);
      for (const Column& other : columns) a[one.row][other.row] += m.weight * geom::dot(one.change, other.change);
    }
  }
  return solve_positive(std::move(a), std::move(b));
}

}  // namespace

base::Result<std::vector<RigidMotion>> turn_and_shift(const std::vector<std::string>& names, std::size_t pinned,
                                                      const std::vector<Match>& matches, double size) {
  DOBRA_TRY_VOID(refuse_loose(names, pinned, matches, size));
  std::vector<RigidMotion> motions = first_motions(names.size(), pinned, matches, size);
  double least = sum_of_squares(motions, matches);
  const auto moved = [&](const std::vector<double>& step, double part) {
    std::vector<RigidMotion> next = motions;
    for (std::size_t block = 0; block < next.size(); ++block) {
      if (block == pinned) continue;
      const std::size_t row = 3 * (block < pinned ? block : block - 1);
      next[block].turn += part * step[row] / size;
      next[block].by = next[block].by + part * geom::Vector{step[row + 1], step[row + 2]};
    }
    return next;
  };
  for (int k = 0; k < most_steps && names.size() > 1; ++k) {
    const std::vector<double> step = step_of(motions, pinned, matches, size);
    double part = 1.0;
    std::vector<RigidMotion> next = moved(step, part);
    for (int half = 0; half < 30 && !(sum_of_squares(next, matches) < least); ++half) next = moved(step, part *= 0.5);
    const double sum = sum_of_squares(next, matches);
    if (!(sum < least)) break;
    least = sum;
    motions = std::move(next);
  }
  return motions;
}

}  // namespace recon::jigsaw
