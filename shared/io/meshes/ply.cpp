// 1. The header, text in all files, says the format, the elements and the types of their properties.
// 2. One loop over the elements reads numbers one by one: words of a text, bytes of a binary file.

#include "shared/io/meshes/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using mesh::PolygonMesh;

namespace {

enum class Format { Text, LittleEndian, BigEndian };

struct Number {
  std::size_t bytes = 0;
  enum class Kind { Signed, Unsigned, Real } kind = Kind::Signed;
};

struct Property {
  std::string name;
  Number number;
  std::optional<Number> count = {};  ///< Of a list.
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties = {};
};

struct Header {
  Format format = Format::Text;
  std::vector<Element> elements = {};
};

std::optional<Number> number_type(std::string_view name) {
  using enum Number::Kind;
  if (name == "char" || name == "int8") return Number{1, Signed};
  if (name == "uchar" || name == "uint8") return Number{1, Unsigned};
  if (name == "short" || name == "int16") return Number{2, Signed};
  if (name == "ushort" || name == "uint16") return Number{2, Unsigned};
  if (name == "int" || name == "int32") return Number{4, Signed};
  if (name == "uint" || name == "uint32") return Number{4, Unsigned};
  if (name == "float" || name == "float32") return Number{4, Real};
  if (name == "double" || name == "float64") return Number{8, Real};
  return std::nullopt;
}

Result<Number> number_at(const Records& records, std::size_t i, bool whole) {
  const std::string_view word = i < records.size() ? records.word(i) : "";
  const std::optional<Number> type = number_type(word);
  if (!type) return records.error(i, fmt::format("{} is no type of a number in a .ply", shown(word)));
  if (whole && type->kind == Number::Kind::Real)
    return records.error(i, "the counts and corners of a .ply are whole numbers; give a list of such");
  return *type;
}

/// "property TYPE NAME" or "property list TYPE TYPE NAME".
Result<Property> property_at(const Records& records, bool of_face) {
  if (records.size() < 3) return records.error(0, "a property needs a type and a name");
  if (records.word(1) != "list") {
    DOBRA_TRY(const Number number, number_at(records, 1, false));
    return Property{std::string(records.word(2)), number};
  }
  DOBRA_TRY(const Number count, number_at(records, 2, true));
  if (records.size() < 5) return records.error(0, "a list needs two types and a name");
  const std::string name(records.word(4));
  DOBRA_TRY(const Number number, number_at(records, 3, of_face && name.starts_with("vertex_ind")));
  return Property{name, number, count};
}

std::size_t column(const Element& element, std::string_view name) {
  const auto& all = element.properties;
  return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; }) -
                                  all.begin());
}

/// Which property of a face holds its corners; the number of properties where none does.
std::size_t corner_column(const Element& face) {
  const auto& all = face.properties;
  for (const std::string_view name : {"vertex_indices", "vertex_index"}) {
    if (const std::size_t i = column(face, name); i < all.size() && all[i].count) return i;
  }
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [](const auto& p) { return p.count.has_value(); }) - all.begin());
}

Result<void> check_header(const Header& header, const Records& records) {
  for (const Element& element : header.elements) {
    if (element.name == "vertex") {
      for (const char* const name : {"x", "y", "z"}) {
        const std::size_t i = column(element, name);
        if (i == element.properties.size() || element.properties[i].count)
          return records.error(0, fmt::format("the header gives the vertices no number {}", name));
      }
    } else if (element.name == "face" && element.count > 0) {
      const std::size_t i = corner_column(element);
      if (i == element.properties.size()) return records.error(0, "the header gives the faces no list of corners");
      if (element.properties[i].number.kind == Number::Kind::Real)
        return records.error(0, "the corners of the faces are not whole numbers");
    }
  }
  return {};
}

Result<Header> read_header(Records& records) {
  DOBRA_TRY_VOID(records.expect("ply"));
  if (records.word(0) != "ply") return records.error(0, "a .ply file begins with ply");
  Header header;
  for (;;) {
    DOBRA_TRY_VOID(records.expect("end_header"));
    const std::string_view word = records.word(0);
    if (word == "end_header") break;
    if (word == "format") {
      const std::string_view name = records.size() > 1 ? records.word(1) : "";
      if (name == "binary_little_endian") {
        header.format = Format::LittleEndian;
      } else if (name == "binary_big_endian") {
        header.format = Format::BigEndian;
      } else if (name != "ascii") {
        return records.error(1, fmt::format("{} is no format of a .ply; they are ascii, binary_little_endian and "
                                            "binary_big_endian",
                                            shown(name)));
      }
    } else if (word == "element") {
      if (records.size() < 3) return records.error(0, "an element needs a name and a number");
      DOBRA_TRY(const std::size_t count, records.count(2, "the number of records", most_items));
      header.elements.push_back({std::string(records.word(1)), count});
    } else if (word == "property") {
      if (header.elements.empty()) return records.error(0, "a property belongs to an element");
      Element& element = header.elements.back();
      DOBRA_TRY(Property property, property_at(records, element.name == "face"));
      element.properties.push_back(std::move(property));
    }
  }
  DOBRA_TRY_VOID(check_header(header, records));
  return header;
}

