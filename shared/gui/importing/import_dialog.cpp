#include "shared/gui/importing/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "shared/base/text.h"
#include "shared/gui/importing/import_preview.h"
#include "shared/gui/importing/line_list.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::importing {

namespace {

constexpr int pause_ms = 200;
constexpr std::size_t most_remarks = 4;

QString file_name(const std::filesystem::path& path) { return QString::fromStdString(path.filename().string()); }

/// The four numbers; nothing where there are others or none.
std::optional<std::vector<double>> numbers_in(const QString& typed) {
  std::vector<double> numbers;
  for (const QString& word : typed.split(QRegularExpression("[;\\s]+"), Qt::SkipEmptyParts)) {
    const auto number = base::parse_number(QString(word).replace(',', '.').toStdString());
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

void name_widget(QWidget* widget, const char* name, const QString& words) {
  widget->setObjectName(QString("import.") + name);
  widget->setAccessibleName(words);
}

/// A list whose width does not follow its longest entry.
QComboBox* narrow_choice() {
  auto* made = new QComboBox;
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setMinimumContentsLength(10);
  return made;
}

}  // namespace

ImportDialog::ImportDialog(const scenario::Program& program, const scenario::Document& document,
                           const std::vector<std::filesystem::path>& files, Wording wording, QWidget* parent)
    : QDialog(parent), model_(program, document, files), wording_(std::move(wording)) {
  setObjectName("import.dialog");
  setWindowTitle(files.size() == 1 ? text("Import %1").arg(file_name(files.front()))
                                   : text("Import %1 files").arg(files.size()));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(6);
  column->addWidget(make_file_row());
  tabs_ = new QTabWidget;
  name_widget(tabs_, "tabs", text("Lines and reading"));
  tabs_->addTab(make_lines_page(), text("What the lines are"));
  tabs_->addTab(make_reading_page(), text("How the file is read"));
  preview_ = new ImportPreview;
  auto* halves = new QSplitter(Qt::Horizontal);
  halves->addWidget(tabs_);
  halves->addWidget(preview_);
  halves->setStretchFactor(0, 3);
  halves->setStretchFactor(1, 2);
  halves->setChildrenCollapsible(false);
  column->addWidget(halves, 1);
  message_ = new QLabel;
  name_widget(message_, "message", text("What is in the way"));
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* room = new QScrollArea;
  room->setWidget(message_);
  room->setWidgetResizable(true);
  room->setFrameShape(QFrame::NoFrame);
  room->setFixedHeight(3 * fontMetrics().lineSpacing() + 6);
  room->setFocusPolicy(Qt::NoFocus);
  column->addWidget(room);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setText(text("Import"));
  ok_->setObjectName("import.ok");
  buttons->button(QDialogButtonBox::Cancel)->setText(text("Cancel"));
  buttons->button(QDialogButtonBox::Cancel)->setObjectName("import.cancel");
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    judge();  // what was changed a moment ago
    if (made_) accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(preview_, &ImportPreview::clicked, this, [this](std::size_t line) {
    lines_->selectRow(static_cast<int>(line));
    lines_->setFocus();
  });
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &ImportDialog::judge);
  show_file(0);
  judge();
  const QSize most = screen()->availableSize() - QSize(20, 40);
  resize(QSize(960, 600).boundedTo(most));
}

QWidget* ImportDialog::make_file_row() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  take_ = new QCheckBox(text("Import this file"));
  take_->setObjectName("import.take_file");
  files_ = narrow_choice();
  name_widget(files_, "files", text("File"));
  for (std::size_t i = 0; i < model_.size(); ++i) {
    files_->addItem(file_name(model_.path(i)));
    files_->setItemData(static_cast<int>(i), QString::fromStdString(model_.path(i).string()), Qt::ToolTipRole);
  }
  line->addWidget(files_, 1);
  line->addWidget(take_);
  connect(files_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index >= 0) show_file(static_cast<std::size_t>(index));
  });
  connect(take_, &QCheckBox::toggled, this, [this](bool on) {
    if (showing_) return;
    model_.take(file_, on);
    changed();
  });
  row->setVisible(model_.size() > 1);
  return row;
}

