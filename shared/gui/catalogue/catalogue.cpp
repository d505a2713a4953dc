#include "shared/gui/catalogue/catalogue.h"

#include <QFile>
#include <QStringList>
#include <algorithm>

#include "shared/base/check.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::gui::catalogue {

namespace {

constexpr int deepest = 4;

/// A template in its fixed parts, with the number of the argument behind each but the last.
struct Parts {
  QStringList fixed;
  std::vector<int> arguments;
};

Parts parts_of(const QString& line) {
  static const QRegularExpression argument(R"(\{(\d*)\})");
  Parts parts;
  qsizetype begin = 0;
  int next = 0;
  for (auto matches = argument.globalMatch(line); matches.hasNext();) {
    const QRegularExpressionMatch match = matches.next();
    parts.fixed << line.mid(begin, match.capturedStart() - begin);
    parts.arguments.push_back(match.captured(1).isEmpty() ? next : match.captured(1).toInt());
    ++next;
    begin = match.capturedEnd();
  }
  parts.fixed << line.mid(begin);
  return parts;
}

/// Numbers of an argument with the user's mark: 'of 0.5 m', '(0.5; 2)', not "v0.5.csv".
QString with_mark(const QString& argument) {
  if (scene::decimal_mark() == scene::DecimalMark::Point) return argument;
  static const QRegularExpression comma_between(R"((\([-+\d.e]+), ([-+\d.e]+\)))");
  static const QRegularExpression number(R"(^[(\[]*[-+]?\d+\.\d+(e[-+]?\d+)?[)\],;:%°]*$)");
  QStringList words = QString(argument).replace(comma_between, "\\1; \\2").split(' ');
  for (QString& word : words) {
    if (number.match(word).hasMatch()) word.replace('.', ',');
  }
  return words.join(' ');
}

/// Where the first "; " or ": " lies outside quotes and brackets; -1 if nowhere.
qsizetype end_of_part(const QString& message) {
  QChar quote;
  int brackets = 0;
  for (qsizetype i = 0; i + 1 < message.size(); ++i) {
    const QChar c = message[i];
    const bool apostrophe = c == '\'' && i > 0 && message[i - 1].isLetter() && message[i + 1].isLetter();
    if (!quote.isNull()) {
      if (c == quote && !apostrophe) quote = QChar();
    } else if ((c == '\'' && !apostrophe) || c == '"' || c == '`') {
      quote = c;
    } else if (c == '(' || c == '[') {
      ++brackets;
    } else if (c == ')' || c == ']') {
      --brackets;
    } else if (brackets == 0 && (c == ';' || c == ':') && message[i + 1] == ' ') {
      return i;
    }
  }
  return -1;
}

base::Error bad_line(qsizetype number, const char* what) {
  base::Place place;
  place.line = static_cast<std::size_t>(number + 1);
  return {base::ErrorCode::BadFormat, what, place};
}

/// A window says nothing of the command line: each template also without its options, "(--jigsaw)".
std::vector<Entry> with_those_of_forms(std::vector<Entry> entries) {
  static const QRegularExpression option(R"( ?\(--[^(){}]*\))");
  const std::size_t given = entries.size();
  for (std::size_t i = 0; i < given; ++i) {
    Entry bare{QString(entries[i].source).remove(option), QString(entries[i].translation).remove(option)};
    if (bare.source != entries[i].source) entries.push_back(std::move(bare));
  }
  return entries;
}

/// The file of the resources; empty where there is none.
Catalogue from_resources(const QString& name) {
  QFile file(":/translations/" + name);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const base::Result<std::vector<Entry>> entries = read_entries(QString::fromUtf8(file.readAll()));
  DOBRA_CHECK(entries.ok());  // a file of our own, judged by a test
  return Catalogue(with_those_of_forms(*entries));
}

Catalogue& installed() {
  static Catalogue catalogue;
  return catalogue;
}

Catalogue& quantities() {
  static Catalogue catalogue = from_resources("quantities_en");
  return catalogue;
}

}  // namespace

const Catalogue& of_import() {
  static const Catalogue catalogue = from_resources("import_en");
  return catalogue;
}

