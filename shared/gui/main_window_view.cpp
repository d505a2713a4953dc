// The window and its view: what the View menu sets, and what the Edit menu does with what is selected.
#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>

#include "shared/gui/canvas.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/text.h"
#include "shared/gui/view/controls.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::gui {

void MainWindow::make_view_controls(QMenu& look, QMenu& edit) {
  look.addSeparator();
  controls_ = new view::Controls(look, view::remembered(settings()), this);
  connect(controls_, &view::Controls::changed, this, &MainWindow::show_view_settings);
  connect(controls_, &view::Controls::back_asked, view_, &VtkWidget::look_back);
  connect(controls_, &view::Controls::forward_asked, view_, &VtkWidget::look_forward);
  connect(controls_, &view::Controls::selection_asked, canvas_, &Canvas::look_at_selection);
  connect(controls_, &view::Controls::other_asked, this, [this] {
    exaggeration_->setFocus();
    exaggeration_->lineEdit()->selectAll();
  });
  view_->set_settings(controls_->settings());
  connect(canvas_, &Canvas::hide_asked, this, [this](const QString& panel, const QString& layer) {
    layers_->set_layer_visible((panel + "/" + layer).toStdString(), false);
  });

  edit.addSeparator();
  const auto add = [&](const char* name, const QString& words, const QKeySequence& keys, void (Canvas::*action)()) {
    QAction* made = edit.addAction(words);
    made->setObjectName(QString("edit.") + name);
    made->setShortcut(keys);
    // Elsewhere these keys are those of the text that is typed.
    made->setShortcutContext(Qt::WidgetShortcut);
    view_->addAction(made);
    connect(made, &QAction::triggered, canvas_, action);
  };
  const bool draws = program_.drawing.add != nullptr;
  const bool edits = program_.drawing.edit != nullptr;
  if (edits) add("cut", text("Cu&t lines"), QKeySequence::Cut, &Canvas::cut);
  add("copy", text("&Copy lines as text"), QKeySequence::Copy, &Canvas::copy);
  if (draws) add("paste", text("&Paste lines"), QKeySequence::Paste, &Canvas::paste);
  add("select_all", text("Select &all"), QKeySequence::SelectAll, &Canvas::select_all);
  add("invert", text("&Invert the selection"), QKeySequence(Qt::CTRL | Qt::Key_I), &Canvas::invert_selection);
}

void MainWindow::show_view_settings() {
  const view::Settings& wanted = controls_->settings();
  QSettings kept = settings();
  const bool ghost = (view::remembered(kept).panels == view::Panels::Overlay) != (wanted.panels == view::Panels::Overlay);
  view::remember(wanted, kept);
  view_->set_settings(wanted);
  if (!ghost) return;
  fit_next_ = session_.outcome() != nullptr;
  show_picture();
  fit_next_ = false;
}

scene::Picture MainWindow::picture_shown() const {
  const bool ghost = controls_->settings().panels == view::Panels::Overlay;
  return documents::picture_of(*session_.outcome(), shown_,
                               ghost ? documents::Beside::Ghost : documents::Beside::Panels);
}

}  // namespace dobra::gui
