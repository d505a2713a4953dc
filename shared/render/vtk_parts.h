#pragma once
// What drawers of the plane and of space are made of. Internal to render: vtk_scene.h and vtk_space.h are what callers
// use.

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>

#include <cstdint>
#include <vector>

#include "shared/geom/point3.h"
#include "shared/scene/layer.h"

namespace dobra::render {

/// Triangles or points of one actor: a frame is drawn in parts of whole actors.
constexpr std::size_t most_an_actor = 16384;
constexpr int color_levels = 64;  // as in the files, so that both look alike
/// Points whose shapes are made at once, in one arrangement: some ten milliseconds.
constexpr std::size_t at_once = 20000;

/// Where part k of so many begins.
constexpr std::size_t part_begin(std::size_t all, std::size_t k, std::size_t parts) { return all * k / parts; }

/// A renderer without lights, on white.
vtkSmartPointer<vtkRenderer> add_renderer(vtkRenderWindow& window, int level);
/// How a window is drawn into: layers of renderers, samples, text.
void prepare(vtkRenderWindow& window, int levels);

/// An actor without anything yet, of one colour, that no light falls on.
vtkSmartPointer<vtkActor> flat_actor(const scene::Color& color);
/// A line thinner than a pixel is a fainter one of one pixel.
void set_width(vtkActor& actor, const scene::Color& color, double pixels);
/// Points as discs with soft borders.
void make_round(vtkActor& actor);

vtkSmartPointer<vtkLookupTable> table_of(const scene::Scale& scale);
/// Values as fractions of a scale, not clamped: the map's ends stay flat inside a triangle that goes beyond them.
vtkSmartPointer<vtkDataArray> fractions_of(const scene::Scale& scale, const std::vector<double>& values);

/// A list of points and cells of them, in the single precision that the graphics card keeps.
class Geometry {
 public:
  explicit Geometry(geom::Point3 origin) : origin_(origin) {
    points_->SetNumberOfComponents(3);
    offsets_->InsertNextValue(0);
  }
  /// Of the plane, lifted by `depth`.
  Geometry(geom::Point origin, double depth) : Geometry(geom::Point3{origin.x, origin.y, -depth}) {}

  /// @pre nothing has been added: it empties the lists
  void reserve(std::size_t points, std::size_t corners, std::size_t cells) {
    points_->Allocate(static_cast<vtkIdType>(3 * points));
    corners_->Allocate(static_cast<vtkIdType>(corners));
    offsets_->Allocate(static_cast<vtkIdType>(cells + 1));
    offsets_->InsertNextValue(0);
  }
  std::int32_t add_point(geom::Point p) { return add_point(geom::Point3{p.x, p.y, 0.0}); }
  std::int32_t add_point(geom::Point3 p) {
    const geom::Vector3 by = p - origin_;
    const float at[3] = {static_cast<float>(by.x), static_cast<float>(by.y), static_cast<float>(by.z)};
    return static_cast<std::int32_t>(points_->InsertNextTypedTuple(at));
  }
  void add_corner(std::int32_t point) { corners_->InsertNextValue(point); }
  void end_cell() { offsets_->InsertNextValue(static_cast<std::int32_t>(corners_->GetNumberOfValues())); }

  enum class As { Points, Lines, Polygons };
  [[nodiscard]] vtkSmartPointer<vtkPolyData> data(As as) const {
    auto made = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(points_);
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets_, corners_);
    made->SetPoints(points);
    if (as == As::Points) made->SetVerts(cells);
    if (as == As::Lines) made->SetLines(cells);
    if (as == As::Polygons) made->SetPolys(cells);
    return made;
  }

 private:
  geom::Point3 origin_;
  vtkNew<vtkFloatArray> points_;
  vtkNew<vtkTypeInt32Array> offsets_;
  vtkNew<vtkTypeInt32Array> corners_;
};

}  // namespace dobra::render
