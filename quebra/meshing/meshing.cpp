#include "quebra/meshing/meshing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "quebra/domain/domain.h"
#include "quebra/meshing/half_crack.h"
#include "quebra/meshing/narrow.h"
#include "quebra/meshing/zone.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/lips.h"
#include "shared/mesh/order2.h"
#include "shared/mesh/recombine.h"
#include "shared/surf/paper/paper_mesher.h"

namespace quebra::meshing {
namespace {

using dobra::base::Error;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Point;
using dobra::geom::Segment;
using dobra::mesh::ElementMesh;
using dobra::mesh::MiddleOfCurve;
using dobra::mesh::NodeId;
using dobra::mesh::SecondOrder;
using dobra::mesh::TriangleMesh;
using dobra::mesh::delaunay::EdgeKind;
using dobra::mesh::delaunay::MeshInput;

/// Builds the input of the mesher; equal points become one node.
class InputBuilder {
 public:
  std::uint32_t add_set(std::string name, EdgeKind kind) {
    input_.sets.push_back({std::move(name), kind});
    return static_cast<std::uint32_t>(input_.sets.size() - 1);
  }
  NodeId node(Point p) {
    const auto [at, added] = nodes_.try_emplace(p, input_.points.size());
    if (added) input_.points.push_back(p);
    return at->second;
  }
  void edge(Point from, Point to, std::uint32_t set) {
    const NodeId a = node(from);
    const NodeId b = node(to);
    if (a != b) input_.edges.push_back({{a, b}, set});
  }
  void size(Point at, double size) { input_.sizes.push_back({at, size}); }
  void name(const std::string& set, Point at) { input_.node_sets[set].push_back(node(at)); }
  MeshInput take() { return std::move(input_); }

