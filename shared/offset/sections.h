#pragma once
// The treated curve at one distance.
//  1 pieces     the boundary of every pill and corner on the right side, cut on the bisector where neighbours overlap;
//               and, as scissors only, left side and end caps
//  2 cull       a piece is dropped on proof that all of it is nearer to the base than D
//  3 cuts       where pieces meet
//  4 sections   between two cuts a section is wholly valid or wholly invalid: one clearance query decides
//  5 assembly   valid sections are joined at their ends, at each free wedge; doubled ones count once, opposite ones cancel
// Notation: D distance, U the set within D of the base with its corners, tau the length below which two places are one.

#include <cstdint>
#include <vector>

#include "shared/geom/spatial_index.h"
#include "shared/offset/base_curve.h"
#include "shared/offset/clearance.h"

namespace dobra::offset {

/// A line from `a` to `b`, or the arc of radius D that goes anticlockwise, by at most half a turn, about `centre`.
struct RawPiece {
  enum class Kind { Line, Arc, Chord };  ///< Chord: an arc until the topology is known, then drawn straight.
  Kind kind = Kind::Line;
  bool wanted = true;  ///< False for scissors.
  Vec a, b, centre;
  std::uint32_t segment = 0;  ///< Of the base.
  std::uint32_t node_a = 0, node_b = 0;

  [[nodiscard]] bool is_line() const { return kind == Kind::Line; }
};

/// A part of a piece between two nodes.
struct Section {
  std::uint32_t piece;
  std::uint32_t from, to;  ///< Nodes.
};

/// A simple curve: sections in order.
struct Chain {
  std::vector<Section> sections;
  bool closed = false;
};

class Trimmer {
 public:
  Trimmer(const BaseCurve& base, const Clearance& clearance, Real distance, const OffsetOptions& options);

  /// Runs steps 1 to 5.
  std::vector<Chain> run();

  /// The chain as a polyline in the user's coordinates. Empty if it vanishes by rounding.
  [[nodiscard]] OffsetPiece output(const Chain& chain) const;

 private:
  struct Cut {
    std::uint32_t piece;
    Real at;  ///< Distance from the piece's start, straight; grows along lines and half-turns.
    std::uint32_t node;
  };
  /// The part of U that a mitre adds: a corner cut out between two normals and bounded by lines at distance D.
  struct Wedge {
    Vec corner, from, to;              ///< Unit normals at which it begins and ends.
    std::vector<Vec> bounds;           ///< Unit normals of its outer lines.
  };

  void make_pieces();
  void make_corner(std::size_t segment, std::vector<std::uint32_t>& start_node, std::vector<std::uint32_t>& end_node);
  void make_scissors();
  void add_arc(RawPiece::Kind kind, bool wanted, std::size_t segment, Vec centre, std::uint32_t a, std::uint32_t b);
  void cull();
  void find_cuts();
  void cut_pair(std::uint32_t i, std::uint32_t j);
  void cut_lines(std::uint32_t i, std::uint32_t j);
  void cut_line_arc(std::uint32_t line, std::uint32_t arc);
  void cut_arcs(std::uint32_t i, std::uint32_t j);
  void cut_at_ends(std::uint32_t piece, std::uint32_t other);
  void add_cut(std::uint32_t i, std::uint32_t j, Vec p);
  void merge_nodes();
  void make_sections();
  [[nodiscard]] bool valid(Vec p) const;
  [[nodiscard]] bool wholly_invalid(const RawPiece& piece) const;
  [[nodiscard]] geom::Box box_of(const RawPiece& piece) const;
  [[nodiscard]] bool on_arc(const RawPiece& arc, Vec p) const;
  [[nodiscard]] Vec middle(const Section& section) const;
  [[nodiscard]] Vec leaving(const Section& section) const;
  [[nodiscard]] Vec arriving(const Section& section) const;
  void remove_doubles();
  std::vector<Chain> assemble();
  void link_at(const std::vector<std::uint32_t>& in, const std::vector<std::uint32_t>& out);
  [[nodiscard]] std::uint32_t node(Vec p);

  const BaseCurve& base_;
  const Clearance& clearance_;
  const Real distance_;
  const OffsetOptions& options_;
  const Real tau_;
  std::vector<Vec> nodes_;
  std::vector<std::uint32_t> place_;  // the node that stands for each node after merging
  std::vector<RawPiece> pieces_;
  std::vector<Wedge> wedges_;
  geom::SpatialIndex wedge_index_;
  std::vector<Cut> cuts_;
  std::vector<Section> sections_;
  std::vector<std::uint32_t> follower_;
};

}  // namespace dobra::offset
