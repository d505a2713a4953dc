#pragma once
// All that a subdivision says about itself, to compare before and after. Where a loop is entered, and where the turn
// round a vertex starts, is of no meaning and left out.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <tuple>

#include "shared/topo/insert.h"
#include "shared/topo/subdivision.h"
#include "shared/topo/validate.h"

namespace dobra::topo {

struct Snapshot {
  std::map<VertexId, std::tuple<double, double, LoopId, std::string>> vertices;
  std::map<HalfEdgeId, std::tuple<HalfEdgeId, HalfEdgeId, VertexId, LoopId, FaceId>> half_edges;
  std::map<EdgeId, std::string> edges;
  std::map<FaceId, std::tuple<LoopId, std::set<LoopId>, std::string>> faces;
  std::size_t components = 0;
  friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

inline std::string text(const std::any& value) {
  const auto* const held = std::any_cast<std::string>(&value);
  return held == nullptr ? std::string() : *held;
}

inline Snapshot snapshot(const Subdivision& s) {
  Snapshot all;
  all.components = s.component_count();
  for (const VertexId v : s.vertices())
    all.vertices[v] = {s.point(v).x, s.point(v).y, s.lone_loop(v), text(s.attribute(v))};
  for (const EdgeId e : s.edges()) {
    all.edges[e] = text(s.attribute(e));
    for (const HalfEdgeId h : {Subdivision::half_edge(e), Subdivision::twin(Subdivision::half_edge(e))}) {
      all.half_edges[h] = {s.next(h), s.previous(h), s.origin(h), s.loop(h), s.face(h)};
    }
  }
  for (const FaceId f : s.faces()) {
    const auto loops = s.loops(f);
    all.faces[f] = {s.outer_loop(f), {loops.begin(), loops.end()}, text(s.attribute(f))};
  }
  return all;
}

inline void expect_sound(const Subdivision& s) {
  for (const std::string& wrong : violations(s)) ADD_FAILURE() << wrong;
}

/// From its lower left corner anticlockwise.
inline geom::Polyline square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, true};
}

}  // namespace dobra::topo
