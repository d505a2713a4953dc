// What QUEBRA says in forms and help has a Brazilian text.

#include "tests/support/translations.h"

#include <gtest/gtest.h>

#include "quebra/core/operations.h"
#include "shared/io/formats/format.h"

namespace quebra::core {
namespace {

TEST(Translations, EveryTextOfFormsAndHelpIsInBrazilianPortuguese) {
  const std::set<std::string> texts = dobra::test::texts_of(program());
  EXPECT_GT(texts.size(), 150u);
  EXPECT_EQ(dobra::test::untranslated(texts), std::vector<std::string>{});
}

TEST(Translations, EveryFormatHasABrazilianTitle) {
  std::set<std::string> titles;
  for (const auto& format : dobra::io::formats::all_formats()) titles.insert(format.title);
  EXPECT_EQ(titles.size(), dobra::io::formats::all_formats().size());
  EXPECT_EQ(dobra::test::untranslated(titles), std::vector<std::string>{});
  EXPECT_EQ(dobra::test::untranslated({"no such text"}).size(), 1u);
}

}  // namespace
}  // namespace quebra::core
