#include "shared/gui/parameter_form.h"

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "shared/base/text.h"
#include "shared/gui/field_editor.h"
#include "shared/gui/importing/file_filter.h"
#include "shared/gui/labels/labels.h"
#include "shared/gui/messages.h"
#include "shared/gui/numbers/numbers.h"
#include "shared/gui/tables_editor.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/theme/icons.h"
#include "shared/scenario/condition.h"
#include "shared/scenario/units.h"

namespace dobra::gui {

using scenario::Field;
using scenario::Kind;
using scenario::Table;
using scenario::Value;

struct TableForm::Row {
  Field field;
  FieldEditor* editor = nullptr;   ///< Either this ...
  TablesEditor* tables = nullptr;  ///< ... or this, for kind Tables.
  QLabel* title = nullptr;
  QLabel* unit = nullptr;
  QToolButton* point = nullptr;  ///< Asks for a name or a place of the canvas; none where there is no such.
  QToolButton* reset = nullptr;
  QLabel* message = nullptr;
  QWidget* vain = nullptr;  ///< That the value has no effect, with a button that removes it.
  QLabel* vain_words = nullptr;
  bool shown = false;  ///< Its editor shows a value of the table.
};

namespace {

constexpr int title_column = 0;
constexpr int editor_column = 1;
constexpr int unit_column = 2;
constexpr int point_column = 3;
constexpr int reset_column = 4;
constexpr int columns = 5;

/// @param unit  of the field, as its table has it
QString unit_of(const Field& field, const std::string& unit) {
  return field.kind == Kind::Degrees ? QString::fromUtf8("°") : numbers::unit_text(unit);
}

/// A default as the editor shows it.
QString said_value(const Field& field, const QString& value) {
  if (field.kind == Kind::Choice) return choice_text(field, value.toStdString());
  if (field.kind == Kind::Flag) return value == "true" ? text("yes") : text("no");
  return value;
}

/// What a value may be, and what it is where none is given.
QStringList range_of(const Field& field) {
  const scenario::FieldOptions& options = field.options;
  QStringList range;
  if (options.above) range << text("greater than %1").arg(numbers::whole(*options.above));
  if (options.at_least) range << text("at least %1").arg(numbers::whole(*options.at_least));
  if (options.at_most) range << text("at most %1").arg(numbers::whole(*options.at_most));
  if (options.other_than) range << text("not %1").arg(numbers::whole(*options.other_than));
  for (const std::string& word : options.words) range << QString::fromStdString(word);
  for (const scenario::FileKind& kind : options.files) range << importing::filter_of(kind);
  if (options.presence == scenario::Presence::Required) range << text("required");
  if (field.default_value) {
    const QString value = numbers::field_text(field.kind, *field.default_value);
    if (!value.isEmpty() && value.size() < 40) range << text("default %1").arg(said_value(field, value));
  }
  return range;
}

/// "Distance: how far ...; greater than 0 m, default 50 m".
QString hint_of(const Field& field, const QString& unit) {
  QString hint = text(field.options.title);
  if (field.options.help[0] != '\0') hint += ": " + text(field.options.help);
  QStringList range = range_of(field);
  if (!range.isEmpty() && !unit.isEmpty()) range.last() += " " + unit;
  if (!range.isEmpty()) {
    range.front()[0] = range.front()[0].toUpper();
    hint += (hint.endsWith('.') ? " " : ". ") + range.join(", ") + ".";
  }
  return hint;
}

QString tool_tip_of(const Field& field) {
  const scenario::FieldOptions& options = field.options;
  QStringList range = range_of(field);
  QString tip = "<p style='white-space:pre-wrap'><b>" + QString::fromStdString(field.key).toHtmlEscaped() + "</b>";
  if (options.help[0] != '\0') tip += "<br>" + text(options.help).toHtmlEscaped();
  if (!range.isEmpty()) tip += "<br><i>" + range.join(", ").toHtmlEscaped() + "</i>";
  return tip + "</p>";
}

/// Judges the value of one field as if the table held nothing else. What is still to be given is not wrong.
QString judge(const Field& field, const Value* value) {
  if (value == nullptr) return {};
  Table alone;
  alone.set(field.key, *value);
  const base::Result<void> good = scenario::check(alone, {field}, {});
  return good ? QString() : QString::fromStdString(good.error().message);
}

bool is_at(const base::Place& place, const base::Place& wanted) {
  return wanted.line > 0 && place.line == wanted.line && (wanted.column == 0 || place.column == wanted.column);
}

/// Whether the canvas can give the value of a field.
bool is_pointed_at(const Field& field) {
  if (field.kind == Kind::Point) return true;
  const std::string& names = field.options.names;
  if (field.kind == Kind::Number) return names == "x" || names == "z";
  return !names.empty() && (field.kind == Kind::Text || field.kind == Kind::Texts);
}

/// "horizon.2.name" as "horizon", 2 and "name"; the index is 0 where there is none.
struct KeyPath {
  std::string head;
  std::size_t index = 0;
  std::string tail;
};

KeyPath split(const std::string& key) {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos) return {key, 0, {}};
  const std::size_t second = key.find('.', dot + 1);
  if (second == std::string::npos) return {key, 0, {}};
  const std::optional<double> index = base::parse_number(key.substr(dot + 1, second - dot - 1));
  return {key.substr(0, dot), index && *index >= 1 ? static_cast<std::size_t>(*index) : 0, key.substr(second + 1)};
}

}  // namespace

