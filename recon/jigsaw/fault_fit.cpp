#include "recon/jigsaw/fault_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "shared/geom/place.h"

namespace recon::jigsaw {

namespace {

using kinematics::Side;

/// Of the section's size: heights that are less are rounding.
constexpr double no_height = 1e-9;
/// Of the size: how well the place of a wall is known at best.
constexpr double known_walls = 3e-4;

/// A wall of an unfolded block.
struct Wall {
  std::size_t fault = 0;
  std::size_t block = 0;
  Side side = Side::Left;
  std::vector<Branch> branches;
};

std::vector<Wall> unfolded_walls(const FaultSetting& setting, const std::vector<UnfoldedBlock>& blocks) {
  std::vector<Wall> walls;
  for (const faults::FaultWall& wall : setting.walls) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (blocks[b].id != wall.block) continue;
      geom::Polyline image = blocks[b].forward(wall.line);
      if (setting.target != nullptr) image = setting.target->clipped(image, blocks[b].side);
      if (image.points.size() < 2) continue;
      // What the noise of the picks turns is no turn.
      const double rough = 4.0 * blocks[b].noise + blocks[b].lean * image.box().height();
      walls.push_back({wall.fault, b, wall.side, branches_of(image, no_height * setting.size + rough)});
      // Rock beyond the top is younger than what is restored.
      if (setting.target != nullptr) continue;  // done
      const double datum = blocks[b].datum;
      const double far = std::numeric_limits<double>::infinity();
      const bool below = blocks[b].side == section::LayerSide::Below;
      for (Branch& branch : walls.back().branches)
        branch = below ? clipped(branch, -far, datum) : clipped(branch, datum, far);
      std::erase_if(walls.back().branches, [](const Branch& branch) { return branch.points.size() < 2; });
    }
  }
  return walls;
}

/// Whether they turn up and down in the same order.
bool alike(const Wall& left, const Wall& right) {
  return std::equal(left.branches.begin(), left.branches.end(), right.branches.begin(), right.branches.end(),
                    [](const Branch& a, const Branch& b) { return a.climbs == b.climbs; });
}

/// Whether their heights overlap at all.
bool beside(const Wall& left, const Wall& right, double least) {
  const auto heights = [](const Wall& wall) {
    std::pair range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Branch& branch : wall.branches) {
      range.first = std::min(range.first, branch.points.front().y);
      range.second = std::max(range.second, branch.points.back().y);
    }
    return range;
  };
  const auto a = heights(left);
  const auto b = heights(right);
  return std::min(a.second, b.second) - std::max(a.first, b.first) > least;
}

base::Error turned(const FaultSetting& setting, const std::vector<UnfoldedBlock>& blocks, const Wall& left,
                   const Wall& right) {
  const Wall& more = left.branches.size() > right.branches.size() ? left : right;
  const Branch& first = more.branches.front();
  const geom::Point turn = first.climbs ? first.points.back() : first.points.front();
  return {base::ErrorCode::CannotRestore,
          fmt::format("the restored wall of block '{}' turns up or down here, and the wall of block '{}' does not, so "
                      "that their distance is no function of z; simplify the fault, take another method or pin, or "
                      "split the fault there",
                      blocks[more.block].name, blocks[&more == &left ? right.block : left.block].name),
          place_at(turn, fmt::format("fault '{}'", setting.faults[left.fault].name))};
}

/// Of the cutoffs of the top at a fault, the ends of the unfolded top.
std::optional<std::pair<std::size_t, geom::Point>> end_of_top(const FaultSetting& setting, std::size_t fault, Side side,
                                                              const std::vector<UnfoldedBlock>& blocks,
                                                              const faults::Cutoff& cutoff) {
  std::optional<std::pair<std::size_t, geom::Point>> found;
  double nearest = 1e-6 * setting.size;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto bounds = [&](const faults::FaultWall& wall) {
      return wall.fault == fault && wall.side == side && wall.block == blocks[b].id;
    };
    if (std::none_of(setting.walls.begin(), setting.walls.end(), bounds)) continue;
    const unfold::Restoration& restoration = blocks[b].restoration;
    for (std::size_t i = 0; i < restoration.lines.size(); ++i) {
      if (restoration.section.horizons[i].id != blocks[b].top) continue;
      const maps::MappedLine& line = restoration.lines[i];
      for (const bool first : {true, false}) {
        const geom::Point before = first ? line.before.points.front() : line.before.points.back();
        if (geom::distance(before, cutoff.at) > nearest) continue;
        nearest = geom::distance(before, cutoff.at);
        found = {b, first ? line.after.points.front() : line.after.points.back()};
      }
    }
  }
  return found;
}

void join_up(std::vector<geom::Point> more, std::vector<geom::Point>& points) {
  for (const geom::Point p : more) {
    if (points.empty() || !(points.back() == p)) points.push_back(p);
  }
}

