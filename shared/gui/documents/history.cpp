#include "shared/gui/documents/history.h"

#include "shared/base/check.h"

namespace dobra::gui::documents {

History::History(DocumentPtr document) : saved_(document) { entries_.push_back({std::move(document), {}}); }

void History::push(DocumentPtr document, std::string what) {
  entries_.resize(position_ + 1);
  entries_.push_back({std::move(document), std::move(what)});
  ++position_;
}

const std::string& History::undo_text() const {
  DOBRA_CHECK(can_undo());
  return entries_[position_].what;
}

const std::string& History::redo_text() const {
  DOBRA_CHECK(can_redo());
  return entries_[position_ + 1].what;
}

void History::undo() {
  DOBRA_CHECK(can_undo());
  --position_;
}

void History::redo() {
  DOBRA_CHECK(can_redo());
  ++position_;
}

void History::replace_all(const std::function<scenario::Document(const scenario::Document&)>& image) {
  const DocumentPtr saved_before = saved_;
  saved_ = nullptr;  // The saved one may have been forgotten by push: then nothing here is saved.
  for (Entry& entry : entries_) {
    auto replaced = std::make_shared<const scenario::Document>(image(*entry.document));
    if (entry.document == saved_before) saved_ = replaced;
    entry.document = std::move(replaced);
  }
}

}  // namespace dobra::gui::documents
