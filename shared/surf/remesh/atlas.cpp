#include "shared/surf/remesh/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>

#include "shared/base/check.h"
#include "shared/base/disjoint_sets.h"
#include "shared/surf/param/relax.h"

namespace dobra::surf::remesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using param::HalfEdge;
using param::no_half_edge;
using param::Sheet;

namespace {

/// Triangles by their numbers in the sheet, in order.
using Triangles = std::vector<std::uint32_t>;

/// A part of a sheet as a sheet of its own. Triangle i is triangles[i]; half-edges follow.
Sheet part_of(const Sheet& sheet, const Triangles& triangles) {
  std::vector<std::uint32_t> number(sheet.triangles.size(), no_half_edge);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) number[triangles[i]] = i;
  std::vector<HalfEdge> twins(3 * triangles.size(), no_half_edge);
  base::DisjointSets same(twins.size());  // corners that are one point
  for (HalfEdge h = 0; h < twins.size(); ++h) {
    const HalfEdge twin = sheet.twins[3 * triangles[h / 3] + h % 3];
    if (twin == no_half_edge || number[twin / 3] == no_half_edge) continue;
    twins[h] = 3 * number[twin / 3] + twin % 3;
    same.join(h, param::next(twins[h]));
    same.join(param::next(h), twins[h]);
  }
  std::vector<Point3> points;
  std::vector<std::uint32_t> point(twins.size(), no_half_edge);
  std::vector<std::array<std::uint32_t, 3>> corners(triangles.size());
  for (HalfEdge h = 0; h < twins.size(); ++h) {
    std::uint32_t& mine = point[same.root(h)];
    if (mine == no_half_edge) {
      mine = static_cast<std::uint32_t>(points.size());
      points.push_back(sheet.points[sheet.start(3 * triangles[h / 3] + h % 3)]);
    }
    corners[h / 3][h % 3] = mine;
  }
  auto made = param::connect(std::move(points), std::move(corners), std::move(twins));
  DOBRA_CHECK(made.ok());  // a part of a manifold, with a point for each fan of triangles
  return std::move(*made);
}

/// Of each triangle to one of them, from centre to centre of neighbours.
std::vector<double> distances(const Sheet& sheet, std::uint32_t from) {
  std::vector<double> length(sheet.triangles.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  length[from] = 0.0;
  queue.emplace(0.0, from);
  while (!queue.empty()) {
    const auto [at, t] = queue.top();
    queue.pop();
    if (at > length[t]) continue;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge twin = sheet.twins[h];
      if (twin == no_half_edge) continue;
      const double there = at + geom::distance(centre(sheet, t), centre(sheet, twin / 3));
      if (there < length[twin / 3]) {
        length[twin / 3] = there;
        queue.emplace(there, twin / 3);
      }
    }
  }
  return length;
}

/// Lengths in space that a unit of the chart stands for, in the two directions in which these are extreme.
struct Scale {
  double least = 0.0, greatest = 0.0;
};

std::vector<Scale> scales(const Sheet& sheet, const std::vector<Point>& uv) {
  std::vector<Scale> made;
  for (const auto& [a, b, c] : sheet.triangles) {
    const geom::Vector3 p = sheet.points[b] - sheet.points[a], q = sheet.points[c] - sheet.points[a];
    const geom::Vector u = uv[b] - uv[a], v = uv[c] - uv[a];
    const double area = cross(u, v);
    const geom::Vector3 along_x = (1.0 / area) * (v.y * p - u.y * q), along_y = (1.0 / area) * (u.x * q - v.x * p);
    // The singular values of the map have this sum of squares and this product.
    const double squares = dot(along_x, along_x) + dot(along_y, along_y),
                 product = geom::length(cross(along_x, along_y));
    const double sum = std::sqrt(squares + 2.0 * product),
                 difference = std::sqrt(std::max(0.0, squares - 2.0 * product));
    const double greatest = 0.5 * (sum + difference);
    made.push_back({product / greatest, greatest});
  }
  return made;
}

/// Pieces that hang together through sides which are not cut.
std::vector<Triangles> pieces_of(const Sheet& sheet, const std::vector<bool>& cut) {
  base::DisjointSets joined(sheet.triangles.size());
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    if (sheet.twins[h] != no_half_edge && !cut[h]) joined.join(h / 3, sheet.twins[h] / 3);
  }
  std::vector<std::size_t> piece(sheet.triangles.size(), no_half_edge);
  std::vector<Triangles> pieces;
  for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t) {
    const std::size_t root = joined.root(t);
    if (root == t) piece[t] = pieces.size(), pieces.emplace_back();
    pieces[piece[root]].push_back(t);
  }
  return pieces;
}

