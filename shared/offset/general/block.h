#pragma once
// 16 segments of the base at a time: their boxes at any distance, and the distance below which they need no look.

#include <cstdint>

#include "shared/offset/kernel/float_box.h"

namespace dobra::offset::general {

/// Box of the raw outline at distance d, given those of the base and of (outline - base) / D.
inline FloatBox outline_box(const FloatBox& base, const FloatBox& by, double d, double margin) {
  return {{base.low_x + d * by.low_x, base.low_y + d * by.low_y},
          {base.high_x + d * by.high_x, base.high_y + d * by.high_y},
          margin};
}

/// 16 segments in a row, with the corners at both ends of each.
struct Block {
  static constexpr std::uint32_t size = 16;
  FloatBox points;
  FloatBox right, left;      ///< Of (raw outline - base) / D on either side.
  std::uint64_t directions;  ///< Of the right side; see ChainTree.
  std::uint64_t absent;      ///< Pieces that the right side does not have, four bits a segment, by SiteKind.
  /// Of its first arcs, four bits a segment.
  [[nodiscard]] std::uint64_t arcs() const { return (~absent >> 1) & 0x1111111111111111; }
  std::uint32_t piece_count;  ///< Those that it has.
  double plain_below;  ///< Below this distance line follows line there, or an arc of at most a right angle between.
  /// Box of all pieces of the raw outline on one side.
  [[nodiscard]] FloatBox box(bool on_left, double d, double margin) const {
    return outline_box(points, on_left ? left : right, d, margin);
  }
};

}  // namespace dobra::offset::general
