// One value of a document changed by its path: --set steps.2.distance=0.4.

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/text.h"
#include "shared/scenario/runner.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

Error bad_usage(const std::string& assignment, const std::string& message) {
  return {ErrorCode::BadUsage, fmt::format("--set {}: {}", assignment, message)};
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Sets path[at..] in `table`: a key, or the key of nested tables, the 1-based number of one of them, and a path in it.
base::Result<void> assign(Table& table, const std::vector<Field>& fields, const std::vector<std::string>& path,
                          std::size_t at, const std::string& text, const std::string& assignment) {
  if (at >= path.size()) return bad_usage(assignment, "the path ends before a key");
  std::vector<std::string> keys;
  for (const Field& field : fields) keys.push_back(field.key);
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == path[at]; });
  if (field == fields.end()) {
    std::string hint = base::did_you_mean(path[at], keys);
    if (hint.empty()) hint = fmt::format("; known keys: {}", fmt::join(keys, ", "));
    return bad_usage(assignment, fmt::format("unknown key '{}'{}", path[at], hint));
  }
  if (field->kind != Kind::Tables) {
    if (at + 1 != path.size())
      return bad_usage(assignment, fmt::format("'{}' is a value; nothing follows it", path[at]));
    const auto value = parse_value(*field, text);
    if (!value) return Error{value.error().code, fmt::format("--set {}: {}", assignment, value.error().message)};
    table.set(field->key, *value);
    return {};
  }
  const Value* value = table.find(field->key);
  std::vector<Table> rows = value != nullptr ? detail::tables_of(*value) : std::vector<Table>{};
  const auto number = at + 1 < path.size() ? base::parse_number(path[at + 1]) : std::nullopt;
  if (!number || *number < 1 || *number > static_cast<double>(rows.size()) ||
      *number != static_cast<double>(static_cast<std::size_t>(*number))) {
    return bad_usage(assignment, fmt::format("after '{}' comes a number from 1 to {}, such as {}.1", path[at],
                                             rows.size(), path[at]));
  }
  DOBRA_TRY_VOID(assign(rows[static_cast<std::size_t>(*number) - 1], field->fields, path, at + 2, text, assignment));
  table.set(field->key, std::move(rows));
  return {};
}

}  // namespace

base::Result<Document> with_value(Document document, const Program& program, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return bad_usage(assignment, "write path=value, such as steps.2.distance=0.4");
  const std::vector<std::string> path = split(assignment.substr(0, equals));
  const std::string text = assignment.substr(equals + 1);
  if (path[0] == "input") {
    DOBRA_TRY_VOID(assign(document.input, fields_in(program.input_fields, document.units), path, 1, text, assignment));
    return document;
  }
  if (path.size() == 1 && (path[0] == "unit_system" || path[0] == "result_units")) {
    if (const auto set = set_units(document, path[0], text); !set)
      return Error{set.error().code, "--set " + set.error().message};
    return document;
  }
  if (path[0] != "steps") {
    static const std::vector<std::string> roots = {"input", "steps", "unit_system", "result_units"};
    std::string hint = base::did_you_mean(path[0], roots);
    if (hint.empty()) hint = "; a path starts with input or steps";
    return bad_usage(assignment, fmt::format("unknown path '{}'{}", path[0], hint));
  }
  const auto number = path.size() > 1 ? find_step(document, path[1]) : std::nullopt;
  if (!number) {
    std::vector<std::string> names;
    for (const Step& step : document.steps) {
      if (!step.name.empty()) names.push_back(step.name);
    }
    return bad_usage(assignment,
                     fmt::format("after 'steps' comes the name or number of one of the {} steps{}",
                                 document.steps.size(), path.size() > 1 ? base::did_you_mean(path[1], names) : ""));
  }
  DOBRA_TRY(const Operation* operation, operation_of(document, *number, program));
  DOBRA_TRY_VOID(assign(document.steps[*number - 1].params, fields_in(operation->fields, document.units), path, 2, text,
                        assignment));
  return document;
}

}  // namespace dobra::scenario
