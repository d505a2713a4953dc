#include "shared/gui/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "shared/gui/canvas.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/draw_bar.h"
#include "shared/gui/error_bar.h"
#include "shared/gui/file_filter.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/messages.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/results.h"
#include "shared/gui/status_line.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/theme/icons.h"
#include "shared/gui/vtk_widget.h"
#include "shared/render/cairo.h"

namespace dobra::gui {

struct MainWindow::Actions {
  QAction* open = nullptr;
  QAction* save = nullptr;
  QAction* save_as = nullptr;
  QAction* save_picture = nullptr;
  QAction* quit = nullptr;
  QAction* undo = nullptr;
  QAction* redo = nullptr;
  QAction* fit = nullptr;
  QAction* run = nullptr;
  QAction* cancel = nullptr;
  QAction* about = nullptr;
  QAction* play = nullptr;
  QAction* step = nullptr;
  QAction* stop = nullptr;
};

namespace {

constexpr const char* shown_key = "shown";
constexpr int roomy = 1000;  ///< Pixels of a window that has room for lists on both sides of the picture.

QDockWidget* dock(QMainWindow& window, const QString& title, const char* name, QWidget* content,
                  Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(title, &window);
  made->setObjectName(name);
  made->setWidget(content);
  made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  window.addDockWidget(area, made);
  return made;
}

}  // namespace

MainWindow::MainWindow(const scenario::Program& program, std::string about)
    : program_(program),
      about_(std::move(about)),
      session_(program),
      player_(session_),
      actions_(std::make_unique<Actions>()) {
  QApplication::setPalette(theme::with_quiet_words(QApplication::palette()));
  setWindowIcon(theme::application_icon());
  setAcceptDrops(true);
  resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
  make_center();
  make_docks();
  make_actions();
  make_player_actions();
  make_status_bar();
  connect_session();
  show_nothing();
  show_document();
}

MainWindow::~MainWindow() = default;

void MainWindow::make_center() {
  auto* center = new QWidget(this);
  auto* column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  error_bar_ = new ErrorBar(center);
  view_ = new VtkWidget(center);
  column->addWidget(error_bar_);
  column->addWidget(view_, 1);
  setCentralWidget(center);
  hint_ = new QLabel(program_.drawing.add ? text("Open a scenario (Ctrl+O), drop one here, or draw the first line (L).")
                                          : text("Open a scenario (Ctrl+O), or drop one here."),
                     view_);
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setMargin(100);  // so that it stands between the axes
  hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
  hint_->setStyleSheet("font-size: 12pt; color: " + QColor::fromRgb(theme::paper_quiet).name());
  auto* middle = new QVBoxLayout(view_);
  middle->addWidget(hint_);
  connect(error_bar_, &ErrorBar::show_asked, this, &MainWindow::go_to_error);
  connect(view_, &VtkWidget::cursor_moved, this, [this](const QString& where) { status_->show_place(where); });
  canvas_ = new Canvas(session_, *view_, this);
  connect(view_, &VtkWidget::picked, canvas_, &Canvas::tell_pick);
  connect(canvas_, &Canvas::told, this, [this](const QString& what) { status_->show_hint(what); });
  connect(canvas_, &Canvas::unfinished_changed, this, &MainWindow::show_undo);
}

void MainWindow::make_docks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  steps_ = new StepList(program_, this);
  form_ = new ParameterForm(this);
  layers_ = new LayerTree(this);
  results_ = new Results(this);
  QDockWidget* steps = dock(*this, text("Steps"), "dock.steps", steps_, Qt::LeftDockWidgetArea);
  QDockWidget* form = dock(*this, text("Parameters"), "dock.form", form_, Qt::LeftDockWidgetArea);
  QDockWidget* layers = dock(*this, text("Layers"), "dock.layers", layers_, Qt::RightDockWidgetArea);
  QDockWidget* results = dock(*this, text("Results"), "dock.results", results_, Qt::RightDockWidgetArea);
  resizeDocks({steps, layers}, {300, 300}, Qt::Horizontal);
  resizeDocks({steps, form}, {200, 460}, Qt::Vertical);
  resizeDocks({layers, results}, {270, 390}, Qt::Vertical);
  if (width() < roomy) {  // what does not fit beside the picture is found under tabs
    addDockWidget(Qt::LeftDockWidgetArea, layers);
    addDockWidget(Qt::LeftDockWidgetArea, results);
    tabifyDockWidget(form, layers);
    tabifyDockWidget(layers, results);
    form->raise();
    resizeDocks({steps}, {260}, Qt::Horizontal);
    resizeDocks({steps, form}, {90, 200}, Qt::Vertical);
  }

