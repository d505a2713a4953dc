#include "shared/solid/shape/contours.h"

#include <fmt/format.h>

#include <cmath>

namespace dobra::solid::shape {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

Result<void> check_contour(const geom::Polyline& line, const char* what) {
  const std::size_t n = line.points.size();
  const auto refuse = [&](ErrorCode code, const std::string& why) {
    return Error{code, fmt::format("the {} {}", what, why)};
  };
  if (n < 3) return refuse(ErrorCode::DegenerateCurve, fmt::format("has {} points and needs three or more", n));
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = line.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      return refuse(ErrorCode::NotFinite, fmt::format("has no finite number at point {}", i + 1));
    if (p == line.points[(i + 1) % n]) {
      return refuse(ErrorCode::DegenerateCurve,
                    fmt::format("has point {} at the place of the one before it; leave it out (the last point of a "
                                "contour is joined to its first by itself)",
                                (i + 1) % n + 1));
    }
  }
  if (geom::signed_area({line.points, true}) == 0.0)
    return refuse(ErrorCode::DegenerateCurve, "has no area: give corners that surround one");
  return {};
}

/// Anticlockwise, or clockwise for a hole.
Contour turned_contour(const geom::Polyline& line, bool hole, SideNames names, const std::string& stem) {
  Contour contour{line.points, {}};
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i)
    contour.names.push_back(names == SideNames::Each && !hole ? fmt::format("{}_{}", stem, i + 1) : stem);
  if ((geom::signed_area({line.points, true}) > 0.0) == hole) {
    std::reverse(contour.points.begin(), contour.points.end());
    // The side that leaves a corner is now the one that came to it.
    std::reverse(contour.names.begin(), contour.names.end());
    std::rotate(contour.names.begin(), contour.names.begin() + 1, contour.names.end());
  }
  return contour;
}

Result<std::vector<Contour>> contours_of(const Profile& profile, SideNames names) {
  DOBRA_TRY_VOID(check_contour(profile.outline, "outline of the profile"));
  std::vector<Contour> contours{turned_contour(profile.outline, false, names, "side")};
  for (std::size_t i = 0; i < profile.holes.size(); ++i) {
    DOBRA_TRY_VOID(check_contour(profile.holes[i], "hole of the profile"));
    contours.push_back(turned_contour(profile.holes[i], true, names,
                                      names == SideNames::Each ? fmt::format("hole_{}", i + 1) : "hole"));
  }
  return contours;
}

}  // namespace dobra::solid::shape
