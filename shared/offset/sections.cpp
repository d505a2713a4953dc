// Step 3; pairs are in pairs.cpp, cuts in cuts.cpp, assembly in assemble.cpp.

#include "shared/offset/sections.h"

#include <algorithm>

namespace dobra::offset {

namespace {
constexpr std::uint32_t none = 0xffffffffU;
// 2^-58: some 30 roundings of Real, a thirtieth of one rounding of the input.
constexpr Real resolution = 3.5e-18L;
}  // namespace

Trimmer::Trimmer(const BaseCurve& base, const Clearance& clearance, Outline::Sides sides, double distance,
                 const OffsetOptions& options, const base::Progress& progress)
    : base_(base),
      clearance_(clearance),
      options_(options),
      outline_(base, clearance.corners(), sides, distance),
      distance_(distance),
      tau_(resolution * (base.size + distance_)),
      progress_(progress) {}

std::vector<OffsetPiece> Trimmer::run() { return run(Buried(base_, clearance_), nullptr); }

std::vector<OffsetPiece> Trimmer::run(const Buried& known, Buried* found) {
  chain_ = survivors(outline_, clearance_, known, found, progress_);
  wanted_ = static_cast<std::uint32_t>(pieces_.size());
  if (wanted_ == 0) return {};
  find_pairs(known, found);
  warm();
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (k % 1024 == 0 && progress_.cancelled()) return {};
    cut_pair(hot_of_[pairs_[k].first], hot_of_[pairs_[k].second]);
  }
  pairs_ = {};
  merge_nodes();
  make_sections();
  if (progress_.cancelled()) return {};
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
  const std::uint32_t trim = start ? piece.trim_a : piece.trim_b;
  if (trim != none) return meet(piece.site(), unpacked(chain_.trims[trim].other), chain_.trims[trim].at);
  return start ? outline_.natural_start<Real>(piece.site()) : outline_.natural_end<Real>(piece.site());
}

/// The pieces of all pairs in Real; linked ones share their node.
void Trimmer::warm() {
  hot_of_.assign(pieces_.size(), none);
  for (const auto& [i, j] : pairs_) hot_of_[i] = hot_of_[j] = 0;
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    if (hot_of_[k] == none) continue;
    const Piece& piece = pieces_[k];
    HotPiece hot{k, piece.is_line(), k < wanted_, {}, {}, centre(piece.site()), none, none};
    if (k > 0 && piece.linked() && hot_of_[k - 1] != none && !hot_.empty() && hot_.back().piece == k - 1) {
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
    if (k % 1024 == 0 && progress_.cancelled()) return;
    const std::uint32_t hot = hot_of_[k];
    if (k == 0 || !pieces_[k].linked()) {
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
    const bool joined = last ? base_.closed && pieces_[0].linked() : pieces_[k + 1].linked();
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
  return piece == s.first ? nodes_[s.from] : exact(start(piece));
}
Vec Trimmer::part_end(const Section& s, std::uint32_t piece) const {
  return piece == s.last ? nodes_[s.to] : exact(end(piece));
}

/// One place decides; but where boundaries nearly coincide the decision is within tau at some places and clear at others, so
/// that the first, the last and a long part are asked.
void Trimmer::add_section(Section section) {
  if (section.first == section.last && section.from == section.to) return;
  std::uint32_t longest = section.first;
  double size = -1;
  // The longest of a few is long enough.
  const std::uint32_t stride = 1 + (section.last - section.first) / 8;
  for (std::uint32_t k = section.first; k <= section.last; k += std::min(stride, std::max(1U, section.last - k))) {
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
  const Site site = pieces_[piece].site();
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
