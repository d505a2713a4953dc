// The planar layout does the work, twice: for a panel that stands for the plane of the page, and once its scale is
// known for that panel with the labels of the axes, which are as large at every scale.
#include "shared/scene/space/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "shared/base/text.h"
#include "shared/scene/decimal_mark.h"
#include "shared/scene/furniture.h"
#include "shared/scene/ticks.h"

namespace dobra::scene::space {

namespace {

using geom::Point;
using geom::Point3;
using geom::Vector;
using geom::Vector3;

/// Round the picture, points: for the labels of its edges, or for the eye alone.
constexpr Vector room_for_labels{58.0, 36.0};
constexpr Vector room_for_eye{10.0, 10.0};
constexpr double shortest_axis = 30.0;  ///< Of one that has ticks, points.
constexpr double corner_axis = 26.0;    ///< Of one in the corner that is not shortened, points.
constexpr double corner_room = 40.0;    ///< From the corner to where they begin.
constexpr double least_corner_axis = 0.25;
constexpr std::array<Color, 3> axis_colors{Color{178, 34, 34}, Color{30, 110, 50}, Color{30, 70, 170}};

double& coordinate(Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
double coordinate(const Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Labels in plane coordinates, as a layer of the panel that stands for the page.
class LabelLayer {
 public:
  LabelLayer(const Color& color, double size) {
    layer_.style.line = color;
    layer_.style.text_size = size;
    layer_.in_legend = InLegend::No;
  }
  void add(Point plane, std::string text, Anchor anchor = Anchor::Centre) {
    labels_.labels.push_back({plane, std::move(text), anchor});
  }
  [[nodiscard]] scene::Layer take() {
    layer_.content = std::move(labels_);
    return std::move(layer_);
  }

 private:
  scene::Layer layer_;
  scene::Labels labels_;
};

class Maker {
 public:
  Maker(const SpacePicture& picture, const geom::Box3& shown, const Look& look, const TextMeasure& measure,
        const LayoutOptions& options)
      : picture_(picture), shown_(shown), look_(look), measure_(measure), options_(options) {
    plane_ = described(picture);
    frame_ = frame_of(look.camera, shown, picture.vertical_exaggeration);
    Panel& panel = plane_.panels.front();
    if (picture.vertical_exaggeration != 1.0) {
      panel.axes.x_title = fmt::format("({} {}\u00d7)", base::translated("vertical exaggeration"),
                                       with_decimal_mark(fmt::format("{:g}", picture.vertical_exaggeration)));
    }
    add_labels_of_picture(panel);
    panel.extent = comfortable(projected(frame_, shown));
  }

  /// The plot shows all, with room for what stands round the picture.
  void make_room(const PageSize& page) {
    if (look_.view) return;
    const geom::Box box = projected(frame_, shown_);
    const Vector room = picture_.axes.box == AxesBox::Shown ? room_for_labels : room_for_eye;
    plane_.panels.front().extent = box.diagonal() > 0.0 ? box : comfortable(box);
    for (int i = 0; i < 3; ++i) {
      const double scale = laid_out(page).panels.front().transform.points_per_x;
      plane_.panels.front().extent = geom::Box{box.low - (1.0 / scale) * room, box.high + (1.0 / scale) * room};
    }
  }

  [[nodiscard]] Layout laid_out(const PageSize& page) const {
    const std::optional<View> view = look_.view;
    return scene::layout(plane_, page, view ? std::span(&view, 1) : std::span<const std::optional<View>>{}, measure_,
                         options_);
  }

  SpaceLayout make(const PageSize& page) {
    make_room(page);
    PanelLayout place = laid_out(page).panels.front();
    sheet_ = {frame_, place.transform, place.plot};
    std::vector<Mark> lines;
    Panel& panel = plane_.panels.front();
    if (picture_.axes.box == AxesBox::Shown) add_edges(panel, lines);
    add_corner(panel, lines);
    SpaceLayout made;
    made.page = laid_out(page);
    place = made.page.panels.front();
    made.sheet = {frame_, place.transform, place.plot};
    made.view = place.view;
    made.page.marks.insert(made.page.marks.begin(), lines.begin(), lines.end());
    return made;
  }

  [[nodiscard]] const Picture& plane() const { return plane_; }

 private:
  void add_labels_of_picture(Panel& panel) const {
    for (const Layer& layer : unrolled(picture_)) {
      const auto* content = std::get_if<Labels>(&layer.content);
      if (content == nullptr || !layer.visible) continue;
      LabelLayer labels(layer.style.line, layer.style.text_size);
      for (const Label& label : content->labels) {
        if (const auto seen = project(frame_, label.at)) labels.add(seen->at, label.text, label.anchor);
      }
      panel.layers.push_back(labels.take());
    }
  }

  struct PageEdge {
    Point3 from, to;
    Point page_from, page_to;
  };

  /// Of the four edges along an axis, the lowest on the page, of equals the right one, but the left one where they
  /// stand upright; of z the leftmost: nothing of the picture is before it.
  [[nodiscard]] std::optional<PageEdge> edge_along(int axis) const {
    std::optional<PageEdge> best;
    double best_score = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      PageEdge edge{shown_.low, shown_.low, {}, {}};
      coordinate(edge.from, (axis + 1) % 3) = coordinate((corner & 1) != 0 ? shown_.high : shown_.low, (axis + 1) % 3);
      coordinate(edge.from, (axis + 2) % 3) = coordinate((corner & 2) != 0 ? shown_.high : shown_.low, (axis + 2) % 3);
      edge.to = edge.from;
      coordinate(edge.to, axis) = coordinate(shown_.high, axis);
      const auto from = project(sheet_, edge.from);
      const auto to = project(sheet_, edge.to);
      if (!from || !to || geom::distance(from->at, to->at) < shortest_axis) continue;
      edge.page_from = from->at;
      edge.page_to = to->at;
      const Point middle = geom::midpoint(from->at, to->at);
      const bool upright = std::abs(to->at.x - from->at.x) < 1e-6 * std::abs(to->at.y - from->at.y);
      const double right = upright ? -1e-3 : 1e-3;
      const double score = axis == 2 ? -middle.x + 1e-3 * middle.y : middle.y + right * middle.x;
      if (!best || score > best_score + 1e-9) {
        best = edge;
        best_score = score;
      }
    }
    return best;
  }

  /// From an edge away from the picture, on the page.
  [[nodiscard]] Vector outwards(const PageEdge& edge) const {
    const Vector along = edge.page_to - edge.page_from;
    const Vector normal = (1.0 / geom::length(along)) * Vector{-along.y, along.x};
    const Point centre = sheet_.page.to_page(projected(frame_, shown_).centre());
    const double side = geom::dot(normal, geom::midpoint(edge.page_from, edge.page_to) - centre);
    if (std::abs(side) < 1e-6) return normal.y > 0.0 ? normal : -normal;
    return side < 0.0 ? -normal : normal;
  }

  void add_edges(Panel& panel, std::vector<Mark>& lines) const {
    const std::array<std::string, 3> titles{picture_.axes.x_title, picture_.axes.y_title, picture_.axes.z_title};
    LabelLayer numbers(ink, options_.text_size - 1.0);
    LabelLayer names(ink, options_.text_size);
    for (int axis = 0; axis < 3; ++axis) {
      if (const auto edge = edge_along(axis)) {
        add_edge(*edge, axis, titles[static_cast<std::size_t>(axis)], numbers, names, lines);
      }
    }
    panel.layers.push_back(numbers.take());
    panel.layers.push_back(names.take());
  }

  void add_edge(const PageEdge& edge, int axis, const std::string& title, LabelLayer& numbers, LabelLayer& names,
                std::vector<Mark>& lines) const {
    const Vector out = outwards(edge);
    const Font font{options_.text_size - 1.0, Weight::Regular};
    const auto add_line = [&](Point a, Point b) {
      double begin = 0.0;
      double end = 1.0;
      if (!part_inside({a, b}, sheet_.plot, begin, end)) return;
      lines.emplace_back(
          LineMark{geom::interpolate(a, b, begin), geom::interpolate(a, b, end), frame_color, 0.75, Dash::Solid});
    };
    add_line(edge.page_from, edge.page_to);
    const Vector along = edge.page_to - edge.page_from;
    const double length = geom::length(along);
    // Room along the edge that keeps level text apart.
    const double line = measure_("0", font).height();
    const auto room = [&](const std::string& text) {
      const double width = measure_(text, font).width;
      return length * std::min(width / std::max(std::abs(along.x), 1e-9), line / std::max(std::abs(along.y), 1e-9));
    };
    const double unit = picture_.axes.unit;
    const double low = coordinate(edge.from, axis);
    const double high = coordinate(edge.to, axis);
    double widest = 0.0;
    const auto beside = [&](Point at, const TextSize& size, double off) {
      return at + (off + 0.5 * (std::abs(out.x) * size.width + std::abs(out.y) * size.height())) * out;
    };
    for (const Tick& tick : ticks_that_fit(low / unit, high / unit, length, 8.0, 20.0, room)) {
      Point3 world = edge.from;
      coordinate(world, axis) = std::clamp(tick.value * unit, low, high);
      const auto seen = project(sheet_, world);
      if (!seen) continue;
      add_line(seen->at, seen->at + tick_length * out);
      const TextSize size = measure_(tick.label, font);
      widest = std::max(widest, std::abs(out.x) * size.width + std::abs(out.y) * size.height());
      const Point at = beside(seen->at, size, tick_length + tick_gap);
      if (sheet_.plot.contains(at)) numbers.add(sheet_.page.to_world(at), tick.label);
    }
    const Point middle = geom::midpoint(edge.page_from, edge.page_to);
    const TextSize size = measure_(title, {options_.text_size, Weight::Regular});
    names.add(sheet_.page.to_world(beside(middle, size, tick_length + 2.5 * tick_gap + widest)), title);
  }

  /// Where the axes begin that say directions: in a corner that the picture leaves free, else in the lower left one if
  /// the plot is large. A view that is on its way keeps them there.
  [[nodiscard]] std::optional<Point> corner() const {
    const geom::Box& plot = sheet_.plot;
    const geom::Box around{{plot.low.x + corner_room, plot.low.y + corner_room},
                           {plot.high.x - corner_room, plot.high.y - corner_room}};
    const Point usual{around.low.x, around.high.y};
    const bool large = plot.width() > 8.0 * corner_room && plot.height() > 6.0 * corner_room;
    const bool small = plot.width() < 3.0 * corner_room || plot.height() < 3.0 * corner_room;
    if (small || look_.view) return small ? std::nullopt : std::optional(usual);
    const geom::Box seen = projected(frame_, shown_);
    geom::Box taken;
    taken.add(sheet_.page.to_page(seen.low));
    taken.add(sheet_.page.to_page(seen.high));
    for (const Point at : {usual, around.low, Point{around.high.x, around.low.y}, around.high}) {
      if (!geom::Box{at, at}.grown(corner_room).overlaps(taken.grown(14.0))) return at;
    }
    return large ? std::optional(usual) : std::nullopt;
  }

  /// Where the axes point, in a corner.
  void add_corner(Panel& panel, std::vector<Mark>& lines) const {
    const std::optional<Point> from = corner();
    if (!from) return;
    Camera parallel = look_.camera;
    if (parallel.projection == Projection::Perspective) parallel.projection = Projection::Parallel;
    parallel.target = Point3{};
    const Frame frame = frame_of(parallel, geom::Box3{{0, 0, 0}, {1, 1, 1}}, 1.0);
    const std::array<Vector3, 3> axes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    const std::array<const std::string*, 3> titles{&picture_.axes.x_title, &picture_.axes.y_title,
                                                   &picture_.axes.z_title};
    for (std::size_t i = 0; i < 3; ++i) {
      const Column4 seen = frame.matrix * column(axes[i]);
      const Vector by{seen[0], -seen[1]};
      const double length = geom::length(by);
      if (length < least_corner_axis) continue;
      const Point to = *from + corner_axis * by;
      lines.emplace_back(LineMark{*from, to, axis_colors[i], 1.5, Dash::Solid});
      LabelLayer name(axis_colors[i], options_.text_size - 1.0);
      const std::string text = titles[i]->substr(0, titles[i]->find(" ["));
      if (text.size() <= 3) name.add(sheet_.page.to_world(to + (8.0 / length) * by), text);
      panel.layers.push_back(name.take());
    }
  }

  const SpacePicture& picture_;
  const geom::Box3& shown_;
  const Look& look_;
  const TextMeasure& measure_;
  LayoutOptions options_;
  Picture plane_;
  Frame frame_;
  Sheet sheet_;
};

}  // namespace

SpaceLayout layout(const SpacePicture& picture, const geom::Box3& shown, const Look& look, const PageSize& page,
                   const TextMeasure& measure, const LayoutOptions& options) {
  return Maker(picture, shown, look, measure, options).make(page);
}

PageSize suggested_page(const SpacePicture& picture, const geom::Box3& shown, const Look& look,
                        const TextMeasure& measure) {
  Maker maker(picture, shown, look, measure, {});
  const double width = usual_width(maker.plane());
  maker.make_room({width, 1.2 * width});
  return scene::suggested_page(maker.plane(), width, measure);
}

}  // namespace dobra::scene::space
