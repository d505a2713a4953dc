#include "shared/gui/documents/edit.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "shared/base/check.h"
#include "shared/scenario/lines_file.h"

namespace dobra::gui::documents {

using scenario::Document;
using scenario::Field;
using scenario::Program;
using scenario::Table;
using scenario::Value;

const Table& table_of(const Document& document, std::size_t part) {
  DOBRA_CHECK(part <= document.steps.size());
  return part == 0 ? document.input : document.steps[part - 1].params;
}

std::vector<Field> fields_of(const Document& document, const Program& program, std::size_t part) {
  if (part == 0) return program.input_fields;
  DOBRA_CHECK(part <= document.steps.size());
  const scenario::Operation* operation = program.find_operation(document.steps[part - 1].operation);
  return operation != nullptr ? operation->fields : std::vector<Field>{};
}

Document with_table(Document document, std::size_t part, Table table) {
  DOBRA_CHECK(part <= document.steps.size());
  (part == 0 ? document.input : document.steps[part - 1].params) = std::move(table);
  return document;
}

Document with_step(Document document, std::size_t after, const std::string& operation) {
  DOBRA_CHECK(after <= document.steps.size());
  scenario::Step step;
  step.operation = operation;
  document.steps.insert(document.steps.begin() + static_cast<std::ptrdiff_t>(after), std::move(step));
  return document;
}

Document without_step(Document document, std::size_t step) {
  DOBRA_CHECK(step >= 1 && step <= document.steps.size());
  document.steps.erase(document.steps.begin() + static_cast<std::ptrdiff_t>(step - 1));
  return document;
}

Document with_step_lowered(Document document, std::size_t step) {
  DOBRA_CHECK(step >= 1 && step < document.steps.size());
  std::swap(document.steps[step - 1], document.steps[step]);
  return document;
}

namespace {

using Path = std::filesystem::path;

enum class Absolute { Stays, BecomesRelative };

std::string moved_name(const std::string& name, const Path& from, const Path& to, Absolute absolute) {
  const Path path(name);
  if (name.empty() || (path.is_absolute() && absolute == Absolute::Stays)) return name;
  const Path target = std::filesystem::absolute(from.empty() ? path : from / path).lexically_normal();
  const Path relative =
      target.lexically_relative(std::filesystem::absolute(to.empty() ? Path(".") : to).lexically_normal());
  return (relative.empty() ? target : relative).generic_string();
}

Table moved_table(Table table, const std::vector<Field>& fields, const Path& from, const Path& to, Absolute absolute) {
  for (const Field& field : fields) {
    const Value* value = table.find(field.key);
    if (value == nullptr) continue;
    if (const auto* name = std::get_if<std::string>(value); name != nullptr && field.kind == scenario::Kind::File) {
      table.set(field.key, moved_name(*name, from, to, absolute));
    } else if (const auto* rows = std::get_if<std::vector<Table>>(value)) {
      std::vector<Table> moved;
      for (const Table& row : *rows) moved.push_back(moved_table(row, field.fields, from, to, absolute));
      table.set(field.key, std::move(moved));
    }
  }
  return table;
}

/// Each once.
void files_in(const Table& table, const std::vector<Field>& fields, std::vector<std::string>& names) {
  for (const Field& field : fields) {
    const Value* value = table.find(field.key);
    if (value == nullptr) continue;
    if (const auto* rows = std::get_if<std::vector<Table>>(value)) {
      for (const Table& row : *rows) files_in(row, field.fields, names);
    }
    const auto* name = std::get_if<std::string>(value);
    if (name == nullptr || name->empty() || field.kind != scenario::Kind::File) continue;
    if (std::find(names.begin(), names.end(), *name) == names.end()) names.push_back(*name);
  }
}

}  // namespace

Document at_file(Document document, const Program& program, const Path& file) {
  const Path from = document.folder();
  const Path to = file.parent_path();
  const auto same = [](const Path& a) {
    return std::filesystem::absolute(a.empty() ? Path(".") : a).lexically_normal();
  };
  // Before it has a place a document can only name files by their whole path.
  const Absolute absolute = document.file.empty() && !file.empty() ? Absolute::BecomesRelative : Absolute::Stays;
  if (same(from) != same(to) || absolute == Absolute::BecomesRelative) {
    for (std::size_t part = 0; part <= document.steps.size(); ++part) {
      Table moved = moved_table(table_of(document, part), fields_of(document, program, part), from, to, absolute);
      document = with_table(std::move(document), part, std::move(moved));
    }
  }
  // Two documents do not share one file of lines.
  if (!document.lines_file.empty() && document.file != file) document.lines_file = scenario::lines_name(file);
  document.file = file;
  return document;
}

std::vector<std::string> files_left(const Document& before, const Document& after, const Program& program) {
  std::vector<std::string> names;
  files_in(before.input, program.input_fields, names);
  std::vector<std::string> left;
  files_in(after.input, program.input_fields, left);
  std::erase_if(names,
                [&](const std::string& name) { return std::find(left.begin(), left.end(), name) != left.end(); });
  return names;
}

Document with_lines_beside(Document document, bool beside) {
  if (document.lines_file.empty() != beside) return document;
  document.lines_source = nullptr;
  document.lines_file = beside ? scenario::lines_name(document.file) : std::string();
  // What stands beside already is somebody's.
  for (int copy = 2;
       beside && !document.file.empty() && std::filesystem::exists(document.folder() / document.lines_file); ++copy) {
    document.lines_file = document.file.stem().string() + " (" + std::to_string(copy) + ").lines.toml";
  }
  return document;
}

bool is_blank(const Document& document, const Program& program) {
  return program.nothing_yet ? program.nothing_yet(document.input) : document.input.empty() && document.steps.empty();
}

Document empty_document(const Program& program) {
  Document document;
  document.program = program.name;
  return document;
}

}  // namespace dobra::gui::documents
