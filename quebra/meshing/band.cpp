#include "quebra/meshing/band.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

// 1. The tubes round the sources. 2. Crossings of curves of different bands, as nodes of both. 3. What of each curve is
// kept. 4. Nodes at the wanted spacing.

namespace quebra::meshing {
namespace {

using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;
using dobra::geom::Vector;

/// Vertices of an offset curve that turn by less are smooth: nodes need not stand there.
constexpr double corner_cosine = 0.94;  // about 20 degrees
/// Depth in a tube, as a fraction of its radius, that is put down to the chords that round ends are drawn with.
constexpr double chord_depth = 0.02;
/// Curves of two bands nearer than this fraction of their spacing leave no room for good triangles between them,
constexpr double too_near = 0.3;
/// unless they part from a common node so fast that this many spacings on they are farther.
constexpr double soon_apart = 1.2;
/// To a curve of the domain it may come nearer, by this factor.
constexpr double wall_share = 0.75;
/// A piece shorter than this fraction of the spacing is left out.
constexpr double too_short = 0.5;
/// A band this much finer than another stays whole.
constexpr double much_finer = 2.0;
/// Points of crossings nearer than this fraction of the spacing are one.
constexpr double same_point = 1e-6;

// --- 1 tubes
// ----------------------------------------------------------------------------------------------------------

class Source {
 public:
  explicit Source(const Band& band) : band_(band) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < band.source.segment_count(); ++i) boxes.push_back(band.source.segment(i).box());
    for (const Box& box : boxes) box_.add(box);
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  [[nodiscard]] const std::string& name() const { return band_.curves.front(); }
  [[nodiscard]] const Box& box() const { return box_; }
  /// How far p is outside the tube of this radius; infinite if that is above `farthest`, or where the tube does not
  /// lie.
  [[nodiscard]] double outside(Point p, double radius, double farthest) const {
    constexpr double nothing = std::numeric_limits<double>::infinity();
    const Polyline& line = band_.source;
    const auto nearest = index_.nearest(
        p, [&](std::size_t i) { return distance(line.segment(i), p); }, radius + farthest);
    if (!nearest) return nothing;
    const Segment segment = line.segment(nearest->item);
    if (band_.tube == Tube::Right && cross(segment.vector(), p - segment.from) > 0.0) return nothing;
    if (band_.tube != Tube::Round && !line.closed) {
      const double slack = 1e-9 * radius * segment.length();
      if (nearest->item == 0 && dot(p - segment.from, segment.vector()) < -slack) return nothing;
      if (nearest->item + 1 == line.segment_count() && dot(p - segment.to, segment.vector()) > slack) return nothing;
    }
    return nearest->distance - radius;
  }

 private:
  const Band& band_;
  Box box_;
  dobra::geom::SpatialIndex index_;
};

/// Of two bands: which curve of `other` a curve of `band` must stay outside of, if any.
std::optional<std::size_t> border(const Band& band, std::size_t rank, const Band& other) {
  if (band.curves == other.curves) return std::nullopt;
  if (much_finer * band.distances[0] <= other.distances[0]) return std::nullopt;
  if (much_finer * other.distances[0] <= band.distances[0]) return other.distances.size() - 1;
  return std::min(rank, other.distances.size() - 1);
}

// --- 2 crossings
// ------------------------------------------------------------------------------------------------------

struct Vertex {
  Point at;
  bool crossing = false;
  bool soft = false;  ///< Only looked at.
};

struct Line {
  std::size_t band = 0;
  const BandCurve* curve = nullptr;
  std::vector<Vertex> vertices;  ///< Of a closed one the first is not repeated.
};

/// Points that fall together are one.
class CommonPoints {
 public:
  explicit CommonPoints(double tolerance) : tolerance_(tolerance) {}
  Point operator()(Point p) {
    const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / (4.0 * tolerance_))); };
    const std::int64_t x = cell(p.x);
    const std::int64_t y = cell(p.y);
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      for (std::int64_t j = y - 1; j <= y + 1; ++j) {
        const auto found = points_.find({i, j});
        if (found == points_.end()) continue;
        for (const Point known : found->second) {
          if (distance(known, p) <= tolerance_) return known;
        }
      }
    }
    points_[{x, y}].push_back(p);
    return p;
  }

 private:
  double tolerance_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Point>> points_;
};

