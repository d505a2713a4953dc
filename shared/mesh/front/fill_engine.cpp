#include "shared/mesh/front/fill_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shared/mesh/front/front_engine.h"
#include "shared/mesh/front/frontal_points.h"
#include "shared/mesh/front/in_plane.h"

namespace dobra::mesh::front {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

namespace {

/// Mean over a triangle of 1 / h^2 for a size h that is linear on it, with these values at its corners: twice the
/// second divided difference of -ln h (Hermite and Genocchi).
double mean_of_inverse_squares(std::array<double, 3> h) {
  std::sort(h.begin(), h.end());
  constexpr double alike = 1.05;
  const auto slope = [](double x, double y) { return y > alike * x ? -std::log(y / x) / (y - x) : -2.0 / (x + y); };
  if (h[2] <= alike * alike * h[0]) return 3.0 / (h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
  return 2.0 * (slope(h[1], h[2]) - slope(h[0], h[1])) / (h[2] - h[0]);
}

/// A corner of a triangle and the size wanted there.
struct Sized {
  Point at;
  double size = 0.0;
};

/// Triangles of the sizes wanted in the triangle a, b, c, if these are linear on it.
double expected_in(const Sized& a, const Sized& b, const Sized& c) {
  return 2.0 / std::numbers::sqrt3 * geom::cross(b.at - a.at, c.at - a.at) *
         mean_of_inverse_squares({a.size, b.size, c.size});
}

/// The same for any sizes: the triangle is halved while the size in the middle of its longest side, or in its own, is
/// not linear between those at the corners.
double expected_in(sizing::SizeSampler& sizes, const Sized& a, const Sized& b, const Sized& c, int depth) {
  constexpr double unnoticed = 0.03;
  constexpr double few = 4.0;  // elements, between which nothing hides
  constexpr int deepest = 12;
  const double ab = geom::length_squared(b.at - a.at);
  const double bc = geom::length_squared(c.at - b.at);
  const double ca = geom::length_squared(a.at - c.at);
  if (bc > ab && bc >= ca) return expected_in(sizes, b, c, a, depth);
  if (ca > ab) return expected_in(sizes, c, a, b, depth);
  const double between = 0.5 * (a.size + b.size);
  if (ab <= few * few * between * between) return expected_in(a, b, c);
  const auto linear = [&](double size, double expected) { return std::abs(size - expected) <= unnoticed * size; };
  const Point middle = geom::midpoint(a.at, b.at);
  const Sized m{middle, sizes.at(middle)};
  if (depth == deepest || (linear(m.size, between) && linear(sizes.at(geom::interpolate(middle, c.at, 1.0 / 3.0)),
                                                             (a.size + b.size + c.size) / 3.0)))
    return expected_in(a, m, c) + expected_in(m, b, c);
  return expected_in(sizes, a, m, c, depth + 1) + expected_in(sizes, m, b, c, depth + 1);
}

}  // namespace

std::size_t make_room(delaunay::DelaunayKernel& kernel, const sizing::SizeField& field, const FrontalOptions& options) {
  // Meshes have up to a tenth more; and sizes that spread round a hole are less than linear, by which the estimate is
  // low.
  constexpr double reserve = 1.2;
  sizing::SizeSampler sizes(field);
  double expected = 0.0;
  std::size_t outside = 0;
  for (delaunay::DelaunayKernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const delaunay::DelaunayKernel::Triangle& cell = kernel.cell(c);
    if (cell.region < 0) {
      ++outside;
    } else {
      const auto corner = [&](std::size_t i) {
        return Sized{kernel.point(cell.vertex[i]), sizes.at(kernel.point(cell.vertex[i]))};
      };
      expected += reserve * expected_in(sizes, corner(0), corner(1), corner(2), 0);
    }
  }
  const auto inside = static_cast<std::size_t>(std::min(expected, static_cast<double>(options.max_triangles)));
  const std::size_t cells = std::max(kernel.cell_count(), outside + inside);
  kernel.reserve(kernel.vertex_count() + (cells - kernel.cell_count()) / 2, cells);
  return cells;
}

std::unique_ptr<FillEngine> make_engine(Engine engine, delaunay::DelaunayKernel& kernel, const sizing::SizeField& field,
                                        const FrontalOptions& options) {
  if (engine == Engine::Delaunay) return frontal_points(kernel, field, options);
  return std::make_unique<InPlane<FrontEngine<Plane>>>(kernel, field, options);
}

Result<void> check_limit(std::size_t triangles, const FrontalOptions& options) {
  if (triangles <= options.max_triangles) return {};
  return Error{ErrorCode::TooManyElements,
               fmt::format("the mesh would have more than {} triangles: use longer boundary edges, a larger growth, or "
                           "raise the limit",
                           options.max_triangles)};
}

}  // namespace dobra::mesh::front
