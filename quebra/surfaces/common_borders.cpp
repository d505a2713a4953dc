#include "quebra/surfaces/common_borders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "shared/base/disjoint_sets.h"
#include "shared/surf/closest.h"
#include "shared/surf/measure.h"
#include "shared/surf/trim/rings.h"

namespace quebra::surfaces {

using namespace dobra;
using geom::Point3;
using geom::Vector3;
using surf::mesh::Finding;
using surf::trim::ChartEdge;
using surf::trim::TrimmedSurface;

namespace {

constexpr int steps = 64;  // of an edge, to see where it runs
/// A border that ends nearer to another face than this part of the smaller one's size was meant to meet it: a web
/// drawn to the side of a plate instead of its middle, or a number with a digit too few.
constexpr double ends_beside = 1e-3;

struct Box3 {
  Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  void add(Point3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  [[nodiscard]] bool near(const Box3& other, double gap) const {
    return low.x <= other.high.x + gap && other.low.x <= high.x + gap && low.y <= other.high.y + gap &&
           other.low.y <= high.y + gap && low.z <= other.high.z + gap && other.low.z <= high.z + gap;
  }
  [[nodiscard]] double diagonal() const { return distance(low, high); }
};

/// An edge of a loop as a curve in space; t runs from 0 to 1.
class Border {
 public:
  Border(std::size_t face, const surf::Surface& surface, ChartEdge edge, bool inside)
      : face_(face), surface_(&surface), edge_(std::move(edge)), inside_(inside) {
    for (int i = 0; i <= steps; ++i) {
      at_.push_back(at(static_cast<double>(i) / steps));
      box_.add(at_.back());
      if (i > 0) length_ += distance(at_[static_cast<std::size_t>(i) - 1], at_.back());
    }
  }
  [[nodiscard]] std::size_t face() const { return face_; }
  [[nodiscard]] const surf::Surface& surface() const { return *surface_; }
  [[nodiscard]] const ChartEdge& edge() const { return edge_; }
  /// Of a line inside its face, not of a loop.
  [[nodiscard]] bool inside() const { return inside_; }
  [[nodiscard]] const Box3& box() const { return box_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] Point3 at(double t) const { return surface_->at(edge_.at(parameter(t))); }
  /// Where it is in the chart, and which way it runs in space.
  [[nodiscard]] std::pair<geom::Point, Vector3> place(double t) const {
    const surf::Curve::Jet chart = edge_.curve.jet(parameter(t));
    const surf::Jet jet = surface_->jet({chart.at.x, chart.at.y});
    return {{chart.at.x, chart.at.y}, chart.first.x * jet.u + chart.first.y * jet.v};
  }
  [[nodiscard]] Point3 start() const { return at_.front(); }
  [[nodiscard]] Point3 end() const { return at_.back(); }

  /// Where it is nearest to a point.
  struct Nearest {
    double t = 0.0, distance = 0.0;
  };
  [[nodiscard]] Nearest nearest(Point3 p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < at_.size(); ++i) {
      if (distance(at_[i], p) < distance(at_[best], p)) best = i;
    }
    double low = static_cast<double>(best > 0 ? best - 1 : 0) / steps;
    double high = static_cast<double>(std::min<std::size_t>(best + 1, steps)) / steps;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (falls(middle, p) ? low : high) = middle;
    }
    Nearest found{0.5 * (low + high), distance(at(0.5 * (low + high)), p)};
    for (const double end : {0.0, 1.0}) {
      if (distance(at(end), p) < found.distance) found = {end, distance(at(end), p)};
    }
    return found;
  }

  /// The part between two parameters.
  [[nodiscard]] ChartEdge part(double from, double to) const {
    ChartEdge piece = edge_;
    piece.from = parameter(from), piece.to = parameter(to);
    return piece;
  }

 private:
  [[nodiscard]] double parameter(double t) const {
    return t == 1.0 ? edge_.to : edge_.from + t * (edge_.to - edge_.from);
  }
  /// Whether the distance to p still falls with t.
  [[nodiscard]] bool falls(double t, Point3 p) const {
    const auto [uv, way] = place(t);
    return dot(surface_->at(uv) - p, way) * (edge_.to - edge_.from) < 0.0;
  }

