#include "shared/gui/canvas.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/canvas/rounding.h"
#include "shared/canvas/selecting.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/documents/line_entries.h"
#include "shared/gui/documents/shown.h"
#include "shared/gui/messages.h"
#include "shared/gui/sheet/overlay_painter.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/theme/icons.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::gui {

namespace {

constexpr double reach = 8.0;             ///< Pixels round the cursor.
constexpr double selection_margin = 0.1;  ///< Round what is zoomed to.

using canvas::rounded;

QCursor cursor_of(canvas::Cursor cursor) {
  if (cursor == canvas::Cursor::Arrow) return Qt::ArrowCursor;
  if (cursor == canvas::Cursor::Hand) return Qt::OpenHandCursor;
  constexpr int side = 24;
  constexpr int glass = 9;
  if (cursor == canvas::Cursor::Magnifier)
    return QCursor(theme::icon(theme::Symbol::ZoomWindow).pixmap(side, side), glass, glass);
  return Qt::CrossCursor;
}

QString text_of(const std::string& source) { return QString::fromStdString(source); }

}  // namespace

/// Lies over the view; what it draws leaves the picture as it is.
class Canvas::Sheet : public QWidget {
 public:
  Sheet(Canvas& canvas, VtkWidget& view) : QWidget(&view), canvas_(canvas), view_(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    resize(view.size());
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const std::size_t panel = canvas_.panel_;
    if (canvas_.work_.empty() || panel >= view_.panel_count() || !view_.is_ready()) return;
    QPainter painter(this);
    const sheet::Plot plot{view_.plot(panel), [&](geom::Point p) { return view_.pixel_of(panel, p); }};
    sheet::OverlayPainter over(painter, plot, view_.colors());
    if (canvas_.tool_->cursor() == canvas::Cursor::Arrow && canvas_.hovered_ && canvas_.hovered_->on) {
      const geom::Polyline* line = canvas_.work_.line(*canvas_.hovered_->on);
      if (line != nullptr) over.glow(*line);  // where a click selects
    }
    const bool snapped = canvas_.pointer_ && canvas_.pointer_->snap;
    canvas::Overlay overlay = canvas_.tool_->overlay(canvas_.work_);
    if (canvas_.being_named_) overlay.lines.push_back(*canvas_.being_named_);
    over.draw(overlay, snapped ? &*canvas_.pointer_->snap : nullptr);
  }

 private:
  Canvas& canvas_;
  VtkWidget& view_;
};

Canvas::Canvas(Session& session, VtkWidget& view, QObject* parent)
    : QObject(parent), session_(session), view_(view), tool_(canvas::make_select_tool()) {
  sheet_ = new Sheet(*this, view);
  entry_ = new QLineEdit(&view);
  entry_->setAccessibleName(text("Place"));
  entry_->setFixedWidth(220);
  entry_->hide();
  entry_->installEventFilter(this);
  view.installEventFilter(this);
  connect(&view, &VtkWidget::view_changed, sheet_, qOverload<>(&QWidget::update));
  connect(&view, &VtkWidget::view_changed, this, &Canvas::use_unit);
}

Canvas::~Canvas() = default;

void Canvas::take_up(std::unique_ptr<canvas::Tool> tool) {
  if (waiting_) tool_ = std::exchange(waiting_, nullptr);
  if (!work_.empty()) tool_->put_down(work_);
  carry_out();
  if (previewed_) session_.run();
  previewed_ = false;
  pointer_.reset();
  entry_->hide();
  take_in_hand(std::move(tool));
}

void Canvas::take_in_hand(std::unique_ptr<canvas::Tool> tool) {
  tool_ = std::move(tool);
  forget_hover();
  view_.set_hand(tool_->cursor() == canvas::Cursor::Hand);
  view_.set_tool_cursor(cursor_of(tool_->cursor()));
  said_.clear();
  show_hint();
}

void Canvas::ask_for_place(const QString& hint, Answer answer) {
  if (!waiting_) waiting_ = std::exchange(tool_, nullptr);
  answer_ = std::move(answer);
  take_in_hand(canvas::make_point_tool(hint.toStdString()));
  view_.setFocus();
}

