#pragma once
// Where a height z(x, y) is not smooth: kinks, jumps, poles, and places where its slope or its bend grows without
// bound. Lines along x and along y are looked at; where the second difference stands out, the place is looked at closer
// and closer, and the power of the step by which the difference falls tells what is there: 2 where the height is
// smooth, 1 at a kink, 0 at a jump, less than 0 at a pole. Page: docs/algorithms/surfaces.md.

#include <functional>
#include <string>
#include <vector>

#include "shared/base/formula_jet.h"
#include "shared/base/result.h"
#include "shared/geom/box.h"

namespace dobra::surf {

enum class GraphFlawKind { Kink, Jump, Pole, Steep, NoValue };

struct GraphFlaw {
  GraphFlawKind kind = GraphFlawKind::Kink;
  geom::Point at;
};

struct GraphFlaws {
  std::vector<double> kinks_x, kinks_y;  ///< Kinks all along a line x = c, y = c of the chart; ascending.
  std::vector<GraphFlaw> flaws;          ///< All others that were found, kinks that are in neither list among them.
};

/// Parts of a range between lines across it (ascending), a hair inside them: what is asked of a part is then of one
/// side of each line. @param size  of the coordinates, by which lines are rounded
std::vector<base::Range> between_lines(base::Range range, const std::vector<double>& lines, double size);
/// How far a part between two lines, `gap` apart, is inside.
double hair_beside(double gap, double size);

struct GraphFlawOptions {
  int lines = 33;      ///< Looked at in each direction.
  int places = 256;    ///< Parts of a line, of which the most bent are looked at closer.
  int candidates = 3;  ///< So many parts of a line, by the second difference and by how it stands out.
  double kink = 1e-4;  ///< Slopes that differ by less are no kink.
  double jump = 1e-6;  ///< Of the range of heights: less is no jump.
};

/// @cost about 100,000 evaluations. What is narrower than a part of a line may be missed.
GraphFlaws graph_flaws(const std::function<double(double, double)>& height, const geom::Box& chart,
                       const GraphFlawOptions& options = {});
/// Of a formula of which the choices are known: besides, kinks and jumps along lines x = c, y = c on which one changes
/// over (base::FormulaJet::changes), to the last digits and however near to each other.
GraphFlaws graph_flaws(const std::function<double(double, double)>& height, const base::FormulaJet& formula,
                       const geom::Box& chart, const GraphFlawOptions& options = {});
/// Of a formula of x and y: besides, parts of the chart over which it may have a kink or a jump, or its derivatives
/// have no bound (base::FormulaJet), are halved down to 1e-5 of the chart and looked at. @error those of base::Formula
base::Result<GraphFlaws> graph_flaws(const std::string& formula, const geom::Box& chart,
                                     const GraphFlawOptions& options = {});

}  // namespace dobra::surf
