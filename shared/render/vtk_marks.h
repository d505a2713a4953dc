#pragma once
// The page's marks in a VTK renderer. Internal to render: vtk_scene.h is what callers use.

#include <vtkActor2D.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <map>
#include <vector>

#include "shared/scene/layout.h"

namespace dobra::render {

/// Keeps the text actors from one layout to the next: text that only moves need not be drawn anew.
class VtkMarks {
 public:
  explicit VtkMarks(vtkRenderer& renderer);
  /// @param height  of the window, pixels.
  void show(const std::vector<scene::Mark>& marks, int height, double pixels_per_point);

 private:
  struct Texts {
    std::vector<vtkSmartPointer<vtkTextActor>> actors;
    std::size_t used = 0;
  };
  void show_text(const scene::TextMark& mark, int height, double pixels_per_point);

  vtkRenderer& renderer_;
  vtkSmartPointer<vtkPolyData> shapes_;
  std::map<std::string, Texts> texts_;
};

}  // namespace dobra::render
