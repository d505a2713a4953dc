#include "shared/render/vtk_layers.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/simplify.h"
#include "shared/scene/color_map.h"
#include "shared/scene/fill.h"
#include "shared/scene/pattern.h"

namespace dobra::render {
namespace {

using geom::Point;
using scene::Color;

constexpr int color_levels = 64;  // as in the files, so that both look alike
/// Details of a line smaller than this cannot be seen.
constexpr double seen_pixels = 0.1;

/// Cells given by where each ends in a list of point numbers.
struct Cells {
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> points;
  Cells() { offsets->InsertNextValue(0); }
  void add(vtkIdType point) { points->InsertNextValue(point); }
  void end() { offsets->InsertNextValue(points->GetNumberOfValues()); }
  [[nodiscard]] vtkSmartPointer<vtkCellArray> array() {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, points);
    return cells;
  }
};

/// Makes strokes given in page coordinates the lines of `data`.
void show_strokes(const std::vector<geom::Segment>& strokes, const scene::Transform& transform, Point origin,
                  double depth, vtkPolyData& data) {
  vtkNew<vtkPoints> points;
  Cells cells;
  for (const geom::Segment& stroke : strokes) {
    for (const Point& end : {stroke.from, stroke.to}) {
      const Point world = transform.to_world(end);
      cells.add(points->InsertNextPoint(world.x - origin.x, world.y - origin.y, depth));
    }
    cells.end();
  }
  data.SetPoints(points);
  data.SetLines(cells.array());
  data.Modified();
}

class ActorMaker {
 public:
  ActorMaker(const scene::Layer& layer, Point origin, double depth, const scene::Ground& ground)
      : layer_(layer), style_(scene::style_on(layer, ground)), origin_(origin), depth_(depth) {}

  LayerActors make() && {
    std::visit(*this, layer_.content);
    return std::move(made_);
  }

  void operator()(const scene::Lines& content) {
    if (style_.dash == scene::Dash::Solid) {
      add_solid(content.lines);
    } else {
      add_dashed(content.lines);
    }
  }

  void operator()(const scene::Markers& content) {
    vtkNew<vtkPoints> points;
    Cells cells;
    for (const Point& p : content.points) {
      cells.add(insert(*points, p, depth_));
      cells.end();
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(cells.array());
    vtkActor& actor = add(data, style_.line);
    make_round(actor);
    const double size = style_.marker_size;
    made_.on_view.emplace_back([&actor, size](const scene::PanelLayout&, double pixels_per_point) {
      actor.GetProperty()->SetPointSize(static_cast<float>(size * pixels_per_point));
    });
  }

  void operator()(const scene::Regions& content) {
    if (style_.fill) {
      vtkNew<vtkPoints> points;
      Cells cells;
      for (std::size_t i = 0; content.triangles && i < content.triangles->size(); ++i) {
        cells.add(insert(*points, (*content.triangles)[i], depth_));
        if (i % 3 == 2) cells.end();
      }
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      data->SetPolys(cells.array());
      add(data, *style_.fill);
      add_pattern(content.regions);
    }
    std::vector<geom::Polyline> outlines;
    for (const scene::Region& region : content.regions) {
      for (geom::Polyline contour : region.contours) {
        contour.closed = true;
        outlines.push_back(std::move(contour));
      }
    }
    depth_ += 0.25;
    add_solid(outlines);
  }

  void operator()(const scene::Mesh& content) {
    vtkNew<vtkPoints> points;
    for (const Point& p : content.points) insert(*points, p, depth_);
    if (content.values_at != scene::ValuesAt::None || style_.fill) add_faces(content, points);
    if (style_.line_width <= 0.0) return;
    vtkNew<vtkPoints> raised;
    for (const Point& p : content.points) insert(*raised, p, depth_ + 0.25);
    Cells cells;
    for (const std::vector<std::uint32_t>& chain : scene::edge_chains(content)) {
      for (const std::uint32_t i : chain) cells.add(i);
      cells.end();
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(raised);
    data->SetLines(cells.array());
    vtkActor& actor = add(data, style_.line);
    const double mean = scene::mean_edge_length(content);
    made_.on_view.emplace_back(
        [&actor, mean, style = style_](const scene::PanelLayout& place, double pixels_per_point) {
          set_width(actor, style, scene::edge_width(mean, style, place.transform.points_per_x) * pixels_per_point);
        });
  }

  void operator()(const scene::Labels&) {}  // the layout has placed them as marks

  void operator()(const scene::Image& content) {
    if (!content.pixels || content.pixels->rgba.empty()) return;
    const scene::Pixels& pixels = *content.pixels;
    const auto width = static_cast<int>(pixels.width);
    const auto height = static_cast<int>(pixels.height);
    vtkNew<vtkImageData> image;
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    for (int y = 0; y < height; ++y) {  // VTK counts rows from the bottom
      const std::uint8_t* row = pixels.rgba.data() + 4 * pixels.width * static_cast<std::size_t>(height - 1 - y);
      std::copy(row, row + 4 * pixels.width, static_cast<std::uint8_t*>(image->GetScalarPointer(0, y, 0)));
    }
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    Cells cells;
    const geom::Box& box = content.box;
    for (const Point at : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) {
      cells.add(insert(*points, {at.x > 0.5 ? box.high.x : box.low.x, at.y > 0.5 ? box.high.y : box.low.y}, depth_));
      places->InsertNextTuple2(at.x, at.y);
    }
    cells.end();
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells.array());
    data->GetPointData()->SetTCoords(places);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    texture->InterpolateOn();
    texture->SetColorModeToDirectScalars();
    vtkActor& actor = add(data, Color{255, 255, 255});
    actor.SetTexture(texture);
    actor.GetProperty()->SetOpacity(content.opacity);
  }

 private:
  vtkIdType insert(vtkPoints& points, Point p, double depth) const {
    return points.InsertNextPoint(p.x - origin_.x, p.y - origin_.y, depth);
  }

  vtkActor& add(vtkPolyData* data, const Color& color) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
    actor->GetProperty()->SetOpacity(color.alpha / 255.0);
    actor->PickableOff();
    made_.actors.push_back(actor);
    return *actor;
  }

