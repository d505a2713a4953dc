#pragma once
// What can be done with a line, where it is clicked with the right button.

#include <QPoint>
#include <QString>
#include <functional>
#include <set>

class QWidget;

namespace dobra::gui::view {

enum class LineCommand { Rename, Kind, Delete, SplitHere, InsertVertex, Copy, ZoomTo, HideLayer };

/// Opens a menu and returns at once. Commands that are not possible are shown and cannot be chosen.
/// @param title  of the line.
void show_line_menu(const QString& title, const std::set<LineCommand>& possible, QPoint global, QWidget* parent,
                    std::function<void(LineCommand)> chosen);

}  // namespace dobra::gui::view
