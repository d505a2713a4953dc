// Steps 1 and 3; cuts are in cuts.cpp, assembly in assemble.cpp.

#include "shared/offset/sections.h"

#include <algorithm>

#include "shared/offset/chain_tree.h"

namespace dobra::offset {

namespace {
constexpr std::uint32_t none = 0xffffffffU;
// 2^-58: some 30 roundings of Real, a thirtieth of one rounding of the input.
constexpr Real resolution = 3.5e-18L;
}  // namespace

Trimmer::Trimmer(const BaseCurve& base, const Clearance& clearance, Outline::Sides sides, double distance,
                 const OffsetOptions& options)
    : base_(base),
      clearance_(clearance),
      options_(options),
      outline_(base, sides, distance, options),
      distance_(distance),
      tau_(resolution * (base.size + distance_)) {}

std::vector<OffsetPiece> Trimmer::run() {
  pieces_ = survivors(outline_);
  cull();
  while (wanted_ < pieces_.size() && outline_.wanted(pieces_[wanted_].site)) ++wanted_;
  if (wanted_ == 0) return {};
  {
    const Pairs pairs = find_pairs();
    warm(pairs);
    for (const auto& [i, j] : pairs) cut_pair(hot_of_[i], hot_of_[j]);
  }
  merge_nodes();
  make_sections();
  remove_doubles();
  std::vector<OffsetPiece> result;
  for (const Chain& chain : assemble()) {
    OffsetPiece piece = output(chain);
    if (!piece.points.empty()) result.push_back(std::move(piece));
  }
  return result;
}

std::uint32_t Trimmer::node(Vec p) {
  nodes_.push_back(p);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

/// Distance is 1-Lipschitz: if the middle is nearer than D - h, all within h of it is nearer than D.
bool Trimmer::buried(std::size_t first, std::size_t last) const {
  Flat low = pieces_[first].a;
  Flat high = low;
  double bulge = 0;
  const auto add = [&](Flat p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  };
  for (std::size_t k = first; k < last; ++k) {
    add(pieces_[k].a);
    add(pieces_[k].b);
    // An arc of at most a right angle rises less than a quarter of its chord above it.
    if (!pieces_[k].is_line()) bulge = std::max(bulge, 0.25 * length(pieces_[k].b - pieces_[k].a));
  }
  const double half = 0.5 * length(high - low) + bulge;
  const double reach = outline_.distance() - half - 1e-13 * (base_.size + outline_.distance());
  return reach > 0 && clearance_.nearer_than(exact(0.5 * (low + high)), reach);
}

/// The same for a part of one piece, halved until each half is nearer to the base by more than its own size.
bool Trimmer::covered(const Piece& piece, Flat a, Flat b, int depth) const {
  const double d = outline_.distance();
  Flat middle = 0.5 * (a + b);
  if (!piece.is_line()) {
    const Flat c = outline_.to<double>(piece.site.step);
    middle = c + d * unit((a - c) + (b - c));
  }
  const double margin = 1e-13 * (base_.size + d);
  const double half = std::max(length(a - middle), length(b - middle));
  if (d - half - margin > 0 && clearance_.nearer_than(exact(middle), d - half - margin)) return true;
  if (depth == 0 || !clearance_.nearer_than(exact(middle), d - margin)) return false;
  return covered(piece, a, middle, depth - 1) && covered(piece, middle, b, depth - 1);
}

/// Long connected parts are what the pass understood; queries are for the short ones.
void Trimmer::cull() {
  constexpr std::size_t short_fragment = 64;
  const std::size_t count = pieces_.size();
  std::size_t seam = count;  // one past the first walk, whose last piece the very first one may be linked to
  while (outline_.two_walks() && seam > 0 && pieces_[seam - 1].site.step >= base_.segment_count()) --seam;
  std::size_t last_kept = count;
  std::size_t kept = 0;
  bool dropped = false;
  const auto keep = [&](std::size_t k) {
    Piece piece = pieces_[k];
    piece.linked = piece.linked && !dropped;
    dropped = false;
    pieces_[kept++] = piece;
    if (k < seam) last_kept = k;
  };
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first + 1;
    while (last < count && pieces_[last].linked) ++last;
    const bool is_short = last - first < short_fragment && last - first < count;
    if (is_short && last - first > 1 && buried(first, last)) {
      dropped = true;
    } else {
      for (std::size_t k = first; k < last; ++k) {
        if (is_short && covered(pieces_[k], pieces_[k].a, pieces_[k].b, 6)) {
          dropped = true;
        } else {
          keep(k);
        }
      }
    }
    first = last;
  }
  if (kept > 0 && last_kept + 1 != seam) pieces_[0].linked = false;
  pieces_.resize(kept);
}

Trimmer::Pairs Trimmer::find_pairs() const {
  const double d = outline_.distance();
  const auto item = [&](std::size_t i) {
    const Piece& p = pieces_[i];
    ChainTree::Item made{{std::min(p.a.x, p.b.x), std::min(p.a.y, p.b.y)}, {std::max(p.a.x, p.b.x), std::max(p.a.y, p.b.y)}, 0, p.linked};
    if (p.site.role == Role::Line) {
      const Flat u = outline_.along<double>(p.site.step);
      made.directions = ChainTree::directions_of(u, u);
    } else if (p.is_line()) {
      made.directions = ChainTree::directions_of(p.b - p.a, p.b - p.a);
    } else {
      const Flat c = outline_.to<double>(p.site.step);
      made.directions = ChainTree::directions_of(left_of(p.a - c), left_of(p.b - c));
      // The end tangents meet outside the arc: arcs are at most a right angle.
      const Flat sum = (p.a - c) + (p.b - c);
      const Flat m = c + (2 * d * d / dot(sum, sum)) * sum;
      made.low = {std::min(made.low.x, m.x), std::min(made.low.y, m.y)};
      made.high = {std::max(made.high.x, m.x), std::max(made.high.y, m.y)};
    }
    return made;
  };
  const ChainTree tree(pieces_.size(), item, 1e-13 * (base_.size + d));
  Pairs pairs;
  tree.for_each_pair([&](std::size_t i, std::size_t j) {
    if (i < wanted_) pairs.emplace_back(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  });
  return pairs;
}

Vec Trimmer::line_normal(Site s) const {
  return s.role == Role::Line ? outline_.normal<Real>(s.step) : outline_.middle_of_turn<Real>(s.step);
}

/// Where the lines or circles of two sites cross, nearest to a place known in doubles.
Vec Trimmer::meet(Site s, Site t, Flat near) const {
  const auto is_line = [](Site x) { return x.role == Role::Line || x.role == Role::Bevel; };
  if (!is_line(s) && is_line(t)) std::swap(s, t);
  const Vec start = exact(near);
  Vec found = start;
  const auto choose = [&](Vec middle, Vec half) {
    found = length(middle + half - start) < length(middle - half - start) ? middle + half : middle - half;
  };
  const Vec p = s.role == Role::Bevel ? centre(s) : outline_.from<Real>(s.step);
  if (is_line(s)) {
    const Vec n = line_normal(s);
    if (is_line(t)) {
      const Vec q = t.role == Role::Bevel ? centre(t) : outline_.from<Real>(t.step);
      const Vec m = line_normal(t);
      const Real area = cross(n, m);
      if (area == 0) return start;
      // n.x = D + n.p, m.x = D + m.q
      const Real f = distance_ - dot(n, start - p);
      const Real g = distance_ - dot(m, start - q);
      found = start + Vec{(f * m.y - g * n.y) / area, (g * n.x - f * m.x) / area};
    } else {
      const Vec c = centre(t);
      const Real gap = distance_ - dot(n, c - p);
      choose(c + gap * n, std::sqrt(std::max(Real(0), (distance_ - gap) * (distance_ + gap))) * left_of(n));
    }
  } else {
    const Vec c = centre(s);
    const Vec to = centre(t) - c;
    const Real gap = length(to);
    if (gap == 0) return start;
    choose(c + Real(0.5) * to, (std::sqrt(std::max(Real(0), (distance_ - gap / 2) * (distance_ + gap / 2))) / gap) * left_of(to));
  }
  return length(found - start) < distance_ * Real(1e-3) ? found : start;
}

Vec Trimmer::exact_end(const Piece& piece, bool start) const {
  const std::uint32_t cut = start ? piece.cut_a : piece.cut_b;
  if (cut != none) return meet(piece.site, unpacked(cut), start ? piece.a : piece.b);
  return start ? outline_.natural_start<Real>(piece.site) : outline_.natural_end<Real>(piece.site);
}

/// The pieces of all pairs in Real; linked ones share their node.
void Trimmer::warm(const Pairs& pairs) {
  hot_of_.assign(pieces_.size(), none);
  for (const auto& [i, j] : pairs) hot_of_[i] = hot_of_[j] = 0;
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    if (hot_of_[k] == none) continue;
    const Piece& piece = pieces_[k];
    HotPiece hot{k, piece.is_line(), k < wanted_, {}, {}, centre(piece.site), none, none};
    if (k > 0 && piece.linked && hot_of_[k - 1] != none && !hot_.empty() && hot_.back().piece == k - 1) {
      hot.node_a = hot_.back().node_b;
    } else {
      hot.node_a = node(exact_end(piece, true));
    }
    hot.node_b = node(exact_end(piece, false));
    hot.a = nodes_[hot.node_a];
    hot.b = nodes_[hot.node_b];
    hot_of_[k] = static_cast<std::uint32_t>(hot_.size());
    hot_.push_back(hot);
  }
}

void Trimmer::make_sections() {
  std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
    return std::pair{a.hot, a.at} < std::pair{b.hot, b.at};
  });
  const auto start_node = [&](std::uint32_t k) {
    return hot_of_[k] != none ? place_[hot_[hot_of_[k]].node_a] : none;
  };
  const auto new_node = [&](Vec p) {
    const std::uint32_t made = node(p);
    place_.push_back(made);
    touched_.push_back(1);
    return made;
  };
  Section open{none, none, none, none};
  std::uint32_t seam = none;
  std::size_t next = 0;
  const auto break_at = [&](std::uint32_t k, std::uint32_t to) {
    open.last = k;
    open.to = to;
    add_section(open);
    open = {k, k, to, none};
  };
  for (std::uint32_t k = 0; k < wanted_; ++k) {
    const std::uint32_t hot = hot_of_[k];
    if (k == 0 || !pieces_[k].linked) {
      std::uint32_t from = start_node(k);
      if (from == none) from = new_node(exact_end(pieces_[k], true));
      if (k == 0) seam = from;
      open = {k, k, from, none};
    } else if (hot != none && touched_[place_[hot_[hot].node_a]]) {
      const std::uint32_t at = place_[hot_[hot].node_a];
      if (open.from != at || open.first != k) {
        open.last = k - 1;
        open.to = at;
        add_section(open);
        open = {k, k, at, none};
      }
    }
    if (hot != none) {
      while (next < cuts_.size() && cuts_[next].hot < hot) ++next;
      for (; next < cuts_.size() && cuts_[next].hot == hot; ++next) {
        const std::uint32_t at = place_[cuts_[next].node];
        if (!(open.first == k && open.from == at)) break_at(k, at);
      }
    }
    // The end of the piece: a gap, the end of the walk, or a cut place; the next piece begins a section there.
    const bool last = k + 1 == wanted_;
    const bool joined = last ? base_.closed && pieces_[0].linked : pieces_[k + 1].linked;
    const bool ends_here = last || !joined || (hot != none && touched_[place_[hot_[hot].node_b]]);
    if (!ends_here) continue;
    std::uint32_t to = hot != none ? place_[hot_[hot].node_b] : none;
    if (last && joined) to = seam;
    if (to == none && !last && joined) to = start_node(k + 1);
    if (to == none) to = new_node(exact_end(pieces_[k], false));
    if (!(open.first == k && open.from == to && open.first != 0)) {
      open.last = k;
      open.to = to;
      add_section(open);
    }
    if (!last) open = {k + 1, k + 1, to, none};
  }
}