QWidget* ImportDialog::make_lines_page() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(6, 6, 6, 6);
  list_ = new LineList(model_, this);
  lines_ = new QTableView;
  name_widget(lines_, "lines", text("Lines of the file"));
  lines_->setModel(list_);
  lines_->setSelectionBehavior(QAbstractItemView::SelectRows);
  lines_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  lines_->setTabKeyNavigation(false);
  lines_->verticalHeader()->hide();
  lines_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  lines_->horizontalHeader()->setSectionResizeMode(LineList::Name, QHeaderView::Stretch);
  for (const int fitted : {LineList::Kind, LineList::From, LineList::Points})
    lines_->horizontalHeader()->setSectionResizeMode(fitted, QHeaderView::ResizeToContents);
  column->addWidget(lines_, 1);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  kind_ = narrow_choice();
  name_widget(kind_, "kind", text("Kind of the selected lines"));
  form->addRow(text("Selected lines are"), kind_);
  pattern_ = new QLineEdit;
  name_widget(pattern_, "pattern", text("Pattern of names"));
  pattern_->setPlaceholderText(text("such as *fault*"));
  pattern_->setToolTip(text("* stands for any text, ? for one character; capitals count"));
  pattern_kind_ = narrow_choice();
  name_widget(pattern_kind_, "pattern_kind", text("Kind of the lines that fit the pattern"));
  for (const auto& kind : model_.importing().kinds)
    pattern_kind_->addItem(text(kind.title.c_str()), QString::fromStdString(kind.name));
  pattern_kind_->setMinimumContentsLength(6);
  pattern_->setMinimumWidth(10 * fontMetrics().averageCharWidth());
  apply_ = new QPushButton(text("Apply"));
  apply_->setObjectName("import.apply");
  apply_->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(pattern_, 2);
  row->addWidget(pattern_kind_, 2);
  row->addWidget(apply_);
  form->addRow(text("Names like"), row);
  column->addLayout(form);
  rules_ = new QLabel;
  name_widget(rules_, "rules", text("Patterns"));
  rules_->setWordWrap(true);
  column->addWidget(rules_);
  connect(list_, &LineList::ticked, this, &ImportDialog::changed);
  connect(lines_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ImportDialog::selection_changed);
  connect(kind_, &QComboBox::activated, this, &ImportDialog::choose_kind);
  connect(apply_, &QPushButton::clicked, this, &ImportDialog::apply_rule);
  connect(pattern_, &QLineEdit::textChanged, this,
          [this](const QString& typed) { apply_->setEnabled(!typed.isEmpty()); });
  apply_->setEnabled(false);
  pattern_->installEventFilter(this);
  return page;
}

QComboBox* ImportDialog::add_choice(QFormLayout* form, const QString& title, const char* name) {
  QComboBox* made = narrow_choice();
  name_widget(made, name, title);
  form->addRow(title, made);
  connect(made, &QComboBox::activated, this, &ImportDialog::read_again);
  return made;
}

