#include "shared/gui/draw_bar.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <map>

#include "shared/gui/canvas.h"
#include "shared/gui/catalogue/catalogue.h"
#include "shared/gui/documents/line_entries.h"
#include "shared/gui/text.h"
#include "shared/scenario/entries.h"

namespace dobra::gui {

namespace {

constexpr int most_copies = 1000;

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

/// Whether the section as it was read has a line called so that the document itself does not hold: one of a file.
bool is_read_from_file(const Session& session, const std::string& kind, const std::string& name) {
  const scenario::Program& program = session.program();
  const auto own = std::find_if(program.drawing.kinds.begin(), program.drawing.kinds.end(),
                                [&](const auto& each) { return each.table == kind; });
  const documents::OutcomePtr& outcome = session.outcome();
  if (own == program.drawing.kinds.end() || own->names.empty() || !program.names_of) return false;
  if (!outcome || outcome->run.states.empty()) return false;
  const std::vector<std::string> names = program.names_of(outcome->run.states.front(), own->names);
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

DrawBar::DrawBar(const Desk& desk, const std::vector<ToolPart>& of_program, actions::Registry& actions, QWidget* parent)
    : QToolBar(text("Draw"), parent),
      session_(desk.session),
      canvas_(desk.canvas),
      actions_(actions),
      in_hand_("draw.select") {
  setObjectName("draw_bar");
  setIconSize({20, 20});
  setMovable(false);
  add_tools();
  add_tools(of_program);
  add_tools_of_lines();
  add_switches();
  actions_.fill(*this, "draw_bar");
  connect(&canvas_, &Canvas::drawn, this, &DrawBar::ask);
  connect(&canvas_, &Canvas::asked, this, &DrawBar::ask_which);
  connect(&canvas_, &Canvas::put_away, this, [this] { actions_.trigger("draw.select"); });
  connect(&canvas_, &Canvas::rename_asked, this, &DrawBar::ask_name);
}

void DrawBar::add_tools() {
  add_tool("look", "select", "Select", theme::Symbol::Select, Qt::Key_S, canvas::make_select_tool);
  add_tool("look", "measure", "Measure", theme::Symbol::Measure, Qt::Key_M, canvas::make_measure_tool);
  add_tool("look", "hand", "Hand", theme::Symbol::Hand, Qt::Key_H, canvas::make_hand_tool);
  add_tool("look", "zoom", "Zoom to a box", theme::Symbol::ZoomWindow, Qt::Key_Z, canvas::make_zoom_tool);
  if (session_.program().drawing.add) {
    add_tool("draw", "line", "Line", theme::Symbol::Line, Qt::Key_L,
             [] { return canvas::make_draw_tool(Drawing::Line); });
    add_tool("draw", "polygon", "Polygon", theme::Symbol::Polygon, Qt::Key_P,
             [] { return canvas::make_draw_tool(Drawing::Polygon); });
    add_tool("draw", "rectangle", "Rectangle", theme::Symbol::Rectangle, Qt::Key_R,
             [] { return canvas::make_draw_tool(Drawing::Rectangle); });
    add_tool("draw", "circle", "Circle", theme::Symbol::Circle, Qt::Key_C,
             [] { return canvas::make_draw_tool(Drawing::Circle); });
    add_tool("draw", "point", "Point", theme::Symbol::Point, Qt::Key_O,
             [] { return canvas::make_draw_tool(Drawing::Point); });
  }
}

void DrawBar::add_tools(const std::vector<ToolPart>& of_program) {
  const Desk desk{session_, canvas_};
  for (const ToolPart& tool : of_program) {
    QList<QKeySequence> keys;
    if (!tool.key.isEmpty()) keys.push_back(tool.key);
    add_tool(tool.name, [desk, make = tool.make] { return make(desk); },
             {.text = tool.text, .help = tool.help, .section = "program", .icon = tool.icon, .keys = std::move(keys)});
  }
}

void DrawBar::add_tools_of_lines() {
  if (!session_.program().drawing.edit) return;
  add_tool("vertices", "insert_vertex", "Insert vertex", theme::Symbol::InsertVertex, Qt::Key_I,
           [] { return canvas::make_line_tool(LineWork::InsertVertex); });
  add_tool("vertices", "split", "Split line", theme::Symbol::Split, Qt::Key_X,
           [] { return canvas::make_line_tool(LineWork::Split); });
  add_tool("vertices", "join", "Join lines", theme::Symbol::Join, Qt::Key_J,
           [] { return canvas::make_line_tool(LineWork::Join); });
  add_tool("vertices", "extend", "Extend line", theme::Symbol::Extend, Qt::Key_E,
           [] { return canvas::make_line_tool(LineWork::Extend); });
  add_tool("vertices", "trim", "Trim line", theme::Symbol::Trim, Qt::Key_T,
           [] { return canvas::make_line_tool(LineWork::Trim); });
  add_tool("carry", "move", "Move lines", theme::Symbol::Move, Qt::Key_G,
           [] { return canvas::make_carry_tool(Carrying::Move); });
  add_tool("carry", "rotate", "Rotate lines", theme::Symbol::Rotate, Qt::Key_A,
           [] { return canvas::make_carry_tool(Carrying::Rotate); });
  add_tool("carry", "mirror", "Mirror lines", theme::Symbol::Mirror, Qt::Key_W,
           [] { return canvas::make_carry_tool(Carrying::Mirror); });
  add_tool("carry", "copy", "Copy lines", theme::Symbol::Copy, Qt::Key_D,
           [] { return canvas::make_carry_tool(Carrying::Copy); });
}

void DrawBar::add_tool(const char* section, const char* name, const char* words, theme::Symbol symbol, int key,
                       Make make) {
  add_tool(name, std::move(make), {.text = words, .section = section, .symbol = symbol, .keys = {QKeySequence(key)}});
}

void DrawBar::add_tool(const std::string& name, Make make, actions::Action action) {
  action.id = "draw." + name;
  action.menu = "&Draw";
  action.bar = "draw_bar";
  action.run = [this, id = action.id, make = std::move(make)] {
    in_hand_ = id;
    canvas_.take_up(make());
  };
  action.checked = [this, id = action.id] { return in_hand_ == id; };
  action.choice = "draw";
  actions_.add(std::move(action));
}

void DrawBar::add_switches() {
  actions_.add({.id = "draw.snap",
                .text = "Snap to lines",
                .help = "Snap to vertices, crossings and lines; not while Alt is held",
                .menu = "&Draw",
                .section = "switches",
                .bar = "draw_bar",
                .symbol = theme::Symbol::Snap,
                .keys = {QKeySequence(Qt::Key_F3)},
                .run = [this] { canvas_.set_snapping(!canvas_.snapping()); },
                .checked = [this] { return canvas_.snapping(); }});
  actions_.add({.id = "draw.grid",
                .text = "Snap to the grid",
                .help = "Places that meet nothing else go to the crossings of the ticks of the axes",
                .menu = "&Draw",
                .section = "switches",
                .keys = {QKeySequence(Qt::Key_F4)},
                .run = [this] { canvas_.set_grid_snapping(!canvas_.grid_snapping()); },
                .checked = [this] { return canvas_.grid_snapping(); }});
  actions_.add({.id = "draw.angles",
                .text = "Draw at multiples of 15°",
                .menu = "&Draw",
                .section = "switches",
                .keys = {QKeySequence(Qt::Key_F8)},
                .run = [this] { canvas_.set_angles(!canvas_.angles()); },
                .checked = [this] { return canvas_.angles(); }});
}

void DrawBar::ask(const canvas::Drawn& what) {
  std::vector<scenario::Drawing::Kind> kinds = session_.program().drawing.kinds;
  std::erase_if(kinds, [&](const auto& kind) { return kind.of != kind_of(what.shape); });
  if (kinds.empty()) {
    canvas_.say(text("This cannot be drawn here: the document has no place for it."));
    return;
  }
  const auto add = [&](const std::string& kind, const std::string& name) -> base::Result<void> {
    if (is_read_from_file(session_, kind, name))
      return scenario::edit_refused(name, "another one has this name already; give another name");
    DOBRA_TRY(scenario::Document document, session_.program().drawing.add(session_.document(), kind, name, what.line));
    session_.edit(std::move(document), text("Draw '%1'").arg(QString::fromStdString(name)));
    return {};
  };
  const auto last =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.table == last_kind_; });
  const std::string likely = last == kinds.end() ? kinds.front().table : last->table;
  // A line that was pasted beside the one that it was copied from takes the next free name.
  const auto is_free = [&](const std::string& name) {
    return !is_read_from_file(session_, likely, name) &&
           session_.program().drawing.add(session_.document(), likely, name, what.line).ok();
  };
  std::string name = what.name;
  if (!name.empty() && !is_free(name)) {
    for (int copy = 2; copy < most_copies && name == what.name; ++copy) {
      std::string next = what.name + " (" + std::to_string(copy) + ")";
      if (is_free(next)) name = std::move(next);
    }
  }
  NewLine question(std::move(kinds), last_kind_, add, this);
  question.propose(QString::fromStdString(name));
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
  refused_->setText(catalogue::translated(QString::fromStdString(added.error().message)));
  adjustSize();
  refused_->show();
  name_->setFocus();
}

}  // namespace dobra::gui
