// What was tried (see docs/architecture.md, facts about the platform): Debian's VTK-Qt library is built for Qt 5, so a
// QOpenGLWidget owns a vtkGenericOpenGLRenderWindow that draws into the widget's framebuffer. Pages of VtkScene are in
// device-independent pixels, just as Qt's mouse positions; only the size of the render window is in device pixels.
#include "shared/gui/vtk_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "shared/base/check.h"
#include "shared/canvas/entry.h"
#include "shared/gui/text.h"
#include "shared/render/vtk_scene.h"

namespace dobra::gui {

namespace {

constexpr double pick_reach = 8.0;       ///< Pixels round the cursor, as the tools reach.
constexpr double zoom_a_notch = 1.2;     ///< Of the wheel: 15 degrees, 120 units.
constexpr double pan_a_key = 0.1;        ///< Of the plot.
constexpr int at_rest = 200;             ///< Milliseconds after the last movement of the view.
constexpr double place_fraction = 0.1;   ///< Of the model that is seen round a place.
constexpr double least_fraction = 1e-9;  ///< Nearest and farthest zoom: size of a pixel over that of the model.
constexpr double most_fraction = 1.0;
constexpr double slow_frame = 25.0;   ///< Milliseconds: where the layers take more, the view moves their last frame.
constexpr std::size_t heavy = 60000;  ///< Cells that are drawn at once; a frame of more is drawn in parts.
constexpr std::size_t first_part = 25000;
constexpr std::size_t least_part = 4000;
constexpr double part_ms = 40.0;  ///< That a part is to take.
constexpr int most_unseen = 2;    ///< Pictures that follow each other too quickly for parts: the next is drawn at once.
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

/// "x" of "x [m]".
QString axis_name(const std::string& title) { return QString::fromStdString(title.substr(0, title.find(" ["))); }

/// "m" of "x [m]"; empty without one.
QString axis_unit(const std::string& title) {
  const std::size_t open = title.rfind('[');
  const bool has_one = open != std::string::npos && title.ends_with(']');
  return has_one ? QString::fromStdString(title.substr(open + 1, title.size() - open - 2)) : QString();
}

QRect rect_of(const QSize& size) { return {QPoint(0, 0), size}; }

geom::Point page_point(QPointF pixel) { return {pixel.x(), pixel.y()}; }

}  // namespace

struct VtkWidget::Scene {
  explicit Scene(VtkWidget& owner) : widget(owner), scene(*window) {
    observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
      // Only if it is not: QOpenGLWidget::makeCurrent binds the widget's framebuffer, behind VTK's back while it draws.
      VtkWidget& own = static_cast<Scene*>(self)->widget;
      if (QOpenGLContext::currentContext() != own.context()) own.makeCurrent();
    });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      const QOpenGLContext* own = static_cast<Scene*>(self)->widget.context();
      *static_cast<bool*>(answer) = own != nullptr && QOpenGLContext::currentContext() == own;
    });
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->SetFrameBlitModeToBlitToCurrent();
    window->OpenGLInitContext();
  }
  ~Scene() {
    scene.release();
    window->Finalize();
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void observe(unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(answer);
    command->SetClientData(this);
    window->AddObserver(event, command);
  }

  VtkWidget& widget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  render::VtkScene scene;
};

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(text("Picture"));
  setAccessibleDescription(text("Arrow keys pan, + and - zoom, Home shows all; with Space held the left button pans."));
  setMinimumSize(320, 240);
  setCursor(Qt::CrossCursor);
  clock_.start();
  rest_.setSingleShot(true);
  rest_.setInterval(at_rest);
  connect(&rest_, &QTimer::timeout, this, &VtkWidget::come_to_rest);
  part_cost_ = first_part;
  connect(&parts_, &QTimer::timeout, this, &VtkWidget::draw_part);
  connect(&bench_, &frames::Bench::arrived, this, [this] {
    if (!scene_) return;
    makeCurrent();
    scene_->scene.arrive();
    doneCurrent();
    frame_is_true_ = false;
    redraw();
  });
  new frames::MeterLabel(meter_, this);
  connect(this, &QOpenGLWidget::frameSwapped, &meter_, &frames::Meter::count_frame);
}

VtkWidget::~VtkWidget() {
  // QOpenGLWidget destroys the context after this class is gone.
  if (context() != nullptr) context()->disconnect(this);
  release();
}

