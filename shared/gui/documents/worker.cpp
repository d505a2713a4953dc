#include "shared/gui/documents/worker.h"

#include <chrono>

#include "shared/scene/detail.h"

namespace dobra::gui::documents {

namespace {

using Clock = std::chrono::steady_clock;
using PicturePtr = std::shared_ptr<const scene::Picture>;
constexpr int short_run = 250;  ///< Milliseconds.
constexpr auto least_time_between_reports = std::chrono::milliseconds(30);

/// Shares with the pictures before what is as it was there. Null for a picture of nothing.
PicturePtr shared_with(scene::Picture picture, std::initializer_list<PicturePtr> before) {
  if (picture.panels.empty()) return nullptr;
  for (const PicturePtr& other : before) {
    if (other) scene::share_with(picture, *other);  // here, and not on the window's thread
  }
  return std::make_shared<const scene::Picture>(std::move(picture));
}

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

/// What is used again by the next run.
struct Worker::Kept {
  explicit Kept(const scenario::Program& program) : runner(program) {}

  scenario::Runner runner;
  scenario::State input;  ///< What `picture` is of.
  PicturePtr picture = nullptr;
  PicturePtr result = nullptr;  ///< The last that was made.

  PicturePtr picture_of_input(const scenario::Program& program, const scenario::State& state) {
    if (input != state) picture = shared_with(program.picture_of(state), {picture});
    input = state;
    return picture;
  }

  OutcomePtr outcome_of(const DocumentPtr& document, const scenario::Program& program, const base::Progress& progress) {
    const auto begin = Clock::now();
    auto outcome = std::make_shared<Outcome>();
    outcome->document = document;
    outcome->run = runner.run(*document, progress);
    outcome->run_seconds = seconds_since(begin);
    const std::vector<scenario::State>& states = outcome->run.states;
    if (states.empty()) {
      outcome->picture = shared_with(program.picture_of_input(*document), {result});
      if (auto space = program.space_of_input(*document))
        outcome->space = std::make_shared<const scene::space::SpacePicture>(std::move(*space));
    } else {
      outcome->input = picture_of_input(program, states.front());
      outcome->picture = states.size() == 1 ? outcome->input
                                            : shared_with(program.picture_of(states.back()), {result, outcome->input});
      if (auto space = program.space_of(states.back()))
        outcome->space = std::make_shared<const scene::space::SpacePicture>(std::move(*space));
      outcome->quantities = program.quantities_of(states.back());
      outcome->remarks = program.remarks_of(states.back());
    }
    result = outcome->picture;
    if (outcome->run.complete()) outcome->verdicts = scenario::judge(*document, program, outcome->run);
    outcome->seconds = seconds_since(begin);
    return outcome;
  }
};

Worker::Worker(const scenario::Program& program, QObject* parent)
    : QObject(parent), program_(program), kept_(std::make_shared<Kept>(program)), bench_(new QObject) {
  bench_->moveToThread(&thread_);
  connect(&thread_, &QThread::finished, bench_, &QObject::deleteLater);
  thread_.setObjectName("dobra worker");
  // Meshers and subdivisions recurse; the default of a secondary thread is not the main thread's 8 MiB everywhere.
  thread_.setStackSize(16u << 20u);
  thread_.start();
  patience_.setSingleShot(true);
  patience_.setInterval(short_run);
  connect(&patience_, &QTimer::timeout, this, [this] {
    if (waiting_) token_.cancel();
  });
}

Worker::~Worker() {
  token_.cancel();
  thread_.quit();
  thread_.wait();
}

void Worker::request(DocumentPtr document) {
  if (busy_) {
    waiting_ = std::move(document);
    if (!patience_.isActive()) token_.cancel();
  } else {
    start(std::move(document));
  }
}

void Worker::cancel() {
  waiting_.reset();
  token_.cancel();
}

void Worker::find_names(const scenario::State& state, const std::string& what) {
  asked_[what] = state;
  QMetaObject::invokeMethod(bench_, [this, state, what] {
    std::vector<std::string> names = program_.names_of(state, what);
    const auto tell = [this, state, what, names = std::move(names)] {
      if (asked_[what] == state) emit names_found(what, names);
    };
    QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
  });
}

void Worker::start(DocumentPtr document) {
  busy_ = true;
  token_ = base::CancelToken();
  patience_.start();
  emit started();
  const auto last_report = std::make_shared<Clock::time_point>();
  const base::Progress listener(token_, [this, last_report](double fraction, const std::string& what) {
    const auto now = Clock::now();
    if (now - *last_report < least_time_between_reports) return;
    *last_report = now;
    const QString said = QString::fromStdString(what).trimmed();
    QMetaObject::invokeMethod(
        this, [this, fraction, said] { emit progress(fraction, said); }, Qt::QueuedConnection);
  });
  QMetaObject::invokeMethod(bench_, [this, document = std::move(document), listener] {
    const OutcomePtr outcome = kept_->outcome_of(document, program_, listener);
    QMetaObject::invokeMethod(
        this, [this, outcome] { done(outcome); }, Qt::QueuedConnection);
  });
}

void Worker::done(const OutcomePtr& outcome) {
  const bool heard = !waiting_ || !token_.cancelled();
  if (waiting_)
    start(std::exchange(waiting_, nullptr));
  else
    busy_ = false;
  if (heard) emit finished(outcome);
}

}  // namespace dobra::gui::documents
