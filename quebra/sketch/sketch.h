#pragma once
// What a user draws or a file holds, before a domain is made of it: curves with their roles, the names of materials,
// and points.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "quebra/sketch/curve.h"
#include "shared/base/error.h"

namespace quebra::sketch {

/// A node wanted inside or on a curve: a support, a load, a gauge.
struct NamedPoint {
  std::string name;  ///< Of the set that its node belongs to; empty: a size only.
  dobra::geom::Point at;
  double size = 0.0;  ///< Of the elements there, m; 0: no wish.
};

/// A name for the part of the material that a point lies in.
struct RegionName {
  std::string name;  ///< Parts of one name are one region.
  dobra::geom::Point at;
};

/// A polygon of the user's file: the material inside it takes its name.
struct Area {
  std::string name;                ///< Of the region; empty: none.
  std::vector<std::string> rings;  ///< Names of the curves of its contour and its holes.
  std::vector<dobra::geom::Polyline>
      outline;  ///< The same as they were read: inside is what an odd number of them holds.
};

/// Loops of these curves inside others are holes only where a point says so (.poly); else they divide material from
/// material.
struct HolePoints {
  std::set<std::string> curves;  ///< By name.
  std::vector<dobra::geom::Point> at;
  dobra::base::Place place;  ///< The file.
};

/// What a domain is made of.
struct Sketch {
  std::vector<Curve> curves;
  std::vector<dobra::base::Place> places;  ///< One a curve: where it stands in the user's file.
  std::vector<RegionName> regions;
  std::vector<NamedPoint> points;
  std::vector<std::string> remarks;
  /// Curves, by name, whose file tells no roles: they are found once ends are joined.
  std::set<std::string> without_role = {};
  std::optional<HolePoints> hole_points = std::nullopt;
  /// Lines, by name, that two areas share (areas.h): between two holes they divide nothing.
  std::set<std::string> interfaces = {};
  std::vector<Area> areas = {};  ///< A region named by `regions` keeps that name.
};

}  // namespace quebra::sketch