QWidget* ImportDialog::make_reading_page() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(6, 6, 6, 6);
  table_ = new QTableWidget;
  name_widget(table_, "table", text("First rows of the file"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
  column->addWidget(table_);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  x_ = add_choice(form, text("Column of x"), "x");
  map_y_ = add_choice(form, text("Column of y on the map"), "map_y");
  map_y_->setToolTip(text("Where x and y are places on the map, the lines are laid into their vertical plane."));
  height_ = add_choice(form, text("Column of heights or depths"), "height");
  names_ = add_choice(form, text("Column of names"), "names");
  separator_ = add_choice(form, text("Columns are separated by"), "separator");
  const std::pair<const char*, QString> separators[] = {{"", text("what the file shows")},
                                                        {"blank", text("blanks")},
                                                        {"tab", text("tabs")},
                                                        {"comma", text("commas")},
                                                        {"semicolon", text("semicolons")}};
  for (const auto& [name, words] : separators) separator_->addItem(words, name);
  axis_ = add_choice(form, text("Second coordinate"), "axis");
  axis_->addItem(text("as the file says, else a height"), "");
  axis_->addItem(text("height: grows upwards"), "up");
  axis_->addItem(text("depth: grows downwards"), "down");
  unit_ = add_choice(form, text("Unit of the coordinates"), "unit");
  unit_->addItem(text("as the file and the scenario say"), "");
  for (const std::string& unit : model_.importing().units)
    unit_->addItem(QString::fromStdString(unit), QString::fromStdString(unit));
  corners_ = new QLineEdit;
  name_widget(corners_, "corners", text("Corners of the picture"));
  corners_->setPlaceholderText(text("x and height, lower left; upper right"));
  form->addRow(text("Corners of the picture"), corners_);
  reading_ = form;
  connect(corners_, &QLineEdit::textEdited, this, &ImportDialog::read_again);
  all_alike_ = new QPushButton(text("Read all files like this one"));
  all_alike_->setObjectName("import.all_alike");
  all_alike_->setAutoDefault(false);
  connect(all_alike_, &QPushButton::clicked, this, [this] {
    model_.read_all_as(file_);
    changed();
  });
  form->addRow(all_alike_);
  column->addLayout(form);
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  return scroll;
}

void ImportDialog::show_file(std::size_t file) {
  file_ = file;
  list_->show_file(file);
  show_reading();
  show_lines();
  // What must be answered first.
  const scenario::ImportLook& look = model_.look(file);
  if (look.error || look.picture) tabs_->setCurrentIndex(1);
}

void ImportDialog::show_reading() {
  showing_ = true;
  const scenario::ImportLook& look = model_.look(file_);
  const scenario::ImportReading& reading = model_.reading(file_);
  take_->setChecked(model_.taken(file_));
  show_table();
  const bool columns = look.table.has_value();
  for (QComboBox* choice : {x_, map_y_, height_, names_, separator_}) choice->setEnabled(columns);
  for (QComboBox* choice : {axis_, unit_}) choice->setEnabled(look.asks_reading);
  const auto pick = [](QComboBox* choice, const std::string& value) {
    choice->setCurrentIndex(std::max(0, choice->findData(QString::fromStdString(value))));
  };
  pick(separator_, reading.separator);
  pick(axis_, reading.y_axis);
  pick(unit_, reading.unit);
  reading_->setRowVisible(corners_, look.picture.has_value());
  for (QComboBox* choice : {x_, map_y_, height_, names_, separator_}) reading_->setRowVisible(choice, columns);
  all_alike_->setVisible(model_.size() > 1);
  all_alike_->setEnabled(look.asks_reading);
  showing_ = false;
}

void ImportDialog::show_table() {
  const std::optional<scenario::ImportTable>& table = model_.look(file_).table;
  table_->clear();
  table_->setVisible(table.has_value());
  for (QComboBox* choice : {x_, map_y_, height_, names_}) choice->clear();
  if (!table) return;
  std::size_t count = table->header.size();
  for (const auto& row : table->rows) count = std::max(count, row.size());
  table_->setColumnCount(static_cast<int>(count));
  table_->setRowCount(static_cast<int>(table->rows.size()));
  names_->addItem(text("none, or as the header says"), 0);
  map_y_->addItem(text("none: x runs along the section"), 0);
  const std::size_t map_y = model_.reading(file_).map_y;
  for (std::size_t c = 0; c < count; ++c) {
    const QString title = c < table->header.size() && !table->header[c].empty()
                              ? QString("%1: %2").arg(c + 1).arg(QString::fromStdString(table->header[c]))
                              : QString::number(c + 1);
    QString role;
    if (c + 1 == table->x) role = "x";
    if (c + 1 == table->height) role = model_.reading(file_).y_axis == "down" ? text("depth") : text("height");
    if (c + 1 == map_y) role = "y";
    if (c + 1 == table->names) role = text("name");
    auto* head = new QTableWidgetItem(role.isEmpty() ? title : title + "\n→ " + role);
    QFont font = table_->font();
    font.setBold(!role.isEmpty());
    head->setFont(font);
    table_->setHorizontalHeaderItem(static_cast<int>(c), head);
    for (QComboBox* choice : {x_, map_y_, height_, names_}) choice->addItem(title, static_cast<int>(c + 1));
    for (std::size_t r = 0; r < table->rows.size(); ++r) {
      const auto& row = table->rows[r];
      table_->setItem(static_cast<int>(r), static_cast<int>(c),
                      new QTableWidgetItem(c < row.size() ? QString::fromStdString(row[c]) : QString()));
    }
  }
  x_->setCurrentIndex(static_cast<int>(table->x) - 1);
  height_->setCurrentIndex(static_cast<int>(table->height) - 1);
  map_y_->setCurrentIndex(static_cast<int>(map_y));
  names_->setCurrentIndex(static_cast<int>(model_.reading(file_).names));
  table_->resizeColumnsToContents();
  const int rows = std::min<int>(5, static_cast<int>(table->rows.size()));
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         rows * table_->verticalHeader()->defaultSectionSize() +
                         table_->horizontalScrollBar()->sizeHint().height() + 4);
}

