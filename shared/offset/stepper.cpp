#include "shared/offset/stepper.h"

#include <algorithm>
#include <set>

#include "shared/offset/clearance.h"

namespace dobra::offset {

using base::Result;
using geom::Point;
using topo::HalfEdgeId;
using topo::Subdivision;
using topo::VertexId;

Result<Stepper> Stepper::start(const geom::Polyline& curve, double distance, const OffsetOptions& options) {
  if (!(distance > 0.0) || !std::isfinite(distance)) {
    return base::Error{base::ErrorCode::InvalidOption, "the offset distance must be above 0"};
  }
  Stepper stepper;
  DOBRA_TRY(stepper.base_, prepare(curve, options.side));
  stepper.distance_ = distance;
  stepper.chain_ = raw_chain(stepper.base_, distance, options, RawArcs::Chords);
  stepper.chain_.segment.resize(stepper.chain_.points.size() - (stepper.base_.closed ? 0 : 1));
  if (stepper.base_.closed) {
    geom::Polyline mirrored{{}, true};
    mirrored.points = stepper.base_.points;
    stepper.orientation_ = geom::signed_area(mirrored);
    // Start on a raw edge whose middle is valid: there no region can hide the start.
    const Clearance clearance(stepper.base_, options);
    const std::size_t count = stepper.chain_.points.size();
    const auto valid = [&](std::size_t i) {
      const Vec mid = Real(0.5) * (stepper.chain_.points[i] + stepper.chain_.points[(i + 1) % count]);
      return !clearance.nearer_than(mid, static_cast<Real>(distance) * (1 - 1e-9L));
    };
    std::size_t first = 0;
    while (first < count && !valid(first)) ++first;
    if (first == count) {
      stepper.chain_.segment.clear();  // nothing of it is far enough: the curve has collapsed
      return stepper;
    }
    // Cut that edge at its middle, so that the curve starts and ends there.
    const Vec mid = Real(0.5) * (stepper.chain_.points[first] + stepper.chain_.points[(first + 1) % count]);
    auto& points = stepper.chain_.points;
    auto& segments = stepper.chain_.segment;
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first + 1) % static_cast<std::ptrdiff_t>(count), points.end());
    std::rotate(segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(first), segments.end());
    points.insert(points.begin(), mid);
    points.push_back(mid);
    segments.push_back(segments.front());
  }
  DOBRA_TRY(stepper.start_, topo::insert(stepper.subdivision_, stepper.raw_point(0)));
  return stepper;
}

Point Stepper::raw_point(std::size_t i) const {
  const Point p = base_.user(chain_.points[i]);
  return {p.x, base_.mirrored ? -p.y : p.y};
}

/// Number of links before v on the curve so far, or -1. A vertex inside a link is put on the curve's record by the caller.
std::ptrdiff_t Stepper::position(VertexId v) const {
  if (v == start_) return 0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (links_[i].to == v) return static_cast<std::ptrdiff_t>(i + 1);
  }
  // Inside a link: one of the edges at v is a part of that link's raw edge.
  std::set<std::uint32_t> raws;
  for (const HalfEdgeId h : subdivision_.round(v)) {
    const std::any& mark = subdivision_.attribute(Subdivision::edge(h));
    if (mark.has_value()) raws.insert(std::any_cast<std::uint32_t>(mark));
  }
  VertexId from = start_;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (raws.contains(links_[i].raw)) {
      for (const HalfEdgeId h : way(from, links_[i].to)) {
        if (subdivision_.target(h) == v) return static_cast<std::ptrdiff_t>(i);
      }
    }
    from = links_[i].to;
  }
  return -1;
}

/// The edges of a link, which later insertions may have split: at each vertex the one straight on.
std::vector<HalfEdgeId> Stepper::way(VertexId from, VertexId to) const {
  std::vector<HalfEdgeId> path;
  const Point end = subdivision_.point(to);
  VertexId at = from;
  while (at != to && path.size() <= subdivision_.edge_count()) {
    const Point p = subdivision_.point(at);
    HalfEdgeId best;
    double straightest = 0.0;
    for (const HalfEdgeId h : subdivision_.round(at)) {
      const geom::Vector along = subdivision_.point(subdivision_.target(h)) - p;
      const double cosine = geom::dot(along, end - p) / (geom::length(along) * geom::distance(end, p));
      if (cosine > straightest) {
        straightest = cosine;
        best = h;
      }
    }
    if (!best.valid()) return {};
    path.push_back(best);
    at = subdivision_.target(best);
  }
  return path;
}

