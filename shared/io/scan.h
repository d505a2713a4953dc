#pragma once
// Lines and words of a text file with their places, for all readers of text: every error they give names
// file, line, column and the text that offends.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"

namespace dobra::io {

/// A piece of a line; `column` is 1-based and counts bytes.
struct Word {
  std::string_view text;
  std::size_t column = 0;
};

/// Text as it can stand in a one-line message: quoted, unprintable bytes as '?', cut after 40 bytes.
std::string shown(std::string_view text);

/// Refuses what no text reader can use.
/// @error EmptyFile: nothing but blanks; BadFormat with line and column: a zero byte (a binary file).
base::Result<void> check_text(std::string_view text, const std::string& file);

/// A finite number.
/// @error BadFormat (not a number, decimal comma) or NotFinite (NaN, infinity), naming the text but no place.
base::Result<double> finite_number(std::string_view text, std::string_view what);

/// What every writer asks first. @error NotFinite with the point's number in `what` and the place.
base::Result<void> check_finite(std::span<const geom::Point> points, std::string_view what);

/// The place of byte `offset` of `text`.
base::Place place_of_byte(std::string_view text, std::size_t offset, const std::string& file);

/// The lines of a text: byte order mark, LF, CRLF and CR line ends taken away.
class Lines {
 public:
  explicit Lines(std::string_view text);
  /// Moves to the next line; false after the last one.
  bool next();
  [[nodiscard]] std::string_view line() const { return line_; }
  /// 1-based number of the current line, byte columns counted from its start.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// Words separated by blanks and tabs.
void split_words(std::string_view line, std::vector<Word>& words);

/// The most points or cells of a file: their numbers have 32 bits, of which the greatest is no number.
inline constexpr std::size_t most_items = 0xFFFFFFFEU;

/// Records: the lines that hold words; comments (from `comment` to the end of the line) and empty lines are skipped.
/// `text` must outlive the reader.
class Records {
 public:
  Records(std::string_view text, std::string file, char comment = '#', char separator = ' ');

  /// Moves to the next record; false at the end of the file.
  bool next();
  /// Moves to the next record. @error BadFormat: the file ends before `what`.
  base::Result<void> expect(std::string_view what);
  /// The current record is read again by the following next().
  void back() { again_ = true; }

  [[nodiscard]] std::size_t size() const { return words_.size(); }
  /// @pre i < size()
  [[nodiscard]] std::string_view word(std::size_t i) const { return words_[i].text; }
  [[nodiscard]] std::string_view line() const { return lines_.line(); }
  [[nodiscard]] std::size_t line_number() const { return lines_.number(); }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// Word i as a finite number; `what` says what it stands for. @error BadFormat, NotFinite with the place.
  [[nodiscard]] base::Result<double> number(std::size_t i, std::string_view what) const;
  /// Word i as an integer. @error BadFormat with the place.
  [[nodiscard]] base::Result<std::int64_t> integer(std::size_t i, std::string_view what) const;
  /// Word i as an integer >= 0 and <= `limit`. @error BadFormat with the place.
  [[nodiscard]] base::Result<std::size_t> count(std::size_t i, std::string_view what,
                                                std::size_t limit = SIZE_MAX) const;

  /// BadFormat at word i of the current record, or at the end of its line if it has fewer words.
  [[nodiscard]] base::Error error(std::size_t i, std::string message) const;
  /// The place of word i.
  [[nodiscard]] base::Place place(std::size_t i) const;

 private:
  Lines lines_;
  std::string file_;
  char comment_;
  char separator_;
  bool again_ = false;
  std::vector<Word> words_;
};

/// Number of records of at least `bytes_each` bytes that a file of `text.size()` bytes can hold: an upper bound for
/// what a reader reserves, so that a corrupt count cannot exhaust the memory.
inline std::size_t plausible_count(std::size_t count, std::string_view text, std::size_t bytes_each = 2) {
  return count < text.size() / bytes_each + 1 ? count : text.size() / bytes_each + 1;
}

}  // namespace dobra::io
