#include "shared/fem/error/recover.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "shared/base/parallel.h"
#include "shared/fem/stress.h"
#include "shared/geom/intersect.h"

namespace dobra::fem::error {
namespace {

using geom::Point;
using geom::Vector;
using mesh::ElementMesh;

constexpr std::size_t grain = 64;
constexpr int most_growth = 4;
/// A fit through barely as many samples as terms follows their errors: at least this many times the terms.
constexpr double enough_samples = 1.4;
/// Samples count by 1 / (this + r)^3 at a distance of r times the patch's size: a patch that grew from the boundary
/// follows what is near its vertex, not the steep field behind it. Chosen for effectivities of Kirsch's plate and of
/// the L.
constexpr double weight_floor = 0.2;

/// One vertex as seen from one region and one fan of elements round it.
struct Patch {
  std::size_t vertex = 0;
  std::vector<std::uint32_t> elements;  ///< That take their value at the vertex from this patch.
  bool interior = false;                ///< The elements surround the vertex.
};

/// Where the samples of an element are, and their stresses.
struct Samples {
  std::vector<std::size_t> first;
  std::vector<Point> points;
  std::vector<Voigt> stresses;
};

class Recovery {
 public:
  Recovery(const ElementMesh& mesh, const Materials& materials, std::span<const Vector> u)
      : mesh_(mesh), neighbours_(neighbours_of(mesh)), first_side_(mesh.element_count() + 1, 0) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e)
      first_side_[e + 1] = first_side_[e] + mesh::corner_count(mesh.types[e]);
    sample(materials, u);
    find_patches();
  }
  RecoveredStress run();

 private:
  void sample(const Materials& materials, std::span<const Vector> u);
  void find_patches();
  [[nodiscard]] std::size_t neighbour(std::size_t element, std::size_t side) const;
  [[nodiscard]] Basis basis_of(std::span<const std::uint32_t> elements) const;
  [[nodiscard]] std::vector<std::uint32_t> grown(const Patch& patch, const std::vector<std::uint32_t>& elements) const;
  [[nodiscard]] bool visible(std::size_t vertex, std::size_t element, std::span<const std::uint32_t> elements) const;

  /// What a patch gives: values at its vertex and at the mid-sides of its elements that end in the vertex.
  struct Fitted {
    std::vector<Voigt> values;  ///< For the vertex, then for each element of the patch its two mid-sides.
    bool grown = false;
    bool degraded = false;
  };
  [[nodiscard]] Fitted fit(const Patch& patch) const;

  static constexpr std::size_t none = ~std::size_t{0};
  const ElementMesh& mesh_;
  std::vector<mesh::ElementSide> neighbours_;
  std::vector<std::size_t> first_side_;
  Samples samples_;
  std::vector<Patch> patches_;
};

void Recovery::sample(const Materials& materials, std::span<const Vector> u) {
  samples_.first.assign(mesh_.element_count() + 1, 0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e)
    samples_.first[e + 1] = samples_.first[e] + integration_points(mesh_.types[e], Rule::Sample).size();
  samples_.points.resize(samples_.first.back());
  samples_.stresses.resize(samples_.first.back());
  base::parallel_for(
      mesh_.element_count(),
      [&](std::size_t e) {
        const ElementGeometry element = geometry_of(mesh_, e);
        const ElementSolution solution(element, materials.at(mesh_.regions[e]), u);
        const auto shapes = shapes_at(element.type, Rule::Sample);
        for (std::size_t g = 0; g < shapes.size(); ++g) {
          const Mapped m = map(element.points(), shapes[g]);
          samples_.points[samples_.first[e] + g] = m.at;
          samples_.stresses[samples_.first[e] + g] = solution.stress(m);
        }
      },
      grain);
}

/// The element across a side if it is of the same region.
std::size_t Recovery::neighbour(std::size_t element, std::size_t side) const {
  const mesh::ElementId other = neighbours_[first_side_[element] + side].element;
  return other.valid() && mesh_.regions[other.index()] == mesh_.regions[element] ? other.index() : none;
}

