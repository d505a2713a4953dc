#include "shared/surf/mesh/border_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <unordered_map>

#include "shared/surf/details.h"
#include "shared/surf/measure.h"
#include "shared/surf/mesh/chart_sizes.h"
#include "shared/surf/mesh/tips.h"
#include "shared/surf/trim/open.h"

namespace dobra::surf::mesh {

using geom::Point;
using geom::Point3;
using geom::Vector3;
using trim::TrimmedSurface;

namespace {

bool is_point(const Border& border, const Piece& piece) {
  const BorderEdge& edge = border.edges[piece.edge];
  if (edge.point) return true;
  if (border.node_of[piece.from] != border.node_of[piece.to]) return false;
  const bool all_of_it = edge.cuts.size() == 2 && edge.cuts[0].vertex == piece.from && !edge.line &&
                         border.point_of[piece.from] == border.point_of[piece.to];
  constexpr double there_and_back = 2.0;
  return !all_of_it && edge.space.length(piece.s0, piece.s1) <= there_and_back * edge.tolerance;
}

}  // namespace

std::vector<Piece> pieces_of(const Border& border) {
  std::vector<Piece> pieces;
  std::vector<std::size_t> first_of_edge;
  for (std::size_t e = 0; e < border.edges.size(); ++e) {
    first_of_edge.push_back(pieces.size());
    const std::vector<Cut>& cuts = border.edges[e].cuts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      pieces.push_back({.edge = e,
                        .s0 = cuts[i].s,
                        .s1 = cuts[i + 1].s,
                        .from = cuts[i].vertex,
                        .to = cuts[i + 1].vertex,
                        .first = pieces.size()});
      pieces.back().point = is_point(border, pieces.back());
    }
  }
  for (const SharedGroup& group : border.groups) {
    const std::size_t count = border.edges[group[0]].cuts.size() - 1;
    for (std::size_t k = 1; k < group.size(); ++k) {
      const bool along = border.along(group[k], group[0]);
      for (std::size_t i = 0; i < count; ++i) {
        Piece& piece = pieces[first_of_edge[group[k]] + i];
        piece.first = first_of_edge[group[0]] + (along ? i : count - 1 - i);
        piece.along = along;
        piece.point = pieces[piece.first].point;
      }
    }
  }
  return pieces;
}

namespace {

/// The size that a curvature allows, 1/m.
double allowed_by(double bend, const SizeOptions& sizes) {
  if (!(bend > 0.0) || !std::isfinite(bend)) return std::numeric_limits<double>::infinity();
  double size = sizes.turn * std::numbers::pi / 180.0 / bend;
  if (sizes.chord > 0.0) size = std::min(size, std::sqrt(6.0 * sizes.chord / bend));  // of an equilateral triangle
  return size;
}

double bend_of_curve(const EdgeInSpace& edge, double s) {
  const EdgeInSpace::Jet c = edge.jet(s);
  const double speed = geom::length(c.first);
  return speed > 0.0 ? geom::length(cross(c.first, c.second)) / (speed * speed * speed) : 0.0;
}

}  // namespace

bool ends_in_tip(const BorderEdge& edge, double s) {
  return !edge.line && is_corner_tip(edge.space.surface(), edge.space.place(s));
}

namespace {

/// What is wanted along an edge at a parameter: by its bend and the surface's, by a formula, and by the bends of the
/// surface beside it, from which sizes grow. No bend counts as sharper than one whose radius is one point.
class Wishes {
 public:
  Wishes(const BorderEdge& edge, const SizeOptions& sizes, double largest)
      : space_(edge.space),
        both_sides_(edge.line.has_value()),
        sizes_(sizes),
        largest_(largest),
        most_bend_(1.0 / std::min(edge.tolerance, finest_bend * largest)),
        near_tip_(nearest_seen(edge, largest)) {}

  [[nodiscard]] double at(double place) const {
    const double s = std::clamp(place, near_tip_[0], near_tip_[1]);
    const Point uv = space_.place(s);
    const double by_bend = std::min(allowed(bend_of_curve(space_, s)), by_surface(uv, space_.surface().jet(uv)));
    const double own = std::min({largest_, by_bend, sizes_.wanted_at(uv, space_.at(s))});
    double size = beside(s, own, 1.0);
    if (both_sides_) size = std::min(size, beside(s, own, -1.0));
    return std::max(size, sizes_.least);
  }