TableForm::TableForm(std::vector<Field> fields, std::filesystem::path folder, QWidget* parent)
    : QWidget(parent), fields_(std::move(fields)), folder_(std::move(folder)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(title_column, 5);
  grid->setColumnStretch(editor_column, 6);
  for (const Field& field : fields_) add_row(field, *grid);
  column->addLayout(grid);
  strays_ = new QVBoxLayout;
  column->addLayout(strays_);
  if (fields_.empty()) {
    auto* nothing = new QLabel(text("Nothing to set."), this);
    nothing->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(nothing);
  }
}

TableForm::~TableForm() = default;

void TableForm::add_row(const Field& field, QGridLayout& grid) {
  auto row = std::make_unique<Row>();
  row->field = field;
  QString title = field.options.title[0] != '\0' ? text(field.options.title) : QString::fromStdString(field.key);
  row->title = new QLabel(title, this);
  row->title->setWordWrap(true);
  row->title->setToolTip(tool_tip_of(field));
  row->message = new QLabel(this);
  row->message->setWordWrap(true);
  row->message->setStyleSheet("color: " + theme::wrong_text(palette()).name());
  row->message->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->message->hide();

  const int line = grid.rowCount();
  make_vain(*row);
  if (field.kind == Kind::Tables) {
    row->tables = new TablesEditor(field, folder_, this);
    grid.addWidget(row->title, line, title_column, 1, columns);
    grid.addWidget(row->tables, line + 1, title_column, 1, columns);
  } else {
    row->editor = make_field_editor(field, folder_, this);
    row->editor->setToolTip(tool_tip_of(field));
    row->editor->setObjectName("editor." + QString::fromStdString(field.key));
    row->title->setBuddy(row->editor);
    row->reset = new QToolButton(this);
    row->reset->setText(QString::fromUtf8("↺"));
    row->reset->setAutoRaise(true);
    row->reset->setToolTip(text("Return to the default"));
    row->reset->setObjectName("reset." + QString::fromStdString(field.key));
    QSizePolicy policy = row->reset->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    row->reset->setSizePolicy(policy);
    if (is_pointed_at(field)) make_point_button(*row);
    if (field.kind == Kind::Points) {
      grid.addWidget(row->title, line, title_column, 1, 3);
      grid.addWidget(row->reset, line, reset_column);
      grid.addWidget(row->editor, line + 1, title_column, 1, columns);
    } else {
      const int width = unit_of(field, field.options.unit).isEmpty() ? 2 : 1;
      grid.addWidget(row->title, line, title_column);
      grid.addWidget(row->editor, line, editor_column, 1, width + (row->point == nullptr && width == 2 ? 1 : 0));
      if (width == 1) {
        row->unit = new QLabel(this);
        grid.addWidget(row->unit, line, unit_column);
      }
      if (row->point != nullptr) grid.addWidget(row->point, line, point_column);
      grid.addWidget(row->reset, line, reset_column);
    }
  }
  grid.addWidget(row->message, line + 2, title_column, 1, columns);
  grid.addWidget(row->vain, line + 3, title_column, 1, columns);
  name_controls(*row);
  connect_row(*row);
  rows_.push_back(std::move(row));
}

