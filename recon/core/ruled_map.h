#pragma once
// Maps between stacks of lines, each pair of neighbours joined by rulings that share the place u along both:
//   P = (1 - v) T(u) + v B(u)   ->   P' = (1 - v) T'(u) + v B'(u)
// Proportional thickness is a stack of two lines, line-length unfolding one of all horizons, each going to a line of
// its own length. Bilinear in each quadrangle, with an inverse in closed form; single-valued where no quadrangle is
// folded over. Above the first line and below the last the rulings go on straight; beyond the ends the last ruling is
// moved along. Source: restoration.md 2.4.  Page: docs/algorithms/thickness.md

#include <array>
#include <optional>
#include <vector>

#include "recon/core/map.h"
#include "recon/core/segment_tree.h"
#include "recon/core/trace.h"

namespace recon::core {

/// One line of the stack and where it goes, with a common place u that grows along both.
struct RuledLine {
  std::vector<double> u;          ///< Increasing; the same first and last value for all lines of a stack.
  std::vector<geom::Point> from;  ///< One a value of u.
  std::vector<geom::Point> to;    ///< Likewise.
};

class RuledMap {
 public:
  RuledMap() = default;
  /// @param lines two or more, from the top down.
  explicit RuledMap(const std::vector<RuledLine>& lines, const MapOptions& options = {});

  [[nodiscard]] RuledMap swapped() const;
  /// The middle of the first quadrangle that is folded over (its sides cross, or it is turned round), in the source.
  [[nodiscard]] std::optional<geom::Point> folded() const { return folded_; }

  // What Tracer asks (trace.h). Cell: strip 0 .. n + 1 of a band, band.
  [[nodiscard]] Spot locate(geom::Point p, Cell hint) const;
  [[nodiscard]] std::array<double, 4> beyond(Cell cell, geom::Point p) const;
  [[nodiscard]] Carried carry(Cell cell, geom::Point p) const;
  [[nodiscard]] static bool keeps(const Spot& spot, geom::Point, const Spot& nearest) {
    return nearest.foot == Foot::InColumn && spot.foot == Foot::InColumn;
  }
  [[nodiscard]] geom::Point back(geom::Point image, Cell& hint) const;
  [[nodiscard]] bool is_outer(Cell cell) const;
  [[nodiscard]] static bool bends() { return true; }
  [[nodiscard]] const TraceTolerances& tolerances() const { return tolerances_; }

 private:
  /// Ruling i of a band joins top[i] and bottom[i]. The first and the last are moved ends, one length away.
  struct Side {
    std::vector<geom::Point> top;
    std::vector<geom::Point> bottom;
    SegmentTree top_tree;  ///< Of the segments of top, the moved ends left out.
    SegmentTree bottom_tree;
  };
  struct Band {
    std::vector<double> u;
    Side from;
    Side to;
  };
  /// Fractions across (0 at the left ruling, 1 at the right) and down (0 at the top, 1 at the bottom).
  struct Place {
    double across = 0.0;
    double down = 0.0;
  };
  static void extend(Side& side, double by);
  static Place place_in(const Side& side, std::size_t strip, geom::Point p);
  static geom::Point point_at(const Side& side, std::size_t strip, Place place);
  [[nodiscard]] Spot locate_on(bool target, geom::Point p, Cell hint) const;
  [[nodiscard]] bool walk(bool target, geom::Point p, Cell& cell) const;
  void to_first(bool target, geom::Point p, Cell& cell) const;
  [[nodiscard]] std::array<double, 4> beyond_on(bool target, Cell cell, geom::Point p) const;
  [[nodiscard]] std::size_t strip_of(std::size_t band, double u) const;
  [[nodiscard]] const Side& side(bool target, std::size_t band) const {
    return target ? bands_[band].to : bands_[band].from;
  }

  std::vector<Band> bands_;
  std::optional<geom::Point> folded_;
  std::optional<geom::Point> folded_target_;
  TraceTolerances tolerances_;
};

}  // namespace recon::core