Vec Trimmer::part_start(const Section& s, std::uint32_t piece) const {
  return piece == s.first ? nodes_[s.from] : exact(pieces_[piece].a);
}
Vec Trimmer::part_end(const Section& s, std::uint32_t piece) const {
  return piece == s.last ? nodes_[s.to] : exact(pieces_[piece].b);
}

/// One place decides; but where boundaries nearly coincide the decision is within tau at some places and clear at others, so
/// that the first, the last and the longest part are asked.
void Trimmer::add_section(Section section) {
  if (section.first == section.last && section.from == section.to) return;
  std::uint32_t longest = section.first;
  double size = -1;
  for (std::uint32_t k = section.first; k <= section.last; ++k) {
    const Flat part = flat(part_end(section, k)) - flat(part_start(section, k));
    if (dot(part, part) > size) {
      size = dot(part, part);
      longest = k;
    }
  }
  if (!valid(middle(section, longest))) return;
  for (const std::uint32_t other : {section.first, section.last}) {
    if (other != longest && !valid(middle(section, other))) return;
  }
  sections_.push_back(section);
}

/// The middle of a part, on its site to the precision of Real.
Vec Trimmer::middle(const Section& section, std::uint32_t piece) const {
  const Vec a = part_start(section, piece);
  const Vec b = part_end(section, piece);
  const Site site = pieces_[piece].site;
  if (!pieces_[piece].is_line()) {
    const Vec c = centre(site);
    return c + distance_ * unit((a - c) + (b - c));
  }
  const Vec n = line_normal(site);
  const Vec p = site.role == Role::Bevel ? centre(site) : outline_.from<Real>(site.step);
  const Vec mid = Real(0.5) * (a + b);
  return mid + (distance_ - dot(n, mid - p)) * n;
}

bool Trimmer::valid(Vec p) const {
  return !clearance_.nearer_than(p, distance_ - 2 * tau_) && !clearance_.in_mitre(p, outline_, distance_ - 2 * tau_);
}

}  // namespace dobra::offset
