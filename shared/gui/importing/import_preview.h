#pragma once
// The lines of a file as they would be read, drawn to fit.

#include <QPixmap>
#include <QWidget>
#include <map>
#include <set>

#include "shared/scenario/importing.h"

namespace dobra::gui::importing {

class ImportPreview : public QWidget {
  Q_OBJECT

 public:
  explicit ImportPreview(QWidget* parent = nullptr);

  /// @param look  null: nothing is drawn. Must live until the next call.
  void show_look(const scenario::ImportLook* look, const std::vector<scenario::ImportChoice>& choices);
  /// These lines are drawn strongly.
  void mark(const std::set<std::size_t>& lines);
  /// The colour of a kind on white, the same for every file.
  static QColor color_of(const std::string& kind);

  [[nodiscard]] QSize sizeHint() const override { return {420, 320}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

 signals:
  /// The line nearest to a click.
  void clicked(std::size_t line);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  struct Fit {
    geom::Point low;
    double scale_x = 1.0, scale_y = 1.0;
    QRectF frame;
    [[nodiscard]] QPointF at(geom::Point p) const {
      return {frame.left() + scale_x * (p.x - low.x), frame.bottom() - scale_y * (p.y - low.y)};
    }
  };
  [[nodiscard]] std::optional<Fit> fit() const;
  void draw_lines(QPainter& painter, const Fit& fit) const;
  void draw_frame(QPainter& painter, const Fit& fit) const;

  const scenario::ImportLook* look_ = nullptr;
  std::vector<scenario::ImportChoice> choices_;
  std::set<std::size_t> marked_;
};

}  // namespace dobra::gui::importing
