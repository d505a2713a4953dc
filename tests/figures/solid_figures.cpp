// Figures of boolean.md, sweeps.md, section_loft.md, csg.md, cap.md and section_block.md.
#include <numbers>

#include "recon/block/cut.h"
#include "recon/core/operations.h"
#include "recon/model/model.h"
#include "shared/render/space_file.h"
#include "shared/scenario/runner.h"
#include "shared/solid/section.h"
#include "shared/solid/shape/loft.h"
#include "shared/solid/shape/rounding.h"
#include "tests/figures/figures.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::figures {
namespace {

namespace shapes = solid::shapes;

/// In a cabinet projection: depth goes up and to the right by half, at 45 degrees.
const double depth = 0.5 * std::numbers::sqrt2 / 2.0;
const geom::Vector3 towards_eye{depth, -1.0, depth};

/// One solid of a row, and what its faces are coloured by.
struct Item {
  std::string title;
  std::vector<solid::Solid> solids;
  double width = 2.0;  // how much of the row it takes
};

scene::Color color_of(const std::string& name) {
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  if (has("Mid - Base/")) return has("cut") || has("start") ? scene::Color{150, 190, 215} : scene::Color{190, 214, 230};
  if (has("Top - Mid/")) return has("cut") || has("start") ? scene::Color{205, 160, 90} : scene::Color{228, 205, 160};
  if (has("block") || has("lower") || has("bottom") || has("start")) return {150, 190, 215};
  if (has("upper")) return {214, 196, 150};
  if (has("cut") || has("end") || has("top")) return {205, 133, 32};
  if (has("round") || has("fault")) return {176, 58, 46};
  return {235, 180, 120};
}

/// Triangles coloured by the names of the faces that they come from; what looks away is hidden, because the painter's
/// order of long triangles would not know.
scene::space::Layer layer_of(const std::string& title, const std::vector<geom::Point3>& points,
                             const std::vector<std::pair<std::array<std::uint32_t, 3>, scene::Color>>& triangles,
                             double across) {
  scene::space::Surface surface;
  for (const geom::Point3 p : points) surface.points.push_back(p + geom::Vector3{across, 0.0, 0.0});
  for (const auto& [t, color] : triangles) {
    const geom::Point3 a = points[t[0]];
    if (dot(cross(points[t[1]] - a, points[t[2]] - a), towards_eye) <= 0.0) continue;
    surface.triangles.push_back(t);
    surface.colors.push_back(color);
  }
  scene::space::Layer layer;
  layer.key = layer.title = title;
  layer.style.line = {60, 70, 80};
  layer.style.line_width = 0.15;
  layer.style.fill = material;
  layer.content = std::move(surface);
  return layer;
}

base::Result<scene::space::Layer> layer_of(const Item& item, double across) {
  std::vector<geom::Point3> points;
  std::vector<std::pair<std::array<std::uint32_t, 3>, scene::Color>> triangles;
  for (const solid::Solid& what : item.solids) {
    DOBRA_TRY(const solid::ToMesh made, solid::to_mesh(what, solid::FacesAs::Triangles));
    const auto shift = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), made.mesh.points.begin(), made.mesh.points.end());
    for (std::size_t f = 0; f < made.mesh.faces.size(); ++f) {
      const auto& face = made.mesh.faces[f];
      triangles.push_back({{face[0] + shift, face[1] + shift, face[2] + shift}, color_of(made.names[f])});
    }
  }
  return layer_of(item.title, points, triangles, across);
}

/// Layers side by side, each with its title below.
base::Result<void> write_row(std::vector<scene::space::Layer> layers, const std::vector<double>& middles,
                             const std::filesystem::path& path, double low, scene::PageSize page) {
  scene::space::SpacePicture picture;
  scene::space::Labels labels;
  for (std::size_t i = 0; i < layers.size(); ++i)
    labels.labels.push_back({geom::Point3{middles[i], 0.0, low}, layers[i].title});
  for (auto& layer : layers) picture.layers.push_back(std::move(layer));
  scene::space::Layer words;
  words.key = "words";
  words.style.line = ink;
  words.content = std::move(labels);
  picture.layers.push_back(std::move(words));
  picture.axes.box = scene::space::AxesBox::Hidden;
  render::SpaceFileOptions options;
  options.page = page;
  options.camera = scene::space::camera_of(scene::space::StandardView::Cabinet);
  return render::write_views(picture, {{"", *options.camera}}, 1, path, options);
}