void VtkWidget::release() {
  if (!scene_) return;
  makeCurrent();
  parts_.stop();
  bench_.clear();
  scene_.reset();
  shown_.reset();
  drawing_.reset();
  is_drawn_ = false;
  doneCurrent();
}

void VtkWidget::initializeGL() {
  scene_ = std::make_unique<Scene>(*this);
  scene_->scene.set_ground(colors().ground);
  scene_->scene.make_later([this](render::VtkScene::Work work) { bench_.post(std::move(work)); });
  // The context may go and come again (another top-level window); what is on the card goes with it.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkWidget::release, Qt::UniqueConnection);
  show_picture();
}

void VtkWidget::resizeGL(int, int) {
  relayout();
  frame_is_true_ = false;
  fill_canvas();
  redraw();
}

void VtkWidget::relayout() {
  if (!scene_) return;
  const double ratio = devicePixelRatioF();
  scene_->scene.resize(static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio)),
                       ratio);
}

void VtkWidget::paintGL() {
  if (!scene_) return;
  if (size().isEmpty()) return;
  if (!shown_ || shown_->size() != pixels()) is_drawn_ = false;
  if (!is_drawn_ && (scene_->scene.holds_frame() || !goes_in_parts())) draw_at_once();
  // Until the parts are there, what was drawn last stays.
  if (lacks_full_frame() && !parts_.isActive() && !rest_.isActive() && !scene_->scene.is_waiting()) begin_parts();
  QOpenGLFunctions* gl = context()->functions();
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  if (shown_)
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, rect_of(pixels()), shown_.get(), rect_of(shown_->size()));
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  // Opaque, or the desktop shows through where VTK left transparency behind.
  const scene::Color& paper = colors().ground.paper;
  gl->glColorMask(shown_ ? GL_FALSE : GL_TRUE, shown_ ? GL_FALSE : GL_TRUE, shown_ ? GL_FALSE : GL_TRUE, GL_TRUE);
  gl->glClearColor(paper.red / 255.0F, paper.green / 255.0F, paper.blue / 255.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void VtkWidget::redraw() {
  is_drawn_ = false;
  parts_.stop();
  if (scene_ && scene_->scene.draws_parts()) {
    makeCurrent();
    scene_->scene.end_parts(render::VtkScene::Parts::Unfinished);
    doneCurrent();
  }
  update();
}

std::size_t VtkWidget::arrangements() const { return scene_ ? scene_->scene.arrangements() : 0; }

QSize VtkWidget::pixels() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

bool VtkWidget::goes_in_parts() const {
  return scene_->scene.cost() > heavy && (unseen_ <= most_unseen || scene_->scene.is_waiting());
}

bool VtkWidget::lacks_full_frame() const { return goes_in_parts() && (!is_drawn_ || scene_->scene.holds_frame()); }

/// @pre the context is current
void VtkWidget::render_into(std::unique_ptr<QOpenGLFramebufferObject>& frame) {
  if (!frame || frame->size() != pixels()) frame = std::make_unique<QOpenGLFramebufferObject>(pixels());
  frame->bind();
  vtkGenericOpenGLRenderWindow& window = *scene_->window;
  window.PushState();
  window.OpenGLInitState();
  window.SetIsCurrent(true);
  window.SetFrameBlitModeToBlitToCurrent();
  window.Render();
  window.PopState();
}

void VtkWidget::draw_at_once() {
  const auto begin = frames::Meter::Clock::now();
  render_into(shown_);
  is_drawn_ = true;
  if (!scene_->scene.holds_frame()) {
    context()->functions()->glFinish();  // what the layers cost is known once they are drawn
    full_frame_ms_ = frames::Meter::milliseconds_since(begin);
    frame_is_true_ = !scene_->scene.is_waiting();
    if (frame_is_true_) unseen_ = 0;
    if (frame_is_true_) meter_.add_full_frame(full_frame_ms_, full_frame_ms_);
  }
  meter_.add(frames::Part::Draw, frames::Meter::milliseconds_since(begin));
}

void VtkWidget::begin_parts() {
  scene_->scene.begin_parts();
  parts_ms_ = 0.0;
  longest_part_ms_ = 0.0;
  parts_began_ = frames::Meter::Clock::now();
  meter_.begin_full_frame();
  parts_.start(0);
}

/// Between two parts the window hears of whatever else there is.
void VtkWidget::draw_part() {
  if (!scene_ || !scene_->scene.draws_parts()) return parts_.stop();
  makeCurrent();
  const auto begin = frames::Meter::Clock::now();
  const bool last = scene_->scene.next_part(part_cost_);
  render_into(drawing_);
  context()->functions()->glFinish();
  const double took = frames::Meter::milliseconds_since(begin);
  parts_ms_ += took;
  longest_part_ms_ = std::max(longest_part_ms_, took);
  const double factor = std::clamp(part_ms / std::max(took, 1.0), 0.5, 1.5);
  part_cost_ = std::max(least_part, static_cast<std::size_t>(factor * static_cast<double>(part_cost_)));
  if (last) end_parts();
  doneCurrent();
}

void VtkWidget::end_parts() {
  parts_.stop();
  scene_->scene.end_parts(render::VtkScene::Parts::Finished);
  std::swap(shown_, drawing_);
  drawing_.reset();
  is_drawn_ = true;
  frame_is_true_ = !scene_->scene.is_waiting();
  full_frame_ms_ = parts_ms_;
  unseen_ = 0;
  meter_.add(frames::Part::Draw, parts_ms_);
  meter_.add_full_frame(frames::Meter::milliseconds_since(parts_began_), longest_part_ms_);
  update();
}

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
  scene_->scene.set_ground(colors().ground);
  doneCurrent();
  show_marker();
}