Catalogue::Catalogue(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    const Parts parts = parts_of(entry.source);
    Pattern pattern{parts.fixed.front(), {}, {}, {}, entry.translation, 0};
    QString expression = "^";
    for (qsizetype i = 0; i < parts.fixed.size(); ++i) {
      expression += QRegularExpression::escape(parts.fixed[i]);
      pattern.letters += parts.fixed[i].size();
      if (parts.fixed[i].size() > pattern.longest.size()) pattern.longest = parts.fixed[i];
      if (i + 1 == parts.fixed.size()) break;
      expression += "(.*?)";
      pattern.quoted.push_back(parts.fixed[i].endsWith('\'') || parts.fixed[i].endsWith('"'));
    }
    pattern.expression = QRegularExpression(expression + "$", QRegularExpression::DotMatchesEverythingOption);
    patterns_.push_back(std::move(pattern));
  }
  std::stable_sort(patterns_.begin(), patterns_.end(),
                   [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
}

std::optional<QString> Catalogue::said(const QString& message, int deeper) const {
  if (deeper < 0) return std::nullopt;
  for (const Pattern& pattern : patterns_) {
    if (!message.startsWith(pattern.start) || !message.contains(pattern.longest)) continue;
    const QRegularExpressionMatch match = pattern.expression.match(message);
    if (!match.hasMatch()) continue;
    const Parts parts = parts_of(pattern.translation);
    QString made = parts.fixed.front();
    for (std::size_t i = 0; i < parts.arguments.size(); ++i) {
      const int argument = parts.arguments[i];
      const QString given = match.captured(argument + 1);
      made += pattern.quoted[static_cast<std::size_t>(argument)] ? given
                                                                 : said(given, deeper - 1).value_or(with_mark(given));
      made += parts.fixed[static_cast<qsizetype>(i) + 1];
    }
    return made;
  }
  return deeper > 0 ? said_in_parts(message, deeper) : std::nullopt;
}

std::optional<QString> Catalogue::said_in_parts(const QString& message, int deeper) const {
  const qsizetype at = end_of_part(message);
  if (at < 0) return std::nullopt;
  const auto first = said(message.left(at), deeper - 1);
  const auto rest = said(message.mid(at + 2), deeper);
  if (!first && !rest) return std::nullopt;
  return first.value_or(message.left(at)) + message.mid(at, 2) + rest.value_or(message.mid(at + 2));
}

QString Catalogue::translated(const QString& message) const { return said(message, deepest).value_or(message); }

std::optional<QString> Catalogue::with_arguments_kept(const QString& message) const { return said(message, 0); }

bool Catalogue::knows(const QString& message) const { return said(message, 0).has_value(); }

base::Result<std::vector<Entry>> read_entries(const QString& written) {
  std::vector<Entry> entries;
  const QStringList lines = written.split('\n');
  for (qsizetype i = 0; i < lines.size(); ++i) {
    if (lines[i].isEmpty() || lines[i].startsWith('#')) continue;
    if (i + 1 == lines.size() || lines[i + 1].isEmpty()) return bad_line(i, "a template without a translation");
    Entry entry{lines[i], lines[i + 1]};
    std::vector<int> taken = parts_of(entry.source).arguments;
    std::vector<int> given = parts_of(entry.translation).arguments;
    std::sort(taken.begin(), taken.end());
    std::sort(given.begin(), given.end());
    if (taken != given) return bad_line(i + 1, "the translation has other arguments than the template");
    entries.push_back(std::move(entry));
    ++i;
  }
  return entries;
}

const Catalogue& current() { return installed(); }

void install(const QString& language) {
  installed() = from_resources("messages_" + language);
  Catalogue words = from_resources("quantities_" + language);
  quantities() = words.size() > 0 ? std::move(words) : from_resources("quantities_en");
}

QString words_of_group(const QString& group) { return quantities().with_arguments_kept(group + '.').value_or(group); }

QString words_of_quantity(const QString& key) {
  const QString last = key.mid(key.lastIndexOf('.') + 1);
  if (const auto whole = quantities().with_arguments_kept(key)) return *whole;
  return quantities().with_arguments_kept(last).value_or(last);
}

}  // namespace dobra::gui::catalogue
