#pragma once
// The picture in space in the window: the left button turns it, the middle one (or the left one with Space held) moves
// it, the wheel comes nearer; a click tells what is there, and markers that the program gives free can be dragged in
// the plane of the screen. Page: docs/user/space_view.md.

#include <QPointF>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "shared/gui/frames/bench.h"
#include "shared/gui/stage/section_handle.h"
#include "shared/gui/stage/space_gesture.h"
#include "shared/gui/stage/vtk_frames.h"
#include "shared/gui/theme/colors.h"
#include "shared/scene/space/layout.h"
#include "shared/scene/space/pick.h"

namespace dobra::render {
class VtkSpace;
}

namespace dobra::gui::stage {

class SpaceWidget : public VtkFrames {
  Q_OBJECT

 public:
  explicit SpaceWidget(QWidget* parent = nullptr);
  ~SpaceWidget() override;

  enum class Looking { AtAll, WhereItDid };
  /// @param looking  AtAll: as the picture asks to be looked at.
  void set_picture(scene::space::SpacePicture picture, Looking looking);
  [[nodiscard]] const scene::space::SpacePicture& picture() const { return picture_; }
  void set_layer_visible(const std::string& layer, bool visible);
  void set_canvas(theme::Canvas canvas);
  /// Times that of the picture.
  void set_exaggeration(double exaggeration);

  /// Cuts what is shown; nothing: all of it is shown. Of the view only.
  void set_section(const std::optional<scene::space::Section>& section);
  [[nodiscard]] const std::optional<scene::space::Section>& section() const { return section_; }
  /// @pre section(), and a picture with layers
  [[nodiscard]] scene::space::CutPlane section_plane() const;
  /// What closes the cut that a plane makes: layers of surfaces whose keys end with scene::space::cap_end, shown where
  /// the layer is that they are of.
  using Caps = std::function<std::vector<scene::space::Layer>(const scene::space::CutPlane&)>;
  void set_caps(Caps caps) { caps_ = std::move(caps); }
  [[nodiscard]] const SectionHandle& section_handle() const { return *handle_; }
  /// As it is cut, without what stands over it.
  [[nodiscard]] const scene::space::SpacePicture& shown() const { return shown_; }

  /// From a usual side, all of it.
  void look_from(scene::space::StandardView view);
  [[nodiscard]] const scene::space::Look& look() const { return look_; }
  /// All of it, from where it is looked at.
  void fit();
  /// Pixels of the widget.
  void orbit(QPointF by);
  void pan(QPointF by);
  void zoom(double factor, QPointF at);

  /// What is at a pixel. Nothing as long as what finds it in a picture of many triangles is being made.
  [[nodiscard]] std::optional<scene::space::SpacePick> pick_at(QPointF pixel);
  /// Marks an item, here or in the plane; nothing: no item is marked.
  void mark(const std::optional<scene::Pick>& pick);
  [[nodiscard]] const std::optional<scene::Pick>& marked() const { return marked_; }
  /// "Top of the sand, item 12: x = 3, y = 4, z = 5 m"
  [[nodiscard]] QString words_of(const scene::space::SpacePick& pick) const;

  /// A place of the model is marked until that is taken back.
  void show_place(const std::optional<geom::Point3>& place);
  [[nodiscard]] const std::optional<geom::Point3>& place() const { return place_; }

  /// Markers of these layers can be dragged.
  void set_draggable(std::vector<std::string> layers) { draggable_ = std::move(layers); }

  /// A marker is under way.
  [[nodiscard]] bool drags() const { return gesture_ == Gesture::Marker; }

  /// Where a point of the model stands. @pre is_ready()
  [[nodiscard]] std::optional<QPointF> pixel_of(geom::Point3 at) const;
  /// The pixels in which the picture is shown. @pre is_ready()
  [[nodiscard]] QRectF plot() const;

 signals:
  void cursor_moved(const QString& where);
  /// Nothing: where there is nothing.
  void clicked(const std::optional<dobra::scene::space::SpacePick>& pick);
  /// A marker under way, in the plane of the screen through it.
  void dragged(dobra::gui::stage::MarkerDrag phase, const dobra::scene::space::SpacePick& marker,
               const dobra::geom::Point3& to);
  /// By its handle in the picture.
  void section_dragged(const dobra::scene::space::Section& section);
  /// Other points stand in other pixels, or another picture is shown.
  void view_changed();

 protected:
  std::unique_ptr<render::VtkStage> make_stage(vtkRenderWindow& window) override;
  void stage_made() override;
  void stage_goes() override { space_ = nullptr; }
  void resized() override;
  [[nodiscard]] scene::Color paper() const override { return theme::canvas_colors(canvas_).ground.paper; }
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  enum class Gesture { None, Press, Orbit, Pan, Marker, Section };
  void cut_picture();
  void add_caps(const scene::space::CutPlane& plane);
  void move_section(const scene::space::Section& section);
  void show_handle();
  void show_picture();
  /// A picture arrives while a marker is held: that stays in the hand if it is still there.
  [[nodiscard]] bool has_marker() const;
  void show_marks();
  void make_picker();
  void hold();
  [[nodiscard]] scene::space::Look held_look() const;
  /// Another look is to be drawn, quickly.
  void look_moved();
  void show_cursor();
  void tell_cursor(QPointF pixel);
  /// Tells what is there, as soon as that can be told.
  void click(QPointF pixel);
  void drag_marker(MarkerDrag phase, QPointF pixel);
  void end_gesture();

  theme::Canvas canvas_ = theme::Canvas::Paper;
  scene::space::SpacePicture picture_;
  scene::space::SpacePicture shown_;  ///< It, cut.
  std::optional<scene::space::Section> section_;
  SectionHandle* handle_;
  double exaggeration_ = 1.0;  ///< Over that of the picture.
  scene::space::Look look_;
  std::optional<geom::Point3> held_;   ///< What it turns about, once it has been moved.
  QSizeF seen_;                        ///< What was in sight when it was moved last, world.
  render::VtkSpace* space_ = nullptr;  ///< The stage, as long as there is one.
  std::optional<scene::Pick> marked_;
  std::optional<geom::Point3> place_;
  Caps caps_;
  std::vector<std::string> draggable_;
  frames::Bench bench_;
  std::shared_ptr<scene::space::Picker> picker_;  ///< Null while it is being made.
  std::optional<QPointF> waiting_click_;
  Gesture gesture_ = Gesture::None;
  Qt::MouseButton button_ = Qt::NoButton;
  QPointF pressed_, last_;
  std::optional<scene::space::SpacePick> marker_;  ///< The one that is dragged.
  geom::Point3 marker_at_;
  bool hand_ = false;  ///< Space is held.
};

}  // namespace dobra::gui::stage
