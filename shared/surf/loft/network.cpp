// 1. Nodes where two lines of the name meet; edges along the lines from node to node; ends that bound nothing go.
// 2. Faces on the map: at a node, the next edge clockwise. Its sides are the runs of edges of one section.
// 3. Four sides: Coons; three: the triangular patch.
#include "shared/surf/loft/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/geom/predicates.h"
#include "shared/surf/loft/loft.h"
#include "shared/surf/triangular_patch.h"

namespace dobra::surf::loft {

using geom::Point;
using geom::Point3;

namespace {

/// Edge e has the half-edges 2 e, along its section, and 2 e + 1.
struct Edge {
  std::size_t section = 0;
  std::size_t from = 0, to = 0;    // nodes
  std::vector<Point3> curve;       // between them
  Point next_to_from, next_to_to;  // on the map, where the trace goes on from the nodes
  bool alive = true;
};

Point map_of(Point3 p) { return {p.x, p.y}; }

bool upper(Point centre, Point p) { return p.y > centre.y || (p.y == centre.y && p.x > centre.x); }

class Network {
 public:
  Network(const std::vector<Section>& sections, const std::string& name, double size, std::vector<Finding>& findings)
      : sections_(sections), name_(name), size_(size), findings_(findings) {}

  /// Whether there are edges left.
  bool build(const std::vector<Mistie>& misties) {
    for (const Mistie& m : misties) {
      const std::size_t node = node_at(m.at);
      on_section_.resize(sections_.size());
      for (const std::size_t s : {m.first, m.second}) {
        auto& nodes = on_section_[s];
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
      }
    }
    for (std::size_t s = 0; s < on_section_.size(); ++s) {
      if (on_section_[s].size() > 1) add_edges(s);
    }
    prune();
    return std::any_of(edges_.begin(), edges_.end(), [](const Edge& e) { return e.alive; });
  }

  base::Result<std::vector<Patch>> patches(const ThroughOptions& options) {
    connect();
    std::vector<Patch> made;
    std::vector<bool> done(2 * edges_.size(), false);
    for (std::size_t h = 0; h < done.size(); ++h) {
      if (done[h] || !edges_[h / 2].alive) continue;
      std::vector<std::size_t> face;
      for (std::size_t at = h; !done[at]; at = next_[at]) done[at] = true, face.push_back(at);
      if (area(face) <= 0.0) continue;
      DOBRA_TRY_VOID(fill(face, options, made));
    }
    tell_ends();
    return made;
  }

 private:
  std::size_t node_at(Point3 p) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (geom::distance(map_of(nodes_[i]), map_of(p)) <= 1e-9 * size_) return i;
    }
    nodes_.push_back(p);
    return nodes_.size() - 1;
  }