  std::size_t face_;
  const surf::Surface* surface_;
  ChartEdge edge_;
  bool inside_ = false;
  std::vector<Point3> at_;
  Box3 box_;
  double length_ = 0.0;
};

class Sharing {
 public:
  Sharing(std::vector<TrimmedSurface>& faces, const CommonBorderOptions& options) : faces_(faces) {
    collect();
    Box3 all;
    for (const Border& border : borders_) all.add(border.box().low), all.add(border.box().high);
    diagonal_ = borders_.empty() ? 0.0 : all.diagonal();
    tolerance_ = options.tolerance * diagonal_;
  }

  void run(std::vector<Finding>& findings) {
    if (borders_.size() < 2) return;
    cut();
    join(findings);
    tell_unjoined(findings);
  }

 private:
  void collect() {
    borders_.clear();
    places_.clear();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t l = 0; l < faces_[f].loops.size(); ++l) {
        for (std::size_t e = 0; e < faces_[f].loops[l].edges.size(); ++e) {
          borders_.emplace_back(f, faces_[f].surface, faces_[f].loops[l].edges[e], false);
          places_.push_back({f, l, e});
        }
      }
      for (std::size_t l = 0; l < faces_[f].lines.size(); ++l) {
        if (faces_[f].lines[l].kind == surf::trim::ChartLine::Kind::Crack) continue;
        for (std::size_t e = 0; e < faces_[f].lines[l].edges.size(); ++e) {
          borders_.emplace_back(f, faces_[f].surface, faces_[f].lines[l].edges[e], true);
          places_.push_back({f, l, e});
        }
      }
    }
  }
  [[nodiscard]] std::vector<ChartEdge>& edges_of(std::size_t border) {
    const auto [face, chain, edge] = places_[border];
    return borders_[border].inside() ? faces_[face].lines[chain].edges : faces_[face].loops[chain].edges;
  }
  /// What of one face may be one curve: the sides of a seam. Lines inside are joined to other faces alone.
  [[nodiscard]] bool may_join(const Border& a, const Border& b) const {
    return a.face() != b.face() || (!a.inside() && !b.inside());
  }
  [[nodiscard]] bool a_point(const Border& border) const { return border.length() <= tolerance_; }

  /// Edges that end inside others with which they run are points of those.
  void cut() {
    std::vector<std::vector<double>> cuts(borders_.size());
    for (std::size_t i = 0; i < borders_.size(); ++i) {
      for (std::size_t j = 0; j < borders_.size(); ++j) {
        if (i == j || a_point(borders_[i]) || a_point(borders_[j]) || !may_join(borders_[i], borders_[j])) continue;
        if (!borders_[i].box().near(borders_[j].box(), tolerance_)) continue;
        for (const double end : {0.0, 1.0}) {
          const Point3 p = borders_[j].at(end);
          const Border::Nearest there = borders_[i].nearest(p);
          const Point3 inside = borders_[j].at(std::abs(end - 0.05));
          if (there.distance > tolerance_ || borders_[i].nearest(inside).distance > tolerance_) continue;
          if (distance(p, borders_[i].start()) <= 2.0 * tolerance_ ||
              distance(p, borders_[i].end()) <= 2.0 * tolerance_)
            continue;
          cuts[i].push_back(there.t);
        }
      }
    }
    for (std::size_t i = borders_.size(); i-- > 0;) {
      std::vector<double>& own = cuts[i];
      std::sort(own.begin(), own.end());
      const Border& border = borders_[i];
      own.erase(
          std::unique(own.begin(), own.end(),
                      [&](double s, double t) { return distance(border.at(s), border.at(t)) <= 2.0 * tolerance_; }),
          own.end());
      if (own.empty()) continue;
      std::vector<ChartEdge> pieces;
      double from = 0.0;
      for (const double t : own) pieces.push_back(border.part(from, t)), from = t;
      pieces.push_back(border.part(from, 1.0));
      auto& edges = edges_of(i);
      const auto at = edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(places_[i][2]));
      edges.insert(at, pieces.begin(), pieces.end());
    }
    collect();
  }

  /// The widest gap of two edges that run beside each other, in which direction.
  struct Beside {
    bool against = false;
    double gap = 0.0;
    Point3 place;
  };
  [[nodiscard]] Beside beside(const Border& a, const Border& b) const {
    Beside found;
    const double along = std::max(distance(a.start(), b.start()), distance(a.end(), b.end()));
    const double opposite = std::max(distance(a.start(), b.end()), distance(a.end(), b.start()));
    found.against = opposite < along;
    found.gap = std::min(along, opposite);
    found.place = a.start();
    if (found.gap > 100.0 * tolerance_) return found;
    // A closed edge has both its ends at one place: which way it runs shows inside.
    if (std::max(along, opposite) <= 100.0 * tolerance_) {
      const double early = b.nearest(a.at(0.25)).t, late = b.nearest(a.at(0.5)).t;
      found.against = late < early;
    }
    for (const double t : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) {
      const double gap = b.nearest(a.at(t)).distance;
      if (gap > found.gap) found.gap = gap, found.place = a.at(t);
    }
    return found;
  }

  void join(std::vector<Finding>& findings) {
    base::DisjointSets sets(borders_.size());
    std::vector<std::uint8_t> shared(borders_.size(), 0);
    double widest = 0.0;
    Point3 place{};  // the widest gap, or the middle of the first that are joined
    std::size_t joined = 0;
    std::vector<std::array<std::size_t, 2>> pairs;
    std::vector<std::uint8_t> against;
    for (std::size_t i = 0; i < borders_.size(); ++i) {
      for (std::size_t j = i + 1; j < borders_.size(); ++j) {
        if (a_point(borders_[i]) || a_point(borders_[j]) || !may_join(borders_[i], borders_[j])) continue;
        if (!borders_[i].box().near(borders_[j].box(), 100.0 * tolerance_)) continue;
        const Beside found = beside(borders_[i], borders_[j]);
        if (found.gap > 100.0 * tolerance_) continue;
        if (found.gap > tolerance_) {
          beside_.insert({i, borders_[j].face()});
          beside_.insert({j, borders_[i].face()});
          findings.push_back(
              {"borders_near",
               fmt::format("borders of '{}' and '{}' run beside each other, {:.3g} m apart: they are not "
                           "joined; make them one curve if they are meant so",
                           faces_[borders_[i].face()].name, faces_[borders_[j].face()].name, found.gap),
               base::Place{.x = found.place.x, .y = found.place.y, .z = found.place.z}});
          continue;
        }
        if (borders_[i].face() != borders_[j].face() && joined++ == 0 && widest <= 1e-9 * diagonal_)
          place = borders_[i].at(0.5);
        if (found.gap > widest) {
          widest = found.gap;
          if (widest > 1e-9 * diagonal_) place = found.place;
        }
        sets.join(i, j);
        shared[i] = shared[j] = 1;
        pairs.push_back({i, j});
        against.push_back(found.against ? 1 : 0);
      }
    }
    number(sets, shared, pairs, against, widest);
    if (joined == 0) return;
    Finding finding{"borders_joined", fmt::format("pairs of borders that are one curve: {}", joined),
                    base::Place{.x = place.x, .y = place.y, .z = place.z}};
    if (widest > 1e-9 * diagonal_)
      finding.message += fmt::format("; the widest gap between two of them is {:.3g} m", widest);
    findings.push_back(std::move(finding));
  }

  void number(base::DisjointSets& sets, const std::vector<std::uint8_t>& shared,
              const std::vector<std::array<std::size_t, 2>>& pairs, const std::vector<std::uint8_t>& against,
              double widest) {
    std::vector<std::int8_t> turned(borders_.size(), -1);
    shared_.assign(borders_.size(), 0);
    for (std::size_t i = 0; i < borders_.size(); ++i) {
      if (shared[i] == 0) continue;
      if (turned[i] < 0) turned[i] = 0;  // The first of its curve.
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs[k][0] == i && turned[pairs[k][1]] < 0)
          turned[pairs[k][1]] = static_cast<std::int8_t>(turned[i] ^ static_cast<std::int8_t>(against[k]));
      }
      ChartEdge& edge = edges_of(i)[places_[i][2]];
      edge.shared = static_cast<surf::trim::SharedCurveId>(sets.root(i));
      edge.against = turned[i] == 1;
      edge.tolerance = std::max({edge.tolerance, tolerance_, widest});
      shared_[i] = 1;
    }
  }

  /// Borders that lie on another face and are not joined to it, and those that end beside one.
  void tell_unjoined(std::vector<Finding>& findings) const {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const surf::Surface& surface = faces_[f].surface;
      const Box3 box = box_of(surface);
      const std::vector<surf::trim::Ring> rings = surf::trim::rings_of(faces_[f]);
      const double size = size_of(f);
      for (std::size_t i = 0; i < borders_.size(); ++i) {
        const Border& border = borders_[i];
        if (border.face() == f || border.inside() || shared_[i] != 0 || a_point(border)) continue;
        if (!border.box().near(box, 0.1 * surface.size())) continue;
        auto finding = unjoined(border, f, rings, std::min(size, size_of(border.face())));
        if (finding && !(finding->code == "border_near_surface" && beside_.contains({i, f})))
          findings.push_back(*std::move(finding));
      }
    }
  }
  [[nodiscard]] std::optional<Finding> unjoined(const Border& border, std::size_t f,
                                                const std::vector<surf::trim::Ring>& rings, double size) const {
    constexpr int places = 16;
    constexpr int run = places / 4;  // of places one after the other that are near
    const double near = ends_beside * size;
    std::optional<Point3> before;
    int beside = 0;
    std::optional<Finding> found;
    for (int k = 0; k < places; ++k) {
      const double t = (k + 0.5) / places;
      const Point3 p = border.at(t);
      const surf::Foot foot = surf::closest_of_all(faces_[f].surface, p);
      const double gap = geom::distance(faces_[f].surface.at(foot.uv), p);
      const bool close = gap <= std::max(tolerance_, near) && covers(rings, foot.uv);
      const bool on = close && gap <= tolerance_;
      if (on && before) {
        return Finding{"border_not_joined",
                       fmt::format("a border of '{0}' lies on '{1}' and is not joined to it: give '{1}' a line "
                                   "of role `internal` there, as by kind = \"surface\" and tool = \"{0}\"",
                                   faces_[border.face()].name, faces_[f].name),
                       base::Place{.x = p.x, .y = p.y, .z = p.z}};
      }
      before = on ? std::optional(p) : std::nullopt;
      const bool ends = close && !on && stands_over(faces_[f].surface, foot, p);
      beside = ends && leaves(border, t, faces_[f].surface, size) ? beside + 1 : 0;
      if (beside == run && !found) {
        found =
            Finding{"border_near_surface",
                    fmt::format("a border of '{0}' ends {2:.3g} m from '{1}' and does not meet it: if they are meant "
                                "to be joined, end it there and give '{1}' a line of role `internal`",
                                faces_[border.face()].name, faces_[f].name, gap),
                    base::Place{.x = p.x, .y = p.y, .z = p.z}};
      }
    }
    return found;
  }
  /// Whether a place is over its foot, and not beside the face.
  [[nodiscard]] static bool stands_over(const surf::Surface& surface, const surf::Foot& foot, Point3 p) {
    const auto normal = surf::normal(surface, foot.uv);
    return normal && std::abs(dot(p - surface.at(foot.uv), *normal)) >= 0.9 * geom::distance(surface.at(foot.uv), p);
  }
  /// Whether the face of a border goes away from a surface that the border is beside: a tenth of the size across it,
  /// it is four of the widest gaps farther off. Plates that lie along each other do not.
  [[nodiscard]] static bool leaves(const Border& border, double t, const surf::Surface& surface, double size) {
    const auto [at, way] = border.place(t);
    const geom::Point uv = at;
    const surf::Jet jet = border.surface().jet(uv);
    const auto normal = surf::normal(jet);
    if (!normal || geom::length(way) == 0.0) return false;
    const Vector3 across = (0.1 * size / geom::length(way)) * cross(*normal, way);
    const surf::Metric m = surf::metric(jet);
    const double u = dot(across, jet.u), v = dot(across, jet.v), square = m.e * m.g - m.f * m.f;
    const geom::Vector step{(m.g * u - m.f * v) / square, (m.e * v - m.f * u) / square};
    const geom::Box& chart = border.surface().chart();
    const double gap = surf::closest_of_all(surface, jet.at).distance;
    return std::ranges::any_of(std::array{step, -1.0 * step}, [&](geom::Vector by) {
      const geom::Point to{std::clamp(uv.x + by.x, chart.low.x, chart.high.x),
                           std::clamp(uv.y + by.y, chart.low.y, chart.high.y)};
      return surf::closest_of_all(surface, border.surface().at(to)).distance > gap + 4.0 * ends_beside * size;
    });
  }
  [[nodiscard]] double size_of(std::size_t face) const {
    Box3 box;
    for (const Border& border : borders_) {
      if (border.face() == face) box.add(border.box().low), box.add(border.box().high);
    }
    return box.low.x <= box.high.x ? box.diagonal() : box_of(faces_[face].surface).diagonal();
  }
  [[nodiscard]] static Box3 box_of(const surf::Surface& surface) {
    constexpr int places = 16;
    Box3 box;
    for (int i = 0; i <= places; ++i) {
      for (int j = 0; j <= places; ++j)
        box.add(
            surface.at({std::lerp(surface.chart().low.x, surface.chart().high.x, static_cast<double>(i) / places),
                        std::lerp(surface.chart().low.y, surface.chart().high.y, static_cast<double>(j) / places)}));
    }
    return box;
  }
  [[nodiscard]] static bool covers(const std::vector<surf::trim::Ring>& rings, geom::Point uv) {
    const std::vector<double> at = surf::trim::meets(rings, uv.y);
    return std::count_if(at.begin(), at.end(), [&](double u) { return u < uv.x; }) % 2 == 1;
  }

  std::vector<TrimmedSurface>& faces_;
  std::vector<Border> borders_;
  std::vector<std::array<std::size_t, 3>> places_;        ///< Face, loop or line, edge of each.
  std::vector<std::uint8_t> shared_;                      ///< One a border.
  std::set<std::pair<std::size_t, std::size_t>> beside_;  ///< Borders told to run beside one of a face, with the face.
  double tolerance_ = 0.0, diagonal_ = 0.0;
};

}  // namespace

