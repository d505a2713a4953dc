#pragma once
// What operations have found out about a section without changing it, each under its own type: error bars, an area
// balance, lines carried along the chain. A new operation keeps its results here, and nothing else of the model knows
// of them. Page: docs/contributing.md

#include <algorithm>
#include <memory>
#include <typeindex>
#include <utility>
#include <vector>

namespace recon::model {

/// Whether a finding stands when the next stage begins.
enum class Outlives { Stage, Nothing };

/// What a finding was made from: it is forgotten when that is made anew.
struct RestsOn {
  std::size_t state = 0;  ///< The last state of the chain that it knows; 0: the input alone.
  Outlives outlives = Outlives::Stage;
};

class Findings {
 public:
  /// One more of its type.
  template <class T>
  void add(T finding, RestsOn on) {
    entries_.push_back({typeid(T), std::make_shared<const T>(std::move(finding)), on});
  }
  /// Instead of those of its type.
  template <class T>
  void set(T finding, RestsOn on) {
    std::erase_if(entries_, [](const Entry& entry) { return entry.type == typeid(T); });
    add(std::move(finding), on);
  }
  /// In the order in which they were made.
  template <class T>
  [[nodiscard]] std::vector<const T*> all() const {
    std::vector<const T*> found;
    for (const Entry& entry : entries_) {
      if (entry.type == typeid(T)) found.push_back(static_cast<const T*>(entry.finding.get()));
    }
    return found;
  }
  /// The last of its type, or null.
  template <class T>
  [[nodiscard]] const T* get() const {
    const auto found = all<T>();
    return found.empty() ? nullptr : found.back();
  }

  /// States after this one are made anew.
  void forget_after(std::size_t state) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.on.state > state; });
  }
  /// The next stage begins.
  void begin_stage() {
    std::erase_if(entries_, [](const Entry& entry) { return entry.on.outlives == Outlives::Nothing; });
  }

 private:
  struct Entry {
    std::type_index type;
    std::shared_ptr<const void> finding;
    RestsOn on;
  };
  std::vector<Entry> entries_;
};

}  // namespace recon::model
