// 1. The stretches of a bed become chains: their gaps are bridged, unless both ends lie on another bed.
// 2. The chains are put in order from above; every one makes a ring with the next one below, with the lowest and with
//    the highest: along the lower one, up on its right side, back along the upper one, down on its left side.
// 3. A side runs along the fault where both ends lie on it, else straight.
// 4. What leaves the cell is cut off.

#include "recon/faults/cell_rock.h"

#include <algorithm>
#include <map>
#include <optional>

#include "recon/section/section_faces.h"
#include "shared/topo/region.h"

namespace recon::faults {

namespace {

struct Chain {
  std::string bed;
  geom::Polyline line;
  bool first_on_bed = false, last_on_bed = false;  ///< Whether an end lies on another bed, which cuts it off.
};

/// A place on a contour of the cell.
struct OnContour {
  std::size_t contour = 0;
  std::size_t segment = 0;
  geom::Point at;
};

class CellCloser {
 public:
  explicit CellCloser(const Cell& cell) : cell_(cell) {
    for (const BedStretch& stretch : cell.stretches) beds_.add(stretch.line.box());
    rounding_ = 1e-7 * beds_.diagonal();
  }

  base::Result<CellRock> run() {
    make_chains();
    std::vector<geom::Polyline> rings;
    const std::size_t count = chains_.size();
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t next = i + 1;
      while (next < count && chains_[next].bed == chains_[i].bed) ++next;
      if (next < count) add_ring(i, next, rings);
      if (cut_off(i)) continue;
      if (i > 1 && !cut_off(0)) add_ring(0, i, rings);
      if (i + 2 < count && !cut_off(count - 1)) add_ring(i, count - 1, rings);
    }
    DOBRA_TRY(made_.rings, within_cell(rings));
    std::stable_sort(made_.closings.begin(), made_.closings.end(), [](const Closing& a, const Closing& b) {
      return geom::length(a.line.to - a.line.from) > geom::length(b.line.to - b.line.from);
    });
    return std::move(made_);
  }

 private:
  [[nodiscard]] bool cut_off(std::size_t chain) const {
    return chains_[chain].first_on_bed || chains_[chain].last_on_bed;
  }

  [[nodiscard]] bool on_other_bed(const std::string& bed, geom::Point p) const {
    return std::any_of(cell_.stretches.begin(), cell_.stretches.end(), [&](const BedStretch& other) {
      return other.bed != bed && geom::distance(other.line, p) <= rounding_;
    });
  }

  void make_chains() {
    std::map<std::string, std::vector<const geom::Polyline*>> beds;
    for (const BedStretch& stretch : cell_.stretches) beds[stretch.bed].push_back(&stretch.line);
    section::Section drawn;
    std::vector<Chain> chains;
    for (auto& [bed, lines] : beds) {
      put_in_order(lines);
      for (const geom::Polyline* line : lines) {
        const bool on_bed = on_other_bed(bed, line->points.front());
        if (chains.empty() || chains.back().bed != bed || (on_bed && chains.back().last_on_bed)) {
          chains.push_back({bed, *line, on_bed, false});
        } else {
          Chain& chain = chains.back();
          made_.closings.push_back({bed, {chain.line.points.back(), line->points.front()}});
          chain.line.points.insert(chain.line.points.end(), line->points.begin(), line->points.end());
        }
        chains.back().last_on_bed = on_other_bed(bed, line->points.back());
      }
    }
    for (const Chain& chain : chains) drawn.horizons.push_back({{}, chain.bed, chain.line, {}});
    for (const std::size_t i : section::stack_order(drawn)) chains_.push_back(std::move(chains[i]));
  }

  /// Along the bed. What faults have left behind them of a piece that runs past is left out.
  void put_in_order(std::vector<const geom::Polyline*>& lines) const {
    const auto by_length = [](const geom::Polyline* a, const geom::Polyline* b) {
      return geom::length(*a) < geom::length(*b);
    };
    const geom::Polyline* longest = *std::max_element(lines.begin(), lines.end(), by_length);
    std::erase_if(lines, [&](const geom::Polyline* line) {
      const bool at_wall = place_of(line->points.front()) || place_of(line->points.back());
      return line != longest && at_wall && geom::length(*line) <= cell_.tolerance;
    });
    geom::Vector way{0.0, 0.0};
    for (const geom::Polyline* line : lines) way = way + (line->points.back() - line->points.front());
    const auto along = [&](const geom::Polyline* line) {
      return geom::dot(way, geom::midpoint(line->points.front(), line->points.back()) - geom::Point{});
    };
    std::stable_sort(lines.begin(), lines.end(), [&](const auto* a, const auto* b) { return along(a) < along(b); });
  }

  /// Where an end lies on a fault.
  [[nodiscard]] std::optional<OnContour> place_of(geom::Point p) const {
    std::optional<OnContour> found;
    double nearest = cell_.tolerance;
    for (std::size_t c = 0; c < cell_.contours.size(); ++c) {
      const geom::Polyline& contour = cell_.contours[c];
      for (std::size_t i = 0; i < contour.segment_count(); ++i) {
        const geom::Segment segment = contour.segment(i);
        if (on_frame(segment) || geom::distance(segment, p) > nearest) continue;
        nearest = geom::distance(segment, p);
        found = OnContour{c, i, geom::interpolate(segment.from, segment.to, geom::nearest_fraction(segment, p))};
      }
    }
    return found;
  }

