#include "shared/topo/owners.h"

namespace dobra::topo {

std::uint32_t Owners::owner(HalfEdgeId h) const {
  const auto found = owner_.find(h);
  return found == owner_.end() ? Sides::none : found->second;
}

void Owners::set_owner(HalfEdgeId h, std::uint32_t who) {
  if (who == Sides::none) {
    owner_.erase(h);
  } else {
    owner_[h] = who;
  }
}

void Owners::record(FaceId f) {
  if (!concerned_.insert(f).second) return;
  const auto who = static_cast<std::uint32_t>(attributes_.size());
  attributes_.push_back(sub_.attribute(f));
  for (const LoopId l : sub_.loops(f)) {
    for (const HalfEdgeId h : sub_.half_edges(l)) owner_.try_emplace(h, who);
  }
}

Sides Owners::open(HalfEdgeId h) {
  const HalfEdgeId back = Subdivision::twin(h);
  if (!sub_.has_face_attributes()) return {};
  if (sub_.face(h) != sub_.face(back)) {
    record(sub_.face(h));
    record(sub_.face(back));
  }
  const Sides sides{owner(h), owner(back)};
  owner_.erase(h);
  owner_.erase(back);
  return sides;
}

void Owners::merged(FaceId left, FaceId right) {
  for (const FaceId f : {left, right}) {
    if (!sub_.contains(f)) concerned_.erase(f);
  }
}

void Owners::placed(HalfEdgeId h, const Sides& sides) {
  if (concerned_.empty()) return;
  set_owner(h, sides.left);
  set_owner(Subdivision::twin(h), sides.right);
}

void Owners::divided(FaceId old, FaceId fresh) {
  if (concerned_.contains(old)) concerned_.insert(fresh);
}

void Owners::split(HalfEdgeId h, HalfEdgeId rest) {
  if (concerned_.empty()) return;
  set_owner(rest, owner(h));
  set_owner(Subdivision::twin(rest), owner(Subdivision::twin(h)));
}

void Owners::coincides(HalfEdgeId h, const Sides& sides) {
  if (concerned_.empty() || sides.left == Sides::none) return;
  const HalfEdgeId back = Subdivision::twin(h);
  if (owner(h) == sides.right) {
    set_owner(h, sides.left);
  } else if (owner(back) == sides.left) {
    set_owner(back, sides.right);
  }
}

std::uint32_t Owners::longest_border(FaceId f) const {
  std::map<std::uint32_t, double> length;
  for (const LoopId l : sub_.loops(f)) {
    for (const HalfEdgeId h : sub_.half_edges(l)) {
      if (const std::uint32_t who = owner(h); who != Sides::none) length[who] += sub_.segment(h).length();
    }
  }
  std::uint32_t best = Sides::none;
  double most = -1.0;
  for (const auto& [who, l] : length) {
    if (l > most) {
      most = l;
      best = who;
    }
  }
  return best;
}

/// Of a face bordered by the new curve alone: that of a face beyond it.
std::uint32_t Owners::neighbours(FaceId f, const std::map<FaceId, std::uint32_t>& known) const {
  for (const LoopId l : sub_.loops(f)) {
    for (const HalfEdgeId h : sub_.half_edges(l)) {
      const auto found = known.find(sub_.face(Subdivision::twin(h)));
      if (found != known.end()) return found->second;
    }
  }
  return Sides::none;
}

void Owners::settle() {
  std::map<FaceId, std::uint32_t> known;
  std::vector<FaceId> open;
  for (const FaceId f : concerned_) {
    const std::uint32_t who = longest_border(f);
    if (who == Sides::none) {
      open.push_back(f);
    } else {
      known[f] = who;
    }
  }
  for (bool found = true; found && !open.empty();) {
    found = false;
    std::vector<FaceId> left;
    for (const FaceId f : open) {
      const std::uint32_t who = neighbours(f, known);
      if (who == Sides::none) {
        left.push_back(f);
      } else {
        known[f] = who;
        found = true;
      }
    }
    open = std::move(left);
  }
  for (const auto& [f, who] : known) sub_.attribute(f) = attributes_[who];
}

}  // namespace dobra::topo
