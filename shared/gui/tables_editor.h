#pragma once
// The editor of a field of kind Tables: a list of small forms that open and close, with Add and Remove.

#include <QWidget>
#include <filesystem>
#include <vector>

#include "shared/base/result.h"
#include "shared/gui/field_editor.h"
#include "shared/scenario/field.h"

class QToolButton;
class QVBoxLayout;

namespace dobra::gui {

class TableForm;

class TablesEditor : public QWidget {
  Q_OBJECT

 public:
  TablesEditor(scenario::Field field, std::filesystem::path folder, QWidget* parent = nullptr);

  void show_tables(const std::vector<scenario::Table>& tables);
  [[nodiscard]] std::size_t count() const { return items_.size(); }
  /// @pre index < count()
  [[nodiscard]] const scenario::Table& table(std::size_t index) const { return items_[index].table; }
  /// The form of table `index`, opened. @pre index < count()
  TableForm& open(std::size_t index);
  /// The form of table `index`, made if it was not yet. @pre index < count()
  TableForm& form(std::size_t index);
  /// The forms that are made: those of tables that have been open.
  [[nodiscard]] std::vector<TableForm*> made_forms() const;
  /// As of TableForm, of all forms here.
  void canvas_answers();

 signals:
  /// A form has just been made.
  void form_made(TableForm* form);
  /// @param key  what changed: "2.name", or "" when a table was added or removed.
  void entered(const std::vector<dobra::scenario::Table>& tables, const QString& key);
  void wants_to_be_seen(QWidget* widget);
  void pointing_asked(dobra::gui::FieldEditor* editor, const dobra::scenario::Field& field);

 private:
  struct Item {
    QWidget* frame = nullptr;
    QToolButton* header = nullptr;
    QToolButton* remove = nullptr;
    scenario::Table table;
    TableForm* form = nullptr;  ///< None before the table is opened.
    bool by_itself = false;     ///< It was opened because the table was new, and nobody has done anything to it.
  };
  void add_item();
  void open_by_itself(std::size_t index);
  [[nodiscard]] std::size_t position_of(const QWidget* frame) const;
  void remove_item(std::size_t index);
  void retitle(std::size_t index);
  [[nodiscard]] std::vector<scenario::Table> tables() const;

  scenario::Field field_;
  std::filesystem::path folder_;
  std::vector<Item> items_;
  bool canvas_answers_ = false;
  QVBoxLayout* list_;
};

}  // namespace dobra::gui
