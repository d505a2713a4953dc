#include "shared/gui/stage/section_handle.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>
#include <utility>

#include "shared/gui/words/words.h"
#include "shared/scene/ground.h"

namespace dobra::gui::stage {

namespace {

namespace space = scene::space;

constexpr double taken_within = 7.0;    ///< Pixels.
constexpr double head_length = 14.0;    ///< Of the arrow;
constexpr double head_half = 6.0;       ///< half of its width.
constexpr double seen_from_end = 12.0;  ///< A shorter arrow is a ring.

geom::Point page_point(QPointF pixel) { return {pixel.x(), pixel.y()}; }

}  // namespace

SectionHandle::SectionHandle(QWidget* view, std::function<const space::Sheet*()> sheet)
    : QWidget(view), sheet_(std::move(sheet)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void SectionHandle::show_section(const std::optional<space::Section>& section, const geom::Box3& box,
                                 double exaggeration) {
  section_ = section;
  setVisible(section.has_value());
  if (!section) {
    hovered_.reset();
    drag_.reset();
    return;
  }
  box_ = box;
  handle_ = space::handle_of(*section, box, exaggeration);
  update();
}

void SectionHandle::set_canvas(theme::Canvas canvas) {
  canvas_ = canvas;
  update();
}

void SectionHandle::hover(const std::optional<QPointF>& pixel) {
  const space::Sheet* sheet = sheet_();
  std::optional<space::Grip> found;
  if (section_ && pixel && sheet != nullptr) found = space::grip_at(handle_, *sheet, page_point(*pixel), taken_within);
  if (std::exchange(hovered_, found) != found) update();
}

QString SectionHandle::hint() const {
  return hovered_ == space::Grip::Arrow ? text("Drag the arrow: the section plane moves along its normal")
                                        : text("Drag the rim: the section plane turns about its middle");
}

QCursor SectionHandle::cursor_over() const {
  if (hovered_ == space::Grip::Rim) return Qt::OpenHandCursor;
  const auto from = pixel_of(handle_.middle), to = pixel_of(handle_.tip);
  if (!from || !to || std::hypot(to->x() - from->x(), to->y() - from->y()) < seen_from_end) return Qt::SizeVerCursor;
  const double turn = std::atan2(from->y() - to->y(), to->x() - from->x()) * 4.0 / std::numbers::pi;  // eighths
  constexpr Qt::CursorShape shapes[] = {Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor, Qt::SizeFDiagCursor};
  return shapes[(static_cast<int>(std::lround(turn)) + 8) % 4];
}

bool SectionHandle::press(QPointF pixel) {
  hover(pixel);
  if (!hovered_) return false;
  drag_.emplace(*section_, box_, handle_, *hovered_, *sheet_(), page_point(pixel));
  return true;
}

space::Section SectionHandle::drag(QPointF pixel) {
  const space::Sheet* sheet = sheet_();
  return sheet != nullptr ? drag_->to(*sheet, page_point(pixel)) : drag_->begin();
}

std::optional<space::Section> SectionHandle::let_go() {
  std::optional<space::Section> began;
  if (drag_) began = drag_->begin();
  drag_.reset();
  return began;
}

std::optional<QPointF> SectionHandle::pixel_of(geom::Point3 at) const {
  const space::Sheet* sheet = sheet_();
  const auto seen = sheet != nullptr ? space::project(*sheet, at) : std::nullopt;
  return seen ? std::optional(QPointF(seen->at.x, seen->at.y)) : std::nullopt;
}

std::optional<QPointF> SectionHandle::arrow_pixel() const {
  return section_ ? pixel_of(geom::midpoint(handle_.middle, handle_.tip)) : std::nullopt;
}

std::vector<QPointF> SectionHandle::rim_pixels() const {
  std::vector<QPointF> pixels;
  for (std::size_t i = 0; section_ && i + 1 < handle_.rim.size(); ++i) {
    if (const auto at = pixel_of(geom::midpoint(handle_.rim[i], handle_.rim[i + 1]))) pixels.push_back(*at);
  }
  return pixels;
}

void SectionHandle::paintEvent(QPaintEvent*) {
  const space::Sheet* sheet = sheet_();
  if (!section_ || sheet == nullptr) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(QRectF(sheet->plot.low.x, sheet->plot.low.y, sheet->plot.width(), sheet->plot.height()));
  const scene::Color line = scene::line_on(section_color, theme::canvas_colors(canvas_).ground);
  const QColor color(line.red, line.green, line.blue);
  draw_rim(painter, color);
  draw_arrow(painter, color);
}

/// What the surfaces hide of the frame is seen faintly.
void SectionHandle::draw_rim(QPainter& painter, const QColor& color) {
  QPolygonF pixels;
  for (const geom::Point3& p : handle_.rim) {
    const auto at = pixel_of(p);
    if (!at) return;
    pixels.append(*at);
  }
  const bool stands_out = hovered_ == space::Grip::Rim;
  QColor faint = color;
  faint.setAlpha(stands_out ? 255 : 110);
  painter.setPen(QPen(faint, stands_out ? 3.0 : 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(pixels);
}

void SectionHandle::draw_arrow(QPainter& painter, const QColor& color) {
  const auto from = pixel_of(handle_.middle), to = pixel_of(handle_.tip);
  if (!from || !to) return;
  const QPointF way = *to - *from;
  const double length = std::hypot(way.x(), way.y());
  const double width = hovered_ == space::Grip::Arrow ? 4.0 : 2.4;
  const QColor halo = theme::canvas_colors(canvas_).behind_words;
  QPainterPath shape;
  if (length < seen_from_end) {
    shape.addEllipse(*from, 8.0, 8.0);
    shape.addEllipse(*from, 2.0, 2.0);
    for (const QPen& pen : {QPen(halo, width + 4.0), QPen(color, width)}) painter.strokePath(shape, pen);
    return;
  }
  const QPointF unit = way / length;
  const QPointF across(-unit.y(), unit.x());
  const QPointF neck = *to - head_length * unit;
  QPainterPath head;
  head.addPolygon(QPolygonF({*to, neck + head_half * across, neck - head_half * across, *to}));
  shape.moveTo(*from);
  shape.lineTo(length > head_length ? neck : *from);
  for (const auto& [ink, more] : {std::pair(halo, 3.0), std::pair(color, 0.0)}) {
    const QPen pen(ink, width + more, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.strokePath(shape, pen);
    if (more > 0.0) painter.strokePath(head, QPen(ink, more + 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(head, ink);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawEllipse(*from, 3.0 + 0.5 * more, 3.0 + 0.5 * more);
  }
}

}  // namespace dobra::gui::stage
