#include "shared/surf/remesh/remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "shared/geom/predicates.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/param/discrete_chart.h"
#include "shared/surf/param/recovered.h"
#include "shared/surf/remesh/network.h"
#include "shared/surf/remesh/triangle_tree.h"

namespace dobra::surf::remesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using mesh::Finding;
using param::Sheet;

namespace {

base::Place place_of(Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }

/// Places of a triangle at which a deviation is looked for, besides its corners.
constexpr std::array<std::array<double, 3>, 10> looks{{{0.5, 0.5, 0.0},
                                                       {0.0, 0.5, 0.5},
                                                       {0.5, 0.0, 0.5},
                                                       {0.75, 0.25, 0.0},
                                                       {0.0, 0.75, 0.25},
                                                       {0.25, 0.0, 0.75},
                                                       {0.25, 0.75, 0.0},
                                                       {0.0, 0.25, 0.75},
                                                       {0.75, 0.0, 0.25},
                                                       {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}}};

/// Places of a triangle at which the way that a surface faces is looked at.
constexpr std::array<std::array<double, 3>, 4> spots{
    {{0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}}};

Point3 at(const std::vector<Point3>& points, const std::array<std::uint32_t, 3>& t, const std::array<double, 3>& c) {
  return points[t[0]] + c[1] * (points[t[1]] - points[t[0]]) + c[2] * (points[t[2]] - points[t[0]]);
}

/// Calls found(triangle of `of`, nearest in `tree`) for the corners and looks of all triangles.
template <class Found>
void look(const std::vector<Point3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles,
          const TriangleTree& tree, Found&& found) {
  std::vector<bool> seen(points.size(), false);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t v : triangles[t]) {
      if (!seen[v]) found(t, tree.nearest(points[v]));
      seen[v] = true;
    }
    for (const auto& c : looks) found(t, tree.nearest(at(points, triangles[t], c)));
  }
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const mesh::SurfaceMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& c : mesh.triangles) {
    triangles.push_back({static_cast<std::uint32_t>(c[0].index()), static_cast<std::uint32_t>(c[1].index()),
                         static_cast<std::uint32_t>(c[2].index())});
  }
  return triangles;
}

double mean_side(const Sheet& sheet) {
  double sum = 0.0;
  for (param::HalfEdge h = 0; h < sheet.twins.size(); ++h)
    sum += geom::distance(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]);
  return sum / static_cast<double>(sheet.twins.size());
}

/// One sheet at work.
class Remesher {
 public:
  Remesher(Charted charted, const RemeshOptions& options, double size)
      : charted_(std::move(charted)),
        options_(options),
        size_(size),
        chart_(std::make_shared<const param::DiscreteChart>(charted_.opened.sheet, charted_.parametrisation.uv)),
        sizes_(charted_.before.points.size(), size),
        tree_(charted_.before.points, charted_.before.triangles) {}

  Result<Remeshed> run(const base::Progress& progress) {
    DOBRA_TRY(const Surface pieces, param::plane_pieces(chart_));
    DOBRA_TRY(Surface guide, guide_of(0));
    Remeshed made;
    double crease = options_.crease;
    if (turns_over(guide)) guide = pieces, guide_ = 1;
    for (int round = 0;; ++round) {
      const double from = static_cast<double>(round) / (options_.rounds + 1);
      const base::Progress part = progress.part(from, from + 1.0 / (options_.rounds + 1));
      auto mesh = fill(guide, pieces, crease, made, part);
      while (!mesh && mesh.error().code != ErrorCode::Cancelled &&
             change_guide(guide, pieces, crease, made, mesh.error()))
        mesh = fill(guide, pieces, crease, made, part);
      if (!mesh) return in_space(mesh.error());
      made.mesh = std::move(*mesh);
      made.rounds = round + 1;
      Point3 worst;
      const bool finer = judge(made, worst);
      if (!(options_.chord > 0.0) || made.deviation <= options_.chord) break;
      if (round == options_.rounds || !finer) {
        made.findings.push_back(
            {"deviation_above",
             fmt::format(
                 "the new mesh is {:.3g} m off, more than the chord of {:.3g} m: the old one is rough or folded "
                 "there; give a greater chord or a smaller size",
                 made.deviation, options_.chord),
             place_of(worst)});
        break;
      }
    }
    made.quality = mesh::quality_of(made.mesh);
    constexpr double much = 0.5;
    if (!(options_.chord > 0.0) && made.deviation > much * size_) {
      made.findings.push_back({"deviation_above",
                               fmt::format("the new mesh is {:.3g} m off, which is much for sides of {:.3g} m: give a "
                                           "chord, or a smaller size",
                                           made.deviation, size_),
                               {}});
    }
    for (const auto& places : made.mesh.places)
      made.flipped += geom::orient2d(places[0], places[1], places[2]) == geom::Sign::Positive ? 0 : 1;
    made.findings.insert(made.findings.begin(), charted_.findings.begin(), charted_.findings.end());
    return made;
  }

