#include "shared/cli/line_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace dobra::cli {
namespace {

struct LineParams : scenario::lines::LineReading {
  std::vector<std::string> kind;
  bool order = false;
  std::optional<double> drop_duplicates, join_gaps, snap_to_faults, share_edges, slivers;

  template <class D>
  static void describe(D& d) {
    LineReading::describe_in<LineParams>(d);
    scenario::lines::LineKeys<LineParams, D> keys(d);
    keys.kind();
    keys.order();
    keys.drop_duplicates();
    keys.join_gaps();
    keys.snap_to_faults();
    keys.share_edges();
    keys.slivers();
  }
};

const std::vector<OptionOf>& reading() {
  static const std::vector<OptionOf> keys = {
      {"format", "--from"}, "columns",         "name_columns", "separator", "coordinates", "trace",
      "fold_axis",          "plane_tolerance", "y_axis",       "reference", "unit",        "exaggeration"};
  return keys;
}

const std::vector<OptionOf>& repairing() {
  static const std::vector<OptionOf> keys = {"kind",
                                             "order",
                                             {"drop_duplicates", "--duplicates"},
                                             "join_gaps",
                                             {"snap_to_faults", "--snap"},
                                             {"share_edges", "--edges"},
                                             "slivers"};
  return keys;
}

base::Error refuse(const std::string& key, const std::string& what) {
  std::string option = "--" + key;
  std::replace(option.begin(), option.end(), '_', '-');
  return {base::ErrorCode::BadUsage, fmt::format("{}: {}", key == "format" ? "--from" : option, what)};
}

}  // namespace

void LineOptions::add(CLI::App& app, Repairs repairs) {
  options_.add(app, scenario::fields_of<LineParams>(), reading());
  if (repairs == Repairs::Offered) options_.add(app, scenario::fields_of<LineParams>(), repairing());
}

base::Result<scenario::Table> LineOptions::table() const {
  scenario::Table given;
  DOBRA_TRY_VOID(options_.set(scenario::fields_of<LineParams>(), given));
  return given;
}

base::Result<io::formats::LineOptions> line_options(const scenario::Table& given) {
  const auto params = scenario::from_table<LineParams>(given);
  DOBRA_TRY(io::formats::LineOptions options, scenario::lines::line_options(params, refuse));
  DOBRA_TRY(options.kinds, scenario::lines::kind_rules(params.kind, refuse));
  if (params.order) options.repair.order = io::formats::PointOrder::AlongTheCurve;
  const auto unless_zero = [](std::optional<double> length) { return length == 0.0 ? std::nullopt : length; };
  options.repair.duplicates = unless_zero(params.drop_duplicates);
  options.repair.gaps = unless_zero(params.join_gaps);
  options.repair.snap = unless_zero(params.snap_to_faults);
  options.repair.edges = unless_zero(params.share_edges);
  options.repair.slivers = unless_zero(params.slivers);
  return options;
}

}  // namespace dobra::cli