/// The curve with its crossings as vertices, and soft ones between so that none are farther apart than `step`.
std::vector<Vertex> with_crossings(const Polyline& line, std::vector<std::vector<Point>> crossings, double step,
                                   double tolerance) {
  std::vector<Vertex> vertices;
  const auto add = [&](const Vertex& vertex) {
    if (vertices.empty() || distance(vertices.back().at, vertex.at) > tolerance) {
      vertices.push_back(vertex);
    } else if (vertex.crossing && (vertices.size() > 1 || line.closed)) {
      vertices.back() = vertex;
    }
  };
  const auto add_from = [&](Point from, Point to) {
    const auto pieces = static_cast<int>(std::ceil(distance(from, to) / step));
    for (int i = 1; i < pieces; ++i) add({interpolate(from, to, static_cast<double>(i) / pieces), false, true});
  };
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const Segment segment = line.segment(i);
    sort_along(segment, crossings[i]);
    add({segment.from});
    Point before = segment.from;
    for (const Point p : crossings[i]) {
      add_from(before, p);
      add({p, true});
      before = p;
    }
    add_from(before, segment.to);
  }
  const bool repeats =
      line.closed && vertices.size() > 1 && distance(vertices.back().at, vertices.front().at) <= tolerance;
  if (repeats && vertices.back().crossing) vertices.front() = vertices.back();
  if (repeats) vertices.pop_back();
  if (line.closed) return vertices;
  // The end is the curve's own, be a crossing never so near.
  while (vertices.size() > 1 && distance(vertices.back().at, line.points.back()) <= tolerance) vertices.pop_back();
  vertices.push_back({line.points.back()});
  return vertices;
}

std::vector<Line> lines_of(std::span<const std::shared_ptr<const Band>> bands) {
  struct Chord {
    std::size_t line = 0;
    std::size_t number = 0;
  };
  std::vector<Line> lines;
  std::vector<Chord> chords;
  std::vector<Box> boxes;
  double finest = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bands.size(); ++b) {
    for (const BandCurve& curve : bands[b]->lines) {
      for (std::size_t i = 0; i < curve.line.segment_count(); ++i) {
        chords.push_back({lines.size(), i});
        boxes.push_back(curve.line.segment(i).box());
      }
      lines.push_back({b, &curve, {}});
      finest = std::min(finest, bands[b]->spacings[curve.rank]);
    }
  }
  std::vector<std::vector<std::vector<Point>>> crossings;
  for (const Line& line : lines) crossings.emplace_back(line.curve->line.segment_count());
  const double tolerance = same_point * finest;
  CommonPoints common(tolerance);
  if (bands.size() > 1) {
    for (const auto& [i, j] : dobra::geom::SpatialIndex(boxes).overlapping_pairs()) {
      const Chord& a = chords[i];
      const Chord& b = chords[j];
      if (lines[a.line].band == lines[b.line].band) continue;
      const auto meeting =
          intersect(lines[a.line].curve->line.segment(a.number), lines[b.line].curve->line.segment(b.number));
      const auto add = [&](Point p) {
        p = common(p);
        crossings[a.line][a.number].push_back(p);
        crossings[b.line][b.number].push_back(p);
      };
      if (meeting.kind != dobra::geom::IntersectionKind::None) add(meeting.start.point);
      if (meeting.kind == dobra::geom::IntersectionKind::Overlap) add(meeting.end.point);
    }
  }
  constexpr double step = 0.125;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double spacing = bands[lines[k].band]->spacings[lines[k].curve->rank];
    lines[k].vertices = with_crossings(lines[k].curve->line, std::move(crossings[k]), step * spacing, tolerance);
  }
  return lines;
}

// --- 3 what is kept
// ---------------------------------------------------------------------------------------------------

/// Judges the edges of one curve against one other band.
class Judge {
 public:
  Judge(const std::vector<Point>& points, const std::vector<bool>& crossing, bool closed, double spacing)
      : points_(points), crossing_(crossing), spacing_(spacing), runs_(runs(closed)) {}

