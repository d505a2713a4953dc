#pragma once
// Trishear from the shapes of beds. Page: docs/algorithms/inversion.md. Source: [allmendinger1998], [cardozo2009].

#include "recon/inversion/fit.h"
#include "recon/inversion/invert_params.h"

namespace recon::inversion {

/// The values in the order of the unknowns.
enum TrishearValue : std::size_t { TipX, TipZ, Ramp, Propagation, Apical, Slip, Concentration, trishear_values };

/// tip_x, tip_z [m] of the tip as it is, ramp [deg], propagation, apical [deg], slip [m], concentration. The hanging
/// wall is the side above the ramp.
Model trishear_model(double size);

/// Their limits: as given, those of the fault named, or made from the box of the beds.
/// @return one list, or two of which the better is to be taken: a ramp that nothing is known of climbs to +x or -x.
/// @param remarks  gets one where the end of a fault that leaves the section is taken for its tip, as `move` does.
/// @error BadValue, BadSection: those of find_fault().
base::Result<std::vector<std::vector<Unknown>>> trishear_unknowns(const section::Section& section,
                                                                  const std::vector<BedShape>& beds,
                                                                  const InvertParams& params,
                                                                  std::vector<std::string>& remarks);

/// The last of the ramp up to its tip, and the sides of the triangle in front of it.
geom::Polyline ramp_line(std::span<const double> values, double length);
std::vector<geom::Polyline> triangle_sides(std::span<const double> values, double length);

}  // namespace recon::inversion
