#include "shared/surf/loft/patch.h"

#include <fmt/format.h>

#include <algorithm>

namespace dobra::surf::loft {

namespace {

constexpr std::size_t most_triangles = 4'000'000;

std::vector<double> parted(const std::vector<double>& lines, std::size_t rows) {
  std::vector<double> made{lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (std::size_t k = 1; k < rows; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(rows);
      made.push_back((1.0 - t) * lines[i - 1] + t * lines[i]);
    }
    made.push_back(lines[i]);
  }
  return made;
}

std::vector<double> merged(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  constexpr double rounded = 1e-12;
  const double same = rounded * (a.back() - a.front());
  a.erase(std::unique(a.begin(), a.end(), [&](double p, double q) { return q - p <= same; }), a.end());
  return a;
}

}  // namespace

base::Result<Patch> lattice(Surface surface, const LatticeLines& lines) {
  std::vector<double> u = parted(merged(surface.breaks().u, lines.u), lines.rows_u);
  std::vector<double> v = parted(merged(surface.breaks().v, lines.v), lines.rows_v);
  if (2 * u.size() * v.size() > most_triangles)
    return base::Error{base::ErrorCode::TooManyElements,
                       fmt::format("a lattice of {} by {} lines; simplify the lines of the sections, or ask for fewer "
                                   "rows between them",
                                   u.size(), v.size())};
  std::vector<geom::Point> places;
  for (const double a : u) {
    for (const double b : v) places.push_back({a, b});
  }
  std::vector<Jet> jets(places.size());
  surface.jets(places, jets);
  Patch patch{std::move(surface), std::move(u), std::move(v), {}, {}, {}, {}, {}, {}, {}};
  for (const Jet& jet : jets) patch.points.push_back(jet.at);
  const auto row = static_cast<std::uint32_t>(patch.v.size());
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = patch.points;
    const int same = (p[a] == p[b] ? 1 : 0) + (p[b] == p[c] ? 1 : 0) + (p[c] == p[a] ? 1 : 0);
    if (same == 0) patch.triangles.push_back({a, b, c});
    if (same == 1) patch.collapsed.push_back({a, b, c});
  };
  for (std::uint32_t i = 0; i + 1 < patch.u.size(); ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = i * row + j, b = a + row, c = b + 1, d = a + 1;
      add(a, b, c);
      add(a, c, d);
    }
  }
  return patch;
}

std::vector<geom::Point3> border_of(const Patch& patch) {
  std::vector<geom::Point3> ring;
  const std::size_t n = patch.u.size(), m = patch.v.size();
  for (std::size_t i = 0; i + 1 < n; ++i) ring.push_back(patch.points[i * m]);
  for (std::size_t j = 0; j + 1 < m; ++j) ring.push_back(patch.points[(n - 1) * m + j]);
  for (std::size_t i = n - 1; i > 0; --i) ring.push_back(patch.points[i * m + m - 1]);
  for (std::size_t j = m - 1; j > 0; --j) ring.push_back(patch.points[j]);
  return ring;
}

}  // namespace dobra::surf::loft