void share_borders(std::vector<TrimmedSurface>& faces, std::vector<Finding>& findings,
                   const CommonBorderOptions& options) {
  Sharing(faces, options).run(findings);
}

base::Result<void> check_ways(const std::vector<TrimmedSurface>& faces) {
  struct Member {
    std::size_t face = 0;
    const ChartEdge* edge = nullptr;
    bool inside = false;
  };
  std::map<surf::trim::SharedCurveId, std::vector<Member>> curves;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto add = [&](const std::vector<ChartEdge>& edges, bool inside) {
      for (const ChartEdge& edge : edges) {
        if (edge.shared) curves[*edge.shared].push_back({f, &edge, inside});
      }
    };
    for (const auto& loop : faces[f].loops) add(loop.edges, false);
    for (const auto& line : faces[f].lines) add(line.edges, true);
  }
  for (const auto& [curve, members] : curves) {
    if (members.size() != 2 || members[0].inside || members[1].inside) continue;
    const TrimmedSurface &first = faces[members[0].face], &second = faces[members[1].face];
    if (&first == &second) continue;
    const bool one_way = members[0].edge->against == members[1].edge->against;
    if (one_way == (first.reversed != second.reversed)) continue;
    base::Place place = second.place;
    const Point3 p = first.surface.at(members[0].edge->at(std::midpoint(members[0].edge->from, members[0].edge->to)));
    place.x = p.x, place.y = p.y, place.z = p.z;
    return base::Error{
        base::ErrorCode::CannotMesh,
        fmt::format(
            "surfaces '{}' and '{}' meet at a border and look opposite ways, or lie on each other: give one of them "
            "facing = \"{}\"",
            first.name, second.name, second.reversed ? "along" : "against"),
        place};
  }
  return {};
}

}  // namespace quebra::surfaces
