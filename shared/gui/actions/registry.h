#pragma once
// All actions of a window. Nothing else makes a QAction that a menu, a tool bar or a key leads to.

#include <QObject>
#include <map>
#include <memory>
#include <vector>

#include "shared/gui/actions/action.h"

class QAction;
class QActionGroup;
class QMenu;
class QMenuBar;
class QToolBar;
class QWidget;

namespace dobra::gui::actions {

class Registry : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    Action action;
    QAction* made = nullptr;
    std::optional<theme::Symbol> looks = {};  ///< Its symbol now, where that changes.
  };

  /// Keys work in `window`.
  explicit Registry(QWidget& window);
  ~Registry() override;

  /// @pre no other action has the id; no other one has one of the keys in the same scope.
  QAction& add(Action action);
  /// The same for a QAction that Qt has made and keeps up to date, such as that of a panel.
  QAction& adopt(QAction& made, Action action);

  /// In the order in which they were added.
  [[nodiscard]] const std::vector<Entry>& all() const { return entries_; }
  /// Null if there is none.
  [[nodiscard]] QAction* find(const std::string& id) const;
  /// As a click in its menu does, once it is known whether it is enabled. @return false if there is no such action or
  /// it is not enabled
  bool trigger(const std::string& id);

  /// Menus in the order in which actions name them first; a later call adds what has come since.
  void fill(QMenuBar& menus);
  /// Those that name the bar, in order.
  void fill(QToolBar& bar, const std::string& name);
  /// One of the menus: "&Edit/Add a &step". Null before `fill`, or if no action names it.
  [[nodiscard]] QMenu* menu(const std::string& path) const;

  /// Asks all for what they are now: enabled, checked, how they are called.
  void refresh();

 private:
  void keep(QAction& made, Action action);
  [[nodiscard]] QMenu& menu_at(QMenuBar& menus, const std::string& path);

  QWidget& window_;
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> by_id_;
  std::map<std::string, QActionGroup*> choices_;
  std::map<std::string, QMenu*> menus_;
  std::map<const void*, std::string> last_section_;  ///< Of each menu and bar.
  std::size_t in_menus_ = 0;                         ///< So many entries have found their menu.
};

/// "File > Open Recent", translated; empty where no menu shows it.
QString menu_path(const Action& action);

/// "Ctrl+Z, Ctrl+Y" as the keyboard of the user says them.
QString keys_text(const QList<QKeySequence>& keys);

}  // namespace dobra::gui::actions
