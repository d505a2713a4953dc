#include "recon/jigsaw/unfold_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/unfold/pin_line.h"
#include "shared/geom/place.h"

namespace recon::jigsaw {

namespace {

using section::Section;

/// Of the block's beds, the side of the top on which most lie.
section::LayerSide side_of(const Section& section, const std::string& top, const maps::Columns& columns) {
  int below = 0;
  for (const section::Horizon& horizon : section.horizons) {
    if (whole_name(horizon) == top) continue;
    const double depth = columns.locate(horizon.line.points[horizon.line.points.size() / 2], 0.0, {}).at.depth;
    below += depth > 0.0 ? 1 : depth < 0.0 ? -1 : 0;
  }
  return below < 0 ? section::LayerSide::Above : section::LayerSide::Below;
}

/// How many of the block's beds a pin line misses.
std::size_t missed(const Section& section, section::HorizonId top, const maps::Columns& columns, bool below,
                   double arc) {
  const unfold::PinLine pin(columns, arc);
  std::size_t count = 0;
  for (const section::Horizon& horizon : section.horizons) {
    if (horizon.id == top) continue;
    const geom::Polyline line = below ? horizon.line : geom::reversed(horizon.line);
    count += pin.meets(line, geom::arc_lengths(line)) ? 0U : 1U;
  }
  return count;
}

/// x of the place of the top, from its middle outwards, where a pin line meets most beds.
base::Result<double> middle_pin(const Section& section, const unfold::SourceGrid& source) {
  DOBRA_TRY(const maps::Columns columns, maps::Columns::along(source.base));
  const std::vector<double> arcs = geom::arc_lengths(source.base);
  constexpr int places = 16;
  double best = 0.5;
  std::size_t least = section.horizons.size();
  for (int k = 0; k <= places && least > 0; ++k) {
    const double part = 0.5 + (k % 2 == 0 ? -1.0 : 1.0) * 0.5 * ((k + 1) / 2) / (places / 2 + 1);
    const std::size_t off =
        missed(section, source.top, columns, source.side == section::LayerSide::Below, part * arcs.back());
    if (off >= least) continue;
    least = off;
    best = part;
  }
  return geom::point_at(source.base, arcs, best * arcs.back()).x;
}

base::Result<unfold::SourceGrid> base_of(const Section& section, const section::Horizon& top, double simplify) {
  unfold::GridParams grid;
  grid.top = top.name;
  grid.simplify = simplify;
  grid.uncovered = unfold::Uncovered::Continue;
  DOBRA_TRY(const maps::Columns columns, maps::Columns::along(top.line));
  DOBRA_TRY(unfold::SourceGrid source, make_base(section, grid, side_of(section, whole_name(top), columns)));
  source.ends = unfold::EndsOfTop::AtFaults;
  return source;
}

base::Result<UnfoldedBlock> unfolded(const CutSection& cut, const Part& part, std::size_t index,
                                     const PlaceOfBlock& place, const unfold::RestoreParams& params,
                                     const base::Progress& progress) {
  UnfoldedBlock block;
  BlockSection own = section_of(cut, index);
  const section::HorizonId top_id = cut.section.horizons[place.top].id;
  const section::Horizon& top = *find_horizon(own.section, top_id);
  DOBRA_TRY(const unfold::SourceGrid source, base_of(own.section, top, place.simplify));
  unfold::TargetParams target;
  DOBRA_TRY(target.pin, place.pin ? base::Result<double>(*place.pin) : middle_pin(own.section, source));
  target.elevation = place.datum;
  DOBRA_TRY(const unfold::Target flat, place_target(own.section, source, target, {}));
  block.part = index;
  block.id = part.id;
  block.name = part.name;
  block.horizons = std::move(own.horizons);
  block.top = top_id;
  block.side = source.side;
  block.pin = flat.source_pin;
  block.datum = flat.target_pin.y;
  DOBRA_TRY(block.restoration, restore(own.section, source, flat, params, progress));
  std::vector<std::string>& remarks = block.restoration.remarks;
  remarks.resize(remarks.size() - 2);  // what the method keeps, and the verdict: said of all blocks together
  remarks.insert(remarks.end(), flat.remarks.begin(), flat.remarks.end());
  for (std::string& remark : remarks) remark = fmt::format("block '{}': {}", block.name, remark);
  return block;
}

geom::Polyline shifted(geom::Polyline line, double by) {
  for (geom::Point& p : line.points) p.x += by;
  return line;
}

}  // namespace

geom::Point UnfoldedBlock::forward(geom::Point p) const {
  return restoration.map.forward(p).at + geom::Vector{shift, 0.0};
}

geom::Point UnfoldedBlock::inverse(geom::Point p) const {
  return restoration.map.inverse(p - geom::Vector{shift, 0.0});
}

geom::Polyline UnfoldedBlock::forward(const geom::Polyline& line) const {
  return shifted(restoration.map.forward(line).after, shift);
}

geom::Polyline UnfoldedBlock::inverse(const geom::Polyline& line) const {
  return restoration.map.swapped().forward(shifted(line, -shift)).after;
}

BlockSection section_of(const CutSection& cut, std::size_t part) {
  const auto mine = [&](const Origin& origin) { return origin.part == part; };
  BlockSection own;
  for (std::size_t i = 0; i < cut.horizons.size(); ++i) {
    if (!mine(cut.horizons[i])) continue;
    own.section.horizons.push_back(cut.section.horizons[i]);
    own.horizons.push_back(i);
  }
  for (section::Horizon& horizon : own.section.horizons) {  // a bed that is whole here is called by its name
    const std::string whole = whole_name(horizon);
    const auto same = [&](const section::Horizon& other) { return whole_name(other) == whole; };
    if (std::count_if(own.section.horizons.begin(), own.section.horizons.end(), same) > 1) continue;
    horizon.name = whole;
    horizon.piece_of.clear();
  }
  for (std::size_t i = 0; i < cut.lines.size(); ++i) {
    if (mine(cut.lines[i])) own.section.lines.push_back(cut.section.lines[i]);
  }
  for (std::size_t i = 0; i < cut.units.size(); ++i) {
    if (mine(cut.units[i])) own.section.units.push_back(cut.section.units[i]);
  }
  return own;
}

base::Result<std::optional<std::size_t>> top_in(const CutSection& cut, const Part& part, std::size_t index,
                                                const std::string& top) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < cut.horizons.size(); ++i) {
    const section::Horizon& horizon = cut.section.horizons[i];
    if (cut.horizons[i].part != index || (horizon.name != top && whole_name(horizon) != top)) continue;
    if (found) {
      const geom::Point at = horizon.line.points.front();
      return base::Error{
          base::ErrorCode::CannotRestore,
          fmt::format("the top '{}' has several pieces in it, one from ({:.6g}, {:.6g}) on, so that none "
                      "of them covers the block; join them, or take another top",
                      top, at.x, at.y),
          place_at(at, fmt::format("block '{}'", part.name))};
    }
    found = i;
  }
  return found;
}

base::Result<UnfoldedBlock> unfold_block(const CutSection& cut, const Part& part, std::size_t index,
                                         const PlaceOfBlock& place, const unfold::RestoreParams& params,
                                         const base::Progress& progress) {
  auto made = unfolded(cut, part, index, place, params, progress);
  if (made) return made;
  base::Error error = made.error();
  error.message = fmt::format("block '{}': {}", part.name, error.message);
  return error;
}

}  // namespace recon::jigsaw
