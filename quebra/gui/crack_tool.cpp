#include "quebra/gui/crack_tool.h"

#include <fmt/format.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "quebra/core/drawing.h"
#include "quebra/core/drawn_chart.h"
#include "quebra/core/surface_edits.h"
#include "quebra/gui/surfaces_shown.h"
#include "quebra/model/model.h"
#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/gui/messages.h"
#include "shared/gui/session.h"
#include "shared/gui/text.h"
#include "shared/scenario/entries.h"

namespace quebra::gui {

namespace {

namespace canvas = dobra::canvas;
namespace geom = dobra::geom;
namespace scenario = dobra::scenario;
using dobra::base::translated;
using geom::Point;

/// A place of a curve.
struct OnCurve {
  std::size_t curve = 0;
  double s = 0.0;
  Point at;               ///< As the picture has it.
  geom::Vector along;     ///< Unit tangent.
  double distance = 0.0;  ///< On the page, of the picture's metres along x.
};

class CrackTool final : public canvas::Tool {
 public:
  explicit CrackTool(const dobra::gui::Desk& desk) : session_(desk.session) {}

  [[nodiscard]] std::string hint() const override {
    if (points_.empty()) return translated("Click where the crack begins; near the border it begins on the border");
    return translated("Click the next point, or type @d<angle; Enter ends the crack, Backspace takes a point back");
  }

  void press(canvas::Workspace& work, const canvas::Pointer& pointer) override {
    const Place place = place_of(pointer);
    if (!points_.empty() && points_.back() == place.at) return;
    if (points_.empty()) {
      border_ = place.border;
      panel_ = work.empty() ? std::string() : work.panel().key;
      snapped_.clear();
    }
    points_.push_back(place.at);
    snapped_.push_back(pointer.snap.has_value());
    cursor_ = place.at;
  }
  void move(canvas::Workspace&, const canvas::Pointer& pointer) override { cursor_ = place_of(pointer).at; }
  void double_click(canvas::Workspace& work, const canvas::Pointer& pointer) override {
    if (points_.empty()) return;
    press(work, pointer);
    end();
  }
  bool key(canvas::Workspace&, canvas::Key key) override {
    if (points_.empty()) {
      if (key == canvas::Key::Escape) say(canvas::PutAway{});
      return key == canvas::Key::Escape;
    }
    if (key == canvas::Key::Enter) end();
    if (key == canvas::Key::Escape) points_.clear();
    if (key == canvas::Key::Backspace) {
      points_.pop_back();
      snapped_.pop_back();
    }
    return true;
  }
  void put_down(canvas::Workspace&) override {
    if (points_.size() > 1) end();
    points_.clear();
  }
  [[nodiscard]] std::optional<Point> last() const override {
    return points_.empty() ? std::nullopt : std::optional(points_.back());
  }

  [[nodiscard]] canvas::Overlay overlay(const canvas::Workspace& work) const override {
    canvas::Overlay overlay;
    if (points_.empty()) {
      canvas::show_selection(work, overlay);
      return overlay;
    }
    geom::Polyline way{points_, false};
    if (way.points.back() != cursor_) way.points.push_back(cursor_);
    overlay.handles = way.points;
    if (way.points.size() < 2) return overlay;
    std::string told =
        fmt::format(fmt::runtime(translated("{:.6g} {} long")), geom::length(way) / work.unit.size, work.unit.name);
    if (border_) {
      told += '\n' + fmt::format(fmt::runtime(translated("{:.1f}° to the border")),
                                 angle_between(way.points[1] - way.points[0], border_->along));
    }
    overlay.texts = {{way.points.back(), canvas::with_decimal_mark(told)}};
    overlay.lines = {std::move(way)};
    return overlay;
  }

 private:
  struct Place {
    Point at;
    std::optional<OnCurve> border;
  };

  /// Degrees, 0 to 90, between two lines.
  static double angle_between(geom::Vector a, geom::Vector b) {
    return std::atan2(std::abs(cross(a, b)), std::abs(dot(a, b))) * 180.0 / std::numbers::pi;
  }

  /// The border within reach of the cursor wins over other lines; a typed place stays where it is if it is no nearer to
  /// the border than rounding.
  [[nodiscard]] Place place_of(const canvas::Pointer& pointer) const {
    const Point wanted = pointer.place();
    const model::Model* model = input();
    if (model == nullptr) return {wanted, std::nullopt};
    // What the cursor is drawn to already may be a corner, or where another crack ends: it stays, if it is on the
    // border.
    const double near = 1e-6 * model->units.from_si(model->domain.box().diagonal(), "m");
    if (auto there = nearest(*model, wanted, pointer.exaggeration); there && there->distance <= near)
      return {pointer.snap && pointer.snap->kind == canvas::SnapKind::Vertex ? wanted : there->at, there};
    if (pointer.snap && pointer.snap->kind == canvas::SnapKind::Vertex) return {wanted, std::nullopt};
    if (auto there = nearest(*model, pointer.at, pointer.exaggeration); there && there->distance <= pointer.reach)
      return {there->at, there};
    return {wanted, std::nullopt};
  }