  connect(steps_, &StepList::selected_changed, this, &MainWindow::show_form);
  connect(steps_, &StepList::add_asked, this, [this](const std::string& operation) {
    form_->form()->commit();
    const std::size_t after = steps_->selected();
    const scenario::Operation* made = program_.find_operation(operation);
    const QString title = text((made != nullptr ? made->title : operation).c_str());
    session_.edit(documents::with_step(session_.document(), after, operation), text("Add '%1'").arg(title));
    steps_->select(after + 1);
  });
  connect(steps_, &StepList::remove_asked, this, [this](std::size_t step) {
    form_->form()->commit();
    session_.edit(documents::without_step(session_.document(), step), text("Remove step %1").arg(step));
  });
  connect(steps_, &StepList::exchange_asked, this, [this](std::size_t step, std::size_t selected) {
    form_->form()->commit();
    session_.edit(documents::with_step_lowered(session_.document(), step),
                  text("Exchange steps %1 and %2").arg(step).arg(step + 1));
    steps_->select(selected);
  });
  connect(form_, &ParameterForm::edited, this, [this](const scenario::Table& table, const QString& key) {
    scenario::Document edited = documents::with_table(session_.document(), form_part_, table);
    const documents::OutcomePtr& outcome = session_.outcome();
    if (form_part_ == 0 && program_.drawing.settle && outcome && !outcome->run.states.empty())
      edited = program_.drawing.settle(session_.document(), std::move(edited), outcome->run.states.front());
    session_.edit(std::move(edited), text("Change '%1'").arg(key));
  });
  connect(layers_, &LayerTree::visibility_changed, view_, &VtkWidget::set_layer_visible);
  connect(layers_, &LayerTree::visibility_changed, this,
          [this](const std::string&, const std::string& layer, bool visible) {
            canvas_->set_layer_hidden(layer, !visible);
          });
}

