#include "shared/gui/vertices/pointing.h"

#include <algorithm>

#include "shared/base/text.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::vertices {

namespace {

QString title_of(const Pointing& wish) { return text(wish.field.options.title); }

/// A length of the picture in the units of the document.
QString length_text(double value, const scenario::Document& document) {
  if (document.shown_units().text() != document.units.text())
    value = document.units.from_si(document.shown_units().to_si(value, "m"), "m");
  return QString::fromStdString(base::number_text(value));
}

/// Empty where the steps before the part know no such name.
std::string name_pointed_at(const Pointing& wish, const canvas::Pointed& pointed, const scenario::Program& program,
                            const documents::Outcome* outcome) {
  if (!program.name_at || !program.names_of || outcome == nullptr || outcome->run.states.empty()) return {};
  const std::vector<scenario::State>& states = outcome->run.states;
  const scenario::UnitSystem& units = outcome->document->shown_units();
  const geom::Point at{units.to_si(pointed.under.x, "m"), units.to_si(pointed.under.y, "m")};
  const std::string& what = wish.field.options.names;
  const scenario::State& seen = wish.shown == documents::Shown::Input ? states.front() : states.back();
  const std::string name = program.name_at(seen, what, pointed.line, at);
  const std::size_t before = std::min(wish.part == 0 ? 0 : wish.part - 1, states.size() - 1);
  const std::vector<std::string> known = program.names_of(states[before], what);
  return std::find(known.begin(), known.end(), name) == known.end() ? std::string() : name;
}

}  // namespace

QString hint_of(const Pointing& wish) {
  return wish.of_name() ? text("Click the line for '%1'; Escape leaves it as it is.").arg(title_of(wish))
                        : text("Click the place for '%1'; Escape leaves it as it is.").arg(title_of(wish));
}

base::Result<QString> pointed_text(const Pointing& wish, const canvas::Pointed& pointed,
                                   const scenario::Document& document, const scenario::Program& program,
                                   const documents::Outcome* outcome) {
  if (wish.of_name()) {
    const std::string name = name_pointed_at(wish, pointed, program, outcome);
    if (!name.empty()) return QString::fromStdString(name);
    const QString why = text("This is nothing for '%1': click another line, or press Escape.").arg(title_of(wish));
    return base::Error{base::ErrorCode::BadValue, why.toStdString()};
  }
  const QString x = length_text(pointed.at.x, document);
  const QString z = length_text(pointed.at.y, document);
  if (wish.field.kind == scenario::Kind::Point) return x + ", " + z;
  return wish.field.options.names == "x" ? x : z;
}

}  // namespace dobra::gui::vertices
