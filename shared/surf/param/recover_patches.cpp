#include "shared/surf/param/recover_patches.h"

#include <algorithm>
#include <cmath>

#include "shared/base/parallel.h"
#include "shared/geom/fit/patch_fit.h"

namespace dobra::surf::param {

using geom::Point;
using geom::Vector;
using geom::Vector3;

namespace {

constexpr std::uint32_t nobody = ~std::uint32_t{0};

class Grower {
 public:
  explicit Grower(const Sheet& sheet) : sheet_(sheet), owner_(sheet.triangles.size(), nobody) {}

  /// Triangles of each patch, ascending.
  std::vector<std::vector<std::uint32_t>> run() {
    seed();
    if (patches_.empty()) take(0, static_cast<std::uint32_t>(patches_.size()));
    spread();
    return std::move(patches_);
  }

 private:
  void take(std::uint32_t triangle, std::uint32_t patch) {
    if (patch == patches_.size()) patches_.emplace_back();
    owner_[triangle] = patch;
    patches_[patch].push_back(triangle);
  }
  void seed() {
    constexpr std::size_t least = 5;  // six points at least
    const std::vector<HalfEdge> first = sheet_.first_half_edges();
    std::vector<std::uint32_t> star;
    for (const HalfEdge begin : first) {
      if (sheet_.twins[begin] == no_half_edge) continue;
      star.clear();
      bool free = true;
      HalfEdge h = begin;
      do {
        star.push_back(h / 3);
        free = free && owner_[h / 3] == nobody;
        h = sheet_.twins[previous(h)];
      } while (h != begin);
      if (!free || star.size() < least) continue;
      const auto patch = static_cast<std::uint32_t>(patches_.size());
      for (const std::uint32_t t : star) take(t, patch);
    }
  }
  void spread() {
    std::vector<std::uint32_t> left;
    for (std::uint32_t t = 0; t < owner_.size(); ++t) {
      if (owner_[t] == nobody) left.push_back(t);
    }
    while (!left.empty()) {
      // A round sees the patches as they were before it.
      std::vector<std::pair<std::uint32_t, std::uint32_t>> joins;
      for (const std::uint32_t t : left) {
        std::uint32_t best = nobody;
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
          if (sheet_.twins[h] == no_half_edge) continue;
          const std::uint32_t patch = owner_[sheet_.twins[h] / 3];
          if (patch == nobody) continue;
          if (best == nobody || std::pair(patches_[patch].size(), patch) < std::pair(patches_[best].size(), best))
            best = patch;
        }
        if (best != nobody) joins.emplace_back(t, best);
      }
      for (const auto& [t, patch] : joins) take(t, patch);
      std::erase_if(left, [&](std::uint32_t t) { return owner_[t] != nobody; });
    }
  }

