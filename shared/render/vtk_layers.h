#pragma once
// Layers as VTK actors. Internal to render: vtk_scene.h is what callers use.

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

#include "shared/scene/ground.h"
#include "shared/scene/layout.h"

namespace dobra::render {

struct LayerActors {
  std::vector<vtkSmartPointer<vtkActor>> actors;
  /// To be called whenever the view or the pixel ratio changed: line widths, marker sizes, dashes.
  std::vector<std::function<void(const scene::PanelLayout&, double pixels_per_point)>> on_view;
};

/// @param layer   its filled regions have their triangles (scene::fill_regions).
/// @param origin  taken off all coordinates, because the graphics card keeps only seven digits.
/// @param ground  what is behind all layers.
/// @param depth   later layers have larger ones, one apart.
LayerActors make_actors(const scene::Layer& layer, geom::Point origin, double depth, const scene::Ground& ground = {});

}  // namespace dobra::render