void VtkWidget::show_picture() {
  if (!scene_) return;
  const auto begin = frames::Meter::Clock::now();
  if (parts_.isActive()) ++unseen_;
  frame_is_true_ = false;
  makeCurrent();
  hurry();
  {
    const render::VtkScene::Changes changes(scene_->scene);
    scene_->scene.set_picture(picture_);
    scene_->scene.set_views(views_);
    scene_->scene.set_options(view::with(settings_, scene_->scene.options()));
    relayout();
    mark_place();
  }
  fill_plots();
  doneCurrent();
  meter_.add(frames::Part::Actors, frames::Meter::milliseconds_since(begin));
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
  if (!whole || scene_->scene.layout().panels.size() != picture_.panels.size()) return false;
  std::vector<geom::Box> plots;
  for (const scene::PanelLayout& panel : scene_->scene.layout().panels) plots.push_back(panel.plot);
  filling_ = view::that_fills(picture_.panels, plots);
  if (!dress()) return false;
  {
    const render::VtkScene::Changes changes(scene_->scene);
    scene_->scene.set_picture(picture_);
    scene_->scene.set_views(views_);
    mark_place();
  }
  frame_is_true_ = false;
  emit exaggerated(filling_);
  return true;
}

void VtkWidget::exaggerate(scene::Picture& picture) const {
  for (scene::Panel& panel : picture.panels) {
    if (view::shows_lengths(panel)) panel.vertical_exaggeration *= settings_.exaggeration.value_or(filling_);
  }
  if (settings_.panels == view::Panels::Row) picture.arrangement = scene::Arrangement::Row;
  if (settings_.panels == view::Panels::Column) picture.arrangement = scene::Arrangement::Column;
}

bool VtkWidget::all_is_seen() const {
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const std::optional<geom::Box>& extent = picture_.panels[i].extent;
    if (!views_[i] || !extent) continue;
    const scene::PanelLayout& panel = scene_->scene.layout().panels[i];
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
    const render::VtkScene::Changes changes(scene_->scene);
    mark_place();
  }
  doneCurrent();
  redraw();
  emit view_changed();
}