void Canvas::hear(const canvas::Pointed& pointed) {
  const QString refused = answer_ ? answer_(pointed) : QString();
  if (!refused.isEmpty()) return say(refused);
  if (waiting_) take_in_hand(std::exchange(waiting_, nullptr));
}

bool Canvas::take_back() {
  const bool taken = !work_.empty() && tool_->take_back(work_);
  carry_out();
  show_hint();
  return taken;
}

void Canvas::say(const QString& message) {
  said_ = message;
  show_hint();
}

void Canvas::show_hint() {
  QString hint = text_of(tool_->hint());
  if (const QString height = text_of(session_.program().drawing.height); height != "z")
    hint.replace("x,z", "x," + height).replace("@dx,dz", "@dx,d" + height);
  emit told(said_.isEmpty() ? hint : said_);
  if (std::exchange(was_unfinished_, unfinished()) != unfinished()) emit unfinished_changed();
  if (told_selection_ != work_.selection) {
    told_selection_ = work_.selection;
    emit lines_changed();
  }
  sheet_->update();
}

void Canvas::tell_pick(const QString& what) {
  if (tool_->cursor() == canvas::Cursor::Arrow && said_.isEmpty()) say(what);
}

void Canvas::show_outcome(std::shared_ptr<const scene::Picture> picture) {
  const documents::OutcomePtr& outcome = session_.outcome();
  if (!outcome || outcome->document != session_.history().current()) return;
  const bool of_selection = !said_.isEmpty() && said_ == text_of(canvas::selection_text(work_));
  base_ = outcome;
  picture_ = std::move(picture);
  previewed_ = false;
  use_panel(panel_ < picture_->panels.size() ? panel_ : 0);
  if (of_selection) said_ = text_of(canvas::selection_text(work_));  // its length may be another now
  show_hint();
}

void Canvas::show_sheet() {
  base_.reset();
  picture_.reset();
  work_.selection.clear();
  use_panel(0);
}

void Canvas::use_panel(std::size_t panel) {
  panel_ = panel;
  hovered_.reset();
  if (picture_ && panel < picture_->panels.size()) {
    work_.show(picture_, panel, hidden_);
    work_.set_editable(std::nullopt);
    work_.set_names([this](const scene::Pick& pick) { return name_in_input(pick); });
    if (session_.program().drawing.edit && base_->input)
      work_.set_editable(documents::lines_of_input(picture_->panels[panel], *base_));
  } else {  // nothing is there yet: the first line is drawn on an empty sheet
    auto empty = std::make_shared<scene::Picture>();
    empty->panels.resize(panel + 1);
    work_.show(std::move(empty), panel);
    work_.set_editable(std::nullopt);
  }
  use_unit();
  told_selection_ = work_.selection;
  emit lines_changed();
  sheet_->update();
}

/// Of a line that the picture has from the input as it is; empty: it has no name of its own.
std::string Canvas::name_in_input(const scene::Pick& pick) const {
  const auto& name_of = session_.program().drawing.name_of;
  if (!name_of || !base_ || base_->run.states.empty()) return {};
  if (work_.editable() == nullptr || !work_.editable()->contains(pick)) return {};
  return name_of(base_->run.states.front(), documents::of_input(pick));
}

void Canvas::select(canvas::Selection selection) {
  std::erase_if(selection, [&](const auto& line) { return work_.empty() || work_.line(line.first) == nullptr; });
  work_.selection = std::move(selection);
  told_selection_ = work_.selection;
  sheet_->update();
}

void Canvas::use_unit() {
  const bool is_section = session_.program().drawing.height == "z";
  work_.direction = is_section ? canvas::Direction::Dip : canvas::Direction::Angle;
  if (panel_ >= view_.panel_count()) return;
  const scene::Axes& axes = view_.axes(panel_);
  const std::size_t open = axes.x_title.rfind('[');
  const bool has_one = open != std::string::npos && axes.x_title.ends_with(']');
  work_.unit = {has_one ? axes.x_title.substr(open + 1, axes.x_title.size() - open - 2) : "m", axes.unit};
}

void Canvas::set_layer_hidden(const std::string& layer, bool hidden) {
  if (hidden) {
    hidden_.insert(layer);
  } else {
    hidden_.erase(layer);
  }
  use_panel(panel_);
}

