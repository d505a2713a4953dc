#pragma once
// Which entries of a list typed words mean.

#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

namespace dobra::gui::actions {

/// Something that the palette offers.
struct Choice {
  QString title;    ///< In the language of the user.
  QString where;    ///< "File > Open Recent", "Layers": where else it is found.
  QString keys;     ///< Empty: none.
  QString heard;    ///< What it is found by besides, never shown: id, English text.
  bool can = true;  ///< Choosing it does something.
  std::function<void()> run;
};

/// Small letters without accents: "Seção" and "SECAO" are both "secao".
QString folded(const QString& words);

/// The places in `choices` of those in whose title or `heard` each typed word occurs, accents and case aside: first
/// those whose title begins with what is typed, then those in which a word does, then those whose title has all typed
/// words, then the rest; each in the order given.
std::vector<std::size_t> found(const std::vector<Choice>& choices, const QString& typed);

}  // namespace dobra::gui::actions
