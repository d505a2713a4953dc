#include "shared/solid/assemble.h"

#include <algorithm>

#include "shared/base/check.h"
#include "shared/base/disjoint_sets.h"

namespace dobra::solid {
namespace {

Plane turned_over(Plane plane) {
  if (plane.constant) {
    geom::Point3& n = plane.through[0];
    n = {-n.x, -n.y, -n.z};
    plane.constant = -*plane.constant;
  } else {
    std::swap(plane.through[1], plane.through[2]);
  }
  return plane;
}

class Assembly {
 public:
  Assembly(const Soup& soup, const Cells& cells, const Fans& fans, const Sides& sides, const std::vector<char>& inside)
      : soup_(soup), cells_(cells), fans_(fans), sides_(sides), inside_(inside) {}

  Boundary run(const Contacts& contacts, std::vector<std::string> names) {
    keep();
    pair();
    link();
    join_cells();
    find_vertices();
    touches_ = touches_ || any_point(contacts);
    drop_straight();
    emit(std::move(names));
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::uint32_t cell_of(std::uint32_t h) const {
    return static_cast<std::uint32_t>(cells_.halves[h].cell.index());
  }
  [[nodiscard]] bool above_inside(std::uint32_t cell) const { return inside_[sides_.above[cell]] != 0; }
  [[nodiscard]] bool below_inside(std::uint32_t cell) const { return inside_[sides_.below[cell]] != 0; }
  [[nodiscard]] bool kept(std::uint32_t h) const { return kept_[cell_of(h)] != 0; }

  /// Which cells are boundary, whether their upper side is inside, and their names.
  void keep() {
    const std::size_t count = cells_.cells.size();
    kept_.resize(count);
    turned_.resize(count);
    name_.resize(count);
    for (std::uint32_t c = 0; c < count; ++c) {
      turned_[c] = above_inside(c) ? 1 : 0;
      kept_[c] = above_inside(c) != below_inside(c) ? 1 : 0;
      const auto covers = cells_.covers_of(cells_.cells[c]);
      std::uint32_t facet = covers[0].facet;
      for (const Cover& cover : covers) {
        if (cover.turned == (turned_[c] != 0)) {
          facet = cover.facet;
          break;
        }
      }
      name_[c] = soup_.facets[facet].name;
    }
  }

  /// Two cells that have a wedge of the inside between them are mates at that edge.
  void pair() {
    mate_.assign(cells_.halves.size(), none);
    std::vector<std::uint32_t> ring;
    for (const std::uint32_t first : fans_.first) {
      ring.clear();
      std::uint32_t h = first;
      do {
        if (kept(h)) ring.push_back(h);
        h = fans_.turned[h];
      } while (h != first);
      if (ring.size() > 2) touches_ = true;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const bool rising = upper_side_follows(cells_, ring[i]);
        if (!(rising ? above_inside(cell_of(ring[i])) : below_inside(cell_of(ring[i])))) continue;
        const std::uint32_t other = ring[(i + 1) % ring.size()];
        if (cell_of(ring[i]) == cell_of(other)) touches_ = true;  // an edge within a cell: something touches it there
        mate_[ring[i]] = other;
        mate_[other] = ring[i];
      }
    }
  }

  /// Half-edges in the direction that has the result's outside above.
  void link() {
    const auto count = static_cast<std::uint32_t>(cells_.halves.size());
    next_.assign(count, none);
    origin_.resize(count);
    for (std::uint32_t h = 0; h < count; ++h) {
      if (!kept(h)) continue;
      DOBRA_CHECK(mate_[h] != none);
      const bool back = turned_[cell_of(h)] != 0;
      origin_[h] = back ? cells_.target(h) : cells_.halves[h].origin;
      if (back) {
        next_[cells_.halves[h].next] = h;
      } else {
        next_[h] = cells_.halves[h].next;
      }
    }
  }

