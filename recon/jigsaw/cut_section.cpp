#include "recon/jigsaw/cut_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/moving/block_area.h"
#include "recon/moving/piece_names.h"
#include "shared/base/parallel.h"

namespace recon::jigsaw {

namespace {

using moving::Fate;
using moving::LinePart;
using section::Section;

/// Whether a line can have anything in a block.
bool can_reach(const geom::Polyline& line, const Part& part) { return line.box().overlaps(part.within); }

/// What of a contour lies on one side of a level (or upright) line, in the box round it at least.
std::vector<geom::Point> beyond(const std::vector<geom::Point>& ring, double geom::Point::*axis, double level,
                                double sign) {
  std::vector<geom::Point> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geom::Point a = ring[i];
    const geom::Point b = ring[(i + 1) % ring.size()];
    const double at_a = sign * (a.*axis - level);
    const double at_b = sign * (b.*axis - level);
    if (at_a >= 0.0) kept.push_back(a);
    if ((at_a >= 0.0) != (at_b >= 0.0)) kept.push_back(geom::interpolate(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

/// Round what of the contours lies in a box.
geom::Box box_within(const std::vector<geom::Polyline>& contours, const geom::Box& box) {
  geom::Box within;
  for (const geom::Polyline& contour : contours) {
    std::vector<geom::Point> ring = beyond(contour.points, &geom::Point::x, box.low.x, 1.0);
    ring = beyond(ring, &geom::Point::x, box.high.x, -1.0);
    ring = beyond(ring, &geom::Point::y, box.low.y, 1.0);
    for (const geom::Point p : beyond(ring, &geom::Point::y, box.high.y, -1.0)) within.add(p);
  }
  return within;
}

bool in_any(const std::vector<PartOfLine>& pieces) {
  return std::any_of(pieces.begin(), pieces.end(), [](const PartOfLine& piece) { return piece.part.has_value(); });
}

bool in_all(const std::vector<PartOfLine>& pieces) {
  return std::all_of(pieces.begin(), pieces.end(), [](const PartOfLine& piece) { return piece.part.has_value(); });
}

/// The blocks one after the other take their share of what no block has.
/// @param share  of a line and a block: parts.
template <class Share>
base::Result<std::vector<PartOfLine>> shared_out(const geom::Polyline& line, std::size_t blocks, Share share) {
  std::vector<PartOfLine> pieces{{line, {}, 0.0}};
  for (std::size_t block = 0; block < blocks; ++block) {
    std::vector<PartOfLine> next;
    for (PartOfLine& piece : pieces) {
      if (piece.part) {
        next.push_back(std::move(piece));
        continue;
      }
      DOBRA_TRY(std::vector<LinePart> parts, share(piece.line, block));
      for (LinePart& part : parts) {
        const bool taken = part.fate == Fate::Moves;
        next.push_back({std::move(part.line), taken ? std::optional(block) : std::nullopt, part.trimmed});
      }
    }
    pieces = std::move(next);
  }
  return pieces;
}

/// An item becomes its first piece; the others stand at the end, with names of their own.
template <class Item, class SetLine>
void distribute(std::vector<PartOfLine> pieces, SetLine set_line, moving::PieceNames& names, std::size_t index,
                std::vector<Item>& items, std::vector<Origin>& origins) {
  const bool several = pieces.size() > 1;
  const std::string whole = items[index].piece_of.empty() ? items[index].name : items[index].piece_of;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (k > 0) {
      items.push_back(items[index]);
      origins.push_back({index, {}});
    }
    const std::size_t at = k == 0 ? index : items.size() - 1;
    if (several && (k > 0 || items[at].piece_of.empty())) items[at].name = names.next(whole);
    if (several) items[at].piece_of = whole;
    if (k > 0) items[at].id = decltype(items[at].id)(names.next_id());
    set_line(items[at], std::move(pieces[k].line));
    origins[at].part = pieces[k].part;
  }
}

std::vector<Origin> origins_of(std::size_t count) {
  std::vector<Origin> origins(count);
  for (std::size_t i = 0; i < count; ++i) origins[i].index = i;
  return origins;
}

void cut_horizons(const Section& section, const std::vector<Part>& parts,
                  const std::vector<faults::FaultCutoffs>& cutoffs, double overshoot, CutSection& made) {
  const double rounding = 1e-8 * box_of(section).diagonal();
  const auto pieces = base::parallel_map<std::vector<PartOfLine>>(section.horizons.size(), [&](std::size_t i) {
    section::Horizon reached = section.horizons[i];
    reach_faults(cutoffs, 0.0, reached);
    std::vector<PartOfLine> of_reached = split(reached.line, parts, overshoot);
    return in_all(of_reached) ? of_reached : split(section.horizons[i].line, parts, overshoot);
  });
  moving::PieceNames names(section.horizons);
  made.horizons = origins_of(section.horizons.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!in_any(pieces[i])) continue;
    for (const PartOfLine& piece : pieces[i]) {
      if (piece.trimmed > rounding) {
        made.remarks.push_back(fmt::format("horizon '{}': {:.4g} m that reached across the fault were cut off",
                                           section.horizons[i].name, piece.trimmed));
      }
    }
    distribute(
        pieces[i], [](section::Horizon& item, geom::Polyline line) { item.line = std::move(line); }, names, i,
        made.section.horizons, made.horizons);
  }
}

void cut_lines(const Section& section, const std::vector<Part>& parts, const std::vector<section::LineId>& boundary,
               double overshoot, CutSection& made) {
  moving::PieceNames names(section.lines);
  made.lines = origins_of(section.lines.size());
  for (std::size_t i = 0; i < section.lines.size(); ++i) {
    const section::SectionLine& line = section.lines[i];
    if (line.kind == section::LineKind::Datum) continue;
    if (std::find(boundary.begin(), boundary.end(), line.id) != boundary.end()) continue;
    std::vector<PartOfLine> pieces = split(line.line, parts, overshoot);
    if (!in_any(pieces)) continue;
    distribute(
        std::move(pieces), [](section::SectionLine& item, geom::Polyline piece) { item.line = std::move(piece); },
        names, i, made.section.lines, made.lines);
  }
}

base::Result<void> cut_units(const Section& section, const std::vector<Part>& parts, CutSection& made) {
  moving::PieceNames names(section.units);
  made.units = origins_of(section.units.size());
  for (std::size_t i = 0; i < section.units.size(); ++i) {
    DOBRA_TRY(std::vector<PartOfLine> pieces,
              shared_out(section.units[i].contour, parts.size(),
                         [&](const geom::Polyline& contour, std::size_t block) -> base::Result<std::vector<LinePart>> {
                           if (!can_reach(contour, parts[block])) return std::vector{LinePart{contour}};
                           return parts[block].area.split_area(contour);
                         }));
    if (!in_any(pieces)) continue;
    distribute(
        std::move(pieces), [](section::Unit& item, geom::Polyline contour) { item.contour = std::move(contour); },
        names, i, made.section.units, made.units);
  }
  return {};
}

}  // namespace

base::Result<std::vector<Part>> parts_of(const Section& section, const std::vector<faults::Fault>& faults,
                                         const faults::Blocks& blocks, std::span<const faults::BlockId> chosen) {
  const double size = box_of(section).diagonal();
  std::vector<Part> parts;
  for (const faults::BlockId id : chosen) {
    const faults::Block& block = blocks.all()[id.index()];
    Part part{id, block.name, block.contours, {}, {}};
    DOBRA_TRY(const std::vector<geom::Polyline> contours,
              moving::area_of_blocks(section, faults, nullptr, std::span(&block.inside, 1)));
    DOBRA_TRY(part.area, moving::MovingPart::of_blocks(contours, size));
    part.within = box_within(part.area.contours(), box_of(section).grown(1e-6 * size)).grown(1e-6 * size);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<PartOfLine> split(const geom::Polyline& line, const std::vector<Part>& parts, double overshoot) {
  const auto share = [&](const geom::Polyline& rest, std::size_t block) -> base::Result<std::vector<LinePart>> {
    if (!can_reach(rest, parts[block])) return std::vector{LinePart{rest}};
    return parts[block].area.split(rest, overshoot);
  };
  return *shared_out(line, parts.size(), share);
}

base::Result<CutSection> cut(const Section& section, const std::vector<Part>& parts,
                             const std::vector<faults::FaultCutoffs>& cutoffs,
                             const std::vector<section::LineId>& boundary, double overshoot) {
  CutSection made;
  made.section = section;
  made.section.faces.reset();
  cut_horizons(section, parts, cutoffs, overshoot, made);
  cut_lines(section, parts, boundary, overshoot, made);
  DOBRA_TRY_VOID(cut_units(section, parts, made));
  return made;
}

}  // namespace recon::jigsaw
