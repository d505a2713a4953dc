#include "shared/gui/vtk_widget.h"

#include <algorithm>
#include <cmath>

#include "shared/base/check.h"
#include "shared/gui/text.h"
#include "shared/render/vtk_scene.h"

namespace dobra::gui {

namespace {

constexpr double place_fraction = 0.1;   ///< Of the model that is seen round a place.
constexpr double least_fraction = 1e-9;  ///< Nearest and farthest zoom: size of a pixel over that of the model.
constexpr double most_fraction = 1.0;
const scene::Color marker_color{0xd0, 0x10, 0x10};

/// The panel with its extent fixed to that of all its layers: hiding one does not move the others.
void fix_extent(scene::Panel& panel) {
  if (panel.extent) return;
  geom::Box box;
  for (const scene::Layer& layer : panel.layers) box.add(scene::extent(layer));
  if (!box.empty()) panel.extent = scene::comfortable(box);
}

scene::Layer marker_layer(const std::string& key, geom::Point at, const scene::Color& color, double size) {
  scene::Layer layer;
  layer.key = key;
  layer.style.line = color;
  layer.style.marker_size = size;
  layer.content = scene::Markers{{at}, {}};
  layer.in_legend = scene::InLegend::No;
  return layer;
}

geom::Point page_point(QPointF pixel) { return {pixel.x(), pixel.y()}; }

}  // namespace

VtkWidget::VtkWidget(QWidget* parent) : stage::VtkFrames(parent) {
  setMouseTracking(true);
  setAccessibleName(text("Picture"));
  setAccessibleDescription(text("Arrow keys pan, + and - zoom, Home shows all; with Space held the left button pans."));
  setMinimumSize(320, 240);
  setCursor(Qt::CrossCursor);
  clock_.start();
}

VtkWidget::~VtkWidget() { shut(); }

std::unique_ptr<render::VtkStage> VtkWidget::make_stage(vtkRenderWindow& window) {
  auto scene = std::make_unique<render::VtkScene>(window);
  scene_ = scene.get();
  return scene;
}

void VtkWidget::stage_made() {
  scene_->set_ground(colors().ground);
  show_picture();
}

void VtkWidget::stage_goes() { scene_ = nullptr; }

void VtkWidget::set_picture(scene::Picture picture, Looking looking) {
  for (scene::Panel& panel : picture.panels) fix_extent(panel);
  const auto same = [](const scene::Panel& a, const scene::Panel& b) { return a.key == b.key; };
  // What shows all in a panel of another size would cut it off, or leave it small.
  if (held_ &&
      !std::equal(picture.panels.begin(), picture.panels.end(), picture_.panels.begin(), picture_.panels.end(), same)) {
    std::fill(views_.begin(), views_.end(), std::nullopt);
    held_ = false;
  }
  std::vector<std::optional<scene::View>> views(picture.panels.size());
  std::optional<double> scale;
  for (std::size_t i = 0; looking == Looking::WhereItDid && i < views.size(); ++i) {
    for (std::size_t old = 0; old < picture_.panels.size(); ++old) {
      if (picture_.panels[old].key == picture.panels[i].key) views[i] = views_[old];
    }
    if (views[i]) scale = views[i]->world_per_point;
  }
  // A new panel beside one that the user has moved joins its scale.
  for (std::size_t i = 0; scale && i < views.size(); ++i) {
    const std::optional<geom::Box>& extent = picture.panels[i].extent;
    if (!views[i]) views[i] = scene::View{extent ? extent->centre() : geom::Point{}, *scale};
  }
  if (looking == Looking::AtAll) history_.clear();
  held_ = held_ && looking == Looking::WhereItDid;
  picture_ = std::move(picture);
  views_ = std::move(views);
  given_.clear();
  for (const scene::Panel& panel : picture_.panels) given_.push_back({panel.axes, panel.vertical_exaggeration});
  dress();
  show_picture();
}

void VtkWidget::set_canvas(theme::Canvas canvas) {
  canvas_ = canvas;
  if (!scene_) return;
  makeCurrent();
  scene_->set_ground(colors().ground);
  doneCurrent();
  show_marker();
}

void VtkWidget::show_picture() {
  if (!scene_) return;
  const auto begin = frames::Meter::Clock::now();
  give_way();
  makeCurrent();
  hurry();
  {
    const render::VtkScene::Changes changes(*scene_);
    scene_->set_picture(picture_);
    scene_->set_views(views_);
    scene_->set_options(view::with(settings_, scene_->options()));
    relayout();
    mark_places();
  }
  fill_plots();
  doneCurrent();
  meter().add(frames::Part::Actors, frames::Meter::milliseconds_since(begin));
  redraw();
  emit view_changed();
}

bool VtkWidget::dress() {
  bool other = false;
  for (std::size_t i = 0; i < given_.size(); ++i) {
    scene::Panel& panel = picture_.panels[i];
    const scene::Axes axes = view::axes_in(given_[i].axes, settings_.unit);
    const double wanted = settings_.exaggeration.value_or(filling_);
    const double exaggeration = view::shows_lengths(panel) ? given_[i].exaggeration * wanted : given_[i].exaggeration;
    other = other || axes.x_title != panel.axes.x_title || exaggeration != panel.vertical_exaggeration;
    panel.axes = axes;
    panel.vertical_exaggeration = exaggeration;
  }
  return other;
}

void VtkWidget::fill_canvas() {
  if (!scene_) return;
  makeCurrent();
  const bool other = fill_plots();
  doneCurrent();
  if (!other) return;
  redraw();
  emit view_changed();
}

/// Not while a part is looked at: the picture would change its shape under the cursor.
/// @return whether the exaggeration is another now. @pre the context is current
bool VtkWidget::fill_plots() {
  if (settings_.exaggeration) return false;
  const bool whole = std::none_of(views_.begin(), views_.end(), [](const auto& view) { return view.has_value(); });
  if (!whole || scene_->layout().panels.size() != picture_.panels.size()) return false;
  std::vector<geom::Box> plots;
  for (const scene::PanelLayout& panel : scene_->layout().panels) plots.push_back(panel.plot);
  filling_ = view::that_fills(picture_.panels, plots);
  if (!dress()) return false;
  {
    const render::VtkScene::Changes changes(*scene_);
    scene_->set_picture(picture_);
    scene_->set_views(views_);
    mark_places();
  }
  forget_frame();
  emit exaggerated(filling_);
  return true;
}

void VtkWidget::make_alike(scene::Picture& picture) const {
  for (scene::Panel& panel : picture.panels) {
    if (view::shows_lengths(panel)) panel.vertical_exaggeration *= settings_.exaggeration.value_or(filling_);
  }
  if (settings_.panels == view::Panels::Row) picture.arrangement = scene::Arrangement::Row;
  if (settings_.panels == view::Panels::Column) picture.arrangement = scene::Arrangement::Column;
  if (!scene_ || all_is_seen()) return;
  for (std::size_t i = 0; i < std::min(picture.panels.size(), panel_count()); ++i) {
    const scene::PanelLayout& here = scene_->layout().panels[i];
    if (picture.panels[i].key == picture_.panels[i].key) picture.panels[i].extent = here.transform.to_world(here.plot);
  }
}

bool VtkWidget::all_is_seen() const {
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const std::optional<geom::Box>& extent = picture_.panels[i].extent;
    if (!views_[i] || !extent) continue;
    const scene::PanelLayout& panel = scene_->layout().panels[i];
    const geom::Box seen = panel.transform.to_world(panel.plot);
    if (!seen.grown(1e-6 * extent->diagonal()).contains(extent->low)) return false;
    if (!seen.grown(1e-6 * extent->diagonal()).contains(extent->high)) return false;
  }
  return true;
}

