// What RECON says in forms, help and pictures has a Brazilian text.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "recon/core/operations.h"
#include "shared/io/file.h"
#include "tests/support/translations.h"

namespace recon::core {
namespace {

TEST(Translations, EveryTextOfFormsAndHelpIsInBrazilianPortuguese) {
  const std::set<std::string> texts = dobra::test::texts_of(program());
  EXPECT_GT(texts.size(), 150u);
  EXPECT_EQ(dobra::test::untranslated(texts), std::vector<std::string>{});
}

TEST(Translations, EveryTextOfPicturesIsInBrazilianPortuguese) {
  const std::map<std::string, std::string> known = dobra::test::brazilian();
  const std::regex call(R"re(translated\(\s*"((?:[^"\\]|\\.)*)"\s*\))re");
  std::size_t seen = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(DOBRA_SOURCE_DIR) / "recon/core")) {
    const std::string source =
        std::regex_replace(dobra::io::read_text(entry.path()).value(), std::regex(R"(\\u00b2)"), "²");
    for (std::sregex_iterator match(source.begin(), source.end(), call); match != std::sregex_iterator(); ++match) {
      const std::string text = (*match)[1];
      ++seen;
      EXPECT_TRUE(known.count(text) > 0 && !known.at(text).empty()) << entry.path().filename() << ": " << text;
    }
  }
  EXPECT_GT(seen, 30u);
}

}  // namespace
}  // namespace recon::core
