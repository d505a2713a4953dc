#include "shared/render/vtk_layers.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

#include "shared/render/vtk_parts.h"
#include "shared/scene/color_map.h"
#include "shared/scene/detail.h"
#include "shared/scene/fill.h"
#include "shared/scene/pattern.h"

namespace dobra::render {
namespace {

using geom::Point;
using scene::Color;

/// Details of a line smaller than this cannot be seen.
constexpr double seen_pixels = 0.1;

/// Where geometry is to lie.
struct Ground {
  Point origin;
  double depth;
  [[nodiscard]] Geometry operator()() const { return {origin, depth}; }
};

using Made = std::vector<vtkSmartPointer<vtkPolyData>>;

/// Strokes given in page coordinates.
vtkSmartPointer<vtkPolyData> strokes_data(const std::vector<geom::Segment>& strokes, const scene::Transform& transform,
                                          Geometry& geometry) {
  for (const geom::Segment& stroke : strokes) {
    for (const Point& end : {stroke.from, stroke.to}) geometry.add_corner(geometry.add_point(transform.to_world(end)));
    geometry.end_cell();
  }
  return geometry.data(Geometry::As::Lines);
}

class ActorMaker {
 public:
  ActorMaker(const scene::Layer& layer, Point origin, double depth, const scene::Ground& ground)
      : layer_(layer), style_(scene::style_on(layer, ground)), origin_(origin), depth_(depth) {
    made_.points = scene::point_count(layer);
  }

  LayerActors make() && {
    std::visit(*this, layer_.content);
    return std::move(made_);
  }

  void operator()(const scene::Lines& content) {
    if (style_.line_width <= 0.0) return;
    if (style_.dash == scene::Dash::Solid) {
      add_solid([lines = content.lines](const scene::Sight& sight) { return scene::seen_lines(lines, sight); });
    } else {
      add_dashed(content.lines);
    }
  }

  void operator()(const scene::Markers& content) {
    const Actors actors = add_actors(style_.line, content.points.size());
    for (const auto& actor : actors) make_round(*actor);
    made_.on_view.emplace_back([actors, size = style_.marker_size](const scene::PanelLayout&, double pixels_per_point) {
      for (const auto& actor : actors) actor->GetProperty()->SetPointSize(static_cast<float>(size * pixels_per_point));
    });
    add_shape(Shape::Follows::Nothing, actors,
              [points = content.points, count = actors.size(), geometry = place()](const Look&) {
                Made made;
                for (std::size_t k = 0; k < count; ++k) {
                  Geometry marks = geometry();
                  for (std::size_t i = part_begin(points.size(), k, count); i < part_begin(points.size(), k + 1, count);
                       ++i) {
                    marks.add_corner(marks.add_point(points[i]));
                    marks.end_cell();
                  }
                  made.push_back(marks.data(Geometry::As::Points));
                }
                return made;
              });
  }

  void operator()(const scene::Regions& content) {
    const auto seen = std::make_shared<SeenRegions>(content.regions);
    if (style_.fill) {
      vtkActor& areas = add(*style_.fill);
      add_shape(Shape::Follows::Detail, {&areas}, [seen, geometry = place()](const Look& look) {
        Geometry filled = geometry();
        const auto regions = seen->under(look.sight());
        for (const scene::Region& region : *regions) {
          const std::vector<Point> triangles = scene::triangles_of(region);
          for (std::size_t i = 0; i < triangles.size(); ++i) {
            filled.add_corner(filled.add_point(triangles[i]));
            if (i % 3 == 2) filled.end_cell();
          }
        }
        return Made{filled.data(Geometry::As::Polygons)};
      });
      add_pattern(seen);
    }
    if (style_.line_width <= 0.0) return;
    depth_ += 0.25;
    add_solid([regions = content.regions](const scene::Sight& sight) {
      std::vector<geom::Polyline> seen_contours;
      for (const scene::Region& region : regions) {
        std::vector<geom::Polyline> contours = region.contours;
        for (geom::Polyline& contour : contours) contour.closed = true;
        for (geom::Polyline& line : scene::seen_lines(contours, sight)) seen_contours.push_back(std::move(line));
      }
      return seen_contours;
    });
  }

