#include "shared/gui/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "shared/io/file.h"

namespace dobra::gui::catalogue {
namespace {

QString entries_error(const char* text) {
  const auto entries = read_entries(text);
  if (entries) return "read " + QString::number(entries->size());
  return QString("%1: %2").arg(entries.error().place->line).arg(QString::fromStdString(entries.error().message));
}

TEST(Catalogue, FilesThatAreWrongAreToldWithTheirLine) {
  EXPECT_EQ(entries_error("a {}\n\n"), "1: a template without a translation");
  EXPECT_EQ(entries_error("# words\n\na {}"), "3: a template without a translation");
  EXPECT_EQ(entries_error("a {}\num\n"), "2: the translation has other arguments than the template");
  EXPECT_EQ(entries_error("a {} {}\num {0} {0}\n"), "2: the translation has other arguments than the template");
  EXPECT_EQ(entries_error("a {} {}\num {1} {0}\n\n# more\nb\nc"), "read 2");
  EXPECT_EQ(entries_error(""), "read 0");
}

const Catalogue& small() {
  static const Catalogue catalogue(
      std::vector<Entry>{{"'{}' must be {}, found {}", "'{}' precisa ser {}, e é {}"},
                         {"'{}' must be {}, found '{}'", "'{}' precisa ser {}, e é '{}'"},
                         {"a number", "um número"},
                         {"found", "achado"},
                         {"{} of {} lie there (a+b) [x]*", "de {1}, {0} estão lá (a+b) [x]*"},
                         {"greater than {}", "maior que {}"}});
  return catalogue;
}

TEST(Catalogue, WhatNoTemplateFitsStaysAsItIs) {
  for (const char* message : {"", "must be", "'a' must be a number", "'a' must be a number, foun b", "{}", "a number "})
    EXPECT_EQ(small().translated(message), message);
  EXPECT_EQ(Catalogue().translated("a number"), "a number");
}

TEST(Catalogue, WhatStandsInQuotesIsTheUsersOwn) {
  EXPECT_EQ(small().translated("'found' must be a number, found 'a number'"),
            "'found' precisa ser um número, e é 'a number'");
}

TEST(Catalogue, ArgumentsAreSaidTooAndMayChangeTheirOrder) {
  EXPECT_EQ(small().translated("'h' must be greater than 0.5 m, found -1"), "'h' precisa ser maior que 0.5 m, e é -1");
  EXPECT_EQ(small().translated("3 of 7 lie there (a+b) [x]*"), "de 7, 3 estão lá (a+b) [x]*");
}

TEST(Catalogue, ArgumentsWithTheWordsOfTheTemplateDoNotConfuseIt) {
  EXPECT_EQ(small().translated("'x, found y' must be a number, found 1"), "'x, found y' precisa ser um número, e é 1");
}

TEST(Catalogue, NamesWithinQuantitiesStay) {
  const Catalogue words(
      std::vector<Entry>{{"horizon.{}.", "Horizonte {}"}, {"section.", "Seção"}, {"section", "corte"}});
  EXPECT_EQ(words.with_arguments_kept("horizon.section."), "Horizonte section");
  EXPECT_EQ(words.with_arguments_kept("horizon.A.B (1)."), "Horizonte A.B (1)");
  EXPECT_EQ(words.with_arguments_kept("fault.section."), std::nullopt);
}

TEST(Catalogue, QuantitiesHaveWordsInBothLanguages) {
  install("pt_BR");
  EXPECT_EQ(words_of_group("since_input.horizon.Top (1)"), "Desde a entrada: horizonte Top (1)");
  EXPECT_EQ(words_of_quantity("horizon.top.length_after"), "Comprimento depois");
  EXPECT_EQ(words_of_quantity("invert.misfit.area"), "area");  // a bed of that name
  install("fr_FR");
  EXPECT_EQ(words_of_group("horizon.top"), "Horizon top");
  EXPECT_EQ(words_of_quantity("section.units_area"), "Area of the units");
  EXPECT_EQ(words_of_quantity("section.no_such_thing"), "no_such_thing");
  install("en");
}

TEST(Catalogue, FilesOfQuantitiesHaveTheSameKeys) {
  std::vector<QStringList> keys;
  for (const char* name : {"quantities_en.txt", "quantities_pt_BR.txt"}) {
    const auto file = std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/translations" / name;
    const auto entries = read_entries(QString::fromStdString(io::read_text(file).value()));
    ASSERT_TRUE(entries) << name << ' ' << entries.error().place->line << ": " << entries.error().message;
    EXPECT_GT(entries->size(), 150U);
    QStringList& all = keys.emplace_back();
    for (const Entry& entry : *entries) all << entry.source;
    EXPECT_EQ(all.removeDuplicates(), 0) << name;
  }
  EXPECT_EQ(keys[0], keys[1]);
}

/// A message for a form has lost what it says of the command line before it is translated, also within another.
TEST(Catalogue, ThePiecesOfMessagesAreKnownWithoutTheirOptions) {
  install("pt_BR");
  const QString said = translated(
      "the top 'A (1)' does not cover the section: this reaches 1747.3 m beyond its end, 121 % of its width; lengthen "
      "the top, take another one, or set 'Beyond the top' = \"continue\" to go on straight there; it is one piece of "
      "horizon 'A': join its pieces before (step join, join_gaps) where no fault displaces it any more; a section that "
      "faults still part is restored block by block");
  EXPECT_TRUE(said.contains("é um pedaço do horizonte 'A'")) << said.toStdString();
  EXPECT_TRUE(said.endsWith("é restaurada bloco a bloco")) << said.toStdString();
  install("en");
}

TEST(Catalogue, TheFileIsReadWhole) {
  const auto file = std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/translations/messages_pt_BR.txt";
  const auto entries = read_entries(QString::fromStdString(io::read_text(file).value()));
  ASSERT_TRUE(entries) << entries.error().place->line << ": " << entries.error().message;
  EXPECT_GT(entries->size(), 100U);
  const Catalogue catalogue(*entries);
  for (const Entry& entry : *entries) {
    QString message = entry.source;
    message.replace(QRegularExpression(R"(\{\d*\})"), "7");
    EXPECT_TRUE(catalogue.knows(message)) << message.toStdString();
    EXPECT_NE(entry.source, entry.translation);
  }
}

}  // namespace
}  // namespace dobra::gui::catalogue