/// What creases part; pieces of less area than `least` are joined to the neighbour with the longest common border.
std::vector<Triangles> parted_by_creases(const Sheet& sheet, double crease, double least) {
  if (!(crease < 180.0)) return pieces_of(sheet, std::vector<bool>(sheet.twins.size(), false));
  std::vector<bool> cut = param::creases_of(sheet, crease);
  for (;;) {
    const std::vector<Triangles> pieces = pieces_of(sheet, cut);
    std::vector<std::size_t> piece(sheet.triangles.size());
    std::vector<double> area(pieces.size(), 0.0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const std::uint32_t t : pieces[i]) {
        const auto& [a, b, c] = sheet.triangles[t];
        piece[t] = i;
        area[i] += 0.5 * geom::length(cross(sheet.points[b] - sheet.points[a], sheet.points[c] - sheet.points[a]));
      }
    }
    // The longest border of each piece that is too small; one that is joined already waits for the next round.
    std::map<std::pair<std::size_t, std::size_t>, double> borders;
    for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
      if (sheet.twins[h] == no_half_edge || piece[h / 3] == piece[sheet.twins[h] / 3]) continue;
      borders[{piece[h / 3], piece[sheet.twins[h] / 3]}] +=
          geom::distance(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]);
    }
    std::vector<std::pair<double, std::size_t>> longest(pieces.size());
    for (const auto& [between, length] : borders)
      longest[between.first] = std::max(longest[between.first], {length, between.second});
    std::vector<std::size_t> joins(pieces.size(), no_half_edge);
    bool some = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (area[i] >= least || !(longest[i].first > 0.0)) continue;
      joins[i] = longest[i].second;
      some = true;
    }
    if (!some) return pieces;
    for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
      if (sheet.twins[h] == no_half_edge) continue;
      const std::size_t p = piece[h / 3], q = piece[sheet.twins[h] / 3];
      if (p == q || joins[p] == q || joins[q] == p) cut[h] = false;
    }
  }
}

/// Two halves and what falls off them.
/// @pre two triangles at least
std::vector<Triangles> halves(const Sheet& sheet) {
  const auto farthest = [](const std::vector<double>& far) {
    return static_cast<std::uint32_t>(std::max_element(far.begin(), far.end()) - far.begin());
  };
  const std::uint32_t from = farthest(distances(sheet, 0));
  const std::vector<double> one = distances(sheet, from);
  const std::uint32_t to = farthest(one);
  const std::vector<double> two = distances(sheet, to);
  std::vector<bool> second(one.size());
  for (std::size_t t = 0; t < one.size(); ++t) second[t] = two[t] < one[t];
  // The line between them becomes smoother: a triangle with two sides on it changes over.
  constexpr int sweeps = 3;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::uint32_t t = 0; t < one.size(); ++t) {
      if (t == from || t == to) continue;
      int others = 0;
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
        others += sheet.twins[h] != no_half_edge && second[sheet.twins[h] / 3] != second[t] ? 1 : 0;
      if (others >= 2) second[t] = !second[t];
    }
  }
  std::vector<bool> cut(sheet.twins.size(), false);
  for (HalfEdge h = 0; h < cut.size(); ++h)
    cut[h] = sheet.twins[h] != no_half_edge && second[h / 3] != second[sheet.twins[h] / 3];
  return pieces_of(sheet, cut);
}

/// A part whose chart stands.
struct Flat {
  Triangles triangles;
  Charted charted;
  double stretch = 1.0;
};

Result<Flat> flat_of(Triangles triangles, const param::SheetMade& made, Holes holes, const AtlasOptions& options,
                     const base::Progress& progress) {
  DOBRA_TRY(Charted charted, chart_sheet(made, {.weights = options.weights}, holes, options.crease));
  if (!charted.parametrisation.flipped.empty())
    return Flat{std::move(triangles), std::move(charted), std::numeric_limits<double>::infinity()};
  const Sheet& sheet = charted.opened.sheet;
  std::vector<Point>& uv = charted.parametrisation.uv;
  double stretched = stretch(sheet, uv);
  if (stretched > options.relaxed_from) {
    DOBRA_TRY_VOID(param::relax(sheet, uv, {}, progress));
    stretched = stretch(sheet, uv);
  }
  return Flat{std::move(triangles), std::move(charted), stretched};
}

