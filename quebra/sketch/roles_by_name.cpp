#include "quebra/sketch/roles_by_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "shared/base/text.h"
#include "shared/io/lines/line_kinds.h"

namespace quebra::sketch {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;

namespace {

struct Named {
  const char* name;
  Role role;
};
constexpr std::array<Named, 4> roles{
    {{"outline", Role::Boundary}, {"hole", Role::Hole}, {"internal", Role::Internal}, {"crack", Role::Crack}}};

struct Rule {
  std::string pattern;
  std::optional<Role> role;  ///< Nothing: `word` says what.
  std::string word;
  bool used = false;
};

Result<Rule> rule_of(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
    return Error{ErrorCode::BadValue,
                 fmt::format("kind: '{}' names no pattern and kind; give them as 'C*=crack'", text)};
  const std::string word = text.substr(sign + 1);
  Rule rule{text.substr(0, sign), role_named(word), word};
  if (rule.role || word == "none" || word == "found") return rule;
  std::vector<std::string> words{"none", "found"};
  for (const Named& known : roles) words.emplace_back(known.name);
  return Error{ErrorCode::BadValue,
               fmt::format("kind: '{}': unknown kind '{}'{}; give outline, hole, internal, crack, found or none", text,
                           word, dobra::base::did_you_mean(word, words))};
}

/// Without the curve; an area that it bounds is none then.
void take_out(Sketch& sketch, std::size_t i) {
  const std::string name = sketch.curves[i].name;
  std::erase_if(sketch.areas, [&](const Area& area) {
    return std::find(area.rings.begin(), area.rings.end(), name) != area.rings.end();
  });
  sketch.without_role.erase(name);
  if (sketch.hole_points) sketch.hole_points->curves.erase(name);
  const auto at = static_cast<std::ptrdiff_t>(i);
  sketch.curves.erase(sketch.curves.begin() + at);
  if (!sketch.places.empty()) sketch.places.erase(sketch.places.begin() + at);
}

}  // namespace

std::optional<Role> role_named(std::string_view word) {
  for (const Named& known : roles) {
    if (word == known.name) return known.role;
  }
  return std::nullopt;
}

std::string role_name(Role role) {
  return std::find_if(roles.begin(), roles.end(), [&](const Named& known) { return known.role == role; })->name;
}

Result<void> set_roles(Sketch& sketch, const std::vector<std::string>& texts) {
  std::vector<Rule> rules;
  for (const std::string& text : texts) {
    DOBRA_TRY(rules.emplace_back(), rule_of(text));
  }
  if (rules.empty()) return {};
  for (std::size_t i = sketch.curves.size(); i-- > 0;) {
    Curve& curve = sketch.curves[i];
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&](const Rule& r) { return dobra::io::lines::fits(r.pattern, curve.name); });
    if (rule == rules.end()) continue;
    rule->used = true;
    if (rule->word == "none") {
      take_out(sketch, i);
      continue;
    }
    if (!rule->role) {
      curve.role = Role::Boundary;
      sketch.without_role.insert(curve.name);
      continue;
    }
    curve.role = *rule->role;
    sketch.without_role.erase(curve.name);
    if (sketch.hole_points) sketch.hole_points->curves.erase(curve.name);
  }
  if (sketch.curves.empty()) return Error{ErrorCode::BadValue, "kind: no curve of the file is left; leave fewer out"};
  for (const Rule& rule : rules) {
    if (!rule.used) sketch.remarks.push_back(fmt::format("kind: no curve of the file is called '{}'", rule.pattern));
  }
  return {};
}

}  // namespace quebra::sketch
