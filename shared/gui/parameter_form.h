#pragma once
// A form made from a list of fields: one row each with title, editor, unit and a button that returns the value to its
// default; what is wrong is said in red under the row. The form never changes a document: it tells what the user wants.

#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "shared/base/result.h"
#include "shared/gui/field_editor.h"
#include "shared/scenario/condition.h"

class QGridLayout;
class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace dobra::gui {

namespace labels {
class Paragraph;
}

class TablesEditor;

/// A property of the editors in a form: what the foot of the form says while they have the focus.
inline constexpr const char* hint_property = "dobra.hint";

/// The names in the model of what a field names ("fault").
using NamesOf = std::function<std::vector<std::string>(const std::string& what)>;

/// The rows of one table; fields of kind Tables hold forms of their own.
class TableForm : public QWidget {
  Q_OBJECT

 public:
  /// @param folder  where relative file names start.
  TableForm(std::vector<scenario::Field> fields, std::filesystem::path folder, QWidget* parent = nullptr);
  ~TableForm() override;

  /// Shows the values, each judged against its field. What is half typed, or was refused, stays where the value under
  /// it is the same as before.
  void set_table(const scenario::Table& table);
  [[nodiscard]] const scenario::Table& table() const { return table_; }
  [[nodiscard]] const std::vector<scenario::Field>& fields() const { return fields_; }

  /// Gives each editor of a name the names there are, now and when it is made.
  void offer(NamesOf names);

  /// Fields that hold names and places of the model get a button that asks for them (pointing_asked).
  void canvas_answers();

  /// Tells what was typed and not yet told, in all rows.
  void commit();
  /// What is said under the first row whose text is not in the table; nothing if all are.
  [[nodiscard]] std::optional<QString> unsettled() const;

  /// Does what a user does who types `text` into the editor of `key`: "count", "horizon.2.name". Empty text resets.
  /// @error UnknownKey; BadValue, the key and the message that the form shows.
  base::Result<void> type(const std::string& key, const QString& text);

  /// What is said under the row of `key` ("count", "horizon.2.name"); empty if it is good or there is no such row.
  [[nodiscard]] QString message_at(const std::string& key) const;

  /// Writes `message` under the row whose value stands at the line and column of `place`, and shows that row.
  /// @return whether there is one.
  bool mark(const base::Place& place, const QString& message);

 signals:
  /// The user set `key` to another good value, or reset it.
  void edited(const dobra::scenario::Table& table, const QString& key);
  void wants_to_be_seen(QWidget* widget);
  /// The user wants to point at what `editor` is to hold: a name, a point, or a coordinate (FieldOptions::names).
  void pointing_asked(dobra::gui::FieldEditor* editor, const dobra::scenario::Field& field);

 protected:
  /// Another theme: what is shown takes its colours.
  void changeEvent(QEvent* event) override;

 private:
  struct Row;
  void add_row(const scenario::Field& field, QGridLayout& grid);
  void make_vain(Row& row);
  void make_point_button(Row& row);
  void add_stray_rows();
  /// Fields that do not matter now are hidden, or said to have no effect where they are set.
  void show_conditions();
  [[nodiscard]] QString without_effect(const scenario::Requirement& lacking) const;
  static void name_controls(const Row& row);
  void connect_row(Row& row);
  void enter(Row& row, const scenario::Value& value);
  void reset(Row& row);
  void show_row(Row& row);
  static void say(Row& row, const QString& message);
  [[nodiscard]] const Row* find_row(const std::string& key) const;

  std::vector<scenario::Field> fields_;
  std::filesystem::path folder_;
  scenario::Table table_;
  std::vector<std::unique_ptr<Row>> rows_;
  QVBoxLayout* strays_ = nullptr;  ///< Keys of the table that no field has.
  NamesOf names_ = nullptr;
  bool canvas_answers_ = false;
};

/// The form of a step with its title and help, in a scroll area.
class ParameterForm : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterForm(QWidget* parent = nullptr);

  /// Shows a part of a document. The editors stay, with focus and cursor, if it is the same part as before.
  /// @param identity  equal for the same part: operation and position.
  void show_part(const QString& identity, const QString& title, const QString& help,
                 const std::vector<scenario::Field>& fields, const scenario::Table& table,
                 const std::filesystem::path& folder);

  /// The next part is another one, whatever its identity: nothing typed stays.
  void forget() { identity_.clear(); }

  /// As of TableForm, of every form that is shown from now on.
  void canvas_answers() { canvas_answers_ = true; }

  [[nodiscard]] TableForm* form() const { return form_; }

 signals:
  void edited(const dobra::scenario::Table& table, const QString& key);
  void pointing_asked(dobra::gui::FieldEditor* editor, const dobra::scenario::Field& field);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// What the field with the focus is for and may hold.
  void show_words();
  void show_hint(QWidget* focused);

  QString identity_;
  QLabel* title_;
  QLabel* help_;
  QScrollArea* scroll_;
  labels::Paragraph* hint_ = nullptr;
  TableForm* form_ = nullptr;
  bool canvas_answers_ = false;
};

}  // namespace dobra::gui
