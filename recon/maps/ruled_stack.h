#pragma once
// One state (before or after) of a stack of lines with rulings between neighbours, and where a point lies in it.
// A band is what lies between two neighbouring lines; its rulings stand at the corners of both, its strips between the
// rulings. Nothing of a strip is stored but which corners of the two lines it lies between.
//
// Where is p:
//   1. Walk from the strip of the point before: along the band until p lies between the two rulings (far ahead by the
//      place u that p should have), then to the next band if p lies beyond a line, until no side has p beyond it.
//   2. That strip is the only one, unless a strip that is folded over lies there: strips turned the right way round
//      cover the stack once more than those turned the other way, so p has a second strip only inside of a folded one.
//      Blocks of strips that meet the box of a folded one are marked when the stack is built.
//   3. Otherwise the first strip that holds p, of all strips in the blocks whose boxes hold p.
//   4. None does: p lies outside the stack (or in a hole of a folded part). From the nearest place on its outline,
//      along the rulings, which go on straight.
// The answer is a function of p alone: the hint only makes it quicker.  Page: docs/algorithms/ruled_map.md

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "recon/maps/trace.h"
#include "shared/geom/box_pyramid.h"
#include "shared/geom/segment_tree.h"

namespace recon::maps {

/// What both states of a stack have in common: places, and which corners each ruling stands between.
struct Rulings {
  /// Last corners of the two lines at or before the ruling, and how far behind one of them it stands.
  struct Corners {
    std::uint32_t upper = 0;
    std::uint32_t lower = 0;
    double part = 0.0;  ///< Of the segment behind `upper`; negative: minus that of the segment behind `lower`.
  };
  std::vector<std::vector<double>> u;              ///< Of the corners of each line; increasing.
  std::vector<std::vector<Corners>> bands;         ///< One between two lines: its rulings, from first to last place.
  std::vector<std::vector<std::uint32_t>> blocks;  ///< Of a band: first ruling of each block, and the last of all.
  double least = 0.0;                              ///< Places nearer to each other are one.

  explicit Rulings(std::vector<std::vector<double>> places);
  [[nodiscard]] double place(std::size_t band, std::size_t ruling) const {
    const Corners at = bands[band][ruling];
    return std::max(u[band][at.upper], u[band + 1][at.lower]);
  }
  [[nodiscard]] std::size_t block_count() const { return blocks.front().size() - 1; }
};

/// Fractions across a strip (0 at the left ruling, 1 at the right) and down (0 at the upper line, 1 at the lower).
struct StripPlace {
  double across = 0.0;
  double down = 0.0;
};

class RuledStack {
 public:
  struct Ruling {
    geom::Point top;
    geom::Point bottom;
  };
  struct Strip {
    Ruling left;
    Ruling right;
  };

  /// @param points  of each line, one a place. @param by  how far the strips beyond the ends reach, m.
  RuledStack(std::shared_ptr<const Rulings> rulings, std::vector<std::vector<geom::Point>> points, double by,
             double tolerance);
  RuledStack(const RuledStack&) = delete;
  RuledStack& operator=(const RuledStack&) = delete;

  [[nodiscard]] const Rulings& rulings() const { return *rulings_; }
  /// The middle of the first strip that is folded over: its sides cross, or it is turned round.
  [[nodiscard]] std::optional<geom::Point> folded() const { return folded_; }
  /// Cells: strip 0 .. n + 1 of a band, band; 0 and n + 1 lie beyond the ends.
  [[nodiscard]] Strip strip(Cell cell) const;
  /// A cell and its strip.
  struct Held {
    Cell cell;
    Strip at;
  };
  [[nodiscard]] Held held(Cell cell) const { return {cell, knows(cell) ? strip(cell) : Strip{}}; }
  /// @param near  that of a point near p; becomes that of p.
  Spot locate(geom::Point p, Held& near) const;
  [[nodiscard]] bool is_outer(Cell cell) const { return cell.first == 0 || cell.first == ruling_count(cell.second); }
  /// Metres beyond the left ruling (side 0), the right one, the upper line or the lower one (3); -infinity where there
  /// is nothing to cross.
  [[nodiscard]] double beyond(Cell cell, const Strip& at, std::size_t side, geom::Point p) const;
  /// The name of p in a strip, wherever p lies, and the point of that name.
  [[nodiscard]] static StripPlace place_in(const Strip& at, geom::Point p);
  [[nodiscard]] static geom::Point point_at(const Strip& at, StripPlace place) {
    return geom::interpolate(geom::interpolate(at.left.top, at.left.bottom, place.down),
                             geom::interpolate(at.right.top, at.right.bottom, place.down), place.across);
  }
  /// Area per change of (across, down), m2; linear in both. 0 where two sides meet, to rounding.
  [[nodiscard]] static double jacobian(const Strip& at, StripPlace place);

 private:
  /// A band and its two lines.
  struct Band {
    const Rulings::Corners* rulings = nullptr;
    std::uint32_t count = 0;  ///< Of rulings.
    const geom::Point* top = nullptr;
    const geom::Point* bottom = nullptr;
  };
  [[nodiscard]] std::uint32_t ruling_count(std::size_t band) const { return bands_[band].count; }
  [[nodiscard]] Ruling ruling(const Band& band, std::uint32_t i) const;
  /// How a walk ends.
  enum class End {
    Inside,  ///< In a strip that holds p.
    Beside,  ///< In a strip that has p beyond no side that leads on; it may not hold p.
    Never,
  };
  [[nodiscard]] End walk(geom::Point p, Cell& cell, Strip& at) const;
  [[nodiscard]] End along_band(geom::Point p, Cell& cell, Strip& at) const;
  [[nodiscard]] End step_along(geom::Point p, Cell& cell, Strip& at) const;
  [[nodiscard]] bool knows(Cell cell) const {
    return cell.second < bands_.size() && cell.first > 0 && cell.first < ruling_count(cell.second);
  }
  [[nodiscard]] bool beyond_upper(const Strip& at, geom::Point p) const;
  [[nodiscard]] bool beyond_lower(const Strip& at, geom::Point p) const;
  [[nodiscard]] bool holds(const Strip& at, geom::Point p) const;
  [[nodiscard]] std::uint32_t strip_of(std::size_t band, double u) const;
  [[nodiscard]] double middle_of(Cell cell) const;
  void to_first(geom::Point p, Cell& cell, Strip& at) const;
  [[nodiscard]] std::optional<Cell> first_holder(geom::Point p, Strip& at) const;
  [[nodiscard]] Spot outside(geom::Point p, Strip& at) const;
  [[nodiscard]] bool doubtful(Cell cell) const;
  void build_blocks();

  std::shared_ptr<const Rulings> rulings_;
  std::vector<std::vector<geom::Point>> points_;  ///< Of each line.
  std::vector<Band> bands_;
  geom::Vector left_;  ///< The ends, moved by these, bound the strips beyond them.
  geom::Vector right_;
  double tolerance_ = 0.0;
  geom::BoxPyramid boxes_;      ///< Of the blocks, bands by places.
  std::vector<char> doubtful_;  ///< Blocks where strips may overlap.
  geom::SegmentTree top_;       ///< Of the first line and of the last one.
  geom::SegmentTree bottom_;
  std::optional<geom::Point> folded_;
};

}  // namespace recon::maps
