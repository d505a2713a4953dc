#include "shared/gui/actions/palette.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "shared/gui/actions/action.h"

namespace dobra::gui::actions {

namespace {
constexpr int widest = 720;  ///< Pixels.
constexpr int rows_shown = 12;
}  // namespace

Palette::Palette(QWidget& window)
    : QFrame(&window),
      window_(window),
      typed_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      nothing_(new QLabel(shown("Nothing that can be done is called so."), this)) {
  setObjectName("palette");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 6, 6, 6);
  typed_->setObjectName("palette.typed");
  typed_->setPlaceholderText(shown("Type what you want to do"));
  typed_->setAccessibleName(shown("Type what you want to do"));
  typed_->installEventFilter(this);
  list_->setObjectName("palette.list");
  list_->setAccessibleName(shown("What can be done"));
  list_->setColumnCount(3);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  column->addWidget(typed_);
  nothing_->setObjectName("palette.nothing");
  nothing_->setWordWrap(true);
  nothing_->hide();
  column->addWidget(nothing_);
  column->addWidget(list_, 1);
  connect(typed_, &QLineEdit::textChanged, this, &Palette::filter);
  connect(list_, &QTreeWidget::itemClicked, this, &Palette::choose);
  window.installEventFilter(this);
  hide();
}

void Palette::open(std::vector<Choice> choices) {
  if (!isVisible()) focus_before_ = window_.focusWidget();
  choices_ = std::move(choices);
  typed_->clear();
  filter({});
  place();
  show();
  raise();
  typed_->setFocus();
}

QStringList Palette::listed() const {
  QStringList titles;
  for (const std::size_t choice : shown_) titles << choices_[choice].title;
  return titles;
}

void Palette::filter(const QString& typed) {
  shown_ = found(choices_, typed);
  list_->clear();
  const QColor quiet = palette().color(QPalette::Active, QPalette::PlaceholderText);
  QList<QTreeWidgetItem*> rows;
  for (const std::size_t choice : shown_) {
    const Choice& each = choices_[choice];
    auto* row = new QTreeWidgetItem({each.title, each.where, each.keys});
    row->setForeground(1, quiet);
    if (!each.can) {
      for (const int column : {0, 2}) row->setForeground(column, quiet);
      QFont slanted = list_->font();
      slanted.setItalic(true);
      row->setFont(0, slanted);
      row->setToolTip(0, shown("Cannot be done now"));
      row->setData(0, Qt::AccessibleDescriptionRole, shown("Cannot be done now"));
    }
    rows << row;
  }
  list_->addTopLevelItems(rows);
  if (!rows.isEmpty()) list_->setCurrentItem(rows.front());
  nothing_->setVisible(rows.isEmpty());
}

void Palette::place() {
  const int width = std::min(widest, window_.width() - 40);
  const int row = list_->fontMetrics().height() + 6;
  const int height = std::min((rows_shown + 2) * row, window_.height() - 80);
  setGeometry((window_.width() - width) / 2, 40, width, height);
}

void Palette::move_by(int rows) {
  const int count = list_->topLevelItemCount();
  if (count == 0) return;
  const int now = list_->indexOfTopLevelItem(list_->currentItem());
  const int next = std::abs(rows) == 1 ? (now + rows + count) % count : std::clamp(now + rows, 0, count - 1);
  list_->setCurrentItem(list_->topLevelItem(next));
}

void Palette::choose() {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  if (row < 0) return;
  const Choice chosen = choices_[shown_[static_cast<std::size_t>(row)]];
  if (!chosen.can) return;
  close_list();
  // Behind what is under way: it may open a question.
  QTimer::singleShot(0, &window_, chosen.run);
}

void Palette::close_list() {
  hide();
  if (focus_before_ != nullptr) focus_before_->setFocus();
}

bool Palette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return false;
  }
  if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
    hide();
    return false;
  }
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  static const std::vector<int> ours{Qt::Key_Escape, Qt::Key_Return, Qt::Key_Enter,   Qt::Key_Down,
                                     Qt::Key_Up,     Qt::Key_PageUp, Qt::Key_PageDown};
  if (std::find(ours.begin(), ours.end(), key) == ours.end()) return false;
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  if (key == Qt::Key_Escape) close_list();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) choose();
  if (key == Qt::Key_Down) move_by(1);
  if (key == Qt::Key_Up) move_by(-1);
  if (key == Qt::Key_PageDown) move_by(rows_shown - 2);
  if (key == Qt::Key_PageUp) move_by(2 - rows_shown);
  return true;
}

}  // namespace dobra::gui::actions