 private:
  /// Between which parameters sizes are those of the place: nearer to a tip they are those at that distance.
  static std::array<double, 2> nearest_seen(const BorderEdge& edge, double largest) {
    std::array<double, 2> seen{0.0, 1.0};
    const double near = std::min(tip_seen * largest, 0.25 * edge.space.length(0.0, 1.0));
    if (ends_in_tip(edge, 0.0)) seen[0] = edge.space.parameter_at(near);
    if (ends_in_tip(edge, 1.0)) seen[1] = edge.space.parameter_at(edge.space.length(0.0, 1.0) - near);
    return seen;
  }
  [[nodiscard]] double allowed(double bend) const {
    return allowed_by(std::isfinite(bend) ? std::min(bend, most_bend_) : bend, sizes_);
  }
  [[nodiscard]] double by_surface(Point uv, const surf::Jet& jet) const {
    return std::min(allowed(followed_bend(space_.surface(), uv, jet, unnoticed_bend(largest_, sizes_), sizes_)),
                    size_by_chart(jet, sizes_));
  }
  /// @param side  1: to the left, where the face is
  [[nodiscard]] double beside(double s, double own, double side) const {
    constexpr std::array steps{0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};  // of the size
    const Surface& surface = space_.surface();
    const Point uv = space_.place(s);
    const surf::Jet jet = surface.jet(uv);
    const Metric m = metric(jet);
    const double det = m.e * m.g - m.f * m.f;
    const Vector3 left = side * cross(cross(jet.u, jet.v), space_.jet(s).first);
    const double long_left = geom::length(left);
    if (!(det > 0.0) || !(long_left > 0.0) || !std::isfinite(long_left)) return own;
    const double along_u = dot(left, jet.u) / long_left, along_v = dot(left, jet.v) / long_left;
    const geom::Vector way{(m.g * along_u - m.f * along_v) / det, (m.e * along_v - m.f * along_u) / det};
    double size = own;
    for (const double step : steps) {
      const Point there = uv + step * own * way;
      if (!surface.chart().contains(there)) break;
      const surf::Jet inside = surface.jet(there);
      const double by_bend = by_surface(there, inside);
      const double wanted = std::min(by_bend, sizes_.wanted_at(there, inside.at));
      size = std::min(size, wanted + (sizes_.growth - 1.0) * step * own);
    }
    return size;
  }

  const EdgeInSpace& space_;
  const bool both_sides_;
  static constexpr double finest_bend = 1e-4;  ///< Its radius, of the largest size, where the tolerance is great.

  const SizeOptions& sizes_;
  const double largest_;
  const double most_bend_;  ///< 1/m
  const std::array<double, 2> near_tip_;
};

/// Samples a quarter of the largest size apart, and where the surface bends closely; between two of them more, while
/// they are farther apart than their size.
Profile wishes_of(const BorderEdge& edge, const Piece& piece, const SizeOptions& sizes, double largest) {
  constexpr double samples_a_side = 4.0;
  constexpr std::size_t most_samples = 20'000;
  constexpr int most_halvings = 6;
  const EdgeInSpace& space = edge.space;
  const Wishes wishes(edge, sizes, largest);
  const double from = space.travelled(piece.s0);
  const double length = space.travelled(piece.s1) - from;
  const auto count = static_cast<std::size_t>(
      std::clamp(std::ceil(samples_a_side * length / largest), 16.0, static_cast<double>(most_samples)));
  Profile profile;
  const auto add = [&](double s, double size) {
    profile.s.push_back(s);
    // Never backwards, as quadrature over a kink may have it.
    const double before = profile.travelled.empty() ? 0.0 : profile.travelled.back();
    profile.travelled.push_back(std::max(space.travelled(s) - from, before));
    profile.size.push_back(size);
  };
  struct Sample {
    double s, size;
    int level;
  };
  std::vector<double> even;
  for (std::size_t i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    even.push_back(i == count ? piece.s1 : i == 0 ? piece.s0 : std::lerp(piece.s0, piece.s1, part));
  }
  const std::vector<double> first = seen_along(
      space.surface(), [&](double s) { return space.place(s); }, even);
  std::vector<Sample> after;  // the next one last
  for (std::size_t i = first.size(); i-- > 0;) after.push_back({first[i], wishes.at(first[i]), 0});
  std::size_t left = most_samples - std::min(most_samples, count);
  while (!after.empty()) {
    const Sample next = after.back();
    const double gap = profile.s.empty() ? 0.0 : space.travelled(next.s) - from - profile.travelled.back();
    if (left > 0 && next.level < most_halvings && !profile.s.empty() &&
        gap > 0.5 * std::min(next.size, profile.size.back())) {
      const double s = std::midpoint(profile.s.back(), next.s);
      after.back().level = next.level + 1;
      after.push_back({s, wishes.at(s), next.level + 1});
      --left;
      continue;
    }
    after.pop_back();
    add(next.s, next.size);
  }
  return profile;
}

/// All samples of one face or of all, linked along the border and at nodes.
class Samples {
 public:
  struct Sample {
    std::size_t piece;
    std::size_t index;
    Point3 at;
  };