/// @error CannotMesh with the place: a flipped triangle
Result<Atlas> atlas_of(const Sheet& before, std::vector<Flat> flats) {
  std::sort(flats.begin(), flats.end(),
            [](const Flat& a, const Flat& b) { return a.triangles.front() < b.triangles.front(); });
  Atlas atlas;
  atlas.before = before;
  std::vector<std::size_t> part(before.triangles.size());
  for (std::size_t i = 0; i < flats.size(); ++i) {
    if (!flats[i].charted.parametrisation.flipped.empty()) {
      const base::Finding& flipped = flats[i].charted.findings.back();
      return Error{ErrorCode::CannotMesh, flipped.message, flipped.place};
    }
    for (const std::uint32_t t : flats[i].triangles) part[t] = i;
  }
  std::vector<bool> cut(before.twins.size(), false);
  for (HalfEdge h = 0; h < cut.size(); ++h)
    cut[h] = before.twins[h] != no_half_edge && part[h / 3] != part[before.twins[h] / 3];
  for (const Flat& flat : flats) {
    const auto& across = flat.charted.opened.across;
    for (HalfEdge h = 0; h < across.size(); ++h) {
      if (across[h] != no_half_edge) cut[3 * flat.triangles[h / 3] + h % 3] = true;
    }
  }
  atlas.opened = param::open_along(before, cut);
  atlas.part.resize(atlas.opened.sheet.points.size());
  atlas.uv.resize(atlas.part.size());
  for (std::uint32_t i = 0; i < flats.size(); ++i) {
    Flat& flat = flats[i];
    atlas.stretch = std::max(atlas.stretch, flat.stretch);
    const auto& uv = flat.charted.parametrisation.uv;
    for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = atlas.opened.sheet.triangles[flat.triangles[t]][k];
        atlas.part[v] = i;
        atlas.uv[v] = uv[flat.charted.opened.sheet.triangles[t][k]];
      }
    }
    atlas.parts.push_back(
        {std::make_shared<const param::DiscreteChart>(std::move(flat.charted.opened.sheet), uv), flat.triangles});
  }
  return atlas;
}

Triangles all_of(const Sheet& sheet) {
  Triangles all(sheet.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

}  // namespace

double stretch(const Sheet& sheet, const std::vector<Point>& uv) {
  constexpr double few = 0.02;  // of the triangles
  std::vector<double> least, greatest;
  for (const Scale& scale : scales(sheet, uv)) {
    least.push_back(scale.least);
    greatest.push_back(scale.greatest);
  }
  const auto skipped = static_cast<std::ptrdiff_t>(few * static_cast<double>(least.size()));
  std::nth_element(least.begin(), least.begin() + skipped, least.end());
  std::nth_element(greatest.begin(), greatest.end() - 1 - skipped, greatest.end());
  return greatest[greatest.size() - 1 - static_cast<std::size_t>(skipped)] / least[static_cast<std::size_t>(skipped)];
}

Result<Atlas> single_chart(const param::SheetMade& made, Holes holes, const AtlasOptions& options,
                           const base::Progress& progress) {
  std::vector<Flat> flats;
  DOBRA_TRY(Flat flat, flat_of(all_of(made.sheet), made, holes, options, progress));
  std::vector<base::Finding> findings = flat.charted.findings;
  flats.push_back(std::move(flat));
  DOBRA_TRY(Atlas atlas, atlas_of(made.sheet, std::move(flats)));
  atlas.findings = std::move(findings);
  return atlas;
}

Result<Atlas> several_charts(const param::SheetMade& made, const AtlasOptions& options,
                             const base::Progress& progress) {
  std::vector<Triangles> open = parted_by_creases(made.sheet, options.crease, options.least_area);
  std::vector<Flat> done;
  while (!open.empty()) {
    DOBRA_TRY_VOID(progress.check());
    const Triangles triangles = std::move(open.back());
    open.pop_back();
    const Sheet sheet = part_of(made.sheet, triangles);
    auto flat = flat_of(triangles, {sheet, {}}, has_many_holes(sheet) ? Holes::Stay : Holes::Cut, options, progress);
    if (triangles.size() <= options.fewest || (flat && flat->stretch <= options.most_stretch)) {
      if (!flat) return flat.error();
      done.push_back(std::move(*flat));
      continue;
    }
    for (Triangles& half : halves(sheet)) {
      for (std::uint32_t& t : half) t = triangles[t];
      open.push_back(std::move(half));
    }
  }
  DOBRA_TRY(Atlas atlas, atlas_of(made.sheet, std::move(done)));
  tell_mended(made.mended, atlas.findings);
  atlas.findings.push_back(
      {"parted",
       fmt::format("one chart would stretch the mesh too much, so it was parted (parts: {}, sides of the lines between "
                   "them: {}, their length: {:.6g})",
                   atlas.parts.size(), atlas.opened.sides, atlas.opened.length),
       {}});
  return atlas;
}

}  // namespace dobra::surf::remesh
