#pragma once
// How the coordinates of the user's files are meant.

#include "shared/geom/point.h"

namespace recon {
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::section {

enum class VerticalAxis { Up, Down };
enum class LengthUnit { Metre, Kilometre, Foot };

/// How coordinates of the user's files become section coordinates: z = y, or reference - y where y grows downwards;
/// times the unit, z divided by the exaggeration.
struct Convention {
  VerticalAxis y_axis = VerticalAxis::Up;
  double reference = 0.0;  ///< In the unit of the file.
  LengthUnit unit = LengthUnit::Metre;
  double exaggeration = 1.0;  ///< Of z in the files.
};

double metres_per_unit(LengthUnit unit);
/// A point of a file in section coordinates, m.
geom::Point to_section(geom::Point in_file, const Convention& convention);
/// The other way.
geom::Point from_section(geom::Point in_section, const Convention& convention);

}  // namespace recon::section