 private:
  /// What the mesher is guided by instead, where it failed: first the plane pieces, which fold where the mesh does;
  /// then smoothed copies, without creases. Tells it. @return false where nothing is left
  bool change_guide(Surface& guide, const Surface& pieces, double& crease, Remeshed& made, const Error& why) {
    const base::Place place = in_space(why).place.value_or(base::Place{});
    if (guide_ == 0 && made.creases > 0) {
      guide = pieces;
      ++guide_;
      return true;
    }
    guide_ = std::max(guide_, std::size_t{1});
    if (made.creases > 0 && crease < 180.0) {
      made.findings.push_back(
          {"crease_left_out",
           fmt::format("{} lines at which the mesh folds are not kept: {}", made.creases, why.message), place});
    }
    crease = 180.0;
    if (guide_ > smoothings.size()) return false;
    if (guide_ == 1) {
      made.findings.push_back(
          {"rough",
           "the mesh is too rough for its own shape to guide the new one: a smoothed copy does; all "
           "nodes lie on the mesh itself",
           place});
    }
    auto smoothed = guide_of(smoothings[guide_ - 1]);
    ++guide_;
    if (!smoothed) return false;
    guide = std::move(*smoothed);
    return true;
  }

  /// How often the copy of the mesh that guides the mesher is smoothed, if it must be.
  static constexpr std::array<int, 2> smoothings{20, 200};

  /// The smooth surface of the mesh, whose vertices inside were moved so often to the mean of their neighbours.
  [[nodiscard]] Result<Surface> guide_of(int times) const {
    auto chart = chart_;
    if (times > 0) {
      Sheet sheet = charted_.opened.sheet;
      const auto first = sheet.first_half_edges();
      std::vector<std::vector<param::Neighbour>> rings(sheet.points.size());
      for (std::size_t v = 0; v < rings.size(); ++v) {
        if (sheet.twins[first[v]] != param::no_half_edge)
          rings[v] = param::ring_weights(sheet, first[v], param::Weights::MeanValue);
      }
      for (int i = 0; i < times; ++i) {
        const std::vector<Point3> before = sheet.points;
        for (std::size_t v = 0; v < rings.size(); ++v) {
          geom::Vector3 step;
          for (const param::Neighbour& n : rings[v]) step = step + n.weight * (before[n.vertex] - before[v]);
          sheet.points[v] = before[v] + 0.5 * step;
        }
      }
      chart = std::make_shared<const param::DiscreteChart>(std::move(sheet), charted_.parametrisation.uv);
    }
    return param::Recovered(std::move(chart), {.meets = param::Meets::Border}).surface();
  }

