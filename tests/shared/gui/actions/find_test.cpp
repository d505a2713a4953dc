#include "shared/gui/actions/find.h"

#include <gtest/gtest.h>

namespace dobra::gui::actions {
namespace {

std::vector<Choice> some() {
  const auto choice = [](const char* title, const char* heard) {
    return Choice{QString::fromUtf8(title), {}, {}, QString::fromUtf8(heard), true, {}};
  };
  return {choice("Salvar figura...", "file.save_picture\nSave &Picture..."), choice("Exibir a seção", "look.result"),
          choice("Quadro", "view.fit\nFit"), choice("Abrir", "file.open"), choice("Reabrir a figura", "x")};
}

TEST(Find, EveryTypedWordMustOccurInTitleOrId) {
  EXPECT_EQ(found(some(), "figura salvar"), (std::vector<std::size_t>{0}));
  EXPECT_EQ(found(some(), "save pic"), (std::vector<std::size_t>{0}));
  EXPECT_EQ(found(some(), "file."), (std::vector<std::size_t>{0, 3}));
  EXPECT_TRUE(found(some(), "figura nada").empty());
}

TEST(Find, AccentsAndCaseAreNoMatter) {
  EXPECT_EQ(found(some(), "SECAO"), (std::vector<std::size_t>{1}));
  EXPECT_EQ(found(some(), QString::fromUtf8("sEçÃo")), (std::vector<std::size_t>{1}));
  EXPECT_EQ(found(some(), QString::fromUtf8("Quádro")), (std::vector<std::size_t>{2}));
}

TEST(Find, WhatBeginsSoComesFirstAndNothingTypedGivesAll) {
  EXPECT_EQ(found(some(), "abrir"), (std::vector<std::size_t>{3, 4}));
  EXPECT_EQ(found(some(), "figura"), (std::vector<std::size_t>{0, 4}));
  EXPECT_EQ(found(some(), "  ").size(), some().size());
}

}  // namespace
}  // namespace dobra::gui::actions
