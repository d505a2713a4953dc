#pragma once
// What the verifier knows of a base: segments, corners, mitres and the raw outline, with 64-bit mantissas.
// Everything is seen from the right side: for the left one base and result are mirrored (y becomes -y).

#include <array>
#include <cstdint>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/geom/predicates.h"
#include "shared/offset/verifier/boxes.h"
#include "shared/offset/verifier/verify.h"

namespace dobra::offset::verifier {

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
  bool simple = false;         ///< Closed, and does not meet itself.
  bool anticlockwise = false;  ///< Of a simple one.
  bool mirrored = false;
  bool round = false;  ///< Arcs of corners come out as they are, not as their chords.
  bool raw = false;    ///< Untreated: parallels may run backwards and beyond their corners.
  bool paper = false;  ///< Made of the paper's raw edges, whole or cut.
  long double d = 0;
  long double rounding = 0;             ///< Of one coordinate of the base, m.
  std::vector<geom::Point> places;      ///< Mirrored, exact but for extended ends.
  std::vector<std::uint32_t> source;    ///< Segment in the user's curve.
  std::vector<std::uint32_t> first_of;  ///< First segment with each source; `none` if there is none.
  std::vector<Wide> along;
  std::vector<long double> span;
  std::vector<Corner> corners;        ///< For each point.
  BoxTree tree;                       ///< Of the segments.
  std::vector<std::uint32_t> mitres;  ///< Corners that have one.
  BoxTree mitre_tree;
  static constexpr std::uint32_t none = 0xffffffffU;

  /// D is so few roundings that one side of the base cannot be told from the other; see Verification::coarse.
  [[nodiscard]] bool coarse() const { return d < 64 * rounding; }
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
  /// The paper's, from corner to corner: where inner corners are near each other beyond both normals, and backwards.
  [[nodiscard]] std::array<Wide, 2> raw_edge(std::size_t i) const;
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
  bool arc = false;                     ///< Anticlockwise about centre.
  bool chord = false;                   ///< Straight, in place of an arc about centre.
  bool line = false;                    ///< Straight, parallel to a segment or a tangent bevel.
  Wide outward;                         ///< Unit: away from the base at the middle.
  std::uint32_t segment = Model::none;  ///< Of the model; none if the edge fits nothing.
  std::size_t piece = 0;
  std::size_t edge = 0;
  long double rounding = 0;           ///< Of its ends, m.
  [[nodiscard]] Wide middle() const;  ///< On the arc, for arcs and chords of arcs.
};

/// The curve's edges, and all that is wrong with each alone (checks e, and a for vertices).
/// It and the checks stop early once `progress` is cancelled.
std::vector<SeenEdge> see(const Model& model, const OffsetCurve& curve, const VerifyOptions& options,
                          Verification& found, const base::Progress& progress);

void check_clearance(const Model& model, const std::vector<SeenEdge>& edges, const VerifyOptions& options,
                     Verification& found, const base::Progress& progress);
void check_crossings(const Model& model, const OffsetCurve& curve, const std::vector<SeenEdge>& edges,
                     Verification& found, const base::Progress& progress);
void check_missing(const Model& model, const OffsetCurve& curve, const std::vector<SeenEdge>& edges,
                   const VerifyOptions& options, Verification& found, const base::Progress& progress);
void check_winding(const Model& model, const std::vector<SeenEdge>& edges, Verification& found,
                   const base::Progress& progress);

geom::Box box_of(const SeenEdge& edge);
/// Of p from the edge as it is drawn.
long double distance(const SeenEdge& edge, Wide p, long double radius);

}  // namespace dobra::offset::verifier
