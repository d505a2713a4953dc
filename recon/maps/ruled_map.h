#pragma once
// Maps between stacks of lines, each pair of neighbours joined by rulings that share the place u along both:
//   P = (1 - v) T(u) + v B(u)   ->   P' = (1 - v) T'(u) + v B'(u)
// Proportional thickness is a stack of two lines. Line length is a stack of all horizons, each of which goes to a line
// of its own length. The map is bilinear in each strip, has an inverse in closed form, and is single-valued where no
// strip is folded over. Above and below the stack the rulings go on straight; beyond its ends the last one moves along.
// Where a point lies: ruled_stack.h. Pages: docs/algorithms/ruled_map.md, docs/algorithms/thickness.md

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "recon/maps/map.h"
#include "recon/maps/ruled_stack.h"
#include "recon/maps/trace.h"

namespace recon::maps {

/// One line of the stack and where it goes, with a common place u that grows along both.
struct RuledLine {
  std::vector<double> u;          ///< Increasing; the same first and last value for all lines of a stack.
  std::vector<geom::Point> from;  ///< One a value of u.
  std::vector<geom::Point> to;    ///< Likewise.
};

/// A value; copies share what they stand on.
class RuledMap {
 public:
  RuledMap() = default;
  /// @param lines two or more, from the top down.
  /// @cost O(n) for n points of all lines, bands in parallel.
  explicit RuledMap(std::vector<RuledLine> lines, const MapOptions& options = {});

  [[nodiscard]] RuledMap swapped() const;
  /// The middle of the first strip that is folded over (its sides cross, or it is turned round), in the source.
  [[nodiscard]] std::optional<geom::Point> folded() const { return from_->folded(); }
  [[nodiscard]] const Rulings& rulings() const { return from_->rulings(); }
  /// What is known of a point near the next one.
  using Hint = RuledStack::Held;
  [[nodiscard]] Hint hint(Cell cell) const { return from_->held(cell); }
  /// Where a single point goes.  @param hint  of a point near it; becomes that of this one.
  [[nodiscard]] geom::Point map(geom::Point p, Hint& hint) const { return across(*from_, *to_, p, hint); }

  // What Tracer asks (trace.cpp). Cell: strip 0 .. n + 1 of a band, band.
  struct Entered {
    Cell cell;
    RuledStack::Strip from;
    RuledStack::Strip to;
  };
  [[nodiscard]] Entered enter(Cell cell) const { return {cell, from_->strip(cell), to_->strip(cell)}; }
  [[nodiscard]] Spot locate(geom::Point p, Cell hint) const {
    Hint near = from_->held(hint);
    return from_->locate(p, near);
  }
  static constexpr std::size_t sides = 4;
  /// Of the strips that hold a point within the tolerance the first is taken.
  static constexpr bool first_holds = true;
  [[nodiscard]] double beyond(const Entered& at, std::size_t side, geom::Point p) const {
    return from_->beyond(at.cell, at.from, side, p);
  }
  [[nodiscard]] static Carried carry(const Entered& at, geom::Point p);
  [[nodiscard]] static bool keeps(const Spot& spot, geom::Point, const Spot& nearest) {
    return nearest.foot == Foot::InColumn && spot.foot == Foot::InColumn;
  }
  [[nodiscard]] Hint hint_back(Cell cell) const { return to_->held(cell); }
  [[nodiscard]] geom::Point back(geom::Point image, Hint& hint) const { return across(*to_, *from_, image, hint); }
  [[nodiscard]] bool is_outer(Cell cell, geom::Point) const { return from_->is_outer(cell); }
  [[nodiscard]] static bool bends() { return true; }
  /// det F at a point by the formula of a cell; not finite where the cell has no area there.
  [[nodiscard]] static double determinant(const Entered& at, geom::Point p) {
    const StripPlace place = RuledStack::place_in(at.from, p);
    return RuledStack::jacobian(at.to, place) / RuledStack::jacobian(at.from, place);
  }
  [[nodiscard]] const TraceTolerances& tolerances() const { return tolerances_; }

 private:
  static geom::Point across(const RuledStack& from, const RuledStack& to, geom::Point p, Hint& hint);

  std::shared_ptr<const RuledStack> from_;
  std::shared_ptr<const RuledStack> to_;
  TraceTolerances tolerances_;
};

}  // namespace recon::maps
