#pragma once
// The adaptive loop: mesh, analyse, estimate the error, ask for new sizes, mesh again, until the error asked for.
// Page: docs/algorithms/estimate.md. Source: [zienkiewicz1992spr], [ladeveze1991].

#include "quebra/core/analysis.h"
#include "quebra/core/meshing.h"

namespace quebra::core {

enum class RuleOfSizes { Optimal, Equal };
enum class MindPeaks { Yes, No };
enum class StartFrom { First, Last };

struct AdaptParams : EstimateParams {
  double target = 5.0;
  RuleOfSizes rule = RuleOfSizes::Optimal;
  MindPeaks peaks = MindPeaks::Yes;
  int max_cycles = 8;
  StartFrom from = StartFrom::First;
  double size = 0.0;
  double min_size = 0.0;
  double growth = 1.3;
  dobra::base::Angle turn = dobra::base::Angle::from_degrees(30.0);
  DivisionRule division = DivisionRule::Even;
  Order order = Order::Second;
  UseConstraints constraints = UseConstraints::Yes;
  UseRosettes rosettes = UseRosettes::No;
  double tip_radius = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("target", &AdaptParams::target, {.title = "Error asked for", .help = "In the energy norm.", .unit = "%", .above = 0, .at_most = 99});
    d.choice("rule", &AdaptParams::rule, {"optimal", "equal"}, {.title = "Rule of sizes", .help = "optimal: fewest elements; equal: the same error in each."});
    d.choice("peaks", &AdaptParams::peaks, {"yes", "no"}, {.title = "Mind peaks", .help = "Asks for the same error in the elements round each peak of stress: the whole may meet it with a peak that does not."});
    d.field("max_cycles", &AdaptParams::max_cycles, {.title = "Most cycles", .at_least = 1, .at_most = 100});
    d.choice("from", &AdaptParams::from, {"first", "last"}, {.title = "Begin with", .help = "first: a mesh of the first size; last: the mesh after the last cycle so far. With most cycles 1 that is one cycle at a time."});
    d.field("size", &AdaptParams::size, {.title = "First size", .help = "And greatest; 0 takes 1/8 of the domain's diagonal.", .unit = "m", .at_least = 0});
    d.field("min_size", &AdaptParams::min_size, {.title = "Least size", .unit = "m", .at_least = 0});
    d.field("growth", &AdaptParams::growth, {.title = "Growth", .help = "Most by which sizes may grow from one element to the next.", .above = 1, .at_most = 10});
    d.field("turn", &AdaptParams::turn, {.title = "Greatest turn", .help = "That one element side on an arc may span.", .unit = "deg", .above = 0, .at_most = 90});
    d.choice("division", &AdaptParams::division, {"even", "halving"}, {.title = "Division of curves", .help = "even: as few sides as meet the sizes; halving: sides halved until they do, 2:1 along a curve."});
    d.choice("order", &AdaptParams::order, {"1", "2"}, {.title = "Order"});
    d.choice("constraints", &AdaptParams::constraints, {"yes", "no"}, {.title = "Obey constraints"});
    d.choice("rosettes", &AdaptParams::rosettes, {"no", "yes"}, {.title = "Rosettes", .help = "Quarter-point elements at crack tips; smaller ones if they hold too much of the error."});
    d.field("tip_radius", &AdaptParams::tip_radius, {.title = "First tip elements", .help = "Length of the quarter-point elements of the first mesh; 0 takes 1/80 of the room round each tip.", .unit = "m", .at_least = 0});
    EstimateParams::describe_in<AdaptParams>(d);
  }
};

/// Adds the mesh and the analysis of every cycle; a remark says why the loop stopped if the target was not reached.
/// @error BadValue: no problem, or no cycle to go on from; those of mesh_domain and analyse
dobra::base::Result<Model> adapt(const Model& model, const AdaptParams& params, const dobra::scenario::Context& context,
                                 const dobra::base::Progress& progress);

}  // namespace quebra::core
