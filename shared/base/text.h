#pragma once
// Small text helpers: numbers that read back to the same bits, and suggestions for misspelt names.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dobra::base {

/// Shortest decimal form that reads back to exactly `value`; independent of the locale. Always has '.', 'e', "inf" or
/// "nan".
std::string number_text(double value);
/// The same at the end of `text`.
void append_number(std::string& text, double value);

/// The value of the whole of `text` as a decimal number, independent of the locale; nothing if any character is left
/// over.
std::optional<double> parse_number(std::string_view text);

/// The candidate nearest to `word` in edit distance, if it is near enough to be meant.
std::optional<std::string> suggestion(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'x'?" or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// Without the blanks at both ends; a view of the same text.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n\v\f");

/// English source text marked for translation; the programs install the translator of the user's language.
/// Returns `text` itself until then.
std::string translated(const char* text);
using Translator = std::string (*)(const char* text);
void set_translator(Translator translator);

}  // namespace dobra::base