  /// Takes the edges away (edge i leads from vertex i) that lie in the tube, or too near to its border if this band is
  /// the one that yields.
  void drop(const Source& other, double radius, double other_spacing, bool yields, std::vector<bool>& kept) const {
    const double near = too_near * std::min(spacing_, other_spacing);
    const double depth = chord_depth * radius;
    std::vector<double> outside;
    outside.reserve(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      outside.push_back(other.outside(midpoint(points_[i], points_[(i + 1) % points_.size()]), radius, near));
    for (const auto& [from, to] : runs_) {
      const auto all = [&, first = from, last = to](auto&& judgement) {
        for (std::size_t i = first; i < last; ++i) {
          if (!judgement(outside[i % kept.size()])) return false;
        }
        return true;
      };
      // The two curves run together: one of them is enough.
      const bool together = all([&](double g) { return std::abs(g) <= depth; });
      const bool enters = !all([&](double g) { return g >= -depth; });
      if (together && !yields) continue;
      for (std::size_t i = from; i < to; ++i) {
        // A run that enters the tube by its border is outside only where it is clearly so.
        const double g = outside[i % kept.size()];
        if (together || g < (enters ? depth : -depth)) kept[i % kept.size()] = false;
      }
      if (yields && !together) drop_near(outside, near, from, to, kept);
    }
  }

 private:
  /// Edges from one crossing or end to the next; of a closed curve the last one may pass the start.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> runs(bool closed) const {
    const std::size_t n = points_.size();
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < n; ++i) {
      if (crossing_[i] || (!closed && (i == 0 || i + 1 == n))) cuts.push_back(i);
    }
    if (cuts.empty()) return {{0, n}};
    if (closed) cuts.push_back(cuts.front() + n);
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) result.emplace_back(cuts[k], cuts[k + 1]);
    return result;
  }

  void drop_near(const std::vector<double>& outside, double near, std::size_t from, std::size_t to,
                 std::vector<bool>& kept) const {
    const std::size_t n = kept.size();
    const std::size_t count = points_.size();
    for (std::size_t i = from; i < to;) {
      double length = 0.0;
      std::size_t end = i;
      for (; end < to && outside[end % n] < near; ++end)
        length += distance(points_[end % count], points_[(end + 1) % count]);
      const bool at_crossing = (i == from && crossing_[from % count]) || (end == to && crossing_[to % count]);
      if (!at_crossing || length > soon_apart * spacing_) {
        for (std::size_t k = i; k < end; ++k) kept[k % n] = false;
      }
      i = std::max(end, i + 1);
    }
  }

  const std::vector<Point>& points_;
  const std::vector<bool>& crossing_;
  double spacing_;
  std::vector<std::pair<std::size_t, std::size_t>> runs_;
};

/// A stretch of a curve that is kept.
struct Stretch {
  std::vector<Vertex> vertices;
  bool closed = false;
  bool from_start = false, to_end = false;  ///< Of an open curve.
};

/// The curves of the domain as sources of bands of no width.
std::vector<Band> walls_of(const domain::Domain& domain) {
  std::vector<Band> walls;
  for (const sketch::Curve& curve : domain.curves)
    walls.push_back({.curves = {curve.name},
                     .source = trace(curve).line,
                     .tube = Tube::Round,
                     .distances = {},
                     .spacings = {},
                     .lines = {}});
  return walls;
}

std::vector<bool> kept_edges(const Line& line, std::span<const std::shared_ptr<const Band>> bands,
                             const std::vector<Source>& sources, const std::vector<Source>& walls) {
  const Band& band = *bands[line.band];
  const bool closed = line.curve->line.closed;
  std::vector<Point> points;
  std::vector<bool> crossing;
  for (const Vertex& vertex : line.vertices) {
    points.push_back(vertex.at);
    crossing.push_back(vertex.crossing);
  }
  std::vector<bool> kept(closed ? points.size() : points.size() - 1, true);
  const Judge judge(points, crossing, closed, band.spacings[line.curve->rank]);
  for (std::size_t b = 0; b < bands.size(); ++b) {
    if (b == line.band) continue;
    const auto rank = border(band, line.curve->rank, *bands[b]);
    if (!rank) continue;
    const bool yields = b < line.band || much_finer * bands[b]->distances[0] <= band.distances[0];
    judge.drop(sources[b], bands[b]->distances[*rank], bands[b]->spacings[*rank], yields, kept);
  }
  // A curve that runs along one of the domain's, too near to it, yields too; one that ends there comes to it at an
  // angle.
  if (line.curve->start) crossing.front() = true;
  if (line.curve->end) crossing.back() = true;
  const double spacing = band.spacings[line.curve->rank];
  const Box reach = line.curve->line.box().grown(too_near * spacing);
  for (const Source& wall : walls) {
    if (!reach.overlaps(wall.box())) continue;
    const bool own = std::find(band.curves.begin(), band.curves.end(), wall.name()) != band.curves.end();
    if (!own) judge.drop(wall, 0.0, wall_share * spacing, true, kept);
  }
  return kept;
}

