#include "shared/gui/field_editor.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/gui/importing/file_filter.h"
#include "shared/gui/numbers/numbers.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"

namespace dobra::gui {

using scenario::Field;
using scenario::Kind;
using scenario::Value;
using Values = std::optional<Value>;

namespace {

constexpr int settle_milliseconds = 350;  ///< After the last step of a spin box, or the last key in a list of points.

/// Default values are shown paler and slanted, so that one sees what the document says itself.
void show_origin(QWidget& widget, FieldEditor::Origin origin) {
  const QPalette now;
  const QColor wanted = now.color(origin == FieldEditor::Origin::Default ? QPalette::PlaceholderText : QPalette::Text);
  // Each change of a font or a palette is told to all that is inside.
  if (widget.font().italic() == (origin == FieldEditor::Origin::Default) &&
      widget.palette().color(QPalette::Active, QPalette::Text) == wanted)
    return;
  QFont font = widget.font();
  font.setItalic(origin == FieldEditor::Origin::Default);
  widget.setFont(font);
  QPalette palette = widget.palette();
  const QPalette standard;
  for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive}) {
    const auto role = origin == FieldEditor::Origin::Default ? QPalette::PlaceholderText : QPalette::Text;
    palette.setColor(group, QPalette::Text, standard.color(group, role));
    palette.setColor(group, QPalette::ButtonText, standard.color(group, role));
  }
  widget.setPalette(palette);
}

QString words_for_nothing(const Field& field) {
  return field.options.presence == scenario::Presence::Required ? text("to be given") : text("not set");
}

/// Pale red behind what is wrong. Not through a style sheet, which would take the arrows off a spin box.
void show_background(QWidget& widget, FieldEditor::Judgement judgement) {
  QPalette palette = widget.palette();
  const bool bad = judgement == FieldEditor::Judgement::Bad;
  for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive}) {
    palette.setColor(group, QPalette::Base,
                     bad ? theme::wrong_base(QPalette()) : QPalette().color(group, QPalette::Base));
  }
  widget.setPalette(palette);
}

/// A spin box that takes any text: what is wrong is said under it instead of being silently replaced.
class FreeSpinBox : public QAbstractSpinBox {
  Q_OBJECT

 public:
  FreeSpinBox(const Field& field, QWidget* parent) : QAbstractSpinBox(parent), field_(field) {
    setFocusPolicy(Qt::StrongFocus);
    lineEdit()->setPlaceholderText(words_for_nothing(field));
    setMinimumWidth(70);
  }

  void stepBy(int steps) override {
    const double value = number().value_or(0.0);
    if (field_.kind == Kind::Integer) {
      lineEdit()->setText(QString::number(static_cast<qint64>(std::llround(within(std::round(value) + steps)))));
    } else {
      lineEdit()->setText(numbers::whole(within(numbers::stepped(value, steps))));
    }
    emit stepped_to();
  }
  QValidator::State validate(QString&, int&) const override { return QValidator::Acceptable; }
  QLineEdit* line() const { return lineEdit(); }

 signals:
  void stepped_to();

 protected:
  StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QAbstractSpinBox::wheelEvent(event);
    else
      event->ignore();
  }

 private:
  [[nodiscard]] std::optional<double> number() const {
    return base::parse_number(numbers::as_parsed(Kind::Number, lineEdit()->text().trimmed()).toStdString());
  }
  double within(double value) const {
    const scenario::FieldOptions& options = field_.options;
    if (options.at_most) value = std::min(value, *options.at_most);
    if (options.at_least) value = std::max(value, *options.at_least);
    if (options.above && value <= *options.above) {
      const double now = number().value_or(*options.above + 1.0);
      value = field_.kind == Kind::Integer ? std::floor(*options.above) + 1.0 : std::max(now, *options.above);
    }
    return value;
  }

  Field field_;
};

