// Figure of boolean.md.
#include <numbers>

#include "shared/render/space_file.h"
#include "tests/figures/figures.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::figures {
namespace {

namespace shapes = solid::shapes;

/// In a cabinet projection: depth goes up and to the right by half, at 45 degrees.
const double depth = 0.5 * std::numbers::sqrt2 / 2.0;
const geom::Vector3 towards_eye{depth, -1.0, depth};

/// A solid's triangles, coloured by the operand whose face they come from.
base::Result<scene::space::Layer> layer_of(const std::string& title, const solid::Solid& what, double across) {
  DOBRA_TRY(const solid::ToMesh made, solid::to_mesh(what, solid::FacesAs::Triangles));
  std::vector<geom::Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<scene::Color> colors;
  for (const geom::Point3 p : made.mesh.points) points.push_back(p + geom::Vector3{across, 0.0, 0.0});
  for (std::size_t f = 0; f < made.mesh.faces.size(); ++f) {
    const auto& face = made.mesh.faces[f];
    // What looks away is hidden; the painter's order of long triangles would not know.
    const geom::Point3 a = points[face[0]];
    if (dot(cross(points[face[1]] - a, points[face[2]] - a), towards_eye) <= 0.0) continue;
    triangles.push_back({face[0], face[1], face[2]});
    colors.push_back(made.names[f] == "block" ? scene::Color{150, 190, 215} : scene::Color{235, 180, 120});
  }
  scene::space::Surface surface;
  surface.points = std::move(points);
  surface.triangles = std::move(triangles);
  surface.colors = std::move(colors);
  scene::space::Layer layer;
  layer.key = layer.title = title;
  layer.style.line = {60, 70, 80};
  layer.style.line_width = 0.15;
  layer.style.fill = material;
  layer.content = std::move(surface);
  return layer;
}

}  // namespace

base::Result<void> write_solids(const std::filesystem::path& path) {
  const solid::Solid block = shapes::solid(shapes::box({0, 0, 0}, {2, 2, 2}), "block");
  const solid::Solid gear =
      shapes::solid(shapes::moved(shapes::prism(shapes::gear(8, 0.6, 0.9), 0, 2.0), {2, 1, 1}), "gear");
  scene::space::SpacePicture picture;
  double across = 0.0;
  scene::space::Labels labels;
  for (const auto& [title, what] :
       {std::pair{"A", block}, std::pair{"B", gear}, std::pair{"union", shapes::unite({block, gear})},
        std::pair{"intersection", shapes::common({block, gear})},
        std::pair{"A without B", shapes::subtract({block, gear})}}) {
    DOBRA_TRY(scene::space::Layer layer, layer_of(title, what, across));
    picture.layers.push_back(std::move(layer));
    labels.labels.push_back({geom::Point3{across + 1.0, 0.0, -0.5}, title});
    across += 3.6;
  }
  scene::space::Layer words;
  words.key = "words";
  words.style.line = ink;
  words.content = std::move(labels);
  picture.layers.push_back(std::move(words));
  picture.axes.box = scene::space::AxesBox::Hidden;
  render::SpaceFileOptions options;
  options.page = scene::PageSize{.width = 900.0, .height = 230.0};
  options.camera = scene::space::camera_of(scene::space::StandardView::Cabinet);
  return render::write_views(picture, {{"", *options.camera}}, 1, path, options);
}

}  // namespace dobra::figures