std::vector<Stretch> stretches_of(const Line& line, const std::vector<bool>& kept, double least) {
  const std::size_t n = line.vertices.size();
  const bool closed = line.curve->line.closed;
  if (closed && std::find(kept.begin(), kept.end(), false) == kept.end()) return {{line.vertices, true}};
  std::size_t start = 0;
  while (closed && kept[start]) ++start;
  std::vector<Stretch> result;
  Stretch open;
  const auto finish = [&] {
    double length = 0.0;
    for (std::size_t i = 1; i < open.vertices.size(); ++i)
      length += distance(open.vertices[i - 1].at, open.vertices[i].at);
    if (length >= least) result.push_back(std::move(open));
    open = {};
  };
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::size_t i = (start + k) % kept.size();
    if (!kept[i]) {
      finish();
      continue;
    }
    if (open.vertices.empty()) {
      open.vertices.push_back(line.vertices[i]);
      open.from_start = !closed && i == 0;
    }
    open.vertices.push_back(line.vertices[(i + 1) % n]);
    open.to_end = !closed && i + 1 == kept.size();
  }
  finish();
  return result;
}

/// What is left of all lines. A crossing that only one line still passes is a vertex like others.
std::vector<std::vector<Stretch>> stretches_of(const domain::Domain& domain, const std::vector<Line>& lines,
                                               std::span<const std::shared_ptr<const Band>> bands) {
  std::vector<Source> sources;
  for (const auto& band : bands) sources.emplace_back(*band);
  const std::vector<Band> walls = walls_of(domain);
  std::vector<Source> wall_sources;
  for (const Band& wall : walls) wall_sources.emplace_back(wall);
  std::vector<std::vector<Stretch>> result;
  std::map<Point, std::vector<std::size_t>> lines_at;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::vector<bool> kept = kept_edges(lines[k], bands, sources, wall_sources);
    const bool whole = std::find(kept.begin(), kept.end(), false) == kept.end();
    const double least = whole ? 0.0 : too_short * bands[lines[k].band]->spacings[lines[k].curve->rank];
    result.push_back(stretches_of(lines[k], kept, least));
    for (const Stretch& stretch : result.back()) {
      for (const Vertex& vertex : stretch.vertices) {
        if (!vertex.crossing) continue;
        std::vector<std::size_t>& here = lines_at[vertex.at];
        if (here.empty() || here.back() != k) here.push_back(k);
      }
    }
  }
  for (auto& stretches : result) {
    for (Stretch& stretch : stretches) {
      for (Vertex& vertex : stretch.vertices) {
        if (!vertex.crossing || lines_at.at(vertex.at).size() > 1) continue;
        vertex.crossing = false;
        vertex.soft = true;
      }
    }
  }
  return result;
}

// --- 4 nodes
// ----------------------------------------------------------------------------------------------------------

/// The same line with vertices only at its ends, its corners, and evenly between them about `spacing` apart.
Polyline respaced(const Polyline& line, double spacing) {
  const std::size_t n = line.points.size();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_end = !line.closed && (i == 0 || i + 1 == n);
    if (!is_end) {
      const Vector in = normalised(line.points[i] - line.points[(i + n - 1) % n]);
      const Vector out = normalised(line.points[(i + 1) % n] - line.points[i]);
      if (dot(in, out) > corner_cosine) continue;
    }
    kept.push_back(i);
  }
  if (kept.empty()) kept.push_back(0);
  const std::vector<double> arc = arc_lengths(line);
  const std::size_t runs = line.closed ? kept.size() : kept.size() - 1;
  const bool one_round = runs == 1 && (line.closed || line.points.front() == line.points.back());
  Polyline result{{}, line.closed};
  for (std::size_t run = 0; run < runs; ++run) {
    const double from = arc[kept[run]];
    const double to = run + 1 < kept.size() ? arc[kept[run + 1]] : arc.back() + arc[kept.front()];
    const int pieces = std::max(one_round ? 3 : 1, static_cast<int>(std::ceil((to - from) / spacing - 0.25)));
    for (int i = 0; i < pieces; ++i) {
      const double s = from + (to - from) * i / pieces;
      result.points.push_back(i == 0 ? line.points[kept[run]]
                                     : point_at(line, arc, s > arc.back() ? s - arc.back() : s));
    }
  }
  if (!line.closed) result.points.push_back(line.points.back());
  return result;
}

