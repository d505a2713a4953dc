#include "shared/gui/sheet/overlay_painter.h"

#include <QPainter>
#include <algorithm>
#include <utility>

namespace dobra::gui::sheet {

namespace {

constexpr double handle_size = 7.0;  ///< Pixels.

}  // namespace

OverlayPainter::OverlayPainter(QPainter& painter, Plot plot, const theme::CanvasColors& colors)
    : painter_(painter), plot_(std::move(plot)), colors_(colors) {
  painter_.setRenderHint(QPainter::Antialiasing);
  painter_.setClipRect(plot_.rect);
}

void OverlayPainter::glow(const geom::Polyline& line) {
  QColor color = colors_.chosen;
  color.setAlpha(90);
  draw_line(line, QPen(color, 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

void OverlayPainter::draw(const canvas::Overlay& overlay, const canvas::Snap* snap) {
  for (const geom::Polyline& line : overlay.chosen) draw_line(line, QPen(colors_.chosen, 2.5));
  for (const geom::Polyline& line : overlay.lines) draw_line(line, QPen(colors_.drawn, 1.6, Qt::DashLine));
  for (const geom::Point at : overlay.handles) handle(at, colors_.handle);
  for (const geom::Point at : overlay.chosen_handles) handle(at, colors_.chosen);
  if (snap != nullptr) draw_snap(*snap);
  for (const canvas::Overlay::Text& label : overlay.texts) write(label.at, QString::fromStdString(label.text), 16.0);
}

void OverlayPainter::draw_line(const geom::Polyline& line, const QPen& pen) {
  QPolygonF pixels;
  for (const geom::Point p : line.points) pixels.append(plot_.pixel_of(p));
  painter_.setPen(pen);
  painter_.setBrush(Qt::NoBrush);
  if (line.closed) {
    painter_.drawPolygon(pixels);
  } else {
    painter_.drawPolyline(pixels);
  }
}

void OverlayPainter::handle(geom::Point at, const QColor& fill) {
  const QPointF pixel = plot_.pixel_of(at);
  painter_.setPen(QPen(colors_.chosen, 1.2));
  painter_.setBrush(fill);
  painter_.drawRect(QRectF(pixel.x() - handle_size / 2, pixel.y() - handle_size / 2, handle_size, handle_size));
}

void OverlayPainter::draw_snap(const canvas::Snap& snap) {
  const QPointF c = plot_.pixel_of(snap.at);
  painter_.setPen(QPen(colors_.snapped, 1.8));
  painter_.setBrush(Qt::NoBrush);
  const double r = 6.0;
  switch (snap.kind) {
    case canvas::SnapKind::Vertex:
      painter_.drawRect(QRectF(c.x() - r, c.y() - r, 2 * r, 2 * r));
      break;
    case canvas::SnapKind::Intersection:
      painter_.drawLine(c + QPointF(-r, -r), c + QPointF(r, r));
      painter_.drawLine(c + QPointF(-r, r), c + QPointF(r, -r));
      break;
    case canvas::SnapKind::Perpendicular:
      painter_.drawPolyline(QPolygonF({c + QPointF(-r, -r), c + QPointF(-r, r), c + QPointF(r, r)}));
      painter_.drawPolyline(QPolygonF({c + QPointF(-r, 0), c, c + QPointF(0, r)}));
      break;
    case canvas::SnapKind::OnLine:
    case canvas::SnapKind::Grid:
    case canvas::SnapKind::Angle:
      painter_.drawEllipse(c, r, r);
      break;
  }
  write(snap.at, QString::fromStdString(canvas::snap_name(snap.kind)), -12.0);
}

void OverlayPainter::write(geom::Point at, const QString& words, double below) {
  const QPointF pixel = plot_.pixel_of(at);
  QRectF box = QFontMetricsF(painter_.font()).boundingRect(QRectF(0, 0, 400, 200), Qt::AlignLeft, words);
  box.moveTopLeft(pixel + QPointF(14.0, below < 0.0 ? below - box.height() : below));
  if (box.right() > plot_.rect.right() - 4.0) box.moveRight(pixel.x() - 14.0);
  box.moveBottom(std::min(box.bottom(), plot_.rect.bottom() - 4.0));
  box.moveTop(std::max(box.top(), plot_.rect.top() + 4.0));
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(colors_.behind_words);
  painter_.drawRoundedRect(box.adjusted(-4, -2, 4, 2), 3, 3);
  painter_.setPen(colors_.words);
  painter_.drawText(box, Qt::AlignLeft, words);
}

}  // namespace dobra::gui::sheet
