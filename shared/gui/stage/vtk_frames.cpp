// What was tried (see docs/architecture.md, facts about the platform): Debian's VTK-Qt library is built for Qt 5, so a
// QOpenGLWidget owns a vtkGenericOpenGLRenderWindow that draws into the widget's framebuffer. Pages are in
// device-independent pixels, just as Qt's mouse positions; only the size of the render window is in device pixels.
#include "shared/gui/stage/vtk_frames.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace dobra::gui::stage {

namespace {

constexpr std::size_t heavy = 60000;  ///< Cells that are drawn at once; a frame of more is drawn in parts.
constexpr std::size_t first_part = 25000;
constexpr std::size_t least_part = 4000;
constexpr double part_ms = 40.0;     ///< That a part is to take.
constexpr int at_rest = 200;         ///< Milliseconds after the last movement of the view.
constexpr double slow_frame = 25.0;  ///< Milliseconds: where the layers take more, something stands in for them.
constexpr int most_unseen = 2;  ///< Pictures that follow each other too quickly for parts: the next is drawn at once.

QRect rect_of(const QSize& size) { return {QPoint(0, 0), size}; }

}  // namespace

struct VtkFrames::Gl {
  explicit Gl(VtkFrames& owner) : widget(owner) {
    observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
      // Only if it is not: QOpenGLWidget::makeCurrent binds the widget's framebuffer, behind VTK's back while it draws.
      VtkFrames& own = static_cast<Gl*>(self)->widget;
      if (QOpenGLContext::currentContext() != own.context()) own.makeCurrent();
    });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      const QOpenGLContext* own = static_cast<Gl*>(self)->widget.context();
      *static_cast<bool*>(answer) = own != nullptr && QOpenGLContext::currentContext() == own;
    });
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->SetFrameBlitModeToBlitToCurrent();
    window->OpenGLInitContext();
    stage = owner.make_stage(*window);
  }
  ~Gl() {
    stage->release();
    window->Finalize();
  }
  Gl(const Gl&) = delete;
  Gl& operator=(const Gl&) = delete;

  void observe(unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(answer);
    command->SetClientData(this);
    window->AddObserver(event, command);
  }

  VtkFrames& widget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  std::unique_ptr<render::VtkStage> stage;
};

VtkFrames::VtkFrames(QWidget* parent) : QOpenGLWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  rest_.setSingleShot(true);
  rest_.setInterval(at_rest);
  connect(&rest_, &QTimer::timeout, this, &VtkFrames::come_to_rest);
  connect(&parts_, &QTimer::timeout, this, &VtkFrames::draw_part);
  connect(&bench_, &frames::Bench::arrived, this, [this] {
    if (!gl_) return;
    makeCurrent();
    gl_->stage->arrive();
    doneCurrent();
    frame_is_true_ = false;
    redraw();
  });
  new frames::MeterLabel(meter_, this);
  connect(this, &QOpenGLWidget::frameSwapped, &meter_, &frames::Meter::count_frame);
}

VtkFrames::~VtkFrames() = default;

void VtkFrames::shut() {
  // QOpenGLWidget destroys the context after this class is gone.
  if (context() != nullptr) context()->disconnect(this);
  release();
}

void VtkFrames::release() {
  if (!gl_) return;
  makeCurrent();
  parts_.stop();
  bench_.clear();
  stage_goes();
  gl_.reset();
  shown_.reset();
  drawing_.reset();
  is_drawn_ = false;
  doneCurrent();
}

void VtkFrames::initializeGL() {
  gl_ = std::make_unique<Gl>(*this);
  gl_->stage->make_later([this](render::VtkStage::Work work) { bench_.post(std::move(work)); });
  // The context may go and come again (another top-level window); what is on the card goes with it.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkFrames::release, Qt::UniqueConnection);
  stage_made();
}

void VtkFrames::resizeGL(int, int) {
  relayout();
  frame_is_true_ = false;
  resized();
  redraw();
}

void VtkFrames::relayout() {
  if (!gl_) return;
  const double ratio = devicePixelRatioF();
  gl_->stage->resize(static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio)),
                     ratio);
}

void VtkFrames::give_way() {
  if (parts_.isActive()) ++unseen_;
  frame_is_true_ = false;
}

/// Smoothing costs about as much as all the rest of a frame: it comes with the view at rest.
void VtkFrames::hurry() {
  gl_->window->SetMultiSamples(0);
  rest_.start();
}

void VtkFrames::hold_if_slow() {
  // What is drawn in parts is not what is seen.
  if (full_frame_ms_ > slow_frame && frame_is_true_ && !gl_->stage->draws_parts()) gl_->stage->hold_frame();
}

void VtkFrames::come_to_rest() {
  rest_.stop();
  if (!gl_ || parts_.isActive()) return;
  gl_->window->SetMultiSamples(render::samples_a_pixel);
  if (lacks_full_frame()) return update();
  makeCurrent();
  gl_->stage->let_go();
  doneCurrent();
  redraw();
}

