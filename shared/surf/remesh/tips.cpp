#include "shared/surf/remesh/tips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <utility>

namespace dobra::surf::remesh {

using geom::Point3;
using geom::Vector3;
using param::HalfEdge;
using param::no_half_edge;
using param::Sheet;

namespace {

/// Points that sides lead to from each, in rows.
class Sides {
 public:
  explicit Sides(const Sheet& sheet) : from_(sheet.points.size() + 1, 0) {
    const auto for_each = [&](auto&& visit) {
      for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
        visit(sheet.start(h), sheet.end(h));
        if (sheet.twins[h] == no_half_edge) visit(sheet.end(h), sheet.start(h));
      }
    };
    for_each([&](std::uint32_t a, std::uint32_t) { ++from_[a + 1]; });
    for (std::size_t v = 1; v < from_.size(); ++v) from_[v] += from_[v - 1];
    ends_.resize(from_.back());
    std::vector<std::size_t> next(from_.begin(), from_.end() - 1);
    for_each([&](std::uint32_t a, std::uint32_t b) { ends_[next[a]++] = b; });
  }
  template <class Visit>
  void for_each_from(std::uint32_t v, Visit&& visit) const {
    for (std::size_t i = from_[v]; i < from_[v + 1]; ++i) visit(ends_[i]);
  }

 private:
  std::vector<std::size_t> from_;
  std::vector<std::uint32_t> ends_;
};

/// Calls visit(point) for one and all within such a way along sides.
template <class Visit>
void for_each_within(const Sheet& sheet, const Sides& sides, std::uint32_t from, double way, Visit&& visit) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::map<std::uint32_t, double> least{{from, 0.0}};
  queue.emplace(0.0, from);
  while (!queue.empty()) {
    const auto [at, v] = queue.top();
    queue.pop();
    if (at > least[v]) continue;
    visit(v);
    sides.for_each_from(v, [&, at = at, v = v](std::uint32_t w) {
      const double there = at + geom::distance(sheet.points[v], sheet.points[w]);
      if (there > way) return;
      const auto [found, fresh] = least.try_emplace(w, there);
      if (!fresh && found->second <= there) return;
      found->second = there;
      queue.emplace(there, w);
    });
  }
}

}  // namespace

std::vector<double> angle_defects(const Sheet& sheet) {
  std::vector<double> lacks(sheet.points.size(), 2.0 * std::numbers::pi);
  for (const auto& loop : sheet.loops) {
    for (const std::uint32_t v : loop) lacks[v] = std::numbers::pi;
  }
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    const Point3 p = sheet.points[sheet.start(h)];
    const Vector3 a = sheet.points[sheet.end(h)] - p, b = sheet.points[sheet.start(param::previous(h))] - p;
    lacks[sheet.start(h)] -= std::atan2(geom::length(cross(a, b)), dot(a, b));
  }
  return lacks;
}

std::vector<std::uint32_t> sharp_points(const Sheet& sheet, const std::vector<double>& sizes, double degrees) {
  const double least = degrees * std::numbers::pi / 180.0;
  const std::vector<double> lacks = angle_defects(sheet);
  std::vector<bool> on_border(sheet.points.size(), false);
  for (const auto& loop : sheet.loops) {
    for (const std::uint32_t v : loop) on_border[v] = true;
  }
  std::vector<std::uint32_t> sharp;
  for (std::uint32_t v = 0; v < lacks.size(); ++v) {
    if (std::abs(lacks[v]) >= least) sharp.push_back(v);
  }
  if (sharp.empty()) return sharp;
  const Sides sides(sheet);
  std::erase_if(sharp, [&](std::uint32_t v) {
    double sum = 0.0;
    for_each_within(sheet, sides, v, sizes[v], [&](std::uint32_t w) {
      if (w == v || !on_border[w]) sum += lacks[w];
    });
    return std::copysign(1.0, lacks[v]) * sum < least;
  });
  std::stable_sort(sharp.begin(), sharp.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return std::abs(lacks[a]) > std::abs(lacks[b]); });
  return sharp;
}

}  // namespace dobra::surf::remesh
