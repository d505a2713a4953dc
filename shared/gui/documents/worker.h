#pragma once
// Runs documents on a thread of its own, so that the window never waits. What is asked for during a run waits, and the
// latest of that is run next. A run that is short comes to its end and is heard of, so that a gesture of many requests
// shows its way; one that takes longer is cancelled for the request that waits, and nothing more is heard of it.

#include <QObject>
#include <QThread>
#include <QTimer>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/gui/documents/history.h"
#include "shared/scenario/runner.h"

namespace dobra::gui::documents {

/// A run with what the window shows of it, all made on the worker's thread. Where the run failed, the rest is that of
/// the last state it reached; without any state, `picture` is what the input draws, or null.
struct Outcome {
  DocumentPtr document;
  scenario::Run run;
  std::shared_ptr<const scene::Picture> picture;
  /// Of the state that the input has made; the same as `picture` where no step has come further. Null without a state.
  std::shared_ptr<const scene::Picture> input;
  /// What stands in space, of the last state; null if nothing does.
  std::shared_ptr<const scene::space::SpacePicture> space;
  std::vector<scenario::Quantity> quantities;
  std::vector<std::string> remarks;
  std::vector<scenario::Verdict> verdicts;  ///< Of a complete run.
  double seconds = 0.0;                     ///< All of it,
  double run_seconds = 0.0;                 ///< without what is shown.
};
using OutcomePtr = std::shared_ptr<const Outcome>;

/// Lives in the window's thread; so do its signals.
class Worker : public QObject {
  Q_OBJECT

 public:
  /// @pre `program` outlives the worker.
  explicit Worker(const scenario::Program& program, QObject* parent = nullptr);
  /// Cancels and waits for the thread.
  ~Worker() override;

  void request(DocumentPtr document);
  /// The run ends as soon as its operation looks; `finished` then says Cancelled.
  void cancel();
  [[nodiscard]] bool busy() const { return busy_; }
  /// Asks what of a state is called `what` (Program::names_of); `names_found` tells it, unless the same is asked of
  /// another state before.
  void find_names(const scenario::State& state, const std::string& what);

 signals:
  void started();
  void progress(double fraction, const QString& what);
  void finished(const dobra::gui::documents::OutcomePtr& outcome);
  void names_found(const std::string& what, const std::vector<std::string>& names);

 private:
  void start(DocumentPtr document);
  void done(const OutcomePtr& outcome);

  const scenario::Program& program_;
  /// Touched by the thread only.
  struct Kept;
  std::shared_ptr<Kept> kept_;
  QThread thread_;
  QObject* bench_;  ///< Lives in the thread; work is posted to it.
  base::CancelToken token_;
  DocumentPtr waiting_;
  /// The state that was asked for last, by what was asked; touched by the window's thread only.
  std::map<std::string, scenario::State> asked_;
  QTimer patience_;  ///< Runs as long as a run counts as short.
  bool busy_ = false;
};

}  // namespace dobra::gui::documents