bool VtkFrames::is_settled() const {
  return !gl_ || (!gl_->stage->is_waiting() && bench_.is_idle() && !(isVisible() && lacks_full_frame()));
}

void VtkFrames::focusInEvent(QFocusEvent* event) {
  QOpenGLWidget::focusInEvent(event);
  update();
}

void VtkFrames::focusOutEvent(QFocusEvent* event) {
  QOpenGLWidget::focusOutEvent(event);
  update();
}

void VtkFrames::paintGL() {
  if (!gl_) return;
  if (size().isEmpty()) return;
  if (!shown_ || shown_->size() != pixels()) is_drawn_ = false;
  if (!is_drawn_ && (gl_->stage->holds_frame() || !goes_in_parts())) draw_at_once();
  // Until the parts are there, what was drawn last stays.
  if (lacks_full_frame() && !parts_.isActive() && !rest_.isActive() && !gl_->stage->is_waiting()) begin_parts();
  QOpenGLFunctions* gl = context()->functions();
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  if (shown_)
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, rect_of(pixels()), shown_.get(), rect_of(shown_->size()));
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  // Opaque, or the desktop shows through where VTK left transparency behind.
  const scene::Color paper = this->paper();
  gl->glColorMask(shown_ ? GL_FALSE : GL_TRUE, shown_ ? GL_FALSE : GL_TRUE, shown_ ? GL_FALSE : GL_TRUE, GL_TRUE);
  gl->glClearColor(paper.red / 255.0F, paper.green / 255.0F, paper.blue / 255.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void VtkFrames::redraw() {
  is_drawn_ = false;
  parts_.stop();
  if (gl_ && gl_->stage->draws_parts()) {
    makeCurrent();
    gl_->stage->end_parts(render::VtkStage::Parts::Unfinished);
    doneCurrent();
  }
  update();
}

std::size_t VtkFrames::arrangements() const { return gl_ ? gl_->stage->arrangements() : 0; }

QSize VtkFrames::pixels() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

bool VtkFrames::goes_in_parts() const {
  return gl_->stage->cost() > heavy && (unseen_ <= most_unseen || gl_->stage->is_waiting());
}

bool VtkFrames::lacks_full_frame() const { return goes_in_parts() && (!is_drawn_ || gl_->stage->holds_frame()); }

/// @pre the context is current
void VtkFrames::render_into(std::unique_ptr<QOpenGLFramebufferObject>& frame) {
  if (!frame || frame->size() != pixels()) frame = std::make_unique<QOpenGLFramebufferObject>(pixels());
  frame->bind();
  vtkGenericOpenGLRenderWindow& window = *gl_->window;
  window.PushState();
  window.OpenGLInitState();
  window.SetIsCurrent(true);
  window.SetFrameBlitModeToBlitToCurrent();
  window.Render();
  window.PopState();
}

void VtkFrames::draw_at_once() {
  const auto begin = frames::Meter::Clock::now();
  render_into(shown_);
  is_drawn_ = true;
  if (!gl_->stage->holds_frame()) {
    context()->functions()->glFinish();  // what the layers cost is known once they are drawn
    full_frame_ms_ = frames::Meter::milliseconds_since(begin);
    frame_is_true_ = !gl_->stage->is_waiting();
    if (frame_is_true_) unseen_ = 0;
    if (frame_is_true_) meter_.add_full_frame(full_frame_ms_, full_frame_ms_);
  }
  meter_.add(frames::Part::Draw, frames::Meter::milliseconds_since(begin));
}

void VtkFrames::begin_parts() {
  gl_->stage->begin_parts();
  if (part_cost_ == 0) part_cost_ = first_part;
  parts_ms_ = 0.0;
  longest_part_ms_ = 0.0;
  parts_began_ = frames::Meter::Clock::now();
  meter_.begin_full_frame();
  parts_.start(0);
}

/// Between two parts the window hears of whatever else there is.
void VtkFrames::draw_part() {
  if (!gl_ || !gl_->stage->draws_parts()) return parts_.stop();
  makeCurrent();
  const auto begin = frames::Meter::Clock::now();
  const bool last = gl_->stage->next_part(part_cost_);
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

void VtkFrames::end_parts() {
  parts_.stop();
  gl_->stage->end_parts(render::VtkStage::Parts::Finished);
  std::swap(shown_, drawing_);
  drawing_.reset();
  is_drawn_ = true;
  frame_is_true_ = !gl_->stage->is_waiting();
  full_frame_ms_ = parts_ms_;
  unseen_ = 0;
  meter_.add(frames::Part::Draw, parts_ms_);
  meter_.add_full_frame(frames::Meter::milliseconds_since(parts_began_), longest_part_ms_);
  update();
}

}  // namespace dobra::gui::stage
