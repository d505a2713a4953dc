#include "recon/cli/faults_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "recon/core/faults_step.h"
#include "recon/core/operations.h"

namespace recon::cli {

namespace {

using FaultJson = nlohmann::ordered_json;

template <class T>
FaultJson or_null(const std::optional<T>& value) {
  return value ? FaultJson(*value) : FaultJson();
}

FaultJson point_or_null(const std::optional<faults::Cutoff>& cutoff) {
  return cutoff ? FaultJson::array({cutoff->at.x, cutoff->at.y}) : FaultJson();
}

/// "left" or "right", of level faults "above" or "below"; nothing where nothing tells it.
std::optional<std::string> hanging_side(const faults::Fault& fault) {
  if (fault.undecided) return std::nullopt;
  const bool left = fault.path.hanging == kinematics::Side::Left;
  if (fault.path.level) return left ? "above" : "below";
  return left ? "left" : "right";
}

FaultJson end_json(const faults::FaultEnd& end) {
  FaultJson json{{"kind", name_of(end.kind)}, {"at", FaultJson::array({end.at.x, end.at.y})}};
  if (!end.on.empty()) json["on"] = end.on;
  return json;
}

FaultJson pair_json(const faults::CutoffPair& pair, const std::vector<faults::ProfilePoint>& profile) {
  FaultJson json{{"horizon", pair.horizon},
                 {"hanging_wall", point_or_null(pair.hanging_wall)},
                 {"footwall", point_or_null(pair.footwall)},
                 {"separation", or_null(pair.separation)},
                 {"throw", or_null(pair.throw_)},
                 {"heave", or_null(pair.heave)},
                 {"gap", or_null(pair.gap)},
                 {"overlap", or_null(pair.overlap)},
                 {"distance", pair.distance}};
  for (const faults::ProfilePoint& point : profile) {
    const bool here = pair.separation && point.horizon == pair.horizon && point.distance == pair.distance;
    if (here && point.mark != faults::ProfileMark::None) json["mark"] = name_of(point.mark);
  }
  return json;
}

FaultJson fault_json(const faults::FaultReport& report, std::size_t i) {
  const faults::Fault& fault = report.faults[i];
  FaultJson json{{"name", fault.name}};
  if (fault.name != fault.whole) json["piece_of"] = fault.whole;
  if (fault.order > 0) json["order"] = fault.order;
  json["hanging_wall"] = or_null(hanging_side(fault));
  json["sense"] = name_of(report.cutoffs[i].sense);
  json["ends"] = {{"lower", end_json(fault.lower)}, {"upper", end_json(fault.upper)}};
  json["cutoffs"] = FaultJson::array();
  for (const faults::CutoffPair& pair : report.cutoffs[i].pairs)
    json["cutoffs"].push_back(pair_json(pair, report.profiles[i]));
  return json;
}

std::string number_or_dash(const std::optional<double>& value) { return value ? fmt::format("{:.3f}", *value) : "-"; }

}  // namespace

std::string faults_json(const model::Model& model) {
  const faults::FaultReport& report = model.findings.get<core::FoundFaults>()->report;
  FaultJson json{{"tolerance", report.tolerance}, {"faults", FaultJson::array()}, {"blocks", FaultJson::array()}};
  for (std::size_t i = 0; i < report.faults.size(); ++i) json["faults"].push_back(fault_json(report, i));
  for (const faults::Block& block : report.blocks) {
    FaultJson row{{"name", block.name}, {"area", block.area}, {"faults", block.faults}};
    if (!block.part_of.empty()) row["part_of"] = block.part_of;
    json["blocks"].push_back(std::move(row));
  }
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  return json.dump(2) + '\n';
}

std::string faults_table(const model::Model& model) {
  const faults::FaultReport& report = model.findings.get<core::FoundFaults>()->report;
  std::string text = fmt::format("{:<16} {:<16} {:>15} {:>12} {:>12} {:>12}\n", "fault", "horizon", "separation [m]",
                                 "throw [m]", "heave [m]", "distance [m]");
  for (std::size_t i = 0; i < report.faults.size(); ++i) {
    for (const faults::CutoffPair& pair : report.cutoffs[i].pairs) {
      text += fmt::format("{:<16} {:<16} {:>15} {:>12} {:>12} {:>12.3f}\n", report.faults[i].name, pair.horizon,
                          number_or_dash(pair.separation), number_or_dash(pair.throw_), number_or_dash(pair.heave),
                          pair.distance);
    }
    if (report.cutoffs[i].pairs.empty()) text += fmt::format("{:<16} -\n", report.faults[i].name);
  }
  text += fmt::format("\n{:<16} {:>15}  {}\n", "block", "area [m2]", "faults");
  for (const faults::Block& block : report.blocks)
    text += fmt::format("{:<16} {:>15.6g}  {}\n", block.name, block.area, fmt::join(block.faults, ", "));
  return text;
}

}  // namespace recon::cli
