#pragma once
// The parameters of the steps that move, turn and join plane profiles.

#include <optional>
#include <vector>

#include "quebra/solids/part_params.h"

namespace quebra::solids {

struct HoleParams {
  std::vector<dobra::geom::Point> points;
  template <class D>
  static void describe(D& d) {
    d.field("points", &HoleParams::points,
            {.title = "Points",
             .help = "Corners of a closed contour.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
  }
};

/// A base of what moves a profile.
struct OfProfile : PlacedPart {
  std::vector<dobra::geom::Point> points;
  std::vector<HoleParams> holes;
  template <class P, class D>
  static void describe_profile(D& d) {
    describe_placed<P>(d);
    d.field("points", static_cast<std::vector<dobra::geom::Point> P::*>(&OfProfile::points),
            {.title = "Points",
             .help = "Corners of a closed contour.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.tables("hole", static_cast<std::vector<HoleParams> P::*>(&OfProfile::holes),
             {.title = "Holes", .help = "Of the profile."});
  }
};

struct ExtrudeParams : OfProfile {
  dobra::geom::Point3 by{0.0, 0.0, 1.0};
  template <class D>
  static void describe(D& d) {
    describe_profile<ExtrudeParams>(d);
    d.field("by", &ExtrudeParams::by,
            {.title = "By (x, y, z)", .help = "How far the profile, which lies in z = 0, is moved.", .unit = "m"});
  }
};

struct SweepParams : OfProfile {
  std::vector<dobra::geom::Point3> path;
  template <class D>
  static void describe(D& d) {
    describe_profile<SweepParams>(d);
    d.field("path", &SweepParams::path,
            {.title = "Path",
             .help = "Points in space that the profile's origin moves along; corners are mitred.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
  }
};

struct RevolveParams : PlacedPart {
  std::vector<dobra::geom::Point> points;
  double angle = 360.0;
  int segments = 64;
  template <class D>
  static void describe(D& d) {
    describe_placed<RevolveParams>(d);
    d.field("points", &RevolveParams::points,
            {.title = "Points",
             .help = "Corners of a closed contour of (radius, z); sides on the axis make no faces.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field(
        "angle", &RevolveParams::angle,
        {.title = "Angle", .help = "In degrees about the z axis, anticlockwise from x.", .above = 0, .at_most = 360});
    d.field("segments", &RevolveParams::segments,
            {.title = "Segments", .help = "Over the whole angle.", .at_least = 1, .at_most = 10000});
  }
};

struct LoftProfileParams {
  std::vector<dobra::geom::Point> points;
  dobra::geom::Point3 at{};
  std::optional<dobra::geom::Point3> axis;
  template <class D>
  static void describe(D& d) {
    d.field("points", &LoftProfileParams::points,
            {.title = "Points",
             .help = "Corners of a closed contour; the first is joined to the first of the next profile.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field("at", &LoftProfileParams::at, {.title = "At (x, y, z)", .help = "Where its origin is put.", .unit = "m"});
    d.field("axis", &LoftProfileParams::axis,
            {.title = "Axis", .help = "Direction in which its plane looks; z where left out."});
  }
};

struct LoftParams : PlacedPart {
  std::vector<LoftProfileParams> profiles;
  template <class D>
  static void describe(D& d) {
    describe_placed<LoftParams>(d);
    d.tables("profile", &LoftParams::profiles,
             {.title = "Profiles", .help = "Two or more, each in front of the one before."});
  }
};

}  // namespace quebra::solids
