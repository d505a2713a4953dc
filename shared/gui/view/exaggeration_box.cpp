#include "shared/gui/view/exaggeration_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>

#include "shared/gui/view/settings.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::view {

namespace {

/// With what it is before it: a screen reader has no other name of an editable box.
QString shown_text(double exaggeration) { return text("VE %1").arg(exaggeration_text(exaggeration)); }

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

}  // namespace dobra::gui::view
