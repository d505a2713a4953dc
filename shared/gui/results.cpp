#include "shared/gui/results.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/gui/catalogue/catalogue.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"

namespace dobra::gui {

namespace {

constexpr int copied_role =
    Qt::UserRole;  ///< Of a row: "horizon.top.length_after<tab>12.5<tab>m", or of a group its key.

/// Copies the key and the whole number, as report.json has them.
class QuantityTree : public QTreeWidget {
 public:
  using QTreeWidget::QTreeWidget;

 protected:
  bool event(QEvent* event) override {
    // Otherwise the window's own Copy would take the key.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
      event->accept();
      return true;
    }
    return QTreeWidget::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    if (!event->matches(QKeySequence::Copy)) return QTreeWidget::keyPressEvent(event);
    if (currentItem() != nullptr) QGuiApplication::clipboard()->setText(currentItem()->data(0, copied_role).toString());
  }
};

QString list_item(const QColor& color, const QString& sign, const QString& words) {
  return QString("<p style='margin:0 0 4px 0'><span style='color:%1'>%2</span> %3</p>")
      .arg(color.name(), sign, words.toHtmlEscaped());
}

/// In the user's language, with its decimal mark; the quantity's key stays as expectations write it.
QString said(const scenario::Verdict& verdict) {
  const auto marked = [](const std::string& words) { return canvas::with_decimal_mark(words); };
  std::string message = verdict.message;
  const std::string& key = verdict.expect.quantity;
  if (const std::size_t at = message.find(key + " is "); verdict.found && at != std::string::npos)
    message = marked(message.substr(0, at)) + key + marked(message.substr(at + key.size()));
  return catalogue::translated(QString::fromStdString(message));
}

}  // namespace

Results::Results(QWidget* parent) : QWidget(parent), quantities_(new QuantityTree(this)), remarks_(new QLabel(this)) {
  quantities_->setAccessibleName(text("Results"));
  quantities_->setHeaderLabels({text("Quantity"), text("Value")});
  quantities_->header()->setStretchLastSection(false);
  quantities_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  quantities_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  quantities_->setIndentation(12);
  quantities_->setAlternatingRowColors(true);
  quantities_->setTextElideMode(Qt::ElideMiddle);
  quantities_->setUniformRowHeights(true);

  remarks_->setWordWrap(true);
  remarks_->setTextFormat(Qt::RichText);
  remarks_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  remarks_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  remarks_->setContentsMargins(6, 4, 6, 4);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(remarks_);
  scroll->setAccessibleName(text("Remarks"));
  scroll->setWidgetResizable(true);

  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(quantities_);
  splitter->addWidget(scroll);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(splitter);
}

void Results::show_outcome(const documents::Outcome& outcome) {
  quantities_->clear();
  QTreeWidgetItem* group = nullptr;
  QString group_name;
  for (const scenario::Quantity& quantity : outcome.quantities) {
    const QString name = QString::fromStdString(quantity.name);
    const auto dot = name.lastIndexOf('.');
    const QString prefix = name.left(std::max<qsizetype>(dot, 0));
    if (prefix != group_name) {
      group_name = prefix;
      group = prefix.isEmpty() ? nullptr : new QTreeWidgetItem(quantities_, {catalogue::words_of_group(prefix)});
      if (group != nullptr) {
        group->setFirstColumnSpanned(true);
        group->setToolTip(0, prefix);
        group->setData(0, copied_role, prefix);
      }
    }
    const QString value = (readable(quantity.value) + " " + QString::fromStdString(quantity.unit)).trimmed();
    const QStringList cells{catalogue::words_of_quantity(name), value};
    auto* line = group != nullptr ? new QTreeWidgetItem(group, cells) : new QTreeWidgetItem(quantities_, cells);
    line->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    const QString whole = QString::fromStdString(base::number_text(quantity.value));
    line->setToolTip(0, name);
    line->setToolTip(1, whole);
    line->setData(0, copied_role, QStringList{name, whole, QString::fromStdString(quantity.unit)}.join('\t').trimmed());
  }
  quantities_->expandAll();
  QString list;
  for (const scenario::Verdict& verdict : outcome.verdicts) {
    if (verdict.met)
      list += list_item(theme::right_text(palette()), QString::fromUtf8("✓"), said(verdict));
    else
      list += list_item(theme::wrong_text(palette()), QString::fromUtf8("✗"), said(verdict));
  }
  for (const std::string& remark : outcome.remarks)
    list += list_item(theme::remark_text(palette()), QString::fromUtf8("•"),
                      catalogue::translated(QString::fromStdString(remark)));
  if (list.isEmpty()) list = "<i>" + text("No remarks.") + "</i>";
  remarks_->setText(list);
}

void Results::clear() {
  quantities_->clear();
  remarks_->clear();
}

QString readable(double value) {
  return QString::fromStdString(canvas::with_decimal_mark(QString::number(value, 'g', 6).toStdString()));
}

}  // namespace dobra::gui
