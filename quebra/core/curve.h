#pragma once
// One curve of a domain: a chain of straight pieces or a circular arc, measured by the distance travelled along it.

#include <string>
#include <variant>
#include <vector>

#include "shared/base/angle.h"
#include "shared/geom/arc.h"
#include "shared/geom/polyline.h"

namespace quebra::core {

enum class Role {
  Boundary,  ///< Part of a loop; loops inside loops are holes, and so on by turns.
  Hole,      ///< Part of a loop that must lie inside another one.
  Internal,  ///< Inside the domain: an interface or a line along which nodes are wanted.
};

/// How a curve is to be divided, where the user said so.
struct Division {
  int segments = 0;    ///< 0: not said.
  double size = 0.0;   ///< Length of a piece, m; 0: not said.
  double ratio = 1.0;  ///< Last piece to first piece, for `segments`.
};

struct Curve {
  std::string name;
  Role role = Role::Boundary;
  std::variant<dobra::geom::Polyline, dobra::geom::Arc> shape;
  Division division;
};

/// m.
double length(const Curve& curve);
[[nodiscard]] bool closed(const Curve& curve);
/// The point at distance s from the start, 0 <= s <= length; the ends are exact.
dobra::geom::Point point(const Curve& curve, double s);
/// The distances of all corners, the two ends included (0 and length; a closed smooth curve gives 0 and length too).
std::vector<double> corners(const Curve& curve);
/// Longest piece that turns by at most `turn`, m; infinite for straight pieces.
double longest_piece(const Curve& curve, dobra::base::Angle turn);

/// Straight pieces that follow the curve so that none turns by more than `turn`, with the distance of each vertex.
struct Trace {
  dobra::geom::Polyline line;
  std::vector<double> s;  ///< One a vertex; one more, the length, for a closed line.
};
Trace trace(const Curve& curve, dobra::base::Angle turn);

/// A wanted node on a curve, and the size of the pieces beside it.
struct Stop {
  double s = 0.0;
  double size = 0.0;  ///< m; 0: no wish.
};

struct DivideOptions {
  double size = 0.0;                  ///< Longest piece, m, where the curve says nothing else; > 0.
  dobra::base::Angle turn = dobra::base::Angle::from_degrees(15.0);  ///< Most that a piece of an arc may turn.
  double growth = 1.3;                ///< Most by which sizes grow from one piece to the next away from a stop; > 1.
};

/// Distances of the nodes along a curve, ascending, from 0 to length (both included): every corner and stop is one, and
/// the pieces between follow the sizes. Exactly `segments` pieces where the curve says so and has neither corners nor stops.
/// @cost O(number of pieces)
std::vector<double> divide(const Curve& curve, std::vector<Stop> stops, const DivideOptions& options);

}  // namespace quebra::core
