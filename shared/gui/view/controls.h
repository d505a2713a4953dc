#pragma once
// The settings of the view to choose from, in a menu and in a small box for the exaggeration.

#include <QComboBox>
#include <QObject>

#include "shared/gui/view/settings.h"

class QAction;
class QMenu;

namespace dobra::gui::view {

/// "1×", "5×" or what is typed.
class ExaggerationBox : public QComboBox {
  Q_OBJECT

 public:
  explicit ExaggerationBox(QWidget* parent);
  /// @param drawn  what the picture has, where that is not told by `exaggeration`.
  void show_value(const std::optional<double>& exaggeration, double drawn);

 signals:
  void chosen(const std::optional<double>& exaggeration);
  void refused(const QString& why);

 protected:
  void focusOutEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void take(const QString& typed);
  QString shown_;
};

class Controls : public QObject {
  Q_OBJECT

 public:
  /// Fills the menu. Actions are called "view.back", "view.grid", ... @pre `menu` outlives this.
  Controls(QMenu& menu, const Settings& settings, QObject* parent);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  void set_exaggeration(const std::optional<double>& exaggeration);

 signals:
  void changed();
  void back_asked();
  void forward_asked();
  void selection_asked();
  /// A free value is to be typed.
  void other_asked();

 private:
  /// One of several in a menu of their own.
  template <class Choice, class Chosen>
  void add_choices(QMenu& menu, const QString& title, const char* name,
                   const std::vector<std::pair<Choice, QString>>& choices, const Choice& now, Chosen&& chosen);
  QAction* add(QMenu& menu, const char* name, const QString& words, const QKeySequence& keys);
  void mark_exaggeration();

  Settings settings_;
  std::vector<std::pair<std::optional<double>, QAction*>> exaggerations_;
  QAction* other_ = nullptr;
};

}  // namespace dobra::gui::view
