#include "shared/surf/remesh/network.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace dobra::surf::remesh {

using dobra::mesh::NodeId;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using param::HalfEdge;
using param::no_half_edge;
using param::Sheet;

namespace {

/// Half-edges that follow each other, between vertices that stay.
using Chain = std::vector<HalfEdge>;

/// A node between the ends of a chain: on which of its half-edges, and at which part of it.
struct Division {
  std::size_t step = 0;
  double part = 0.0;
};

class Builder {
 public:
  Builder(const Charted& charted, const std::vector<double>& sizes, double corner, double crease)
      : opened_(charted.opened),
        sheet_(charted.opened.sheet),
        uv_(charted.parametrisation.uv),
        sizes_(sizes),
        straightest_(std::cos(corner * std::numbers::pi / 180.0)),
        stays_(charted.before.points.size(), false) {
    find_creases(charted.before, crease);
    find_stays();
  }

  Network run() {
    made_.chart.sets = {{"", dobra::mesh::delaunay::EdgeKind::Boundary},
                        {"crease", dobra::mesh::delaunay::EdgeKind::Constraint}};
    for (const auto& vertices : sheet_.loops) {
      for (const Chain& chain : border_chains(vertices)) {
        add(chain, 0);
        if (cut_folded_[chain.front()] && chain.front() < opened_.across[chain.back()]) ++made_.cut_creases;
      }
    }
    for (const Chain& chain : crease_chains()) {
      add(chain, 1);
      ++made_.creases;
    }
    made_.creases += made_.cut_creases;
    return std::move(made_);
  }

 private:
  [[nodiscard]] std::uint32_t origin(std::uint32_t v) const { return opened_.origin[v]; }
  [[nodiscard]] Vector3 along(HalfEdge h) const {
    return sheet_.points[sheet_.end(h)] - sheet_.points[sheet_.start(h)];
  }
  [[nodiscard]] bool turns(HalfEdge before, HalfEdge after) const {
    const Vector3 a = along(before), b = along(after);
    return dot(a, b) <= straightest_ * geom::length(a) * geom::length(b);
  }

  /// Where the sheet folds, within and across the cut: the numbers of half-edges are those before the cut.
  void find_creases(const Sheet& before, double degrees) {
    folded_.assign(sheet_.twins.size(), false);
    cut_folded_.assign(sheet_.twins.size(), false);
    if (!(degrees < 180.0)) return;
    const std::vector<bool> folded = param::creases_of(before, degrees);
    for (HalfEdge h = 0; h < folded.size(); ++h) {
      if (sheet_.twins[h] != no_half_edge)
        folded_[h] = folded[h];
      else
        cut_folded_[h] = folded[h];
    }
  }

  /// A loop of the border as half-edges in their order.
  [[nodiscard]] std::vector<HalfEdge> border(const std::vector<std::uint32_t>& vertices) const {
    std::vector<HalfEdge> out(sheet_.points.size(), no_half_edge), loop;
    for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
      if (sheet_.twins[h] == no_half_edge) out[sheet_.start(h)] = h;
    }
    for (const std::uint32_t v : vertices) loop.push_back(out[v]);
    return loop;
  }

