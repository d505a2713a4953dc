#include "shared/mesh/fill_engine.h"

#include <fmt/format.h>

#include "shared/mesh/advancing_front.h"
#include "shared/mesh/front_gaps.h"
#include "shared/mesh/frontal_points.h"

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Progress;
using base::Result;

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

}  // namespace

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
