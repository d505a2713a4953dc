#pragma once
// Second half of the general engine: the treated curve at one distance, from the candidate pieces.
//  1 pairs     A tree with direction masks finds the pieces that may meet. Pieces on the other side of the base only
//              serve to cut; they are made where a block of them comes near the curve.
//  2 cuts      Where the pairs meet, and in which order along each piece (contact.h).
//  3 sections  What lies between two cuts, of however many pieces, is valid or invalid as a whole: one query decides.
//  4 assembly  Valid sections are joined at their ends. Sections that lie on each other count once.
// A cut is symbolic: it is known by the pair that it comes from. Its place is rounded; decisions are not.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "shared/offset/general/candidates.h"
#include "shared/offset/general/contact.h"
#include "shared/offset/general/pairs.h"
#include "shared/offset/general/validity.h"
#include "shared/offset/kernel/piece_writer.h"

namespace dobra::offset::general {

class Trimmer {
 public:
  Trimmer(const BaseCurve& base, const Clearance& clearance, Outline::Sides sides, double distance,
          const OffsetOptions& options, const base::Progress& progress = {});

  /// All pieces of the curve, in order of their first base segment; none if progress was cancelled.
  std::vector<OffsetPiece> run();
  /// The same, given what is known to lie in U. @param found  see candidates().
  std::vector<OffsetPiece> run(const Buried& known, Buried* found);

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::uint32_t start_of = none - 1;
  static constexpr std::uint32_t end_of_piece = none - 2;
  /// A piece that may meet others.
  struct HotPiece {
    Shape<Real> shape;
    std::uint32_t piece;
    std::uint32_t node_a, node_b;
  };
  /// A place; symbolic if it is an end of a hot piece (j = start_of, end_of) or the crossing of two.
  struct Node {
    Vec at;
    std::uint32_t i, j;
  };
  struct Cut {
    Real at;       ///< Distance from the piece's start, straight; grows along lines and arcs up to half a turn.
    double error;  ///< Its bound.
    std::uint32_t hot;
    std::uint32_t node;
  };
  struct Section {
    std::uint32_t first, last;  ///< Pieces.
    std::uint32_t from, to;     ///< Nodes.
  };
  /// A simple curve: some sections in a row.
  struct Chain {
    std::size_t first, last;
    bool closed;
  };
  void warm();
  template <class T>
  [[nodiscard]] Shape<T> whole(Site s) const;
  template <class T>
  [[nodiscard]] Shape<T> shape(const Piece& piece, const Contact<T>& a, const Contact<T>& b) const;
  template <class T>
  [[nodiscard]] Contact<T> end_of(const Piece& piece, bool start) const;
  [[nodiscard]] double error_of(Site s) const;

  void cut_pair(std::uint32_t i, std::uint32_t j);
  template <class T>
  void add_cuts(std::uint32_t i, std::uint32_t j, const Contacts<T>& contacts);
  void add_cut(std::uint32_t hot, std::uint32_t node, double slide);
  void merge_twins();
  void order_cuts();
  void order_piece(std::vector<Cut>& cuts);
  void order_in_doubt(Cut* first, Cut* last);
  void merge(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] std::uint32_t representative(std::uint32_t node);
  const Shape<High>& fine_shape(std::uint32_t hot);
  const VecOf<High>& fine(std::uint32_t node);

  void make_sections();
  void add_section(const Section& section);
  void tell_buried(Buried& found) const;
  template <class T>
  [[nodiscard]] VecOf<T> place(std::uint32_t node) const;
  template <class T>
  [[nodiscard]] VecOf<T> middle(const Section& section, std::uint32_t piece) const;
  [[nodiscard]] bool valid(const Section& section, std::uint32_t piece);

  void remove_doubles();
  std::vector<Chain> assemble();
  void link();
  void link_at(std::span<const std::uint32_t> in, std::span<const std::uint32_t> out);
  [[nodiscard]] Vec heading(std::uint32_t piece, std::uint32_t node) const;
  [[nodiscard]] OffsetPiece output(const Chain& chain) const;
  [[nodiscard]] bool is_whole_block(const Block& block, std::uint32_t k, std::uint32_t last) const;
  std::uint32_t write_block(PieceWriter& writer, std::uint32_t k, std::uint32_t last) const;
  [[nodiscard]] std::uint32_t node(Vec p, std::uint32_t i = none, std::uint32_t j = none);
  [[nodiscard]] std::uint32_t segment_of(std::uint32_t piece) const { return pieces_[piece].step(); }
  [[nodiscard]] Flat start(std::uint32_t k) const { return place_of(pieces_[k], true, outline_); }
  [[nodiscard]] Flat end(std::uint32_t k) const { return place_of(pieces_[k], false, outline_); }
  template <class Ends>
  [[nodiscard]] Flat place_of(const Piece& piece, bool start, Ends& ends) const {
    const std::uint32_t trim = start ? piece.trim_a : piece.trim_b;
    if (trim != Piece::none && clearance_.has_far_mitres()) return flat(end_of<Real>(piece, start).at);
    return start ? chain_.start(ends, piece) : chain_.end(ends, piece);
  }

  const BaseCurve& base_;
  const Clearance& clearance_;
  const OffsetOptions& options_;
  const Outline outline_;
  WitnessSearch witnesses_;
  Validity validity_;
  const base::Progress& progress_;
  Candidates chain_;
  std::vector<Piece>& pieces_ = chain_.pieces;
  std::uint32_t wanted_ = 0;  // the pieces before this one are of the right side, the others are cutters
  Pairing::Pairs pairs_;
  std::vector<std::uint32_t> hot_of_;
  std::vector<HotPiece> hot_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint32_t, Shape<High>> fine_shapes_;
  std::unordered_map<std::uint32_t, VecOf<High>> fine_;
  std::vector<std::uint32_t> place_;  // the node that stands for each node after merging
  std::vector<char> touched_;         // places where something is cut
  std::vector<Cut> cuts_;
  std::vector<std::uint32_t> twins_;  // hot pieces that coincide with others in part
  std::vector<std::uint32_t> ends_;   // nodes of ends that lie on other pieces
  std::vector<Section> sections_;
  std::vector<std::uint32_t> follower_;
  std::vector<char> has_leader_;
};

}  // namespace dobra::offset::general