base::Result<void> write_row(const std::vector<Item>& items, const std::filesystem::path& path, double low,
                             scene::PageSize page) {
  std::vector<scene::space::Layer> layers;
  std::vector<double> middles;
  double across = 0.0;
  for (const Item& item : items) {
    DOBRA_TRY(scene::space::Layer layer, layer_of(item, across));
    layers.push_back(std::move(layer));
    middles.push_back(across + 0.5 * item.width);
    across += item.width + 1.6;
  }
  return write_row(std::move(layers), middles, path, low, page);
}

solid::Solid made(const base::Result<solid::shape::Shape>& shape, const std::string& prefix = "") {
  return solid::shape::solid_of(shape.value(), prefix).value();
}

solid::shape::Profile outline_of(std::vector<geom::Point> points) { return {{std::move(points), true}, {}}; }

base::Result<void> write_sweeps(const std::filesystem::path& path) {
  namespace shape = solid::shape;
  shape::Profile frame = outline_of({{0, 0}, {1.6, 0}, {1.6, 1.6}, {0, 1.6}});
  frame.holes.push_back({{{0.5, 0.5}, {1.1, 0.5}, {1.1, 1.1}, {0.5, 1.1}}, true});
  const shape::Profile bar = outline_of({{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}});
  shape::RoundOptions round;
  round.radius = 0.35;
  round.segments = 3;
  DOBRA_TRY(const solid::Solid rounded,
            shape::round_convex(shapes::solid(shapes::box({0, 0, 0}, {2, 2, 1.4}), "block"), round));
  const std::vector<geom::Point3> way{{0.2, 0.4, 0.2}, {1.8, 0.4, 0.2}, {1.8, 0.4, 1.6}, {0.3, 1.8, 1.6}};
  const geom::Polyline cup{{{0.4, 0.0}, {1.0, 0.0}, {0.7, 0.7}, {1.0, 1.5}, {0.8, 1.5}, {0.5, 0.7}}, true};
  const auto turned = [&] {
    shape::Shape half = shape::revolve(cup, {.angle = 250.0, .segments = 24}).value();
    for (geom::Point3& p : half.mesh.points) p = p + geom::Vector3{1.0, 1.0, 0.0};
    return half;
  };
  return write_row({{"extrusion", {made(shape::extrude(frame, {0.4, 0.3, 1.4}))}},
                    {"along a path", {made(shape::sweep(bar, way))}},
                    {"revolution", {made(turned())}},
                    {"rounded edges", {rounded}}},
                   path, -0.5, {.width = 760.0, .height = 230.0});
}

/// Two beds with a fault, the same three times along strike.
solid::shape::LoftSection faulted(double north, double foot, double throw_) {
  const auto on_fault = [&](double z) { return geom::Point{foot + 0.3 * z, z}; };
  const geom::Point low = on_fault(0);
  const geom::Point high = on_fault(2);
  const geom::Point west = on_fault(1.3);
  const geom::Point east = on_fault(1.3 - throw_);
  return {{{0, north, 0}, {1, 0, 0}, {0, 0, 1}},
          {{{{{0, 1.2}, {0, 0}, low}, false}, "border", "lower", ""},
           {{{low, {4, 0}, {4, 1.1 - throw_}}, false}, "border", "lower", ""},
           {{{{4, 1.1 - throw_}, {4, 2}, high}, false}, "border", "upper", ""},
           {{{high, {0, 2}, {0, 1.2}}, false}, "border", "upper", ""},
           {{{{0, 1.2}, {0.8, 1.4}, west}, false}, "top", "upper", "lower"},
           {{{east, {3, 1.3 - throw_}, {4, 1.1 - throw_}}, false}, "top", "upper", "lower"},
           {{{low, east}, false}, "fault", "lower", "lower"},
           {{{east, west}, false}, "fault", "lower", "upper"},
           {{{west, high}, false}, "fault", "upper", "upper"}}};
}