 private:
  MeshInput input_;
  std::map<Point, NodeId> nodes_;
};

std::vector<sketch::Stop> stops_on(std::size_t curve, const domain::Domain& domain,
                                   const std::vector<model::Constraint>& constraints) {
  std::vector<sketch::Stop> stops;
  for (const domain::Junction& junction : domain.junctions) {
    if (junction.curve == curve) stops.push_back({junction.s, 0.0});
  }
  const sketch::Curve& own = domain.curves[curve];
  const std::array ends{std::pair{0.0, point(own, 0.0)}, std::pair{length(own), point(own, length(own))}};
  for (const sketch::NamedPoint& named : domain.points) {
    if (!(named.size > 0.0)) continue;
    for (const auto& [s, at] : ends) {
      if (at == named.at) stops.push_back({s, named.size});
    }
    for (const domain::Junction& junction : domain.junctions) {
      if (junction.curve == curve && junction.at == named.at) stops.push_back({junction.s, named.size});
    }
  }
  for (const model::Constraint& constraint : constraints) {
    for (const auto& foot : constraint.feet) {
      if (foot.curve == curve) stops.push_back({foot.s, constraint.spacing});
    }
  }
  return stops;
}

/// The nodes of a curve in order; at a junction exactly its point.
std::vector<Point> nodes_on(const domain::Domain& domain, std::size_t curve, const std::vector<double>& s) {
  std::vector<Point> nodes = points(domain.curves[curve], s);
  for (const domain::Junction& junction : domain.junctions) {
    if (junction.curve != curve) continue;
    const auto above = std::lower_bound(s.begin(), s.end(), junction.s);
    const bool before = above != s.begin() && (above == s.end() || junction.s - *(above - 1) < *above - junction.s);
    nodes[static_cast<std::size_t>(above - s.begin()) - (before ? 1 : 0)] = junction.at;
  }
  if (closed(domain.curves[curve])) nodes.back() = nodes.front();
  return nodes;
}

EdgeKind kind_of(sketch::Role role) {
  switch (role) {
    case sketch::Role::Boundary:
    case sketch::Role::Hole:
      return EdgeKind::Boundary;
    case sketch::Role::Internal:
      return EdgeKind::Interface;
    case sketch::Role::Crack:
      break;
  }
  return EdgeKind::Constraint;
}

/// How many pieces of a side meet the sizes wanted along it.
int pieces_of(const Segment& side, const std::function<double(Point)>& wanted) {
  double size = side.length();
  for (const double f : {0.25, 0.5, 0.75}) size = std::min(size, wanted(interpolate(side.from, side.to, f)));
  return std::max(1, static_cast<int>(std::lround(side.length() / size)));
}

Result<MeshInput> mesh_input(const model::Model& model, const std::vector<model::Constraint>& constraints,
                             std::span<const dobra::mesh::delaunay::SizeRequest> sizes,
                             const std::vector<TipRosette>& rosettes, const sketch::DivideOptions& options) {
  const domain::Domain& domain = model.domain;
  InputBuilder builder;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    const auto set = builder.add_set(curve.name, kind_of(curve.role));
    DOBRA_TRY(const std::vector<double> s, divide(curve, stops_on(c, domain, constraints), options));
    const std::vector<Point> nodes = nodes_on(domain, c, s);
    for (std::size_t i = 1; i < nodes.size(); ++i) builder.edge(nodes[i - 1], nodes[i], set);
    if (curve.tip_size > 0.0) {
      builder.size(nodes.front(), curve.tip_size);
      builder.size(nodes.back(), curve.tip_size);
    }
  }
  for (const model::Constraint& constraint : constraints) {
    const auto set = builder.add_set(constraint.name, EdgeKind::Constraint);
    for (std::size_t i = 0; i < constraint.line.segment_count(); ++i) {
      const Point from = constraint.line.segment(i).from, to = constraint.line.segment(i).to;
      // A cycle of the adaptive loop asks for sizes below those of the constraint.
      const int pieces = sizes.empty() || !options.limit ? 1 : pieces_of({from, to}, options.limit);
      const bool swapped = to < from;  // the same points from both ends
      const auto at = [&](int k) {
        return k == 0        ? from
               : k == pieces ? to
               : swapped     ? interpolate(to, from, static_cast<double>(pieces - k) / pieces)
                             : interpolate(from, to, static_cast<double>(k) / pieces);
      };
      for (int k = 0; k < pieces; ++k) builder.edge(at(k), at(k + 1), set);
    }
  }
  for (const sketch::NamedPoint& named : domain.points) {
    if (!named.name.empty()) builder.name(named.name, named.at);
    if (named.size > 0.0) builder.size(named.at, named.size);
  }
  for (const model::Zone& zone : model.zones) {
    for (const Point p : points_of(zone, domain)) builder.size(p, zone.size);
  }
  for (const auto& request : sizes) builder.size(request.at, request.size);
  for (const TipRosette& tip : rosettes)
    builder.size(tip.rosette.tip, distance(tip.rosette.rings.back()[0], tip.rosette.rings.back()[1]));
  MeshInput input = builder.take();
  for (const domain::Face& face : domain.faces) input.regions.push_back({face.inside, face.region});
  return input;
}

/// One a curve: whether it keeps the subdivision it asks for.
std::vector<std::uint8_t> keeping(const domain::Domain& domain, const std::vector<model::Constraint>& constraints) {
  std::vector<std::uint8_t> keeps;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Division& said = domain.curves[c].division;
    const bool asks = said.segments > 0 || said.ratio != 1.0;
    keeps.push_back(asks && explicit_division(domain.curves[c], stops_on(c, domain, constraints)) ? 1 : 0);
  }
  return keeps;
}

/// Curves that cannot keep the subdivision they ask for.
void remark_on_divisions(const domain::Domain& domain, const std::vector<std::uint8_t>& keeps,
                         std::vector<std::string>& remarks) {
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    if ((curve.division.segments == 0 && curve.division.ratio == 1.0) || keeps[c] != 0) continue;
    remarks.push_back(fmt::format(
        "`segments` and `ratio` of curve '{}' give way to the sizes of the offset constraints or points on it",
        curve.name));
  }
}

