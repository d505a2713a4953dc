// How frames come to the screen: at once, or part by part between events where that would take too long.
#include <vtkOpenGLState.h>

#include <QOpenGLFunctions>
#include <QPainter>
#include <algorithm>

#include "shared/gui/vtk_widget_scene.h"

namespace dobra::gui {

namespace {

constexpr std::size_t heavy = 60000;  ///< Cells that are drawn at once; a frame of more is drawn in parts.
constexpr std::size_t first_part = 25000;
constexpr std::size_t least_part = 4000;
constexpr double part_ms = 40.0;  ///< That a part is to take.
constexpr int most_unseen = 2;    ///< Pictures that follow each other too quickly for parts: the next is drawn at once.

QRect rect_of(const QSize& size) { return {QPoint(0, 0), size}; }

}  // namespace

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
  if (part_cost_ == 0) part_cost_ = first_part;
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

}  // namespace dobra::gui
