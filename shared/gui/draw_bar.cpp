#include "shared/gui/draw_bar.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <map>

#include "shared/gui/canvas.h"
#include "shared/gui/documents/line_entries.h"
#include "shared/gui/text.h"

namespace dobra::gui {

namespace {

using canvas::Carrying;
using canvas::Drawing;
using canvas::LineWork;
using Of = scenario::Drawing::Kind::Of;

Of kind_of(canvas::Shape shape) {
  switch (shape) {
    case canvas::Shape::Polygon:
      return Of::Polygons;
    case canvas::Shape::Point:
      return Of::Points;
    case canvas::Shape::Line:
      break;
  }
  return Of::Lines;
}

}  // namespace

DrawBar::DrawBar(Session& session, Canvas& canvas, QMenu& menu, QWidget* parent)
    : QToolBar(text("Draw"), parent), session_(session), canvas_(canvas), tools_(new QActionGroup(this)) {
  setObjectName("draw_bar");
  setIconSize({20, 20});
  setMovable(false);
  add_tool(menu, "select", text("Select"), theme::Symbol::Select, QKeySequence(Qt::Key_S), canvas::make_select_tool);
  add_tool(menu, "measure", text("Measure"), theme::Symbol::Measure, QKeySequence(Qt::Key_M),
           canvas::make_measure_tool);
  add_tool(menu, "hand", text("Hand"), theme::Symbol::Hand, QKeySequence(Qt::Key_H), canvas::make_hand_tool);
  add_tool(menu, "zoom", text("Zoom to a box"), theme::Symbol::ZoomWindow, QKeySequence(Qt::Key_Z),
           canvas::make_zoom_tool);
  if (session.program().drawing.add) {
    addSeparator();
    menu.addSeparator();
    add_tool(menu, "line", text("Line"), theme::Symbol::Line, QKeySequence(Qt::Key_L),
             [] { return canvas::make_draw_tool(Drawing::Line); });
    add_tool(menu, "polygon", text("Polygon"), theme::Symbol::Polygon, QKeySequence(Qt::Key_P),
             [] { return canvas::make_draw_tool(Drawing::Polygon); });
    add_tool(menu, "rectangle", text("Rectangle"), theme::Symbol::Rectangle, QKeySequence(Qt::Key_R),
             [] { return canvas::make_draw_tool(Drawing::Rectangle); });
    add_tool(menu, "circle", text("Circle"), theme::Symbol::Circle, QKeySequence(Qt::Key_C),
             [] { return canvas::make_draw_tool(Drawing::Circle); });
    add_tool(menu, "point", text("Point"), theme::Symbol::Point, QKeySequence(Qt::Key_O),
             [] { return canvas::make_draw_tool(Drawing::Point); });
  }
  if (session.program().drawing.edit) {
    addSeparator();
    menu.addSeparator();
    add_tool(menu, "insert_vertex", text("Insert vertex"), theme::Symbol::InsertVertex, QKeySequence(Qt::Key_I),
             [] { return canvas::make_line_tool(LineWork::InsertVertex); });
    add_tool(menu, "split", text("Split line"), theme::Symbol::Split, QKeySequence(Qt::Key_X),
             [] { return canvas::make_line_tool(LineWork::Split); });
    add_tool(menu, "join", text("Join lines"), theme::Symbol::Join, QKeySequence(Qt::Key_J),
             [] { return canvas::make_line_tool(LineWork::Join); });
    add_tool(menu, "extend", text("Extend line"), theme::Symbol::Extend, QKeySequence(Qt::Key_E),
             [] { return canvas::make_line_tool(LineWork::Extend); });
    add_tool(menu, "trim", text("Trim line"), theme::Symbol::Trim, QKeySequence(Qt::Key_T),
             [] { return canvas::make_line_tool(LineWork::Trim); });
    addSeparator();
    menu.addSeparator();
    add_tool(menu, "move", text("Move lines"), theme::Symbol::Move, QKeySequence(Qt::Key_G),
             [] { return canvas::make_carry_tool(Carrying::Move); });
    add_tool(menu, "rotate", text("Rotate lines"), theme::Symbol::Rotate, QKeySequence(Qt::Key_A),
             [] { return canvas::make_carry_tool(Carrying::Rotate); });
    add_tool(menu, "mirror", text("Mirror lines"), theme::Symbol::Mirror, QKeySequence(Qt::Key_W),
             [] { return canvas::make_carry_tool(Carrying::Mirror); });
    add_tool(menu, "copy", text("Copy lines"), theme::Symbol::Copy, QKeySequence(Qt::Key_D),
             [] { return canvas::make_carry_tool(Carrying::Copy); });
  }
  add_switches(menu, canvas);
  tools_->actions().front()->setChecked(true);
  connect(&canvas, &Canvas::drawn, this, &DrawBar::ask);
  connect(&canvas, &Canvas::asked, this, &DrawBar::ask_which);
  connect(&canvas, &Canvas::put_away, this, [this] { take_up("select"); });
  connect(&canvas, &Canvas::rename_asked, this, &DrawBar::ask_name);
}

void DrawBar::add_tool(QMenu& menu, const char* name, const QString& words, theme::Symbol symbol,
                       const QKeySequence& keys, Make make) {
  QAction* made = menu.addAction(theme::icon(symbol), words);
  made->setObjectName(QString("draw.") + name);
  made->setCheckable(true);
  made->setShortcut(keys);
  made->setToolTip(QString("%1 (%2)").arg(words, keys.toString(QKeySequence::NativeText)));
  tools_->addAction(made);
  addAction(made);
  connect(made, &QAction::triggered, this, [this, make] { canvas_.take_up(make()); });
}

void DrawBar::add_switches(QMenu& menu, Canvas& canvas) {
  addSeparator();
  menu.addSeparator();
  QAction* snap = menu.addAction(theme::icon(theme::Symbol::Snap), text("Snap to lines"));
  snap->setObjectName("draw.snap");
  snap->setCheckable(true);
  snap->setChecked(true);
  snap->setShortcut(QKeySequence(Qt::Key_F3));
  snap->setToolTip(text("Snap to vertices, crossings and lines (F3); not while Alt is held"));
  addAction(snap);
  connect(snap, &QAction::toggled, &canvas, &Canvas::set_snapping);
  QAction* grid = menu.addAction(text("Snap to the grid"));
  grid->setObjectName("draw.grid");
  grid->setCheckable(true);
  grid->setShortcut(QKeySequence(Qt::Key_F4));
  connect(grid, &QAction::toggled, &canvas, &Canvas::set_grid_snapping);
  QAction* angles = menu.addAction(text("Draw at multiples of 15°"));
  angles->setObjectName("draw.angles");
  angles->setCheckable(true);
  angles->setShortcut(QKeySequence(Qt::Key_F8));
  connect(angles, &QAction::toggled, &canvas, &Canvas::set_angles);
}

bool DrawBar::take_up(const QString& name) {
  const QList<QAction*> actions = tools_->actions();
  const auto found = std::find_if(actions.begin(), actions.end(),
                                  [&](const QAction* action) { return action->objectName() == "draw." + name; });
  if (found == actions.end()) return false;
  (*found)->trigger();
  return true;
}

void DrawBar::ask(const canvas::Drawn& what) {
  std::vector<scenario::Drawing::Kind> kinds = session_.program().drawing.kinds;
  std::erase_if(kinds, [&](const auto& kind) { return kind.of != kind_of(what.shape); });
  if (kinds.empty()) {
    canvas_.say(text("This cannot be drawn here: the document has no place for it."));
    return;
  }
  const auto add = [&](const std::string& kind, const std::string& name) -> base::Result<void> {
    DOBRA_TRY(scenario::Document document, session_.program().drawing.add(session_.document(), kind, name, what.line));
    session_.edit(std::move(document), text("Draw '%1'").arg(QString::fromStdString(name)));
    return {};
  };
  NewLine question(std::move(kinds), last_kind_, add, this);
  question.propose(QString::fromStdString(what.name));
  if (question.exec() == QDialog::Accepted) last_kind_ = question.kind();
}

void DrawBar::ask_name(const QString& table, const QString& name) {
  const scenario::Program& program = session_.program();
  std::vector<scenario::Drawing::Kind> kinds = program.drawing.kinds;
  const std::string before = table.toStdString();
  const auto own = std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.table == before; });
  if (own == kinds.end()) return;
  const Of of = own->of;
  std::erase_if(kinds, [&](const auto& kind) { return kind.of != of; });
  const auto change = [&](const std::string& kind, const std::string& to) -> base::Result<void> {
    DOBRA_TRY(scenario::Document document,
              documents::with_line_renamed(session_.document(), program, before, name.toStdString(), to));
    DOBRA_TRY(document, documents::with_line_of_kind(std::move(document), program, before, to, kind));
    session_.edit(std::move(document), text("Rename '%1'").arg(name));
    return {};
  };
  NewLine question(std::move(kinds), before, change, this);
  question.setWindowTitle(text("Name and kind"));
  question.propose(name);
  question.call_button(text("Change"));
  question.exec();
}

