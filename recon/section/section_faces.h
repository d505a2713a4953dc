#pragma once
// The section as one planar subdivision: horizons, faults and the section's border cut it into faces, faces under the
// same horizon are a rock unit, and neighbours share their edges, so that the areas of the units add up to that of the
// section. Page: docs/algorithms/units.md

#include <optional>
#include <string>
#include <vector>

#include "recon/section/arrangement.h"
#include "recon/section/section.h"

namespace recon::section {

/// Two horizons that meet, the first before the second in the section.
struct HorizonMeeting {
  HorizonId first;
  HorizonId second;
  LineMeeting meeting;  ///< Of the first with the second.
};

/// The faces under one horizon: named by it and by the horizon that bounds it below, if there is one.
struct RockUnit {
  std::string name;                      ///< "A - B"; "A" at the bottom; "above A" at the top of the section.
  std::optional<std::size_t> top;        ///< Index of the horizon: of several over a face the deepest.
  std::optional<std::size_t> base;       ///< Of several under a face the highest.
  std::size_t faces = 0;                 ///< Faults and horizons that end cut a unit into several.
  std::vector<geom::Polyline> contours;  ///< Of its faces: anticlockwise, holes clockwise.
  double area = 0.0;                     ///< m2
  /// Its faces are all that lies between the two, contour_between, cut by faults at most.
  bool whole = false;
};

/// What the polygons of the section leave out or have twice.
struct Misfit {
  std::string what;  ///< "gap" or "overlap".
  std::string between;
  double area = 0.0;  ///< m2
  geom::Point place;
  double open_over = 0.0;  ///< How wide a gap is that is open at the side of the drawing, m; 0: it is closed.
  bool upright = false;    ///< It is open above or below instead, and that is how high it is.
};
/// "gap of 3 m2 between the units A, B", and how wide an open one is.
std::string words_of(const Misfit& misfit);

/// A horizon under which the section's made border is open, though another one lies below it.
struct OpenPlace {
  HorizonId under;
  geom::Point place;
};

/// Part of a horizon over which lies nothing of the section.
struct BareStretch {
  HorizonId horizon;
  geom::Polyline line;
};

struct SectionFaces {
  std::vector<HorizonMeeting> meetings;
  std::vector<RockUnit> units;  ///< From the top down.
  double area = 0.0;            ///< Within the border, m2, found without the faces.
  std::vector<Misfit> misfits;
  std::vector<OpenPlace> open;
  std::vector<geom::Segment> sides;  ///< Straight lines that the border was made of.
  std::vector<BareStretch> bare;
};

/// The subdivision that units are read off.
struct UnitFaces {
  Arrangement arrangement;
  std::vector<std::string> lines;                ///< What each line of it is: "horizon A", "fault F", "border".
  std::vector<std::vector<topo::FaceId>> faces;  ///< Of each of SectionFaces::units.
  SectionFaces found;
};

/// The border is the section's own, or made of its first and last horizon and straight lines between the ends of
/// neighbours (with a topography: from there on); what lies above a topography is air.
/// @pre   no horizon meets itself.
/// @error those of topo::insert and Arrangement::holders.
/// @cost  O(n log n) for n points.
base::Result<SectionFaces> faces_of(const Section& section);
/// The same with the subdivision; straight lines that the border was made of are called "side".
base::Result<UnitFaces> unit_faces_of(const Section& section);

/// Indices of the horizons from the top down: of two that do not cross, the one that has the other on its right-hand
/// side.
std::vector<std::size_t> stack_order(const Section& section);

/// The units as errors name them: "unit 'Q'".
std::vector<std::string> unit_labels(const Section& section);

/// One line each: horizons that meet, and where the border is open.
std::vector<std::string> remarks_of(const SectionFaces& faces, const Section& section);

struct MisfitRemark {
  std::string text;
  geom::Point place;  ///< Of the greatest.
};
/// One line for what polygons leave out, and one for what they have twice.
std::vector<MisfitRemark> misfit_remarks(const SectionFaces& faces);

}  // namespace recon::section
