#pragma once
// What the verifier knows of a base: segments, corners, mitres and the raw outline, with 64-bit mantissas, and a tree of boxes.
// Everything is seen from the right side: for the left one base and result are mirrored (y becomes -y).

#include <cmath>
#include <cstdint>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/box.h"
#include "shared/geom/predicates.h"
#include "shared/offset/verify.h"

namespace dobra::offset::judge {

/// A place or a displacement with 64-bit mantissas.
struct Wide {
  long double x = 0;
  long double y = 0;
  friend Wide operator+(Wide a, Wide b) { return {a.x + b.x, a.y + b.y}; }
  friend Wide operator-(Wide a, Wide b) { return {a.x - b.x, a.y - b.y}; }
  friend Wide operator-(Wide a) { return {-a.x, -a.y}; }
  friend Wide operator*(long double f, Wide a) { return {f * a.x, f * a.y}; }
};
inline Wide wide(geom::Point p) { return {p.x, p.y}; }
inline geom::Point narrow(Wide a) { return {static_cast<double>(a.x), static_cast<double>(a.y)}; }
inline long double dot(Wide a, Wide b) { return a.x * b.x + a.y * b.y; }
inline long double cross(Wide a, Wide b) { return a.x * b.y - a.y * b.x; }
inline long double size(Wide a) { return std::hypot(a.x, a.y); }
inline Wide right_of(Wide a) { return {a.y, -a.x}; }
inline Wide unit(Wide a) { return (1 / size(a)) * a; }

/// Point of [a, b] nearest to p.
Wide nearest_on(Wide a, Wide b, Wide p);
/// An arc about `centre`, anticlockwise from a to b, at most half a turn: true if the direction of p lies in it.
bool in_sector(Wide centre, Wide a, Wide b, Wide p);

/// Boxes in the order of a chain, halved again and again.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<geom::Box>& boxes);

  /// Calls visit(item) for all items whose boxes, and those of all their parents, `wants` accepts, until visit says true.
  template <class Wants, class Visit>
  void each(Wants&& wants, Visit&& visit) const {
    if (boxes_.empty()) return;
    std::uint32_t open[80];
    std::size_t count = 0;
    open[count++] = 1;
    while (count > 0) {
      const std::uint32_t node = open[--count];
      if (boxes_[node].empty() || !wants(boxes_[node])) continue;
      if (node >= leaves_) {
        if (visit(static_cast<std::size_t>(node - leaves_))) return;
        continue;
      }
      open[count++] = 2 * node + 1;
      open[count++] = 2 * node;
    }
  }

 private:
  std::uint32_t leaves_ = 1;
  std::vector<geom::Box> boxes_;  // children of i are 2 i and 2 i + 1; the root is 1
};

long double gap(const geom::Box& box, Wide p);
/// Least distance of segment [a, b] from a box, not more than it is, and 0 or the like if they meet.
long double gap(const geom::Box& box, Wide a, Wide b);
geom::Box box_round(Wide a, Wide b);

enum class CornerKind : std::uint8_t { End, Straight, Inner, Mitre, Tangent, Arc };

/// A base point, seen from the right side.
struct Corner {
  CornerKind kind = CornerKind::End;
  bool round_left = false;   ///< The left side has a gap there.
  long double half_tan = 0;  ///< tan(turn / 2).
  Wide middle;               ///< Unit, halves the angle between the normals; for Tangent and Mitre.
};

/// Part of the raw outline.
struct Element {
  Wide a, b, centre;
  bool arc = false;  ///< Anticlockwise.
};

class Model {
 public:
  static base::Result<Model> make(const geom::Polyline& base, const OffsetOptions& options, double distance);

  bool closed = false;
  bool simple = false;  ///< Closed, and does not meet itself.
  bool anticlockwise = false;  ///< Of a simple one.
  bool mirrored = false;
  bool round = false;  ///< Arcs of corners come out as they are, not as their chords.
  bool raw = false;  ///< Untreated: parallels may run backwards and beyond their corners.
  long double d = 0;
  long double rounding = 0;             ///< Of one coordinate of the base, m.
  std::vector<geom::Point> places;      ///< Mirrored, exact but for extended ends.
  std::vector<std::uint32_t> source;    ///< Segment in the user's curve.
  std::vector<std::uint32_t> first_of;  ///< First segment with each source; `none` if there is none.
  std::vector<Wide> along;
  std::vector<long double> span;
  std::vector<Corner> corners;  ///< For each point.
  BoxTree tree;                 ///< Of the segments.
  std::vector<std::uint32_t> mitres;  ///< Corners that have one.
  BoxTree mitre_tree;
  static constexpr std::uint32_t none = 0xffffffffU;

