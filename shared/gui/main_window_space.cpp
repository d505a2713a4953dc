// The window and its view in space: beside the plane where the program has something there, picking linked both ways.
#include <QAction>
#include <QApplication>
#include <QSplitter>
#include <tuple>

#include "shared/gui/canvas.h"
#include "shared/gui/labels/status_line.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"
#include "shared/render/space_file.h"

namespace dobra::gui {

void MainWindow::make_space_view() {
  space_ = new stage::SpaceWidget(views_);
  space_->hide();
  space_->set_canvas(theme::canvas_of(kept_canvas(), QApplication::palette()));
  space_->set_draggable(part_.space.draggable);
  views_->setChildrenCollapsible(false);
  connect(space_, &stage::SpaceWidget::cursor_moved, this,
          [this](const QString& where) { status_->show_place(where); });
  connect(space_, &stage::SpaceWidget::clicked, this, [this](const std::optional<scene::space::SpacePick>& pick) {
    view_->mark(pick ? std::optional(pick->pick) : std::nullopt);
    canvas_->say(pick ? space_->words_of(*pick) : text("Nothing here."));
    if (pick) point_at({pick->pick, pick->place, pick->chart});
  });
  connect(space_, &stage::SpaceWidget::dragged, this,
          [this](stage::MarkerDrag phase, const scene::space::SpacePick& marker, const geom::Point3& to) {
            if (part_.space.dragged)
              part_.space.dragged({session_, *canvas_}, phase, {marker.pick, marker.place, marker.chart}, to);
          });
  connect(view_, &VtkWidget::picked_item, this,
          [this](std::size_t panel, const std::optional<scene::Pick>& pick, geom::Point at) {
            if (!has_space()) return;
            view_->mark(pick);
            space_->mark(pick);
            if (pick) point_at({*pick, std::nullopt, at, view_->panel_key(panel)});
          });
}

void MainWindow::point_at(const stage::ItemAt& item) {
  if (part_.space.clicked) part_.space.clicked({session_, *canvas_}, item);
}

bool MainWindow::has_space() const { return session_.outcome() != nullptr && session_.outcome()->space != nullptr; }

std::optional<scene::space::SpacePicture> MainWindow::space_shown(scene::Picture& listed) const {
  if (!has_space()) return std::nullopt;
  scene::space::SpacePicture picture = *session_.outcome()->space;
  picture.layers = scene::space::unrolled(picture);
  scene::Picture described = layers_->chosen(scene::space::described(picture));
  scene::Panel& panel = described.panels.front();
  panel.title = text("In space").toStdString();
  for (scene::space::Layer& layer : picture.layers) {
    for (const scene::Layer& known : panel.layers) {
      if (known.key == scene::space::known_key(layer.key)) layer.visible = known.visible;
    }
  }
  listed.panels.push_back(std::move(panel));
  return picture;
}

void MainWindow::show_space(const std::optional<scene::space::SpacePicture>& picture) {
  const bool is_new = space_->picture().layers.empty() || fit_next_;
  if (picture)
    space_->set_picture(*picture,
                        is_new ? stage::SpaceWidget::Looking::AtAll : stage::SpaceWidget::Looking::WhereItDid);
  else if (!space_->picture().layers.empty())
    space_->set_picture({}, stage::SpaceWidget::Looking::AtAll);
  view_->mark(std::nullopt);  // numbers of items are those of one picture
  space_->mark(std::nullopt);
  show_views();
}

void MainWindow::show_views() {
  const bool space = has_space() && looked_at_ != Views::Plane;
  const bool before = !space_->isHidden();
  space_->setVisible(space);
  const bool plane = !has_space() || session_.outcome()->picture != nullptr;
  view_->setVisible(!space || (plane && looked_at_ == Views::Both));
  if (space && !before && looked_at_ == Views::Both) {
    const int half = std::max(views_->width() / 2, 1);
    views_->setSizes({half, half});
  }
  actions_.refresh();
}

void MainWindow::add_space_actions() {
  using scene::space::StandardView;
  const std::string menu = "&View/View in &space";
  for (const auto& [name, words, views] :
       {std::tuple{"both", "Beside the plane", Views::Both}, std::tuple{"plane", "The plane alone", Views::Plane},
        std::tuple{"alone", "Space alone", Views::Space}}) {
    actions_.add({.id = std::string("view.space.") + name,
                  .text = words,
                  .menu = menu,
                  .section = "where",
                  .run =
                      [this, views = views] {
                        looked_at_ = views;
                        show_views();
                      },
                  .enabled = [this] { return has_space(); },
                  .checked = [this, views = views] { return looked_at_ == views; },
                  .choice = "view.space"});
  }
  int key = Qt::Key_1;
  for (const auto& [name, words, view] : {std::tuple{"front", "From the &front", StandardView::Front},
                                          std::tuple{"top", "From the &top", StandardView::Top},
                                          std::tuple{"right", "From the &right", StandardView::Right},
                                          std::tuple{"isometric", "&Isometric", StandardView::Isometric},
                                          std::tuple{"dimetric", "&Dimetric", StandardView::Dimetric},
                                          std::tuple{"cavalier", "&Cavalier", StandardView::Cavalier},
                                          std::tuple{"cabinet", "Ca&binet", StandardView::Cabinet},
                                          std::tuple{"perspective", "&Perspective", StandardView::Perspective}}) {
    actions_.add({.id = std::string("view.space.") + name,
                  .text = words,
                  .menu = menu,
                  .section = "side",
                  .keys = {QKeySequence(key++)},
                  .run = [this, view = view] { space_->look_from(view); },
                  .enabled = [this] { return has_space(); },
                  .scope = space_});
  }
  actions_.add({.id = "view.space.fit",
                .text = "Fit the view in space",
                .menu = menu,
                .section = "side",
                .run = [this] { space_->fit(); },
                .enabled = [this] { return has_space(); }});
  actions_.add({.id = "view.space.save",
                .text = "&Save the picture in space...",
                .menu = menu,
                .section = "save",
                .run = [this] { ask_save_space_picture(); },
                .enabled = [this] { return has_space(); }});
}

base::Result<void> MainWindow::save_space_picture(const std::filesystem::path& file) {
  if (!has_space())
    return base::Error{base::ErrorCode::CannotDraw,
                       text("there is no picture in space; run a scenario that has one").toStdString()};
  scene::space::SpacePicture picture = space_->picture();
  picture.vertical_exaggeration *= look_.exaggeration.value_or(1.0);
  render::SpaceFileOptions options;
  options.camera = space_->look().camera;
  return render::write_picture(picture, file, options);
}

}  // namespace dobra::gui
