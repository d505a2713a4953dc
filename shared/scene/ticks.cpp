#include "shared/scene/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/scene/decimal_mark.h"

namespace dobra::scene {
namespace {

constexpr double slack = 1e-9;       // of a step: rounding in low / step must not lose the tick at an end
constexpr double plain_limit = 1e8;  // numbers from here on are written with an exponent

/// Steps numbered in rising order: 0 is 1, 1 is 2, 2 is 5, 3 is 10, -1 is 0.5.
double step_number(int i) {
  const int decade = i >= 0 ? i / 3 : (i - 2) / 3;
  const int within = i - 3 * decade;
  const double base = within == 0 ? 1.0 : within == 1 ? 2.0 : 5.0;
  // Dividing by a whole power of ten is exact to the last bit; multiplying by 0.1 is not.
  return decade >= 0 ? base * std::pow(10.0, decade) : base / std::pow(10.0, -decade);
}

int decimals_of(double step) { return std::clamp(static_cast<int>(-std::floor(std::log10(step) + slack)), 0, 15); }

/// In the user's language.
std::string shown(std::string text) {
  text = with_decimal_mark(std::move(text));
  // U+2212 is as wide as a plus and is not taken for a hyphen.
  return !text.empty() && text.front() == '-' ? "\u2212" + text.substr(1) : text;
}

std::vector<Tick> single(double value) { return {{value, shown(fmt::format("{:.6g}", value))}}; }

std::vector<Tick> ticks_of_step(double low, double high, double step) {
  std::vector<Tick> ticks;
  const double from = std::ceil(low / step - slack);
  const double to = std::floor(high / step + slack);
  const bool plain = std::max(std::abs(low), std::abs(high)) < plain_limit && step >= 1e-6;
  for (double k = from; k <= to; k += 1.0) {
    const double value = k * step + 0.0;  // + 0.0 turns -0 into 0
    ticks.push_back({value, plain ? tick_label(value, decimals_of(step)) : shown(fmt::format("{:.10g}", value))});
  }
  return ticks;
}

bool keep_apart(const std::vector<Tick>& ticks, double points_per_unit, double gap, double spacing,
                const std::function<double(const std::string&)>& room) {
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const double apart = (ticks[i].value - ticks[i - 1].value) * points_per_unit;
    if (apart < spacing || apart < 0.5 * (room(ticks[i - 1].label) + room(ticks[i].label)) + gap) return false;
  }
  return true;
}

}  // namespace

std::string tick_label(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  if (zero && text.front() == '-') text.erase(0, 1);
  return shown(std::move(text));
}

double nice_below(double value) {
  int i = 3 * static_cast<int>(std::floor(std::log10(value))) - 1;
  while (step_number(i + 1) <= value * (1.0 + slack)) ++i;
  return step_number(i);
}

std::vector<Tick> nice_ticks(double low, double high, std::size_t at_most) {
  if (!std::isfinite(low) || !std::isfinite(high)) return {};
  const double width = high - low;
  // Below this the numbers of neighbouring ticks would read the same.
  if (!(width > 1e-12 * std::max(std::abs(low), std::abs(high)))) return single(low);
  int i = 3 * static_cast<int>(std::floor(std::log10(width / static_cast<double>(at_most)))) - 1;
  for (;; ++i) {
    const double step = step_number(i);
    const double count = std::floor(high / step + slack) - std::ceil(low / step - slack) + 1.0;
    if (count < 0.5) return single(low);
    if (count <= static_cast<double>(at_most) + 0.5) return ticks_of_step(low, high, step);
  }
}

std::vector<Tick> ticks_that_fit(double low, double high, double length, double gap, double spacing,
                                 const std::function<double(const std::string&)>& room) {
  auto at_most = static_cast<std::size_t>(std::clamp(length / spacing + 1.0, 1.0, 100.0));
  for (; at_most > 1; --at_most) {
    std::vector<Tick> ticks = nice_ticks(low, high, at_most);
    if (keep_apart(ticks, length / (high - low), gap, spacing, room)) return ticks;
  }
  return nice_ticks(low, high, 1);
}

std::vector<Tick> logarithmic_ticks_that_fit(double low, double high, double length, double gap, double spacing,
                                             const std::function<double(const std::string&)>& room) {
  for (int every = 0; every <= 308; ++every) {  // 0: three a decade
    std::vector<Tick> ticks;
    for (double decade = std::floor(low); decade <= high; decade += 1.0) {
      if (every > 1 && std::fmod(decade, every) != 0.0) continue;
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double at = decade + std::log10(digit);
        if (at < low || at > high || (every > 0 && digit > 1.0)) continue;
        ticks.push_back({at, with_decimal_mark(fmt::format("{:g}", digit * std::pow(10.0, decade)))});
      }
    }
    if (ticks.empty()) break;
    if (keep_apart(ticks, length / (high - low), gap, spacing, room)) return ticks;
  }
  return ticks_that_fit(low, high, length, gap, spacing, room);
}

}  // namespace dobra::scene
