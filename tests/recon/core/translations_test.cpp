// What RECON says in forms, help and pictures has a Brazilian text.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "recon/core/operations.h"
#include "shared/io/file.h"

namespace recon::core {
namespace {

std::string unescaped(std::string text) {
  for (const auto& [entity, sign] :
       {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}) {
    const std::string wanted = entity;
    for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1))
      text.replace(at, wanted.size(), sign);
  }
  return text;
}

/// Source texts and their translations.
std::map<std::string, std::string> brazilian() {
  const std::string ts =
      dobra::io::read_text(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/translations/dobra_pt_BR.ts").value();
  std::map<std::string, std::string> texts;
  const auto between = [&](const std::string& open, const std::string& close, std::size_t& at) {
    const std::size_t begin = ts.find(open, at);
    if (begin == std::string::npos) return std::string();
    const std::size_t end = ts.find(close, begin);
    at = end;
    return unescaped(ts.substr(begin + open.size(), end - begin - open.size()));
  };
  for (std::size_t at = 0; ts.find("<source>", at) != std::string::npos;) {
    const std::string source = between("<source>", "</source>", at);
    texts[source] = between("<translation>", "</translation>", at);
  }
  return texts;
}

void collect(const std::vector<dobra::scenario::Field>& fields, std::set<std::string>& texts) {
  for (const dobra::scenario::Field& field : fields) {
    texts.insert({field.options.title, field.options.help});
    collect(field.fields, texts);
  }
}

TEST(Translations, EveryTextOfFormsAndHelpIsInBrazilianPortuguese) {
  std::set<std::string> texts;
  collect(program().input_fields, texts);
  for (const dobra::scenario::Operation& operation : program().operations) {
    texts.insert({operation.title, operation.help});
    collect(operation.fields, texts);
  }
  texts.erase("");
  EXPECT_GT(texts.size(), 150u);
  const std::map<std::string, std::string> known = brazilian();
  for (const std::string& text : texts) EXPECT_TRUE(known.count(text) > 0 && !known.at(text).empty()) << text;
}

TEST(Translations, EveryTextOfPicturesIsInBrazilianPortuguese) {
  const std::map<std::string, std::string> known = brazilian();
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
