#include "recon/gui/balance_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <climits>
#include <cmath>

#include "recon/model/model.h"
#include "shared/gui/canvas.h"
#include "shared/gui/numbers/numbers.h"
#include "shared/gui/session.h"
#include "shared/gui/text.h"
#include "shared/gui/theme/icons.h"

namespace recon::gui {

namespace {

namespace canvas = dobra::canvas;
namespace numbers = dobra::gui::numbers;
namespace scenario = dobra::scenario;
using dobra::gui::text;

constexpr int name_role = Qt::UserRole;  ///< Of the row of a bed: what its lines are called.

QString percent(double value) {
  const double shown = std::round(100.0 * value) / 100.0 + 0.0;  // no -0,00
  return QString("%1 %").arg(QLocale().toString(shown, 'f', 2));
}

/// The last state of the session's run, if it is one of RECON's.
const model::Model* last_model(const dobra::gui::Session& session) {
  const dobra::gui::documents::OutcomePtr& outcome = session.outcome();
  if (!outcome || outcome->run.states.empty()) return nullptr;
  return &scenario::model_of<model::Model>(outcome->run.states.back());
}

}  // namespace

BalancePanel::BalancePanel(const dobra::gui::Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  states_ = new QComboBox(this);
  states_->setObjectName("balance.states");
  states_->setAccessibleName(text("States compared"));
  verdict_ = new QLabel(this);
  verdict_->setObjectName("balance.verdict");
  verdict_->setWordWrap(true);
  rows_ = new QTreeWidget(this);
  rows_->setObjectName("balance.rows");
  rows_->setAccessibleName(text("Balance"));
  const QString units = QString::fromUtf8("\n[m, m²]");  // of beds and of units
  rows_->setHeaderLabels({text("Name"), text("Changed by"), text("Before") + units, text("After") + units});
  rows_->setRootIsDecorated(false);
  rows_->setWordWrap(true);
  rows_->viewport()->installEventFilter(this);
  rows_->header()->setSectionResizeMode(QHeaderView::Fixed);
  rows_->header()->setMinimumSectionSize(rows_->fontMetrics().horizontalAdvance("-00.00 %"));
  rows_->header()->setStretchLastSection(false);
  column->addWidget(states_);
  column->addWidget(verdict_);
  column->addWidget(rows_, 1);
  connect(&desk_.session, &dobra::gui::Session::run_finished, this, &BalancePanel::show_outcome);
  connect(&desk_.session, &dobra::gui::Session::document_changed, this, [this] {
    if (desk_.session.outcome() == nullptr) show_outcome();
  });
  connect(&desk_.canvas, &dobra::gui::Canvas::lines_changed, this, &BalancePanel::follow_selection);
  connect(states_, &QComboBox::activated, this, &BalancePanel::show_rows);
  connect(rows_, &QTreeWidget::itemSelectionChanged, this, &BalancePanel::select_lines);
  connect(rows_, &QTreeWidget::itemActivated, this, [this] { desk_.canvas.look_at_selection(); });
  show_outcome();
}

/// Numbers have the room that they need, and names the rest, in as many lines as that takes; no word is cut.
void BalancePanel::fit_names() {
  const QFontMetrics metrics = rows_->fontMetrics();
  const int around = 2 * (rows_->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
  int least = rows_->header()->sectionSizeHint(0);
  int icon = 0;
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem& row = *rows_->topLevelItem(i);
    if (!row.icon(0).isNull()) icon = rows_->style()->pixelMetric(QStyle::PM_SmallIconSize) + around;
    for (const QString& word : row.text(0).split(' ')) least = std::max(least, metrics.horizontalAdvance(word));
  }
  int numbers = 0;
  for (int column = 1; column < rows_->columnCount(); ++column) numbers += rows_->header()->sectionSize(column);
  const int width = std::max(least + icon + 2 * around, rows_->viewport()->width() - numbers);
  rows_->header()->resizeSection(0, width);
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem& row = *rows_->topLevelItem(i);
    const int room = width - around - (row.icon(0).isNull() ? 0 : icon);
    const QRect words = metrics.boundingRect(QRect(0, 0, room, INT_MAX / 2), Qt::TextWordWrap, row.text(0));
    row.setSizeHint(0, {width, std::max(words.height() + 2, row.icon(0).isNull() ? 0 : icon)});
  }
}

bool BalancePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == rows_->viewport() && event->type() == QEvent::Resize) fit_names();
  return QWidget::eventFilter(watched, event);
}

