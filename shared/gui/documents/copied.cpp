#include "shared/gui/documents/copied.h"

#include <fmt/format.h>

#include <regex>

#include "shared/base/check.h"
#include "shared/base/text.h"
#include "shared/gui/documents/edit.h"
#include "shared/scenario/runner.h"

namespace dobra::gui::documents {

using base::Error;
using base::ErrorCode;
using scenario::Document;
using scenario::Program;

std::string part_text(const Document& document, std::size_t part) {
  DOBRA_CHECK(part <= document.steps.size());
  Document only;
  only.program = document.program;
  if (part == 0) {
    if (document.input.empty()) return "[input]\n";
    only.input = document.input;
    only.input_comment = document.input_comment;
  } else {
    only.steps = {document.steps[part - 1]};
  }
  const std::string text = scenario::document_text(only);
  return text.substr(text.find("\n\n") + 2);  // behind the version and the program
}

namespace {

constexpr const char* clipboard = "clipboard";

/// A scenario with its version and program, or only tables of one.
bool is_whole(const std::string& text) { return std::regex_search(text, std::regex("(^|\n)[ \t]*dobra[ \t]*=")); }

constexpr std::size_t head_lines = 2;  ///< Put before text that is not whole.

base::Result<Document> parsed(const Program& program, const std::string& text) {
  if (is_whole(text)) return scenario::parse_document(text, clipboard);
  const std::string head = fmt::format("dobra = {}\nprogram = \"{}\"\n", Document::current_version, program.name);
  return scenario::parse_document(head + text, clipboard);
}

base::Result<Document> with_steps_of(const std::string& text, Document document, const Program& program,
                                     std::size_t after) {
  DOBRA_TRY(const Document pasted, parsed(program, text));
  DOBRA_TRY_VOID(scenario::check_program(pasted, program));
  if (pasted.steps.empty()) {
    return Error{
        ErrorCode::BadValue, base::translated("the clipboard holds no step; copy text that begins with [[step]]"), {}};
  }
  if (is_whole(text) && pasted.units.text() != document.units.text()) {
    return Error{ErrorCode::BadValue,
                 base::translated("the clipboard's numbers are in other units than those of this document; give both "
                                  "the same unit_system"),
                 {}};
  }
  for (std::size_t step = 1; step <= pasted.steps.size(); ++step) {
    DOBRA_TRY(const scenario::Operation* operation, scenario::operation_of(pasted, step, program));
    DOBRA_TRY_VOID(scenario::check(pasted.steps[step - 1].params,
                                   scenario::fields_in(operation->fields, document.units),
                                   scenario::step_label(pasted, step)));
  }
  document.steps.insert(document.steps.begin() + static_cast<std::ptrdiff_t>(after), pasted.steps.begin(),
                        pasted.steps.end());
  return document;
}

}  // namespace

base::Result<Document> with_pasted(Document document, const Program& program, std::size_t after,
                                   const std::string& text) {
  DOBRA_CHECK(after <= document.steps.size());
  base::Result<Document> made = with_steps_of(text, std::move(document), program, after);
  if (made || is_whole(text) || !made.error().place || made.error().place->line <= head_lines) return made;
  Error error = made.error();
  error.place->line -= head_lines;
  return error;
}

namespace {

/// As a shell takes it for one word.
std::string quoted(const std::string& word) {
  if (!word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@") ==
          std::string::npos)
    return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// What --set says of the differences between two tables of the same fields.
void add_assignments(const std::vector<scenario::Field>& fields, const scenario::Table& before,
                     const scenario::Table& now, const std::string& path, std::vector<std::string>& assignments) {
  for (const scenario::Field& field : fields) {
    const scenario::Value* was = before.find(field.key);
    const scenario::Value* is = now.find(field.key);
    if (is == nullptr || (was != nullptr && *was == *is)) continue;
    if (field.kind != scenario::Kind::Tables) {
      assignments.push_back(fmt::format("{}.{}={}", path, field.key, scenario::value_text(*is)));
      continue;
    }
    const auto* old_rows = was == nullptr ? nullptr : std::get_if<std::vector<scenario::Table>>(was);
    const auto* rows = std::get_if<std::vector<scenario::Table>>(is);
    if (old_rows == nullptr || rows == nullptr) continue;
    for (std::size_t i = 0; i < std::min(old_rows->size(), rows->size()); ++i)
      add_assignments(field.fields, (*old_rows)[i], (*rows)[i], fmt::format("{}.{}.{}", path, field.key, i + 1),
                      assignments);
  }
}

}  // namespace

std::string command_of(const Document& document, const Program& program, const std::optional<Document>& on_disk) {
  const std::filesystem::path file = std::filesystem::absolute(document.file).lexically_normal();
  std::filesystem::path out = file;
  out.replace_extension();
  out += "_results";
  std::vector<std::string> assignments;
  bool all_said = on_disk.has_value();
  if (on_disk && on_disk->steps.size() == document.steps.size()) {
    for (std::size_t part = 0; part <= document.steps.size(); ++part) {
      const std::string path = part == 0 ? "input" : fmt::format("steps.{}", part);
      add_assignments(fields_of(document, program, part), table_of(*on_disk, part), table_of(document, part), path,
                      assignments);
    }
  }
  if (on_disk) {
    base::Result<Document> made = *on_disk;
    for (const std::string& assignment : assignments)
      if (made) made = scenario::with_value(*made, program, assignment);
    all_said = made && scenario::document_text(*made) == scenario::document_text(document);
  }
  std::string command = fmt::format("{} run {} --out {}", program.name, quoted(file.string()), quoted(out.string()));
  if (!all_said) {
    return "# " + base::translated("Not all changes of the window are in the file: save it before you run this.") +
           '\n' + command + '\n';
  }
  for (const std::string& assignment : assignments) command += " --set " + quoted(assignment);
  return command + '\n';
}

}  // namespace dobra::gui::documents
