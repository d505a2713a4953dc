#include "shared/offset/monotone/mitre_envelope.h"

#include <algorithm>
#include <array>
#include <bit>

#include "shared/offset/monotone/curve_overlay.h"

namespace dobra::offset::monotone {

using geom::Point;
using geom::Vector;

namespace {

/// Greatest height of a curve near places that are asked for in ascending order: each point comes and goes once.
class SlidingTop {
 public:
  SlidingTop(const CurveOverlay& curve, double distance) : curve_(curve), d_(distance), leaves_(curve.x_of(1)) {}
  [[nodiscard]] double within(double x);

 private:
  struct Top {
    double y;
    std::size_t at;
  };
  const CurveOverlay& curve_;
  const double d_;
  std::vector<Top> tops_;  // from `first_` on: points in reach that no later one is above, descending
  std::size_t first_ = 0;
  std::size_t low_ = 0;                                      // the part where the reach starts
  std::size_t high_ = 0;                                     // the first point beyond it
  double leaves_;                                            // where part low_ ends
  double reach_ = -std::numeric_limits<double>::infinity();  // of the last point
};

/// The highest place of the curve within D of x along the axis; infinity where it does not reach so far.
double SlidingTop::within(double x) {
  if (x - d_ < curve_.x_of(0)) return std::numeric_limits<double>::infinity();
  if (x - d_ >= leaves_) {
    while (x - d_ >= leaves_) {
      leaves_ = ++low_ < curve_.parts() ? curve_.x_of(low_ + 1) : std::numeric_limits<double>::infinity();
    }
    if (high_ < low_) {
      high_ = low_;
      reach_ = -std::numeric_limits<double>::infinity();
    }
    while (first_ < tops_.size() && tops_[first_].at < low_) ++first_;
    if (2 * first_ > tops_.size()) {
      tops_.erase(tops_.begin(), tops_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
    }
  }
  // Parts are convex: none is above both of its ends.
  for (; reach_ < x + d_ && high_ <= curve_.parts(); ++high_) {
    const double y = curve_.axis().y(curve_.point(high_));
    while (tops_.size() > first_ && tops_.back().y <= y) tops_.pop_back();
    tops_.push_back({y, high_});
    reach_ = curve_.x_of(high_);
  }
  return tops_[first_].y;
}

/// The lower boundary of a mitre: foot, tip or both ends of a bevel, foot.
struct Quad {
  std::array<Point, 4> at;  ///< Without a bevel the tip stands twice.
  bool bevelled;
  std::size_t corner;
};

class MitreEnvelope {
 public:
  MitreEnvelope(Stacked& stacked, const BaseCurve& base, Vector forward, double distance, const JoinRule& joins,
                const StadiaLeft& left)
      : cut_(stacked.cut),
        left_(left),
        base_(base),
        axis_{forward},
        d_(distance),
        joins_(joins),
        touching_(touching(base, distance)),
        curve_(stacked, base, forward, distance, joins) {}

  bool run();

 private:
  [[nodiscard]] Quad quad(std::size_t corner) const;
  [[nodiscard, gnu::always_inline]] inline double lowest_of(std::size_t corner) const;
  [[nodiscard]] bool is_above_curve(const Quad& quad, std::size_t& hint) const;
  [[nodiscard]] bool is_above_part(Point p, std::size_t k) const;
  [[nodiscard]] std::vector<std::uint32_t> with_arcs() const;
  [[nodiscard]] std::vector<std::uint32_t> lowest() const;
  std::vector<Span> first_quads();
  std::vector<Span> other_quads();
  void add(const Quad& quad, LowerEnvelope& envelope) const;
  static std::uint64_t bit(std::size_t corner) { return std::uint64_t{1} << (corner % 64); }
  template <class Use>
  void for_each_cut(Use&& use) const {
    for (std::size_t word = 0; word < cut_.size(); ++word) {
      for (std::uint64_t bits = cut_[word]; bits != 0; bits &= bits - 1) {
        use(word * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }

  std::vector<std::uint64_t>& cut_;
  const StadiaLeft& left_;
  const BaseCurve& base_;
  const Axis axis_;
  const double d_;
  const JoinRule& joins_;
  const double touching_;
  CurveOverlay curve_;
};

Quad MitreEnvelope::quad(std::size_t corner) const {
  const double t = base_.half_tans[corner];
  const bool bevelled = joins_.of(t) != CornerKind::Mitre;
  const double beyond = bevelled ? quarter_of(t) : t;  // of the feet, in D
  const Point tip = tip_at(base_, corner, d_, beyond);
  const Point end = bevelled ? bevel_end(base_, corner, d_, beyond) : tip;
  return {{foot_before(base_, corner, d_), tip, end, foot_after(base_, corner, d_)}, bevelled, corner};
}

/// Not above any place of the quad across the axis, and exact for mitres that are not bevelled.
double MitreEnvelope::lowest_of(std::size_t corner) const {
  const double t = base_.half_tans[corner];
  const Vector u = base_.headings[corner - 1];
  const double foot = geom::dot(axis_.forward, u);
  const double tip = foot - t * geom::cross(axis_.forward, u);
  const double other = geom::dot(axis_.forward, base_.headings[corner]);
  constexpr double bevel = 1.4143;  // its ends are not farther from the corner, in D
  double down = std::max(foot, other);
  down = tip > down ? tip : down;
  down = t > joins_.mitre_below() ? bevel : down;  // no branch: it could not be foretold
  return axis_.y(base_.points[corner]) - d_ * down;
}

/// Cut corners of whose arcs a part is on the curve: there their mitres come out, unless others hide them.
std::vector<std::uint32_t> MitreEnvelope::with_arcs() const {
  constexpr std::size_t size = BaseCurve::block_size;
  std::vector<std::uint32_t> corners;
  for (std::size_t b = 0; b < left_.size(); ++b) {
    const auto cut = static_cast<std::uint32_t>(cut_[b * size / 64] >> (b * size % 64));
    for (std::uint32_t bits = cut & left_[b] >> size; bits != 0; bits &= bits - 1) {
      corners.push_back(static_cast<std::uint32_t>(b * size) + static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
  }
  return corners;
}

/// Those with the lowest quads, one from each stretch of the axis.
std::vector<std::uint32_t> MitreEnvelope::lowest() const {
  std::vector<std::uint32_t> corners;
  constexpr double stretch = 0.25;  // of D
  double end = -std::numeric_limits<double>::infinity();
  std::size_t lowest = 0;
  double least = 0;
  const auto release = [&] {
    if (lowest != 0) corners.push_back(static_cast<std::uint32_t>(lowest));
  };
  for_each_cut([&](std::size_t corner) {
    const double own = lowest_of(corner);
    const double x = axis_.x(base_.points[corner]);
    if (x > end) {
      release();
      lowest = corner;
      least = own;
      end = x + stretch * d_;
    } else if (own < least) {
      lowest = corner;
      least = own;
    }
  });
  release();
  return corners;
}

/// The envelope of quads that hide most of the others: where many corners are cut for each arc left, long tips do.
std::vector<Span> MitreEnvelope::first_quads() {
  constexpr std::size_t many = 8;
  std::vector<std::uint32_t> corners = with_arcs();
  std::size_t cut = 0;
  for (const std::uint64_t word : cut_) cut += static_cast<std::size_t>(std::popcount(word));
  if (cut > many * corners.size()) corners = lowest();
  LowerEnvelope envelope(touching_);
  for (const std::uint32_t corner : corners) {
    cut_[corner / 64] &= ~bit(corner);
    add(quad(corner), envelope);
  }
  return envelope.finish();
}

/// The envelope of those that are left and come out below the curve.
std::vector<Span> MitreEnvelope::other_quads() {
  LowerEnvelope envelope(touching_);
  std::size_t hint = 0;
  SlidingTop top(curve_, d_);
  for_each_cut([&](std::size_t corner) {
    if (lowest_of(corner) >= top.within(axis_.x(base_.points[corner]))) return;
    const Quad made = quad(corner);
    if (is_above_curve(made, hint)) return;
    add(made, envelope);
  });
  cut_ = {};
  return envelope.finish();
}

/// False if it is not, or if it would take long to tell. The quad is convex, and so are the parts of the curve: their
/// corners tell; and its feet are on stadia.
bool MitreEnvelope::is_above_curve(const Quad& quad, std::size_t& hint) const {
  constexpr std::size_t patience = 64;
  hint = curve_.part_at(axis_.x(quad.at[1]), hint);
  if (!is_above_part(quad.at[1], hint)) return false;
  const auto below = [&](std::size_t k, std::size_t arm) {
    return geom::cross(quad.at[arm + 1] - quad.at[arm], curve_.point(k) - quad.at[arm]) <= 0;
  };
  const double start = axis_.x(quad.at[0]);
  for (std::size_t k = hint; curve_.x_of(k) >= start; --k) {
    if (!below(k, 0)) return false;
    if (k == 0 || k + patience < hint) return false;
  }
  std::size_t k = hint + 1;
  for (std::size_t arm = quad.bevelled ? 1 : 2; arm < 3; ++arm) {
    const double end = axis_.x(quad.at[arm + 1]);
    for (; k <= curve_.parts() && curve_.x_of(k) <= end; ++k) {
      if (!below(k, arm)) return false;
    }
    if (k > curve_.parts() || k > hint + patience) return false;
    if (arm == 1 && !is_above_part(quad.at[2], k - 1)) return false;
  }
  return true;
}

/// @pre p is between the ends of part k, along the axis.
bool MitreEnvelope::is_above_part(Point p, std::size_t k) const {
  const std::uint32_t of = curve_.site(k);
  if (of == cap_site || kind_of(of) == SiteKind::Arc) {
    const Vector to = p - curve_.centre(of);
    return geom::length_squared(to) <= d_ * d_ || geom::cross(axis_.forward, to) >= 0;
  }
  return geom::cross(curve_.point(k + 1) - curve_.point(k), p - curve_.point(k)) >= 0;
}

void MitreEnvelope::add(const Quad& quad, LowerEnvelope& envelope) const {
  envelope.start_graph();
  double x0 = axis_.x(quad.at[0]);
  double y0 = axis_.y(quad.at[0]);
  const auto add_to = [&](Point end, std::uint32_t of) {
    const double x1 = axis_.x(end);
    const double y1 = axis_.y(end);
    if (x1 > x0) envelope.add({x0, x1, x1, y1, (y1 - y0) / (x1 - x0), of});
    x0 = std::max(x0, x1);
    y0 = y1;
  };
  add_to(quad.at[1], site_of(SiteKind::Line, quad.corner - 1));
  if (quad.bevelled) add_to(quad.at[2], site_of(SiteKind::Bevel, quad.corner - 1));
  add_to(quad.at[3], site_of(SiteKind::Line, quad.corner));
  envelope.end_graph();
}

bool MitreEnvelope::run() {
  const std::vector<Span> first = first_quads();
  curve_.lay(first);
  const std::vector<Span> others = other_quads();
  curve_.lay(others);
  if (!first.empty() || !others.empty()) return true;
  curve_.take_off_caps();  // all are hidden
  return false;
}

}  // namespace

bool add_cut_mitres(Stacked& stacked, const BaseCurve& base, Vector forward, double distance, const JoinRule& joins,
                    const StadiaLeft& left) {
  if (std::all_of(stacked.cut.begin(), stacked.cut.end(), [](std::uint64_t word) { return word == 0; })) return false;
  return MitreEnvelope(stacked, base, forward, distance, joins, left).run();
}

}  // namespace dobra::offset::monotone
