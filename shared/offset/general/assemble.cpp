// Step 4: sections become curves.

#include <algorithm>
#include <tuple>

#include "shared/offset/general/sections.h"

namespace dobra::offset::general {

namespace {

/// Grows with the angle of a direction, from -180 to 180 degrees.
Real rising(Vec v) {
  using std::abs;
  const Real part = v.y / (abs(v.x) + abs(v.y));
  if (v.x >= 0) return part;
  return (v.y < 0 ? -2 : 2) - part;
}

}  // namespace

/// The direction of travel along a piece at one of its nodes.
Vec Trimmer::heading(std::uint32_t piece, std::uint32_t node) const {
  const Site s = pieces_[piece].site();
  if (s.kind == SiteKind::Line) return outline_.along<Real>(s.step);
  return left_of(s.kind == SiteKind::Bevel ? outline_.middle_of_turn<Real>(s.step)
                                           : nodes_[node].at - outline_.to<Real>(s.step));
}

/// Where parts of the base coincide, so do parts of the curve, cut at the ends of both: they are one.
void Trimmer::remove_doubles() {
  using What = std::tuple<std::uint32_t, std::uint32_t, bool, Real, Real>;  // ends, kind, centre of an arc
  std::vector<std::pair<What, std::uint32_t>> parts;
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    const Section& s = sections_[i];
    if (s.first != s.last) continue;
    const Piece& piece = pieces_[s.first];
    const Vec pole = piece.is_line() ? Vec{} : outline_.to<Real>(piece.step());
    parts.push_back({{s.from, s.to, piece.is_line(), pole.x, pole.y}, i});
  }
  std::sort(parts.begin(), parts.end());
  std::vector<char> gone(sections_.size(), 0);
  for (std::size_t k = 1; k < parts.size(); ++k) gone[parts[k].second] = parts[k].first == parts[k - 1].first;
  std::erase_if(sections_, [&](const Section& s) { return gone[static_cast<std::size_t>(&s - sections_.data())]; });
}

/// Free space lies to the right of every section, so that the way on from one that arrives is the first one that
/// leaves, turning anticlockwise from the way back. Thus curves that touch are kept apart.
void Trimmer::link_at(std::span<const std::uint32_t> in, std::span<const std::uint32_t> out) {
  struct Ray {
    Real angle;
    int bend;  // of two with one tangent, the arc that bends anticlockwise comes later
    bool leaves;
    std::uint32_t section;
  };
  std::vector<Ray> rays;
  for (const std::uint32_t s : in) {
    const Section& section = sections_[s];
    const int bend = pieces_[section.last].is_line() ? 0 : -1;
    rays.push_back({rising(-heading(section.last, section.to)), bend, false, s});
  }
  for (const std::uint32_t s : out) {
    const Section& section = sections_[s];
    const int bend = pieces_[section.first].is_line() ? 0 : 1;
    rays.push_back({rising(heading(section.first, section.from)), bend, true, s});
  }
  std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
    return std::tuple{a.angle, a.bend, a.leaves, a.section} < std::tuple{b.angle, b.bend, b.leaves, b.section};
  });
  // Like brackets: an arriving one waits until the next leaving one takes it.
  std::vector<std::uint32_t> waiting;
  for (std::size_t k = 0; k < 2 * rays.size(); ++k) {
    const Ray& ray = rays[k % rays.size()];
    if (!ray.leaves && k < rays.size()) {
      waiting.push_back(ray.section);
    } else if (ray.leaves && !waiting.empty() && !has_leader_[ray.section]) {
      follower_[waiting.back()] = ray.section;
      has_leader_[ray.section] = 1;
      waiting.pop_back();
    }
  }
}

/// Joins the sections that meet at the nodes.
void Trimmer::link() {
  struct End {
    std::uint32_t node;
    bool leaves;
    std::uint32_t section;
    auto operator<=>(const End&) const = default;
  };
  std::vector<End> ends;
  ends.reserve(2 * sections_.size());
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    ends.push_back({sections_[i].to, false, i});
    ends.push_back({sections_[i].from, true, i});
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::uint32_t> in, out;
  for (auto end = ends.begin(); end != ends.end();) {
    in.clear();
    out.clear();
    for (const std::uint32_t at = end->node; end != ends.end() && end->node == at; ++end) {
      (end->leaves ? out : in).push_back(end->section);
    }
    if (!in.empty() && !out.empty()) link_at(in, out);
  }
}