  [[nodiscard]] bool on_frame(const geom::Segment& s) const {
    const geom::Point low = cell_.frame.points[0], high = cell_.frame.points[2];
    return (s.from.x == s.to.x && (s.from.x == low.x || s.from.x == high.x)) ||
           (s.from.y == s.to.y && (s.from.y == low.y || s.from.y == high.y));
  }

  /// Anticlockwise along the contour; nothing if that leads over the frame.
  [[nodiscard]] std::optional<geom::Polyline> forward(const OnContour& from, const OnContour& to) const {
    const geom::Polyline& contour = cell_.contours[from.contour];
    geom::Polyline way{{from.at}, false};
    const geom::Point start = contour.segment(from.segment).from;
    std::size_t i = from.segment;
    if (i != to.segment || geom::distance(start, from.at) > geom::distance(start, to.at)) {
      do {
        way.points.push_back(contour.segment(i).to);
        i = (i + 1) % contour.segment_count();
        if (on_frame(contour.segment(i))) return std::nullopt;
      } while (i != to.segment);
    }
    way.points.push_back(to.at);
    return way;
  }

  /// From one end to that of another bed: along the fault where both lie on it, else straight.
  [[nodiscard]] geom::Polyline side(const Chain& from_chain, geom::Point from, geom::Point to) {
    const auto a = place_of(from);
    const auto b = place_of(to);
    if (a && b && a->contour == b->contour) {
      const auto up = forward(*a, *b);
      auto down = forward(*b, *a);
      if (down) down = geom::reversed(std::move(*down));
      if (up && (!down || geom::length(*up) <= geom::length(*down))) return *up;
      if (down) return *down;
    }
    if (a.has_value() != b.has_value()) made_.closings.push_back({from_chain.bed, {from, to}});
    return {{from, to}, false};
  }

  /// Of two chains the parts that face each other: one that the end of the other lies on goes no farther.
  static void trim(const Chain& ending, Chain& other, double rounding) {
    const auto meets = [&](geom::Point p) { return geom::distance(other.line, p) <= rounding; };
    std::vector<geom::Point>& points = other.line.points;
    const auto place = [&](geom::Point p) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < other.line.segment_count(); ++i) {
        if (geom::distance(other.line.segment(i), p) < geom::distance(other.line.segment(best), p)) best = i;
      }
      return static_cast<std::ptrdiff_t>(best);
    };
    const geom::Point first = ending.line.points.front(), last = ending.line.points.back();
    if (meets(last)) {
      points.erase(points.begin() + place(last) + 1, points.end());
      points.push_back(last);
    }
    if (other.line.segment_count() > 0 && meets(first)) {
      points.erase(points.begin(), points.begin() + place(first) + 1);
      points.insert(points.begin(), first);
    }
  }

  void add_ring(std::size_t upper_chain, std::size_t lower_chain, std::vector<geom::Polyline>& rings) {
    Chain upper = chains_[upper_chain], lower = chains_[lower_chain];
    if (upper.bed == lower.bed) return;
    trim(chains_[upper_chain], lower, rounding_);
    trim(chains_[lower_chain], upper, rounding_);
    geom::Polyline ring = lower.line;
    ring.closed = true;
    const auto append = [&](const std::vector<geom::Point>& points) {
      ring.points.insert(ring.points.end(), points.begin(), points.end());
    };
    append(side(lower, lower.line.points.back(), upper.line.points.back()).points);
    append(geom::reversed(upper.line).points);
    append(side(lower, upper.line.points.front(), lower.line.points.front()).points);
    ring = geom::without_repeated_points(std::move(ring));
    if (ring.points.size() > 2) rings.push_back(std::move(ring));
  }

  [[nodiscard]] base::Result<std::vector<geom::Polyline>> within_cell(const std::vector<geom::Polyline>& rings) const {
    DOBRA_TRY(std::vector<geom::Polyline> both, topo::region(rings, topo::Inside::Positive));
    if (both.empty()) return both;
    both.insert(both.end(), cell_.contours.begin(), cell_.contours.end());
    geom::Box all;
    for (const geom::Polyline& ring : both) all.add(ring.box());
    const geom::Box round = all.grown(all.diagonal());  // clockwise, so that what only one of them holds counts nothing
    both.push_back({{round.low, {round.low.x, round.high.y}, round.high, {round.high.x, round.low.y}}, true});
    return topo::region(both, topo::Inside::Positive);
  }

  const Cell& cell_;
  geom::Box beds_;
  double rounding_ = 0.0;  ///< m
  std::vector<Chain> chains_;
  CellRock made_;
};

}  // namespace

base::Result<CellRock> rock_of(const Cell& cell) { return CellCloser(cell).run(); }

}  // namespace recon::faults
