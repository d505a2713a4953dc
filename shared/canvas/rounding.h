#pragma once
// What a mouse can mean: places in as few digits as a pixel can tell apart.

#include <cmath>

namespace dobra::canvas {

/// To a tenth of a pixel in round decimals. @param pixel  what one is in the world, > 0
inline double rounded(double value, double pixel) {
  const double step = std::pow(10.0, std::floor(std::log10(pixel)) - 1.0);
  const double steps = std::round(value / step);
  // Divided by a power of ten, the number is the nearest to what is written.
  return step < 1.0 ? steps / std::round(1.0 / step) : steps * step;
}

}  // namespace dobra::canvas
