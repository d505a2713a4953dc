#pragma once
// Which attribute a face is to have when an edge between two faces was taken out and its parts came in again by another
// way. While the edge is out its faces are one; every half-edge that was there before remembers whose border it is, and
// in the end the borders tell. Costs nothing unless faces have attributes and an edge is taken out.

#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "shared/topo/subdivision.h"

namespace dobra::topo {

/// Whose border the left and the right side of an edge are; none: unknown.
struct Sides {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::uint32_t left = none;
  std::uint32_t right = none;
};

class Owners {
 public:
  explicit Owners(Subdivision& sub) : sub_(sub) {}

  /// To be called before h's edge is removed. Returns whose its sides are.
  Sides open(HalfEdgeId h);
  /// After h's edge was removed, where its faces were `left` and `right`.
  void merged(FaceId left, FaceId right);
  /// After h, a part of an edge with these sides or a new one, came in.
  void placed(HalfEdgeId h, const Sides& sides);
  /// After an edge was connected: `fresh` was made out of `old`.
  void divided(FaceId old, FaceId fresh);
  /// After h was split and goes on in `rest`.
  void split(HalfEdgeId h, HalfEdgeId rest);
  /// A part with these sides turned out to be h, which was there already: what lay between the two is gone.
  void coincides(HalfEdgeId h, const Sides& sides);
  /// Gives all faces concerned their attributes.
  void settle();

 private:
  [[nodiscard]] std::uint32_t owner(HalfEdgeId h) const;
  void set_owner(HalfEdgeId h, std::uint32_t who);
  void record(FaceId f);
  [[nodiscard]] std::uint32_t longest_border(FaceId f) const;
  [[nodiscard]] std::uint32_t neighbours(FaceId f, const std::map<FaceId, std::uint32_t>& known) const;

  Subdivision& sub_;
  std::vector<std::any> attributes_;
  std::unordered_map<HalfEdgeId, std::uint32_t> owner_;
  std::set<FaceId> concerned_;
};

}  // namespace dobra::topo
