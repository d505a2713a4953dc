#include "shared/gui/heard/boxes.h"

#include <QAccessibleWidget>
#include <QComboBox>

namespace dobra::gui::heard {

namespace {

class Box : public QAccessibleWidget {
 public:
  explicit Box(QComboBox* box) : QAccessibleWidget(box, QAccessible::ComboBox) {}

  [[nodiscard]] QString text(QAccessible::Text what) const override {
    if (what == QAccessible::Value) return box().currentText();
    // Where nobody has named it, what is chosen is better than nothing.
    const QString said = QAccessibleWidget::text(what);
    return said.isEmpty() && what == QAccessible::Name ? box().currentText() : said;
  }
  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State now = QAccessibleWidget::state();
    now.expandable = true;
    now.editable = box().isEditable();
    return now;
  }
  [[nodiscard]] QStringList actionNames() const override {
    QStringList names = QAccessibleWidget::actionNames();
    if (box().isEnabled()) names.prepend(showMenuAction());
    return names;
  }
  void doAction(const QString& action) override {
    if (action == showMenuAction())
      box().showPopup();
    else
      QAccessibleWidget::doAction(action);
  }

 private:
  [[nodiscard]] QComboBox& box() const { return *static_cast<QComboBox*>(object()); }
};

/// Null for all else, which Qt knows.
QAccessibleInterface* make(const QString&, QObject* object) {
  auto* box = qobject_cast<QComboBox*>(object);
  return box == nullptr ? nullptr : new Box(box);
}

}  // namespace

void name_boxes() {
  static const bool once = [] {
    QAccessible::installFactory(make);
    return true;
  }();
  (void)once;
}

}  // namespace dobra::gui::heard