  void operator()(const scene::Mesh& content) {
    if (content.values_at != scene::ValuesAt::None || style_.fill) add_faces(content);
    if (style_.line_width <= 0.0) return;
    const Actors actors = add_actors(style_.line, content.triangles.size());
    const auto mean = std::make_shared<std::atomic<double>>(0.0);
    depth_ += 0.25;
    add_shape(Shape::Follows::Nothing, actors, [content, mean, count = actors.size(), geometry = place()](const Look&) {
      *mean = scene::mean_edge_length(content);
      const auto chains = scene::edge_chains(content);
      PartOfMesh part(content.points);
      Made made;
      for (std::size_t k = 0; k < count; ++k) {
        Geometry edges = geometry();
        for (std::size_t c = part_begin(chains.size(), k, count); c < part_begin(chains.size(), k + 1, count); ++c) {
          for (const std::uint32_t i : chains[c]) edges.add_corner(part.point(edges, i));
          edges.end_cell();
        }
        made.push_back(edges.data(Geometry::As::Lines));
        part.begin_next();
      }
      return made;
    });
    made_.on_view.emplace_back(
        [actors, mean, style = style_](const scene::PanelLayout& place, double pixels_per_point) {
          const double width = scene::edge_width(*mean, style, place.transform.points_per_x) * pixels_per_point;
          for (const auto& actor : actors) set_width(*actor, style.line, width);
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
    vtkActor& actor = add(Color{255, 255, 255});
    actor.SetTexture(smooth_texture(image));
    actor.GetProperty()->SetOpacity(content.opacity);
    add_shape(Shape::Follows::Nothing, {&actor}, [box = content.box, origin = origin_, depth = depth_](const Look&) {
      return Made{textured_box(box, origin, depth)};
    });
  }

 private:
  /// The regions of a layer as they are seen; the last answer is kept, for its fill and its pattern ask alike.
  class SeenRegions {
   public:
    using List = std::vector<scene::Region>;
    explicit SeenRegions(base::Shared<List> regions) : regions_(std::move(regions)) {}
    [[nodiscard]] std::shared_ptr<const List> under(const scene::Sight& sight) {
      const std::lock_guard lock(mutex_);
      const bool known = seen_ && sight_.detail == sight.detail && sight_.window == sight.window;
      if (known) return seen_;
      auto list = std::make_shared<List>();
      for (const scene::Region& region : regions_) list->push_back(scene::seen_region(region, sight));
      sight_ = sight;
      seen_ = std::move(list);
      return seen_;
    }

   private:
    base::Shared<List> regions_;
    std::mutex mutex_;
    scene::Sight sight_;
    std::shared_ptr<const List> seen_;
  };

  /// The points of a mesh as each of its parts needs them.
  class PartOfMesh {
   public:
    explicit PartOfMesh(const std::vector<Point>& points) : points_(points), known_(points.size()) {}
    std::int32_t point(Geometry& geometry, std::uint32_t i) {
      if (known_[i].part == part_) return known_[i].at;
      return (known_[i] = {part_, geometry.add_point(points_[i])}).at;
    }
    void begin_next() { ++part_; }

   private:
    struct Known {
      std::uint32_t part = 0;
      std::int32_t at = 0;
    };
    const std::vector<Point>& points_;
    std::vector<Known> known_;
    std::uint32_t part_ = 1;
  };
  using Actors = std::vector<vtkSmartPointer<vtkActor>>;

  [[nodiscard]] Ground place() const { return {origin_, depth_}; }

  Actors add_actors(const Color& color, std::size_t size) {
    Actors actors;
    for (std::size_t done = 0; done == 0 || done < size; done += most_an_actor) {
      add(color);
      actors.push_back(made_.actors.back());
    }
    return actors;
  }

  vtkActor& add(const Color& color) {
    auto actor = flat_actor(color);
    made_.actors.push_back(actor);
    return *actor;
  }

  void add_shape(Shape::Follows follows, std::vector<vtkSmartPointer<vtkActor>> actors,
                 std::function<Made(const Look&)> make) {
    made_.shapes.push_back(std::make_shared<Shape>(follows, std::move(actors), std::move(make)));
  }

  void add_faces(const scene::Mesh& content) {
    const Actors actors = add_actors(style_.fill.value_or(Color{255, 255, 255}), content.triangles.size());
    add_shape(Shape::Follows::Nothing, actors, [content, count = actors.size(), geometry = place()](const Look&) {
      PartOfMesh part(content.points);
      Made made;
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t begin = part_begin(content.triangles.size(), k, count);
        const std::size_t end = part_begin(content.triangles.size(), k + 1, count);
        Geometry faces = geometry();
        faces.reserve(end - begin, 3 * (end - begin), end - begin);
        std::vector<double> at_points;
        for (std::size_t t = begin; t < end; ++t) {
          for (const std::uint32_t i : content.triangles[t]) {
            const auto corner = part.point(faces, i);
            faces.add_corner(corner);
            const bool is_new = static_cast<std::size_t>(corner) == at_points.size();
            if (is_new && content.values_at == scene::ValuesAt::Points) at_points.push_back(content.values[i]);
          }
          faces.end_cell();
        }
        part.begin_next();
        const vtkSmartPointer<vtkPolyData> data = faces.data(Geometry::As::Polygons);
        if (content.values_at == scene::ValuesAt::Triangles)
          data->GetCellData()->SetScalars(colors_of(content, begin, end));
        if (content.values_at == scene::ValuesAt::Points)
          data->GetPointData()->SetScalars(fractions_of(content.scale, at_points));
        made.push_back(data);
      }
      return made;
    });
    if (content.values_at == scene::ValuesAt::None) return;
    vtkSmartPointer<vtkLookupTable> table;
    if (content.values_at == scene::ValuesAt::Points) table = table_of(content.scale);
    for (const auto& actor : actors) {
      actor->GetProperty()->SetOpacity(1.0);
      vtkMapper& mapper = *actor->GetMapper();
      mapper.ScalarVisibilityOn();
      if (table == nullptr) {
        mapper.SetScalarModeToUseCellData();
        mapper.SetColorModeToDirectScalars();
        continue;
      }
      mapper.SetScalarModeToUsePointData();
      mapper.SetColorModeToMapScalars();
      mapper.SetLookupTable(table);
      mapper.UseLookupTableScalarRangeOn();
      mapper.InterpolateScalarsBeforeMappingOn();
    }
  }

  static vtkSmartPointer<vtkDataArray> colors_of(const scene::Mesh& content, std::size_t begin, std::size_t end) {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(3);
    colors->Allocate(static_cast<vtkIdType>(3 * (end - begin)));
    for (std::size_t t = begin; t < end; ++t) {
      const Color color = scene::stepped_color(content.scale, content.values[t], color_levels);
      const unsigned char rgb[3] = {color.red, color.green, color.blue};
      colors->InsertNextTypedTuple(rgb);
    }
    return colors;
  }

  /// Segments shorter than a pixel come out faint or not at all, so what is drawn is the line as it can be seen.
  void add_solid(std::function<std::vector<geom::Polyline>(const scene::Sight&)> seen) {
    vtkActor& strokes = add(style_.line);
    follow_width(strokes);
    std::vector<vtkSmartPointer<vtkActor>> actors{&strokes};
    // A wide line of VTK is cut off square at every point; discs make round joins of the gaps. On a translucent line
    // they would show.
    if (style_.line_width >= 1.5 && style_.line.alpha == 255) {
      vtkActor& discs = add(style_.line);
      make_round(discs);
      made_.on_view.emplace_back(
          [&discs, width = style_.line_width](const scene::PanelLayout&, double pixels_per_point) {
            discs.GetProperty()->SetPointSize(static_cast<float>(width * pixels_per_point));
          });
      actors.emplace_back(&discs);
    }
    const bool joined = actors.size() > 1;
    add_shape(Shape::Follows::Detail, std::move(actors),
              [seen = std::move(seen), joined, geometry = place()](const Look& look) {
                Geometry lines = geometry();
                Geometry joins = geometry();
                for (const geom::Polyline& line : seen(look.sight())) {
                  std::optional<std::int32_t> first;
                  for (const Point& p : line.points) {
                    const std::int32_t at = lines.add_point(p);
                    if (!first) first = at;
                    lines.add_corner(at);
                    if (!joined) continue;
                    joins.add_corner(joins.add_point(p));
                    joins.end_cell();
                  }
                  if (line.closed && first) lines.add_corner(*first);
                  lines.end_cell();
                }
                Made made{lines.data(Geometry::As::Lines)};
                if (joined) made.push_back(joins.data(Geometry::As::Points));
                return made;
              });
  }

  /// VTK has no stipple in core OpenGL, so strokes are made for what is in sight, whenever that changes.
  void add_dashed(const base::Shared<std::vector<geom::Polyline>>& lines) {
    vtkActor& actor = add(style_.line);
    follow_width(actor);
    add_shape(Shape::Follows::View, {&actor}, [lines, style = style_, geometry = place()](const Look& look) {
      std::vector<geom::Segment> strokes;
      const scene::Transform& transform = look.place.transform;
      const std::vector<double> pattern = scene::dash_lengths(style.dash, style.line_width);
      for (const geom::Polyline& line : lines) {
        // Dashes are measured on the page: they keep their length under zoom and exaggeration.
        geom::Polyline on_page{{}, line.closed};
        on_page.points.reserve(line.points.size());
        for (const Point& p : line.points) on_page.points.push_back(transform.to_page(p));
        const auto more = scene::strokes_of(on_page, pattern, look.place.plot.grown(style.line_width));
        strokes.insert(strokes.end(), more.begin(), more.end());
      }
      Geometry made = geometry();
      return Made{strokes_data(strokes, transform, made)};
    });
  }

  /// Signs stand on the page, so they are made for what is in sight, whenever that changes.
  void add_pattern(std::shared_ptr<SeenRegions> seen) {
    if (style_.pattern == scene::Pattern::None) return;
    vtkActor& actor = add(scene::pattern_ink);
    made_.on_view.emplace_back(
        [&actor, fill = *style_.fill, pattern = style_.pattern](const scene::PanelLayout&, double pixels_per_point) {
          const double pixels = scene::pattern_width(pattern) * pixels_per_point;
          set_ink(*actor.GetProperty(), fill, scene::pattern_ink, std::min(pixels, 1.0));
          actor.GetProperty()->SetLineWidth(static_cast<float>(std::max(pixels, 1.0)));
        });
    const double over = depth_ + 0.125;
    add_shape(Shape::Follows::View, {&actor},
              [seen = std::move(seen), pattern = style_.pattern, origin = origin_, over](const Look& look) {
                std::vector<geom::Segment> strokes;
                const auto regions = seen->under(look.sight());
                for (const scene::Region& region : *regions) {
                  const auto more = pattern_over(region, pattern, look.place);
                  strokes.insert(strokes.end(), more.begin(), more.end());
                }
                Geometry made(origin, over);
                return Made{strokes_data(strokes, look.place.transform, made)};
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
      set_width(actor, style.line, style.line_width * pixels_per_point);
    });
  }

  const scene::Layer& layer_;
  const scene::Style style_;
  Point origin_;
  double depth_;
  LayerActors made_;
};

}  // namespace

scene::Sight Look::sight() const {
  // Steps of two, so that what has been made serves for a while as the view comes nearer.
  const double pixels = std::max(place.transform.points_per_x, place.transform.points_per_y) * pixels_per_point;
  const double step = std::exp2(std::ceil(std::log2(pixels)));
  return {seen_pixels / step, window};
}

geom::Box Look::seen() const {
  geom::Box box;
  for (const Point corner : {place.plot.low, place.plot.high}) box.add(place.transform.to_world(corner));
  return box;
}

Look look_at(const scene::PanelLayout& place, double pixels_per_point, std::size_t points) {
  constexpr std::size_t few = 5000;  // are drawn whole
  constexpr double everything = 1e300;
  Look look{place, pixels_per_point, {{-everything, -everything}, {everything, everything}}};
  if (points <= few) return look;
  const geom::Box box = look.seen();
  look.window = {{box.low.x - box.width(), box.low.y - box.height()},
                 {box.high.x + box.width(), box.high.y + box.height()}};
  return look;
}

bool Look::serves(const Look& other, Follows follows) const {
  if (follows == Follows::Nothing) return true;
  if (follows == Follows::Detail) {
    const geom::Box box = other.seen();
    return sight().detail == other.sight().detail && window.contains(box.low) && window.contains(box.high);
  }
  const scene::Transform& a = place.transform;
  const scene::Transform& b = other.place.transform;
  const Point origin{};
  return a.points_per_x == b.points_per_x && a.points_per_y == b.points_per_y &&
         a.to_page(origin) == b.to_page(origin) && place.plot == other.place.plot &&
         pixels_per_point == other.pixels_per_point;
}

void Shape::show(const std::vector<vtkSmartPointer<vtkPolyData>>& made, const Look& look) {
  made_for = look;
  for (std::size_t i = 0; i < actors.size(); ++i)
    static_cast<vtkPolyDataMapper*>(actors[i]->GetMapper())->SetInputData(made[i]);
}

LayerActors make_actors(const scene::Layer& layer, geom::Point origin, double depth, const scene::Ground& ground) {
  return ActorMaker(layer, origin, depth, ground).make();
}

vtkSmartPointer<vtkTexture> smooth_texture(vtkImageData* image) {
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetColorModeToDirectScalars();
  return texture;
}

vtkSmartPointer<vtkPolyData> textured_box(const geom::Box& box, geom::Point origin, double depth) {
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  Geometry corners(origin, depth);
  for (const Point at : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) {
    corners.add_corner(
        corners.add_point(Point{at.x > 0.5 ? box.high.x : box.low.x, at.y > 0.5 ? box.high.y : box.low.y}));
    places->InsertNextTuple2(at.x, at.y);
  }
  corners.end_cell();
  vtkSmartPointer<vtkPolyData> data = corners.data(Geometry::As::Polygons);
  data->GetPointData()->SetTCoords(places);
  return data;
}

}  // namespace dobra::render
