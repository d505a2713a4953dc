#pragma once
// Options that are parameters: "--pin-error" is the field pin_error, with the title, help, unit, range, choices and
// default of its description. So an operation is described once for scenarios, windows and the command line.
// A choice of no and yes is a flag.

#include <memory>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace CLI {
class App;
}

namespace dobra::cli {

/// Of a number out of its range: 3, a bad value, as in a scenario; or 2, wrong usage.
enum class OutOfRange { BadValue, BadUsage };

/// A field that becomes an option, of the field's name or of another.
struct OptionOf {
  OptionOf(const char* field_key, const char* option_name = "") : key(field_key), name(option_name) {}
  std::string key;
  std::string name;  ///< "--from"; empty: that of the key.
};

class ParameterOptions {
 public:
  explicit ParameterOptions(OutOfRange out_of_range = OutOfRange::BadValue) : out_of_range_(out_of_range) {}

  /// @param wanted  the fields that become options, in this order; all where it is empty.
  /// @pre   this object stays where it is while the app is in use.
  void add(CLI::App& app, const std::vector<scenario::Field>& fields, const std::vector<OptionOf>& wanted = {});

  /// What the user gave, read into a table by the fields (in the units of the scenario). Files are named from where the
  /// user stands. @error BadValue for a number out of range (see OutOfRange), else BadUsage; both name the option.
  [[nodiscard]] base::Result<void> set(const std::vector<scenario::Field>& fields, scenario::Table& params) const;
  [[nodiscard]] bool any() const;

 private:
  struct Given {
    std::string key;
    std::string option;
    std::vector<std::string> words;
    bool flag = false;  ///< Of a flag: it was given.
  };
  [[nodiscard]] base::Result<scenario::Value> value_of(const scenario::Field& field, const Given& given) const;
  OutOfRange out_of_range_;
  std::vector<std::unique_ptr<Given>> given_;
};

/// The options of a struct of parameters that one command has for itself.
template <class P>
class OptionsOf {
 public:
  explicit OptionsOf(OutOfRange out_of_range = OutOfRange::BadValue) : options_(out_of_range) {}
  void add(CLI::App& app, const std::vector<OptionOf>& wanted = {}) {
    options_.add(app, scenario::fields_of<P>(), wanted);
  }
  /// @error as ParameterOptions::set
  [[nodiscard]] base::Result<P> read() const {
    DOBRA_TRY(const scenario::Table table, table_of());
    return scenario::from_table<P>(table);
  }
  /// Only what was given.
  [[nodiscard]] base::Result<scenario::Table> table_of() const {
    scenario::Table table;
    DOBRA_TRY_VOID(options_.set(scenario::fields_of<P>(), table));
    return table;
  }
  [[nodiscard]] bool any() const { return options_.any(); }

 private:
  ParameterOptions options_;
};

}  // namespace dobra::cli
