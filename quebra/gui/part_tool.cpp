#include "quebra/gui/part_tool.h"

#include <QPainter>
#include <QPolygonF>

#include "quebra/core/surface_edits.h"
#include "quebra/core/surface_marks.h"
#include "quebra/gui/surfaces_shown.h"
#include "quebra/model/model.h"
#include "shared/base/text.h"
#include "shared/gui/canvas.h"
#include "shared/gui/messages.h"
#include "shared/gui/text.h"

namespace quebra::gui {

namespace {

namespace canvas = dobra::canvas;
namespace geom = dobra::geom;
using dobra::base::translated;
using dobra::gui::text;

/// @return what is wrong; empty: the document has been edited.
QString turn_part(dobra::gui::Session& session, const model::SurfaceSet& set, std::size_t face, geom::Point uv) {
  auto edited = core::with_part_turned(session.document(), set, face, uv);
  if (!edited) return dobra::gui::in_words(edited.error());
  const QString name = QString::fromStdString(set.faces[face].name);
  session.edit(std::move(edited->document), edited->taken_in ? text("Take in a part of '%1'").arg(name)
                                                             : text("Leave out a part of '%1'").arg(name));
  return {};
}

class PartTool : public canvas::Tool {
 public:
  explicit PartTool(dobra::gui::Session& session) : session_(session) {}

  [[nodiscard]] std::string hint() const override {
    return translated("Click a part of a surface, in its chart or in space, to leave it out or to take it in again");
  }
  [[nodiscard]] bool snaps() const override { return false; }

  void press(canvas::Workspace& work, const canvas::Pointer& pointer) override {
    const auto place = place_of(work, pointer.at);
    if (!place) return say(canvas::Told{translated("There are no surfaces here")});
    if (const QString wrong = turn_part(session_, *place->set, place->face, place->uv); !wrong.isEmpty())
      say(canvas::Told{wrong.toStdString()});
  }
  void move(canvas::Workspace& work, const canvas::Pointer& pointer) override {
    outline_.clear();
    const auto place = place_of(work, pointer.at);
    if (!place || place->face >= place->set->parts.size() || !place->set->parts[place->face].recognised) return;
    const auto& recognised = *place->set->parts[place->face].recognised;
    const auto part = recognised.pick(place->uv);
    if (!part) return;
    const core::DrawnChart chart(place->set->faces[place->face].surface);
    outline_ = core::region_of(recognised.faces()[*part].loops, chart).contours;
    for (geom::Polyline& contour : outline_) {
      for (geom::Point& p : contour.points)
        p = {place->model->units.from_si(p.x, "m"), place->model->units.from_si(p.y, "m")};
    }
  }
  bool key(canvas::Workspace&, canvas::Key key) override {
    if (key == canvas::Key::Escape) say(canvas::PutAway{});
    return key == canvas::Key::Escape;
  }
  [[nodiscard]] canvas::Overlay overlay(const canvas::Workspace&) const override {
    canvas::Overlay overlay;
    overlay.lines = outline_;
    return overlay;
  }

 private:
  struct Place {
    const model::Model* model;
    const model::SurfaceSet* set;
    std::size_t face;
    geom::Point uv;
  };
  /// In the chart that a panel shows.
  [[nodiscard]] std::optional<Place> place_of(const canvas::Workspace& work, geom::Point at) const {
    const model::Model* model = model_with_surfaces(session_);
    if (model == nullptr || work.empty()) return std::nullopt;
    const auto face = core::face_of_chart(work.panel().key);
    if (!face || *face >= model->surfaces->faces.size()) return std::nullopt;
    const core::DrawnChart chart(model->surfaces->faces[*face].surface);
    const geom::Point uv = chart.chart({model->units.to_si(at.x, "m"), model->units.to_si(at.y, "m")});
    return Place{model, model->surfaces.get(), *face, uv};
  }

  dobra::gui::Session& session_;
  std::vector<geom::Polyline> outline_;  ///< Of the part under the cursor.
};

/// The face that an item of the picture in space is of.
std::optional<std::size_t> face_of(const model::Model& model, const dobra::scene::Pick& pick) {
  const model::SurfaceSet& set = *model.surfaces;
  if (pick.layer == core::faces_layer) return pick.id;
  if (pick.layer == "mesh" && !model.surface_meshes.empty()) {
    const auto& faces = model.surface_meshes.back()->mesh.faces;
    return pick.id < faces.size() ? std::optional<std::size_t>(faces[pick.id]) : std::nullopt;
  }
  if (pick.layer != core::left_out_layer) return std::nullopt;
  std::size_t before = 0;
  for (std::size_t f = 0; f < set.parts.size(); ++f) {
    before += set.parts[f].left_out.size();
    if (pick.id < before) return f;
  }
  return std::nullopt;
}

}  // namespace

const model::Model* model_with_surfaces(const dobra::gui::Session& session) {
  const dobra::gui::documents::OutcomePtr& outcome = session.outcome();
  if (!outcome || outcome->run.states.empty()) return nullptr;
  const auto& model = dobra::scenario::model_of<model::Model>(outcome->run.states.back());
  return model.surfaces ? &model : nullptr;
}

std::unique_ptr<canvas::Tool> make_part_tool(const dobra::gui::Desk& desk) {
  return std::make_unique<PartTool>(desk.session);
}

void choose_part(const dobra::gui::Desk& desk, const dobra::gui::stage::ItemAt& item) {
  if (!item.panel.empty() || dynamic_cast<PartTool*>(&desk.canvas.tool()) == nullptr) return;
  const model::Model* model = model_with_surfaces(desk.session);
  if (model == nullptr) return;
  const auto face = face_of(*model, item.pick);
  if (!face || !item.chart || *face >= model->surfaces->faces.size())
    return desk.canvas.say(text("click inside a part, away from the lines that bound it"));
  if (const QString wrong = turn_part(desk.session, *model->surfaces, *face, *item.chart); !wrong.isEmpty())
    desk.canvas.say(wrong);
}

void draw_part(QPainter& painter) {
  painter.drawRect(QRectF(3, 5, 18, 14));
  const QPolygonF part({{3, 5}, {12, 5}, {9, 19}, {3, 19}});
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(part);
}

}  // namespace quebra::gui