std::optional<canvas::Pointer> Canvas::pointer_at(QPointF pixel, Qt::KeyboardModifiers keys, bool pressed) {
  const std::optional<VtkWidget::Spot> spot = view_.spot_at(pixel);
  if (!spot) return std::nullopt;
  // Nobody loses what is selected by moving over another panel.
  const bool stays =
      tool_->last() || (!pressed && tool_->cursor() == canvas::Cursor::Arrow && !work_.selection.empty());
  if ((spot->panel != panel_ && !stays) || work_.empty()) use_panel(spot->panel);
  if (spot->panel != panel_) return std::nullopt;
  const double size = view_.view(panel_).world_per_point;
  canvas::Pointer pointer;
  pointer.exaggeration = view_.exaggeration(panel_);
  const auto& unit_length = session_.program().drawing.unit_length;
  const double unit = unit_length ? unit_length(session_.document()) : 1.0;  // the document's numbers are to be short
  pointer.at = {unit * rounded(spot->at.x / unit, size / unit),
                unit * rounded(spot->at.y / unit, size / pointer.exaggeration / unit)};
  pointer.reach = reach * size;
  if (keys & Qt::ShiftModifier) pointer.modifier = canvas::Modifier::Add;
  if (keys & Qt::ControlModifier) pointer.modifier = canvas::Modifier::Toggle;
  canvas::SnapWish wish{.reach = pointer.reach, .exaggeration = pointer.exaggeration, .from = tool_->last()};
  wish.without = tool_->moving();
  if (grid_snapping_) {
    const geom::Vector step = view_.tick_step(panel_);
    wish.kinds.insert(canvas::SnapKind::Grid);
    wish.grid = step.x;
    wish.grid_y = step.y;
    // A tick that says 0, in sight or not.
    const scene::Axes& axes = view_.axes(panel_);
    if (axes.x_reading) wish.grid_origin.x = axes.x_reading->to_world(0.0);
    if (axes.y_reading) wish.grid_origin.y = axes.y_reading->to_world(0.0);
  }
  if (angles_ != keys.testFlag(Qt::ShiftModifier)) wish.kinds.insert(canvas::SnapKind::Angle);
  if (snapping_ && tool_->snaps() && !keys.testFlag(Qt::AltModifier)) pointer.snap = work_.snaps().at(spot->at, wish);
  return pointer;
}

bool Canvas::mouse(QMouseEvent& event, QEvent::Type type) {
  const bool left = event.button() == Qt::LeftButton;
  // What pans is no click of a tool.
  if (left && type != QEvent::MouseButtonRelease && view_.hand_is_ready()) return false;
  std::optional<canvas::Pointer> pointer =
      pointer_at(event.position(), event.modifiers(), type == QEvent::MouseButtonPress);
  if (type == QEvent::MouseMove) hover(event);
  if (event.button() == Qt::RightButton && type == QEvent::MouseButtonRelease) {
    hover(event);
    show_menu(event.globalPosition().toPoint());
    return true;
  }
  // A gesture that leaves the plot ends where it was last.
  if (!pointer && left && type == QEvent::MouseButtonRelease) pointer = pointer_;
  if (!pointer || (type != QEvent::MouseMove && !left)) return false;
  pointer_ = pointer;
  if (type == QEvent::MouseButtonPress) said_.clear();
  // What is shown meanwhile must not run away from under the cursor.
  if (type == QEvent::MouseButtonPress) view_.hold();
  if (type == QEvent::MouseButtonPress) tool_->press(work_, *pointer);
  if (type == QEvent::MouseMove) tool_->move(work_, *pointer);
  if (type == QEvent::MouseButtonRelease) tool_->release(work_, *pointer);
  if (type == QEvent::MouseButtonDblClick) tool_->double_click(work_, *pointer);
  carry_out();
  const bool selects = tool_->cursor() == canvas::Cursor::Arrow && said_.isEmpty();
  if (selects && type != QEvent::MouseMove) said_ = text_of(canvas::selection_text(work_));
  if (type != QEvent::MouseMove) show_hint();
  sheet_->update();
  return false;
}

