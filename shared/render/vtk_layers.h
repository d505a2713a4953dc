#pragma once
// Layers as VTK actors. Internal to render: vtk_scene.h is what callers use.

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "shared/scene/detail.h"
#include "shared/scene/ground.h"
#include "shared/scene/layout.h"

namespace dobra::render {

/// What makes a shape out of date: nothing, coming nearer (or away, or out of the window that it was made for), any
/// change of the view.
enum class Follows { Nothing, Detail, View };

/// How a panel is looked at, as the shapes of a layer need to know.
struct Look {
  scene::PanelLayout place;
  double pixels_per_point = 1.0;
  geom::Box window{};  ///< What is outside need not be there.

  [[nodiscard]] scene::Sight sight() const;
  /// The world box of the plot.
  [[nodiscard]] geom::Box seen() const;
  /// Whether what was made for this serves for another.
  [[nodiscard]] bool serves(const Look& other, Follows follows) const;
};

/// @param points  of the layer: one of few points is made whole.
Look look_at(const scene::PanelLayout& place, double pixels_per_point, std::size_t points);

/// What some actors of a layer draw. It is made from values alone, on any thread, and then shown on that of the window.
struct Shape {
  using Follows = dobra::render::Follows;

  Shape(Follows what, std::vector<vtkSmartPointer<vtkActor>> of,
        std::function<std::vector<vtkSmartPointer<vtkPolyData>>(const Look&)> maker)
      : follows(what), actors(std::move(of)), make(std::move(maker)) {}

  [[nodiscard]] bool serves(const Look& look) const { return made_for && made_for->serves(look, follows); }
  void show(const std::vector<vtkSmartPointer<vtkPolyData>>& made, const Look& look);

  Follows follows;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  /// One an actor.
  std::function<std::vector<vtkSmartPointer<vtkPolyData>>(const Look&)> make;
  std::optional<Look> made_for;
  std::atomic<std::uint64_t> wanted{0};  ///< The number of the request that it waits for; 0: none.
  Look wanted_for;
};

struct LayerActors {
  std::vector<vtkSmartPointer<vtkActor>> actors;
  std::vector<std::shared_ptr<Shape>> shapes;
  std::size_t points = 0;  ///< Of the layer.
  /// To be called whenever the view or the pixel ratio changed: line widths, marker sizes.
  std::vector<std::function<void(const scene::PanelLayout&, double pixels_per_point)>> on_view;
};

/// @param origin  taken off all coordinates, because the graphics card keeps only seven digits.
/// @param ground  what is behind all layers.
/// @param depth   later layers have larger ones, one apart.
/// @cost  O(points) at most, without looking at their neighbours: the shapes are made later.
LayerActors make_actors(const scene::Layer& layer, geom::Point origin, double depth, const scene::Ground& ground = {});

/// A picture over a box of the world.
vtkSmartPointer<vtkTexture> smooth_texture(vtkImageData* image);
vtkSmartPointer<vtkPolyData> textured_box(const geom::Box& box, geom::Point origin, double depth);

}  // namespace dobra::render