/// The curve has come back to v, `at` links from its start: all that lies after is a region's border.
void Stepper::close_loop(std::ptrdiff_t at, VertexId v, Step& step) {
  const auto keep = static_cast<std::size_t>(at);
  const VertexId before = keep == 0 ? start_ : links_[keep - 1].to;
  std::vector<Link> loop;
  std::uint32_t cut_raw = 0;
  bool inside_link = false;
  if (before != v) {  // v lies inside link `keep`: its first part stays
    cut_raw = links_[keep].raw;
    inside_link = true;
  }
  for (std::size_t i = keep; i < links_.size(); ++i) loop.push_back(links_[i]);
  geom::Polyline outline{{subdivision_.point(v)}, true};
  for (const Link& link : loop) outline.points.push_back(subdivision_.point(link.to));
  if (outline.points.back() == outline.points.front()) outline.points.pop_back();
  // On a closed contour a region of the base's own orientation is a valid component; all others are spurious.
  const double area = geom::signed_area(outline);
  const double noise = 1e-12 * distance_ * distance_;
  if (orientation_ != 0.0 && area * orientation_ > 0.0 && std::abs(area) > noise && outline.points.size() >= 3) {
    finished_.push_back(piece(v, loop, true));
  }
  VertexId from = v;
  std::set<topo::EdgeId> edges;
  for (const Link& link : loop) {
    for (const HalfEdgeId h : way(from, link.to)) edges.insert(Subdivision::edge(h));
    from = link.to;
  }
  links_.resize(keep);
  if (inside_link) links_.push_back({v, cut_raw});
  for (const topo::EdgeId e : edges) {
    step.deleted.push_back(e);
    step.deleted_edges.push_back(subdivision_.segment(e));
    const Result<void> removed = topo::remove(subdivision_, e, topo::Bare::Keep);
    DOBRA_CHECK(removed.ok());
  }
}

Result<Stepper::Step> Stepper::step() {
  DOBRA_CHECK(!done());
  const auto raw = static_cast<std::uint32_t>(next_);
  Step step;
  step.base_segment = base_.source[chain_.segment[next_]];
  const geom::Segment edge{raw_point(next_), raw_point(next_ + 1)};
  step.edge = {base_.user(chain_.points[next_]), base_.user(chain_.points[next_ + 1])};
  ++next_;
  if (edge.from == edge.to) return step;
  DOBRA_TRY(const topo::Inserted inserted, topo::insert(subdivision_, edge));
  step.inserted = inserted.edges;
  step.formed = inserted.faces;
  for (const topo::EdgeId e : inserted.edges) {
    if (!subdivision_.attribute(e).has_value()) subdivision_.attribute(e) = raw;
  }
  std::vector<VertexId> visits;
  for (const HalfEdgeId h : inserted.path) visits.push_back(subdivision_.target(h));
  for (std::size_t k = 0; k < visits.size(); ++k) {
    const VertexId v = visits[k];
    const std::ptrdiff_t at = position(v);
    links_.push_back({v, raw});
    if (at < 0) continue;
    if (base_.closed && done() && k + 1 == visits.size() && v == start_) {
      closed_up_ = true;
      continue;
    }
    close_loop(at, v, step);
  }
  return step;
}

OffsetPiece Stepper::piece(VertexId start, const std::vector<Link>& links, bool closed) const {
  OffsetPiece made;
  made.side = base_.mirrored ? Side::LeftOfTravel : Side::RightOfTravel;
  made.closed = closed;
  std::vector<Point> points{subdivision_.point(start)};
  std::vector<OffsetEdge> edges;
  for (const Link& link : links) {
    const std::uint32_t source = base_.source[chain_.segment[link.raw]];
    if (!edges.empty() && edges.back() == OffsetEdge::line(source) && points.size() > 1 && &link != links.data() &&
        (&link - 1)->raw == link.raw) {
      points.back() = subdivision_.point(link.to);  // the raw edge goes straight on
      continue;
    }
    points.push_back(subdivision_.point(link.to));
    edges.push_back(OffsetEdge::line(source));
  }
  if (closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  for (Point& p : points) p.y = base_.mirrored ? -p.y : p.y;
  made.points = std::move(points);
  made.edges = std::move(edges);
  return made;
}

OffsetCurve Stepper::result() const {
  OffsetCurve curve;
  curve.distance = distance_;
  curve.pieces = finished_;
  if (!links_.empty()) curve.pieces.insert(curve.pieces.begin(), piece(start_, links_, closed_up_));
  return curve;
}

Result<OffsetCurve> run_stepper(const geom::Polyline& curve, double distance, const OffsetOptions& options) {
  DOBRA_TRY(Stepper stepper, Stepper::start(curve, distance, options));
  while (!stepper.done()) DOBRA_TRY_VOID(stepper.step());
  return stepper.result();
}

}  // namespace dobra::offset
