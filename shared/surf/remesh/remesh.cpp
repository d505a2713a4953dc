#include "shared/surf/remesh/remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "shared/geom/box3.h"
#include "shared/geom/predicates.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/param/recovered.h"
#include "shared/surf/remesh/atlas.h"
#include "shared/surf/remesh/estimate.h"
#include "shared/surf/remesh/network.h"
#include "shared/surf/remesh/one_sheet.h"
#include "shared/surf/remesh/polish.h"
#include "shared/surf/remesh/triangle_tree.h"
#include "shared/surf/remesh/twice_joined.h"

namespace dobra::surf::remesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using mesh::Finding;
using param::Sheet;

namespace {

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

/// Calls found(triangle of `of`, nearest in `tree`) for the corners and looks of all triangles. @error Cancelled
template <class Found>
Result<void> look(const std::vector<Point3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                  const TriangleTree& tree, const base::Progress& progress, Found&& found) {
  std::vector<bool> seen(points.size(), false);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    DOBRA_TRY_VOID(progress.check());
    for (const std::uint32_t v : triangles[t]) {
      if (!seen[v]) found(t, tree.nearest(points[v]));
      seen[v] = true;
    }
    for (const auto& c : looks) found(t, tree.nearest(at(points, triangles[t], c)));
  }
  return {};
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const mesh::SurfaceMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& c : mesh.triangles) {
    triangles.push_back({static_cast<std::uint32_t>(c[0].index()), static_cast<std::uint32_t>(c[1].index()),
                         static_cast<std::uint32_t>(c[2].index())});
  }
  return triangles;
}

/// Nothing could be filled between them.
bool lies_in_a_line(std::span<const Point> points) {
  for (std::size_t i = 2; i < points.size(); ++i) {
    for (std::size_t k = 1; k < i; ++k) {
      if (points[k] == points[0]) continue;
      if (geom::orient2d(points[0], points[k], points[i]) != geom::Sign::Zero) return false;
      break;
    }
  }
  return true;
}

/// One sheet at work.
class Remesher {
 public:
  Remesher(const Atlas& atlas, const RemeshOptions& options, double size, Creases creases)
      : atlas_(atlas),
        options_(options),
        size_(size),
        creases_(creases),
        sizes_(atlas_.before.points.size(), size),
        tree_(atlas_.before.points, atlas_.before.triangles) {
    for (const Point3 p : atlas_.before.points) box_.add(p);
  }

  /// Some creases were, when it was run.
  [[nodiscard]] bool left_out() const { return left_out_; }

