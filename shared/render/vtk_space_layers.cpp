#include "shared/render/vtk_space_layers.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "shared/render/vtk_parts.h"
#include "shared/scene/fill.h"
#include "shared/scene/marks.h"
#include "shared/scene/space/pick.h"
#include "shared/scene/space/shade.h"

namespace dobra::render {
namespace {

using geom::Point3;
namespace space = scene::space;

/// Triangles of a surface while the view moves.
constexpr std::size_t thin_enough = 40000;
constexpr std::size_t most_strokes = 50000;  ///< Dashes of a layer; one of more is drawn solid.
constexpr double joined_width = 1.5;         ///< Points: lines from here on have round corners.
constexpr std::size_t most_joins = 20000;

/// The points of a surface as each of its parts needs them.
class PartOfSurface {
 public:
  explicit PartOfSurface(const std::vector<Point3>& points) : points_(points), known_(points.size()) {}
  std::int32_t point(Geometry& geometry, std::uint32_t i) {
    if (known_[i].part != part_) known_[i] = {part_, geometry.add_point(points_[i])};
    return known_[i].at;
  }
  void begin_next() { ++part_; }

 private:
  struct Known {
    std::uint32_t part = 0;
    std::int32_t at = 0;
  };
  const std::vector<Point3>& points_;
  std::vector<Known> known_;
  std::uint32_t part_ = 1;
};

std::size_t parts_of(std::size_t size) { return std::max<std::size_t>((size + most_an_actor - 1) / most_an_actor, 1); }

std::vector<SpaceData::Part> faces_of(const space::Surface& surface, const scene::Style& style, Point3 origin) {
  std::vector<SpaceData::Part> made;
  PartOfSurface part(surface.points);
  const std::size_t count = parts_of(surface.triangles.size());
  const bool by_cell = surface.values_at == scene::ValuesAt::Triangles || !surface.colors.empty();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t begin = part_begin(surface.triangles.size(), k, count);
    const std::size_t end = part_begin(surface.triangles.size(), k + 1, count);
    Geometry faces(origin);
    faces.reserve(end - begin, 3 * (end - begin), end - begin);
    std::vector<double> at_points;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    for (std::size_t t = begin; t < end; ++t) {
      for (const std::uint32_t i : surface.triangles[t]) {
        const auto corner = part.point(faces, i);
        faces.add_corner(corner);
        const bool is_new = static_cast<std::size_t>(corner) == at_points.size();
        if (is_new && surface.values_at == scene::ValuesAt::Points) at_points.push_back(surface.values[i]);
      }
      faces.end_cell();
      if (!by_cell) continue;
      const scene::Color color = space::color_of(surface, t, style);
      const unsigned char rgba[4] = {color.red, color.green, color.blue, color.alpha};
      colors->InsertNextTypedTuple(rgba);
    }
    part.begin_next();
    made.push_back(faces.data(Geometry::As::Polygons));
    if (surface.values_at == scene::ValuesAt::Points)
      made.back()->GetPointData()->SetScalars(fractions_of(surface.scale, at_points));
    else if (by_cell)
      made.back()->GetCellData()->SetScalars(colors);
  }
  return made;
}

double mean_edge(const space::Surface& surface) {
  double sum = 0.0;
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) sum += geom::distance(surface.points[t[k]], surface.points[t[(k + 1) % 3]]);
  }
  return surface.triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(surface.triangles.size()));
}

std::vector<SpaceData::Part> edges_of(const space::Surface& surface, Point3 origin) {
  const auto chains = scene::edge_chains(surface.triangles.get(), surface.points.size());
  std::vector<SpaceData::Part> made;
  PartOfSurface part(surface.points);
  const std::size_t count = parts_of(surface.triangles.size());
  for (std::size_t k = 0; k < count; ++k) {
    Geometry edges(origin);
    for (std::size_t c = part_begin(chains.size(), k, count); c < part_begin(chains.size(), k + 1, count); ++c) {
      for (const std::uint32_t i : chains[c]) edges.add_corner(part.point(edges, i));
      edges.end_cell();
    }
    part.begin_next();
    made.push_back(edges.data(Geometry::As::Lines));
  }
  return made;
}

class DataMaker {
 public:
  DataMaker(const space::Layer& layer, Point3 origin) : layer_(layer), origin_(origin) {}
  SpaceData make() && {
    std::visit(*this, layer_.content);
    return std::move(data_);
  }

