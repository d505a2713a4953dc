#include "shared/offset/stepper/stepper.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "shared/base/check.h"
#include "shared/geom/intersect.h"

namespace dobra::offset::stepper {

using base::Result;
using geom::Point;
using topo::EdgeId;
using topo::HalfEdgeId;
using topo::Subdivision;
using topo::VertexId;

namespace {

/// The raw chain of a contour. Where a segment at an inner corner is too short for its parallel to reach the bisector,
/// cutting there would take away what belongs to the result, so both parallels go on to the corner's normals and are
/// joined by a chord, all nearer than D.
RawChain whole_chain(const BaseCurve& base, double distance, const OffsetOptions& options) {
  const RawChain cut = raw_chain(base, distance, options, RawArcs::Chords);
  RawChain chain;
  const auto add = [&](Vec p, std::size_t segment) {
    chain.points.push_back(p);
    chain.segment.push_back(static_cast<std::uint32_t>(segment));
  };
  const std::size_t count = cut.points.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t segment = cut.segment[k];
    const std::uint32_t before = cut.segment[k == 0 ? count - 1 : k - 1];
    const Real reach = Real(distance) * base.half_tan_as<Real>(segment);
    const bool cut_there = segment != before && base.turn[segment] == Turn::Inner;
    if (!cut_there || reach <= std::min(base.span(before), base.span(segment))) {
      add(cut.points[k], segment);
      continue;
    }
    add(base.point(segment) + Real(distance) * base.normal(before), before);
    add(base.point(segment) + Real(distance) * base.normal(segment), segment);
  }
  return chain;
}

}  // namespace

Result<Stepper> Stepper::start(const geom::Polyline& curve, double distance, const OffsetOptions& options) {
  if (!(distance > 0.0) || !std::isfinite(distance)) {
    return base::Error{base::ErrorCode::InvalidOption, "the offset distance must be above 0"};
  }
  Stepper stepper;
  DOBRA_TRY(stepper.base_, prepare(curve, options.side));
  stepper.distance_ = distance;
  stepper.chain_ = stepper.base_.closed ? whole_chain(stepper.base_, distance, options)
                                        : raw_chain(stepper.base_, distance, options, RawArcs::Chords);
  stepper.chain_.segment.resize(stepper.chain_.points.size() - (stepper.base_.closed ? 0 : 1));
  if (stepper.base_.closed) stepper.judge_ = StepperJudge(stepper.base_, distance, options);
  DOBRA_TRY(stepper.start_, topo::insert(stepper.subdivision_, stepper.raw_point(0)));
  stepper.end_ = stepper.start_;
  return stepper;
}

Stepper::Mark Stepper::mark(EdgeId e) const {
  const auto* const held = std::any_cast<Mark>(&subdivision_.attribute(e));
  return held == nullptr ? Mark{} : *held;
}

bool Stepper::on_trail(VertexId v) const {
  if (v == start_) return true;
  const HalfEdgeId first = subdivision_.leaving(v);
  if (!first.valid()) return false;
  HalfEdgeId h = first;
  do {
    if (mark(Subdivision::edge(h)).trail != none) return true;
    h = subdivision_.turned(h);
  } while (h != first);
  return false;
}

/// What is this near is taken to touch, as the subdivision itself draws it together.
double Stepper::rounding(Point p) const {
  const double margin = subdivision_.margin(p);
  return std::isfinite(margin) ? 0x1p-8 * margin : 0.0;
}

/// The vertex of a raw point: one of the curve so far, if it is there but for rounding. Edges of the curve that pass it
/// by no more are led through it, so that the region that closes there is seen now, and not noticed by nobody when what
/// comes later is rounded to the same place.
Result<VertexId> Stepper::arrive(Point p) {
  const double near = rounding(p);
  std::vector<EdgeId> passing;
  VertexId there;
  subdivision_.edge_tree().visit({p, p}, near, [&](std::uint32_t item, const geom::Segment& s) {
    const HalfEdgeId h = Subdivision::half_edge(EdgeId(item));
    if (mark(EdgeId(item)).trail == none || geom::distance(s, p) > near) return;
    bool at_end = false;
    for (const VertexId v : {subdivision_.origin(h), subdivision_.target(h)}) {
      const double away = geom::distance(subdivision_.point(v), p);
      if (away > near) continue;
      at_end = true;
      const double least = there.valid() ? geom::distance(subdivision_.point(there), p) : near;
      if (away < least || !there.valid() || (away == least && v < there)) there = v;
    }
    if (!at_end) passing.push_back(EdgeId(item));
  });
  if (there.valid()) p = subdivision_.point(there);
  std::sort(passing.begin(), passing.end());
  for (const EdgeId e : passing) {
    if (subdivision_.contains(e)) DOBRA_TRY_VOID(lead_through(e, p));
  }
  return topo::insert(subdivision_, p);
}