void VtkWidget::set_settings(const view::Settings& settings) {
  if (settings == settings_) return;
  const bool fits = scene_ && settings.exaggeration != settings_.exaggeration && all_is_seen();
  settings_ = settings;
  if (fits) std::fill(views_.begin(), views_.end(), std::nullopt);
  dress();
  show_picture();
  if (settings_.exaggeration) emit exaggerated(*settings_.exaggeration);
}

/// On the panel that can show the place, or on the first.
std::size_t VtkWidget::panel_of(geom::Point place) const {
  const auto has_place = [&](const scene::Panel& panel) { return panel.extent && panel.extent->contains(place); };
  const auto found = std::find_if(picture_.panels.begin(), picture_.panels.end(), has_place);
  return found == picture_.panels.end() ? 0 : static_cast<std::size_t>(found - picture_.panels.begin());
}

void VtkWidget::show_marker() {
  if (!scene_) return;
  makeCurrent();
  {
    const render::VtkScene::Changes changes(*scene_);
    mark_places();
  }
  doneCurrent();
  redraw();
  emit view_changed();
}

/// @pre the context is current
void VtkWidget::mark_places() {
  for (std::size_t i = 0; i < picture_.panels.size(); ++i) {
    std::vector<scene::Layer> layers;
    if (marked_) layers = scene::highlight(picture_.panels[i], *marked_);
    if (place_ && i == place_panel_) {
      layers.push_back(marker_layer("gui.place.rim", *place_, marker_color, 18.0));
      layers.push_back(marker_layer("gui.place.ring", *place_, {255, 255, 255}, 12.0));
      layers.push_back(marker_layer("gui.place.point", *place_, marker_color, 5.0));
    }
    scene_->set_overlay(i, layers);
  }
}

