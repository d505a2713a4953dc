// What a user can ask of the window, in the order of its menus; the tools of the canvas are those of DrawBar.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "shared/gui/actions/palette.h"
#include "shared/gui/canvas.h"
#include "shared/gui/documents/copied.h"
#include "shared/gui/draw_bar.h"
#include "shared/gui/labels/status_line.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::gui {

using actions::Action;
using theme::Symbol;

namespace {

constexpr const char* main_bar = "tool_bar";
constexpr const char* watch_bar = "watch_bar";
constexpr const char* shown_key = "shown";
constexpr const char* theme_key = "theme";
constexpr const char* canvas_key = "canvas";

const char* name_of(documents::Shown shown) {
  switch (shown) {
    case documents::Shown::Input:
      return "input";
    case documents::Shown::Both:
      return "both";
    case documents::Shown::Result:
      break;
  }
  return "result";
}

}  // namespace

void MainWindow::make_actions() {
  add_file_actions();
  add_edit_actions();
  draw_bar_ = new DrawBar({session_, *canvas_}, part_.tools, actions_, this);
  add_view_actions();
  add_run_actions();
  add_help_actions();
  actions_.fill(*menuBar());
  const auto add_bar = [&](const QString& title, const char* name) {
    QToolBar* bar = addToolBar(title);
    bar->setObjectName(name);
    bar->setMovable(false);
    bar->setIconSize({22, 22});
    actions_.fill(*bar, name);
  };
  add_bar(text("Tools"), main_bar);
  addToolBar(draw_bar_);
  if (can_watch()) add_bar(text("Watch"), watch_bar);
  steps_->use(*actions_.menu("&Edit/Add &step"), *actions_.find("step.remove"), *actions_.find("step.up"),
              *actions_.find("step.down"));
  // Whoever draws wants the sheet.
  for (const actions::Registry::Entry& entry : actions_.all()) {
    if (entry.action.id.starts_with("draw."))
      connect(entry.made, &QAction::triggered, this, &MainWindow::leave_welcome);
  }
  palette_ = new actions::Palette(*this);
  actions_.refresh();
}

void MainWindow::add_file_actions() {
  const std::string menu = "&File";
  actions_.add(
      {.id = "file.new", .text = "&New", .menu = menu, .section = "open", .keys = {QKeySequence::New}, .run = [this] {
         if (may_discard()) begin_new();
       }});
  actions_.add({.id = "file.open",
                .text = "&Open...",
                .menu = menu,
                .section = "open",
                .bar = main_bar,
                .symbol = Symbol::Open,
                .keys = {QKeySequence::Open},
                .run = [this] { ask_open(); }});
  actions_.add(
      {.id = "file.recent", .text = "Open &Recent", .menu = menu, .section = "open", .list = [this](QMenu& list) {
         fill_recent_menu(list);
       }});
  if (program_.importing.look)
    actions_.add({.id = "file.import",
                  .text = "&Import...",
                  .help = "Brings lines, drawings or pictures from files into the scenario.",
                  .menu = menu,
                  .section = "open",
                  .keys = {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)},
                  .run = [this] { ask_import(); }});
  actions_.add({.id = "file.save",
                .text = "&Save",
                .menu = menu,
                .section = "save",
                .bar = main_bar,
                .symbol = Symbol::Save,
                .keys = {QKeySequence::Save},
                .run = [this] { ask_save(); }});
  actions_.add({.id = "file.save_as",
                .text = "Save &As...",
                .menu = menu,
                .section = "save",
                .keys = {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
                .run = [this] { ask_save_as(); }});
  actions_.add({.id = "file.lines_beside",
                .text = "Keep &lines in a file beside",
                .help = "Saving writes the lines of the scenario to a file of their own, which the scenario names.",
                .menu = menu,
                .section = "save",
                .run = [this] { keep_lines_beside(session_.document().lines_file.empty()); },
                .checked = [this] { return !session_.document().lines_file.empty(); }});
  actions_.add({.id = "file.save_picture",
                .text = "Save &Picture...",
                .menu = menu,
                .section = "save",
                .bar = main_bar,
                .symbol = Symbol::SavePicture,
                .keys = {QKeySequence(Qt::CTRL | Qt::Key_E)},
                .run = [this] { ask_save_picture(); },
                .enabled = [this] { return session_.outcome() != nullptr && session_.outcome()->picture != nullptr; }});
  actions_.add({.id = "file.quit",
                .text = "&Quit",
                .menu = menu,
                .section = "quit",
                .keys = {QKeySequence(Qt::CTRL | Qt::Key_Q)},
                .run = [this] { close(); }});
}

