// Curves that two surfaces share: pairs of cells until they cannot hide a loop, a point of each, and a walk along it.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "shared/surf/cells.h"
#include "shared/surf/intersect.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

/// Places in both charts: u, v of the first, u, v of the second.
using Four = Eigen::Vector4d;
using Matrix34 = Eigen::Matrix<double, 3, 4>;

Eigen::Vector3d eigen(Vector3 v) { return {v.x, v.y, v.z}; }
Vector3 unit_or_nought(Vector3 v) {
  const double size = geom::length(v);
  return size > 0.0 ? v / size : Vector3{};
}

struct Both {
  Jet a, b;
  [[nodiscard]] Vector3 gap() const { return a.at - b.at; }
};

struct Limits {
  Four low, high;
  [[nodiscard]] Four width() const { return high - low; }
};

class Search {
 public:
  Search(const Surface& first, const Surface& second)
      : first_(first),
        second_(second),
        in_first_(first),
        in_second_(second),
        size_(std::min(first.size(), second.size())) {
    const double far = std::max(geom::distance(first.at(first.chart().centre()), {}),
                                geom::distance(second.at(second.chart().centre()), {}));
    enough_ = 2e-14 * (std::max(first.size(), second.size()) + far);
    scale_ = limits(first.chart(), second.chart()).width();
  }

  base::Result<SharedSet> run() {
    DOBRA_TRY_VOID(part());
    for (const Pair& pair : regular_) start_from(pair);
    join();
    return std::move(found_);
  }

 private:
  struct Pair {
    std::size_t a, b;
  };

  static Limits limits(const Box& a, const Box& b) {
    return {{a.low.x, a.low.y, b.low.x, b.low.y}, {a.high.x, a.high.y, b.high.x, b.high.y}};
  }
  [[nodiscard]] Both at(const Four& x) const { return {first_.jet({x[0], x[1]}), second_.jet({x[2], x[3]})}; }
  [[nodiscard]] SharedPoint shared(const Four& x) const {
    return {{x[0], x[1]}, {x[2], x[3]}, first_.at({x[0], x[1]})};
  }
  /// By parts of the charts, so that the units of the parameters do not matter.
  [[nodiscard]] Matrix34 derivative(const Both& j) const {
    Matrix34 d;
    d.col(0) = scale_[0] * eigen(j.a.u);
    d.col(1) = scale_[1] * eigen(j.a.v);
    d.col(2) = -scale_[2] * eigen(j.b.u);
    d.col(3) = -scale_[3] * eigen(j.b.v);
    return d;
  }

  // ---- pairs of cells

  static bool apart(const Hull& a, const Hull& b) {
    const Vector3 way = b.centre - a.centre;
    for (const Vector3 axis :
         {unit_or_nought(way), unit_or_nought(cross(a.along_u, a.along_v)), unit_or_nought(cross(b.along_u, b.along_v)),
          unit_or_nought(a.along_u), unit_or_nought(a.along_v), unit_or_nought(b.along_u), unit_or_nought(b.along_v)}) {
      if (std::abs(dot(way, axis)) > a.reach(axis) + b.reach(axis)) return true;
    }
    return false;
  }
  /// No normal of the cell leans from that of the middle by more, radians.
  static double lean(const Hull& hull) {
    const double area = geom::length(cross(hull.along_u, hull.along_v));
    const double turn =
        geom::length(hull.along_u) * hull.turn_v + geom::length(hull.along_v) * hull.turn_u + hull.turn_u * hull.turn_v;
    return turn < area ? std::asin(turn / area) : 4.0;
  }
  static bool transversal(const Hull& a, const Hull& b) {
    const Vector3 n = unit_or_nought(cross(a.along_u, a.along_v)), m = unit_or_nought(cross(b.along_u, b.along_v));
    const double angle = std::atan2(geom::length(cross(n, m)), std::abs(dot(n, m)));
    const double lean_a = lean(a), lean_b = lean(b);
    return lean_a < 0.4 && lean_b < 0.4 && angle > 1.5 * (lean_a + lean_b);
  }

