#pragma once
// The mesher of trimmed surfaces of the paper, as it is written: quadtree of the chart, a front that grows by levels,
// smoothing by equation 18. It also says of every triangle which rule made it. Always ends, and never folds a triangle
// of the chart. Page: docs/algorithms/paper_mesher.md. Source: [miranda2009surface].

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/paper/chart_quadtree.h"

namespace dobra::surf::paper {

struct PaperOptions {
  double largest = 0.0;         ///< L: no cell of the quadtree longer, m; 0 takes the longest side of the border.
  double turn = 15.0;           ///< A: most that the normal turns in a cell, degrees.
  double least_distance = 0.4;  ///< Of a new node from other segments, part of H.
  /// The text has H itself for the three below, as_printed(): then the triangle that it wants has longer sides than H,
  /// and its own neighbours stand in its sphere. These are for triangles whose sides are H.
  double height = 0.8660254037844386;  ///< Of the ideal point over its segment, part of H.
  double sphere = 0.5;                 ///< Radius in which a node of the front is taken for the ideal point, part of H.
  double mouth = 2.0;                  ///< A wider corner of the front gets a node in its mouth, part of H.
  /// The point on the surface may be farther from the segment than asked by this part: over a chord that the surface
  /// bends away from, every point of it is.
  double excess = 0.05;
  double corner = 80.0;                    ///< Between neighbouring segments: below, the corner is closed, degrees.
  int passes = 3;                          ///< Of smoothing.
  double phi = 0.75;                       ///< Step of smoothing, 0 to 1.
  std::size_t most_triangles = 5'000'000;  ///< More end in TooManyElements.
};

/// With H itself for height, sphere and mouth.
PaperOptions as_printed(PaperOptions options);

/// Which rule of step vi to xiv made a triangle.
enum class Rule : std::uint8_t {
  Corner,   ///< vi: over a narrow corner of the front.
  Halved,   ///< vi: one of the two round a node in the middle of a corner's mouth.
  Node,     ///< xii: to the best node of the front in the sphere.
  NewNode,  ///< xiii: to the ideal point.
  Closing,  ///< What is left when no level goes on: to the best node of the front.
};

struct Made {
  std::array<std::uint32_t, 3> triangle;  ///< Nodes; the first two are the segment's ends.
  std::uint32_t created = 0;              ///< Level in which the segment may be used first: 0 for the border's.
  std::uint32_t level = 0;                ///< Level in which it was used.
  Rule rule = Rule::NewNode;
};

class PaperMesher {
 public:
  enum class Stage : std::uint8_t { Front, Smoothing, Done };

  /// What comes next.
  struct Next {
    Stage stage = Stage::Done;
    std::uint32_t level = 0;                                ///< Of the front; or the pass of smoothing, from 0.
    std::optional<std::array<std::uint32_t, 2>> segment{};  ///< The shortest active one.
    double size = 0.0;                                      ///< H over it, m.
  };
  /// What there is, to be drawn.
  struct View {
    std::vector<geom::Point> places;
    std::vector<geom::Point3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    struct Side {
      std::array<std::uint32_t, 2> nodes;
      bool active;
    };
    std::vector<Side> front;
  };

  /// Checks the border and builds the quadtree.
  /// @error those of constrained_delaunay for the border, with the place {x, y, z, u, v}; of ChartQuadtree.
  static base::Result<PaperMesher> start(const mesh::ChartInput& input, const PaperOptions& options = {},
                                         const base::Progress& progress = {});
  /// About `count` triangles more, or one pass of smoothing.
  /// @error TooManyElements, Cancelled: no further step.  @pre not done()
  base::Result<void> step(std::size_t count, const base::Progress& progress = {});
  [[nodiscard]] bool done() const { return next().stage == Stage::Done; }
  [[nodiscard]] Next next() const;
  [[nodiscard]] View view() const;
  [[nodiscard]] const ChartQuadtree& quadtree() const;
  /// One a triangle made so far, in order.
  [[nodiscard]] const std::vector<Made>& log() const;
  /// "crowded_cell": a cell of the deepest level holds several given nodes.
  [[nodiscard]] std::vector<mesh::Finding> findings() const;
  /// @pre done()
  [[nodiscard]] mesh::FaceMesh mesh() const;

 private:
  struct State;
  struct Destroy {
    void operator()(State* state) const;
  };
  explicit PaperMesher(std::unique_ptr<State, Destroy> state) : state_(std::move(state)) {}
  std::unique_ptr<State, Destroy> state_;
};

/// All of it at once.
base::Result<mesh::FaceMesh> paper_mesh(const mesh::ChartInput& input, const PaperOptions& options = {},
                                        const base::Progress& progress = {});

/// Faces divided by halving, each meshed, assembled. `options.largest` 0 takes what SizeOptions does.
struct PaperSurface {
  mesh::SurfaceMesh mesh;
  mesh::Division division;
  std::vector<mesh::Finding> findings;  ///< Of the division and of the faces.
};
base::Result<PaperSurface> paper_mesh(std::span<const trim::TrimmedSurface> surfaces, const PaperOptions& options = {},
                                      const base::Progress& progress = {});

}  // namespace dobra::surf::paper