void Recovery::find_patches() {
  // Corners by vertex; those of a vertex that reach each other over sides within a region are one patch.
  std::vector<std::vector<std::uint32_t>> stars(mesh_.points.size());
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const auto nodes = mesh_.nodes_of(mesh::ElementId(e));
    for (std::size_t i = 0; i < mesh::corner_count(mesh_.types[e]); ++i)
      stars[nodes[i].index()].push_back(static_cast<std::uint32_t>(e));
  }
  for (std::size_t vertex = 0; vertex < stars.size(); ++vertex) {
    std::vector<std::uint32_t> left = stars[vertex];
    while (!left.empty()) {
      Patch patch{vertex, {left.front()}, true};
      left.erase(left.begin());
      for (std::size_t k = 0; k < patch.elements.size(); ++k) {
        const std::size_t e = patch.elements[k];
        const auto nodes = mesh_.nodes_of(mesh::ElementId(e));
        const std::size_t corners = mesh::corner_count(mesh_.types[e]);
        std::size_t i = 0;
        while (nodes[i].index() != vertex) ++i;
        for (const std::size_t side : {i, (i + corners - 1) % corners}) {
          const std::size_t other = neighbour(e, side);
          if (other == none) patch.interior = false;
          const auto found = std::find(left.begin(), left.end(), other);
          if (found == left.end()) continue;
          patch.elements.push_back(*found);
          left.erase(found);
        }
      }
      std::sort(patch.elements.begin(), patch.elements.end());
      patches_.push_back(std::move(patch));
    }
  }
}

Basis Recovery::basis_of(std::span<const std::uint32_t> elements) const {
  const auto all = [&](auto&& is) {
    return std::all_of(elements.begin(), elements.end(), [&](auto e) { return is(mesh_.types[e]); });
  };
  if (all([](ElementType t) { return t == ElementType::Q8; })) return Basis::Serendipity;
  if (all([](ElementType t) { return t == ElementType::Q4; })) return Basis::Bilinear;
  return all([](ElementType t) { return mesh::is_quadratic(t); }) ? Basis::Quadratic : Basis::Linear;
}

/// Whether the line from a vertex to the middle of an element stays clear of the boundary sides of `elements`.
bool Recovery::visible(std::size_t vertex, std::size_t element, std::span<const std::uint32_t> elements) const {
  const auto middle_of = [&](std::size_t e) {
    const auto nodes = mesh_.nodes_of(mesh::ElementId(e));
    Vector sum;
    const std::size_t corners = mesh::corner_count(mesh_.types[e]);
    for (std::size_t i = 0; i < corners; ++i) sum = sum + (mesh_.point(nodes[i]) - Point{});
    return Point{} + sum / static_cast<double>(corners);
  };
  const geom::Segment sight{mesh_.points[vertex], middle_of(element)};
  for (const std::uint32_t e : elements) {
    for (std::uint32_t side = 0; side < mesh::corner_count(mesh_.types[e]); ++side) {
      if (neighbour(e, side) != none) continue;
      const auto ends = side_nodes(mesh_, {mesh::ElementId(e), side});
      if (ends[0].index() == vertex || ends[1].index() == vertex) continue;
      const auto meeting = geom::intersect(sight, geom::Segment{mesh_.point(ends[0]), mesh_.point(ends[1])});
      if (meeting.kind != geom::IntersectionKind::None) return false;
    }
  }
  return true;
}

