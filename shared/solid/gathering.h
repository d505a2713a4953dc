#pragma once
// All operands of an operation in one space, with one list of names.

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "shared/solid/box_tree.h"
#include "shared/solid/solid.h"

namespace dobra::solid {

class Gathering {
 public:
  explicit Gathering(std::span<const Solid> operands);
  Soup soup;
  std::vector<std::string> names;
  std::vector<BoxTree> trees;

 private:
  void add(const Boundary& boundary, std::uint32_t operand);
  std::uint32_t name_number(const std::string& name);
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

}  // namespace dobra::solid