base::Result<void> write_lofts(const std::filesystem::path& path) {
  namespace shape = solid::shape;
  const std::vector<shape::LoftSection> sections{faulted(0, 1.4, 0.5), faulted(1.5, 1.8, 0.4), faulted(3, 1.9, 0.2)};
  DOBRA_TRY(const auto parts, shape::loft_sections(sections));
  Item whole{"sections joined", {}, 4.0};
  Item lower{"the lower bed", {}, 4.0};
  std::vector<solid::Solid> beds;
  for (const shape::LoftPart& part : parts) {
    shape::Shape named = part.shape;
    for (std::string& name : named.names) name = name == "fault" && part.name == "lower" ? name : part.name;
    DOBRA_TRY(solid::Solid solid, shape::solid_of(named));
    if (part.name == "lower") lower.solids.push_back(solid);
    beds.push_back(std::move(solid));
  }
  whole.solids.push_back(shapes::unite(beds));
  const auto ring = [](int corners, double radius) {
    geom::Polyline line{{}, true};
    for (const auto& [x, y] : shapes::regular(corners, radius, 0.25 * std::numbers::pi)) line.points.push_back({x, y});
    return line;
  };
  const std::vector<shape::PlacedProfile> profiles{{{ring(4, 1.4), {}}, solid::moved_by({1, 1, 0})},
                                                   {{ring(24, 0.7), {}}, solid::moved_by({1.2, 1, 2})}};
  return write_row({whole, lower, {"profiles joined", {made(shape::loft(profiles))}}}, path, -0.5,
                   {.width = 760.0, .height = 230.0});
}

base::Result<void> write_tree(const std::filesystem::path& path) {
  const solid::Solid block = shapes::solid(shapes::box({0, 0, 0}, {2, 2, 2}), "block");
  const mesh::PolygonMesh bar = shapes::moved(shapes::prism(shapes::regular(24, 0.5), -0.4, 2.4), {1, 1, 0});
  mesh::PolygonMesh lying = bar;
  for (geom::Point3& p : lying.points) p = {p.y, p.z, p.x};
  const solid::Solid b = shapes::solid(bar, "bar");
  const solid::Solid c = shapes::solid(lying, "bar");
  return write_row({{"A", {block}},
                    {"B", {b}},
                    {"B placed", {c}},
                    {"B + B placed", {shapes::unite({b, c})}},
                    {"A - (B + B placed)", {shapes::subtract({block, b, c})}}},
                   path, -0.9, {.width = 900.0, .height = 240.0});
}

base::Result<void> write_cut(const std::filesystem::path& path) {
  const solid::Solid block =
      shapes::subtract({shapes::solid(shapes::box({0, 0, 0}, {2.4, 2, 2}), "block"),
                        shapes::solid(shapes::moved(shapes::rotated(shapes::prism(shapes::regular(32, 0.35), -2, 2),
                                                                    {1, 0, 0}, 0.5 * std::numbers::pi),
                                                    {0.8, 1, 1.3}),
                                      "bore"),
                        shapes::solid(shapes::sphere({1.7, 1.1, 0.7}, 0.45, 12, 24), "cavity")});
  DOBRA_TRY(const solid::Halves halves, solid::halve(block, {0.0, -1.0, 0.0, 1.0}));
  return write_row({{"behind the plane", {halves.below}, 2.4}, {"in front of it", {halves.above}, 2.4}}, path, -0.5,
                   {.width = 560.0, .height = 230.0});
}

