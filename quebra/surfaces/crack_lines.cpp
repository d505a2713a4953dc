#include "quebra/surfaces/crack_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "shared/offset/offset.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Result;
using geom::Point;
using geom::Point3;
using geom::Vector;
using surf::Curve;
using surf::Surface;
using surf::trim::ChartEdge;

namespace {

constexpr double pi = std::numbers::pi;

/// x = a u + b v, y = d v: lengths near one place of the chart are those in space.
struct LocalChart {
  double a = 1.0, b = 0.0, d = 1.0;

  static std::optional<LocalChart> at(const Surface& surface, Point uv) {
    const auto jet = surface.jet(uv);
    const double e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v);
    const double area = e * g - f * f;
    constexpr double flat = 1e-18;
    if (!(area > flat * e * g) || !(e > 0.0)) return std::nullopt;
    return LocalChart{std::sqrt(e), f / std::sqrt(e), std::sqrt(area / e)};
  }
  [[nodiscard]] Point in(Point uv) const { return {a * uv.x + b * uv.y, d * uv.y}; }
  [[nodiscard]] Point out(Point p) const { return {(p.x - b * p.y / d) / a, p.y / d}; }
  /// Greatest over least stretch of another chart seen from this one, and of both over 1.
  [[nodiscard]] double skew(const LocalChart& other) const {
    const double p = other.a / a, q = (other.b - p * b) / d, r = other.d / d;
    const double sum = p * p + q * q + r * r, product = p * r;
    const double root = std::sqrt(std::max(0.0, sum * sum - 4.0 * product * product));
    const double most = std::sqrt(0.5 * (sum + root)), least = product / most;
    return std::max(most, 1.0) / std::min(least, 1.0);
  }
};

