#pragma once
// Blocks: what the faults and the border of a section part. Page: docs/algorithms/blocks.md

#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "recon/faults/fault.h"
#include "shared/base/id.h"

namespace recon::faults {

struct BlockTag {
  static constexpr const char* prefix = "block";
};
using BlockId = base::Id<BlockTag>;

struct Block {
  BlockId id;  ///< From the left; = its place in Blocks::all().
  std::string name;
  double area = 0.0;                     ///< m2
  std::vector<std::string> faults;       ///< That part it from other blocks.
  geom::Point inside;                    ///< A point of it.
  std::vector<geom::Polyline> contours;  ///< Anticlockwise, holes clockwise.
  std::string part_of;                   ///< Its group; empty: none.
};

/// What a block shows of a fault that parts it from others: along the fault from its lower end, as far as the rock of
/// the block reaches.
struct FaultWall {
  std::size_t fault = 0;                           ///< In the order of the faults.
  kinematics::Side side = kinematics::Side::Left;  ///< Of travel, where the block lies.
  BlockId block;
  geom::Polyline line;
};

/// The faults and the outline as a subdivision (blocks.cpp).
struct BlockDrawing;

class Blocks {
 public:
  /// Faults that leave the section go on straight; those that end within the tolerance of another one end on it.
  /// @error those of Arrangement; BadSection: a block's point on a fault or outside the rock, two names in one block.
  /// @cost  O(n log n) for n points of the faults and of the section's outline.
  static base::Result<Blocks> make(const section::Section& section, const std::vector<Fault>& faults,
                                   const FaultOptions& options);

  [[nodiscard]] const std::vector<Block>& all() const { return blocks_; }
  /// None on a fault; exact. Beyond the rock's outline the block that reaches there between the faults as they go on.
  /// @cost O(log n)
  [[nodiscard]] BlockId at(geom::Point p) const;
  /// All blocks on the hanging-wall side that are reached without crossing the fault's path; other faults are crossed.
  /// @error BadSection: nothing tells the hanging wall; the fault parts nothing, with the place where it ends in rock.
  [[nodiscard]] base::Result<std::vector<BlockId>> hanging_wall(const Fault& fault) const;
  /// Of all faults, those of the left side first.
  [[nodiscard]] std::vector<FaultWall> walls() const;
  /// What was guessed of the outline, and pieces of beds that have rock on neither side: what encloses it is open, so
  /// that a block lacks it or is missing. With places. @cost O(pieces x points of the outline)
  [[nodiscard]] std::vector<std::string> remarks_on_beds(const section::Section& section) const;
  /// Blocks, and all blocks of groups.  @error BadSection: no block or group is called so.
  [[nodiscard]] base::Result<std::vector<BlockId>> named(std::span<const std::string> names) const;

 private:
  /// Adds what is reached from the blocks without crossing the fault or what its path goes on along.
  void spread(const Fault& fault, std::size_t number, std::set<BlockId>& reached) const;

  std::vector<Block> blocks_;
  std::shared_ptr<const BlockDrawing> drawing_;
};

}  // namespace recon::faults