  base::Result<void> part() {
    std::vector<Pair> level;
    for (std::size_t i = 0; i < in_first_.parts(); ++i) {
      for (std::size_t j = 0; j < in_second_.parts(); ++j) level.push_back({i, j});
    }
    constexpr std::size_t most = 100000;
    for (int depth = 0; depth < 200 && !level.empty(); ++depth) {
      std::vector<Pair> next;
      for (const Pair& pair : level) {
        const Hull a = in_first_[pair.a].hull, b = in_second_[pair.b].hull;
        if (apart(a, b)) continue;
        const double larger = std::max(a.radius(), b.radius());
        if (larger < size_ / 6.0 && transversal(a, b)) {
          regular_.push_back(pair);
          continue;
        }
        if (larger < 4e-3 * size_) {
          if (is_about_a_contact(pair)) continue;
          contact(pair);
          if (is_about_a_contact(pair)) continue;
        }
        if (larger < 1e-9 * size_) continue;  // a pole: what passes it is seen beside it
        // The larger one is halved; of two alike the one that bends more.
        if (a.radius() >= b.radius()) {
          for (const std::size_t half : in_first_.halves(pair.a)) next.push_back({half, pair.b});
        } else {
          for (const std::size_t half : in_second_.halves(pair.b)) next.push_back({pair.a, half});
        }
      }
      level = std::move(next);
      if (level.size() > most || found_.contacts.size() > 5000) {
        const Point3 p = level.empty() ? found_.contacts.back().point.at : in_first_[level.front().a].hull.centre;
        return Error{ErrorCode::InvalidOption,
                     "the surfaces share more than curves here, or nearly so: they lie on each other, or touch along "
                     "a line; move or turn one",
                     base::Place{.x = p.x, .y = p.y, .z = p.z}};
      }
    }
    return {};
  }

  [[nodiscard]] bool is_about_a_contact(const Pair& pair) const {
    const Box &a = in_first_[pair.a].box, &b = in_second_[pair.b].box;
    const auto near = [](const Box& box, Point uv) {
      return std::abs(uv.x - box.centre().x) <= 3.0 * box.width() &&
             std::abs(uv.y - box.centre().y) <= 3.0 * box.height();
    };
    return std::any_of(found_.contacts.begin(), found_.contacts.end(), [&](const SharedContact& contact) {
      return near(a, contact.point.first) && near(b, contact.point.second);
    });
  }

  /// Looks for a place near the pair where the normals are parallel and the way from one surface to the other is along
  /// them, and keeps it if the way is nought.
  void contact(const Pair& pair) {
    const Limits box = limits(in_first_[pair.a].box, in_second_[pair.b].box);
    const Four middle = 0.5 * (box.low + box.high), reach = 3.0 * box.width();
    Four x = middle;
    for (int round = 0; round < 25; ++round) {
      const Both j = at(x);
      const Vector3 r = j.gap(), n = cross(j.a.u, j.a.v);
      const Vector3 n_u = cross(j.a.uu, j.a.v) + cross(j.a.u, j.a.uv),
                    n_v = cross(j.a.uv, j.a.v) + cross(j.a.u, j.a.vv);
      Eigen::Matrix4d d;
      Four f;
      f << dot(r, j.b.u), dot(r, j.b.v), dot(n, j.b.u), dot(n, j.b.v);
      d << dot(j.a.u, j.b.u), dot(j.a.v, j.b.u), dot(r, j.b.uu) - dot(j.b.u, j.b.u), dot(r, j.b.uv) - dot(j.b.v, j.b.u),
          dot(j.a.u, j.b.v), dot(j.a.v, j.b.v), dot(r, j.b.uv) - dot(j.b.u, j.b.v), dot(r, j.b.vv) - dot(j.b.v, j.b.v),
          dot(n_u, j.b.u), dot(n_v, j.b.u), dot(n, j.b.uu), dot(n, j.b.uv), dot(n_u, j.b.v), dot(n_v, j.b.v),
          dot(n, j.b.uv), dot(n, j.b.vv);
      d = d * scale_.asDiagonal();
      for (int row = 0; row < 4; ++row) {
        const double size = d.row(row).norm();
        if (!(size > 0.0)) continue;
        d.row(row) /= size, f[row] /= size;
      }
      Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> solver;
      solver.setThreshold(1e-9);
      solver.compute(d);
      const Four step = scale_.cwiseProduct(solver.solve(f));
      x -= step;
      if (!x.allFinite() || ((x - middle).cwiseAbs() - reach).maxCoeff() > 0.0) return;
      if (step.cwiseQuotient(scale_).cwiseAbs().maxCoeff() < 1e-14) break;
    }
    const Limits all = limits(first_.chart(), second_.chart());
    for (int i = 0; i < 4; ++i) {
      const double off = 1e-9 * scale_[i];
      if (x[i] < all.low[i] - off || x[i] > all.high[i] + off) return;
      if (x[i] < all.low[i] + hair * scale_[i]) x[i] = all.low[i];
      if (x[i] > all.high[i] - hair * scale_[i]) x[i] = all.high[i];
    }
    const Both j = at(x);
    const Vector3 n = unit_or_nought(cross(j.a.u, j.a.v)), m = unit_or_nought(cross(j.b.u, j.b.v));
    if (geom::length(j.gap()) > 1e-10 * size_ || geom::length(cross(n, m)) > 1e-5 || n == Vector3{} || m == Vector3{})
      return;
    // Heights over the common tangent plane, by two of its axes.
    const Vector3 e = unit_or_nought(j.a.u), g = cross(n, e);
    const auto heights = [&](const Jet& jet) {
      Eigen::Matrix2d by;
      by << dot(jet.u, e), dot(jet.v, e), dot(jet.u, g), dot(jet.v, g);
      Eigen::Matrix2d form;
      form << dot(jet.uu, n), dot(jet.uv, n), dot(jet.uv, n), dot(jet.vv, n);
      const Eigen::Matrix2d back = by.inverse();
      return Eigen::Matrix2d(back.transpose() * form * back);
    };
    const Eigen::Vector2d bends =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(heights(j.a) - heights(j.b)).eigenvalues();
    const double nought = 1e-5 / size_;
    SharedContact::Kind kind = bends[0] * bends[1] > 0.0 ? SharedContact::Kind::Touch : SharedContact::Kind::Crossing;
    if (std::abs(bends[0]) < nought || std::abs(bends[1]) < nought) kind = SharedContact::Kind::Along;
    for (const SharedContact& other : found_.contacts) {
      if (geom::distance(other.point.at, j.a.at) < 1e-8 * size_) {
        // The same place from another side of a seam: the pair is settled by it too.
        if (geom::distance(other.point.first, {x[0], x[1]}) + geom::distance(other.point.second, {x[2], x[3]}) <
            1e-6 * scale_.sum())
          return;
      }
    }
    found_.contacts.push_back({kind, shared(x)});
  }