std::optional<canvas::Key> Canvas::key_of(int key) {
  switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return canvas::Key::Enter;
    case Qt::Key_Escape:
      return canvas::Key::Escape;
    case Qt::Key_Backspace:
      return canvas::Key::Backspace;
    case Qt::Key_Delete:
      return canvas::Key::Delete;
    default:
      return std::nullopt;
  }
}

bool Canvas::key_press(int key, const QString& typed) {
  if (const std::optional<canvas::Key> known = key_of(key)) {
    said_.clear();
    const bool used = !work_.empty() && tool_->key(work_, *known);
    carry_out();
    show_hint();
    return used;
  }
  const bool starts_place = typed.size() == 1 && QString("0123456789-@.,").contains(typed);
  if (!starts_place || work_.empty() || !tool_->snaps()) return false;
  open_entry(typed);
  return true;
}

void Canvas::open_entry(const QString& typed) {
  entry_->setText(typed);
  const QRectF plot = view_.is_ready() && panel_ < view_.panel_count() ? view_.plot(panel_) : QRectF(view_.rect());
  entry_->move(plot.bottomLeft().toPoint() + QPoint(8, -entry_->height() - 8));  // not over the legend
  entry_->show();
  entry_->raise();
  entry_->setFocus();
}

bool Canvas::entry_key(const QEvent& event) {
  if (event.type() != QEvent::KeyPress) return false;
  const std::optional<canvas::Key> key = key_of(static_cast<const QKeyEvent&>(event).key());
  if (key == canvas::Key::Enter) enter();
  if (key == canvas::Key::Escape) {
    entry_->hide();
    view_.setFocus();
  }
  return key == canvas::Key::Enter || key == canvas::Key::Escape;  // the view below is not to have them too
}

/// Lengths are typed in the unit of the axes, places as the axes say them.
void Canvas::enter() {
  const double unit = work_.unit.size;
  canvas::EntryContext context{.last = tool_->last()};
  if (context.last && pointer_) context.towards = pointer_->at - *context.last;
  if (context.last && unit != 1.0) context.last = geom::Point{context.last->x / unit, context.last->y / unit};
  const std::optional<double> number = base::parse_number(entry_->text().trimmed().replace(',', '.').toStdString());
  const std::optional<geom::Point> meant = number ? tool_->place_of_number(*number) : std::nullopt;
  base::Result<geom::Point> place =
      meant ? base::Result<geom::Point>(*meant) : canvas::parse_entry(entry_->text().toStdString(), context);
  const QString typed_words = entry_->text().trimmed();
  const bool is_place = place && !meant && !number && !typed_words.startsWith('@') && !typed_words.contains('<');
  if (place && !meant && unit != 1.0) place = geom::Point{place->x * unit, place->y * unit};
  if (is_place && panel_ < view_.panel_count()) {
    const scene::Axes& axes = view_.axes(panel_);
    if (axes.x_reading) place->x = axes.x_reading->to_world(place->x / unit);
    if (axes.y_reading) place->y = axes.y_reading->to_world(place->y / unit);
  }
  if (!place) {
    say(text_of(place.error().message));
    return;
  }
  said_.clear();
  entry_->hide();
  view_.setFocus();
  canvas::Pointer typed = pointer_.value_or(canvas::Pointer{});
  typed.at = *place;
  typed.snap.reset();
  tool_->press(work_, typed);
  tool_->release(work_, typed);
  carry_out();
  show_hint();
}

void Canvas::hover(const QMouseEvent& event) {
  const std::optional<VtkWidget::Spot> spot = view_.spot_at(event.position());
  const bool gesture = (event.buttons() & (Qt::LeftButton | Qt::MiddleButton)) != 0;
  if (!spot || spot->panel != panel_ || work_.empty() || gesture) return forget_hover();
  canvas::SnapWish wish{.reach = reach * view_.view(panel_).world_per_point,
                        .exaggeration = view_.exaggeration(panel_),
                        .kinds = {canvas::SnapKind::OnLine}};
  std::optional<canvas::Snap> found = work_.snaps().at(spot->at, wish);
  if (work_.editable() != nullptr) {  // where lines lie over each other, the one that can be worked on
    wish.only = work_.editable();
    if (std::optional<canvas::Snap> ours = work_.snaps().at(spot->at, wish)) found = std::move(ours);
  }
  const bool other = (found ? found->on : std::nullopt) != (hovered_ ? hovered_->on : std::nullopt);
  hovered_ = std::move(found);
  emit over_line(hovered_ ? text_of(canvas::direction_text(work_, *hovered_)) : QString());
  if (other) sheet_->update();
}

