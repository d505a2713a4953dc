#pragma once
// The figures of docs/algorithms: each a function that calls the library and returns a picture of what it returned.
// main.cpp writes them. Nothing here is drawn by hand but the input; what looks wrong is wrong in the library.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/triangle_mesh.h"
#include "shared/scene/layer.h"

namespace dobra::figures {

struct Figure {
  std::string name;  ///< Of the file, without ending.
  base::Result<scene::Picture> (*make)();
  double width = 720.0;  ///< Of the page, points.
  bool pixels = false;   ///< A PNG always: so many triangles are too much for a page to load.
};

std::vector<Figure> geom_figures();
std::vector<Figure> topo_figures();
std::vector<Figure> offset_figures();
std::vector<Figure> recon_figures();
std::vector<Figure> fault_figures();
std::vector<Figure> mesh_figures();
std::vector<Figure> quality_figures();
std::vector<Figure> surf_figures();
std::vector<Figure> trim_figures();
std::vector<Figure> paper_figures();
std::vector<Figure> import_figures();
std::vector<Figure> free_border_figures();
std::vector<Figure> param_figures();
std::vector<Figure> loft_figures();

/// One surface from the usual sides (space_figures.cpp).
base::Result<void> write_projection(const std::filesystem::path& path);
/// Solids side by side (solid_figures.cpp): "boolean", "sweeps", "section_loft", "csg", "cap" or
/// "section_block".
base::Result<void> write_solids(const std::string& name, const std::filesystem::path& path);

/// What each stage of the general offset engine makes of one base (offset_stages.cpp).
base::Result<scene::Picture> offset_stages();

// One palette for all figures, that of the programs.
constexpr scene::Color ink{38, 50, 56};
constexpr scene::Color blue{13, 71, 161};
constexpr scene::Color red{176, 58, 46};
constexpr scene::Color orange{205, 133, 32};
constexpr scene::Color green{66, 122, 72};
constexpr scene::Color grey{126, 147, 168};
constexpr scene::Color pale{216, 222, 228};
constexpr scene::Color material{236, 239, 241};

scene::Style stroke(scene::Color color, double width, scene::Dash dash = scene::Dash::Solid);
scene::Style filled(scene::Color color);
scene::Style dots(scene::Color color, double diameter);

using scene::InLegend;
/// A layer that the legend does not name has no title.
scene::Layer lines(std::string title, const scene::Style& style, std::vector<geom::Polyline> lines);
scene::Layer markers(std::string title, const scene::Style& style, std::vector<geom::Point> points);
scene::Layer regions(std::string title, const scene::Style& style, std::vector<scene::Region> regions);
scene::Layer labels(scene::Color color, std::vector<scene::Label> labels, double size = 9.0);
/// A panel with its layers' keys numbered; `margin` is added round all of them, in world units.
scene::Panel panel(std::string title, std::vector<scene::Layer> layers, double margin, const scene::Axes& axes = {});

geom::Polyline chain(std::vector<geom::Point> points);
geom::Polyline contour(std::vector<geom::Point> points);
geom::Polyline outline(const geom::Box& box);

/// Triangles coloured by their measure alpha.
scene::Layer quality_layer(const mesh::TriangleMesh& mesh);
/// Triangles without values.
scene::Layer wires(const mesh::TriangleMesh& mesh, scene::Color line, double width);
std::vector<std::array<std::uint32_t, 3>> corners_of(const mesh::TriangleMesh& mesh);

/// A cosine, y = -cos x over [0, 4 pi], 129 points from left to right.
geom::Polyline cosine();

}  // namespace dobra::figures
