#pragma once
// Parameters of a restoration block by block. Page: docs/algorithms/jigsaw.md

#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/scenario/field.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::jigsaw {

/// How blocks slide together. Walls: the squared distance of the walls of every fault, over z, is least. Top: the ends
/// of the top meet.
enum class Fit { Walls, Top };
/// What holds the blocks of a jigsaw. Datum: each is unfolded to it, then they slide along it. Rotation: without a
/// datum, they stay rigid, turn and shift.
enum class Constraint { Datum, Rotation };

struct BlockwiseParams {
  std::vector<std::string> block;
  bool jigsaw = false;
  Constraint constraint = Constraint::Datum;
  std::optional<Fit> fit;
  std::string top;
  std::optional<double> pin;
  std::optional<double> elevation;
  std::vector<geom::Point> target;
  std::optional<geom::Point> target_pin;
  std::optional<double> simplify;
  std::optional<double> cutoff_tolerance;
  template <class D>
  static void describe(D& d) {
    d.field("block", &BlockwiseParams::block,
            {.title = "Blocks",
             .help = "Only these, or groups of them, are restored, each with a pin of its own; the rest stays.",
             .names = "block",
             .when = "jigsaw = false"});
    d.field("jigsaw", &BlockwiseParams::jigsaw,
            {.title = "Jigsaw", .help = "Every block is restored with a pin of its own, then they slide together."});
    d.choice("constraint", &BlockwiseParams::constraint, {"datum", "rotation"},
             {.title = "Constraint of the blocks",
              .help = "Of the jigsaw. datum: each block is unfolded to the datum, then they slide along it; rotation: "
                      "without a datum, rigid blocks turn and shift.",
              .when = "jigsaw = true"});
    d.choice(
        "fit", &BlockwiseParams::fit, {"walls", "top"},
        {.title = "Blocks fit by",
         .help = "Of the jigsaw. walls (the default): the walls of all faults lie as near to each other as can be; "
                 "top: the ends of the top meet.",
         .when = "jigsaw = true"});
    d.field("top", &BlockwiseParams::top,
            {.title = "Top horizon of the blocks",
             .help = "Restored to the datum in every block; by default the first. With block or jigsaw, which need no "
                     "steps grid and target.",
             .names = "horizon",
             .when = "jigsaw = true or block is set"});
    d.field(
        "pin", &BlockwiseParams::pin,
        {.title = "x of the pin",
         .help = "Of the block that it lies in, which stays where it is; by default the leftmost block, pinned near "
                 "its middle, as the others are.",
         .unit = "m",
         .names = "x",
         .when = "jigsaw = true or block is set"});
    d.field("elevation", &BlockwiseParams::elevation,
            {.title = "Elevation of the datum",
             .help = "By default that of the top at the pin.",
             .unit = "m",
             .names = "z",
             .when = "jigsaw = true and constraint = datum or block is set"});
    d.field("target", &BlockwiseParams::target,
            {.title = "Points of the target",
             .help = "Instead of a level datum: the line that the top of every block is restored to, such as a "
                     "regional dip or the topography.",
             .unit = "m",
             .when = "jigsaw = true and constraint = datum or block is set"});
    d.field("target_pin", &BlockwiseParams::target_pin,
            {.title = "Pin on the target",
             .help = "The point to which the pin goes; by default the one with the same x.",
             .unit = "m",
             .when = "target is set"});
    d.field("simplify", &BlockwiseParams::simplify,
            {.title = "Simplify the top",
             .help = "The top of every block with fewer points, nowhere farther from it than this.",
             .unit = "m",
             .at_least = 0.0,
             .when = "jigsaw = true and constraint = datum or block is set"});
    d.field("cutoff_tolerance", &BlockwiseParams::cutoff_tolerance,
            {.title = "Tolerance of cutoffs",
             .help = "How far ends of lines are taken to the faults; by default 0.005 of the section's diagonal.",
             .unit = "m",
             .above = 0.0,
             .when = "jigsaw = true or block is set"});
  }
};

inline bool is_rigid(const BlockwiseParams& params) { return params.constraint == Constraint::Rotation; }
/// Whether blocks are restored rather than the section as a whole.
inline bool is_blockwise(const BlockwiseParams& params) { return params.jigsaw || !params.block.empty(); }
/// @error BadValue: block and jigsaw together; what belongs to one of them without it.
base::Result<void> check_params(const BlockwiseParams& params);

}  // namespace recon::jigsaw
