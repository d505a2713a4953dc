#include "recon/section/crossings.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/geom/intersect.h"
#include "shared/geom/place.h"
#include "shared/geom/spatial_index.h"

namespace recon::section {

namespace {

std::vector<geom::Box> boxes_of(const geom::Polyline& line) {
  std::vector<geom::Box> boxes;
  boxes.reserve(line.segment_count());
  for (std::size_t i = 0; i < line.segment_count(); ++i) boxes.push_back(line.segment(i).box());
  return boxes;
}

double length_between(const geom::Polyline& line, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) sum += line.segment(i).length();
  return sum;
}

}  // namespace

std::vector<SelfCrossing> self_crossings(const geom::Polyline& line) {
  const geom::SpatialIndex index(boxes_of(line));
  std::vector<SelfCrossing> found;
  for (const auto& [i, j] : index.overlapping_pairs()) {
    const geom::Intersection meeting = geom::intersect(line.segment(i), line.segment(j));
    const bool neighbours = j == i + 1 || (line.closed && i == 0 && j + 1 == line.segment_count());
    if (meeting.kind == geom::IntersectionKind::Overlap ||
        (meeting.kind == geom::IntersectionKind::Point && !neighbours)) {
      found.push_back({i, j, meeting.start.point});
    }
  }
  return found;
}

base::Result<WithoutLoops> without_loops(geom::Polyline line, const LoopOptions& options) {
  WithoutLoops result;
  const double longest = options.longest_loop * geom::length(line);
  // A cut can bring a new crossing (of the shortened piece): look again until there is none. Each round drops points.
  for (auto crossings = self_crossings(line); !crossings.empty(); crossings = self_crossings(line)) {
    geom::Polyline cut;
    std::size_t next = 0;  // first point not yet copied
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      if (crossings[k].first < next) continue;  // inside a loop that is gone
      SelfCrossing loop = crossings[k];         // of those on this segment the longest
      while (k + 1 < crossings.size() && crossings[k + 1].first == loop.first) loop = crossings[++k];
      const double loop_length = length_between(line, loop.first + 1, loop.second);
      if (loop_length > longest) {
        return base::Error{
            base::ErrorCode::BadSection,
            fmt::format("the line crosses itself in a loop of {:.4g} m, too long to be cut out; correct the line",
                        loop_length),
            place_at(loop.place)};
      }
      for (; next <= loop.first; ++next) cut.points.push_back(line.points[next]);
      cut.points.push_back(loop.place);
      next = loop.second + 1;
      result.places.push_back(loop.place);
    }
    for (; next < line.points.size(); ++next) cut.points.push_back(line.points[next]);
    line = geom::without_repeated_points(std::move(cut));
  }
  result.line = std::move(line);
  return result;
}

}  // namespace recon::section
