#include "shared/surf/remesh/network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

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

/// Lines that are nearer than this part of the size are too near.
constexpr double narrow = 0.25;

/// Sets of lines.
enum : std::uint32_t { border_set, crease, cut_crease };

/// A node between the ends of a chain: on which of its half-edges, and at which part of it.
struct Division {
  std::size_t step = 0;
  double part = 0.0;
};

/// Points in cells of a grid.
class NearPoints {
 public:
  explicit NearPoints(double cell) : cell_(cell) {}
  void add(Point3 p, std::uint32_t part) { cells_[cell_of(p)].push_back({p, part}); }
  /// @pre distance is at most a cell
  [[nodiscard]] bool within(Point3 p, double distance, std::uint32_t part) const {
    const Cell at = cell_of(p);
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -1; j <= 1; ++j) {
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto found = cells_.find({at[0] + i, at[1] + j, at[2] + k});
          if (found == cells_.end()) continue;
          for (const auto& [q, of] : found->second) {
            if (of == part && geom::distance(p, q) < distance) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(Point3 p) const {
    const auto number = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    return {number(p.x), number(p.y), number(p.z)};
  }
  double cell_;
  std::map<Cell, std::vector<std::pair<Point3, std::uint32_t>>> cells_;
};

class Builder {
 public:
  Builder(const Atlas& atlas, const std::vector<double>& sizes, double corner, double crease, Creases creases,
          Tips tips)
      : atlas_(atlas),
        opened_(atlas.opened),
        sheet_(atlas.opened.sheet),
        sizes_(sizes),
        straightest_(std::cos(corner * std::numbers::pi / 180.0)),
        creases_(creases),
        keep_tips_(tips == Tips::Stay),
        out_(sheet_.points.size(), no_half_edge),
        stays_(atlas.before.points.size(), false) {
    for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
      if (sheet_.twins[h] == no_half_edge) out_[sheet_.start(h)] = h;
    }
    find_creases(atlas.before, crease);
    find_stays();
    find_tips(corner);
  }

  Network run() {
    // At most as often as makes a side of each of the sheet's.
    constexpr int rounds = 8;
    for (int round = 0;; ++round) {
      build();
      if (!divide_more() || round == rounds) break;
    }
    return std::move(made_);
  }

 private:
  /// The line, and which of its sides.
  using SideOfLine = std::pair<HalfEdge, std::ptrdiff_t>;

  void build() {
    made_ = {};
    sides_.clear(), point_.clear(), node_of_vertex_.clear(), cut_nodes_.clear(), joined_.clear();
    made_.parts.resize(atlas_.parts.size());
    sides_.resize(made_.parts.size());
    for (Network::Part& part : made_.parts) {
      part.chart.sets = {{"", dobra::mesh::delaunay::EdgeKind::Boundary},
                         {"crease", dobra::mesh::delaunay::EdgeKind::Constraint},
                         {"cut crease", dobra::mesh::delaunay::EdgeKind::Boundary}};
    }
    for (const auto& vertices : sheet_.loops) {
      for (const Chain& chain : border_chains(vertices)) {
        add(chain, cut_folded_[chain.front()] ? cut_crease : border_set);
        if (cut_folded_[chain.front()] && chain.front() < opened_.across[chain.back()]) ++made_.cut_creases;
      }
    }
    for (const Chain& chain : crease_chains()) {
      add(chain, crease);
      ++made_.creases;
    }
    made_.creases += made_.cut_creases;
    add_tips();
  }

  /// Sides that cross are halved. @return there are some
  bool divide_more() {
    std::set<SideOfLine> crossing;
    for (std::size_t p = 0; p < made_.parts.size(); ++p) {
      const auto& chart = made_.parts[p].chart;
      std::vector<geom::Box> boxes(chart.edges.size());
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const NodeId node : chart.edges[i].nodes) boxes[i].add(chart.points[node.index()]);
      }
      const auto segment = [&](std::size_t i) {
        const auto& nodes = chart.edges[i].nodes;
        return geom::Segment{chart.points[nodes[0].index()], chart.points[nodes[1].index()]};
      };
      for (const auto& [i, j] : geom::SpatialIndex(boxes).overlapping_pairs()) {
        const auto& a = chart.edges[i].nodes;
        const auto& b = chart.edges[j].nodes;
        const bool beside = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
        const auto meeting = geom::intersect(segment(i), segment(j)).kind;
        if (meeting == geom::IntersectionKind::None || (beside && meeting != geom::IntersectionKind::Overlap)) continue;
        crossing.insert({sides_[p][i], sides_[p][j]});
      }
    }
    // From the last side of a line, so that the numbers of those before it stand.
    for (auto side = crossing.rbegin(); side != crossing.rend(); ++side) {
      std::vector<double>& ends = ends_[side->first];
      ends.insert(ends.begin() + side->second + 1, 0.5 * (ends[side->second] + ends[side->second + 1]));
    }
    return !crossing.empty();
  }
  /// By which a line is known from both sides of a cut.
  [[nodiscard]] HalfEdge name_of(const Chain& chain) const {
    const HalfEdge across = opened_.across[chain.back()];
    return across == no_half_edge ? chain.front() : std::min(chain.front(), across);
  }

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
    std::vector<HalfEdge> loop;
    for (const std::uint32_t v : vertices) loop.push_back(out_[v]);
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
    std::vector<std::uint32_t>& folds = folds_at_;
    folds.assign(sheet_.points.size(), 0);
    for (HalfEdge h = 0; h < folded_.size(); ++h) {
      if (folded_[h]) ++folds[sheet_.start(h)];
    }
    for (std::size_t v = 0; v < folds.size(); ++v) {
      if (on_border[v] && folds[v] > 0) ++folds[v];  // the border is a line too
      if (folds[v] > 0 && (folds[v] != 2 || on_border[v])) stays_[origin(static_cast<std::uint32_t>(v))] = true;
    }
    // A loop has two at least. They are chosen before any line is made, as another part may have the same loop.
    for (const auto& vertices : sheet_.loops) {
      std::size_t count = 0;
      for (const std::uint32_t v : vertices) count += stays_[origin(v)] ? 1 : 0;
      if (count == 0) stays_[origin(vertices[0])] = true;
      if (count == 0) stays_[origin(vertices[vertices.size() / 2])] = true;
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

  /// Vertices at which the sheet comes to a tip, the sharpest first.
  void find_tips(double corner) {
    constexpr double full = 2.0 * std::numbers::pi;
    std::vector<double> sums(stays_.size(), 0.0);
    std::vector<bool> on_border(stays_.size(), false);
    for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
      const Vector3 a = along(h), b = sheet_.points[sheet_.start(param::previous(h))] - sheet_.points[sheet_.start(h)];
      sums[origin(sheet_.start(h))] += std::atan2(geom::length(cross(a, b)), dot(a, b));
      if (sheet_.twins[h] != no_half_edge || opened_.across[h] != no_half_edge) continue;
      on_border[origin(sheet_.start(h))] = on_border[origin(sheet_.end(h))] = true;
    }
    std::vector<std::vector<std::uint32_t>> beside;
    for (std::uint32_t v = 0; v < sums.size(); ++v) {
      if (on_border[v] || std::abs(full - sums[v]) <= corner * std::numbers::pi / 180.0) continue;
      if (beside.empty()) beside = neighbours(atlas_.before);
      if (stands_off(v, beside)) tips_.push_back(v);
    }
    std::stable_sort(tips_.begin(), tips_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::abs(full - sums[a]) > std::abs(full - sums[b]);
    });
    tip_.assign(stays_.size(), false);
    for (const std::uint32_t v : tips_) tip_[v] = true;
    // A cut through one has a node there.
    for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
      const std::uint32_t v = origin(sheet_.start(h));
      if (sheet_.twins[h] == no_half_edge && tip_[v]) stays_[v] = true;
    }
  }
  static std::vector<std::vector<std::uint32_t>> neighbours(const Sheet& sheet) {
    std::vector<std::vector<std::uint32_t>> beside(sheet.points.size());
    for (HalfEdge h = 0; h < sheet.twins.size(); ++h) beside[sheet.start(h)].push_back(sheet.end(h));
    return beside;
  }
  /// From the vertices of the sheet that are first half a side off, or else its neighbours.
  [[nodiscard]] bool stands_off(std::uint32_t tip, const std::vector<std::vector<std::uint32_t>>& beside) const {
    constexpr double steep = 0.4, part = 0.5;
    const std::vector<Point3>& points = atlas_.before.points;
    std::vector<std::uint32_t> todo{tip};
    std::set<std::uint32_t> seen{tip};
    Vector3 sum{};
    double distance = 0.0, count = 0.0;
    for (std::size_t i = 0; i < todo.size(); ++i) {
      for (const std::uint32_t w : beside[todo[i]]) {
        if (!seen.insert(w).second) continue;
        const Vector3 off = points[w] - points[tip];
        if (geom::length(off) < part * sizes_[tip]) {
          todo.push_back(w);
        } else {
          sum = sum + off;
          distance += geom::length(off);
          count += 1.0;
        }
      }
    }
    return count > 0.0 && geom::length(sum) >= steep * distance;
  }

  /// Of tips near each other the sharper one, and none near a line.
  void add_tips() {
    constexpr double apart = 0.5;
    NearPoints near(apart * *std::max_element(sizes_.begin(), sizes_.end()));
    std::map<std::uint32_t, std::uint32_t> own;  // the vertex of the chart, of those off the cut
    for (std::uint32_t v = 0; v < sheet_.points.size(); ++v) {
      if (!tips_.empty() && tip_[origin(v)]) own[origin(v)] = v;
    }
    for (std::size_t p = 0; p < made_.parts.size() && !tips_.empty(); ++p) {
      for (const auto& edge : made_.parts[p].chart.edges) {
        const Point3 a = made_.parts[p].at[edge.nodes[0].index()], b = made_.parts[p].at[edge.nodes[1].index()];
        for (const double t : {0.0, 0.25, 0.5, 0.75}) near.add(a + t * (b - a), static_cast<std::uint32_t>(p));
      }
    }
    for (const std::uint32_t v : tips_) {
      const std::uint32_t of_chart = own.at(v);
      const Point3 at = sheet_.points[of_chart];
      const bool on_line = point_.contains(of_chart);  // one ends there, or a cut
      if (!keep_tips_ || (!on_line && near.within(at, apart * sizes_[v], atlas_.part[of_chart]))) {
        ++made_.tips_out;
        made_.tip_at = at;
        continue;
      }
      near.add(at, atlas_.part[of_chart]);
      ++made_.tips;
      part_of(of_chart).chart.node_sets["tips"].emplace_back(point_of(of_chart));
    }
  }

  /// A loop between vertices that stay.
  std::vector<Chain> border_chains(const std::vector<std::uint32_t>& vertices) {
    std::vector<HalfEdge> loop = border(vertices);
    const auto begins = [&](std::size_t i) { return stays_[origin(sheet_.start(loop[i]))]; };
    std::size_t first = 0;
    while (!begins(first)) ++first;
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
    std::erase_if(chains, [&](const Chain& chain) {
      if (!loose(chain)) return false;
      ++made_.loose;
      made_.loose_at = sheet_.points[sheet_.start(chain.front())];
      return true;
    });
    if (creases_ == Creases::Clear) leave_out_narrow(chains);
    return chains;
  }

  /// Of two lines with much less than a side between them one is kept: that of the border, or the longer one.
  void leave_out_narrow(std::vector<Chain>& chains) {
    const auto length = [&](const Chain& chain) {
      double sum = 0.0;
      for (const HalfEdge h : chain) sum += geom::length(along(h));
      return sum;
    };
    std::stable_sort(chains.begin(), chains.end(),
                     [&](const Chain& a, const Chain& b) { return length(a) > length(b); });
    NearPoints near(narrow * *std::max_element(sizes_.begin(), sizes_.end()));
    for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
      if (sheet_.twins[h] == no_half_edge) add_samples({h}, near);
    }
    std::erase_if(chains, [&](const Chain& chain) {
      if (is_narrow(chain, near)) {
        ++made_.narrow;
        made_.narrow_at = sheet_.points[sheet_.start(chain.front())];
        return true;
      }
      add_samples(chain, near);
      return false;
    });
  }
  template <class Visit>
  void for_each_sample(const Chain& chain, Visit&& visit) const {
    double before = 0.0;
    for (const HalfEdge h : chain) {
      const double side = geom::length(along(h)), size = sizes_[origin(sheet_.start(h))];
      const double count = std::ceil(2.0 * side / (narrow * size));
      for (double k = 0.5; k < count; k += 1.0)
        visit(sheet_.points[sheet_.start(h)] + k / count * along(h), before + k / count * side, size);
      before += side;
    }
  }
  void add_samples(const Chain& chain, NearPoints& near) const {
    for_each_sample(chain, [&](Point3 p, double, double) { near.add(p, atlas_.part[sheet_.start(chain[0])]); });
  }
  /// Most of it, but for its ends, where other lines begin.
  [[nodiscard]] bool is_narrow(const Chain& chain, const NearPoints& near) const {
    constexpr double ends = 0.4;  // of the size
    double length = 0.0;
    for (const HalfEdge h : chain) length += geom::length(along(h));
    std::size_t all = 0, beside = 0;
    for_each_sample(chain, [&](Point3 p, double from, double size) {
      if (std::min(from, length - from) < ends * size) return;
      ++all;
      if (near.within(p, narrow * size, atlas_.part[sheet_.start(chain[0])])) ++beside;
    });
    return 2 * beside > all;
  }
  /// The next half-edge from the same vertex, clockwise.
  [[nodiscard]] HalfEdge turned(HalfEdge h) const {
    const HalfEdge twin = sheet_.twins[h];
    return twin == no_half_edge ? no_half_edge : param::next(twin);
  }
  /// Shorter than a side of the new mesh; where all are kept, with an end that no other line meets.
  [[nodiscard]] bool loose(const Chain& chain) const {
    const bool ends = folds_at_[sheet_.start(chain.front())] == 1 || folds_at_[sheet_.end(chain.back())] == 1;
    if (creases_ == Creases::All && !ends) return false;
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
    std::vector<double>& ends = ends_[name_of(chain)];
    if (ends.empty()) {
      for (double k = 0.0; k <= count; k += 1.0) ends.push_back(k / count * sum.back());
    }
    std::vector<Division> made;
    std::size_t step = 0;
    for (std::size_t k = 1; k + 1 < ends.size(); ++k) {
      while (step + 1 < chain.size() && sum[step + 1] < ends[k]) ++step;
      made.push_back({step, (ends[k] - sum[step]) / (sum[step + 1] - sum[step])});
    }
    return made;
  }

  [[nodiscard]] Network::Part& part_of(std::uint32_t vertex) { return made_.parts[atlas_.part[vertex]]; }
  std::uint32_t point_of(std::uint32_t vertex) {
    Network::Part& part = part_of(vertex);
    const auto [found, fresh] = point_.try_emplace(vertex, static_cast<std::uint32_t>(part.at.size()));
    if (!fresh) return found->second;
    const auto [node, first] = node_of_vertex_.try_emplace(origin(vertex), made_.nodes);
    if (first) ++made_.nodes;
    return push(part, atlas_.uv[vertex], sheet_.points[vertex], node->second);
  }
  static std::uint32_t push(Network::Part& part, Point uv, Point3 at, std::uint32_t node) {
    part.chart.points.push_back(uv);
    part.at.push_back(at);
    part.node.push_back(node);
    return static_cast<std::uint32_t>(part.at.size() - 1);
  }

  void add(const Chain& chain, std::uint32_t set) {
    const HalfEdge across = opened_.across[chain.front()];
    std::vector<Division> between;
    std::vector<std::uint32_t> nodes;
    const auto other = across == no_half_edge ? cut_nodes_.end() : cut_nodes_.find(across);
    const bool again = other != cut_nodes_.end();
    if (again) {
      nodes.assign(other->second.nodes.rbegin(), other->second.nodes.rend());
      for (auto d = other->second.between.rbegin(); d != other->second.between.rend(); ++d)
        between.push_back({chain.size() - 1 - d->step, 1.0 - d->part});
    } else {
      between = divide(chain);
      for (std::size_t i = 0; i < between.size(); ++i) nodes.push_back(made_.nodes++);
      if (across != no_half_edge) cut_nodes_[chain.back()] = {nodes, between};
    }
    const std::uint32_t number = atlas_.part[sheet_.start(chain.front())];
    const HalfEdge name = name_of(chain);
    Network::Part& part = made_.parts[number];
    std::uint32_t last = point_of(sheet_.start(chain.front()));
    const auto last_side = static_cast<std::ptrdiff_t>(between.size());
    std::ptrdiff_t done = 0;
    const auto side = [&](std::uint32_t to) {
      part.chart.edges.push_back({{NodeId(last), NodeId(to)}, set});
      sides_[number].emplace_back(name, again ? last_side - done : done);
      ++done;
      last = to;
    };
    for (std::size_t i = 0; i < between.size(); ++i) {
      const HalfEdge h = chain[between[i].step];
      const std::uint32_t a = sheet_.start(h), b = sheet_.end(h);
      side(push(part, geom::interpolate(atlas_.uv[a], atlas_.uv[b], between[i].part),
                sheet_.points[a] + between[i].part * (sheet_.points[b] - sheet_.points[a]), nodes[i]));
    }
    side(point_of(sheet_.end(chain.back())));
  }

  struct CutNodes {
    std::vector<std::uint32_t> nodes;
    std::vector<Division> between;
  };
  const Atlas& atlas_;
  const param::Opened& opened_;
  const Sheet& sheet_;
  const std::vector<double>& sizes_;
  const double straightest_;
  const Creases creases_;
  const bool keep_tips_;
  std::vector<HalfEdge> out_;                                 ///< The half-edge of the border that starts in a point.
  std::vector<bool> stays_;                                   ///< One a point before the cut.
  std::set<std::pair<std::uint32_t, std::uint32_t>> joined_;  ///< Ends of the chains so far.
  std::vector<std::uint32_t> folds_at_;                       ///< One a point: lines at which it folds that meet.
  std::vector<bool> folded_;                                  ///< One a half-edge: a crease.
  std::vector<bool> cut_folded_;                              ///< One a half-edge: a crease that was cut.
  std::vector<std::uint32_t> tips_;                           ///< Before the cut; the sharpest first.
  std::vector<bool> tip_;                                     ///< One a point before the cut.
  std::map<std::uint32_t, std::uint32_t> point_, node_of_vertex_;
  std::map<HalfEdge, CutNodes>
      cut_nodes_;  ///< By the last half-edge of a chain, which is across the first of its other side.
  std::map<HalfEdge, std::vector<double>> ends_;  ///< Of the sides of a line, both ends included.
  std::vector<std::vector<SideOfLine>> sides_;    ///< One an edge of a part.
  Network made_;
};

}  // namespace

Network divide_network(const Atlas& atlas, const std::vector<double>& sizes, double corner, double crease,
                       Creases creases, Tips tips) {
  return Builder(atlas, sizes, corner, crease, creases, tips).run();
}

}  // namespace dobra::surf::remesh