void TableForm::make_vain(Row& row) {
  row.vain = new QWidget(this);
  auto* layout = new QHBoxLayout(row.vain);
  layout->setContentsMargins(0, 0, 0, 0);
  row.vain_words = new QLabel(row.vain);
  row.vain_words->setWordWrap(true);
  row.vain_words->setForegroundRole(QPalette::PlaceholderText);
  auto* remove = new QToolButton(row.vain);
  remove->setText(text("Remove"));
  remove->setObjectName("remove." + QString::fromStdString(row.field.key));
  remove->setAccessibleName(row.title->text() + ": " + text("Remove"));
  layout->addWidget(row.vain_words, 1);
  layout->addWidget(remove);
  row.vain->hide();
  connect(remove, &QToolButton::clicked, this, [this, &row] { reset(row); });
}

void TableForm::make_point_button(Row& row) {
  row.point = new QToolButton(this);
  row.point->setIcon(theme::icon(theme::Symbol::Point));
  row.point->setAutoRaise(true);
  row.point->setToolTip(text("Point at it on the canvas"));
  row.point->setObjectName("point." + QString::fromStdString(row.field.key));
  row.point->setAccessibleName(row.title->text() + ": " + row.point->toolTip());
  row.point->hide();  // until somebody listens: canvas_answers
  connect(row.point, &QToolButton::clicked, this, [this, &row] { emit pointing_asked(row.editor, row.field); });
}

void TableForm::canvas_answers() {
  canvas_answers_ = true;
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->tables != nullptr) row->tables->canvas_answers();
  }
  show_conditions();
}

void TableForm::show_conditions() {
  for (const std::unique_ptr<Row>& row : rows_) {
    const std::optional<scenario::Requirement> lacking = scenario::unmet(row->field, table_, fields_);
    const bool set = table_.find(row->field.key) != nullptr;
    const bool shown = !lacking || set || (row->editor != nullptr && row->editor->unsettled());
    row->title->setVisible(shown);
    row->title->setEnabled(!lacking);
    const QString unit = unit_of(row->field, scenario::si_unit(row->field, table_, fields_));
    if (row->unit != nullptr) {
      row->unit->setText(unit);
      row->unit->setVisible(shown);
    }
    if (row->editor != nullptr) row->editor->setProperty(hint_property, hint_of(row->field, unit));
    if (row->point != nullptr) row->point->setVisible(shown && !lacking && canvas_answers_);
    QWidget* editor = row->tables != nullptr ? static_cast<QWidget*>(row->tables) : row->editor;
    editor->setVisible(shown);
    editor->setEnabled(!lacking);
    if (row->reset != nullptr) {
      QSizePolicy policy = row->reset->sizePolicy();
      policy.setRetainSizeWhenHidden(shown);  // a row that is not shown takes no room
      row->reset->setSizePolicy(policy);
      row->reset->setVisible(set && !lacking);
    }
    row->vain->setVisible(set && lacking);
    if (lacking) row->vain_words->setText(without_effect(*lacking));
    row->message->setVisible(shown && !row->message->text().isEmpty());
  }
}

/// What keeps a value from having an effect, in the words of the form.
QString TableForm::without_effect(const scenario::Requirement& lacking) const {
  const auto field =
      std::find_if(fields_.begin(), fields_.end(), [&](const Field& other) { return other.key == lacking.key; });
  const QString title = field == fields_.end() ? QString::fromStdString(lacking.key) : text(field->options.title);
  const std::optional<std::string> word = scenario::word_of(lacking.key, table_, fields_);
  if (lacking.is == scenario::Requirement::Is::Set || !word || field == fields_.end())
    return text("Has no effect without '%1'.").arg(title);
  return text("Has no effect with '%1': %2.").arg(title, said_value(*field, QString::fromStdString(*word)));
}