/// Lets Ctrl+Z through to the document when the text itself has nothing to undo.
class UndoPassesThrough : public QObject {
 public:
  explicit UndoPassesThrough(QLineEdit* line) : QObject(line), line_(line) { line->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool undo = key->matches(QKeySequence::Undo) && !line_->isUndoAvailable();
    const bool redo = key->matches(QKeySequence::Redo) && !line_->isRedoAvailable();
    if (undo || redo) event->ignore();
    return undo || redo;
  }

 private:
  QLineEdit* line_;
};

/// Of a text that its line cuts off: its beginning while nobody writes there, and the whole under the pointer.
class WholeText : public QObject {
 public:
  explicit WholeText(QLineEdit* line) : QObject(line), line_(line) { line->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::FocusOut) {
      const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
      if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason) line_->setCursorPosition(0);
      return false;
    }
    const QString whole = line_->text();
    if (event->type() != QEvent::ToolTip || line_->fontMetrics().horizontalAdvance(whole) + 8 <= line_->width())
      return false;
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                       "<p style='white-space:pre-wrap'>" + whole.toHtmlEscaped() + "</p>", line_);
    return true;
  }

 private:
  QLineEdit* line_;
};

/// Listens to the letters of codes (the items' data) where those of the words do not fit.
class CalmComboBox : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    const bool letter = !event->text().isEmpty() && event->text().front().isPrint() &&
                        (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0;
    if (letter) {
      const bool goes_on = since_.isValid() && since_.elapsed() < QApplication::keyboardInputInterval();
      typed_ = (goes_on ? typed_ : QString()) + event->text();
      since_.start();
      const int code = findData(typed_, Qt::UserRole, Qt::MatchStartsWith);
      if (code >= 0 && findText(typed_, Qt::MatchStartsWith) < 0) {
        setCurrentIndex(code);
        emit activated(code);
        return;
      }
    }
    QComboBox::keyPressEvent(event);
  }
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QComboBox::wheelEvent(event);
    else
      event->ignore();
  }

 private:
  QString typed_;
  QElapsedTimer since_;  ///< The last letter.
};

QHBoxLayout* tight_row(QWidget* widget) {
  auto* layout = new QHBoxLayout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  return layout;
}

/// The shared part of editors whose content is one line of text read by scenario::parse_value.
class LineEditor : public FieldEditor {
 public:
  LineEditor(const Field& field, QWidget* parent) : FieldEditor(parent), field_(field) {}
  ~LineEditor() override {  // what loses the focus because it goes commits nothing
    disconnect(line_, nullptr, this, nullptr);
    disconnect(surface_, nullptr, this, nullptr);
  }

  void show_value(const Values& value, Origin origin) override {
    shown_ = value ? numbers::field_text(field_.kind, *value) : QString();
    told_ = shown_;
    const int cursor = line_->text() == shown_ ? line_->cursorPosition() : line_->hasFocus() ? -1 : 0;
    line_->setText(shown_);
    if (cursor >= 0) line_->setCursorPosition(cursor);
    show_origin(*surface_, origin);
  }
  void type(const QString& typed) override {
    line_->setText(typed);
    line_->setCursorPosition(0);
    show_origin(*surface_, Origin::Document);
    commit();
  }
  void commit() override {
    const QString typed = line_->text();
    if (typed == told_) return;
    told_ = typed;
    if (typed.trimmed().isEmpty()) {
      emit emptied();
      return;
    }
    const base::Result<Value> value =
        scenario::parse_value(field_, numbers::as_parsed(field_.kind, typed.trimmed()).toStdString());
    if (value)
      emit entered(*value);
    else
      emit rejected(QString::fromStdString(value.error().message));
  }
  [[nodiscard]] bool unsettled() const override { return line_->text() != shown_; }
  void show_judgement(Judgement judgement) override { show_background(*surface_, judgement); }

