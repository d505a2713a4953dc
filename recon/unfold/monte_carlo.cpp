#include "recon/unfold/monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "recon/balance/face_ledger.h"
#include "recon/unfold/picks.h"
#include "shared/base/counter_random.h"
#include "shared/base/parallel.h"

namespace recon::unfold {

namespace {

struct Name {
  std::string name;
  std::string unit;
};

/// What is drawn from: horizons, and the numbers of restoration in the order of `names`.
class Draws {
 public:
  Draws(const section::Section& section, const SourceGrid& source, const Target& target, const RestoreParams& restore,
        const MonteCarloParams& params)
      : section_(section), source_(source), target_(target), restore_(restore), params_(params) {
    for (balance::LedgerUnit& unit :
         balance::ledger_units(section, horizons_in_order(section, source, target), source.side)) {
      if (!unit.unit) units_.push_back(std::move(unit));
    }
    std::vector<geom::Polyline> contours;
    const auto add = [&](const std::string& name, const std::vector<geom::Polyline>& of_unit, section::BedRole role) {
      traced_.push_back({name, contours.size(), of_unit.size(), role});
      contours.insert(contours.end(), of_unit.begin(), of_unit.end());
    };
    for (const section::Unit& unit : section.units) add(unit.name, {unit.contour}, section::BedRole::Judged);
    for (const section::RockUnit& unit : balance::units_by_faces(section))
      add(unit.name, unit.contours, balance::role_of(section, unit));
    picks_.emplace(section, std::move(contours),
                   PickErrors{params.pick_error, params.correlation.value_or(box_of(section).width() / 20.0),
                              static_cast<std::uint64_t>(params.seed)});
    for (const char* name :
         {"shortening", "greatest_change_percent", "greatest_area_change_percent", "inconsistency_percent"}) {
      names_.push_back({name, std::string_view(name).ends_with("percent") ? "%" : "m"});
    }
    for (const section::Horizon& horizon : section.horizons) {
      names_.push_back({"horizon." + horizon.name + ".length_before", "m"});
      names_.push_back({"horizon." + horizon.name + ".length_after", "m"});
      names_.push_back({"horizon." + horizon.name + ".change_percent", "%"});
      names_.push_back({"horizon." + horizon.name + ".shortening", "m"});
      names_.push_back({"horizon." + horizon.name + ".shortening_percent", "%"});
    }
    for (const balance::LedgerUnit& unit : units_) {
      name_areas(unit.name);
      names_.push_back({"unit." + unit.name + ".thickness_mean_before", "m"});
      names_.push_back({"unit." + unit.name + ".thickness_mean_after", "m"});
    }
    for (const TracedUnit& unit : traced_) name_areas(unit.name);
  }

  [[nodiscard]] const std::vector<Name>& names() const { return names_; }

  /// The numbers of draw `number` (not a number where there is nothing to measure), and last whether it balances (not a
  /// number where that is not judged); empty if it cannot be restored.
  [[nodiscard]] std::vector<double> draw(std::uint32_t number) const {
    section::Section section;
    section.convention = section_.convention;
    section.horizons = section_.horizons;
    Picks::Draw drawn = picks_->draw(number);
    for (std::size_t h = 0; h < section.horizons.size(); ++h) section.horizons[h].line = std::move(drawn.horizons[h]);
    auto source = make_base(section, source_.params, source_.side);
    if (!source) return {};
    auto target = place_target(section, *source, target_params(number), {});
    if (!target) return {};
    RestoreParams restore = restore_;
    restore.angle = restore.angle + normal(number, angle_stream) * params_.angle_error;
    auto made = make_method_map(section, *source, *target, method_params(restore));
    if (!made) return {};
    std::vector<double> numbers = measure(section, drawn.contours, *made, target->map);
    // Only a thickness may be missing: the map has no image of a line whose other numbers are none.
    for (std::size_t k = 0; k < names_.size(); ++k) {
      if (!std::isfinite(numbers[k]) && names_[k].name.find(".thickness_") == std::string::npos) return {};
    }
    return numbers;
  }

 private:
  /// A unit that is measured by its contours.
  struct TracedUnit {
    std::string name;
    std::size_t first = 0;  ///< Of them ...
    std::size_t count = 0;  ///< ... so many.
    section::BedRole role = section::BedRole::Judged;
  };

  void name_areas(const std::string& unit) {
    names_.push_back({"unit." + unit + ".area_before", "m2"});
    names_.push_back({"unit." + unit + ".area_after", "m2"});
  }

  // Streams of random numbers beside those of the lines.
  static constexpr std::uint32_t pin_stream = 0xFFFFFFFFU;
  static constexpr std::uint32_t angle_stream = 0xFFFFFFFEU;

  [[nodiscard]] double normal(std::uint32_t number, std::uint32_t stream) const {
    return base::normal_pair({number, stream, 0, 0}, static_cast<std::uint64_t>(params_.seed))[0];
  }

  [[nodiscard]] TargetParams target_params(std::uint32_t number) const {
    TargetParams params = target_.params;
    if (params.pin) params.pin = *params.pin + params_.pin_error * normal(number, pin_stream);
    if (params.shape == TargetShape::Line) {  // as it was read: files are not read again for each draw
      params.file.clear();
      params.points = target_.line.points;
      if (source_.side == section::LayerSide::Above) std::reverse(params.points.begin(), params.points.end());
      params.direction = TargetDirection::AsGiven;
    }
    return params;
  }

