#include "shared/solid/shape/convex_cutter.h"

#include <algorithm>
#include <array>

#include "shared/base/check.h"

namespace dobra::solid::shape {

using geom::Point3;
using geom::Sign;
using geom::Vector3;

namespace {

std::uint64_t directed(std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32U) | to; }
std::uint64_t undirected(std::uint32_t a, std::uint32_t b) { return directed(std::min(a, b), std::max(a, b)); }

}  // namespace

/// What is known of the plane that cuts.
struct ConvexCutter::Cut {
  PlaneId plane;
  std::unordered_map<std::uint32_t, Sign> signs;               // of corners
  std::vector<std::uint32_t> above;                            // corners
  std::unordered_map<std::uint64_t, std::uint32_t> crossings;  // of edges
  std::vector<std::array<std::uint32_t, 2>> rim;               // edges of the new face
  bool any_below = false;
};

ConvexCutter::ConvexCutter(double reach) : reach_(reach) {
  constexpr std::array<std::array<std::uint32_t, 4>, 6> loops{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<Point3> places;
  for (std::uint32_t i = 0; i < 8; ++i) {
    places.push_back({(i & 1U) != 0 ? reach : -reach, (i & 2U) != 0 ? reach : -reach, (i & 4U) != 0 ? reach : -reach});
    corners_.push_back({space_.add(places.back()), {}});
  }
  for (const auto& loop : loops) {
    const auto number = static_cast<std::uint32_t>(faces_.size());
    const PlaneId plane = space_.add(Plane{{places[loop[0]], places[loop[1]], places[loop[2]]}, {}});
    faces_.push_back({plane, name_number(""), {loop.begin(), loop.end()}});
    for (const std::uint32_t corner : loop) corners_[corner].faces.push_back(number);
  }
}

std::uint32_t ConvexCutter::name_number(const std::string& name) {
  const auto [at, fresh] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (fresh) names_.push_back(name);
  return at->second;
}

double ConvexCutter::height(Vector3 normal, std::uint32_t corner) const {
  return dot(normal, space_.rounded(corners_[corner].at) - Point3{});
}

std::vector<std::uint32_t> ConvexCutter::neighbours(std::uint32_t corner) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t f : corners_[corner].faces) {
    // The edges that leave the corner; each neighbour has one.
    const auto& loop = faces_[f].loop;
    const auto at = std::find(loop.begin(), loop.end(), corner);
    found.push_back(at + 1 == loop.end() ? loop.front() : *(at + 1));
  }
  return found;
}

/// The highest corner, first, and those as high as it but for rounding that hang together with it. From a corner
/// upwards over edges; where planes nearly meet in one point, corners lie so near to each other that the way leads
/// along them.
std::vector<std::uint32_t> ConvexCutter::highest(Vector3 normal) const {
  const double slack = 1e-12 * reach_ * length(normal);
  std::vector<std::uint32_t> level{near_};
  for (std::size_t i = 0; i < level.size(); ++i) {
    for (const std::uint32_t next : neighbours(level[i])) {
      const double up = height(normal, next) - height(normal, level[0]);
      if (up > 0.0) {
        level = {next};
        i = static_cast<std::size_t>(-1);  // begins anew
        break;
      }
      if (up >= -slack && std::find(level.begin(), level.end(), next) == level.end()) level.push_back(next);
    }
  }
  return level;
}

Sign ConvexCutter::side(Cut& cut, std::uint32_t corner) const {
  const auto known = cut.signs.find(corner);
  if (known != cut.signs.end()) return known->second;
  const Sign sign = space_.side(cut.plane, corners_[corner].at);
  cut.signs.emplace(corner, sign);
  cut.any_below = cut.any_below || sign == Sign::Negative;
  return sign;
}

/// Corners above the plane hang together over edges.
void ConvexCutter::find_above(Cut& cut) const {
  std::vector<std::uint32_t> open = highest(space_.rough_normal(cut.plane));
  for (const std::uint32_t next : neighbours(open[0])) open.push_back(next);
  std::unordered_map<std::uint32_t, char> seen;
  while (!open.empty()) {
    const std::uint32_t corner = open.back();
    open.pop_back();
    if (side(cut, corner) != Sign::Positive || !seen.emplace(corner, 1).second) continue;
    cut.above.push_back(corner);
    for (const std::uint32_t next : neighbours(corner)) open.push_back(next);
  }
}

/// The corner where an edge of the face meets the plane.
std::uint32_t ConvexCutter::crossing(Cut& cut, std::uint32_t face, std::uint32_t from, std::uint32_t to) {
  const auto [known, fresh] =
      cut.crossings.try_emplace(undirected(from, to), static_cast<std::uint32_t>(corners_.size()));
  if (fresh) {
    std::uint32_t other = face;
    for (const std::uint32_t f : corners_[from].faces) {
      const auto& with = corners_[to].faces;
      if (f != face && std::find(with.begin(), with.end(), f) != with.end()) other = f;
    }
    DOBRA_CHECK(other != face);
    corners_.push_back({space_.meet(faces_[face].plane, faces_[other].plane, cut.plane), {face, other}});
  }
  return known->second;
}

