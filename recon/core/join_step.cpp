#include "recon/core/join_step.h"

#include <algorithm>

#include "recon/core/report.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace {

/// What the steps `join` have done; the last one last.
struct DoneJoins {
  std::vector<input::Join> joins;
  std::vector<std::string> remarks;
};

void add_join_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* done = model.findings.get<DoneJoins>();
  if (done == nullptr) return;
  double widest = 0.0;
  for (const input::Join& join : done->joins) widest = std::max(widest, join.gap);
  quantities.push_back({"join.joined", count_of(done->joins.size()), ""});
  quantities.push_back({"join.widest_gap", widest, "m"});
}

void add_join_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const auto all = model.findings.all<DoneJoins>();
  if (all.empty()) return;
  scenario::DataTable table{"joins", {"join", "horizon", "x [m]", "z [m]", "gap [m]"}, {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const input::Join& join : all[i]->joins)
      table.rows.push_back({count_of(i + 1), join.horizon, join.at.x, join.at.y, join.gap});
  }
  tables.push_back(std::move(table));
}

void add_join_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  for (const DoneJoins* done : model.findings.all<DoneJoins>()) append(done->remarks, remarks);
}

void add_join_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (model->findings.get<DoneJoins>() == nullptr || is_done(*model)) return;
  outputs.push_back({"joined.geojson", [model](const std::filesystem::path& path) {
                       return io::gis::write_geojson(path.string(), restored_features(model->section));
                     }});
}

}  // namespace

base::Result<model::Model> run_join(const model::Model& model, const input::JoinParams& params,
                                    const scenario::Context&, const base::Progress&) {
  DOBRA_TRY(model::Model next, next_stage(model));
  DOBRA_TRY(input::JoinedPieces joined, join_pieces(std::move(next.section), params));
  next.section = std::move(joined.section);
  next.findings.add(DoneJoins{std::move(joined.joins), std::move(joined.remarks)}, {.state = next.earlier.size()});
  return next;
}

scenario::Operation join_step() {
  return scenario::make_operation<model::Model, input::JoinParams>(
      "join", "Join beds", "Makes one line of pieces of a horizon that blocks moved back have brought together.",
      run_join,
      {.quantities = add_join_quantities,
       .tables = add_join_tables,
       .remarks = add_join_remarks,
       .outputs = add_join_outputs});
}

}  // namespace recon::core
