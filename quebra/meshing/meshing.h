#pragma once
// Domain and constraints -> mesh: curves divided, quadtree, an engine that fills the domain, smoothing; then cracks
// opened, quadrilaterals, second order.

#include <span>
#include <string>

#include "quebra/meshing/size_source.h"
#include "quebra/meshing/tip_rosettes.h"
#include "quebra/model/model.h"
#include "shared/base/progress.h"
#include "shared/mesh/delaunay/mesh_input.h"
#include "shared/mesh/front/fill_engine.h"
#include "shared/scenario/lines/line_keys.h"
#include "shared/scenario/program.h"

namespace quebra::meshing {

enum class UseConstraints { Yes, No };
enum class Order { First, Second };
enum class Quadrilaterals { No, Yes };
enum class UseRosettes { No, Yes };
/// Paper: [miranda2009surface] as it is written.
enum class EngineChoice { Front, Delaunay, Paper };

/// What every mesh obeys, that of a mesh step and each of an adaptive loop. A base of MeshParams and AdaptParams.
struct MeshRules {
  std::string size_formula, background, background_field;
  sketch::DivisionRule division = sketch::DivisionRule::Even;
  dobra::base::Angle turn = dobra::base::Angle::from_degrees(15.0);
  double chord = 0.0;
  double growth = 1.3;
  double narrow = 1.0;
  EngineChoice engine = EngineChoice::Front;
  int smoothing = 3;
  int max_elements = 20000000;
  UseConstraints constraints = UseConstraints::Yes;
  Order order = Order::First;
  UseRosettes rosettes = UseRosettes::No;
  int sectors = 20;
  double tip_radius = 0.0;

  template <class P, class D>
  static void describe_in(D& d) {
    d.field(
        "size_formula", of<P>(&MeshRules::size_formula),
        {.title = "Size by formula",
         .help = "Of x and y: \"0.1 + 0.05 * hypot(x, y)\"; the least of all sizes counts. On surfaces of x, y, z and, "
                 "where one is meshed, of the u and v of its chart.",
         .unit = "m",
         .of_space = true});
    d.file("background", of<P>(&MeshRules::background),
           {.title = "Background mesh",
            .help = "Its elements' sizes, or those of a field of it, are wanted.",
            .files = dobra::scenario::lines::file_kinds({dobra::io::formats::Use::ReadMesh})});
    d.field("background_field", of<P>(&MeshRules::background_field),
            {.title = "Background field",
             .help = "Name of the field at the points of a VTK mesh that holds sizes in m; empty: the sizes of the "
                     "elements.",
             .when = "background is set"});
    d.choice(
        "division", of<P>(&MeshRules::division), {"even", "halving"},
        {.title = "Division of curves",
         .help = "even: as few sides as meet size and turn; halving: sides halved until they do, 2:1 along a curve."});
    d.field("turn", of<P>(&MeshRules::turn),
            {.title = "Greatest turn",
             .help = "That one element side on an arc may span; of a surface, that its normal may turn along a side.",
             .unit = "deg",
             .above = 0,
             .at_most = 90});
    d.field("chord", of<P>(&MeshRules::chord),
            {.title = "Greatest distance from a surface",
             .help = "Of the elements' sides; 0 does not ask. Of surfaces in space only.",
             .unit = "m",
             .at_least = 0});
    d.field("growth", of<P>(&MeshRules::growth),
            {.title = "Growth",
             .help = "Most by which sizes may grow from one element to the next; 1.17 on surfaces where left out.",
             .above = 1,
             .at_most = 10});
    d.field("narrow", of<P>(&MeshRules::narrow),
            {.title = "Across narrow places",
             .help = "Elements wanted across the material where curves, crack tips or points come near each other: "
                     "sides there are divided as finely. 0: sides are as long as elsewhere.",
             .at_least = 0,
             .at_most = 20});
    d.choice("engine", of<P>(&MeshRules::engine), {"front", "delaunay", "paper"},
             {.title = "Engine",
              .help = "What places the nodes inside: rows from the boundary inwards; one by one in a Delaunay "
                      "triangulation, which is slower (plane domains only); or the front of [miranda2009surface] as it "
                      "is written."});
    d.field("smoothing", of<P>(&MeshRules::smoothing), {.title = "Smoothing passes", .at_least = 0, .at_most = 100});
    d.field("max_elements", of<P>(&MeshRules::max_elements),
            {.title = "Most elements", .help = "The mesher stops with advice beyond it.", .at_least = 1});
    d.choice("constraints", of<P>(&MeshRules::constraints), {"yes", "no"}, {.title = "Obey constraints"});
    d.choice("order", of<P>(&MeshRules::order), {"1", "2"},
             {.title = "Order", .help = "2: nodes at mid-sides too, on the true curve."});
    d.choice("rosettes", of<P>(&MeshRules::rosettes), {"no", "yes"},
             {.title = "Rosettes",
              .help = "Quarter-point elements round each crack tip; needs order 2. A loop makes them smaller if they "
                      "hold too much of the error."});
    d.field(
        "sectors", of<P>(&MeshRules::sectors),
        {.title = "Sectors", .help = "Of a rosette, even.", .at_least = 6, .at_most = 360, .when = "rosettes = yes"});
    d.field("tip_radius", of<P>(&MeshRules::tip_radius),
            {.title = "Tip elements",
             .help = "Length of the quarter-point elements, of the first mesh in a loop; 0 takes 1/80 of the room "
                     "round the tip: straight end of the crack, ligament, other tips, named points.",
             .unit = "m",
             .at_least = 0,
             .when = "rosettes = yes"});
  }

