#include "shared/gui/theme/icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace dobra::gui::theme {

namespace {

const QColor green(0x2e, 0x7d, 0x32);
const QColor red(0xc6, 0x28, 0x28);
const QColor amber(0xe6, 0x9f, 0x00);
const QColor blue(0x15, 0x65, 0xc0);

void fill(QPainter& painter, const QColor& color, const QPainterPath& path) { painter.fillPath(path, color); }

QPainterPath polygon(std::initializer_list<QPointF> points) {
  QPainterPath path;
  path.addPolygon(QPolygonF(QList<QPointF>(points)));
  path.closeSubpath();
  return path;
}

void draw_open(QPainter& p) {
  p.drawPolyline(QPolygonF({{3, 19}, {3, 5}, {9, 5}, {11, 8}, {18, 8}, {18, 11}}));
  p.drawPolygon(QPolygonF({{3, 19}, {7, 11}, {22, 11}, {18, 19}}));
}
void draw_save(QPainter& p) {
  p.drawPolygon(QPolygonF({{4, 4}, {17, 4}, {20, 7}, {20, 20}, {4, 20}}));
  p.drawRect(QRectF(8, 4, 7, 5));
  p.drawRect(QRectF(7, 13, 10, 7));
}
void draw_save_picture(QPainter& p) {
  p.drawRect(QRectF(3, 5, 18, 14));
  p.drawPolyline(QPolygonF({{4, 17}, {9, 11}, {13, 15}, {16, 12}, {20, 16}}));
  p.drawEllipse(QPointF(16, 9), 1.2, 1.2);
}
void draw_undo(QPainter& p) {
  QPainterPath arc(QPointF(5, 10));
  arc.cubicTo(12, 6, 20, 9, 19, 19);
  p.drawPath(arc);
  p.drawPolyline(QPolygonF({{10, 5}, {5, 10}, {11, 14}}));
}
void draw_redo(QPainter& p) {
  p.translate(24, 0);
  p.scale(-1, 1);
  draw_undo(p);
}
void draw_fit(QPainter& p) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    p.drawPolyline(QPolygonF({{4, 9}, {4, 4}, {9, 4}}));
    p.translate(24, 0);
    p.rotate(90);
  }
  p.drawRect(QRectF(9, 9, 6, 6));
}
void draw_run(QPainter& p) { fill(p, green, polygon({{7, 4}, {20, 12}, {7, 20}})); }
void draw_cancel(QPainter& p) {
  QPainterPath square;
  square.addRoundedRect(QRectF(6, 6, 12, 12), 1.5, 1.5);
  fill(p, red, square);
}
void draw_add(QPainter& p) {
  p.drawLine(QPointF(12, 5), QPointF(12, 19));
  p.drawLine(QPointF(5, 12), QPointF(19, 12));
}
void draw_remove(QPainter& p) { p.drawLine(QPointF(5, 12), QPointF(19, 12)); }
void draw_up(QPainter& p) {
  p.drawLine(QPointF(12, 5), QPointF(12, 20));
  p.drawPolyline(QPolygonF({{6, 11}, {12, 5}, {18, 11}}));
}
void draw_down(QPainter& p) {
  p.translate(0, 24);
  p.scale(1, -1);
  draw_up(p);
}