  [[nodiscard]] PlaneId plane_of(std::uint32_t cell) const { return soup_.facets[cells_.cells[cell].facet].plane; }
  [[nodiscard]] bool one_plane(std::uint32_t c, std::uint32_t d) const {
    return cells_.cells[c].facet == cells_.cells[d].facet || soup_.space.coplanar(plane_of(c), plane_of(d));
  }

  void join_cells() {
    base::DisjointSets sets(cells_.cells.size());
    gone_.assign(mate_.size(), 0);
    flat_.assign(mate_.size(), 0);
    for (std::uint32_t h = 0; h < mate_.size(); ++h) {
      if (!kept(h) || mate_[h] < h) continue;
      const std::uint32_t c = cell_of(h);
      const std::uint32_t d = cell_of(mate_[h]);
      if (!one_plane(c, d)) continue;
      flat_[h] = flat_[mate_[h]] = 1;
      if (name_[c] != name_[d]) continue;
      sets.join(c, d);
      gone_[h] = gone_[mate_[h]] = 1;
    }
    face_.resize(cells_.cells.size());
    for (std::uint32_t c = 0; c < face_.size(); ++c) face_[c] = static_cast<std::uint32_t>(sets.root(c));
    // Past the edges that are gone.
    auto linked = next_;
    previous_.assign(next_.size(), none);
    for (std::uint32_t h = 0; h < next_.size(); ++h) {
      if (!there(h)) continue;
      std::uint32_t g = next_[h];
      while (gone_[g] != 0) g = next_[mate_[g]];
      linked[h] = g;
      previous_[g] = h;
    }
    next_ = std::move(linked);
  }
  [[nodiscard]] bool there(std::uint32_t h) const { return kept(h) && gone_[h] == 0; }

  /// One vertex for the half-edges that follow each other round it.
  void find_vertices() {
    vertex_.assign(next_.size(), none);
    std::vector<char> used(soup_.space.point_count(), 0);
    for (std::uint32_t h = 0; h < next_.size(); ++h) {
      if (!there(h) || vertex_[h] != none) continue;
      char& place = used[origin_[h].index()];
      if (place != 0) touches_ = true;
      place = 1;
      std::uint32_t degree = 0;
      for (std::uint32_t g = h; vertex_[g] == none; g = mate_[previous_[g]]) {
        vertex_[g] = static_cast<std::uint32_t>(degree_.size());
        ++degree;
      }
      degree_.push_back(degree);
    }
  }

  /// A facet touches another in a point alone.
  [[nodiscard]] static bool any_point(const Contacts& contacts) {
    return std::any_of(contacts.cuts.begin(), contacts.cuts.end(), [](const Cut& cut) { return cut.a == cut.b; });
  }

  void drop_straight() {
    straight_.assign(next_.size(), 0);
    for (std::uint32_t h = 0; h < next_.size(); ++h) {
      if (!there(h) || degree_[vertex_[h]] != 2) continue;
      // Between two planes there is one line alone.
      if (flat_[h] == 0 || soup_.space.collinear(origin_[previous_[h]], origin_[h], origin_[next_[h]])) {
        straight_[h] = 1;
      }
    }
  }

