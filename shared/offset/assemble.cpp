// Step 4: sections become curves.

#include <algorithm>
#include <map>

#include "shared/offset/piece_writer.h"
#include "shared/offset/sections.h"

namespace dobra::offset {

namespace {
constexpr std::uint32_t none = 0xffffffffU;
}  // namespace

Vec Trimmer::leaving(const Section& section) const {
  const Piece& piece = pieces_[section.first];
  return piece.is_line() ? left_of(line_normal(piece.site)) : left_of(nodes_[section.from] - centre(piece.site));
}

Vec Trimmer::arriving(const Section& section) const {
  const Piece& piece = pieces_[section.last];
  return piece.is_line() ? left_of(line_normal(piece.site)) : left_of(nodes_[section.to] - centre(piece.site));
}

/// Where boundaries coincide: the same way, they are one; opposite ways, the free strip between them has no width.
void Trimmer::remove_doubles() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between;
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    const Section& s = sections_[i];
    if (s.first != s.last) continue;  // what coincides is cut at all ends of its pieces
    between[std::minmax(s.from, s.to)].push_back(i);
  }
  std::vector<char> gone(sections_.size(), 0);
  for (const auto& [ends, group] : between) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size(); ++b) {
        if (gone[group[b]] || gone[group[a]]) continue;
        const Section& s = sections_[group[a]];
        const Section& t = sections_[group[b]];
        if (length(middle(s, s.first) - middle(t, t.first)) > 4 * tau_) continue;
        if (s.from == t.from) gone[group[b]] = 1;
      }
    }
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size(); ++b) {
        if (gone[group[b]] || gone[group[a]]) continue;
        if (length(middle(sections_[group[a]], sections_[group[a]].first) - middle(sections_[group[b]], sections_[group[b]].first)) > 4 * tau_) continue;
        gone[group[a]] = gone[group[b]] = 1;
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    if (!gone[i]) sections_[kept++] = sections_[i];
  }
  sections_.resize(kept);
}

/// Free space lies to the right of every section, so that the way on from one that arrives is the first one that leaves,
/// turning anticlockwise from the way back. Thus curves that touch are kept apart.
void Trimmer::link_at(const std::vector<std::uint32_t>& in, const std::vector<std::uint32_t>& out) {
  if (in.size() == 1 && out.size() == 1) {
    follower_[in[0]] = out[0];
    has_leader_[out[0]] = 1;
    return;
  }
  struct Ray {
    Real angle;
    int bend;  // of two with one tangent, the arc that bends anticlockwise comes later
    bool leaves;
    std::uint32_t section;
  };
  std::vector<Ray> rays;
  for (const std::uint32_t s : in) {
    const Vec back = -arriving(sections_[s]);
    rays.push_back({std::atan2(back.y, back.x), pieces_[sections_[s].last].is_line() ? 0 : -1, false, s});
  }
  for (const std::uint32_t s : out) {
    const Vec on = leaving(sections_[s]);
    rays.push_back({std::atan2(on.y, on.x), pieces_[sections_[s].first].is_line() ? 0 : 1, true, s});
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

std::vector<Trimmer::Chain> Trimmer::assemble() {
  std::vector<std::vector<std::uint32_t>> in(nodes_.size());
  std::vector<std::vector<std::uint32_t>> out(nodes_.size());
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    out[sections_[i].from].push_back(i);
    in[sections_[i].to].push_back(i);
  }
  follower_.assign(sections_.size(), none);
  has_leader_.assign(sections_.size(), 0);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!in[n].empty() && !out[n].empty()) link_at(in[n], out[n]);
  }
  std::vector<Chain> chains;
  std::vector<char> done(sections_.size(), 0);
  const auto follow = [&](std::uint32_t start) {
    Chain chain;
    std::uint32_t s = start;
    while (s != none && !done[s]) {
      done[s] = 1;
      chain.sections.push_back(sections_[s]);
      s = follower_[s];
    }
    chain.closed = s != none;
    chains.push_back(std::move(chain));
  };
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    if (!has_leader_[i]) follow(i);
  }
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    if (!done[i]) follow(i);
  }
  const auto lowest_segment = [&](const Section& s) {  // segments grow along a walk
    return std::min(segment_of(s.first), segment_of(s.last));
  };
  const auto first_segment = [&](const Chain& chain) {
    std::uint32_t least = none;
    for (const Section& s : chain.sections) least = std::min(least, lowest_segment(s));
    return least;
  };
  std::stable_sort(chains.begin(), chains.end(),
                   [&](const Chain& a, const Chain& b) { return first_segment(a) < first_segment(b); });
  return chains;
}

/// A closed chain starts where its lowest base segment does.
OffsetPiece Trimmer::output(const Chain& chain) const {
  std::vector<Span> spans;
  std::size_t count = 0;
  for (const Section& s : chain.sections) count += s.last - s.first + 1;
  spans.reserve(count);
  for (const Section& s : chain.sections) {
    for (std::uint32_t k = s.first; k <= s.last; ++k) {
      if (spans.empty() || spans.back().piece != k) spans.push_back({flat(part_start(s, k)), k});
    }
  }
  const Flat end = flat(nodes_[chain.sections.back().to]);
  if (chain.closed) {
    if (spans.size() > 1 && spans.front().piece == spans.back().piece) {  // one piece, entered at its middle
      spans.front().a = spans.back().a;
      spans.pop_back();
    }
    std::size_t start = 0;
    for (std::size_t i = 1; i < spans.size(); ++i) {
      if (spans[i].piece < spans[start].piece) start = i;
    }
    std::rotate(spans.begin(), spans.begin() + static_cast<std::ptrdiff_t>(start), spans.end());
  }
  const auto point = [](Flat p) { return geom::Point{p.x, p.y}; };
  PieceWriter writer(base_, options_.join);
  writer.reserve(spans.size() + 1);
  for (const Span& span : spans) {
    const Site site = pieces_[span.piece].site;
    if (pieces_[span.piece].is_line()) {
      writer.add_line(point(span.a), site.step);
    } else {
      writer.add_arc(point(span.a), site.step);
    }
  }
  return chain.closed ? writer.finish_closed() : writer.finish_open(point(end));
}

}  // namespace dobra::offset