  Samples(const Border& border, const std::vector<Piece>& pieces, std::vector<Profile>& profiles,
          const std::vector<std::size_t>& chosen)
      : border_(border), pieces_(pieces), profiles_(profiles) {
    for (const std::size_t p : chosen) {
      const Profile& profile = profiles[p];
      first_.emplace(p, samples_.size());
      for (std::size_t i = 0; i < profile.s.size(); ++i) {
        samples_.push_back({p, i, border.edges[pieces[p].edge].space.at(profile.s[i])});
      }
      ends_[border.node_of[pieces[p].from]].push_back(samples_.size() - profile.s.size());
      ends_[border.node_of[pieces[p].to]].push_back(samples_.size() - 1);
    }
  }

  [[nodiscard]] std::size_t count() const { return samples_.size(); }
  [[nodiscard]] const Sample& operator[](std::size_t i) const { return samples_[i]; }
  [[nodiscard]] double& size(std::size_t i) { return profiles_[samples_[i].piece].size[samples_[i].index]; }

  /// Calls visit(sample, distance along the border) for its neighbours.
  template <class Visitor>
  void for_neighbours(std::size_t i, Visitor&& visit) const {
    const Sample& here = samples_[i];
    const Profile& profile = profiles_[here.piece];
    if (here.index > 0) visit(i - 1, profile.travelled[here.index] - profile.travelled[here.index - 1]);
    if (here.index + 1 < profile.s.size()) {
      visit(i + 1, profile.travelled[here.index + 1] - profile.travelled[here.index]);
    }
    const Piece& piece = pieces_[here.piece];
    if (here.index == 0) at_node(piece.from, i, visit);
    if (here.index + 1 == profile.s.size()) at_node(piece.to, i, visit);
  }

  /// Sizes grow along the border by no more than `slope` a metre.
  void grow(double slope) {
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    for (std::size_t i = 0; i < count(); ++i) open.push({size(i), i});
    while (!open.empty()) {
      const auto [here, i] = open.top();
      open.pop();
      if (here > size(i)) continue;
      for_neighbours(i, [&, here = here](std::size_t j, double distance) {
        const double allowed = here + slope * distance;
        if (allowed >= size(j)) return;
        size(j) = allowed;
        open.push({allowed, j});
      });
    }
  }

  /// Where other parts of the border come near that are no neighbours along it.
  void narrow(double elements, double least) {
    const std::vector<double> free = all_sizes();
    double side = elements * *std::max_element(free.begin(), free.end());
    for (std::size_t i = 0; i + 1 < count(); ++i) {
      if (samples_[i].piece == samples_[i + 1].piece) {
        side = std::max(side, geom::distance(samples_[i].at, samples_[i + 1].at));
      }
    }
    const Grid grid(*this, side);
    constexpr double round_a_corner = 20.0;  // the way round one of 6 degrees, in straight distances
    std::vector<double> along(count(), std::numeric_limits<double>::infinity());
    std::vector<double> wanted = free;
    for (std::size_t i = 0; i < count(); ++i) {
      const double radius = elements * free[i];
      const std::vector<std::size_t> near = mark_neighbours(i, 2.0 * free[i], along);
      double distance = radius;
      grid.for_near(samples_[i].at, [&](std::size_t j) {  // the chord from j to j + 1
        if (pieces_[samples_[j].piece].first == pieces_[samples_[i].piece].first) return;
        const double away = from_chord(samples_[i].at, samples_[j].at, samples_[j + 1].at);
        if (std::min(along[j], along[j + 1]) <= round_a_corner * away) return;
        distance = std::min(distance, away);
      });
      for (const std::size_t j : near) along[j] = std::numeric_limits<double>::infinity();
      constexpr double finest = 0.002;  // of the size elsewhere: where borders touch or cross the distance is nought
      wanted[i] = std::max({std::min(free[i], distance / elements), finest * free[i], least});
    }
    for (std::size_t i = 0; i < count(); ++i) size(i) = wanted[i];
  }