  void operator()(const space::Lines& content) {
    Geometry lines(origin_);
    std::size_t count = 0;
    for (const std::vector<Point3>& line : content.lines) {
      for (const Point3& p : line) lines.add_corner(lines.add_point(p));
      lines.end_cell();
      count += line.size();
    }
    data_.lines.push_back(lines.data(Geometry::As::Lines));
    if (layer_.style.line_width < joined_width || layer_.style.dash != scene::Dash::Solid || count > most_joins) return;
    Geometry joins(origin_);
    for (const std::vector<Point3>& line : content.lines) {
      for (const Point3& p : line) {
        joins.add_corner(joins.add_point(p));
        joins.end_cell();
      }
    }
    data_.discs.push_back(joins.data(Geometry::As::Points));
  }
  void operator()(const space::Markers& content) {
    Geometry points(origin_);
    for (const Point3& p : content.points) {
      points.add_corner(points.add_point(p));
      points.end_cell();
    }
    data_.discs.push_back(points.data(Geometry::As::Points));
  }
  void operator()(const space::Surface& content) {
    data_.faces = faces_of(content, layer_.style, origin_);
    if (layer_.style.line_width > 0.0) {
      data_.edges = edges_of(content, origin_);
      data_.mean_edge = mean_edge(content);
    }
    if (content.triangles.size() > thin_enough)
      data_.thinned = faces_of(space::thinned(content, thin_enough), layer_.style, origin_);
  }
  void operator()(const space::Labels&) {}   // the layout has placed them as marks
  void operator()(const space::Curtain&) {}  // unrolled before

 private:
  const space::Layer& layer_;
  Point3 origin_;
  SpaceData data_;
};

/// Lines and points that lie on a surface are drawn over it.
void lift(vtkActor& actor) {
  actor.GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                                        "//VTK::PositionVC::Impl\n"
                                                        "  gl_Position.z -= 0.004 * gl_Position.w;\n",
                                                        false);
}

vtkSmartPointer<vtkActor> actor_of(const SpaceData::Part& part, const scene::Color& color) {
  vtkSmartPointer<vtkActor> actor = flat_actor(color);
  static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(part);
  return actor;
}

std::vector<vtkSmartPointer<vtkActor>> face_actors(const std::vector<SpaceData::Part>& parts, const space::Layer& layer,
                                                   const space::Light& light) {
  const auto& surface = std::get<space::Surface>(layer.content);
  const scene::Color plain = layer.style.fill.value_or(scene::Color{200, 204, 210});
  std::vector<vtkSmartPointer<vtkActor>> made;
  vtkSmartPointer<vtkLookupTable> table;
  if (surface.values_at == scene::ValuesAt::Points) table = table_of(surface.scale);
  for (const SpaceData::Part& part : parts) {
    made.push_back(actor_of(part, plain));
    vtkProperty& property = *made.back()->GetProperty();
    property.LightingOn();
    property.SetInterpolationToFlat();
    property.SetAmbientColor(property.GetColor());
    property.SetAmbient(light.ambient);
    property.SetDiffuse(1.0 - light.ambient);
    property.SetSpecular(0.0);
    vtkMapper& mapper = *made.back()->GetMapper();
    if (table != nullptr) {
      mapper.ScalarVisibilityOn();
      mapper.SetScalarModeToUsePointData();
      mapper.SetColorModeToMapScalars();
      mapper.SetLookupTable(table);
      mapper.UseLookupTableScalarRangeOn();
      mapper.InterpolateScalarsBeforeMappingOn();
    } else if (surface.values_at == scene::ValuesAt::Triangles || !surface.colors.empty()) {
      mapper.ScalarVisibilityOn();
      mapper.SetScalarModeToUseCellData();
      mapper.SetColorModeToDirectScalars();
      property.SetOpacity(1.0);
    }
  }
  return made;
}