  // ---- points and walks

  /// The point of both surfaces that Newton's rule finds with some parameters held; the others stay between limits.
  std::optional<Four> settled(Four x, const Limits& box, int held = -1) const {
    for (int round = 0; round < 40; ++round) {
      const Both j = at(x);
      const Eigen::Vector3d r = eigen(j.gap());
      if (!r.allFinite()) return std::nullopt;
      if (r.norm() <= enough_) return x;
      Matrix34 d = derivative(j);
      const Four down = -(d.transpose() * r);
      for (int i = 0; i < 4; ++i) {
        if (i == held || (x[i] <= box.low[i] && down[i] < 0.0) || (x[i] >= box.high[i] && down[i] > 0.0))
          d.col(i).setZero();
      }
      Eigen::CompleteOrthogonalDecomposition<Matrix34> solver;
      solver.setThreshold(1e-12);
      solver.compute(d);
      const Four step = scale_.cwiseProduct(Four(solver.solve(-r)));
      const Four next = (x + step).cwiseMax(box.low).cwiseMin(box.high);
      if ((next - x).cwiseQuotient(scale_).cwiseAbs().maxCoeff() < 1e-17) break;
      x = next;
    }
    return eigen(at(x).gap()).norm() <= 20.0 * enough_ ? std::optional(x) : std::nullopt;
  }

  /// The point of the curve in the plane through a point, across a direction.
  std::optional<Four> in_plane(Four x, Point3 through, Vector3 across) const {
    double last = 1e300;
    for (int round = 0; round < 12; ++round) {
      const Both j = at(x);
      Four f;
      f << eigen(j.gap()), dot(j.a.at - through, across);
      if (!f.allFinite()) return std::nullopt;
      const double off = f.norm();
      if (off <= enough_ || (round > 2 && off < 20.0 * enough_ && off >= last)) return x;
      last = off;
      const Four step = plane_solver(j, across).solve(f);
      x -= scale_.cwiseProduct(step);
    }
    return std::nullopt;
  }
  [[nodiscard]] Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> plane_solver(const Both& j,
                                                                                     Vector3 across) const {
    Eigen::Matrix4d d;
    d.topRows<3>() = derivative(j);
    d.row(3) << scale_[0] * dot(j.a.u, across), scale_[1] * dot(j.a.v, across), 0.0, 0.0;
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> solver;
    solver.setThreshold(1e-13);
    solver.compute(d);
    return solver;
  }
  /// Unit direction of the curve, on the side of `before`; that itself where the surfaces touch.
  static Vector3 direction(const Both& j, Vector3 before) {
    const Vector3 n = unit_or_nought(cross(j.a.u, j.a.v)), m = unit_or_nought(cross(j.b.u, j.b.v));
    const Vector3 along = cross(n, m);
    if (geom::length(along) < 1e-9) return before;
    const Vector3 unit = unit_or_nought(along);
    return dot(unit, before) < 0.0 ? -unit : unit;
  }

