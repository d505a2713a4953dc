// Step 2: where pieces meet, and in which order on each.

#include <algorithm>
#include <limits>
#include <numeric>
#include <type_traits>

#include "shared/offset/general/sections.h"

namespace dobra::offset::general {

namespace {

/// What a half tangent's error is multiplied with: the cross product that it comes from is exact in High only.
template <class T>
double growth(double half_tan) {
  return std::is_same_v<T, High> ? 1 + half_tan : 1 + half_tan * half_tan;
}

// Far below what the perturbation of D makes of coincidences, far above the error.
constexpr double same_place = 0x1p-180;

}  // namespace

/// Greatest coordinates about a site, which its error is measured against.
double Trimmer::error_of(Site s) const {
  double reach = 1;
  if (s.kind == SiteKind::Line) {
    for (const std::uint32_t step : {outline_.before(s.step), s.step}) {
      if (outline_.corner(step) == CornerKind::Mitre) reach = std::max(reach, 1 + outline_.half_tan(step));
    }
  }
  return base_.size + outline_.distance() * reach;
}

/// The line or circle of a site. Lines begin at the start of their segment, whatever their ends.
template <class T>
Shape<T> Trimmer::whole(Site s) const {
  Shape<T> made;
  made.line = s.kind == SiteKind::Line || s.kind == SiteKind::Bevel;
  made.error = made.slide = resolution<T> * error_of(s);
  const T d = distance_as<T>(outline_.distance());
  if (s.kind == SiteKind::Line) {
    made.pole = outline_.along<T>(s.step);
    made.a = outline_.from<T>(s.step) + d * right_of(made.pole);
  } else if (s.kind == SiteKind::Bevel) {
    const VecOf<T> out = outline_.middle_of_turn<T>(s.step);
    made.pole = left_of(out);
    made.a = outline_.to<T>(s.step) + d * out;
  } else {
    made.pole = outline_.to<T>(s.step);
  }
  return made;
}

template <class T>
Contact<T> Trimmer::end_of(const Piece& piece, bool start) const {
  const Site site = piece.site();
  const std::uint32_t trim = start ? piece.trim_a : piece.trim_b;
  if (trim != Piece::none) {
    const Shape<T> own = whole<T>(site);
    const Shape<T> other = whole<T>(unpacked(chain_.trims[trim].other));
    const T d = distance_as<T>(outline_.distance());
    return start ? entry(other, own, d) : entry(own, other, d);
  }
  Contact<T> found;
  found.at = start ? outline_.natural_start<T>(site) : outline_.natural_end<T>(site);
  double turn = 0;
  if (site.kind == SiteKind::Line) {
    const std::uint32_t step = start ? outline_.before(site.step) : site.step;
    const CornerKind kind = outline_.corner(step);
    if (kind == CornerKind::Mitre || kind == CornerKind::Meet) turn = outline_.half_tan(step);
  }
  found.slide = resolution<T> * (error_of(site) + outline_.distance() * growth<T>(turn));
  return found;
}

template <class T>
Shape<T> Trimmer::shape(const Piece& piece, const Contact<T>& a, const Contact<T>& b) const {
  Shape<T> made = whole<T>(piece.site());
  made.a = a.at;
  made.b = b.at;
  made.slide = std::max({made.slide, a.slide, b.slide});
  made.size = made.line ? dot(b.at - a.at, made.pole) : length(b.at - a.at);
  return made;
}

/// The pieces of all pairs; linked ones share their node.
void Trimmer::warm() {
  hot_of_.assign(pieces_.size(), none);
  if (pairs_.empty()) return;
  for (const auto& [i, j] : pairs_) hot_of_[i] = hot_of_[j] = 0;
  Contact<Real> end;
  for (std::uint32_t k = 0; k < hot_of_.size(); ++k) {
    if (hot_of_[k] == none) continue;
    const auto hot = static_cast<std::uint32_t>(hot_.size());
    const bool linked = k > 0 && pieces_[k].linked() && hot > 0 && hot_.back().piece == k - 1;
    const Contact<Real> start = linked ? end : end_of<Real>(pieces_[k], true);
    end = end_of<Real>(pieces_[k], false);
    HotPiece made{shape(pieces_[k], start, end), k, none, none};
    made.node_a = linked ? hot_.back().node_b : node(made.shape.a, hot, start_of);
    const bool seam = k + 1 == wanted_ && k > 0 && pieces_[0].linked() && hot_of_[0] != none;
    made.node_b = seam ? hot_[hot_of_[0]].node_a : node(made.shape.b, hot, end_of_piece);
    hot_of_[k] = hot;
    hot_.push_back(made);
  }
}

void Trimmer::cut_pair(std::uint32_t i, std::uint32_t j) {
  const HotPiece& p = hot_[i];
  const HotPiece& q = hot_[j];
  if (p.node_a == q.node_b && p.node_a != none && q.piece + 1 == wanted_) return;  // linked over the seam
  const Contacts<Real> contacts(p.shape, q.shape, outline_.distance());
  if (!contacts.doubtful()) return add_cuts(i, j, contacts);
  const Contacts<High> exact(fine_shape(i), fine_shape(j), distance_as<High>(outline_.distance()));
  if (exact.twins()) twins_.insert(twins_.end(), {i, j});
  add_cuts(i, j, exact);
}

template <class T>
void Trimmer::add_cuts(std::uint32_t i, std::uint32_t j, const Contacts<T>& contacts) {
  for (const Contact<T>& contact : contacts) {
    using Kind = typename Contact<T>::Kind;
    if (contact.kind != Kind::Crossing) {  // an end of one lies on the other
      const bool of_first = contact.kind == Kind::StartOfFirst || contact.kind == Kind::EndOfFirst;
      const bool start = contact.kind == Kind::StartOfFirst || contact.kind == Kind::StartOfSecond;
      const HotPiece& own = hot_[of_first ? i : j];
      ends_.push_back(start ? own.node_a : own.node_b);  // a section ends there, whatever the other piece is for
      add_cut(of_first ? j : i, ends_.back(), own.shape.slide);
      continue;
    }
    const std::uint32_t at = node(as<Real>(contact.at), i, j);
    if constexpr (std::is_same_v<T, High>) fine_.emplace(at, contact.at);
    double slide = contact.slide;
    const double least = resolution<Real> * (base_.size + outline_.distance());
    if (!(slide < 0x1p8 * least)) fine(at);  // nearly parallel, or cut far from where they are known best
    if (fine_.contains(at)) slide = least;
    add_cut(i, at, slide);
    add_cut(j, at, slide);
  }
}

void Trimmer::add_cut(std::uint32_t hot, std::uint32_t node, double slide) {
  const HotPiece& piece = hot_[hot];
  if (piece.piece >= wanted_) return;
  cuts_.push_back({length(nodes_[node].at - piece.shape.a), slide + piece.shape.slide, hot, node});
}

const Shape<High>& Trimmer::fine_shape(std::uint32_t hot) {
  const auto found = fine_shapes_.find(hot);
  if (found != fine_shapes_.end()) return found->second;
  const Piece& piece = pieces_[hot_[hot].piece];
  return fine_shapes_.emplace(hot, shape(piece, end_of<High>(piece, true), end_of<High>(piece, false))).first->second;
}

const VecOf<High>& Trimmer::fine(std::uint32_t node) {
  if (const auto found = fine_.find(node); found != fine_.end()) return found->second;
  const Node known = nodes_[node];
  const auto keep = [&](const VecOf<High>& at) -> const VecOf<High>& {
    nodes_[node].at = as<Real>(at);
    return fine_.emplace(node, at).first->second;
  };
  if (known.j == start_of) return keep(fine_shape(known.i).a);
  if (known.j == end_of_piece) return keep(fine_shape(known.i).b);
  VecOf<High> nearest = as<High>(known.at);
  High least = std::numeric_limits<High>::infinity();
  for (const Contact<High>& contact :
       Contacts<High>(fine_shape(known.i), fine_shape(known.j), distance_as<High>(outline_.distance()))) {
    const VecOf<High> off = contact.at - as<High>(known.at);
    if (dot(off, off) < least) {
      least = dot(off, off);
      nearest = contact.at;
    }
  }
  return keep(nearest);
}

std::uint32_t Trimmer::representative(std::uint32_t node) {
  while (place_[node] != node) node = place_[node] = place_[place_[node]];
  return node;
}

/// The one made first stands for both.
void Trimmer::merge(std::uint32_t a, std::uint32_t b) {
  a = representative(a);
  b = representative(b);
  place_[std::max(a, b)] = std::min(a, b);
  touched_[std::min(a, b)] = 1;
}

/// Pieces that coincide are cut by the same others, each by itself: the same places twice, perhaps.
void Trimmer::merge_twins() {
  if (twins_.empty()) return;
  std::sort(twins_.begin(), twins_.end());
  twins_.erase(std::unique(twins_.begin(), twins_.end()), twins_.end());
  struct Known {
    Real along;  // in some direction that no base has
    double error;
    std::uint32_t node;
  };
  std::vector<Known> all;
  const auto add = [&](std::uint32_t node, double error) {
    all.push_back({dot(nodes_[node].at, Vec{Real(0.8191520442889918L), Real(0.5735764363510461L)}), error, node});
  };
  for (const std::uint32_t hot : twins_) {
    add(hot_[hot].node_a, hot_[hot].shape.slide);
    add(hot_[hot].node_b, hot_[hot].shape.slide);
  }
  for (const Cut& cut : cuts_) {
    if (std::binary_search(twins_.begin(), twins_.end(), cut.hot)) add(cut.node, cut.error);
  }
  std::sort(all.begin(), all.end(),
            [](const Known& a, const Known& b) { return a.along != b.along ? a.along < b.along : a.node < b.node; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1;
         j < all.size() && all[j].along - all[i].along <= static_cast<Real>(all[i].error + all[j].error); ++j) {
      if (representative(all[i].node) == representative(all[j].node)) continue;
      const VecOf<High> off = fine(all[j].node) - fine(all[i].node);
      if (length(off) <= same_place * (base_.size + outline_.distance())) merge(all[i].node, all[j].node);
    }
  }
}

/// By exact places; those that are one for every distance are merged.
void Trimmer::order_in_doubt(Cut* first, Cut* last) {
  struct Exact {
    High at;
    Cut cut;
  };
  std::vector<Exact> exact;
  const Shape<High>& own = fine_shape(first->hot);
  for (const Cut* c = first; c != last; ++c) {
    const VecOf<High> off = fine(c->node) - own.a;
    exact.push_back({own.line ? dot(off, own.pole) : length(off), *c});
  }
  std::sort(exact.begin(), exact.end(),
            [](const Exact& a, const Exact& b) { return a.at != b.at ? a.at < b.at : a.cut.node < b.cut.node; });
  const double same = same_place * error_of(pieces_[hot_[first->hot].piece].site());
  for (std::size_t k = 0; k < exact.size(); ++k) {
    first[k] = exact[k].cut;
    if (k > 0 && exact[k].at - exact[k - 1].at <= same) merge(exact[k - 1].cut.node, exact[k].cut.node);
  }
}

/// The cuts of one piece, its ends among them.
void Trimmer::order_piece(std::vector<Cut>& cuts) {
  std::sort(cuts.begin(), cuts.end(),
            [](const Cut& a, const Cut& b) { return a.at != b.at ? a.at < b.at : a.node < b.node; });
  for (std::size_t first = 0; first < cuts.size();) {
    std::size_t last = first + 1;
    Real reach = cuts[first].at + static_cast<Real>(cuts[first].error);
    for (; last < cuts.size() && cuts[last].at - static_cast<Real>(cuts[last].error) <= reach; ++last) {
      reach = std::max(reach, cuts[last].at + static_cast<Real>(cuts[last].error));
    }
    if (last - first > 1) order_in_doubt(cuts.data() + first, cuts.data() + last);
    first = last;
  }
}

void Trimmer::order_cuts() {
  place_.resize(nodes_.size());
  std::iota(place_.begin(), place_.end(), 0U);
  touched_.assign(nodes_.size(), 0);
  merge_twins();
  std::stable_sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) { return a.hot < b.hot; });
  std::vector<Cut> own;
  for (std::size_t first = 0; first < cuts_.size();) {
    std::size_t last = first;
    while (last < cuts_.size() && cuts_[last].hot == cuts_[first].hot) ++last;
    const HotPiece& piece = hot_[cuts_[first].hot];
    own.assign(cuts_.begin() + static_cast<std::ptrdiff_t>(first), cuts_.begin() + static_cast<std::ptrdiff_t>(last));
    own.push_back({0, piece.shape.slide, cuts_[first].hot, piece.node_a});
    own.push_back({piece.shape.size, 2 * piece.shape.slide, cuts_[first].hot, piece.node_b});
    order_piece(own);
    // The ends stay in place: what is before the start or beyond the end is one with it.
    std::size_t kept = first;
    for (const Cut& c : own) {
      if (kept < last && c.node != piece.node_a && c.node != piece.node_b) cuts_[kept++] = c;
    }
    for (; kept < last; ++kept) cuts_[kept] = {piece.shape.size, 0, cuts_[first].hot, piece.node_b};
    first = last;
  }
  for (std::uint32_t i = 0; i < place_.size(); ++i) {
    place_[i] = representative(i);
    if (touched_[i]) touched_[place_[i]] = 1;
  }
  for (const Cut& cut : cuts_) touched_[place_[cut.node]] = 1;
  for (const std::uint32_t end : ends_) touched_[place_[end]] = 1;
}

template Shape<double> Trimmer::whole<double>(Site) const;
template Shape<Real> Trimmer::whole<Real>(Site) const;
template Shape<High> Trimmer::whole<High>(Site) const;
template Contact<Real> Trimmer::end_of<Real>(const Piece&, bool) const;

}  // namespace dobra::offset::general
