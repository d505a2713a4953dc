#pragma once
// Layers of space as VTK actors. Internal to render: vtk_space.h is what callers use.

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

#include "shared/scene/ground.h"
#include "shared/scene/space/layout.h"

namespace dobra::render {

/// The data of a layer, made from values alone on any thread.
struct SpaceData {
  using Part = vtkSmartPointer<vtkPolyData>;
  std::vector<Part> faces{};
  std::vector<Part> edges{};
  std::vector<Part> thinned{};  ///< In place of faces and edges while the view moves; empty: those are few.
  std::vector<Part> lines{};
  std::vector<Part> discs{};  ///< Markers.
  double mean_edge = 0.0;     ///< World.
};

/// @param origin  taken off all coordinates, because the graphics card keeps only seven digits.
/// @cost  O(n log n), n triangles
SpaceData make_data(const scene::space::Layer& layer, geom::Point3 origin);

/// Points and triangles of a layer: what making its data costs.
std::size_t size_of(const scene::space::Layer& layer);

struct SpaceActors {
  std::vector<vtkSmartPointer<vtkActor>> full{};
  std::vector<vtkSmartPointer<vtkActor>> thinned{};  ///< While the view moves.
  /// To be called whenever the view or the pixel ratio changed: widths, sizes, dashes.
  std::vector<std::function<void(const scene::space::Sheet&, double pixels_per_point)>> on_view{};
};

SpaceActors make_actors(const scene::space::Layer& layer, const SpaceData& data, geom::Point3 origin,
                        const scene::space::Light& light, const scene::Ground& ground);

}  // namespace dobra::render
