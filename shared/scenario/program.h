#pragma once
// What a program tells the shared machinery (runner, command line, window): its input and its operations, each with
// what it adds to a state's picture, numbers, tables, remarks and files. Plain functions in a table; the state itself
// is opaque here.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "shared/base/progress.h"
#include "shared/scenario/document.h"
#include "shared/scenario/field.h"
#include "shared/scenario/importing.h"
#include "shared/scene/layer.h"
#include "shared/scene/pick.h"
#include "shared/scene/space/picture.h"

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

/// What a state tells of one part of it: each adds its own, and nothing where the state does not have that part. In SI.
/// Any may be left out.
struct Results {
  std::function<void(const State&, std::vector<Quantity>&)> quantities{};
  std::function<void(const State&, std::vector<DataTable>&)> tables{};
  std::function<void(const State&, std::vector<std::string>&)>
      remarks{};  ///< What the user should know: repairs, limits.
  /// Exchange files, without tables, report and pictures.
  std::function<void(const State&, std::vector<Output>&)> outputs{};
  std::function<void(const State&, scene::Picture&)> draw{};
  /// What stands in space.
  std::function<void(const State&, scene::space::SpacePicture&)> draw_space{};
  /// Whether it reached what it was asked to (an error, say); nothing if nothing was asked. `run` ends with 1 if not.
  std::function<std::optional<bool>(const State&)> reached{};
};

/// Results of a program's own type of model.
template <class Model>
struct ResultsOf {
  void (*quantities)(const Model&, std::vector<Quantity>&) = nullptr;
  void (*tables)(const Model&, std::vector<DataTable>&) = nullptr;
  void (*remarks)(const Model&, std::vector<std::string>&) = nullptr;
  void (*outputs)(const std::shared_ptr<const Model>&, std::vector<Output>&) = nullptr;
  void (*draw)(const Model&, scene::Picture&) = nullptr;
  void (*draw_space)(const Model&, scene::space::SpacePicture&) = nullptr;
  std::optional<bool> (*reached)(const Model&) = nullptr;
};

template <class Model>
Results make_results(const ResultsOf<Model>& of) {
  Results results;
  const auto adder = [](auto add) {
    return [add](const State& state, auto& list) { add(model_of<Model>(state), list); };
  };
  if (of.quantities) results.quantities = adder(of.quantities);
  if (of.tables) results.tables = adder(of.tables);
  if (of.remarks) results.remarks = adder(of.remarks);
  if (of.draw) results.draw = adder(of.draw);
  if (of.draw_space) results.draw_space = adder(of.draw_space);
  if (of.outputs) {
    results.outputs = [add = of.outputs](const State& state, std::vector<Output>& list) {
      add(std::static_pointer_cast<const Model>(state), list);
    };
  }
  if (of.reached) results.reached = [ask = of.reached](const State& state) { return ask(model_of<Model>(state)); };
  return results;
}

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
  Results results{};                            ///< What of a state this operation has made.
};

/// Wraps `Result<Model> run(const Model&, const Params&, const Context&, const Progress&)`.
template <class Model, class Params>
Operation make_operation(std::string name, std::string title, std::string help,
                         base::Result<Model> (*run)(const Model&, const Params&, const Context&, const base::Progress&),
                         const ResultsOf<Model>& results = {}) {
  return {std::move(name),
          std::move(title),
          std::move(help),
          fields_of<Params>(),
          [run](const State& state, const Table& table, const Context& context,
                const base::Progress& progress) -> base::Result<State> {
            DOBRA_TRY(Model model, run(model_of<Model>(state), from_table<Params>(table), context, progress));
            return make_state(std::move(model));
          },
          {},
          {},
          make_results(results)};
}