void ImportDialog::show_lines() {
  const scenario::ImportLook& look = model_.look(file_);
  list_->refresh();
  preview_->show_look(&look, model_.choices(file_));
  QStringList rules;
  for (const scenario::ImportRule& rule : model_.rules(file_))
    rules.push_back(text("%1 is %2").arg(QString::fromStdString(rule.pattern), kind_title(model_, rule.kind)));
  rules_->setText(rules.join(", "));
  rules_->setVisible(!rules.isEmpty());
  const bool lines = !look.lines.empty();
  for (QWidget* widget :
       {static_cast<QWidget*>(lines_), static_cast<QWidget*>(pattern_), static_cast<QWidget*>(pattern_kind_)})
    widget->setEnabled(lines);
  selection_changed();
}

void ImportDialog::read_again() {
  if (showing_) return;
  scenario::ImportReading reading = model_.reading(file_);
  const bool other_separator = reading.separator != separator_->currentData().toString().toStdString();
  reading.separator = separator_->currentData().toString().toStdString();
  reading.y_axis = axis_->currentData().toString().toStdString();
  reading.unit = unit_->currentData().toString().toStdString();
  const auto column = [](QComboBox* choice) {
    return choice->currentIndex() < 0 ? std::size_t{0} : static_cast<std::size_t>(choice->currentData().toInt());
  };
  if (other_separator) {
    reading.x = reading.map_y = reading.height = reading.names = 0;  // the columns are others now
  } else if (model_.look(file_).table) {
    const scenario::ImportTable& table = *model_.look(file_).table;
    const bool chosen =
        column(x_) != table.x || column(height_) != table.height || column(map_y_) > 0 || model_.look(file_).error;
    if (chosen || reading.x > 0) {
      reading.x = column(x_);
      reading.height = column(height_);
      reading.map_y = column(map_y_);
    }
    reading.names = column(names_);
  }
  if (const auto numbers = numbers_in(corners_->text()); model_.look(file_).picture)
    reading.corners = numbers && numbers->size() == 4 ? *numbers : std::vector<double>();
  preview_->show_look(nullptr, {});  // its look goes
  if (reading.y_axis != model_.reading(file_).y_axis) axis_chosen_.insert(file_);
  model_.read_as(file_, reading);
  // Whoever chooses a column of depths means depths; the choice shows it and can be changed. Negative ones may be
  // heights.
  if (const auto& table = model_.look(file_).table; table && reading.height > 0 && !axis_chosen_.contains(file_)) {
    const std::string meant = table->depth && !table->negative ? "down" : "";
    if (std::exchange(reading.y_axis, meant) != meant) model_.read_as(file_, reading);
  }
  list_->show_file(file_);
  show_reading();
  changed();
}

std::vector<std::size_t> ImportDialog::selected_lines() const {
  std::vector<std::size_t> lines;
  for (const QModelIndex& row : lines_->selectionModel()->selectedRows())
    lines.push_back(static_cast<std::size_t>(row.row()));
  return lines;
}

std::vector<scenario::Importing::Kind> ImportDialog::kinds_of_selection() const {
  std::set<scenario::ImportShape> shapes;
  for (const std::size_t line : selected_lines()) shapes.insert(model_.look(file_).lines[line].shape);
  std::vector<scenario::Importing::Kind> kinds = model_.importing().kinds;
  std::erase_if(kinds, [&](const auto& kind) {
    return !std::all_of(shapes.begin(), shapes.end(), [&](auto shape) { return kind.shapes.contains(shape); });
  });
  return kinds;
}

