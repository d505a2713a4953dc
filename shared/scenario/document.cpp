#include "shared/scenario/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/scenario/field.h"
#include "shared/scenario/lines_file.h"
#include "shared/scenario/toml_reader.h"
#include "shared/scenario/toml_text.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

std::string take_text(Table& table, std::string_view key) {
  const Value* value = table.find(key);
  const auto* text = value != nullptr ? std::get_if<std::string>(value) : nullptr;
  std::string out = text != nullptr ? *text : std::string{};
  table.erase(key);
  return out;
}

std::vector<Field> top_fields() {
  Field version{"dobra", Kind::Integer, {.help = "Format version.", .presence = Presence::Required}, {}, {}, {}};
  Field program{"program", Kind::Text, {.help = "recon or quebra.", .presence = Presence::Required}, {}, {}, {}};
  Field title{"title", Kind::Text, {}, {}, {}, {}};
  Field units{"unit_system", Kind::Text, {.help = "Of every number of the file."}, {}, {}, {}};
  Field results{"result_units", Kind::Text, {.help = "Of the results, where they are to differ."}, {}, {}, {}};
  Field lines{"lines_file", Kind::Text, {.help = "Where the tables of the input stand."}, {}, {}, {}};
  return {version, program, title, units, results, lines};
}

base::Result<void> read_top(const Table& top, Document& document) {
  DOBRA_TRY_VOID(check(top, top_fields(), ""));
  const auto version = std::get<std::int64_t>(*top.find("dobra"));
  if (version < 1 || version > Document::current_version) {
    return Error{ErrorCode::BadValue,
                 fmt::format("format version {} is not known to this program, which reads versions 1 to {}", version,
                             Document::current_version),
                 top.place("dobra")};
  }
  document.program = std::get<std::string>(*top.find("program"));
  if (const Value* title = top.find("title")) document.title = std::get<std::string>(*title);
  if (const Value* lines = top.find("lines_file")) document.lines_file = std::get<std::string>(*lines);
  document.comment = top.comment;
  for (const char* key : {"unit_system", "result_units"}) {
    const Value* text = top.find(key);
    if (text == nullptr) continue;
    if (const auto set = set_units(document, key, std::get<std::string>(*text)); !set)
      return base::located(set.error(), top.place(key));
  }
  return {};
}

/// Comments above keys that are no parameters go above the table.
std::string all_comments(const Table& table) {
  std::string comment = table.comment;
  for (const Table::Entry& entry : table.entries()) comment = joined_comments(comment, entry.comment);
  return comment;
}

base::Result<Step> read_step(Table table, std::size_t number) {
  Step step;
  step.place = table.own_place;
  step.comment = table.comment;
  const std::string where = fmt::format("step {}", number);
  const Field operation{"operation", Kind::Text, {.presence = Presence::Required}, {}, {}, {}};
  const Field name{"name", Kind::Text, {}, {}, {}, {}};
  Table reserved;
  reserved.own_place = table.own_place;
  for (const Table::Entry& entry : table.entries()) {
    if (entry.key != "operation" && entry.key != "name") continue;
    reserved.set(entry.key, entry.value, entry.place);
    step.comment = joined_comments(step.comment, entry.comment);
  }
  DOBRA_TRY_VOID(check(reserved, {operation, name}, where));
  step.operation = take_text(table, "operation");
  step.name = take_text(table, "name");
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (!step.name.empty() && std::all_of(step.name.begin(), step.name.end(), digit)) {
    return Error{ErrorCode::BadValue,
                 fmt::format("{}: the name '{}' would be taken for a step's number; add a letter", where, step.name),
                 reserved.place("name")};
  }
  table.comment.clear();
  step.params = std::move(table);
  return step;
}

