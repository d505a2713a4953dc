#include "shared/scenario/entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "shared/base/text.h"

namespace dobra::scenario {

Entries entries_of(const Table& input, const std::string& key) {
  const Value* value = input.find(key);
  const auto* entries = value == nullptr ? nullptr : std::get_if<Entries>(value);
  return entries == nullptr ? Entries() : *entries;
}

void set_entries(Table& input, const std::string& key, Entries entries) {
  if (entries.empty()) {
    input.erase(key);
  } else {
    input.set(key, std::move(entries));
  }
}

Entries::iterator entry_named(Entries& entries, const std::string& name) {
  return std::find_if(entries.begin(), entries.end(), [&](const Table& t) { return text_in(t, "name") == name; });
}

std::string free_name(Entries& entries, const std::string& whole) {
  for (int k = 2;; ++k) {
    std::string name = fmt::format("{} ({})", whole, k);
    if (entry_named(entries, name) == entries.end()) return name;
  }
}

std::string text_in(const Table& entry, std::string_view key) {
  const Value* value = entry.find(key);
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return text == nullptr ? std::string() : *text;
}

std::vector<geom::Point> points_in(const Table& entry) {
  const Value* value = entry.find("points");
  const auto* points = value == nullptr ? nullptr : std::get_if<Points>(value);
  return points == nullptr ? std::vector<geom::Point>() : points->list();
}

base::Error edit_refused(const std::string& name, const char* why) {
  base::Place place;
  place.item = fmt::format("'{}'", name);
  return {base::ErrorCode::BadValue, base::translated(why), place};
}

}  // namespace dobra::scenario
