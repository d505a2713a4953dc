#include "shared/solid/boolean.h"

#include <algorithm>

#include "shared/solid/assemble.h"
#include "shared/solid/gathering.h"

namespace dobra::solid {
namespace {

bool two_operands(const Soup& soup, std::span<const Cover> covers, std::uint32_t& only) {
  for (const Cover& cover : covers) {
    const std::uint32_t operand = soup.facets[cover.facet].operand;
    if (only != none && only != operand) return true;
    only = operand;
  }
  return false;
}

Contact contact_of(const Soup& soup, const Contacts& contacts, const Cells& cells, const Fans& fans,
                   const Sides& sides) {
  for (const Windings& kind : sides.kinds) {
    if (kind.size() > 1) return Contact::Volume;
  }
  for (const Cell& cell : cells.cells) {
    std::uint32_t only = none;
    if (two_operands(soup, cells.covers_of(cell), only)) return Contact::Face;
  }
  for (const std::uint32_t first : fans.first) {
    std::uint32_t only = none;
    std::uint32_t h = first;
    do {
      if (two_operands(soup, cells.covers_of(cells.cells[cells.halves[h].cell.index()]), only)) return Contact::Edge;
      h = fans.turned[h];
    } while (h != first);
  }
  std::vector<std::uint32_t> owner(soup.space.point_count(), none);
  for (const Facet& facet : soup.facets) {
    for (const PointId p : soup.corners_of(facet)) {
      std::uint32_t& only = owner[p.index()];
      if (only != none && only != facet.operand) return Contact::Vertex;
      only = facet.operand;
    }
  }
  for (const Cut& cut : contacts.cuts) {
    const std::uint32_t operand = soup.facets[cut.facet].operand;
    if (owner[cut.a.index()] != operand) return Contact::Vertex;
  }
  return Contact::Nothing;
}

}  // namespace

base::Result<Combined> combine(std::span<const Solid> operands, const Rule& rule) {
  if (operands.empty()) {
    return base::Error{base::ErrorCode::InvalidOption, "there is no solid to combine: give one at least"};
  }
  std::vector<bool> in(operands.size(), false);
  if (rule(in)) {
    return base::Error{base::ErrorCode::InvalidOption,
                       "the result would reach without end: what is outside all solids must be outside it"};
  }
  Gathering all(operands);
  const Contacts found = contacts(all.soup, all.trees);
  const Cells cells = arrange(all.soup, found);
  const Fans round = fans(all.soup, cells);
  const Sides windings = sides(all.soup, cells, round, all.trees);
  std::vector<char> inside;
  for (const Windings& kind : windings.kinds) {
    std::fill(in.begin(), in.end(), false);
    for (const auto& [operand, number] : kind) in[operand] = number > 0;
    inside.push_back(rule(in) ? 1 : 0);
  }
  const Contact contact = contact_of(all.soup, found, cells, round, windings);
  return Combined{Solid(assemble(all.soup, found, cells, round, windings, inside, std::move(all.names))), contact};
}

base::Result<Combined> combine(std::span<const Solid> operands, Operation operation) {
  return combine(operands, [operation](const std::vector<bool>& in) {
    switch (operation) {
      case Operation::Union:
        return std::find(in.begin(), in.end(), true) != in.end();
      case Operation::Intersection:
        return std::find(in.begin(), in.end(), false) == in.end();
      case Operation::Difference:
        return in[0] && std::find(in.begin() + 1, in.end(), true) == in.end();
    }
    return false;
  });
}

const char* name(Contact contact) {
  switch (contact) {
    case Contact::Nothing:
      return "nothing";
    case Contact::Vertex:
      return "vertex";
    case Contact::Edge:
      return "edge";
    case Contact::Face:
      return "face";
    case Contact::Volume:
      return "volume";
  }
  return "";
}

}  // namespace dobra::solid