  void add_edges(std::size_t s) {
    const Section& section = sections_[s];
    const auto of_name = std::find_if(section.lines.begin(), section.lines.end(),
                                      [&](const SectionLine& line) { return line.name == name_; });
    const geom::Polyline& line = of_name->line;
    std::vector<std::pair<double, std::size_t>> along;  // place in the line, node
    for (const std::size_t node : on_section_[s]) {
      double place = 0.0, least = INFINITY;
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double away = geom::distance(section.trace.in_space(line.points[i]), nodes_[node]);
        if (away < least) least = away, place = static_cast<double>(i);
      }
      nodes_[node] = section.trace.in_space(line.points[static_cast<std::size_t>(place)]);
      along.emplace_back(place, node);
    }
    std::sort(along.begin(), along.end());
    for (std::size_t k = 1; k < along.size(); ++k) {
      const auto first = static_cast<std::ptrdiff_t>(along[k - 1].first);
      const auto last = static_cast<std::ptrdiff_t>(along[k].first);
      if (first == last) continue;
      const geom::Polyline part{{line.points.begin() + first, line.points.begin() + last + 1}, false};
      Edge edge{s, along[k - 1].second, along[k].second, in_space(section.trace, part), {}, {}};
      edge.curve.front() = nodes_[edge.from];
      edge.curve.back() = nodes_[edge.to];
      edge.curve = without_twins(edge.curve, 1e-9 * size_);
      const double a = part.points.front().x, b = part.points.back().x;
      edge.next_to_from = after(section.trace, a, b);
      edge.next_to_to = after(section.trace, b, a);
      edges_.push_back(std::move(edge));
    }
    reach_.push_back({s, along.front().first, along.back().first});
  }
  /// The next corner of the trace from `from` on towards `to`, or that itself.
  static Point after(const PlanTrace& trace, double from, double to) {
    double next = to;
    for (const double corner : trace.distances()) {
      if ((corner - from) * (corner - next) < 0.0) next = corner;
    }
    return trace.on_map(next);
  }

  void prune() {
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<int> degree(nodes_.size(), 0);
      for (const Edge& e : edges_) {
        if (e.alive) ++degree[e.from], ++degree[e.to];
      }
      for (Edge& e : edges_) {
        if (e.alive && (degree[e.from] == 1 || degree[e.to] == 1)) e.alive = false, changed = true;
      }
    }
  }

  [[nodiscard]] std::size_t start(std::size_t h) const { return h % 2 == 0 ? edges_[h / 2].from : edges_[h / 2].to; }
  [[nodiscard]] std::size_t end(std::size_t h) const { return start(h ^ 1); }
  [[nodiscard]] Point towards(std::size_t h) const {
    return h % 2 == 0 ? edges_[h / 2].next_to_from : edges_[h / 2].next_to_to;
  }

  void connect() {
    std::vector<std::vector<std::size_t>> leaving(nodes_.size());
    for (std::size_t h = 0; h < 2 * edges_.size(); ++h) {
      if (edges_[h / 2].alive) leaving[start(h)].push_back(h);
    }
    next_.assign(2 * edges_.size(), 0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const Point centre = map_of(nodes_[n]);
      std::sort(leaving[n].begin(), leaving[n].end(), [&](std::size_t a, std::size_t b) {
        const bool up_a = upper(centre, towards(a)), up_b = upper(centre, towards(b));
        if (up_a != up_b) return up_a;
        return geom::orient2d(centre, towards(a), towards(b)) == geom::Sign::Positive;
      });
      const std::size_t count = leaving[n].size();
      for (std::size_t k = 0; k < count; ++k) next_[leaving[n][k] ^ 1] = leaving[n][(k + count - 1) % count];
    }
  }

  [[nodiscard]] std::vector<Point3> curve(std::size_t h) const {
    std::vector<Point3> points = edges_[h / 2].curve;
    if (h % 2 == 1) std::reverse(points.begin(), points.end());
    return points;
  }

  [[nodiscard]] double area(const std::vector<std::size_t>& face) const {
    double twice = 0.0;
    const Point origin = map_of(nodes_.front());
    for (const std::size_t h : face) {
      const auto points = curve(h);
      for (std::size_t i = 1; i < points.size(); ++i)
        twice += geom::cross(map_of(points[i - 1]) - origin, map_of(points[i]) - origin);
    }
    return 0.5 * twice;
  }

  /// The runs of half-edges of one section.
  [[nodiscard]] std::vector<std::vector<std::size_t>> sides_of(std::vector<std::size_t> face) const {
    const auto section = [&](std::size_t h) { return edges_[h / 2].section; };
    for (std::size_t turn = 0; turn < face.size() && section(face.front()) == section(face.back()); ++turn)
      std::rotate(face.begin(), face.begin() + 1, face.end());
    std::vector<std::vector<std::size_t>> sides;
    for (const std::size_t h : face) {
      if (sides.empty() || section(sides.back().back()) != section(h)) sides.emplace_back();
      sides.back().push_back(h);
    }
    return sides;
  }

  [[nodiscard]] std::vector<Point3> side_points(const std::vector<std::size_t>& side) const {
    std::vector<Point3> points;
    for (const std::size_t h : side) {
      const auto more = curve(h);
      points.insert(points.end(), more.begin() + (points.empty() ? 0 : 1), more.end());
    }
    return points;
  }

  /// Two sides across from each other, with vertices at common places: what rounding parts is one place.
  static base::Result<std::array<Curve, 2>> across(const std::vector<Point3>& a, const std::vector<Point3>& b) {
    DOBRA_TRY(const CommonBreaks common, common_breaks({a, b}));
    std::vector<double> knots{0.0};
    knots.insert(knots.end(), common.u.begin(), common.u.end());
    knots.push_back(1.0);
    DOBRA_TRY(Curve first, Curve::nurbs(1, knots, common.points[0]));
    DOBRA_TRY(Curve second, Curve::nurbs(1, knots, common.points[1]));
    return std::array<Curve, 2>{std::move(first), std::move(second)};
  }

  /// Of four sides, the last two of which run back, as Coons's patch has them, or of three.
  static base::Result<Surface> surface_of(const std::vector<std::vector<Point3>>& sides) {
    if (sides.size() == 4) {
      DOBRA_TRY(const auto along, across(sides[0], sides[2]));
      DOBRA_TRY(const auto up, across(sides[3], sides[1]));
      return Surface::coons(along[0], along[1], up[0], up[1]);
    }
    DOBRA_TRY(const Curve first, Curve::polyline(sides[0]));
    DOBRA_TRY(const Curve second, Curve::polyline(sides[1]));
    DOBRA_TRY(const Curve third, Curve::polyline(sides[2]));
    DOBRA_TRY(const TriangularPatch patch, TriangularPatch::make(first, second, third));
    return patch.surface();
  }

  base::Result<void> fill(const std::vector<std::size_t>& face, const ThroughOptions& options,
                          std::vector<Patch>& made) {
    const auto sides = sides_of(face);
    Point3 middle{};
    for (const std::size_t h : face) middle = middle + (nodes_[start(h)] - Point3{}) / static_cast<double>(face.size());
    const base::Place place{.item = name_, .x = middle.x, .y = middle.y, .z = middle.z};
    if (sides.size() != 3 && sides.size() != 4) {
      findings_.push_back({"cell_open",
                           fmt::format("'{}': the cell of {} sections stays open; three or four bound a patch, so a "
                                       "section across it would close it",
                                       name_, sides.size()),
                           place});
      return {};
    }
    std::vector<std::vector<Point3>> points;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      points.push_back(side_points(sides[k]));
      if (sides.size() == 4 && k >= 2) std::reverse(points.back().begin(), points.back().end());
    }
    auto surface = surface_of(points);
    if (!surface) {
      findings_.push_back({"no_patch", fmt::format("'{}': {}", name_, surface.error().message), place});
      return {};
    }
    // The patch of three sides has no breaks of its own: its lattice goes through the vertices of all of them.
    LatticeLines lines;
    if (sides.size() == 3) {
      lines.u = parts_of(points[0]);
      lines.v = parts_of(points[1]);
      for (const double part : parts_of(points[2])) lines.v.push_back(1.0 - part);
    }
    const auto rows = [&](std::size_t breaks) { return std::max<std::size_t>(1, 2 * options.rows / (breaks - 1)); };
    lines.rows_u = rows(surface->breaks().u.size() + lines.u.size());
    lines.rows_v = rows(surface->breaks().v.size() + lines.v.size());
    DOBRA_TRY(Patch patch, lattice(std::move(*surface), lines));
    for (const auto& side : sides) patch.sections.push_back(edges_[side.front() / 2].section);
    made.push_back(std::move(patch));
    return {};
  }
  static std::vector<double> parts_of(const std::vector<Point3>& side) {
    std::vector<double> parts{0.0};
    for (std::size_t i = 1; i < side.size(); ++i) parts.push_back(parts.back() + geom::distance(side[i - 1], side[i]));
    const double length = parts.back();
    for (double& part : parts) part /= length;
    return parts;
  }

  /// Lines that go on beyond the first or last node of a cell.
  void tell_ends() const {
    for (const Reach& reach : reach_) {
      const Section& section = sections_[reach.section];
      const auto of_name = std::find_if(section.lines.begin(), section.lines.end(),
                                        [&](const SectionLine& line) { return line.name == name_; });
      const auto points = in_space(section.trace, of_name->line);
      for (const Point3 end : {points.front(), points.back()}) {
        double least = INFINITY;
        for (const Point3 node : nodes_) least = std::min(least, geom::distance(node, end));
        if (least <= 1e-6 * size_) continue;
        findings_.push_back({"beyond_cells",
                             fmt::format("'{}' of section '{}' goes {:.6g} m beyond the last section that crosses it; "
                                         "no surface reaches there",
                                         name_, section.name, least),
                             {.item = name_, .x = end.x, .y = end.y, .z = end.z}});
      }
    }
  }

  struct Reach {
    std::size_t section;
    double first, last;
  };
  const std::vector<Section>& sections_;
  const std::string& name_;
  double size_;
  std::vector<Finding>& findings_;
  std::vector<Point3> nodes_;
  std::vector<std::vector<std::size_t>> on_section_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> next_;
  std::vector<Reach> reach_;
};

}  // namespace

base::Result<std::vector<Patch>> patches_between(const std::vector<Section>& sections, const std::string& name,
                                                 const std::vector<Mistie>& misties, const ThroughOptions& options,
                                                 double size, std::vector<Finding>& findings) {
  for (const Mistie& m : misties) {
    for (const std::size_t s : {m.first, m.second}) {
      const auto& lines = sections[s].lines;
      const auto count =
          std::count_if(lines.begin(), lines.end(), [&](const SectionLine& l) { return l.name == name; });
      if (count == 1) continue;
      findings.push_back({"pieces_cross",
                          fmt::format("'{}' is in {} pieces in section '{}', which crosses another; no patches between "
                                      "crossing sections are made of pieces",
                                      name, count, sections[s].name),
                          {.item = name, .x = m.at.x, .y = m.at.y, .z = m.at.z}});
      return std::vector<Patch>{};
    }
  }
  Network network(sections, name, size, findings);
  if (!network.build(misties)) return std::vector<Patch>{};
  return network.patches(options);
}

}  // namespace dobra::surf::loft