/// For those who hear the form: its controls are called as the row is, its buttons by what they do to it.
void TableForm::name_controls(const Row& row) {
  if (row.editor == nullptr) return;
  const QString title = row.title->text();
  row.reset->setAccessibleName(title + ": " + row.reset->toolTip());
  for (QWidget* control : row.editor->findChildren<QWidget*>()) {
    const auto* button = qobject_cast<QToolButton*>(control);
    if (control->focusPolicy() == Qt::NoFocus) continue;
    control->setAccessibleName(button != nullptr ? title + ": " + button->toolTip() : title);
    if (button == nullptr) control->setAccessibleDescription(text(row.field.options.help));
  }
}

void TableForm::connect_row(Row& row) {
  if (row.tables != nullptr) {
    connect(row.tables, &TablesEditor::wants_to_be_seen, this, &TableForm::wants_to_be_seen);
    connect(row.tables, &TablesEditor::pointing_asked, this, &TableForm::pointing_asked);
    connect(row.tables, &TablesEditor::form_made, this, [this](TableForm* form) {
      if (names_) form->offer(names_);
    });
    connect(row.tables, &TablesEditor::entered, this,
            [this, &row](const std::vector<Table>& tables, const QString& key) {
              if (tables.empty())
                table_.erase(row.field.key);
              else
                table_.set(row.field.key, tables);
              show_conditions();
              const QString own = QString::fromStdString(row.field.key);
              emit edited(table_, key.isEmpty() ? own : own + "." + key);
            });
    return;
  }
  connect(row.editor, &FieldEditor::entered, this, [this, &row](const Value& value) { enter(row, value); });
  connect(row.editor, &FieldEditor::emptied, this, [this, &row] { reset(row); });
  connect(row.editor, &FieldEditor::rejected, this, [&row](const QString& message) { say(row, message); });
  connect(row.reset, &QToolButton::clicked, this, [this, &row] { reset(row); });
}

void TableForm::enter(Row& row, const Value& value) {
  const QString wrong = judge(row.field, &value);
  say(row, wrong);
  if (!wrong.isEmpty()) return;
  const Value* before = table_.find(row.field.key);
  const bool same = before != nullptr && *before == value;
  if (!same) table_.set(row.field.key, value);
  show_row(row);
  show_conditions();
  if (same) return;
  emit edited(table_, QString::fromStdString(row.field.key));
}

void TableForm::reset(Row& row) {
  const bool had_value = table_.find(row.field.key) != nullptr;
  table_.erase(row.field.key);
  show_row(row);
  show_conditions();
  if (had_value) emit edited(table_, QString::fromStdString(row.field.key));
}

void TableForm::show_row(Row& row) {
  row.shown = true;
  const Value* written = table_.find(row.field.key);
  QString wrong = judge(row.field, written);
  // In the one type of the field's kind; nothing if it is written as another kind, which `wrong` then says.
  const std::optional<Value> value = written != nullptr ? scenario::as_kind(*written, row.field.kind) : std::nullopt;
  if (row.tables != nullptr) {
    row.tables->show_tables(value ? std::get<std::vector<Table>>(*value) : std::vector<Table>{});
    // What is wrong inside a table is said inside its own form.
    if (value) wrong.clear();
  } else {
    if (written != nullptr)
      row.editor->show_value(value, FieldEditor::Origin::Document);
    else
      row.editor->show_value(row.field.default_value, FieldEditor::Origin::Default);
  }
  say(row, wrong);
}

void TableForm::say(Row& row, const QString& message) {
  row.message->setText(in_words_of_the_form(message, {row.field}));
  row.message->setVisible(!message.isEmpty());
  if (row.editor == nullptr) return;
  row.editor->show_judgement(message.isEmpty() ? FieldEditor::Judgement::Good : FieldEditor::Judgement::Bad);
}

void TableForm::set_table(const Table& table) {
  const Table before = std::exchange(table_, table);
  for (const std::unique_ptr<Row>& row : rows_) {
    const Value* was = before.find(row->field.key);
    const Value* is = table_.find(row->field.key);
    const bool same = (was == nullptr) == (is == nullptr) && (is == nullptr || *was == *is);
    // An edit touches what it changes: a row that shows its value stays, and so does what is half typed in it.
    const bool stays =
        same && row->shown && row->editor != nullptr && (row->editor->unsettled() || row->message->text().isEmpty());
    if (!stays) show_row(*row);
  }
  show_conditions();
  add_stray_rows();
}

void TableForm::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->shown && row->editor != nullptr && !row->editor->unsettled()) show_row(*row);
  }
}

