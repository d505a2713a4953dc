#include "shared/gui/view/line_menu.h"

#include <QAction>
#include <QMenu>
#include <utility>

#include "shared/gui/words/words.h"

namespace dobra::gui::view {

void show_line_menu(const QString& title, const std::set<LineCommand>& possible, QPoint global, QWidget* parent,
                    std::function<void(LineCommand)> chosen) {
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
  add("rename", text("Rename..."), LineCommand::Rename);
  add("kind", text("Kind..."), LineCommand::Kind);
  menu->addSeparator();
  add("insert_vertex", text("Insert vertex here"), LineCommand::InsertVertex);
  add("split", text("Split here"), LineCommand::SplitHere);
  add("delete", text("Delete"), LineCommand::Delete);
  menu->addSeparator();
  add("copy", text("Copy"), LineCommand::Copy);
  add("zoom", text("Zoom to it"), LineCommand::ZoomTo);
  add("hide", text("Hide its layer"), LineCommand::HideLayer);
  menu->popup(global);
}

}  // namespace dobra::gui::view
