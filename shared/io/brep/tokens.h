#pragma once
// The words of a .brep file, one after the other over all lines.

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/geom/point3.h"

namespace dobra::io::brep {

/// `text` outlives it.
class Tokens {
 public:
  Tokens(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// The next word, without taking it; empty at the end.
  std::string_view peek();
  /// @error BadFormat: the file ends before `what`.
  base::Result<std::string_view> word(std::string_view what);
  /// @error BadFormat: another word, or the end.
  base::Result<void> expect(std::string_view keyword);
  base::Result<double> number(std::string_view what);
  base::Result<geom::Vector3> vector(std::string_view what);
  base::Result<geom::Point3> point(std::string_view what);
  /// Two numbers, z = 0.
  base::Result<geom::Point3> point_of_chart(std::string_view what);
  /// An integer in low .. high.
  base::Result<long> integer(std::string_view what, long low, long high);
  base::Result<bool> flag(std::string_view what);
  /// How many things follow that take `words_each` words, as far as the rest of the file can hold them.
  base::Result<std::size_t> count(std::string_view what, std::size_t words_each);
  enum class After { Blank, Anything };
  /// A number of a table from 1 to `size`, from 0 then. Behind it the next word may follow without a blank.
  base::Result<std::size_t> index(std::string_view what, std::size_t size, After after = After::Blank);
  void skip_line();

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  /// BadFormat at the word that was taken last.
  [[nodiscard]] base::Error error(std::string message, base::ErrorCode code = base::ErrorCode::BadFormat) const;

 private:
  void skip_blanks();
  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0, begin_of_line_ = 0, line_ = 1;
  std::size_t said_line_ = 1, said_column_ = 1;  ///< Of the word taken last.
};

}  // namespace dobra::io::brep
