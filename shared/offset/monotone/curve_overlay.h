#pragma once
// The curve of the monotone engine with straight pieces laid over it: where one is lower it takes the curve's place
// (mitre_envelope.h). Everything is a graph over the forward axis: whatever rounding does, the result cannot cross
// itself.

#include <limits>

#include "shared/offset/monotone/lower_envelope.h"
#include "shared/offset/monotone/stadium_stack.h"

namespace dobra::offset::monotone {

/// Site of a part of the curve.
constexpr std::uint32_t site_of(SiteKind kind, std::size_t segment) {
  return static_cast<std::uint32_t>(4 * segment) + static_cast<std::uint32_t>(kind);
}
constexpr std::uint32_t cap_site = 0xffffffffU;  ///< The arc about the first point.
constexpr SiteKind kind_of(std::uint32_t site) { return static_cast<SiteKind>(site % 4); }
constexpr std::size_t segment_of(std::uint32_t site) { return site / 4; }

/// Places along and across the forward axis.
struct Axis {
  geom::Vector forward;
  [[nodiscard]] double x(geom::Point p) const { return forward.x * p.x + forward.y * p.y; }
  [[nodiscard]] double y(geom::Point p) const { return forward.x * p.y - forward.y * p.x; }
  [[nodiscard]] geom::Point point(double x, double y) const {
    return {forward.x * x - forward.y * y, forward.y * x + forward.x * y};
  }
};

constexpr OffsetEdge edge_of(std::uint32_t site) {
  const std::size_t segment = segment_of(site);
  return kind_of(site) == SiteKind::Line ? OffsetEdge::line(segment) : OffsetEdge::arc(segment | mitred);
}

class CurveOverlay {
 public:
  /// Ends `stacked` by its tip and the arc about the last point of the base, and changes it from then on.
  CurveOverlay(Stacked& stacked, const BaseCurve& base, geom::Vector forward, double distance, const JoinRule& joins);
  /// As it was, if nothing has been laid over it.
  void take_off_caps();
  /// Lays pieces over the curve; their sites are lines and bevels. If they start before it, the arc about the first
  /// point is put in front.
  /// @param pieces  in order of x, disjoint, within D of the base along the axis.
  /// @cost          O(k + m log m), k = pieces and parts below them; O(curve) moves of memory.
  void lay(const std::vector<Span>& pieces);

  [[nodiscard]] const Axis& axis() const { return axis_; }
  [[nodiscard]] std::size_t parts() const { return parts_; }
  /// Start of part k, or end of part k - 1.
  [[nodiscard]] geom::Point point(std::size_t k) const { return curve_.points[k]; }
  [[nodiscard]] double x_of(std::size_t k) const { return axis_.x(curve_.points[k]); }
  /// The last part that starts at x or before it (else the first), looked for from `hint` on in growing steps.
  [[nodiscard]] std::size_t part_at(double x, std::size_t hint) const;
  [[nodiscard]] std::uint32_t site(std::size_t k) const;
  /// Of an arc.
  [[nodiscard]] geom::Point centre(std::uint32_t site) const {
    return site == cap_site ? base_.points[0] : base_.points[segment_of(site) + 1];
  }

 private:
  struct Edit {
    std::size_t first, last;  ///< These parts go ...
    std::size_t from, to;     ///< ... and these added ones take their place.
  };
  struct Part {  ///< Of the curve; of an arc the chord.
    std::size_t k;
    std::uint32_t site;
    double x0, y0, x1, y1;
    [[nodiscard]] double at(double x) const {
      if (x <= x0) return y0;
      return x >= x1 ? y1 : y0 + (y1 - y0) * ((x - x0) / (x1 - x0));
    }
  };
  struct Line {
    geom::Point on;
    geom::Vector along;
  };

  [[nodiscard]] Part part(std::size_t k) const;
  [[nodiscard]] Part part_after(const Part& own) const;
  void compare(const Span& w, const Part& own, double x0, double x1);
  void compare_with_line(const Span& w, const Part& own, double x0, double x1);
  void compare_with_arc(const Span& w, const Part& own, double x0, double x1);
  /// From x on, within the part, the quad is lower. `at`: where it crosses that part, if it does so there.
  void take_quad(const Span& w, const Part& own, double x, const geom::Point* at = nullptr) {
    if (quad_ == nullptr) {
      enter_quad(w, own, x, at);
    } else if (quad_->site != w.site) {
      insert(meet(quad_->site, w.site, x, w.at(x)), edge_of(w.site));
    }
    quad_ = &w;
  }
  /// From x on the part of the curve is lower, or nothing else is there.
  void take_curve(const Part& own, double x, const geom::Point* at = nullptr) {
    if (quad_ != nullptr) leave_quad(own, x, at);
  }
  void enter_quad(const Span& w, const Part& own, double x, const geom::Point* at);
  void leave_quad(const Part& own, double x, const geom::Point* at);
  void insert(geom::Point p, OffsetEdge edge) {
    added_points_.push_back(p);
    added_edges_.push_back(edge);
  }
  void apply_edits();
  [[nodiscard]] bool is_short(geom::Point p, geom::Point q) const;
  [[nodiscard]] bool has_short_step(std::size_t from, std::size_t to) const;
  void drop_short_steps();

  // Where sites meet.
  [[nodiscard]] Line line(std::uint32_t site) const;
  [[nodiscard]] geom::Point meet(std::uint32_t a, std::uint32_t b, double x, double y) const;
  [[nodiscard]] bool natural_meet(std::uint32_t a, std::uint32_t b, geom::Point& at) const;

  Stacked& curve_;
  const BaseCurve& base_;
  const Axis axis_;
  const double d_;
  const JoinRule& joins_;
  const double touching_;
  std::size_t parts_ = 0;
  std::vector<Edit> edits_;
  std::vector<geom::Point> added_points_;
  std::vector<OffsetEdge> added_edges_;
  const Span* quad_ = nullptr;  // what the curve has come to run along, if it is a quad
};

}  // namespace dobra::offset::monotone
