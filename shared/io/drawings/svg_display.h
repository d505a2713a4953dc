#pragma once
// Whether an element of an SVG is displayed: the properties `display` and `visibility`. An attribute `style` goes
// before the rules of <style> sheets, and these before an attribute of the property's name; of rules, those of an id go
// before those of a class, and these before those of a name. Source: [svg11], chapters 6 and 11.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shared/io/xml.h"

namespace dobra::io::drawings {

class SvgDisplay {
 public:
  /// Takes the rules of all sheets of the document whose selector is one name, class or id; other rules are left out.
  explicit SvgDisplay(const Xml& xml);

  /// What an element says itself; empty: nothing, or "inherit".
  [[nodiscard]] std::string value(const pugi::xml_node& element, std::string_view property) const;

 private:
  struct Rule {
    std::string selector;  ///< "#id", ".class" or "name".
    std::string declarations;
  };
  void add_sheet(std::string_view sheet);

  std::vector<Rule> rules_;  ///< In the order of the file: the last one of its kind counts.
};

}  // namespace dobra::io::drawings
