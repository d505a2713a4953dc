#pragma once
// A geological section as values: horizons now; faults, unit polygons, markers, pin and loose lines join as further
// lists of the same kind (an id, a name, geometry, where it came from). x runs along the section, z is up, metres.

#include <string>
#include <vector>

#include "shared/base/error.h"
#include "shared/base/id.h"
#include "shared/geom/polyline.h"

namespace recon::core {

namespace base = dobra::base;
namespace geom = dobra::geom;

struct HorizonTag {
  static constexpr const char* prefix = "horizon";
};
/// Stays with a horizon through all steps; names are free to change.
using HorizonId = base::Id<HorizonTag>;

/// The trace of a bed surface, ordered from its left end to its right end.
struct Horizon {
  HorizonId id;
  std::string name;
  geom::Polyline line;  ///< Open, n >= 2 distinct points, m, free of self-crossings.
  base::Place source;   ///< The file, or the place in the scenario, that it came from.
};

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

struct Section {
  std::vector<Horizon> horizons;
  Convention convention;  ///< Of the files it was read from; further files of the scenario follow it.
};

/// @return the horizon of that name, or nullptr.
const Horizon* find_horizon(const Section& section, const std::string& name);
/// @return the horizon of that id, or nullptr.
const Horizon* find_horizon(const Section& section, HorizonId id);
/// Names in the order of the section.
std::vector<std::string> horizon_names(const Section& section);

/// A place to zoom to.
base::Place place_at(geom::Point p, std::string item = {});

/// Box round all horizons.
geom::Box box_of(const Section& section);

double metres_per_unit(LengthUnit unit);
/// A point of a file in section coordinates, m.
geom::Point to_section(geom::Point in_file, const Convention& convention);

}  // namespace recon::core
