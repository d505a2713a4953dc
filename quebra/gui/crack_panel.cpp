#include "quebra/gui/crack_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "quebra/analysis/analysis.h"
#include "quebra/model/model.h"
#include "shared/gui/canvas.h"
#include "shared/gui/numbers/numbers.h"
#include "shared/gui/session.h"
#include "shared/gui/text.h"

namespace quebra::gui {

namespace {

namespace canvas = dobra::canvas;
namespace fem = dobra::fem;
namespace geom = dobra::geom;
namespace numbers = dobra::gui::numbers;
namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using dobra::gui::text;

constexpr int curve_role = Qt::UserRole;  ///< Of the row of a crack: its number among the curves.
constexpr const char* layer = "cracks";   ///< That the picture of the domain draws them in.

const model::Model* last_model(const dobra::gui::Session& session) {
  const dobra::gui::documents::OutcomePtr& outcome = session.outcome();
  if (!outcome || outcome->run.states.empty()) return nullptr;
  return &scenario::model_of<model::Model>(outcome->run.states.back());
}

/// The last analysis whose tips were asked for.
const analysis::Analysis* analysed_tips(const model::Model& model) {
  const bool any = !model.analyses.empty() && !model.analyses.back()->tips.empty();
  return any ? model.analyses.back().get() : nullptr;
}

/// From start to end, degrees anticlockwise from +x.
double direction_of(const sketch::Curve& crack) {
  const geom::Vector way = sketch::point(crack, sketch::length(crack)) - sketch::point(crack, 0.0);
  return std::atan2(way.y, way.x) * 180.0 / std::numbers::pi;
}

}  // namespace

CrackPanel::CrackPanel(const dobra::gui::Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  cases_ = new QComboBox(this);
  cases_->setObjectName("cracks.cases");
  cases_->setAccessibleName(text("Load case"));
  none_ = new QLabel(text("There are no cracks. The tool Crack (K) draws one."), this);
  none_->setObjectName("cracks.none");
  none_->setWordWrap(true);
  none_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  rows_ = new QTreeWidget(this);
  rows_->setObjectName("cracks.rows");
  rows_->setAccessibleName(text("Cracks"));
  rows_->setUniformRowHeights(true);
  rows_->header()->setStretchLastSection(false);
  column->addWidget(cases_);
  column->addWidget(none_, 1);
  column->addWidget(rows_, 1);
  connect(&desk_.session, &dobra::gui::Session::run_finished, this, &CrackPanel::show_outcome);
  connect(&desk_.session, &dobra::gui::Session::document_changed, this, [this] {
    if (desk_.session.outcome() == nullptr) show_outcome();
  });
  connect(&desk_.canvas, &dobra::gui::Canvas::lines_changed, this, &CrackPanel::follow_selection);
  connect(cases_, &QComboBox::activated, this, &CrackPanel::show_rows);
  connect(rows_, &QTreeWidget::itemSelectionChanged, this, &CrackPanel::select_crack);
  connect(rows_, &QTreeWidget::itemActivated, this, [this] { desk_.canvas.look_at_selection(); });
  show_outcome();
}

void CrackPanel::show_outcome() {
  stale_ = true;
  if (isVisible()) fill();
}

void CrackPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) fill();
}

void CrackPanel::fill() {
  stale_ = false;
  const model::Model* model = last_model(desk_.session);
  const analysis::Analysis* analysed = model == nullptr ? nullptr : analysed_tips(*model);
  QStringList cases;
  if (analysed != nullptr) {
    for (const fem::LoadCase& load : analysed->problem.cases) cases.push_back(QString::fromStdString(load.name));
  }
  QStringList shown;
  for (int i = 0; i < cases_->count(); ++i) shown.push_back(cases_->itemText(i));
  if (shown != cases) {
    cases_->clear();
    cases_->addItems(cases);
  }
  cases_->setVisible(cases.size() > 1);
  show_rows();
}