/// What comes near a place that nothing was asked for.
std::string beside(const NarrowPlaces::Left& left, const domain::Domain& domain) {
  if (left.beside == domain.curves.size()) return "a point";
  return left.beside == left.curve ? "another part of it" : fmt::format("'{}'", domain.curves[left.beside].name);
}

/// Curves that keep theirs though something comes nearer than their sides are long.
void remark_on_kept(const domain::Domain& domain, const std::vector<NarrowPlaces::Left>& all,
                    std::vector<std::string>& remarks) {
  for (const auto& kept : all) {
    remarks.push_back(fmt::format(
        "curve '{}' keeps its {}, with sides of {:.3g} m at ({:.6g}, {:.6g}), {:.3g} m from {}: elements between are "
        "as flat; divide it more finely or leave its subdivision to `narrow`",
        domain.curves[kept.curve].name, domain.curves[kept.curve].division.segments > 0 ? "`segments`" : "`ratio`",
        kept.side, kept.at.x, kept.at.y, kept.width, beside(kept, domain)));
  }
}

/// Places that are too narrow to ask for sides as short: once for both of their curves, and not where a sliver is told.
void remark_on_slight(const model::Model& model, const std::vector<NarrowPlaces::Left>& all,
                      std::vector<std::string>& remarks) {
  std::set<std::pair<std::size_t, std::size_t>> told;
  const auto& curves = model.domain.curves;
  for (const auto& slight : all) {
    const bool known = std::any_of(model.findings.begin(), model.findings.end(), [&](const sketch::Finding& finding) {
      if (finding.wrong != sketch::Wrong::Sliver) return false;
      if (distance(finding.at, slight.at) <= slight.side) return true;
      if (slight.beside == curves.size()) return false;
      const std::string& one = curves[slight.curve].name;
      const std::string& two = curves[slight.beside].name;
      return finding.curve == one + ", " + two || finding.curve == two + ", " + one;
    });
    if (known || !told.insert(std::minmax({slight.curve, slight.beside})).second) continue;
    remarks.push_back(fmt::format(
        "curve '{}', with sides of {:.3g} m at ({:.6g}, {:.6g}), is {:.3g} m from {}: too near for `narrow`, and "
        "elements between are flat; use a smaller size there, or close the gap",
        curves[slight.curve].name, slight.side, slight.at.x, slight.at.y, slight.width, beside(slight, model.domain)));
  }
}

Error too_many(double triangles, const std::string& of, const MeshParams& params) {
  return {
      dobra::base::ErrorCode::TooManyElements,
      fmt::format(
          "{} makes about {:.3g} triangles, more than the {} allowed; use greater sizes{}, or raise max_elements", of,
          triangles, params.max_elements,
          params.size > 0.0 ? fmt::format(" (about {:.3g} times)", std::sqrt(triangles / params.max_elements)) : "")};
}

/// What an estimate may err by: only what is surely too much is refused before it is tried.
constexpr double sure = 1.25;

/// Refuses a uniform size that is too small, before anything is divided.
Result<void> check_size(const domain::Domain& domain, const MeshParams& params) {
  if (!(params.size > 0.0)) return {};
  double area = 0.0;
  for (const domain::Face& face : domain.faces) area += face.area;
  const double triangles = 4.0 / std::numbers::sqrt3 * area / (params.size * params.size);
  if (triangles <= sure * params.max_elements) return {};
  return too_many(triangles, fmt::format("a size of {:.6g} m over {:.6g} m2", params.size, area), params);
}

