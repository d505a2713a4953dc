// Step 3; pairs are in pairs.cpp, cuts in cuts.cpp, assembly in assemble.cpp.

#include "shared/offset/general/sections.h"

#include <algorithm>
#include <cassert>

namespace dobra::offset::general {

Trimmer::Trimmer(const BaseCurve& base, const Clearance& clearance, Outline::Sides sides, double distance,
                 const OffsetOptions& options, const base::Progress& progress)
    : base_(base),
      clearance_(clearance),
      options_(options),
      outline_(base, clearance.corners(), sides, distance),
      witnesses_(outline_, clearance),
      validity_(outline_, clearance),
      progress_(progress) {}

std::vector<OffsetPiece> Trimmer::run() { return run(Buried(base_, clearance_), nullptr); }

std::vector<OffsetPiece> Trimmer::run(const Buried& known, Buried* found) {
  chain_ = candidates(outline_, clearance_, witnesses_, known, found, progress_);
  wanted_ = static_cast<std::uint32_t>(pieces_.size());
  if (wanted_ == 0) return {};
  pairs_ = Pairing(outline_, clearance_, chain_, witnesses_, progress_).run(known, found);
  if (progress_.cancelled()) return {};
  warm();
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (k % 1024 == 0 && progress_.cancelled()) return {};
    cut_pair(hot_of_[pairs_[k].first], hot_of_[pairs_[k].second]);
  }
  pairs_ = {};
  order_cuts();
  make_sections();
  if (progress_.cancelled()) return {};
  if (found != nullptr) tell_buried(*found);
  remove_doubles();
  std::vector<OffsetPiece> result;
  for (const Chain& chain : assemble()) {
    OffsetPiece piece = output(chain);
    if (!piece.points.empty()) result.push_back(std::move(piece));
  }
  return result;
}