Error more_than_counted(std::size_t points, std::size_t faces) {
  return {ErrorCode::BadFormat,
          fmt::format("the header counts {} points and {} faces, and here is one more record: mend "
                      "the counts, or take it out",
                      points, faces)};
}

/// The records of a text: a line each.
class TextBody {
 public:
  explicit TextBody(Records& records) : records_(records) {}
  Result<void> begin(const Element& element, std::size_t i) {
    word_ = 0;
    record_ = fmt::format("{} {} of {}", element.name, i + 1, element.count);
    return records_.expect(record_);
  }
  Result<double> real(const Property& property) { return records_.number(word_++, property.name); }
  /// At most as many as the line still has words.
  Result<std::size_t> list_size(const Property&) {
    DOBRA_TRY(const std::size_t count, records_.count(word_++, "the number of corners", most_items));
    const std::size_t left = records_.size() - word_;
    if (count <= left) return count;
    return records_.error(records_.size(),
                          fmt::format("{} has {} corners, and the line ends after {} of them; the file may "
                                      "have been cut short",
                                      record_, count, left));
  }
  Result<std::size_t> corner(Number) { return records_.count(word_++, "the corner", most_items); }
  Result<void> skip(Number, std::size_t times) {
    word_ += times;
    return {};
  }
  /// Of the number that was read last.
  [[nodiscard]] Error error(ErrorCode, std::string message) const {
    return records_.error(word_ - 1, std::move(message));
  }
  Result<void> end(const PolygonMesh& mesh) {
    if (!records_.next()) return {};
    return records_.error(0, more_than_counted(mesh.points.size(), mesh.faces.size()).message);
  }

 private:
  Records& records_;
  std::size_t word_ = 0;
  std::string record_;  ///< "face 3 of 12".
};

/// The records of a binary file: bytes one after another.
class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, bool big, const std::string& file) : rest_(bytes), big_(big), file_(file) {}
  Result<void> begin(const Element& element, std::size_t i) {
    element_ = &element;
    record_ = i;
    return {};
  }
  Result<double> real(const Property& property) {
    DOBRA_TRY(const double value, number(property.number));
    if (std::isfinite(value)) return value;
    return error(ErrorCode::NotFinite, fmt::format("{} is not a finite number", property.name));
  }
  /// At most as many as there are bytes for.
  Result<std::size_t> list_size(const Property& property) {
    DOBRA_TRY(const std::size_t count, whole(*property.count, "the number of corners"));
    if (count > rest_.size() / property.number.bytes) return cut_short();
    return count;
  }
  Result<std::size_t> corner(Number type) { return whole(type, "the corner"); }
  Result<void> skip(Number type, std::size_t times) {
    if (times > rest_.size() / type.bytes) return cut_short();
    rest_.remove_prefix(times * type.bytes);
    return {};
  }
  [[nodiscard]] Error error(ErrorCode code, std::string_view message) const {
    return {code, fmt::format("{} {} of {}: {}", element_->name, record_ + 1, element_->count, message),
            base::Place{.file = file_}};
  }
  Result<void> end(const PolygonMesh& mesh) {
    if (rest_.empty()) return {};
    return base::located(more_than_counted(mesh.points.size(), mesh.faces.size()), {.file = file_});
  }

 private:
  [[nodiscard]] Error cut_short() const {
    return error(ErrorCode::BadFormat, "the file ends here, as if it were cut short; write it again");
  }
  Result<std::size_t> whole(Number type, std::string_view what) {
    DOBRA_TRY(const double value, number(type));
    if (value >= 0.0) return static_cast<std::size_t>(value);
    return error(ErrorCode::BadFormat, fmt::format("{} {} is less than 0", what, value));
  }
  /// Every whole number that there is, of 32 bits, is one of double precision.
  Result<double> number(Number type) {
    if (type.bytes > rest_.size()) return cut_short();
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const auto byte = static_cast<unsigned char>(rest_[big_ ? i : type.bytes - 1 - i]);
      bits = bits << 8U | byte;
    }
    rest_.remove_prefix(type.bytes);
    if (type.kind == Number::Kind::Real) {
      return type.bytes == 4 ? double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))}
                             : std::bit_cast<double>(bits);
    }
    const double value = static_cast<double>(bits);
    const double beyond = std::ldexp(1.0, static_cast<int>(8 * type.bytes));
    return type.kind == Number::Kind::Signed && value >= beyond / 2.0 ? value - beyond : value;
  }

  std::string_view rest_;
  bool big_;
  const std::string& file_;
  const Element* element_ = nullptr;
  std::size_t record_ = 0;
};

