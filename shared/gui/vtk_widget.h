#pragma once
// The picture in the window, drawn by VTK: pan with the middle button, zoom at the cursor with the wheel, fit with F or
// a double click of the middle button, tell what is under the cursor, mark a place.

#include <QCursor>
#include <QElapsedTimer>
#include <memory>
#include <optional>

#include "shared/gui/stage/vtk_frames.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/view/history.h"
#include "shared/gui/view/settings.h"
#include "shared/scene/pick.h"
#include "shared/scene/view.h"

namespace dobra::render {
class VtkScene;
}

namespace dobra::gui {

/// What a new picture does to the views.
enum class Looking { AtAll, WhereItDid };

class VtkWidget : public stage::VtkFrames {
  Q_OBJECT

 public:
  explicit VtkWidget(QWidget* parent = nullptr);
  ~VtkWidget() override;

  void set_picture(scene::Picture picture, Looking looking);
  void set_layer_visible(const std::string& panel, const std::string& layer, bool visible);
  /// How pictures are looked at, this one and those to come. Where all was seen, all is seen again.
  void set_settings(const view::Settings& settings);

  /// Gives the panels of a picture the exaggeration, the arrangement and the part of the model that they show here.
  void make_alike(scene::Picture& picture) const;

  /// What pictures are drawn on.
  void set_canvas(theme::Canvas canvas);
  [[nodiscard]] const theme::CanvasColors& colors() const { return theme::canvas_colors(canvas_); }

  /// All of every panel, at the scale they share.
  void fit();
  /// `factor` times nearer, the point under `at` (pixels of the widget) staying where it is. The other panels keep the
  /// common scale.
  void zoom(double factor, QPointF at);
  /// Moves the panel at `from` by a distance in pixels of the widget; where panels are linked, all of them.
  void pan(QPointF from, QPointF by);
  /// All of a box of the model, as large as its panel allows; of a box without size its middle, at the present scale.
  /// @pre is_ready(), panel < panel_count()
  void look_at(std::size_t panel, const geom::Box& box);
  /// The view before the last pan, zoom or fit, and back to it. @return false if there is none.
  bool look_back();
  bool look_forward();
  /// The left button pans.
  void set_hand(bool on);
  /// It pans now: by set_hand, or because Space is held.
  [[nodiscard]] bool hand_is_ready() const { return hand_tool_ || hand_ == Hand::Ready; }
  /// Shown where nothing pans.
  void set_tool_cursor(const QCursor& cursor);

  /// Puts a marker at a point of the first panel that can show it, and zooms there.
  void show_place(geom::Point place);
  /// The same in a panel that is known. @pre panel < panel_count()
  void show_place(std::size_t panel, geom::Point place);
  /// The marker alone.
  void mark_place(std::size_t panel, geom::Point place);
  void clear_place();
  /// Marks the items of that layer and identity, in whichever panels there are any; nothing: none.
  void mark(const std::optional<scene::Pick>& pick);
  [[nodiscard]] const std::optional<scene::Pick>& marked() const { return marked_; }

  /// What a panel shows. @pre panel < number of panels
  [[nodiscard]] scene::View view(std::size_t panel) const;
  [[nodiscard]] std::size_t panel_count() const { return picture_.panels.size(); }
  [[nodiscard]] const std::string& panel_key(std::size_t panel) const { return picture_.panels[panel].key; }
  [[nodiscard]] const std::string& panel_title(std::size_t panel) const { return picture_.panels[panel].title; }
  /// The point of the model under a pixel, with the number of its panel; nothing outside the plots.
  struct Spot {
    std::size_t panel = 0;
    geom::Point at;
  };
  [[nodiscard]] std::optional<Spot> spot_at(QPointF pixel) const;
  /// New pictures are looked at where this one is now, also where all of it is shown.
  void hold();
  /// The pixels of the widget in which a panel shows its layers. @pre is_ready(), panel < panel_count()
  [[nodiscard]] QRectF plot(std::size_t panel) const;
  [[nodiscard]] double exaggeration(std::size_t panel) const { return picture_.panels[panel].vertical_exaggeration; }
  /// In which unit it is shown, and what its axes are called. @pre panel < panel_count()
  [[nodiscard]] const scene::Axes& axes(std::size_t panel) const { return picture_.panels[panel].axes; }
  /// From one tick of the axes to the next, world; 0 where there is only one. @pre is_ready(), panel < panel_count()
  [[nodiscard]] geom::Vector tick_step(std::size_t panel) const;
  /// Where a point of the model stands in the widget.
  [[nodiscard]] QPointF pixel_of(std::size_t panel, geom::Point at) const;

 signals:
  void cursor_moved(const QString& where);
  /// What the picture is drawn with where the settings leave it open.
  void exaggerated(double exaggeration);
  void picked(const QString& what);
  /// The item that was clicked, with its place; nothing: there is none.
  void picked_item(std::size_t panel, const std::optional<dobra::scene::Pick>& pick, dobra::geom::Point at);
  /// Other places of the model stand in other pixels, or another picture is shown.
  void view_changed();

 protected:
  std::unique_ptr<render::VtkStage> make_stage(vtkRenderWindow& window) override;
  void stage_made() override;
  void stage_goes() override;
  void resized() override { fill_canvas(); }
  [[nodiscard]] scene::Color paper() const override { return colors().ground.paper; }
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
  void show_picture();
  void show_marker();
  void mark_places();
  [[nodiscard]] std::size_t panel_of(geom::Point place) const;
  void pick(QPointF pixel);
  void show_cursor();
  void pan_by_key(int right, int up);
  void move_views();
  /// To be called before the views move.
  void remember(view::Move move);
  void go_to(const view::Looks& looks);
  [[nodiscard]] view::Looks looks() const;
  /// Axes and exaggeration as the settings say. @return whether any is another now.
  bool dress();
  void fill_canvas();
  bool fill_plots();
  [[nodiscard]] bool all_is_seen() const;
  [[nodiscard]] bool goes_along(std::size_t panel, std::size_t moved) const;

  theme::Canvas canvas_ = theme::Canvas::Paper;
  /// What the settings change of a panel, as it was given.
  struct Given {
    scene::Axes axes;
    double exaggeration = 1.0;
  };

  scene::Picture picture_;  ///< As given, but for what the settings change.
  std::vector<Given> given_;
  view::Settings settings_;
  double filling_ = 1.0;  ///< The exaggeration where the settings leave it open.
  view::History history_;
  QElapsedTimer clock_;
  std::optional<scene::Pick> marked_;
  std::optional<geom::Point> place_;               ///< Where the marker stands,
  std::size_t place_panel_ = 0;                    ///< and in which panel.
  std::vector<std::optional<scene::View>> views_;  ///< One a panel; nothing: all of it.
  render::VtkScene* scene_ = nullptr;              ///< The stage, as long as there is one.
  bool held_ = false;                              ///< Those views show all, and were left so by nobody's wish.
  QPointF drag_;
  Qt::MouseButton dragging_ = Qt::NoButton;
  enum class Hand { Away, Ready } hand_ = Hand::Away;  ///< Ready while Space is held: the left button pans.
  bool hand_tool_ = false;                             ///< It pans all the time.
  QCursor tool_cursor_ = Qt::CrossCursor;
};

}  // namespace dobra::gui
