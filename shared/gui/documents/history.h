#pragma once
// Undo and redo over immutable documents: a list of shared values and a position in it. No Qt.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "shared/scenario/document.h"

namespace dobra::gui::documents {

using DocumentPtr = std::shared_ptr<const scenario::Document>;

class History {
 public:
  /// Starts with one document, which counts as saved.
  explicit History(DocumentPtr document);

  [[nodiscard]] const DocumentPtr& current() const { return entries_[position_].document; }

  /// Makes `document` the current one; what could be redone is forgotten.
  /// @param what  the change in a few words, already translated: "Change 'count'".
  void push(DocumentPtr document, std::string what);

  [[nodiscard]] bool can_undo() const { return position_ > 0; }
  [[nodiscard]] bool can_redo() const { return position_ + 1 < entries_.size(); }
  /// What undo (redo) would take back (do again). @pre can_undo() (can_redo())
  [[nodiscard]] const std::string& undo_text() const;
  [[nodiscard]] const std::string& redo_text() const;
  /// @pre can_undo(), can_redo()
  void undo();
  void redo();

  /// The current document is what the file holds.
  void mark_saved() { saved_ = current(); }
  [[nodiscard]] bool modified() const { return saved_ != current(); }

  /// Replaces every document by its image, such as the same document at another place on disk: where a document lives
  /// is not something that undo takes back.
  void replace_all(const std::function<scenario::Document(const scenario::Document&)>& image);

 private:
  struct Entry {
    DocumentPtr document;
    std::string what;
  };
  std::vector<Entry> entries_;
  std::size_t position_ = 0;
  DocumentPtr saved_;
};

}  // namespace dobra::gui::documents
