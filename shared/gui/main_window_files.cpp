// The window and its files: opening, saving, what is asked before something is lost, and what was lost before.
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <set>

#include "shared/gui/error_bar.h"
#include "shared/gui/file_filter.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/status_line.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"
#include "shared/render/cairo.h"

namespace dobra::gui {

namespace {

constexpr int most_recent_files = 10;
constexpr const char* recent_key = "recent_files";

QString scenario_filter() { return file_filter({{"Scenarios", {".toml"}}}); }

/// The scenario among what is dragged over the window; empty if there is none.
QString dragged_file(const QMimeData& data) {
  for (const QUrl& url : data.urls()) {
    if (url.isLocalFile() && url.toLocalFile().endsWith(".toml", Qt::CaseInsensitive)) return url.toLocalFile();
  }
  return {};
}

}  // namespace

base::Result<void> MainWindow::open(const std::filesystem::path& file) {
  const base::Result<void> opened = session_.open(file);
  if (!opened) {
    show_error(opened.error());
    return opened.error();
  }
  remember_file(file);
  form_->forget();
  show_form();
  // The run has only been asked for: its picture comes later.
  fit_next_ = true;
  error_.reset();
  show_nothing();
  layers_->forget_choices();
  layers_->show_picture({});
  steps_->select(session_.document().steps.empty() ? 0 : 1);
  return {};
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
  view_->exaggerate(shown);
  return render::write_picture(scenario::titled(layers_->chosen(std::move(shown)), session_.document()), file);
}

base::Result<void> MainWindow::save_screenshot(const std::filesystem::path& file) {
  view_->come_to_rest();
  const QImage image = grab().toImage();
  const double ratio = image.devicePixelRatio();
  const QPoint corner = view_->mapTo(this, QPoint(0, 0));
  const QRect part(corner * ratio, view_->size() * ratio);
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

void MainWindow::ask_open() {
  if (!may_discard()) return;
  const QString chosen = QFileDialog::getOpenFileName(this, text("Open a scenario"),
                                                      from_path(session_.document().folder()), scenario_filter());
  if (!chosen.isEmpty()) open_asking(to_path(chosen));
}

bool MainWindow::ask_save() {
  if (!settle()) return false;
  if (session_.document().file.empty()) return ask_save_as();
  if (!session_.changed_on_disk()) return save(session_.document().file).ok();
  QMessageBox box(
      QMessageBox::Warning, QString::fromStdString(program_.title),
      text("Another program has changed %1 since it was read here.").arg(from_path(session_.document().file)),
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
  QString chosen = QFileDialog::getSaveFileName(this, text("Save the scenario"), from_path(session_.document().file),
                                                scenario_filter());
  if (chosen.isEmpty()) return false;
  if (!chosen.endsWith(".toml", Qt::CaseInsensitive)) chosen += ".toml";
  return save(to_path(chosen)).ok();
}

void MainWindow::ask_save_picture() {
  const auto& endings = render::picture_endings;
  std::filesystem::path proposed = session_.document().file;
  if (proposed.empty()) proposed = session_.document().folder() / "picture";
  proposed.replace_extension(endings.front());
  QString chosen = QFileDialog::getSaveFileName(this, text("Save the picture"), from_path(proposed),
                                                filter_of({"Pictures", {endings.begin(), endings.end()}}));
  if (chosen.isEmpty()) return;
  if (!to_path(chosen).has_extension()) chosen += endings.front();
  const base::Result<void> written = save_picture(to_path(chosen));
  if (written)
    status_->show_state(text("Saved %1").arg(chosen));
  else
    show_error(written.error());
}

bool MainWindow::may_discard() {
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
  if (may_discard())
    event->accept();
  else
    event->ignore();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!dragged_file(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString file = dragged_file(*event->mimeData());
  if (file.isEmpty()) return;
  event->acceptProposedAction();
  if (may_discard()) open_asking(to_path(file));
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
  if (open(file)) offer_recovery();
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
