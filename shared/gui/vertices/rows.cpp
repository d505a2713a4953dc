#include "shared/gui/vertices/rows.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <cmath>

#include "shared/base/text.h"
#include "shared/gui/words/words.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::gui::vertices {

namespace {

QStringList cells_of(const QString& row) {
  if (row.contains('\t')) return row.split('\t');
  if (row.contains(';')) return row.split(';');
  static const QRegularExpression blanks("\\s+");
  const QStringList by_blanks = row.split(blanks, Qt::SkipEmptyParts);
  // "1,5, 2,5" and "1.5,2.5": a comma at the end of a cell, or the only thing between two.
  if (by_blanks.size() == 1) return by_blanks.front().split(',');
  QStringList cells;
  for (QString cell : by_blanks) {
    if (cell.endsWith(',')) cell.chop(1);
    cells << cell;
  }
  return cells;
}

}  // namespace

std::optional<double> cell_value(const QString& typed) {
  QString number = typed.trimmed();
  if (number.count(',') == 1 && !number.contains('.')) number.replace(',', '.');
  const std::optional<double> value = base::parse_number(number.toStdString());
  return value && std::isfinite(*value) ? value : std::nullopt;
}

QString cell_text(double value) {
  QString written = QString::fromStdString(base::number_text(value));
  if (written.endsWith(".0")) written.chop(2);
  return QString::fromStdString(scene::with_decimal_mark(written.toStdString()));
}

base::Result<std::vector<geom::Point>> points_of_rows(const QString& written) {
  const auto bad = [](const QString& what) { return base::Error{base::ErrorCode::BadValue, what.toStdString()}; };
  std::vector<geom::Point> points;
  QString all = written;
  all.replace("\r\n", "\n").replace('\r', '\n');
  const QStringList rows = all.split('\n');
  for (qsizetype i = 0; i < rows.size(); ++i) {
    if (rows[i].trimmed().isEmpty()) continue;
    QStringList cells = cells_of(rows[i]);
    while (cells.size() > 2 && cells.back().trimmed().isEmpty()) cells.pop_back();  // empty columns beside
    std::vector<double> numbers;
    QString wrong;
    for (const QString& cell : cells) {
      const std::optional<double> number = cell_value(cell);
      if (number)
        numbers.push_back(*number);
      else if (wrong.isEmpty())
        wrong = cell.trimmed();
    }
    if (points.empty() && numbers.empty()) continue;  // the headings of the columns
    if (numbers.size() != static_cast<std::size_t>(cells.size()))
      return bad(text("row %1: '%2' is not a number").arg(i + 1).arg(wrong));
    if (numbers.size() != 2)
      return bad(text("row %1 has %2 numbers; copy two columns, x and z").arg(i + 1).arg(numbers.size()));
    points.push_back({numbers[0], numbers[1]});
  }
  if (points.empty()) return bad(text("there are no rows of two numbers to paste"));
  return points;
}

QString rows_of_points(const std::vector<geom::Point>& points) {
  QString rows;
  for (const geom::Point p : points) rows += cell_text(p.x) + '\t' + cell_text(p.y) + '\n';
  return rows;
}

}  // namespace dobra::gui::vertices