void DrawBar::ask_which(const canvas::Asked& what) {
  QMessageBox box(QMessageBox::Question, QString::fromStdString(session_.program().title),
                  QString::fromStdString(what.question), QMessageBox::NoButton, this);
  std::map<const void*, const canvas::Edited*> answers;
  for (const auto& [words, edited] : what.answers)
    answers[box.addButton(QString::fromStdString(words).replace("&", "&&"), QMessageBox::AcceptRole)] = &edited;
  box.addButton(text("Cancel"), QMessageBox::RejectRole);
  box.exec();
  const auto answer = answers.find(box.clickedButton());
  if (answer != answers.end()) canvas_.carry_out(*answer->second);
}

NewLine::NewLine(std::vector<scenario::Drawing::Kind> kinds, const std::string& chosen,
                 std::function<base::Result<void>(const std::string&, const std::string&)> add, QWidget* parent)
    : QDialog(parent), kinds_(std::move(kinds)), add_(std::move(add)) {
  setWindowTitle(text("What was drawn?"));
  setMinimumWidth(380);
  auto* rows = new QFormLayout(this);
  kind_ = new QComboBox(this);
  for (const scenario::Drawing::Kind& kind : kinds_) {
    kind_->addItem(text(kind.title.c_str()));
    if (kind.table == chosen) kind_->setCurrentIndex(kind_->count() - 1);
  }
  name_ = new QLineEdit(this);
  refused_ = new QLabel(this);
  refused_->setWordWrap(true);
  name_->setObjectName("name");
  refused_->setObjectName("refused");
  refused_->hide();
  rows->addRow(text("Kind"), kind_);
  rows->addRow(text("Name"), name_);
  rows->addRow(refused_);
  auto* buttons = new QDialogButtonBox(this);
  add_button_ = buttons->addButton(text("Add"), QDialogButtonBox::AcceptRole);
  add_button_->setDefault(true);
  buttons->addButton(text("Discard"), QDialogButtonBox::RejectRole);
  rows->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &NewLine::try_to_add);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  name_->setFocus();
}

void NewLine::propose(const QString& name) {
  name_->setText(name);
  name_->selectAll();
}

void NewLine::call_button(const QString& words) { add_button_->setText(words); }

std::string NewLine::kind() const { return kinds_[static_cast<std::size_t>(kind_->currentIndex())].table; }

void NewLine::try_to_add() {
  const base::Result<void> added = add_(kind(), name_->text().toStdString());
  if (added) return accept();
  refused_->setText(QString::fromStdString(added.error().message));
  adjustSize();
  refused_->show();
  name_->setFocus();
}

}  // namespace dobra::gui