/// Dashes of lines in space, of their length on the page where they do not lead away from the viewer.
SpaceData::Part dashed(const space::Lines& content, const scene::Style& style, double world_per_point, Point3 origin) {
  const std::vector<double> pattern = scene::dash_lengths(style.dash, style.line_width);
  double period = 0.0;
  for (const double length : pattern) period += length * world_per_point;
  double all = 0.0;
  for (const std::vector<Point3>& line : content.lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) all += geom::distance(line[i], line[i + 1]);
  }
  const bool solid = !(period > 0.0) || all / period > static_cast<double>(most_strokes);
  Geometry made(origin);
  const auto add = [&](Point3 from, Point3 to) {
    made.add_corner(made.add_point(from));
    made.add_corner(made.add_point(to));
    made.end_cell();
  };
  for (const std::vector<Point3>& line : content.lines) {
    double along = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double length = geom::distance(line[i], line[i + 1]);
      const auto at = [&](double l) {
        return line[i] + (std::clamp(l, 0.0, length) / length) * (line[i + 1] - line[i]);
      };
      if (!(length > 0.0)) continue;
      if (solid) {
        add(line[i], line[i + 1]);
        continue;
      }
      for (double begin = -std::fmod(along, period); begin < length; begin += period) {
        double from = begin;
        for (std::size_t k = 0; k < pattern.size(); ++k) {
          const double to = from + pattern[k] * world_per_point;
          if (k % 2 == 0 && to > 0.0 && from < length) add(at(from), at(to));
          from = to;
        }
      }
      along = std::fmod(along + length, period);
    }
  }
  return made.data(Geometry::As::Lines);
}

}  // namespace

SpaceData make_data(const space::Layer& layer, Point3 origin) { return DataMaker(layer, origin).make(); }

std::size_t size_of(const space::Layer& layer) {
  if (const auto* surface = std::get_if<space::Surface>(&layer.content))
    return surface->points.size() + surface->triangles.size();
  if (const auto* markers = std::get_if<space::Markers>(&layer.content)) return markers->points.size();
  std::size_t count = 0;
  if (const auto* lines = std::get_if<space::Lines>(&layer.content)) {
    for (const std::vector<Point3>& line : lines->lines) count += line.size();
  }
  return count;
}

SpaceActors make_actors(const space::Layer& layer, const SpaceData& data, Point3 origin, const space::Light& light,
                        const scene::Ground& ground) {
  SpaceActors made;
  const bool is_surface = std::holds_alternative<space::Surface>(layer.content);
  const scene::Color line = is_surface ? layer.style.line : scene::line_on(layer.style.line, ground);
  const auto add = [&](const SpaceData::Part& part) {
    made.full.push_back(actor_of(part, line));
    lift(*made.full.back());
    if (data.thinned.empty()) made.thinned.push_back(made.full.back());
    return made.full.back();
  };
  if (is_surface) {
    made.full = face_actors(data.faces, layer, light);
    made.thinned = data.thinned.empty() ? made.full : face_actors(data.thinned, layer, light);
    std::vector<vtkSmartPointer<vtkActor>> edges;
    for (const SpaceData::Part& part : data.edges) edges.push_back(add(part));
    if (!edges.empty()) {
      made.on_view.emplace_back([edges, line, style = layer.style, mean = data.mean_edge](const space::Sheet& sheet,
                                                                                          double pixels_per_point) {
        const double width = scene::edge_width(mean, style, sheet.page.points_per_x) * pixels_per_point;
        for (const auto& edge : edges) set_width(*edge, line, width);
      });
    }
    return made;
  }
  if (layer.style.line_width > 0.0) {
    for (const SpaceData::Part& part : data.lines) {
      const vtkSmartPointer<vtkActor> actor = add(part);
      made.on_view.emplace_back([actor, line, width = layer.style.line_width](const space::Sheet&, double ratio) {
        set_width(*actor, line, width * ratio);
      });
      if (layer.style.dash == scene::Dash::Solid) continue;
      const auto& content = std::get<space::Lines>(layer.content);
      made.on_view.emplace_back([actor, content, style = layer.style, origin, made_for = std::make_shared<double>(0.0)](
                                    const space::Sheet& sheet, double) {
        constexpr double near_enough = 1.3;
        const double scale = 1.0 / sheet.page.points_per_x;
        if (*made_for > 0.0 && scale < near_enough * *made_for && *made_for < near_enough * scale) return;
        *made_for = scale;
        static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(dashed(content, style, scale, origin));
      });
    }
  }
  const bool markers = std::holds_alternative<space::Markers>(layer.content);
  const double size = markers ? layer.style.marker_size : layer.style.line_width;
  if (!markers && line.alpha != 255) return made;
  for (const SpaceData::Part& part : data.discs) {
    const vtkSmartPointer<vtkActor> actor = add(part);
    make_round(*actor);
    made.on_view.emplace_back([actor, size](const space::Sheet&, double pixels_per_point) {
      actor->GetProperty()->SetPointSize(static_cast<float>(size * pixels_per_point));
    });
  }
  return made;
}

}  // namespace dobra::render