 protected:
  void use(QLineEdit* line, QWidget* surface) {
    line_ = line;
    surface_ = surface;
    setFocusProxy(surface);
    new UndoPassesThrough(line);
    new WholeText(line);
    connect(line, &QLineEdit::editingFinished, this, &LineEditor::commit);
    connect(line, &QLineEdit::textEdited, this, [this] { show_origin(*surface_, Origin::Document); });
  }
  const Field field_;

 private:
  QLineEdit* line_ = nullptr;
  QWidget* surface_ = nullptr;
  QString shown_;  ///< The value that was last shown.
  QString told_;   ///< What was last shown or committed.
};

class NumberEditor : public LineEditor {
 public:
  NumberEditor(const Field& field, QWidget* parent) : LineEditor(field, parent) {
    auto* spin = new FreeSpinBox(field, this);
    tight_row(this)->addWidget(spin);
    use(spin->line(), spin);
    settle_.setSingleShot(true);
    settle_.setInterval(settle_milliseconds);
    // The spin box keeps Enter to itself: its line never hears of it.
    connect(spin, &FreeSpinBox::editingFinished, this, &NumberEditor::commit);
    connect(spin, &FreeSpinBox::stepped_to, &settle_, qOverload<>(&QTimer::start));
    connect(&settle_, &QTimer::timeout, this, &NumberEditor::commit);
  }

 private:
  QTimer settle_;
};

class TextEditor : public LineEditor {
 public:
  TextEditor(const Field& field, QWidget* parent) : LineEditor(field, parent) {
    line_ = new QLineEdit(this);
    line_->setPlaceholderText(words_for_nothing(field));
    pick_ = new QToolButton(this);
    pick_->setObjectName("pick." + QString::fromStdString(field.key));
    pick_->setArrowType(Qt::DownArrow);
    pick_->setToolTip(text("Pick a name from the model"));
    pick_->setPopupMode(QToolButton::InstantPopup);
    pick_->setMenu(new QMenu(pick_));
    pick_->hide();
    QHBoxLayout* row = tight_row(this);
    row->addWidget(line_, 1);
    row->addWidget(pick_);
    use(line_, line_);
    connect(pick_->menu(), &QMenu::aboutToShow, this, &TextEditor::fill_menu);
  }
  void offer(const std::vector<std::string>& names) override {
    names_ = names;
    pick_->setVisible(!names.empty());
  }

  void take_name(const QString& name) override {
    const std::vector<std::string> now = chosen();
    if (std::find(now.begin(), now.end(), name.toStdString()) == now.end()) pick(name.toStdString());
  }

 private:
  /// What is chosen now is ticked.
  void fill_menu() {
    pick_->menu()->clear();
    const std::vector<std::string> now = chosen();
    for (const std::string& name : names_) {
      // A single & would underline a letter.
      QAction* action = pick_->menu()->addAction(QString::fromStdString(name).replace("&", "&&"));
      action->setCheckable(true);
      action->setChecked(std::find(now.begin(), now.end(), name) != now.end());
      connect(action, &QAction::triggered, this, [this, name] { pick(name); });
    }
  }
  [[nodiscard]] std::vector<std::string> chosen() const {
    const std::string typed = line_->text().trimmed().toStdString();
    if (field_.kind == Kind::Text) return {typed};
    const base::Result<Value> value = scenario::parse_value(field_, typed);
    if (typed.empty() || !value) return {};
    return std::get<std::vector<std::string>>(*value);
  }
  /// Of several names, adds one or takes it away.
  void pick(const std::string& name) {
    if (field_.kind == Kind::Text) {
      type(QString::fromStdString(name));
      return;
    }
    std::vector<std::string> names = chosen();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end())
      names.push_back(name);
    else
      names.erase(at);
    type(names.empty() ? QString() : numbers::field_text(Kind::Texts, names));
  }

  QLineEdit* line_ = nullptr;
  QToolButton* pick_ = nullptr;
  std::vector<std::string> names_;
};

