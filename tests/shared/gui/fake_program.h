#pragma once
// A small program for tests of the window: a stack of waves, of which some steps are slow and some fail.

#include <QTest>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "shared/scenario/program.h"

namespace dobra::test {

struct Bump {
  std::string name;
  double height = 1.0;
  std::vector<geom::Point> points;
  template <class D>
  static void describe(D& d) {
    d.field("name", &Bump::name, {.title = "Name", .presence = scenario::Presence::Required});
    d.field("height", &Bump::height, {.title = "Height", .unit = "m", .above = 0});
    d.field("points", &Bump::points, {.title = "Points"});
  }
};

struct WaveInput {
  std::string file;
  double amplitude = 100.0;
  std::vector<Bump> bumps;
  template <class D>
  static void describe(D& d) {
    d.file("file", &WaveInput::file, {.title = "File with a curve", .help = "Two columns, x and y."});
    d.field("amplitude", &WaveInput::amplitude, {.title = "Amplitude", .unit = "m"});
    d.tables("bump", &WaveInput::bumps, {.title = "Bumps"});
  }
};

enum class Corners { Mitre, Round };

struct StackParams {
  int count = 3;
  double distance = 50.0;
  base::Angle tilt;
  Corners corners = Corners::Mitre;
  bool filled = true;
  std::optional<double> limit;
  std::string note;
  std::vector<geom::Point> datum;
  template <class D>
  static void describe(D& d) {
    d.field("count", &StackParams::count,
            {.title = "Number of curves", .help = "How many curves.", .at_least = 1, .at_most = 40});
    d.field("distance", &StackParams::distance,
            {.title = "Distance from one curve to the next", .unit = "m", .above = 0});
    d.field("tilt", &StackParams::tilt, {.title = "Tilt"});
    d.choice("corners", &StackParams::corners, {"mitre", "round"}, {.title = "Corners"});
    d.field("filled", &StackParams::filled, {.title = "Filled"});
    d.field("limit", &StackParams::limit, {.title = "Limit", .unit = "m", .at_least = 0});
    d.field("note", &StackParams::note, {.title = "Note"});
    d.field("datum", &StackParams::datum, {.title = "Datum", .help = "A line of at least two points."});
  }
};

struct SleepParams {
  double seconds = 0.1;
  template <class D>
  static void describe(D& d) {
    d.field("seconds", &SleepParams::seconds, {.title = "Seconds", .unit = "s", .at_least = 0});
  }
};

struct BreakParams {
  geom::Point at{500.0, -50.0};
  template <class D>
  static void describe(D& d) {
    d.field("at", &BreakParams::at, {.title = "Where", .unit = "m"});
  }
};

struct Waves {
  double amplitude = 100.0;
  int count = 0;
  double distance = 0.0;
  bool filled = false;
  std::vector<geom::Polyline> bumps{};
  std::vector<std::string> names{};  ///< Of the bumps.
};

inline base::Result<Waves> stack(const Waves& waves, const StackParams& params, const scenario::Context&,
                                 const base::Progress&) {
  Waves made = waves;
  made.count = params.count;
  made.distance = params.distance;
  made.filled = params.filled;
  return made;
}

inline base::Result<Waves> sleep(const Waves& waves, const SleepParams& params, const scenario::Context&,
                                 const base::Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  double passed = 0.0;
  while (passed < params.seconds) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(passed / params.seconds, "sleeping");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  return waves;
}

struct LiftParams {
  double by = 100.0;
  template <class D>
  static void describe(D& d) {
    d.field("by", &LiftParams::by, {.title = "By", .unit = "m"});
  }
};

/// No bump stays where it was.
inline base::Result<Waves> lift(const Waves& waves, const LiftParams& params, const scenario::Context&,
                                const base::Progress&) {
  Waves made = waves;
  for (geom::Polyline& bump : made.bumps) {
    for (geom::Point& p : bump.points) p.y += params.by;
  }
  return made;
}

inline base::Result<Waves> break_at(const Waves&, const BreakParams& params, const scenario::Context&,
                                    const base::Progress&) {
  base::Place place;
  place.item = "wave 1";
  place.x = params.at.x;
  place.y = params.at.y;
  return base::Error{base::ErrorCode::SelfIntersection, "the wave crosses itself; move it", place};
}

inline geom::Polyline wave_line(double amplitude, double depth) {
  geom::Polyline line;
  for (int i = 0; i <= 100; ++i) line.points.push_back({10.0 * i, amplitude * std::sin(0.0628318530718 * i) - depth});
  return line;
}

inline scene::Panel wave_panel(const Waves& waves, const std::string& key, double amplitude) {
  using namespace scene;
  Panel panel{key, key == "before" ? "Before" : "After", {"x [m]", "z [m]"}, {}, 1.0, std::nullopt};
  if (waves.filled && waves.count > 0) {
    geom::Polyline contour = wave_line(amplitude, waves.distance * waves.count);
    const geom::Polyline top = geom::reversed(wave_line(amplitude, 0.0));
    contour.points.insert(contour.points.end(), top.points.begin(), top.points.end());
    contour.closed = true;
    panel.layers.push_back(
        {"bed", "bed", Style{{90, 90, 90}, 0.0, Dash::Solid, Color{236, 214, 160}}, Regions{{Region{{contour}}}, {}}});
  }
  Lines stack;
  for (int k = 1; k <= waves.count; ++k) stack.lines.push_back(wave_line(amplitude, waves.distance * k));
  panel.layers.push_back({"stack", "offset curves", Style{{90, 100, 110}, 0.8, Dash::Solid}, stack});
  panel.layers.push_back(
      {"top", "top", Style{{20, 60, 130}, 2.0, Dash::Solid}, Lines{{wave_line(amplitude, 0.0)}, {}}});
  for (std::uint32_t i = 0; i < waves.bumps.size(); ++i)
    panel.layers.push_back(
        {"bump_" + std::to_string(i), waves.names[i], Style{{130, 60, 20}}, Lines{{waves.bumps[i]}, {i}}});
  return panel;
}

inline std::vector<scenario::Table> bumps_of(const scenario::Document& document) {
  const scenario::Value* bumps = document.input.find("bump");
  return bumps == nullptr ? std::vector<scenario::Table>() : std::get<std::vector<scenario::Table>>(*bumps);
}

/// Bumps are drawn and edited by their points.
inline scenario::Drawing drawing_of_bumps() {
  return {.kinds = {{"bump", "Bump"}},
          .edit = [](const scenario::Document& document, const scenario::State&,
                     std::span<const scene::LineEdit> edits) -> base::Result<scenario::Document> {
            scenario::Document made = document;
            std::vector<scenario::Table> bumps = bumps_of(document);
            for (const scene::LineEdit& edit : edits) {
              if (!edit.pick.layer.starts_with("bump_"))
                return base::Error{base::ErrorCode::BadValue, "only bumps are edited", {}};
              if (!edit.becomes.empty()) bumps[edit.pick.id].set("points", edit.becomes.front().points);
            }
            for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
              if (edit->becomes.empty()) bumps.erase(bumps.begin() + edit->pick.id);
            }
            made.input.set("bump", bumps);
            return made;
          },
          .add = [](const scenario::Document& document, const std::string&, const std::string& name,
                    const geom::Polyline& line) -> base::Result<scenario::Document> {
            if (name.empty()) return base::Error{base::ErrorCode::BadValue, "give it a name", {}};
            scenario::Document made = document;
            std::vector<scenario::Table> bumps = bumps_of(document);
            bumps.emplace_back().set("name", name);
            bumps.back().set("points", line.points);
            made.input.set("bump", bumps);
            return made;
          }};
}