double turn(Point a, Point b, Point c) {
  const Vector in = b - a, out = c - b;
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

class CrackLineMaker {
 public:
  CrackLineMaker(const Surface& surface, const DrawnCrack& crack, const std::vector<std::vector<Point>>& bounds,
                 const CrackLineOptions& options)
      : surface_(surface), crack_(crack), bounds_(bounds), options_(options) {
    for (const Point p : crack_.places) in_space_.push_back(surface_.at(p));
  }

  Result<CrackLines> run() {
    const Point middle = crack_.places[crack_.places.size() / 2];
    const auto chart = LocalChart::at(surface_, middle);
    if (!chart) {
      doubt(options_.bands.empty() ? "rosette_left_out" : "band_left_out",
            fmt::format("crack '{}' has no bands and no rosettes: the surface has no normal there", crack_.name),
            middle);
      return made_;
    }
    chart_ = *chart;
    if (!options_.bands.empty()) tell_skew();
    for (std::size_t i = 0; i < options_.bands.size(); ++i) DOBRA_TRY_VOID(add_band(i));
    if (options_.rosette > 0.0 && !crack_.closed) {
      DOBRA_TRY_VOID(add_rosette(false));
      DOBRA_TRY_VOID(add_rosette(true));
    }
    return made_;
  }

 private:
  void doubt(std::string code, std::string message, Point at) {
    made_.doubts.push_back({std::move(code), std::move(message), at});
  }

  void tell_skew() {
    double worst = 1.0;
    Point where = crack_.places.front();
    for (const Point p : crack_.places) {
      const auto other = LocalChart::at(surface_, p);
      const double skew = other ? chart_.skew(*other) : std::numeric_limits<double>::infinity();
      if (skew > worst) worst = skew, where = p;
    }
    if (worst <= options_.most_skew) return;
    doubt("band_skewed",
          fmt::format("the chart is stretched {:.3g} times as much here as in the middle of crack '{}': look at its "
                      "bands, or draw it in parts",
                      worst, crack_.name),
          where);
  }

  /// The crack in the local chart, without places on straight parts.
  [[nodiscard]] geom::Polyline base(double distance) const {
    constexpr double straight = 1e-4;
    std::vector<Point> all;
    for (const Point p : crack_.places) {
      if (all.empty() || chart_.in(p) != all.back()) all.push_back(chart_.in(p));
    }
    if (crack_.closed && all.size() > 1) all.pop_back();
    geom::Polyline base{{all.front()}, crack_.closed};
    std::size_t kept = 0;
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      bool needed = false;
      const Vector chord = all[i + 1] - all[kept];
      const double length = geom::length(chord);
      for (std::size_t k = kept + 1; k <= i && !needed; ++k)
        needed = std::abs(cross(chord, all[k] - all[kept])) > straight * distance * length;
      if (needed) base.points.push_back(all[i]), kept = i;
    }
    base.points.push_back(all.back());
    return base;
  }

  Result<void> add_band(std::size_t number) {
    const double distance = options_.bands[number];
    const geom::Polyline along = base(distance);
    std::vector<std::vector<Point>> contours, sides;
    for (const offset::Side side : {offset::Side::RightOfTravel, offset::Side::LeftOfTravel}) {
      offset::OffsetOptions wanted;
      wanted.side = side;
      wanted.join = offset::Join::Round;
      const std::array<double, 1> distances{distance};
      DOBRA_TRY(const auto curves, offset::offset(along, distances, wanted));
      for (const offset::OffsetPiece& piece : curves[0].pieces) {
        constexpr double chord = 0.01;
        const auto drawn = offset::chords(piece, along, chord).polyline.points;
        (piece.closed ? contours : sides).push_back(drawn);
      }
    }
    if (!crack_.closed) {
      if (!joins(along, sides, distance)) {
        doubt("band_left_out",
              fmt::format("crack '{}' has no band at {:.6g} m: it bends back on itself nearer than that", crack_.name,
                          distance),
              crack_.places.front());
        return {};
      }
      contours.push_back(round(along, sides));
    }
    const std::string name = fmt::format("{}_band_{}", crack_.name, number + 1);
    double missed = 0.0;
    Point where;
    for (std::vector<Point>& contour : contours) {
      std::vector<Point> places = stepped(contour, 0.3 * distance);
      for (Point& p : places) {
        p = chart_.out(p);
        if (!inside(p)) continue;
        const double off = move_to(p, distance);
        if (off > missed) missed = off, where = p;
      }
      DOBRA_TRY_VOID(draw(name, places));
    }
    if (missed > options_.accuracy) {
      doubt("band_skewed",
            fmt::format("the band of crack '{}' at {:.6g} m is {:.3g} % off that distance here", crack_.name, distance,
                        100.0 * missed),
            where);
    }
    return {};
  }

  /// Both sides run from end to end of the crack.
  static bool joins(const geom::Polyline& along, const std::vector<std::vector<Point>>& sides, double distance) {
    if (sides.size() != 2) return false;
    constexpr double near = 1e-3;
    const auto at = [&](Point p, Point end) { return std::abs(geom::distance(p, end) / distance - 1.0) < near; };
    return std::all_of(sides.begin(), sides.end(), [&](const std::vector<Point>& side) {
      return side.size() > 1 && at(side.front(), along.points.front()) && at(side.back(), along.points.back());
    });
  }

  /// The right side, round the end, the left side back, round the start.
  static std::vector<Point> round(const geom::Polyline& along, const std::vector<std::vector<Point>>& sides) {
    std::vector<Point> contour = sides[0];
    const auto cap = [&](Point centre, Point from) {
      constexpr int steps = 12;
      const Vector first = from - centre;
      for (int k = 1; k < steps; ++k) {
        const double angle = pi * k / steps;
        contour.push_back(centre + geom::Vector{std::cos(angle) * first.x - std::sin(angle) * first.y,
                                                std::sin(angle) * first.x + std::cos(angle) * first.y});
      }
    };
    cap(along.points.back(), sides[0].back());
    contour.insert(contour.end(), sides[1].rbegin(), sides[1].rend());
    cap(along.points.front(), sides[1].front());
    return contour;
  }

  static std::vector<Point> stepped(const std::vector<Point>& contour, double step) {
    constexpr double most = 400.0;
    double length = 0.0;
    for (std::size_t i = 0; i < contour.size(); ++i) length += distance(contour[i], contour[(i + 1) % contour.size()]);
    step = std::max(step, length / most);
    std::vector<Point> places;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point a = contour[i], b = contour[(i + 1) % contour.size()];
      const int count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / step)));
      if (distance(a, b) < 0.02 * step) continue;
      for (int k = 0; k < count; ++k) places.push_back(a + (static_cast<double>(k) / count) * (b - a));
    }
    return places;
  }

  [[nodiscard]] bool inside(Point uv) const {
    const geom::Box& box = surface_.chart();
    return (surface_.closed_u() || (uv.x >= box.low.x && uv.x <= box.high.x)) &&
           (surface_.closed_v() || (uv.y >= box.low.y && uv.y <= box.high.y));
  }

  /// Foot on the crack, in the chart, and the distance in space.
  [[nodiscard]] std::pair<Point, double> foot(Point uv) const {
    const Point3 at = surface_.at(uv);
    double best = std::numeric_limits<double>::infinity();
    Point where;
    for (std::size_t i = 0; i + 1 < in_space_.size(); ++i) {
      const geom::Vector3 by = in_space_[i + 1] - in_space_[i];
      const double square = dot(by, by);
      const double t = square > 0.0 ? std::clamp(dot(at - in_space_[i], by) / square, 0.0, 1.0) : 0.0;
      const double away = geom::length(at - (in_space_[i] + t * by));
      if (away >= best) continue;
      best = away;
      where = crack_.places[i] + t * (crack_.places[i + 1] - crack_.places[i]);
    }
    return {where, best};
  }

  /// @return by what part of it the distance is missed
  [[nodiscard]] double move_to(Point& uv, double distance) const {
    constexpr int times = 4;
    const geom::Box& box = surface_.chart();
    for (int k = 0; k < times; ++k) {
      const auto [from, away] = foot(uv);
      if (!(away > 0.0)) return 1.0;
      uv = from + (distance / away) * (uv - from);
      if (!surface_.closed_u()) uv.x = std::clamp(uv.x, box.low.x, box.high.x);
      if (!surface_.closed_v()) uv.y = std::clamp(uv.y, box.low.y, box.high.y);
    }
    const bool at_border = (!surface_.closed_u() && (uv.x == box.low.x || uv.x == box.high.x)) ||
                           (!surface_.closed_v() && (uv.y == box.low.y || uv.y == box.high.y));
    return at_border ? 0.0 : std::abs(foot(uv).second / distance - 1.0);
  }

  /// A closed contour as lines of splines between corners, what is outside the chart left out.
  Result<void> draw(const std::string& name, const std::vector<Point>& places) {
    const std::size_t n = places.size();
    if (n < 3) return {};
    std::size_t first = n;
    for (std::size_t i = 0; i < n && first == n; ++i) first = inside(places[i]) ? n : i;
    if (first == n) {
      std::vector<Point> whole = places;
      whole.push_back(places.front());
      return add(name, whole, true);
    }
    std::vector<Point> part;
    const auto flush = [&]() -> Result<void> {
      if (part.size() > 1) DOBRA_TRY_VOID(add(name, part, false));
      part.clear();
      return {};
    };
    for (std::size_t k = 1; k <= n; ++k) {
      const Point before = places[(first + k - 1) % n], p = places[(first + k) % n];
      if (inside(p)) {
        if (!inside(before)) part = {at_border(p, before)};
        if (part.empty() || part.back() != p) part.push_back(p);
      } else if (!part.empty()) {
        const Point end = at_border(part.back(), p);
        if (end != part.back()) part.push_back(end);
        DOBRA_TRY_VOID(flush());
      }
    }
    return flush();
  }

  /// Where the way from a place inside to one outside leaves the chart.
  [[nodiscard]] Point at_border(Point in, Point out) const {
    const geom::Box& box = surface_.chart();
    double t = 1.0;
    const auto cut = [&](double from, double to, double low, double high) {
      if (to < low) t = std::min(t, (low - from) / (to - from));
      if (to > high) t = std::min(t, (high - from) / (to - from));
    };
    if (!surface_.closed_u()) cut(in.x, out.x, box.low.x, box.high.x);
    if (!surface_.closed_v()) cut(in.y, out.y, box.low.y, box.high.y);
    Point p = in + t * (out - in);
    const double wide = 1e-12 * box.width(), high = 1e-12 * box.height();
    if (!surface_.closed_u()) {
      if (p.x <= box.low.x + wide) p.x = box.low.x;
      if (p.x >= box.high.x - wide) p.x = box.high.x;
    }
    if (!surface_.closed_v()) {
      if (p.y <= box.low.y + high) p.y = box.low.y;
      if (p.y >= box.high.y - high) p.y = box.high.y;
    }
    return p;
  }

  Result<void> add(const std::string& name, std::vector<Point> places, bool closed) {
    constexpr double corner = 0.7;  // of a turn between two steps; a round end turns by a quarter of it
    const auto sharp = [&](Point a, Point b, Point c) {
      return turn(chart_.in(a), chart_.in(b), chart_.in(c)) > corner;
    };
    if (closed) {
      const std::size_t n = places.size() - 1;
      for (std::size_t i = 0; i < n; ++i) {
        if (!sharp(places[(i + n - 1) % n], places[i], places[i + 1])) continue;
        places.pop_back();
        std::rotate(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), places.end());
        places.push_back(places.front());
        break;
      }
    }
    CrackLines::Line line{name, closed, {}};
    std::vector<Point3> part;
    std::vector<double> lengths;  // in space nearly: those of the chart have other units in u than in v
    for (std::size_t i = 0; i < places.size(); ++i) {
      lengths.push_back(part.empty() ? 0.0 : lengths.back() + distance(chart_.in(places[i - 1]), chart_.in(places[i])));
      part.push_back({places[i].x, places[i].y, 0.0});
      const bool last = i + 1 == places.size();
      if (!last && (i == 0 || !sharp(places[i - 1], places[i], places[i + 1]))) continue;
      DOBRA_TRY(Curve curve, Curve::through(part, lengths));
      const double from = curve.low(), to = curve.high();
      line.edges.push_back({.curve = std::move(curve), .from = from, .to = to, .name = name});
      part = {part.back()};
      lengths = {0.0};
    }
    made_.lines.push_back(std::move(line));
    return {};
  }

  /// The place of the crack that is `radius` from its end in space, on the edge that ends there.
  [[nodiscard]] std::optional<Point> on_crack(bool at_end, double radius) const {
    const ChartEdge& edge = at_end ? crack_.edges.back() : crack_.edges.front();
    double near = at_end ? edge.to : edge.from, far = at_end ? edge.from : edge.to;
    const Point3 tip = surface_.at(edge.at(near));
    const auto beyond = [&](double t) { return geom::distance(surface_.at(edge.at(t)), tip) > radius; };
    const double whole = far - near, start = near;
    constexpr int steps = 256;
    bool found = false;
    for (int k = 1; k <= steps && !found; ++k) {
      far = start + whole * k / steps;
      found = beyond(far);
      if (!found) near = far;
    }
    if (!found) return std::nullopt;
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) (beyond(0.5 * (near + far)) ? far : near) = 0.5 * (near + far);
    return edge.at(near);
  }

  Result<void> add_rosette(bool at_end) {
    const double radius = options_.rosette;
    const Point tip = at_end ? crack_.places.back() : crack_.places.front();
    const Point3 centre = surface_.at(tip);
    const auto left_out = [&](const char* why) {
      doubt("rosette_left_out", fmt::format("an end of crack '{}' has no rosette: {}", crack_.name, why), tip);
      return Result<void>{};
    };
    double room = std::numeric_limits<double>::infinity();
    for (const auto& bound : bounds_) {
      for (const Point p : bound) room = std::min(room, geom::distance(surface_.at(p), centre));
    }
    constexpr double mouth = 0.05, spare = 1.05;
    if (room < mouth * radius || at_side(tip)) return {};
    if (room < spare * radius) return left_out("a border is nearer than its radius");
    const auto chart = LocalChart::at(surface_, tip);
    if (!chart) return left_out("the surface has no normal there");
    const auto first = on_crack(at_end, radius);
    if (!first) return left_out("the last part of the crack is shorter than its radius");
    const Vector back = chart->in(*first) - chart->in(tip);
    std::vector<Point> ring{*first};
    for (int k = 1; k < options_.sectors; ++k) {
      const double angle = 2.0 * pi * k / options_.sectors;
      const Vector by{std::cos(angle) * back.x - std::sin(angle) * back.y,
                      std::sin(angle) * back.x + std::cos(angle) * back.y};
      Point p = chart->out(chart->in(tip) + by);
      constexpr int times = 4;
      for (int i = 0; i < times; ++i) {
        if (!inside(p)) return left_out("a border is nearer than its radius");
        p = tip + (radius / geom::distance(surface_.at(p), centre)) * (p - tip);
      }
      if (!inside(p)) return left_out("a border is nearer than its radius");
      ring.push_back(p);
    }
    return add_ring(tip, ring);
  }

  /// Whether a place lies on a side of the chart.
  [[nodiscard]] bool at_side(Point p) const {
    const geom::Box& box = surface_.chart();
    const double wide = 1e-9 * box.width(), high = 1e-9 * box.height();
    return (!surface_.closed_u() && (p.x <= box.low.x + wide || p.x >= box.high.x - wide)) ||
           (!surface_.closed_v() && (p.y <= box.low.y + high || p.y >= box.high.y - high));
  }

  Result<void> add_ring(Point tip, const std::vector<Point>& ring) {
    const std::string name = crack_.name + "_rosette";
    const auto straight = [&](Point a, Point b) -> Result<ChartEdge> {
      DOBRA_TRY(Curve curve, Curve::line({a.x, a.y, 0.0}, {b.x, b.y, 0.0}));
      return ChartEdge{.curve = std::move(curve), .from = 0.0, .to = 1.0, .name = name};
    };
    CrackLines::Line round{name, true, {}};
    for (std::size_t k = 0; k < ring.size(); ++k) {
      DOBRA_TRY(ChartEdge edge, straight(ring[k], ring[(k + 1) % ring.size()]));
      round.edges.push_back(std::move(edge));
      if (k == 0) continue;  // the crack itself
      DOBRA_TRY(ChartEdge spoke, straight(tip, ring[k]));
      made_.lines.push_back({name, false, {std::move(spoke)}});
    }
    made_.lines.push_back(std::move(round));
    made_.tips.push_back({tip, {}, options_.rosette});
    return {};
  }

  const Surface& surface_;
  const DrawnCrack& crack_;
  const std::vector<std::vector<Point>>& bounds_;
  const CrackLineOptions& options_;
  LocalChart chart_;
  std::vector<Point3> in_space_;
  CrackLines made_;
};

}  // namespace

Result<CrackLines> crack_lines(const Surface& surface, const DrawnCrack& crack,
                               const std::vector<std::vector<Point>>& bounds, const CrackLineOptions& options) {
  if (crack.places.size() < 2) return CrackLines{};
  return CrackLineMaker(surface, crack, bounds, options).run();
}

}  // namespace quebra::surfaces
