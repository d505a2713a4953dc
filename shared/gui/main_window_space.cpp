// The window and its view in space: beside the plane where the program has something there, picking linked both ways.
#include <QAction>
#include <QApplication>
#include <QPainter>
#include <QPolygonF>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>
#include <tuple>

#include "shared/gui/canvas.h"
#include "shared/gui/labels/status_line.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/stage/section_bar.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"
#include "shared/render/space_file.h"

namespace dobra::gui {

namespace {

constexpr double wide_enough = 1.4;  ///< For two pictures side by side, by the height.
const scene::Color plain_fill{0xd7, 0xe3, 0xea};

/// Three triangles of one surface, one of them filled.
void draw_colors(QPainter& painter) {
  painter.drawPolygon(QPolygonF({{3, 19}, {12, 4}, {21, 19}}));
  painter.drawLine(QPointF(7.5, 11.5), QPointF(12, 19));
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(QPolygonF({{12, 19}, {16.5, 11.5}, {21, 19}}));
}

/// A block and the plane that cuts it.
void draw_section(QPainter& painter) {
  painter.drawPolyline(QPolygonF({{12, 6}, {4, 6}, {4, 18}, {12, 18}}));
  painter.drawPolygon(QPolygonF({{12, 3}, {19, 7}, {19, 21}, {12, 17}}));
}

}  // namespace

void MainWindow::make_space_view() {
  space_side_ = new QWidget(views_);
  space_side_->hide();
  auto* column = new QVBoxLayout(space_side_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  space_bar_ = new QToolBar(text("View in space"), space_side_);
  space_bar_->setObjectName("space_bar");
  space_bar_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  space_ = new stage::SpaceWidget(space_side_);
  space_->set_caps([this](const scene::space::CutPlane& plane) {
    auto made = section_by(plane);
    return made ? std::move(made->caps) : std::vector<scene::space::Layer>();
  });
  section_ = new stage::SectionBar(space_side_);
  section_->hide();
  column->addWidget(space_bar_);
  column->addWidget(space_, 1);
  column->addWidget(section_);
  connect(section_, &stage::SectionBar::moved, this, [this](const scene::space::Section& section) {
    space_->set_section(section);
    show_moved_section();
  });
  connect(section_, &stage::SectionBar::refused, this, [this](const QString& why) { canvas_->say(why); });
  connect(space_, &stage::SpaceWidget::section_dragged, this, [this](const scene::space::Section& section) {
    section_->show_section(section);
    show_moved_section();
  });
  space_->set_canvas(theme::canvas_of(kept_canvas(), QApplication::palette()));
  space_->set_draggable(part_.space.draggable);
  views_->setChildrenCollapsible(false);
  connect(space_, &stage::SpaceWidget::cursor_moved, this,
          [this](const QString& where) { status_->show_place(where); });
  connect(space_, &stage::SpaceWidget::clicked, this, [this](const std::optional<scene::space::SpacePick>& pick) {
    if (pick) ask_for_panel({pick->pick, pick->place, pick->chart});
    space_->mark(pick ? std::optional(pick->pick) : std::nullopt);
    view_->mark(pick ? std::optional(pick->pick) : std::nullopt);
    canvas_->say(pick ? space_->words_of(*pick) : text("Nothing here."));
    if (pick) point_at({pick->pick, pick->place, pick->chart});
  });
  connect(space_, &stage::SpaceWidget::dragged, this,
          [this](stage::MarkerDrag phase, const scene::space::SpacePick& marker, const geom::Point3& to) {
            if (phase == stage::MarkerDrag::Begins) view_->hold();
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

void MainWindow::ask_for_panel(const stage::ItemAt& item) {
  if (!part_.space.panel_of || !session_.outcome()->picture) return;
  const std::string key = part_.space.panel_of({session_, *canvas_}, item);
  const auto& panels = session_.outcome()->picture->panels;
  const bool there = std::any_of(panels.begin(), panels.end(), [&](const auto& panel) { return panel.key == key; });
  // One that stands in the place of another goes when that is asked for.
  if (key.empty() || key == asked_panel_ || (there && (asked_panel_.empty() || key != panels.back().key))) return;
  asked_panel_ = there ? std::string() : key;
  show_picture();
}

void MainWindow::add_asked_panel(scene::Picture& picture) {
  if (asked_panel_.empty() || !part_.space.panel || picture.panels.empty()) return;
  auto asked = part_.space.panel({session_, *canvas_}, asked_panel_);
  if (asked) picture.panels.back() = *std::move(asked);
}

std::optional<SectionMade> MainWindow::section_by(const scene::space::CutPlane& plane) {
  if (!part_.space.section || !has_space()) return std::nullopt;
  return part_.space.section({session_, *canvas_}, plane);
}

void MainWindow::add_section_panel(scene::Picture& picture) {
  if (!space_->section() || !has_space()) return;
  const auto made = section_by(space_->section_plane());
  if (made) picture.panels.push_back(made->panel);
  picture.arrangement = scene::Arrangement::Grid;
}

/// What stands in space is cut already; the section in the plane follows.
void MainWindow::show_moved_section() {
  if (!part_.space.section || !session_.outcome()) return;
  const scene::Picture picture = picture_wanted();
  // Whether the plane meets anything decides on what is listed.
  if (picture.panels.size() != view_->panel_count() || picture.panels.empty() != !has_plane_) return show_picture();
  if (has_plane_) show_plane(picture);
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
  if (colored_) return picture;
  for (scene::space::Layer& layer : picture.layers) {
    auto* surface = std::get_if<scene::space::Surface>(&layer.content);
    if (surface == nullptr || surface->values_at == scene::ValuesAt::None) continue;
    surface->values_at = scene::ValuesAt::None;
    surface->values = {};
    layer.style.fill = plain_fill;
  }
  return picture;
}

void MainWindow::show_space(const std::optional<scene::space::SpacePicture>& picture) {
  const bool is_new = space_->picture().layers.empty() || fit_next_;
  if (picture)
    space_->set_picture(*picture,
                        is_new ? stage::SpaceWidget::Looking::AtAll : stage::SpaceWidget::Looking::WhereItDid);
  else if (!space_->picture().layers.empty())
    space_->set_picture({}, stage::SpaceWidget::Looking::AtAll);
  section_->show_axes(space_->picture().axes, scene::space::extent(space_->picture()));
  view_->mark(std::nullopt);  // numbers of items are those of one picture
  space_->mark(std::nullopt);
  show_views();
}

void MainWindow::show_views() {
  const bool space = has_space() && looked_at_ != Views::Plane;
  const bool before = !space_side_->isHidden();
  space_side_->setVisible(space);
  const bool plane = !has_space() || has_plane_;
  view_->setVisible(!space || (plane && looked_at_ == Views::Both));
  arrange_views();
  if (space && !before && looked_at_ == Views::Both) {
    const int all = std::max({views_->width(), views_->height(), 1});
    const bool beside = views_->orientation() == Qt::Horizontal;
    views_->setSizes({beside ? all / 2 : 2 * all / 5, beside ? all / 2 : 3 * all / 5});
  }
  actions_.refresh();
}

/// Side by side where that leaves both room enough, else one above the other.
void MainWindow::arrange_views() {
  if (views_ == nullptr || !views_->isVisible()) return;
  const bool wide = views_->width() >= wide_enough * views_->height();
  views_->setOrientation(wide ? Qt::Horizontal : Qt::Vertical);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  arrange_views();
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
  add_space_switches();
  actions_.add({.id = "view.space.save",
                .text = "&Save the picture in space...",
                .menu = menu,
                .section = "save",
                .run = [this] { ask_save_space_picture(); },
                .enabled = [this] { return has_space(); }});
}

void MainWindow::without_colors(scene::Picture& plane) const {
  if (colored_ || !has_space()) return;
  for (scene::Panel& panel : plane.panels) {
    for (scene::Layer& layer : panel.layers) {
      auto* mesh = std::get_if<scene::Mesh>(&layer.content);
      if (mesh == nullptr || mesh->values_at == scene::ValuesAt::None) continue;
      mesh->values_at = scene::ValuesAt::None;
      mesh->values = {};
      layer.style.fill = plain_fill;
    }
  }
}

std::vector<LayerTree::Listed> MainWindow::layers_in_space(const std::vector<std::string>& keys) const {
  std::vector<LayerTree::Listed> listed = layers_->listed();
  std::erase_if(listed, [&](const LayerTree::Listed& layer) {
    return std::none_of(keys.begin(), keys.end(), [&](const std::string& key) {
      return layer.key == std::string(scene::space::panel_key) + "/" + key;
    });
  });
  return listed;
}

bool MainWindow::shows_layers(const std::vector<std::string>& keys) const {
  const auto listed = layers_in_space(keys);
  return std::any_of(listed.begin(), listed.end(), [](const LayerTree::Listed& layer) { return layer.visible; });
}

void MainWindow::show_section(bool on) {
  section_->setVisible(on);
  space_->set_section(on ? std::optional(section_->section()) : std::nullopt);
  if (part_.space.section && session_.outcome()) {
    fit_next_ = true;  // what stands beside is another picture
    show_picture();
    fit_next_ = false;
  }
  canvas_->say(on ? text("Drag the arrow to move the section plane, its rim to turn it; Escape takes a drag back.")
                  : QString());
}

void MainWindow::add_space_switches() {
  const auto add = [this](
                       const std::string& name, const std::string& words, const std::string& help, theme::Draw icon,
                       std::function<void()> run, std::function<bool()> is_on,
                       std::function<bool()> can = [] { return true; }) {
    actions_.add({.id = "view.space." + name,
                  .text = words,
                  .help = help,
                  .menu = "&View/View in &space",
                  .section = "switches",
                  .bar = "space_bar",
                  .icon = icon,
                  .run = std::move(run),
                  .enabled = [this, can = std::move(can)] { return has_space() && can(); },
                  .checked = std::move(is_on)});
  };
  add(
      "colors", "Colours", "Surfaces have the colours of their values; the legend says which", draw_colors,
      [this] {
        colored_ = !colored_;
        show_picture();
      },
      [this] { return colored_; });
  for (const LayerSwitch& each : part_.space.switches) {
    add(
        "show." + each.name, each.text, each.help, each.icon,
        [this, layers = each.layers, instead = each.instead] {
          const bool on = !shows_layers(layers);
          for (const std::string& layer : layers) layers_->set_layer_visible(layer, on);
          for (const std::string& layer : instead) layers_->set_layer_visible(layer, !on);
        },
        [this, layers = each.layers] { return shows_layers(layers); },
        [this, layers = each.layers] { return !layers_in_space(layers).empty(); });
  }
  add(
      "section", "Section", "A plane cuts the picture, to look inside; what is before it is not shown", draw_section,
      [this] { show_section(!space_->section()); }, [this] { return space_->section().has_value(); });
  actions_.fill(*space_bar_, "space_bar");
}

base::Result<void> MainWindow::save_space_picture(const std::filesystem::path& file) {
  if (!has_space())
    return base::Error{base::ErrorCode::CannotDraw,
                       text("there is no picture in space; run a scenario that has one").toStdString()};
  scene::space::SpacePicture picture = space_->shown();
  picture.vertical_exaggeration *= look_.exaggeration.value_or(1.0);
  render::SpaceFileOptions options;
  options.camera = space_->look().camera;
  return render::write_picture(picture, file, options);
}

}  // namespace dobra::gui