class FileEditor : public LineEditor {
 public:
  FileEditor(const Field& field, std::filesystem::path folder, QWidget* parent)
      : LineEditor(field, parent), folder_(std::move(folder)) {
    auto* line = new QLineEdit(this);
    line->setPlaceholderText(text("no file"));
    auto* choose = new QToolButton(this);
    choose->setIcon(style()->standardIcon(QStyle::SP_DirOpenIcon));
    choose->setToolTip(text("Choose a file"));
    QHBoxLayout* row = tight_row(this);
    row->addWidget(line, 1);
    row->addWidget(choose);
    use(line, line);
    connect(choose, &QToolButton::clicked, this, &FileEditor::choose);
  }

 private:
  void choose() {
    const QString chosen = QFileDialog::getOpenFileName(this, text("Choose a file"), from_path(folder_),
                                                        importing::file_filter(field_.options.files));
    if (chosen.isEmpty()) return;
    const std::filesystem::path file = to_path(chosen);
    const std::filesystem::path relative =
        file.lexically_relative(std::filesystem::absolute(folder_.empty() ? "." : folder_).lexically_normal());
    type(from_path(relative.empty() ? file : relative));
  }

  std::filesystem::path folder_;
};

class FlagEditor : public FieldEditor {
 public:
  FlagEditor(const Field&, QWidget* parent) : FieldEditor(parent), box_(new QCheckBox(this)) {
    tight_row(this)->addWidget(box_);
    setFocusProxy(box_);
    connect(box_, &QCheckBox::clicked, this, [this](bool on) { emit entered(Value(on)); });
  }
  void show_value(const Values& value, Origin origin) override {
    box_->setChecked(value && std::get<bool>(*value));
    box_->setText(origin == Origin::Default ? text("(default)") : QString());
    show_origin(*box_, origin);
  }
  void type(const QString& typed) override {
    if (typed != "true" && typed != "false") {
      emit rejected(text("write true or false"));
      return;
    }
    box_->setChecked(typed == "true");
    emit entered(Value(typed == "true"));
  }

 private:
  QCheckBox* box_;
};

class ChoiceEditor : public FieldEditor {
 public:
  ChoiceEditor(const Field& field, QWidget* parent) : FieldEditor(parent), box_(new CalmComboBox(this)) {
    box_->setFocusPolicy(Qt::StrongFocus);
    for (const std::string& choice : field.choices) {
      const QString code = QString::fromStdString(choice);
      box_->addItem(choice_text(field, choice), code);
      box_->setItemData(box_->count() - 1, code, Qt::ToolTipRole);
    }
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(6);
    box_->setPlaceholderText(words_for_nothing(field));
    tight_row(this)->addWidget(box_, 1);
    setFocusProxy(box_);
    connect(box_, &QComboBox::activated, this,
            [this](int at) { emit entered(Value(box_->itemData(at).toString().toStdString())); });
  }
  void show_value(const Values& value, Origin origin) override {
    box_->setCurrentIndex(value ? box_->findData(QString::fromStdString(std::get<std::string>(*value))) : -1);
    show_origin(*box_, origin);
  }
  void type(const QString& typed) override {
    const int code = box_->findData(typed);
    const int index = code >= 0 ? code : box_->findText(typed, Qt::MatchFixedString);
    if (index < 0) {
      emit rejected(text("'%1' is not one of the choices").arg(typed));
      return;
    }
    box_->setCurrentIndex(index);
    emit entered(Value(box_->itemData(index).toString().toStdString()));
  }

 private:
  QComboBox* box_;
};

/// Tells when a widget without such a signal of its own is left.
class Leaving : public QObject {
  Q_OBJECT

 public:
  explicit Leaving(QWidget* widget) : QObject(widget) { widget->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    // A menu of the widget's own does not end the typing.
    if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason)
      emit left();
    return false;
  }

 signals:
  void left();
};

