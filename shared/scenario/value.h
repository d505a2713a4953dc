#pragma once
// Values of parameters as they stand in a scenario file: typed, ordered, each with its place in the file.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shared/base/error.h"
#include "shared/geom/point.h"
#include "shared/geom/point3.h"
#include "shared/scenario/points.h"

namespace dobra::scenario {

class Table;

/// One value. Integers written where a number is meant are stored as they are written and read as numbers; a list of
/// numbers in a file is always vector<double> (the reader cannot know that [1, 2] or [1, 2, 3] is meant as a point),
/// and an empty list is an empty vector<double>.
using Value = std::variant<bool, std::int64_t, double, std::string, geom::Point, std::vector<double>, Points,
                           std::vector<geom::Point3>, std::vector<std::string>, std::vector<Table>>;

/// Keys and values in the order in which they were written. Equality ignores places and comments, and takes values as
/// equal that are written with the same text: a point and a list of its two numbers, empty lists of any kind. Copies
/// share their entries until one is changed; points put in the place of others share the runs that are the same.
class Table {
 public:
  struct Entry;

  [[nodiscard]] const Value* find(std::string_view key) const;
  /// Where the value of `key` stands in the file; the table's own place if the key is absent.
  [[nodiscard]] const base::Place& place(std::string_view key) const;
  /// Replaces the value of `key` (its place stays) or appends it.
  void set(std::string_view key, Value value);
  void set(std::string_view key, Value value, base::Place place);
  void set_comment(std::string_view key, std::string text);
  void erase(std::string_view key);

  [[nodiscard]] const std::vector<Entry>& entries() const;
  [[nodiscard]] bool empty() const { return entries().empty(); }

  base::Place own_place;  ///< Of the table's header.
  std::string comment;    ///< Comment lines above the header, without "# ", joined by newlines. Used for nested tables.

  friend bool operator==(const Table& a, const Table& b);

 private:
  [[nodiscard]] std::vector<Entry>& own_entries();

  std::shared_ptr<std::vector<Entry>> entries_;  ///< Null: none.
};

struct Table::Entry {
  std::string key;
  Value value;
  base::Place place;
  std::string comment;  ///< Comment lines above the key (or behind the value) in the file.
};

}  // namespace dobra::scenario
