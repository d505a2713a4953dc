#include "recon/unfold/bed_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "shared/base/parallel.h"

namespace recon::unfold {

namespace {

/// Stretches of the top in which depths are compared.
constexpr std::size_t stretches = 64;

/// What a bed covers of each stretch, and its depth there.
struct Profile {
  std::array<double, stretches> covered{};  ///< m along the top.
  std::array<double, stretches> moment{};   ///< Integral of the depth over that, m2.
  double mean = 0.0;                        ///< Depth.
};

/// Where a name lies along the top, m.
double place_of(const maps::ColumnPoint& name, const maps::Columns& top) {
  const maps::Columns::Frame& frame = top.frame(name.column);
  if (name.column.index() == 0) return name.along;
  if (top.is_outer(name.column)) return frame.arc + frame.length + name.along;
  return frame.arc + name.along * frame.length;
}

/// A piece of a bed from one place and depth to another, shared out to the stretches that it passes.
void add_piece(double from, double depth_from, double to, double depth_to, double first, double width, Profile& made) {
  if (from > to) {
    std::swap(from, to);
    std::swap(depth_from, depth_to);
  }
  const auto stretch_of = [&](double place) {
    return static_cast<std::size_t>(std::clamp((place - first) / width, 0.0, static_cast<double>(stretches) - 1.0));
  };
  const std::size_t last = stretch_of(to);
  for (std::size_t i = stretch_of(from); i <= last && to > from; ++i) {
    const double low = std::max(from, first + static_cast<double>(i) * width);
    const double high = i == last ? to : std::min(to, first + static_cast<double>(i + 1) * width);
    if (!(high > low)) continue;
    const double part = (0.5 * (low + high) - from) / (to - from);
    made.covered[i] += high - low;
    made.moment[i] += (high - low) * ((1.0 - part) * depth_from + part * depth_to);
  }
}

/// Mean depth of a less that of b over the stretches that both cover; nothing if there are none.
std::optional<double> deeper_by(const Profile& a, const Profile& b) {
  double sum = 0.0;
  double shared = 0.0;
  for (std::size_t i = 0; i < stretches; ++i) {
    const double both = std::min(a.covered[i], b.covered[i]);
    if (!(both > 0.0)) continue;
    sum += both * (a.moment[i] / a.covered[i] - b.moment[i] / b.covered[i]);
    shared += both;
  }
  return shared > 0.0 ? std::optional(sum / shared) : std::nullopt;
}

std::vector<Profile> profiles_of(const std::vector<NamedBed>& beds, const maps::Columns& top) {
  const maps::Columns::Frame& end = top.frame(maps::ColumnId(top.inner_count()));
  std::vector<std::vector<double>> places(beds.size());
  double first = 0.0;
  double last = end.arc + end.length;
  for (std::size_t k = 0; k < beds.size(); ++k) {
    for (const maps::ColumnPoint& name : beds[k].names) places[k].push_back(place_of(name, top));
    for (const double place : places[k]) {
      first = std::min(first, place);
      last = std::max(last, place);
    }
  }
  const double width = (last - first) / static_cast<double>(stretches);
  return base::parallel_map<Profile>(beds.size(), [&](std::size_t k) {
    Profile made;
    const std::vector<maps::ColumnPoint>& names = beds[k].names;
    if (names.empty()) add_piece(0.0, 0.0, end.arc + end.length, 0.0, first, width, made);
    for (std::size_t i = 0; i < names.size(); ++i) {
      made.mean += names[i].depth / static_cast<double>(names.size());
      if (i > 0) add_piece(places[k][i - 1], names[i - 1].depth, places[k][i], names[i].depth, first, width, made);
    }
    return made;
  });
}

}  // namespace

std::vector<section::HorizonId> in_order(const std::vector<NamedBed>& beds, const maps::Columns& top) {
  const std::vector<Profile> profiles = profiles_of(beds, top);
  // Of beds that nothing left lies above, the one of least mean depth comes next. Beds that cross each other may all
  // have one above them: then the least of all.
  std::vector<std::vector<std::size_t>> below(beds.size());
  std::vector<std::size_t> above(beds.size(), 0);
  for (std::size_t i = 0; i < beds.size(); ++i) {
    for (std::size_t j = i + 1; j < beds.size(); ++j) {
      const auto deeper = deeper_by(profiles[i], profiles[j]);
      if (!deeper || *deeper == 0.0) continue;
      below[*deeper < 0.0 ? i : j].push_back(*deeper < 0.0 ? j : i);
      ++above[*deeper < 0.0 ? j : i];
    }
  }
  std::vector<section::HorizonId> order;
  std::vector<char> taken(beds.size(), 0);
  while (order.size() < beds.size()) {
    std::size_t next = beds.size();
    for (std::size_t i = 0; i < beds.size(); ++i) {
      if (taken[i] != 0) continue;
      const auto rank = [&](std::size_t k) { return std::tuple(above[k] > 0, profiles[k].mean, beds[k].id.index()); };
      if (next == beds.size() || rank(i) < rank(next)) next = i;
    }
    taken[next] = 1;
    order.push_back(beds[next].id);
    for (const std::size_t k : below[next])
      if (above[k] > 0) --above[k];
  }
  return order;
}

}  // namespace recon::unfold
