#pragma once
// Borders and creases of an opened sheet, divided into sides of the new mesh. Internal to remesh.h.

#include <vector>

#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/remesh/atlas.h"

namespace dobra::surf::remesh {

struct Network {
  /// Points and edges of a chart, with the place in space and the number of the node of each point.
  struct Part {
    dobra::mesh::delaunay::MeshInput chart;
    std::vector<geom::Point3> at;
    std::vector<std::uint32_t> node;
  };
  std::vector<Part> parts;  ///< As those of the atlas.
  std::uint32_t nodes = 0;
  std::size_t creases = 0;      ///< Lines kept.
  std::size_t cut_creases = 0;  ///< Of them, those that a cut runs along: these are kept whatever `crease` is.
  std::size_t narrow = 0;       ///< Creases left out, as they run close beside another line,
  geom::Point3 narrow_at;       ///< and where one of them begins.
  std::size_t loose = 0;        ///< Creases left out, as they are shorter than a side,
  geom::Point3 loose_at;        ///< and where one of them begins.
  std::size_t tips = 0;         ///< Points kept, as the sheet comes to a tip there: the node set "tips".
  std::size_t tips_out = 0;     ///< Tips left out, as asked, or as a line or a sharper tip is much nearer than a side,
  geom::Point3 tip_at;          ///< and where one of them is.
};

/// Which creases become lines.
enum class Creases : std::uint8_t {
  Clear,  ///< None shorter than a side, and none much nearer than a side to another line.
  All     ///< All but those shorter than a side with an end that nothing meets: triangles may become needles there.
};

enum class Tips : std::uint8_t { Stay, LeaveOut };

/// Unless all are kept: of two creases with less than a quarter of the size between them the shorter one is left out.
/// Along each line between vertices that stay, as many sides as the sizes ask for, even by them; more where sides would
/// cross others in the chart, as those of a line that turns to and fro may. Both sides of a cut get the same nodes.
/// A tip is a vertex inside whose angles have a sum that is more than `corner` off a full turn, and that is
/// still one at half a side: it stands off the vertices there by 0.4 of their distance.
/// @param sizes  one a point of the sheet before the cut, m
/// @param crease  degrees; 180: none are kept
Network divide_network(const Atlas& atlas, const std::vector<double>& sizes, double corner, double crease,
                       Creases creases = Creases::Clear, Tips tips = Tips::Stay);

}  // namespace dobra::surf::remesh
