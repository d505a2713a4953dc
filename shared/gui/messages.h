#pragma once
// Messages in the words of the window: what a scenario file calls by a key, a form calls by its title.

#include <QString>

#include "shared/scenario/program.h"

namespace dobra::gui {

/// `message` with the titles of `fields` (and of the fields of their tables) where it names their keys, and without
/// what it says of the command line; in the user's language.
QString in_words_of_the_form(const QString& message, const std::vector<scenario::Field>& fields);

/// A remark in the user's language, with the titles of `fields` where it speaks of options of the command line.
QString remark_in_words(const QString& remark, const std::vector<scenario::Field>& fields);

/// base::to_string in the user's language.
QString in_words(const base::Error& error);

/// What went wrong in part `part` of a document. Lines of the document's own file are left out: those on the screen may
/// be others by now.
QString in_words_of_the_window(base::Error error, const scenario::Document& document, const scenario::Program& program,
                               std::size_t part);

/// What is to be said of a file that is brought into `document`, in the words of the import dialog.
QString in_words_of_the_import(base::Error error, const scenario::Document& document, const scenario::Program& program);

/// What is still to be given before a document can be run: "'Name' of 'Horizons' 2"; empty if nothing is.
QString still_to_be_given(const scenario::Document& document, const scenario::Program& program);

}  // namespace dobra::gui