  /// Somewhere the surface faces the other way than the triangle there, as one does that rounds sharp corners.
  [[nodiscard]] bool turns_over(const Surface& surface) const {
    const auto& sheet = charted_.opened.sheet;
    const auto& uv = charted_.parametrisation.uv;
    std::vector<Point> places;
    for (const auto& [a, b, c] : sheet.triangles) {
      for (const auto& at : spots) places.push_back(uv[a] + at[1] * (uv[b] - uv[a]) + at[2] * (uv[c] - uv[a]));
    }
    std::vector<Jet> jets(places.size());
    surface.jets(places, jets);
    for (std::size_t i = 0; i < jets.size(); ++i) {
      const auto& [a, b, c] = sheet.triangles[i / spots.size()];
      const geom::Vector3 normal = cross(sheet.points[b] - sheet.points[a], sheet.points[c] - sheet.points[a]);
      if (!(dot(cross(jets[i].u, jets[i].v), normal) > 0.0)) return true;
    }
    return false;
  }

  /// The place in the chart is one in space for the user.
  Error in_space(Error error) const {
    if (!error.place || !error.place->u || !error.place->v) return error;
    const param::Located located = chart_->locate({*error.place->u, *error.place->v});
    const auto& sheet = charted_.opened.sheet;
    const Point3 p = at(sheet.points, sheet.triangles[located.triangle], located.at);
    error.place->x = p.x, error.place->y = p.y, error.place->z = p.z;
    return error;
  }

  [[nodiscard]] double wanted(Point uv) const {
    const param::Located place = chart_->locate(uv);
    const auto& t = charted_.before.triangles[place.triangle];
    double sum = 0.0, all = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double c = std::clamp(place.at[i], 0.0, 1.0);
      sum += c * sizes_[t[i]];
      all += c;
    }
    return sum / all;
  }

  Result<mesh::SurfaceMesh> fill(const Surface& smooth, const Surface& pieces, double crease, Remeshed& made,
                                 const base::Progress& progress) const {
    Network network = divide_network(charted_, sizes_, options_.corner, crease);
    made.creases = network.creases;
    mesh::ChartInput input{smooth, std::move(network.chart), std::move(network.at), std::move(network.node)};
    mesh::ChartMeshOptions options;
    options.sizes.largest = size_;
    options.sizes.turn = 180.0;
    options.sizes.growth = options_.growth;
    options.sizes.least = options_.least * size_;
    options.sizes.wanted = [this](Point uv, Point3) { return wanted(uv); };
    options.points.max_triangles = options_.most_triangles;
    options.attempts = 1;
    DOBRA_TRY(mesh::FaceMesh face, mesh::mesh_chart(input, options, progress));
    // Nodes inside were placed on the smooth surface; they belong on the mesh that was given.
    std::vector<Jet> jets(face.chart.points.size());
    pieces.jets(face.chart.points, jets);
    for (std::size_t i = input.at.size(); i < jets.size(); ++i) face.at[i] = jets[i].at;
    mesh::Division division;
    division.nodes = network.nodes;
    division.faces.push_back(std::move(input));
    const trim::TrimmedSurface whole{pieces};
    return mesh::assemble({&whole, 1}, division, {&face, 1});
  }

  /// Measures the deviation, and makes sizes smaller where it is above the chord.
  /// @return some became smaller
  bool judge(Remeshed& made, Point3& worst) {
    const auto triangles = triangles_of(made.mesh);
    const TriangleTree tree(made.mesh.points, triangles);
    made.deviation = 0.0;
    const auto& before = charted_.before;
    std::vector<double> next = sizes_;
    const auto seen = [&](double off, Point3 place, std::uint32_t old_triangle, std::uint32_t new_triangle) {
      if (off > made.deviation) made.deviation = off, worst = place;
      if (!(options_.chord > 0.0) || off <= options_.chord) return;
      double side = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        side = std::max(side, geom::distance(made.mesh.points[triangles[new_triangle][i]],
                                             made.mesh.points[triangles[new_triangle][(i + 1) % 3]]));
      }
      const double smaller = std::clamp(0.8 * std::sqrt(options_.chord / off), 0.4, 0.8);
      for (const std::uint32_t v : before.triangles[old_triangle])
        next[v] = std::min({next[v], smaller * side, smaller * sizes_[v]});
    };
    look(made.mesh.points, triangles, tree_,
         [&](std::uint32_t t, const TriangleTree::Nearest& n) { seen(n.distance, n.at, n.triangle, t); });
    look(before.points, before.triangles, tree,
         [&](std::uint32_t t, const TriangleTree::Nearest& n) { seen(n.distance, n.at, t, n.triangle); });
    return take(next);
  }

  /// Sizes that became smaller, and those of their neighbours, so that the mesher sees them. @return there are some
  bool take(const std::vector<double>& next) {
    const double least = options_.least * size_;
    std::vector<double> spread = next;
    for (const auto& t : charted_.before.triangles) {
      for (const std::uint32_t v : t) {
        for (const std::uint32_t w : t) {
          if (next[w] < sizes_[w]) spread[v] = std::min(spread[v], next[w]);
        }
      }
    }
    bool finer = false;
    for (std::size_t v = 0; v < spread.size(); ++v) {
      spread[v] = std::max(spread[v], least);
      finer = finer || spread[v] < sizes_[v];
    }
    sizes_ = std::move(spread);
    return finer;
  }

  const Charted charted_;
  const RemeshOptions& options_;
  const double size_;
  std::shared_ptr<const param::DiscreteChart> chart_;
  std::vector<double> sizes_;  ///< One a point of the sheet before the cut, m.
  const TriangleTree tree_;
  std::size_t guide_ = 0;  ///< How many guides were given up.
};