template <class Body>
Result<void> read_vertex(Body& body, const Element& element, PolygonMesh& mesh) {
  Point3 point;
  for (const Property& property : element.properties) {
    double* const into = property.name == "x"   ? &point.x
                         : property.name == "y" ? &point.y
                         : property.name == "z" ? &point.z
                                                : nullptr;
    if (property.count) {
      DOBRA_TRY(const std::size_t count, body.list_size(property));
      DOBRA_TRY_VOID(body.skip(property.number, count));
    } else if (into == nullptr) {
      DOBRA_TRY_VOID(body.skip(property.number, 1));
    } else {
      DOBRA_TRY(*into, body.real(property));
    }
  }
  mesh.points.push_back(point);
  return {};
}

template <class Body>
Result<void> read_face(Body& body, const Element& element, std::size_t corners, PolygonMesh& mesh) {
  std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const Property& property = element.properties[p];
    std::size_t count = 1;
    if (property.count) {
      DOBRA_TRY(count, body.list_size(property));
    }
    if (p != corners) {
      DOBRA_TRY_VOID(body.skip(property.number, count));
      continue;
    }
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY(const std::size_t corner, body.corner(property.number));
      if (corner >= mesh.points.size())
        return body.error(ErrorCode::BadFormat, fmt::format("there is no point {}", corner));
      face.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  return {};
}

template <class Body>
Result<void> read_other(Body& body, const Element& element) {
  for (const Property& property : element.properties) {
    std::size_t count = 1;
    if (property.count) {
      DOBRA_TRY(count, body.list_size(property));
    }
    DOBRA_TRY_VOID(body.skip(property.number, count));
  }
  return {};
}

template <class Body>
Result<PolygonMesh> read_body(Body body, const Header& header) {
  PolygonMesh mesh;
  for (const Element& element : header.elements) {
    if (element.properties.empty() && header.format != Format::Text) continue;
    const std::size_t corners = corner_column(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      DOBRA_TRY_VOID(body.begin(element, i));
      if (element.name == "vertex") {
        DOBRA_TRY_VOID(read_vertex(body, element, mesh));
      } else if (element.name == "face") {
        DOBRA_TRY_VOID(read_face(body, element, corners, mesh));
      } else {
        DOBRA_TRY_VOID(read_other(body, element));
      }
    }
  }
  DOBRA_TRY_VOID(body.end(mesh));
  return mesh;
}

/// Behind the line end_header: one or two bytes end it, as they end the first line. Nothing if there is no such line.
std::size_t body_begin(std::string_view bytes) {
  constexpr std::string_view last = "end_header";
  for (std::size_t at = bytes.find(last); at != std::string_view::npos; at = bytes.find(last, at + 1)) {
    if (at == 0 || (bytes[at - 1] != '\n' && bytes[at - 1] != '\r')) continue;
    const std::size_t first_end = bytes.find_first_of("\r\n");
    const bool two = bytes.substr(first_end, 2) == "\r\n";
    return std::min(bytes.size(), at + last.size() + (two ? 2 : 1));
  }
  return std::string_view::npos;
}

}  // namespace

Result<PolygonMesh> parse_ply(std::string_view bytes, const std::string& file) {
  const std::string_view head = bytes.substr(0, body_begin(bytes));
  DOBRA_TRY_VOID(check_text(head, file));
  Records records(head, file);
  DOBRA_TRY(const Header header, read_header(records));
  if (header.format != Format::Text)
    return read_body(BinaryBody(bytes.substr(head.size()), header.format == Format::BigEndian, file), header);
  DOBRA_TRY_VOID(check_text(bytes, file));
  Records all(bytes, file);
  DOBRA_TRY_VOID(read_header(all));
  return read_body(TextBody(all), header);
}

}  // namespace dobra::io::meshes
