#include "recon/kinematics/fault_bend_fold.h"

#include <algorithm>
#include <cmath>

#include "recon/kinematics/refuse.h"
#include "recon/maps/columns.h"

namespace recon::kinematics {

namespace {

/// The angle from a to b, > 0 where b turns into the hanging wall.
double turn_of(const FaultPath& path, geom::Vector a, geom::Vector b) {
  const double angle = std::atan2(geom::cross(a, b), geom::dot(a, b));
  return path.hanging == Side::Left ? angle : -angle;
}

/// Follows what passes the bends while the fault slips. Packet j is the rock over segment j before any slip; bend k
/// lies between segments k and k + 1.
class Passage {
 public:
  Passage(const FaultPath& path, std::optional<base::Angle> bedding) : path_(path) {
    const std::size_t n = path.line.segment_count();
    for (std::size_t j = 0; j < n; ++j) along_.push_back(geom::normalised(path.line.segment(j).vector()));
    geom::Vector beds = along_[0];
    if (bedding) beds = {std::cos(bedding->radians()), std::sin(bedding->radians())};
    if (geom::dot(beds, along_[0]) < 0.0) beds = -beds;
    for (std::size_t j = 0; j < n; ++j) cutoff_.push_back(turn_of(path, beds, along_[j]));
    for (std::size_t k = 0; k + 1 < n; ++k) {
      passing_.push_back(k);
      marks_.push_back({k + 1, 0.0});
    }
  }

  /// While nothing changes at any bend.
  struct Stage {
    double from = 0.0, to = maps::infinity;  ///< Slip of the first segment, m.
    std::vector<std::size_t> packets;        ///< Passing each bend.
    std::vector<BendFold> folds;             ///< Of each bend.
    std::vector<double> speeds;              ///< Of each segment.
  };
  /// The stages up to a slip.
  base::Result<std::vector<Stage>> run(double until) {
    std::vector<Stage> stages;
    for (double gone = 0.0; gone < until || stages.empty();) {
      DOBRA_TRY(Stage stage, stage_at(gone));
      advance(stage);
      gone = stage.to;
      stages.push_back(std::move(stage));
    }
    return stages;
  }

 private:
  /// What stood at a bend before any slip: the segment that it moves along, and how far it has gone there, m.
  struct Mark {
    std::size_t segment;
    double gone;
  };
  [[nodiscard]] bool ends_at_bend(std::size_t segment) const { return segment + 1 < along_.size(); }
  [[nodiscard]] double length(std::size_t segment) const { return path_.line.segment(segment).length(); }

  base::Result<Stage> stage_at(double gone) {
    Stage stage{gone, maps::infinity, passing_, {}, {1.0}};
    for (std::size_t k = 0; k < passing_.size(); ++k) {
      DOBRA_TRY(const BendFold fold, fold_at(k, passing_[k]));
      stage.speeds.push_back(stage.speeds.back() * fold.slip_ratio);
      stage.folds.push_back(fold);
    }
    for (const Mark& mark : marks_) {
      if (!ends_at_bend(mark.segment)) continue;
      const double room = length(mark.segment) - mark.gone;
      stage.to = std::min(stage.to, gone + room / stage.speeds[mark.segment]);
    }
    return stage;
  }

  void advance(const Stage& stage) {
    for (std::size_t b = 0; b < marks_.size(); ++b) {
      Mark& mark = marks_[b];
      if (!ends_at_bend(mark.segment)) continue;
      mark.gone += (stage.to - stage.from) * stage.speeds[mark.segment];
      if (mark.gone < length(mark.segment) * (1.0 - 1e-12)) continue;
      passing_[mark.segment] = b;  // packet b stands behind what stood at bend b
      mark = {mark.segment + 1, 0.0};
    }
  }

  /// The packet gets a new cutoff at every bend that it has passed.
  base::Result<BendFold> fold_at(std::size_t bend, std::size_t packet) {
    double theta = cutoff_[packet];
    BendFold fold;
    for (std::size_t k = packet; k <= bend; ++k) {
      const double phi = -turn_of(path_, along_[k], along_[k + 1]);
      auto made = bend_fold(base::Angle::from_radians(theta), base::Angle::from_radians(phi));
      if (!made) return refused(made.error().message, path_.line.points[k + 1]);
      fold = *made;
      theta = fold.beta.radians();
    }
    return fold;
  }

  const FaultPath& path_;
  std::vector<geom::Vector> along_;
  std::vector<double> cutoff_;        ///< Of the packets, where they stood before any slip.
  std::vector<std::size_t> passing_;  ///< The packet at each bend.
  std::vector<Mark> marks_;           ///< Of each bend.
};

base::Result<std::vector<Passage::Stage>> stages_of(const FaultPath& path, std::optional<base::Angle> bedding,
                                                    double from, double to) {
  if (from < 0.0 || to < 0.0) {
    return refused(
        "a fault-bend fold grows by slip up the fault; for extension take shear or fault_parallel_flow; to "
        "restore more than the fold has grown is not possible",
        path.line.points.front());
  }
  DOBRA_TRY(std::vector<Passage::Stage> stages, Passage(path, bedding).run(std::max(from, to)));
  const double least = std::min(from, to);
  std::erase_if(stages, [&](const Passage::Stage& stage) { return stage.to <= least; });
  stages.front().from = least;
  stages.back().to = std::max(from, to);
  return stages;
}

}  // namespace

base::Result<std::vector<BendStage>> bend_stages(const FaultPath& path, std::optional<base::Angle> bedding, double from,
                                                 double to) {
  DOBRA_TRY(const std::vector<Passage::Stage> stages, stages_of(path, bedding, from, to));
  std::vector<BendStage> bends;
  for (std::size_t k = 0; k + 1 < path.line.segment_count(); ++k) {
    for (std::size_t i = 0; i < stages.size(); ++i) {
      const Passage::Stage& stage = stages[i];
      if (i > 0 && stages[i - 1].packets[k] == stage.packets[k]) {
        bends.back().to = stage.to;
      } else {
        bends.push_back({path.line.points[k + 1], stage.folds[k], stage.from, stage.to});
      }
    }
  }
  return bends;
}

base::Result<FlowMap> fault_bend_fold(const FaultPath& path, std::optional<base::Angle> bedding, double from,
                                      double to) {
  DOBRA_TRY(const std::vector<Passage::Stage> stages, stages_of(path, bedding, from, to));
  FlowMap map;
  for (const Passage::Stage& stage : stages) {
    DOBRA_TRY(FlowDomains domains, FlowDomains::make(path, stage.speeds));
    map = map.then(FlowMap(std::make_shared<const FlowDomains>(std::move(domains)), stage.to - stage.from));
  }
  return to < from ? map.swapped() : map;
}

}  // namespace recon::kinematics
