#pragma once
// The front of the paper's mesher: directed segments with what is not yet meshed on their left, in buckets by the cells
// of the quadtree, and the test of a triangle against them. Positions are of the chart, distances of space; what is
// where is decided by exact orientation in the chart. Page: docs/algorithms/paper_mesher.md.

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "shared/geom/predicates.h"
#include "shared/surf/paper/chart_quadtree.h"

namespace dobra::surf::paper {

struct Segment {
  std::uint32_t from = 0, to = 0;
  std::int32_t region = 0;
  std::uint32_t level = 0;  ///< The level in which it may be used first.
  double length = 0.0;      ///< Of the chord, m.
  bool active = false;      ///< To be used in the level at work.
  bool alive = true;
};

class PaperFront {
 public:
  using SegmentIndex = std::uint32_t;
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Refers to the quadtree, which must live as long.
  explicit PaperFront(const ChartQuadtree& tree) : tree_(&tree), buckets_(tree.cells().size()) {}

  /// @param loose  a node of no segment yet, which must become one of the mesh.
  std::uint32_t add_node(geom::Point uv, geom::Point3 at, bool loose = false);
  SegmentIndex add_segment(std::uint32_t from, std::uint32_t to, std::int32_t region, std::uint32_t level);
  void remove_segment(SegmentIndex segment);

  [[nodiscard]] const std::vector<geom::Point>& places() const { return places_; }
  [[nodiscard]] const std::vector<geom::Point3>& points() const { return points_; }
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }
  [[nodiscard]] Segment& segment(SegmentIndex s) { return segments_[s]; }
  [[nodiscard]] const Segment& segment(SegmentIndex s) const { return segments_[s]; }
  [[nodiscard]] std::size_t alive() const { return alive_; }
  [[nodiscard]] bool on_front(std::uint32_t node) const { return loose_[node] || !from_[node].empty(); }
  /// The segment between two nodes in this direction.
  [[nodiscard]] SegmentIndex find(std::uint32_t from, std::uint32_t to) const;
  /// The segment that ends where `segment` begins (begins where it ends), the next one round the node over what is not
  /// meshed; and the angle between both there, in space, radians. Above pi where the chart says so.
  struct Neighbour {
    SegmentIndex segment = none;
    double angle = 7.0;
  };
  [[nodiscard]] Neighbour before(SegmentIndex segment) const;
  [[nodiscard]] Neighbour after(SegmentIndex segment) const;

  /// A corner above a segment: a node of the front, or a new place.
  struct Corner {
    geom::Point uv;
    geom::Point3 at;
    std::uint32_t node = none;
  };
  [[nodiscard]] Corner corner(std::uint32_t node) const { return {places_[node], points_[node], node}; }
  /// Verifica(ABC) over the segment AB: it has area and the right turn, no node of the front lies in it, its new sides
  /// cross no segment; a new corner is no nearer to other segments than `least_distance`, m.
  [[nodiscard]] bool valid(std::uint32_t a, std::uint32_t b, const Corner& c, double least_distance);
  /// Nodes of the front within a distance in space of a place, ascending.
  void near(geom::Point uv, geom::Point3 at, double radius, geom::Vector reach, std::vector<std::uint32_t>& found);
  [[nodiscard]] std::vector<std::uint32_t> nodes() const;  ///< All of the front, ascending.

 private:
  struct Bucket {
    std::vector<SegmentIndex> segments;
    std::vector<std::uint32_t> loose;
  };
  template <class Visitor>
  void for_segments(const geom::Box& box, Visitor&& visit);
  [[nodiscard]] geom::Box box_of(SegmentIndex segment) const;
  [[nodiscard]] double space_angle(std::uint32_t at, std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] double chart_angle(std::uint32_t at, std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool crosses(geom::Point p, std::uint32_t p_node, const Corner& c, const Segment& segment) const;
  [[nodiscard]] bool keeps_distance(std::uint32_t a, std::uint32_t b, const Corner& c, double least,
                                    geom::Vector reach);

  const ChartQuadtree* tree_;
  std::vector<geom::Point> places_;
  std::vector<geom::Point3> points_;
  std::vector<std::uint8_t> loose_;
  std::vector<std::vector<SegmentIndex>> from_, to_;  ///< One a node: segments of the front.
  std::vector<Segment> segments_;
  std::vector<Bucket> buckets_;  ///< One a cell; of leaves.
  std::unordered_map<std::uint64_t, SegmentIndex> by_ends_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t look_ = 0;
  std::size_t alive_ = 0;
};

/// How far a length of space may reach in the chart at most, by the metric at a place.
geom::Vector reach_of(const Surface& surface, geom::Point uv, double length);

}  // namespace dobra::surf::paper
