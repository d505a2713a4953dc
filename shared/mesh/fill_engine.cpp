#include "shared/mesh/fill_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "shared/mesh/advancing_front.h"
#include "shared/mesh/front_gaps.h"
#include "shared/mesh/frontal_points.h"

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Progress;
using base::Result;
using geom::Point;

namespace {

/// The front, then the gaps that it leaves. Where sides of the front cross beyond mending, points everywhere instead.
class FrontEngine final : public FillEngine {
 public:
  FrontEngine(DelaunayKernel& kernel, const SizeField& field, const FrontalOptions& options)
      : kernel_(kernel),
        field_(field),
        options_(options),
        given_(kernel),
        part_(advancing_front(kernel, field, options, front_)) {}

  Result<void> step(std::size_t count, const Progress& progress) override {
    constexpr double rows = 0.7;
    const Progress part = stage_ == Stage::Rows ? progress.part(0.0, rows) : progress.part(rows, 1.0);
    if (const auto stepped = part_->step(count, part); !stepped) {
      if (stepped.error().code != ErrorCode::SelfIntersection || stage_ == Stage::Points) return stepped;
      kernel_ = given_;
      stage_ = Stage::Points;
      part_ = frontal_points(kernel_, field_, options_);
    }
    if (part_->done() && stage_ == Stage::Rows) {
      stage_ = Stage::Gaps;
      part_ = gap_filler(kernel_, front_, field_, options_);
    }
    return {};
  }
  [[nodiscard]] bool done() const override { return stage_ != Stage::Rows && part_->done(); }
  [[nodiscard]] std::vector<geom::Segment> front() const override { return part_->front(); }

 private:
  enum class Stage : std::uint8_t { Rows, Gaps, Points };

  DelaunayKernel& kernel_;
  const SizeField& field_;
  const FrontalOptions& options_;
  const DelaunayKernel given_;
  Front front_;
  std::unique_ptr<FillEngine> part_;
  Stage stage_ = Stage::Rows;
};

/// Triangles of the sizes wanted in the triangle a, b, c: halved while the sizes at its corners differ much.
double expected_in(SizeSampler& sizes, Point a, Point b, Point c, int depth) {
  constexpr double alike = 1.5;
  constexpr int deepest = 12;
  const double ha = sizes.at(a);
  const double hb = sizes.at(b);
  const double hc = sizes.at(c);
  if (depth < deepest && std::max({ha, hb, hc}) > alike * std::min({ha, hb, hc})) {
    const double ab = geom::length_squared(b - a);
    const double bc = geom::length_squared(c - b);
    const double ca = geom::length_squared(a - c);
    if (bc > ab && bc >= ca) return expected_in(sizes, b, c, a, depth);
    if (ca > ab) return expected_in(sizes, c, a, b, depth);
    const Point m = geom::midpoint(a, b);
    return expected_in(sizes, a, m, c, depth + 1) + expected_in(sizes, m, b, c, depth + 1);
  }
  const double h = (ha + hb + hc) / 3.0;
  return 2.0 / std::numbers::sqrt3 * geom::cross(b - a, c - a) / (h * h);
}

}  // namespace

std::size_t make_room(DelaunayKernel& kernel, const SizeField& field, const FrontalOptions& options) {
  constexpr double reserve = 1.12;  // Meshes have up to a tenth more.
  SizeSampler sizes(field);
  double expected = 0.0;
  std::size_t outside = 0;
  for (DelaunayKernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const DelaunayKernel::Triangle& cell = kernel.cell(c);
    const auto corner = [&](std::size_t i) { return kernel.point(cell.vertex[i]); };
    if (cell.region < 0) {
      ++outside;
    } else {
      expected += reserve * expected_in(sizes, corner(0), corner(1), corner(2), 0);
    }
  }
  const auto inside = static_cast<std::size_t>(std::min(expected, static_cast<double>(options.max_triangles)));
  const std::size_t cells = std::max(kernel.cell_count(), outside + inside);
  kernel.reserve(kernel.vertex_count() + (cells - kernel.cell_count()) / 2, cells);
  return cells;
}

std::unique_ptr<FillEngine> make_engine(Engine engine, DelaunayKernel& kernel, const SizeField& field,
                                        const FrontalOptions& options) {
  if (engine == Engine::Delaunay) return frontal_points(kernel, field, options);
  return std::make_unique<FrontEngine>(kernel, field, options);
}

Result<void> check_limit(std::size_t triangles, const FrontalOptions& options) {
  if (triangles <= options.max_triangles) return {};
  return Error{ErrorCode::TooManyElements,
               fmt::format("the mesh would have more than {} triangles: use longer boundary edges, a larger growth, or "
                           "raise the limit",
                           options.max_triangles)};
}

}  // namespace dobra::mesh
