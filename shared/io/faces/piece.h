#pragma once
// Edges in the chart while a face is imported, and what is said about them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/io/faces/geometry.h"
#include "shared/io/faces/import.h"

namespace dobra::io::faces {

/// An edge on its way round a loop, from `from` to `to` of its curve.
struct Piece {
  surf::Curve curve;
  double from = 0.0, to = 1.0;
  std::optional<surf::Curve> space = std::nullopt;  ///< In the world, over the same edge.
  double space_from = 0.0, space_to = 1.0;
  brep::Index edge = 0;                             ///< The shape.
  std::optional<brep::Index> drawn = std::nullopt;  ///< Its curve of the file's chart curves.
  bool against = false;                             ///< Followed against the edge.
  bool still = false;                               ///< One point in space.
  std::size_t start = 0, end = 0;                   ///< The vertices' shapes, 0 for none, else number + 1.
  double tolerance = 0.0;                           ///< Of edge and vertices, the greatest.
  std::optional<surf::trim::SharedCurveId> shared = std::nullopt;
  std::string name = {};

  [[nodiscard]] geom::Point at(double t) const {
    const geom::Point3 p = curve.at(t);
    return {p.x, p.y};
  }
  [[nodiscard]] geom::Point begin_at() const { return at(from); }
  [[nodiscard]] geom::Point end_at() const { return at(to); }
};

using Loop = std::vector<Piece>;

Piece turned(Piece piece);
Loop turned(Loop loop);
Piece shifted(Piece piece, geom::Vector by);
Loop shifted(Loop loop, geom::Vector by);
/// A straight one between two places of the chart. @pre they differ
Piece straight(geom::Point from, geom::Point to);
/// With its ends moved to two places exactly.
Piece reaching(const Piece& piece, geom::Point begin, geom::Point end);

/// Parameters along the way, ends included: one part where it is straight, else `parts` between breaks.
std::vector<double> parameters_along(const Piece& piece, int parts = 12);
/// Places at equal steps, and at breaks: where a straight piece lies on a surface that is not.
std::vector<geom::Point> spread(const Piece& piece);
/// Places along a loop, each once.
std::vector<geom::Point> outline(const Loop& loop);
double area_of(const std::vector<geom::Point>& outline);  ///< Positive anticlockwise.
bool inside(const std::vector<geom::Point>& outline, geom::Point at);

/// Where a face says what was found.
class Report {
 public:
  Report(std::vector<surf::mesh::Finding>& findings, base::Place place)
      : findings_(findings), place_(std::move(place)) {}
  void say(std::string code, std::string message, std::optional<geom::Point> uv = std::nullopt,
           std::optional<geom::Point3> at = std::nullopt);
  [[nodiscard]] base::Place place(std::optional<geom::Point> uv, std::optional<geom::Point3> at) const;

 private:
  std::vector<surf::mesh::Finding>& findings_;
  base::Place place_;
};

/// Why a face is left out.
struct Refusal {
  std::string code;
  std::string message;
  std::optional<geom::Point> uv = std::nullopt;
  std::optional<geom::Point3> at = std::nullopt;
};

}  // namespace dobra::io::faces
