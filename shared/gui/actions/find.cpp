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

namespace {

/// The words of a title, folded, with blanks for quotes and the like: "Add 'Mesh'" as "add mesh".
QString words_of(const QString& title) {
  QString words = folded(title);
  for (QChar& c : words) {
    if (!c.isLetterOrNumber()) c = ' ';
  }
  return words.simplified();
}

/// How well a title answers what is typed: 0 best; 4 where the words stand beside the title alone.
std::size_t rank_of(const QString& title, const QString& typed, const QStringList& words) {
  const QString bare = words_of(title);
  const QString wanted = words_of(typed);
  const auto begins_a_word = [&](const QString& word) { return (' ' + bare).contains(' ' + word); };
  if (bare.startsWith(wanted)) return 0;
  if (begins_a_word(wanted)) return 1;
  if (std::all_of(words.begin(), words.end(), begins_a_word)) return 2;
  const QString whole = folded(title);
  if (std::all_of(words.begin(), words.end(), [&](const QString& word) { return whole.contains(word); })) return 3;
  return 4;
}

}  // namespace

std::vector<std::size_t> found(const std::vector<Choice>& choices, const QString& typed) {
  const QString all = folded(typed).simplified();
  const QStringList words = all.split(' ', Qt::SkipEmptyParts);
  std::array<std::vector<std::size_t>, 5> ranks;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const QString title = folded(choices[i].title);
    const QString heard = title + '\n' + folded(choices[i].heard);
    if (!std::all_of(words.begin(), words.end(), [&](const QString& word) { return heard.contains(word); })) continue;
    ranks[rank_of(choices[i].title, all, words)].push_back(i);
  }
  std::vector<std::size_t> places;
  for (const auto& rank : ranks) places.insert(places.end(), rank.begin(), rank.end());
  return places;
}

}  // namespace dobra::gui::actions
