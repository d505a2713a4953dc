#include "shared/io/xml.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

/// What markup that does not end begins with; empty for what is wrong where the parser stands.
std::string_view beginning_of(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_bad_comment:
      return "<!--";
    case pugi::status_bad_cdata:
      return "<![";
    case pugi::status_bad_doctype:
      return "<!";
    case pugi::status_bad_pi:
      return "<?";
    default:
      return {};
  }
}

const char* what_is_wrong(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_bad_comment:
      return "this comment does not end";
    case pugi::status_bad_cdata:
    case pugi::status_bad_doctype:
    case pugi::status_bad_pi:
      return "this markup does not end";
    case pugi::status_bad_attribute:
      return "an attribute needs a name, '=' and a value between quotes";
    case pugi::status_bad_start_element:
      return "this tag does not end, or has a character that no name may have";
    case pugi::status_bad_end_element:
      return "this end tag does not end";
    case pugi::status_out_of_memory:
      return "the file is too large for the memory";
    default:
      return "a name is due after '<'; the sign itself is written &lt;";
  }
}

}  // namespace

std::string_view local_name(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  return name.substr(name.find(':') + 1);
}

Place Xml::place(const char* at) const {
  return place_of_byte(text_, static_cast<std::size_t>(at - buffer_.data()), file_);
}

Place Xml::place(const pugi::xml_node& node) const {
  const auto offset = static_cast<std::size_t>(node.offset_debug());
  return place_of_byte(text_, offset - (node.type() == pugi::node_element ? 1 : 0), file_);
}

// At the end of the text. What is open is a chain of last children; the end tags behind the innermost of that chain
// close it and what is round it.
pugi::xml_node Xml::innermost_open() const {
  pugi::xml_node node = document_;
  const auto last_element = [](const pugi::xml_node& parent) {
    pugi::xml_node child = parent.last_child();
    while (child && child.type() != pugi::node_element) child = child.previous_sibling();
    return child;
  };
  while (const pugi::xml_node inner = last_element(node)) node = inner;
  const auto begin = static_cast<std::size_t>(node.offset_debug());
  const std::size_t tag_end = std::min(text_.find('>', begin), text_.size());
  std::size_t closed = tag_end > begin && tag_end < text_.size() && text_[tag_end - 1] == '/' ? 1 : 0;
  for (std::size_t at = text_.find("</", begin); at != std::string_view::npos; at = text_.find("</", at + 2)) {
    closed += text_.find('>', at) == std::string_view::npos ? 0 : 1;
  }
  for (; closed > 0 && node.parent().type() == pugi::node_element; --closed) node = node.parent();
  return node;
}

Error Xml::error(const pugi::xml_parse_result& result) const {
  const auto offset = std::min(static_cast<std::size_t>(result.offset), text_.size());
  const auto fail = [&](std::string message, const Place& where) {
    return Error{ErrorCode::BadFormat, std::move(message), where};
  };
  if (result.status != pugi::status_end_element_mismatch) {
    const std::string_view begin = beginning_of(result.status);
    const std::size_t at = begin.empty() ? std::string_view::npos : text_.rfind(begin, offset);
    return fail(what_is_wrong(result.status), place_of_byte(text_, std::min(at, offset), file_));
  }
  const std::size_t tag = text_.rfind("</", offset);
  if (offset + 1 < text_.size() && tag != std::string_view::npos) {
    const std::string_view shut = text_.substr(tag, text_.find('>', tag) + 1 - tag);
    return fail(fmt::format("the end tag {} closes nothing that is open", shown(shut)),
                place_of_byte(text_, tag, file_));
  }
  const pugi::xml_node open = innermost_open();
  return fail(fmt::format("the element {} is not closed; the file may have been cut short", shown(open.name())),
              place(open));
}

Result<Xml> Xml::parse(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  Xml xml(text, file);
  // Line ends stay as they are, so that places count the bytes of the file.
  constexpr unsigned int options = pugi::parse_escapes | pugi::parse_cdata | pugi::parse_fragment;
  const pugi::xml_parse_result result =
      xml.document_.load_buffer_inplace(xml.buffer_.data(), xml.buffer_.size(), options, pugi::encoding_utf8);
  if (!result) return xml.error(result);
  return xml;
}

}  // namespace dobra::io