class PointsEditor : public FieldEditor {
 public:
  PointsEditor(const Field&, QWidget* parent)
      : FieldEditor(parent), edit_(new QPlainTextEdit(this)), leaving_(new Leaving(edit_)) {
    edit_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    edit_->setPlaceholderText(text("x, y on each line"));
    edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
    edit_->setTabChangesFocus(true);
    edit_->setFixedHeight(7 * edit_->fontMetrics().lineSpacing());
    tight_row(this)->addWidget(edit_);
    setFocusProxy(edit_);
    settle_.setSingleShot(true);
    settle_.setInterval(2 * settle_milliseconds);
    connect(edit_, &QPlainTextEdit::textChanged, &settle_, qOverload<>(&QTimer::start));
    connect(&settle_, &QTimer::timeout, this, &PointsEditor::commit);
    connect(leaving_, &Leaving::left, this, &PointsEditor::commit);
  }
  ~PointsEditor() override { disconnect(leaving_, nullptr, this, nullptr); }
  void show_value(const Values& value, Origin origin) override {
    const QString words =
        value ? QString::fromStdString(numbers::text_of_points(std::get<scenario::Points>(*value).list())) : QString();
    // The user's own layout stays while it means the same: the document comes back after each change.
    const base::Result<std::vector<geom::Point>> typed = numbers::points_from_text(edit_->toPlainText().toStdString());
    if (!value || !typed || Value(*typed) != *value) {
      const QSignalBlocker quiet(edit_);
      edit_->setPlainText(words);
    }
    shown_ = edit_->toPlainText();
    told_ = shown_;
    show_origin(*edit_, origin);
  }
  void type(const QString& typed) override {
    edit_->setPlainText(QString(typed).replace(";", "\n"));
    commit();
  }
  void commit() override {
    settle_.stop();
    if (edit_->toPlainText() == told_) return;
    told_ = edit_->toPlainText();
    if (told_.trimmed().isEmpty()) {
      emit emptied();
      return;
    }
    base::Result<std::vector<geom::Point>> points = numbers::points_from_text(told_.toStdString());
    if (points)
      emit entered(Value(std::move(*points)));
    else
      emit rejected(QString::fromStdString(points.error().message));
  }
  [[nodiscard]] bool unsettled() const override { return edit_->toPlainText() != shown_; }
  void show_judgement(Judgement judgement) override { show_background(*edit_, judgement); }

 private:
  QPlainTextEdit* edit_;
  Leaving* leaving_;
  QTimer settle_;
  QString shown_;  ///< As in LineEditor.
  QString told_;
};

}  // namespace

void FieldEditor::show_judgement(Judgement) {}

FieldEditor* make_field_editor(const Field& field, const std::filesystem::path& folder, QWidget* parent) {
  switch (field.kind) {
    case Kind::Flag:
      return new FlagEditor(field, parent);
    case Kind::Integer:
    case Kind::Number:
    case Kind::Degrees:
      return new NumberEditor(field, parent);
    case Kind::Choice:
      return new ChoiceEditor(field, parent);
    case Kind::File:
      return new FileEditor(field, folder, parent);
    case Kind::Points:
      return new PointsEditor(field, parent);
    case Kind::Text:
    case Kind::Point:
    case Kind::Point3:
    case Kind::Numbers:
    case Kind::Points3:
    case Kind::Texts:
      return new TextEditor(field, parent);
    case Kind::Tables:
      break;
  }
  DOBRA_CHECK(field.kind != Kind::Tables);
  return nullptr;
}

QString choice_text(const Field& field, const std::string& choice) {
  const QString code = QString::fromStdString(choice);
  const QString words = QCoreApplication::translate("dobra", choice.c_str(), field.key.c_str());
  const bool symbol = code.indexOf('_') == 1;  // "s_xx", "b_spline"
  return words != code || symbol ? words : QString(code).replace('_', ' ');
}

}  // namespace dobra::gui

#include "field_editor.moc"
