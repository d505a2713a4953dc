#pragma once
// The engine Front of fill_engine.h in a space of its own: the plane, or a surface (space.h).

#include <memory>
#include <vector>

#include "shared/mesh/front/advancer.h"
#include "shared/mesh/front/gap_filler.h"

namespace dobra::mesh::front {

/// The front, then the gaps that it leaves. Where sides of the front cross beyond mending, points everywhere instead.
template <class Space>
class FrontEngine final : public FillEngine {
 public:
  FrontEngine(delaunay::DelaunayKernel& kernel, Space& space, const sizing::SizeField& field,
              const FrontalOptions& options)
      : kernel_(kernel),
        space_(space),
        field_(field),
        options_(options),
        given_(kernel),
        part_(std::make_unique<Advancer<Space>>(kernel, space, field, options, front_)) {}

  base::Result<void> step(std::size_t count, const base::Progress& progress) override {
    constexpr double rows = 0.7;
    const base::Progress part = stage_ == Stage::Rows ? progress.part(0.0, rows) : progress.part(rows, 1.0);
    if (const auto stepped = part_->step(count, part); !stepped) {
      if (stepped.error().code != base::ErrorCode::SelfIntersection || stage_ == Stage::Points) return stepped;
      kernel_ = given_;
      space_.forget(given_.vertex_count());
      stage_ = Stage::Points;
      part_ = std::make_unique<PointPlacer<Space>>(kernel_, space_, field_, options_);
    }
    if (part_->done() && stage_ == Stage::Rows) {
      stage_ = Stage::Gaps;
      part_ = std::make_unique<GapFiller<Space>>(kernel_, space_, front_, field_, options_);
    }
    return {};
  }
  [[nodiscard]] bool done() const override { return stage_ != Stage::Rows && part_->done(); }
  [[nodiscard]] std::vector<geom::Segment> front() const override { return part_->front(); }

 private:
  enum class Stage : std::uint8_t { Rows, Gaps, Points };

  delaunay::DelaunayKernel& kernel_;
  Space& space_;
  const sizing::SizeField& field_;
  const FrontalOptions& options_;
  const delaunay::DelaunayKernel given_;
  Front front_;
  std::unique_ptr<FillEngine> part_;
  Stage stage_ = Stage::Rows;
};

}  // namespace dobra::mesh::front