/// Takes what is above away from a face, and notes the edge that this leaves.
void ConvexCutter::clip(Cut& cut, std::uint32_t face) {
  const std::vector<std::uint32_t> loop = faces_[face].loop;
  const std::size_t n = loop.size();
  std::vector<std::uint32_t> kept;
  std::array<std::uint32_t, 2> rim{none, none};  // where the way along the loop goes up through the plane, and down
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t p = loop[i];
    const std::uint32_t q = loop[(i + 1) % n];
    const Sign at_p = side(cut, p);
    const Sign at_q = side(cut, q);
    if (at_p != Sign::Positive) kept.push_back(p);
    if ((at_p == Sign::Positive) == (at_q == Sign::Positive)) continue;
    const std::uint32_t low = at_p == Sign::Positive ? q : p;
    std::uint32_t end = low;
    if (side(cut, low) == Sign::Negative) {
      end = crossing(cut, face, p, q);
      kept.push_back(end);
    }
    rim[at_p == Sign::Positive ? 1 : 0] = end;
  }
  if (rim[0] != none && rim[0] != rim[1]) cut.rim.push_back({rim[1], rim[0]});
  if (kept.size() < 3) {
    for (const std::uint32_t corner : kept) std::erase(corners_[corner].faces, face);
    kept.clear();
  }
  faces_[face].loop = std::move(kept);
}

/// The face that the cut makes.
void ConvexCutter::close(Cut& cut, std::uint32_t name) {
  std::unordered_map<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : cut.rim) next.emplace(from, to);
  DOBRA_CHECK(next.size() == cut.rim.size() && next.size() >= 3);
  const auto number = static_cast<std::uint32_t>(faces_.size());
  Face face{cut.plane, name, {}};
  std::uint32_t corner = cut.rim[0][0];
  do {
    face.loop.push_back(corner);
    corners_[corner].faces.push_back(number);
    const auto found = next.find(corner);
    DOBRA_CHECK(found != next.end() && face.loop.size() <= next.size());
    corner = found->second;
  } while (corner != cut.rim[0][0]);
  DOBRA_CHECK(face.loop.size() == next.size());
  near_ = face.loop[0];
  faces_.push_back(std::move(face));
}

void ConvexCutter::cut(const Plane& plane, const std::string& name) {
  if (empty_) return;
  Cut cut{space_.add(plane), {}, {}, {}, {}, false};
  find_above(cut);
  if (cut.above.empty()) return;
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t corner : cut.above)
    touched.insert(touched.end(), corners_[corner].faces.begin(), corners_[corner].faces.end());
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (std::uint32_t f : touched) {
    for (const std::uint32_t corner : faces_[f].loop) side(cut, corner);
  }
  if (!cut.any_below) {
    for (std::uint32_t c = 0; c < corners_.size() && !cut.any_below; ++c) {
      if (!corners_[c].faces.empty()) side(cut, c);
    }
  }
  if (!cut.any_below) {
    empty_ = true;
    return;
  }
  for (const std::uint32_t f : touched) clip(cut, f);
  for (const std::uint32_t corner : cut.above) corners_[corner].faces.clear();
  close(cut, name_number(name));
}

std::vector<Point3> ConvexCutter::corners() const {
  std::vector<Point3> places;
  if (empty_) return places;
  for (const Corner& corner : corners_) {
    if (!corner.faces.empty()) places.push_back(space_.rounded(corner.at));
  }
  return places;
}

Solid ConvexCutter::solid() const {
  if (empty_) return {};
  Boundary out;
  out.names = names_;
  std::vector<PlaneId> planes;
  std::unordered_map<std::uint64_t, std::uint32_t> edges;
  std::vector<std::uint32_t> corner_numbers(corners_.size(), none);
  for (const Face& face : faces_)
    planes.push_back(face.loop.empty() ? PlaneId() : out.soup.space.add(space_.plane(face.plane)));
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto& loop = faces_[f].loop;
    if (loop.empty()) continue;
    out.soup.begin(planes[f], 0, faces_[f].name);
    out.soup.begin_loop();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges.emplace(directed(loop[i], loop[(i + 1) % loop.size()]),
                    static_cast<std::uint32_t>(out.soup.corners.size()));
      out.soup.add_corner(out.soup.space.add(space_, corners_[loop[i]].at), PlaneId());
      std::uint32_t& number = corner_numbers[loop[i]];
      if (number == none) number = out.vertex_count++;
      out.vertices.push_back(number);
    }
  }
  out.mates.resize(out.soup.corners.size());
  for (const auto& [edge, corner] : edges) {
    const auto mate = edges.find(directed(static_cast<std::uint32_t>(edge), static_cast<std::uint32_t>(edge >> 32U)));
    DOBRA_CHECK(mate != edges.end());
    out.mates[corner] = mate->second;
  }
  for (const Facet& facet : out.soup.facets) {
    for (std::uint32_t c = facet.first_corner; c < facet.corner_end; ++c) out.soup.across[out.mates[c]] = facet.plane;
  }
  out.soup.inner = {Inner::Trusted};
  out.shell_count = 1;
  out.shells.assign(out.soup.facets.size(), 0);
  return Solid(std::move(out));
}

}  // namespace dobra::solid::shape