/// The same for sizes that vary.
Result<void> check_field(const dobra::mesh::sizing::SizeField& field, const domain::Domain& domain,
                         const MeshParams& params) {
  if (field.estimated_triangles() <= sure * params.max_elements) return {};
  const domain::Inside inside(domain);
  const double triangles = field.estimated_triangles([&](Point p) { return inside(p); });
  if (triangles <= sure * params.max_elements) return {};
  return too_many(
      triangles, "what curves, points, zones, narrow places (`narrow = 0` leaves them), formula and background ask for",
      params);
}

/// The middle between two neighbouring nodes of a curve that bends.
MiddleOfCurve middle_of(const Arc& arc) {
  return [arc](Point from, Point to) {
    const Point chord = midpoint(from, to);
    const auto ray = chord - arc.centre();
    const double distance = length(ray);
    return distance > 0.0
               ? arc.centre() + (0.5 * (length(from - arc.centre()) + length(to - arc.centre())) / distance) * ray
               : chord;
  };
}
MiddleOfCurve middle_of(const sketch::Curve& curve, const sketch::Smooth& smooth) {
  return [&curve, &smooth](Point from, Point to) {
    const auto at = [&](Point p) {
      const auto& chords = smooth.chords();
      std::size_t best = 0;
      for (std::size_t i = 1; i + 1 < chords.points.size(); ++i) {
        const auto gap = [&](std::size_t k) { return distance(Segment{chords.points[k], chords.points[k + 1]}, p); };
        if (gap(i) < gap(best)) best = i;
      }
      const double f = nearest_fraction({chords.points[best], chords.points[best + 1]}, p);
      return chords.s[best] + f * (chords.s[best + 1] - chords.s[best]);
    };
    double s = at(from);
    double t = at(to);
    // Across the seam of a closed curve the way through it is the short one.
    if (closed(curve) && std::abs(t - s) > 0.5 * smooth.length()) (s < t ? s : t) += smooth.length();
    return smooth.point(std::fmod(0.5 * (s + t), smooth.length() * (1.0 + 1e-12)));
  };
}

std::map<std::string, MiddleOfCurve> bent_sides(const domain::Domain& domain) {
  std::map<std::string, MiddleOfCurve> middles;
  for (const sketch::Curve& curve : domain.curves) {
    std::vector<std::string> sets{curve.name};
    if (curve.role == sketch::Role::Crack) sets = {curve.name + "_left", curve.name + "_right"};
    for (const std::string& set : sets) {
      if (const auto* arc = std::get_if<Arc>(&curve.shape)) middles[set] = middle_of(*arc);
      if (const auto* smooth = std::get_if<sketch::Smooth>(&curve.shape)) middles[set] = middle_of(curve, *smooth);
    }
  }
  return middles;
}

/// From the triangles to the elements that the user asked for.
Result<ElementMesh> elements_of(const TriangleMesh& triangles, const model::Model& model, const MeshParams& params,
                                const std::vector<TipRosette>& rosettes, std::vector<std::string>& remarks) {
  const domain::Domain& domain = model.domain;
  ElementMesh mesh = element_mesh_of(triangles);
  DOBRA_TRY_VOID(fill(mesh, rosettes));
  mesh.region_names = domain.region_names;
  std::vector<std::string> cracks;
  for (const sketch::Curve& curve : domain.curves) {
    for (const std::string& group : curve.groups) {
      const auto& sides = mesh.side_sets.at(curve.name);
      mesh.side_sets[group].insert(mesh.side_sets[group].end(), sides.begin(), sides.end());
    }
    if (curve.role == sketch::Role::Crack) cracks.push_back(curve.name);
  }
  if (!cracks.empty()) {
    DOBRA_TRY(mesh, open_lips(std::move(mesh), cracks));
  }
  DOBRA_TRY_VOID(name_half_tips(mesh, model.half_tips));
  if (params.quadrilaterals == Quadrilaterals::Yes) mesh = recombine(mesh);
  if (params.order == Order::First) return mesh;
  SecondOrder second = to_second_order(std::move(mesh), bent_sides(domain));
  for (const auto& side : second.straightened) {
    const auto nodes = side_nodes(second.mesh, side);
    const Point at = second.mesh.point(nodes[2]);
    remarks.push_back(fmt::format(
        "the side at ({:.6g}, {:.6g}) stays straight: its curve would invert the element; use smaller sides there",
        at.x, at.y));
  }
  if (!rosettes.empty()) DOBRA_TRY_VOID(dobra::fem::fracture::set_quarter_points(second.mesh));
  return std::move(second.mesh);
}

