#pragma once
// One curve of a domain: a chain of straight pieces, a circular arc or a smooth chain of cubics, measured by the
// distance travelled along it.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "shared/base/angle.h"
#include "shared/geom/arc.h"
#include "shared/geom/cubic_path.h"
#include "shared/geom/polyline.h"

namespace quebra::sketch {

enum class Role {
  Boundary,  ///< Part of a loop; loops inside loops are holes, and so on by turns.
  Hole,      ///< Part of a loop that must lie inside another one.
  Internal,  ///< Inside the domain: an interface or a line along which nodes are wanted.
  Crack,     ///< Inside the domain: its two lips come apart.
};

/// How finely arcs are followed where a domain is cut with lines (not how they are meshed).
inline constexpr dobra::base::Angle trace_turn = dobra::base::Angle::from_degrees(2.0);

/// A chain of cubics measured by length, with the chords that follow it so that none turns by more than trace_turn.
class Smooth {
 public:
  /// @error those of discretise: a corner, no length, not finite.
  static dobra::base::Result<Smooth> make(dobra::geom::CubicPath path);

  [[nodiscard]] double length() const { return at_knot_.back(); }
  [[nodiscard]] bool closed() const { return chords_.points.front() == chords_.points.back(); }
  /// The point at distance s; the ends are exact.
  [[nodiscard]] dobra::geom::Point point(double s) const;
  [[nodiscard]] dobra::geom::Vector direction(double s) const;
  [[nodiscard]] const dobra::geom::CubicPath& path() const { return path_; }
  /// What lies between two distances, from < to.  @error those of make.
  [[nodiscard]] dobra::base::Result<Smooth> part(double from, double to) const;

  struct Chords {
    std::vector<dobra::geom::Point> points;
    std::vector<double> s;
    std::vector<double> turn;  ///< Of the tangent along each chord, radians.
  };
  [[nodiscard]] const Chords& chords() const { return chords_; }

 private:
  explicit Smooth(dobra::geom::CubicPath path) : path_(std::move(path)) {}
  [[nodiscard]] double parameter(double s) const;

  dobra::geom::CubicPath path_;
  std::vector<double> knots_;    ///< As parameters from 0 to 1.
  std::vector<double> at_knot_;  ///< Distance at each knot.
  Chords chords_;
};

/// How a curve is to be divided, where the user said so.
struct Division {
  int segments = 0;    ///< 0: not said.
  double size = 0.0;   ///< Greatest length of a piece, m; 0: not said.
  double ratio = 1.0;  ///< Last piece to first piece; without `segments` as many as it takes for `size`.
};

struct Curve {
  std::string name;
  Role role = Role::Boundary;
  std::variant<dobra::geom::Polyline, dobra::geom::Arc, Smooth> shape;
  Division division;
  std::vector<std::string> groups = {};  ///< Further sets that its sides belong to.
  double tip_size = 0.0;                 ///< Of a crack: length of the sides at its ends, m; 0: not said.
};

/// Whether it is part of a loop.
[[nodiscard]] bool bounds(const Curve& curve);
/// m.
double length(const Curve& curve);
[[nodiscard]] bool closed(const Curve& curve);
/// The point at distance s from the start, 0 <= s <= length; the ends are exact.
dobra::geom::Point point(const Curve& curve, double s);
/// The same for many, in one pass.
std::vector<dobra::geom::Point> points(const Curve& curve, std::span<const double> s);
/// Unit tangent at distance s; of a corner, that of the piece behind it.
dobra::geom::Vector direction(const Curve& curve, double s);
/// The distances of all corners, the two ends included (0 and length; a closed smooth curve gives 0 and length too).
std::vector<double> corners(const Curve& curve);

/// Straight pieces that follow the curve so that none turns by more than trace_turn, with the distance of each vertex.
struct Trace {
  dobra::geom::Polyline line;
  std::vector<double> s;  ///< One a vertex; one more, the length, for a closed line.
};
Trace trace(const Curve& curve);

/// Equal for curves that pass the same points, wherever they start and whichever way they run; exact but for splines,
/// of which the traces count.
using ShapeKey = std::vector<std::array<dobra::geom::Point, 2>>;
ShapeKey shape_key(const Curve& curve);

/// Of its trace, or the true box of an arc.
dobra::geom::Box box_of(const Curve& curve);

/// Marks full circles in whose box, grown by the margin, there is nothing else: neither another curve nor one of the
/// points.
/// @cost O(n log n) for n pieces of polylines and splines, and sixteenths of arcs.
std::vector<std::uint8_t> lone_circles(std::span<const Curve> curves, std::span<const dobra::geom::Point> points,
                                       double margin);

/// Distances along two curves where they truly meet, by Newton's method from s and t, where their traces do; nothing if
/// they stay farther apart than the tolerance.
std::optional<std::array<double, 2>> meeting(const Curve& one, double s, const Curve& two, double t, double tolerance);

/// A wanted node on a curve, and the size of the pieces beside it.
struct Stop {
  double s = 0.0;
  double size = 0.0;  ///< m; 0: no wish.
};

enum class DivisionRule {
  Even,     ///< As few pieces as meet the limits, alike or growing evenly.
  Halving,  ///< Equal pieces no longer than the size, each halved until it is short and turns little; 2:1 along
            ///< the curve.
};

struct DivideOptions {
  double size = 0.0;  ///< Longest piece, m, where the curve says nothing else; > 0.
  dobra::base::Angle turn = dobra::base::Angle::from_degrees(15.0);  ///< Most that a piece of an arc may turn.
  double growth = 1.3;  ///< Most by which sizes grow from one piece to the next away from a stop; > 1.
  /// Size wanted at a point, such as a size field's; empty: none.
  std::function<double(dobra::geom::Point)> limit = {};
  DivisionRule rule = DivisionRule::Even;
  std::size_t most = 20'000'000;  ///< Pieces; more are refused before any is made.
};

/// Distances of the nodes along a curve, ascending, from 0 to length (both included): every corner and stop is one, and
/// the pieces between follow the sizes. No piece is longer than the size or turns by more than `turn`; `limit` is met
/// to a twentieth. A crack has two pieces at least, or it could not open. Where the curve says `segments` or a `ratio`,
/// that alone counts: just so many pieces over all its corners and stops, growing evenly; unless a stop inside the
/// curve has a size of its own (explicit_division). Page: docs/algorithms/discretise.md.
/// @error BadValue: fewer segments than there are straight pieces between corners and stops; TooManyElements with the
///        curve's name, both before any piece is made.
/// @cost O(number of pieces)
dobra::base::Result<std::vector<double>> divide(const Curve& curve, std::vector<Stop> stops,
                                                const DivideOptions& options);

/// Whether `segments` and `ratio` of the curve are obeyed: they are said, and no stop inside the curve has a size.
bool explicit_division(const Curve& curve, std::span<const Stop> stops);

}  // namespace quebra::sketch
