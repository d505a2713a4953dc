#pragma once
// Which pieces may meet. Pieces of the right side are grouped by the 16 steps that they belong to. The box of a nearly
// complete group follows from its block (clearance.h) without a look at any piece. Where boxes of groups overlap, the
// boxes of runs of four pieces are compared, then those of pieces, then the pieces' convex hulls: what a margin far
// above rounding separates does not meet. Pieces on the other side of the base only serve to cut; they are called
// cutters, and are made where a block comes near the curve.

#include <array>
#include <utility>
#include <vector>

#include "shared/base/progress.h"
#include "shared/offset/general/candidates.h"
#include "shared/offset/general/witness.h"
#include "shared/offset/kernel/chain_tree.h"

namespace dobra::offset::general {

class Pairing {
 public:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  /// @param chain  the candidates of the right side; gets the cutters.
  /// @param witnesses  those that found them.
  Pairing(const Outline& outline, const Clearance& clearance, Candidates& chain, WitnessSearch& witnesses,
          const base::Progress& progress);

  /// Indices of pieces, the first one of the right side; linked neighbours are no pair. Incomplete if progress was
  /// cancelled.
  /// @param known, found  see candidates().
  /// @cost  O(n) where the curve does not come near itself, some 10 ns a segment.
  Pairs run(const Buried& known, Buried* found);

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::size_t run_size = 4;
  /// A piece: the hull of its ends and, of an arc, the crossing of its end tangents.
  struct PieceHull {
    FloatBox box;
    Site site;
    std::uint32_t piece;
    Flat a, b, m;
    [[nodiscard]] bool is_arc() const { return site.kind == SiteKind::Arc || site.kind == SiteKind::SecondArc; }
  };
  /// The pieces of one group, or cutters of one leaf of the other side.
  struct Bunch {
    std::size_t group = none;  ///< Or leaf.
    FloatBox box;
    std::vector<PieceHull> hulls;
    std::array<FloatBox, 3 * Block::size / run_size> runs;  ///< Of so many hulls each.
    [[nodiscard]] std::size_t run_count() const { return (hulls.size() + run_size - 1) / run_size; }
  };
  struct Group {
    std::uint32_t first, last;  ///< Pieces.
  };

  void make_groups();
  void find_parts();
  [[nodiscard]] bool is_long(const Piece& piece) const;
  [[nodiscard]] PieceHull hull(Site site, std::uint32_t piece, Flat a, Flat b) const;
  template <class Visit>
  void each_hull(const Group& group, const Visit& visit) const;
  void load(std::size_t group, Bunch& bunch) const;
  static void add_runs(Bunch& bunch);
  /// A bunch that stays valid until the next call but one.
  [[nodiscard]] const Bunch& cached(std::size_t group);
  /// Pairs of runs whose boxes overlap: visit(first hull, its last, first, last).
  template <class Visit>
  static void each_overlap(const Bunch& p, const Bunch& q, const Visit& visit);
  [[nodiscard]] bool apart(const PieceHull& p, const PieceHull& q) const;
  [[nodiscard]] bool beyond_an_edge(const PieceHull& p, const PieceHull& q) const;
  /// The groups that others than their neighbours may meet.
  [[nodiscard]] ChainTree crowd_tree();
  void pair_own(const ChainTree& tree);
  [[nodiscard]] bool goes_straight_on(std::size_t a, std::size_t b) const;
  void pair_alone();
  void pair_groups(std::size_t a, std::size_t b);
  [[nodiscard]] std::uint32_t block_of(std::size_t group) const {
    return chain_.pieces[groups_[group].first].step() / Block::size;
  }
  [[nodiscard]] Pairs near_blocks(const ChainTree& tree) const;
  void cut_by_caps();
  void pair_cutters(const ChainTree& tree);
  void make_cutters(std::uint32_t leaf);
  void add_cutter(Site site, Flat a, Flat b) {
    if (!known_->holds(site)) cutters_.hulls.push_back(hull(site, none, a, b));
  }
  void add_corner_cutters(std::uint32_t step, const Outline::Junction& junction);
  bool is_needed(PieceHull& cutter);
  void cut_with(const Bunch& near);

  const Outline& outline_;
  const Clearance& clearance_;
  const BaseCurve& base_;
  Candidates& chain_;
  WitnessSearch& witnesses_;
  const base::Progress& progress_;
  const Buried* known_ = nullptr;
  Buried* found_ = nullptr;
  const std::uint32_t wanted_;  // the pieces before this one are of the right side, the others are cutters
  const double margin_;
  /// What is left of a long line when what surely lies in U is taken off its ends: what crosses that is not asked for,
  /// as no piece becomes valid or invalid there.
  struct Part {
    std::uint32_t piece;
    bool empty;
    Flat a, b;
  };
  std::vector<Part> parts_;  // in order of the pieces
  std::vector<Group> groups_;
  std::vector<ChainTree::Leaf> leaves_;  // of the groups
  std::vector<char> alone_;
  std::vector<std::uint32_t> crowd_;  // groups that are not
  std::vector<Bunch> cache_;
  Bunch spare_;
  const Bunch* latest_ = nullptr;
  Bunch cutters_;
  Pairs pairs_;
};

}  // namespace dobra::offset::general
