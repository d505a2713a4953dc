#pragma once
// Tier 1, second half: the treated curve at one distance, from the pieces that survive the stack pass.
//  1 pairs      that may meet, from a tree with direction masks; only the pieces in them are looked at again, in Real. What lies on
//               the other side of the base only serves to cut: its pieces are made where a block of them comes near the curve
//  2 cuts       where those meet; what comes within tau is cut too, which does no harm
//  3 sections   between two cuts a section, of however many pieces, is wholly valid or wholly invalid: one query decides
//  4 assembly   valid sections are joined at their ends, at each free wedge; doubled ones count once, opposite ones cancel
// Notation: D distance, U the set within D of the base with its corners, tau the length below which two places are one.

#include <cstdint>
#include <vector>

#include "shared/offset/chain_tree.h"
#include "shared/offset/clearance.h"
#include "shared/offset/survivors.h"

namespace dobra::offset {

class Trimmer {
 public:
  Trimmer(const BaseCurve& base, const Clearance& clearance, Outline::Sides sides, double distance,
          const OffsetOptions& options, const base::Progress& progress = {});

  /// All pieces of the curve, in order of their first base segment; none if progress was cancelled.
  std::vector<OffsetPiece> run();
  /// The same, given what is known to lie in U. @param found  see survivors().
  std::vector<OffsetPiece> run(const Buried& known, Buried* found);

 private:
  /// A piece that may meet others, in Real.
  struct HotPiece {
    std::uint32_t piece;
    bool line, wanted;
    Vec a, b, centre;
    std::uint32_t node_a, node_b;
  };
  struct Cut {
    std::uint32_t hot;
    Real at;  ///< Distance from the piece's start, straight; grows along lines and arcs up to half a turn.
    std::uint32_t node;
  };
  struct Section {
    std::uint32_t first, last;  ///< Pieces.
    std::uint32_t from, to;     ///< Nodes.
  };
  /// A simple curve: sections in order.
  struct Chain {
    std::vector<Section> sections;
    bool closed = false;
  };
  /// Pieces of one block of 16 steps.
  struct Group {
    std::uint32_t first, last;
  };
  struct Item {
    FloatBox box;
    std::uint32_t piece;
  };
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  void find_pairs(const Buried& known, Buried* found);
  [[nodiscard]] std::vector<ChainTree::Leaf> make_groups();
  [[nodiscard]] FloatBox box(Site s, Flat a, Flat b) const;
  void add_items(const Group& group, std::vector<Item>& items) const;
  void pair_own(const ChainTree& tree);
  void pair_scissors(const ChainTree& tree, const Buried& known, Buried* found);
  template <class Add>
  void each_scissor(std::uint32_t step, const Add& add) const;
  void warm();
  [[nodiscard]] Vec exact_end(const Piece& piece, bool start) const;
  [[nodiscard]] Vec meet(Site s, Site t, Flat near) const;
  [[nodiscard]] Vec centre(Site s) const { return outline_.to<Real>(s.step); }
  [[nodiscard]] Vec line_normal(Site s) const;

  void cut_pair(std::uint32_t i, std::uint32_t j);
  void cut_lines(std::uint32_t i, std::uint32_t j);
  void cut_line_arc(std::uint32_t line, std::uint32_t arc);
  void cut_arcs(std::uint32_t i, std::uint32_t j);
  void cut_at_ends(std::uint32_t piece, std::uint32_t other);
  void add_cut(std::uint32_t i, std::uint32_t j, Vec p);
  [[nodiscard]] bool on_arc(const HotPiece& arc, Vec p) const;
  void merge_nodes();

  void make_sections();
  void add_section(Section section);
  [[nodiscard]] Vec part_start(const Section& s, std::uint32_t piece) const;
  [[nodiscard]] Vec part_end(const Section& s, std::uint32_t piece) const;
  [[nodiscard]] Vec middle(const Section& section, std::uint32_t piece) const;
  [[nodiscard]] bool valid(Vec p) const;

  void remove_doubles();
  std::vector<Chain> assemble();
  void link_at(const std::vector<std::uint32_t>& in, const std::vector<std::uint32_t>& out);
  [[nodiscard]] Vec leaving(const Section& section) const;
  [[nodiscard]] Vec arriving(const Section& section) const;
  [[nodiscard]] OffsetPiece output(const Chain& chain) const;
  [[nodiscard]] std::uint32_t node(Vec p);
  [[nodiscard]] std::uint32_t segment_of(std::uint32_t piece) const { return pieces_[piece].step(); }
  [[nodiscard]] Flat start(std::uint32_t k) const { return chain_.start(outline_, pieces_[k]); }
  [[nodiscard]] Flat end(std::uint32_t k) const { return chain_.end(outline_, pieces_[k]); }

  const BaseCurve& base_;
  const Clearance& clearance_;
  const OffsetOptions& options_;
  const Outline outline_;
  const Real distance_;
  const Real tau_;
  const base::Progress& progress_;
  Survivors chain_;
  std::vector<Piece>& pieces_ = chain_.pieces;
  std::uint32_t wanted_ = 0;          // the pieces before this one are of the right side, the others are scissors
  std::vector<Group> groups_;
  Pairs pairs_;
  std::vector<std::uint32_t> hot_of_;
  std::vector<HotPiece> hot_;
  std::vector<Vec> nodes_;
  std::vector<std::uint32_t> place_;  // the node that stands for each node after merging
  std::vector<char> touched_;         // places where something is cut
  std::vector<Cut> cuts_;
  std::vector<Section> sections_;
  std::vector<std::uint32_t> follower_;
  std::vector<char> has_leader_;
};

}  // namespace dobra::offset