inline scenario::Program fake_program() {
  using namespace scenario;
  Program program;
  program.name = "waves";
  program.title = "WAVES";
  program.input_fields = fields_of<WaveInput>();
  program.read_input = [](const Table& table, const Context&, const base::Progress&) -> base::Result<State> {
    Waves waves;
    waves.amplitude = from_table<WaveInput>(table).amplitude;
    for (const Bump& bump : from_table<WaveInput>(table).bumps) {
      waves.bumps.push_back({bump.points, false});
      waves.names.push_back(bump.name);
    }
    if (waves.amplitude < 0.0) return base::Error{base::ErrorCode::BadSection, "the wave is upside down"};
    return make_state(waves);
  };
  program.draw_input = [](const Table& table, const Context&, scene::Picture& picture) {
    const double amplitude = from_table<WaveInput>(table).amplitude;
    if (amplitude > -1000.0) picture.panels.push_back(wave_panel({}, "before", amplitude));
  };
  program.operations = {make_operation<Waves, StackParams>("stack", "Stack of waves",
                                                           "Repeats the wave below itself at equal distances.", stack),
                        make_operation<Waves, SleepParams>("sleep", "Sleep", "Does nothing for a while.", sleep),
                        make_operation<Waves, LiftParams>("lift", "Lift", "Lifts all bumps.", lift),
                        make_operation<Waves, BreakParams>("break", "Break", "Always fails.", break_at)};
  program.results.draw = [](const State& state, scene::Picture& picture) {
    const auto& waves = model_of<Waves>(state);
    picture = scene::Picture{"Waves",
                             {wave_panel(waves, "before", waves.amplitude), wave_panel(waves, "after", 0.0)},
                             scene::Arrangement::Column};
  };
  program.results.quantities = [](const State& state, std::vector<Quantity>& quantities) {
    const auto& waves = model_of<Waves>(state);
    quantities = {{"wave.amplitude", waves.amplitude, "m"},
                  {"stack.count", static_cast<double>(waves.count), ""},
                  {"stack.thickness", waves.count * waves.distance, "m"}};
  };
  program.results.remarks = [](const State& state, std::vector<std::string>& remarks) {
    if (model_of<Waves>(state).count > 10) remarks.push_back("more than ten curves are hard to tell apart");
  };
  program.drawing = drawing_of_bumps();
  return program;
}

inline const char* waves_text() {
  return "dobra = 1\nprogram = \"waves\"\n\n[input]\namplitude = 100.0\n\n[[step]]\noperation = \"stack\"\nname = "
         "\"grid\"\n"
         "count = 4\ndistance = 50.0\n";
}

/// A folder of its own for each test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dobra_gui_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path path_;
};

}  // namespace dobra::test