/// How lines of the picture are edited in a window: every edit is a function document -> document. Lines in SI, as the
/// picture of the input shows them.
struct Drawing {
  struct Kind {
    std::string table;  ///< Of the input: "horizon".
    std::string title;  ///< "Horizon"
    enum class Of { Lines, Polygons, Points } of = Of::Lines;
    std::string names{};  ///< What of a state (names_of) has none of its names twice, read from files or not.
  };
  std::vector<Kind> kinds{};  ///< What a user may draw; empty: nothing.
  std::string height = "z";   ///< What the second coordinate of the pictures is called.
  /// @param input  the state that the input makes.
  /// @error BadValue: a line that the document does not hold by itself, with what to do.
  std::function<base::Result<Document>(const Document& document, const State& input, std::span<const scene::LineEdit>)>
      edit{};
  /// With one more line. @error BadValue: the name is taken.
  std::function<base::Result<Document>(const Document& document, const std::string& table, const std::string& name,
                                       const geom::Polyline&)>
      add{};
  /// What an edit of the input in a form is to take along, so that the rest looks as before; may be left out.
  /// @param input  the state of `before`.
  std::function<Document(const Document& before, Document after, const State& input)> settle{};
  /// How long one of the document's coordinates is in the pictures: 0.3048 for feet. Left out: 1.
  std::function<double(const Document&)> unit_length{};
  /// What a line is called that shares its layer with others; empty: as its layer. May be left out.
  std::function<std::string(const State& input, const scene::Pick&)> name_of{};
};

enum class TakesUnits { SiOnly, Any };

struct Program {
  std::string name;   ///< "recon"
  std::string title;  ///< "RECON"
  TakesUnits takes_units = TakesUnits::SiOnly;
  std::vector<Field> input_fields;
  std::function<base::Result<State>(const Table& input, const Context&, const base::Progress&)> read_input;
  /// What an input draws that read_input may refuse, unjudged, as far as it can be read; may be left out.
  std::function<void(const Table& input, const Context&, scene::Picture&)> draw_input{};
  /// The same of what stands in space; may be left out.
  std::function<void(const Table& input, const Context&, scene::space::SpacePicture&)> draw_input_in_space{};
  /// Whether an input holds nothing yet that a run could begin with; left out: an empty one.
  std::function<bool(const Table& input)> nothing_yet{};
  std::vector<Operation> operations;
  Results results;  ///< What the input has made, and what all operations have in common.
  /// The units that pictures, quantities, tables and remarks are turned into; left out: SI.
  std::function<UnitSystem(const State&)> units_of{};
  /// What of a state is called `what` (FieldOptions::names), for forms that offer it; may be left out.
  std::function<std::vector<std::string>(const State&, const std::string& what)> names_of{};
  /// The name of a `what` (FieldOptions::names) of a state whose line was pointed at, or that lies at the place; empty:
  /// there is none. May be left out.
  std::function<std::string(const State&, const std::string& what, const std::optional<scene::Pick>& line,
                            geom::Point at)>
      name_at{};
  Drawing drawing{};
  Importing importing{};

  // What a state tells in all: the input's part, then that of each operation in the order of the list.
  [[nodiscard]] scene::Picture picture_of(const State& state) const;
  /// Nothing where no part has a layer in space.
  [[nodiscard]] std::optional<scene::space::SpacePicture> space_of(const State& state) const;
  /// What the input of a document draws where there is no state to draw; without panels if that is nothing.
  [[nodiscard]] scene::Picture picture_of_input(const Document& document) const;
  [[nodiscard]] std::optional<scene::space::SpacePicture> space_of_input(const Document& document) const;
  [[nodiscard]] std::vector<Quantity> quantities_of(const State& state) const;
  [[nodiscard]] std::vector<DataTable> tables_of(const State& state) const;
  [[nodiscard]] std::vector<std::string> remarks_of(const State& state) const;
  [[nodiscard]] std::vector<Output> outputs_of(const State& state) const;
  /// No, if one part says so; yes, if one says yes and none no.
  [[nodiscard]] std::optional<bool> reached(const State& state) const;

  [[nodiscard]] const Operation* find_operation(const std::string& operation) const;
};

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

/// What is set in the document and has no effect beside what else is set (FieldOptions::when), each with its part:
/// "step 2 (restore): 'angle' has no effect with method = constant".
std::vector<std::string> without_effect(const Document& document, const Program& program);

}  // namespace dobra::scenario
