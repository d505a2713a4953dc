#include "shared/gui/text.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include "shared/base/text.h"
#include "shared/io/file.h"

namespace dobra::gui {
namespace {

class Brazilian {
 public:
  Brazilian() {
    if (translator.load(QLocale("pt_BR"), "dobra", "_", ":/translations"))
      QCoreApplication::installTranslator(&translator);
  }
  ~Brazilian() { QCoreApplication::removeTranslator(&translator); }
  QTranslator translator;
};

TEST(Text, EveryWordOfTheWindowIsTranslated) {
  const Brazilian language;
  const QRegularExpression call(R"re((?<![A-Za-z_.>])text\(\s*"((?:[^"\\]|\\.)*)")re");
  std::size_t seen = 0;
  std::size_t same = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(DOBRA_SOURCE_DIR) / "shared/gui")) {
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

TEST(Text, PlaceholdersSurviveTranslation) {
  const Brazilian language;
  EXPECT_EQ(text("line %1: '%2' is not a number").arg(3).arg("x").toStdString(), "linha 3: 'x' não é um número");
}

TEST(Text, WordsOfTheLibraryGoThroughTheSameTranslation) {
  const Brazilian language;
  install_translation("en");
  EXPECT_EQ(base::translated("Layers"), "Camadas");
  EXPECT_EQ(base::translated("no such words"), "no such words");
}

}  // namespace
}  // namespace dobra::gui
