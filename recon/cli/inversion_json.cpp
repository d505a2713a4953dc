#include "recon/cli/inversion_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/core/invert_step.h"
#include "recon/core/operations.h"
#include "recon/core/predict_step.h"

namespace recon::cli {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

const inversion::Inversion& inversion_in(const model::Model& model) {
  return model.findings.get<core::FoundKinematics>()->inversion;
}

const char* limit_name(inversion::AtLimit limit) {
  return limit == inversion::AtLimit::No ? "no" : limit == inversion::AtLimit::Low ? "low" : "high";
}

Json map_json(const inversion::MisfitMap& map, const inversion::Fit& fit) {
  Json misfit = Json::array();
  for (const double rms : map.rms) misfit.push_back(number_or_null(rms));
  return {{"values", {fit.estimates[map.axes[0]].unknown.key, fit.estimates[map.axes[1]].unknown.key}},
          {"at", {map.at[0], map.at[1]}},
          {"misfit", std::move(misfit)},
          {"region", map.region}};
}

}  // namespace

std::string inversion_json(const model::Model& model) {
  const inversion::Inversion& found = inversion_in(model);
  const inversion::Fit& fit = found.fit;
  Json json = {{"method", name_of(found.params.method)}};
  Json values = Json::array();
  for (const inversion::Estimate& e : fit.estimates) {
    values.push_back({{"name", e.unknown.key},
                      {"unit", e.unknown.unit},
                      {"best", e.best},
                      {"fixed", e.unknown.fixed()},
                      {"low", number_or_null(e.low)},
                      {"high", number_or_null(e.high)},
                      {"limits", {e.unknown.low, e.unknown.high}},
                      {"at_limit", limit_name(e.at_limit)}});
  }
  json["values"] = std::move(values);
  json["confidence"] = found.params.confidence;
  json["misfit"] = fit.rms;
  json["misfit_before"] = fit.before;
  json["misfit_region"] = number_or_null(fit.region);
  json["points"] = fit.points;
  json["independent_points"] = fit.effective;
  Json beds = Json::array();
  for (const inversion::BedMisfit& bed : fit.beds) {
    beds.push_back({{"name", bed.name},
                    {"points", bed.points},
                    {"misfit_before", bed.before},
                    {"misfit", bed.after},
                    {"dip_restored", bed.dip.degrees()},
                    {"correlation", bed.correlation},
                    {"correlation_length", bed.correlation_length}});
  }
  json["beds"] = std::move(beds);
  if (found.map) json["map"] = map_json(*found.map, fit);
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  return json.dump(2) + '\n';
}

std::string inversion_table(const model::Model& model) {
  const inversion::Inversion& found = inversion_in(model);
  const inversion::Fit& fit = found.fit;
  std::string text =
      fmt::format("{}: misfit {:.5g} m (as the beds lie {:.5g} m)", name_of(found.params.method), fit.rms, fit.before);
  if (fit.region) text += fmt::format(", {:.4g} % region to {:.5g} m", found.params.confidence, *fit.region);
  text += fmt::format("\n\n{:<16} {:>12} {:>12} {:>12}   limits of the search\n", "value", "best", "low", "high");
  const auto cell = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.9g}", *value) : std::string("-");
  };
  for (const inversion::Estimate& e : fit.estimates) {
    const std::string name =
        e.unknown.unit.empty() ? e.unknown.key : fmt::format("{} [{}]", e.unknown.key, e.unknown.unit);
    text += fmt::format(
        "{:<16} {:>12.9g} {:>12} {:>12}   {}\n", name, e.best, cell(e.low), cell(e.high),
        e.unknown.fixed() ? std::string("fixed") : fmt::format("{:.9g} to {:.9g}", e.unknown.low, e.unknown.high));
  }
  text +=
      fmt::format("\n{:<28} {:>8} {:>14} {:>14} {:>14}\n", "bed", "points", "before [m]", "restored [m]", "dip [deg]");
  for (const inversion::BedMisfit& bed : fit.beds) {
    text += fmt::format("{:<28} {:>8} {:>14.5g} {:>14.5g} {:>14.4g}\n", bed.name, bed.points, bed.before, bed.after,
                        bed.dip.degrees());
  }
  return text;
}

std::string prediction_json(const model::Model& model) {
  const inversion::Predicted& found = model.findings.get<core::FoundPrediction>()->predicted;
  Json json = {{"what", name_of(*found.params.what)}};
  Json solutions = Json::array();
  for (const auto& solution : found.solutions) {
    Json figures = Json::object();
    for (const auto& [name, value] : solution) figures[name] = value;
    solutions.push_back(std::move(figures));
  }
  json["solutions"] = std::move(solutions);
  Json lines = Json::array();
  for (const inversion::Predicted::Line& line : found.lines) {
    Json points = Json::array();
    for (const geom::Point p : line.line.points) points.push_back({p.x, p.y});
    lines.push_back({{"kind", line.kind}, {"points", std::move(points)}});
  }
  json["lines"] = std::move(lines);
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  return json.dump(2) + '\n';
}

std::string prediction_table(const model::Model& model) {
  const inversion::Predicted& found = model.findings.get<core::FoundPrediction>()->predicted;
  std::string text = fmt::format("{}\n", name_of(*found.params.what));
  for (std::size_t i = 0; i < found.solutions.size(); ++i) {
    if (found.solutions.size() > 1) text += fmt::format("\nsolution {}\n", i + 1);
    for (const auto& [name, value] : found.solutions[i]) text += fmt::format("{:<32} {:>14.7g}\n", name, value);
  }
  return text;
}

}  // namespace recon::cli
