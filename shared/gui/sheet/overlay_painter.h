#pragma once
// What a tool of the canvas shows over the picture, drawn in pixels: lines, handles, the mark of a snap and its name,
// words beside a place. Page: docs/user/canvas.md.

#include <QPointF>
#include <QRectF>
#include <functional>

#include "shared/canvas/tool.h"
#include "shared/gui/theme/colors.h"

class QColor;
class QPainter;
class QPen;

namespace dobra::gui::sheet {

/// Where a panel lies in the window.
struct Plot {
  QRectF rect;  ///< In pixels; nothing is drawn outside of it.
  std::function<QPointF(geom::Point)> pixel_of;
};

class OverlayPainter {
 public:
  /// @pre painter and colours outlive this one.
  OverlayPainter(QPainter& painter, Plot plot, const theme::CanvasColors& colors);

  /// A line to which a click would belong.
  void glow(const geom::Polyline& line);
  /// The overlay of a tool and, if there is one, the snap under the cursor.
  void draw(const canvas::Overlay& overlay, const canvas::Snap* snap);

 private:
  void draw_line(const geom::Polyline& line, const QPen& pen);
  void handle(geom::Point at, const QColor& fill);
  /// A mark of its own for each kind, and its name.
  void draw_snap(const canvas::Snap& snap);
  /// Beside a place, above or below it, within the plot.
  void write(geom::Point at, const QString& words, double below);

  QPainter& painter_;
  Plot plot_;
  const theme::CanvasColors& colors_;
};

}  // namespace dobra::gui::sheet
