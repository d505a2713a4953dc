#pragma once
// Options that are parameters: "--pin-error" is the field pin_error, with the title, help, unit, range, choices and
// default of its description. So an operation is described once for scenarios, windows and the command line.

#include <memory>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace CLI {
class App;
}

namespace dobra::cli {

class ParameterOptions {
 public:
  /// @param keys  of the fields that become options, in this order; all where it is empty.
  /// @pre   this object stays where it is while the app is in use.
  void add(CLI::App& app, const std::vector<scenario::Field>& fields, const std::vector<std::string>& keys = {});

  /// What the user gave, read into a table by the fields (in the units of the scenario). Files are named from where the
  /// user stands. @error BadValue for a number out of range, else BadUsage; both name the option.
  [[nodiscard]] base::Result<void> set(const std::vector<scenario::Field>& fields, scenario::Table& params) const;
  [[nodiscard]] bool any() const;

 private:
  struct Given {
    std::string key;
    std::vector<std::string> words;
    bool flag = false;  ///< Of a flag: it was given.
  };
  std::vector<std::unique_ptr<Given>> given_;
};

}  // namespace dobra::cli
