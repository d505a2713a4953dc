#include "recon/core/carry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/input.h"
#include "recon/core/percent.h"

namespace recon::core {

namespace {

/// Beyond this part of the line's and its image's box the way back counts as another way.
constexpr double return_tolerance = 1e-9;

geom::Point through(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Point p) {
  for (; from < to; ++from) p = chain[from]->restoration->map.forward(p).at;
  for (; from > to; --from) p = chain[from - 1]->restoration->map.inverse(p);
  return p;
}

base::Result<std::size_t> state_of(int number, std::size_t restored, const char* key) {
  if (number >= 0 && static_cast<std::size_t>(number) <= restored) return static_cast<std::size_t>(number);
  return base::Error{base::ErrorCode::BadValue,
                     fmt::format("{} = {}: the section has been restored {} times, so take a state from 0 to {}", key,
                                 number, restored, restored)};
}

CarriedLine carried_line(const std::vector<const Stage*>& chain, const CarriedLines& states, geom::Polyline line) {
  if (line.points.size() > 3 && line.points.front() == line.points.back()) {
    line.points.pop_back();
    line.closed = true;
  }
  CarriedLine carried;
  for (const geom::Point p : line.points) carried.points.push_back(carry(chain, states.from, states.to, p));
  carried.after = line.points.size() < 2 ? geom::Polyline{{carried.points.front().at}, false}
                                         : carry(chain, states.from, states.to, line);
  carried.before = std::move(line);
  return carried;
}

/// What is not to be taken for certain of a line.
void remark_on(const CarriedLine& line, std::vector<std::string>& remarks) {
  const auto worst = std::max_element(line.points.begin(), line.points.end(),
                                      [](const CarriedPoint& a, const CarriedPoint& b) { return a.misses < b.misses; });
  const double size = std::max(line.before.box().diagonal(), line.after.box().diagonal()) +
                      geom::distance(line.before.points.front(), {});
  if (worst->misses <= return_tolerance * size) return;
  const auto count = std::count_if(line.points.begin(), line.points.end(),
                                   [&](const CarriedPoint& p) { return p.misses > return_tolerance * size; });
  const geom::Point at = line.before.points[static_cast<std::size_t>(worst - line.points.begin())];
  remarks.push_back(
      fmt::format("{} points are carried where a map is not single-valued: the way back misses them, most ({:.6g}, "
                  "{:.6g}) by {:.4g} m",
                  count, at.x, at.y, worst->misses));
}

const Section& section_of(const std::vector<const Stage*>& chain, std::size_t state) {
  return state < chain.size() ? chain[state]->section : chain.back()->restoration->section;
}

/// Beyond the section nothing but the straight continuation of its grid tells where a point goes.
void remark_outside(const CarriedLine& line, const Section& section, std::vector<std::string>& remarks) {
  const geom::Box box = box_of(section);
  const auto outside = [&](geom::Point p) {
    return p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y;
  };
  const std::vector<geom::Point>& points = line.before.points;
  const auto first = std::find_if(points.begin(), points.end(), outside);
  if (first == points.end()) return;
  remarks.push_back(fmt::format("{} points that are carried lie outside the section, the first at ({:.6g}, {:.6g})",
                                std::count_if(points.begin(), points.end(), outside), first->x, first->y));
}

/// Rows of `first` and `last` that have the same name and are in every stage between.
template <class Row, class Measure>
void join_rows(const std::vector<Row>& first, const std::vector<Row>& last, Measure measure,
               std::vector<Compared>& joined) {
  for (const Row& row : first) {
    const auto found = std::find_if(last.begin(), last.end(), [&](const Row& other) { return other.name == row.name; });
    if (found == last.end()) continue;
    const auto [before, after] = measure(row, *found);
    if (before > 0.0) joined.push_back({row.name, before, after, row.role});
  }
}

}  // namespace

CarriedPoint carry(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Point p) {
  const geom::Point at = through(chain, from, to, p);
  return {at, geom::distance(through(chain, to, from, at), p)};
}

geom::Polyline carry(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Polyline line) {
  for (; from < to; ++from) line = chain[from]->restoration->map.forward(line).after;
  for (; from > to; --from) line = chain[from - 1]->restoration->map.swapped().forward(line).after;
  return line;
}

base::Result<CarriedLines> carry_lines(const std::vector<const Stage*>& chain, const CarryParams& params,
                                       const dobra::scenario::Context& context) {
  CarriedLines carried;
  DOBRA_TRY(carried.from, state_of(params.from, chain.size(), "from"));
  DOBRA_TRY(carried.to, params.to ? state_of(*params.to, chain.size(), "to") : base::Result(chain.size()));
  if (carried.from == carried.to) {
    return base::Error{base::ErrorCode::BadValue,
                       fmt::format("from and to are both state {}; nothing lies between them", carried.from)};
  }
  HorizonInput input;
  input.name = "line";
  input.file = params.file;
  input.feature = params.feature;
  input.points = params.points;
  const Convention convention = params.file.empty() ? Convention{} : chain.front()->section.convention;
  if (params.file.empty() && (params.points.size() == 1 || params.as == CarryAs::Points)) {
    for (const geom::Point p : params.points) carried.lines.push_back(carried_line(chain, carried, {{p}, false}));
  } else {
    DOBRA_TRY(ReadPieces read, read_pieces(input, {.convention = convention}, context));
    carried.remarks = std::move(read.remarks);
    for (geom::Polyline& piece : read.pieces) carried.lines.push_back(carried_line(chain, carried, std::move(piece)));
  }
  for (const CarriedLine& line : carried.lines) {
    remark_on(line, carried.remarks);
    remark_outside(line, section_of(chain, carried.from), carried.remarks);
  }
  return carried;
}

ChainVerdict judge(const Comparison& comparison, double tolerance) {
  const auto worst = [](const std::vector<Compared>& rows) {
    const Compared* found = nullptr;
    for (const Compared& row : rows) {
      if (row.role != BedRole::Judged) continue;
      if (found == nullptr || std::abs(row.change_percent()) > std::abs(found->change_percent())) found = &row;
    }
    return found;
  };
  ChainVerdict verdict{false, worst(comparison.beds), worst(comparison.units)};
  const auto within = [&](const Compared* row) {
    return row == nullptr || std::abs(row->change_percent()) <= tolerance;
  };
  verdict.balanced = within(verdict.bed) && within(verdict.unit);
  return verdict;
}

Comparison compare(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to) {
  const Restoration& first = *chain[from]->restoration;
  const Restoration& last = *chain[to - 1]->restoration;
  Comparison comparison;
  join_rows(
      first.lengths, last.lengths,
      [](const LineLength& a, const LineLength& b) { return std::pair(a.length_before, b.length_after); },
      comparison.beds);
  join_rows(
      first.ledger.units, last.ledger.units,
      [](const UnitRow& a, const UnitRow& b) { return std::pair(a.area_before, b.area_after); }, comparison.units);
  return comparison;
}

std::string verdict_since_input(const std::vector<const Stage*>& chain) {
  if (chain.size() < 2) return {};
  const double tolerance = chain.back()->restoration->params.tolerance;
  const Comparison whole = compare(chain, 0, chain.size());
  const ChainVerdict verdict = judge(whole, tolerance);
  std::string text = fmt::format("since the input: {}", verdict.balanced ? "balanced" : "not balanced");
  if (verdict.bed != nullptr) {
    text += fmt::format(": the greatest change of a bed's length is {} % (horizon '{}')",
                        percent_text(std::abs(verdict.bed->change_percent())), verdict.bed->name);
  }
  if (verdict.unit != nullptr) {
    text += fmt::format(", of a unit's area {} % ('{}')", percent_text(std::abs(verdict.unit->change_percent())),
                        verdict.unit->name);
  }
  return text + fmt::format("; the tolerance is {:.4g} %", tolerance);
}

}  // namespace recon::core
