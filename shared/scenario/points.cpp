#include "shared/scenario/points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace dobra::scenario {
namespace {

bool written_alike(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool written_alike(const geom::Point& a, const geom::Point& b) {
  return written_alike(a.x, b.x) && written_alike(a.y, b.y);
}

constexpr auto alike = [](const geom::Point& a, const geom::Point& b) { return written_alike(a, b); };

}  // namespace

Points::Points(const std::vector<geom::Point>& points) { append(points, 0, points.size()); }

Points::Points(const std::vector<geom::Point>& points, const Points& before) {
  const auto same = [&](const Run& run, std::size_t at) {
    return at + run.points->size() <= points.size() &&
           std::equal(run.points->begin(), run.points->end(), points.begin() + static_cast<std::ptrdiff_t>(at), alike);
  };
  std::size_t head = 0;  // runs
  while (head < before.runs_.size() && same(before.runs_[head], size_)) append(before.runs_[head++].points);
  std::size_t tail = before.runs_.size();
  std::size_t end = points.size();
  while (tail > head) {
    const std::size_t length = before.runs_[tail - 1].points->size();
    if (end < size_ + length || !same(before.runs_[tail - 1], end - length)) break;
    end -= length;
    --tail;
  }
  append(points, size_, end);
  for (; tail < before.runs_.size(); ++tail) append(before.runs_[tail].points);
}

void Points::append(std::shared_ptr<const std::vector<geom::Point>> run) {
  const std::size_t length = run->size();
  runs_.push_back({size_, std::move(run)});
  size_ += length;
}

void Points::append(const std::vector<geom::Point>& points, std::size_t begin, std::size_t end) {
  while (begin < end) {
    // Two of equal length rather than a long one and a few points.
    const std::size_t rest = end - begin;
    const std::size_t length = rest <= run_length      ? rest
                               : rest < 2 * run_length ? (rest + 1) / 2
                                                       : std::size_t{run_length};
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
    append(std::make_shared<const std::vector<geom::Point>>(first, first + static_cast<std::ptrdiff_t>(length)));
    begin += length;
  }
}

const geom::Point& Points::operator[](std::size_t i) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), i,
                                      [](std::size_t number, const Run& run) { return number < run.first; });
  const Run& run = *std::prev(after);
  return (*run.points)[i - run.first];
}

std::vector<geom::Point> Points::list() const {
  std::vector<geom::Point> all;
  all.reserve(size_);
  for (const Run& run : runs_) all.insert(all.end(), run.points->begin(), run.points->end());
  return all;
}

bool operator==(const Points& a, const Points& b) {
  if (a.size_ != b.size_) return false;
  const auto shared = [](const Points::Run& x, const Points::Run& y) {
    return x.first == y.first && x.points->size() == y.points->size() &&
           (x.points == y.points || std::equal(x.points->begin(), x.points->end(), y.points->begin(), alike));
  };
  if (std::equal(a.runs_.begin(), a.runs_.end(), b.runs_.begin(), b.runs_.end(), shared)) return true;
  return std::equal(a.begin(), a.end(), b.begin(), alike);
}

}  // namespace dobra::scenario
