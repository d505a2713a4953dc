#pragma once
// One block of a section restored by itself. Page: docs/algorithms/jigsaw.md

#include "recon/jigsaw/blockwise_params.h"
#include "recon/jigsaw/cut_section.h"
#include "recon/jigsaw/rigid_motion.h"
#include "recon/jigsaw/target_line.h"
#include "recon/unfold/restore.h"

namespace recon::jigsaw {

struct UnfoldedBlock {
  std::size_t part = 0;  ///< Among the blocks that the section is cut into.
  faults::BlockId id;
  std::string name;
  std::vector<std::size_t> horizons;  ///< Of the cut section, in the order of restoration.lines.
  section::HorizonId top;             ///< Of the cut section.
  section::LayerSide side = section::LayerSide::Below;
  geom::Point pin;                  ///< On the top, before.
  double datum = 0.0;               ///< z; of a rigid block infinite, above all of it.
  double noise = 0.0;               ///< Of the picks of its top, one standard deviation, m.
  double lean = 0.0;                ///< By how much that makes its walls lean, radians.
  double slid = 0.0;                ///< Along the datum or the target, m.
  RigidMotion placed;               ///< What the block does afterwards: it slides, or a rigid one turns and shifts.
  unfold::Restoration restoration;  ///< Of the block's own section, with the ids of the cut section.

  /// Where a point of the block goes, and where one of it comes from.
  [[nodiscard]] geom::Point forward(geom::Point p) const;
  [[nodiscard]] geom::Point inverse(geom::Point p) const;
  [[nodiscard]] geom::Polyline forward(const geom::Polyline& line) const;
  /// The whole line through the map of the block, wherever it lies.
  [[nodiscard]] geom::Polyline inverse(const geom::Polyline& line) const;
};

/// What the block's own section is made of.
struct BlockSection {
  section::Section section;
  std::vector<std::size_t> horizons;  ///< Indices in the cut section.
};
BlockSection section_of(const CutSection& cut, std::size_t part);

struct PlaceOfBlock {
  std::size_t top = 0;                 ///< Index in the cut section.
  std::optional<double> pin;           ///< x; by default the place nearest to the middle of the top where all beds are.
  std::optional<double> datum;         ///< z; by default that of the top at the pin.
  const TargetLine* target = nullptr;  ///< Instead of a level datum.
  std::optional<geom::Point> target_pin;  ///< On it; by default the point above or below the pin.
  double simplify = 0.0;
};

/// A block that stays as it is, to be turned and shifted.
/// @param bed  of the block, index in the cut section; measured as its top.
/// @error Cancelled; errors of the mesher for a polygon.
base::Result<UnfoldedBlock> rigid_block(const CutSection& cut, const Part& part, std::size_t index, std::size_t bed,
                                        const unfold::RestoreParams& params);

/// @error those of make_base(), place_target() and restore(), with the name of the block.
base::Result<UnfoldedBlock> unfold_block(const CutSection& cut, const Part& part, std::size_t index,
                                         const PlaceOfBlock& place, const unfold::RestoreParams& params,
                                         const base::Progress& progress);

}  // namespace recon::jigsaw
