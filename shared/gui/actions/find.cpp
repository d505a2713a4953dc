#include "shared/gui/actions/find.h"

#include <algorithm>
#include <array>

namespace dobra::gui::actions {

QString folded(const QString& words) {
  QString bare;
  for (const QChar c : words.normalized(QString::NormalizationForm_D)) {
    if (!c.isMark()) bare.append(c);
  }
  return bare.toCaseFolded();
}

std::vector<std::size_t> found(const std::vector<Choice>& choices, const QString& typed) {
  const QString all = folded(typed).simplified();
  const QStringList words = all.split(' ', Qt::SkipEmptyParts);
  std::array<std::vector<std::size_t>, 3> ranks;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const QString title = folded(choices[i].title);
    const QString heard = title + '\n' + folded(choices[i].heard);
    if (!std::all_of(words.begin(), words.end(), [&](const QString& word) { return heard.contains(word); })) continue;
    const bool begins = title.startsWith(all);
    const bool word_begins = (' ' + title).contains(' ' + all);
    ranks[begins ? 0 : word_begins ? 1 : 2].push_back(i);
  }
  std::vector<std::size_t> places;
  for (const auto& rank : ranks) places.insert(places.end(), rank.begin(), rank.end());
  return places;
}

}  // namespace dobra::gui::actions
