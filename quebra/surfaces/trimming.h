#pragma once
// What trims leave of one surface: loops in its chart, lines and points inside. Page: docs/user/surfaces.md.

#include <optional>
#include <string>
#include <vector>

#include "quebra/model/surface_meshed.h"
#include "quebra/surfaces/crack_lines.h"
#include "quebra/surfaces/trim_params.h"
#include "quebra/surfaces/trim_rings.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/recognise.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

class Trimming {
 public:
  Trimming(dobra::surf::Surface surface, std::string name, ChartUnits units);

  /// @param tool  the other surface of a trim of kind surface.
  /// @error BadValue: what its kind needs is missing; BadDomain with the place: it leaves the chart, does not close
  /// where
  ///        it must, or does not meet the surface.
  dobra::base::Result<void> add(const TrimParams& trim, const std::optional<dobra::surf::Surface>& tool);
  /// @error BadValue: no place, or two.
  dobra::base::Result<void> add(const PartParams& part);
  dobra::base::Result<void> add(const SurfacePointParams& point);

  /// The face that is left; its loops have the outside on the right. Sides of the chart are the sets NAME_left,
  /// NAME_right (ends of u), NAME_bottom and NAME_top (ends of v).
  /// @error BadDomain with the place: lines that cross, parts that are not there, nothing left.
  /// @param numbers  of edges that are one curve, kept from surface to surface.
  /// @param parts    the parts from which it is made.
  dobra::base::Result<dobra::surf::trim::TrimmedSurface> face(dobra::surf::trim::SharedNumbers& numbers,
                                                              std::vector<dobra::surf::mesh::Finding>& findings,
                                                              model::SurfaceParts& parts) const;
  /// The trims that were added, as lines that divide nothing.
  [[nodiscard]] std::vector<dobra::surf::trim::ChartLine> drawn_lines() const;
  /// Where the parts that were added lie, and whether they stay.
  [[nodiscard]] std::vector<model::ChosenPart> chosen(std::size_t face) const;

 private:
  dobra::base::Result<void> add_cut(const TrimParams& trim, const std::optional<dobra::surf::Surface>& tool);
  dobra::base::Result<void> chain(const TrimParams& trim, std::vector<dobra::surf::trim::ChartEdge> edges);
  /// A curve of a trim, or several that follow each other.
  struct Drawn {
    TrimRole role;
    std::string name;
    bool closed = false;
    std::vector<dobra::surf::trim::ChartEdge> edges;
    CrackLineOptions round = {};  ///< What goes with a crack.
  };
  struct Picked {
    PartFate fate;
    std::string name;
    dobra::geom::Point at;
  };
  /// Whole periods of the closed directions, none first.
  [[nodiscard]] std::vector<dobra::geom::Vector> periods() const;
  /// Which faces lie inside a ring. @param inner  a place in each face
  [[nodiscard]] dobra::base::Result<std::vector<std::uint8_t>> inside_of(
      const TrimRing& ring, const dobra::surf::trim::Recognised& recognised,
      const std::vector<dobra::geom::Point>& inner) const;
  [[nodiscard]] dobra::base::Error as_written(dobra::base::Error error) const;
  /// Fills in which parts are meant.
  [[nodiscard]] dobra::base::Result<void> keep(const dobra::surf::trim::Recognised& recognised,
                                               model::SurfaceParts& parts) const;
  /// Bands and rosettes of the cracks, as internal lines; sizes at their ends.
  dobra::base::Result<void> add_crack_lines(std::vector<Drawn>& lines, std::vector<dobra::surf::trim::ChartPoint>& tips,
                                            std::vector<dobra::surf::mesh::Finding>& findings) const;
  void add_regions(dobra::surf::trim::TrimmedSurface& face) const;
  [[nodiscard]] dobra::base::Result<dobra::geom::Point> place_of(const std::optional<dobra::geom::Point>& at,
                                                                 const std::optional<dobra::geom::Point3>& place) const;
  [[nodiscard]] dobra::base::Error refused(const std::string& message, dobra::geom::Point uv) const;

  dobra::surf::Surface surface_;
  std::string name_;
  ChartUnits units_;
  std::vector<Drawn> drawn_;
  std::vector<TrimRing> rings_;  ///< Of holes and outlines.
  std::vector<Picked> parts_;
  std::vector<dobra::surf::trim::ChartPoint> points_;
};

}  // namespace quebra::surfaces
