#pragma once
// Numbers that were short before arithmetic, such as 12.5 in feet that went to metres and back. Method: the nearest
// number of ten digits is taken where it differs by no more than the rounding of a few operations. Of numbers that were
// not short one in some 100 000 is near enough by chance; it then changes by that rounding.

namespace dobra::base {

/// The number of ten digits that `value` is but for the rounding of a few operations; else `value` itself.
double without_rounding(double value);

}  // namespace dobra::base
