#include "shared/offset/verifier/model.h"

#include <algorithm>
#include <array>
#include <limits>

#include "shared/geom/intersect.h"
#include "shared/geom/polyline.h"
#include "shared/offset/verifier/exact.h"

namespace dobra::offset::verifier {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Box;
using geom::Point;

Wide nearest_on(Wide a, Wide b, Wide p) {
  const Wide along = b - a;
  const long double squared = dot(along, along);
  if (squared == 0) return a;
  const long double t = dot(p - a, along) / squared;
  // From the nearer end, so that a foot near it keeps its digits.
  if (t <= 0) return a;
  if (t >= 1) return b;
  return t < 0.5L ? a + t * along : b + (dot(p - b, along) / squared) * along;
}

bool in_sector(Wide centre, Wide a, Wide b, Wide p) {
  const Wide u = a - centre;
  const Wide v = b - centre;
  const Wide w = p - centre;
  const long double whole = cross(u, v);
  if (whole > 0) return cross(u, w) >= 0 && cross(w, v) >= 0;
  if (dot(u, v) > 0) return dot(u, w) > 0 && cross(u, w) >= 0 && cross(w, v) >= 0;  // empty but for rounding
  return cross(u, w) >= 0 || (cross(w, v) >= 0 && dot(w, u) < 0);                   // half a turn
}

Box box_round(Wide a, Wide b) {
  Box box;
  box.add(narrow(a));
  box.add(narrow(b));
  return box;
}

long double gap(const Box& box, Wide p) {
  const long double x = std::max({box.low.x - p.x, 0.0L, p.x - box.high.x});
  const long double y = std::max({box.low.y - p.y, 0.0L, p.y - box.high.y});
  return std::hypot(x, y);
}

long double gap(const Box& box, Wide a, Wide b) {
  // Clipped by the sides of the box: does the segment meet it?
  long double from = 0;
  long double to = 1;
  const auto clip = [&](long double start, long double step, long double low, long double high) {
    if (step == 0) {
      if (start < low || start > high) from = 2;
      return;
    }
    const long double s = (low - start) / step;
    const long double t = (high - start) / step;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  };
  clip(a.x, b.x - a.x, box.low.x, box.high.x);
  clip(a.y, b.y - a.y, box.low.y, box.high.y);
  if (from <= to) return 0;
  long double least = std::min(gap(box, a), gap(box, b));
  for (const Wide corner : {Wide{box.low.x, box.low.y}, Wide{box.high.x, box.low.y}, Wide{box.high.x, box.high.y},
                            Wide{box.low.x, box.high.y}}) {
    least = std::min(least, size(nearest_on(a, b, corner) - corner));
  }
  return least;
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  while (leaves_ < boxes.size()) leaves_ *= 2;
  boxes_.resize(2 * static_cast<std::size_t>(leaves_));
  std::copy(boxes.begin(), boxes.end(), boxes_.begin() + leaves_);
  for (std::size_t i = leaves_ - 1; i > 0; --i) {
    boxes_[i].add(boxes_[2 * i]);
    boxes_[i].add(boxes_[2 * i + 1]);
  }
}

namespace {

Error at_point(ErrorCode code, std::string message, Point p) {
  Error error{code, std::move(message), base::Place{}};
  if (geom::is_finite(p)) {
    error.place->x = p.x;
    error.place->y = p.y;
  }
  return error;
}

/// a.x b.y - a.y b.x, rounded about once.
long double precise_cross(Wide a, Wide b) {
  const long double product = a.y * b.x;
  return std::fma(a.x, b.y, -product) - std::fma(a.y, b.x, -product);
}

/// The first normal turned by half of a left turn; digits are kept next to a U-turn, where the normals cancel.
Wide halfway(Wide along, long double half_tan) {
  if (std::isinf(half_tan)) return along;
  const long double cosine = 1 / std::sqrt(1 + half_tan * half_tan);
  return cosine * right_of(along) + (half_tan * cosine) * along;
}

}  // namespace

Result<Model> Model::make(const geom::Polyline& base, const OffsetOptions& options, double distance) {
  if (!(distance > 0) || !std::isfinite(distance))
    return Error{ErrorCode::InvalidOption, "a distance to verify must be above 0"};
  Model made;
  made.closed = base.closed;
  made.mirrored = options.side == Side::LeftOfTravel;
  made.round = options.join == Join::Round;
  made.raw = options.treatment == Treatment::Untreated;
  made.paper = options.ends == Ends::Paper && !base.closed && !made.raw;
  made.d = distance;
  double greatest = 0;
  for (std::size_t i = 0; i < base.points.size(); ++i) {
    const Point p = base.points[i];
    if (!geom::is_finite(p))
      return at_point(ErrorCode::NotFinite, "a coordinate of the base is not a finite number", p);
    greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
    const Point q{p.x, made.mirrored ? -p.y : p.y};
    if (!made.places.empty() && made.places.back() == q) {
      made.source.back() = static_cast<std::uint32_t>(i);  // the segment that leaves a repeated point is its last
      continue;
    }
    made.places.push_back(q);
    made.source.push_back(static_cast<std::uint32_t>(i));
  }
  if (made.closed && made.places.size() > 1 && made.places.front() == made.places.back()) {
    made.places.pop_back();
    made.source.pop_back();
  }
  if (made.places.size() < (made.closed ? 3U : 2U)) {
    return at_point(ErrorCode::DegenerateCurve, "the base has too few distinct points",
                    base.points.empty() ? Point{} : base.points[0]);
  }
  if (!made.closed) made.source.pop_back();
  if (!made.closed && options.ends == Ends::Extended) {
    const auto lengthened = [&](Point end, Point inner) {
      return narrow(wide(end) + (static_cast<long double>(options.extension) * made.d) * unit(wide(end) - wide(inner)));
    };
    const Point first = lengthened(made.places[0], made.places[1]);
    const Point last = lengthened(made.places.back(), made.places[made.places.size() - 2]);
    if (first != made.places.front()) {  // else rounding swallows the extension
      made.places.insert(made.places.begin(), first);
      made.source.insert(made.source.begin(), made.source.front());
    }
    if (last != made.places.back()) {
      made.places.push_back(last);
      made.source.push_back(made.source.back());
    }
    greatest *= 4;  // new ends are rounded, wherever their maker rounds them
  }
  greatest = std::max(greatest, distance);
  made.rounding = static_cast<long double>(greatest) * std::numeric_limits<double>::epsilon();
  made.first_of.assign(base.points.size(), none);
  for (std::size_t i = made.source.size(); i-- > 0;) made.first_of[made.source[i]] = static_cast<std::uint32_t>(i);
  made.measure(options);
  // A subdivision leads edges through vertices that are a few units in the last place of its greatest coordinate away.
  for (std::size_t i = 0; made.paper && i < made.count(); ++i) {
    for (const Wide p : made.raw_edge(i))
      made.rounding = std::max(made.rounding, 0x1p-49L * std::max(std::abs(p.x), std::abs(p.y)));
  }
  made.find_mitres();
  made.find_out_if_simple();
  return made;
}

void Model::measure(const OffsetOptions& options) {
  const std::size_t segments = places.size() - (closed ? 0 : 1);
  std::vector<Box> boxes;
  boxes.reserve(segments);
  for (std::size_t i = 0; i < segments; ++i) {
    const Wide step = to(i) - from(i);
    span.push_back(size(step));
    along.push_back(unit(step));
    boxes.push_back(box_round(from(i), to(i)));
  }
  tree = BoxTree(boxes);
  corners.resize(places.size());
  for (std::size_t at = closed ? 0 : 1; at < places.size() - (closed ? 0 : 1); ++at) {
    const std::size_t in = incoming(at);
    Corner& corner = corners[at];
    const geom::Sign turn = geom::orient2d(places[in], places[at], places[end_index(at)]);
    const long double cosine = dot(along[in], along[at]);
    long double across = precise_cross(to(in) - from(in), to(at) - from(at));
    // Next to a U-turn nothing of it may be left, if the places have digits of very different sizes.
    if (cosine < 0 && std::abs(across) < 0x1p-20L * span[in] * span[at]) {
      across = cross_of(places[in], places[at], places[at], places[end_index(at)]);
    }
    const long double sine = std::abs(across) / (span[in] * span[at]);
    corner.kind = CornerKind::Straight;
    if (turn == geom::Sign::Zero && cosine > 0) continue;
    corner.half_tan = cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
    if (turn == geom::Sign::Zero) corner.half_tan = std::numeric_limits<long double>::infinity();
    corner.round_left = turn == geom::Sign::Negative;
    corner.middle = halfway(along[in], corner.round_left ? -corner.half_tan : corner.half_tan);
    corner.kind = CornerKind::Inner;
    if (turn == geom::Sign::Negative) continue;
    const long double limit = options.tip_limit();
    const bool within = 1 + corner.half_tan * corner.half_tan <= limit * limit * (1 + 1e-14L);
    const bool chord = std::isinf(corner.half_tan) && options.u_turn == UTurn::ChordBevel;
    corner.kind = CornerKind::Arc;
    if (options.join == Join::Round || options.join == Join::Bevel) continue;
    if (within) corner.kind = CornerKind::Mitre;
    if (!within && !chord && options.beyond_tip_limit() == BeyondLimit::TangentBevel) corner.kind = CornerKind::Tangent;
  }
}

void Model::find_out_if_simple() {
  simple = closed;
  const auto segment = [&](std::size_t i) { return geom::Segment{places[i], places[end_index(i)]}; };
  for (std::size_t i = 0; i < count() && simple; ++i) {
    const Box box = segment(i).box();
    tree.each([&](const Box& other) { return other.overlaps(box); },
              [&](std::size_t j) {
                if (j <= i) return false;
                const auto meet = geom::intersect(segment(i), segment(j)).kind;
                const bool neighbours = j == i + 1 || (i == 0 && j + 1 == count());
                if (meet == geom::IntersectionKind::Overlap || (meet == geom::IntersectionKind::Point && !neighbours))
                  simple = false;
                return !simple;
              });
  }
  anticlockwise = simple && geom::signed_area({places, true}) > 0;
}

long double Model::reach(std::size_t at) const {
  const long double t = corners[at].half_tan;
  if (corners[at].kind == CornerKind::Mitre) return d * t;
  if (corners[at].kind != CornerKind::Tangent) return 0;
  return std::isinf(t) ? d : d * (t / (1 + std::sqrt(1 + t * t)));  // tan of a quarter of the turn
}

std::array<Wide, 2> Model::raw_edge(std::size_t i) const {
  const auto back = [&](std::size_t at) {
    return corners[at].kind == CornerKind::Inner ? d * corners[at].half_tan : -reach(at);
  };
  const Wide aside = d * normal(i);
  return {from(i) + back(i) * along[i] + aside, to(i) - back(end_index(i)) * along[i] + aside};
}

void Model::find_mitres() {
  std::vector<Box> boxes;
  for (std::size_t at = 0; at < corners.size(); ++at) {
    if (corners[at].kind != CornerKind::Mitre && corners[at].kind != CornerKind::Tangent) continue;
    mitres.push_back(static_cast<std::uint32_t>(at));
    const Wide p = wide(places[at]);
    const std::size_t in = incoming(at);
    Box box = box_round(p + d * normal(in), p + d * normal(at));
    box.add(narrow(p));
    box.add(narrow(p + d * normal(in) + reach(at) * along[in]));
    box.add(narrow(p + d * normal(at) - reach(at) * along[at]));
    boxes.push_back(box);
  }
  mitre_tree = BoxTree(boxes);
}

long double Model::depth_in_mitre(std::size_t at, Wide p) const {
  const Wide q = p - wide(places[at]);
  const Wide first = normal(incoming(at));
  const Wide last = normal(at);
  if (cross(first, q) < 0 || cross(q, last) < 0 || dot(q, corners[at].middle) < 0)
    return -std::numeric_limits<long double>::infinity();
  long double out = std::max(dot(first, q), dot(last, q));
  if (corners[at].kind == CornerKind::Tangent) out = std::max(out, dot(corners[at].middle, q));
  return d - out;
}

std::vector<std::vector<Element>> Model::outline() const {
  std::vector<std::vector<Element>> walks(closed ? 2 : 1);
  std::vector<Element>* walk = &walks[0];
  const auto line = [&](Wide a, Wide b) { walk->push_back({a, b, {}, false}); };
  const auto arc = [&](Wide a, Wide b, Wide centre) { walk->push_back({a, b, centre, true}); };
  const auto turn_right_side = [&](std::size_t i) {  // the corner at the end of segment i
    const std::size_t at = end_index(i);
    const Wide p = to(i);
    const Wide a = p + d * normal(i);
    const Wide b = p + d * normal(after(i));
    switch (corners[at].kind) {
      case CornerKind::Mitre:
      case CornerKind::Tangent: {
        const Wide c = a + reach(at) * along[i];
        const Wide e = b - reach(at) * along[after(i)];
        line(a, c);
        if (corners[at].kind == CornerKind::Tangent) line(c, e);
        line(corners[at].kind == CornerKind::Tangent ? e : c, b);
        break;
      }
      case CornerKind::Arc:
        arc(a, b, p);
        break;
      default:
        line(a, p);
        line(p, b);
    }
  };
  const auto turn_left_side = [&](std::size_t i) {  // the corner at the start of segment i, going back
    const std::size_t at = i;
    const std::size_t in = incoming(at);
    const Wide p = from(i);
    const Wide a = p - d * normal(i);
    const Wide b = p - d * normal(in);
    if (corners[at].round_left) return arc(a, b, p);
    line(a, p);
    line(p, b);
  };
  const std::size_t n = count();
  for (std::size_t i = 0; i < n; ++i) {
    line(from(i) + d * normal(i), to(i) + d * normal(i));
    if (closed || i + 1 < n) turn_right_side(i);
  }
  if (closed) {
    walk = &walks[1];
  } else {
    const Wide p = to(n - 1);
    arc(p + d * normal(n - 1), p + d * along[n - 1], p);
    arc(p + d * along[n - 1], p - d * normal(n - 1), p);
  }
  for (std::size_t i = n; i-- > 0;) {
    line(to(i) - d * normal(i), from(i) - d * normal(i));
    if (closed || i > 0) turn_left_side(i);
  }
  if (!closed) {
    const Wide p = from(0);
    arc(p - d * normal(0), p - d * along[0], p);
    arc(p - d * along[0], p + d * normal(0), p);
  }
  return walks;
}

Winding::Winding(std::vector<Element> walk) : walk_(std::move(walk)) {
  while (leaves_ < walk_.size()) leaves_ *= 2;
  boxes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < walk_.size(); ++i) {
    // Ends are joined exactly: each element begins where the one before it ends.
    if (i > 0) walk_[i].a = walk_[i - 1].b;
    const Element& e = walk_[i];
    Box box = box_round(e.a, e.b);
    const double slack = static_cast<double>(size(e.b - e.a)) * 1e-15 + 1e-300;
    if (e.arc) {
      const long double r = size(e.a - e.centre);
      for (const Wide way : {Wide{r, 0}, Wide{0, r}, Wide{-r, 0}, Wide{0, -r}}) {
        if (in_sector(e.centre, e.a, e.b, e.centre + way)) box.add(narrow(e.centre + way));
      }
    }
    boxes_[leaves_ + i] = box.grown(slack + 4e-16 * std::max({std::abs(box.low.x), std::abs(box.high.x),
                                                              std::abs(box.low.y), std::abs(box.high.y)}));
  }
  if (!walk_.empty()) walk_.back().b = walk_.front().a;
  for (std::size_t i = leaves_ - 1; i > 0; --i) {
    boxes_[i].add(boxes_[2 * i]);
    boxes_[i].add(boxes_[2 * i + 1]);
  }
}