std::uint32_t Trimmer::node(Vec p, std::uint32_t i, std::uint32_t j) {
  nodes_.push_back({p, i, j});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void Trimmer::make_sections() {
  const auto new_node = [&](Vec p) {
    const std::uint32_t made = node(p);
    place_.push_back(made);
    touched_.push_back(1);
    return made;
  };
  const auto hot_node = [&](std::uint32_t k, bool start) {
    if (hot_of_[k] == none) return none;
    return place_[start ? hot_[hot_of_[k]].node_a : hot_[hot_of_[k]].node_b];
  };
  Section open{none, none, none, none};
  // Ends the open section and begins one with piece `next`.
  const auto end_at = [&](std::uint32_t last, std::uint32_t to, std::uint32_t next) {
    add_section({open.first, last, open.from, to});
    open = {next, next, to, none};
  };
  // From a linked piece to the next one that may be cut, or that the next one does not follow: amidst a section.
  std::size_t next_hot = 0;
  const auto skip = [&](std::uint32_t k) {
    while (next_hot < hot_.size() && hot_[next_hot].piece < k) ++next_hot;
    const std::uint32_t stop = std::min(wanted_ - 1, next_hot < hot_.size() ? hot_[next_hot].piece : wanted_);
    return k < stop ? static_cast<std::uint32_t>(next_gap(pieces_.data(), k + 1, stop + 1)) - 1 : k;
  };
  std::uint32_t seam = none;
  std::size_t next_cut = 0;
  for (std::uint32_t k = 0; k < wanted_; ++k) {
    if (k % 1024 == 0 && progress_.cancelled()) return;
    if (k > 0 && pieces_[k].linked()) k = skip(k);
    const std::uint32_t start = hot_node(k, true);
    if (k == 0 || !pieces_[k].linked()) {
      open = {k, k, start != none ? start : new_node(end_of<Real>(pieces_[k], true).at), none};
      if (k == 0) seam = open.from;
    } else if (start != none && touched_[start] && (open.from != start || open.first != k)) {
      end_at(k - 1, start, k);
    }
    for (; next_cut < cuts_.size() && cuts_[next_cut].hot == hot_of_[k]; ++next_cut) {
      end_at(k, place_[cuts_[next_cut].node], k);
    }
    // The end of the piece: a gap, the end of the walk, or a cut place; the next piece begins a section there.
    const bool last = k + 1 == wanted_;
    const bool joined = last ? base_.closed && pieces_[0].linked() : pieces_[k + 1].linked();
    std::uint32_t to = hot_node(k, false);
    if (!last && joined && (to == none || !touched_[to])) continue;
    if (last && joined) to = seam;
    end_at(k, to != none ? to : new_node(end_of<Real>(pieces_[k], false).at), k + 1);
  }
}

/// Pieces without a valid section lie in U, and so does what was cut off them.
void Trimmer::tell_buried(Buried& found) const {
  std::uint32_t k = 0;
  const auto until = [&](std::uint32_t last) {
    for (; k < last; ++k) found.add(pieces_[k].site());
  };
  for (const Section& s : sections_) {
    until(s.first);
    k = s.last + 1;
  }
  until(wanted_);
}

template <class T>
VecOf<T> Trimmer::place(std::uint32_t node) const {
  if constexpr (std::is_same_v<T, High>) {
    // What was never in doubt is far enough from all else on its piece.
    if (const auto found = fine_.find(node); found != fine_.end()) return found->second;
  }
  return as<T>(nodes_[node].at);
}

/// The middle of a part, on its site to the precision of T.
template <class T>
VecOf<T> Trimmer::middle(const Section& section, std::uint32_t piece) const {
  const std::uint32_t hot = hot_of_[piece];
  const VecOf<T> a = piece == section.first ? place<T>(section.from)
                     : hot != none          ? place<T>(hot_[hot].node_a)
                                            : as<T>(start(piece));
  const VecOf<T> b = piece == section.last ? place<T>(section.to)
                     : hot != none         ? place<T>(hot_[hot].node_b)
                                           : as<T>(end(piece));
  const Shape<T> carrier = whole<T>(pieces_[piece].site());
  if (!carrier.line)
    return carrier.pole + distance_as<T>(outline_.distance()) * unit((a - carrier.pole) + (b - carrier.pole));
  return carrier.a + T(dot(carrier.pole, T(0.5) * (a + b) - carrier.a)) * carrier.pole;
}

bool Trimmer::valid(const Section& section, std::uint32_t piece) {
  const Flat rough = middle<double>(section, piece);
  // What cuts it most likely holds it, on one side of the cut.
  for (const std::uint32_t end : {section.from, section.to}) {
    if (nodes_[end].j >= end_of_piece) continue;
    for (const std::uint32_t hot : {nodes_[end].i, nodes_[end].j}) {
      if (hot_[hot].piece != piece && witnesses_.deep(rough, pieces_[hot_[hot].piece].step())) return false;
    }
  }
  const Site site = pieces_[piece].site();
  const double error = error_of(site);
  Place found = validity_.of(middle<Real>(section, piece), site, resolution<Real> * error);
  if (found == Place::Doubtful) found = validity_.of(middle<High>(section, piece), site, resolution<High> * error);
  if (found != Place::Free) return false;
  const bool only_side = outline_.sides() == Outline::Sides::Right && clearance_.has_mitres();
  return !only_side || !validity_.pokes_through(rough, site);
}

/// One place decides for all of it: the middle of the longest of a few parts, where the least is in doubt.
void Trimmer::add_section(const Section& section) {
  if (section.first == section.last && section.from == section.to) return;
  std::uint32_t longest = section.first;
  double size = -1;
  const std::uint32_t stride = 1 + (section.last - section.first) / 8;
  for (std::uint32_t k = section.first; k <= section.last; k += std::min(stride, std::max(1U, section.last - k))) {
    const Flat a = k == section.first ? flat(nodes_[section.from].at) : start(k);
    const Flat b = k == section.last ? flat(nodes_[section.to].at) : end(k);
    if (dot(b - a, b - a) > size) {
      size = dot(b - a, b - a);
      longest = k;
    }
  }
  const bool free = valid(section, longest);
  assert(valid(section, section.first) == free && valid(section, section.last) == free);
  if (free) sections_.push_back(section);
}

}  // namespace dobra::offset::general