/// Crossings stay; between them nodes at the spacing, or the curve's own.
Polyline with_nodes(Stretch stretch, Spacing kind, double spacing) {
  std::vector<Vertex>& vertices = stretch.vertices;
  Polyline result{{}, stretch.closed};
  const auto is_crossing = [](const Vertex& vertex) { return vertex.crossing; };
  const auto first = std::find_if(vertices.begin(), vertices.end(), is_crossing);
  if (kind == Spacing::Base || (stretch.closed && first == vertices.end())) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const bool is_end = !stretch.closed && (i == 0 || i + 1 == vertices.size());
      if (!vertices[i].soft || is_end) result.points.push_back(vertices[i].at);
    }
    return kind == Spacing::Base ? result : respaced(result, spacing);
  }
  if (stretch.closed) {
    std::rotate(vertices.begin(), first, vertices.end());
    vertices.push_back(vertices.front());
  }
  Polyline run;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    run.points.push_back(vertices[i].at);
    if (i == 0 || !(vertices[i].crossing || i + 1 == vertices.size())) continue;
    const Polyline nodes = respaced(run, spacing);
    result.points.insert(result.points.end(), nodes.points.begin(), nodes.points.end() - 1);
    run.points = {vertices[i].at};
  }
  if (!stretch.closed) result.points.push_back(vertices.back().at);
  return result;
}

/// The node of the boundary where a constraint ends: the corner, where that is near.
Point settle(const domain::Domain& domain, model::Constraint::Foot& foot, double spacing) {
  const sketch::Curve& curve = domain.curves[foot.curve];
  for (const double corner : corners(curve)) {
    if (std::abs(corner - foot.s) < 0.3 * spacing) foot.s = corner;
  }
  return point(curve, foot.s);
}

model::Constraint constraint_of(const domain::Domain& domain, const Band& band, const BandCurve& curve,
                                Stretch stretch) {
  model::Constraint result;
  result.distance = band.distances[curve.rank];
  result.spacing = band.spacings[curve.rank];
  const std::optional<model::Constraint::Foot> start = stretch.from_start ? curve.start : std::nullopt;
  const std::optional<model::Constraint::Foot> end = stretch.to_end ? curve.end : std::nullopt;
  result.line = with_nodes(std::move(stretch), band.kind, result.spacing);
  if (start) {
    result.feet.push_back(*start);
    result.line.points.front() = settle(domain, result.feet.back(), result.spacing);
  }
  if (end) {
    result.feet.push_back(*end);
    result.line.points.back() = settle(domain, result.feet.back(), result.spacing);
  }
  return result;
}

}  // namespace

std::vector<model::Constraint> constraints_of(const domain::Domain& domain,
                                              std::span<const std::shared_ptr<const Band>> bands) {
  std::vector<model::Constraint> constraints;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> pieces;
  const std::vector<Line> lines = lines_of(bands);
  auto stretches = stretches_of(domain, lines, bands);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Band& band = *bands[lines[k].band];
    const std::size_t rank = lines[k].curve->rank;
    for (Stretch& stretch : stretches[k]) {
      const std::size_t piece = ++pieces[{lines[k].band, rank}];
      constraints.push_back(constraint_of(domain, band, *lines[k].curve, std::move(stretch)));
      constraints.back().name =
          fmt::format("{}_{}{}", band.curves.front(), rank + 1, piece == 1 ? "" : fmt::format("_{}", piece));
    }
  }
  return constraints;
}

}  // namespace quebra::meshing
