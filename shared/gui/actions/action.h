#pragma once
// What a user can ask of the window, as a value: menus, tool bars, the palette and the list of keys are made from it.

#include <QKeySequence>
#include <QList>
#include <QString>
#include <functional>
#include <optional>
#include <string>

#include "shared/gui/theme/icons.h"

class QMenu;
class QWidget;

namespace dobra::gui::actions {

struct Action {
  std::string id = {};    ///< "file.open": what scripts and tests call it, and the name of its QAction.
  std::string text = {};  ///< As menus show it, English source, with the & of its letter.
  std::string help = {};  ///< A sentence, English source; none where the text says it all.
  /// Titles of the menus that lead to it, English source: "&View/&Theme". Empty: in no menu.
  std::string menu = {};
  std::string section = {};  ///< Neighbours of a menu or a bar in different sections stand apart.
  std::string bar = {};      ///< The tool bar that shows it; empty: none.
  std::optional<theme::Symbol> symbol = {};
  theme::Draw icon = nullptr;  ///< In the place of a symbol.
  QList<QKeySequence> keys = {};
  std::function<void()> run = {};
  std::function<bool()> enabled = {};        ///< Not set: always.
  std::function<bool()> checked = {};        ///< Set: it is on or off.
  std::string choice = {};                   ///< Of the checked ones with the same choice one is on.
  std::function<QString()> label = {};       ///< Set: the text as it is now, translated.
  std::function<theme::Symbol()> look = {};  ///< Set: the symbol as it is now.
  std::function<void(QMenu&)> list = {};     ///< Set: it opens a menu of its own, filled whenever it is about to show.
  QWidget* scope = nullptr;  ///< Its keys work where this widget has the focus; null: in all of the window.
};

/// English source in the language of the user.
QString shown(const std::string& source);

/// Without the & that marks the letter of a menu.
QString plain(QString words);

}  // namespace dobra::gui::actions