  /// Of what bounds the domain.
  static std::optional<OnCurve> nearest(const model::Model& model, Point shown, double exaggeration) {
    const auto page = [&](Point si) {
      const Point p{model.units.from_si(si.x, "m"), model.units.from_si(si.y, "m")};
      return std::hypot(p.x - shown.x, exaggeration * (p.y - shown.y));
    };
    std::optional<OnCurve> found;
    for (std::size_t c = 0; c < model.domain.curves.size(); ++c) {
      const sketch::Curve& curve = model.domain.curves[c];
      if (!sketch::bounds(curve)) continue;
      const double s = nearest_distance(curve, page);
      const Point at = sketch::point(curve, s);
      if (found && page(at) >= found->distance) continue;
      found = OnCurve{c,
                      s,
                      {model.units.from_si(at.x, "m"), model.units.from_si(at.y, "m")},
                      sketch::direction(curve, s),
                      page(at)};
    }
    return found;
  }

  /// Where along a curve it is nearest, by its trace and then between the neighbours of the nearest chord.
  template <class Page>
  static double nearest_distance(const sketch::Curve& curve, const Page& page) {
    const sketch::Trace trace = sketch::trace(curve);
    double low = 0.0;
    double high = 0.0;
    double least = std::numeric_limits<double>::infinity();
    constexpr int cuts = 8;
    for (std::size_t i = 0; i + 1 < trace.s.size(); ++i) {
      for (int k = 0; k <= cuts; ++k) {
        const double s = trace.s[i] + (trace.s[i + 1] - trace.s[i]) * k / cuts;
        const double here = page(sketch::point(curve, s));
        if (!(here < least)) continue;
        least = here;
        const double step = (trace.s[i + 1] - trace.s[i]) / cuts;
        low = std::max(trace.s[i], s - step);
        high = std::min(trace.s[i + 1], s + step);
      }
    }
    constexpr int halvings = 100;
    for (int i = 0; i < halvings; ++i) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      if (page(sketch::point(curve, a)) <= page(sketch::point(curve, b)))
        high = b;
      else
        low = a;
    }
    return 0.5 * (low + high);
  }

  /// What the input of the document is, where a run has read it.
  [[nodiscard]] const model::Model* input() const {
    const dobra::gui::documents::OutcomePtr& outcome = session_.outcome();
    if (!outcome || outcome->run.states.empty()) return nullptr;
    return &scenario::model_of<model::Model>(outcome->run.states.front());
  }

  [[nodiscard]] bool is_taken(const std::string& name) const {
    for (const char* key : {"curve", "crack", "trim"}) {
      scenario::Entries entries = scenario::entries_of(session_.document().input, key);
      if (scenario::entry_named(entries, name) != entries.end()) return true;
    }
    const model::Model* model = input();
    return model != nullptr && std::any_of(model->domain.curves.begin(), model->domain.curves.end(),
                                           [&](const sketch::Curve& curve) { return curve.name == name; });
  }

  /// A trim of the surface whose chart it was drawn in.
  [[nodiscard]] dobra::base::Result<scenario::Document> on_surface(const model::Model& model, std::size_t face,
                                                                   const std::string& name) const {
    const core::DrawnChart chart(model.surfaces->faces[face].surface);
    std::vector<core::ChartPoint> line;
    for (std::size_t i = 0; i < points_.size(); ++i)
      line.push_back(
          {chart.chart({model.units.to_si(points_[i].x, "m"), model.units.to_si(points_[i].y, "m")}), snapped_[i]});
    return core::with_crack_on(session_.document(), *model.surfaces, face, name, line);
  }

  void end() {
    if (points_.size() < 2) {
      say(canvas::Told{translated("A crack has two points or more")});
      return;
    }
    std::string name = "crack";
    for (int i = 2; is_taken(name); ++i) name = fmt::format("crack_{}", i);
    const auto face = core::face_of_chart(panel_);
    const model::Model* model = face ? model_with_surfaces(session_) : nullptr;
    auto document = model != nullptr && *face < model->surfaces->faces.size()
                        ? on_surface(*model, *face, name)
                        : core::with_curve(session_.document(), "crack", name, {points_, false});
    points_.clear();
    if (!document) {
      say(canvas::Told{dobra::gui::in_words(document.error()).toStdString()});
      return;
    }
    session_.edit(*std::move(document), dobra::gui::text("Draw '%1'").arg(QString::fromStdString(name)));
  }

  dobra::gui::Session& session_;
  std::vector<Point> points_;
  std::vector<bool> snapped_;      ///< One a point: it was drawn to something.
  std::string panel_;              ///< Where the first one was clicked.
  std::optional<OnCurve> border_;  ///< On which the first point stands.
  Point cursor_;
};

}  // namespace

std::unique_ptr<canvas::Tool> make_crack_tool(const dobra::gui::Desk& desk) {
  return std::make_unique<CrackTool>(desk);
}

void draw_crack(QPainter& painter) {
  painter.drawLine(QPointF(4, 3), QPointF(4, 21));
  painter.drawPolyline(QPolygonF({{4, 9}, {9, 12}, {12, 10}, {16, 14}, {21, 12}}));
  painter.drawPolyline(QPolygonF({{4, 15}, {9, 13.5}, {12, 12}}));
}

}  // namespace quebra::gui
