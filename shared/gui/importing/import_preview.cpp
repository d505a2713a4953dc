#include "shared/gui/importing/import_preview.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/box.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::importing {

namespace {

constexpr double most_stretched = 20.0;  ///< Heights against widths.

/// Points that fall on one pixel are drawn once.
QPolygonF thinned(const geom::Polyline& line, const auto& place) {
  QPolygonF points;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const QPointF at = place(line.points[i]);
    const bool last = i + 1 == line.points.size();
    if (!points.empty() && !last && std::abs(at.x() - points.back().x()) + std::abs(at.y() - points.back().y()) < 0.7)
      continue;
    points.push_back(at);
  }
  if (line.closed && !points.empty()) points.push_back(points.front());
  return points;
}

/// Of the canvas beside widgets of this palette.
const theme::CanvasColors& colors_beside(const QPalette& palette) {
  return theme::canvas_colors(theme::canvas_of(theme::CanvasChoice::AsTheme, palette));
}

QColor to_color(const scene::Color& color) { return {color.red, color.green, color.blue}; }

/// A colour of lines on white, as it is seen on the ground.
QColor on_ground(const QColor& color, const scene::Ground& ground) {
  const auto part = [](int value) { return static_cast<std::uint8_t>(value); };
  return to_color(scene::line_on({part(color.red()), part(color.green()), part(color.blue())}, ground));
}

double distance_to(QPointF p, QPointF a, QPointF b) {
  const QPointF way = b - a;
  const double squared = QPointF::dotProduct(way, way);
  const double t = squared > 0.0 ? std::clamp(QPointF::dotProduct(p - a, way) / squared, 0.0, 1.0) : 0.0;
  const QPointF gap = p - (a + t * way);
  return std::hypot(gap.x(), gap.y());
}

QImage image_of(const scene::Pixels& pixels) {
  return QImage(pixels.rgba.data(), static_cast<int>(pixels.width), static_cast<int>(pixels.height),
                static_cast<qsizetype>(4 * pixels.width), QImage::Format_RGBA8888);
}

}  // namespace

