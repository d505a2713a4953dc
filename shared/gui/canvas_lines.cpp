// What the canvas does with the lines that are selected: the clipboard, the menu of a line, and looking at them.
#include <QApplication>
#include <QClipboard>
#include <algorithm>

#include "shared/base/text.h"
#include "shared/canvas/selecting.h"
#include "shared/gui/canvas.h"
#include "shared/gui/documents/line_entries.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::gui {

namespace {

constexpr double selection_margin = 0.1;  ///< Round what is zoomed to.

}  // namespace

void Canvas::select_all() {
  work_.selection = canvas::all_lines(work_);
  say(text_of(canvas::selection_text(work_)));
}

void Canvas::invert_selection() {
  work_.selection = canvas::other_lines(work_);
  say(text_of(canvas::selection_text(work_)));
}

void Canvas::copy() {
  const std::vector<canvas::NamedLine> lines = canvas::selected_lines(work_);
  if (lines.empty()) return say(text("Nothing is selected: take up Select (S) and click a line first."));
  QApplication::clipboard()->setText(text_of(canvas::text_of_lines(lines)));
  say(text("Lines copied: %1; Ctrl+V draws them in any window, and a spreadsheet takes them.").arg(lines.size()));
}

void Canvas::cut() {
  copy();
  canvas::Edited edited{{}, base::translated("Cut lines"), canvas::Stage::Done};
  for (const auto& [pick, vertices] : std::exchange(work_.selection, {})) edited.lines.push_back({pick, {}});
  if (!edited.lines.empty()) carry_out(edited);
  sheet_->update();
}

void Canvas::paste() {
  const base::Result<std::vector<canvas::NamedLine>> lines =
      canvas::lines_of_text(QApplication::clipboard()->text().toStdString());
  if (!lines) return say(text_of(lines.error().message));
  for (const canvas::NamedLine& line : *lines) {
    const canvas::Shape shape = line.line.closed               ? canvas::Shape::Polygon
                                : line.line.points.size() == 1 ? canvas::Shape::Point
                                                               : canvas::Shape::Line;
    emit drawn(canvas::Drawn{shape, line.line, line.name});
  }
}

void Canvas::look_at_selection() {
  const geom::Box box = canvas::selection_box(work_);
  if (box.empty() || !view_.is_ready() || panel_ >= view_.panel_count())
    return say(text("Nothing is selected: take up Select (S) and click a line first."));
  view_.look_at(panel_, box.grown(selection_margin * std::max(box.width(), box.height())));
}

/// For the line under the cursor, which is selected then.
void Canvas::show_menu(QPoint global) {
  if (work_.empty()) return;
  std::optional<canvas::Snap> on = hovered_;
  if (!on && work_.selection.size() == 1) {  // from the keyboard
    const scene::Pick& pick = work_.selection.begin()->first;
    if (const geom::Polyline* line = work_.line(pick))
      on = canvas::Snap{canvas::SnapKind::OnLine, line->points.front(), pick, 0};
  }
  if (!on || !on->on) return;
  using view::LineCommand;
  std::set<LineCommand> possible{LineCommand::ZoomTo, LineCommand::HideLayer, LineCommand::Copy};
  const std::string title = work_.title(*on->on);
  if (session_.program().drawing.edit && work_.is_editable(*on->on)) {
    possible.insert({LineCommand::Delete, LineCommand::InsertVertex, LineCommand::SplitHere});
    if (documents::table_of_line(session_.document(), session_.program(), title))
      possible.insert({LineCommand::Rename, LineCommand::Kind});
  }
  if (!work_.selection.contains(*on->on)) work_.selection = {{*on->on, {}}};
  say(text_of(canvas::selection_text(work_)));
  view::show_line_menu(text_of(work_.name(*on->on)), possible, global, &view_,
                       [this, on = *on](LineCommand command) { carry_out(command, on); });
}

void Canvas::carry_out(view::LineCommand command, const canvas::Snap& on) {
  using view::LineCommand;
  if (work_.empty() || work_.line(*on.on) == nullptr) return;  // a run has taken it away meanwhile
  switch (command) {
    case LineCommand::Rename:
    case LineCommand::Kind: {
      const std::string name = work_.title(*on.on);
      if (const auto table = documents::table_of_line(session_.document(), session_.program(), name))
        emit rename_asked(text_of(*table), text_of(name));
      break;
    }
    case LineCommand::Delete: {
      canvas::Edited edited{{}, base::translated("Delete lines"), canvas::Stage::Done};
      for (const auto& [pick, vertices] : std::exchange(work_.selection, {})) edited.lines.push_back({pick, {}});
      carry_out(edited);
      break;
    }
    case LineCommand::SplitHere:
      work_on(canvas::LineWork::Split, on);
      break;
    case LineCommand::InsertVertex:
      work_on(canvas::LineWork::InsertVertex, on);
      break;
    case LineCommand::Copy:
      copy();
      break;
    case LineCommand::ZoomTo:
      look_at_selection();
      break;
    case LineCommand::HideLayer:
      emit hide_asked(text_of(work_.panel().key), text_of(on.on->layer));
      break;
  }
  sheet_->update();
}

/// As a click with that tool there does.
void Canvas::work_on(canvas::LineWork work, const canvas::Snap& on) {
  const std::unique_ptr<canvas::Tool> tool = canvas::make_line_tool(work);
  canvas::Pointer pointer{.at = on.at, .snap = on};
  pointer.exaggeration = view_.exaggeration(panel_);
  pointer.reach = reach * view_.view(panel_).world_per_point;
  tool->press(work_, pointer);
  carry_out(tool->take());
}

}  // namespace dobra::gui