int Winding::round(Wide p) const { return part(1, 0, leaves_, p); }

int Winding::part(std::size_t node, std::size_t low, std::size_t high, Wide p) const {
  if (low >= walk_.size()) return 0;
  const Box& box = boxes_[node];
  if (box.high.y < p.y || box.low.y > p.y || box.high.x < p.x) return 0;
  // A ray to the right crosses a connected part beyond p as often as its ends say, upwards less downwards.
  const auto crossed = [&](Wide a, Wide b) {
    return (a.y <= p.y && b.y > p.y ? 1 : 0) - (a.y > p.y && b.y <= p.y ? 1 : 0);
  };
  const std::size_t last = std::min(high, walk_.size()) - 1;
  if (box.low.x > p.x) return crossed(walk_[low].a, walk_[last].b);
  if (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    return part(2 * node, low, middle, p) + part(2 * node + 1, middle, high, p);
  }
  const Element& e = walk_[low];
  const long double side = cross(e.b - e.a, p - e.a);
  int winds = crossed(e.a, e.b);
  if (winds > 0 && side <= 0) winds = 0;
  if (winds < 0 && side >= 0) winds = 0;
  // The part between an arc and its chord, which lies to the right of the chord.
  if (e.arc && side < 0 && size(p - e.centre) < size(e.a - e.centre)) ++winds;
  return winds;
}

Wide SeenEdge::middle() const {
  if (line || !(arc || chord)) return 0.5L * (a + b);
  const Wide u = a - centre;
  const Wide v = b - centre;
  // Long arcs bulge to the right of their chord, short ones along the sum of their radii: each where it keeps its
  // digits.
  return centre + size(u) * unit(dot(u, v) < 0 ? right_of(b - a) : u + v);
}

geom::Box box_of(const SeenEdge& edge) {
  Box box = box_round(edge.a, edge.b);
  if (!edge.arc) return box;
  const long double r = size(edge.a - edge.centre);
  for (const Wide way : {Wide{r, 0}, Wide{0, r}, Wide{-r, 0}, Wide{0, -r}}) {
    if (in_sector(edge.centre, edge.a, edge.b, edge.centre + way)) box.add(narrow(edge.centre + way));
  }
  return box;
}

long double distance(const SeenEdge& edge, Wide p, long double radius) {
  if (!edge.arc && !edge.chord) return size(nearest_on(edge.a, edge.b, p) - p);
  if (in_sector(edge.centre, edge.a, edge.b, p)) return std::abs(size(p - edge.centre) - radius);
  return std::min(size(p - edge.a), size(p - edge.b));
}

}  // namespace dobra::offset::verifier