std::optional<double> heave_of_top(const FaultSetting& setting, std::size_t fault) {
  std::optional<double> heave;
  for (const faults::CutoffPair& pair : setting.cutoffs[fault].pairs) {
    if (pair.horizon == setting.top && pair.heave) heave = heave.value_or(0.0) + *pair.heave;
  }
  return heave;
}

/// Walls count the less the deeper they lie, as the noise of the picks of the top makes them lean.
Distance trusted_distance(const FacingWalls& f, const std::vector<UnfoldedBlock>& blocks, double size) {
  const UnfoldedBlock& left = blocks[f.left];
  const UnfoldedBlock& right = blocks[f.right];
  const double known = std::hypot(left.noise, right.noise, known_walls * size);
  return distance_of(f.walls, {left.datum, std::hypot(left.lean, right.lean) / known});
}

}  // namespace

base::Result<std::vector<FacingWalls>> facing_walls(const FaultSetting& setting,
                                                    const std::vector<UnfoldedBlock>& blocks) {
  const std::vector<Wall> walls = unfolded_walls(setting, blocks);
  const double least = no_height * setting.size;
  std::vector<FacingWalls> facing;
  for (const Wall& left : walls) {
    for (const Wall& right : walls) {
      if (left.fault != right.fault || left.side != Side::Left || right.side != Side::Right) continue;
      if (left.block == right.block || !beside(left, right, least)) continue;
      if (!alike(left, right)) return turned(setting, blocks, left, right);
      for (std::size_t k = 0; k < left.branches.size(); ++k) {
        WallPair pair = pair_of(left.branches[k], right.branches[k]);
        if (pair.height() > least) facing.push_back({left.fault, left.block, right.block, std::move(pair)});
      }
    }
  }
  return facing;
}

std::vector<Tie> ties_of_walls(const std::vector<FacingWalls>& facing, const std::vector<UnfoldedBlock>& blocks,
                               double size) {
  std::vector<Tie> ties;
  for (const FacingWalls& f : facing) {
    const Distance apart = trusted_distance(f, blocks, size);
    ties.push_back({f.left, f.right, apart.height / size, -apart.moment / apart.height, f.fault});
  }
  return ties;
}

std::vector<Tie> ties_of_top(const FaultSetting& setting, const std::vector<UnfoldedBlock>& blocks) {
  std::vector<Tie> ties;
  for (std::size_t fault = 0; fault < setting.cutoffs.size(); ++fault) {
    for (const faults::CutoffPair& pair : setting.cutoffs[fault].pairs) {
      if (pair.horizon != setting.top || !pair.hanging_wall || !pair.footwall) continue;
      const Side side = setting.faults[fault].path.hanging;
      const Side other = side == Side::Left ? Side::Right : Side::Left;
      const auto hanging = end_of_top(setting, fault, side, blocks, *pair.hanging_wall);
      const auto foot = end_of_top(setting, fault, other, blocks, *pair.footwall);
      if (!hanging || !foot || hanging->first == foot->first) continue;
      ties.push_back({hanging->first, foot->first, 1.0, hanging->second.x - foot->second.x, fault});
    }
  }
  return ties;
}

std::vector<RestoredFault> restored_faults(const FaultSetting& setting, const std::vector<FacingWalls>& facing) {
  std::vector<RestoredFault> made;
  for (std::size_t fault = 0; fault < setting.faults.size(); ++fault) {
    RestoredFault row;
    row.name = setting.faults[fault].name;
    if (const auto heave = heave_of_top(setting, fault)) row.shortening = 0.0 - *heave;
    std::vector<std::vector<geom::Point>> means;
    Distance apart;
    for (const FacingWalls& f : facing) {
      if (f.fault != fault) continue;
      row.measured = true;
      row.opening += opening_of(f.walls);
      apart += distance_of(f.walls, {});
      means.push_back(mean_of(f.walls));
    }
    if (row.measured) row.misfit = std::sqrt(apart.squared / apart.height);
    std::stable_sort(means.begin(), means.end(),
                     [](const auto& a, const auto& b) { return a.front().y < b.front().y; });
    for (std::vector<geom::Point>& mean : means) join_up(std::move(mean), row.line.points);
    if (row.line.points.size() > 1) {
      const geom::Vector chord = row.line.points.back() - row.line.points.front();
      row.dip = std::atan2(std::abs(chord.y), std::abs(chord.x)) * 180.0 / std::numbers::pi;
    }
    made.push_back(std::move(row));
  }
  return made;
}

void add_slide_errors(const std::vector<FacingWalls>& facing, const std::vector<UnfoldedBlock>& blocks, double size,
                      std::vector<RestoredFault>& faults) {
  for (std::size_t fault = 0; fault < faults.size(); ++fault) {
    Distance apart;
    for (const FacingWalls& f : facing) {
      if (f.fault == fault) apart += trusted_distance(f, blocks, size);
    }
    if (faults[fault].measured) faults[fault].slide_error = std::sqrt(apart.squared / apart.height);
  }
}

}  // namespace recon::jigsaw