  void start_from(const Pair& pair) {
    const Limits cell = limits(in_first_[pair.a].box, in_second_[pair.b].box);
    const Limits parts = limits(in_first_.part(in_first_[pair.a].part), in_second_.part(in_second_[pair.b].part));
    const Four middle = 0.5 * (cell.low + cell.high), half = 0.45 * cell.width();
    for (int seed = 0; seed < 5; ++seed) {
      Four x = middle;
      if (seed > 0) x += half.cwiseProduct(Four(seed & 1 ? 1 : -1, seed & 2 ? 1 : -1, 0, 0));
      const std::optional<Four> on = settled(x, cell);
      if (!on || is_known(*on)) continue;
      trace(*on, parts);
    }
  }

  /// Whether a traced curve passes the place.
  [[nodiscard]] bool is_known(const Four& x) const {
    const SharedPoint here = shared(x);
    for (const Traced& each : traced_) {
      for (std::size_t k = 1; k < each.points.size(); ++k) {
        const Four &p = each.points[k - 1], &q = each.points[k];
        const Point3 a = each.at[k - 1], b = each.at[k];
        const Vector3 chord = b - a;
        const double length = geom::length(chord);
        if (geom::distance(here.at, a) > 1.3 * length) continue;
        const double part = dot(here.at - a, chord) / (length * length);
        if (part < -0.02 || part > 1.02) continue;
        const Four guess = p + part * (q - p);
        if ((guess - x).cwiseQuotient(scale_).cwiseAbs().maxCoeff() > 0.3) continue;
        const std::optional<Four> there = in_plane(guess, here.at, chord / length);
        if (there && (*there - x).cwiseQuotient(scale_).cwiseAbs().maxCoeff() < 1e-5 &&
            geom::distance(first_.at({(*there)[0], (*there)[1]}), here.at) < 1e-8 * size_)
          return true;
      }
    }
    return false;
  }

  struct Traced {
    std::vector<Four> points;
    std::vector<Point3> at;
    bool closed = false;
  };

  void trace(const Four& start, const Limits& parts) {
    Traced forward = walked(start, parts, 1.0);
    if (!forward.closed) {
      const Traced back = walked(start, parts, -1.0);
      std::vector<Four> points(back.points.rbegin(), back.points.rend());
      std::vector<Point3> places(back.at.rbegin(), back.at.rend());
      if (forward.points.size() == 1) points.back() = forward.points.front();  // a start a hair from its end
      points.insert(points.end(), forward.points.begin() + 1, forward.points.end());
      places.insert(places.end(), forward.at.begin() + 1, forward.at.end());
      forward.points = std::move(points);
      forward.at = std::move(places);
    }
    if (forward.points.size() > 1) traced_.push_back(std::move(forward));
  }

