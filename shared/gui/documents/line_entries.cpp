#include "shared/gui/documents/line_entries.h"

#include <algorithm>
#include <iterator>

#include "shared/base/text.h"
#include "shared/gui/documents/edit.h"
#include "shared/scenario/entries.h"

namespace dobra::gui::documents {

namespace {

using scenario::Entries;
using scenario::Table;
using scenario::Value;

/// Of the table that lines of a kind stand in, or of any other.
enum class Of { ItsKind, Others };

/// Every value of these fields that names what `what` is, and is `name`. A piece names the whole that it is of.
void rename_in(Table& table, const std::vector<scenario::Field>& fields, const std::string& what,
               const std::string& name, const std::string& to, Of of = Of::Others) {
  for (const scenario::Field& field : fields) {
    const Value* value = table.find(field.key);
    if (value == nullptr) continue;
    if (const auto* entries = std::get_if<Entries>(value)) {
      Entries renamed = *entries;
      for (Table& entry : renamed)
        rename_in(entry, field.fields, what, name, to, field.key == what ? Of::ItsKind : Of::Others);
      if (renamed != *entries) table.set(field.key, std::move(renamed));
      continue;
    }
    if (field.options.names != what && !(of == Of::ItsKind && field.key == "piece_of")) continue;
    if (const auto* words = std::get_if<std::vector<std::string>>(value)) {
      std::vector<std::string> renamed = *words;
      std::replace(renamed.begin(), renamed.end(), name, to);
      if (renamed != *words) table.set(field.key, std::move(renamed));
    } else if (const auto* word = std::get_if<std::string>(value); word != nullptr && *word == name) {
      table.set(field.key, to);
    }
  }
}

const std::vector<scenario::Field>* fields_of_table(const scenario::Program& program, const std::string& table) {
  const auto at = std::find_if(program.input_fields.begin(), program.input_fields.end(),
                               [&](const scenario::Field& field) { return field.key == table; });
  return at == program.input_fields.end() ? nullptr : &at->fields;
}

}  // namespace

std::optional<std::string> table_of_line(const scenario::Document& document, const scenario::Program& program,
                                         const std::string& name) {
  std::optional<std::string> found;
  if (name.empty()) return found;
  for (const scenario::Drawing::Kind& kind : program.drawing.kinds) {
    const Entries entries = scenario::entries_of(document.input, kind.table);
    const auto count = std::count_if(entries.begin(), entries.end(),
                                     [&](const Table& entry) { return scenario::text_in(entry, "name") == name; });
    if (count > 1 || (count == 1 && found)) return std::nullopt;
    if (count == 1) found = kind.table;
  }
  return found;
}

base::Result<scenario::Document> with_line_renamed(scenario::Document document, const scenario::Program& program,
                                                   const std::string& table, const std::string& name,
                                                   const std::string& to) {
  if (base::trimmed(to).empty()) return scenario::edit_refused(name, "give it a name");
  if (to == name) return document;
  Entries entries = scenario::entries_of(document.input, table);
  if (scenario::entry_named(entries, to) != entries.end())
    return scenario::edit_refused(to, "another one has this name already; give another name");
  const auto entry = scenario::entry_named(entries, name);
  if (entry == entries.end()) return scenario::edit_refused(name, "the document holds no such line");
  entry->set("name", to);
  scenario::set_entries(document.input, table, std::move(entries));
  // Its own kind's pieces, and all that names a line of its kind.
  rename_in(document.input, program.input_fields, table, name, to);
  for (std::size_t part = 1; part <= document.steps.size(); ++part) {
    Table parameters = table_of(document, part);
    rename_in(parameters, fields_of(document, program, part), table, name, to);
    if (parameters != table_of(document, part)) document = with_table(std::move(document), part, std::move(parameters));
  }
  return document;
}

base::Result<scenario::Document> with_line_of_kind(scenario::Document document, const scenario::Program& program,
                                                   const std::string& table, const std::string& name,
                                                   const std::string& to) {
  if (to == table) return document;
  Entries from = scenario::entries_of(document.input, table);
  const auto entry = scenario::entry_named(from, name);
  if (entry == from.end()) return scenario::edit_refused(name, "the document holds no such line");
  Entries there = scenario::entries_of(document.input, to);
  if (scenario::entry_named(there, name) != there.end())
    return scenario::edit_refused(name, "another one has this name already; give another name");
  Table made = *entry;
  const std::vector<scenario::Field>* fields = fields_of_table(program, to);
  for (const auto& each : entry->entries()) {
    const bool known = fields == nullptr || std::any_of(fields->begin(), fields->end(),
                                                        [&](const auto& field) { return field.key == each.key; });
    if (!known) made.erase(each.key);
  }
  there.push_back(std::move(made));
  from.erase(entry);
  scenario::set_entries(document.input, table, std::move(from));
  scenario::set_entries(document.input, to, std::move(there));
  return document;
}

}  // namespace dobra::gui::documents
