#include "quebra/analysis/fracture.h"

#include <fmt/format.h>

#include <algorithm>

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
namespace scenario = dobra::scenario;
using dobra::base::Error;
using dobra::base::ErrorCode;

/// One figure of a tip: its quantity's name, its unit, its value if it has one.
struct Figure {
  const char* name;
  const char* unit;
  std::optional<double> value;
};

std::vector<Figure> figures_of(const fem::fracture::TipResult& tip) {
  const char* const k = "Pa sqrt(m)";
  const auto one = [](const std::optional<fem::fracture::Intensity>& i) {
    return i ? std::optional(i->one) : std::nullopt;
  };
  const auto two = [](const std::optional<fem::fracture::Intensity>& i) {
    return i ? std::optional(i->two) : std::nullopt;
  };
  const auto angle = [&](fem::fracture::Kink fem::fracture::TipResult::Kinks::*kink) {
    return tip.kinks ? std::optional((*tip.kinks.*kink).angle.degrees()) : std::nullopt;
  };
  using Kinks = fem::fracture::TipResult::Kinks;
  return {{"K_I", k, tip.domain.k.one},
          {"K_II", k, tip.domain.k.two},
          {"closure.K_I", k, one(tip.closure)},
          {"closure.K_II", k, two(tip.closure)},
          {"correlation.K_I", k, one(tip.correlation)},
          {"correlation.K_II", k, two(tip.correlation)},
          {"spread", "%", tip.spread ? std::optional(100.0 * *tip.spread) : std::nullopt},
          {"J", "J/m2", tip.no_j ? std::nullopt : std::optional(tip.domain.j)},
          {"G", "J/m2", tip.release},
          {"T", "Pa", tip.domain.t_stress},
          {"contour", "m", tip.contour.outer},
          {"kink.sigma_theta", "deg", angle(&Kinks::sigma_theta)},
          {"kink.s_theta", "deg", angle(&Kinks::s_theta)},
          {"kink.g_theta", "deg", angle(&Kinks::g_theta)}};
}

/// What the user should know of the tips; of one that no load case has figures of, once.
void add_tip_remarks(const Analysis& analysis, std::vector<std::string>& remarks) {
  for (std::size_t c = 0; c < analysis.tips.size(); ++c) {
    const std::string of =
        analysis.tips.size() == 1 ? std::string() : fmt::format("load case '{}': ", analysis.problem.cases[c].name);
    for (std::size_t t = 0; t < analysis.tips[c].size(); ++t) {
      const fem::fracture::TipResult& tip = analysis.tips[c][t];
      for (const std::string& remark : tip.remarks) remarks.push_back(of + remark);
      if (!tip.refused) continue;
      const bool always = std::all_of(analysis.tips.begin(), analysis.tips.end(), [&](const auto& tips) {
        return tips[t].refused && tips[t].refused->message == tip.refused->message;
      });
      if (!always || c == 0)
        remarks.push_back(fmt::format("{}crack tip '{}' at ({:.6g}, {:.6g}) has no K: {}", always ? "" : of, tip.name,
                                      tip.at.x, tip.at.y, tip.refused->message));
    }
  }
}

}  // namespace

dobra::base::Result<model::Model> add_tips(const model::Model& model, const FractureParams& params,
                                           const scenario::Context&, const dobra::base::Progress& progress) {
  if (model.analyses.empty())
    return Error{ErrorCode::BadValue, "there is no analysis: put a step 'analyse' or 'adapt' before"};
  Analysis analysis = *model.analyses.back();
  const auto& mesh = analysis.meshed->mesh;
  if (mesh.tips.empty())
    return Error{ErrorCode::BadValue,
                 "the mesh has no crack tips; give the input a crack that ends inside the material"};
  analysis.tips.clear();
  for (std::size_t c = 0; c < analysis.problem.cases.size(); ++c) {
    DOBRA_TRY_VOID(progress.check());
    analysis.tips.push_back(fem::fracture::crack_tips(mesh, analysis.problem, analysis.problem.cases[c],
                                                      analysis.solution.cases[c].displacements, params.contour));
  }
  const auto all_refused = [](const auto& tips) {
    return std::all_of(tips.begin(), tips.end(), [](const auto& tip) { return tip.refused.has_value(); });
  };
  if (std::all_of(analysis.tips.begin(), analysis.tips.end(), all_refused))
    return *analysis.tips.front().front().refused;
  model::Model result = model;
  add_tip_remarks(analysis, result.remarks);
  result.analyses.back() = std::make_shared<const Analysis>(std::move(analysis));
  return result;
}

