#pragma once
// The adaptive loop: mesh, analyse, estimate the error, ask for new sizes, mesh again, until the error asked for.
// Page: docs/algorithms/estimate.md. Source: [zienkiewicz1992spr], [ladeveze1991].

#include "quebra/analysis/analysis.h"
#include "quebra/meshing/meshing.h"

namespace quebra::analysis {

enum class RuleOfSizes { Optimal, Equal };
enum class MindPeaks { Yes, No };
enum class StartFrom { First, Last };

struct AdaptParams : meshing::MeshRules, EstimateParams {
  AdaptParams() {
    turn = dobra::base::Angle::from_degrees(30.0);
    order = meshing::Order::Second;
  }

  double target = 5.0;
  RuleOfSizes rule = RuleOfSizes::Optimal;
  MindPeaks peaks = MindPeaks::Yes;
  int max_cycles = 8;
  StartFrom from = StartFrom::First;
  double size = 0.0;
  double min_size = 0.0;
  double memory = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("target", &AdaptParams::target,
            {.title = "Error asked for", .help = "In the energy norm.", .unit = "%", .above = 0, .at_most = 99});
    d.choice("rule", &AdaptParams::rule, {"optimal", "equal"},
             {.title = "Rule of sizes", .help = "optimal: fewest elements; equal: the same error in each."});
    d.choice("peaks", &AdaptParams::peaks, {"yes", "no"},
             {.title = "Mind peaks",
              .help = "Asks for the same error in the elements round each peak of stress: the whole may meet it with a "
                      "peak that does not."});
    d.field("max_cycles", &AdaptParams::max_cycles, {.title = "Most cycles", .at_least = 1, .at_most = 100});
    d.choice("from", &AdaptParams::from, {"first", "last"},
             {.title = "Begin with",
              .help = "first: a mesh of the first size; last: the mesh after the last cycle so far. With most cycles 1 "
                      "that is one cycle at a time."});
    d.field("size", &AdaptParams::size,
            {.title = "First size",
             .help = "And greatest; 0 takes 1/8 of the domain's diagonal, or the formula or background mesh alone.",
             .unit = "m",
             .at_least = 0});
    d.field("min_size", &AdaptParams::min_size,
            {.title = "Least size", .help = "That the loop asks for by itself.", .unit = "m", .at_least = 0});
    d.field("memory", &AdaptParams::memory,
            {.title = "Memory",
             .help = "Most that the factorisation may take; 0 takes what the machine has.",
             .unit = "B",
             .at_least = 0});
    meshing::MeshRules::describe_in<AdaptParams>(d);
    EstimateParams::describe_in<AdaptParams>(d);
  }
};

/// Adds the mesh and the analysis of every cycle; a remark says why the loop stopped if the target was not reached:
/// reached means that the estimate is at most 0.8 of it (0.85 of 2 % or less), for the estimate may be low. What stops
/// a cycle after the first (memory, the user) leaves those before it. Each cycle is reported as a kept line. Sizes of a
/// formula or background mesh bound those of every cycle from above.
/// @error BadValue: no problem, or no cycle to go on from; those of SizeSource::make, mesh_domain and analyse
dobra::base::Result<model::Model> adapt(const model::Model& model, const AdaptParams& params,
                                        const dobra::scenario::Context& context, const dobra::base::Progress& progress);

}  // namespace quebra::analysis