ImportPreview::ImportPreview(QWidget* parent) : QWidget(parent) {
  setObjectName("import.preview");
  setAccessibleName(text("Preview of the file"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ImportPreview::show_look(const scenario::ImportLook* look, const std::vector<scenario::ImportChoice>& choices) {
  look_ = look;
  choices_ = choices;
  std::erase_if(marked_, [&](std::size_t line) { return line >= choices.size(); });
  update();
}

void ImportPreview::mark(const std::set<std::size_t>& lines) {
  marked_ = lines;
  update();
}

QColor ImportPreview::color_of(const std::string& kind) {
  if (kind == "fault" || kind == "crack") return {198, 40, 40};
  if (kind == "topography") return {121, 85, 72};
  if (kind == "unit" || kind == "hole") return {106, 27, 154};
  if (kind == "border" || kind == "outline") return {38, 50, 56};
  if (kind == "marker") return {0, 105, 92};
  if (kind == "horizon" || kind == "growth") return {13, 71, 161};
  return {84, 110, 122};
}

std::optional<ImportPreview::Fit> ImportPreview::fit() const {
  if (look_ == nullptr) return std::nullopt;
  geom::Box box;
  for (const scenario::ImportLine& line : look_->lines) {
    for (const geom::Polyline& part : line.parts) {
      for (const geom::Point p : part.points) box.add(p);
    }
  }
  if (look_->picture) {
    box.add(look_->picture->box.low);
    box.add(look_->picture->box.high);
  }
  if (!(box.high.x >= box.low.x) || !(box.high.y >= box.low.y)) return std::nullopt;
  const QFontMetrics metrics(font());
  Fit fit;
  fit.low = box.low;
  fit.frame = QRectF(rect()).adjusted(6, 6 + metrics.height(), -6, -6 - metrics.height());
  const double width = std::max(box.width(), 1e-12 * std::max(1.0, box.height()));
  const double height = std::max(box.height(), 1e-12 * std::max(1.0, box.width()));
  fit.scale_x = fit.frame.width() / width;
  fit.scale_y = fit.frame.height() / height;
  // To scale, but for long thin sections.
  if (fit.scale_x > fit.scale_y) {
    fit.scale_x = std::min(fit.scale_x, fit.scale_y);
  } else {
    fit.scale_y = std::min(fit.scale_y, most_stretched * fit.scale_x);
    if (box.height() * fit.scale_x > 0.35 * fit.frame.height()) fit.scale_y = fit.scale_x;
  }
  fit.frame = QRectF(fit.frame.center().x() - 0.5 * fit.scale_x * width,
                     fit.frame.center().y() - 0.5 * fit.scale_y * height, fit.scale_x * width, fit.scale_y * height);
  return fit;
}

void ImportPreview::draw_lines(QPainter& painter, const Fit& fit) const {
  const auto draw = [&](std::size_t i) {
    const scenario::ImportLine& line = look_->lines[i];
    QColor color = on_ground(color_of(choices_[i].kind), colors_beside(palette()).ground);
    if (!choices_[i].taken) {
      color = colors_beside(palette()).quiet;
      color.setAlpha(90);
    }
    const double width = marked_.contains(i) ? 3.0 : 1.3;
    painter.setPen(QPen(color, width));
    for (const geom::Polyline& part : line.parts) {
      const QPolygonF points = thinned(part, [&](geom::Point p) { return fit.at(p); });
      if (line.shape == scenario::ImportShape::Points) {
        painter.setBrush(color);
        for (const QPointF p : points) painter.drawEllipse(p, width + 1.0, width + 1.0);
        painter.setBrush(Qt::NoBrush);
      } else {
        painter.drawPolyline(points);
      }
    }
  };
  for (std::size_t i = 0; i < look_->lines.size(); ++i) {
    if (!marked_.contains(i)) draw(i);
  }
  for (const std::size_t i : marked_) draw(i);
}

void ImportPreview::draw_frame(QPainter& painter, const Fit& fit) const {
  painter.setPen(colors_beside(palette()).quiet);
  const QLocale locale;
  const auto number = [&](double value) { return locale.toString(value, 'g', 6); };
  const geom::Point high{fit.low.x + fit.frame.width() / fit.scale_x, fit.low.y + fit.frame.height() / fit.scale_y};
  const QRectF all = QRectF(rect()).adjusted(6, 3, -6, -3);
  painter.drawText(all, Qt::AlignTop | Qt::AlignLeft,
                   text("%1 to %2 m upwards").arg(number(fit.low.y), number(high.y)));
  painter.drawText(all, Qt::AlignBottom | Qt::AlignLeft,
                   text("%1 to %2 m along").arg(number(fit.low.x), number(high.x)));
  const double stretched = fit.scale_y / fit.scale_x;
  if (stretched > 1.01)
    painter.drawText(all, Qt::AlignBottom | Qt::AlignRight,
                     text("heights × %1").arg(locale.toString(stretched, 'g', 2)));
}

void ImportPreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const theme::CanvasColors& colors = colors_beside(palette());
  painter.fillRect(rect(), to_color(colors.ground.paper));
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  const auto placed = fit();
  if (!placed) {
    painter.setPen(colors.quiet);
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     text("Nothing can be shown yet."));
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (look_->picture) {
    const geom::Box& box = look_->picture->box;
    const QRectF where(placed->at({box.low.x, box.high.y}), placed->at({box.high.x, box.low.y}));
    painter.drawImage(where, image_of(*look_->picture->pixels));
  } else {
    draw_lines(painter, *placed);
  }
  if (look_->placed) draw_frame(painter, *placed);
}

void ImportPreview::mousePressEvent(QMouseEvent* event) {
  const auto placed = fit();
  if (!placed || event->button() != Qt::LeftButton) return;
  double nearest = 8.0;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < look_->lines.size(); ++i) {
    for (const geom::Polyline& part : look_->lines[i].parts) {
      const QPolygonF points = thinned(part, [&](geom::Point p) { return placed->at(p); });
      for (qsizetype k = 0; k < points.size(); ++k) {
        const double gap = distance_to(event->position(), points[k], points[std::min(k + 1, points.size() - 1)]);
        if (gap < nearest) nearest = gap, found = i;
      }
    }
  }
  if (found) emit clicked(*found);
}

}  // namespace dobra::gui::importing