void CrackPanel::show_rows() {
  following_ = true;
  rows_->clear();
  const model::Model* model = last_model(desk_.session);
  const bool any = model != nullptr && std::any_of(model->domain.curves.begin(), model->domain.curves.end(),
                                                   [](const auto& c) { return c.role == sketch::Role::Crack; });
  none_->setVisible(!any);
  rows_->setVisible(any);
  if (any) {
    const scenario::UnitSystem& units = model->units;
    const QString k = "\n[" + numbers::unit_text(units.unit("Pa sqrt(m)")) + "]";
    rows_->setHeaderLabels({text("Crack"), text("Length") + QString("\n[%1]").arg(units.length_unit().c_str()),
                            text("Direction") + QString::fromUtf8("\n[°]"), "K_I" + k, "K_II" + k});
    const analysis::Analysis* analysed = analysed_tips(*model);
    const auto load = static_cast<std::size_t>(std::max(cases_->currentIndex(), 0));
    std::map<std::string, const fem::fracture::TipResult*> tips;
    if (analysed != nullptr && load < analysed->tips.size()) {
      for (const fem::fracture::TipResult& tip : analysed->tips[load]) tips.emplace(tip.name, &tip);
    }
    for (std::size_t c = 0; c < model->domain.curves.size(); ++c) {
      const sketch::Curve& crack = model->domain.curves[c];
      if (crack.role != sketch::Role::Crack) continue;
      auto* row = new QTreeWidgetItem(
          rows_, {QString::fromStdString(crack.name), numbers::readable(units.from_si(sketch::length(crack), "m")),
                  numbers::readable(direction_of(crack))});
      row->setData(0, curve_role, static_cast<int>(c));
      for (const char* end : {"_start", "_end"}) {
        const auto found = tips.find(crack.name + end);
        if (found == tips.end()) continue;
        const fem::fracture::TipResult& tip = *found->second;
        auto* at = new QTreeWidgetItem(row, {QString::fromStdString(tip.name)});
        at->setData(0, curve_role, static_cast<int>(c));
        if (tip.refused) {
          at->setText(3, text("none"));
          at->setToolTip(3, QString::fromStdString(tip.refused->message));
          continue;
        }
        at->setText(3, numbers::readable(units.from_si(tip.domain.k.one, "Pa sqrt(m)")));
        at->setText(4, numbers::readable(units.from_si(tip.domain.k.two, "Pa sqrt(m)")));
      }
    }
    rows_->expandAll();
    for (int column = 0; column < rows_->columnCount(); ++column) rows_->resizeColumnToContents(column);
  }
  following_ = false;
  follow_selection();
}

void CrackPanel::select_crack() {
  const QList<QTreeWidgetItem*> chosen = rows_->selectedItems();
  if (following_ || chosen.isEmpty() || desk_.canvas.workspace().empty()) return;
  const scene::Pick pick{layer, static_cast<std::uint32_t>(chosen.front()->data(0, curve_role).toInt())};
  following_ = true;
  if (desk_.canvas.workspace().line(pick) != nullptr) {
    desk_.canvas.choose({{pick, {}}});
  } else {
    desk_.canvas.say(
        text("This picture does not show the crack; look at the input (Ctrl+1), or show the layer of cracks."));
  }
  following_ = false;
}

void CrackPanel::follow_selection() {
  if (following_) return;
  const canvas::Workspace& work = desk_.canvas.workspace();
  const bool any = !work.empty() && !work.selection.empty() && work.selection.begin()->first.layer == layer;
  following_ = true;
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = rows_->topLevelItem(i);
    const bool chosen = any && row->data(0, curve_role).toInt() == static_cast<int>(work.selection.begin()->first.id);
    row->setSelected(chosen);
    if (chosen) rows_->setCurrentItem(row);
  }
  following_ = false;
}

}  // namespace quebra::gui
