// The window and its view: what the View menu sets, and what the Edit menu does with what is selected.
#include <QAction>
#include <QLineEdit>
#include <QSettings>
#include <tuple>

#include "shared/gui/canvas.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/text.h"
#include "shared/gui/view/exaggeration_box.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::gui {

template <class Choice>
void MainWindow::add_look_choices(const char* name, const char* title, Choice view::Settings::*setting,
                                  const std::vector<std::tuple<Choice, const char*, const char*>>& choices) {
  for (const auto& [choice, key, words] : choices) {
    actions_.add({.id = std::string("view.") + name + "." + key,
                  .text = words,
                  .menu = std::string("&View/") + title,
                  .run =
                      [this, setting, choice = choice] {
                        look_.*setting = choice;
                        show_look();
                      },
                  .checked = [this, setting, choice = choice] { return look_.*setting == choice; },
                  .choice = std::string("view.") + name});
  }
}

void MainWindow::add_look_switch(const char* name, const char* title, QKeySequence keys, std::function<void()> turn,
                                 std::function<bool()> is_on) {
  actions_.add({.id = std::string("view.") + name,
                .text = title,
                .menu = "&View",
                .section = "settings",
                .keys = keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys},
                .run =
                    [this, turn] {
                      turn();
                      show_look();
                    },
                .checked = std::move(is_on)});
}

void MainWindow::add_look_actions() {
  look_ = view::remembered(settings());
  view_->set_settings(look_);
  space_->set_exaggeration(look_.exaggeration.value_or(1.0));
  connect(canvas_, &Canvas::hide_asked, this, [this](const QString& panel, const QString& layer) {
    layers_->set_layer_visible((panel + "/" + layer).toStdString(), false);
  });
  const auto add = [this](const char* name, const char* words, QKeySequence keys, std::function<void()> run) {
    actions_.add({.id = std::string("view.") + name,
                  .text = words,
                  .menu = "&View",
                  .section = "look",
                  .keys = {keys},
                  .run = std::move(run)});
  };
  add("selection", "Zoom to the selection", QKeySequence(Qt::SHIFT | Qt::Key_F),
      [this] { canvas_->look_at_selection(); });
  add("back", "Previous view", QKeySequence(Qt::ALT | Qt::Key_Left), [this] { view_->look_back(); });
  add("forward", "Next view", QKeySequence(Qt::ALT | Qt::Key_Right), [this] { view_->look_forward(); });

  const std::string exaggeration = "&View/Vertical exaggeration";
  for (const double each : view::usual_exaggerations) {
    actions_.add({.id = "view.exaggeration." + QString::number(each).toStdString(),
                  .text = view::exaggeration_text(each).toStdString(),
                  .menu = exaggeration,
                  .run = [this, each] { set_exaggeration(each); },
                  .checked = [this, each] { return look_.exaggeration == each; },
                  .choice = "view.exaggeration"});
  }
  actions_.add({.id = "view.exaggeration.fill",
                .text = "Fill the canvas",
                .menu = exaggeration,
                .run = [this] { set_exaggeration(std::nullopt); },
                .checked = [this] { return !look_.exaggeration; },
                .choice = "view.exaggeration"});
  actions_.add({.id = "view.exaggeration.other", .text = "Other...", .menu = exaggeration, .run = [this] {
                  exaggeration_->setFocus();
                  exaggeration_->lineEdit()->selectAll();
                }});
  using view::Panels;
  using view::Unit;
  add_look_choices<Panels>("panels", "Arrange panels", &view::Settings::panels,
                           {{Panels::AsFits, "as_fits", "As they are largest"},
                            {Panels::Row, "row", "Side by side"},
                            {Panels::Column, "column", "One above the other"},
                            {Panels::Overlay, "ghost", "Input as a ghost under the result"}});
  add_look_choices<Unit>("unit", "Units of the axes", &view::Settings::unit,
                         {{Unit::AsRead, "as_read", "Those of the document"},
                          {Unit::Metre, "m", "Metres"},
                          {Unit::Kilometre, "km", "Kilometres"},
                          {Unit::Foot, "ft", "Feet"}});
  add_look_choices<scene::Legends>("legend", "Legend", &view::Settings::legend,
                                   {{scene::Legends::Usual, "usual", "Usual"},
                                    {scene::Legends::Compact, "compact", "Compact"},
                                    {scene::Legends::Off, "off", "None"}});
  add_look_switch(
      "linked", "Panels move together", {},
      [this] { look_.linked = look_.linked == view::Linked::Yes ? view::Linked::No : view::Linked::Yes; },
      [this] { return look_.linked == view::Linked::Yes; });
  add_look_switch(
      "grid", "Grid", QKeySequence(Qt::SHIFT | Qt::Key_F4),
      [this] { look_.grid = look_.grid == scene::GridLines::On ? scene::GridLines::Off : scene::GridLines::On; },
      [this] { return look_.grid == scene::GridLines::On; });
}

void MainWindow::add_selection_actions() {
  // Elsewhere these keys are those of the text that is typed.
  const auto add = [this](const char* name, const char* words, QKeySequence keys, std::function<void()> run) {
    actions_.add({.id = std::string("edit.") + name,
                  .text = words,
                  .menu = "&Edit",
                  .section = "selection",
                  .keys = {keys},
                  .run = std::move(run),
                  .scope = view_});
  };
  if (program_.drawing.edit) add("cut", "Cu&t lines", QKeySequence::Cut, [this] { canvas_->cut(); });
  add("copy", "&Copy lines as text", QKeySequence::Copy, [this] { canvas_->copy(); });
  if (program_.drawing.add) add("paste", "&Paste lines", QKeySequence::Paste, [this] { canvas_->paste(); });
  add("select_all", "Select &all", QKeySequence::SelectAll, [this] { canvas_->select_all(); });
  add("invert", "&Invert the selection", QKeySequence(Qt::CTRL | Qt::Key_I), [this] { canvas_->invert_selection(); });
}

void MainWindow::set_exaggeration(const std::optional<double>& exaggeration) {
  look_.exaggeration = exaggeration;
  show_look();
}

void MainWindow::show_look() {
  QSettings kept = settings();
  const bool ghost =
      (view::remembered(kept).panels == view::Panels::Overlay) != (look_.panels == view::Panels::Overlay);
  view::remember(look_, kept);
  view_->set_settings(look_);
  space_->set_exaggeration(look_.exaggeration.value_or(1.0));
  actions_.refresh();
  if (!ghost || !session_.outcome()) return;
  fit_next_ = true;
  show_picture();
  fit_next_ = false;
}

scene::Picture MainWindow::picture_shown() const {
  const bool ghost = look_.panels == view::Panels::Overlay;
  return documents::picture_of(*session_.outcome(), shown_,
                               ghost ? documents::Beside::Ghost : documents::Beside::Panels);
}

}  // namespace dobra::gui
