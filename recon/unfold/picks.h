#pragma once
// The digitised lines of a section under errors of picking: horizons, faults, topographies and polygons move by smooth
// normal errors, each by its own, and the contours of units move with the lines that they lie on. Each draw is a
// function of the seed and its number alone. Source: [salmon2011philox]. Page: docs/algorithms/ledger.md

#include <cstdint>
#include <optional>
#include <vector>

#include "recon/section/section.h"

namespace recon::unfold {

struct PickErrors {
  double deviation = 0.0;    ///< Of x and of z of every pick, m.
  double correlation = 1.0;  ///< Errors of picks nearer than this along a line are alike, m.
  std::uint64_t seed = 0;
};

class Picks {
 public:
  /// @param contours  closed ones, each vertex on the lines of the section or alone.
  Picks(const section::Section& section, std::vector<geom::Polyline> contours, const PickErrors& errors);

  /// One draw: the lines, and the contours in their order. Neighbours that share vertices do so in every draw.
  struct Draw {
    std::vector<geom::Polyline> horizons;
    std::vector<geom::Polyline> contours;
  };
  /// A vertex on one line moves with it. Where two lines meet, it goes to where the moved lines meet (with the first if
  /// they run alike); the border of the section stays. A polygon's vertex that lies on no other line moves by the
  /// polygon's own errors: a corner in the middle of an edge of another polygon may leave that edge in a draw
  /// (`share_edges` gives the edge a vertex there).
  /// @cost O(vertices)
  [[nodiscard]] Draw draw(std::uint32_t number) const;

 private:
  /// A place on a line: in a segment, `part` of the way along it.
  struct Anchor {
    std::size_t line = 0;
    std::size_t segment = 0;
    double part = 0.0;
  };
  struct Vertex {
    geom::Point at;
    std::optional<Anchor> first;   ///< Nothing: it stays.
    std::optional<Anchor> second;  ///< Where two lines meet.
  };
  using Errors = std::vector<geom::Vector>;  ///< One a vertex of a line.

  void anchor(const std::vector<geom::Polyline>& contours, std::size_t polygons);
  /// Of line `line` in draw `number`: normal errors at every correlation length along it, between them in proportion,
  /// each of the same deviation.
  [[nodiscard]] Errors errors_of(std::size_t line, std::uint32_t number) const;
  [[nodiscard]] geom::Point moved(const Vertex& vertex, const std::vector<Errors>& errors) const;

  PickErrors how_;
  std::vector<geom::Polyline> lines_;  ///< Horizons, faults and topographies, the border, polygons.
  std::vector<std::vector<double>> arcs_;
  std::size_t horizons_ = 0;
  std::optional<std::size_t> border_;
  std::vector<std::vector<Vertex>> contours_;
};

}  // namespace recon::unfold