/// Seconds since the last call.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What the mesher is given.
struct Prepared {
  MeshInput input;
  dobra::mesh::front::MeshOptions options;
  std::vector<TipRosette> rosettes;
};

const std::vector<model::Constraint>& obeyed(const model::Model& model, const MeshParams& params) {
  static const std::vector<model::Constraint> none;
  return params.constraints == UseConstraints::Yes ? model.constraints : none;
}

Result<Prepared> prepare(const model::Model& model, const MeshParams& params, const MeshWishes& wishes,
                         const SizeSource& source, std::vector<std::string>& remarks) {
  // A formula or a background mesh alone says what is wanted.
  const double size = params.size > 0.0 ? params.size : model.domain.box().diagonal() / (source.empty() ? 20.0 : 1.0);
  DOBRA_TRY_VOID(check_size(model.domain, params));
  const auto& constraints = obeyed(model, params);
  Prepared prepared;
  if (params.rosettes == UseRosettes::Yes) {
    if (params.order != Order::Second || params.quadrilaterals == Quadrilaterals::Yes) {
      return dobra::base::Error{
          dobra::base::ErrorCode::BadValue,
          "rosettes are made of triangles of second order: give order = \"2\" and no quadrilaterals"};
    }
    DOBRA_TRY(prepared.rosettes, tip_rosettes(model.domain, model.half_tips,
                                              {.sectors = params.sectors, .radius = params.tip_radius}, wishes.tips));
  }
  dobra::mesh::front::MeshOptions& options = prepared.options;
  options.engine = params.engine == EngineChoice::Delaunay ? dobra::mesh::front::Engine::Delaunay
                                                           : dobra::mesh::front::Engine::Front;
  options.sizes.growth = params.growth;
  options.sizes.max_size = params.size;
  options.sizes.function = source.function();
  options.smoothing.passes = params.smoothing;
  options.points.max_triangles = static_cast<std::size_t>(params.max_elements);
  sketch::DivideOptions divide{.size = size,
                               .turn = params.turn,
                               .growth = params.growth,
                               .limit = {},
                               .rule = params.division,
                               .most = static_cast<std::size_t>(params.max_elements)};
  DOBRA_TRY(MeshInput coarse, mesh_input(model, constraints, wishes.sizes, prepared.rosettes, divide));
  const std::vector<std::uint8_t> keeps = keeping(model.domain, constraints);
  remark_on_divisions(model.domain, keeps, remarks);
  NarrowOptions narrow{.across = params.narrow, .size = [size](Point) { return size; }};
  std::optional<dobra::mesh::sizing::SizeField> elsewhere;
  prepared.input = coarse;
  if (!source.empty() && params.narrow > 0.0) {  // What is narrow depends on the sizes that it gives.
    const auto built = dobra::mesh::front::size_field_of(coarse, options.sizes);
    DOBRA_TRY_VOID(source.check());
    DOBRA_TRY(elsewhere, built);
    DOBRA_TRY_VOID(check_field(*elsewhere, model.domain, params));
    narrow.size = divide.limit = [&elsewhere](Point p) { return elsewhere->size_at(p); };
    DOBRA_TRY(prepared.input, mesh_input(model, constraints, wishes.sizes, prepared.rosettes, divide));
  }
  NarrowPlaces places = narrow_places(model.domain, prepared.input, keeps, narrow);
  remark_on_kept(model.domain, places.kept, remarks);
  constexpr double steep = 1.7;
  if (!places.sizes.empty() && params.growth > steep) {
    remarks.push_back(fmt::format(
        "growth = {:.3g} leads away from narrow places so fast that elements beside them are flat; use {} or less",
        params.growth, steep));
  }
  // Curves that pass something finer are divided again, so that sizes grow along them as they do inside; and again
  // while bent ones turn out to come nearer to others than their first chords did.
  constexpr int most_divisions = 8;
  std::vector<dobra::mesh::delaunay::SizeRequest> narrow_sizes;
  for (int division = 0; division < most_divisions; ++division) {
    coarse.sizes.insert(coarse.sizes.end(), places.sizes.begin(), places.sizes.end());
    narrow_sizes.insert(narrow_sizes.end(), places.sizes.begin(), places.sizes.end());
    const auto built = dobra::mesh::front::size_field_of(coarse, options.sizes);
    DOBRA_TRY_VOID(source.check());
    DOBRA_TRY(const auto field, built);
    DOBRA_TRY_VOID(check_field(field, model.domain, params));
    divide.limit = [&field](Point p) { return field.size_at(p); };
    DOBRA_TRY(prepared.input, mesh_input(model, constraints, wishes.sizes, prepared.rosettes, divide));
    if (places.sizes.empty() || places.again.empty()) break;
    narrow.only = std::move(places.again);
    narrow.smallest = 0.1;  // of sides that are short there by now
    narrow.floor = 1e-3 * size;
    narrow.points = false;
    places = narrow_places(model.domain, prepared.input, keeps, narrow);
    if (places.sizes.empty()) break;
  }
  remark_on_slight(model, places.slight, remarks);
  prepared.input.sizes.insert(prepared.input.sizes.end(), narrow_sizes.begin(), narrow_sizes.end());
  DOBRA_TRY_VOID(cut_out(prepared.input, prepared.rosettes));
  return prepared;
}

