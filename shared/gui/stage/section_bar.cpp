#include "shared/gui/stage/section_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/canvas/rounding.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::stage {

namespace {

namespace space = scene::space;

constexpr int steps = 1000;    ///< Of the slider.
constexpr int turned_row = 3;  ///< Of the box of axes, behind x, y and z; there as long as the plane is turned.

QString name_of(const std::string& title) { return QString::fromStdString(title.substr(0, title.find(" ["))); }

QString marked(const QString& number) {
  return QString::fromStdString(canvas::with_decimal_mark(number.toStdString()));
}

QString words_of(const geom::Vector3& normal) {
  const auto one = [](double value) { return marked(QString::number(value + 0.0, 'f', 2)); };
  return QString("(%1; %2; %3)").arg(one(normal.x), one(normal.y), one(normal.z));
}

}  // namespace

SectionBar::SectionBar(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  axis_ = new QComboBox(this);
  axis_->setObjectName("section.axis");
  axis_->setAccessibleName(text("Section plane"));
  axis_->setToolTip(text("What the section plane is square to: an axis, or a direction once its rim is dragged"));
  axis_->addItems({"x", "y", "z"});
  axis_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName("section.place");
  slider_->setAccessibleName(text("Place of the section plane"));
  slider_->setRange(0, steps);
  slider_->setPageStep(steps / 20);
  place_ = new QLineEdit(this);
  place_->setObjectName("section.number");
  place_->setAccessibleName(text("Place of the section plane, a number"));
  place_->setToolTip(text("Where the plane stands on the axis; turned, how far from the origin along its normal"));
  place_->setAlignment(Qt::AlignRight);
  place_->setMinimumWidth(place_->fontMetrics().horizontalAdvance("-0000.00") + 12);
  place_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  place_->installEventFilter(this);
  unit_ = new QLabel(this);
  side_ = new QToolButton(this);
  side_->setObjectName("section.side");
  side_->setText(text("Other side"));
  side_->setToolTip(text("Takes away what lies on the other side of the plane"));
  side_->setCheckable(true);
  row->addWidget(axis_);
  row->addWidget(slider_, 3);
  row->addWidget(place_, 1);
  row->addWidget(unit_);
  row->addWidget(side_);
  show_all();
  connect(axis_, &QComboBox::activated, this, &SectionBar::take_axis);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    space::Section now = section_;
    now.part = static_cast<double>(value) / steps;
    tell(now);
  });
  connect(place_, &QLineEdit::returnPressed, this, &SectionBar::take_place);
  connect(side_, &QToolButton::toggled, this, [this](bool on) {
    space::Section now = section_;
    now.other_side = on;
    tell(now);
  });
}

void SectionBar::show_axes(const space::Axes& axes, const geom::Box3& box) {
  axes_ = axes;
  box_ = box;
  for (int i = 0; i < turned_row; ++i)
    axis_->setItemText(i, name_of(i == 0 ? axes.x_title : i == 1 ? axes.y_title : axes.z_title));
  const QString title = QString::fromStdString(axes.x_title);
  unit_->setText(title.contains(" [") ? title.section(" [", 1).chopped(1) : QString());
  unit_->setVisible(!unit_->text().isEmpty());
  show_all();
}

void SectionBar::show_section(const space::Section& section) {
  section_ = section;
  show_all();
}

void SectionBar::show_all() {
  const QSignalBlocker axis(axis_), slider(slider_), side(side_);
  const auto along = space::axis_of(section_);
  while (axis_->count() > turned_row) axis_->removeItem(turned_row);
  if (!along) axis_->addItem(words_of(section_.normal));
  axis_->setCurrentIndex(along ? static_cast<int>(*along) : turned_row);
  slider_->setValue(static_cast<int>(std::lround(section_.part * steps)));
  side_->setChecked(section_.other_side);
  show_place();
}

QString SectionBar::number(double place) const {
  const double pixel = std::max(box_.diagonal(), 1e-300) / axes_.unit / steps;
  return marked(QString::number(canvas::rounded(place / axes_.unit, 10.0 * pixel), 'g', 6));
}

void SectionBar::show_place() { place_->setText(number(space::place_of(section_, box_))); }

void SectionBar::take_axis(int row) {
  if (row >= turned_row) return;
  tell(space::section_across(static_cast<space::CutAxis>(row), section_.part, section_.other_side));
}

void SectionBar::take_place() {
  const auto typed = base::parse_number(place_->text().trimmed().replace(',', '.').toStdString());
  const space::Reach reach = space::reach_along(section_.normal, box_);
  const double place = typed.value_or(0.0) * axes_.unit;
  const double rounding = box_.diagonal() / steps;  // an end may be typed as it is shown
  if (!typed || place < reach.from - rounding || place > reach.to + rounding) {
    emit refused(text("The section plane stands from %1 to %2.").arg(number(reach.from), number(reach.to)));
    return show_place();
  }
  tell(space::placed(section_, box_, place));
  place_->selectAll();
}

void SectionBar::tell(const space::Section& section) {
  if (section == section_) return show_all();
  show_section(section);
  emit moved(section_);
}

/// What is typed and not taken is forgotten: a view has nothing to lose.
bool SectionBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched != place_) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::FocusOut) show_place();
  if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
  show_place();
  return true;
}

}  // namespace dobra::gui::stage
