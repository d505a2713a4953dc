// Steps 1, 2 and 4; cuts are in cuts.cpp, assembly in assemble.cpp.

#include "shared/offset/sections.h"

#include <algorithm>

namespace dobra::offset {

namespace {
constexpr std::uint32_t none = 0xffffffffU;
// 2^-58: some 30 roundings of Real, a thirtieth of one rounding of the input.
constexpr Real resolution = 3.5e-18L;
}  // namespace

Trimmer::Trimmer(const BaseCurve& base, const Clearance& clearance, Real distance, const OffsetOptions& options)
    : base_(base),
      clearance_(clearance),
      distance_(distance),
      options_(options),
      tau_(resolution * (base.size + distance)) {}

std::vector<Chain> Trimmer::run() {
  make_pieces();
  make_scissors();
  cull();
  find_cuts();
  merge_nodes();
  make_sections();
  remove_doubles();
  return assemble();
}

std::uint32_t Trimmer::node(Vec p) {
  nodes_.push_back(p);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void Trimmer::add_arc(RawPiece::Kind kind, bool wanted, std::size_t segment, Vec centre, std::uint32_t a,
                      std::uint32_t b) {
  RawPiece piece;
  piece.kind = kind;
  piece.wanted = wanted;
  piece.centre = centre;
  piece.segment = static_cast<std::uint32_t>(segment);
  piece.node_a = a;
  piece.node_b = b;
  piece.a = nodes_[a];
  piece.b = nodes_[b];
  pieces_.push_back(piece);
}

/// Fills the corner between `segment` and the next one, and tells the nodes where the two lines end and begin.
void Trimmer::make_corner(std::size_t segment, std::vector<std::uint32_t>& start_node,
                          std::vector<std::uint32_t>& end_node) {
  const std::size_t next = base_.after(segment);
  const std::size_t at = base_.end_index(segment);
  const Vec p = base_.points[at];
  const Vec n = base_.normal[segment];
  const Vec m = base_.normal[next];
  const Real t = base_.half_tan[at];
  const Vec first = p + distance_ * n;
  const Vec second = p + distance_ * m;
  if (base_.turn[at] == Turn::Straight) {
    end_node[segment] = start_node[next] = node(second);
  } else if (base_.turn[at] == Turn::Inner) {
    const Real back = distance_ * t;
    // Beyond the bisector each line is nearer than D to the other segment, provided that this reaches so far.
    if (back <= base_.lengths[segment] && back <= base_.lengths[next]) {
      end_node[segment] = start_node[next] = node(first - back * base_.along[segment]);
    } else {
      end_node[segment] = node(first);
      start_node[next] = node(second);
    }
  } else if (const Fill fill = fill_of(base_, at, options_); fill == Fill::Mitre) {
    end_node[segment] = start_node[next] = node(first + (distance_ * t) * base_.along[segment]);
    wedges_.push_back({p, n, m, {n, m}});
  } else if (fill == Fill::Tangent) {
    const Real q = distance_ * quarter_tan(t);
    const Vec bisector = std::isinf(t) ? base_.along[segment] : unit(n + m);
    end_node[segment] = node(first + q * base_.along[segment]);
    start_node[next] = node(second - q * base_.along[next]);
    RawPiece bevel;
    bevel.segment = static_cast<std::uint32_t>(segment);
    bevel.node_a = end_node[segment];
    bevel.node_b = start_node[next];
    bevel.a = nodes_[bevel.node_a];
    bevel.b = nodes_[bevel.node_b];
    pieces_.push_back(bevel);
    wedges_.push_back({p, n, m, {n, bisector, m}});
  } else {
    end_node[segment] = node(first);
    start_node[next] = node(second);
    const bool chord = options_.join != Join::Round;
    add_arc(chord ? RawPiece::Kind::Chord : RawPiece::Kind::Arc, true, segment, p, end_node[segment], start_node[next]);
  }
}

void Trimmer::make_pieces() {
  const std::size_t count = base_.segment_count();
  std::vector<std::uint32_t> start(count, none);
  std::vector<std::uint32_t> end(count, none);
  for (std::size_t i = 0; i < count; ++i) {
    if (base_.has_after(i)) make_corner(i, start, end);
  }
  if (!base_.closed) {
    start[0] = node(base_.from(0) + distance_ * base_.normal[0]);
    end[count - 1] = node(base_.to(count - 1) + distance_ * base_.normal[count - 1]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    RawPiece line;
    line.segment = static_cast<std::uint32_t>(i);
    line.node_a = start[i];
    line.node_b = end[i];
    line.a = nodes_[start[i]];
    line.b = nodes_[end[i]];
    // Cut from both sides beyond its middle: every point of it is nearer than D to one neighbour or the other.
    if (dot(line.b - line.a, base_.along[i]) > tau_) pieces_.push_back(line);
  }
  std::vector<geom::Box> boxes;
  for (const Wedge& w : wedges_) {
    geom::Box box;
    box.add(rounded(w.corner));
    for (std::size_t k = 0; k + 1 < w.bounds.size(); ++k) {
      const Vec sum = w.bounds[k] + w.bounds[k + 1];
      box.add(rounded(w.corner + (2 * distance_ / dot(sum, sum)) * sum));
    }
    box.add(rounded(w.corner + distance_ * w.from));
    box.add(rounded(w.corner + distance_ * w.to));
    boxes.push_back(box.grown(1e-12 * static_cast<double>(base_.size + distance_)));
  }
  wedge_index_ = geom::SpatialIndex(boxes);
}

void Trimmer::make_scissors() {
  const std::size_t count = base_.segment_count();
  for (std::size_t i = 0; i < count; ++i) {
    RawPiece line;
    line.wanted = false;
    line.segment = static_cast<std::uint32_t>(i);
    line.a = base_.to(i) - distance_ * base_.normal[i];
    line.b = base_.from(i) - distance_ * base_.normal[i];
    line.node_a = node(line.a);
    line.node_b = node(line.b);
    pieces_.push_back(line);
    const std::size_t at = base_.end_index(i);
    if (!base_.has_after(i) || base_.turn[at] != Turn::Inner) continue;
    const Vec p = base_.points[at];
    const std::uint32_t from = node(p - distance_ * base_.normal[base_.after(i)]);
    add_arc(RawPiece::Kind::Arc, false, i, p, from, node(p - distance_ * base_.normal[i]));
  }
  if (base_.closed) return;
  const Vec n = distance_ * base_.normal.front();
  const Vec m = distance_ * base_.normal.back();
  const std::uint32_t start_left = node(base_.points.front() - n);
  add_arc(RawPiece::Kind::Arc, false, 0, base_.points.front(), start_left, node(base_.points.front() + n));
  const std::uint32_t end_right = node(base_.points.back() + m);
  add_arc(RawPiece::Kind::Arc, false, count - 1, base_.points.back(), end_right, node(base_.points.back() - m));
}

void Trimmer::cull() {
  std::erase_if(pieces_, [&](const RawPiece& piece) { return piece.wanted && wholly_invalid(piece); });
  // Scissors that are near nothing wanted are the greater part, and need no clearance query to be put away.
  std::vector<geom::Box> boxes;
  for (const RawPiece& piece : pieces_) boxes.push_back(piece.wanted ? box_of(piece) : geom::Box{});
  const geom::SpatialIndex wanted(boxes);
  std::erase_if(pieces_, [&](const RawPiece& piece) {
    if (piece.wanted) return false;
    bool near = false;
    wanted.for_each_overlapping(box_of(piece), [&](std::size_t) {
      near = true;
      return geom::Visit::Stop;
    });
    return !near || wholly_invalid(piece);
  });
}

/// Distance is 1-Lipschitz: if the middle is nearer than D - h, all within h of it is nearer than D.
bool Trimmer::wholly_invalid(const RawPiece& piece) const {
  Vec mid = Real(0.5) * (piece.a + piece.b);
  if (!piece.is_line()) {
    const Vec out = mid - piece.centre;
    const Real size = length(out);
    mid = size > Real(1e-3) * distance_ ? piece.centre + (distance_ / size) * out
                                        : piece.centre + left_of(piece.a - piece.centre);
  }
  const Real half = std::max(length(piece.a - mid), length(piece.b - mid));
  return clearance_.nearer_than(mid, distance_ - half - 4 * tau_);
}

bool Trimmer::valid(Vec p) const {
  if (clearance_.nearer_than(p, distance_ - 2 * tau_)) return false;
  bool inside = false;
  const geom::Point q = rounded(p);
  wedge_index_.for_each_overlapping(geom::Box{q, q}, [&](std::size_t i) {
    const Wedge& w = wedges_[i];
    const Vec to = p - w.corner;
    if (cross(w.from, to) < 0 || cross(to, w.to) < 0) return geom::Visit::Continue;
    Real outermost = 0;
    for (const Vec n : w.bounds) outermost = std::max(outermost, dot(n, to));
    inside = outermost < distance_ - 2 * tau_;
    return inside ? geom::Visit::Stop : geom::Visit::Continue;
  });
  return !inside;
}

void Trimmer::make_sections() {
  std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
    return std::pair{a.piece, a.at} < std::pair{b.piece, b.at};
  });
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const RawPiece& piece = pieces_[i];
    std::uint32_t last = place_[piece.node_a];
    const auto up_to = [&](std::uint32_t node_to) {
      const Section section{i, last, node_to};
      if (node_to != last && valid(middle(section))) sections_.push_back(section);
      last = node_to;
    };
    for (; next < cuts_.size() && cuts_[next].piece == i; ++next) up_to(place_[cuts_[next].node]);
    if (piece.wanted) up_to(place_[piece.node_b]);
  }
}

Vec Trimmer::middle(const Section& section) const {
  const RawPiece& piece = pieces_[section.piece];
  const Vec a = nodes_[section.from];
  const Vec b = nodes_[section.to];
  const Vec mid = Real(0.5) * (a + b);
  if (piece.is_line()) return mid;
  const Vec out = mid - piece.centre;
  const Real size = length(out);
  // Half a turn has its middle to the left of its start, seen from the centre.
  if (size < Real(1e-3) * distance_) return piece.centre + left_of(a - piece.centre);
  return piece.centre + (distance_ / size) * out;
}

}  // namespace dobra::offset