void tell_mended(const param::Mended& mended, std::vector<Finding>& findings) {
  const auto tell = [&](std::size_t count, const char* text) {
    if (count > 0) findings.push_back({"mended", fmt::format(fmt::runtime(text), count), {}});
  };
  tell(mended.merged, "{} points at the place of another one were joined with it");
  tell(mended.unused, "{} points of no face were left out");
  tell(mended.dropped, "{} triangles that are doubled or have two corners only were left out");
  tell(mended.flipped, "{} triangles without area were mended");
  tell(mended.turned, "{} triangles were turned the way of the first");
}

bool keeps_holes(const Sheet& sheet) { return sheet.loops.size() > 1 && sheet.genus() == 0; }

Result<void> lay_flat_cut(Charted& charted, const param::ParametriseOptions& options) {
  charted.opened = param::open(charted.before);
  if (charted.opened.sides > 0) {
    charted.findings.push_back(
        {"cut",
         fmt::format("the mesh has {} borders and {} handles, so it was cut open along {} sides, {:.6g} m in all",
                     charted.before.loops.size(), charted.before.genus(), charted.opened.sides, charted.opened.length),
         {}});
  }
  if (!charted.opened.sheet.disk() || charted.opened.sheet.loops[0].size() < 3) {
    return Error{ErrorCode::CannotMesh, "the mesh has too few triangles to be cut open",
                 place_of(charted.before.points[0])};
  }
  DOBRA_TRY(charted.parametrisation, param::parametrise(charted.opened.sheet, options));
  return {};
}

/// Holes are filled, so that there is a disk, and the filling is forgotten.
Result<void> lay_flat_with_holes(Charted& charted, const param::ParametriseOptions& options) {
  const Sheet whole = param::filled(charted.before);
  DOBRA_TRY(charted.parametrisation, param::parametrise(whole, options));
  charted.opened.sheet = charted.before;
  charted.opened.origin.resize(charted.before.points.size());
  std::iota(charted.opened.origin.begin(), charted.opened.origin.end(), 0U);
  charted.opened.across.assign(charted.before.twins.size(), param::no_half_edge);
  charted.parametrisation.uv.resize(charted.before.points.size());
  std::erase_if(charted.parametrisation.flipped, [&](std::uint32_t t) { return t >= charted.before.triangles.size(); });
  charted.findings.push_back(
      {"holes",
       fmt::format("{} borders stay holes in the chart, so the mesh was not cut open", charted.before.loops.size() - 1),
       {}});
  return {};
}

