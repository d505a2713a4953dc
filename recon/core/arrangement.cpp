#include "recon/core/arrangement.h"

#include <algorithm>
#include <unordered_map>

#include "shared/topo/insert.h"

namespace recon::core {

base::Result<Arrangement> Arrangement::make(std::span<const geom::Polyline> lines) {
  Arrangement made;
  for (const geom::Polyline& line : lines) DOBRA_TRY_VOID(made.add(line));
  return made;
}

base::Result<void> Arrangement::add(const geom::Polyline& line) {
  const auto number = static_cast<std::uint32_t>(lines_.size());
  DOBRA_TRY(const topo::Inserted inserted, topo::insert(subdivision_, line));
  for (const topo::HalfEdgeId h : inserted.path) own(topo::Structure::edge(h), number);
  lines_.push_back(line);
  return {};
}

void Arrangement::own(topo::EdgeId edge, std::uint32_t line) {
  std::vector<std::uint32_t> owners = lines_on(edge);
  if (std::binary_search(owners.begin(), owners.end(), line)) return;
  owners.insert(std::upper_bound(owners.begin(), owners.end(), line), line);
  const auto [known, is_new] = set_number_.try_emplace(owners, static_cast<std::uint32_t>(sets_.size()));
  if (is_new) sets_.push_back(std::move(owners));
  subdivision_.attribute(edge) = known->second;
}

const std::vector<std::uint32_t>& Arrangement::lines_on(topo::EdgeId edge) const {
  const auto* number = std::any_cast<std::uint32_t>(&subdivision_.attribute(edge));
  return sets_[number == nullptr ? 0 : *number];
}

bool Arrangement::runs_along(topo::EdgeId edge, std::uint32_t line) const {
  const std::vector<std::uint32_t>& owners = lines_on(edge);
  return std::binary_search(owners.begin(), owners.end(), line);
}

std::vector<topo::HalfEdgeId> Arrangement::path(std::uint32_t line) const {
  const geom::Polyline& course = lines_[line];
  const auto start = subdivision_.vertex_at(course.points.front());
  std::vector<topo::HalfEdgeId> path;
  if (!start) return path;
  const auto next_of = [&](topo::VertexId v, topo::HalfEdgeId arrived) {
    for (const topo::HalfEdgeId h : subdivision_.round(v)) {
      const bool back = arrived.valid() && h == topo::Structure::twin(arrived);
      if (!back && runs_along(topo::Structure::edge(h), line)) return h;
    }
    return topo::HalfEdgeId();
  };
  for (topo::HalfEdgeId h = next_of(*start, {}); h.valid();) {
    path.push_back(h);
    const topo::VertexId v = subdivision_.target(h);
    if (v == *start || path.size() > subdivision_.edge_count()) break;
    h = next_of(v, h);
  }
  if (!course.closed || path.empty()) return path;
  // A ring has no first half-edge of its own: the second point decides the direction.
  std::vector<topo::HalfEdgeId> turned(path.size());
  std::transform(path.rbegin(), path.rend(), turned.begin(),
                 [](topo::HalfEdgeId h) { return topo::Structure::twin(h); });
  double area = 0.0;
  for (const topo::HalfEdgeId h : path) {
    const geom::Segment s = subdivision_.segment(h);
    area += geom::cross(s.from - course.points.front(), s.to - course.points.front());
  }
  return (area > 0.0) == (geom::signed_area(course) > 0.0) ? path : turned;
}

namespace {

/// How a first line passes a second one: at each vertex that they share.
class Passage {
 public:
  Passage(const Arrangement& arrangement, std::uint32_t second) : sub_(arrangement.subdivision()) {
    const std::vector<topo::HalfEdgeId> path = arrangement.path(second);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const topo::VertexId from = sub_.origin(path[i]);
      ways_[from.index()].on = path[i];
      ways_[sub_.target(path[i]).index()].back = topo::Structure::twin(path[i]);
    }
  }

  [[nodiscard]] bool meets(topo::VertexId v) const { return ways_.count(v.index()) > 0; }

  /// Of a half-edge that leaves a shared vertex: 1 to the left of the second line, -1 to its right, 0 where that ends.
  [[nodiscard]] int side(topo::HalfEdgeId h) const {
    const Ways& ways = ways_.at(sub_.origin(h).index());
    if (!ways.on.valid() || !ways.back.valid()) return 0;
    const auto to = [&](topo::HalfEdgeId way) { return sub_.point(sub_.target(way)); };
    return topo::within(sub_.point(sub_.origin(h)), to(ways.on), to(ways.back), to(h)) ? 1 : -1;
  }

 private:
  struct Ways {
    topo::HalfEdgeId on;    ///< Leaves towards the end of the second line.
    topo::HalfEdgeId back;  ///< Towards its beginning.
  };
  const topo::Subdivision& sub_;
  std::unordered_map<std::size_t, Ways> ways_;
};

}  // namespace

base::Result<LineMeeting> meeting_of(const geom::Polyline& first, const geom::Polyline& second) {
  const geom::Polyline lines[] = {first, second};
  DOBRA_TRY(const Arrangement arrangement, Arrangement::make(lines));
  const topo::Subdivision& sub = arrangement.subdivision();
  const Passage passage(arrangement, 1);
  LineMeeting meeting;
  int came_from = 0;
  bool together = false;
  topo::VertexId met;
  const auto part = [&](int to) {
    const bool crosses = came_from * to < 0;
    if (meeting.touches + meeting.crossings == 0 || (crosses && meeting.crossings == 0)) meeting.place = sub.point(met);
    ++(crosses ? meeting.crossings : meeting.touches);
    together = false;
  };
  for (const topo::HalfEdgeId h : arrangement.path(0)) {
    const topo::VertexId from = sub.origin(h);
    const bool along = arrangement.runs_along(topo::Structure::edge(h), 1);
    if (!together && passage.meets(from)) {  // only where the first line begins on the second
      together = true;
      came_from = 0;
      met = from;
    }
    if (along) continue;
    if (together) part(passage.side(h));
    const topo::VertexId to = sub.target(h);
    if (!passage.meets(to)) continue;
    together = true;
    came_from = passage.side(topo::Structure::twin(h));
    met = to;
  }
  if (together) part(0);
  return meeting;
}

}  // namespace recon::core
