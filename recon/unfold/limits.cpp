#include "recon/unfold/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/geom/place.h"

namespace recon::unfold {

namespace {

base::Result<void> refuse_line(const std::string& item, const std::vector<geom::Point>& before,
                               const std::vector<geom::Point>& after) {
  const auto lost = std::find_if(after.begin(), after.end(), [](geom::Point p) { return !geom::is_finite(p); });
  if (lost == after.end()) return {};
  const auto index = std::min(static_cast<std::size_t>(lost - after.begin()), before.size() - 1);
  return base::Error{base::ErrorCode::CannotRestore, "the map has no finite value here; choose another method",
                     place_at(before[index], item)};
}

/// A method that takes the section without a doubt, in the words of a scenario and of the command line.
std::string method_that_works(const section::Section& section, const SourceGrid& source, const Target& target,
                              RestoreParams params) {
  struct Choice {
    RestoreMethod method;
    SlipBeds beds;
    const char* words;
  };
  constexpr std::array choices{
      Choice{RestoreMethod::Flexural, SlipBeds::Parallel,
             "flexural slip with parallel beds (--method flexural --beds parallel)"},
      Choice{RestoreMethod::Flexural, SlipBeds::Horizons, "flexural slip (--method flexural)"},
      Choice{RestoreMethod::LineLength, SlipBeds::Horizons, "line length (--method line_length)"},
      Choice{RestoreMethod::Shear, SlipBeds::Horizons, "vertical shear (--method shear)"}};
  params.outside = Doubt::Refuse;
  params.angle = {};
  for (const Choice& choice : choices) {
    params.method = choice.method;
    params.beds = choice.beds;
    if (restore(section, source, target, params, {})) return fmt::format("{} restores this section", choice.words);
  }
  return "a top with fewer points may help (--simplify)";
}

/// The worst place, by the factor.
struct Worst {
  double factor = greatest_factor;
  std::string what;
  base::Place place;

  void add(double value, const std::string& text, const base::Place& at) {
    // What is turned over is worse than any factor.
    const double change = value > 0.0 ? std::max(value, 1.0 / value) : 1e12 * (1.0 - value);
    if (!(change > factor)) return;
    factor = change;
    what = text;
    place = at;
  }
};

/// Where a restored bed is stretched most (or least).
geom::Point most_changed(const maps::MappedLine& line, bool longer) {
  geom::Point place = line.before.points.front();
  double most = 0.0;
  for (std::size_t i = 0; i < line.before.segment_count(); ++i) {
    const double before = line.before.segment(i).length();
    const double after = line.after.segment(i).length();
    const double change = longer ? after / before : before / after;
    if (!(before > 0.0) || !(change > most)) continue;
    most = change;
    place = geom::midpoint(line.before.segment(i).from, line.before.segment(i).to);
  }
  return place;
}

}  // namespace

base::Result<void> refuse_not_finite(const section::Section& section, const Restoration& restoration) {
  for (std::size_t i = 0; i < restoration.lines.size(); ++i) {
    DOBRA_TRY_VOID(refuse_line(fmt::format("horizon '{}'", section.horizons[i].name),
                               restoration.lines[i].before.points, restoration.lines[i].after.points));
  }
  for (std::size_t i = 0; i < section.units.size(); ++i) {
    DOBRA_TRY_VOID(refuse_line(fmt::format("unit '{}'", section.units[i].name), section.units[i].contour.points,
                               restoration.ledger.units[i].contour_after.points));
  }
  const section::Section& after = restoration.section;
  for (const section::SectionLine& line : after.lines) {
    const auto given = std::find_if(section.lines.begin(), section.lines.end(),
                                    [&](const section::SectionLine& other) { return other.id == line.id; });
    DOBRA_TRY_VOID(
        refuse_line(fmt::format("{} '{}'", kind_name(line.kind), line.name), given->line.points, line.line.points));
  }
  for (std::size_t i = 0; i < after.markers.size(); ++i) {
    DOBRA_TRY_VOID(refuse_line(fmt::format("marker '{}'", section.markers[i].name), section.markers[i].points,
                               after.markers[i].points));
  }
  return {};
}

base::Result<void> refuse_beyond_limits(const section::Section& section, const SourceGrid& source, const Target& target,
                                        const Restoration& restoration) {
  if (restoration.params.method != RestoreMethod::Variable) return {};
  Worst worst;
  for (const balance::UnitRow& row : restoration.ledger.units) {
    if (!row.dilatation) continue;
    const std::string item = fmt::format("unit '{}'", row.name);
    for (const auto& [change, at] :
         {std::pair(row.dilatation->least, row.least_at), std::pair(row.dilatation->greatest, row.greatest_at)})
      worst.add(1.0 + change, fmt::format("det F is {:.4g} here", 1.0 + change), place_at(at, item));
  }
  for (std::size_t i = 0; i < restoration.lengths.size(); ++i) {
    const balance::LineLength& row = restoration.lengths[i];
    worst.add(
        row.length_after / row.length_before,
        fmt::format("the bed's length changes by {:.4g} %, most here", row.change_percent),
        place_at(most_changed(restoration.lines[i], row.change_percent > 0.0), fmt::format("horizon '{}'", row.name)));
  }
  if (worst.what.empty()) return {};
  return base::Error{
      base::ErrorCode::CannotRestore,
      fmt::format("variable thickness is beyond its limits: {}, and areas and lengths may change by a factor of {} at "
                  "most; {}; outside = \"nearest\" (--outside nearest) goes on all the same",
                  worst.what, greatest_factor, method_that_works(section, source, target, restoration.params)),
      worst.place};
}

}  // namespace recon::unfold