void VtkWidget::set_layer_visible(const std::string& panel_key, const std::string& layer_key, bool visible) {
  for (scene::Panel& panel : picture_.panels) {
    if (panel.key != panel_key) continue;
    for (scene::Layer& layer : panel.layers) {
      if (layer.key == layer_key) layer.visible = visible;
    }
  }
  if (!scene_) return;
  makeCurrent();
  scene_->set_layer_visible(panel_key, layer_key, visible);
  doneCurrent();
  forget_frame();
  redraw();
}

void VtkWidget::fit() {
  remember(view::Move::Jump);
  std::fill(views_.begin(), views_.end(), std::nullopt);
  if (!scene_) return;
  makeCurrent();
  scene_->set_views(views_);
  fill_plots();
  doneCurrent();
  redraw();
  emit view_changed();
}

void VtkWidget::zoom(double factor, QPointF at) {
  if (!scene_ || picture_.panels.empty()) return;
  const std::optional<Spot> spot = spot_at(at);
  std::vector<scene::View> views = scene_->views();
  double size = 0.0;
  for (const scene::Panel& panel : picture_.panels) {
    if (panel.extent) size = std::max(size, panel.extent->diagonal());
  }
  const double wanted = views[0].world_per_point / factor;
  if (size > 0.0 && (wanted < least_fraction * size || wanted > most_fraction * size)) return;
  remember(view::Move::Glide);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const bool along = spot && goes_along(i, spot->panel);
    const geom::Point still = along ? views[i].centre + (spot->at - views[spot->panel].centre) : views[i].centre;
    views_[i] = scene::zoom_at(views[i], still, factor);
  }
  move_views();
}

void VtkWidget::pan(QPointF from, QPointF by) {
  const std::optional<Spot> spot = spot_at(from);
  if (!spot) return;
  remember(view::Move::Glide);
  const std::vector<scene::View> views = scene_->views();
  const double exaggeration = picture_.panels[spot->panel].vertical_exaggeration;
  const geom::Vector moved =
      scene::pan(views[spot->panel], {by.x(), by.y()}, exaggeration).centre - views[spot->panel].centre;
  for (std::size_t i = 0; i < views.size(); ++i) {
    views_[i] = views[i];
    if (goes_along(i, spot->panel)) views_[i]->centre = views[i].centre + moved;
  }
  move_views();
}

/// Whether a panel moves where `moved` does: that one itself, and linked ones on the same plane.
bool VtkWidget::goes_along(std::size_t panel, std::size_t moved) const {
  const bool linked = settings_.linked == view::Linked::Yes && view::shows_lengths(picture_.panels[panel]) &&
                      view::shows_lengths(picture_.panels[moved]);
  return panel == moved || linked;
}

void VtkWidget::look_at(std::size_t panel, const geom::Box& box) {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  const geom::Point middle = box.centre();
  if (box.empty() || !std::isfinite(middle.x) || !std::isfinite(middle.y)) return;
  remember(view::Move::Jump);
  const std::vector<scene::View> views = scene_->views();
  const geom::Box& plot = scene_->layout().panels[panel].plot;
  const double exaggeration = picture_.panels[panel].vertical_exaggeration;
  double scale = views[panel].world_per_point;
  if (box.width() > 0.0 || box.height() > 0.0)
    scale = scene::fit(box, plot.width(), plot.height(), exaggeration).world_per_point;
  if (picture_.panels[panel].extent)
    scale = std::max(scale, least_fraction * picture_.panels[panel].extent->diagonal());
  const geom::Vector moved = middle - views[panel].centre;
  for (std::size_t i = 0; i < views.size(); ++i)
    views_[i] = scene::View{goes_along(i, panel) ? views[i].centre + moved : views[i].centre, scale};
  move_views();
}