/// Puts the sections in the order of their chains.
std::vector<Trimmer::Chain> Trimmer::assemble() {
  const std::size_t count = sections_.size();
  follower_.assign(count, none);
  has_leader_.assign(count, 0);
  link();
  std::vector<std::pair<std::uint32_t, Chain>> chains;  // with their first segments
  std::vector<char> done(count, 0);
  std::vector<Section> ordered;
  ordered.reserve(count);
  const auto follow = [&](std::uint32_t start) {
    const std::size_t first = ordered.size();
    std::uint32_t lowest = none;  // segments grow along a walk
    std::uint32_t s = start;
    for (; s != none && !done[s]; s = follower_[s]) {
      done[s] = 1;
      ordered.push_back(sections_[s]);
      lowest = std::min({lowest, segment_of(sections_[s].first), segment_of(sections_[s].last)});
    }
    chains.push_back({lowest, {first, ordered.size(), s != none}});
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!has_leader_[i]) follow(i);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!done[i]) follow(i);
  }
  sections_ = std::move(ordered);
  std::stable_sort(chains.begin(), chains.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Chain> result;
  result.reserve(chains.size());
  for (const auto& [lowest, chain] : chains) result.push_back(chain);
  return result;
}

/// All pieces of a plain block, if its first one is piece k. How many.
std::uint32_t Trimmer::write_block(PieceWriter& writer, std::uint32_t k, std::uint32_t last) const {
  const std::uint32_t step = pieces_[k].step();
  const Block& block = clearance_.blocks()[step / Block::size];
  const std::uint32_t count = block.piece_count;
  const auto starts = [&](geom::Point* start) {
    return Outline::Starts(outline_).find_block(step, block.arcs(), start);
  };
  return is_whole_block(block, k, last) && writer.add_block(step, block.arcs(), count, starts) ? count : 0;
}

/// All pieces of a plain block begin with piece k, which is of its first step, and none is cut.
bool Trimmer::is_whole_block(const Block& block, std::uint32_t k, std::uint32_t last) const {
  const Piece& first = pieces_[k];
  const std::uint32_t count = block.piece_count;
  if (!(outline_.distance() < block.plain_below) || clearance_.has_far_mitres() || k + count > last) return false;
  if (!first.is_line() || pieces_[k + count - 1].step() != first.step() + Block::size - 1) return false;
  return std::all_of(&first, &first + count, [](const Piece& p) { return p.trim_a == Piece::none; });
}

/// A closed chain starts where its lowest base segment does.
OffsetPiece Trimmer::output(const Chain& chain) const {
  const std::span<const Section> sections(sections_.data() + chain.first, sections_.data() + chain.last);
  std::size_t count = 1;
  for (const Section& s : sections) count += s.last - s.first + 1;
  PieceWriter writer(base_, options_.join);
  writer.reserve(count);
  const auto write = [&](Flat a, std::uint32_t k) {
    const Piece& piece = pieces_[k];
    if (piece.is_line()) {
      writer.add_line({a.x, a.y}, piece.step());
    } else {
      writer.add_arc({a.x, a.y}, piece.step());
    }
  };
  Outline::Ends ends(outline_);
  // A section that goes on in the piece where the one before stopped adds nothing there.
  const auto write_section = [&](const Section& s, std::uint32_t previous, std::uint32_t first, std::uint32_t last) {
    if (first == s.first && first != previous) write(flat(nodes_[s.from].at), first);
    for (std::uint32_t k = first == s.first ? first + 1 : first; k <= last;) {
      const bool may_begin = pieces_[k].step() % Block::size == 0;
      const std::uint32_t written = may_begin ? write_block(writer, k, last + 1) : 0;
      if (written == 0) write(place_of(pieces_[k], true, ends), k);
      k += std::max(written, 1U);
    }
  };
  if (!chain.closed) {
    std::uint32_t previous = none;
    for (const Section& s : sections) {
      write_section(s, previous, s.first, s.last);
      previous = s.last;
    }
    const Flat end = flat(nodes_[sections.back().to].at);
    return writer.finish_open({end.x, end.y});
  }
  // Where the lowest piece begins; pieces grow within a section.
  const std::size_t size = sections.size();
  const auto before = [&](std::size_t i) { return sections[(i + size - 1) % size].last; };
  std::size_t best = 0;
  std::uint32_t lowest = none;
  for (std::size_t i = 0; i < size; ++i) {
    const bool goes_on = sections[i].first == before(i);  // its first piece begins in another section
    const std::uint32_t k = sections[i].first + (goes_on ? 1 : 0);
    if (k > sections[i].last || k >= lowest) continue;
    lowest = k;
    best = i;
  }
  if (lowest == none) lowest = sections[0].first;  // one piece only
  write_section(sections[best], none, lowest, sections[best].last);
  for (std::size_t i = 1; i < size; ++i) {
    const std::size_t at = (best + i) % size;
    write_section(sections[at], before(at), sections[at].first, sections[at].last);
  }
  return writer.finish_closed(outline_.distance());
}

}  // namespace dobra::offset::general
