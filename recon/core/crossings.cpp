#include "recon/core/crossings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

namespace recon::core {

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
    const bool neighbours = j == i + 1;
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

std::vector<HorizonCrossing> crossings_between(const Section& section) {
  std::vector<geom::Box> boxes;
  std::vector<std::pair<std::size_t, std::size_t>> owner;  // horizon, segment
  for (std::size_t h = 0; h < section.horizons.size(); ++h) {
    const geom::Polyline& line = section.horizons[h].line;
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      boxes.push_back(line.segment(i).box());
      owner.emplace_back(h, i);
    }
  }
  std::map<std::pair<std::size_t, std::size_t>, HorizonCrossing> found;
  for (const auto& [a, b] : geom::SpatialIndex(boxes).overlapping_pairs()) {
    const Horizon& first = section.horizons[owner[a].first];
    const Horizon& second = section.horizons[owner[b].first];
    if (first.id == second.id) continue;
    const geom::Intersection meeting =
        geom::intersect(first.line.segment(owner[a].second), second.line.segment(owner[b].second));
    if (meeting.kind == geom::IntersectionKind::None) continue;
    auto [entry, is_new] = found.try_emplace({owner[a].first, owner[b].first},
                                             HorizonCrossing{first.id, second.id, 0, meeting.start.point});
    ++entry->second.count;
  }
  std::vector<HorizonCrossing> crossings;
  for (const auto& [pair, crossing] : found) crossings.push_back(crossing);
  return crossings;
}

}  // namespace recon::core
