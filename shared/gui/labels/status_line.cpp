#include "shared/gui/labels/status_line.h"

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

#include "shared/gui/labels/labels.h"
#include "shared/gui/theme/icons.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::labels {

namespace {

constexpr int worth_progress = 300;  ///< Milliseconds that runs take before their progress is shown.

}  // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      hint_(new Line(this)),
      state_(new Line(this)),
      place_(new QLabel(this)),
      dip_(new Line(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  hint_->setObjectName("status.hint");
  state_->setObjectName("status.state");
  state_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  place_->setMinimumWidth(place_->fontMetrics().horizontalAdvance("x = -00000.000   y = -00000.000 m") + 12);
  place_->setObjectName("status.place");
  dip_->setObjectName("status.dip");
  dip_->setMaximumWidth(dip_->fontMetrics().horizontalAdvance(text("dip {:.1f}°") + " (a bed of a long name)"));
  progress_->setMinimumWidth(60);
  progress_->setMaximumWidth(220);
  progress_->setRange(0, 1000);
  cancel_->setIcon(theme::icon(theme::Symbol::Cancel));
  cancel_->setText(text("Cancel"));
  cancel_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  progress_->hide();
  cancel_->hide();
  place_->hide();
  patience_.setSingleShot(true);
  patience_.setInterval(worth_progress);
  connect(&patience_, &QTimer::timeout, this, [this] {
    progress_->show();
    cancel_->show();
  });
  addWidget(hint_, 3);
  addWidget(state_, 1);
  addPermanentWidget(progress_);
  addPermanentWidget(cancel_);
  addPermanentWidget(dip_);
  addPermanentWidget(place_);
  connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancel_asked);
}

void StatusLine::show_hint(const QString& hint) { hint_->say(hint); }
void StatusLine::show_state(const QString& state) { state_->say(state); }
void StatusLine::show_dip(const QString& dip) { dip_->say(dip); }
/// Where the place has no text it takes no room: a small window has none to spare.
void StatusLine::show_place(const QString& place) {
  place_->setText(place);
  place_->setVisible(!place.isEmpty());
}

void StatusLine::begin_run() {
  progress_->setValue(0);
  progress_->setFormat(text("running"));
  if (!patience_.isActive() && progress_->isHidden()) patience_.start();
}

void StatusLine::show_progress(double fraction, const QString& what) {
  progress_->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
  progress_->setFormat(what.isEmpty() ? text("running") + " %p%" : what);
}

void StatusLine::end_run() {
  patience_.stop();
  progress_->hide();
  cancel_->hide();
}

}  // namespace dobra::gui::labels
