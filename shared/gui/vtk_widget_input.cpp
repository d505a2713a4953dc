// What the mouse and the keys do to the view, and what is said of the place under the cursor.
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "shared/canvas/entry.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::gui {

namespace {

constexpr double pick_reach = 8.0;    ///< Pixels round the cursor, as the tools reach.
constexpr double zoom_a_notch = 1.2;  ///< Of the wheel: 15 degrees, 120 units.
constexpr double pan_a_key = 0.1;     ///< Of the plot.

/// "x" of "x [m]".
QString axis_name(const std::string& title) { return QString::fromStdString(title.substr(0, title.find(" ["))); }

/// "m" of "x [m]"; empty without one.
QString axis_unit(const std::string& title) {
  const std::size_t open = title.rfind('[');
  const bool has_one = open != std::string::npos && title.ends_with(']');
  return has_one ? QString::fromStdString(title.substr(open + 1, title.size() - open - 2)) : QString();
}

}  // namespace

void VtkWidget::pick(QPointF pixel) {
  const std::optional<Spot> spot = spot_at(pixel);
  if (!spot) return;
  const scene::Panel& panel = picture_.panels[spot->panel];
  const double scale = view(spot->panel).world_per_point;
  const std::optional<scene::Pick> found = scene::pick(panel, spot->at, pick_reach * scale);
  emit picked_item(spot->panel, found, spot->at);
  if (!found) {
    emit picked(text("Nothing here."));
    return;
  }
  const auto is_it = [&](const scene::Layer& layer) { return layer.key == found->layer; };
  const auto layer = std::find_if(panel.layers.begin(), panel.layers.end(), is_it);
  const std::string title = layer != panel.layers.end() && !layer->title.empty() ? layer->title : found->layer;
  emit picked(text("%1, item %2").arg(QString::fromStdString(title)).arg(found->id));
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
  const bool hand = hand_ == Hand::Ready || hand_tool_;
  const bool pans = event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && hand);
  if (pans && dragging_ == Qt::NoButton) {
    dragging_ = event->button();
    drag_ = event->position();
    show_cursor();
  } else if (event->button() == Qt::LeftButton) {
    pick(event->position());
  }
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_ != Qt::NoButton) {
    pan(drag_, event->position() - drag_);
    drag_ = event->position();
  }
  const std::optional<Spot> spot = spot_at(event->position());
  if (!spot) {
    emit cursor_moved({});
    return;
  }
  const scene::Panel& panel = picture_.panels[spot->panel];
  const double scale = view(spot->panel).world_per_point;
  const auto number = [&](double value, const scene::Reading& reading) {
    // As many decimals as a pixel can tell apart.
    const double pixel = scale * std::abs(reading.per_unit);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 12);
    return QString::fromStdString(
        canvas::with_decimal_mark(QString::number(reading.of(value), 'f', decimals).toStdString()));
  };
  const scene::Axes& axes = panel.axes;
  const scene::Reading x = axes.x_reading.value_or(scene::Reading{axes.x_title, 0.0, 1.0 / axes.unit});
  const scene::Reading y = axes.y_reading.value_or(scene::Reading{axes.y_title, 0.0, 1.0 / axes.unit});
  // A unit that both have is said once.
  const QString of_x = axis_unit(x.title), of_y = axis_unit(y.title);
  emit cursor_moved(QString("%1 = %2%3   %4 = %5 %6")
                        .arg(axis_name(x.title), number(spot->at.x, x), of_x == of_y ? QString() : " " + of_x,
                             axis_name(y.title), number(spot->at.y, y), of_y)
                        .trimmed());
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != dragging_) return;
  dragging_ = Qt::NoButton;
  show_cursor();
}

void VtkWidget::show_cursor() {
  if (dragging_ != Qt::NoButton) {
    setCursor(Qt::ClosedHandCursor);
  } else if (hand_ == Hand::Ready || hand_tool_) {
    setCursor(Qt::OpenHandCursor);
  } else {
    setCursor(tool_cursor_);
  }
}

void VtkWidget::set_hand(bool on) {
  hand_tool_ = on;
  show_cursor();
}

void VtkWidget::set_tool_cursor(const QCursor& cursor) {
  tool_cursor_ = cursor;
  show_cursor();
}

void VtkWidget::keyPressEvent(QKeyEvent* event) {
  const QPointF middle(0.5 * width(), 0.5 * height());
  switch (event->key()) {
    case Qt::Key_Space:
      hand_ = Hand::Ready;
      return show_cursor();
    case Qt::Key_Left:
      return pan_by_key(-1, 0);
    case Qt::Key_Right:
      return pan_by_key(1, 0);
    case Qt::Key_Up:
      return pan_by_key(0, 1);
    case Qt::Key_Down:
      return pan_by_key(0, -1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(zoom_a_notch, middle);
    case Qt::Key_Minus:
      return zoom(1.0 / zoom_a_notch, middle);
    case Qt::Key_Home:
      return fit();
    default:
      stage::VtkFrames::keyPressEvent(event);
  }
}

void VtkWidget::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return stage::VtkFrames::keyReleaseEvent(event);
  if (event->isAutoRepeat()) return;
  hand_ = Hand::Away;
  show_cursor();
}

void VtkWidget::focusOutEvent(QFocusEvent* event) {
  hand_ = Hand::Away;
  show_cursor();
  stage::VtkFrames::focusOutEvent(event);
}

/// The view moves over the model, so the model moves the other way. Each panel pans by a part of its own.
void VtkWidget::pan_by_key(int right, int up) {
  if (!scene_) return;
  remember(view::Move::Glide);
  for (std::size_t i = 0; i < panel_count(); ++i) {
    const QRectF part = plot(i);
    const geom::Vector by{-pan_a_key * right * part.width(), pan_a_key * up * part.height()};
    views_[i] = scene::pan(view(i), by, picture_.panels[i].vertical_exaggeration);
  }
  move_views();
}

void VtkWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) fit();
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) zoom(std::pow(zoom_a_notch, notches), event->position());
  event->accept();
}

void VtkWidget::leaveEvent(QEvent*) { emit cursor_moved({}); }

}  // namespace dobra::gui
