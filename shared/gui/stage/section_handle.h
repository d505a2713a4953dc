#pragma once
// Lies over the view in space and shows what takes hold of the section plane: an arrow along its normal and its rim.
// What it draws leaves the picture as it is. Page: docs/user/space_view.md.

#include <QCursor>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <functional>
#include <optional>

#include "shared/gui/theme/colors.h"
#include "shared/scene/space/section.h"

namespace dobra::gui::stage {

inline constexpr scene::Color section_color{0x15, 0x65, 0xc0};

class SectionHandle : public QWidget {
  Q_OBJECT

 public:
  /// @param sheet  where points of space stand; null as long as nothing can be drawn.
  SectionHandle(QWidget* view, std::function<const scene::space::Sheet*()> sheet);

  /// Nothing: there is no section. @pre the box is not empty where there is one
  void show_section(const std::optional<scene::space::Section>& section, const geom::Box3& box, double exaggeration);
  void set_canvas(theme::Canvas canvas);
  /// The part under the mouse stands out; nothing: the mouse is elsewhere.
  void hover(const std::optional<QPointF>& pixel);
  [[nodiscard]] const std::optional<scene::space::Grip>& hovered() const { return hovered_; }
  /// A closed line. @pre there is a section
  [[nodiscard]] const std::vector<geom::Point3>& rim() const { return handle_.rim; }
  /// What a drag of the part under the mouse does, and the cursor that says so; @pre hovered()
  [[nodiscard]] QString hint() const;
  [[nodiscard]] QCursor cursor_over() const;

  /// Takes hold of what is there. @return whether there is anything.
  bool press(QPointF pixel);
  [[nodiscard]] bool is_held() const { return drag_.has_value(); }
  /// @pre is_held()
  scene::space::Section drag(QPointF pixel);
  /// @return the section where it was taken hold of; nothing: it was not.
  std::optional<scene::space::Section> let_go();

  /// Pixels, for those who look for it: the middle of the arrow, and of each side of the rim. Empty: not in sight.
  [[nodiscard]] std::optional<QPointF> arrow_pixel() const;
  [[nodiscard]] std::vector<QPointF> rim_pixels() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] std::optional<QPointF> pixel_of(geom::Point3 at) const;
  void draw_rim(QPainter& painter, const QColor& color);
  void draw_arrow(QPainter& painter, const QColor& color);

  std::function<const scene::space::Sheet*()> sheet_;
  theme::Canvas canvas_ = theme::Canvas::Paper;
  std::optional<scene::space::Section> section_;
  geom::Box3 box_;
  scene::space::Handle handle_;
  std::optional<scene::space::Grip> hovered_;
  std::optional<scene::space::SectionDrag> drag_;
};

}  // namespace dobra::gui::stage
