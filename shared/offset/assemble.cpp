// Step 5: sections become curves.

#include <algorithm>
#include <map>

#include "shared/offset/sections.h"

namespace dobra::offset {

namespace {
constexpr std::uint32_t none = 0xffffffffU;
}  // namespace

Vec Trimmer::leaving(const Section& section) const {
  const RawPiece& piece = pieces_[section.piece];
  if (piece.is_line()) return nodes_[section.to] - nodes_[section.from];
  return left_of(nodes_[section.from] - piece.centre);
}

Vec Trimmer::arriving(const Section& section) const {
  const RawPiece& piece = pieces_[section.piece];
  if (piece.is_line()) return nodes_[section.to] - nodes_[section.from];
  return left_of(nodes_[section.to] - piece.centre);
}

/// Where boundaries coincide: the same way, they are one; opposite ways, the free strip between them has no width.
void Trimmer::remove_doubles() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between;
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    const Section& s = sections_[i];
    between[std::minmax(s.from, s.to)].push_back(i);
  }
  std::vector<char> gone(sections_.size(), 0);
  for (const auto& [ends, group] : between) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size(); ++b) {
        if (gone[group[b]] || gone[group[a]]) continue;
        const Section& s = sections_[group[a]];
        const Section& t = sections_[group[b]];
        if (length(middle(s) - middle(t)) > 4 * tau_) continue;
        if (s.from == t.from) gone[group[b]] = 1;
      }
    }
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size(); ++b) {
        if (gone[group[b]] || gone[group[a]]) continue;
        if (length(middle(sections_[group[a]]) - middle(sections_[group[b]])) > 4 * tau_) continue;
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
    rays.push_back({std::atan2(back.y, back.x), pieces_[sections_[s].piece].is_line() ? 0 : -1, false, s});
  }
  for (const std::uint32_t s : out) {
    const Vec on = leaving(sections_[s]);
    rays.push_back({std::atan2(on.y, on.x), pieces_[sections_[s].piece].is_line() ? 0 : 1, true, s});
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
    } else if (ray.leaves && !waiting.empty() &&
               std::find(follower_.begin(), follower_.end(), ray.section) == follower_.end()) {
      follower_[waiting.back()] = ray.section;
      waiting.pop_back();
    }
  }
}

std::vector<Chain> Trimmer::assemble() {
  std::vector<std::vector<std::uint32_t>> in(nodes_.size());
  std::vector<std::vector<std::uint32_t>> out(nodes_.size());
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    out[sections_[i].from].push_back(i);
    in[sections_[i].to].push_back(i);
  }
  follower_.assign(sections_.size(), none);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!in[n].empty() && !out[n].empty()) link_at(in[n], out[n]);
  }
  std::vector<char> has_leader(sections_.size(), 0);
  for (const std::uint32_t f : follower_) {
    if (f != none) has_leader[f] = 1;
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
    if (!has_leader[i]) follow(i);
  }
  for (std::uint32_t i = 0; i < sections_.size(); ++i) {
    if (!done[i]) follow(i);
  }
  const auto first_segment = [&](const Chain& chain) {
    std::uint32_t least = none;
    for (const Section& s : chain.sections) least = std::min(least, pieces_[s.piece].segment);
    return least;
  };
  std::stable_sort(chains.begin(), chains.end(),
                   [&](const Chain& a, const Chain& b) { return first_segment(a) < first_segment(b); });
  return chains;
}

OffsetPiece Trimmer::output(const Chain& chain) const {
  // A closed chain starts where its lowest base segment does.
  std::vector<Section> sections = chain.sections;
  if (chain.closed) {
    std::size_t start = 0;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const std::size_t before = i == 0 ? sections.size() - 1 : i - 1;
      if (sections[before].piece == sections[i].piece) continue;
      if (sections[start].piece == sections[start == 0 ? sections.size() - 1 : start - 1].piece ||
          pieces_[sections[i].piece].segment < pieces_[sections[start].piece].segment) {
        start = i;
      }
    }
    std::rotate(sections.begin(), sections.begin() + static_cast<std::ptrdiff_t>(start), sections.end());
  }
  OffsetPiece piece;
  piece.polyline.closed = chain.closed;
  const auto add = [&](Vec p, std::uint32_t segment) {
    const geom::Point q = base_.user(p);
    if (!piece.polyline.points.empty() && piece.polyline.points.back() == q) {
      piece.base_edge.back() = base_.source[segment];
      return;
    }
    piece.polyline.points.push_back(q);
    piece.base_edge.push_back(base_.source[segment]);
  };
  std::uint32_t last_segment = 0;
  for (std::size_t i = 0; i < sections.size();) {
    std::size_t end = i + 1;
    while (end < sections.size() && sections[end].piece == sections[i].piece) ++end;
    const RawPiece& raw = pieces_[sections[i].piece];
    const Vec a = nodes_[sections[i].from];
    const Vec b = nodes_[sections[end - 1].to];
    add(a, raw.segment);
    if (raw.kind == RawPiece::Kind::Arc) {
      const Vec from = a - raw.centre;
      const Vec to = b - raw.centre;
      Real angle = std::atan2(cross(from, to), dot(from, to));
      if (angle < 0) angle += 2 * std::acos(Real(-1));
      const Real step = 2 * std::acos(1 - static_cast<Real>(options_.arc_tolerance));
      const auto parts = std::max<long>(1, std::lround(std::ceil(angle / step)));
      for (long k = 1; k < parts; ++k) {
        const Real t = angle * static_cast<Real>(k) / static_cast<Real>(parts);
        add(raw.centre + (std::cos(t) * from + std::sin(t) * left_of(from)), raw.segment);
      }
    }
    last_segment = raw.segment;
    i = end;
  }
  auto& points = piece.polyline.points;
  if (!chain.closed) {
    add(nodes_[sections.back().to], last_segment);
    piece.base_edge.pop_back();
  } else if (points.size() > 1 && points.front() == points.back()) {
    points.pop_back();
    piece.base_edge.pop_back();
  }
  if (points.size() < (chain.closed ? 3U : 2U)) return {};
  return piece;
}

}  // namespace dobra::offset