  Result<Remeshed> run(const base::Progress& progress) {
    for (const Part& part : atlas_.parts) {
      DOBRA_TRY(Surface pieces, param::plane_pieces(part.chart));
      DOBRA_TRY(Surface smooth, guide_of(part, 0));
      const bool over = turns_over(smooth, part);
      guides_.push_back({over ? pieces : std::move(smooth), pieces, over ? std::size_t{1} : std::size_t{0}});
    }
    Remeshed made;
    Point3 worst;
    std::vector<mesh::TriangleId> turned;
    for (int round = 0;; ++round) {
      const double from = static_cast<double>(round) / (options_.rounds + 1);
      const base::Progress step = progress.part(from, from + 1.0 / (options_.rounds + 1));
      std::size_t at = 0;
      auto mesh = fill(made, step, at);
      while (!mesh && mesh.error().code != ErrorCode::Cancelled && mesh.error().code != ErrorCode::InvalidOption &&
             change_guide(at, made, mesh.error()))
        mesh = fill(made, step, at);
      left_out_ = made.narrow_creases + made.short_creases > 0;
      if (!mesh) return in_space(mesh.error(), at);
      made.mesh = std::move(*mesh);
      made.flipped = 0;
      for (const auto& places : made.mesh.places)
        made.flipped += geom::orient2d(places[0], places[1], places[2]) == geom::Sign::Positive ? 0 : 1;
      DOBRA_TRY(turned, polish(made.mesh, atlas_.before, tree_, step));
      if (const auto sound = mesh::check(made.mesh); !sound)
        return too_large(sound.error().message, in_space_only(sound.error().place));
      if (size_ > box_.diagonal() && mesh::quality_of(made.mesh).boundary_edges == 0)
        return too_large("it is closed, and smaller than one side", place_of(atlas_.before.points[0]));
      made.rounds = round + 1;
      DOBRA_TRY(const bool finer, judge(made, worst, step));
      if (!(options_.chord > 0.0) || made.deviation <= options_.chord) break;
      if (round == options_.rounds || !finer) {
        made.findings.push_back(
            {"deviation_above",
             fmt::format("the new mesh is {:.3g} off, more than the chord of {:.3g}: the old one is rough or folded "
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
                               fmt::format("the new mesh is {:.3g} off, which is much for sides of {:.3g}: give a "
                                           "chord, or a smaller size",
                                           made.deviation, size_),
                               place_of(worst)});
    }
    judge_area(made, worst);
    if (made.narrow_creases > 0) {
      made.findings.push_back({"crease_left_out",
                               fmt::format("lines at which the mesh folds that run beside another one, much nearer "
                                           "than a side, and are left out: {}; give a smaller size to keep them",
                                           made.narrow_creases),
                               place_of(made.narrow_at)});
    }
    constexpr double same = 1e-9;  // of the extent: where nothing is off, short creases are sides
    if (made.short_creases > 0 && made.deviation > same * box_.diagonal()) {
      made.findings.push_back({"crease_left_out",
                               fmt::format("lines at which the mesh folds that are shorter than a side, and are left "
                                           "out: {}; give a smaller size to keep them",
                                           made.short_creases),
                               place_of(made.short_at)});
    }
    if (made.tips_out > 0 && made.deviation > same * box_.diagonal()) {
      made.findings.push_back(
          {"tip_left_out",
           fmt::format("points at which the mesh comes to a tip that are left out: {}; give a smaller "
                       "size to keep them",
                       made.tips_out),
           place_of(made.tip_at)});
    }
    made.folded = turned.size();
    if (!turned.empty()) {
      made.findings.push_back(
          {"folded", fmt::format("triangles that face against the old mesh: {}; give a smaller size", turned.size()),
           place_of(made.mesh.points[made.mesh.triangles[turned[0].index()][0].index()])});
    }
    made.findings.insert(made.findings.begin(), atlas_.findings.begin(), atlas_.findings.end());
    return made;
  }

 private:
  /// What the mesher of a part is guided by.
  struct Guide {
    Surface surface;
    Surface pieces;  ///< The triangles themselves.
    std::size_t given_up = 0;
  };

  /// What the mesher is guided by instead, where it failed: first the plane pieces, which fold where the mesh does;
  /// then smoothed copies, without creases. Tells it. @return false where nothing is left
  bool change_guide(std::size_t at, Remeshed& made, const Error& why) {
    if (at == guides_.size()) return false;  // all parts are meshed, and do not fit together
    Guide& guide = guides_[at];
    const base::Place place = in_space(why, at).place.value_or(base::Place{});
    const bool has_creases = made.creases > made.cut_creases;
    if (guide.given_up == 0 && has_creases) {
      guide.surface = guide.pieces;
      ++guide.given_up;
      return true;
    }
    guide.given_up = std::max(guide.given_up, std::size_t{1});
    if (has_creases && crease_ < 180.0) {
      made.findings.push_back({"crease_left_out",
                               fmt::format("not all lines at which the mesh folds are kept, left out are {}: {}",
                                           made.creases - made.cut_creases, why.message),
                               place});
    }
    crease_ = 180.0;
    if (guide.given_up > smoothings.size()) return false;
    if (!std::exchange(rough_, true)) {
      made.findings.push_back(
          {"rough",
           "the mesh is too rough for its own shape to guide the new one: a smoothed copy does; all "
           "nodes lie on the mesh itself",
           place});
    }
    auto smoothed = guide_of(atlas_.parts[at], smoothings[guide.given_up - 1]);
    ++guide.given_up;
    if (!smoothed) return false;
    guide.surface = std::move(*smoothed);
    return true;
  }

  /// How often the copy of the mesh that guides the mesher is smoothed, if it must be.
  static constexpr std::array<int, 2> smoothings{20, 200};

  /// The smooth surface of the mesh, whose vertices inside were moved so often to the mean of their neighbours.
  [[nodiscard]] static Result<Surface> guide_of(const Part& part, int times) {
    auto chart = part.chart;
    if (times > 0) {
      Sheet sheet = chart->sheet();
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
      chart = std::make_shared<const param::DiscreteChart>(std::move(sheet), part.chart->uv());
    }
    return param::Recovered(std::move(chart), {.meets = param::Meets::Border}).surface();
  }

  /// Somewhere the surface faces the other way than the triangle there, as one does that rounds sharp corners.
  [[nodiscard]] static bool turns_over(const Surface& surface, const Part& part) {
    const Sheet& sheet = part.chart->sheet();
    const auto& uv = part.chart->uv();
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
  Error in_space(Error error, std::size_t part) const {
    if (part == atlas_.parts.size() || !error.place || !error.place->u || !error.place->v) return error;
    const param::DiscreteChart& chart = *atlas_.parts[part].chart;
    const param::Located located = chart.locate({*error.place->u, *error.place->v});
    const Sheet& sheet = chart.sheet();
    const Point3 p = at(sheet.points, sheet.triangles[located.triangle], located.at);
    error.place->x = p.x, error.place->y = p.y, error.place->z = p.z;
    return error;
  }

  [[nodiscard]] double wanted(const Part& part, Point uv) const {
    const param::Located place = part.chart->locate(uv);
    const auto& t = atlas_.before.triangles[part.triangles[place.triangle]];
    double sum = 0.0, all = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double c = std::clamp(place.at[i], 0.0, 1.0);
      sum += c * sizes_[t[i]];
      all += c;
    }
    return sum / all;
  }

  /// More triangles than the sizes can mean: what guides the mesher is folded.
  [[nodiscard]] std::size_t far_too_many(const Part& part, std::size_t nodes_given) const {
    constexpr double equilateral = 0.433, always = 1000.0, each_node = 10.0;
    double expected = each_node * static_cast<double>(nodes_given);
    const auto& points = atlas_.before.points;
    for (const std::uint32_t t : part.triangles) {
      const auto& [a, b, c] = atlas_.before.triangles[t];
      const double size = (sizes_[a] + sizes_[b] + sizes_[c]) / 3.0;
      expected += 0.5 * geom::length(cross(points[b] - points[a], points[c] - points[a])) / (equilateral * size * size);
    }
    return static_cast<std::size_t>(std::min(1e15, options_.beyond * expected + always));
  }

  /// The vertex inside whose angles have the sum furthest from 360 degrees.
  [[nodiscard]] Point3 sharpest() const {
    const Sheet& sheet = atlas_.before;
    std::vector<double> sums(sheet.points.size(), 0.0);
    for (param::HalfEdge h = 0; h < sheet.twins.size(); ++h) {
      const Point3 p = sheet.points[sheet.start(h)];
      const geom::Vector3 a = sheet.points[sheet.end(h)] - p;
      const geom::Vector3 b = sheet.points[sheet.start(param::previous(h))] - p;
      sums[sheet.start(h)] += std::atan2(geom::length(cross(a, b)), dot(a, b));
    }
    for (const auto& loop : sheet.loops) {
      for (const std::uint32_t v : loop) sums[v] = 2.0 * std::numbers::pi;
    }
    const auto off = [](double p, double q) {
      return std::abs(p - 2.0 * std::numbers::pi) < std::abs(q - 2.0 * std::numbers::pi);
    };
    return sheet.points[static_cast<std::size_t>(std::max_element(sums.begin(), sums.end(), off) - sums.begin())];
  }

  /// @param at  on an error the part that it is of
  Result<mesh::SurfaceMesh> fill(Remeshed& made, const base::Progress& progress, std::size_t& at) const {
    Network network = divide_network(atlas_, sizes_, options_.corner, crease_, creases_,
                                     crease_ == options_.crease ? Tips::Stay : Tips::LeaveOut);
    made.creases = network.creases;
    made.cut_creases = network.cut_creases;
    made.narrow_creases = network.narrow;
    made.narrow_at = network.narrow_at;
    made.short_creases = network.loose;
    made.short_at = network.loose_at;
    made.tips = network.tips;
    made.tips_out = network.tips_out;
    made.tip_at = network.tip_at;
    mesh::Division division;
    division.nodes = network.nodes;
    std::vector<mesh::FaceMesh> faces;
    std::vector<trim::TrimmedSurface> surfaces;
    const double count = static_cast<double>(atlas_.parts.size());
    for (at = 0; at < atlas_.parts.size(); ++at) {
      const double done = static_cast<double>(at);
      DOBRA_TRY(mesh::FaceMesh face, fill_part(at, std::move(network.parts[at]), division,
                                               progress.part(done / count, (done + 1.0) / count)));
      faces.push_back(std::move(face));
      surfaces.push_back({guides_[at].pieces});
    }
    part_twice_joined(faces, division, surfaces);
    DOBRA_TRY_VOID(progress.check());
    return mesh::join(surfaces, division, faces);
  }

  [[nodiscard]] Error too_large(const std::string& why, const std::optional<base::Place>& place) const {
    return {ErrorCode::InvalidOption,
            fmt::format("size {:.6g} is too large for this mesh ({}): give a smaller one", size_, why), place};
  }

  /// Its input goes to the faces of the division.
  Result<mesh::FaceMesh> fill_part(std::size_t at, Network::Part network, mesh::Division& division,
                                   const base::Progress& progress) const {
    const Part& part = atlas_.parts[at];
    if (lies_in_a_line(network.chart.points))
      return too_large("the lines that it is cut along have too few sides", place_of(network.at[0]));
    division.faces.push_back(
        {guides_[at].surface, std::move(network.chart), std::move(network.at), std::move(network.node)});
    const mesh::ChartInput& input = division.faces.back();
    mesh::ChartMeshOptions options;
    options.sizes.largest = size_;
    options.sizes.turn = 0.0;
    options.sizes.growth = options_.growth;
    options.sizes.least = options_.least * size_;
    options.sizes.wanted = [this, &part](Point uv, Point3) { return wanted(part, uv); };
    options.points.max_triangles = std::min(options_.most_triangles, far_too_many(part, input.at.size()));
    constexpr std::size_t cells_each = 4, cells_always = 20'000;
    options.sizes.most_cells =
        std::min(options.sizes.most_cells, cells_each * options.points.max_triangles + cells_always);
    options.attempts = 1;
    options.keep_folds = true;  // polish mends most
    auto filled = mesh::mesh_chart(input, options, progress);
    if (!filled && filled.error().code == ErrorCode::TooManyElements &&
        options.points.max_triangles < options_.most_triangles) {
      return Error{ErrorCode::CannotMesh,
                   "the mesh is so sharp here that its chart asks for far too many triangles: cut it there, or give "
                   "another size",
                   place_of(sharpest())};
    }
    DOBRA_TRY(mesh::FaceMesh face, std::move(filled));
    // Nodes inside were placed on the smooth surface; they belong on the mesh that was given.
    std::vector<Jet> jets(face.chart.points.size());
    guides_[at].pieces.jets(face.chart.points, jets);
    for (std::size_t i = input.at.size(); i < jets.size(); ++i) face.at[i] = jets[i].at;
    return face;
  }

  /// Tells an area that differs from that of the mesh given.
  void judge_area(Remeshed& made, Point3 worst) const {
    made.area_before = area_of(atlas_.before);
    if (std::abs(made.quality.area - made.area_before) <= options_.area_off * made.area_before) return;
    made.findings.push_back({"area_off",
                             fmt::format("the new mesh has an area of {:.6g}, the old one of {:.6g}: give a smaller "
                                         "size, or a chord",
                                         made.quality.area, made.area_before),
                             place_of(worst)});
  }

  static std::optional<base::Place> in_space_only(const std::optional<base::Place>& place) {
    if (!place) return place;
    return base::Place{.x = place->x, .y = place->y, .z = place->z};
  }

  /// Measures the deviation, and makes sizes smaller where it is above the chord.
  /// @return some became smaller  @error Cancelled; TooManyElements: the chord asks for more than the limit
  Result<bool> judge(Remeshed& made, Point3& worst, const base::Progress& progress) {
    DOBRA_TRY_VOID(progress.check());
    const auto triangles = triangles_of(made.mesh);
    const TriangleTree tree(made.mesh.points, triangles);
    made.deviation = 0.0;
    const auto& before = atlas_.before;
    std::vector<double> next = sizes_, enough = sizes_;
    const auto seen = [&](double off, Point3 place, std::uint32_t old_triangle, std::uint32_t new_triangle) {
      if (off > made.deviation) made.deviation = off, worst = place;
      if (!(options_.chord > 0.0) || off <= options_.chord) return;
      double side = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        side = std::max(side, geom::distance(made.mesh.points[triangles[new_triangle][i]],
                                             made.mesh.points[triangles[new_triangle][(i + 1) % 3]]));
      }
      const double ratio = std::sqrt(options_.chord / off), smaller = std::clamp(0.8 * ratio, 0.4, 0.8);
      for (const std::uint32_t v : before.triangles[old_triangle]) {
        next[v] = std::min({next[v], smaller * side, smaller * sizes_[v]});
        enough[v] = std::min(enough[v], ratio * side);
      }
    };
    DOBRA_TRY_VOID(
        look(made.mesh.points, triangles, tree_, progress,
             [&](std::uint32_t t, const TriangleTree::Nearest& n) { seen(n.distance, n.at, n.triangle, t); }));
    DOBRA_TRY_VOID(
        look(before.points, before.triangles, tree, progress,
             [&](std::uint32_t t, const TriangleTree::Nearest& n) { seen(n.distance, n.at, t, n.triangle); }));
    if (made.rounds == 1) DOBRA_TRY_VOID(not_too_many(enough, worst));
    return take(next);
  }

  /// How far a side is off a smooth mesh goes with its square, so the first round tells what the chord asks for.
  /// @error TooManyElements
  [[nodiscard]] Result<void> not_too_many(const std::vector<double>& enough, Point3 worst) const {
    const double triangles = expected_triangles(atlas_.before, enough);
    const auto most = static_cast<double>(options_.most_triangles);
    if (triangles <= most) return {};
    constexpr double at_ease = 0.1;  // of the limit
    return Error{ErrorCode::TooManyElements,
                 fmt::format("chord {:.6g} asks for about {:.2g} triangles, and the limit is {}: give a greater one, "
                             "such as {:.6g}",
                             options_.chord, triangles, options_.most_triangles,
                             rounded_up(options_.chord * triangles / (at_ease * most))),
                 place_of(worst)};
  }

  /// Sizes that became smaller, and those of their neighbours, so that the mesher sees them. @return there are some
  bool take(const std::vector<double>& next) {
    const double least = options_.least * size_;
    std::vector<double> spread = next;
    for (const auto& t : atlas_.before.triangles) {
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

  const Atlas& atlas_;
  const RemeshOptions& options_;
  const double size_;
  const Creases creases_;
  bool left_out_ = false;
  geom::Box3 box_;
  std::vector<double> sizes_;  ///< One a point of the sheet before the cut, m.
  const TriangleTree tree_;
  std::vector<Guide> guides_;  ///< One a part.
  double crease_ = options_.crease;
  bool rough_ = false;  ///< Told.
};

}  // namespace

namespace {

bool is_off(const Remeshed& made, const RemeshOptions& options) {
  return made.folded > 0 || std::abs(made.quality.area - made.area_before) > options.area_off * made.area_before;
}
/// To the mesh given.
bool is_nearer(const Remeshed& a, const Remeshed& b) {
  const auto off = [](const Remeshed& m) { return std::pair(m.folded, std::abs(m.quality.area - m.area_before)); };
  return off(a) < off(b);
}

/// Another chart would not help.
bool ends_it(const Error& error) {
  return error.code == ErrorCode::Cancelled || error.code == ErrorCode::TooManyElements;
}

}  // namespace

Result<Remeshed> remesh_once(param::SheetMade made, const RemeshOptions& options, double size,
                             const base::Progress& progress) {
  const auto is_small_and_closed = [](const Sheet& sheet) {
    constexpr std::size_t few = 16;  // too few to be cut open, as those of a tetrahedron
    return sheet.loops.empty() && sheet.triangles.size() < few;
  };
  while ((mean_side(made.sheet) > size && made.sheet.triangles.size() < options.enough) ||
         is_small_and_closed(made.sheet))
    made.sheet = param::quartered(made.sheet);
  constexpr double least_part = 20.0;
  const AtlasOptions flat{.weights = options.weights,
                          .crease = options.crease,
                          .most_stretch = options.most_stretch,
                          .least_area = least_part * size * size};
  // Creases that are left out are kept where it does not do without them.
  const auto run = [&](const Atlas& atlas) {
    Remesher clear(atlas, options, size, Creases::Clear);
    auto done = clear.run(progress);
    if (!clear.left_out() || (done ? !is_off(*done, options) : ends_it(done.error()))) return done;
    auto all = Remesher(atlas, options, size, Creases::All).run(progress);
    if (!all && done && ends_it(all.error())) return all;
    return all && (!done || is_nearer(*all, *done)) ? all : done;
  };
  // One chart is the best, as far as it keeps its scale.
  const Holes first = has_many_holes(made.sheet) ? Holes::Stay : Holes::Cut;
  const Holes second = first == Holes::Cut ? Holes::Stay : Holes::Cut;
  std::optional<Error> why;
  for (const Holes holes : {first, second}) {
    if (holes != first && !keeps_holes(made.sheet)) break;
    auto atlas = single_chart(made, holes, flat, progress);
    if (atlas && atlas->stretch > flat.most_stretch) continue;
    auto done = atlas ? run(*atlas) : Result<Remeshed>(atlas.error());
    if (done || ends_it(done.error())) return done;
    if (!why) why = done.error();
  }
  auto atlas = several_charts(made, flat, progress);
  auto done = atlas ? run(*atlas) : Result<Remeshed>(atlas.error());
  if (done || ends_it(done.error()) || !why) return done;
  return *why;
}

double deviation(const Sheet& a, const Sheet& b) {
  double most = 0.0;
  const auto take = [&](std::uint32_t, const TriangleTree::Nearest& n) { most = std::max(most, n.distance); };
  // Nobody cancels.
  (void)look(a.points, a.triangles, TriangleTree(b.points, b.triangles), {}, take);
  (void)look(b.points, b.triangles, TriangleTree(a.points, a.triangles), {}, take);
  return most;
}

}  // namespace dobra::surf::remesh
