#include "shared/gui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>
#include <algorithm>
#include <set>

#include "shared/gui/canvas.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/draw_bar.h"
#include "shared/gui/heard/boxes.h"
#include "shared/gui/importing/file_filter.h"
#include "shared/gui/importing/taken_in_bar.h"
#include "shared/gui/labels/status_line.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/mending/error_bar.h"
#include "shared/gui/mending/page.h"
#include "shared/gui/messages.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/results.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/theme/icons.h"
#include "shared/gui/vertices/pointing.h"
#include "shared/gui/vertices/vertex_panel.h"
#include "shared/gui/view/exaggeration_box.h"
#include "shared/gui/vtk_widget.h"
#include "shared/gui/welcome/page.h"
#include "shared/render/cairo.h"

namespace dobra::gui {

namespace {

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

MainWindow::MainWindow(const scenario::Program& program, WindowPart part)
    : program_(program), part_(std::move(part)), session_(program), player_(session_), actions_(*this) {
  heard::name_boxes();
  theme::apply(kept_theme());
  setWindowIcon(theme::application_icon());
  setAcceptDrops(true);
  resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
  make_center();
  make_docks();
  make_actions();
  make_status_bar();
  connect_session();
  show_nothing();
  show_document();
}

MainWindow::~MainWindow() {
  hide();  // what loses the focus tells what was typed there, while all that hears it is alive
  for (QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

void MainWindow::make_center() {
  auto* center = new QWidget(this);
  auto* column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  error_bar_ = new mending::ErrorBar(center);
  views_ = new QSplitter(Qt::Horizontal, center);
  view_ = new VtkWidget(views_);
  column->addWidget(error_bar_);
  make_taken_in_bar(*column);
  column->addWidget(views_, 1);
  welcome_ = new welcome::Page(QString::fromStdString(program_.title),
                               part_.about.empty() ? QString() : text(part_.about.c_str()), part_.examples,
                               program_.importing.look != nullptr, center);
  welcome_->hide();
  column->addWidget(welcome_, 1);
  mending_ = new mending::Page(center);
  mending_->hide();
  column->addWidget(mending_, 1);
  connect(mending_, &mending::Page::save_asked, this, &MainWindow::save_mended);
  connect(mending_, &mending::Page::open_asked, this, &MainWindow::ask_open);
  connect(mending_, &mending::Page::left, this, [this] {
    if (may_discard_text()) leave_mending();
  });
  setCentralWidget(center);
  hint_ = new QLabel(program_.drawing.add ? text("Open a scenario (Ctrl+O), drop one here, or draw the first line (L).")
                                          : text("Open a scenario (Ctrl+O), or drop one here."),
                     view_);
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setMargin(100);  // so that it stands between the axes
  hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
  show_canvas();
  auto* middle = new QVBoxLayout(view_);
  middle->addWidget(hint_);
  connect(welcome_, &welcome::Page::left, this, &MainWindow::leave_welcome);
  connect(welcome_, &welcome::Page::new_asked, this, [this] {
    if (may_discard()) begin_new();
  });
  connect(welcome_, &welcome::Page::open_asked, this, &MainWindow::ask_open);
  connect(welcome_, &welcome::Page::import_asked, this, &MainWindow::ask_import);
  connect(welcome_, &welcome::Page::example_asked, this, [this](const std::string& file) {
    if (may_discard()) (void)open_example(file);  // the error bar says what is wrong
  });
  connect(welcome_, &welcome::Page::recent_asked, this, [this](const QString& file) {
    if (may_discard()) open_asking(to_path(file));
  });
  connect(error_bar_, &mending::ErrorBar::show_asked, this, &MainWindow::go_to_error);
  connect(view_, &VtkWidget::cursor_moved, this, [this](const QString& where) { status_->show_place(where); });
  canvas_ = new Canvas(session_, *view_, this);
  connect(view_, &VtkWidget::picked, canvas_, &Canvas::tell_pick);
  connect(canvas_, &Canvas::told, this, [this](const QString& what) { status_->show_hint(what); });
  connect(canvas_, &Canvas::unfinished_changed, this, &MainWindow::show_undo);
  connect(canvas_, &Canvas::taken_in, this,
          [this](const std::vector<std::string>& files) { taken_in_bar_->say(files, session_.document()); });
  connect(canvas_, &Canvas::over_line, this, [this](const QString& dip) { status_->show_dip(dip); });
  make_space_view();
}

void MainWindow::show_canvas() {
  view_->set_canvas(theme::canvas_of(kept_canvas(), QApplication::palette()));
  if (space_ != nullptr) space_->set_canvas(theme::canvas_of(kept_canvas(), QApplication::palette()));
  hint_->setStyleSheet("font-size: 12pt; color: " + view_->colors().quiet.name());
}

void MainWindow::set_theme(theme::Theme theme) {
  form_->form()->commit();
  theme::apply(theme);
}

/// What has taken colours out of the palette takes them again.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || results_ == nullptr) return;
  // Behind the children, which hear of it later.
  QTimer::singleShot(0, this, [this] {
    error_bar_->take_colors();
    show_canvas();
    form_->form()->commit();
    form_->forget();
    show_form();
    if (!session_.outcome()) return;
    results_->show_outcome(*session_.outcome());
    scene::Picture listed = picture_shown();
    (void)space_shown(listed);
    layers_->show_picture(listed);
  });
}

void MainWindow::make_docks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  steps_ = new StepList(program_, this);
  form_ = new ParameterForm(this);
  layers_ = new LayerTree(this);
  results_ = new Results(this);
  results_->name_by(program_.input_fields);
  vertices_ = new vertices::VertexPanel(this);
  dock(*this, text("Steps"), "dock.steps", steps_, Qt::LeftDockWidgetArea);
  dock(*this, text("Parameters"), "dock.form", form_, Qt::LeftDockWidgetArea);
  dock(*this, text("Layers"), "dock.layers", layers_, Qt::RightDockWidgetArea);
  dock(*this, text("Results"), "dock.results", results_, Qt::RightDockWidgetArea);
  dock(*this, text("Vertices"), "dock.vertices", vertices_, Qt::RightDockWidgetArea);
  for (const PanelPart& panel : part_.panels)
    dock(*this, text(panel.title.c_str()), ("dock." + panel.name).c_str(), panel.make({session_, *canvas_}, this),
         Qt::RightDockWidgetArea);
  place_docks();

  connect(steps_, &StepList::selected_changed, this, [this] {
    show_form();
    actions_.refresh();
  });
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
  form_->canvas_answers();
  connect(form_, &ParameterForm::pointing_asked, this, [this](FieldEditor* editor, const scenario::Field& field) {
    const vertices::Pointing wish{field, form_part_, shown_};
    canvas_->ask_for_place(
        vertices::hint_of(wish), [this, wish, at = QPointer(editor)](const canvas::Pointed& pointed) {
          const base::Result<QString> value =
              vertices::pointed_text(wish, pointed, session_.document(), program_, session_.outcome().get());
          if (!value) return QString::fromStdString(value.error().message);
          if (at != nullptr && wish.of_name()) at->take_name(*value);
          if (at != nullptr && !wish.of_name()) at->type(*value);
          return QString();
        });
  });
  connect(form_, &ParameterForm::edited, this, [this](const scenario::Table& table, const QString& key) {
    scenario::Document edited = documents::with_table(session_.document(), form_part_, table);
    const documents::OutcomePtr& outcome = session_.outcome();
    if (form_part_ == 0 && program_.drawing.settle && outcome && !outcome->run.states.empty())
      edited = program_.drawing.settle(session_.document(), std::move(edited), outcome->run.states.front());
    session_.edit(std::move(edited), text("Change '%1'").arg(key));
  });
  connect(canvas_, &Canvas::lines_changed, this, [this] {
    vertices_->show(canvas_->workspace(), QString::fromStdString(session_.document().shown_units().length_unit()),
                    QString::fromStdString(program_.drawing.height));
  });
  connect(vertices_, &vertices::VertexPanel::selected, canvas_, &Canvas::select);
  connect(vertices_, &vertices::VertexPanel::edited, canvas_, qOverload<const canvas::Edited&>(&Canvas::carry_out));
  connect(vertices_, &vertices::VertexPanel::told, canvas_, &Canvas::say);
  connect(layers_, &LayerTree::visibility_changed, this,
          [this](const std::string& panel, const std::string& layer, bool visible) {
            if (panel == scene::space::panel_key) return space_->set_layer_visible(layer, visible);
            view_->set_layer_visible(panel, layer, visible);
            canvas_->set_layer_hidden(layer, !visible);
          });
  connect(layers_, &LayerTree::visibility_changed, this, [this] { actions_.refresh(); });
}

void MainWindow::place_docks() {
  const auto at = [this](const char* name, Qt::DockWidgetArea area) {
    auto* panel = findChild<QDockWidget*>(name);
    addDockWidget(area, panel);
    panel->show();
    return panel;
  };
  const bool narrow = width() < roomy;  // what does not fit beside the picture is found under tabs
  const Qt::DockWidgetArea second = narrow ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea;
  QDockWidget* steps = at("dock.steps", Qt::LeftDockWidgetArea);
  QDockWidget* form = at("dock.form", Qt::LeftDockWidgetArea);
  QDockWidget* layers = at("dock.layers", second);
  QDockWidget* results = at("dock.results", second);
  QDockWidget* vertices = at("dock.vertices", second);
  tabifyDockWidget(results, vertices);
  std::vector<QDockWidget*> of_program;
  for (const PanelPart& panel : part_.panels) {
    of_program.push_back(at(("dock." + panel.name).c_str(), second));
    tabifyDockWidget(results, of_program.back());
  }
  results->raise();
  if (narrow) {
    tabifyDockWidget(form, layers);
    tabifyDockWidget(layers, results);
    tabifyDockWidget(results, vertices);
    vertices->hide();  // four titles have no room side by side
    for (QDockWidget* panel : of_program) panel->hide();
    form->raise();
    resizeDocks({steps}, {260}, Qt::Horizontal);
    resizeDocks({steps, form}, {90, 200}, Qt::Vertical);
    return;
  }
  resizeDocks({steps, layers}, {300, 300}, Qt::Horizontal);
  resizeDocks({steps, form}, {200, 460}, Qt::Vertical);
  resizeDocks({layers, results}, {270, 390}, Qt::Vertical);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  frame_known_ = !windowHandle()->frameMargins().isNull();
  // What panels need while they are being placed may have made the window larger than the screen.
  keep_on_screen();
}

/// A window manager puts its frame round the window after it is shown, and moves it by the frame.
void MainWindow::moveEvent(QMoveEvent* event) {
  QMainWindow::moveEvent(event);
  if (frame_known_ || !isVisible() || windowHandle()->frameMargins().isNull()) return;
  frame_known_ = true;
  keep_on_screen();
}

void MainWindow::keep_on_screen() {
  if (isMaximized() || isFullScreen()) return;
  layout()->activate();
  const QRect room = screen()->availableGeometry();
  const QMargins frame = windowHandle() != nullptr ? windowHandle()->frameMargins() : QMargins();
  resize(size().boundedTo(room.marginsRemoved(frame).size()));
  const QSize whole = size().grownBy(frame);
  move(std::max(room.left(), std::min(x(), room.right() + 1 - whole.width())),
       std::max(room.top(), std::min(y(), room.bottom() + 1 - whole.height())));
}

void MainWindow::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  // Titles of panels under tabs stay whole; what has no room is scrolled to.
  auto* tabs = qobject_cast<QTabBar*>(event->child());
  if (event->type() == QEvent::ChildPolished && tabs != nullptr) {
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(true);
  }
}

void MainWindow::show_player() {
  actions_.refresh();
  if (player_.watching()) status_->show_state(text("At work: after %1 steps").arg(player_.steps()));
}

void MainWindow::make_status_bar() {
  status_ = new labels::StatusLine(this);
  setStatusBar(status_);
  exaggeration_ = new view::ExaggerationBox(status_);
  status_->addPermanentWidget(exaggeration_);
  connect(exaggeration_, &view::ExaggerationBox::chosen, this, &MainWindow::set_exaggeration);
  connect(exaggeration_, &view::ExaggerationBox::refused, canvas_, &Canvas::say);
  connect(view_, &VtkWidget::exaggerated, this,
          [this](double drawn) { exaggeration_->show_value(look_.exaggeration, drawn); });
  connect(status_, &labels::StatusLine::cancel_asked, this, [this] { session_.cancel(); });
  canvas_->show_hint();
}

void MainWindow::connect_session() {
  connect(&session_, &Session::document_changed, this, &MainWindow::show_document);
  connect(&session_, &Session::run_started, this, &MainWindow::show_run_started);
  connect(&session_, &Session::progress, this, &MainWindow::show_progress);
  connect(&session_, &Session::run_finished, this, &MainWindow::show_outcome);
  connect(&session_, &Session::names_found, this, [this] { offer_names(form_part_); });
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
  QMessageBox::about(
      this, text("About %1").arg(title),
      QString("<h3>%1 %2</h3><p>%3</p><p>%4</p>")
          .arg(title, DOBRA_VERSION, text(part_.about.c_str()), text("Part of Dobra. Apache License 2.0.")));
}

bool MainWindow::undo() {
  if (canvas_->take_back()) return true;
  form_->form()->commit();
  const bool can = session_.history().can_undo();
  session_.undo();
  return can;
}

void MainWindow::show_undo() {
  hint_->setVisible(!canvas_->unfinished() && documents::is_blank(session_.document(), program_));
  actions_.refresh();
}

void MainWindow::show_document() {
  const scenario::Document& document = session_.document();
  const QString name = document.file.empty() ? text("untitled") : from_path(document.file.filename());
  setWindowTitle(name + QString::fromUtf8("[*] — ") + QString::fromStdString(program_.title));
  setWindowFilePath({});
  setWindowModified(session_.history().modified());
  if (!document.file.empty() || !document.input.empty() || !document.steps.empty()) leave_welcome();
  steps_->show_document(document, part_states());
  show_undo();
  if (session_.outcome() == nullptr) {
    if (documents::is_blank(document, program_)) show_nothing();
    show_space(std::nullopt);
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
  form_->form()->offer([this, part](const std::string& what) { return session_.names_before(part, what); });
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
    space_->show_place(std::nullopt);
  }
  actions_.refresh();
  if (player_.watching()) return;  // Many short runs, one after the other.
  status_->begin_run();
  steps_->show_document(session_.document(), part_states());
}

void MainWindow::show_progress(double fraction, const QString& what) { status_->show_progress(fraction, what); }

void MainWindow::show_outcome() {
  if (!session_.busy()) status_->end_run();
  actions_.refresh();
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
  space_->show_place(std::nullopt);
  // A marker on its way may pass places where nothing can be made: what was there last stays in sight.
  if (!space_->drags() || outcome.space != nullptr) show_picture();
  fit_next_ = outcome.picture == nullptr;
  results_->show_outcome(outcome);
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
  const scene::Picture picture = picture_wanted();
  scene::Picture listed = layers_->chosen(picture);
  has_plane_ = !picture.panels.empty();
  show_space(space_shown(listed));
  layers_->show_picture(listed);
  actions_.refresh();                      // switches of layers
  if (!has_plane_) return show_nothing();  // what was there is not the document's any more
  show_plane(picture);
}

scene::Picture MainWindow::picture_wanted() {
  scene::Picture picture = picture_shown();
  add_asked_panel(picture);
  add_section_panel(picture);
  return picture;
}

void MainWindow::show_plane(const scene::Picture& picture) {
  scene::Picture wanted = layers_->chosen(picture);
  without_colors(wanted);
  view_->set_picture(std::move(wanted), fit_next_ ? Looking::AtAll : Looking::WhereItDid);
  canvas_->show_outcome(std::make_shared<const scene::Picture>(picture));
}

void MainWindow::show_nothing() {
  scene::Picture sheet;
  if (program_.drawing.add)
    sheet.panels.push_back({.key = "section",
                            .axes = {.y_title = program_.drawing.height + " [m]"},
                            .extent = geom::Box{{0.0, -600.0}, {1000.0, 0.0}}});
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
  if (error.place) mark_place(*error.place);
  const QString said =
      of_run ? in_words_of_the_window(error, *outcome->document, program_, outcome->run.failed_step) : in_words(error);
  error_bar_->say(said, of_run || has_place ? mending::ErrorBar::CanShow::Yes : mending::ErrorBar::CanShow::No);
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
  if (error_->place) go_to_place(*error_->place);
}

/// The panel whose axes say u and v there, with the place in it: the one that is called after the item of the place, or
/// the only one that it can be.
std::optional<std::pair<std::size_t, geom::Point>> MainWindow::place_in_plane(const base::Place& place) const {
  if (!place.u || !place.v) return std::nullopt;
  const std::size_t quote = place.item.find('\'');
  const std::string name = quote == std::string::npos ? std::string() : place.item.substr(quote + 1);
  std::vector<std::pair<std::size_t, geom::Point>> found;
  for (std::size_t i = 0; i < view_->panel_count(); ++i) {
    const scene::Axes& axes = view_->axes(i);
    if (!axes.x_reading || !axes.y_reading) continue;
    const std::pair<std::size_t, geom::Point> here(
        i, {axes.x_reading->to_world(*place.u), axes.y_reading->to_world(*place.v)});
    if (!name.empty() && (view_->panel_title(i) + "'").ends_with(" " + name)) return here;
    found.push_back(here);
  }
  return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

void MainWindow::mark_place(const base::Place& place) {
  if (!place.x || !place.y || !place.z) return;
  space_->show_place(geom::Point3{*place.x, *place.y, *place.z});
  if (const auto shown = place_in_plane(place)) view_->mark_place(shown->first, shown->second);
}

/// In space it is marked already.
void MainWindow::go_to_place(const base::Place& place) {
  if (!place.x || !place.y) return;
  if (!place.z) return view_->show_place({*place.x, *place.y});
  if (const auto shown = place_in_plane(place)) view_->show_place(shown->first, shown->second);
}

}  // namespace dobra::gui