 private:
  template <class P, class T>
  static T P::*of(T MeshRules::*member) {
    return member;
  }
};

struct MeshParams : MeshRules {
  std::string label;
  double size = 0.0;
  Quadrilaterals quadrilaterals = Quadrilaterals::No;
  int stop_after = 0;

  template <class D>
  static void describe(D& d) {
    d.field("label", &MeshParams::label, {.title = "Label", .help = "Stands above the picture of this mesh."});
    d.field("size", &MeshParams::size,
            {.title = "Target size",
             .help = "Of element sides: on curves none is longer, inside they are about as long, a few by half. 0 "
                     "takes 1/20 of the domain's diagonal on the boundary and the longest side inside, or the formula "
                     "or background mesh alone.",
             .unit = "m",
             .at_least = 0});
    MeshRules::describe_in<MeshParams>(d);
    d.choice("quads", &MeshParams::quadrilaterals, {"no", "yes"},
             {.title = "Quadrilaterals", .help = "Joins pairs of triangles where that gives a good shape."});
    d.field("stop_after", &MeshParams::stop_after,
            {.title = "Stop after",
             .help = "Steps of the engine, one side of its front or one node each: shows it at work. 0: it goes on "
                     "until the mesh is done.",
             .at_least = 0});
  }
};

/// What a cycle of the adaptive loop asks of the next mesh.
struct MeshWishes {
  std::vector<dobra::mesh::delaunay::SizeRequest> sizes = {};
  std::vector<TipRadius> tips = {};  ///< Rosettes; a tip that is not among them takes params.tip_radius.
};

/// Meshes the domain of a model with `wishes` inside, and `source` everywhere, beside those that the model asks for
/// itself: the least of them counts, growth bounded.
/// @param remarks  what the user should know is added to it.
/// @error those of divide and mesh::triangulate, with the place; BadValue for sizes of the source that are not greater
///        than 0; TooManyElements before any work if the sizes make more elements than allowed.
dobra::base::Result<model::Meshed> mesh_domain(const model::Model& model, const MeshParams& params,
                                               const MeshWishes& wishes, std::vector<std::string>& remarks,
                                               const dobra::base::Progress& progress, const SizeSource& source = {});

/// Adds one mesh to the model; or, if the engine is stopped before it is done, what it has made so far.
/// @error those of mesh_domain, SizeSource::make.
dobra::base::Result<model::Model> add_mesh(const model::Model& model, const MeshParams& params,
                                           const dobra::scenario::Context& context,
                                           const dobra::base::Progress& progress);

}  // namespace quebra::meshing
