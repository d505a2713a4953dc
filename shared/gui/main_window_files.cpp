// The window and its files: opening, saving, what is asked before something is lost, and what was lost before.
#include <QBoxLayout>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QToolBar>
#include <algorithm>
#include <set>
#include <utility>

#include "shared/gui/documents/edit.h"
#include "shared/gui/importing/file_filter.h"
#include "shared/gui/importing/import_dialog.h"
#include "shared/gui/importing/taken_in_bar.h"
#include "shared/gui/labels/status_line.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/mending/error_bar.h"
#include "shared/gui/mending/page.h"
#include "shared/gui/messages.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"
#include "shared/gui/welcome/page.h"
#include "shared/io/file.h"
#include "shared/render/cairo.h"

namespace dobra::gui {

namespace {

constexpr int most_recent_files = 10;
constexpr std::size_t most_mended_bytes = 4'000'000;  ///< What an editor of text can still show.
constexpr const char* recent_key = "recent_files";
constexpr const char* geometry_key = "layout/geometry";
constexpr const char* state_key = "layout/state";
constexpr int layout_version = 2;  ///< Of panels and bars: a layout of another version is not taken up.

constexpr const char* scenario_ending = ".toml";

QString text_of_another_program() {
  return text("Another program has changed the file meanwhile. Save again to replace what it wrote.");
}

QString scenario_filter() { return importing::file_filter({{"Scenarios", {scenario_ending}}}); }

/// The scenario among what is dragged over the window (empty if there is none), and what else lies on this machine.
struct Dragged {
  QString scenario;
  std::vector<std::filesystem::path> others;
};

Dragged dragged_files(const QMimeData& data) {
  Dragged files;
  for (const QUrl& url : data.urls()) {
    if (!url.isLocalFile()) continue;
    const QString file = url.toLocalFile();
    if (!file.endsWith(scenario_ending, Qt::CaseInsensitive))
      files.others.push_back(to_path(file));
    else if (files.scenario.isEmpty())
      files.scenario = file;
  }
  return files;
}

/// Asks where to write. A name without an ending gets `ending` before it is asked whether to replace what is there.
/// @return nothing if the dialog was left.
std::optional<std::filesystem::path> ask_target(QWidget* window, const QString& title,
                                                const std::filesystem::path& proposed, const QString& filter,
                                                const char* ending) {
  QFileDialog dialog(window, title, from_path(proposed.parent_path()), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(ending);
  dialog.selectFile(from_path(proposed.filename()));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return std::nullopt;
  return to_path(dialog.selectedFiles().front());
}

}  // namespace

/// What begins a document out of a file that is no scenario; null: none does.
const OtherFile* MainWindow::other_file(const std::filesystem::path& file) const {
  const QString ending = from_path(file.extension()).toLower();
  const auto is_it = [&](const OtherFile& each) {
    const std::vector<std::string>& endings = each.kind.endings;
    return std::find(endings.begin(), endings.end(), ending.toStdString()) != endings.end();
  };
  const auto found = std::find_if(part_.files.begin(), part_.files.end(), is_it);
  return found == part_.files.end() ? nullptr : &*found;
}

base::Result<void> MainWindow::begin_with(const OtherFile& kind, const std::filesystem::path& file) {
  base::Result<scenario::Document> made = kind.begin(std::filesystem::absolute(file));
  if (!made) {
    show_error(made.error());
    return made.error();
  }
  session_.begin(*std::move(made));
  remember_file(file);
  show_other_document();
  return {};
}

base::Result<void> MainWindow::open(const std::filesystem::path& file) {
  if (const OtherFile* other = other_file(file)) return begin_with(*other, file);
  const base::Result<void> opened = session_.open(file);
  if (!opened) {
    show_error(opened.error());
    return opened.error();
  }
  remember_file(file);
  show_other_document();
  return {};
}

base::Result<void> MainWindow::open_or_mend(const std::filesystem::path& file) {
  const base::Result<void> opened = open(file);
  if (opened) return {};
  const base::Result<std::string> text = io::read_text(file);
  const bool scenario = QString::fromStdString(file.extension().string()).toLower() == ".toml";
  if (text && scenario && text->size() <= most_mended_bytes)
    show_mending(file, *text, opened.error());
  else if (session_.document().file.empty() && documents::is_blank(session_.document(), program_))
    welcome();
  return opened.error();
}

void MainWindow::show_mending(const std::filesystem::path& file, const std::string& text, const base::Error& error) {
  error_bar_->clear();  // the page says it
  mending_->show_file(file, text, error, in_words(error));
  welcome_->hide();
  views_->hide();
  mending_->show();
}

/// Nothing is written before the text can be read.
void MainWindow::save_mended() {
  const std::filesystem::path file = mending_->file();
  const std::string text = mending_->written();
  const auto readable = [&]() -> base::Result<void> {
    DOBRA_TRY(const scenario::Document document, scenario::parse_document(text, file));
    return scenario::check_program(document, program_);
  }();
  if (!readable) return mending_->show_error(readable.error(), in_words(readable.error()));
  const base::Result<std::string> on_disk = io::read_text(file);
  if (on_disk && *on_disk != mending_->text_of_file()) {
    mending_->set_text_of_file(*on_disk);
    const QString said = text_of_another_program();
    return mending_->show_error({base::ErrorCode::CannotWrite, said.toStdString()}, said);
  }
  if (const base::Result<void> written = io::write_file(file, text); !written)
    return mending_->show_error(written.error(), in_words(written.error()));
  if (open(file)) leave_mending();
}

void MainWindow::leave_mending() {
  if (mending_->isHidden()) return;
  mending_->hide();
  views_->show();
  view_->setFocus();
}

base::Result<void> MainWindow::open_example(const std::string& file) {
  const auto begun = [&]() -> base::Result<void> {
    DOBRA_TRY(const std::filesystem::path written,
              welcome::write_example(program_.name, file, welcome::examples_folder(program_.name)));
    DOBRA_TRY(scenario::Document document, scenario::read_document(written));
    DOBRA_TRY_VOID(scenario::check_program(document, program_));
    document.file = written;
    session_.begin(documents::at_file(std::move(document), program_, {}));
    return {};
  }();
  if (!begun) {
    show_error(begun.error());
    return begun.error();
  }
  show_other_document();
  return {};
}

void MainWindow::begin_new() {
  session_.begin(documents::empty_document(program_));
  show_other_document();
  view_->setFocus();
}

void MainWindow::welcome() {
  mending_->hide();
  welcome_->show_recent(recent_files());
  views_->hide();
  welcome_->show();
  welcome_->take_focus();
}

void MainWindow::leave_welcome() {
  if (welcome_->isHidden()) return;
  welcome_->hide();
  views_->show();
  view_->setFocus();
}

void MainWindow::restore_layout() {
  keeps_layout_ = true;
  const QSettings kept = settings();
  restoreGeometry(kept.value(geometry_key).toByteArray());
  restoreState(kept.value(state_key).toByteArray(), layout_version);
  keep_on_screen();  // it may have become smaller since
}

void MainWindow::reset_layout() {
  showNormal();
  const QRect room = screen()->availableGeometry();
  resize(QSize(1280, 800).boundedTo(room.size()));
  move(room.topLeft());
  keep_on_screen();
  for (QToolBar* bar : findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) bar->show();
  place_docks();
}

void MainWindow::show_other_document() {
  leave_welcome();
  leave_mending();
  form_->forget();
  show_form();
  // The run has only been asked for: its picture comes later.
  fit_next_ = true;
  error_.reset();
  show_nothing();
  layers_->forget_choices();
  layers_->show_picture({});
  steps_->select(session_.document().steps.empty() ? 0 : 1);
}

base::Result<void> MainWindow::save(const std::filesystem::path& file) {
  if (!settle()) return *error_;
  const base::Result<void> saved = session_.save(file);
  if (!saved) {
    show_error(saved.error());
    return saved.error();
  }
  remember_file(file);
  status_->show_state(text("Saved %1").arg(from_path(file)));
  return {};
}

base::Result<void> MainWindow::save_picture(const std::filesystem::path& file) {
  if (!session_.outcome() || !session_.outcome()->picture) {
    return base::Error{base::ErrorCode::CannotDraw,
                       text("there is no picture yet; run the scenario first").toStdString()};
  }
  scene::Picture shown = picture_shown();
  view_->make_alike(shown);
  return render::write_picture(scenario::titled(layers_->chosen(std::move(shown)), session_.document()), file);
}

base::Result<void> MainWindow::save_screenshot(const std::filesystem::path& file) {
  view_->come_to_rest();
  space_->come_to_rest();
  const QImage image = grab().toImage();
  const double ratio = image.devicePixelRatio();
  const QWidget* seen = view_->isHidden() ? static_cast<QWidget*>(space_) : view_;
  const QPoint corner = seen->mapTo(this, QPoint(0, 0));
  const QRect part(corner * ratio, seen->size() * ratio);
  std::set<QRgb> colors;
  for (int y = part.top(); y <= part.bottom() && colors.size() < 2; y += 2) {
    for (int x = part.left(); x <= part.right(); x += 2) colors.insert(image.pixel(x, y));
  }
  const bool has_picture = session_.outcome() && session_.outcome()->picture;
  if (has_picture && colors.size() < 2) {
    return base::Error{base::ErrorCode::CannotDraw, text("the view came out blank").toStdString()};
  }
  if (!image.save(from_path(file), "PNG")) {
    return base::Error{base::ErrorCode::CannotWrite, text("cannot write the picture").toStdString(),
                       base::Place{file.string(), 0, 0, {}, {}, {}}};
  }
  return {};
}

QString MainWindow::open_filter() const {
  std::vector<scenario::FileKind> kinds{{"Scenarios", {scenario_ending}}};
  for (const OtherFile& each : part_.files) kinds.push_back(each.kind);
  return importing::file_filter(kinds);
}

void MainWindow::ask_open() {
  if (!may_discard()) return;
  const QString chosen = QFileDialog::getOpenFileName(this, text("Open a scenario"),
                                                      from_path(session_.document().folder()), open_filter());
  if (!chosen.isEmpty()) open_asking(to_path(chosen));
}

bool MainWindow::ask_save() {
  if (!settle()) return false;
  if (session_.document().file.empty()) return ask_save_as();
  const std::optional<std::filesystem::path> changed = session_.changed_on_disk();
  if (!changed) return save(session_.document().file).ok();
  QMessageBox box(QMessageBox::Warning, QString::fromStdString(program_.title),
                  text("Another program has changed %1 since it was read here.").arg(from_path(*changed)),
                  QMessageBox::NoButton, this);
  box.setInformativeText(text("Saving to it loses those changes."));
  const QPushButton* other = box.addButton(text("Save as another file"), QMessageBox::AcceptRole);
  const QPushButton* overwrite = box.addButton(text("Overwrite"), QMessageBox::DestructiveRole);
  box.addButton(text("Cancel"), QMessageBox::RejectRole);
  box.exec();
  const auto* answer = static_cast<const void*>(box.clickedButton());
  if (answer == other) return ask_save_as();
  return answer == overwrite && save(session_.document().file).ok();
}

bool MainWindow::ask_save_as() {
  const scenario::Document& document = session_.document();
  const std::filesystem::path proposed = document.file.empty() ? document.folder() / "" : document.file;
  auto chosen = ask_target(this, text("Save the scenario"), proposed, scenario_filter(), scenario_ending);
  if (!chosen) return false;
  if (chosen->extension() == scenario_ending) return save(*chosen).ok();
  *chosen += scenario_ending;  // "fold.v2" has an ending, though not this one: the dialog has not asked about this file
  if (std::filesystem::exists(*chosen) &&
      QMessageBox::question(this, text("Save the scenario"),
                            text("%1 is there already. Replace it?").arg(from_path(*chosen))) != QMessageBox::Yes)
    return false;
  return save(*chosen).ok();
}

void MainWindow::ask_save_picture() {
  const auto& endings = render::picture_endings;
  std::filesystem::path proposed = session_.document().file;
  if (proposed.empty()) proposed = session_.document().folder() / "picture";
  proposed.replace_extension(endings.front());
  const auto chosen = ask_target(this, text("Save the picture"), proposed,
                                 importing::filter_of({"Pictures", {endings.begin(), endings.end()}}), endings.front());
  if (!chosen) return;
  const base::Result<void> written = save_picture(*chosen);
  if (written)
    status_->show_state(text("Saved %1").arg(from_path(*chosen)));
  else
    show_error(written.error());
}

void MainWindow::ask_save_space_picture() {
  const auto& endings = render::picture_endings;
  std::filesystem::path proposed = session_.document().file;
  if (proposed.empty()) proposed = session_.document().folder() / "picture";
  proposed.replace_filename(proposed.stem().string() + "_space");
  proposed.replace_extension(endings.front());
  const auto chosen = ask_target(this, text("Save the picture in space"), proposed,
                                 importing::filter_of({"Pictures", {endings.begin(), endings.end()}}), endings.front());
  if (!chosen) return;
  const base::Result<void> written = save_space_picture(*chosen);
  if (written)
    status_->show_state(text("Saved %1").arg(from_path(*chosen)));
  else
    show_error(written.error());
}

bool MainWindow::may_discard_text() {
  if (mending_->isHidden() || !mending_->modified()) return true;
  QMessageBox box(QMessageBox::Question, QString::fromStdString(program_.title),
                  text("The text of %1 has changes that are not saved.").arg(from_path(mending_->file().filename())),
                  QMessageBox::NoButton, this);
  const QPushButton* discard = box.addButton(text("Discard"), QMessageBox::DestructiveRole);
  box.addButton(text("Cancel"), QMessageBox::RejectRole);
  box.exec();
  return static_cast<const void*>(box.clickedButton()) == discard;
}

bool MainWindow::may_discard() {
  if (!may_discard_text()) return false;
  form_->form()->commit();
  if (!session_.history().modified() && !form_->form()->unsettled()) return true;
  QMessageBox box(QMessageBox::Question, QString::fromStdString(program_.title),
                  text("The scenario has changes that are not saved."), QMessageBox::NoButton, this);
  box.setInformativeText(text("Save them?"));
  const QPushButton* save = box.addButton(text("Save"), QMessageBox::AcceptRole);
  const QPushButton* discard = box.addButton(text("Discard"), QMessageBox::DestructiveRole);
  box.addButton(text("Cancel"), QMessageBox::RejectRole);
  box.exec();
  const auto* answer = static_cast<const void*>(box.clickedButton());
  if (answer == save) return ask_save();
  if (answer == discard) session_.forget_unsaved();
  return answer == discard;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_discard()) return event->ignore();
  event->accept();
  if (!keeps_layout_) return;
  QSettings kept = settings();
  kept.setValue(geometry_key, saveGeometry());
  kept.setValue(state_key, saveState(layout_version));
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const Dragged files = dragged_files(*event->mimeData());
  if (!files.scenario.isEmpty() || (program_.importing.look && !files.others.empty())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  Dragged files = dragged_files(*event->mimeData());
  if (files.scenario.isEmpty() && files.others.size() == 1 && other_file(files.others.front()) != nullptr)
    files.scenario = from_path(std::exchange(files.others, {}).front());
  const bool can_import = program_.importing.look && !files.others.empty();
  if (files.scenario.isEmpty() && !can_import) return;
  event->acceptProposedAction();
  if (!files.scenario.isEmpty()) {
    if (!may_discard()) return;
    open_asking(to_path(files.scenario));
  }
  if (!can_import) return;
  // The dialog waits until the one who let go is free again.
  QMetaObject::invokeMethod(
      this, [this, files] { import_files(files.others); }, Qt::QueuedConnection);
}

void MainWindow::ask_import() {
  const QStringList chosen =
      QFileDialog::getOpenFileNames(this, text("Import files"), from_path(session_.document().folder()),
                                    importing::file_filter(program_.importing.files));
  std::vector<std::filesystem::path> files;
  for (const QString& file : chosen) files.push_back(to_path(file));
  if (!files.empty()) import_files(files);
}

void MainWindow::import_files(const std::vector<std::filesystem::path>& files) {
  if (!settle()) return;
  const auto wording = [this](const base::Error& error) {
    return in_words_of_the_import(error, session_.document(), program_);
  };
  importing::ImportDialog dialog(program_, session_.document(), files, wording, this);
  if (dialog.exec() != QDialog::Accepted) return;
  fit_next_ = true;
  session_.edit(dialog.document(), dialog.what());
}

void MainWindow::make_taken_in_bar(QBoxLayout& column) {
  taken_in_bar_ = new importing::TakenInBar;
  column.addWidget(taken_in_bar_);
  connect(taken_in_bar_, &importing::TakenInBar::beside_asked, this, [this] { keep_lines_beside(true); });
  connect(taken_in_bar_, &importing::TakenInBar::undo_asked, this, [this] { session_.undo(); });
  // Another document, or the one before: what was said is not of it. What is said of an edit comes after it.
  connect(&session_, &Session::document_changed, taken_in_bar_, &QWidget::hide);
}

void MainWindow::keep_lines_beside(bool beside) {
  if (!settle()) return;
  session_.edit(documents::with_lines_beside(session_.document(), beside),
                beside ? text("Keep lines in a file beside") : text("Keep lines in the scenario"));
  if (beside)
    status_->show_state(text("Lines are saved in %1").arg(QString::fromStdString(session_.document().lines_file)));
}

QSettings MainWindow::settings() const {
  return QSettings(QSettings::IniFormat, QSettings::UserScope, "Dobra", QString::fromStdString(program_.name));
}

void MainWindow::remember_file(const std::filesystem::path& file) {
  QSettings kept = settings();
  QStringList files = kept.value(recent_key).toStringList();
  const QString name = from_path(std::filesystem::absolute(file).lexically_normal());
  files.removeAll(name);
  files.prepend(name);
  kept.setValue(recent_key, QStringList(files.mid(0, most_recent_files)));
}

QStringList MainWindow::recent_files() const { return settings().value(recent_key).toStringList(); }

void MainWindow::fill_recent_menu(QMenu& list) {
  const QStringList files = recent_files();
  for (const QString& file : files) {
    QAction* action = list.addAction(QString(file).replace("&", "&&"));
    action->setEnabled(QFileInfo::exists(file));
    connect(action, &QAction::triggered, this, [this, file] {
      if (may_discard()) open_asking(to_path(file));
    });
  }
  if (files.isEmpty()) list.addAction(text("None yet"))->setEnabled(false);
}

void MainWindow::open_asking(const std::filesystem::path& file) {
  if (open_or_mend(file)) offer_recovery();
}

void MainWindow::offer_recovery() {
  if (!session_.unsaved()) return;
  QMessageBox box(QMessageBox::Question, QString::fromStdString(program_.title),
                  text("Changes were not saved when the program last ended."), QMessageBox::NoButton, this);
  box.setInformativeText(text("Take them up again? Undo gives back what was saved."));
  QPushButton* recover = box.addButton(text("Recover"), QMessageBox::AcceptRole);
  const QPushButton* discard = box.addButton(text("Discard"), QMessageBox::DestructiveRole);
  box.setDefaultButton(recover);
  box.setEscapeButton(recover);  // which loses nothing
  box.exec();
  if (static_cast<const void*>(box.clickedButton()) == discard)
    session_.forget_unsaved();
  else
    session_.recover();
}

}  // namespace dobra::gui
