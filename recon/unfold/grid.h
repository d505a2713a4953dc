#pragma once
// Grids of restoration: offset curves of a base line and the rungs (bisector transversals) between them. The source
// grid stands on the top of the deformed section. Page: docs/algorithms/grid.md.
// Source: [carvalho2005offset].

#include <optional>
#include <string>
#include <vector>

#include "recon/maps/columns.h"
#include "recon/section/section.h"
#include "shared/base/progress.h"

namespace recon::unfold {

enum class GridExtent { Count, Base };
enum class Treatment { Treated, Untreated };
enum class CornerJoin { Mitre, Bisector, Round, Bevel };
enum class Uncovered { Refuse, Continue };
/// AtFaults: the top ends where faults cut it, so that deeper beds reach beyond its ends by their nature.
enum class EndsOfTop { Open, AtFaults };
/// What a grid stands on after a restoration.
enum class GridFrom { Current, Input };

/// Parameters of the step `grid`.
struct GridParams {
  std::string top;
  GridExtent extent = GridExtent::Count;
  int count = 10;
  std::optional<double> distance;
  double factor = 1.0;
  double simplify = 0.0;
  section::LayerSide side = section::LayerSide::Auto;
  Treatment treatment = Treatment::Treated;
  CornerJoin join = CornerJoin::Mitre;
  Uncovered uncovered = Uncovered::Refuse;
  double cover_tolerance = 5.0;
  GridFrom from = GridFrom::Current;
  template <class D>
  static void describe(D& d) {
    d.field("top", &GridParams::top,
            {.title = "Top horizon",
             .help = "The horizon that the curves are parallel to; by default the first.",
             .names = "horizon"});
    d.choice(
        "extent", &GridParams::extent, {"count", "base"},
        {.title = "Extent", .help = "count: so many curves; base: as many as reach the deepest point of the section."});
    d.field("count", &GridParams::count, {.title = "Number of curves", .at_least = 1, .at_most = 10000});
    d.field("distance", &GridParams::distance,
            {.title = "First distance",
             .help = "By default such that the curves reach the deepest point.",
             .unit = "m",
             .above = 0.0});
    d.field("factor", &GridParams::factor,
            {.title = "Factor", .help = "Each gap is this many times the one before.", .above = 0.0});
    d.field(
        "simplify", &GridParams::simplify,
        {.title = "Simplify the top",
         .help =
             "The grid stands on the top with fewer points, nowhere farther from it than this; unsteady lines need it.",
         .unit = "m",
         .at_least = 0.0});
    d.choice("side", &GridParams::side, {"auto", "below", "above"},
             {.title = "Side", .help = "auto: the side of the other horizons, below if there are none."});
    d.choice("treatment", &GridParams::treatment, {"treated", "untreated"},
             {.title = "Spurious regions", .help = "treated: loops of the offset curves are removed."});
    d.choice("join", &GridParams::join, {"mitre", "bisector", "round", "bevel"},
             {.title = "Corners",
              .help = "mitre: bisector points up to four distances; bisector: however far, as the rungs go."});
    d.choice("uncovered", &GridParams::uncovered, {"refuse", "continue"},
             {.title = "Where the section reaches beyond the top",
              .help = "refuse: an error with the place; continue: the grid goes on straight there."});
    d.field("cover_tolerance", &GridParams::cover_tolerance,
            {.title = "Beyond the top at most",
             .help = "So much of the top's width goes without saying: traces of one section seldom end at one line.",
             .unit = "%",
             .at_least = 0.0,
             .when = "uncovered = refuse"});
    d.choice("from", &GridParams::from, {"current", "input"},
             {.title = "Stands on",
              .help = "current: the section as the steps before leave it; input: as it was read, which begins anew."});
  }
};

struct GridCurve {
  double distance = 0.0;               ///< From the base, m.
  std::vector<geom::Polyline> pieces;  ///< Zero or more, oriented like the base.
};

struct Grid {
  std::vector<GridCurve> curves;
  std::vector<geom::Polyline> rungs;  ///< Two points each, from the base on; where treated they end at the medial axis.
  std::size_t vanished = 0;           ///< Curves of which nothing is left.
  std::size_t left_out = 0;           ///< Separate short pieces of curves, not kept.
};

/// What the grid of a line is made of.
struct GridOptions {
  std::vector<double> distances;  ///< Increasing, > 0, m.
  Treatment treatment = Treatment::Treated;
  CornerJoin join = CornerJoin::Mitre;
  int most_halvings = 50;  ///< For the place where a rung meets the medial axis.
};

/// Offset curves and rungs on the right-hand side of travel.
/// @param columns  those of `line`, or a refinement of them: one rung each.
/// @error OffsetFailed, InvalidOption, Cancelled.
base::Result<Grid> make_grid(const geom::Polyline& line, const maps::Columns& columns, const GridOptions& options,
                             const base::Progress& progress);

/// The grid of the top of the deformed section, and what the following steps need to know of it.
struct SourceGrid {
  GridParams params;  ///< It was made with these.
  section::HorizonId top;
  section::LayerSide side = section::LayerSide::Below;  ///< As found; never Auto.
  EndsOfTop ends = EndsOfTop::Open;
  geom::Polyline base;  ///< The top, in the travel direction that has the layers on its right-hand side.
  GridOptions options;
  double deepest = 0.0;  ///< Greatest depth of a horizon or unit, m (0 if all lie on or above the top).
  Grid grid;
  std::vector<std::string> remarks;
};

/// The base of the grid alone, without curves and rungs: top, side, base, params.
/// @param side  never Auto.
/// @error BadSection (no such top), those of geom::simplify.
base::Result<SourceGrid> make_base(const section::Section& section, const GridParams& params, section::LayerSide side);

/// @error BadSection (no such top, with a suggestion; a top that does not cover the section, with the farthest place),
/// InvalidOption (curves that cannot reach the base),
/// DegenerateCurve, and those of make_grid.
base::Result<SourceGrid> make_source_grid(const section::Section& section, const GridParams& params,
                                          const base::Progress& progress);

}  // namespace recon::unfold
