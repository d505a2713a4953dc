#pragma once
// What a window works on, without the window: the history of the document, its runs, reading and writing.

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "shared/gui/documents/history.h"
#include "shared/gui/documents/journal.h"
#include "shared/gui/documents/worker.h"

namespace dobra::gui {

class Session : public QObject {
  Q_OBJECT

 public:
  /// Starts with an empty document. @pre `program` outlives the session.
  explicit Session(const scenario::Program& program, QObject* parent = nullptr);

  [[nodiscard]] const scenario::Program& program() const { return program_; }
  [[nodiscard]] const scenario::Document& document() const { return *history_.current(); }
  [[nodiscard]] const documents::History& history() const { return history_; }
  /// Of the last run that came to an end; null before.
  [[nodiscard]] const documents::OutcomePtr& outcome() const { return outcome_; }
  /// What the last edit took of the window's thread, with all that heard of it.
  [[nodiscard]] double last_edit_milliseconds() const { return last_edit_milliseconds_; }
  /// A run is under way or about to start.
  [[nodiscard]] bool busy() const { return pause_.isActive() || worker_.busy(); }

  /// Replaces document and history by what a file holds, and runs it. Nothing changes on an error.
  /// @error those of scenario::read_document; WrongProgram.
  base::Result<void> open(const std::filesystem::path& file);
  /// Replaces document and history by a document without a file, and runs it if there is something to run.
  void begin(scenario::Document document);
  /// Writes the document, and its file of lines; from then on it lives at `file`.
  /// @error CannotWrite, also where a file of lines is in the way that is not the document's.
  base::Result<void> save(const std::filesystem::path& file);
  /// What the journal of the document holds, from a window that did not come to its end; nothing if there is none.
  [[nodiscard]] std::optional<scenario::Document> unsaved() const;
  /// Takes up what `unsaved` gives, as an edit.
  void recover();
  /// What is not saved is not wanted.
  void forget_unsaved();
  /// Waits until the journal is on the disk.
  void wait_for_journal() { journal_.wait(); }

  /// The document's file, or its file of lines, where it is there and not what was last read from it or written to it.
  [[nodiscard]] std::optional<std::filesystem::path> changed_on_disk() const;

  /// Makes `document` the current one and runs it after a short pause, or behind the run in progress. A
  /// document that lacks what must be given waits for it.
  /// @param what  for the Undo menu, translated.
  void edit(scenario::Document document, const QString& what);
  void undo();
  void redo();
  void run();
  void cancel();
  /// Runs a document that is not the one being edited, to be looked at until the next run. @return what its outcome
  /// names.
  documents::DocumentPtr look_at(scenario::Document document);

  /// What the form of a part may name (Program::names_of), of the state before that part as the last run left it. What
  /// takes long is found by the worker when no run is under way: until `names_found`, they are those of before.
  std::vector<std::string> names_before(std::size_t part, const std::string& what);

  /// How many parts (input included) from the first on are the same in both documents.
  static std::size_t common_parts(const scenario::Document& a, const scenario::Document& b);

 signals:
  /// Another document, or the same one saved.
  void document_changed();
  void run_started();
  void progress(double fraction, const QString& what);
  void run_finished();
  void names_found();
  void journal_failed(const QString& why);

 private:
  /// The journal holds what the file does not.
  void keep_journal();
  void go_on();
  void follow_edit();
  void finish(const documents::OutcomePtr& outcome);
  [[nodiscard]] base::Result<void> check_lines_file(const scenario::Document& target) const;
  /// What the document's files hold now is what the window knows of.
  void remember_disk();

  const scenario::Program& program_;
  documents::History history_;
  documents::Worker worker_;
  QTimer pause_;
  documents::OutcomePtr outcome_;
  documents::Journal journal_;
  struct Names {
    scenario::State asked = nullptr;  ///< The last state that was asked for them.
    std::vector<std::string> names{};
  };
  std::map<std::string, Names> names_;  ///< By what they are of.
  double last_edit_milliseconds_ = 0.0;
  /// The document's file and its file of lines, and their bytes when they were last read or written.
  std::vector<std::pair<std::filesystem::path, std::optional<std::string>>> known_;
};

}  // namespace dobra::gui