  [[nodiscard]] std::vector<double> measure(const section::Section& section,
                                            const std::vector<geom::Polyline>& contours, MethodMap& method,
                                            const maps::ColumnMap& grid) const {
    const std::vector<maps::MappedLine> lines = map_horizons(method, section, grid);
    std::vector<double> numbers(4);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const section::Horizon& horizon = section.horizons[i];
      const balance::LineLength row = balance::line_length(horizon, lines[i]);
      if (horizon.id == source_.top) numbers[0] = row.shortening;
      if (row.role == section::BedRole::Judged) numbers[1] = std::max(numbers[1], std::abs(row.change_percent));
      numbers.insert(numbers.end(),
                     {row.length_before, row.length_after, row.change_percent, row.shortening, row.shortening_percent});
    }
    const auto add = [&](const balance::UnitAreas& areas, section::BedRole role) {
      numbers.insert(numbers.end(), {areas.before, areas.after});
      if (role != section::BedRole::Judged) return;
      numbers[2] = std::max(numbers[2], 100.0 * std::abs(areas.after - areas.before) / areas.before);
    };
    const auto thickness = [](const geom::Polyline& upper, const geom::Polyline& lower) {
      const std::optional<balance::Range> range = balance::thickness_between(upper, lower);
      return range ? range->mean : std::numeric_limits<double>::quiet_NaN();
    };
    for (const balance::LedgerUnit& unit : units_) {
      const maps::MappedLine& upper = lines[*unit.upper];
      const maps::MappedLine& lower = lines[*unit.lower];
      add(balance::areas_between(upper, lower, method.map_of_ends()),
          balance::role_of(section, unit.upper, unit.lower));
      numbers.insert(numbers.end(), {thickness(upper.before, lower.before), thickness(upper.after, lower.after)});
    }
    for (const TracedUnit& unit : traced_) {
      const std::span of_unit = std::span(contours).subspan(unit.first, unit.count);
      add({balance::area_of(of_unit), balance::area_of(balance::images_of(of_unit, method.map))}, unit.role);
    }
    const balance::Consistency consistency = balance::consistency_of(section.horizons);
    numbers[3] = consistency.worst.percent;
    const balance::BalanceVerdict verdict =
        verdict_of(consistency, std::max({numbers[1], numbers[2], numbers[3]}), restore_.tolerance);
    numbers.push_back(verdict == balance::BalanceVerdict::NotJudged  ? std::numeric_limits<double>::quiet_NaN()
                      : verdict == balance::BalanceVerdict::Balanced ? 1.0
                                                                     : 0.0);
    return numbers;
  }

  const section::Section& section_;
  const SourceGrid& source_;
  const Target& target_;
  const RestoreParams& restore_;
  const MonteCarloParams& params_;
  std::vector<balance::LedgerUnit> units_;  ///< Between two horizons.
  std::vector<TracedUnit> traced_;          ///< Polygons, or faces.
  std::optional<Picks> picks_;
  std::vector<Name> names_;
};

/// @param values sorted.
double quantile(const std::vector<double>& values, double part) {
  const double place = part * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const double t = place - static_cast<double>(low);
  return low + 1 < values.size() ? (1.0 - t) * values[low] + t * values[low + 1] : values[low];
}

Spread spread_of(const Name& name, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  Spread spread{name.name, name.unit};
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  spread.low = quantile(values, 0.025);
  spread.median = quantile(values, 0.5);
  spread.high = quantile(values, 0.975);
  return spread;
}

/// @param balanced  1 or 0 of each draw that is judged.
/// @param restored  draws that could be restored.
void tell_share(const std::vector<double>& balanced, std::size_t restored, MonteCarlo& result) {
  if (balanced.size() < restored)
    result.remarks.push_back(fmt::format("{} of {} draws have nothing to judge: no two beds lie beside each other",
                                         restored - balanced.size(), restored));
  if (balanced.empty()) return;
  result.balanced_share = std::accumulate(balanced.begin(), balanced.end(), 0.0) / static_cast<double>(balanced.size());
  result.remarks.push_back(
      fmt::format("{:.4g} % of {} draws balance", 100.0 * *result.balanced_share, balanced.size()));
}

}  // namespace

base::Result<MonteCarlo> monte_carlo(const section::Section& section, const SourceGrid& source, const Target& target,
                                     const RestoreParams& restore, const MonteCarloParams& params,
                                     const base::Progress& progress) {
  const Draws draws(section, source, target, restore, params);
  const auto count = static_cast<std::size_t>(params.draws);
  std::mutex reporting;
  std::size_t done = 0;
  const auto rows = base::parallel_map<std::vector<double>>(
      count,
      [&](std::size_t i) {
        if (progress.cancelled()) return std::vector<double>{};
        std::vector<double> row = draws.draw(static_cast<std::uint32_t>(i));
        const std::lock_guard lock(reporting);
        if (++done % 64 == 0) progress.report(static_cast<double>(done) / static_cast<double>(count), "draws");
        return row;
      },
      8);
  DOBRA_TRY_VOID(progress.check());
  MonteCarlo result;
  result.params = params;
  std::vector<std::vector<double>> columns(draws.names().size() + 1);
  for (const std::vector<double>& row : rows) {
    if (row.empty()) ++result.failed;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!std::isnan(row[k])) columns[k].push_back(row[k]);
    }
  }
  if (result.failed == count) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("none of {} draws could be restored; are the errors larger than the section allows?", count)};
  }
  for (std::size_t k = 0; k < draws.names().size(); ++k) {
    if (columns[k].empty()) continue;
    result.spreads.push_back(spread_of(draws.names()[k], std::move(columns[k])));
  }
  if (result.failed > 0)
    result.remarks.push_back(
        fmt::format("{} of {} draws could not be restored and are not counted", result.failed, count));
  tell_share(columns.back(), count - result.failed, result);
  progress.report(1.0, "draws");
  return result;
}

}  // namespace recon::unfold
