#include "recon/jigsaw/unfold_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

/// x of the place of the top, from its middle outwards, where a pin line meets most beds and is least askew.
base::Result<double> middle_pin(const Section& section, const unfold::SourceGrid& source) {
  DOBRA_TRY(const maps::Columns columns, maps::Columns::along(source.base));
  const std::vector<double> arcs = geom::arc_lengths(source.base);
  constexpr int places = 16;
  double best = 0.5;
  std::pair least(section.horizons.size(), std::numbers::pi);
  for (int k = 0; k <= places && least > std::pair(std::size_t{0}, unfold::askew_tolerance); ++k) {
    const double part = 0.5 + (k % 2 == 0 ? -1.0 : 1.0) * 0.5 * ((k + 1) / 2) / (places / 2 + 1);
    const std::size_t off =
        missed(section, source.top, columns, source.side == section::LayerSide::Below, part * arcs.back());
    const double askew = std::max(unfold::askew_tolerance, unfold::askew_at(source.base, arcs, part * arcs.back()));
    if (std::pair(off, askew) >= least) continue;
    least = {off, askew};
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

/// One standard deviation of the picks of a line about a smooth curve, m: by the median change of how far each stands
/// off the chord of its neighbours, to which bends and corners hardly add.
double noise_of(const std::vector<geom::Point>& points) {
  std::vector<double> off;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const geom::Vector chord = geom::normalised(points[i + 1] - points[i - 1]);
    off.push_back(geom::cross(chord, points[i] - points[i - 1]));
  }
  std::vector<double> changes;
  for (std::size_t i = 1; i < off.size(); ++i) changes.push_back(std::abs(off[i] - off[i - 1]));
  if (changes.size() < 3) return 0.0;
  const auto middle = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2);
  std::nth_element(changes.begin(), middle, changes.end());
  return *middle / (0.6745 * std::sqrt(5.0));  // of normal noise, independent from pick to pick
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
  if (place.target != nullptr) {
    target.shape = unfold::TargetShape::Line;
    target.points = place.target->line().points;
    target.target_pin = place.target_pin;
  } else {
    target.elevation = place.datum;
  }
  DOBRA_TRY(const unfold::Target flat, place_target(own.section, source, target, {}));
  block.part = index;
  block.id = part.id;
  block.name = part.name;
  block.horizons = std::move(own.horizons);
  block.top = top_id;
  block.side = source.side;
  block.pin = flat.source_pin;
  block.datum = flat.target_pin.y;
  block.noise = noise_of(top.line.points);
  // The columns at a wall are as steep as a segment of the top has them.
  block.lean =
      block.noise * std::numbers::sqrt2 * static_cast<double>(top.line.segment_count()) / geom::length(top.line);
  DOBRA_TRY(block.restoration, restore(own.section, source, flat, params, progress));
  std::vector<std::string>& remarks = block.restoration.remarks;
  remarks.resize(remarks.size() - 2);  // what the method keeps, and the verdict: said of all blocks together
  remarks.insert(remarks.end(), flat.remarks.begin(), flat.remarks.end());
  for (std::string& remark : remarks) remark = fmt::format("block '{}': {}", block.name, remark);
  return block;
}

}  // namespace

geom::Point UnfoldedBlock::forward(geom::Point p) const { return placed.forward(restoration.map.forward(p).at); }

geom::Point UnfoldedBlock::inverse(geom::Point p) const { return restoration.map.inverse(placed.inverse(p)); }

geom::Polyline UnfoldedBlock::forward(const geom::Polyline& line) const {
  return placed.forward(restoration.map.forward(line).after);
}

geom::Polyline UnfoldedBlock::inverse(const geom::Polyline& line) const {
  return restoration.map.swapped().forward(placed.inverse(line)).after;
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

base::Result<UnfoldedBlock> rigid_block(const CutSection& cut, const Part& part, std::size_t index, std::size_t bed,
                                        const unfold::RestoreParams& params) {
  UnfoldedBlock block;
  BlockSection own = section_of(cut, index);
  const geom::Box box = box_of(own.section);
  const double beyond = box.width() + box.height();
  // Sheared from a level line onto itself nothing moves.
  unfold::SourceGrid source;
  source.top = cut.section.horizons[bed].id;
  source.ends = unfold::EndsOfTop::AtFaults;
  source.base = {{{box.low.x - beyond, box.high.y}, {box.high.x + beyond, box.high.y}}, false};
  unfold::TargetParams target;
  target.pin = box.centre().x;
  DOBRA_TRY(const unfold::Target flat, place_target(own.section, source, target, {}));
  unfold::RestoreParams stiff = params;
  stiff.method = unfold::RestoreMethod::Shear;
  stiff.angle = {};
  DOBRA_TRY(block.restoration, restore(own.section, source, flat, stiff, {}));
  block.restoration.remarks.clear();           // of a top and its shear
  block.restoration.balance.consistency = {};  // nothing is unfolded
  block.part = index;
  block.id = part.id;
  block.name = part.name;
  block.horizons = std::move(own.horizons);
  block.top = source.top;
  block.pin = box.centre();
  block.datum = std::numeric_limits<double>::infinity();
  return block;
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