  /// Along the curve until it leaves the parts, or comes back.
  Traced walked(const Four& start, const Limits& parts, double sense) const {
    Traced made;
    const auto add = [&](const Four& x) {
      made.points.push_back(x);
      made.at.push_back(first_.at({x[0], x[1]}));
    };
    add(start);
    const double longest = 0.02 * size_, shortest = 1e-10 * size_;
    double step = 0.01 * size_;
    Both j = at(start);
    Vector3 way =
        sense * unit_or_nought(cross(unit_or_nought(cross(j.a.u, j.a.v)), unit_or_nought(cross(j.b.u, j.b.v))));
    Four x = start;
    constexpr std::size_t most = 200000;
    while (made.points.size() < most) {
      const Point3 here = j.a.at;
      // Back at the start?
      const Vector3 home = made.at.front() - here;
      if (made.points.size() > 4 && dot(home, way) > 0.0 && dot(home, way) <= step &&
          geom::length(home) <= 1.3 * dot(home, way)) {
        const std::optional<Four> there = in_plane(x + dot(home, way) * tangent(j, way), made.at.front(), way);
        if (there && (*there - start).cwiseQuotient(scale_).cwiseAbs().maxCoeff() < 1e-6) {
          add(start);
          made.closed = true;
          return made;
        }
      }
      const Four guess = x + step * tangent(j, way);
      const Point3 wanted = here + step * way;
      const std::optional<Four> next = guess.allFinite() ? in_plane(guess, wanted, way) : std::nullopt;
      bool good = next.has_value();
      Both there;
      Vector3 onward;
      if (good) {
        there = at(*next);
        onward = direction(there, way);
        good = dot(onward, way) > 0.978 && geom::distance(there.a.at, wanted) < 0.25 * step;
      }
      const auto shorter = [&] { return (step *= 0.5) >= shortest; };
      if (!good) {
        // Over a border nothing need be there to be found.
        if (const std::optional<Four> end = end_of(x, guess, parts)) {
          if (geom::distance(first_.at({(*end)[0], (*end)[1]}), here) <= 2.0 * step) {
            finish(made, *end);
            return made;
          }
        }
        if (shorter()) continue;
        return made;
      }
      if (((*next - parts.high).cwiseQuotient(scale_)).maxCoeff() > hair ||
          ((parts.low - *next).cwiseQuotient(scale_)).maxCoeff() > hair) {
        if (const std::optional<Four> end = end_of(x, *next, parts)) {
          finish(made, *end);
          return made;
        }
        if (shorter()) continue;
        return made;
      }
      x = next->cwiseMax(parts.low).cwiseMin(parts.high);
      j = at(x);
      if (dot(onward, way) > 0.9976) step = std::min(1.6 * step, longest);
      way = onward;
      add(x);
    }
    return made;
  }
  static constexpr double hair = 1e-12;

  /// The change of all four parameters for a unit of way.
  [[nodiscard]] Four tangent(const Both& j, Vector3 way) const {
    const Four solved = plane_solver(j, way).solve(Four(0, 0, 0, 1));
    return scale_.cwiseProduct(solved);
  }

  static void finish_at(Traced& made, const Four& end, Point3 at) {
    made.points.push_back(end);
    made.at.push_back(at);
  }
  void finish(Traced& made, const Four& end) const {
    const Point3 p = first_.at({end[0], end[1]});
    if (geom::distance(p, made.at.back()) <= 1e-12 * size_) {  // the border itself, not a hair before it
      made.points.pop_back();
      made.at.pop_back();
    }
    finish_at(made, end, p);
  }

  /// Where the curve leaves the parts between a place inside and one outside: the parameter that leaves first is held
  /// at its limit.
  std::optional<Four> end_of(const Four& inside, const Four& outside, const Limits& parts) const {
    struct Way {
      double part;
      int index;
      double limit;
    };
    std::vector<Way> ways;
    for (int i = 0; i < 4; ++i) {
      for (const double limit : {parts.low[i], parts.high[i]}) {
        const bool leaves = limit == parts.low[i] ? outside[i] < limit : outside[i] > limit;
        if (leaves) ways.push_back({std::clamp((limit - inside[i]) / (outside[i] - inside[i]), 0.0, 1.0), i, limit});
      }
    }
    std::sort(ways.begin(), ways.end(), [](const Way& p, const Way& q) { return p.part < q.part; });
    for (const Way& each : ways) {
      Four x = (inside + each.part * (outside - inside)).cwiseMax(parts.low).cwiseMin(parts.high);
      x[each.index] = each.limit;
      if (const std::optional<Four> end = settled(x, parts, each.index)) return end;
    }
    return std::nullopt;
  }

  // ---- what the user gets

