#pragma once
// A small program for tests of the shared machinery: lists of numbers and points, and operations that count their
// calls, fail or wait.

#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <thread>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/scenario/program.h"

namespace dobra::fake {

struct Model {
  std::vector<double> numbers;
  std::vector<geom::Point> points;
  std::vector<std::string> remarks;
};

/// How often each operation ("input" for the input) was really computed.
inline std::map<std::string, int>& calls() {
  static std::map<std::string, int> counts;
  return counts;
}

struct Horizon {
  std::string name;
  std::string file;
  std::vector<geom::Point> points;
  template <class D>
  static void describe(D& d) {
    d.field("name", &Horizon::name, {.title = "Name", .presence = scenario::Presence::Required});
    d.file("file", &Horizon::file, {.title = "File of points"});
    d.field("points", &Horizon::points, {.title = "Points", .unit = "m"});
  }
};

enum class Depth { Up, Down };

struct Input {
  std::vector<double> numbers;
  geom::Point origin{0.0, 0.0};
  Depth depth = Depth::Up;
  std::vector<std::string> tags;
  std::string file;
  std::vector<Horizon> horizons;
  template <class D>
  static void describe(D& d) {
    d.field("numbers", &Input::numbers, {.title = "Numbers"});
    d.field("origin", &Input::origin, {.title = "Origin", .unit = "m"});
    d.choice("depth", &Input::depth, {"up", "down"}, {.title = "Direction of z"});
    d.field("tags", &Input::tags, {.title = "Tags"});
    d.file("file", &Input::file, {.title = "File of numbers, one a line"});
    d.tables("horizon", &Input::horizons, {.title = "Horizons"});
  }
};

enum class Join { Mitre, Bisector, Round };

struct Scale {
  double factor = 2.0;
  int times = 1;
  std::optional<double> limit;
  base::Angle turn = base::Angle::from_degrees(30.0);
  Join join = Join::Mitre;
  bool reverse = false;
  geom::Point pin{1.0, 2.0};
  std::vector<geom::Point> path;
  template <class D>
  static void describe(D& d) {
    d.field("factor", &Scale::factor,
            {.title = "Factor", .help = "Each number is multiplied by it.", .unit = "m", .above = 0});
    d.field("times", &Scale::times, {.title = "Times", .at_least = 1, .at_most = 1000});
    d.field("limit", &Scale::limit, {.title = "Limit"});
    d.field("turn", &Scale::turn, {.title = "Turn", .at_least = -180, .at_most = 180});
    d.choice("join", &Scale::join, {"mitre", "bisector", "round"}, {.title = "Corners"});
    d.field("reverse", &Scale::reverse, {.title = "Reverse"});
    d.field("pin", &Scale::pin, {.title = "Pin point", .unit = "m"});
    d.field("path", &Scale::path, {.title = "Path", .unit = "m"});
  }
};

struct Import {
  std::string file;
  template <class D>
  static void describe(D& d) {
    d.file("file", &Import::file, {.title = "File", .presence = scenario::Presence::Required});
  }
};

struct Wait {
  double seconds = 30.0;
  std::string signal_file;
  bool deaf = false;  ///< To the wish to stop.
  template <class D>
  static void describe(D& d) {
    d.field("deaf", &Wait::deaf, {.title = "Deaf"});
    d.field("seconds", &Wait::seconds, {.title = "Seconds", .at_least = 0});
    d.field("signal_file", &Wait::signal_file, {.title = "File made when waiting starts"});
  }
};

struct Nothing {
  template <class D>
  static void describe(D&) {}
};

inline base::Result<std::vector<double>> numbers_of_file(const std::filesystem::path& file) {
  DOBRA_TRY(const std::string text, io::read_text(file));
  std::vector<double> numbers;
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const auto number = base::parse_number(std::string_view(text).substr(begin, end - begin));
    ++line;
    if (!number) {
      base::Place place;
      place.file = file.string();
      place.line = line;
      return base::Error{base::ErrorCode::BadFormat, "is not a number", place};
    }
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

inline base::Result<Model> scale(const Model& model, const Scale& params, const scenario::Context&,
                                 const base::Progress& progress) {
  ++calls()["scale"];
  progress.report(0.5, "half way");
  Model out = model;
  for (double& number : out.numbers) number *= std::pow(params.factor, params.times);
  if (params.reverse) out.remarks.push_back("the numbers were reversed");
  out.points.insert(out.points.end(), params.path.begin(), params.path.end());
  return out;
}

inline base::Result<Model> import(const Model& model, const Import& params, const scenario::Context& context,
                                  const base::Progress&) {
  ++calls()["import"];
  Model out = model;
  DOBRA_TRY(const std::vector<double> more, numbers_of_file(context.folder / params.file));
  out.numbers.insert(out.numbers.end(), more.begin(), more.end());
  return out;
}

inline base::Result<Model> wait(const Model& model, const Wait& params, const scenario::Context&,
                                const base::Progress& progress) {
  ++calls()["wait"];
  if (!params.signal_file.empty()) std::ofstream(params.signal_file) << "waiting\n";
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(params.seconds);
  while (std::chrono::steady_clock::now() < end) {
    if (!params.deaf) DOBRA_TRY_VOID(progress.check());
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return model;
}

inline base::Result<Model> fail(const Model&, const Nothing&, const scenario::Context&, const base::Progress&) {
  ++calls()["fail"];
  base::Place place;
  place.x = 3.0;
  place.y = 4.0;
  return base::Error{base::ErrorCode::CannotMesh, "the curve crosses itself; move the point", place};
}

inline base::Result<scenario::State> read_input(const scenario::Table& table, const scenario::Context& context,
                                                const base::Progress&) {
  ++calls()["input"];
  const auto input = scenario::from_table<Input>(table);
  Model model;
  model.numbers = input.numbers;
  model.points = {input.origin};
  if (!input.file.empty()) {
    DOBRA_TRY(const std::vector<double> more, numbers_of_file(context.folder / input.file));
    model.numbers.insert(model.numbers.end(), more.begin(), more.end());
  }
  for (const Horizon& horizon : input.horizons) {
    if (!horizon.file.empty()) {
      DOBRA_TRY(const std::vector<double> more, numbers_of_file(context.folder / horizon.file));
      model.numbers.insert(model.numbers.end(), more.begin(), more.end());
    }
    model.points.insert(model.points.end(), horizon.points.begin(), horizon.points.end());
  }
  return scenario::make_state(std::move(model));
}

inline std::vector<scenario::Quantity> quantities(const scenario::State& state) {
  const auto& model = scenario::model_of<Model>(state);
  double sum = 0.0;
  for (const double number : model.numbers) sum += number;
  return {{"sum", sum, "m"}, {"count", static_cast<double>(model.numbers.size()), ""}};
}

inline scene::Picture picture(const scenario::State& state) {
  const auto& model = scenario::model_of<Model>(state);
  scene::Layer layer;
  layer.key = "points";
  layer.title = "Points";
  layer.content = scene::Markers{model.points, {}};
  scene::Panel panel;
  panel.key = "panel";
  panel.title = "Points";
  panel.layers = {layer};
  return {"A picture", {panel}};
}

inline std::vector<scenario::DataTable> tables(const scenario::State& state) {
  const auto& model = scenario::model_of<Model>(state);
  scenario::DataTable table{"numbers", {"name", "value [m]"}, {}};
  for (const double number : model.numbers) table.rows.push_back({std::string("a, \"b\""), number});
  return {table};
}

inline std::vector<scenario::Output> outputs(const scenario::State& state) {
  return {{"numbers.txt", [state](const std::filesystem::path& file) {
             std::string text;
             for (const double number : scenario::model_of<Model>(state).numbers)
               text += base::number_text(number) + '\n';
             return io::write_file(file, text);
           }}};
}

inline const scenario::Program& program() {
  static const scenario::Program fake = [] {
    scenario::Program p;
    p.name = "fake";
    p.title = "FAKE";
    p.input_fields = scenario::fields_of<Input>();
    p.read_input = read_input;
    p.operations = {
        scenario::make_operation<Model, Scale>("scale", "Scale numbers", "Multiplies every number.", scale),
        scenario::make_operation<Model, Import>("import", "Import numbers", "Adds the numbers of a file.", import),
        scenario::make_operation<Model, Wait>("wait", "Wait", "Waits, and can be interrupted.", wait),
        scenario::make_operation<Model, Nothing>("fail", "Fail", "Cannot be done.", fail)};
    p.results.draw = [](const scenario::State& state, scene::Picture& drawn) { drawn = picture(state); };
    p.results.quantities = [](const scenario::State& state, auto& list) { list = quantities(state); };
    p.results.remarks = [](const scenario::State& state, auto& list) {
      list = scenario::model_of<Model>(state).remarks;
    };
    p.results.tables = [](const scenario::State& state, auto& list) { list = tables(state); };
    p.results.outputs = [](const scenario::State& state, auto& list) { list = outputs(state); };
    return p;
  }();
  return fake;
}

}  // namespace dobra::fake
