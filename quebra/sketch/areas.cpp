#include "quebra/sketch/areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "quebra/sketch/snap.h"

// 1. Rings turned so that their area lies on the left. 2. They are made to share vertices (snap.h). 3. A side that two
// areas pass in opposite directions is shared. 4. Each ring is cut where its neighbour changes.

namespace quebra::sketch {
namespace {

using dobra::geom::Point;
using dobra::geom::Polyline;

constexpr std::size_t outside = static_cast<std::size_t>(-1);

struct Ring {
  std::size_t area = 0, curve = 0;
  Polyline line;
};

/// The rings of all areas, each with its area on the left; areas with a ring that is not closed and straight are left
/// out.
std::vector<Ring> rings_of(const Sketch& sketch) {
  std::map<std::string, std::size_t> by_name;
  for (std::size_t c = 0; c < sketch.curves.size(); ++c) by_name.emplace(sketch.curves[c].name, c);
  std::vector<Ring> rings;
  for (std::size_t a = 0; a < sketch.areas.size(); ++a) {
    std::vector<Ring> own;
    for (const std::string& name : sketch.areas[a].rings) {
      const auto found = by_name.find(name);
      const auto* line = found == by_name.end() ? nullptr : std::get_if<Polyline>(&sketch.curves[found->second].shape);
      if (line != nullptr && line->closed) own.push_back({a, found->second, *line});
    }
    if (own.size() != sketch.areas[a].rings.size()) continue;
    for (Ring& ring : own) {
      const auto depth = std::count_if(own.begin(), own.end(), [&](const Ring& other) {
        return &other != &ring && locate(other.line, ring.line.points.front()) == dobra::geom::Side::Inside;
      });
      if ((signed_area(ring.line) > 0.0) != (depth % 2 == 0)) ring.line = reversed(std::move(ring.line));
    }
    rings.insert(rings.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  return rings;
}

/// Of every directed side, the areas on its left.
using Lefts = std::map<std::pair<Point, Point>, std::vector<std::size_t>>;

class Parter {
 public:
  Parter(Sketch& sketch, double tolerance) : sketch_(sketch), rings_(rings_of(sketch)) {
    std::vector<Polyline*> lines;
    for (Ring& ring : rings_) lines.push_back(&ring.line);
    snap_together(lines, tolerance);
    for (const Ring& ring : rings_) {
      for (std::size_t i = 0; i < ring.line.segment_count(); ++i) {
        const auto [from, to] = ring.line.segment(i);
        lefts_[{from, to}].push_back(ring.area);
      }
    }
    for (const Curve& curve : sketch.curves) names_.insert(curve.name);
  }

  void run() {
    const std::set<std::size_t> left_alone = overlapping();
    std::vector<Curve> made;
    std::vector<dobra::base::Place> places;
    std::set<std::size_t> gone;
    for (const Ring& ring : rings_) {
      if (left_alone.contains(ring.area)) continue;
      std::vector<std::size_t> beyond;
      for (std::size_t i = 0; i < ring.line.segment_count(); ++i) beyond.push_back(beyond_side(ring, i, left_alone));
      if (std::all_of(beyond.begin(), beyond.end(), [](std::size_t other) { return other == outside; })) continue;
      gone.insert(ring.curve);
      names_.erase(sketch_.curves[ring.curve].name);
      for (Curve& curve : cut(ring, beyond)) {
        made.push_back(std::move(curve));
        places.push_back(ring.curve < sketch_.places.size() ? sketch_.places[ring.curve] : dobra::base::Place{});
      }
    }
    for (auto c = gone.rbegin(); c != gone.rend(); ++c) {
      sketch_.without_role.erase(sketch_.curves[*c].name);
      sketch_.curves.erase(sketch_.curves.begin() + static_cast<std::ptrdiff_t>(*c));
      if (*c < sketch_.places.size()) sketch_.places.erase(sketch_.places.begin() + static_cast<std::ptrdiff_t>(*c));
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
      sketch_.curves.push_back(std::move(made[i]));
      sketch_.places.push_back(places[i]);
    }
  }

 private:
  /// Areas that have a side with another area on the same side of it: they overlap.
  [[nodiscard]] std::set<std::size_t> overlapping() const {
    std::set<std::size_t> found;
    for (const auto& [side, areas] : lefts_) {
      if (areas.size() > 1) found.insert(areas.begin(), areas.end());
    }
    return found;
  }

  [[nodiscard]] std::size_t beyond_side(const Ring& ring, std::size_t i,
                                        const std::set<std::size_t>& left_alone) const {
    const auto [from, to] = ring.line.segment(i);
    const auto back = lefts_.find({to, from});
    if (back == lefts_.end() || back->second.front() == ring.area || left_alone.contains(back->second.front()))
      return outside;
    return back->second.front();
  }

  /// The pieces of a ring between changes of its neighbour; of a shared one, the area that comes first keeps it.
  std::vector<Curve> cut(const Ring& ring, const std::vector<std::size_t>& beyond) {
    const std::size_t n = beyond.size();
    const std::string own = sketch_.curves[ring.curve].name;
    std::vector<Curve> pieces;
    const auto add = [&](std::size_t first, std::size_t count) {
      const std::size_t other = beyond[first];
      if (other != outside && other < ring.area) return;
      Polyline line{{}, count == n};
      for (std::size_t k = 0; k < count + (line.closed ? 0 : 1); ++k)
        line.points.push_back(ring.line.points[(first + k) % n]);
      const std::string name =
          other == outside ? own : fmt::format("{}_{}", name_of_area(ring.area), name_of_area(other));
      Curve piece{unused(name), other == outside ? Role::Boundary : Role::Internal, std::move(line), {}};
      if (other != outside) sketch_.interfaces.insert(piece.name);
      pieces.push_back(std::move(piece));
    };
    std::size_t start = 0;
    while (start < n && beyond[start] == beyond[(start + n - 1) % n]) ++start;
    if (start == n) {
      add(0, n);
      return pieces;
    }
    for (std::size_t begin = 0; begin < n;) {
      std::size_t end = begin + 1;
      while (end < n && beyond[(start + end) % n] == beyond[(start + begin) % n]) ++end;
      add((start + begin) % n, end - begin);
      begin = end;
    }
    return pieces;
  }

  [[nodiscard]] const std::string& name_of_area(std::size_t area) const {
    return sketch_.areas[area].name.empty() ? sketch_.areas[area].rings.front() : sketch_.areas[area].name;
  }

  std::string unused(const std::string& name) {
    std::string free = name;
    for (int i = 2; !names_.insert(free).second; ++i) free = fmt::format("{}_{}", name, i);
    return free;
  }

  Sketch& sketch_;
  std::vector<Ring> rings_;
  Lefts lefts_;
  std::set<std::string> names_;
};

}  // namespace

void part_shared_sides(Sketch& sketch, double tolerance) {
  if (sketch.areas.size() > 1) Parter(sketch, tolerance).run();
}

}  // namespace quebra::sketch
