#include "shared/gui/text.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "tests/shared/gui/brazilian.h"

namespace dobra::gui {
namespace {

TEST(Text, EveryWordOfTheWindowIsTranslated) {
  const test::Brazilian language;
  const QRegularExpression call(R"re((?<![A-Za-z_.>])text\(\s*"((?:[^"\\]|\\.)*)")re");
  std::size_t seen = 0;
  std::size_t same = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(DOBRA_SOURCE_DIR) / "shared/gui")) {
    if (entry.path().extension() != ".cpp") continue;
    auto match = call.globalMatch(QString::fromStdString(io::read_text(entry.path()).value()));
    while (match.hasNext()) {
      const std::string words = match.next().captured(1).toStdString();
      ++seen;
      if (text(words.c_str()).toStdString() == words && words != "%1, item %2") {
        ADD_FAILURE() << entry.path().filename() << ": no translation of '" << words << "'";
        ++same;
      }
    }
  }
  EXPECT_GT(seen, 80u);
  EXPECT_EQ(same, 0u);
}

/// All that tools and the programs' own panels say is a sentence or a capitalised word in their sources.
TEST(Text, EveryWordOfTheToolsIsTranslated) {
  const test::Brazilian language;
  const QRegularExpression comment(R"(//[^\n]*|#include[^\n]*)");
  const QRegularExpression literal(R"re("((?:[^"\\\n]|\\.)*)")re");
  std::size_t seen = 0;
  std::vector<std::filesystem::directory_entry> files;
  for (const char* room : {"shared/canvas", "recon/gui", "quebra/gui"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(DOBRA_SOURCE_DIR) / room))
      files.push_back(entry);
  }
  for (const auto& entry : files) {
    if (entry.path().extension() != ".cpp") continue;
    QString source = QString::fromStdString(io::read_text(entry.path()).value());
    source.remove(comment).remove(QRegularExpression(R"("\s*\n\s*")"));
    auto match = literal.globalMatch(source);
    while (match.hasNext()) {
      const QString words = match.next().captured(1);
      const bool unit = words == "Pa sqrt(m)";
      if (unit || !words.contains(QRegularExpression("[A-Za-z]{2,}.* |^[A-Z][a-z]"))) continue;
      ++seen;
      EXPECT_NE(text(words.toUtf8().constData()), words) << entry.path().filename() << ": " << words.toStdString();
    }
  }
  EXPECT_GT(seen, 40u);
}

TEST(Text, PlaceholdersSurviveTranslation) {
  const test::Brazilian language;
  EXPECT_EQ(text("line %1: '%2' is not a number").arg(3).arg("x").toStdString(), "linha 3: 'x' não é um número");
}

TEST(Text, WordsOfTheLibraryGoThroughTheSameTranslation) {
  const test::Brazilian language;
  install_translation("en");
  EXPECT_EQ(base::translated("Layers"), "Camadas");
  EXPECT_EQ(base::translated("no such words"), "no such words");
}

}  // namespace
}  // namespace dobra::gui