  /// Curves whose ends meet in one place, two there, are one.
  void join() {
    struct Chain {
      std::vector<SharedPoint> points;
      bool closed;
    };
    std::vector<Chain> chains;
    for (const Traced& each : traced_) {
      Chain chain{{}, each.closed};
      for (const Four& x : each.points) chain.points.push_back(shared(x));
      chains.push_back(std::move(chain));
    }
    const double same = 1e-9 * size_;
    for (const SharedContact& contact : found_.contacts) {
      if (contact.kind != SharedContact::Kind::Crossing) continue;
      for (std::size_t i = 0; i < chains.size(); ++i) {
        const std::size_t k = passes(chains[i].points, contact);
        if (k == 0) continue;
        auto& points = chains[i].points;
        const auto at = points.begin() + static_cast<std::ptrdiff_t>(k);
        std::vector<SharedPoint> rest(at, points.end());
        points.erase(at, points.end());
        points.push_back(contact.point);
        rest.insert(rest.begin(), contact.point);
        if (chains[i].closed) {  // it begins and ends in the contact
          rest.insert(rest.end(), points.begin() + 1, points.end());
          points = std::move(rest);
          chains[i].closed = false;
          continue;
        }
        chains.push_back({std::move(rest), false});
      }
    }
    for (Chain& chain : chains) {
      end_in_contacts(chain.points);
      std::reverse(chain.points.begin(), chain.points.end());
      end_in_contacts(chain.points);
      std::reverse(chain.points.begin(), chain.points.end());
    }
    drop_doubles(chains, same);
    std::erase_if(chains, [this](const Chain& chain) { return is_speck(chain.points); });
    for (bool again = true; again;) {
      again = false;
      for (std::size_t i = 0; i < chains.size() && !again; ++i) {
        if (chains[i].closed) continue;
        for (const bool at_end : {true, false}) {
          const Point3 end = at_end ? chains[i].points.back().at : chains[i].points.front().at;
          if (curves_cross_at(end, same)) continue;        // a curve has a corner there
          std::vector<std::pair<std::size_t, bool>> meet;  // ends of chains at this place; true: the last point
          for (std::size_t k = 0; k < chains.size(); ++k) {
            if (chains[k].closed) continue;
            if (geom::distance(chains[k].points.front().at, end) <= same) meet.emplace_back(k, false);
            if (geom::distance(chains[k].points.back().at, end) <= same) meet.emplace_back(k, true);
          }
          if (meet.size() != 2) continue;
          if (meet[0].first == meet[1].first) {
            chains[i].closed = true;
          } else {
            Chain &a = chains[meet[0].first], &b = chains[meet[1].first];
            if (!meet[0].second) std::reverse(a.points.begin(), a.points.end());
            if (meet[1].second) std::reverse(b.points.begin(), b.points.end());
            a.points.insert(a.points.end(), b.points.begin(), b.points.end());
            chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(meet[1].first));
          }
          again = true;
          break;
        }
      }
    }
    // A contact on a seam is found from both sides.
    std::vector<SharedContact> contacts;
    for (const SharedContact& each : found_.contacts) {
      const bool known = std::any_of(contacts.begin(), contacts.end(), [&](const SharedContact& other) {
        return geom::distance(each.point.at, other.point.at) <= 1e-8 * size_;
      });
      if (!known) contacts.push_back(each);
    }
    found_.contacts = std::move(contacts);
    for (Chain& chain : chains) found_.curves.push_back({std::move(chain.points), chain.closed});
  }

  [[nodiscard]] bool curves_cross_at(Point3 place, double same) const {
    return std::any_of(found_.contacts.begin(), found_.contacts.end(), [&](const SharedContact& contact) {
      return contact.kind == SharedContact::Kind::Crossing && geom::distance(contact.point.at, place) <= same;
    });
  }

  /// The number of the point before which a curve passes a contact, not in one of its ends; 0 where it does not.
  [[nodiscard]] std::size_t passes(const std::vector<SharedPoint>& points, const SharedContact& contact) const {
    constexpr double beside = 1e-3;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const SharedPoint &p = points[k - 1], &q = points[k];
      const Vector3 chord = q.at - p.at;
      const double square = dot(chord, chord);
      const double part = square > 0.0 ? dot(contact.point.at - p.at, chord) / square : -1.0;
      if (!(part >= 0.0 && part < 1.0)) continue;
      const SharedPoint there{p.first + part * (q.first - p.first), p.second + part * (q.second - p.second),
                              p.at + part * chord};
      if (apart(there, contact.point) > beside) continue;
      const bool at_first = k == 1 && apart(p, contact.point) <= near_contact;
      const bool at_last = k + 1 == points.size() && apart(q, contact.point) <= near_contact;
      return at_first || at_last ? 0 : k;
    }
    return 0;
  }

  /// By parts of the charts.
  [[nodiscard]] double apart(const SharedPoint& p, const SharedPoint& q) const {
    const Four x(p.first.x - q.first.x, p.first.y - q.first.y, p.second.x - q.second.x, p.second.y - q.second.y);
    return x.cwiseQuotient(scale_).cwiseAbs().maxCoeff();
  }
  static constexpr double near_contact = 1e-5;

  /// Where the surfaces touch at the end of a curve, the end is known to the root of the rounding only, the contact
  /// much better.
  void end_in_contacts(std::vector<SharedPoint>& points) const {
    for (const SharedContact& contact : found_.contacts) {
      if (contact.kind != SharedContact::Kind::Crossing || apart(points.back(), contact.point) > near_contact) continue;
      while (points.size() > 2 && apart(points[points.size() - 2], contact.point) <= near_contact) points.pop_back();
      points.back() = contact.point;
      return;
    }
  }

  /// Of a curve through a pole hardly more than rounding is left beside it, which may be found as a curve of its own.
  [[nodiscard]] bool is_speck(const std::vector<SharedPoint>& points) const {
    const auto near = [&](const SharedPoint& p) { return geom::distance(p.at, points.front().at) <= 1e-7 * size_; };
    return std::all_of(points.begin(), points.end(), near) &&
           std::any_of(points.begin(), points.end(),
                       [&](const SharedPoint& p) { return first_.in_pole(p.first) || second_.in_pole(p.second); });
  }

  /// A curve that runs along a seam or a corner is found from both sides.
  template <class Chains>
  void drop_doubles(Chains& chains, double same) const {
    const auto lies_on = [&](const auto& inner, const auto& outer) {
      const double sag = 0.02;
      for (const SharedPoint& p : inner.points) {
        bool near = false;
        for (std::size_t k = 1; k < outer.points.size() && !near; ++k) {
          const Point3 a = outer.points[k - 1].at;
          const Vector3 chord = outer.points[k].at - a;
          const double length = geom::length(chord),
                       part = length > 0.0 ? std::clamp(dot(p.at - a, chord) / (length * length), 0.0, 1.0) : 0.0;
          near = geom::distance(p.at, a + part * chord) <=
                 std::max(same, sag * length * std::min(part, 1.0 - part) * 4.0 + same);
        }
        if (!near) return false;
      }
      return true;
    };
    for (std::size_t i = 0; i < chains.size(); ++i) {
      for (std::size_t k = chains.size(); k-- > i + 1;) {
        const bool ends = geom::distance(chains[i].points.front().at, chains[k].points.front().at) <= same ||
                          geom::distance(chains[i].points.front().at, chains[k].points.back().at) <= same ||
                          chains[i].closed;
        if (ends && lies_on(chains[k], chains[i])) chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
  }

  const Surface &first_, &second_;
  Cells in_first_, in_second_;
  double size_, enough_ = 0.0;
  Four scale_;
  std::vector<Pair> regular_;
  std::vector<Traced> traced_;
  SharedSet found_;
};

}  // namespace

