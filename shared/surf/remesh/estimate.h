#pragma once
// How many triangles sizes mean, before any is made. Internal to remesh.h. Page: docs/algorithms/remesh.md.

#include <vector>

#include "shared/surf/param/sheet.h"

namespace dobra::surf::remesh {

/// Area and lines of sheets that are to be meshed with one size. Nothing overflows, whatever the unit is.
class Demand {
 public:
  /// @param crease  degrees: sides at which the sheet folds by more are lines, as borders are
  void add(const param::Sheet& sheet, double crease);
  /// Of sides so long: equilateral ones that fill the area, and one at each side of a line. @pre size > 0
  [[nodiscard]] double triangles(double size) const;
  /// The size that means so many, rounded up to two digits.
  [[nodiscard]] double size_for(double triangles) const;

 private:
  double unit_ = 0.0;    ///< The longest side so far, m.
  double area_ = 0.0;    ///< In units squared.
  double length_ = 0.0;  ///< Of lines, in units, those inside from both sides.
};

/// Triangles that fill the sheet with these sizes. @param sizes  one a point, m
double expected_triangles(const param::Sheet& sheet, const std::vector<double>& sizes);

/// Not less, with two digits.
double rounded_up(double value);
/// Not more, with two digits.
double rounded_down(double value);

}  // namespace dobra::surf::remesh