 private:
  template <class Visitor>
  void at_node(std::size_t vertex, std::size_t except, Visitor& visit) const {
    const auto found = ends_.find(border_.node_of[vertex]);
    if (found == ends_.end()) return;
    for (const std::size_t j : found->second) {
      if (j != except) visit(j, 0.0);
    }
  }

  [[nodiscard]] std::vector<double> all_sizes() {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < count(); ++i) sizes.push_back(size(i));
    return sizes;
  }

  static double from_chord(Point3 p, Point3 a, Point3 b) {
    const Vector3 way = b - a;
    const double square = dot(way, way);
    const double t = square > 0.0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0.0;
    return geom::distance(p, a + t * way);
  }

  /// Samples within a way along the border: their distances in `along`, to be taken back by the list returned.
  std::vector<std::size_t> mark_neighbours(std::size_t i, double radius, std::vector<double>& along) const {
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    std::vector<std::size_t> marked{i};
    along[i] = 0.0;
    open.push({0.0, i});
    while (!open.empty()) {
      const auto [way, j] = open.top();
      open.pop();
      if (way > along[j]) continue;
      for_neighbours(j, [&, way = way](std::size_t k, double distance) {
        if (!(way + distance <= radius) || !(way + distance < along[k])) return;  // nor where a length is no number
        if (along[k] == std::numeric_limits<double>::infinity()) marked.push_back(k);
        along[k] = way + distance;
        open.push({way + distance, k});
      });
    }
    return marked;
  }

  /// Chords by the cubes of space that they pass.
  class Grid {
   public:
    Grid(const Samples& samples, double side) : side_(side) {
      for (std::size_t j = 0; j + 1 < samples.count(); ++j) {
        if (samples[j].piece != samples[j + 1].piece) continue;
        const auto a = cell(samples[j].at), b = cell(samples[j + 1].at);
        Key key;
        for (key[0] = std::min(a[0], b[0]); key[0] <= std::max(a[0], b[0]); ++key[0]) {
          for (key[1] = std::min(a[1], b[1]); key[1] <= std::max(a[1], b[1]); ++key[1]) {
            for (key[2] = std::min(a[2], b[2]); key[2] <= std::max(a[2], b[2]); ++key[2]) cells_[key].push_back(j);
          }
        }
      }
    }
    template <class Visitor>
    void for_near(Point3 p, Visitor&& visit) const {
      const Key here = cell(p);
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          for (std::int64_t dz = -1; dz <= 1; ++dz) {
            const auto found = cells_.find({here[0] + dx, here[1] + dy, here[2] + dz});
            if (found == cells_.end()) continue;
            for (const std::size_t j : found->second) visit(j);
          }
        }
      }
    }

   private:
    using Key = std::array<std::int64_t, 3>;
    [[nodiscard]] Key cell(Point3 p) const {
      return {static_cast<std::int64_t>(std::floor(p.x / side_)), static_cast<std::int64_t>(std::floor(p.y / side_)),
              static_cast<std::int64_t>(std::floor(p.z / side_))};
    }
    double side_;
    std::map<Key, std::vector<std::size_t>> cells_;
  };

  const Border& border_;
  const std::vector<Piece>& pieces_;
  std::vector<Profile>& profiles_;
  std::vector<Sample> samples_;
  std::unordered_map<std::size_t, std::size_t> first_;
  std::map<std::size_t, std::vector<std::size_t>> ends_;  ///< A node, the samples there.
};

/// The sizes of a piece go to the one that is divided for it, by parts of the way.
void hand_over(const Profile& own, bool along, Profile& first) {
  const double own_length = own.travelled.back(), length = first.travelled.back();
  for (std::size_t i = 0; i < own.s.size(); ++i) {
    const double part = own.travelled[i] / own_length;
    const double at = (along ? part : 1.0 - part) * length;
    const auto above = std::lower_bound(first.travelled.begin(), first.travelled.end(), at);
    const auto k =
        std::min<std::size_t>(static_cast<std::size_t>(above - first.travelled.begin()), first.travelled.size() - 1);
    first.size[k] = std::min(first.size[k], own.size[i]);
    if (k > 0) first.size[k - 1] = std::min(first.size[k - 1], own.size[i]);
  }
}

}  // namespace