/// The mesher of the paper in the plane: a surface that is flat.
Result<TriangleMesh> by_paper(const MeshInput& input, const MeshParams& params, const dobra::base::Progress& progress) {
  dobra::geom::Box box;
  for (const Point p : input.points) box.add(p);
  DOBRA_TRY(auto plane, dobra::surf::Surface::plane({}, box));
  dobra::surf::mesh::ChartInput chart{std::move(plane), input, {}, {}};
  for (const Point p : input.points) {
    chart.at.push_back({p.x, p.y, 0.0});
    chart.node.push_back(static_cast<std::uint32_t>(chart.node.size()));
  }
  dobra::surf::paper::PaperOptions options;
  options.largest = params.size;
  options.turn = params.turn.degrees();
  options.passes = params.smoothing;
  options.most_triangles = static_cast<std::size_t>(params.max_elements);
  auto made = dobra::surf::paper::paper_mesh(chart, options, progress);
  if (!made) {
    dobra::base::Error error = made.error();
    if (error.place) error.place->z = error.place->u = error.place->v = std::nullopt;
    return error;
  }
  return std::move(made->chart);
}

std::string name_of_next(const model::Model& model, const MeshParams& params) {
  return !params.label.empty() ? params.label : fmt::format("Mesh {}", model.meshes.size() + 1);
}

/// The engine after `params.stop_after` steps; nothing if it is done by then.
Result<std::shared_ptr<const model::MeshWork>> work_on(const model::Model& model, const MeshParams& params,
                                                       const SizeSource& source,
                                                       const dobra::base::Progress& progress) {
  std::vector<std::string> remarks;  // of the finished mesh only
  DOBRA_TRY(const Prepared prepared, prepare(model, params, {}, source, remarks));
  DOBRA_TRY(dobra::mesh::front::Mesher mesher,
            dobra::mesh::front::Mesher::start(prepared.input, prepared.options, progress));
  DOBRA_TRY_VOID(source.check());
  for (int step = 0; step < params.stop_after && !mesher.done(); ++step) DOBRA_TRY_VOID(mesher.step(1, progress));
  if (mesher.done()) return std::shared_ptr<const model::MeshWork>();
  dobra::mesh::front::Mesher::View view = mesher.view();
  return std::make_shared<const model::MeshWork>(
      model::MeshWork{name_of_next(model, params), static_cast<std::size_t>(params.stop_after),
                      std::move(view.triangles.points), std::move(view.triangles.triangles), std::move(view.front)});
}

}  // namespace