std::vector<Field> expect_fields() {
  const auto number = [](const char* key, FieldOptions options) {
    return Field{key, Kind::Number, options, {}, {}, {}};
  };
  const auto text = [](const char* key, FieldOptions options = {}) {
    return Field{key, Kind::Text, options, {}, {}, {}};
  };
  return {text("quantity", {.presence = Presence::Required}),
          text("step"),
          text("rate_from"),
          text("name"),
          text("section"),
          text("source"),
          text("note"),
          number("factor", {}),
          number("value", {}),
          number("tolerance", {.at_least = 0}),
          number("relative_tolerance", {.at_least = 0}),
          number("at_least", {}),
          number("at_most", {})};
}

/// What an expectation says in words, in the order of a file.
std::array<std::pair<const char*, std::string*>, 4> texts_of(Expect& expect) {
  return {{{"name", &expect.name}, {"section", &expect.section}, {"source", &expect.source}, {"note", &expect.note}}};
}

base::Result<Expect> read_expect(Table table, std::size_t number) {
  const std::string where = fmt::format("expectation {}", number);
  // A step is meant by its number or its name.
  for (const char* const key : {"step", "rate_from"}) {
    const Value* step = table.find(key);
    const auto* integer = step == nullptr ? nullptr : std::get_if<std::int64_t>(step);
    if (integer != nullptr) table.set(key, fmt::format("{}", *integer));
  }
  DOBRA_TRY_VOID(check(table, expect_fields(), where));
  Expect expect;
  expect.place = table.own_place;
  expect.comment = all_comments(table);
  expect.quantity = std::get<std::string>(*table.find("quantity"));
  const auto number_at = [&](const char* key) -> std::optional<double> {
    const Value* value = table.find(key);
    return value != nullptr ? std::optional(detail::number_of(*value)) : std::nullopt;
  };
  if (const Value* step = table.find("step")) expect.step = std::get<std::string>(*step);
  if (const Value* step = table.find("rate_from")) expect.rate_from = std::get<std::string>(*step);
  for (const auto& [key, text] : texts_of(expect)) {
    if (const Value* value = table.find(key)) *text = std::get<std::string>(*value);
  }
  expect.factor = number_at("factor").value_or(1.0);
  expect.value = number_at("value");
  expect.tolerance = number_at("tolerance").value_or(0.0);
  expect.relative_tolerance = number_at("relative_tolerance").value_or(0.0);
  expect.at_least = number_at("at_least");
  expect.at_most = number_at("at_most");
  if (!expect.value && !expect.at_least && !expect.at_most) {
    return Error{ErrorCode::MissingKey, where + ": says nothing about the quantity; add value, at_least or at_most",
                 table.own_place};
  }
  return expect;
}

std::string step_toml(const char* key, const std::optional<std::string>& step) {
  if (!step) return "";
  const bool digits = !step->empty() && step->size() < 18 && step->find_first_not_of("0123456789") == std::string::npos;
  return entry_toml(key, digits ? Value(static_cast<std::int64_t>(std::stoll(*step))) : Value(*step));
}

std::string expect_toml(Expect expect) {
  std::string out = '\n' + comment_toml(expect.comment) + "[[expect]]\n";
  for (const auto& [key, text] : texts_of(expect)) {
    if (!text->empty()) out += entry_toml(key, *text);
  }
  out += entry_toml("quantity", expect.quantity);
  out += step_toml("step", expect.step) + step_toml("rate_from", expect.rate_from);
  if (expect.factor != 1.0) out += entry_toml("factor", expect.factor);
  if (expect.value) out += entry_toml("value", *expect.value);
  if (expect.tolerance != 0.0) out += entry_toml("tolerance", expect.tolerance);
  if (expect.relative_tolerance != 0.0) out += entry_toml("relative_tolerance", expect.relative_tolerance);
  if (expect.at_least) out += entry_toml("at_least", *expect.at_least);
  if (expect.at_most) out += entry_toml("at_most", *expect.at_most);
  return out;
}

}  // namespace

