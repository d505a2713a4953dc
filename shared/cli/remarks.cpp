#include "shared/cli/remarks.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <string_view>

namespace dobra::cli {

namespace {

constexpr std::size_t most = 5, shown = 3;

/// Without numbers, and without names but those of faults.
std::string kind_of(std::string_view remark) {
  std::string kind;
  for (std::size_t i = 0; i < remark.size(); ++i) {
    const auto c = static_cast<unsigned char>(remark[i]);
    const std::size_t end = c == '\'' ? remark.find('\'', i + 1) : std::string_view::npos;
    const bool opens = i == 0 || std::isalnum(static_cast<unsigned char>(remark[i - 1])) == 0;
    if (opens && end != std::string_view::npos) {
      kind += remark.substr(0, i).ends_with("fault ") ? remark.substr(i, end - i + 1) : "''";
      i = end;
    } else if (std::isdigit(c) != 0) {
      const std::size_t last = remark.find_first_not_of("0123456789.e+-", i);
      i = (last == std::string_view::npos ? remark.size() : last) - 1;
      if (!kind.empty() && kind.back() == '-') kind.pop_back();
      kind += '#';
    } else {
      kind += remark[i];
    }
  }
  return kind;
}

}  // namespace

std::vector<std::string> shortened(const std::vector<std::string>& remarks, const char* where) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < remarks.size(); ++i) {
    const auto [at, fresh] = known.emplace(kind_of(remarks[i]), groups.size());
    if (fresh) groups.emplace_back();
    groups[at->second].push_back(i);
  }
  std::vector<std::string> lines;
  for (const std::vector<std::size_t>& group : groups) {
    const std::size_t count = group.size() > most ? shown : group.size();
    for (std::size_t k = 0; k < count; ++k) lines.push_back(remarks[group[k]]);
    if (count < group.size()) {
      lines.push_back(fmt::format("... and {} more like these ({})", group.size() - count, where));
    }
  }
  return lines;
}

}  // namespace dobra::cli
