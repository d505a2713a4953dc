#pragma once
// A point as the place of an error, for the user to zoom to, and in the text of a message.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "shared/base/error.h"
#include "shared/geom/point.h"

namespace dobra::geom {

inline base::Place place_at(Point p, std::string item = {}) { return {.item = std::move(item), .x = p.x, .y = p.y}; }

}  // namespace dobra::geom

/// "(x, y)": to six digits, and to the hundredth of a metre where coordinates are larger than 10 km, as those of maps.
template <>
struct fmt::formatter<dobra::geom::Point> {
  constexpr auto parse(format_parse_context& context) { return context.begin(); }

  template <class Context>
  auto format(dobra::geom::Point p, Context& context) const {
    const auto digits = [](double value) {
      int count = 6;
      for (double size = 1e4; std::abs(value) >= size && count < 12; size *= 10.0) ++count;
      return count;
    };
    return fmt::format_to(context.out(), "({:.{}g}, {:.{}g})", p.x, digits(p.x), p.y, digits(p.y));
  }
};
