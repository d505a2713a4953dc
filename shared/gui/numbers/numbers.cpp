#include "shared/gui/numbers/numbers.h"

#include <QRegularExpression>
#include <QStringList>
#include <cmath>

#include "shared/base/text.h"
#include "shared/gui/words/words.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::gui::numbers {

namespace {

using scenario::Kind;
using scenario::Value;

QString marked(const std::string& text) { return QString::fromStdString(scene::with_decimal_mark(text)); }

bool writes_comma() { return scene::decimal_mark() == scene::DecimalMark::Comma; }

/// "1e-07" as "1e-7", "2.1e+11" as "2.1e11".
QString with_short_exponent(QString number) {
  static const QRegularExpression exponent("e([+-])0*(?=\\d)");
  const QRegularExpressionMatch match = exponent.match(number);
  if (match.hasMatch())
    number.replace(match.capturedStart(), match.capturedLength(), match.captured(1) == "-" ? "e-" : "e");
  return number;
}

QString plain(double value) {
  QString text = QString::fromStdString(base::number_text(value));
  if (text.endsWith(".0")) text.chop(2);
  return with_short_exponent(text);
}

QString without_brackets(QString list) {
  if (list.startsWith('[') && list.endsWith(']')) list = list.mid(1, list.size() - 2).trimmed();
  return list;
}

QString list_text(const std::vector<double>& list) {
  QStringList parts;
  for (const double each : list) parts << whole(each);
  return parts.join(writes_comma() ? "; " : ", ");
}

/// Names that read back from a list parted by commas; otherwise the text with quotes and brackets.
QString names_text(const std::vector<std::string>& names) {
  QStringList parts;
  for (const std::string& name : names) {
    const bool plain = !name.empty() && base::trimmed(name) == name && name.find_first_of(",[]\"'\\") == name.npos;
    if (!plain) return QString::fromStdString(scenario::value_text(names));
    parts << QString::fromStdString(name);
  }
  return parts.isEmpty() ? QString("[]") : parts.join(", ");
}

QString with_point(QString number) {
  if (number.count(',') == 1 && !number.contains('.')) number.replace(',', '.');
  return number;
}

/// The numbers of a list, each with a point.
QStringList cells_of(const QString& written, bool single_number_may_have_comma) {
  const QString list = without_brackets(written.trimmed());
  static const QRegularExpression parting("[;\\t]");
  static const QRegularExpression blanks("\\s+");
  QStringList cells;
  if (list.contains(parting)) {
    for (const QString& cell : list.split(parting)) cells << with_point(cell.trimmed());
    while (!cells.isEmpty() && cells.back().isEmpty()) cells.pop_back();
    return cells;
  }
  QStringList words = list.split(blanks, Qt::SkipEmptyParts);
  const bool alone = words.size() == 1;
  for (QString& word : words) {
    while (word.endsWith(',')) word.chop(1);
  }
  words.removeAll(QString());
  if (!alone) {
    for (const QString& word : words) cells << (word.count(',') > 1 ? word : with_point(word));
    return cells;
  }
  if (words.isEmpty()) return {};
  if (single_number_may_have_comma && words.front().count(',') == 1) return {with_point(words.front())};
  return words.front().split(',');
}

QString line_without_brackets(const std::string& line) {
  QString plain = QString::fromStdString(line);
  for (const QChar bracket : {'[', ']', '(', ')', '\r'}) plain.replace(bracket, ' ');
  return plain;
}

}  // namespace

QString whole(double value) { return marked(plain(value).toStdString()); }

QString readable(double value) {
  constexpr double longest = 1e9;
  const double size = std::abs(value);
  const bool in_full = size >= 1e5 && size < longest;
  return marked(
      with_short_exponent(in_full ? QString::number(value, 'f', 0) : QString::number(value, 'g', 6)).toStdString());
}

QString unit_text(const std::string& unit) {
  if (unit == "deg") return QString::fromUtf8("°");
  QString set = QString::fromStdString(unit);
  static const QRegularExpression power("(?<=[a-zA-Z])([23])(?![\\w.])");
  for (QRegularExpressionMatch match = power.match(set); match.hasMatch(); match = power.match(set))
    set.replace(match.capturedStart(), 1, match.captured(1) == "2" ? QString::fromUtf8("²") : QString::fromUtf8("³"));
  static const QRegularExpression root("sqrt\\((\\w+)\\)");
  return set.replace(root, QString::fromUtf8("√\\1"));
}

QString field_text(Kind kind, const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return whole(*number);
  if (const auto* point = std::get_if<geom::Point>(&value)) return list_text({point->x, point->y});
  if (const auto* list = std::get_if<std::vector<double>>(&value); list != nullptr && !list->empty())
    return list_text(*list);
  if (const auto* names = std::get_if<std::vector<std::string>>(&value); names != nullptr && kind == Kind::Texts)
    return names_text(*names);
  const QString text = QString::fromStdString(scenario::value_text(value));
  return text == "[]" ? QString() : text;  // an empty list is no text of a field
}

QString as_parsed(Kind kind, const QString& typed) {
  if (kind == Kind::Number || kind == Kind::Degrees) return with_point(typed);
  if (kind != Kind::Point && kind != Kind::Point3 && kind != Kind::Numbers) return typed;
  return cells_of(typed, kind != Kind::Point && writes_comma()).join(", ");
}

base::Result<std::vector<geom::Point>> points_from_text(const std::string& written) {
  std::vector<geom::Point> points;
  const QStringList lines = QString::fromStdString(written).split('\n');
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const auto bad = [](const QString& what) { return base::Error{base::ErrorCode::BadValue, what.toStdString()}; };
    std::vector<double> numbers;
    for (const QString& cell : cells_of(line_without_brackets(lines[i].toStdString()), false)) {
      const std::optional<double> value = base::parse_number(cell.toStdString());
      if (!value || !std::isfinite(*value)) return bad(text("line %1: '%2' is not a number").arg(i + 1).arg(cell));
      numbers.push_back(*value);
    }
    if (numbers.empty()) continue;
    if (numbers.size() != 2) return bad(text("line %1: a point has two numbers, x and y").arg(i + 1));
    points.push_back({numbers[0], numbers[1]});
  }
  return points;
}

std::string text_of_points(const std::vector<geom::Point>& points) {
  std::string written;
  for (const geom::Point p : points) {
    if (!written.empty()) written += '\n';
    written += list_text({p.x, p.y}).toStdString();
  }
  return written;
}

double stepped(double value, int steps) {
  if (value == 0.0) return 0.1 * steps;
  const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  // Through the count of steps, so that 0.3 + 0.01 gives 0.31 and not 0.31000000000000005.
  const double count = std::round(value / step) + steps;
  const double inverse = std::round(1.0 / step);
  return step < 1.0 ? count / inverse : count * step;
}

}  // namespace dobra::gui::numbers