  const Sheet& sheet_;
  std::vector<std::uint32_t> owner_;
  std::vector<std::vector<std::uint32_t>> patches_;
};

struct Fitted {
  Point centre;
  Quadratic polynomial{};
  bool quadratic = false;
  bool linear = false;
};

Fitted fit(const DiscreteChart& chart, const std::vector<std::uint32_t>& triangles, const RecoverOptions& options) {
  const Sheet& sheet = chart.sheet();
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : triangles)
    vertices.insert(vertices.end(), sheet.triangles[t].begin(), sheet.triangles[t].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Fitted fitted;
  Vector sum;
  std::vector<Point> places;
  for (const std::uint32_t v : vertices) {
    places.push_back(chart.uv()[v]);
    sum = sum + (places.back() - places.front());
  }
  fitted.centre = places.front() + sum / static_cast<double>(places.size());
  double scale = 0.0;
  for (const Point p : places) scale = std::max(scale, distance(p, fitted.centre));
  std::vector<double> weights;
  if (options.weights == RecoverOptions::SampleWeights::InverseDistance) {
    constexpr double floor = 0.2;  // of the patch's size: a sample in its middle has no greater weight
    for (const Point p : places) weights.push_back(1.0 / (floor + distance(p, fitted.centre) / scale));
  }
  const auto solve = [&](geom::fit::Basis basis) {
    const geom::fit::PatchFit found(basis, fitted.centre, scale, places, weights);
    if (!found.determined()) return false;
    const std::array<double, 6> unit{1.0, scale, scale, scale * scale, scale * scale, scale * scale};
    std::vector<double> samples(vertices.size());
    for (int axis = 0; axis < 3; ++axis) {
      const auto part = [axis](auto& p) -> auto& { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
      for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = part(sheet.points[vertices[i]]);
      const auto coefficients = found.coefficients(samples);
      for (std::size_t k = 0; k < 6; ++k) part(fitted.polynomial[k]) = coefficients[k] / unit[k];
    }
    return true;
  };
  fitted.quadratic = solve(geom::fit::Basis::Quadratic);
  fitted.linear = fitted.quadratic || solve(geom::fit::Basis::Linear);
  if (!fitted.linear) {
    Vector3 mean;
    for (const std::uint32_t v : vertices) mean = mean + (sheet.points[v] - geom::Point3{});
    fitted.polynomial[0] = mean / static_cast<double>(vertices.size());
  }
  return fitted;
}

/// The patch beside one that has the fewest triangles; nobody if it is alone.
std::uint32_t beside(const Sheet& sheet, const std::vector<std::vector<std::uint32_t>>& patches,
                     const std::vector<std::uint32_t>& owner, std::uint32_t patch) {
  std::uint32_t best = nobody;
  for (const std::uint32_t t : patches[patch]) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      if (sheet.twins[h] == no_half_edge) continue;
      const std::uint32_t other = owner[sheet.twins[h] / 3];
      if (other == patch) continue;
      if (best == nobody || std::pair(patches[other].size(), other) < std::pair(patches[best].size(), best))
        best = other;
    }
  }
  return best;
}

}  // namespace

Quadratic shifted(const Quadratic& a, Vector d) {
  Quadratic made = a;
  made[0] = a[0] + d.x * a[1] + d.y * a[2] + (d.x * d.x) * a[3] + (d.x * d.y) * a[4] + (d.y * d.y) * a[5];
  made[1] = a[1] + (2.0 * d.x) * a[3] + d.y * a[4];
  made[2] = a[2] + d.x * a[4] + (2.0 * d.y) * a[5];
  return made;
}

Patches patches_of(const DiscreteChart& chart, const RecoverOptions& options) {
  const Sheet& sheet = chart.sheet();
  std::vector<std::vector<std::uint32_t>> patches = Grower(sheet).run();
  std::vector<Fitted> fits = base::parallel_map<Fitted>(
      patches.size(), [&](std::size_t p) { return fit(chart, patches[p], options); }, 64);
  std::vector<std::uint32_t> owner(sheet.triangles.size(), nobody);
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    for (const std::uint32_t t : patches[p]) owner[t] = p;
  }
  Patches made;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    while (!patches[p].empty() && !fits[p].quadratic) {
      const std::uint32_t other = beside(sheet, patches, owner, p);
      if (other == nobody) break;
      for (const std::uint32_t t : patches[other]) owner[t] = p;
      patches[p].insert(patches[p].end(), patches[other].begin(), patches[other].end());
      patches[other].clear();
      fits[p] = fit(chart, patches[p], options);
      ++made.report.merged;
    }
  }
  std::vector<std::uint32_t> number(patches.size(), nobody);
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    if (patches[p].empty()) continue;
    number[p] = static_cast<std::uint32_t>(made.polynomials.size());
    made.centres.push_back(fits[p].centre);
    made.polynomials.push_back(fits[p].polynomial);
    made.report.degraded += fits[p].quadratic ? 0 : 1;
  }
  made.report.patches = made.polynomials.size();
  made.report.patch_of.resize(owner.size());
  for (std::size_t t = 0; t < owner.size(); ++t) made.report.patch_of[t] = number[owner[t]];
  return made;
}

}  // namespace dobra::surf::param
