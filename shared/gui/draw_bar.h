#pragma once
// The tools of the canvas to choose from, and the question what was drawn.

#include <QDialog>
#include <QToolBar>

#include "shared/canvas/tool.h"
#include "shared/gui/actions/registry.h"
#include "shared/gui/session.h"
#include "shared/gui/window_part.h"
#include "shared/scenario/program.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace dobra::gui {

class Canvas;

/// One button a tool; the menu Draw has the same actions.
class DrawBar : public QToolBar {
  Q_OBJECT

 public:
  /// Adds the tools, those of the program too, and their switches to `actions`.
  DrawBar(const Desk& desk, const std::vector<ToolPart>& of_program, actions::Registry& actions, QWidget* parent);

 private:
  using Make = std::function<std::unique_ptr<canvas::Tool>()>;
  void add_tool(const char* section, const char* name, const char* words, theme::Symbol symbol, int key, Make make);
  /// With what taking up a tool needs.
  void add_tool(const std::string& name, Make make, actions::Action action);
  void add_tools();
  void add_tools(const std::vector<ToolPart>& of_program);
  void add_tools_of_lines();
  void add_switches();
  void ask(const canvas::Drawn& what);
  void ask_name(const QString& table, const QString& name);
  void ask_which(const canvas::Asked& what);

  Session& session_;
  Canvas& canvas_;
  actions::Registry& actions_;
  std::string in_hand_;  ///< The id of the tool that was taken up last.
  std::string last_kind_;
};

/// "Horizon" called "H 3": what a new line is.
class NewLine : public QDialog {
  Q_OBJECT

 public:
  /// @param kinds  those that may be chosen. @pre not empty
  /// @param add    makes the document with the new line.
  NewLine(std::vector<scenario::Drawing::Kind> kinds, const std::string& chosen,
          std::function<base::Result<void>(const std::string& kind, const std::string& name)> add, QWidget* parent);

  [[nodiscard]] std::string kind() const;
  /// What it is called unless the user says otherwise.
  void propose(const QString& name);
  /// Of the button that takes what is said.
  void call_button(const QString& words);

 private:
  void try_to_add();

  std::vector<scenario::Drawing::Kind> kinds_;
  std::function<base::Result<void>(const std::string&, const std::string&)> add_;
  QComboBox* kind_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* refused_ = nullptr;
  QPushButton* add_button_ = nullptr;
};

}  // namespace dobra::gui
