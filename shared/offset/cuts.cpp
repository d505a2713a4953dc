// Step 2: where pieces meet. A cut too many does no harm (both sides are then valid, or both not), so whatever comes within
// tau is cut, tangencies and ends included.

#include <algorithm>
#include <unordered_map>

#include "shared/offset/sections.h"

namespace dobra::offset {

void Trimmer::cut_pair(std::uint32_t i, std::uint32_t j) {
  cut_at_ends(i, j);
  if (hot_[j].wanted) cut_at_ends(j, i);
  if (hot_[i].line && hot_[j].line) return cut_lines(i, j);
  if (hot_[i].line) return cut_line_arc(i, j);
  if (hot_[j].line) return cut_line_arc(j, i);
  cut_arcs(i, j);
}

void Trimmer::add_cut(std::uint32_t i, std::uint32_t j, Vec p) {
  const std::uint32_t at = node(p);
  if (hot_[i].wanted) cuts_.push_back({i, length(p - hot_[i].a), at});
  if (hot_[j].wanted) cuts_.push_back({j, length(p - hot_[j].a), at});
}

/// Cuts `piece` where an end of `other` lies on it.
void Trimmer::cut_at_ends(std::uint32_t piece, std::uint32_t other) {
  const HotPiece& cut = hot_[piece];
  const HotPiece& end = hot_[other];
  for (const bool first : {true, false}) {
    const Vec p = first ? end.a : end.b;
    const std::uint32_t at = first ? end.node_a : end.node_b;
    if (at == cut.node_a || at == cut.node_b) continue;
    const Vec to = p - cut.a;
    if (cut.line) {
      const Vec whole = cut.b - cut.a;
      const Real size = length(whole);
      const Vec along = (1 / size) * whole;
      const Real t = dot(to, along);
      if (t < -tau_ || t > size + tau_ || std::abs(cross(along, to)) > tau_) continue;
    } else if (std::abs(length(p - cut.centre) - distance_) > tau_ || !on_arc(cut, p)) {
      continue;
    }
    cuts_.push_back({piece, length(to), at});
  }
}

void Trimmer::cut_lines(std::uint32_t i, std::uint32_t j) {
  const HotPiece& p = hot_[i];
  const HotPiece& q = hot_[j];
  const Vec u = p.b - p.a;
  const Vec v = q.b - q.a;
  const Vec w = q.a - p.a;
  const Real area = cross(u, v);
  if (area == 0) return;
  const Real t = cross(w, v) / area;
  const Real s = cross(w, u) / area;
  const Real slack_p = tau_ / length(u);
  const Real slack_q = tau_ / length(v);
  if (t < -slack_p || t > 1 + slack_p || s < -slack_q || s > 1 + slack_q) return;
  add_cut(i, j, p.a + std::clamp(t, Real(0), Real(1)) * u);
}

bool Trimmer::on_arc(const HotPiece& arc, Vec p) const {
  const Vec out = p - arc.centre;
  const Real slack = tau_ * distance_;
  return cross(arc.a - arc.centre, out) >= -slack && cross(out, arc.b - arc.centre) >= -slack;
}

void Trimmer::cut_line_arc(std::uint32_t line, std::uint32_t arc) {
  const HotPiece& p = hot_[line];
  const HotPiece& c = hot_[arc];
  const Vec whole = p.b - p.a;
  const Real size = length(whole);
  const Vec along = (1 / size) * whole;
  const Vec to = c.centre - p.a;
  const Real foot = dot(to, along);
  const Real across = std::abs(cross(along, to));
  if (across > distance_ + tau_) return;
  const auto cut = [&](Real t) {
    if (t < -tau_ || t > size + tau_) return;
    const Vec at = p.a + std::clamp(t, Real(0), size) * along;
    if (on_arc(c, at)) add_cut(line, arc, at);
  };
  if (std::abs(distance_ - across) <= tau_) cut(foot);
  if (across >= distance_) return;
  const Real half = std::sqrt((distance_ - across) * (distance_ + across));
  cut(foot - half);
  cut(foot + half);
}

void Trimmer::cut_arcs(std::uint32_t i, std::uint32_t j) {
  const HotPiece& p = hot_[i];
  const HotPiece& q = hot_[j];
  const Vec between = q.centre - p.centre;
  const Real half = length(between) / 2;
  if (half <= tau_ || half > distance_ + tau_) return;  // the same circle: its ends are cuts already
  const Vec mid = p.centre + Real(0.5) * between;
  const auto cut = [&](Vec at) {
    if (on_arc(p, at) && on_arc(q, at)) add_cut(i, j, at);
  };
  if (std::abs(distance_ - half) <= tau_) cut(mid);
  if (half >= distance_) return;
  const Vec across = (std::sqrt((distance_ - half) * (distance_ + half)) / (2 * half)) * left_of(between);
  cut(mid + across);
  cut(mid - across);
}

/// Nodes nearer than tau are one, which is the one made first.
void Trimmer::merge_nodes() {
  place_.resize(nodes_.size());
  const Real cell = 4 * tau_;
  const auto key = [](long long x, long long y) {
    return static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL ^ static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL;
  };
  std::unordered_multimap<std::uint64_t, std::uint32_t> cells;
  cells.reserve(nodes_.size());
  std::vector<char> used(nodes_.size(), 0);
  for (const HotPiece& piece : hot_) {
    if (piece.wanted) used[piece.node_a] = used[piece.node_b] = 1;
  }
  for (const Cut& cut : cuts_) used[cut.node] = 1;
  touched_.assign(nodes_.size(), 0);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    place_[i] = i;
    if (!used[i]) continue;
    const Vec p = nodes_[i];
    // A place is near the edge of its cell in few cases, and only then has to be looked for next door as well.
    const Real cx = std::floor(p.x / cell);
    const Real cy = std::floor(p.y / cell);
    const int left = p.x / cell - cx < Real(0.5) ? -1 : 1;
    const int down = p.y / cell - cy < Real(0.5) ? -1 : 1;
    std::uint32_t found = i;
    for (const int dx : {0, left}) {
      for (const int dy : {0, down}) {
        const auto range = cells.equal_range(key(static_cast<long long>(cx) + dx, static_cast<long long>(cy) + dy));
        for (auto it = range.first; it != range.second; ++it) {
          if (it->second < found && length(nodes_[it->second] - p) <= tau_) found = it->second;
        }
      }
    }
    place_[i] = found;
    if (found != i) touched_[found] = 1;
    if (found == i) cells.emplace(key(static_cast<long long>(cx), static_cast<long long>(cy)), i);
  }
  for (const Cut& cut : cuts_) touched_[place_[cut.node]] = 1;
}

}  // namespace dobra::offset
