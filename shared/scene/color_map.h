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

/// The colour of a value.
Color color_of(const Scale& scale, double value);

}  // namespace dobra::scene
