#pragma once
// Offset curves in pictures: coloured by distance, over the curves that they are parallel to; and the construction of
// one, where it stands.

#include <string>
#include <vector>

#include "shared/operations/offset_curves.h"
#include "shared/operations/offset_stages.h"
#include "shared/scene/layer.h"

namespace dobra::operations {

struct OffsetNaming {
  std::string prefix = "offset";  ///< Of the keys of the layers.
  double unit = 1.0;              ///< Of the distances in their titles, m,
  std::string unit_name = {};     ///< and how it is called; empty: not at all.
};

/// What becomes of a distance at which nothing remains.
enum class Nothing { Told, LeftOut };

/// A layer a distance, by which it is coloured.
std::vector<scene::Layer> offset_layers(const std::vector<OffsetFamily>& families, const OffsetNaming& naming,
                                        Nothing nothing = Nothing::Told);

/// The bases in one layer.
scene::Layer base_layer(const std::vector<OffsetFamily>& families, const OffsetNaming& naming);

/// The base segment and the raw edge of the last step, what it deleted, and the curve so far.
std::vector<scene::Layer> stage_layers(const OffsetStage& stage, const OffsetNaming& naming);

}  // namespace dobra::operations
