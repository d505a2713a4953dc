#include "shared/solid/check/validate.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/solid/gathering.h"
#include "shared/solid/windings.h"

namespace dobra::solid::check {
namespace {

void check_links(const Solid& solid, std::vector<std::string>& found) {
  const Soup& soup = solid.boundary().soup;
  const std::size_t count = soup.corners.size();
  std::vector<std::size_t> previous(count);
  for (std::size_t h = 0; h < count; ++h) previous[solid.next(HalfEdgeId(h)).index()] = h;
  std::vector<std::size_t> passed(solid.vertex_count(), 0);
  std::vector<char> seen(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const HalfEdgeId h(i);
    const HalfEdgeId mate = solid.mate(h);
    if (mate == h || solid.mate(mate) != h) found.push_back(fmt::format("half-edge {} and its mate do not agree", i));
    if (solid.origin(mate) != solid.origin(solid.next(h)) ||
        soup.corners[mate.index()] != soup.corners[solid.next(h).index()]) {
      found.push_back(fmt::format("half-edge {} does not end where its mate begins", i));
    }
    if (soup.corners[i] == soup.corners[solid.next(h).index()])
      found.push_back(fmt::format("half-edge {} has no length", i));
    if (seen[i] != 0) continue;
    ++passed[solid.origin(h).index()];
    for (std::size_t g = i; seen[g] == 0; g = solid.mate(HalfEdgeId(previous[g])).index()) {
      seen[g] = 1;
      if (solid.origin(HalfEdgeId(g)) != solid.origin(h))
        found.push_back(fmt::format("half-edge {} leaves another vertex", g));
    }
  }
  for (std::size_t v = 0; v < passed.size(); ++v) {
    if (passed[v] != 1) found.push_back(fmt::format("vertex {} has {} fans of faces", v, passed[v]));
  }
}

void check_planes(const Solid& solid, std::vector<std::string>& found) {
  const Soup& soup = solid.boundary().soup;
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    for (const PointId p : soup.corners_of(soup.facets[f])) {
      if (soup.space.side(soup.facets[f].plane, p) != geom::Sign::Zero) {
        found.push_back(fmt::format("a corner of face {} is not in its plane", f));
      }
    }
  }
}

void check_geometry(const Solid& solid, std::vector<std::string>& found) {
  Gathering all(std::span(&solid, 1));
  all.soup.inner[0] = Inner::Searched;
  const Contacts meetings = contacts(all.soup, all.trees);
  const Cells cells = arrange(all.soup, meetings);
  const Fans round = fans(all.soup, cells);
  if (open_half(all.soup, cells, round)) {
    found.emplace_back("the faces do not close");
    return;
  }
  for (const Cell& cell : cells.cells) {
    if (cell.cover_end - cell.first_cover != 1) found.emplace_back("two faces cover each other");
  }
  const Sides windings = sides(all.soup, cells, round, all.trees);
  for (const Windings& kind : windings.kinds) {
    if (!kind.empty() && kind[0].second != 1) {
      found.push_back(fmt::format("a region is surrounded {} times", kind[0].second));
    }
  }
}

}  // namespace

std::vector<std::string> violations(const Solid& solid) {
  std::vector<std::string> found;
  check_links(solid, found);
  check_planes(solid, found);
  if (!found.empty()) return found;
  const Counts c = solid.counts();
  if (c.handles < 0) found.push_back(fmt::format("there are {} handles", c.handles));
  check_geometry(solid, found);
  return found;
}

}  // namespace dobra::solid::check
