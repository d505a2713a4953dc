#include "recon/jigsaw/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/balance/percent.h"

namespace recon::jigsaw {

namespace {

using section::Section;

/// Items of the block's restored section in the place of those with the same id.
template <class Item, class SetLine>
void put_back(const std::vector<Item>& restored, SetLine set_line, std::vector<Item>& items) {
  for (const Item& item : restored) {
    const auto same = [&](const Item& other) { return other.id == item.id; };
    const auto at = std::find_if(items.begin(), items.end(), same);
    if (at != items.end()) set_line(item, *at);
  }
}

void put_back_lines(const CutSection& cut, Blockwise& made) {
  Section& section = made.section;
  for (const UnfoldedBlock& block : made.blocks) {
    const section::Section& own = block.restoration.section;
    put_back(
        own.horizons,
        [&](const section::Horizon& from, section::Horizon& to) { to.line = block.placed.forward(from.line); },
        section.horizons);
    put_back(
        own.lines,
        [&](const section::SectionLine& from, section::SectionLine& to) { to.line = block.placed.forward(from.line); },
        section.lines);
    put_back(
        own.units,
        [&](const section::Unit& from, section::Unit& to) { to.contour = block.placed.forward(from.contour); },
        section.units);
  }
  for (std::size_t i = cut.lines.size(); i-- > 0;) {  // what is eroded is not restored
    const auto unfolded = [&](const UnfoldedBlock& block) { return cut.lines[i].part == block.part; };
    if (section.lines[i].kind != section::LineKind::Eroded) continue;
    if (std::any_of(made.blocks.begin(), made.blocks.end(), unfolded))
      section.lines.erase(section.lines.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// Faults become the line in the middle between their restored walls.
void put_back_faults(const std::vector<faults::Fault>& faults, Blockwise& made) {
  std::vector<section::SectionLine>& lines = made.section.lines;
  for (std::size_t i = 0; i < made.faults.size(); ++i) {
    if (made.faults[i].line.points.size() < 2) continue;
    const faults::Fault& fault = faults[i];
    for (std::size_t k = 0; k < fault.pieces.size(); ++k) {
      const auto is = [&](const section::SectionLine& line) { return line.id == fault.pieces[k]; };
      const auto at = std::find_if(lines.begin(), lines.end(), is);
      if (at == lines.end()) continue;
      if (k > 0) {
        lines.erase(at);
        continue;
      }
      at->line = made.faults[i].line;
      if (fault.pieces.size() == 1) continue;
      at->name = fault.name;
      if (fault.name == fault.whole) at->piece_of.clear();
    }
  }
}

std::vector<balance::LineLength> lengths_of(const CutSection& cut, const Blockwise& made) {
  std::vector<balance::LineLength> rows;
  for (std::size_t i = 0; i < cut.section.horizons.size(); ++i)
    rows.push_back(balance::line_length(cut.section.horizons[i], std::vector{made.section.horizons[i].line}));
  if (is_rigid(made.how)) return rows;  // no depth to a top
  for (const UnfoldedBlock& block : made.blocks) {
    for (std::size_t i = 0; i < block.horizons.size(); ++i) {
      const section::Horizon& horizon = cut.section.horizons[block.horizons[i]];
      balance::LineLength& row = rows[block.horizons[i]];
      row = block.restoration.lengths[i];
      row.name = horizon.name;
      row.piece_of = horizon.piece_of;
    }
  }
  return rows;
}

void widen(std::optional<balance::Range>& range, const std::optional<balance::Range>& more) {
  if (!more || !range) return;
  range->least = std::min(range->least, more->least);
  range->greatest = std::max(range->greatest, more->greatest);
}

/// Rows of one unit in several blocks are summed.
void add_unit(balance::UnitRow row, std::vector<balance::UnitRow>& rows) {
  const auto same = [&](const balance::UnitRow& other) { return other.name == row.name; };
  const auto at = std::find_if(rows.begin(), rows.end(), same);
  if (at == rows.end()) {
    row.thickness_before.reset();
    row.thickness_after.reset();
    rows.push_back(std::move(row));
    return;
  }
  ++at->pieces;
  at->area_before += row.area_before;
  at->area_after += row.area_after;
  at->change_percent = balance::percent(at->area_after - at->area_before, at->area_before);
  widen(at->dilatation, row.dilatation);
  if (at->dilatation) at->dilatation->mean = 0.01 * at->change_percent;
}

std::vector<balance::UnitRow> units_of(const std::vector<UnfoldedBlock>& blocks) {
  std::vector<balance::UnitRow> rows;
  for (const UnfoldedBlock& block : blocks) {
    const std::vector<section::Unit>& polygons = block.restoration.section.units;
    const std::vector<balance::UnitRow>& own = block.restoration.ledger.units;
    for (std::size_t i = 0; i < own.size(); ++i) {
      balance::UnitRow row = own[i];
      if (i < polygons.size() && !polygons[i].piece_of.empty()) row.name = polygons[i].piece_of;
      add_unit(std::move(row), rows);
    }
  }
  return rows;
}

Widths widths_of(const CutSection& cut, const Blockwise& made) {
  geom::Box before, after;
  for (const UnfoldedBlock& block : made.blocks) {
    for (std::size_t i = 0; i < cut.section.horizons.size(); ++i) {
      if (cut.section.horizons[i].id != block.top) continue;
      before.add(cut.section.horizons[i].line.box());
      after.add(made.section.horizons[i].line.box());
    }
  }
  Widths widths{before.width(), after.width(), 0.0};
  for (const RestoredFault& fault : made.faults) widths.faults += fault.shortening.value_or(0.0);
  return widths;
}

}  // namespace

void assemble(const CutSection& cut, const std::vector<faults::Fault>& faults, const faults::Blocks& blocks,
              Blockwise& made) {
  for (const faults::Block& block : blocks.all()) {
    const auto is = [&](const UnfoldedBlock& other) { return other.id == block.id; };
    const auto at = std::find_if(made.blocks.begin(), made.blocks.end(), is);
    BlockRow& row = made.rows.emplace_back(BlockRow{block.name, std::nullopt});
    if (at == made.blocks.end()) continue;
    row.shift = at->slid;
    if (!is_rigid(made.how)) continue;
    const geom::Vector moved = at->placed.forward(at->pin) - at->pin;
    row.shift = moved.x;
    row.raise = moved.y;
    row.turn = at->placed.turn * 180.0 / std::numbers::pi;
  }
  made.section = cut.section;
  made.section.faces.reset();
  made.section.border.reset();
  made.section.backdrops.clear();
  put_back_lines(cut, made);
  put_back_faults(faults, made);
  for (section::Marker& marker : made.section.markers) {
    for (geom::Point& p : marker.points) p = made.forward(p);
  }
  for (section::BlockName& name : made.section.block_names) name.at = made.forward(name.at);
  made.lengths = lengths_of(cut, made);
  made.units = units_of(made.blocks);
  made.widths = widths_of(cut, made);
}

namespace {

/// What a fault leaves open, of the smallest unfolded block that it bounds.
double opening_percent(const RestoredFault& fault, std::size_t number, const faults::Blocks& blocks,
                       const std::vector<faults::FaultWall>& walls, const Blockwise& made) {
  double smallest = 0.0;
  for (const faults::FaultWall& wall : walls) {
    const auto is = [&](const UnfoldedBlock& block) { return block.id == wall.block; };
    if (wall.fault != number || std::none_of(made.blocks.begin(), made.blocks.end(), is)) continue;
    const double area = blocks.all()[wall.block.index()].area;
    smallest = smallest > 0.0 ? std::min(smallest, area) : area;
  }
  return balance::percent(fault.opening.gap + fault.opening.overlap, smallest);
}

void judge_beds(Blockwise& made) {
  balance::Balance& balance = made.balance;
  for (const UnfoldedBlock& block : made.blocks) {
    const balance::Balance& own = block.restoration.balance;
    if (balance.worst.empty() || own.greatest_change_percent > balance.greatest_change_percent) {
      balance.greatest_change_percent = own.greatest_change_percent;
      balance.worst = own.worst;
    }
    if (balance.worst_unit.empty() || own.greatest_area_change_percent > balance.greatest_area_change_percent) {
      balance.greatest_area_change_percent = own.greatest_area_change_percent;
      balance.worst_unit = own.worst_unit;
    }
    const std::size_t compared = balance.consistency.compared + own.consistency.compared;
    if (own.consistency.compared > 0 && own.consistency.worst.percent >= balance.consistency.worst.percent)
      balance.consistency.worst = own.consistency.worst;
    balance.consistency.compared = compared;
  }
}

/// Where a cutoff stands after the restoration; nothing if its bed was not cut off there.
std::optional<geom::Point> restored(const std::optional<faults::Cutoff>& cutoff, const Blockwise& made) {
  if (!cutoff || cutoff->passes) return std::nullopt;
  const section::Horizon* bed = find_horizon(made.section, cutoff->piece);
  if (bed == nullptr || bed->role == section::BedRole::Growth) return std::nullopt;
  return cutoff->end == section::LineEnd::First ? bed->line.points.front() : bed->line.points.back();
}

/// Beds that stand at other heights on the two walls of a restored fault.
/// @param target  above which heights are meant; null: a level datum.
void judge_offsets(const std::vector<faults::FaultCutoffs>& cutoffs, const TargetLine* target, Blockwise& made) {
  const auto height = [&](geom::Point p) { return target != nullptr ? p.y - target->z(p.x) : p.y; };
  geom::Box beds;
  for (const section::Horizon& horizon : made.section.horizons) beds.add(horizon.line.box());
  for (const faults::FaultCutoffs& fault : cutoffs) {
    const bool jigsaw = std::any_of(made.faults.begin(), made.faults.end(),
                                    [&](const RestoredFault& f) { return f.name == fault.fault && f.measured; });
    for (const faults::CutoffPair& pair : fault.pairs) {
      const auto hanging = restored(pair.hanging_wall, made);
      const auto foot = restored(pair.footwall, made);
      if (!jigsaw || !hanging || !foot) continue;
      const bool rigid = is_rigid(made.how);
      const double offset = rigid ? geom::distance(*hanging, *foot) : std::abs(height(*hanging) - height(*foot));
      const double percent = balance::percent(offset, beds.height());
      if (percent > made.params.tolerance) {
        made.remarks.push_back(
            rigid ? fmt::format("the cutoffs of horizon '{}' on fault '{}' stay {:.4g} m apart, at ({:.9g}, {:.9g})",
                                pair.horizon, fault.fault, offset, foot->x, foot->y)
                  : fmt::format("horizon '{}' stands {:.4g} m higher on one wall of fault '{}' than on the "
                                "other, at ({:.9g}, {:.9g})",
                                pair.horizon, offset, fault.fault, foot->x, foot->y));
      }
      if (!made.worst_offset.empty() && percent <= made.greatest_offset_percent) continue;
      made.greatest_offset_percent = percent;
      made.worst_offset = pair.horizon;
    }
  }
}

/// The shifts are linear in what the ties ask for, and the faults speak independently.
void add_shift_errors(Blockwise& made) {
  if (made.ties.empty()) return;
  std::vector<std::string> names;
  for (const UnfoldedBlock& block : made.blocks) names.push_back(block.name);
  std::vector<std::optional<double>> variances(names.size(), 0.0);
  for (std::size_t fault = 0; fault < made.faults.size(); ++fault) {
    const std::optional<double>& error = made.faults[fault].slide_error;
    std::vector<Tie> ties = made.ties;
    for (Tie& tie : ties) tie.apart = tie.fault == fault ? 1.0 : 0.0;
    const auto moved = slide(names, made.pinned, ties);
    for (std::size_t b = 0; moved && b < names.size(); ++b) {
      const double by = (*moved)[b];
      if (std::abs(by) <= 1e-9) continue;
      variances[b] = variances[b] && error ? std::optional(*variances[b] + by * by * *error * *error) : std::nullopt;
    }
  }
  for (std::size_t b = 0; b < names.size(); ++b) {
    for (BlockRow& row : made.rows) {
      if (row.name == names[b] && variances[b]) row.shift_error = std::sqrt(*variances[b]);
    }
  }
}

}  // namespace

void judge(const faults::Blocks& blocks, const std::vector<faults::FaultWall>& walls,
           const std::vector<faults::FaultCutoffs>& cutoffs, const TargetLine* target, Blockwise& made) {
  judge_beds(made);
  judge_offsets(cutoffs, target, made);
  add_shift_errors(made);
  bool measured = false;
  for (std::size_t i = 0; i < made.faults.size(); ++i) {
    const RestoredFault& fault = made.faults[i];
    measured |= fault.measured;
    const double percent = opening_percent(fault, i, blocks, walls, made);
    if (fault.measured && (made.worst_fault.empty() || percent > made.greatest_opening_percent)) {
      made.greatest_opening_percent = percent;
      made.worst_fault = fault.name;
    }
  }
  balance::Balance& balance = made.balance;
  const double greatest =
      std::max({balance.greatest_change_percent, balance.greatest_area_change_percent,
                balance.consistency.worst.percent, made.greatest_opening_percent, made.greatest_offset_percent});
  balance.verdict = verdict_of(balance.consistency, greatest, made.params.tolerance);
  if (measured && balance.verdict == balance::BalanceVerdict::NotJudged)
    balance.verdict = balance::BalanceVerdict::Balanced;  // the walls have been compared
}

std::string verdict_text(const Blockwise& made) {
  const balance::Balance& balance = made.balance;
  std::string text = verdict_words(balance.verdict);
  const auto add = [&](fmt::string_view words, double percent, const std::string& name) {
    if (!name.empty()) text += fmt::format(fmt::runtime(words), balance::percent_text(percent), name);
  };
  add(": the greatest change of a bed's length is {} % (horizon '{}')", balance.greatest_change_percent, balance.worst);
  add(", of a unit's area {} % ('{}')", balance.greatest_area_change_percent, balance.worst_unit);
  add(", what a fault leaves open {} % of a block (fault '{}')", made.greatest_opening_percent, made.worst_fault);
  add(", the offset of a bed on a restored fault {} % of the depth (horizon '{}')", made.greatest_offset_percent,
      made.worst_offset);
  if (!is_rigid(made.how)) text += "; " + consistency_text(balance.consistency);
  return text + fmt::format("; the tolerance is {:.4g} %", made.params.tolerance);
}

}  // namespace recon::jigsaw