Result<model::Meshed> mesh_domain(const model::Model& model, const MeshParams& params, const MeshWishes& wishes,
                                  std::vector<std::string>& remarks, const dobra::base::Progress& progress,
                                  const SizeSource& source) {
  const auto& constraints = obeyed(model, params);
  Stopwatch watch;
  model::Meshed meshed;
  const auto done = [&](const char* phase) {
    meshed.seconds.push_back({phase, watch.lap()});
    return progress.check();
  };
  DOBRA_TRY(const Prepared prepared, prepare(model, params, wishes, source, remarks));
  DOBRA_TRY_VOID(done("divide"));
  TriangleMesh triangles;
  if (params.engine == EngineChoice::Paper) {
    DOBRA_TRY(triangles, by_paper(prepared.input, params, progress));
    DOBRA_TRY(auto sizes, dobra::mesh::front::size_field_of(prepared.input, prepared.options.sizes));
    DOBRA_TRY_VOID(source.check());
    meshed.sizes = std::make_shared<const dobra::mesh::sizing::SizeField>(std::move(sizes));
  } else {  // The mesher's memory is given back before the elements are made.
    DOBRA_TRY(auto mesher, dobra::mesh::front::Mesher::start(prepared.input, prepared.options, progress));
    DOBRA_TRY_VOID(source.check());
    constexpr std::size_t between_checks = 8192;
    while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(between_checks, progress));
    triangles = mesher.mesh();
    meshed.sizes = std::make_shared<const dobra::mesh::sizing::SizeField>(mesher.sizes());
  }
  DOBRA_TRY_VOID(done("triangulate"));
  DOBRA_TRY(meshed.mesh, elements_of(triangles, model, params, prepared.rosettes, remarks));
  DOBRA_TRY_VOID(done("elements"));
  meshed.quality = dobra::mesh::quality_of(triangles);
  meshed.elements = dobra::mesh::element_quality_of(meshed.mesh);
  DOBRA_TRY_VOID(done("quality"));
  for (const model::Constraint& constraint : constraints)
    meshed.constraint_edges += triangles.constraint_sets.at(constraint.name).size();
  meshed.name = name_of_next(model, params);
  meshed.constraints = constraints.size();
  return meshed;
}

Result<model::Model> add_mesh(const model::Model& model, const MeshParams& params,
                              const dobra::scenario::Context& context, const dobra::base::Progress& progress) {
  model::Model result = model;
  result.work.reset();
  DOBRA_TRY(const SizeSource source,
            SizeSource::make(model.domain, params.size_formula, params.background, params.background_field, context));
  if (params.stop_after > 0 && params.engine == EngineChoice::Paper) {
    return dobra::base::Error{dobra::base::ErrorCode::NotSupported,
                              "`stop_after` shows the engines front and delaunay at work; set it to 0"};
  }
  if (params.stop_after > 0) {
    DOBRA_TRY(result.work, work_on(model, params, source, progress));
    if (result.work) {
      result.remarks.push_back(fmt::format(
          "{} was stopped after {} steps, with {} triangles and {} sides in its front; stop_after = 0 finishes it",
          result.work->name, result.work->steps, result.work->triangles.size(), result.work->front.size()));
      return result;
    }
  }
  DOBRA_TRY(model::Meshed meshed, mesh_domain(model, params, {}, result.remarks, progress, source));
  result.meshes.push_back(std::make_shared<const model::Meshed>(std::move(meshed)));
  return result;
}

}  // namespace quebra::meshing
