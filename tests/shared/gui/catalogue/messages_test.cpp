// Every message that the library can say has a Portuguese template. Messages are found in the source: texts in quotes
// with three words and more, joined as the compiler joins them.

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <filesystem>
#include <set>

#include "shared/gui/catalogue/catalogue.h"
#include "shared/io/file.h"

namespace dobra::gui::catalogue {
namespace {

namespace fs = std::filesystem;

const fs::path root = DOBRA_SOURCE_DIR;

struct Literal {
  QString text;
  qsizetype line = 0;
  QString before;  ///< What stands before it in its line.
};

/// Of a source file, what the compiler takes for one text: neighbours joined, comments and characters left out.
std::vector<Literal> literals_of(const QString& source) {
  static const QRegularExpression token(
      R"RE(//[^\n]*|/\*.*?\*/|R"(\w*)\((.*?)\)\1"|"((?:\\.|[^"\\\n])*)"|'(?:\\.|[^'\\\n])'|#include[^\n]*|\s+|\w+|.)RE",
      QRegularExpression::DotMatchesEverythingOption);
  std::vector<Literal> all;
  bool joined = false;
  for (auto matches = token.globalMatch(source); matches.hasNext();) {
    const QRegularExpressionMatch match = matches.next();
    const QStringView whole = match.capturedView();
    if (whole.startsWith(u"//") || whole.startsWith(u"/*") || whole.front().isSpace()) continue;
    const bool raw = whole.startsWith(u"R\"");
    if (!raw && whole.front() != u'"') {
      joined = false;
      continue;
    }
    QString text = raw ? match.captured(2) : match.captured(3);
    if (!raw) text.replace("\\\"", "\"").replace("\\n", "\n").replace("\\t", "\t").replace("\\\\", "\\");
    if (joined) {
      all.back().text += text;
    } else {
      const qsizetype at = match.capturedStart();
      const qsizetype line = source.lastIndexOf('\n', at);
      all.push_back({text, source.left(at).count('\n') + 1, source.mid(line + 1, at - line - 1)});
    }
    joined = true;
  }
  return all;
}

/// {:.6g} and {} alike.
QString plain(QString text) {
  static const QRegularExpression argument(R"(\{[^{}]*\})");
  return text.replace(argument, "{}");
}

bool reads_as_message(const Literal& literal, const fs::path& file) {
  static const QRegularExpression word("[A-Za-z']{2,}");
  static const QRegularExpression condition(" (=|in|is) [a-z_, ]+$");
  const QString& text = literal.text;
  if (text.contains('\n') || text.contains("><") || text.contains("\\u")) return false;  // a page, or a format
  if (literal.before.contains(".when") || literal.before.contains(".unit")) return false;
  if (file.extension() == ".h" && condition.match(text).hasMatch()) return false;
  if (text.endsWith(' ') || text.endsWith(" '")) return false;  // what follows is said by itself
  static const QRegularExpression sentence(R"([A-Za-z}][,;:]? [A-Za-z{('"])");
  if (!sentence.match(text).hasMatch()) return false;
  int words = 0;
  for (auto matches = word.globalMatch(plain(text)); matches.hasNext(); matches.next()) ++words;
  return words >= 3;
}

/// What nobody reads in a window.
bool is_left_out(const fs::path& file) {
  const std::string name = fs::relative(file, root).generic_string();
  const auto has = [&](const char* part) { return name.find(part) != std::string::npos; };
  return has("/gui/") || has("/cli/") || has("/render/") || has("main.cpp") || has("quebra/validation/") ||
         has("shared/topo/validate.cpp") || has("shared/solid/check/validate.cpp");
}

/// Kinds that files have, and what GDAL and toml++ say; comments in files that the programs write.
const std::set<QString> no_messages = {
    "strike slip fault",
    "falha de empurrao",
    "nivel de referencia",
    "camada de crescimento",
    "horizonte de crescimento",
    "estrato de crescimento",
    "linha de pino",
    "Undefined geographic SRS",
    "Undefined Cartesian SRS",
    "Of every number of the file.",
    "Of the results, where they are to differ.",
    "Where the tables of the input stand.",
    "Lines of the scenario beside, which names this file as its lines_file. Numbers are in the units of both."};

std::vector<Entry> entries() {
  return read_entries(QString::fromStdString(io::read_text(root / "resources/translations/messages_pt_BR.txt").value()))
      .value();
}

TEST(MessagesOfTheLibrary, EachHasABrazilianTemplate) {
  QString templates = "\n";
  for (const Entry& entry : entries()) templates += plain(entry.source) + "\n";
  QSet<QString> of_forms;
  const QString ts = QString::fromStdString(io::read_text(root / "resources/translations/dobra_pt_BR.ts").value());
  static const QRegularExpression source("<source>(.*?)</source>", QRegularExpression::DotMatchesEverythingOption);
  for (auto matches = source.globalMatch(ts); matches.hasNext();) {
    QString words = matches.next().captured(1);
    words.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&apos;", "'");
    of_forms.insert(words.replace("&amp;", "&"));
  }
  std::size_t seen = 0;
  for (const char* folder : {"shared", "recon", "quebra"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& file = entry.path();
      if ((file.extension() != ".cpp" && file.extension() != ".h") || is_left_out(file)) continue;
      for (const Literal& literal : literals_of(QString::fromStdString(io::read_text(file).value()))) {
        if (!reads_as_message(literal, file) || no_messages.contains(literal.text)) continue;
        ++seen;
        EXPECT_TRUE(templates.contains(plain(literal.text)) || of_forms.contains(literal.text))
            << file << ':' << literal.line << ": " << literal.text.toStdString();
      }
    }
  }
  EXPECT_GT(seen, 1500U);
}

/// Templates are found again by their own words, whatever stands for their arguments, and keep those.
TEST(MessagesOfTheLibrary, EachIsSaidWithItsArguments) {
  const std::vector<Entry> all = entries();
  const Catalogue catalogue(all);
  QStringList doubled;
  QSet<QString> sources;
  for (const Entry& entry : all) {
    if (sources.contains(plain(entry.source))) doubled << entry.source;
    sources.insert(plain(entry.source));
    int number = 0;
    QString message;
    for (const QString& part : QString(plain(entry.source)).split("{}")) {
      if (number > 0) message += QString("q%1q").arg(number);
      message += part;
      ++number;
    }
    const QString said = catalogue.translated(message);
    for (int i = 1; i < number; ++i)
      EXPECT_EQ(said.count(QString("q%1q").arg(i)), 1) << entry.source.toStdString() << " -> " << said.toStdString();
  }
  EXPECT_EQ(doubled, QStringList());
}

TEST(MessagesOfTheLibrary, PutTogetherMessagesAreSaidInParts) {
  const Catalogue catalogue(std::vector<Entry>{{"horizon '{}'", "horizonte '{}'"},
                                               {"it is flat", "é plano"},
                                               {"mend it", "corrija-o"},
                                               {"{} of {} lie there", "{} de {} estão lá"}});
  EXPECT_EQ(catalogue.translated("horizon 'a: b': it is flat; mend it"), "horizonte 'a: b': é plano; corrija-o");
  EXPECT_EQ(catalogue.translated("f.csv: it is flat"), QString::fromUtf8("f.csv: é plano"));
  EXPECT_EQ(catalogue.translated("x: y; z"), "x: y; z");
  EXPECT_EQ(catalogue.translated("'it is flat; mend it"), "'it is flat; mend it");
  EXPECT_EQ(catalogue.translated("(it is flat; mend it): mend it"), "(it is flat; mend it): corrija-o");
  EXPECT_FALSE(catalogue.knows("f.csv: it is flat"));
}

}  // namespace
}  // namespace dobra::gui::catalogue
