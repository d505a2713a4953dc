#pragma once
// Domain and constraints -> mesh: curves divided, quadtree, an engine that fills the domain, smoothing; then cracks
// opened, quadrilaterals, second order.

#include <span>
#include <string>

#include "quebra/core/model.h"
#include "quebra/core/size_source.h"
#include "quebra/core/tip_rosettes.h"
#include "shared/base/progress.h"
#include "shared/mesh/fill_engine.h"
#include "shared/mesh/mesh_input.h"
#include "shared/scenario/program.h"

namespace quebra::core {

enum class UseConstraints { Yes, No };
enum class Order { First, Second };
enum class Quadrilaterals { No, Yes };
enum class UseRosettes { No, Yes };

struct MeshParams {
  std::string label;
  double size = 0.0;
  std::string size_formula = {};
  std::string background = {};
  std::string background_field = {};
  DivisionRule division = DivisionRule::Even;
  dobra::base::Angle turn = dobra::base::Angle::from_degrees(15.0);
  double growth = 1.3;
  dobra::mesh::Engine engine = dobra::mesh::Engine::Front;
  int smoothing = 3;
  int max_elements = 20000000;
  UseConstraints constraints = UseConstraints::Yes;
  Order order = Order::First;
  Quadrilaterals quadrilaterals = Quadrilaterals::No;
  UseRosettes rosettes = UseRosettes::No;
  int sectors = 20;
  double tip_radius = 0.0;
  int stop_after = 0;

  template <class D>
  static void describe(D& d) {
    d.field("label", &MeshParams::label, {.title = "Label", .help = "Stands above the picture of this mesh."});
    d.field("size", &MeshParams::size, {.title = "Target size", .help = "Of element sides: on curves none is longer, inside they are about as long, a few by half. 0 takes 1/20 of the domain's diagonal on the boundary and the longest side inside, or the formula or background mesh alone.", .unit = "m", .at_least = 0});
    d.field("size_formula", &MeshParams::size_formula, {.title = "Size by formula", .help = "Of x and y: \"0.1 + 0.05 * hypot(x, y)\"; the least of all sizes counts.", .unit = "m"});
    d.file("background", &MeshParams::background, {.title = "Background mesh", .help = "Its elements' sizes, or those of a field of it, are wanted (.vtu .msh .inp .bdf .nf .ele)."});
    d.field("background_field", &MeshParams::background_field, {.title = "Background field", .help = "Name of the field at the points of a .vtu that holds sizes in m; empty: the sizes of the elements."});
    d.choice("division", &MeshParams::division, {"even", "halving"}, {.title = "Division of curves", .help = "even: as few sides as meet size and turn; halving: sides halved until they do, 2:1 along a curve."});
    d.field("turn", &MeshParams::turn, {.title = "Greatest turn", .help = "That one element side on an arc may span.", .unit = "deg", .above = 0, .at_most = 90});
    d.field("growth", &MeshParams::growth, {.title = "Growth", .help = "Most by which sizes may grow from one element to the next.", .above = 1, .at_most = 10});
    d.choice("engine", &MeshParams::engine, {"front", "delaunay"}, {.title = "Engine", .help = "What places the nodes inside: rows from the boundary inwards, or one by one in a Delaunay triangulation, which is slower."});
    d.field("smoothing", &MeshParams::smoothing, {.title = "Smoothing passes", .at_least = 0, .at_most = 100});
    d.field("max_elements", &MeshParams::max_elements, {.title = "Most elements", .help = "The mesher stops with advice beyond it.", .at_least = 1});
    d.choice("constraints", &MeshParams::constraints, {"yes", "no"}, {.title = "Obey constraints"});
    d.choice("order", &MeshParams::order, {"1", "2"}, {.title = "Order", .help = "2: nodes at mid-sides too, on the true curve."});
    d.choice("quads", &MeshParams::quadrilaterals, {"no", "yes"}, {.title = "Quadrilaterals", .help = "Joins pairs of triangles where that gives a good shape."});
    d.choice("rosettes", &MeshParams::rosettes, {"no", "yes"}, {.title = "Rosettes", .help = "Quarter-point elements round each crack tip; needs order 2."});
    d.field("sectors", &MeshParams::sectors, {.title = "Sectors", .help = "Of a rosette, even.", .at_least = 6, .at_most = 360});
    d.field("tip_radius", &MeshParams::tip_radius, {.title = "Tip elements", .help = "Length of the quarter-point elements; 0 takes 1/80 of the room round the tip: straight end of the crack, ligament, other tips.", .unit = "m", .at_least = 0});
    d.field("stop_after", &MeshParams::stop_after, {.title = "Stop after", .help = "Steps of the engine, one side of its front or one node each: shows it at work. 0: it goes on until the mesh is done.", .at_least = 0});
  }
};

/// What a cycle of the adaptive loop asks of the next mesh.
struct MeshWishes {
  std::vector<dobra::mesh::SizeRequest> sizes = {};
  std::vector<TipRadius> tips = {};  ///< Rosettes; a tip that is not among them takes params.tip_radius.
};

/// Meshes the domain of a model with `wishes` inside, and `source` everywhere, beside those that the model asks for
/// itself: the least of them counts, growth bounded.
/// @param remarks  what the user should know is added to it.
/// @error those of divide and mesh::triangulate, with the place; BadValue for sizes of the source that are not greater than
///        0; TooManyElements before any work if the sizes make more elements than allowed.
dobra::base::Result<Meshed> mesh_domain(const Model& model, const MeshParams& params, const MeshWishes& wishes,
                                        std::vector<std::string>& remarks, const dobra::base::Progress& progress, const SizeSource& source = {});

/// Adds one mesh to the model; or, if the engine is stopped before it is done, what it has made so far.
/// @error those of mesh_domain, SizeSource::make.
dobra::base::Result<Model> add_mesh(const Model& model, const MeshParams& params, const dobra::scenario::Context& context,
                                    const dobra::base::Progress& progress);

}  // namespace quebra::core
