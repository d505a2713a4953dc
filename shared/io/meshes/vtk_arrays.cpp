// 1. Find the piece, and the DataArrays in each of its sections and of those beside it.
// 2. Turn each DataArray into numbers.
#include "shared/io/meshes/vtk_arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>

#include "shared/base/text.h"
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

Result<VtkArrays> VtkArrays::read(std::string_view text, const std::string& path, std::string_view ending,
                                  const std::string& type, std::initializer_list<const char*> sections) {
  DOBRA_TRY(VtkParts parts, vtk_parts(text, path));
  auto kept = std::make_unique<VtkParts>(std::move(parts));
  DOBRA_TRY(Xml xml, Xml::parse(kept->markup, path));
  VtkArrays made(std::move(kept), std::make_unique<const Xml>(std::move(xml)));
  const pugi::xml_node file = made.xml_->root().child("VTKFile");
  if (!file) {
    return Error{ErrorCode::BadFormat, fmt::format("not a {} file: there is no VTKFile tag", ending),
                 base::Place{.file = path}};
  }
  DOBRA_TRY_VOID(made.check_header(file, type));
  DOBRA_TRY_VOID(made.find_appended(file));
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
  const std::string compressor = file.attribute("compressor").value();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    return refuse(
        fmt::format("data compressed by {} are not read; save them with zlib or uncompressed", shown(compressor)));
  const std::string header = file.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    return refuse(fmt::format("header type {} is not known", shown(header)));
  encoding_ = {.header_size = header == "UInt64" ? 8U : 4U, .zlib = !compressor.empty()};
  return {};
}

Result<void> VtkArrays::find_appended(const pugi::xml_node& file) {
  const pugi::xml_node node = file.child("AppendedData");
  const std::string encoding = node.attribute("encoding").as_string("base64");
  if (encoding == "raw") {
    appended_ = parts_->appended;
    return {};
  }
  if (encoding != "base64") return error(node, fmt::format("encoding {} is not known", shown(encoding)));
  appended_base64_ = true;
  appended_ = node.text().get();
  appended_.remove_prefix(std::min(appended_.find('_'), appended_.size() - 1) + 1);
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
  if (format == "ascii") {
    DOBRA_TRY_VOID(read_ascii(node.text().get(), array.field.values));
  } else if (format == "binary" || format == "appended") {
    DOBRA_TRY_VOID(read_binary(node, array.field.values));
  } else {
    return error(node, fmt::format("format {} is not known; it is ascii, binary or appended", shown(format)));
  }
  arrays_[section].push_back(std::move(array));
  return {};
}

Result<void> VtkArrays::read_binary(const pugi::xml_node& node, std::vector<double>& values) const {
  const std::string name = node.attribute("type").value();
  const auto* type = std::find_if(std::begin(types), std::end(types), [&](const Type& t) { return t.name == name; });
  if (type == std::end(types)) return error(node, fmt::format("number type {} is not known", shown(name)));
  VtkEncoding encoding = encoding_;
  std::string in_place;
  std::string_view data;
  if (std::string_view(node.attribute("format").value()) == "appended") {
    const std::string offset = node.attribute("offset").value();
    const std::optional<double> at = base::parse_number(offset);
    if (!at || !(*at >= 0.0) || *at >= static_cast<double>(appended_.size()) || *at != std::floor(*at))
      return error(node, fmt::format("offset {} does not lie in the appended data", shown(offset)));
    data = appended_.substr(static_cast<std::size_t>(*at));
    encoding.base64 = appended_base64_;
  } else {
    const std::string_view text = node.text().get();
    std::copy_if(text.begin(), text.end(), std::back_inserter(in_place),
                 [](char c) { return c != ' ' && c != '\n' && c != '\r' && c != '\t'; });
    if (in_place.empty()) return {};
    data = in_place;
    encoding.alone = true;
  }
  const Result<std::string> bytes = vtk_bytes(data, encoding);
  if (!bytes) return error(node, bytes.error().message);
  if (bytes->size() % type->size != 0)
    return error(node, fmt::format("{} bytes are no whole number of {}", bytes->size(), name));
  type->append(*bytes, values);
  for (const double value : values) {
    if (!std::isfinite(value)) return error(node, "the array holds a number that is not finite", ErrorCode::NotFinite);
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