/// Many holes, each small: a cut through all of them would stretch the chart.
bool has_many_holes(const Sheet& sheet) {
  constexpr std::size_t many = 4;
  constexpr double small = 0.5;  // of the longest border
  if (!keeps_holes(sheet) || sheet.loops.size() <= many) return false;
  const std::size_t longest = param::longest_loop(sheet);
  const double most = small * param::loop_length(sheet, sheet.loops[longest]);
  for (std::size_t i = 0; i < sheet.loops.size(); ++i) {
    if (i != longest && param::loop_length(sheet, sheet.loops[i]) > most) return false;
  }
  return true;
}

Result<Charted> chart_sheet(const param::SheetMade& made, const param::ParametriseOptions& options, Holes holes) {
  Charted charted{made.sheet, {}, {}, {}};
  tell_mended(made.mended, charted.findings);
  if (holes == Holes::Stay && keeps_holes(charted.before)) {
    DOBRA_TRY_VOID(lay_flat_with_holes(charted, options));
  } else {
    DOBRA_TRY_VOID(lay_flat_cut(charted, options));
  }
  const param::Parametrisation& chart = charted.parametrisation;
  if (!chart.why_circle.empty())
    charted.findings.push_back({"circle", fmt::format("the border lies on a circle: {}", chart.why_circle), {}});
  if (!chart.flipped.empty()) {
    const auto& sheet = charted.opened.sheet;
    charted.findings.push_back({"flipped", fmt::format("{} triangles are flipped in the chart", chart.flipped.size()),
                                place_of(at(sheet.points, sheet.triangles[chart.flipped[0]], looks.back()))});
  }
  return charted;
}

/// One way of laying the mesh flat, and what comes of it.
Result<Remeshed> remesh_as(const param::SheetMade& sheet, const RemeshOptions& options, double size, Holes holes,
                           const base::Progress& progress) {
  DOBRA_TRY(Charted charted, chart_sheet(sheet, {.weights = options.weights}, holes));
  if (!charted.parametrisation.flipped.empty()) {
    const Finding& flipped = charted.findings.back();
    return Error{ErrorCode::CannotMesh, flipped.message, flipped.place};
  }
  return Remesher(std::move(charted), options, size).run(progress);
}

}  // namespace

Result<Charted> chart_mesh(const dobra::mesh::PolygonMesh& mesh, const param::ParametriseOptions& options,
                           Holes holes) {
  DOBRA_TRY(const param::SheetMade made, param::sheet_of(mesh));
  return chart_sheet(made, options, holes);
}

Result<Remeshed> remesh(const dobra::mesh::PolygonMesh& mesh, const RemeshOptions& options,
                        const base::Progress& progress) {
  const auto wrong = [](const char* text) { return Error{ErrorCode::InvalidOption, text}; };
  if (!(options.size >= 0.0) || !std::isfinite(options.size)) return wrong("size must be a positive length, or 0");
  if (!(options.chord >= 0.0) || !std::isfinite(options.chord)) return wrong("chord must be a positive length, or 0");
  DOBRA_TRY(param::SheetMade made, param::sheet_of(mesh));
  const double size = options.size > 0.0 ? options.size : mean_side(made.sheet);
  while (mean_side(made.sheet) > size && made.sheet.triangles.size() < options.enough)
    made.sheet = param::quartered(made.sheet);
  const Holes first = has_many_holes(made.sheet) ? Holes::Stay : Holes::Cut;
  auto done = remesh_as(made, options, size, first, progress);
  if (done || !keeps_holes(made.sheet) || done.error().code != ErrorCode::CannotMesh) return done;
  auto other = remesh_as(made, options, size, first == Holes::Cut ? Holes::Stay : Holes::Cut, progress);
  return other ? std::move(other) : std::move(done);
}

double deviation(const Sheet& a, const Sheet& b) {
  double most = 0.0;
  const auto take = [&](std::uint32_t, const TriangleTree::Nearest& n) { most = std::max(most, n.distance); };
  look(a.points, a.triangles, TriangleTree(b.points, b.triangles), take);
  look(b.points, b.triangles, TriangleTree(a.points, a.triangles), take);
  return most;
}

}  // namespace dobra::surf::remesh
