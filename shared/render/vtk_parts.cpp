#include "shared/render/vtk_parts.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <cmath>

#include "shared/render/vtk_stage.h"
#include "shared/scene/color_map.h"

namespace dobra::render {

vtkSmartPointer<vtkRenderer> add_renderer(vtkRenderWindow& window, int level) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetLayer(level);
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetBackgroundAlpha(1.0);
  renderer->InteractiveOff();
  renderer->SetAutomaticLightCreation(false);
  window.AddRenderer(renderer);
  return renderer;
}

void prepare(vtkRenderWindow& window, int levels) {
  window.SetNumberOfLayers(levels);
  window.SetMultiSamples(samples_a_pixel);
  window.SetAlphaBitPlanes(0);
  window.SetDPI(72);  // so that a font's size is its height in pixels
}

vtkSmartPointer<vtkActor> flat_actor(const scene::Color& color) {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyData> nothing_yet;
  mapper->SetInputData(nothing_yet);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
  actor->GetProperty()->SetOpacity(color.alpha / 255.0);
  actor->PickableOff();
  return actor;
}

void set_width(vtkActor& actor, const scene::Color& color, double pixels) {
  actor.SetVisibility(pixels > 0.0);
  actor.GetProperty()->SetLineWidth(static_cast<float>(std::max(pixels, 1.0)));
  actor.GetProperty()->SetOpacity(color.alpha / 255.0 * std::min(pixels, 1.0));
}

void make_round(vtkActor& actor) {
  actor.GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "//VTK::Light::Impl\n"
      "  float fromMiddle = 2.0 * length(gl_PointCoord - vec2(0.5));\n"
      "  float soft = 1.5 * fwidth(gl_PointCoord.x);\n"
      "  fragOutput0.a *= 1.0 - smoothstep(1.0 - 2.0 * soft, 1.0, fromMiddle);\n"
      "  if (fragOutput0.a <= 0.0) { discard; }\n",
      false);
  actor.ForceTranslucentOn();
}

vtkSmartPointer<vtkLookupTable> table_of(const scene::Scale& scale) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(color_levels);
  for (int i = 0; i < color_levels; ++i) {
    const scene::Color c = scene::color_at(scale.map, (i + 0.5) / color_levels);
    table->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
  }
  const scene::Color none = scene::color_at(scale.map, std::nan(""));
  table->SetNanColor(none.red / 255.0, none.green / 255.0, none.blue / 255.0, 1.0);
  table->SetTableRange(0.0, 1.0);
  return table;
}

vtkSmartPointer<vtkDataArray> fractions_of(const scene::Scale& scale, const std::vector<double>& values) {
  auto fractions = vtkSmartPointer<vtkFloatArray>::New();
  const double width = scale.high - scale.low;
  for (const double value : values)
    fractions->InsertNextValue(static_cast<float>(width != 0.0 ? (value - scale.low) / width : 0.5));
  return fractions;
}

}  // namespace dobra::render