/// Two beds and a fault, as the block of their section. On the map the section runs to the east from (0, 0).
base::Result<recon::block::Block> block_of_beds() {
  DOBRA_TRY(
      const scenario::Document document,
      scenario::parse_document("dobra = 1\nprogram = \"recon\"\n"
                               "[[input.horizon]]\nname = \"Top (1)\"\npiece_of = \"Top\"\n"
                               "points = [[0, 1.4], [0.7, 1.6], [1.25, 1.5]]\n"
                               "[[input.horizon]]\nname = \"Top (2)\"\npiece_of = \"Top\"\n"
                               "points = [[1.4, 1.2], [2.2, 1.3], [3, 1.1]]\n"
                               "[[input.horizon]]\nname = \"Mid (1)\"\npiece_of = \"Mid\"\n"
                               "points = [[0, 0.9], [0.7, 1.1], [1.5, 1]]\n"
                               "[[input.horizon]]\nname = \"Mid (2)\"\npiece_of = \"Mid\"\n"
                               "points = [[1.65, 0.7], [2.2, 0.8], [3, 0.6]]\n"
                               "[[input.horizon]]\nname = \"Base (1)\"\npiece_of = \"Base\"\n"
                               "points = [[0, 0.4], [0.7, 0.6], [1.75, 0.5]]\n"
                               "[[input.horizon]]\nname = \"Base (2)\"\npiece_of = \"Base\"\n"
                               "points = [[1.9, 0.2], [2.2, 0.3], [3, 0.1]]\n"
                               "[[input.fault]]\nname = \"F\"\n"
                               "points = [[1.1, 1.8], [1.25, 1.5], [1.4, 1.2], [1.5, 1], [1.65, 0.7], [1.75, 0.5], "
                               "[1.9, 0.2], [2, 0]]\n",
                               "beds"));
  const scenario::Run run = scenario::Runner(recon::core::program()).run(document);
  if (!run.complete()) return *run.error;
  return recon::block::extrude(scenario::model_of<recon::model::Model>(run.states.back()).section, {2.4, {}});
}

/// The units of a block as one solid whose faces are called after them; behind a plane where there is one.
base::Result<solid::Solid> beds_of(const recon::block::Block& block, const solid::CutPlane* plane = nullptr) {
  std::vector<solid::Solid> beds;
  for (const recon::block::BlockUnit& unit : block.units) {
    beds.push_back(made(unit.shape, unit.name + "/"));
    if (plane == nullptr) continue;
    DOBRA_TRY(solid::Halves halves, solid::halve(beds.back(), *plane, unit.name + "/cut"));
    beds.back() = std::move(halves.below);
  }
  return shapes::unite(beds);
}

base::Result<void> write_block(const std::filesystem::path& path) {
  DOBRA_TRY(const recon::block::Block block, block_of_beds());
  DOBRA_TRY(const recon::block::CutFrame frame, recon::block::cut_over(block, {0.2, 0.3}, {2.8, 1.9}));
  DOBRA_TRY(const recon::block::BlockCut cut, recon::block::cut(block, frame));
  DOBRA_TRY(const recon::block::Block section, recon::block::extrude(block.section, {0.02, {}}));
  DOBRA_TRY(const recon::block::Block across, recon::block::extrude(cut.section, {0.02, {}}));
  std::vector<Item> items;
  for (const auto& [title, what, plane] :
       {std::tuple{"section", &section, static_cast<const solid::CutPlane*>(nullptr)},
        std::tuple{"block", &block, static_cast<const solid::CutPlane*>(nullptr)},
        std::tuple{"behind the cut", &block, &frame.plane},
        std::tuple{"new section", &across, static_cast<const solid::CutPlane*>(nullptr)}}) {
    DOBRA_TRY(solid::Solid beds, beds_of(*what, plane));
    items.push_back({title, {std::move(beds)}, 3.0});
  }
  return write_row(items, path, -0.4, {.width = 900.0, .height = 200.0});
}

}  // namespace

base::Result<void> write_solids(const std::string& name, const std::filesystem::path& path) {
  if (name == "sweeps") return write_sweeps(path);
  if (name == "section_loft") return write_lofts(path);
  if (name == "csg") return write_tree(path);
  if (name == "cap") return write_cut(path);
  if (name == "section_block") return write_block(path);
  const solid::Solid block = shapes::solid(shapes::box({0, 0, 0}, {2, 2, 2}), "block");
  const solid::Solid gear =
      shapes::solid(shapes::moved(shapes::prism(shapes::gear(8, 0.6, 0.9), 0, 2.0), {2, 1, 1}), "gear");
  return write_row({{"A", {block}},
                    {"B", {gear}},
                    {"union", {shapes::unite({block, gear})}},
                    {"intersection", {shapes::common({block, gear})}},
                    {"A without B", {shapes::subtract({block, gear})}}},
                   path, -0.5, {.width = 900.0, .height = 230.0});
}

}  // namespace dobra::figures
