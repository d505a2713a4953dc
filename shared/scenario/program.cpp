#include "shared/scenario/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "shared/base/text.h"
#include "shared/scenario/condition.h"
#include "shared/scenario/units.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

base::Result<void> check_names(const Document& document) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < document.steps.size(); ++i) {
    const Step& step = document.steps[i];
    if (step.name.empty() || names.insert(step.name).second) continue;
    base::Place place = step.place;
    place.item = step_label(document, i + 1);
    return Error{ErrorCode::BadValue,
                 fmt::format("another step is called '{}' already; give this one another name", step.name), place};
  }
  for (std::size_t i = 0; i < document.expects.size(); ++i) {
    const Expect& expect = document.expects[i];
    const auto unknown = [&](const std::optional<std::string>& step) { return step && !find_step(document, *step); };
    if (!unknown(expect.step) && !unknown(expect.rate_from)) continue;
    const std::string& step = unknown(expect.step) ? *expect.step : *expect.rate_from;
    base::Place place = expect.place;
    place.item = fmt::format("expectation {}", i + 1);
    const std::vector<std::string> known(names.begin(), names.end());
    return Error{ErrorCode::BadValue,
                 fmt::format("there is no step '{}' among the {} steps{}", step, document.steps.size(),
                             base::did_you_mean(step, known)),
                 place};
  }
  return {};
}

}  // namespace

const Operation* Program::find_operation(const std::string& operation) const {
  const auto found = std::find_if(operations.begin(), operations.end(),
                                  [&](const Operation& known) { return known.name == operation; });
  return found == operations.end() ? nullptr : &*found;
}

scene::Picture titled(scene::Picture picture, const Document& document) {
  if (picture.paper != scene::Paper::A4Landscape || !picture.title.empty()) return picture;
  picture.title = document.title.empty() ? document.file.stem().string() : document.title;
  return picture;
}

namespace {

/// One member of the results of all parts of a program, in order.
template <class List, class Member>
List gathered(const Program& program, const State& state, Member member) {
  List list;
  const auto add = [&](const Results& part) {
    if (part.*member) (part.*member)(state, list);
  };
  add(program.results);
  for (const Operation& operation : program.operations) add(operation.results);
  return list;
}

}  // namespace

scene::Picture Program::picture_of(const State& state) const {
  auto picture = gathered<scene::Picture>(*this, state, &Results::draw);
  return units_of ? in_units(std::move(picture), units_of(state)) : picture;
}

std::optional<scene::space::SpacePicture> Program::space_of(const State& state) const {
  auto picture = gathered<scene::space::SpacePicture>(*this, state, &Results::draw_space);
  if (picture.layers.empty()) return std::nullopt;
  return units_of ? in_units(std::move(picture), units_of(state)) : std::move(picture);
}

scene::Picture Program::picture_of_input(const Document& document) const {
  scene::Picture picture;
  if (!draw_input || !check(document.input, fields_in(input_fields, document.units), {})) return picture;
  const Context context{document.folder(), document.units, document.shown_units()};
  draw_input(in_si(document.input, input_fields, document.units), context, picture);
  return units_of ? in_units(std::move(picture), document.shown_units()) : picture;
}

std::optional<scene::space::SpacePicture> Program::space_of_input(const Document& document) const {
  scene::space::SpacePicture picture;
  if (!draw_input_in_space || !check(document.input, fields_in(input_fields, document.units), {})) return std::nullopt;
  const Context context{document.folder(), document.units, document.shown_units()};
  draw_input_in_space(in_si(document.input, input_fields, document.units), context, picture);
  if (picture.layers.empty()) return std::nullopt;
  return units_of ? in_units(std::move(picture), document.shown_units()) : std::move(picture);
}

std::vector<Quantity> Program::quantities_of(const State& state) const {
  auto quantities = gathered<std::vector<Quantity>>(*this, state, &Results::quantities);
  return units_of ? in_units(std::move(quantities), units_of(state)) : quantities;
}

std::vector<DataTable> Program::tables_of(const State& state) const {
  auto tables = gathered<std::vector<DataTable>>(*this, state, &Results::tables);
  return units_of ? in_units(std::move(tables), units_of(state)) : tables;
}

std::vector<std::string> Program::remarks_of(const State& state) const {
  auto remarks = gathered<std::vector<std::string>>(*this, state, &Results::remarks);
  if (!units_of) return remarks;
  for (std::string& remark : remarks) remark = message_in_units(remark, units_of(state));
  return remarks;
}

std::vector<Output> Program::outputs_of(const State& state) const {
  return gathered<std::vector<Output>>(*this, state, &Results::outputs);
}

std::optional<bool> Program::reached(const State& state) const {
  std::optional<bool> all;
  const auto ask = [&](const Results& part) {
    const std::optional<bool> one = part.reached ? part.reached(state) : std::nullopt;
    if (one) all = all.value_or(true) && *one;
  };
  ask(results);
  for (const Operation& operation : operations) ask(operation.results);
  return all;
}

base::Result<const Operation*> operation_of(const Document& document, std::size_t number, const Program& program) {
  const Step& step = document.steps.at(number - 1);
  if (const Operation* operation = program.find_operation(step.operation)) return operation;
  std::vector<std::string> names;
  for (const Operation& operation : program.operations) names.push_back(operation.name);
  std::string hint = base::did_you_mean(step.operation, names);
  if (hint.empty()) hint = fmt::format("; known operations: {}", fmt::join(names, ", "));
  base::Place place = step.place;
  place.item = fmt::format("step {}", number);
  return Error{ErrorCode::UnknownOperation, fmt::format("unknown operation '{}'{}", step.operation, hint), place};
}

base::Result<void> check_program(const Document& document, const Program& program) {
  base::Place place;
  place.file = document.file.string();
  if (document.program == program.name) {
    if (program.takes_units == TakesUnits::Any || (document.units.si() && document.shown_units().si())) return {};
    return Error{
        ErrorCode::BadValue,
        fmt::format(
            "unit_system and result_units are of scenarios of quebra; those of {} are in metres: leave them out",
            program.name),
        place};
  }
  return Error{ErrorCode::WrongProgram,
               fmt::format("this scenario is for '{}', not for '{}'; run it with {}", document.program, program.name,
                           document.program),
               place};
}

base::Result<void> check(const Document& document, const Program& program) {
  DOBRA_TRY_VOID(check_program(document, program));
  DOBRA_TRY_VOID(check(document.input, fields_in(program.input_fields, document.units), "input"));
  for (std::size_t number = 1; number <= document.steps.size(); ++number) {
    DOBRA_TRY(const Operation* operation, operation_of(document, number, program));
    DOBRA_TRY_VOID(check(document.steps[number - 1].params, fields_in(operation->fields, document.units),
                         step_label(document, number)));
  }
  return check_names(document);
}

std::vector<std::string> without_effect(const Document& document, const Program& program) {
  std::vector<std::string> told;
  const auto tell = [&](const std::string& part, const Table& table, const std::vector<Field>& fields) {
    for (const std::string& one : without_effect(table, fields)) told.push_back(fmt::format("{}: {}", part, one));
  };
  tell("input", document.input, program.input_fields);
  for (std::size_t i = 0; i < document.steps.size(); ++i) {
    const Operation* operation = program.find_operation(document.steps[i].operation);
    if (operation != nullptr) tell(step_label(document, i + 1), document.steps[i].params, operation->fields);
  }
  return told;
}

}  // namespace dobra::scenario