Result<void> Stepper::lead_through(EdgeId e, Point p) {
  const Mark marked = mark(e);
  const geom::Segment s = subdivision_.segment(e);
  DOBRA_TRY_VOID(topo::remove(subdivision_, e, topo::Bare::Keep));
  DOBRA_TRY(const topo::Inserted parts, topo::insert(subdivision_, geom::Polyline{{s.from, p, s.to}, false}));
  for (const HalfEdgeId h : parts.path) {
    const EdgeId part = Subdivision::edge(h);
    if (mark(part).trail == none) subdivision_.attribute(part) = marked;
  }
  return {};
}

/// A raw edge through the vertices of the curve so far that it passes by rounding only.
geom::Polyline Stepper::way_of(const geom::Segment& edge) const {
  const double near = std::max(rounding(edge.from), rounding(edge.to));
  std::vector<Point> passed;
  subdivision_.edge_tree().visit(edge, near, [&](std::uint32_t item, const geom::Segment& s) {
    if (mark(EdgeId(item)).trail == none) return;
    for (const Point q : {s.from, s.to}) {
      const bool inside = geom::distance(q, edge.from) > near && geom::distance(q, edge.to) > near;
      if (inside && geom::distance(edge, q) <= near) passed.push_back(q);
    }
  });
  geom::sort_along(edge, passed);
  geom::Polyline way{{edge.from}, false};
  way.points.insert(way.points.end(), passed.begin(), passed.end());
  way.points.push_back(edge.to);
  return way;
}

/// The curve so far from one of its vertices to a later one. Walked backwards, so that what is walked is what a region
/// is made of.
std::vector<HalfEdgeId> Stepper::trail(VertexId from, VertexId to) const {
  std::unordered_map<VertexId, HalfEdgeId> onward{{to, HalfEdgeId()}};
  std::vector<VertexId> reached{to};
  for (std::size_t i = 0; i < reached.size() && !onward.contains(from); ++i) {
    for (const HalfEdgeId h : subdivision_.round(reached[i])) {
      const VertexId before = subdivision_.target(h);
      if (mark(Subdivision::edge(h)).trail == none || !onward.try_emplace(before, Subdivision::twin(h)).second)
        continue;
      reached.push_back(before);
    }
  }
  std::vector<HalfEdgeId> way;
  for (auto at = onward.find(from); at != onward.end() && at->second.valid();
       at = onward.find(subdivision_.target(at->second))) {
    way.push_back(at->second);
  }
  return way;
}

Result<Stepper::Step> Stepper::step() {
  DOBRA_CHECK(!done());
  const auto raw = static_cast<std::uint32_t>(next_);
  const std::size_t last = (next_ + 1) % chain_.points.size();
  Step step;
  step.base_segment = base_.source[base_segment(raw)];
  step.edge = {base_.user(chain_.points[next_]), base_.user(chain_.points[last])};
  DOBRA_TRY(const VertexId to, arrive(raw_point(last)));
  const geom::Segment edge{subdivision_.point(end_), subdivision_.point(to)};
  ++next_;
  if (edge.from != edge.to) {
    DOBRA_TRY(const topo::Inserted inserted, topo::insert(subdivision_, way_of(edge)));
    step.inserted = inserted.edges;
    step.formed = inserted.faces;
    const std::span<const HalfEdgeId> path = inserted.path;
    for (std::size_t k = 0; k < path.size(); ++k) advance(path[k], raw, path.subspan(k + 1), step);
  }
  if (done() && base_.closed) erase_what_is_near(step);
  return step;
}

/// The curve goes on along h. Where it has been there before, a region closes: the trail from there to here, and h,
/// which may be a part of that trail where the curve turns straight back.
void Stepper::advance(HalfEdgeId h, std::uint32_t raw, std::span<const HalfEdgeId> ahead, Step& step) {
  const EdgeId e = Subdivision::edge(h);
  const VertexId v = subdivision_.target(h);
  const bool returns = on_trail(v);
  std::vector<HalfEdgeId> region;
  if (returns) region = trail(v, end_);
  Mark marked = mark(e);
  const bool straight_back = marked.trail != none;
  if (!straight_back) {
    marked.trail = raw;
    subdivision_.attribute(e) = marked;
    region.push_back(h);
  }
  end_ = v;
  if (!returns) return;
  const bool stands = base_.closed && !straight_back && !spurious(region);
  for (const HalfEdgeId side : region) {
    const EdgeId part = Subdivision::edge(side);
    Mark m = mark(part);
    if (stands && m.kept == none) {
      m.kept = m.trail;
    } else if (stands && !kept_way(side)) {
      m.kept = none;  // there and back again is nothing
    }
    m.trail = none;
    subdivision_.attribute(part) = m;
    const bool needed =
        std::any_of(ahead.begin(), ahead.end(), [&](HalfEdgeId a) { return Subdivision::edge(a) == part; });
    if (m.kept == none && !needed) erase(part, step);
  }
}

bool Stepper::spurious(std::span<const HalfEdgeId> region) const {
  return std::all_of(region.begin(), region.end(), [&](HalfEdgeId h) {
    return judge_.buried(subdivision_.segment(h), base_segment(mark(Subdivision::edge(h)).trail));
  });
}

