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
#include <utility>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/gui/catalogue/catalogue.h"
#include "shared/gui/messages.h"
#include "shared/gui/numbers/numbers.h"
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
    message =
        marked(message.substr(0, at)) + key + numbers::unit_text(marked(message.substr(at + key.size()))).toStdString();
  return catalogue::translated(QString::fromStdString(message)).replace("+-", QString::fromUtf8("±"));
}

}  // namespace

Results::Results(QWidget* parent) : QWidget(parent), quantities_(new QuantityTree(this)), remarks_(new QLabel(this)) {
  quantities_->setAccessibleName(text("Results"));
  quantities_->setHeaderLabels({text("Quantity"), text("Value")});
  quantities_->header()->setStretchLastSection(false);
  quantities_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  // Once a run and not at each number; the lines in sight, and some hundred of thousands below.
  quantities_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
  quantities_->header()->setResizeContentsPrecision(200);
  quantities_->setIndentation(12);
  quantities_->setAlternatingRowColors(true);
  quantities_->setTextElideMode(Qt::ElideMiddle);
  quantities_->setUniformRowHeights(true);

  remarks_->setWordWrap(true);
  remarks_->setTextFormat(Qt::RichText);
  remarks_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  remarks_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  remarks_->setContentsMargins(6, 4, 6, 4);
  remarks_->hide();
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
  splitter->setSizes({600, 300});  // in that proportion, whatever the height
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(splitter);
}

void Results::show_outcome(const documents::Outcome& outcome) {
  show_quantities(outcome.quantities);
  show_remarks(outcome);
}

void Results::show_quantities(const std::vector<scenario::Quantity>& quantities) {
  std::vector<std::string> names;
  for (const scenario::Quantity& quantity : quantities) names.push_back(quantity.name);
  // A run that changes numbers changes no more than numbers.
  if (names != names_) list_names(quantities);
  names_ = std::move(names);
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const scenario::Quantity& quantity = quantities[i];
    const QString value = (numbers::readable(quantity.value) + " " + numbers::unit_text(quantity.unit)).trimmed();
    if (lines_[i]->text(1) != value) lines_[i]->setText(1, value);
    const QString whole = QString::fromStdString(base::number_text(quantity.value));
    lines_[i]->setToolTip(1, whole);
    const QStringList copied{QString::fromStdString(quantity.name), whole, QString::fromStdString(quantity.unit)};
    lines_[i]->setData(0, copied_role, copied.join('\t').trimmed());
  }
  quantities_->resizeColumnToContents(1);
}

void Results::list_names(const std::vector<scenario::Quantity>& quantities) {
  quantities_->clear();
  lines_.clear();
  QList<QTreeWidgetItem*> top;  // shown all at once
  QTreeWidgetItem* group = nullptr;
  QString group_name;
  for (const scenario::Quantity& quantity : quantities) {
    const QString name = QString::fromStdString(quantity.name);
    const auto dot = name.lastIndexOf('.');
    const QString prefix = name.left(std::max<qsizetype>(dot, 0));
    if (prefix != group_name) {
      group_name = prefix;
      group = prefix.isEmpty() ? nullptr : new QTreeWidgetItem(QStringList(catalogue::words_of_group(prefix)));
      if (group != nullptr) {
        group->setToolTip(0, prefix);
        group->setData(0, copied_role, prefix);
        top << group;
      }
    }
    const QStringList cells{catalogue::words_of_quantity(name), {}};
    auto* line = group != nullptr ? new QTreeWidgetItem(group, cells) : new QTreeWidgetItem(cells);
    if (group == nullptr) top << line;
    line->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    line->setToolTip(0, name);
    lines_.push_back(line);
  }
  quantities_->addTopLevelItems(top);
  for (QTreeWidgetItem* item : std::as_const(top)) item->setFirstColumnSpanned(item->childCount() > 0);
  quantities_->expandAll();
}

void Results::show_remarks(const documents::Outcome& outcome) {
  QString list;
  for (const scenario::Verdict& verdict : outcome.verdicts) {
    if (verdict.met)
      list += list_item(theme::right_text(palette()), QString::fromUtf8("✓"), said(verdict));
    else
      list += list_item(theme::wrong_text(palette()), QString::fromUtf8("✗"), said(verdict));
  }
  for (const std::string& remark : outcome.remarks)
    list += list_item(theme::remark_text(palette()), QString::fromUtf8("•"),
                      remark_in_words(QString::fromStdString(remark), fields_));
  if (list.isEmpty()) list = "<i>" + text("No remarks.") + "</i>";
  if (remarks_->text() != list) remarks_->setText(list);
  remarks_->show();
}

void Results::clear() {
  quantities_->clear();
  lines_.clear();
  names_.clear();
  remarks_->clear();
  remarks_->hide();  // nothing said is no stop for the keyboard
}

}  // namespace dobra::gui
