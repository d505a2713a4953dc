// 1. Find the piece, and the DataArrays in each of its sections and of those beside it.
// 2. Turn each DataArray into numbers (ASCII or base64 with a length in front).
#include "shared/io/meshes/vtk_arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "shared/base/text.h"
#include "shared/io/base64.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

// Size in bytes and conversion of one binary number.
template <class T>
void append_as(std::string_view bytes, std::vector<double>& values) {
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    values.push_back(static_cast<double>(value));
  }
}

struct Type {
  std::string_view name;
  std::size_t size;
  void (*append)(std::string_view, std::vector<double>&);
};

constexpr Type types[] = {{"Float64", 8, append_as<double>},     {"Float32", 4, append_as<float>},
                          {"Int64", 8, append_as<std::int64_t>}, {"UInt64", 8, append_as<std::uint64_t>},
                          {"Int32", 4, append_as<std::int32_t>}, {"UInt32", 4, append_as<std::uint32_t>},
                          {"Int16", 2, append_as<std::int16_t>}, {"UInt16", 2, append_as<std::uint16_t>},
                          {"Int8", 1, append_as<std::int8_t>},   {"UInt8", 1, append_as<std::uint8_t>}};

}  // namespace

Error VtkArrays::error(const pugi::xml_node& at, std::string message, ErrorCode code) const {
  return Error{code, std::move(message), xml_->place(at)};
}

Result<VtkArrays> VtkArrays::read(const Xml& xml, std::string_view ending, const std::string& type,
                                  std::initializer_list<const char*> sections) {
  VtkArrays made(xml);
  const pugi::xml_node file = xml.root().child("VTKFile");
  if (!file) {
    return Error{ErrorCode::BadFormat, fmt::format("not a {} file: there is no VTKFile tag", ending),
                 base::Place{.file = xml.file()}};
  }
  DOBRA_TRY_VOID(made.check_header(file, type));
  const pugi::xml_node data = file.child(type.c_str());
  made.piece_ = data.child("Piece");
  if (const pugi::xml_node second = made.piece_.next_sibling("Piece"))
    return made.error(second, "files of several pieces are not read; join them first", ErrorCode::UnknownFormat);
  for (const pugi::xml_node& parent : {data, made.piece_}) {
    for (const char* const section : sections) {
      for (const pugi::xml_node& array : parent.child(section).children("DataArray"))
        DOBRA_TRY_VOID(made.read_array(array, section));
    }
  }
  return made;
}

Result<void> VtkArrays::check_header(const pugi::xml_node& file, const std::string& type) {
  const auto refuse = [&](std::string message) { return error(file, std::move(message), ErrorCode::UnknownFormat); };
  const std::string given = file.attribute("type").value();
  if (given != type) return refuse(fmt::format("VTK type {} is not read here; give {}", shown(given), type));
  if (std::string_view(file.attribute("byte_order").as_string("LittleEndian")) != "LittleEndian")
    return refuse("only LittleEndian files are read");
  if (file.attribute("compressor")) return refuse("compressed files are not read; save it uncompressed");
  const std::string header = file.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    return refuse(fmt::format("header type {} is not known", shown(header)));
  header_size_ = header == "UInt64" ? 8 : 4;
  return {};
}

Result<void> VtkArrays::read_array(const pugi::xml_node& node, const std::string& section) {
  VtkArray array{{}, node};
  array.field.name = node.attribute("Name").value();
  const std::string components = node.attribute("NumberOfComponents").as_string("1");
  const std::optional<double> count = base::parse_number(components);
  if (!count || !(*count >= 1.0) || *count > 1000.0 || *count != std::floor(*count)) {
    return error(node, fmt::format("NumberOfComponents {} is not a count", shown(components)));
  }
  array.field.components = static_cast<std::size_t>(*count);
  const std::string format = node.attribute("format").as_string("ascii");
  if (format != "ascii" && format != "binary") {
    return error(node, fmt::format("format {} is not read; save it as ASCII or inline binary", shown(format)),
                 ErrorCode::UnknownFormat);
  }
  const auto is_text = [](const pugi::xml_node& child) { return child.type() != pugi::node_element; };
  const auto text = std::find_if(node.begin(), node.end(), is_text);
  if (text != node.end()) DOBRA_TRY_VOID(read_values(node, *text, array.field.values));
  arrays_[section].push_back(std::move(array));
  return {};
}

Result<void> VtkArrays::read_values(const pugi::xml_node& node, const pugi::xml_node& text,
                                    std::vector<double>& values) const {
  const std::string format = node.attribute("format").as_string("ascii");
  const std::string name = node.attribute("type").value();
  const auto* type = std::find_if(std::begin(types), std::end(types), [&](const Type& t) { return t.name == name; });
  if (type == std::end(types)) return error(node, fmt::format("number type {} is not known", shown(name)));
  if (format == "ascii") return read_ascii(text.value(), values);
  const std::optional<std::string> bytes = from_base64(text.value());
  if (!bytes || bytes->size() < header_size_) return error(text, "this array is not valid base64");
  std::uint64_t size = 0;
  std::memcpy(&size, bytes->data(), header_size_);
  if (size != bytes->size() - header_size_ || size % type->size != 0) {
    return error(text, fmt::format("the array says {} bytes and holds {}", size, bytes->size() - header_size_));
  }
  type->append(std::string_view(*bytes).substr(header_size_), values);
  for (const double value : values) {
    if (!std::isfinite(value)) return error(text, "the array holds a number that is not finite", ErrorCode::NotFinite);
  }
  return {};
}

Result<void> VtkArrays::read_ascii(std::string_view text, std::vector<double>& values) const {
  constexpr std::string_view blanks = " \t\r\n";
  while (true) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    const Result<double> value = finite_number(word, "the value");
    if (!value) return base::located(value.error(), xml_->place(word.data()));
    values.push_back(*value);
    text.remove_prefix(word.size());
  }
}

Result<VtkArray> VtkArrays::take(const std::string& section, std::string_view name) {
  std::vector<VtkArray>& arrays = arrays_[section];
  for (auto it = arrays.begin(); it != arrays.end(); ++it) {
    if (!name.empty() && it->field.name != name) continue;
    VtkArray array = std::move(*it);
    arrays.erase(it);
    return array;
  }
  return Error{ErrorCode::BadFormat, fmt::format("there is no array {} in {}", shown(name), section),
               base::Place{.file = xml_->file()}};
}

}  // namespace dobra::io::meshes