  [[nodiscard]] std::size_t count() const { return along.size(); }
  [[nodiscard]] std::size_t end_index(std::size_t i) const { return i + 1 == places.size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == count() ? 0 : i + 1; }
  /// Segment that ends (begins) at a corner.
  [[nodiscard]] std::size_t incoming(std::size_t corner) const { return corner == 0 ? count() - 1 : corner - 1; }
  [[nodiscard]] Wide from(std::size_t i) const { return wide(places[i]); }
  [[nodiscard]] Wide to(std::size_t i) const { return wide(places[end_index(i)]); }
  [[nodiscard]] Wide normal(std::size_t i) const { return right_of(along[i]); }
  /// How far the raw parallel goes on beyond a corner.
  [[nodiscard]] long double reach(std::size_t corner) const;
  [[nodiscard]] Wide nearest(std::size_t segment, Wide p) const { return nearest_on(from(segment), to(segment), p); }
  [[nodiscard]] Wide seen(geom::Point p) const { return {p.x, mirrored ? -p.y : p.y}; }
  [[nodiscard]] geom::Point user(Wide p) const { return narrow({p.x, mirrored ? -p.y : p.y}); }

  /// How deep p lies in the mitre of a corner: below its outer lines, if between its normals; negative if outside.
  [[nodiscard]] long double depth_in_mitre(std::size_t corner, Wide p) const;
  /// The raw outline: one closed walk, or two for a closed base. Each goes anticlockwise round what it encloses.
  [[nodiscard]] std::vector<std::vector<Element>> outline() const;

 private:
  void measure(const OffsetOptions& options);
  void find_out_if_simple();
  void find_mitres();
};

/// Winding number of a closed walk round any point, in about log n steps.
class Winding {
 public:
  explicit Winding(std::vector<Element> walk);
  [[nodiscard]] int round(Wide p) const;

 private:
  [[nodiscard]] int part(std::size_t node, std::size_t low, std::size_t high, Wide p) const;
  std::vector<Element> walk_;
  std::size_t leaves_ = 1;
  std::vector<geom::Box> boxes_;
};

/// A curve as the checks see it: mirrored if the base is.
struct SeenEdge {
  Wide a, b, centre;
  bool arc = false;    ///< Anticlockwise about centre.
  bool chord = false;  ///< Straight, in place of an arc about centre.
  bool line = false;   ///< Straight, parallel to a segment or a tangent bevel.
  Wide outward;        ///< Unit: away from the base at the middle.
  std::uint32_t segment = Model::none;  ///< Of the model; none if the edge fits nothing.
  std::size_t piece = 0;
  std::size_t edge = 0;
  long double rounding = 0;  ///< Of its ends, m.
  [[nodiscard]] Wide middle() const;  ///< On the arc, for arcs and chords of arcs.
};

/// The curve's edges, and all that is wrong with each alone (checks e, and a for vertices).
std::vector<SeenEdge> see(const Model& model, const OffsetCurve& curve, const VerifyOptions& options, Verification& found);

void check_clearance(const Model& model, const std::vector<SeenEdge>& edges, const VerifyOptions& options, Verification& found);
void check_crossings(const Model& model, const OffsetCurve& curve, const std::vector<SeenEdge>& edges, Verification& found);
void check_missing(const Model& model, const OffsetCurve& curve, const std::vector<SeenEdge>& edges, const VerifyOptions& options,
                   Verification& found);
void check_winding(const Model& model, const std::vector<SeenEdge>& edges, Verification& found);

geom::Box box_of(const SeenEdge& edge);
/// Of p from the edge as it is drawn.
long double distance(const SeenEdge& edge, Wide p, long double radius);

}  // namespace dobra::offset::judge