view::Looks VtkWidget::looks() const {
  view::Looks looks;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    if (views_[i]) looks.emplace(picture_.panels[i].key, *views_[i]);
  }
  return looks;
}

void VtkWidget::remember(view::Move move) {
  held_ = false;
  history_.before(looks(), move, clock_.elapsed());
}

void VtkWidget::go_to(const view::Looks& looks) {
  held_ = false;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const auto at = looks.find(picture_.panels[i].key);
    views_[i] = at == looks.end() ? std::nullopt : std::optional(at->second);
  }
  if (!scene_) return;
  fill_canvas();
  move_views();
}

bool VtkWidget::look_back() {
  const std::optional<view::Looks> then = history_.back(looks());
  if (then) go_to(*then);
  return then.has_value();
}

bool VtkWidget::look_forward() {
  const std::optional<view::Looks> then = history_.forward(looks());
  if (then) go_to(*then);
  return then.has_value();
}

geom::Vector VtkWidget::tick_step(std::size_t panel) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  return scene_->layout().panels[panel].tick_step;
}

void VtkWidget::move_views() {
  makeCurrent();
  hurry();
  hold_if_slow();
  scene_->set_views(views_);
  doneCurrent();
  redraw();
  emit view_changed();
}

void VtkWidget::show_place(geom::Point place) { show_place(panel_of(place), place); }

void VtkWidget::mark_place(std::size_t panel, geom::Point place) {
  place_ = place, place_panel_ = panel;
  show_marker();
}

void VtkWidget::show_place(std::size_t panel, geom::Point place) {
  if (!scene_ || panel >= picture_.panels.size()) return;
  place_ = place, place_panel_ = panel;
  remember(view::Move::Jump);
  const double size = picture_.panels[panel].extent ? picture_.panels[panel].extent->diagonal() : 1.0;
  const std::vector<scene::View> views = scene_->views();
  const double scale = place_fraction * size / std::max(scene_->layout().panels[panel].plot.width(), 1.0);
  for (std::size_t i = 0; i < views.size(); ++i) {
    views_[i] = scene::View{i == panel ? place : views[i].centre, scale > 0.0 ? scale : views[i].world_per_point};
  }
  makeCurrent();
  scene_->set_views(views_);
  doneCurrent();
  show_marker();
}

void VtkWidget::clear_place() {
  if (!place_) return;
  place_.reset();
  show_marker();
}

void VtkWidget::mark(const std::optional<scene::Pick>& pick) {
  if (!pick && !marked_) return;
  marked_ = pick;
  show_marker();
}

scene::View VtkWidget::view(std::size_t panel) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  return scene_->views()[panel];
}

std::optional<VtkWidget::Spot> VtkWidget::spot_at(QPointF pixel) const {
  if (!scene_) return std::nullopt;
  const std::optional<std::size_t> panel = scene_->panel_at(page_point(pixel));
  if (!panel || *panel >= picture_.panels.size()) return std::nullopt;
  return Spot{*panel, scene_->layout().panels[*panel].transform.to_world(page_point(pixel))};
}

void VtkWidget::hold() {
  if (!scene_) return;
  held_ = held_ || std::none_of(views_.begin(), views_.end(), [](const auto& view) { return view.has_value(); });
  const std::vector<scene::View> views = scene_->views();
  for (std::size_t i = 0; i < views.size(); ++i) views_[i] = views[i];
}

QRectF VtkWidget::plot(std::size_t panel) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  const geom::Box& box = scene_->layout().panels[panel].plot;
  return {box.low.x, box.low.y, box.width(), box.height()};
}

QPointF VtkWidget::pixel_of(std::size_t panel, geom::Point at) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  const geom::Point page = scene_->layout().panels[panel].transform.to_page(at);
  return {page.x, page.y};
}

}  // namespace dobra::gui