void disc(QPainter& p, const QColor& color) {
  p.setPen(Qt::NoPen);
  p.setBrush(color);
  p.drawEllipse(QPointF(12, 12), 9.5, 9.5);
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(Qt::white, 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}
void draw_done(QPainter& p) {
  disc(p, green);
  p.drawPolyline(QPolygonF({{7.5, 12.5}, {11, 16}, {17, 8.5}}));
}
void draw_failed(QPainter& p) {
  disc(p, red);
  p.drawLine(QPointF(8.5, 8.5), QPointF(15.5, 15.5));
  p.drawLine(QPointF(15.5, 8.5), QPointF(8.5, 15.5));
}
void draw_running(QPainter& p) {
  disc(p, blue);
  p.drawPolyline(QPolygonF({{12, 7}, {12, 12.5}, {16, 14.5}}));
}
void draw_pending(QPainter& p) {
  p.setPen(QPen(p.pen().color(), 1.8, Qt::DotLine));
  p.drawEllipse(QPointF(12, 12), 8.5, 8.5);
}
void draw_warning(QPainter& p) {
  fill(p, amber, polygon({{12, 3}, {22.5, 21}, {1.5, 21}}));
  p.setPen(QPen(Qt::black, 2.2, Qt::SolidLine, Qt::RoundCap));
  p.drawLine(QPointF(12, 9.5), QPointF(12, 14.5));
  p.drawPoint(QPointF(12, 18));
}

/// A picture with a triangle on it: the work is looked at, not run.
void draw_play(QPainter& p) {
  p.drawRect(QRectF(3, 4, 18, 16));
  fill(p, blue, polygon({{9, 8}, {16.5, 12}, {9, 16}}));
}
void draw_pause(QPainter& p) {
  p.drawRect(QRectF(3, 4, 18, 16));
  fill(p, blue, polygon({{8, 8}, {10.7, 8}, {10.7, 16}, {8, 16}}));
  fill(p, blue, polygon({{13.3, 8}, {16, 8}, {16, 16}, {13.3, 16}}));
}
void draw_step(QPainter& p) {
  p.drawRect(QRectF(3, 4, 18, 16));
  fill(p, blue, polygon({{7, 8}, {13.5, 12}, {7, 16}}));
  fill(p, blue, polygon({{14.5, 8}, {17, 8}, {17, 16}, {14.5, 16}}));
}

/// A square vertex on a line.
void vertex(QPainter& p, QPointF at) { p.fillRect(QRectF(at.x() - 2.6, at.y() - 2.6, 5.2, 5.2), blue); }
void draw_select(QPainter& p) {
  p.drawPolygon(QPolygonF({{6, 3}, {6, 19}, {10, 15.5}, {13, 21}, {15.5, 19.7}, {12.6, 14.4}, {18, 14}}));
}
void draw_measure(QPainter& p) {
  p.drawPolygon(QPolygonF({{2, 16}, {16, 2}, {22, 8}, {8, 22}}));
  for (const double k : {0.0, 1.0, 2.0, 3.0})
    p.drawLine(QPointF(5.5 + 3.2 * k, 12.5 - 3.2 * k), QPointF(7.8 + 3.2 * k, 14.8 - 3.2 * k));
}
void draw_line(QPainter& p) {
  p.drawPolyline(QPolygonF({{3, 18}, {9, 8}, {15, 15}, {21, 5}}));
  for (const QPointF at : {QPointF(3, 18), QPointF(9, 8), QPointF(15, 15), QPointF(21, 5)}) vertex(p, at);
}
void draw_polygon(QPainter& p) {
  const QPolygonF corners({{12, 3}, {21, 10}, {17, 20}, {6, 20}, {3, 9}});
  p.drawPolygon(corners);
  for (const QPointF at : corners) vertex(p, at);
}
void draw_rectangle(QPainter& p) {
  p.drawRect(QRectF(4, 6, 16, 12));
  vertex(p, {4, 18});
  vertex(p, {20, 6});
}
void draw_circle(QPainter& p) {
  p.drawEllipse(QPointF(12, 12), 9, 9);
  vertex(p, {12, 12});
}
void draw_point(QPainter& p) {
  p.drawLine(QPointF(12, 3), QPointF(12, 21));
  p.drawLine(QPointF(3, 12), QPointF(21, 12));
  vertex(p, {12, 12});
}
void draw_insert_vertex(QPainter& p) {
  p.drawLine(QPointF(2, 20), QPointF(22, 12));
  vertex(p, {12, 16});
  p.drawLine(QPointF(12, 2), QPointF(12, 10));
  p.drawLine(QPointF(8, 6), QPointF(16, 6));
}
void draw_split(QPainter& p) {
  p.drawLine(QPointF(2, 18), QPointF(9, 14));
  p.drawLine(QPointF(15, 10), QPointF(22, 6));
  p.drawLine(QPointF(9, 7), QPointF(15, 17));
}
void draw_join(QPainter& p) {
  p.drawPolyline(QPolygonF({{2, 18}, {12, 12}, {22, 6}}));
  vertex(p, {12, 12});
}
void draw_extend(QPainter& p) {
  p.drawLine(QPointF(20, 3), QPointF(20, 21));
  p.drawLine(QPointF(2, 12), QPointF(9, 12));
  p.setPen(QPen(blue, 2.0, Qt::DotLine));
  p.drawLine(QPointF(9, 12), QPointF(20, 12));
}
void draw_trim(QPainter& p) {
  p.drawLine(QPointF(12, 3), QPointF(12, 21));
  p.drawLine(QPointF(2, 12), QPointF(12, 12));
  p.setPen(QPen(red, 2.0, Qt::DotLine));
  p.drawLine(QPointF(14, 12), QPointF(22, 12));
}
void draw_move(QPainter& p) {
  p.drawLine(QPointF(12, 3), QPointF(12, 21));
  p.drawLine(QPointF(3, 12), QPointF(21, 12));
  p.drawPolyline(QPolygonF({{9, 6}, {12, 3}, {15, 6}}));
  p.drawPolyline(QPolygonF({{9, 18}, {12, 21}, {15, 18}}));
  p.drawPolyline(QPolygonF({{6, 9}, {3, 12}, {6, 15}}));
  p.drawPolyline(QPolygonF({{18, 9}, {21, 12}, {18, 15}}));
}
void draw_rotate(QPainter& p) {
  p.drawArc(QRectF(4, 4, 16, 16), 40 * 16, 280 * 16);
  p.drawPolyline(QPolygonF({{18.5, 2}, {18.4, 7}, {13.5, 7}}));
}
void draw_mirror(QPainter& p) {
  p.drawPolygon(QPolygonF({{9, 6}, {9, 18}, {2, 18}}));
  p.drawPolygon(QPolygonF({{15, 6}, {15, 18}, {22, 18}}));
  p.setPen(QPen(blue, 1.6, Qt::DashLine));
  p.drawLine(QPointF(12, 2), QPointF(12, 22));
}
void draw_copy(QPainter& p) {
  p.drawPolyline(QPolygonF({{3, 14}, {9, 5}, {17, 9}}));
  p.setPen(QPen(blue, 1.8));
  p.drawPolyline(QPolygonF({{7, 20}, {13, 11}, {21, 15}}));
}
void draw_snap(QPainter& p) {
  QPainterPath magnet(QPointF(5, 4));
  magnet.lineTo(5, 12);
  magnet.arcTo(QRectF(5, 5, 14, 14), 180, 180);
  magnet.lineTo(19, 4);
  p.drawPath(magnet);
  p.setPen(QPen(red, 3.2));
  p.drawLine(QPointF(5, 4), QPointF(5, 6));
  p.drawLine(QPointF(19, 4), QPointF(19, 6));
}

/// A folded bed, a flat one, both.
void draw_fold(QPainter& p, double height) {
  QPainterPath fold(QPointF(2, height));
  fold.cubicTo({8, height - 12}, {16, height + 12}, {22, height});
  p.drawPath(fold);
}
void draw_show_input(QPainter& p) {
  p.setPen(QPen(blue, 2.4));
  draw_fold(p, 9);
  p.setPen(QPen(blue, 1.2));
  draw_fold(p, 15);
}
void draw_show_result(QPainter& p) {
  p.setPen(QPen(green, 2.4));
  p.drawLine(QPointF(2, 9), QPointF(22, 9));
  p.setPen(QPen(green, 1.2));
  p.drawLine(QPointF(2, 15), QPointF(22, 15));
}
void draw_show_both(QPainter& p) {
  p.setPen(QPen(blue, 2.4));
  draw_fold(p, 7);
  p.setPen(QPen(green, 2.4));
  p.drawLine(QPointF(2, 18), QPointF(22, 18));
}

void draw_hand(QPainter& p) {
  QPainterPath hand(QPointF(7, 13));
  hand.lineTo(4.5, 10.5);
  hand.lineTo(3, 12);
  hand.lineTo(8, 20);
  hand.lineTo(16, 20);
  hand.lineTo(19, 14);
  hand.lineTo(19, 7.5);
  p.drawPath(hand);
  for (const double x : {7.0, 11.0, 15.0, 19.0}) p.drawLine(QPointF(x, x == 19.0 ? 7 : 4), QPointF(x, 12));
}
void draw_zoom_window(QPainter& p) {
  p.drawEllipse(QPointF(9.5, 9.5), 6.5, 6.5);
  p.drawLine(QPointF(14.5, 14.5), QPointF(21, 21));
  p.setPen(QPen(blue, 1.6));
  p.drawRect(QRectF(6.5, 7.5, 6, 4));
}

Draw drawing_of(Symbol symbol) {
  switch (symbol) {
    case Symbol::Open:
      return draw_open;
    case Symbol::Save:
      return draw_save;
    case Symbol::SavePicture:
      return draw_save_picture;
    case Symbol::Undo:
      return draw_undo;
    case Symbol::Redo:
      return draw_redo;
    case Symbol::Fit:
      return draw_fit;
    case Symbol::Run:
      return draw_run;
    case Symbol::Cancel:
      return draw_cancel;
    case Symbol::Add:
      return draw_add;
    case Symbol::Remove:
      return draw_remove;
    case Symbol::Up:
      return draw_up;
    case Symbol::Down:
      return draw_down;
    case Symbol::Done:
      return draw_done;
    case Symbol::Failed:
      return draw_failed;
    case Symbol::Running:
      return draw_running;
    case Symbol::Pending:
      return draw_pending;
    case Symbol::Warning:
      return draw_warning;
    case Symbol::Play:
      return draw_play;
    case Symbol::Pause:
      return draw_pause;
    case Symbol::Step:
      return draw_step;
    case Symbol::Select:
      return draw_select;
    case Symbol::Measure:
      return draw_measure;
    case Symbol::Line:
      return draw_line;
    case Symbol::Polygon:
      return draw_polygon;
    case Symbol::Rectangle:
      return draw_rectangle;
    case Symbol::Circle:
      return draw_circle;
    case Symbol::Point:
      return draw_point;
    case Symbol::InsertVertex:
      return draw_insert_vertex;
    case Symbol::Split:
      return draw_split;
    case Symbol::Join:
      return draw_join;
    case Symbol::Extend:
      return draw_extend;
    case Symbol::Trim:
      return draw_trim;
    case Symbol::Move:
      return draw_move;
    case Symbol::Rotate:
      return draw_rotate;
    case Symbol::Mirror:
      return draw_mirror;
    case Symbol::Copy:
      return draw_copy;
    case Symbol::Snap:
      return draw_snap;
    case Symbol::ShowInput:
      return draw_show_input;
    case Symbol::ShowResult:
      return draw_show_result;
    case Symbol::ShowBoth:
      return draw_show_both;
    case Symbol::Hand:
      return draw_hand;
    case Symbol::ZoomWindow:
      return draw_zoom_window;
  }
  return draw_pending;
}

class SymbolEngine : public QIconEngine {
 public:
  explicit SymbolEngine(Draw draw) : draw_(draw) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const double side = std::min(rect.width(), rect.height());
    painter->translate(rect.center().x() + 0.5 - side / 2, rect.center().y() + 0.5 - side / 2);
    painter->scale(side / 24.0, side / 24.0);
    if (mode == QIcon::Disabled) painter->setOpacity(0.3);
    const QColor color = QApplication::palette().color(QPalette::WindowText);
    painter->setPen(QPen(color, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    draw_(*painter);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    if (pixmap.isNull()) return pixmap;  // a list that has no room yet asks for an icon of no size
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new SymbolEngine(draw_); }

 private:
  Draw draw_;
};

}  // namespace

QIcon icon(Draw draw) { return QIcon(new SymbolEngine(draw)); }
QIcon icon(Symbol symbol) { return icon(drawing_of(symbol)); }

QIcon swatch(const QBrush& brush, const QColor& line) {
  QPixmap pixmap(28, 28);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(line, 3));
  painter.setBrush(brush);
  painter.drawRoundedRect(QRectF(3, 3, 22, 22), 3, 3);
  return QIcon(pixmap);
}

QIcon letter_swatch(const QColor& color) {
  QPixmap pixmap(28, 28);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(QPolygonF({{6, 24}, {14, 4}, {22, 24}}));
  painter.drawLine(QPointF(9, 17), QPointF(19, 17));
  return QIcon(pixmap);
}

QIcon application_icon() {
  QPixmap pixmap(64, 64);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [color, down] :
       {std::pair(QColor("#b5651d"), 14.0), {QColor("#e0b070"), 30.0}, {QColor("#3b6ea5"), 46.0}}) {
    QPainterPath fold(QPointF(4, down));
    fold.cubicTo(22, down - 26, 40, down + 22, 60, down - 4);
    painter.setPen(QPen(color, 10, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(fold);
  }
  return QIcon(pixmap);
}

}  // namespace dobra::gui::theme
