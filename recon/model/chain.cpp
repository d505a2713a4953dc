#include "recon/model/chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/balance/percent.h"

namespace recon::model {

namespace {

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

/// Units with all pieces that faults have cut them into: "A (1) - B (2)" is of "A - B". Moves cut them anew.
std::vector<balance::UnitRow> whole_units(const std::vector<balance::UnitRow>& rows) {
  std::vector<balance::UnitRow> wholes;
  for (const balance::UnitRow& row : rows) {
    std::string name = row.name;
    for (std::size_t open = name.find(" ("); open != std::string::npos; open = name.find(" (", open)) {
      const std::size_t behind = name.find_first_not_of("0123456789", open + 2);
      if (behind == open + 2 || behind == std::string::npos || name[behind] != ')')
        ++open;
      else
        name.erase(open, behind + 1 - open);
    }
    const auto known =
        std::find_if(wholes.begin(), wholes.end(), [&](const auto& whole) { return whole.name == name; });
    if (known == wholes.end()) {
      wholes.push_back(row);
      wholes.back().name = std::move(name);
      continue;
    }
    known->area_before += row.area_before;
    known->area_after += row.area_after;
  }
  return wholes;
}

/// Beds that moves have cut meanwhile are compared as wholes.
void join_wholes(const std::vector<balance::LineLength>& first, const std::vector<balance::LineLength>& last,
                 std::vector<Compared>& joined) {
  const std::vector<balance::LineLength> after = balance::whole_beds(last);
  for (const balance::LineLength& bed : balance::whole_beds(first)) {
    const auto known = [&](const balance::LineLength& row) {
      const bool piece = row.name == bed.name || (!bed.piece_of.empty() && row.piece_of == bed.piece_of);
      return piece && std::any_of(joined.begin(), joined.end(), [&](const auto& one) { return one.name == row.name; });
    };
    const auto same = [&](const balance::LineLength& other) { return other.name == bed.name; };
    const auto found = std::find_if(after.begin(), after.end(), same);
    if (found == after.end() || std::any_of(first.begin(), first.end(), known)) continue;
    if (bed.length_before > 0.0) joined.push_back({bed.name, bed.length_before, found->length_after, bed.role});
  }
}

}  // namespace

ChainVerdict judge(const Comparison& comparison, double tolerance) {
  const auto worst = [](const std::vector<Compared>& rows) {
    const Compared* found = nullptr;
    for (const Compared& row : rows) {
      if (row.role != section::BedRole::Judged) continue;
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
  const Stage& first = *chain[from];
  const Stage& last = *chain[to - 1];
  const bool moved =
      std::any_of(chain.begin() + static_cast<std::ptrdiff_t>(from), chain.begin() + static_cast<std::ptrdiff_t>(to),
                  [](const Stage* stage) { return stage->moved.has_value(); });
  Comparison comparison;
  join_rows(
      lengths_of(first), lengths_of(last),
      [](const balance::LineLength& a, const balance::LineLength& b) {
        return std::pair(a.length_before, b.length_after);
      },
      comparison.beds);
  join_wholes(lengths_of(first), lengths_of(last), comparison.beds);
  join_rows(
      moved ? whole_units(units_of(first)) : units_of(first), moved ? whole_units(units_of(last)) : units_of(last),
      [](const balance::UnitRow& a, const balance::UnitRow& b) { return std::pair(a.area_before, b.area_after); },
      comparison.units);
  return comparison;
}

double balance_tolerance(const std::vector<const Stage*>& chain) {
  for (auto stage = chain.rbegin(); stage != chain.rend(); ++stage) {
    if ((*stage)->restoration) return (*stage)->restoration->params.tolerance;
    if ((*stage)->blockwise) return (*stage)->blockwise->params.tolerance;
  }
  return unfold::RestoreParams{}.tolerance;
}

std::string verdict_since_input(const std::vector<const Stage*>& chain) {
  if (chain.size() < 2) return {};
  const double tolerance = balance_tolerance(chain);
  const Comparison whole = compare(chain, 0, chain.size());
  const ChainVerdict verdict = judge(whole, tolerance);
  std::string text = fmt::format("since the input: {}", verdict.balanced ? "balanced" : "not balanced");
  if (verdict.bed != nullptr) {
    text += fmt::format(": the greatest change of a bed's length is {} % (horizon '{}')",
                        balance::percent_text(std::abs(verdict.bed->change_percent())), verdict.bed->name);
  }
  if (verdict.unit != nullptr) {
    text += fmt::format(", of a unit's area {} % ('{}')",
                        balance::percent_text(std::abs(verdict.unit->change_percent())), verdict.unit->name);
  }
  return text + fmt::format("; the tolerance is {:.4g} %", tolerance);
}

}  // namespace recon::model