base::Result<SharedSet> intersect_surfaces(const Surface& first, const Surface& second) {
  return Search(first, second).run();
}

base::Result<SharedSet> intersect_plane(const Surface& surface, Point3 on_plane, Vector3 normal) {
  if (!geom::is_finite(on_plane) || !geom::is_finite(normal))
    return Error{ErrorCode::NotFinite, "the plane has a number that is not finite"};
  if (normal == Vector3{}) return Error{ErrorCode::DegenerateCurve, "the normal of the plane has no direction"};
  const Vector3 n = geom::normalised(normal);
  const Vector3 axis = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Vector3{1, 0, 0}
                       : std::abs(n.y) <= std::abs(n.z)                                 ? Vector3{0, 1, 0}
                                                                                        : Vector3{0, 0, 1};
  const Vector3 x = geom::normalised(cross(axis, n)), y = cross(n, x);
  // As much of the plane as the surface can reach.
  const Cells cells(surface);
  Box chart;
  for (std::size_t i = 0; i < cells.parts(); ++i) {
    const Hull& hull = cells[i].hull;
    const Vector3 from = hull.centre - on_plane;
    chart.add(Point{dot(from, x) - hull.reach(x), dot(from, y) - hull.reach(y)});
    chart.add(Point{dot(from, x) + hull.reach(x), dot(from, y) + hull.reach(y)});
  }
  DOBRA_TRY(const Surface plane, Surface::plane({on_plane, x, y, n}, chart.grown(0.01 * surface.size())));
  return intersect_surfaces(surface, plane);
}

}  // namespace dobra::surf