  void add_faces(const scene::Mesh& content, vtkPoints* points) {
    Cells cells;
    for (const auto& triangle : content.triangles) {
      for (const std::uint32_t i : triangle) cells.add(i);
      cells.end();
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells.array());
    vtkActor& actor = add(data, style_.fill.value_or(Color{255, 255, 255}));
    vtkMapper& mapper = *actor.GetMapper();
    if (content.values_at == scene::ValuesAt::None) return;
    actor.GetProperty()->SetOpacity(1.0);
    mapper.ScalarVisibilityOn();
    if (content.values_at == scene::ValuesAt::Triangles) {
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(3);
      for (const double value : content.values) {
        const Color color = scene::stepped_color(content.scale, value, color_levels);
        const unsigned char rgb[3] = {color.red, color.green, color.blue};
        colors->InsertNextTypedTuple(rgb);
      }
      data->GetCellData()->SetScalars(colors);
      mapper.SetScalarModeToUseCellData();
      mapper.SetColorModeToDirectScalars();
      return;
    }
    vtkNew<vtkFloatArray> fractions;
    vtkNew<vtkLookupTable> table;
    const double width = content.scale.high - content.scale.low;
    // Not clamped: the map's ends stay flat inside a triangle that goes beyond them.
    for (const double value : content.values) {
      fractions->InsertNextValue(static_cast<float>(width != 0.0 ? (value - content.scale.low) / width : 0.5));
    }
    table->SetNumberOfTableValues(color_levels);
    for (int i = 0; i < color_levels; ++i) {
      const Color c = scene::color_at(content.scale.map, (i + 0.5) / color_levels);
      table->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
    }
    const Color none = scene::color_at(content.scale.map, std::nan(""));
    table->SetNanColor(none.red / 255.0, none.green / 255.0, none.blue / 255.0, 1.0);
    table->SetTableRange(0.0, 1.0);
    data->GetPointData()->SetScalars(fractions);
    mapper.SetScalarModeToUsePointData();
    mapper.SetColorModeToMapScalars();
    mapper.SetLookupTable(table);
    mapper.UseLookupTableScalarRangeOn();
    mapper.InterpolateScalarsBeforeMappingOn();
  }

  /// Segments shorter than a pixel come out faint or not at all, so what is drawn is the line as it can be seen at the
  /// present scale.
  void add_solid(const std::vector<geom::Polyline>& lines) {
    if (style_.line_width <= 0.0) return;
    vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
    follow_width(add(data, style_.line));
    vtkSmartPointer<vtkPolyData> joins;
    // A wide line of VTK is cut off square at every point; discs make round joins of the gaps. On a translucent line
    // they would show.
    if (style_.line_width >= 1.5 && style_.line.alpha == 255) {
      joins = vtkSmartPointer<vtkPolyData>::New();
      vtkActor& discs = add(joins, style_.line);
      make_round(discs);
      made_.on_view.emplace_back(
          [&discs, width = style_.line_width](const scene::PanelLayout&, double pixels_per_point) {
            discs.GetProperty()->SetPointSize(static_cast<float>(width * pixels_per_point));
          });
    }
    made_.on_view.emplace_back([data, joins, lines, origin = origin_, depth = depth_, drawn_for = 0.0](
                                   const scene::PanelLayout& place, double pixels_per_point) mutable {
      const double pixels_per_unit =
          std::max(place.transform.points_per_x, place.transform.points_per_y) * pixels_per_point;
      if (pixels_per_unit == drawn_for) return;
      drawn_for = pixels_per_unit;
      vtkNew<vtkPoints> points;
      Cells cells;
      Cells verts;
      for (const geom::Polyline& line : lines) {
        const auto seen = geom::simplify(line, {seen_pixels / pixels_per_unit});
        if (!seen) continue;  // a line of one point has nothing to draw
        const vtkIdType first = points->GetNumberOfPoints();
        for (const Point& p : seen->points) {
          const vtkIdType at = points->InsertNextPoint(p.x - origin.x, p.y - origin.y, depth);
          cells.add(at);
          verts.add(at);
          verts.end();
        }
        if (line.closed) cells.add(first);
        cells.end();
      }
      data->SetPoints(points);
      data->SetLines(cells.array());
      data->Modified();
      if (joins == nullptr) return;
      joins->SetPoints(points);
      joins->SetVerts(verts.array());
      joins->Modified();
    });
  }

