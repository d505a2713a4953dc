#include "shared/gui/results.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/gui/catalogue/catalogue.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/colors.h"

namespace dobra::gui {

namespace {

QString list_item(const QColor& color, const QString& sign, const std::string& words) {
  return QString("<p style='margin:0 0 4px 0'><span style='color:%1'>%2</span> %3</p>")
      .arg(color.name(), sign, catalogue::translated(QString::fromStdString(words)).toHtmlEscaped());
}

}  // namespace

Results::Results(QWidget* parent) : QWidget(parent), quantities_(new QTreeWidget(this)), remarks_(new QLabel(this)) {
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
    const QString value = (readable(quantity.value) + " " + QString::fromStdString(quantity.unit)).trimmed();
    if (lines_[i]->text(1) != value) lines_[i]->setText(1, value);
    lines_[i]->setToolTip(1, QString::fromStdString(base::number_text(quantity.value)));
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
      group = prefix.isEmpty() ? nullptr : new QTreeWidgetItem(QStringList(prefix));
      if (group != nullptr) top << group;
    }
    const QStringList cells{name.mid(dot + 1), {}};
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
  QString said;
  for (const scenario::Verdict& verdict : outcome.verdicts) {
    if (verdict.met)
      said += list_item(theme::right_text(palette()), QString::fromUtf8("✓"), verdict.message);
    else
      said += list_item(theme::wrong_text(palette()), QString::fromUtf8("✗"), verdict.message);
  }
  for (const std::string& remark : outcome.remarks)
    said += list_item(theme::remark_text(palette()), QString::fromUtf8("•"), remark);
  if (said.isEmpty()) said = "<i>" + text("No remarks.") + "</i>";
  if (remarks_->text() != said) remarks_->setText(said);
}

void Results::clear() {
  quantities_->clear();
  lines_.clear();
  names_.clear();
  remarks_->clear();
}

QString readable(double value) {
  return QString::fromStdString(canvas::with_decimal_mark(QString::number(value, 'g', 6).toStdString()));
}

}  // namespace dobra::gui
