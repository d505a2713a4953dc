#include "shared/scenario/runner.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>

#include "shared/scenario/toml_text.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

/// Size and time of the files that a table names, so that a changed file counts as a changed parameter.
std::string file_marks(const Table& table, const std::vector<Field>& fields, const std::filesystem::path& folder) {
  std::string marks;
  for (const Field& field : fields) {
    const Value* value = table.find(field.key);
    const Value* present = value != nullptr ? value : field.default_value ? &*field.default_value : nullptr;
    if (present == nullptr) continue;
    if (const auto* rows = std::get_if<std::vector<Table>>(present)) {
      for (const Table& row : *rows) marks += file_marks(row, field.fields, folder);
    }
    const auto* name = std::get_if<std::string>(present);
    if (field.kind != Kind::File || name == nullptr || name->empty()) continue;
    struct stat status {};
    const std::filesystem::path path = folder / *name;
    if (::stat(path.c_str(), &status) != 0) {
      marks += fmt::format("# {} missing\n", value_toml(path.string()));
    } else {
      marks += fmt::format("# {} {} {}.{:09}\n", value_toml(path.string()), status.st_size, status.st_mtim.tv_sec,
                           status.st_mtim.tv_nsec);
    }
  }
  return marks;
}

std::string input_key(const Context& context) {
  return fmt::format("{} {} {}", context.folder.string(), context.units.text(), context.shown_units.text());
}

base::Place input_place(const Document& document) {
  base::Place place = document.input.own_place;
  if (place.file.empty()) place.file = document.file.string();
  place.item = "input";
  return place;
}

base::Place step_place(const Document& document, std::size_t number) {
  base::Place place = document.steps[number - 1].place;
  if (place.file.empty()) place.file = document.file.string();
  place.item = step_label(document, number);
  return place;
}

/// @error CannotSolve naming the first number of a state that is none: reports and tables hold finite numbers only.
base::Result<void> check_numbers(const Program& program, const State& state) {
  const auto refuse = [](const std::string& what, double value) {
    return Error{
        ErrorCode::CannotSolve,
        fmt::format("{} came out as {}, which is no finite number; nothing of this step is written", what, value)};
  };
  for (const Quantity& quantity : program.quantities_of(state)) {
    if (!std::isfinite(quantity.value)) return refuse(fmt::format("'{}'", quantity.name), quantity.value);
  }
  for (const DataTable& table : program.tables_of(state)) {
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
        const double* number = std::get_if<double>(&table.rows[r][c]);
        if (number == nullptr || std::isfinite(*number)) continue;
        return refuse(fmt::format("'{}' in row {} of the table '{}'", table.columns[c], r + 1, table.name), *number);
      }
    }
  }
  return {};
}

}  // namespace

const State* Runner::recall(const Key& key, std::uint64_t& number) {
  const auto [first, last] = remembered_.equal_range(key.text);
  const auto found = std::find_if(first, last, [&](const auto& known) { return known.second.table == key.table; });
  if (found == last) return nullptr;
  found->second.last_used = runs_;
  number = found->second.number;
  return &found->second.state;
}

void Runner::remember(Key key, State state, std::uint64_t& number) {
  number = next_number_++;
  remembered_.emplace(std::move(key.text), Remembered{std::move(key.table), std::move(state), number, runs_});
  ++computed_;
}

void Runner::forget() {
  std::vector<std::pair<std::uint64_t, std::uint64_t>>
      spare;  // last use and number of states that this run did not need
  for (const auto& [key, known] : remembered_) {
    if (known.last_used != runs_) spare.emplace_back(known.last_used, known.number);
  }
  if (spare.size() <= spare_states) return;
  // The oldest go first; among equals the later steps, without which the earlier ones are still of use.
  std::sort(spare.begin(), spare.end(),
            [](const auto& a, const auto& b) { return a.first != b.first ? a.first < b.first : a.second > b.second; });
  spare.resize(spare.size() - spare_states);
  std::erase_if(remembered_, [&](const auto& known) {
    return std::find(spare.begin(), spare.end(), std::pair(known.second.last_used, known.second.number)) != spare.end();
  });
}

Run Runner::run(const Document& document, const base::Progress& progress) {
  Run run;
  computed_ = 0;
  ++runs_;
  std::uint64_t before = 0;
  const Context context{document.folder(), document.units, document.shown_units()};
  const double total = static_cast<double>(document.steps.size() + 1);
  const auto fail = [&](std::size_t step, Error error) {
    run.failed_step = step;
    run.error = base::located(in_units(std::move(error), document.units),
                              step == 0 ? input_place(document) : step_place(document, step));
  };

  /// State number k, 0 being the input.
  const auto advance = [&](std::size_t k) -> base::Result<void> {
    DOBRA_TRY_VOID(progress.check());
    const Operation* operation = nullptr;
    if (k == 0) {
      DOBRA_TRY_VOID(check_program(document, program_));
      DOBRA_TRY_VOID(check(document.input, fields_in(program_.input_fields, document.units), "input"));
    } else {
      DOBRA_TRY(operation, operation_of(document, k, program_));
      DOBRA_TRY_VOID(
          check(document.steps[k - 1].params, fields_in(operation->fields, document.units), step_label(document, k)));
    }
    const Table& table = k == 0 ? document.input : document.steps[k - 1].params;
    const std::vector<Field>& fields = k == 0 ? program_.input_fields : operation->fields;
    Key key{fmt::format("{} {}\n{}", before, k == 0 ? input_key(context) : operation->name,
                        file_marks(table, fields, context.folder)),
            table};
    if (const State* known = recall(key, before)) {
      run.states.push_back(*known);
      return {};
    }
    const base::Progress part = progress.part(static_cast<double>(k) / total, static_cast<double>(k + 1) / total);
    part.report(0.0, k == 0 ? "input" : operation->title);
    const Table si = in_si(table, fields, document.units);
    DOBRA_TRY(State state,
              k == 0 ? program_.read_input(si, context, part) : operation->run(run.states.back(), si, context, part));
    DOBRA_TRY_VOID(check_numbers(program_, state));
    if (!progress.cancelled())
      remember(std::move(key), state, before);  // what an interrupted step gave is not its result
    run.states.push_back(std::move(state));
    return {};
  };

  for (std::size_t k = 0; k <= document.steps.size(); ++k) {
    if (const auto advanced = advance(k); !advanced) {
      fail(k, advanced.error());
      break;
    }
  }
  if (run.complete()) progress.report(1.0);
  forget();
  return run;
}

}  // namespace dobra::scenario
