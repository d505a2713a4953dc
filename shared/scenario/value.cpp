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
  const auto* points = std::get_if<Points>(&a);
  const auto* others = std::get_if<Points>(&b);
  if (points != nullptr && others != nullptr) return *points == *others;
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

const std::vector<Table::Entry>& Table::entries() const {
  static const std::vector<Entry> none;
  return entries_ ? *entries_ : none;
}

std::vector<Table::Entry>& Table::own_entries() {
  if (!entries_)
    entries_ = std::make_shared<std::vector<Entry>>();
  else if (entries_.use_count() > 1)
    entries_ = std::make_shared<std::vector<Entry>>(*entries_);
  return *entries_;
}

const Value* Table::find(std::string_view key) const {
  const auto entry = locate(entries(), key);
  return entry == entries().end() ? nullptr : &entry->value;
}

const base::Place& Table::place(std::string_view key) const {
  const auto entry = locate(entries(), key);
  return entry == entries().end() ? own_place : entry->place;
}

void Table::set(std::string_view key, Value value) {
  base::Place here = place(key);  // by value: the entries may become a copy
  set(key, std::move(value), std::move(here));
}

void Table::set(std::string_view key, Value value, base::Place place) {
  std::vector<Entry>& own = own_entries();
  const auto entry = locate(own, key);
  if (entry == own.end()) {
    own.push_back({std::string(key), std::move(value), std::move(place), {}});
    return;
  }
  const auto* before = std::get_if<Points>(&entry->value);
  const auto* after = std::get_if<Points>(&value);
  if (before != nullptr && after != nullptr) value = Points(after->list(), *before);
  entry->value = std::move(value);
  entry->place = std::move(place);
}

void Table::set_comment(std::string_view key, std::string text) {
  if (find(key) == nullptr) return;
  locate(own_entries(), key)->comment = std::move(text);
}

void Table::erase(std::string_view key) {
  if (find(key) == nullptr) return;
  std::vector<Entry>& own = own_entries();
  own.erase(locate(own, key));
}

bool operator==(const Table& a, const Table& b) {
  if (a.entries_ == b.entries_) return true;
  const auto left = in_file_order(a);
  const auto right = in_file_order(b);
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const auto* x, const auto* y) { return x->key == y->key && equal(x->value, y->value); });
}

}  // namespace dobra::scenario
