#pragma once
// Round numbers along an axis: steps of 1, 2 or 5 times a power of ten, labels with the decimals that the step needs.

#include <functional>
#include <string>
#include <vector>

namespace dobra::scene {

struct Tick {
  double value = 0.0;
  std::string label;
};

/// The multiples of the smallest 1-2-5 step within [low, high] that are not more than `at_most`, in rising order.
/// At least one whenever the numbers are finite: `low` itself if no multiple of a step fits. Empty if they are not
/// finite.
/// @pre low <= high, at_most >= 1.
std::vector<Tick> nice_ticks(double low, double high, std::size_t at_most);

/// The densest nice ticks whose labels keep apart on an axis of `length` points.
/// @param room     length in points that a label takes along the axis.
/// @param gap      least distance in points between neighbouring labels.
/// @param spacing  least distance in points between neighbouring ticks.
std::vector<Tick> ticks_that_fit(double low, double high, double length, double gap, double spacing,
                                 const std::function<double(const std::string&)>& room);

/// The same for decimal logarithms: ticks at those of 1, 2 and 5 times the powers of ten, of these powers alone where
/// that is too dense, or of every so many of them, labelled with the numbers themselves. Steps of the logarithm where
/// no such number lies within.
std::vector<Tick> logarithmic_ticks_that_fit(double low, double high, double length, double gap, double spacing,
                                             const std::function<double(const std::string&)>& room);

/// The largest 1, 2 or 5 times a power of ten that is not above `value`.  @pre value > 0.
double nice_below(double value);

/// A number as on an axis, with `decimals` decimals and a true minus sign; "0" has none.
std::string tick_label(double value, int decimals);

}  // namespace dobra::scene