void ImportDialog::selection_changed() {
  const std::vector<std::size_t> lines = selected_lines();
  preview_->mark({lines.begin(), lines.end()});
  kind_->clear();
  kind_->setEnabled(!lines.empty());
  if (lines.empty()) {
    kind_->addItem(text("select lines above"));
    return;
  }
  const auto kinds = kinds_of_selection();
  for (const auto& kind : kinds) kind_->addItem(text(kind.title.c_str()), QString::fromStdString(kind.name));
  const std::string& first = model_.choices(file_)[lines.front()].kind;
  const bool same = std::all_of(lines.begin(), lines.end(),
                                [&](std::size_t line) { return model_.choices(file_)[line].kind == first; });
  kind_->setCurrentIndex(same ? kind_->findData(QString::fromStdString(first)) : -1);
}

void ImportDialog::choose_kind(int index) {
  const QVariant kind = kind_->itemData(index);
  if (!kind.isValid()) return;
  model_.set_kind(file_, selected_lines(), kind.toString().toStdString());
  changed();
}

void ImportDialog::apply_rule() {
  const scenario::ImportRule rule{pattern_->text().toStdString(),
                                  pattern_kind_->currentData().toString().toStdString()};
  if (rule.pattern.empty()) return;
  if (model_.add_rule(file_, rule) == 0) {
    message_->setText(text("No line of this file is called like '%1'.").arg(pattern_->text()));
    return;
  }
  pattern_->clear();
  changed();
}

bool ImportDialog::eventFilter(QObject* watched, QEvent* event) {
  if (watched != pattern_ || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return QDialog::eventFilter(watched, event);
  apply_rule();  // Enter in the pattern is not Enter in the dialog
  return true;
}

void ImportDialog::changed() {
  show_lines();
  ok_->setEnabled(false);
  pause_.start();
}

void ImportDialog::judge() {
  pause_.stop();
  made_.reset();
  auto result = model_.result();
  QPalette palette = QDialog::palette();
  QStringList said;
  if (result) {
    made_ = *std::move(result);
    for (const std::string& note : made_->notes) said.push_back(QString::fromStdString(note));
    const std::vector<std::string>& remarks = model_.look(file_).remarks;
    for (std::size_t i = 0; i < std::min(most_remarks, remarks.size()); ++i)
      said.push_back(wording_({base::ErrorCode::Unclear, remarks[i]}));
    if (remarks.size() > most_remarks) said.push_back(text("and %1 more remarks").arg(remarks.size() - most_remarks));
  } else {
    said.push_back(asked_above(result.error()).value_or(wording_(result.error())));
    palette.setColor(QPalette::WindowText, theme::wrong_text(palette));
  }
  message_->setPalette(palette);
  message_->setText(said.join("\n"));
  ok_->setEnabled(made_.has_value());
  ok_->setToolTip(made_ ? QString() : said.join("\n"));
}

/// Which columns of a table are meant is asked in the dialog, not on a command line.
std::optional<QString> ImportDialog::asked_above(const base::Error& error) const {
  if (error.code != base::ErrorCode::Unclear || !error.place) return std::nullopt;
  if (error.message.find("--columns") == std::string::npos) return std::nullopt;
  for (std::size_t i = 0; i < model_.size(); ++i) {
    const std::optional<scenario::ImportTable>& table = model_.look(i).table;
    if (!table || model_.path(i).string() != error.place->file) continue;
    std::size_t columns = table->header.size();
    for (const auto& row : table->rows) columns = std::max(columns, row.size());
    return text(
               "%1: choose which of its %2 columns hold x, heights or depths, and names; for places on the map, y too.")
        .arg(file_name(model_.path(i)))
        .arg(columns);
  }
  return std::nullopt;
}

QString ImportDialog::what() const {
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < model_.size(); ++i) {
    if (model_.taken(i)) taken.push_back(i);
  }
  return taken.size() == 1 ? text("Import '%1'").arg(file_name(model_.path(taken.front())))
                           : text("Import %1 files").arg(taken.size());
}

}  // namespace dobra::gui::importing
