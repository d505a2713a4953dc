#pragma once
// Messages of the library in the user's language. The library says a message as one English line, made of a template
// and arguments ("'{}' must be {}, found {}"). The catalogue holds templates with their translations; a message is
// recognised by the fixed words of a template and said in the other one, with the same arguments. Arguments are
// messages again ("a number"), or numbers, which get the user's decimal mark; what stands in quotes is the user's own.
// Page: docs/contributing.md.

#include <QRegularExpression>
#include <QString>
#include <optional>
#include <vector>

#include "shared/base/result.h"

namespace dobra::gui::catalogue {

/// A template and its translation: {} or {0}, {1} stand for arguments; lines of their own in a file of messages.
struct Entry {
  QString source;
  QString translation;
};

class Catalogue {
 public:
  Catalogue() = default;
  explicit Catalogue(const std::vector<Entry>& entries);

  /// The message in the other language. Of several templates that fit the one with the most fixed letters wins; where
  /// none fits, what stands before and behind "; " or ": " is said by itself, and what no template fits stays.
  /// @cost a regular expression for each template whose first letters and longest part the message has
  [[nodiscard]] QString translated(const QString& message) const;
  /// As translated, but arguments stay as they are; nothing where no template fits.
  [[nodiscard]] std::optional<QString> with_arguments_kept(const QString& message) const;
  /// Whether a template fits the message.
  [[nodiscard]] bool knows(const QString& message) const;
  [[nodiscard]] std::size_t size() const { return patterns_.size(); }

 private:
  struct Pattern {
    QString start;    ///< The fixed letters before the first argument.
    QString longest;  ///< The longest of the fixed parts.
    QRegularExpression expression;
    std::vector<bool> quoted;  ///< Of each argument: stands in quotes.
    QString translation;
    qsizetype letters = 0;
  };
  /// Messages within messages up to `deeper` levels; arguments further in stay as they are.
  [[nodiscard]] std::optional<QString> said(const QString& message, int deeper) const;
  /// In parts, of which at least one has a template.
  [[nodiscard]] std::optional<QString> said_in_parts(const QString& message, int deeper) const;

  std::vector<Pattern> patterns_;  ///< Those with more fixed letters first.
};

/// Reads a file of messages: pairs of lines, template and translation, with blank lines and lines of # between them.
/// @error BadFormat with the number of the line: a template without a translation, or with other arguments.
base::Result<std::vector<Entry>> read_entries(const QString& text);

/// That of the user's language, in the resources of the window; empty in English. Set by install.
const Catalogue& current();
void install(const QString& language);

/// What the library says of files that are brought in, in the English words of the import dialog.
const Catalogue& of_import();

/// What stands before the last dot of a quantity's key, in the words of the user's language, English where there is no
/// other: "horizon.Top" gives "Horizon Top". Names stay; the key itself where it has no words.
QString words_of_group(const QString& group);
/// The last part of a quantity's key in words: "horizon.Top.length_after" gives "Length after".
QString words_of_quantity(const QString& key);

/// By the current catalogue.
inline QString translated(const QString& message) { return current().translated(message); }

}  // namespace dobra::gui::catalogue
