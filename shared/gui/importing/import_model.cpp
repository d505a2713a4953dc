#include "shared/gui/importing/import_model.h"

#include <algorithm>
#include <utility>

#include "shared/base/text.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/scenario/lines/import_rules.h"

namespace dobra::gui::importing {

using scenario::ImportLine;
using scenario::ImportShape;

ImportModel::ImportModel(const scenario::Program& program, scenario::Document document,
                         const std::vector<std::filesystem::path>& files)
    : program_(program), document_(std::move(document)) {
  for (const std::filesystem::path& path : files) {
    File& file = files_.emplace_back();
    file.said.file = std::filesystem::absolute(path).lexically_normal();
    file.look = importing().look(document_, file.said.file, {});
    choose(file);
  }
}

std::vector<scenario::Importing::Kind> ImportModel::kinds_for(ImportShape shape) const {
  std::vector<scenario::Importing::Kind> kinds = importing().kinds;
  std::erase_if(kinds, [&](const auto& kind) { return !kind.shapes.contains(shape); });
  return kinds;
}

void ImportModel::choose(File& file) const {
  const std::vector<ImportLine>& lines = file.look.lines;
  file.said.choices = scenario::lines::choices_by(file.said.rules, file.look, importing().kinds);
  file.from.assign(lines.size(), KindFrom::Shape);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ImportLine& line = lines[i];
    if (line.told_by == scenario::ToldBy::File) file.from[i] = KindFrom::File;
    if (line.told_by == scenario::ToldBy::Name) file.from[i] = KindFrom::Name;
    const bool ruled = std::any_of(file.said.rules.begin(), file.said.rules.end(), [&](const auto& rule) {
      return rule.kind == file.said.choices[i].kind && io::lines::fits(rule.pattern, line.name);
    });
    if (ruled) file.from[i] = KindFrom::Rule;
    if (const auto own = file.kinds.find(key_of(line)); own != file.kinds.end()) {
      file.said.choices[i].kind = own->second;
      file.from[i] = KindFrom::User;
    }
    if (file.left_out.contains(key_of(line))) file.said.choices[i].taken = false;
  }
}

void ImportModel::read_as(std::size_t index, const scenario::ImportReading& reading) {
  File& file = files_[index];
  if (file.said.reading == reading) return;
  file.said.reading = reading;
  file.look = importing().look(document_, file.said.file, reading);
  choose(file);
}

void ImportModel::read_all_as(std::size_t index) {
  const scenario::ImportReading& like = files_[index].said.reading;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (i == index || files_[i].look.picture || !files_[i].look.asks_reading) continue;
    scenario::ImportReading reading = like;
    if (!files_[i].look.table) reading.x = reading.map_y = reading.height = reading.names = 0;
    if (!files_[i].look.table) reading.separator.clear();
    read_as(i, reading);
  }
}

void ImportModel::take_lines(std::size_t index, const std::vector<std::size_t>& lines, bool taken) {
  File& file = files_[index];
  for (const std::size_t i : lines) {
    if (taken)
      file.left_out.erase(key_of(file.look.lines[i]));
    else
      file.left_out.insert(key_of(file.look.lines[i]));
  }
  choose(file);
}

std::size_t ImportModel::set_kind(std::size_t index, const std::vector<std::size_t>& lines, const std::string& kind) {
  File& file = files_[index];
  std::size_t count = 0;
  for (const std::size_t i : lines) {
    const auto kinds = kinds_for(file.look.lines[i].shape);
    if (std::none_of(kinds.begin(), kinds.end(), [&](const auto& known) { return known.name == kind; })) continue;
    file.kinds[key_of(file.look.lines[i])] = kind;
    ++count;
  }
  choose(file);
  return count;
}

std::size_t ImportModel::add_rule(std::size_t index, const scenario::ImportRule& rule) {
  File& file = files_[index];
  std::size_t count = 0;
  for (const ImportLine& line : file.look.lines) {
    if (!io::lines::fits(rule.pattern, line.name)) continue;
    ++count;
    const auto kinds = kinds_for(line.shape);
    if (std::any_of(kinds.begin(), kinds.end(), [&](const auto& known) { return known.name == rule.kind; }))
      file.kinds.erase(key_of(line));
  }
  if (count == 0) return 0;
  std::erase_if(file.said.rules, [&](const auto& other) { return other.pattern == rule.pattern; });
  file.said.rules.insert(file.said.rules.begin(), rule);
  choose(file);
  return count;
}

void ImportModel::drop_rules(std::size_t index) {
  files_[index].said.rules.clear();
  choose(files_[index]);
}

base::Result<scenario::Imported> ImportModel::result() const {
  scenario::Imported all{document_, {}};
  bool any = false;
  for (const File& file : files_) {
    if (!file.taken) continue;
    any = true;
    auto made = importing().take_in(std::move(all.document), file.look, file.said);
    if (!made) return made.error();
    all.document = std::move(made->document);
    all.notes.insert(all.notes.end(), made->notes.begin(), made->notes.end());
  }
  if (!any) return base::Error{base::ErrorCode::BadValue, base::translated("no file is chosen; tick one")};
  return all;
}

}  // namespace dobra::gui::importing
