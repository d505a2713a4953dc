#pragma once
// XML for the readers that need it: a document of pugixml, and the place in the file of whatever stands in it. Entities
// that a document declares itself are never put in: &name; stays as it is. Source: [pugixml].

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"

namespace dobra::io {

/// A document and the text that it was read from, which must outlive it.
class Xml {
 public:
  /// Comments, declarations and processing instructions are left out. Elements may be nested to any depth: walk them
  /// without recursion.
  /// @error EmptyFile; BadFormat with line and column: a zero byte, markup that does not end, an attribute without a
  ///        value in quotes, an end tag that closes nothing, an element that is not closed.  @cost linear
  static base::Result<Xml> parse(std::string_view text, const std::string& file);

  /// Its children are what stands outside of every element: the one root element, if the file is a document.
  [[nodiscard]] pugi::xml_node root() const { return document_; }
  /// Of the '<' of an element, of the first character of a text.
  [[nodiscard]] base::Place place(const pugi::xml_node& node) const;
  /// Of a character of the value of a text.
  [[nodiscard]] base::Place place(const char* at) const;
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  Xml(std::string_view text, std::string file)
      : text_(text), file_(std::move(file)), buffer_(text.begin(), text.end()) {}
  [[nodiscard]] base::Error error(const pugi::xml_parse_result& result) const;
  [[nodiscard]] pugi::xml_node innermost_open() const;

  std::string_view text_;
  std::string file_;
  std::vector<char> buffer_;  ///< The values of the document stand in it.
  pugi::xml_document document_;
};

/// The name of an element without its namespace: "path" of "svg:path".
std::string_view local_name(const pugi::xml_node& element);

}  // namespace dobra::io