  void find_stays() {
    std::vector<std::uint32_t> cuts(stays_.size(), 0);  // sides of a cut at each vertex, each seen from both sides
    std::vector<bool> on_border(sheet_.points.size(), false);
    for (const auto& vertices : sheet_.loops) {
      const std::vector<HalfEdge> loop = border(vertices);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const HalfEdge before = loop[(i + loop.size() - 1) % loop.size()], after = loop[i];
        const bool cut_before = opened_.across[before] != no_half_edge,
                   cut_after = opened_.across[after] != no_half_edge;
        const std::uint32_t v = origin(sheet_.start(after));
        on_border[sheet_.start(after)] = true;
        if (cut_before != cut_after || (!cut_before && turns(before, after))) stays_[v] = true;
        // Where the cut leaves a crease, and where the crease that it runs along turns.
        if (cut_folded_[before] != cut_folded_[after] || (cut_folded_[after] && turns(before, after))) stays_[v] = true;
        if (cut_after) ++cuts[v], ++cuts[origin(sheet_.end(after))];
      }
    }
    for (std::size_t v = 0; v < cuts.size(); ++v) {
      if (cuts[v] != 0 && cuts[v] != 4) stays_[v] = true;
    }
    std::vector<std::uint32_t> folds(sheet_.points.size(), 0);
    for (HalfEdge h = 0; h < folded_.size(); ++h) {
      if (folded_[h]) ++folds[sheet_.start(h)];
    }
    for (std::size_t v = 0; v < folds.size(); ++v) {
      if (folds[v] > 0 && (folds[v] != 2 || on_border[v])) stays_[origin(static_cast<std::uint32_t>(v))] = true;
    }
    // A line that turns sharply keeps its corner.
    std::vector<HalfEdge> first(sheet_.points.size(), no_half_edge);
    for (HalfEdge h = 0; h < folded_.size(); ++h) {
      if (!folded_[h] || folds[sheet_.start(h)] != 2) continue;
      HalfEdge& other = first[sheet_.start(h)];
      if (other == no_half_edge)
        other = h;
      else if (turns(sheet_.twins[other], h))
        stays_[origin(sheet_.start(h))] = true;
    }
  }

  /// A loop between vertices that stay; of one without any, two pieces.
  std::vector<Chain> border_chains(const std::vector<std::uint32_t>& vertices) {
    std::vector<HalfEdge> loop = border(vertices);
    const auto begins = [&](std::size_t i) { return stays_[origin(sheet_.start(loop[i]))]; };
    std::size_t first = 0;
    while (first < loop.size() && !begins(first)) ++first;
    if (first == loop.size()) {
      stays_[origin(sheet_.start(loop[0]))] = true;
      stays_[origin(sheet_.start(loop[loop.size() / 2]))] = true;
      first = 0;
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    std::vector<Chain> chains;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (begins(i)) chains.emplace_back();
      chains.back().push_back(loop[i]);
    }
    return chains;
  }

  std::vector<Chain> crease_chains() {
    std::vector<Chain> chains;
    std::vector<bool> seen(folded_.size(), false);
    const auto follow = [&](HalfEdge begin) {
      Chain chain;
      for (HalfEdge h = begin;;) {
        chain.push_back(h);
        seen[h] = seen[sheet_.twins[h]] = true;
        const std::uint32_t end = sheet_.end(h);
        if (stays_[origin(end)]) break;
        HalfEdge onward = no_half_edge;
        for (HalfEdge k = param::next(h); k != sheet_.twins[h] && k != no_half_edge; k = turned(k)) {
          if (folded_[k]) onward = k;
        }
        if (onward == no_half_edge || seen[onward]) break;
        h = onward;
      }
      chains.push_back(std::move(chain));
    };
    for (HalfEdge h = 0; h < folded_.size(); ++h) {
      if (folded_[h] && !seen[h] && stays_[origin(sheet_.start(h))]) follow(h);
    }
    for (HalfEdge h = 0; h < folded_.size(); ++h) {
      if (!folded_[h] || seen[h]) continue;
      stays_[origin(sheet_.start(h))] = true;  // a closed crease
      follow(h);
    }
    std::erase_if(chains, [&](const Chain& chain) { return loose(chain); });
    return chains;
  }
  /// The next half-edge from the same vertex, clockwise.
  [[nodiscard]] HalfEdge turned(HalfEdge h) const {
    const HalfEdge twin = sheet_.twins[h];
    return twin == no_half_edge ? no_half_edge : param::next(twin);
  }
  /// Shorter than a side of the new mesh.
  [[nodiscard]] bool loose(const Chain& chain) const {
    double length = 0.0;
    for (const HalfEdge h : chain) length += geom::length(along(h));
    return length < sizes_[origin(sheet_.start(chain[0]))];
  }
  /// About as many sides as the sizes say; enough that no two sides of the mesh have the same ends.
  std::vector<Division> divide(const Chain& chain) {
    std::vector<double> sum{0.0};
    for (const HalfEdge h : chain) {
      const double size = 0.5 * (sizes_[origin(sheet_.start(h))] + sizes_[origin(sheet_.end(h))]);
      sum.push_back(sum.back() + geom::length(along(h)) / size);
    }
    const std::uint32_t from = origin(sheet_.start(chain.front())), to = origin(sheet_.end(chain.back()));
    const bool again = !joined_.insert(std::minmax(from, to)).second;
    const double least = from == to ? 3.0 : again ? 2.0 : 1.0;
    const double count = std::max(least, std::round(sum.back()));
    std::vector<Division> made;
    std::size_t step = 0;
    for (double k = 1.0; k < count; k += 1.0) {
      const double wanted = k / count * sum.back();
      while (step + 1 < chain.size() && sum[step + 1] < wanted) ++step;
      made.push_back({step, (wanted - sum[step]) / (sum[step + 1] - sum[step])});
    }
    return made;
  }

  std::uint32_t point_of(std::uint32_t vertex) {
    const auto [found, fresh] = point_.try_emplace(vertex, static_cast<std::uint32_t>(made_.at.size()));
    if (!fresh) return found->second;
    const auto [node, first] = node_of_vertex_.try_emplace(origin(vertex), made_.nodes);
    if (first) ++made_.nodes;
    return push(uv_[vertex], sheet_.points[vertex], node->second);
  }
  std::uint32_t push(Point uv, Point3 at, std::uint32_t node) {
    made_.chart.points.push_back(uv);
    made_.at.push_back(at);
    made_.node.push_back(node);
    return static_cast<std::uint32_t>(made_.at.size() - 1);
  }

  void add(const Chain& chain, std::uint32_t set) {
    const HalfEdge across = set == 0 ? opened_.across[chain.front()] : no_half_edge;
    std::vector<Division> between;
    std::vector<std::uint32_t> nodes;
    if (const auto other = across == no_half_edge ? cut_nodes_.end() : cut_nodes_.find(across);
        other != cut_nodes_.end()) {
      nodes.assign(other->second.nodes.rbegin(), other->second.nodes.rend());
      for (auto d = other->second.between.rbegin(); d != other->second.between.rend(); ++d)
        between.push_back({chain.size() - 1 - d->step, 1.0 - d->part});
    } else {
      between = divide(chain);
      for (std::size_t i = 0; i < between.size(); ++i) nodes.push_back(made_.nodes++);
      if (across != no_half_edge) cut_nodes_[chain.back()] = {nodes, between};
    }
    std::uint32_t last = point_of(sheet_.start(chain.front()));
    const auto side = [&](std::uint32_t to) {
      made_.chart.edges.push_back({{NodeId(last), NodeId(to)}, set});
      last = to;
    };
    for (std::size_t i = 0; i < between.size(); ++i) {
      const HalfEdge h = chain[between[i].step];
      const std::uint32_t a = sheet_.start(h), b = sheet_.end(h);
      side(push(geom::interpolate(uv_[a], uv_[b], between[i].part),
                sheet_.points[a] + between[i].part * (sheet_.points[b] - sheet_.points[a]), nodes[i]));
    }
    side(point_of(sheet_.end(chain.back())));
  }

  struct CutNodes {
    std::vector<std::uint32_t> nodes;
    std::vector<Division> between;
  };
  const param::Opened& opened_;
  const Sheet& sheet_;
  const std::vector<Point>& uv_;
  const std::vector<double>& sizes_;
  const double straightest_;
  std::vector<bool> stays_;                                   ///< One a point before the cut.
  std::set<std::pair<std::uint32_t, std::uint32_t>> joined_;  ///< Ends of the chains so far.
  std::vector<bool> folded_;                                  ///< One a half-edge: a crease.
  std::vector<bool> cut_folded_;                              ///< One a half-edge: a crease that was cut.
  std::map<std::uint32_t, std::uint32_t> point_, node_of_vertex_;
  std::map<HalfEdge, CutNodes>
      cut_nodes_;  ///< By the last half-edge of a chain, which is across the first of its other side.
  Network made_;
};

}  // namespace

Network divide_network(const Charted& charted, const std::vector<double>& sizes, double corner, double crease) {
  return Builder(charted, sizes, corner, crease).run();
}

}  // namespace dobra::surf::remesh