void TableForm::commit() {
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->editor != nullptr) row->editor->commit();
    if (row->tables == nullptr) continue;
    for (TableForm* form : row->tables->made_forms()) form->commit();
  }
}

std::optional<QString> TableForm::unsettled() const {
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->editor != nullptr && row->editor->unsettled()) return row->message->text();
    if (row->tables == nullptr) continue;
    for (const TableForm* form : row->tables->made_forms()) {
      if (std::optional<QString> inside = form->unsettled()) return inside;
    }
  }
  return std::nullopt;
}

void TableForm::offer(NamesOf names) {
  names_ = std::move(names);
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->editor != nullptr && !row->field.options.names.empty())
      row->editor->offer(names_(row->field.options.names));
    if (row->tables == nullptr) continue;
    for (TableForm* form : row->tables->made_forms()) form->offer(names_);
  }
}

void TableForm::add_stray_rows() {
  while (QLayoutItem* item = strays_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  for (const Table::Entry& entry : table_.entries()) {
    const auto has_key = [&](const Field& field) { return field.key == entry.key; };
    if (std::any_of(fields_.begin(), fields_.end(), has_key)) continue;
    auto* line = new QWidget(this);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* words = new QLabel(text("'%1' is not a parameter here").arg(QString::fromStdString(entry.key)), line);
    words->setStyleSheet("color: " + theme::wrong_text(palette()).name());
    words->setWordWrap(true);
    auto* remove = new QToolButton(line);
    remove->setText(text("Remove"));
    layout->addWidget(words, 1);
    layout->addWidget(remove);
    strays_->addWidget(line);
    connect(remove, &QToolButton::clicked, this, [this, key = entry.key] {
      table_.erase(key);
      emit edited(table_, QString::fromStdString(key));
    });
  }
}

const TableForm::Row* TableForm::find_row(const std::string& key) const {
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->field.key == key) return row.get();
  }
  return nullptr;
}

base::Result<void> TableForm::type(const std::string& key, const QString& typed) {
  const KeyPath path = split(key);
  const Row* found = find_row(path.head);
  if (found == nullptr) {
    std::vector<std::string> keys;
    for (const Field& field : fields_) keys.push_back(field.key);
    return base::Error{base::ErrorCode::UnknownKey,
                       text("no parameter '%1' here").arg(QString::fromStdString(path.head)).toStdString() +
                           base::did_you_mean(path.head, keys)};
  }
  if (found->tables != nullptr) {
    if (path.index == 0 || path.index > found->tables->count()) {
      const QString said = text("'%1' has %2 tables; write %1.NUMBER.KEY").arg(QString::fromStdString(path.head));
      return base::Error{base::ErrorCode::UnknownKey, said.arg(found->tables->count()).toStdString()};
    }
    return found->tables->open(path.index - 1).type(path.tail, typed);
  }
  emit wants_to_be_seen(found->editor);
  if (typed.isEmpty())
    found->reset->click();
  else
    found->editor->type(typed);
  if (found->message->text().isEmpty()) return {};
  return base::Error{base::ErrorCode::BadValue, key + ": " + found->message->text().toStdString()};
}

QString TableForm::message_at(const std::string& key) const {
  const KeyPath path = split(key);
  const Row* row = find_row(path.head);
  if (row == nullptr) return {};
  if (row->tables != nullptr && path.index >= 1 && path.index <= row->tables->count()) {
    return row->tables->form(path.index - 1).message_at(path.tail);
  }
  return row->message->text();
}

bool TableForm::mark(const base::Place& place, const QString& message) {
  for (const std::unique_ptr<Row>& row : rows_) {
    if (row->tables != nullptr) {
      for (std::size_t i = 0; i < row->tables->count(); ++i) {
        const std::vector<Table::Entry>& entries = row->tables->table(i).entries();
        const auto here = [&](const Table::Entry& entry) { return is_at(entry.place, place); };
        if (!std::any_of(entries.begin(), entries.end(), here)) continue;
        return row->tables->open(i).mark(place, message);
      }
    } else if (table_.find(row->field.key) != nullptr && is_at(table_.place(row->field.key), place)) {
      say(*row, message);
      emit wants_to_be_seen(row->message);
      return true;
    }
  }
  return false;
}

}  // namespace dobra::gui