  /// VTK has no stipple in core OpenGL, so strokes are made for what is in sight, whenever that changes.
  void add_dashed(const std::vector<geom::Polyline>& lines) {
    if (style_.line_width <= 0.0) return;
    vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
    follow_width(add(data, style_.line));
    made_.on_view.emplace_back(
        [data, lines, style = style_, origin = origin_, depth = depth_](const scene::PanelLayout& place, double) {
          std::vector<geom::Segment> strokes;
          const std::vector<double> pattern = scene::dash_lengths(style.dash, style.line_width);
          for (const geom::Polyline& line : lines) {
            // Dashes are measured on the page: they keep their length under zoom and exaggeration.
            geom::Polyline on_page{{}, line.closed};
            for (const Point& p : line.points) on_page.points.push_back(place.transform.to_page(p));
            const auto more = scene::strokes_of(on_page, pattern, place.plot.grown(style.line_width));
            strokes.insert(strokes.end(), more.begin(), more.end());
          }
          show_strokes(strokes, place.transform, origin, depth, *data);
        });
  }

  /// Signs stand on the page, so they are made for what is in sight, whenever that changes.
  void add_pattern(const std::vector<scene::Region>& regions) {
    if (style_.pattern == scene::Pattern::None) return;
    vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
    vtkActor& actor = add(data, scene::pattern_ink);
    made_.on_view.emplace_back([&actor, data, regions, fill = *style_.fill, pattern = style_.pattern, origin = origin_,
                                depth = depth_ + 0.125](const scene::PanelLayout& place, double pixels_per_point) {
      const double pixels = scene::pattern_width(pattern) * pixels_per_point;
      set_ink(*actor.GetProperty(), fill, scene::pattern_ink, std::min(pixels, 1.0));
      actor.GetProperty()->SetLineWidth(static_cast<float>(std::max(pixels, 1.0)));
      std::vector<geom::Segment> strokes;
      for (const scene::Region& region : regions) {
        const auto more = pattern_over(region, pattern, place);
        strokes.insert(strokes.end(), more.begin(), more.end());
      }
      show_strokes(strokes, place.transform, origin, depth, *data);
    });
  }

  /// Ink over a fill as one opaque colour: what is translucent VTK draws without smoothing, and over later layers.
  static void set_ink(vtkProperty& property, const Color& fill, const Color& ink, double cover) {
    const double a = cover * ink.alpha / 255.0;
    const auto mixed = [a](std::uint8_t below, std::uint8_t above) { return ((1.0 - a) * below + a * above) / 255.0; };
    property.SetColor(mixed(fill.red, ink.red), mixed(fill.green, ink.green), mixed(fill.blue, ink.blue));
    property.SetOpacity(1.0);
  }

  /// What of the signs of a region is in its plot, in page coordinates.
  static std::vector<geom::Segment> pattern_over(const scene::Region& region, scene::Pattern pattern,
                                                 const scene::PanelLayout& place) {
    std::vector<geom::Polyline> on_page = region.contours;
    geom::Box box;
    for (geom::Polyline& contour : on_page) {
      for (Point& p : contour.points) p = place.transform.to_page(p);
      box.add(contour.box());
    }
    const geom::Box seen{{std::max(box.low.x, place.plot.low.x), std::max(box.low.y, place.plot.low.y)},
                         {std::min(box.high.x, place.plot.high.x), std::min(box.high.y, place.plot.high.y)}};
    return scene::parts_inside(scene::pattern_strokes(pattern, seen), on_page);
  }

  void follow_width(vtkActor& actor) {
    made_.on_view.emplace_back([&actor, style = style_](const scene::PanelLayout&, double pixels_per_point) {
      set_width(actor, style, style.line_width * pixels_per_point);
    });
  }

  /// A line thinner than a pixel is a fainter one of one pixel.
  static void set_width(vtkActor& actor, const scene::Style& style, double pixels) {
    actor.SetVisibility(pixels > 0.0);
    actor.GetProperty()->SetLineWidth(static_cast<float>(std::max(pixels, 1.0)));
    actor.GetProperty()->SetOpacity(style.line.alpha / 255.0 * std::min(pixels, 1.0));
  }

  /// Points as discs with soft borders.
  static void make_round(vtkActor& actor) {
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

  const scene::Layer& layer_;
  const scene::Style style_;
  Point origin_;
  double depth_;
  LayerActors made_;
};

}  // namespace

LayerActors make_actors(const scene::Layer& layer, geom::Point origin, double depth, const scene::Ground& ground) {
  return ActorMaker(layer, origin, depth, ground).make();
}

}  // namespace dobra::render
