#include "shared/gui/view/controls.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QWheelEvent>
#include <array>
#include <utility>

namespace dobra::gui::view {

namespace {

QString text(const char* source) { return QCoreApplication::translate("dobra", source); }

/// With what it is before it: a screen reader has no other name of an editable box.
QString shown_text(double exaggeration) { return text("VE %1").arg(exaggeration_text(exaggeration)); }

constexpr std::array usual_exaggerations{1.0, 2.0, 5.0, 10.0};
constexpr int fills_row = static_cast<int>(usual_exaggerations.size());

}  // namespace

ExaggerationBox::ExaggerationBox(QWidget* parent) : QComboBox(parent) {
  setEditable(true);
  setInsertPolicy(QComboBox::NoInsert);
  setCompleter(nullptr);
  setObjectName("exaggeration");
  setAccessibleName(text("Vertical exaggeration"));
  setToolTip(text("Vertical exaggeration of the view; type any number"));
  for (const double each : usual_exaggerations) addItem(shown_text(each));
  addItem(text("Fill"));
  setMinimumContentsLength(6);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(this, &QComboBox::textActivated, this, &ExaggerationBox::take);
  show_value(1.0, 1.0);
}

void ExaggerationBox::show_value(const std::optional<double>& exaggeration, double drawn) {
  shown_ = shown_text(exaggeration.value_or(drawn));
  setEditText(shown_);
}

void ExaggerationBox::take(const QString& typed) {
  if (typed == itemText(fills_row)) {
    emit chosen(std::nullopt);
    return;
  }
  const QString sign = shown_text(1.0).section(' ', 0, 0);
  const QString number = typed.startsWith(sign, Qt::CaseInsensitive) ? typed.mid(sign.size()) : typed;
  const base::Result<double> value = exaggeration_from(number);
  if (value) {
    emit chosen(*value);
  } else {
    setEditText(shown_);
    emit refused(QString::fromStdString(value.error().message));
  }
}

void ExaggerationBox::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    take(currentText());
    lineEdit()->selectAll();
    event->accept();
  } else if (event->key() == Qt::Key_Escape) {
    setEditText(shown_);
    event->accept();
  } else {
    QComboBox::keyPressEvent(event);
  }
}

void ExaggerationBox::wheelEvent(QWheelEvent* event) { event->ignore(); }

/// What is typed and not taken is forgotten: a view has nothing to lose.
void ExaggerationBox::focusOutEvent(QFocusEvent* event) {
  setEditText(shown_);
  QComboBox::focusOutEvent(event);
}

template <class Choice, class Chosen>
void Controls::add_choices(QMenu& menu, const QString& title, const char* name,
                           const std::vector<std::pair<Choice, QString>>& choices, const Choice& now,
                           Chosen&& chosen) {
  QMenu* submenu = menu.addMenu(title);
  auto* group = new QActionGroup(this);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& [choice, words] = choices[i];
    QAction* made = submenu->addAction(words);
    made->setObjectName(QString("view.%1.%2").arg(name).arg(i));
    made->setCheckable(true);
    made->setChecked(choice == now);
    group->addAction(made);
    connect(made, &QAction::triggered, this, [this, choice = choice, chosen] {
      chosen(choice);
      emit changed();
    });
  }
}

QAction* Controls::add(QMenu& menu, const char* name, const QString& words, const QKeySequence& keys) {
  QAction* made = menu.addAction(words);
  made->setObjectName(QString("view.") + name);
  made->setShortcut(keys);
  return made;
}

Controls::Controls(QMenu& menu, const Settings& settings, QObject* parent) : QObject(parent), settings_(settings) {
  connect(add(menu, "back", text("Previous view"), QKeySequence(Qt::ALT | Qt::Key_Left)), &QAction::triggered, this,
          &Controls::back_asked);
  connect(add(menu, "forward", text("Next view"), QKeySequence(Qt::ALT | Qt::Key_Right)), &QAction::triggered, this,
          &Controls::forward_asked);
  connect(add(menu, "selection", text("Zoom to the selection"), QKeySequence(Qt::SHIFT | Qt::Key_F)),
          &QAction::triggered, this, &Controls::selection_asked);
  menu.addSeparator();

  QMenu* exaggeration = menu.addMenu(text("Vertical exaggeration"));
  for (const double each : usual_exaggerations) {
    QAction* made = add(*exaggeration, "exaggeration", exaggeration_text(each), {});
    exaggerations_.emplace_back(each, made);
  }
  exaggerations_.emplace_back(std::nullopt, add(*exaggeration, "exaggeration", text("Fill the canvas"), {}));
  for (const auto& [value, action] : exaggerations_) {
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, value = value] { set_exaggeration(value); });
  }
  other_ = add(*exaggeration, "exaggeration.other", text("Other..."), {});
  other_->setCheckable(true);
  connect(other_, &QAction::triggered, this, [this] {
    mark_exaggeration();
    emit other_asked();
  });
  mark_exaggeration();

  add_choices<Panels>(menu, text("Arrange panels"), "panels",
                      {{Panels::AsFits, text("As they are largest")},
                       {Panels::Row, text("Side by side")},
                       {Panels::Column, text("One above the other")},
                       {Panels::Overlay, text("Input as a ghost under the result")}},
                      settings_.panels, [this](Panels panels) { settings_.panels = panels; });
  QAction* linked = add(menu, "linked", text("Panels move together"), {});
  linked->setCheckable(true);
  linked->setChecked(settings_.linked == Linked::Yes);
  connect(linked, &QAction::toggled, this, [this](bool on) {
    settings_.linked = on ? Linked::Yes : Linked::No;
    emit changed();
  });
  QAction* grid = add(menu, "grid", text("Grid"), QKeySequence(Qt::SHIFT | Qt::Key_F4));
  grid->setCheckable(true);
  grid->setChecked(settings_.grid == scene::GridLines::On);
  connect(grid, &QAction::toggled, this, [this](bool on) {
    settings_.grid = on ? scene::GridLines::On : scene::GridLines::Off;
    emit changed();
  });
  add_choices<Unit>(menu, text("Units of the axes"), "unit",
                    {{Unit::AsRead, text("Those of the document")},
                     {Unit::Metre, text("Metres")},
                     {Unit::Kilometre, text("Kilometres")},
                     {Unit::Foot, text("Feet")}},
                    settings_.unit, [this](Unit unit) { settings_.unit = unit; });
  add_choices<scene::Legends>(menu, text("Legend"), "legend",
                              {{scene::Legends::Usual, text("Usual")},
                               {scene::Legends::Compact, text("Compact")},
                               {scene::Legends::Off, text("None")}},
                              settings_.legend, [this](scene::Legends legend) { settings_.legend = legend; });
}

void Controls::set_exaggeration(const std::optional<double>& exaggeration) {
  settings_.exaggeration = exaggeration;
  mark_exaggeration();
  emit changed();
}

void Controls::mark_exaggeration() {
  bool usual = false;
  for (const auto& [value, action] : exaggerations_) {
    action->setChecked(value == settings_.exaggeration);
    usual = usual || action->isChecked();
  }
  other_->setChecked(!usual);
}

}  // namespace dobra::gui::view