void BalancePanel::show_outcome() {
  stale_ = true;
  if (isVisible()) fill();
}

void BalancePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) fill();
}

void BalancePanel::fill() {
  stale_ = false;
  const model::Model* last = last_model(desk_.session);
  show_states(last == nullptr ? 0 : model::restored_stages(*last).size());
  show_rows();
}

/// All of the chain, and each of its stages where there are several.
void BalancePanel::show_states(std::size_t count) {
  const auto wanted = static_cast<int>(count > 1 ? count + 1 : count);
  states_->setVisible(count > 1);
  if (states_->count() == wanted) return;
  states_->clear();
  if (count > 0) states_->addItem(text("The input and the last state"));
  for (std::size_t k = 1; count > 1 && k <= count; ++k)
    states_->addItem(k == 1 ? text("The input and state 1") : text("States %1 and %2").arg(k - 1).arg(k));
}

void BalancePanel::show_rows() {
  following_ = true;
  rows_->clear();
  const model::Model* last = last_model(desk_.session);
  const auto chain = last == nullptr ? std::vector<const model::Stage*>() : model::restored_stages(*last);
  rows_->setVisible(!chain.empty());
  if (chain.empty()) {
    verdict_->setText(text("Nothing is restored or moved yet, so that there is nothing to compare."));
    following_ = false;
    return;
  }
  const auto state = static_cast<std::size_t>(std::max(states_->currentIndex(), 0));
  const model::Comparison compared =
      state == 0 ? model::compare(chain, 0, chain.size()) : model::compare(chain, state - 1, state);
  const double tolerance = model::balance_tolerance(chain);
  const QString most = QLocale().toString(tolerance);
  verdict_->setText(model::judge(compared, tolerance).balanced
                        ? text("Balanced: no bed and no unit changed by more than %1 %.").arg(most)
                        : text("Not balanced: what changed by more than %1 % is marked.").arg(most));
  add_rows(compared.beds, Row::Bed, tolerance);
  add_rows(compared.units, Row::Unit, tolerance);
  for (int column = 1; column < rows_->columnCount(); ++column) rows_->resizeColumnToContents(column);
  fit_names();
  following_ = false;
  follow_selection();
}

void BalancePanel::add_rows(const std::vector<model::Compared>& rows, Row kind, double tolerance) {
  const QString what = kind == Row::Bed ? text("Length of the bed") : text("Area of the unit");
  for (const model::Compared& row : rows) {
    const QString name = QString::fromStdString(row.name);
    auto* item = new QTreeWidgetItem(
        rows_, {name, percent(row.change_percent()), numbers::readable(row.before), numbers::readable(row.after)});
    for (int column = 1; column < item->columnCount(); ++column)
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    const bool judged = row.role == section::BedRole::Judged;
    item->setToolTip(0, name + "\n" + (judged ? what : what + text(" (not judged)")));
    if (kind == Row::Bed) item->setData(0, name_role, name);
    if (!judged || !(std::abs(row.change_percent()) > tolerance)) continue;
    item->setIcon(0, dobra::gui::theme::icon(dobra::gui::theme::Symbol::Warning));
    item->setData(1, Qt::AccessibleDescriptionRole, text("beyond the tolerance"));
  }
}

void BalancePanel::select_lines() {
  const QList<QTreeWidgetItem*> chosen = rows_->selectedItems();
  if (following_ || chosen.isEmpty() || desk_.canvas.workspace().empty()) return;
  const std::string name = chosen.front()->data(0, name_role).toString().toStdString();
  canvas::Selection selection;
  for (const auto& [pick, line] : desk_.canvas.workspace().lines()) {
    if (!name.empty() && pick.layer.starts_with("horizon_") && desk_.canvas.workspace().title(pick) == name)
      selection[pick] = {};
  }
  desk_.canvas.choose(std::move(selection));
}

void BalancePanel::follow_selection() {
  if (following_) return;
  const canvas::Workspace& work = desk_.canvas.workspace();
  const QString name = work.empty() || work.selection.empty()
                           ? QString()
                           : QString::fromStdString(work.title(work.selection.begin()->first));
  following_ = true;
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = rows_->topLevelItem(i);
    const bool chosen = !name.isEmpty() && row->data(0, name_role).toString() == name;
    row->setSelected(chosen);
    if (chosen) rows_->setCurrentItem(row);
  }
  following_ = false;
}

}  // namespace recon::gui
