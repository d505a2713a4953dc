#pragma once
// The tools on the picture: passes mouse and keys on to the tool in hand, draws what it shows over the picture without
// touching that, and turns what it has done into edits of the document. Page: docs/user/canvas.md.

#include <QEvent>
#include <QObject>
#include <QPointF>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "shared/canvas/tool.h"
#include "shared/gui/session.h"
#include "shared/gui/view/line_menu.h"

class QLineEdit;
class QMouseEvent;

namespace dobra::gui {

class VtkWidget;

class Canvas : public QObject {
  Q_OBJECT

 public:
  /// Works on what `view` shows. @pre both outlive the canvas
  Canvas(Session& session, VtkWidget& view, QObject* parent = nullptr);
  ~Canvas() override;

  /// What the mouse and the keys do from now on. What the tool before has drawn so far is finished.
  void take_up(std::unique_ptr<canvas::Tool> tool);
  /// Lends the mouse to somebody else: the next click is told to `answer`, which says what is wrong with it, or takes
  /// it (no words). After that, after Escape, and when another tool is taken up, the tool in hand is back.
  /// @param hint  what is to be clicked.
  using Answer = std::function<QString(const canvas::Pointed&)>;
  void ask_for_place(const QString& hint, Answer answer);
  [[nodiscard]] bool is_asking() const { return waiting_ != nullptr; }

  /// The last point of what is being drawn, or the gesture. @return false if nothing is unfinished.
  bool take_back();
  [[nodiscard]] bool unfinished() const { return tool_->unfinished(); }
  [[nodiscard]] canvas::Tool& tool() { return *tool_; }
  [[nodiscard]] canvas::Workspace& workspace() { return work_; }

  /// Of the last run `picture` is shown. That of an edit under way changes nothing here.
  void show_outcome(std::shared_ptr<const scene::Picture> picture);
  void show_hint();
  /// In the place of the hint, until the next click.
  void say(const QString& message);
  /// What lies where the picture was clicked; of no interest to a tool that draws.
  void tell_pick(const QString& what);
  /// Nothing is there yet but a sheet to draw on.
  void show_sheet();
  void set_layer_hidden(const std::string& layer, bool hidden);

  void set_snapping(bool on) { snapping_ = on; }
  [[nodiscard]] bool snapping() const { return snapping_; }
  [[nodiscard]] bool angles() const { return angles_; }
  /// Lines are drawn in multiples of 15 degrees.
  void set_angles(bool on) { angles_ = on; }

  /// Places without another snap go to the crossings of the ticks of the axes.
  void set_grid_snapping(bool on) { grid_snapping_ = on; }
  [[nodiscard]] bool grid_snapping() const { return grid_snapping_; }

  void select_all();
  void invert_selection();
  /// The selected lines go to the clipboard as text (canvas/line_text.h).
  void copy();
  void cut();
  /// The lines of the clipboard are drawn where they were, each with the question what it is.
  void paste();
  void look_at_selection();
  /// The line under the cursor, with the place on it that is nearest.
  [[nodiscard]] const std::optional<canvas::Snap>& hovered() const { return hovered_; }

  /// What is selected from now on; lines that are not there any more are left out.
  void select(canvas::Selection selection);
  /// The same, and whoever shows what is selected hears of it.
  void choose(canvas::Selection selection) {
    select(std::move(selection));
    emit lines_changed();
  }

  /// As if the tool in hand had made it.
  void carry_out(const canvas::Edited& edited);

 signals:
  /// What the tool waits for; until the next click or key why it has done nothing.
  void told(const QString& message);
  /// The dip of the line under the cursor; empty where there is none.
  void over_line(const QString& dip);
  /// Select is to be taken up.
  void put_away();
  void hide_asked(const QString& panel, const QString& layer);
  /// The line called `name`, in the table of the input that is named, is to have another name, or be of another kind.
  void rename_asked(const QString& table, const QString& name);
  /// Something is being drawn now, or is no more.
  void unfinished_changed();
  /// Other lines are there now, or other ones are selected.
  void lines_changed();
  /// What only the user can decide.
  void asked(const dobra::canvas::Asked& what);
  /// The lines of these files are the document's own now.
  void taken_in(const std::vector<std::string>& files);
  /// Something was drawn that the user must say what it is.
  void drawn(const dobra::canvas::Drawn& what);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Sheet;
  static QString text_of(const std::string& source) { return QString::fromStdString(source); }
  static constexpr double reach = 8.0;  ///< Pixels round the cursor.
  [[nodiscard]] std::optional<canvas::Pointer> pointer_at(QPointF pixel, Qt::KeyboardModifiers keys, bool pressed);
  bool mouse(QMouseEvent& event, QEvent::Type type);
  bool key_press(int key, const QString& typed);
  [[nodiscard]] static std::optional<canvas::Key> key_of(int key);
  void open_entry(const QString& typed);
  bool entry_key(const QEvent& event);
  void enter();
  void carry_out();
  void carry_out(const std::vector<canvas::Change>& changes);
  void use_panel(std::size_t panel);
  [[nodiscard]] std::string name_in_input(const scene::Pick& pick) const;
  void use_unit();
  void hover(const QMouseEvent& event);
  void forget_hover();
  void show_menu(QPoint global);
  void carry_out(view::LineCommand command, const canvas::Snap& on);
  void work_on(canvas::LineWork work, const canvas::Snap& on);
  void take_in_hand(std::unique_ptr<canvas::Tool> tool);
  void hear(const canvas::Pointed& pointed);

  Session& session_;
  VtkWidget& view_;
  Sheet* sheet_ = nullptr;
  QLineEdit* entry_ = nullptr;
  std::unique_ptr<canvas::Tool> tool_;
  std::unique_ptr<canvas::Tool> waiting_;  ///< The tool in hand before somebody asked for a place.
  Answer answer_;
  canvas::Workspace work_;
  documents::OutcomePtr base_;                     ///< Of the document that is edited; not of an edit under way.
  std::shared_ptr<const scene::Picture> picture_;  ///< What is shown of it.
  QString said_;                                   ///< Stands in the place of the hint.
  std::size_t panel_ = 0;
  std::set<std::string> hidden_;
  canvas::Selection told_selection_;
  std::optional<canvas::Pointer> pointer_;
  std::optional<canvas::Snap> hovered_;
  bool snapping_ = true;
  bool angles_ = false;
  bool grid_snapping_ = false;
  bool previewed_ = false;
  std::optional<geom::Polyline> being_named_;  ///< Drawn, while the window asks what it is.
  bool was_unfinished_ = false;
};

}  // namespace dobra::gui
