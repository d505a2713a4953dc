#include "recon/moving/block_area.h"

#include <set>

#include "recon/section/arrangement.h"
#include "recon/section/face_contours.h"
#include "shared/topo/locate.h"

namespace recon::moving {

namespace {

/// Diagonals of the section from it to the frame, and how far faults go on that leave it.
constexpr double frame_at = 3.0;
constexpr double beyond_frame = 10.0;
/// Diagonals that a fault goes on behind the one that it ends on, so that rounding leaves no gap.
constexpr double across = 1e-6;

/// One end of a line, which is its last point.
void lengthen(std::vector<geom::Point>& points, const faults::FaultEnd& end, double diagonal) {
  if (end.kind == faults::EndKind::Tip) return;
  const geom::Vector along = geom::normalised(points.back() - points[points.size() - 2]);
  if (end.kind == faults::EndKind::Border) {
    points.push_back(points.back() + beyond_frame * diagonal * along);
    return;
  }
  const geom::Vector to = end.at - points.back();
  const bool ahead = dot(to, along) > 0.0;
  if (ahead) points.push_back(end.at);
  points.push_back(points.back() + across * diagonal * (ahead ? geom::normalised(to) : along));
}

geom::Polyline drawn(geom::Polyline line, const faults::FaultEnd& lower, const faults::FaultEnd& upper,
                     double diagonal) {
  lengthen(line.points, upper, diagonal);
  line = geom::reversed(std::move(line));
  lengthen(line.points, lower, diagonal);
  return line;
}

geom::Polyline frame_round(const geom::Box& box, double diagonal) {
  const geom::Box frame = box.grown(frame_at * diagonal);
  return {{frame.low, {frame.high.x, frame.low.y}, frame.high, {frame.low.x, frame.high.y}}, true};
}

}  // namespace

base::Result<std::vector<geom::Polyline>> area_of_blocks(const section::Section& section,
                                                         const std::vector<faults::Fault>& faults,
                                                         const faults::Fault& moving,
                                                         std::span<const geom::Point> inside) {
  const geom::Box box = box_of(section);
  const double diagonal = box.diagonal();
  std::vector<geom::Polyline> lines{frame_round(box, diagonal)};
  for (const faults::Fault& fault : faults) lines.push_back(drawn(own_line(fault), fault.lower, fault.upper, diagonal));
  // Beyond the fault's own part its path runs along others, to where they end.
  const faults::FaultEnd border{};
  const kinematics::FaultPath& path = moving.path;
  const faults::FaultEnd tip{faults::EndKind::Tip, {}, {}, 0.0};
  lines.push_back(drawn(path.line,
                        path.tip_at_begin       ? tip
                        : moving.own_from > 0.0 ? border
                                                : moving.lower,
                        path.tip_at_end                                         ? tip
                        : moving.own_to < geom::length(path.line) * (1 - 1e-12) ? border
                                                                                : moving.upper,
                        diagonal));
  DOBRA_TRY(const section::Arrangement arrangement, section::Arrangement::make(std::move(lines)));
  std::set<topo::FaceId> chosen;
  for (const geom::Point p : inside) {
    const topo::Location place = topo::locate(arrangement.subdivision(), p);
    if (place.where == topo::Where::Face) chosen.insert(place.face);
  }
  std::vector<geom::Polyline> contours;
  for (const topo::FaceId face : chosen) {
    for (geom::Polyline& contour : section::contours_of(arrangement, face)) contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace recon::moving
