#pragma once
// Where the picture in space is cut, in numbers: across which axis, how far along it, and which side is taken away. It
// follows the handle in the picture (section_handle.h).

#include <QWidget>

#include "shared/scene/space/section.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace dobra::gui::stage {

class SectionBar : public QWidget {
  Q_OBJECT

 public:
  explicit SectionBar(QWidget* parent = nullptr);
  [[nodiscard]] const scene::space::Section& section() const { return section_; }
  /// Says places along the axes of this picture.
  void show_axes(const scene::space::Axes& axes, const geom::Box3& box);
  /// What it is from elsewhere; tells nobody.
  void show_section(const scene::space::Section& section);

 signals:
  void moved(const dobra::scene::space::Section& section);
  /// What was typed is no place of the plane; why.
  void refused(const QString& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_all();
  void show_place();
  void take_axis(int row);
  void take_place();
  void tell(const scene::space::Section& section);
  [[nodiscard]] QString number(double place) const;

  QComboBox* axis_;
  QSlider* slider_;
  QLineEdit* place_;
  QLabel* unit_;
  QToolButton* side_;
  scene::space::Section section_;
  scene::space::Axes axes_;
  geom::Box3 box_{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
};

}  // namespace dobra::gui::stage
