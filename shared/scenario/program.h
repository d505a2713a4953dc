#pragma once
// What a program tells the shared machinery (runner, command line, window): its input, its operations, and how a state
// is drawn, measured and written. Plain functions in a table; the state itself is opaque here.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shared/base/progress.h"
#include "shared/scenario/document.h"
#include "shared/scenario/field.h"
#include "shared/scene/layer.h"

namespace dobra::scenario {

/// An immutable model of the program's own type, shared between documents, caches and windows.
using State = std::shared_ptr<const void>;

template <class Model>
State make_state(Model model) {
  return std::make_shared<const Model>(std::move(model));
}
template <class Model>
const Model& model_of(const State& state) {
  return *static_cast<const Model*>(state.get());
}

/// What surrounds a run.
struct Context {
  std::filesystem::path folder;  ///< Relative file names start here.
  UnitSystem units = {};         ///< Of the document, and so of files that do not say theirs. Parameters come in SI.
  UnitSystem shown_units = {};   ///< In which pictures, quantities, tables and exchange files are to be.
};

/// One thing that a user can do to a model: a pure function of the model and the parameters.
struct Operation {
  std::string name;   ///< As in scenario files: "grid".
  std::string title;  ///< As in menus: "Offset grid".
  std::string help;   ///< One or two sentences.
  std::vector<Field> fields;
  std::function<base::Result<State>(const State&, const Table&, const Context&, const base::Progress&)> run;
  /// The parameter that stops the work after so many steps, so that it can be watched; empty if there is none.
  std::string stop_after{};
  std::function<bool(const State&)> at_work{};  ///< Whether it was stopped so, and not done.
};

/// Wraps `Result<Model> run(const Model&, const Params&, const Context&, const Progress&)`.
template <class Model, class Params>
Operation make_operation(std::string name, std::string title, std::string help,
                         base::Result<Model> (*run)(const Model&, const Params&, const Context&,
                                                    const base::Progress&)) {
  return {std::move(name), std::move(title), std::move(help), fields_of<Params>(),
          [run](const State& state, const Table& table, const Context& context,
                const base::Progress& progress) -> base::Result<State> {
            DOBRA_TRY(Model model, run(model_of<Model>(state), from_table<Params>(table), context, progress));
            return make_state(std::move(model));
          }};
}

/// A number that a state has: what expectations refer to and reports list.
struct Quantity {
  std::string name;  ///< Dotted, stable: "horizon.top.length_after".
  double value = 0.0;
  std::string unit;  ///< "m", "m2", "%"; empty if none.
};

/// Written as CSV and into report.json.
struct DataTable {
  std::string name;                  ///< File name without ending: "line_length".
  std::vector<std::string> columns;  ///< With the unit in square brackets: "length_before [m]".
  std::vector<std::vector<std::variant<double, std::string>>> rows;
};

/// A file that a state can be written to.
struct Output {
  std::string file_name;
  std::function<base::Result<void>(const std::filesystem::path&)> write;
  std::vector<std::string> losses = {};  ///< What the file leaves out or renames, a line each, for the user.
};

enum class TakesUnits { SiOnly, Any };

struct Program {
  std::string name;   ///< "recon"
  std::string title;  ///< "RECON"
  TakesUnits takes_units = TakesUnits::SiOnly;
  std::vector<Field> input_fields;
  std::function<base::Result<State>(const Table& input, const Context&, const base::Progress&)> read_input;
  std::vector<Operation> operations;
  std::function<scene::Picture(const State&)> picture_of;
  std::function<std::vector<Quantity>(const State&)> quantities_of;
  std::function<std::vector<std::string>(const State&)> remarks_of;  ///< What the user should know: repairs, limits.
  /// Whether the steps reached what they were asked to (an error, say); nothing if nothing was asked. `run` ends with 1
  /// otherwise.
  std::function<std::optional<bool>(const State&)> reached_of{};
  std::function<std::vector<DataTable>(const State&)> tables_of;
  std::function<std::vector<Output>(const State&)>
      outputs_of;  ///< Exchange files, without tables, report and pictures.

  [[nodiscard]] const Operation* find_operation(const std::string& operation) const;
};

/// That of a state, or nothing.
std::optional<bool> reached(const Program& program, const State& state);

/// The picture; a sheet without a title is called after the document, or after the document's file.
scene::Picture titled(scene::Picture picture, const Document& document);

/// The operation of step `number` (1-based).
/// @error UnknownOperation, with a suggestion and the step's place.
base::Result<const Operation*> operation_of(const Document& document, std::size_t number, const Program& program);

/// @error WrongProgram if the document is for another program.
base::Result<void> check_program(const Document& document, const Program& program);

/// Judges program name, input and all parameters against the program's fields, without running anything.
/// @error WrongProgram, UnknownOperation (with a suggestion), and those of check(), each with its place.
base::Result<void> check(const Document& document, const Program& program);

}  // namespace dobra::scenario
