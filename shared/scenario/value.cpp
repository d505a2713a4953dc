#include "shared/scenario/value.h"

#include <algorithm>

#include "shared/scenario/toml_text.h"

namespace dobra::scenario {
namespace {

template <class Entries>
auto locate(Entries& entries, std::string_view key) {
  return std::find_if(entries.begin(), entries.end(), [&](const Table::Entry& entry) { return entry.key == key; });
}

bool is_tables(const Value& value) {
  const auto* tables = std::get_if<std::vector<Table>>(&value);
  return tables != nullptr && !tables->empty();
}

bool equal(const Value& a, const Value& b) {
  if (is_tables(a) || is_tables(b)) return a == b;
  return value_toml(a) == value_toml(b);
}

/// Files hold plain keys before nested tables, so the order between the two kinds does not count.
std::vector<const Table::Entry*> in_file_order(const Table& table) {
  std::vector<const Table::Entry*> order;
  for (const Table::Entry& entry : table.entries()) order.push_back(&entry);
  std::stable_partition(order.begin(), order.end(), [](const Table::Entry* entry) { return !is_tables(entry->value); });
  return order;
}

}  // namespace

const Value* Table::find(std::string_view key) const {
  const auto entry = locate(entries_, key);
  return entry == entries_.end() ? nullptr : &entry->value;
}

const base::Place& Table::place(std::string_view key) const {
  const auto entry = locate(entries_, key);
  return entry == entries_.end() ? own_place : entry->place;
}

void Table::set(std::string_view key, Value value) { set(key, std::move(value), place(key)); }

void Table::set(std::string_view key, Value value, base::Place place) {
  const auto entry = locate(entries_, key);
  if (entry == entries_.end()) {
    entries_.push_back({std::string(key), std::move(value), std::move(place), {}});
  } else {
    entry->value = std::move(value);
    entry->place = std::move(place);
  }
}

void Table::set_comment(std::string_view key, std::string text) {
  const auto entry = locate(entries_, key);
  if (entry != entries_.end()) entry->comment = std::move(text);
}

void Table::erase(std::string_view key) {
  const auto entry = locate(entries_, key);
  if (entry != entries_.end()) entries_.erase(entry);
}

bool operator==(const Table& a, const Table& b) {
  const auto left = in_file_order(a);
  const auto right = in_file_order(b);
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const auto* x, const auto* y) { return x->key == y->key && equal(x->value, y->value); });
}

}  // namespace dobra::scenario
