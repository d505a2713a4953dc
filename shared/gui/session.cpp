#include "shared/gui/session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "shared/base/text.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/messages.h"
#include "shared/gui/text.h"
#include "shared/io/file.h"

namespace dobra::gui {

namespace {
constexpr int pause_milliseconds = 15;  ///< What one action changes in several edits is run once.
}

Session::Session(const scenario::Program& program, QObject* parent)
    : QObject(parent),
      program_(program),
      history_(std::make_shared<const scenario::Document>(documents::empty_document(program))),
      worker_(program),
      journal_([this](const base::Error& error) {
        const QString why = QString::fromStdString(base::to_string(error));
        QMetaObject::invokeMethod(
            this, [this, why] { emit journal_failed(why); }, Qt::QueuedConnection);
      }) {
  pause_.setSingleShot(true);
  pause_.setInterval(pause_milliseconds);
  connect(&pause_, &QTimer::timeout, this, [this] { worker_.request(history_.current()); });
  connect(&worker_, &documents::Worker::started, this, &Session::run_started);
  connect(&worker_, &documents::Worker::progress, this, &Session::progress);
  connect(&worker_, &documents::Worker::finished, this, &Session::finish);
  connect(&worker_, &documents::Worker::names_found, this,
          [this](const std::string& what, const std::vector<std::string>& names) {
            Names& known = names_[what];
            if (known.asked && std::exchange(known.names, names) != names) emit names_found();
          });
}

base::Result<void> Session::open(const std::filesystem::path& file) {
  DOBRA_TRY(scenario::Document document, scenario::read_document(file));
  // Wrong parameters can be mended in the form; a document of another program cannot.
  DOBRA_TRY_VOID(scenario::check_program(document, program_));
  document.file = file;
  history_ = documents::History(std::make_shared<const scenario::Document>(std::move(document)));
  remember_disk();
  outcome_ = nullptr;
  names_.clear();
  emit document_changed();
  run();
  return {};
}

void Session::begin(scenario::Document document) {
  document.file.clear();
  history_ = documents::History(std::make_shared<const scenario::Document>(std::move(document)));
  known_.clear();
  outcome_ = nullptr;
  names_.clear();
  cancel();
  emit document_changed();
  run();
}

base::Result<void> Session::save(const std::filesystem::path& file) {
  const auto moved = [&](const scenario::Document& document) { return documents::at_file(document, program_, file); };
  if (history_.modified()) {
    // One that is older than what is saved would be taken for newer after a crash between writing and forgetting.
    keep_journal();
    journal_.wait();
  }
  DOBRA_TRY_VOID(check_lines_file(moved(document())));
  DOBRA_TRY_VOID(scenario::write_document(moved(document()), file));
  const bool same_place = document().file == file;
  if (!same_place) {
    forget_unsaved();
    history_.replace_all(moved);
  }
  history_.mark_saved();
  forget_unsaved();
  remember_disk();
  emit document_changed();
  return {};
}

/// A file of lines that stands there already is this document's own, or that of the document that is replaced.
base::Result<void> Session::check_lines_file(const scenario::Document& target) const {
  if (target.lines_file.empty()) return {};
  const std::filesystem::path lines = target.folder() / target.lines_file;
  const bool own = std::any_of(known_.begin(), known_.end(), [&](const auto& known) { return known.first == lines; });
  std::error_code none;
  if (own || !std::filesystem::exists(lines, none)) return {};
  const auto there = scenario::read_document(target.file);
  if (there && there->lines_file == target.lines_file) return {};
  return base::Error{base::ErrorCode::CannotWrite,
                     base::translated("the lines are to stand in this file, which is there already; save the scenario "
                                      "under another name"),
                     base::Place{.file = lines.string()}};
}

void Session::remember_disk() {
  known_.clear();
  std::vector<std::filesystem::path> files{document().file};
  if (!document().lines_file.empty()) files.push_back(document().folder() / document().lines_file);
  for (const std::filesystem::path& file : files) {
    const base::Result<std::string> bytes = io::read_bytes(file);
    known_.emplace_back(file, bytes ? std::optional(*bytes) : std::nullopt);
  }
}

std::optional<std::filesystem::path> Session::changed_on_disk() const {
  for (const auto& [file, bytes] : known_) {
    const base::Result<std::string> now = io::read_bytes(file);
    if (now && *now != bytes) return file;
  }
  return std::nullopt;
}

void Session::edit(scenario::Document document, const QString& what) {
  history_.push(std::make_shared<const scenario::Document>(std::move(document)), what.toStdString());
  go_on();
}

void Session::undo() {
  if (!history_.can_undo()) return;
  history_.undo();
  go_on();
}

void Session::redo() {
  if (!history_.can_redo()) return;
  history_.redo();
  go_on();
}

void Session::keep_journal() {
  journal_.keep(documents::Journal::file_of(document()), history_.modified() ? history_.current() : nullptr);
}

void Session::forget_unsaved() { journal_.keep(documents::Journal::file_of(document()), nullptr); }

std::optional<scenario::Document> Session::unsaved() const {
  const base::Result<std::string> written = io::read_text(documents::Journal::file_of(document()));
  if (!written) return std::nullopt;
  base::Result<scenario::Document> read = scenario::parse_document(*written, document().file);
  if (!read || !scenario::check_program(*read, program_)) return std::nullopt;
  if (scenario::document_text(*read) == scenario::document_text(document())) return std::nullopt;
  return std::move(*read);
}

void Session::recover() {
  std::optional<scenario::Document> found = unsaved();
  if (!found) return;
  found->source = document().source;  // the journal's own is of no interest
  found->lines_source = document().lines_source;
  edit(*std::move(found), text("Recover what was not saved"));
}

void Session::go_on() {
  const auto begin = std::chrono::steady_clock::now();
  follow_edit();
  const auto took = std::chrono::steady_clock::now() - begin;
  last_edit_milliseconds_ = std::chrono::duration<double, std::milli>(took).count();
}

void Session::follow_edit() {
  keep_journal();
  const bool blank = documents::is_blank(document(), program_);
  if (blank) outcome_ = nullptr;
  emit document_changed();
  // What waits for a value would only fail.
  if (blank)
    cancel();
  else if (!still_to_be_given(document(), program_).isEmpty())
    pause_.stop();
  else if (!pause_.isActive())  // a stream of edits does not put the run off
    pause_.start();
}

void Session::run() {
  pause_.stop();
  if (documents::is_blank(document(), program_)) return;
  worker_.request(history_.current());
}

void Session::cancel() {
  pause_.stop();
  worker_.cancel();
}

documents::DocumentPtr Session::look_at(scenario::Document document) {
  pause_.stop();
  auto looked_at = std::make_shared<const scenario::Document>(std::move(document));
  worker_.request(looked_at);
  return looked_at;
}

void Session::finish(const documents::OutcomePtr& outcome) {
  if (!documents::is_blank(document(), program_)) outcome_ = outcome;
  emit run_finished();
}

std::vector<std::string> Session::names_before(std::size_t part, const std::string& what) {
  if (part == 0 || !program_.names_of || !outcome_ || outcome_->run.states.size() < part) return {};
  const scenario::State& state = outcome_->run.states[part - 1];
  Names& known = names_[what];
  if (!busy() && std::exchange(known.asked, state) != state) worker_.find_names(state, what);
  return known.names;
}

std::size_t Session::common_parts(const scenario::Document& a, const scenario::Document& b) {
  if (!(a.input == b.input)) return 0;
  const std::size_t steps = std::min(a.steps.size(), b.steps.size());
  std::size_t same = 0;
  while (same < steps && a.steps[same].operation == b.steps[same].operation &&
         a.steps[same].params == b.steps[same].params) {
    ++same;
  }
  return same + 1;
}

}  // namespace dobra::gui