void MainWindow::make_actions() {
  Actions& a = *actions_;
  QMenu* file = menuBar()->addMenu(text("&File"));
  QMenu* edit = menuBar()->addMenu(text("&Edit"));
  QMenu* draw = menuBar()->addMenu(text("&Draw"));
  QMenu* look = menuBar()->addMenu(text("&View"));
  QMenu* run = menuBar()->addMenu(text("&Run"));
  QMenu* help = menuBar()->addMenu(text("&Help"));
  const auto add = [this](QMenu* menu, const QString& words, const QKeySequence& keys, auto&& action) {
    QAction* made = menu->addAction(words);
    made->setShortcut(keys);
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  a.open = add(file, text("&Open..."), QKeySequence::Open, [this] { ask_open(); });
  recent_ = file->addMenu(text("Open &Recent"));
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fill_recent_menu);
  file->addSeparator();
  a.save = add(file, text("&Save"), QKeySequence::Save, [this] { ask_save(); });
  a.save_as = add(file, text("Save &As..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { ask_save_as(); });
  a.save_picture =
      add(file, text("Save &Picture..."), QKeySequence(Qt::CTRL | Qt::Key_E), [this] { ask_save_picture(); });
  file->addSeparator();
  a.quit = add(file, text("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
  a.undo = add(edit, text("&Undo"), QKeySequence::Undo, [this] { undo(); });
  a.redo = add(edit, text("&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), [this] { session_.redo(); });
  a.redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  a.fit = add(look, text("&Fit"), QKeySequence(Qt::Key_F), [this] { view_->fit(); });
  look->addSeparator();
  for (QDockWidget* each : findChildren<QDockWidget*>()) look->addAction(each->toggleViewAction());
  a.run = add(run, text("&Run"), QKeySequence(Qt::Key_F5), [this] {
    if (settle()) session_.run();
  });
  a.cancel = add(run, text("&Cancel"), QKeySequence(Qt::Key_Escape), [this] { session_.cancel(); });
  a.about = add(help, text("&About %1").arg(QString::fromStdString(program_.title)), {}, [this] { about(); });

  QToolBar* bar = addToolBar(text("Tools"));
  bar->setObjectName("tool_bar");
  bar->setMovable(false);
  bar->setIconSize({22, 22});
  const auto place = [bar](QAction* action, theme::Symbol symbol) {
    action->setIcon(theme::icon(symbol));
    bar->addAction(action);
  };
  place(a.open, theme::Symbol::Open);
  place(a.save, theme::Symbol::Save);
  place(a.save_picture, theme::Symbol::SavePicture);
  bar->addSeparator();
  place(a.undo, theme::Symbol::Undo);
  place(a.redo, theme::Symbol::Redo);
  bar->addSeparator();
  place(a.fit, theme::Symbol::Fit);
  make_shown_actions(*look, *bar);
  bar->addSeparator();
  place(a.run, theme::Symbol::Run);
  place(a.cancel, theme::Symbol::Cancel);
  draw_bar_ = new DrawBar(session_, *canvas_, *draw, this);
  addToolBar(draw_bar_);
}

void MainWindow::make_shown_actions(QMenu& menu, QToolBar& bar) {
  menu.addSeparator();
  auto* group = new QActionGroup(this);
  const auto add = [&](documents::Shown shown, const char* name, const QString& words, int key, theme::Symbol symbol) {
    QAction* made = menu.addAction(theme::icon(symbol), words);
    made->setObjectName(QString("look.") + name);
    made->setCheckable(true);
    made->setChecked(settings().value(shown_key, "result").toString() == name);
    made->setShortcut(QKeySequence(Qt::CTRL | key));
    made->setToolTip(QString("%1 (%2)").arg(words, made->shortcut().toString(QKeySequence::NativeText)));
    if (made->isChecked()) shown_ = shown;
    group->addAction(made);
    bar.addAction(made);
    connect(made, &QAction::triggered, this, [this, shown, name] {
      shown_ = shown;
      settings().setValue(shown_key, name);
      show_picture();
    });
  };
  add(documents::Shown::Input, "input", text("The input"), Qt::Key_1, theme::Symbol::ShowInput);
  add(documents::Shown::Result, "result", text("The result"), Qt::Key_2, theme::Symbol::ShowResult);
  add(documents::Shown::Both, "both", text("Input and result"), Qt::Key_3, theme::Symbol::ShowBoth);
}

bool MainWindow::look_at(const QString& what) {
  auto* action = findChild<QAction*>("look." + what);
  if (action != nullptr) action->trigger();
  return action != nullptr;
}

/// Only in a program with something to watch.
void MainWindow::make_player_actions() {
  const auto& operations = program_.operations;
  if (std::all_of(operations.begin(), operations.end(),
                  [](const auto& operation) { return operation.stop_after.empty(); }))
    return;
  Actions& a = *actions_;
  QToolBar* bar = addToolBar(text("Watch"));
  bar->setObjectName("watch_bar");
  bar->setMovable(false);
  bar->setIconSize({22, 22});
  const auto add = [&](const QString& words, theme::Symbol symbol, const QKeySequence& keys, auto&& action) {
    QAction* made = bar->addAction(theme::icon(symbol), words);
    made->setShortcut(keys);
    made->setToolTip(QString("%1 (%2)").arg(words, keys.toString(QKeySequence::NativeText)));
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  a.play = add(text("Watch it work"), theme::Symbol::Play, QKeySequence(Qt::Key_F6), [this] {
    if (player_.playing())
      player_.pause();
    else if (settle())
      player_.play(watched_part());
  });
  a.step = add(text("One step more"), theme::Symbol::Step, QKeySequence(Qt::Key_F7), [this] {
    if (settle()) player_.step(watched_part());
  });
  a.stop = add(text("Stop watching"), theme::Symbol::Cancel, QKeySequence(Qt::Key_F9), [this] { player_.stop(); });
  connect(&player_, &Player::changed, this, &MainWindow::show_player);
  connect(steps_, &StepList::selected_changed, this, &MainWindow::show_player);
}

std::size_t MainWindow::watched_part() const {
  const std::size_t selected = steps_->selected();
  if (player_.can_watch(selected)) return selected;
  std::size_t part = session_.document().steps.size();
  while (part > 0 && !player_.can_watch(part)) --part;
  return part;
}

void MainWindow::show_player() {
  if (actions_->play == nullptr) return;
  const bool can = watched_part() > 0;
  actions_->play->setEnabled(can);
  actions_->play->setIcon(theme::icon(player_.playing() ? theme::Symbol::Pause : theme::Symbol::Play));
  actions_->step->setEnabled(can && !player_.playing());
  actions_->stop->setEnabled(player_.watching());
  if (player_.watching()) status_->show_state(text("At work: after %1 steps").arg(player_.steps()));
}

void MainWindow::make_status_bar() {
  status_ = new StatusLine(this);
  setStatusBar(status_);
  connect(status_, &StatusLine::cancel_asked, this, [this] { session_.cancel(); });
  canvas_->show_hint();
}

void MainWindow::connect_session() {
  connect(&session_, &Session::document_changed, this, &MainWindow::show_document);
  connect(&session_, &Session::run_started, this, &MainWindow::show_run_started);
  connect(&session_, &Session::progress, this, &MainWindow::show_progress);
  connect(&session_, &Session::run_finished, this, &MainWindow::show_outcome);
  connect(&session_, &Session::journal_failed, this,
          [this](const QString& why) { status_->show_state(text("Changes are not kept for a crash: %1").arg(why)); });
}

bool MainWindow::settle() {
  form_->form()->commit();
  const std::optional<QString> refused = form_->form()->unsettled();
  if (refused) show_error({base::ErrorCode::BadValue, text("not done: %1").arg(*refused).toStdString()});
  return !refused;
}

void MainWindow::select(std::size_t part) {
  form_->form()->commit();
  steps_->select(part);
}

void MainWindow::about() {
  const QString title = QString::fromStdString(program_.title);
  QMessageBox::about(this, text("About %1").arg(title),
                     QString("<h3>%1 %2</h3><p>%3</p><p>%4</p>")
                         .arg(title, DOBRA_VERSION, text(about_.c_str()), text("Part of Dobra. Apache License 2.0.")));
}

bool MainWindow::undo() {
  if (canvas_->take_back()) return true;
  form_->form()->commit();
  const bool can = session_.history().can_undo();
  session_.undo();
  return can;
}

void MainWindow::show_undo() {
  const documents::History& history = session_.history();
  const auto words = [](const QString& verb, const std::string& what) {
    return what.empty() ? verb : verb + ": " + QString::fromStdString(what);
  };
  const bool unfinished = canvas_->unfinished();
  hint_->setVisible(!unfinished && documents::is_blank(session_.document(), program_));
  actions_->undo->setEnabled(unfinished || history.can_undo());
  actions_->redo->setEnabled(!unfinished && history.can_redo());
  actions_->undo->setText(unfinished ? text("&Undo: last point")
                                     : words(text("&Undo"), history.can_undo() ? history.undo_text() : std::string()));
  actions_->redo->setText(words(text("&Redo"), history.can_redo() ? history.redo_text() : std::string()));
}

void MainWindow::show_document() {
  const scenario::Document& document = session_.document();
  const QString name = document.file.empty() ? text("untitled") : from_path(document.file.filename());
  setWindowTitle(name + QString::fromUtf8("[*] — ") + QString::fromStdString(program_.title));
  setWindowFilePath({});
  setWindowModified(session_.history().modified());
  show_undo();
  actions_->save_picture->setEnabled(session_.outcome() != nullptr && session_.outcome()->picture != nullptr);
  actions_->cancel->setEnabled(session_.busy());
  steps_->show_document(document, part_states());
  if (session_.outcome() == nullptr) {
    if (documents::is_blank(document, program_)) show_nothing();
    layers_->show_picture({});
    status_->show_state({});
    error_bar_->clear();
    results_->clear();
  }
  show_form();
  show_player();
  const QString missing = still_to_be_given(document, program_);
  if (!missing.isEmpty()) status_->show_state(text("Still to be given: %1").arg(missing));
}

void MainWindow::show_form() {
  const scenario::Document& document = session_.document();
  const std::size_t part = std::min(steps_->selected(), document.steps.size());
  form_part_ = part;
  QString title = text("Input");
  QString help;
  QString identity = from_path(document.file) + "#input";
  if (part > 0) {
    const scenario::Step& step = document.steps[part - 1];
    const scenario::Operation* operation = program_.find_operation(step.operation);
    title = text((operation != nullptr ? operation->title : step.operation).c_str());
    help = operation != nullptr ? text(operation->help.c_str())
                                : text("%1 has no such operation.").arg(QString::fromStdString(program_.title));
    identity = from_path(document.file) + "#" + QString::number(part) + QString::fromStdString(step.operation);
  }
  form_->show_part(identity, title, help,
                   scenario::fields_in(documents::fields_of(document, program_, part), document.units),
                   documents::table_of(document, part), document.folder());
  offer_names(part);
  mark_error();
}

void MainWindow::offer_names(std::size_t part) {
  form_->form()->offer([&](const std::string& what) -> std::vector<std::string> {
    const documents::OutcomePtr& outcome = session_.outcome();
    if (part == 0 || !program_.names_of || !outcome || outcome->run.states.size() < part) return {};
    return program_.names_of(outcome->run.states[part - 1], what);
  });
}

std::vector<PartState> MainWindow::part_states() const {
  const scenario::Document& document = session_.document();
  std::vector<PartState> states(document.steps.size() + 1, session_.busy() ? PartState::Running : PartState::Pending);
  const documents::OutcomePtr& outcome = session_.outcome();
  if (!outcome) return states;
  const std::size_t same = Session::common_parts(document, *outcome->document);
  for (std::size_t part = 0; part < std::min(same, outcome->run.states.size()); ++part) states[part] = PartState::Done;
  const std::size_t failed = outcome->run.failed_step;
  if (outcome->run.error && failed < same && !session_.busy()) {
    const bool stopped = outcome->run.error->code == base::ErrorCode::Cancelled;
    states[failed] = stopped ? PartState::Pending : PartState::Failed;
  }
  return states;
}

void MainWindow::show_run_started() {
  const documents::OutcomePtr& before = session_.outcome();
  if (before && before->run.error &&
      Session::common_parts(session_.document(), *before->document) <= before->run.failed_step) {
    // What failed has been changed; whether it fails still is for this run to say.
    error_.reset();
    error_bar_->clear();
    view_->clear_place();
  }
  actions_->cancel->setEnabled(true);
  if (player_.watching()) return;  // Many short runs, one after the other.
  status_->begin_run();
  steps_->show_document(session_.document(), part_states());
}

void MainWindow::show_progress(double fraction, const QString& what) { status_->show_progress(fraction, what); }

void MainWindow::show_outcome() {
  if (!session_.busy()) status_->end_run();
  actions_->cancel->setEnabled(session_.busy());
  if (!session_.outcome()) return;
  const documents::Outcome& outcome = *session_.outcome();
  frames::Meter& meter = view_->meter();
  meter.add(frames::Part::Edit, session_.last_edit_milliseconds());
  meter.add(frames::Part::Run, 1000.0 * outcome.run_seconds);
  meter.add(frames::Part::Layers, 1000.0 * (outcome.seconds - outcome.run_seconds));
  meter.expect_state();
  error_.reset();
  error_bar_->clear();
  view_->clear_place();
  show_picture();
  fit_next_ = outcome.picture == nullptr;
  results_->show_outcome(outcome);
  actions_->save_picture->setEnabled(outcome.picture != nullptr);
  steps_->show_document(session_.document(), part_states());
  offer_names(std::min(steps_->selected(), session_.document().steps.size()));
  if (outcome.run.error) {
    show_error(*outcome.run.error);
    mark_error();
  } else if (!player_.watching()) {
    status_->show_state(
        text("Done in %1 s").arg(QLocale().toString(outcome.seconds, 'f', outcome.seconds < 1 ? 2 : 1)));
  }
}

void MainWindow::show_picture() {
  if (!session_.outcome()) return;
  const auto picture = std::make_shared<const scene::Picture>(documents::picture_of(*session_.outcome(), shown_));
  const scene::Picture wanted = layers_->chosen(*picture);
  layers_->show_picture(wanted);
  if (wanted.panels.empty()) return show_nothing();  // what was there is not the document's any more
  view_->set_picture(wanted, fit_next_ ? Looking::AtAll : Looking::WhereItDid);
  canvas_->show_outcome(picture);
}

void MainWindow::show_nothing() {
  scene::Picture sheet;
  if (program_.drawing.add)
    sheet.panels.push_back({.key = "section", .extent = geom::Box{{0.0, -600.0}, {1000.0, 0.0}}});
  view_->set_picture(std::move(sheet), Looking::AtAll);
  canvas_->show_sheet();
}

void MainWindow::show_error(const base::Error& error) {
  if (error.code == base::ErrorCode::Cancelled) {
    status_->show_state(text("Interrupted. What is shown is the last step that was done."));
    return;
  }
  error_ = error;
  const documents::OutcomePtr& outcome = session_.outcome();
  const bool of_run = outcome && outcome->run.error && outcome->run.error->message == error.message;
  const bool has_place = error.place && error.place->x && error.place->y;
  const QString said = of_run ? in_words_of_the_window(error, *outcome->document, program_, outcome->run.failed_step)
                              : QString::fromStdString(base::to_string(error));
  error_bar_->say(said, of_run || has_place ? ErrorBar::CanShow::Yes : ErrorBar::CanShow::No);
}

void MainWindow::mark_error() {
  if (!error_ || !error_->place || !session_.outcome() || !session_.outcome()->run.error) return;
  const documents::Outcome& outcome = *session_.outcome();
  if (steps_->selected() != outcome.run.failed_step || form_->form() == nullptr) return;
  // What the user has changed since is for the next run to judge.
  if (Session::common_parts(session_.document(), *outcome.document) <= outcome.run.failed_step) return;
  form_->form()->mark(*error_->place,
                      in_words_of_the_form(QString::fromStdString(error_->message), form_->form()->fields()));
}

void MainWindow::go_to_error() {
  if (!error_) return;
  if (session_.outcome() && session_.outcome()->run.error) {
    steps_->select(std::min(session_.outcome()->run.failed_step, session_.document().steps.size()));
    mark_error();
  }
  if (error_->place && error_->place->x && error_->place->y) view_->show_place({*error_->place->x, *error_->place->y});
}

}  // namespace dobra::gui