QString MainWindow::undo_text() const {
  const documents::History& history = session_.history();
  if (canvas_->unfinished()) return text("&Undo: last point");
  if (!history.can_undo() || history.undo_text().empty()) return text("&Undo");
  return text("&Undo") + ": " + QString::fromStdString(history.undo_text());
}

QString MainWindow::redo_text() const {
  const documents::History& history = session_.history();
  if (!history.can_redo() || history.redo_text().empty()) return text("&Redo");
  return text("&Redo") + ": " + QString::fromStdString(history.redo_text());
}

void MainWindow::add_edit_actions() {
  const std::string menu = "&Edit";
  actions_.add({.id = "edit.undo",
                .text = "&Undo",
                .menu = menu,
                .section = "undo",
                .bar = main_bar,
                .symbol = Symbol::Undo,
                .keys = {QKeySequence::Undo},
                .run = [this] { undo(); },
                .enabled = [this] { return canvas_->unfinished() || session_.history().can_undo(); },
                .label = [this] { return undo_text(); }});
  actions_.add({.id = "edit.redo",
                .text = "&Redo",
                .menu = menu,
                .section = "undo",
                .bar = main_bar,
                .symbol = Symbol::Redo,
                .keys = {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                .run = [this] { session_.redo(); },
                .enabled = [this] { return !canvas_->unfinished() && session_.history().can_redo(); },
                .label = [this] { return redo_text(); }});
  for (const scenario::Operation& operation : program_.operations) {
    actions_.add({.id = "step.add." + operation.name,
                  .text = operation.title,
                  .help = operation.help,
                  .menu = menu + "/Add &step",
                  .run = [this, name = operation.name] { emit steps_->add_asked(name); }});
  }
  actions_.add({.id = "edit.copy_step",
                .text = "Cop&y step as scenario text",
                .help = "The selected step, or the input, as a scenario writes it, on the clipboard",
                .menu = menu,
                .section = "copy",
                .keys = {QKeySequence::Copy},
                .run = [this] { copy_step(); },
                .scope = steps_});
  actions_.add({.id = "edit.paste_step",
                .text = "&Paste scenario text as steps",
                .help = "Inserts the steps on the clipboard behind the selected one",
                .menu = menu,
                .section = "copy",
                .keys = {QKeySequence::Paste},
                .run = [this] { paste_step(); },
                .scope = steps_});
  actions_.add({.id = "edit.copy_command",
                .text = "Copy as co&mmand",
                .help = "The command line that does what the window shows, on the clipboard",
                .menu = menu,
                .section = "copy",
                .run = [this] { copy_command(); },
                .enabled = [this] { return !session_.document().file.empty(); }});
  add_selection_actions();
  const auto selected = [this] { return steps_->selected(); };
  actions_.add({.id = "step.remove",
                .text = "Remove the step",
                .menu = menu,
                .section = "step",
                .symbol = Symbol::Remove,
                .keys = {QKeySequence(Qt::Key_Delete)},
                .run = [this, selected] { emit steps_->remove_asked(selected()); },
                .enabled = [selected] { return selected() >= 1; },
                .scope = steps_});
  actions_.add({.id = "step.up",
                .text = "Move the step up",
                .menu = menu,
                .section = "step",
                .symbol = Symbol::Up,
                .keys = {QKeySequence(Qt::ALT | Qt::Key_Up)},
                .run = [this, selected] { emit steps_->exchange_asked(selected() - 1, selected() - 1); },
                .enabled = [selected] { return selected() >= 2; },
                .scope = steps_});
  actions_.add(
      {.id = "step.down",
       .text = "Move the step down",
       .menu = menu,
       .section = "step",
       .symbol = Symbol::Down,
       .keys = {QKeySequence(Qt::ALT | Qt::Key_Down)},
       .run = [this, selected] { emit steps_->exchange_asked(selected(), selected() + 1); },
       .enabled = [this, selected] { return selected() >= 1 && selected() < session_.document().steps.size(); },
       .scope = steps_});
}

void MainWindow::copy_step() {
  form_->form()->commit();
  const std::size_t part = steps_->selected();
  QApplication::clipboard()->setText(QString::fromStdString(documents::part_text(session_.document(), part)));
  status_->show_state(text("Copied: %1").arg(steps_->title(part)));
}

void MainWindow::paste_step() {
  form_->form()->commit();
  const std::size_t after = steps_->selected();
  const std::string pasted = QApplication::clipboard()->text().toStdString();
  base::Result<scenario::Document> made = documents::with_pasted(session_.document(), program_, after, pasted);
  if (!made) return show_error(made.error());
  const std::size_t count = made->steps.size() - session_.document().steps.size();
  session_.edit(*std::move(made), text("Paste step"));
  steps_->select(after + count);
}

void MainWindow::copy_command() {
  if (!settle()) return;
  const scenario::Document& document = session_.document();
  const base::Result<scenario::Document> read = scenario::read_document(document.file);
  const QString command =
      QString::fromStdString(documents::command_of(document, program_, read ? std::optional(*read) : std::nullopt));
  QApplication::clipboard()->setText(command);
  status_->show_state(text("Copied: %1").arg(command.trimmed().section('\n', -1)));
}

void MainWindow::add_view_actions() {
  const std::string menu = "&View";
  actions_.add({.id = "view.fit",
                .text = "&Fit",
                .menu = menu,
                .section = "look",
                .bar = main_bar,
                .symbol = Symbol::Fit,
                .keys = {QKeySequence(Qt::Key_F)},
                .run = [this] { space_->hasFocus() || !view_->isVisible() ? space_->fit() : view_->fit(); }});
  add_look_actions();
  add_space_actions();
  const QString kept = settings().value(shown_key, "result").toString();
  const auto add = [&](documents::Shown shown, const char* words, int key, Symbol symbol) {
    if (kept == name_of(shown)) shown_ = shown;
    actions_.add({.id = std::string("look.") + name_of(shown),
                  .text = words,
                  .menu = menu,
                  .section = "shown",
                  .bar = main_bar,
                  .symbol = symbol,
                  .keys = {QKeySequence(Qt::CTRL | key)},
                  .run =
                      [this, shown] {
                        shown_ = shown;
                        settings().setValue(shown_key, name_of(shown));
                        show_picture();
                      },
                  .checked = [this, shown] { return shown_ == shown; },
                  .choice = "look"});
  };
  add(documents::Shown::Input, "The input", Qt::Key_1, Symbol::ShowInput);
  add(documents::Shown::Result, "The result", Qt::Key_2, Symbol::ShowResult);
  add(documents::Shown::Both, "Input and result", Qt::Key_3, Symbol::ShowBoth);
  add_color_actions();
  for (QDockWidget* each : findChildren<QDockWidget*>()) add_panel_action(*each);
  actions_.add({.id = "view.reset_layout",
                .text = "&Reset layout",
                .help = "Panels, bars and size of the window as at the first start",
                .menu = menu,
                .section = "panels",
                .run = [this] { reset_layout(); }});
}

theme::Theme MainWindow::kept_theme() const {
  const QString name = settings().value(theme_key, "system").toString();
  return name == "dark" ? theme::Theme::Dark : name == "light" ? theme::Theme::Light : theme::Theme::System;
}

theme::CanvasChoice MainWindow::kept_canvas() const {
  const QString name = settings().value(canvas_key, "theme").toString();
  using theme::CanvasChoice;
  return name == "dark" ? CanvasChoice::Dark : name == "paper" ? CanvasChoice::Paper : CanvasChoice::AsTheme;
}

void MainWindow::add_color_actions() {
  const auto add = [this](const char* key, const char* name, const char* words, const char* menu, auto&& apply,
                          auto&& is_on) {
    actions_.add({.id = std::string(key) + "." + name,
                  .text = words,
                  .menu = std::string("&View/") + menu,
                  .section = key,
                  .run =
                      [this, key, name, apply] {
                        settings().setValue(key, name);
                        apply();
                      },
                  .checked = is_on,
                  .choice = key});
  };
  for (const auto& [theme, name, words] : {std::tuple{theme::Theme::System, "system", "As the &system"},
                                           {theme::Theme::Light, "light", "&Light"},
                                           {theme::Theme::Dark, "dark", "&Dark"}}) {
    add(
        theme_key, name, words, "&Theme", [this, theme = theme] { set_theme(theme); },
        [this, theme = theme] { return kept_theme() == theme; });
  }
  for (const auto& [canvas, name, words] : {std::tuple{theme::CanvasChoice::AsTheme, "theme", "As the &theme"},
                                            {theme::CanvasChoice::Paper, "paper", "&White paper"},
                                            {theme::CanvasChoice::Dark, "dark", "&Dark canvas"}}) {
    add(
        canvas_key, name, words, "&Canvas", [this] { show_canvas(); },
        [this, canvas = canvas] { return kept_canvas() == canvas; });
  }
}

void MainWindow::add_panel_action(QDockWidget& panel) {
  const QString name = panel.objectName().section('.', 1);
  actions_.adopt(*panel.toggleViewAction(), {.id = "view.panel." + name.toStdString(),
                                             .text = panel.windowTitle().toStdString(),
                                             .menu = "&View/&Panels",
                                             .section = "panels"});
  connect(panel.toggleViewAction(), &QAction::triggered, &panel, [&panel](bool shown) {
    if (shown) panel.raise();  // not behind others of its dock
  });
}

bool MainWindow::can_watch() const {
  return std::any_of(program_.operations.begin(), program_.operations.end(),
                     [](const auto& operation) { return !operation.stop_after.empty(); });
}

void MainWindow::add_run_actions() {
  const std::string menu = "&Run";
  actions_.add({.id = "run.run",
                .text = "&Run",
                .menu = menu,
                .section = "run",
                .bar = main_bar,
                .symbol = Symbol::Run,
                .keys = {QKeySequence(Qt::Key_F5)},
                .run = [this] {
                  if (settle()) session_.run();
                }});
  actions_.add({.id = "run.cancel",
                .text = "&Cancel",
                .menu = menu,
                .section = "run",
                .bar = main_bar,
                .symbol = Symbol::Cancel,
                .keys = {QKeySequence(Qt::Key_Escape)},
                .run = [this] { session_.cancel(); },
                .enabled = [this] { return session_.busy(); }});
  if (!can_watch()) return;
  actions_.add({.id = "run.watch",
                .text = "Watch it work",
                .menu = menu,
                .section = "watch",
                .bar = watch_bar,
                .symbol = Symbol::Play,
                .keys = {QKeySequence(Qt::Key_F6)},
                .run =
                    [this] {
                      if (player_.playing())
                        player_.pause();
                      else if (settle())
                        player_.play(watched_part());
                    },
                .enabled = [this] { return watched_part() > 0; },
                .look = [this] { return player_.playing() ? Symbol::Pause : Symbol::Play; }});
  actions_.add({.id = "run.step",
                .text = "One step more",
                .menu = menu,
                .section = "watch",
                .bar = watch_bar,
                .symbol = Symbol::Step,
                .keys = {QKeySequence(Qt::Key_F7)},
                .run =
                    [this] {
                      if (settle()) player_.step(watched_part());
                    },
                .enabled = [this] { return watched_part() > 0 && !player_.playing(); }});
  actions_.add({.id = "run.stop",
                .text = "Stop watching",
                .menu = menu,
                .section = "watch",
                .bar = watch_bar,
                .symbol = Symbol::Cancel,
                .keys = {QKeySequence(Qt::Key_F9)},
                .run = [this] { player_.stop(); },
                .enabled = [this] { return player_.watching(); }});
  connect(&player_, &Player::changed, this, &MainWindow::show_player);
  connect(steps_, &StepList::selected_changed, this, &MainWindow::show_player);
}

void MainWindow::add_help_actions() {
  const std::string menu = "&Help";
  actions_.add({.id = "help.palette",
                .text = "&Find an action...",
                .help = "Lists all that can be done, filtered by what you type",
                .menu = menu,
                .section = "find",
                .keys = {QKeySequence(Qt::CTRL | Qt::Key_K)},
                .run = [this] { palette_->open(choices()); }});
  actions_.add(
      {.id = "help.keys", .text = "&Keys...", .menu = menu, .section = "find", .run = [this] { show_keys(); }});
  actions_.add({.id = "help.welcome",
                .text = "&Welcome page",
                .help = "Examples and recent files",
                .menu = menu,
                .section = "find",
                .run = [this] { welcome(); }});
  actions_.add({.id = "help.about",
                .text = "&About %1",
                .menu = menu,
                .section = "about",
                .run = [this] { about(); },
                .label = [this] { return text("&About %1").arg(QString::fromStdString(program_.title)); }});
}

std::vector<actions::Choice> MainWindow::choices() {
  actions_.refresh();
  std::vector<actions::Choice> all;
  for (const actions::Registry::Entry& entry : actions_.all()) {
    const Action& action = entry.action;
    if (action.list || action.id == "help.palette") continue;
    actions::Choice choice{actions::plain(entry.made->text()),
                           actions::menu_path(action),
                           actions::keys_text(action.keys.mid(0, 1)),
                           {},
                           entry.made->isEnabled(),
                           [made = entry.made] { made->trigger(); }};
    if (action.id.starts_with("step.add.")) choice.title = text("Add '%1'").arg(choice.title);
    if (entry.made->isCheckable() && entry.made->isChecked()) choice.title += QString::fromUtf8("  ✓");
    choice.heard = QString::fromStdString(action.id + '\n' + action.text + '\n' + action.help) + '\n' +
                   actions::shown(action.help) + '\n' + choice.where;
    all.push_back(std::move(choice));
  }
  add_choices_of_document(all);
  return all;
}

void MainWindow::add_choices_of_document(std::vector<actions::Choice>& all) {
  const scenario::Document& document = session_.document();
  for (std::size_t part = 0; part <= document.steps.size(); ++part) {
    all.push_back({text("Go to %1").arg(steps_->title(part)), text("Steps"), {}, "go to step", true, [this, part] {
                     if (part > session_.document().steps.size()) return;
                     select(part);
                     steps_->setFocus();
                   }});
  }
  for (const LayerTree::Listed& layer : layers_->listed()) {
    const QString words = layer.visible ? text("Hide layer '%1'") : text("Show layer '%1'");
    all.push_back({words.arg(layer.title),
                   text("Layers") + QString::fromUtf8(" › ") + layer.panel,
                   {},
                   QString::fromStdString(layer.key) + (layer.visible ? "\nhide layer" : "\nshow layer"),
                   true,
                   [this, layer] { layers_->set_layer_visible(layer.key, !layer.visible); }});
  }
  for (const QString& file : recent_files()) {
    const std::filesystem::path path = to_path(file);
    all.push_back({text("Open %1").arg(from_path(path.filename())),
                   from_path(path.parent_path()),
                   {},
                   file + "\nopen recent",
                   std::filesystem::exists(path),
                   [this, path] {
                     if (may_discard()) open_asking(path);
                   }});
  }
}

void MainWindow::show_keys() {
  QDialog dialog(this);
  dialog.setWindowTitle(text("Keys"));
  auto* column = new QVBoxLayout(&dialog);
  auto* list = new QTreeWidget(&dialog);
  list->setObjectName("keys");
  list->setAccessibleName(text("Keys"));
  list->setHeaderLabels({text("Action"), text("Keys"), text("In the menu")});
  list->setRootIsDecorated(false);
  for (const actions::Registry::Entry& entry : actions_.all()) {
    if (entry.action.keys.isEmpty()) continue;
    new QTreeWidgetItem(list, {actions::plain(actions::shown(entry.action.text)).remove("..."),
                               actions::keys_text(entry.action.keys), actions::menu_path(entry.action)});
  }
  for (int i = 0; i < list->columnCount(); ++i) list->resizeColumnToContents(i);
  auto* buttons = new QDialogButtonBox(&dialog);
  connect(buttons->addButton(text("Close"), QDialogButtonBox::RejectRole), &QAbstractButton::clicked, &dialog,
          &QDialog::reject);
  column->addWidget(list);
  column->addWidget(buttons);
  dialog.resize(QSize(620, 560).boundedTo(size()));
  list->setFocus();
  dialog.exec();
}

bool MainWindow::look_at(const QString& what) { return actions_.trigger("look." + what.toStdString()); }

std::size_t MainWindow::watched_part() const {
  const std::size_t selected = steps_->selected();
  if (player_.can_watch(selected)) return selected;
  std::size_t part = session_.document().steps.size();
  while (part > 0 && !player_.can_watch(part)) --part;
  return part;
}

}  // namespace dobra::gui
