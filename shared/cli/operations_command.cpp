// The sub-command `operations`: scenario reference from the same fields that the reader and the forms use.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/cli/commands.h"

namespace dobra::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string fields_text(const std::vector<scenario::Field>& fields, const std::string& indent) {
  std::size_t width = 0;
  for (const scenario::Field& field : fields) width = std::max(width, field.key.size());
  std::string text;
  for (const scenario::Field& field : fields) {
    text += fmt::format("{}{:<{}}  {}", indent, field.key, width, scenario::field_summary(field));
    const scenario::FieldOptions& options = field.options;
    if (options.title[0] != '\0') text += fmt::format("; {}", base::translated(options.title));
    if (options.help[0] != '\0') text += fmt::format(". {}", base::translated(options.help));
    text += '\n' + fields_text(field.fields, indent + "    ");
  }
  return text;
}

Json fields_json(const std::vector<scenario::Field>& fields) {
  Json list = Json::array();
  for (const scenario::Field& field : fields) {
    const scenario::FieldOptions& options = field.options;
    Json json = {{"key", field.key},
                 {"summary", scenario::field_summary(field)},
                 {"title", options.title},
                 {"help", options.help}};
    json["unit"] = options.unit;
    json["required"] = options.presence == scenario::Presence::Required;
    if (options.above) json["above"] = *options.above;
    if (options.at_least) json["at_least"] = *options.at_least;
    if (options.at_most) json["at_most"] = *options.at_most;
    if (!field.choices.empty()) json["choices"] = field.choices;
    if (field.default_value) json["default"] = scenario::value_text(*field.default_value);
    if (!field.fields.empty()) json["fields"] = fields_json(field.fields);
    list.push_back(std::move(json));
  }
  return list;
}

Json operation_json(const scenario::Operation& operation) {
  return {{"name", operation.name},
          {"title", operation.title},
          {"help", operation.help},
          {"parameters", fields_json(operation.fields)}};
}

std::string operation_text(const scenario::Operation& operation) {
  return fmt::format("{}: {}. {}\n{}", operation.name, operation.title, operation.help,
                     fields_text(operation.fields, "  "));
}

std::string all_text(const scenario::Program& program) {
  std::size_t width = 0;
  for (const scenario::Operation& operation : program.operations) width = std::max(width, operation.name.size());
  std::string text = fmt::format("[input] of a scenario for {}:\n{}\nOperations of its steps:\n", program.name,
                                 fields_text(program.input_fields, "  "));
  for (const scenario::Operation& operation : program.operations) {
    text += fmt::format("  {:<{}}  {}\n", operation.name, width, operation.title);
  }
  return text + fmt::format("\n'{} operations NAME' lists the parameters of one.\n", program.name);
}

base::Result<int> operations_job(Session& session, const std::string& name) {
  const scenario::Program& program = session.program;
  const bool as_json = session.options.format == OutputFormat::Json;
  const auto written = [](const base::Result<void>& printed) -> base::Result<int> {
    if (!printed) return printed.error();
    return 0;
  };
  if (name.empty()) {
    if (!as_json) return written(print(all_text(program)));
    Json json = {
        {"program", program.name}, {"input", fields_json(program.input_fields)}, {"operations", Json::array()}};
    for (const scenario::Operation& operation : program.operations)
      json["operations"].push_back(operation_json(operation));
    return written(print(json.dump(2) + '\n'));
  }
  if (const scenario::Operation* operation = program.find_operation(name)) {
    return written(print(as_json ? operation_json(*operation).dump(2) + '\n' : operation_text(*operation)));
  }
  std::vector<std::string> names;
  for (const scenario::Operation& operation : program.operations) names.push_back(operation.name);
  std::string hint = base::did_you_mean(name, names);
  if (hint.empty()) hint = fmt::format("; known operations: {}", fmt::join(names, ", "));
  return base::Error{base::ErrorCode::BadUsage, fmt::format("unknown operation '{}'{}", name, hint)};
}

}  // namespace

Command operations_command() {
  return {"operations", "List the operations of scenario steps, or the parameters of one", [](CLI::App& app) -> Job {
            const auto name = std::make_shared<std::string>();
            app.add_option("name", *name, "Operation whose parameters are listed")->type_name("NAME");
            return [name](Session& session) { return operations_job(session, *name); };
          }};
}

}  // namespace dobra::cli
