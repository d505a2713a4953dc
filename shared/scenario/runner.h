#pragma once
// Runs documents, and remembers states by the prefix of the document that made them: a change to step k re-runs k and
// later.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "shared/scenario/program.h"

namespace dobra::scenario {

struct Run {
  std::vector<State> states;         ///< states[0] is the input, states[k] is after step k; as far as the run came.
  std::optional<base::Error> error;  ///< Why it came no farther.
  std::size_t failed_step = 0;       ///< 0 the input, k step k; meaningful with `error`.

  [[nodiscard]] bool complete() const { return !error; }
};

/// Not thread-safe: one runner, one worker.
class Runner {
 public:
  /// States of other documents than the last that stay remembered, so that undo and redo are instant.
  static constexpr std::size_t spare_states = 32;

  explicit Runner(const Program& program) : program_(program) {}

  /// Runs all steps, taking remembered states where the prefix (parameters, and size and time of the input files) is
  /// the same.
  Run run(const Document& document, const base::Progress& progress = {});

  /// How many steps (input included) the last run really computed.
  [[nodiscard]] std::size_t computed() const { return computed_; }

 private:
  /// What a state depends on: the parameters of its step, and everything else as text.
  struct Key {
    std::string text;  ///< The number of the state before it, the step, size and time of its files.
    Table table;       ///< Compared without comments and places; shares its points with the document.
  };
  struct Remembered {
    Table table;
    State state;
    std::uint64_t number = 0;  ///< Never used again for another state.
    std::uint64_t last_used = 0;
  };
  const State* recall(const Key& key, std::uint64_t& number);
  void remember(Key key, State state, std::uint64_t& number);
  void forget();

  const Program& program_;
  std::multimap<std::string, Remembered> remembered_;  ///< By Key::text.
  std::uint64_t next_number_ = 1;
  std::uint64_t runs_ = 0;
  std::size_t computed_ = 0;
};

struct Verdict {
  Expect expect;
  std::optional<double> found;  ///< Nothing if the state has no such quantity.
  bool met = false;
  std::string message;  ///< One line.
};

/// Judges the expectations of a complete run.
std::vector<Verdict> judge(const Document& document, const Program& program, const Run& run);

/// report.json: program, version, input and steps (effective values, quantities, remarks that are new with the step),
/// tables of the last state, expectations; where a step failed, "error": {"step", "message"} instead of expectations.
/// Same run, same bytes: no times, no paths outside the document.
std::string report_json(const Document& document, const Program& program, const Run& run);

/// Changes one value: "steps.2.distance=0.4", "steps.NAME.distance=0.4", "input.depth=down", "unit_system=mm, N, MPa".
/// @error BadUsage with a suggestion, BadValue.
base::Result<Document> with_value(Document document, const Program& program, const std::string& assignment);

}  // namespace dobra::scenario
