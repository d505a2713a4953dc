// Points and lines through a section that is restored block by block.

#include <algorithm>

#include "recon/jigsaw/blockwise.h"
#include "shared/geom/simplify.h"

namespace recon::jigsaw {

namespace {

/// Of the section's size: what is no farther from the boundary of a block lies on it.
constexpr double on_boundary = 1e-8;
constexpr int most_halvings = 60;

/// Which unfolded block a place of the restored section belongs to.
class Holder {
 public:
  explicit Holder(const Blockwise& made) : made_(made) {}

  /// @param first  is asked before all others.
  [[nodiscard]] std::optional<std::size_t> of(geom::Point p, std::optional<std::size_t> first = {}) const {
    if (first && (holds(*first, p) || touches(*first, p))) return first;
    return beside({}, p);
  }
  /// Of all blocks but one.
  [[nodiscard]] std::optional<std::size_t> beside(std::optional<std::size_t> but, geom::Point p) const {
    for (std::size_t b = 0; b < made_.blocks.size(); ++b) {
      if (b != but && holds(b, p)) return b;
    }
    for (std::size_t b = 0; b < made_.blocks.size(); ++b) {
      if (b != but && touches(b, p)) return b;
    }
    return std::nullopt;
  }

  /// From a place on the boundary of a block a little on, so that it lies in the block.
  [[nodiscard]] geom::Point into(std::optional<std::size_t> block, geom::Point from, geom::Point to) const {
    const geom::Vector step = 1e-9 * made_.size * geom::normalised(to - from);
    for (double steps = 1.0; block && steps <= 64.0; steps *= 2.0) {
      const geom::Point p = from + steps * step;
      if (geom::distance(from, p) < geom::distance(from, to) && holds(*block, p)) return p;
    }
    return from;
  }
  /// Whether a place is of that block (or of none), without what only touches it.
  [[nodiscard]] bool inside(std::optional<std::size_t> block, geom::Point p) const {
    return block ? holds(*block, p) : !of(p);
  }

 private:
  [[nodiscard]] const moving::MovingPart& area(std::size_t b) const { return made_.parts[made_.blocks[b].part].area; }
  [[nodiscard]] bool holds(std::size_t b, geom::Point p) const {
    return area(b).fate_of(made_.blocks[b].inverse(p)) == moving::Fate::Moves;
  }
  [[nodiscard]] bool touches(std::size_t b, geom::Point p) const {
    const geom::Point from = made_.blocks[b].inverse(p);
    const std::vector<geom::Polyline>& contours = area(b).contours();
    return std::any_of(contours.begin(), contours.end(), [&](const geom::Polyline& contour) {
      return geom::distance(contour, from) <= on_boundary * made_.size;
    });
  }

  const Blockwise& made_;
};

void append(const geom::Polyline& more, geom::Polyline& line) {
  line.points.insert(line.points.end(), more.points.begin(), more.points.end());
}

}  // namespace

geom::Point Blockwise::forward(geom::Point p) const {
  for (const UnfoldedBlock& block : blocks) {
    if (parts[block.part].area.fate_of(p) == moving::Fate::Moves) return block.forward(p);
  }
  return p;
}

geom::Polyline Blockwise::forward(const geom::Polyline& line) const {
  geom::Polyline made{{}, line.closed};
  for (const PartOfLine& piece : split(line, parts, 0.0)) {
    const auto is = [&](const UnfoldedBlock& block) { return piece.part == block.part; };
    const auto block = std::find_if(blocks.begin(), blocks.end(), is);
    append(block == blocks.end() ? piece.line : block->forward(piece.line), made);
  }
  return geom::without_repeated_points(std::move(made));
}

geom::Point Blockwise::inverse(geom::Point p) const {
  const auto block = Holder(*this).of(p);
  return block ? blocks[*block].inverse(p) : p;
}

geom::Polyline Blockwise::inverse(const geom::Polyline& line) const {
  const Holder holder(*this);
  geom::Polyline made{{}, line.closed};
  std::vector<geom::Point> points = line.points;
  if (line.closed) points.push_back(points.front());
  geom::Polyline run{{points.front()}, false};
  auto now = holder.of(points.front());
  const auto finish = [&](geom::Point end) {
    if (!(run.points.back() == end)) run.points.push_back(end);
    append(now && run.points.size() > 1 ? blocks[*now].inverse(run)
           : now                        ? geom::Polyline{{blocks[*now].inverse(end)}, false}
                                        : run,
           made);
    run.points = {end};
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    std::size_t turns = 2 * blocks.size() + 2;  // a straight line passes no more blocks, and back
    for (auto next = holder.of(points[i], now); next != now && turns > 0; --turns) {
      double in = 0.0, out = 1.0;  // of the way from the run's end
      const geom::Point start = run.points.back();
      for (int k = 0; k < most_halvings; ++k) {
        const double middle = 0.5 * (in + out);
        (holder.inside(now, geom::interpolate(start, points[i], middle)) ? in : out) = middle;
      }
      finish(geom::interpolate(start, points[i], in));
      run.points = {geom::interpolate(start, points[i], out)};
      now = holder.beside(now, run.points.front());
      run.points.front() = holder.into(now, run.points.front(), points[i]);
      next = holder.of(points[i], now);
    }
    run.points.push_back(points[i]);
  }
  const geom::Point end = run.points.back();
  finish(end);
  if (line.closed) made.points.pop_back();
  return geom::without_near_points(std::move(made), 2.0 * on_boundary * size);
}

}  // namespace recon::jigsaw
