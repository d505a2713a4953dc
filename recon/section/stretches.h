#pragma once
// Which stretches of the lines of a section run free of everything else: they can stand in a planar subdivision as one
// straight edge each, and nothing changes but how it looks. So the subdivision has edges where lines meet or run close
// to each other, not as many as there are points.
//
// Each line stands under a tree of its parts; of a part are known its chord, how far it goes from that, and whether it
// runs in one direction of x or y. A stretch is a part that
//   runs in one direction, hence does not meet itself;
//   is apart from every stretch of every other line, and from those of its own line that do not follow it;
//   runs in a common direction with the stretches that it follows and that follow it, hence meets them at its ends
//   only.
// What fails that is halved, down to single segments. So the chords of the stretches and the single segments cross each
// other exactly where the lines do; between a stretch and its chord lies nothing else, so that faces and their
// neighbours are the same.  Page: docs/algorithms/units.md

#include <cstdint>
#include <span>
#include <vector>

#include "shared/geom/polyline.h"

namespace recon {
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::section {

/// Segments first .. last - 1 of a line; of a closed one with n points vertex n is vertex 0 again.
struct Stretch {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  [[nodiscard]] bool is_segment() const { return last - first == 1; }
};

class Stretches {
 public:
  /// Further lines, numbered as they stand. Where they come near to others, both are cut more finely.
  /// @cost O(n), and O(log n) for each place where lines run close to each other.
  void add(std::span<const geom::Polyline> lines);
  /// From now on every stretch is a segment.
  void cut_all();
  /// Of a line, in order, from its first point to its last.
  [[nodiscard]] std::vector<Stretch> of(std::size_t line) const;

 private:
  /// Segments in the smallest part that is free or not as a whole.
  static constexpr std::size_t leaf_size = 16;

  struct Node {
    geom::Point from;  ///< The chord.
    geom::Point to;
    double length = 0.0;  ///< Of the chord, m.
    double reach = 0.0;   ///< No point of the part is farther from the chord, m.
    geom::Box box;
    std::uint8_t runs = 0;  ///< Directions in which all segments run: bits for +x, -x, +y, -y.
    bool cut = false;       ///< Into its halves, a leaf into its segments.
    std::uint32_t first = 0;
    std::uint32_t last = 0;  ///< 0: no segments.
  };
  /// Node k has the halves 2k and 2k + 1.
  struct Tree {
    std::vector<Node> nodes;
    std::size_t leaves = 0;
    std::uint32_t segments = 0;
    bool closed = false;
    [[nodiscard]] bool is_leaf(std::size_t node) const { return node >= leaves; }
  };
  static Tree tree_of(const geom::Polyline& line);
  static void collect(const Tree& tree, std::size_t node, std::vector<Stretch>& stretches);
  static void cut_within(Tree& tree, std::size_t node, double margin);
  static void cut_between(Tree& a, std::size_t in_a, Tree& b, std::size_t in_b, double margin);

  std::vector<Tree> trees_;
  double greatest_ = 0.0;  ///< Of all coordinates.
};

}  // namespace recon::section
