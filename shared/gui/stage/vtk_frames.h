#pragma once
// A widget that VTK draws into: how frames come to the screen. A frame of many cells is drawn part by part between
// events, something quicker stands in for it while the view moves, and edges are smoothed when it rests.

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>

#include "shared/gui/frames/bench.h"
#include "shared/gui/frames/meter.h"
#include "shared/render/vtk_stage.h"
#include "shared/scene/layer.h"

class vtkRenderWindow;

namespace dobra::gui::stage {

class VtkFrames : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit VtkFrames(QWidget* parent = nullptr);
  ~VtkFrames() override;

  /// The next frame is that of a view at rest: smoothed.
  void come_to_rest();
  /// Whether it can be drawn, so that places have pixels.
  [[nodiscard]] bool is_ready() const { return gl_ != nullptr; }
  /// All of the picture is shown as it is, in all its detail.
  [[nodiscard]] bool is_settled() const;
  /// How often the page was laid out.
  [[nodiscard]] std::size_t arrangements() const;
  /// Where the time of the frames goes.
  [[nodiscard]] frames::Meter& meter() { return meter_; }

 protected:
  /// Makes what draws into the window; it lives as long as the OpenGL context.
  virtual std::unique_ptr<render::VtkStage> make_stage(vtkRenderWindow& window) = 0;
  /// The stage is there and wants its picture. The context is current.
  virtual void stage_made() = 0;
  /// It is about to go.
  virtual void stage_goes() = 0;
  /// The widget has another size; the stage knows it.
  virtual void resized() = 0;
  [[nodiscard]] virtual scene::Color paper() const = 0;

  /// To be called by destructors of classes that make a stage.
  void shut();
  void relayout();
  /// Frames are to be quick from now on, until the view has been at rest for a while. The context is current.
  void hurry();
  /// The view is about to move: what is slow to draw is stood in for. The context is current.
  void hold_if_slow();
  /// What was drawn last is not what is to be seen: it is drawn anew, and what was being drawn is not wanted.
  void redraw();
  /// What is shown is not the picture as it is now.
  void forget_frame() { frame_is_true_ = false; }
  /// The same of a new picture.
  void give_way();

  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  struct Gl;
  void release();
  void draw_at_once();
  void begin_parts();
  void draw_part();
  void end_parts();
  /// Too much for one frame that the window waits for.
  [[nodiscard]] bool goes_in_parts() const;
  /// What is to be drawn in parts is not seen, or as it was held.
  [[nodiscard]] bool lacks_full_frame() const;
  /// Of the device.
  [[nodiscard]] QSize pixels() const;
  void render_into(std::unique_ptr<QOpenGLFramebufferObject>& frame);

  std::unique_ptr<Gl> gl_;  ///< What needs the OpenGL context.
  frames::Bench bench_;     ///< Makes what is drawn of many points.
  frames::Meter meter_;
  double full_frame_ms_ = 0.0;  ///< What the last frame cost that showed the layers.
  bool frame_is_true_ = false;  ///< What was drawn last is the picture as it is now.
  bool is_drawn_ = false;       ///< What was drawn last is what is to be seen, be it a frame that is held.
  std::unique_ptr<QOpenGLFramebufferObject> shown_;    ///< What was drawn last.
  std::unique_ptr<QOpenGLFramebufferObject> drawing_;  ///< A frame that is drawn part by part.
  QTimer parts_;                                       ///< Runs as long as one is, and draws the next part.
  std::size_t part_cost_ = 0;                          ///< Points and cells of a part.
  double parts_ms_ = 0.0;                              ///< What the parts took until now,
  double longest_part_ms_ = 0.0;                       ///< and the longest of them.
  frames::Meter::Clock::time_point parts_began_;
  int unseen_ = 0;  ///< Pictures that gave way to another before they were drawn.
  QTimer rest_;     ///< As long as it runs the view moves, and is drawn without smoothing.
};

}  // namespace dobra::gui::stage
