#pragma once
// Sizes of things in rows and columns, row by row. Internal to scene.

#include <cstddef>
#include <vector>

#include "shared/scene/layout.h"

namespace dobra::scene {

constexpr double panel_gap = 16.0;

/// Something that takes `fixed` points and `growing` world units.
struct Stretch {
  double fixed = 0.0;
  double growing = 0.0;
};

class Grid {
 public:
  Grid(std::size_t count, std::size_t columns) : count_(count), columns_(columns) {}

  [[nodiscard]] std::size_t rows() const { return (count_ + columns_ - 1) / columns_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t row_of(std::size_t i) const { return i / columns_; }
  [[nodiscard]] std::size_t column_of(std::size_t i) const { return i % columns_; }
  /// The greatest of each column, or of each row.  @pre one size a thing.
  [[nodiscard]] std::vector<double> in_columns(const std::vector<double>& sizes) const;
  [[nodiscard]] std::vector<double> in_rows(const std::vector<double>& sizes) const;
  /// The largest scale at which all columns together are not wider than `room`, or all rows not higher.
  [[nodiscard]] double scale_across(double room, const std::vector<Stretch>& widths) const;
  [[nodiscard]] double scale_down(double room, const std::vector<Stretch>& heights) const;

 private:
  std::size_t count_;
  std::size_t columns_;
};

bool have_extents(const std::vector<Panel>& panels);

/// How large panels are drawn in so many columns of a window, by their extents alone: what else is shown there must not
/// move them. Without extents, how square the cells are.
double size_in_window(const std::vector<Panel>& panels, const PageSize& page, std::size_t columns);

/// All sizes and the gaps between them.
double with_gaps(const std::vector<double>& sizes);

}  // namespace dobra::scene