/// @pre the context is current
void VtkWidget::mark_place() {
  for (std::size_t i = 0; i < picture_.panels.size(); ++i) {
    std::vector<scene::Layer> layers;
    if (place_ && i == panel_of(*place_)) {
      layers = {marker_layer("gui.place.rim", *place_, marker_color, 18.0),
                marker_layer("gui.place.ring", *place_, {255, 255, 255}, 12.0),
                marker_layer("gui.place.point", *place_, marker_color, 5.0)};
    }
    scene_->scene.set_overlay(i, layers);
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
  scene_->scene.set_layer_visible(panel_key, layer_key, visible);
  doneCurrent();
  frame_is_true_ = false;
  redraw();
}

void VtkWidget::fit() {
  remember(view::Move::Jump);
  std::fill(views_.begin(), views_.end(), std::nullopt);
  if (!scene_) return;
  makeCurrent();
  scene_->scene.set_views(views_);
  fill_plots();
  doneCurrent();
  redraw();
  emit view_changed();
}

void VtkWidget::zoom(double factor, QPointF at) {
  if (!scene_ || picture_.panels.empty()) return;
  const std::optional<Spot> spot = spot_at(at);
  std::vector<scene::View> views = scene_->scene.views();
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
  const std::vector<scene::View> views = scene_->scene.views();
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
  const std::vector<scene::View> views = scene_->scene.views();
  const geom::Box& plot = scene_->scene.layout().panels[panel].plot;
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
  return scene_->scene.layout().panels[panel].tick_step;
}

/// Smoothing costs about as much as all the rest of a frame: it comes with the view at rest.
void VtkWidget::hurry() {
  scene_->window->SetMultiSamples(0);
  rest_.start();
}

void VtkWidget::come_to_rest() {
  rest_.stop();
  if (!scene_ || parts_.isActive()) return;
  scene_->window->SetMultiSamples(render::samples_a_pixel);
  if (lacks_full_frame()) return update();
  makeCurrent();
  scene_->scene.let_go();
  doneCurrent();
  redraw();
}

void VtkWidget::move_views() {
  makeCurrent();
  hurry();
  // What is drawn in parts is not what is seen.
  if (full_frame_ms_ > slow_frame && frame_is_true_ && !scene_->scene.draws_parts()) scene_->scene.hold_frame();
  scene_->scene.set_views(views_);
  doneCurrent();
  redraw();
  emit view_changed();
}

void VtkWidget::show_place(geom::Point place) {
  if (!scene_ || picture_.panels.empty()) return;
  place_ = place;
  remember(view::Move::Jump);
  const std::size_t panel = panel_of(place);
  const double size = picture_.panels[panel].extent ? picture_.panels[panel].extent->diagonal() : 1.0;
  const std::vector<scene::View> views = scene_->scene.views();
  const double scale = place_fraction * size / std::max(scene_->scene.layout().panels[panel].plot.width(), 1.0);
  for (std::size_t i = 0; i < views.size(); ++i) {
    views_[i] = scene::View{i == panel ? place : views[i].centre, scale > 0.0 ? scale : views[i].world_per_point};
  }
  makeCurrent();
  scene_->scene.set_views(views_);
  doneCurrent();
  show_marker();
}

void VtkWidget::clear_place() {
  if (!place_) return;
  place_.reset();
  show_marker();
}

scene::View VtkWidget::view(std::size_t panel) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  return scene_->scene.views()[panel];
}

std::optional<VtkWidget::Spot> VtkWidget::spot_at(QPointF pixel) const {
  if (!scene_) return std::nullopt;
  const std::optional<std::size_t> panel = scene_->scene.panel_at(page_point(pixel));
  if (!panel || *panel >= picture_.panels.size()) return std::nullopt;
  return Spot{*panel, scene_->scene.layout().panels[*panel].transform.to_world(page_point(pixel))};
}

void VtkWidget::hold() {
  if (!scene_) return;
  held_ = held_ || std::none_of(views_.begin(), views_.end(), [](const auto& view) { return view.has_value(); });
  const std::vector<scene::View> views = scene_->scene.views();
  for (std::size_t i = 0; i < views.size(); ++i) views_[i] = views[i];
}

bool VtkWidget::is_settled() const {
  return !scene_ || (!scene_->scene.is_waiting() && bench_.is_idle() && !(isVisible() && lacks_full_frame()));
}

QRectF VtkWidget::plot(std::size_t panel) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  const geom::Box& box = scene_->scene.layout().panels[panel].plot;
  return {box.low.x, box.low.y, box.width(), box.height()};
}

QPointF VtkWidget::pixel_of(std::size_t panel, geom::Point at) const {
  DOBRA_CHECK(scene_ && panel < picture_.panels.size());
  const geom::Point page = scene_->scene.layout().panels[panel].transform.to_page(at);
  return {page.x, page.y};
}

