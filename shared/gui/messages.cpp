#include "shared/gui/messages.h"

#include <QRegularExpression>

#include "shared/gui/catalogue/catalogue.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/text.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::gui {

using scenario::Field;
using scenario::Table;

namespace {

QString title_of(const Field& field) {
  const QString title = field.options.title[0] != '\0' ? text(field.options.title) : QString::fromStdString(field.key);
  return "'" + title + "'";
}

/// To find the place on the picture by.
QString coordinate(double value) {
  return QString::fromStdString(scene::with_decimal_mark(QString::number(value, 'g', 10).toStdString()));
}

/// The ways in which messages name a key.
void name_by_title(QString& message, const Field& field) {
  const QString key = QRegularExpression::escape(QString::fromStdString(field.key));
  const QString title = title_of(field).replace("\\", "\\\\");
  message.replace(QRegularExpression("^'" + key + "'"), title);
  message.replace(QRegularExpression("(the|unknown) key '" + key + "'"), title);
  message.replace(QRegularExpression("`" + key + "`"), title);
  message.replace(QRegularExpression("\\b" + key + " = "), title + " = ");
  message.replace(QRegularExpression("\\ban? \\[\\[input\\." + key + "\\]\\](?! to)"), text("one under %1").arg(title));
  message.replace(QRegularExpression("\\[\\[input\\." + key + "\\]\\]"), title);
  for (const Field& inner : field.fields) name_by_title(message, inner);
}

/// Of a table, the first required field without a value.
QString missing_in(const Table& table, const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    const scenario::Value* value = table.find(field.key);
    if (value == nullptr && field.options.presence == scenario::Presence::Required) return title_of(field);
    const auto* rows = value != nullptr ? std::get_if<std::vector<Table>>(value) : nullptr;
    for (std::size_t i = 0; rows != nullptr && i < rows->size(); ++i) {
      const QString inner = missing_in((*rows)[i], field.fields);
      if (!inner.isEmpty()) return text("%1 of %2 %3").arg(inner, title_of(field), QString::number(i + 1));
    }
  }
  return {};
}

/// "step 2" stands alone where the operation is not known.
QString item_in_words(const QString& item) {
  static const QRegularExpression step("^step (\\d+)$");
  const QRegularExpressionMatch match = step.match(item);
  return match.hasMatch() ? text("step %1").arg(match.captured(1)) : catalogue::translated(item);
}

/// The field of that key, of the input or of one of its tables; null if there is none.
const Field* field_of(const std::vector<Field>& fields, const std::string& key) {
  for (const Field& field : fields) {
    if (field.key == key) return &field;
    if (const Field* inner = field_of(field.fields, key)) return inner;
  }
  return nullptr;
}

/// `--repair (repair = "yes")` as `'Repair' = "yes"`, `--gap (gap in [input])` and `--gap` as `'Gap'`.
QString named_by_options(QString said, const std::vector<Field>& fields) {
  static const QRegularExpression option(R"(--([a-z]+(?:-[a-z]+)*)(?: \([a-z_]+( = [^()]*)?[^()]*\))?)");
  for (qsizetype from = 0;;) {
    const QRegularExpressionMatch match = option.match(said, from);
    if (!match.hasMatch()) return said;
    const Field* field = field_of(fields, match.captured(1).replace('-', '_').toStdString());
    const QString title = field != nullptr ? title_of(*field) + match.captured(2) : match.captured();
    said.replace(match.capturedStart(), match.capturedLength(), title);
    from = match.capturedStart() + title.size();
  }
}

}  // namespace

QString remark_in_words(const QString& remark, const std::vector<Field>& fields) {
  return named_by_options(catalogue::translated(remark), fields);
}

QString in_words_of_the_form(const QString& message, const std::vector<Field>& fields) {
  if (message.isEmpty()) return {};  // as a form says of each of its rows
  static const QRegularExpression without(R"( ?\(--[^()]*\))");
  // Templates have the options with their keys: these get their titles once the message is translated.
  static const QRegularExpression kept(R"(--[a-z-]+ \([^()]*\))");
  const QString bare = QString(message).remove(without);
  QString said;
  qsizetype from = 0;
  const auto add = [&](QString part) {
    for (const Field& field : fields) name_by_title(part, field);
    said += part;
  };
  for (auto options = kept.globalMatch(bare); options.hasNext();) {
    const QRegularExpressionMatch option = options.next();
    add(bare.mid(from, option.capturedStart() - from));
    said += option.captured();
    from = option.capturedEnd();
  }
  add(bare.mid(from));
  return named_by_options(catalogue::translated(said), fields).replace("[input]", text("Input"));
}

QString in_words(const base::Error& error) {
  QString words;
  if (!error.place) return catalogue::translated(QString::fromStdString(error.message));
  const base::Place& place = *error.place;
  if (!place.file.empty()) {
    words += QString::fromStdString(place.file);
    if (place.line > 0) words += QString(":%1").arg(place.line);
    if (place.line > 0 && place.column > 0) words += QString(":%1").arg(place.column);
    words += ": ";
  }
  if (!place.item.empty()) words += item_in_words(QString::fromStdString(place.item)) + ": ";
  words += catalogue::translated(QString::fromStdString(error.message));
  if (place.x && place.y && place.z)
    words += " " + text("(at %1, %2, %3)").arg(coordinate(*place.x), coordinate(*place.y), coordinate(*place.z));
  else if (place.x && place.y)
    words += " " + text("(at %1, %2)").arg(coordinate(*place.x), coordinate(*place.y));
  if (place.u && place.v) words += " " + text("(u = %1, v = %2)").arg(coordinate(*place.u), coordinate(*place.v));
  return words;
}

QString in_words_of_the_window(base::Error error, const scenario::Document& document, const scenario::Program& program,
                               std::size_t part) {
  if (error.place && error.place->file == document.file.string()) {
    error.place->file.clear();
    error.place->line = 0;
  }
  if (part <= document.steps.size()) {
    const QString said =
        in_words_of_the_form(QString::fromStdString(error.message), documents::fields_of(document, program, part));
    error.message = said.toStdString();
  }
  return in_words(error);
}

QString in_words_of_the_import(base::Error error, const scenario::Document& document,
                               const scenario::Program& program) {
  if (const auto said = catalogue::of_import().with_arguments_kept(QString::fromStdString(error.message)))
    error.message = said->toStdString();
  return in_words_of_the_window(std::move(error), document, program, 0);
}

QString still_to_be_given(const scenario::Document& document, const scenario::Program& program) {
  for (std::size_t part = 0; part <= document.steps.size(); ++part) {
    const QString missing =
        missing_in(documents::table_of(document, part), documents::fields_of(document, program, part));
    if (!missing.isEmpty()) return missing;
  }
  return {};
}

}  // namespace dobra::gui
