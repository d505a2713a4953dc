#include "shared/io/formats/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "shared/io/file.h"

namespace dobra::io::formats {
namespace {

bool has_ending(const Format& format, const std::string& ending) {
  return std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end();
}

const Format* find(Use use, const auto& wanted) {
  const std::vector<Format>& all = all_formats();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Format& format) { return is_for(format, use) && wanted(format); });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

bool is_for(const Format& format, Use use) {
  switch (use) {
    case Use::ReadLines:
      return format.lines && (format.lines->parse != nullptr || format.lines->read != nullptr);
    case Use::WriteLines:
      return format.lines && (format.lines->text != nullptr || format.lines->write != nullptr);
    case Use::WritePlaneLines:
      return is_for(format, Use::WriteLines) && format.lines->written_as != WrittenAs::MapOnly;
    case Use::WriteLinesToScale:
      return is_for(format, Use::WriteLines) && format.lines->to_scale;
    case Use::ReadMesh:
      return format.mesh && (format.mesh->parse != nullptr || format.mesh->read != nullptr);
    case Use::ReadFields:
      return format.mesh && format.mesh->fields != nullptr;
    case Use::ReadPolygons:
      return format.mesh && format.mesh->polygons != nullptr;
    case Use::WriteMesh:
      return format.mesh && (format.mesh->text != nullptr || format.mesh->write != nullptr);
    case Use::WriteSpaceMesh:
      return format.mesh && format.mesh->space;
    case Use::ReadDrawing:
      break;
  }
  return format.drawing != nullptr;
}

std::vector<std::string> endings_for(Use use) {
  std::vector<std::string> endings;
  for (const Format& format : all_formats()) {
    if (is_for(format, use)) endings.insert(endings.end(), format.endings.begin(), format.endings.end());
  }
  return endings;
}

std::vector<std::string> names_for(Use use) {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) {
    if (is_for(format, use)) names.emplace_back(format.name);
  }
  return names;
}

const Format* format_of(const std::string& path, Use use) {
  return find(use, [ending = ending_of(path)](const Format& format) { return has_ending(format, ending); });
}

const Format* format_named(std::string_view name, Use use) {
  return find(use, [&](const Format& format) { return format.name == name; });
}

std::string formats_markdown() {
  std::string text = "| name | format | endings | holds | read | written | kept |\n|---|---|---|---|---|---|---|\n";
  for (const Format& format : all_formats()) {
    const auto or_no = [](std::string_view what) { return what.empty() ? "no" : what; };
    text += fmt::format("| `{}` | {} | `{}` | {} | {} | {} | {} |\n", format.name, format.title,
                        fmt::join(format.endings, "` `"),
                        format.lines     ? "lines"
                        : !format.mesh   ? "drawing"
                        : format.drawing ? "drawing, mesh"
                                         : "mesh",
                        or_no(format.read), or_no(format.written), format.kept);
  }
  return text;
}

}  // namespace dobra::io::formats
