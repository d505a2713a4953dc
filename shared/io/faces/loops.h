#pragma once
// Edges of wires as loops that close in the chart, the face on their left.

#include <variant>

#include "shared/io/faces/piece.h"

namespace dobra::io::faces {

/// What the loops of a face are measured by.
struct Bench {
  const WholeSurface& whole;
  const surf::Surface& surface;  ///< Over all pieces, and a period more to all sides.
  double diagonal;               ///< Of the face, m.
  const ImportOptions& options;
  Report& report;
  surf::trim::SharedCurveId& next_shared;  ///< For seams that are made here.

  [[nodiscard]] geom::Point3 at(geom::Point uv) const { return surface.at(uv); }
  /// Length in space of a straight line of the chart, by chords.
  [[nodiscard]] double stretch(geom::Point a, geom::Point b) const;
  /// How far ends may be apart in space, m.
  [[nodiscard]] double allowed(const Piece& a, const Piece& b) const;
  /// Whole periods that bring b nearest to a.
  [[nodiscard]] geom::Vector periods(geom::Point a, geom::Point b) const;
};

/// Pieces that follow each other; `round` is what the last one ends beyond the first: nothing, or whole periods.
struct Chain {
  Loop pieces;
  geom::Vector round{};
};

template <class T>
using Outcome = std::variant<T, Refusal>;

/// Pieces of one wire in order, as one chain or more.
Outcome<std::vector<Chain>> chained(const Bench& bench, Loop wire);
/// The ends of pieces that follow each other, and of the last and the first, made the same points.
Loop joined(const Bench& bench, Loop loop);

/// Edges that are used twice taken out: in one direction the second, in both directions both, which become lines.
void take_out_twice(const Bench& bench, std::vector<Loop>& wires, Loop& lines);

/// Chains of all wires as closed loops, turned and nested; `lines` moved by periods to lie in them.
Outcome<std::vector<Loop>> loops_of(const Bench& bench, std::vector<Chain> chains, Loop& lines);

}  // namespace dobra::io::faces
