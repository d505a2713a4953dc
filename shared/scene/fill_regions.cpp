// Regions as trapezoids: a line sweeps along the longer side of the region and stops where contours have corners or
// cross ([bentley1979]). Between two stops nothing changes but what lies beside the corner, so each stop ends
// and begins a few trapezoids and touches no others. The order of edges along the line comes from exact predicates;
// where a crossing is computed a little too late, the edges are exchanged as soon as they meet.
#include <algorithm>
#include <optional>
#include <queue>
#include <set>

#include "shared/geom/predicates.h"
#include "shared/scene/fill.h"

namespace dobra::scene {
namespace {

using geom::Point;
using geom::Sign;

/// The order in which the sweep line, a hair from horizontal, comes to points.
bool earlier(Point a, Point b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); }

/// An edge of a contour, from the end that the line comes to first.
struct Edge {
  Point low;
  Point high;
  [[nodiscard]] double x_at(double y) const {
    if (y <= low.y) return low.x;
    if (y >= high.y) return high.x;
    return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
  }
  /// Positive: p is on the left.
  [[nodiscard]] Sign side(Point p) const { return geom::orient2d(low, high, p); }
};

/// Positive: just below the first of their upper ends, a is on the left of b.
Sign order_above(const Edge& a, const Edge& b) {
  const Sign above = earlier(a.high, b.high) ? b.side(a.high) : -a.side(b.high);
  if (above != Sign::Zero) return above;
  return earlier(a.low, b.low) ? -a.side(b.low) : b.side(a.low);
}

/// Where two edges that are known to cross do so, nearly.
Point crossing_of(const Edge& a, const Edge& b) {
  if (a.low.y == a.high.y) return {b.x_at(a.low.y), a.low.y};
  if (b.low.y == b.high.y) return {a.x_at(b.low.y), b.low.y};
  const geom::Vector along = a.high - a.low;
  const geom::Vector other = b.high - b.low;
  return a.low + geom::cross(b.low - a.low, other) / geom::cross(along, other) * along;
}

class Sweep {
 public:
  enum class Axes { AsGiven, Exchanged };

  Sweep(const Region& region, Axes axes) : axes_(axes) {
    for (const geom::Polyline& contour : region.contours) {
      const std::vector<Point>& points = contour.points;
      for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
        add_edge(turned(points[j]), turned(points[i]));
    }
    state_.resize(edges_.size());
  }

  std::vector<Point> run() && {
    const std::vector<Corner> corners = sorted_corners();
    for (std::size_t i = 0; i < corners.size();) {
      const Point at = corners[i].at;
      while (!crossings_.empty() && !earlier(at, crossings_.top().at)) {
        const Crossing next = crossings_.top();
        crossings_.pop();  // before it brings others
        cross(next);
      }
      now_ = at;
      touched_.clear();
      for (; i < corners.size() && corners[i].at == at; ++i) {
        if (corners[i].ends)
          take_out(corners[i].edge);
        else
          put_in(corners[i].edge);
      }
      for (const std::uint32_t edge : touched_) settle(edge);
    }
    return std::move(triangles_);
  }

 private:
  /// A place on the sweep line. Edges that cross exchange their places.
  struct Place {
    mutable std::uint32_t edge;
  };
  struct Less {
    const Sweep* sweep;
    bool operator()(Place a, Place b) const { return sweep->comes_first(a.edge, b.edge); }
  };
  using Line = std::multiset<Place, Less>;
  struct State {
    std::optional<Line::iterator> place;  ///< Where the edge is on the line, if it is.
    bool inside = false;                  ///< What is on its right is filled, ...
    Point since;                          ///< ... and has not been drawn since the line was here.
  };
  struct Corner {
    Point at;
    std::uint32_t edge;
    bool ends;
  };
  struct Crossing {
    Point at;
    std::uint32_t left;  ///< Before they cross.
    std::uint32_t right;
    bool operator<(const Crossing& other) const {  // the queue's top is the greatest
      if (at != other.at) return earlier(other.at, at);
      return std::pair(left, right) > std::pair(other.left, other.right);
    }
  };

  [[nodiscard]] Point turned(Point p) const { return axes_ == Axes::AsGiven ? p : Point{p.y, p.x}; }

  void add_edge(Point a, Point b) {
    if (a == b || !geom::is_finite(a) || !geom::is_finite(b)) return;
    edges_.push_back(earlier(a, b) ? Edge{a, b} : Edge{b, a});
  }

