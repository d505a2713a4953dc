#include "shared/gui/stage/section_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "shared/canvas/entry.h"
#include "shared/canvas/rounding.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::stage {

namespace {

constexpr int steps = 1000;  ///< Of the slider.

QString name_of(const std::string& title) { return QString::fromStdString(title.substr(0, title.find(" ["))); }

}  // namespace

SectionBar::SectionBar(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  axis_ = new QComboBox(this);
  axis_->setObjectName("section.axis");
  axis_->setAccessibleName(text("Section plane"));
  axis_->setToolTip(text("The axis that the section plane is square to"));
  axis_->addItems({"x", "y", "z"});
  place_ = new QSlider(Qt::Horizontal, this);
  place_->setObjectName("section.place");
  place_->setAccessibleName(text("Place of the section plane"));
  place_->setRange(0, steps);
  place_->setPageStep(steps / 20);
  place_->setValue(steps / 2);
  where_ = new QLabel(this);
  side_ = new QToolButton(this);
  side_->setObjectName("section.side");
  side_->setText(text("Other side"));
  side_->setToolTip(text("Takes away what lies on the other side of the plane"));
  side_->setCheckable(true);
  row->addWidget(axis_);
  row->addWidget(place_, 1);
  row->addWidget(where_);
  row->addWidget(side_);
  connect(axis_, &QComboBox::currentIndexChanged, this, &SectionBar::tell);
  connect(place_, &QSlider::valueChanged, this, &SectionBar::tell);
  connect(side_, &QToolButton::toggled, this, &SectionBar::tell);
}

Section SectionBar::section() const {
  return {static_cast<scene::space::CutAxis>(std::max(axis_->currentIndex(), 0)),
          static_cast<double>(place_->value()) / steps, side_->isChecked()};
}

void SectionBar::show_axes(const scene::space::Axes& axes, const geom::Box3& box) {
  axes_ = axes;
  box_ = box;
  for (int i = 0; i < axis_->count(); ++i)
    axis_->setItemText(i, name_of(i == 0 ? axes.x_title : i == 1 ? axes.y_title : axes.z_title));
  show_place();
}

void SectionBar::show_place() {
  if (box_.empty()) return;
  const Section now = section();
  const geom::Point3 at = scene::space::plane_across(now.axis, now.part, box_, false).through;
  const int axis = axis_->currentIndex();
  const double low = axis == 0 ? at.x : axis == 1 ? at.y : at.z;
  const double pixel = std::max(box_.diagonal(), 1e-300) / axes_.unit / steps;
  const QString number = QString::number(canvas::rounded(low / axes_.unit, 10.0 * pixel), 'g', 6);
  const QString title = QString::fromStdString(axis == 0 ? axes_.x_title : axis == 1 ? axes_.y_title : axes_.z_title);
  const QString unit = title.contains(" [") ? " " + title.section(" [", 1).chopped(1) : QString();
  where_->setText(QString::fromStdString(canvas::with_decimal_mark(number.toStdString())) + unit);
  where_->setMinimumWidth(std::max(where_->minimumWidth(), where_->sizeHint().width()));  // the slider stands still
}

void SectionBar::tell() {
  show_place();
  emit moved(section());
}

}  // namespace dobra::gui::stage