void Stepper::erase(EdgeId e, Step& step) {
  step.deleted.push_back(e);
  step.deleted_edges.push_back(subdivision_.segment(e));
  const HalfEdgeId h = Subdivision::half_edge(e);
  const VertexId ends[2] = {subdivision_.origin(h), subdivision_.target(h)};
  const Result<void> removed = topo::remove(subdivision_, e, topo::Bare::Keep);
  DOBRA_CHECK(removed.ok());
  for (const VertexId v : ends) {
    if (v != start_ && v != end_ && subdivision_.lone_loop(v).valid()) subdivision_.kvsf(v);
  }
}

/// The last pass on closed contours: now that all crossings are there, each edge is near as a whole or not at all.
void Stepper::erase_what_is_near(Step& step) {
  for (const EdgeId e : subdivision_.edges()) {
    const Mark m = mark(e);
    if (m.kept == none || judge_.middle_is_near(subdivision_.segment(e), base_segment(m.kept))) erase(e, step);
  }
  // Tips of long joins that stick out on the far side of the base bound nothing.
  std::vector<VertexId> ends = subdivision_.vertices();
  while (!ends.empty()) {
    const VertexId v = ends.back();
    ends.pop_back();
    if (!subdivision_.contains(v) || subdivision_.degree(v) != 1) continue;
    ends.push_back(subdivision_.target(subdivision_.leaving(v)));
    erase(Subdivision::edge(subdivision_.leaving(v)), step);
  }
}

/// True if a region that stands runs along h this way.
bool Stepper::kept_way(HalfEdgeId h) const {
  const std::uint32_t raw = mark(Subdivision::edge(h)).kept;
  if (raw == none) return false;
  return geom::dot(subdivision_.segment(h).vector(), raw_point(raw + 1) - raw_point(raw)) > 0.0;
}

/// The way on: the first that leaves anticlockwise from the way back, so that contours that touch stay apart.
HalfEdgeId Stepper::next_kept(HalfEdgeId h) const {
  const HalfEdgeId back = Subdivision::twin(h);
  for (HalfEdgeId out = subdivision_.turned(back); out != back; out = subdivision_.turned(out)) {
    if (kept_way(out)) return out;
  }
  return {};
}

void Stepper::add_contours(OffsetCurve& curve) const {
  std::unordered_set<EdgeId> used;
  std::vector<HalfEdgeId> starts;
  for (const EdgeId e : subdivision_.edges()) {
    for (const HalfEdgeId h : {Subdivision::half_edge(e), Subdivision::twin(Subdivision::half_edge(e))}) {
      if (kept_way(h)) starts.push_back(h);
    }
  }
  std::stable_sort(starts.begin(), starts.end(), [&](HalfEdgeId a, HalfEdgeId b) {
    return mark(Subdivision::edge(a)).kept < mark(Subdivision::edge(b)).kept;
  });
  for (const HalfEdgeId first : starts) {
    if (used.contains(Subdivision::edge(first))) continue;
    std::vector<HalfEdgeId> way;
    HalfEdgeId h = first;
    while (h.valid() && used.insert(Subdivision::edge(h)).second) {
      way.push_back(h);
      h = next_kept(h);
    }
    curve.pieces.push_back(piece(way, true, h == first));
  }
}

OffsetPiece Stepper::piece(const std::vector<HalfEdgeId>& way, bool kept, bool closed) const {
  OffsetPiece made;
  made.side = base_.mirrored ? Side::LeftOfTravel : Side::RightOfTravel;
  made.closed = closed;
  const auto raw = [&](std::size_t i) {
    const Mark m = mark(Subdivision::edge(way[i]));
    return kept ? m.kept : m.trail;
  };
  const auto add = [&](VertexId v) {
    const Point p = subdivision_.point(v);
    made.points.push_back({p.x, base_.mirrored ? -p.y : p.y});
  };
  for (std::size_t i = 0; i < way.size(); ++i) {
    // Where the raw edge just goes on, nothing is left of what crossed it.
    const bool goes_on = i > 0 ? raw(i - 1) == raw(i) : closed && way.size() > 1 && raw(way.size() - 1) == raw(0);
    if (goes_on) continue;
    add(subdivision_.origin(way[i]));
    made.edges.push_back(OffsetEdge::line(base_.source[base_segment(raw(i))]));
  }
  if (!closed && !way.empty()) add(subdivision_.target(way.back()));
  return made;
}

OffsetCurve Stepper::result() const {
  OffsetCurve curve;
  curve.distance = distance_;
  if (base_.closed) add_contours(curve);
  const bool all = base_.closed && done();
  if (const auto way = all ? std::vector<HalfEdgeId>() : trail(start_, end_); !way.empty()) {
    curve.pieces.insert(curve.pieces.begin(), piece(way, false, false));
  }
  return curve;
}

Result<OffsetCurve> run_stepper(const geom::Polyline& curve, double distance, const OffsetOptions& options) {
  DOBRA_TRY(Stepper stepper, Stepper::start(curve, distance, options));
  while (!stepper.done()) DOBRA_TRY_VOID(stepper.step());
  return stepper.result();
}

}  // namespace dobra::offset::stepper
