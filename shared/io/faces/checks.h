#pragma once
// What a face must fulfil once its loops are made.

#include "shared/io/faces/loops.h"

namespace dobra::io::faces {

/// How far a curve in the chart is from its curve in space: at most, m, and where.
struct Apart {
  double distance = 0.0;
  geom::Point uv{};
};
Apart apart(const surf::Surface& surface, const Piece& piece);

/// Two edges of loops that cross.
struct Crossing {
  std::string first, second;
  geom::Point uv{};
  bool at_end = false;  ///< Within `close` of an end of one of them.
};
/// The first crossing that is not at an end, or else the first at one, if there is any. Seen on polygons that are a
/// part of 1e-5 of the face off at most, and followed to 1e-9 of it on the curves.
/// @param close  m
std::optional<Crossing> crossing_of(const surf::Surface& surface, const std::vector<Loop>& loops, double close);

}  // namespace dobra::io::faces
