#include "shared/gui/documents/history.h"

#include <gtest/gtest.h>

namespace dobra::gui::documents {
namespace {

DocumentPtr titled(const std::string& title) {
  scenario::Document document;
  document.title = title;
  return std::make_shared<const scenario::Document>(std::move(document));
}

TEST(History, NewOneIsSavedAndHasNothingToUndo) {
  const History history(titled("a"));
  EXPECT_FALSE(history.modified());
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
}

TEST(History, UndoGivesTheVeryDocumentBack) {
  const DocumentPtr a = titled("a");
  const DocumentPtr b = titled("b");
  History history(a);
  history.push(b, "change");
  EXPECT_EQ(history.undo_text(), "change");
  history.undo();
  EXPECT_EQ(history.current(), a);
  EXPECT_EQ(history.redo_text(), "change");
  history.redo();
  EXPECT_EQ(history.current(), b);
}

TEST(History, ChangeAfterUndoForgetsWhatCouldBeRedone) {
  const DocumentPtr c = titled("c");
  History history(titled("a"));
  history.push(titled("b"), "b");
  history.undo();
  history.push(c, "c");
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.current(), c);
  history.undo();
  EXPECT_FALSE(history.can_undo());
}

TEST(History, SavedMarkFollowsTheDocumentThroughUndo) {
  History history(titled("a"));
  history.push(titled("b"), "b");
  EXPECT_TRUE(history.modified());
  history.mark_saved();
  EXPECT_FALSE(history.modified());
  history.undo();
  EXPECT_TRUE(history.modified());
  history.redo();
  EXPECT_FALSE(history.modified());
}

TEST(History, SavedDocumentThatWasForgottenLeavesEverythingModified) {
  History history(titled("a"));
  history.push(titled("b"), "b");
  history.mark_saved();
  history.undo();
  history.push(titled("c"), "c");
  EXPECT_TRUE(history.modified());
  history.undo();
  EXPECT_TRUE(history.modified());
}

TEST(History, ReplacingAllKeepsPositionAndSavedMark) {
  History history(titled("a"));
  history.push(titled("b"), "b");
  history.push(titled("c"), "c");
  history.undo();
  history.mark_saved();
  history.replace_all([](scenario::Document document) {
    document.title += "!";
    return document;
  });
  EXPECT_EQ(history.current()->title, "b!");
  EXPECT_FALSE(history.modified());
  history.undo();
  EXPECT_EQ(history.current()->title, "a!");
  EXPECT_TRUE(history.modified());
}

}  // namespace
}  // namespace dobra::gui::documents
