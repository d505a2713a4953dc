#include "shared/scenario/lines_file.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "shared/io/file.h"

namespace dobra::scenario {

namespace {

using base::Error;
using base::ErrorCode;

constexpr const char* what_it_is =
    "Lines of the scenario beside, which names this file as its lines_file. Numbers are in the units of both.";

bool is_tables(const Table::Entry& entry) { return std::holds_alternative<std::vector<Table>>(entry.value); }

base::Result<void> check_lines(const Document& lines, const Document& document) {
  const auto refused = [&](base::Place place, std::string message) {
    if (place.file.empty()) place.file = lines.file.string();
    return Error{ErrorCode::BadValue, std::move(message), std::move(place)};
  };
  if (lines.program != document.program)
    return Error{ErrorCode::WrongProgram,
                 fmt::format("a file of lines for '{}', and the scenario is for '{}'", lines.program, document.program),
                 base::Place{.file = lines.file.string()}};
  if (lines.units.text() != document.units.text())
    return refused({}, fmt::format("its units ('{}') are not those of the scenario ('{}'); give both the same "
                                   "unit_system",
                                   lines.units.text(), document.units.text()));
  const char* only = "a file of lines has nothing but tables such as [[input.horizon]]; move this to the scenario";
  if (!lines.steps.empty()) return refused(lines.steps.front().place, only);
  if (!lines.expects.empty()) return refused(lines.expects.front().place, only);
  if (!lines.lines_file.empty()) return refused({}, "a file of lines names no lines_file; remove it");
  for (const Table::Entry& entry : lines.input.entries()) {
    if (!is_tables(entry)) return refused(entry.place, fmt::format("'{}': {}", entry.key, only));
  }
  return {};
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code none;
  return std::filesystem::equivalent(a, b, none);
}

}  // namespace

std::string lines_name(const std::filesystem::path& document) {
  return document.empty() ? "lines.toml" : document.stem().string() + ".lines.toml";
}

base::Result<Document> with_lines_read(Document document) {
  if (document.lines_file.empty()) return document;
  const std::filesystem::path file = document.folder() / document.lines_file;
  if (same_file(file, document.file))
    return Error{ErrorCode::BadValue, "lines_file names the scenario itself; name a file beside it",
                 base::Place{.file = document.file.string()}};
  base::Result<std::string> text = io::read_text(file);
  if (!text) {
    Error error = text.error();
    error.message += fmt::format("; '{}' names it as its lines_file", document.file.filename().string());
    return error;
  }
  DOBRA_TRY(const Document lines, parse_document(*text, file));
  DOBRA_TRY_VOID(check_lines(lines, document));
  document.lines_source = lines.source;
  for (const Table::Entry& entry : lines.input.entries()) {
    std::vector<Table> tables;
    if (const Value* own = document.input.find(entry.key)) {
      const auto* there = std::get_if<std::vector<Table>>(own);
      if (there == nullptr)
        return Error{ErrorCode::BadValue,
                     fmt::format("'{}' is no table in the scenario; remove one of both", entry.key),
                     document.input.place(entry.key)};
      tables = *there;
    }
    const auto& more = std::get<std::vector<Table>>(entry.value);
    tables.insert(tables.end(), more.begin(), more.end());
    document.input.set(entry.key, std::move(tables), entry.place);
  }
  return document;
}

std::string own_text(const Document& document) {
  if (document.lines_file.empty()) return saved_text(document);
  Document own = document;
  for (const Table::Entry& entry : document.input.entries()) {
    if (is_tables(entry)) own.input.erase(entry.key);
  }
  return saved_text(own);
}

std::string lines_text(const Document& document) {
  Document lines;
  lines.comment = what_it_is;
  if (document.lines_source) {
    if (auto read = parse_document(*document.lines_source, document.folder() / document.lines_file))
      lines = *std::move(read);
  }
  lines.program = document.program;
  lines.units = document.units;
  Table tables;
  tables.comment = lines.input.comment;
  for (const Table::Entry& entry : document.input.entries()) {
    if (!is_tables(entry)) continue;
    tables.set(entry.key, entry.value);
    tables.set_comment(entry.key, entry.comment);
  }
  lines.input = std::move(tables);
  return saved_text(lines);
}

}  // namespace dobra::scenario
