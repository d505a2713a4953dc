#include "shared/gui/view/line_menu.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <utility>

namespace dobra::gui::view {

void show_line_menu(const QString& title, const std::set<LineCommand>& possible, QPoint global, QWidget* parent,
                    std::function<void(LineCommand)> chosen) {
  const auto words = [](const char* source) { return QCoreApplication::translate("dobra", source); };
  auto* menu = new QMenu(parent);
  menu->setObjectName("line_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addSection(QString(title).replace("&", "&&"));
  const auto add = [&](const char* name, const QString& label, LineCommand command) {
    QAction* action = menu->addAction(label);
    action->setObjectName(QString("line.") + name);
    action->setEnabled(possible.contains(command));
    QObject::connect(action, &QAction::triggered, parent, [chosen, command] { chosen(command); });
  };
  add("rename", words("Rename..."), LineCommand::Rename);
  add("kind", words("Kind..."), LineCommand::Kind);
  menu->addSeparator();
  add("insert_vertex", words("Insert vertex here"), LineCommand::InsertVertex);
  add("split", words("Split here"), LineCommand::SplitHere);
  add("delete", words("Delete"), LineCommand::Delete);
  menu->addSeparator();
  add("copy", words("Copy"), LineCommand::Copy);
  add("zoom", words("Zoom to it"), LineCommand::ZoomTo);
  add("hide", words("Hide its layer"), LineCommand::HideLayer);
  menu->popup(global);
}

}  // namespace dobra::gui::view