void VtkWidget::pick(QPointF pixel) {
  const std::optional<Spot> spot = spot_at(pixel);
  if (!spot) return;
  const scene::Panel& panel = picture_.panels[spot->panel];
  const double scale = scene_->scene.views()[spot->panel].world_per_point;
  const std::optional<scene::Pick> found = scene::pick(panel, spot->at, pick_reach * scale);
  if (!found) {
    emit picked(text("Nothing here."));
    return;
  }
  const auto is_it = [&](const scene::Layer& layer) { return layer.key == found->layer; };
  const auto layer = std::find_if(panel.layers.begin(), panel.layers.end(), is_it);
  const std::string title = layer != panel.layers.end() && !layer->title.empty() ? layer->title : found->layer;
  emit picked(text("%1, item %2").arg(QString::fromStdString(title)).arg(found->id));
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
  const bool hand = hand_ == Hand::Ready || hand_tool_;
  const bool pans = event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && hand);
  if (pans && dragging_ == Qt::NoButton) {
    dragging_ = event->button();
    drag_ = event->position();
    show_cursor();
  } else if (event->button() == Qt::LeftButton) {
    pick(event->position());
  }
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_ != Qt::NoButton) {
    pan(drag_, event->position() - drag_);
    drag_ = event->position();
  }
  const std::optional<Spot> spot = spot_at(event->position());
  if (!spot) {
    emit cursor_moved({});
    return;
  }
  const scene::Panel& panel = picture_.panels[spot->panel];
  const double scale = scene_->scene.views()[spot->panel].world_per_point;
  const double unit = panel.axes.unit;
  // As many decimals as a pixel can tell apart.
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(scale / unit))), 0, 12);
  const auto number = [&](double value) {
    return QString::fromStdString(
        canvas::with_decimal_mark(QString::number(value / unit, 'f', decimals).toStdString()));
  };
  emit cursor_moved(QString("%1 = %2   %3 = %4 %5")
                        .arg(axis_name(panel.axes.x_title), number(spot->at.x), axis_name(panel.axes.y_title),
                             number(spot->at.y), axis_unit(panel.axes.y_title))
                        .trimmed());
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != dragging_) return;
  dragging_ = Qt::NoButton;
  show_cursor();
}

void VtkWidget::show_cursor() {
  if (dragging_ != Qt::NoButton) {
    setCursor(Qt::ClosedHandCursor);
  } else if (hand_ == Hand::Ready || hand_tool_) {
    setCursor(Qt::OpenHandCursor);
  } else {
    setCursor(tool_cursor_);
  }
}

void VtkWidget::set_hand(bool on) {
  hand_tool_ = on;
  show_cursor();
}

void VtkWidget::set_tool_cursor(const QCursor& cursor) {
  tool_cursor_ = cursor;
  show_cursor();
}

void VtkWidget::keyPressEvent(QKeyEvent* event) {
  const QPointF middle(0.5 * width(), 0.5 * height());
  switch (event->key()) {
    case Qt::Key_Space:
      hand_ = Hand::Ready;
      return show_cursor();
    case Qt::Key_Left:
      return pan_by_key(-1, 0);
    case Qt::Key_Right:
      return pan_by_key(1, 0);
    case Qt::Key_Up:
      return pan_by_key(0, 1);
    case Qt::Key_Down:
      return pan_by_key(0, -1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(zoom_a_notch, middle);
    case Qt::Key_Minus:
      return zoom(1.0 / zoom_a_notch, middle);
    case Qt::Key_Home:
      return fit();
    default:
      QOpenGLWidget::keyPressEvent(event);
  }
}

void VtkWidget::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return QOpenGLWidget::keyReleaseEvent(event);
  if (event->isAutoRepeat()) return;
  hand_ = Hand::Away;
  show_cursor();
}

void VtkWidget::focusInEvent(QFocusEvent* event) {
  QOpenGLWidget::focusInEvent(event);
  update();
}

void VtkWidget::focusOutEvent(QFocusEvent* event) {
  hand_ = Hand::Away;
  show_cursor();
  QOpenGLWidget::focusOutEvent(event);
  update();
}

/// The view moves over the model, so the model moves the other way. Each panel pans by a part of its own.
void VtkWidget::pan_by_key(int right, int up) {
  if (!scene_) return;
  remember(view::Move::Glide);
  const std::vector<scene::View> views = scene_->scene.views();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const geom::Box& plot = scene_->scene.layout().panels[i].plot;
    const geom::Vector by{-pan_a_key * right * plot.width(), pan_a_key * up * plot.height()};
    views_[i] = scene::pan(views[i], by, picture_.panels[i].vertical_exaggeration);
  }
  move_views();
}

void VtkWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) fit();
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) zoom(std::pow(zoom_a_notch, notches), event->position());
  event->accept();
}

void VtkWidget::leaveEvent(QEvent*) { emit cursor_moved({}); }

}  // namespace dobra::gui
