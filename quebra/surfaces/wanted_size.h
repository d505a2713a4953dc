#pragma once
// The size wanted on surfaces by a formula of x, y, z and, where one face is meshed, of u and v. Where it gives no
// positive finite number on a face the first place is remembered. Page: docs/user/surfaces.md.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "shared/base/result.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

class WantedSize {
 public:
  /// @param units  of the chart, where u and v may be asked for.
  /// @error BadValue: a formula that cannot be read
  static dobra::base::Result<WantedSize> make(const std::string& text, const std::optional<dobra::geom::Vector>& units);

  /// What meshers ask, m. @pre this lives as long
  [[nodiscard]] std::function<double(dobra::geom::Point, dobra::geom::Point3)> function() const;
  /// Of the face that is meshed next; places outside it do not count.
  void enter(const dobra::surf::trim::TrimmedSurface& face);
  /// @error BadValue with the place: no size at one of 64 places of each edge.
  [[nodiscard]] dobra::base::Result<void> on_border(const dobra::surf::trim::TrimmedSurface& face) const;
  /// @error BadValue with the first place inside a face that was asked for and has no size.
  [[nodiscard]] dobra::base::Result<void> inside() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace quebra::surfaces
