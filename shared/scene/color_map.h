#pragma once
// How numbers become colours. The maps are monotone in lightness (Viridis, Cividis) or diverging (CoolWarm, Quality),
// and all can be told apart by people who do not see red and green alike. Source: Viridis by S. van der Walt and N.
// Smith, Cividis by J. Nunez et al., CoolWarm by K. Moreland.

#include "shared/scene/layer.h"

namespace dobra::scene {

/// The colour at a fraction of a map: 0 is its low end, 1 its high end, outside takes the ends; grey for NaN.
Color color_at(ColorMapName map, double fraction);

/// Where `value` lies between the low and the high of a scale, 0..1 and clamped; 0.5 if the scale has no width; NaN for
/// NaN.
double fraction_of(const Scale& scale, double value);

/// Differences below this part of what numbers are made of are rounding.
constexpr double rounding_part = 1e-7;

/// Gives all values of a field that is constant to rounding one value, 0 where that is rounding itself, and its scale
/// no width, so that it has one colour and one number; leaves others as they are.
/// @param size  the greatest of the numbers that the values are made of, as sums and differences.
/// @return whether it is constant. A field without values is not.
bool settle_constant(Mesh& mesh, double size);

/// The colour of a value.
Color color_of(const Scale& scale, double value);

}  // namespace dobra::scene
