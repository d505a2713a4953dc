#pragma once
// A geological section as values: horizons, faults, unit polygons, markers, pin and loose lines, each with an id that
// stays with it through all steps, a name that is free to change, geometry, and where it came from. x runs along the
// section, z is up, metres.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/section/convention.h"
#include "shared/base/error.h"
#include "shared/base/id.h"
#include "shared/geom/polyline.h"
#include "shared/scene/unit_colors.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::section {

struct HorizonTag {
  static constexpr const char* prefix = "horizon";
};
/// Stays with a horizon through all steps; names are free to change.
using HorizonId = base::Id<HorizonTag>;

/// What verdicts make of a bed or a unit.
enum class BedRole {
  Judged,
  Growth,   ///< Laid down while the section deformed, so that its length is not to agree with that of older beds.
  Outside,  ///< Of units only: nothing but a line that the program drew between ends of beds bounds it on one side.
};

/// The trace of a bed surface, ordered from its left end to its right end.
struct Horizon {
  HorizonId id;
  std::string name;
  geom::Polyline line;  ///< Open, n >= 2 distinct points, m, free of self-crossings.
  base::Place source;   ///< The file, or the place in the scenario, that it came from.
  /// The horizon that faults or the topography have cut it from, as one of several pieces; empty where it is whole.
  std::string piece_of = {};
  BedRole role = BedRole::Judged;  ///< What verdicts make of it.
};

/// What a horizon and its pieces are called together.
const std::string& whole_name(const Horizon& horizon);

enum class LineEnd { First, Last };

/// On which side of the line that a grid stands on the layers lie.
enum class LayerSide { Auto, Below, Above };

struct LineTag {
  static constexpr const char* prefix = "line";
};
struct UnitTag {
  static constexpr const char* prefix = "unit";
};
struct MarkerTag {
  static constexpr const char* prefix = "marker";
};
using LineId = base::Id<LineTag>;
using UnitId = base::Id<UnitTag>;
using MarkerId = base::Id<MarkerTag>;

/// Topography: the surface of today; Datum: what the section may be restored to; Eroded: the part of a horizon that lay
/// above the topography.
enum class LineKind { Fault, Pin, Loose, Topography, Datum, Eroded };

/// On which side of a fault its hanging wall lies. Auto: the side above it.
enum class HangingWall { Auto, Left, Right, Above, Below };
/// "auto", "left", "right", "above", "below".
const char* hanging_wall_name(HangingWall side);

/// A line that is no bed: it is carried with the section, but not part of the balance.
struct SectionLine {
  LineId id;
  LineKind kind = LineKind::Fault;
  std::string name;
  geom::Polyline line;  ///< Open, in the order in which it was given.
  base::Place source;
  /// Of faults: the fault that younger ones have cut this one from, as one of several pieces; empty where it is whole.
  std::string piece_of = {};
  int order = 0;  ///< Of faults: 1 is the youngest; 0: not said.
  HangingWall hanging_wall = HangingWall::Auto;
};

/// What a fault and its pieces are called together.
const std::string& whole_name(const SectionLine& line);

/// The area of a rock unit.
struct Unit {
  UnitId id;
  std::string name;
  geom::Polyline contour;  ///< Closed, simple, anticlockwise.
  base::Place source;
  std::string piece_of = {};  ///< The unit that it is one of several pieces of; empty where it is whole.
};

/// Points that belong together: picks of a well, a fossil, a growth line.
struct Marker {
  MarkerId id;
  std::string name;
  std::vector<geom::Point> points;
  base::Place source;
};

/// A picture behind the section: a scan, a seismic line.
struct Backdrop {
  std::string name;
  dobra::scene::Image image;
  base::Place source;
};

/// What the block in which a point lies is called. Page: docs/user/faults.md
struct BlockName {
  std::string name;
  geom::Point at;
  std::string part_of = {};  ///< The group that the block moves with; empty: none.
};

struct SectionFaces;

struct Section {
  std::vector<Horizon> horizons;
  std::vector<SectionLine> lines;
  std::vector<Unit> units;
  std::vector<Marker> markers;
  std::vector<Backdrop> backdrops;
  std::vector<BlockName> block_names;
  std::optional<geom::Polyline> border;  ///< What belongs to the section: closed, anticlockwise.
  /// Units, meetings of horizons and misfits of polygons, made when the section was read (section_faces.h).
  std::shared_ptr<const SectionFaces> faces;
  Convention convention;  ///< Of the files it was read from; further files of the scenario follow it.
  std::shared_ptr<const dobra::scene::ColorTable> colors;  ///< As the user gave them, or null.
  std::string left_end;                                    ///< Compass point over the left end; empty: not known.
  std::string right_end;
};

/// Whether no other piece of the same horizon reaches farther to the left (First) or to the right (Last).
bool is_outermost(const Section& section, const Horizon& horizon, LineEnd end);

/// The first horizon, or piece of one, that is called so together with its pieces; null if there is none.
const Horizon* first_piece(const Section& section, const std::string& whole);
/// @return the horizon of that name, or nullptr.
const Horizon* find_horizon(const Section& section, const std::string& name);
/// @return the horizon of that id, or nullptr.
const Horizon* find_horizon(const Section& section, HorizonId id);
/// Names in the order of the section.
std::vector<std::string> horizon_names(const Section& section);

/// "fault", "pin", "loose", "topography", "datum", "eroded".
const char* kind_name(LineKind kind);

/// Box round everything in the section but backdrops.
geom::Box box_of(const Section& section);

}  // namespace recon::section
