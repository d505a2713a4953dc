#include "quebra/solids/tree_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace quebra::solids {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;

struct Made {
  std::size_t step = 0;
  std::vector<std::string> of;
};

std::vector<std::string> texts_of(const scenario::Value* value) {
  const auto* const texts = value == nullptr ? nullptr : std::get_if<std::vector<std::string>>(value);
  return texts == nullptr ? std::vector<std::string>{} : *texts;
}

/// The names from `start` back to itself; empty if it is not made of itself.
std::vector<std::string> cycle_from(const std::string& start, const std::map<std::string, Made>& parts) {
  // A way in breadth first, so that the shortest cycle is told.
  std::map<std::string, std::string> before;
  std::vector<std::string> open{start};
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto found = parts.find(open[i]);
    if (found == parts.end()) continue;
    for (const std::string& name : found->second.of) {
      if (name == start) {
        std::vector<std::string> way{start};
        for (std::string at = open[i]; at != start; at = before[at]) way.push_back(at);
        way.push_back(start);
        std::reverse(way.begin(), way.end());
        return way;
      }
      if (before.try_emplace(name, open[i]).second) open.push_back(name);
    }
  }
  return {};
}

}  // namespace

base::Result<void> check_tree(const scenario::Document& document) {
  std::map<std::string, Made> parts;
  for (std::size_t i = 0; i < document.steps.size(); ++i) {
    const scenario::Table& params = document.steps[i].params;
    const scenario::Value* const value = params.find("part");
    const auto* const name = value == nullptr ? nullptr : std::get_if<std::string>(value);
    if (name != nullptr) parts.try_emplace(*name, Made{i, texts_of(params.find("of"))});
  }
  for (std::size_t i = 0; i < document.steps.size(); ++i) {
    const scenario::Table& params = document.steps[i].params;
    const scenario::Value* const value = params.find("part");
    const auto* const own = value == nullptr ? nullptr : std::get_if<std::string>(value);
    base::Place place = params.place("of");
    place.item = scenario::step_label(document, i + 1);
    if (own != nullptr) {
      if (const auto way = cycle_from(*own, parts); !way.empty()) {
        return Error{ErrorCode::BadValue,
                     fmt::format("recursion: part '{}' is made of itself ('{}')", *own, fmt::join(way, "' of '")),
                     place};
      }
    }
    for (const std::string& name : texts_of(params.find("of"))) {
      const auto made = parts.find(name);
      if (made == parts.end() || made->second.step < i) continue;
      return Error{ErrorCode::BadValue,
                   fmt::format("part '{}' is made only by {}: move that step before this one", name,
                               scenario::step_label(document, made->second.step + 1)),
                   place};
    }
  }
  return {};
}

}  // namespace quebra::solids
