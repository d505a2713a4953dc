// report.json: what a run was given and what came of it.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "shared/scenario/runner.h"

namespace dobra::scenario {
namespace {

using Json = nlohmann::ordered_json;

std::string scalar(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Lists of plain values, and points in lists, stay on one line; everything else is indented by two blanks a level.
void print(const Json& json, const std::string& indent, std::string& out) {
  const bool flat = !json.is_structured() || json.empty() ||
                    (json.is_array() &&
                     std::none_of(json.begin(), json.end(), [](const Json& item) { return item.is_structured(); }));
  if (flat) {
    if (!json.is_array() || json.empty()) {
      out += scalar(json);
      return;
    }
    out += '[';
    for (std::size_t i = 0; i < json.size(); ++i) out += (i > 0 ? ", " : "") + scalar(json[i]);
    out += ']';
    return;
  }
  const std::string deeper = indent + "  ";
  out += json.is_object() ? "{" : "[";
  bool first = true;
  for (auto item = json.begin(); item != json.end(); ++item) {
    out += (first ? "\n" : ",\n") + deeper;
    first = false;
    if (json.is_object()) out += scalar(item.key()) + ": ";
    print(*item, deeper, out);
  }
  out += '\n' + indent + (json.is_object() ? "}" : "]");
}

Json json_of(const geom::Point& point) { return Json::array({point.x, point.y}); }

Json json_of(const Table& table, const std::vector<Field>& fields);

struct ToJson {
  const Field& field;
  Json operator()(const geom::Point& point) const { return json_of(point); }
  Json operator()(const Points& points) const {
    Json list = Json::array();
    for (const geom::Point& point : points) list.push_back(json_of(point));
    return list;
  }
  Json operator()(const std::vector<geom::Point3>& points) const {
    Json list = Json::array();
    for (const geom::Point3& p : points) list.push_back(Json::array({p.x, p.y, p.z}));
    return list;
  }
  Json operator()(const std::vector<Table>& tables) const {
    Json list = Json::array();
    for (const Table& table : tables) list.push_back(json_of(table, field.fields));
    return list;
  }
  template <class T>
  Json operator()(const T& value) const {
    return value;
  }
};

/// The values that count, in the order of the fields: those written and the defaults of the others. Each has the type
/// of its field, so that 1 and 1.0 give the same bytes.
Json json_of(const Table& table, const std::vector<Field>& fields) {
  Json values = Json::object();
  for (const Field& field : fields) {
    const Value* written = table.find(field.key);
    const auto value = written != nullptr ? as_kind(*written, field.kind) : field.default_value;
    if (value) values[field.key] = std::visit(ToJson{field}, *value);
  }
  return values;
}

void add_findings(const Program& program, const Run& run, std::size_t k, Json& json) {
  Json quantities = Json::object();
  for (const Quantity& quantity : program.quantities_of(run.states[k]))
    quantities[quantity.name] = {{"value", quantity.value}, {"unit", quantity.unit}};
  json["quantities"] = std::move(quantities);
  const auto before = k == 0 ? std::vector<std::string>{} : program.remarks_of(run.states[k - 1]);
  Json fresh = Json::array();
  for (const std::string& remark : program.remarks_of(run.states[k])) {
    if (std::find(before.begin(), before.end(), remark) == before.end()) fresh.push_back(remark);
  }
  json["remarks"] = std::move(fresh);
}

Json tables_json(const Program& program, const State& state) {
  Json tables = Json::object();
  for (const DataTable& table : program.tables_of(state)) {
    Json rows = Json::array();
    for (const auto& row : table.rows) {
      Json cells = Json::array();
      for (const auto& cell : row) std::visit([&](const auto& value) { cells.push_back(value); }, cell);
      rows.push_back(std::move(cells));
    }
    tables[table.name] = {{"columns", table.columns}, {"rows", std::move(rows)}};
  }
  return tables;
}

Json verdict_json(const Verdict& verdict) {
  const Expect& expect = verdict.expect;
  Json json = {{"quantity", expect.quantity}};
  if (!expect.name.empty()) json["name"] = expect.name;
  if (expect.step) json["step"] = *expect.step;
  if (expect.rate_from) json["rate_from"] = *expect.rate_from;
  if (expect.factor != 1.0) json["factor"] = expect.factor;
  if (expect.value) {
    json["value"] = *expect.value;
    json["tolerance"] = expect.tolerance;
    json["relative_tolerance"] = expect.relative_tolerance;
  }
  if (expect.at_least) json["at_least"] = *expect.at_least;
  if (expect.at_most) json["at_most"] = *expect.at_most;
  if (verdict.found) json["found"] = *verdict.found;
  json["met"] = verdict.met;
  return json;
}

}  // namespace

std::string report_json(const Document& document, const Program& program, const Run& run) {
  Json report;
  report["program"] = program.name;
  report["version"] = DOBRA_VERSION;
  report["title"] = document.title;
  if (!document.units.si()) report["unit_system"] = document.units.text();
  if (document.result_units) report["result_units"] = document.result_units->text();
  report["complete"] = run.complete();
  if (run.complete()) {
    if (const auto met = program.reached(run.states.back())) report["reached"] = *met;
  }
  if (!run.states.empty()) {
    report["input"]["values"] = json_of(document.input, fields_in(program.input_fields, document.units));
    add_findings(program, run, 0, report["input"]);
  }
  report["steps"] = Json::array();
  for (std::size_t k = 1; k < run.states.size(); ++k) {
    const Step& step = document.steps[k - 1];
    Json json = {{"operation", step.operation}, {"name", step.name}};
    const Operation* operation = program.find_operation(step.operation);
    json["values"] = json_of(step.params, fields_in(operation->fields, document.units));
    add_findings(program, run, k, json);
    report["steps"].push_back(std::move(json));
  }
  if (!run.states.empty()) report["tables"] = tables_json(program, run.states.back());
  if (run.error) report["error"] = {{"step", run.failed_step}, {"message", run.error->message}};
  if (run.complete()) {
    report["expectations"] = Json::array();
    for (const Verdict& verdict : judge(document, program, run))
      report["expectations"].push_back(verdict_json(verdict));
  }
  std::string out;
  print(report, "", out);
  return out + '\n';
}

}  // namespace dobra::scenario
