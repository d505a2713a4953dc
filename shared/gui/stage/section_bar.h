#pragma once
// Where the picture in space is cut: across which axis, how far along it, and which side is taken away.

#include <QWidget>

#include "shared/geom/box3.h"
#include "shared/scene/space/cut.h"
#include "shared/scene/space/picture.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace dobra::gui::stage {

/// A plane square to an axis, by parts of the box of the picture.
struct Section {
  scene::space::CutAxis axis = scene::space::CutAxis::X;
  double part = 0.5;
  bool other_side = false;
  friend bool operator==(const Section&, const Section&) = default;
};

class SectionBar : public QWidget {
  Q_OBJECT

 public:
  explicit SectionBar(QWidget* parent = nullptr);
  [[nodiscard]] Section section() const;
  /// Says places along the axes of this picture.
  void show_axes(const scene::space::Axes& axes, const geom::Box3& box);

 signals:
  void moved(const dobra::gui::stage::Section& section);

 private:
  void show_place();
  void tell();

  QComboBox* axis_;
  QSlider* place_;
  QLabel* where_;
  QToolButton* side_;
  scene::space::Axes axes_;
  geom::Box3 box_;
};

}  // namespace dobra::gui::stage