std::vector<Profile> sizes_along(const Border& border, const std::vector<Piece>& pieces,
                                 std::span<const TrimmedSurface> surfaces, const SizeOptions& sizes,
                                 const std::vector<double>& largest) {
  std::vector<Profile> profiles(pieces.size());
  std::vector<std::vector<std::size_t>> of_face(surfaces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const BorderEdge& edge = border.edges[pieces[p].edge];
    if (pieces[p].point) continue;
    profiles[p] = wishes_of(edge, pieces[p], sizes, largest[edge.face]);
    of_face[edge.face].push_back(p);
  }
  const double slope = sizes.growth - 1.0;
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    if (of_face[f].empty()) continue;
    Samples samples(border, pieces, profiles, of_face[f]);
    if (sizes.narrow > 0.0) samples.narrow(sizes.narrow, sizes.least);
    for (const trim::ChartPoint& point : surfaces[f].points) {
      if (!point.size) continue;
      const Point3 at = surfaces[f].surface.at(point.at);
      for (std::size_t i = 0; i < samples.count(); ++i) {
        samples.size(i) = std::min(samples.size(i), *point.size + slope * geom::distance(at, samples[i].at));
      }
    }
  }
  std::vector<std::size_t> divided;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (profiles[p].s.empty()) continue;
    if (pieces[p].first == p) {
      divided.push_back(p);
    } else {
      hand_over(profiles[p], pieces[p].along, profiles[pieces[p].first]);
      profiles[p] = {};
    }
  }
  Samples(border, pieces, profiles, divided).grow(slope);
  return profiles;
}

namespace {

/// The integral of ds / h from the start to each sample: where the size is linear in the way, a logarithm.
std::vector<double> sums_of(const Profile& profile) {
  std::vector<double> sum{0.0};
  for (std::size_t i = 0; i + 1 < profile.s.size(); ++i) {
    const double way = profile.travelled[i + 1] - profile.travelled[i];
    const double h0 = profile.size[i], h1 = profile.size[i + 1];
    const double ratio = (h1 - h0) / h0;
    const double over = std::abs(ratio) < 1e-6 ? way / (0.5 * (h0 + h1)) : way * std::log1p(ratio) / (h1 - h0);
    sum.push_back(sum.back() + over);
  }
  return sum;
}

}  // namespace

void clear_tip(const BorderEdge& edge, const Profile& profile, std::vector<double>& parameters) {
  const Surface& surface = edge.space.surface();
  for (const bool at_end : {false, true}) {
    const double tip = at_end ? 1.0 : 0.0;
    if ((at_end ? parameters.back() : parameters.front()) != tip || edge.name != trim::artificial_border ||
        !ends_in_tip(edge, tip))
      continue;
    const double whole = edge.space.length(0.0, 1.0), looked = 0.1 * whole;
    const double s = edge.space.parameter_at(at_end ? whole - looked : looked);
    const auto bent = curvature(surface.jet(edge.space.place(s)));
    if (!bent) continue;
    const double sharpest = std::max(std::abs(bent->least), std::abs(bent->greatest));
    const double half_angle = std::atan(1.0 / (sharpest * looked));
    const double clear = first_way_from_tip(half_angle, at_end ? profile.size.back() : profile.size.front());
    std::erase_if(parameters, [&](double at) {
      const double way = edge.space.travelled(at);
      return at != 0.0 && at != 1.0 && (at_end ? whole - way : way) < clear;
    });
  }
}

double sides_wanted(const Profile& profile) { return sums_of(profile).back(); }

std::vector<double> even_parameters(const EdgeInSpace& edge, const Profile& profile, std::size_t least) {
  const std::vector<double> sum = sums_of(profile);
  constexpr double slack = 1e-6;  // of a side: an exact fit stays one
  const auto count = std::max(least, static_cast<std::size_t>(std::max(1.0, std::ceil(sum.back() - slack))));
  const double from = edge.travelled(profile.s.front());
  std::vector<double> parameters{profile.s.front()};
  for (std::size_t k = 1; k < count; ++k) {
    const double wanted = sum.back() * static_cast<double>(k) / static_cast<double>(count);
    const auto above = std::upper_bound(sum.begin(), sum.end(), wanted);
    const auto i = std::min<std::size_t>(static_cast<std::size_t>(above - sum.begin()), sum.size() - 1) - 1;
    const double h0 = profile.size[i], h1 = profile.size[i + 1];
    const double way = profile.travelled[i + 1] - profile.travelled[i];
    const double slope = (h1 - h0) / way, rest = wanted - sum[i];
    const double part = std::abs(slope * rest) < 1e-9 ? h0 * rest : h0 * std::expm1(slope * rest) / slope;
    parameters.push_back(edge.parameter_at(from + profile.travelled[i] + std::clamp(part, 0.0, way)));
  }
  parameters.push_back(profile.s.back());
  return parameters;
}

}  // namespace dobra::surf::mesh