/// The elements and those beyond their sides that can be seen from the vertex.
std::vector<std::uint32_t> Recovery::grown(const Patch& patch, const std::vector<std::uint32_t>& elements) const {
  std::vector<std::uint32_t> next;
  for (const std::uint32_t e : elements) {
    for (std::size_t side = 0; side < mesh::corner_count(mesh_.types[e]); ++side) {
      const std::size_t other = neighbour(e, side);
      if (other != none && !std::binary_search(elements.begin(), elements.end(), other))
        next.push_back(static_cast<std::uint32_t>(other));
    }
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  std::vector<std::uint32_t> all = elements;
  all.insert(all.end(), next.begin(), next.end());
  std::erase_if(next, [&](std::uint32_t e) { return !visible(patch.vertex, e, all); });
  std::vector<std::uint32_t> result = elements;
  result.insert(result.end(), next.begin(), next.end());
  std::sort(result.begin(), result.end());
  return result;
}

Recovery::Fitted Recovery::fit(const Patch& patch) const {
  Fitted fitted;
  std::vector<std::uint32_t> elements = patch.elements;
  std::vector<Point> points;
  std::vector<std::size_t> from;
  const Point centre = mesh_.points[patch.vertex];
  double scale = 0.0;
  std::optional<PatchFit> best;
  const auto fit_of = [&](Basis terms) {
    std::vector<double> weights;
    for (const Point p : points) weights.push_back(std::pow(weight_floor + distance(centre, p) / scale, -3.0));
    best.emplace(terms, centre, scale, points, weights);
  };
  const auto gather = [&] {
    points.clear();
    from.clear();
    scale = 0.0;
    for (const std::uint32_t e : elements) {
      for (std::size_t s = samples_.first[e]; s < samples_.first[e + 1]; ++s) {
        points.push_back(samples_.points[s]);
        from.push_back(s);
        scale = std::max(scale, distance(centre, samples_.points[s]));
      }
    }
  };
  gather();
  Basis basis = basis_of(elements);
  const auto enough = [&] {
    return static_cast<double>(points.size()) >= enough_samples * static_cast<double>(term_count(basis));
  };
  for (int growth = 0; growth <= most_growth; ++growth) {
    if ((patch.interior || growth > 0) && enough()) {
      fit_of(basis);
      if (best->determined()) break;
    }
    const std::size_t before = elements.size();
    elements = grown(patch, elements);
    if (elements.size() == before) break;
    fitted.grown = true;
    gather();
    basis = basis_of(elements);
  }
  if (!best || !best->determined()) {  // a sliver of a region: all it has, exactly or by a plane or a mean
    fit_of(basis);
    if (!best->determined()) {
      fitted.degraded = true;
      fit_of(Basis::Linear);
    }
  }
  const auto value_at = [&](Point p) {
    const std::vector<double> weights =
        best->determined() ? best->weights_at(p)
                           : std::vector<double>(points.size(), 1.0 / static_cast<double>(points.size()));
    Voigt sum{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weights[i] * samples_.stresses[from[i]][k];
    }
    return sum;
  };
  fitted.values.push_back(value_at(centre));
  for (const std::uint32_t e : patch.elements) {
    if (!mesh::is_quadratic(mesh_.types[e])) continue;
    const auto nodes = mesh_.nodes_of(mesh::ElementId(e));
    const std::size_t corners = mesh::corner_count(mesh_.types[e]);
    std::size_t i = 0;
    while (nodes[i].index() != patch.vertex) ++i;
    for (const std::size_t side : {i, (i + corners - 1) % corners})
      fitted.values.push_back(value_at(mesh_.point(nodes[corners + side])));
  }
  return fitted;
}

RecoveredStress Recovery::run() {
  const auto fitted = base::parallel_map<Fitted>(
      patches_.size(), [&](std::size_t p) { return fit(patches_[p]); }, grain);
  RecoveredStress result;
  result.at_element_nodes.assign(mesh_.nodes.size(), Voigt{});
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    result.grown += fitted[p].grown ? 1 : 0;
    result.degraded += fitted[p].degraded ? 1 : 0;
    std::size_t next = 1;
    for (const std::uint32_t e : patches_[p].elements) {
      const auto nodes = mesh_.nodes_of(mesh::ElementId(e));
      const std::size_t corners = mesh::corner_count(mesh_.types[e]);
      std::size_t i = 0;
      while (nodes[i].index() != patches_[p].vertex) ++i;
      result.at_element_nodes[mesh_.first[e] + i] = fitted[p].values[0];
      if (!mesh::is_quadratic(mesh_.types[e])) continue;
      for (const std::size_t side : {i, (i + corners - 1) % corners}) {
        Voigt& sum = result.at_element_nodes[mesh_.first[e] + corners + side];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += 0.5 * fitted[p].values[next][k];
        ++next;
      }
    }
  }
  return result;
}

}  // namespace

RecoveredStress recover_stress(const ElementMesh& mesh, const Materials& materials, std::span<const Vector> u) {
  return Recovery(mesh, materials, u).run();
}

std::vector<Voigt> nodal_mean(const ElementMesh& mesh, std::span<const Voigt> at_element_nodes) {
  std::vector<Voigt> mean(mesh.points.size(), Voigt{});
  std::vector<double> count(mesh.points.size(), 0.0);
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
    const std::size_t node = mesh.nodes[k].index();
    count[node] += 1.0;
    for (std::size_t i = 0; i < 3; ++i) mean[node][i] += at_element_nodes[k][i];
  }
  for (std::size_t n = 0; n < mean.size(); ++n) {
    for (double& value : mean[n]) value /= count[n];
  }
  return mean;
}

}  // namespace dobra::fem::error
