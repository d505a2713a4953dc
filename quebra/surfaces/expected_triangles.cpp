#include "quebra/surfaces/expected_triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "shared/surf/details.h"
#include "shared/surf/mesh/chart_sizes.h"
#include "shared/surf/trim/finding.h"
#include "shared/surf/trim/rings.h"

namespace quebra::surfaces {

using namespace dobra;
using geom::Point;
using surf::mesh::SizeOptions;
using surf::trim::Ring;
using surf::trim::TrimmedSurface;

namespace {

std::vector<Ring> rings_or_chart(const TrimmedSurface& face) {
  std::vector<Ring> rings = surf::trim::rings_of(face);
  const auto [low, high] = face.surface.chart();
  if (rings.empty()) rings.push_back({low, {high.x, low.y}, high, {low.x, high.y}});
  return rings;
}

/// Parts of the golden ratio: no two rows are alike.
double scattered(int i) {
  const double value = (i + 0.5) * std::numbers::phi;
  return value - std::floor(value);
}

/// By the parts of a graph in which it bends closely, which scattered places miss.
ExpectedTriangles expected_in_details(const TrimmedSurface& face, const SizeOptions& sizes) {
  const surf::Surface& surface = face.surface;
  const std::vector<Ring> rings = rings_or_chart(face);
  geom::Box box;
  for (const Ring& ring : rings) box.add(geom::box_of(ring));
  const double largest = surf::mesh::largest_size(surface, sizes);
  const double unnoticed = surf::mesh::unnoticed_bend(largest, sizes);
  surf::Details details = surf::details_of(surface, box);
  details.parts.insert(details.parts.end(), details.unseen.begin(), details.unseen.end());
  ExpectedTriangles found;
  double least = std::numeric_limits<double>::infinity();
  for (const geom::Box& part : details.parts) {
    const Point uv = part.centre();
    const std::vector<double> at = surf::trim::meets(rings, uv.y);
    if (std::count_if(at.begin(), at.end(), [&](double u) { return u < uv.x; }) % 2 == 0) continue;
    const surf::Jet jet = surface.jet(uv);
    const double bend = surf::mesh::followed_bend(surface, uv, jet, unnoticed, sizes);
    const double size =
        std::max(sizes.least, std::min({largest, surf::mesh::size_by_bend(bend, sizes),
                                        surf::mesh::size_by_chart(jet, sizes), sizes.wanted_at(uv, jet.at)}));
    const double area = geom::length(cross(jet.u, jet.v)) * part.width() * part.height();
    const double triangles = 4.0 / std::numbers::sqrt3 * area / (size * size);
    if (!std::isfinite(triangles)) continue;
    found.count += triangles;
    if (size < least) least = size, found.finest = uv;
  }
  return found;
}

}  // namespace

ExpectedTriangles expected_triangles(const TrimmedSurface& face, const SizeOptions& sizes, int lines) {
  constexpr std::size_t left_out = 8;
  const std::vector<Ring> rings = rings_or_chart(face);
  geom::Box box;
  for (const Ring& ring : rings) box.add(geom::box_of(ring));
  const double largest = surf::mesh::largest_size(face.surface, sizes);
  const double du = box.width() / lines, dv = box.height() / lines;
  ExpectedTriangles found;
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> parts;
  for (int j = 0; j < lines; ++j) {
    const double v = std::lerp(box.low.y, box.high.y, (j + scattered(j)) / lines);
    const std::vector<double> at = surf::trim::meets(rings, v);
    for (int i = 0; i < lines; ++i) {
      const Point uv{std::lerp(box.low.x, box.high.x, (i + scattered(i + 7 * j)) / lines), v};
      if (std::count_if(at.begin(), at.end(), [&](double u) { return u < uv.x; }) % 2 == 0) continue;
      const surf::Jet jet = face.surface.jet(uv);
      const double size =
          std::max(sizes.least, std::min({largest, surf::mesh::size_by_shape(jet, sizes),
                                          surf::mesh::size_by_chart(jet, sizes), sizes.wanted_at(uv, jet.at)}));
      const double part = 4.0 / std::numbers::sqrt3 * geom::length(cross(jet.u, jet.v)) * du * dv / (size * size);
      if (!std::isfinite(part)) continue;
      parts.push_back(part);
      if (size < least) least = size, found.finest = uv;
    }
  }
  if (parts.size() <= left_out) return found;
  std::nth_element(parts.begin(), parts.begin() + left_out, parts.end(), std::greater<>());
  found.count = std::accumulate(parts.begin() + left_out, parts.end(), 0.0);
  return found;
}

base::Result<void> not_too_many(const TrimmedSurface& face, const SizeOptions& sizes, std::size_t most) {
  constexpr int few = 32, many = 128;
  constexpr double doubtful = 0.01, sure = 2.0;
  const auto allowed = static_cast<double>(most);
  if (!face.surface.seen(face.surface.chart())) {
    const ExpectedTriangles close = expected_in_details(face, sizes);
    if (close.count > sure * allowed)
      return base::Error{base::ErrorCode::TooManyElements,
                         fmt::format("the mesh would have more than {} triangles, the least of them here, where the "
                                     "surface bends closely: trim this part of the surface away, or raise the limit",
                                     most),
                         surf::trim::place_of(face.surface, close.finest)};
  }
  ExpectedTriangles found = expected_triangles(face, sizes, few);
  if (found.count <= doubtful * allowed) return {};
  found = expected_triangles(face, sizes, many);
  if (found.count <= sure * allowed) return {};
  return base::Error{base::ErrorCode::TooManyElements,
                     fmt::format("the mesh would have more than {} triangles, the least of them here: use a greater "
                                 "size, turn or growth, trim this part of the surface away, or raise the limit",
                                 most),
                     surf::trim::place_of(face.surface, found.finest)};
}

}  // namespace quebra::surfaces