void Canvas::forget_hover() {
  if (!hovered_) return;
  hovered_.reset();
  emit over_line({});
  sheet_->update();
}

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

void Canvas::carry_out() { carry_out(tool_->take()); }

void Canvas::carry_out(const std::vector<canvas::Change>& changes) {
  for (const canvas::Change& change : changes) {
    if (const auto* edited = std::get_if<canvas::Edited>(&change)) carry_out(*edited);
    if (const auto* what = std::get_if<canvas::Drawn>(&change)) {
      being_named_ = what->line;
      sheet_->update();
      emit drawn(*what);
      being_named_.reset();
      sheet_->update();
    }
    if (const auto* message = std::get_if<canvas::Told>(&change)) say(text_of(message->message));
    if (const auto* question = std::get_if<canvas::Asked>(&change)) emit asked(*question);
    if (std::holds_alternative<canvas::PutAway>(change)) emit put_away();
    if (const auto* wanted = std::get_if<canvas::LookedAt>(&change)) {
      if (wanted->factor == 1.0)
        view_.look_at(panel_, wanted->box);
      else
        view_.zoom(wanted->factor, view_.pixel_of(panel_, wanted->box.centre()));
    }
    if (const auto* pointed = std::get_if<canvas::Pointed>(&change)) hear(*pointed);
    if (std::holds_alternative<canvas::NotPointed>(change) && waiting_) take_in_hand(std::exchange(waiting_, nullptr));
    if (std::holds_alternative<canvas::Dropped>(change) && std::exchange(previewed_, false)) session_.run();
  }
}

void Canvas::carry_out(const canvas::Edited& edited) {
  const auto& edit = session_.program().drawing.edit;
  if (!edit || !base_ || base_->run.states.empty()) return;
  if (!std::all_of(edited.lines.begin(), edited.lines.end(),
                   [&](const auto& line) { return work_.is_editable(line.pick); })) {
    say(text_of(canvas::made_by_a_step()));
    return;
  }
  std::vector<scene::LineEdit> lines = edited.lines;
  for (scene::LineEdit& line : lines) line.pick = documents::of_input(line.pick);
  base::Result<scenario::Document> document = edit(session_.document(), base_->run.states.front(), lines);
  if (!document) {
    say(in_words(document.error()));
    return;
  }
  previewed_ = edited.stage == canvas::Stage::During;
  if (previewed_) {
    session_.look_at(*std::move(document));
  } else {
    const std::vector<std::string> left = documents::files_left(session_.document(), *document, session_.program());
    session_.edit(*std::move(document), text_of(edited.what));
    if (!left.empty()) emit taken_in(left);
  }
}

bool Canvas::eventFilter(QObject* watched, QEvent* event) {
  if (watched == entry_) return entry_key(*event);
  switch (event->type()) {
    case QEvent::Resize:
      sheet_->resize(view_.size());
      return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      return mouse(*static_cast<QMouseEvent*>(event), event->type());
    case QEvent::ShortcutOverride:  // Escape and Delete belong to the tool before they belong to a menu
      if (key_of(static_cast<QKeyEvent*>(event)->key())) event->accept();
      return false;
    case QEvent::KeyPress: {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key_press(key->key(), key->text())) return true;
      // A key that the tool has no use for is the menu's again.
      if (key->key() == Qt::Key_Escape) session_.cancel();
      return false;
    }
    case QEvent::ContextMenu:
      if (static_cast<QContextMenuEvent*>(event)->reason() == QContextMenuEvent::Keyboard) {
        show_menu(view_.mapToGlobal(view_.rect().center()));
        return true;
      }
      return false;
    case QEvent::Leave:
      pointer_.reset();
      forget_hover();
      sheet_->update();
      return false;
    default:
      return false;
  }
}

}  // namespace dobra::gui
