#include "shared/gui/frames/meter.h"

#include <QShortcut>
#include <QString>
#include <algorithm>
#include <utility>

#include "shared/base/text.h"

namespace dobra::gui::frames {

double Meter::milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void Meter::add(Part part, double milliseconds) {
  last_[static_cast<std::size_t>(part)] = milliseconds;
  emit changed();
}

void Meter::count_frame() {
  ++frames_;
  if (std::exchange(new_state_, false)) ++states_;
  const Clock::time_point now = Clock::now();
  recent_.push_back(now);
  while (now - recent_.front() > std::chrono::seconds(1)) recent_.pop_front();
}

void Meter::add_full_frame(double milliseconds, double deaf) {
  ++full_frames_;
  longest_.milliseconds = std::max(longest_.milliseconds, milliseconds);
  longest_.deaf = std::max(longest_.deaf, deaf);
}

void Meter::expect_state() { new_state_ = true; }

QString Meter::words() const {
  const std::array<const char*, part_count> names{"edit", "run", "layers", "actors", "draw"};
  QString said;
  for (std::size_t i = 0; i < names.size(); ++i)
    said += QString::fromStdString(base::translated(names[i])) + QString(" %1  ").arg(last_[i], 0, 'f', 1);
  return said + QString("ms  %1 ").arg(recent_.size()) + QString::fromStdString(base::translated("frames/s"));
}

MeterLabel::MeterLabel(Meter& meter, QWidget* parent) : QLabel(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setStyleSheet("background: rgba(0, 0, 0, 170); color: white; padding: 3px 6px");
  const auto show_words = [this, &meter] {
    if (isHidden()) return;  // words cost more than numbers
    setText(meter.words());
    adjustSize();
    move(6, 6);
  };
  connect(&meter, &Meter::changed, this, show_words);
  connect(new QShortcut(Qt::Key_F12, parent), &QShortcut::activated, this, [this, show_words] {
    setVisible(isHidden());
    show_words();
  });
  setVisible(qEnvironmentVariableIntValue("DOBRA_METER") != 0);
}

}  // namespace dobra::gui::frames
