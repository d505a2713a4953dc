#include "shared/gui/mending/page.h"

#include <QApplication>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>

#include "shared/gui/theme/colors.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::mending {

Page::Page(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), message_(new QLabel(this)), edit_(new QPlainTextEdit(this)) {
  setObjectName("mending");
  QFont bold = title_->font();
  bold.setPointSizeF(1.3 * bold.pointSizeF());
  bold.setBold(true);
  title_->setFont(bold);
  title_->setTextFormat(Qt::PlainText);
  title_->setWordWrap(true);
  message_->setObjectName("mending.message");
  message_->setTextFormat(Qt::PlainText);
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  edit_->setObjectName("mending.text");
  edit_->setAccessibleName(text("Text of the file"));
  edit_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
  auto* save = new QPushButton(text("Save and open"), this);
  save->setObjectName("mending.save");
  save->setToolTip(text("Nothing is written as long as the text cannot be read"));
  auto* open = new QPushButton(text("Open another file..."), this);
  open->setObjectName("mending.open");
  auto* leave = new QPushButton(text("Leave the file as it is"), this);
  leave->setObjectName("mending.leave");
  connect(save, &QPushButton::clicked, this, &Page::save_asked);
  connect(open, &QPushButton::clicked, this, &Page::open_asked);
  connect(leave, &QPushButton::clicked, this, &Page::left);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(save);
  buttons->addWidget(open);
  buttons->addStretch(1);
  buttons->addWidget(leave);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(message_);
  column->addWidget(edit_, 1);
  column->addLayout(buttons);
}

void Page::show_file(const std::filesystem::path& file, const std::string& written, const base::Error& error,
                     const QString& message) {
  file_ = file;
  text_of_file_ = written;
  carriage_returns_ = written.find("\r\n") != std::string::npos;
  title_->setText(text("%1 cannot be read").arg(QString::fromStdString(file.filename().string())));
  edit_->setPlainText(QString::fromStdString(written));
  edit_->document()->setModified(false);
  show_error(error, message);
}

void Page::show_error(const base::Error& error, const QString& message) {
  message_->setText(message);
  const base::Place place = error.place.value_or(base::Place{});
  line_ = place.line;
  const QTextBlock block = edit_->document()->findBlockByNumber(static_cast<int>(std::max<std::size_t>(line_, 1)) - 1);
  if (line_ > 0 && block.isValid()) {
    QTextCursor cursor(block);
    const int column = static_cast<int>(std::max<std::size_t>(place.column, 1)) - 1;
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, std::min(column, block.length() - 1));
    edit_->setTextCursor(cursor);
    edit_->centerCursor();
  }
  mark_line();
  edit_->setFocus();
}

std::string Page::written() const {
  QString all = edit_->toPlainText();
  if (carriage_returns_) all.replace("\n", "\r\n");
  return all.toStdString();
}

bool Page::modified() const { return edit_->document()->isModified(); }

void Page::mark_line() {
  QList<QTextEdit::ExtraSelection> marks;
  const QTextBlock block = edit_->document()->findBlockByNumber(static_cast<int>(line_) - 1);
  if (line_ > 0 && block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(block);
    mark.format.setBackground(theme::wrong_base(QApplication::palette()));
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    marks << mark;
  }
  edit_->setExtraSelections(marks);
  QPalette palette = message_->palette();
  palette.setColor(QPalette::WindowText, theme::wrong_text(QApplication::palette()));
  message_->setPalette(palette);
}

/// Escape is the page's own while it has the focus, whatever else waits for it.
bool Page::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
    event->accept();
  return QWidget::event(event);
}

void Page::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::ApplicationPaletteChange) mark_line();
}

void Page::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return emit left();
  QWidget::keyPressEvent(event);
}

}  // namespace dobra::gui::mending