std::string ask_for_rosettes(scenario::Document& document) {
  auto& steps = document.steps;
  const auto crack =
      std::find_if(steps.rbegin(), steps.rend(), [](const auto& step) { return step.operation == "crack"; });
  const auto mesh = std::find_if(
      crack, steps.rend(), [](const auto& step) { return step.operation == "mesh" || step.operation == "adapt"; });
  const auto give = [](scenario::Table& params) {
    params.set("order", std::string("2"));
    params.set("rosettes", std::string("yes"));
  };
  if (mesh == steps.rend()) {
    scenario::Step step{.operation = "mesh", .name = {}, .params = {}, .comment = {}, .place = {}};
    give(step.params);
    const auto analyse =
        std::find_if(steps.begin(), steps.end(), [](const auto& s) { return s.operation == "analyse"; });
    steps.insert(analyse != steps.end() ? analyse : crack.base() - 1, std::move(step));
    return "the scenario has no mesh: one with rosettes of quarter-point elements at the tips is made";
  }
  const auto says = [&](const char* key, const char* value) {
    const scenario::Value* found = mesh->params.find(key);
    return found != nullptr && *found == scenario::Value(std::string(value));
  };
  if (mesh->params.find("rosettes") != nullptr || says("order", "1") || says("quads", "yes")) return {};
  give(mesh->params);
  return fmt::format(
      "step '{}' puts rosettes of quarter-point elements at the tips; rosettes = \"no\" there leaves them out",
      mesh->operation);
}

void add_tip_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (model.analyses.empty()) return;
  const Analysis& analysis = *model.analyses.back();
  for (std::size_t c = 0; c < analysis.tips.size(); ++c) {
    for (const auto& tip : analysis.tips[c]) {
      if (tip.refused) continue;
      for (const Figure& figure : figures_of(tip)) {
        if (figure.value)
          quantities.push_back({fmt::format("tip.{}.{}.{}", analysis.solution.cases[c].name, tip.name, figure.name),
                                *figure.value, figure.unit});
      }
    }
  }
}

void add_tip_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (model.analyses.empty() || model.analyses.back()->tips.empty()) return;
  const Analysis& analysis = *model.analyses.back();
  scenario::DataTable table{"tips", {"case", "tip", "x [m]", "y [m]"}, {}};
  for (std::size_t c = 0; c < analysis.tips.size(); ++c) {
    for (const auto& tip : analysis.tips[c]) {
      const auto figures = figures_of(tip);
      if (table.rows.empty()) {
        for (const Figure& figure : figures) table.columns.push_back(fmt::format("{} [{}]", figure.name, figure.unit));
        table.columns.emplace_back("reason");
      }
      auto& row = table.rows.emplace_back();
      row.reserve(table.columns.size());
      row.emplace_back(analysis.solution.cases[c].name);
      row.emplace_back(tip.name);
      for (const double place : {tip.at.x, tip.at.y}) row.emplace_back(place);
      for (const Figure& figure : figures) {
        if (figure.value && !tip.refused)
          row.emplace_back(*figure.value);
        else
          row.emplace_back(std::string());
      }
      row.emplace_back(tip.refused ? scenario::message_in_units(tip.refused->message, model.units) : std::string());
    }
  }
  tables.push_back(std::move(table));
}

std::optional<bool> tips_reached(const model::Model& model) {
  std::optional<bool> reached;
  for (const auto& analysis : model.analyses) {
    for (const auto& tips : analysis->tips)
      reached = reached.value_or(true) &&
                std::none_of(tips.begin(), tips.end(), [](const auto& tip) { return tip.refused.has_value(); });
  }
  return reached;
}

}  // namespace quebra::analysis