  void emit(std::vector<std::string> names) {
    // The first half-edge of each loop, behind that of the face's loop before it.
    std::vector<std::uint32_t> first_loop(face_.size(), none);
    std::vector<std::uint32_t> last_loop(face_.size(), none);
    std::vector<std::uint32_t> next_loop(next_.size(), none);
    std::vector<char> seen(next_.size(), 0);
    std::size_t corner_count = 0;
    std::size_t loop_count = 0;
    for (std::uint32_t h = 0; h < next_.size(); ++h) {
      if (!there(h) || seen[h] != 0 || straight_[h] != 0) continue;
      const std::uint32_t face = face_[cell_of(h)];
      (last_loop[face] == none ? first_loop[face] : next_loop[last_loop[face]]) = h;
      last_loop[face] = h;
      ++loop_count;
      for (std::uint32_t g = h; seen[g] == 0; g = next_[g], ++corner_count) seen[g] = 1;
    }
    out_.soup.space.reserve(degree_.size(), loop_count);
    out_.soup.reserve(loop_count, corner_count, loop_count);
    out_.soup.inner = {touches_ ? Inner::Searched : Inner::Trusted};
    std::vector<std::uint32_t> corner(next_.size(), none);
    std::vector<std::uint32_t> halves;  // of each corner
    halves.reserve(corner_count);
    for (std::uint32_t c = 0; c < face_.size(); ++c) {
      if (kept_[c] == 0 || face_[c] != c) continue;
      Plane plane = soup_.space.plane(plane_of(c));
      if (turned_[c] != 0) plane = turned_over(plane);
      out_.soup.begin(out_.soup.space.add(plane), 0, name_[c]);
      for (std::uint32_t first = first_loop[c]; first != none; first = next_loop[first]) {
        out_.soup.begin_loop();
        std::uint32_t h = first;
        do {
          if (straight_[h] == 0) {
            corner[h] = static_cast<std::uint32_t>(halves.size());
            halves.push_back(h);
            out_.soup.add_corner(out_.soup.space.add(soup_.space, origin_[h]), PlaneId());
          }
          h = next_[h];
        } while (h != first);
      }
    }
    out_.names = std::move(names);
    finish(corner, halves);
  }

  void finish(const std::vector<std::uint32_t>& corner, const std::vector<std::uint32_t>& halves) {
    const std::size_t count = halves.size();
    std::vector<std::uint32_t> facet(count);
    for (std::uint32_t f = 0; f < out_.soup.facets.size(); ++f) {
      out_.soup.visit_edges(out_.soup.facets[f], [&](std::uint32_t i, std::uint32_t) { facet[i] = f; });
    }
    base::DisjointSets shells(out_.soup.facets.size());
    std::vector<std::uint32_t> numbers(degree_.size(), none);
    out_.mates.resize(count);
    out_.vertices.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t last = halves[i];  // of the halves that the edge is made of
      while (straight_[next_[last]] != 0) last = next_[last];
      out_.mates[i] = corner[mate_[last]];
      DOBRA_CHECK(out_.mates[i] != none);
      std::uint32_t& number = numbers[vertex_[halves[i]]];
      if (number == none) number = out_.vertex_count++;
      out_.vertices[i] = number;
      const std::uint32_t beyond = facet[out_.mates[i]];
      shells.join(facet[i], beyond);
      if (flat_[halves[i]] == 0) out_.soup.across[i] = out_.soup.facets[beyond].plane;
    }
    std::vector<std::uint32_t> shell_numbers(out_.soup.facets.size(), none);
    out_.shells.resize(out_.soup.facets.size());
    for (std::size_t f = 0; f < out_.shells.size(); ++f) {
      std::uint32_t& number = shell_numbers[shells.root(f)];
      if (number == none) number = out_.shell_count++;
      out_.shells[f] = number;
    }
  }

  const Soup& soup_;
  const Cells& cells_;
  const Fans& fans_;
  const Sides& sides_;
  const std::vector<char>& inside_;
  std::vector<char> kept_, turned_, gone_, flat_, straight_;
  std::vector<std::uint32_t> name_, mate_, next_, previous_, face_, vertex_, degree_;
  std::vector<PointId> origin_;
  bool touches_ = false;
  Boundary out_;
};

}  // namespace

Boundary assemble(const Soup& soup, const Contacts& contacts, const Cells& cells, const Fans& fans, const Sides& sides,
                  const std::vector<char>& inside, std::vector<std::string> names) {
  return Assembly(soup, cells, fans, sides, inside).run(contacts, std::move(names));
}

}  // namespace dobra::solid