  [[nodiscard]] std::vector<Corner> sorted_corners() const {
    std::vector<Corner> corners;
    corners.reserve(2 * edges_.size());
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      corners.push_back({edges_[edge].low, edge, false});
      corners.push_back({edges_[edge].high, edge, true});
    }
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
      if (a.at != b.at) return earlier(a.at, b.at);
      return std::pair(!a.ends, a.edge) < std::pair(!b.ends, b.edge);  // edges that end first
    });
    return corners;
  }

  /// One of the two, the newer, begins where the line is now.
  [[nodiscard]] bool comes_first(std::uint32_t a, std::uint32_t b) const {
    const bool a_is_new = edges_[a].low == now_;
    const Sign side = a_is_new ? edges_[b].side(edges_[a].low) : -edges_[a].side(edges_[b].low);
    if (side != Sign::Zero) return side == Sign::Positive;
    const Sign above = order_above(edges_[a], edges_[b]);
    return above == Sign::Zero ? a < b : above == Sign::Positive;
  }

  [[nodiscard]] std::optional<std::uint32_t> before(std::uint32_t edge) const {
    const Line::iterator place = *state_[edge].place;
    return place == line_.begin() ? std::nullopt : std::optional(std::prev(place)->edge);
  }
  [[nodiscard]] std::optional<std::uint32_t> after(std::uint32_t edge) const {
    const Line::iterator next = std::next(*state_[edge].place);
    return next == line_.end() ? std::nullopt : std::optional(next->edge);
  }

  void put_in(std::uint32_t edge) {
    state_[edge] = {line_.insert({edge}), false, now_};
    // The one before it drew up to the one behind it.
    if (const auto left = before(edge)) draw(*left, after(edge));
    touched_.push_back(edge);
    if (const auto right = after(edge)) touched_.push_back(*right);
  }

  void take_out(std::uint32_t edge) {
    const auto left = before(edge);
    const auto right = after(edge);
    if (left) draw(*left, edge);
    draw(edge, right);
    line_.erase(*state_[edge].place);
    state_[edge].place.reset();
    if (right) touched_.push_back(*right);
  }

  void cross(const Crossing& crossing) {
    const auto [at, a, b] = crossing;
    if (!state_[a].place || !state_[b].place || after(a) != b) return;
    if (order_above(edges_[a], edges_[b]) != Sign::Negative) return;
    now_ = at;
    if (const auto left = before(a)) draw(*left, a);
    draw(a, b);
    draw(b, after(b));
    std::swap((*state_[a].place)->edge, (*state_[b].place)->edge);
    std::swap(state_[a], state_[b]);
    expect_crossing(before(b), b);
    expect_crossing(a, after(a));
  }

  /// From an edge on the line to the right, filled follows on empty.
  void settle(std::uint32_t first) {
    if (!state_[first].place) return;
    expect_crossing(before(first), first);
    expect_crossing(first, after(first));
    for (std::optional<std::uint32_t> edge = first; edge; edge = after(*edge)) {
      const auto left = before(*edge);
      const bool inside = !left || !state_[*left].inside;
      if (inside == state_[*edge].inside) return;
      draw(*edge, after(*edge));
      state_[*edge].inside = inside;
      state_[*edge].since = now_;
    }
  }

  void expect_crossing(std::optional<std::uint32_t> left, std::optional<std::uint32_t> right) {
    if (!left || !right) return;
    const Edge& a = edges_[*left];
    const Edge& b = edges_[*right];
    if (order_above(a, b) != Sign::Negative) return;
    const Point last = earlier(a.high, b.high) ? a.high : b.high;
    Point at = crossing_of(a, b);
    if (!geom::is_finite(at) || earlier(last, at)) at = last;
    if (earlier(at, now_)) at = now_;
    crossings_.push({at, *left, *right});
  }

  /// What an edge has filled on its right, up to where the line is now.
  void draw(std::uint32_t edge, std::optional<std::uint32_t> right) {
    State& state = state_[edge];
    const double low = state.since.y;
    const double high = now_.y;
    state.since = now_;
    if (!state.inside || !right || !(high > low)) return;
    const Point a{edges_[edge].x_at(low), low};
    const Point b{edges_[*right].x_at(low), low};
    const Point c{edges_[*right].x_at(high), high};
    const Point d{edges_[edge].x_at(high), high};
    if (b.x > a.x) add_triangle(a, b, c);
    if (c.x > d.x) add_triangle(a, c, d);
  }

  void add_triangle(Point a, Point b, Point c) {
    if (axes_ == Axes::Exchanged) std::swap(b, c);
    triangles_.insert(triangles_.end(), {turned(a), turned(b), turned(c)});
  }

  Axes axes_;
  std::vector<Edge> edges_;
  std::vector<State> state_;  ///< One an edge.
  Line line_{Less{this}};     ///< From left to right.
  std::priority_queue<Crossing> crossings_;
  std::vector<std::uint32_t> touched_;  ///< Edges on the line beside which something has changed.
  Point now_;
  std::vector<Point> triangles_;
};

}  // namespace

std::vector<Point> triangles_of(const Region& region) {
  geom::Box box;
  for (const geom::Polyline& contour : region.contours) box.add(contour.box());
  // Few edges are on the line at a time if it is short.
  const bool wide = !box.empty() && box.width() > box.height();
  return Sweep(region, wide ? Sweep::Axes::Exchanged : Sweep::Axes::AsGiven).run();
}

}  // namespace dobra::scene
