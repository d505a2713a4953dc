#pragma once
// Parameters of the step `invert`: the kinematics of a fold from the shapes of its beds.
// Page: docs/algorithms/inversion.md

#include <optional>
#include <string>
#include <vector>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace recon {
namespace base = dobra::base;
}

namespace recon::inversion {

enum class InvertMethod { Trishear, Shear };

/// Of a value one number, which fixes it, or the two limits between which it is sought; where nothing is given there
/// are limits made from the section, or the value of the fault named.
struct InvertParams {
  InvertMethod method = InvertMethod::Trishear;
  std::vector<std::string> horizon;
  std::string fault;
  std::vector<double> tip_x, tip_z, ramp, propagation, apical, slip, concentration;
  std::vector<double> angle;
  std::optional<base::Angle> bedding;
  double confidence = 95.0;
  std::vector<std::string> map;
  int map_points = 25;
  std::int64_t seed = 1;
  int generations = 120;
  template <class D>
  static void describe(D& d) {
    d.choice("method", &InvertParams::method, {"trishear", "shear"},
             {.title = "Method",
              .help = "trishear: a fold in front of the tip of a fault; shear: inclined simple shear over a known "
                      "fault."});
    d.field("horizon", &InvertParams::horizon,
            {.title = "Beds",
             .help = "Horizons, pieces and all, that are to become straight; by default all.",
             .names = "horizon"});
    d.field("fault", &InvertParams::fault,
            {.title = "Fault",
             .help = "Of shear: over which it goes; of trishear: whose tip and ramp are taken.",
             .names = "fault"});
    d.field("tip_x", &InvertParams::tip_x,
            {.title = "Tip x",
             .help = "Of trishear: of the tip as it is; one number fixes it, two are limits.",
             .unit = "m",
             .when = "method = trishear"});
    d.field("tip_z", &InvertParams::tip_z,
            {.title = "Tip z",
             .help = "Of trishear: of the tip as it is; one number fixes it, two are limits.",
             .unit = "m",
             .when = "method = trishear"});
    d.field("ramp", &InvertParams::ramp,
            {.title = "Ramp",
             .help = "Of trishear: direction in which the tip goes, anticlockwise from +x; one number or limits.",
             .unit = "deg",
             .at_least = -180.0,
             .at_most = 180.0,
             .when = "method = trishear"});
    d.field("propagation", &InvertParams::propagation,
            {.title = "P/S",
             .help = "Of trishear: how far the tip goes a metre of slip; one number or limits.",
             .at_least = 0.0,
             .when = "method = trishear"});
    d.field("apical", &InvertParams::apical,
            {.title = "Apical angle",
             .help = "Of trishear: the full angle of the triangle; one number or limits.",
             .unit = "deg",
             .above = 0.0,
             .at_most = 179.0,
             .when = "method = trishear"});
    d.field("slip", &InvertParams::slip,
            {.title = "Slip",
             .help = "That made the fold, along the fault; positive raised the hanging wall. One number or limits.",
             .unit = "m"});
    d.field("concentration", &InvertParams::concentration,
            {.title = "Concentration",
             .help = "Of trishear: one number or limits; by default 1.",
             .above = 0.0,
             .when = "method = trishear"});
    d.field("angle", &InvertParams::angle,
            {.title = "Angle",
             .help = "Of shear: its direction from the vertical, positive leaning to +x; one number or limits.",
             .unit = "deg",
             .at_least = -89.0,
             .at_most = 89.0,
             .when = "method = shear"});
    d.field("bedding", &InvertParams::bedding,
            {.title = "Bedding",
             .help = "Direction that restored beds have, anticlockwise from +x; by default each bed has its own.",
             .unit = "deg",
             .at_least = -90.0,
             .at_most = 90.0});
    describe_search(d);
  }

 private:
  template <class D>
  static void describe_search(D& d) {
    d.field("confidence", &InvertParams::confidence,
            {.title = "Confidence", .help = "Of the limits.", .unit = "%", .above = 0.0, .at_most = 99.9});
    d.field("map", &InvertParams::map,
            {.title = "Map of the misfit",
             .help = "Two of the values that are sought, one after the other, such as propagation and apical."});
    d.field("map_points", &InvertParams::map_points,
            {.title = "Points of the map",
             .help = "Along each side.",
             .at_least = 3,
             .at_most = 200,
             .when = "map is set"});
    d.field("seed", &InvertParams::seed, {.title = "Seed", .help = "Of the search.", .at_least = 0});
    d.field("generations", &InvertParams::generations,
            {.title = "Generations", .help = "Of the search, at the most.", .at_least = 1, .at_most = 10000});
  }
};

}  // namespace recon::inversion