base::Result<Document> parse_document(const std::string& text, const std::filesystem::path& file) {
  DOBRA_TRY(ScenarioTables tables, read_scenario_tables(text, file.string()));
  Document document;
  document.file = file;
  document.source = std::make_shared<const std::string>(text);
  document.end_comment = tables.end_comment;
  DOBRA_TRY_VOID(read_top(tables.top, document));
  document.input.own_place.file = file.string();
  if (tables.input) {
    document.input = std::move(*tables.input);
    document.input_comment = std::exchange(document.input.comment, {});
  }
  for (std::size_t i = 0; i < tables.steps.size(); ++i) {
    DOBRA_TRY(Step step, read_step(std::move(tables.steps[i]), i + 1));
    document.steps.push_back(std::move(step));
  }
  for (std::size_t i = 0; i < tables.expects.size(); ++i) {
    DOBRA_TRY(Expect expect, read_expect(std::move(tables.expects[i]), i + 1));
    document.expects.push_back(std::move(expect));
  }
  return document;
}

base::Result<Document> read_document(const std::filesystem::path& file) {
  DOBRA_TRY(const std::string text, io::read_text(file));
  auto document = parse_document(text, file);
  if (document) return with_lines_read(*std::move(document));
  if (document.error().code != base::ErrorCode::BadSyntax || io::ending_of(file) == ".toml") return document;
  base::Error error = document.error();
  error.message = "no scenario, which is a .toml; other files are named in its [input] (" + error.message + ")";
  return error;
}

std::string document_text(const Document& document) {
  std::string out = comment_toml(document.comment);
  out += entry_toml("dobra", Document::current_version);
  out += entry_toml("program", document.program);
  if (!document.title.empty()) out += entry_toml("title", document.title);
  if (!document.units.si()) out += entry_toml("unit_system", document.units.text());
  if (document.result_units) out += entry_toml("result_units", document.result_units->text());
  if (!document.lines_file.empty()) out += entry_toml("lines_file", document.lines_file);
  if (!document.input.empty() || !document.input_comment.empty()) {
    out += '\n' + comment_toml(document.input_comment) + "[input]\n" + table_toml(document.input, "input");
  }
  for (const Step& step : document.steps) {
    out += '\n' + comment_toml(step.comment) + "[[step]]\n" + entry_toml("operation", step.operation);
    if (!step.name.empty()) out += entry_toml("name", step.name);
    out += table_toml(step.params, "step");
  }
  for (const Expect& expect : document.expects) out += expect_toml(expect);
  if (!document.end_comment.empty()) out += '\n' + comment_toml(document.end_comment);
  return out;
}

base::Result<void> write_document(const Document& document, const std::filesystem::path& file) {
  // The lines first: a document that is there names lines that are there.
  if (!document.lines_file.empty()) {
    DOBRA_TRY_VOID(io::write_file(file.parent_path() / document.lines_file, lines_text(document)));
  }
  return io::write_file(file, own_text(document));
}

base::Result<void> set_units(Document& document, const std::string& key, const std::string& text) {
  const auto made = UnitSystem::make(text);
  if (!made) return Error{made.error().code, key + made.error().message};
  if (key == "unit_system")
    document.units = *made;
  else
    document.result_units = *made;
  return {};
}

std::string step_label(const Document& document, std::size_t number) {
  return fmt::format("step {} ({})", number, document.steps.at(number - 1).operation);
}

std::optional<std::size_t> find_step(const Document& document, const std::string& name_or_number) {
  const auto named = std::find_if(document.steps.begin(), document.steps.end(), [&](const Step& step) {
    return !name_or_number.empty() && step.name == name_or_number;
  });
  if (named != document.steps.end()) return static_cast<std::size_t>(named - document.steps.begin()) + 1;
  if (name_or_number.empty() || name_or_number.size() > 9 ||
      name_or_number.find_first_not_of("0123456789") != std::string::npos) {
    return std::nullopt;
  }
  const std::size_t number = std::stoul(name_or_number);
  return number >= 1 && number <= document.steps.size() ? std::optional(number) : std::nullopt;
}

}  // namespace dobra::scenario
