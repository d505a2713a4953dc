#include "shared/base/error.h"

#include <fmt/format.h>

namespace dobra::base {

std::string to_string(const Error& error) {
  std::string text;
  if (error.place) {
    const Place& place = *error.place;
    if (!place.file.empty()) {
      text += place.file;
      if (place.line > 0) text += fmt::format(":{}", place.line);
      if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
      text += ": ";
    }
    if (!place.item.empty()) text += place.item + ": ";
  }
  text += error.message;
  if (!error.place) return text;
  const Place& place = *error.place;
  if (place.x && place.y) {
    text += fmt::format(" (at {:.10g}, {:.10g}", *place.x, *place.y);
    text += place.z ? fmt::format(", {:.10g})", *place.z) : ")";
  }
  if (place.u && place.v) text += fmt::format(" (u, v = {:.10g}, {:.10g})", *place.u, *place.v);
  return text;
}

int exit_code(ErrorCode code) {
  const int number = static_cast<int>(code);
  if (code == ErrorCode::Cancelled) return 130;
  if (code == ErrorCode::BadUsage) return 2;
  const bool bad_input = number / 100 == 1 || number / 100 == 7 || number / 100 == 8 || code == ErrorCode::BadSection ||
                         code == ErrorCode::BadDomain || code == ErrorCode::NotClosed || code == ErrorCode::InsideOut ||
                         code == ErrorCode::BadMesh || code == ErrorCode::NotSupported ||
                         code == ErrorCode::SelfIntersection || code == ErrorCode::OutsideDomain;
  const bool cannot_write = code == ErrorCode::CannotWrite;
  return bad_input && !cannot_write ? 3 : 4;
}

Error located(Error error, const Place& place) {
  if (!error.place) {
    error.place = place;
    return error;
  }
  Place& known = *error.place;
  if (known.file.empty()) {
    known.file = place.file;
    known.line = place.line;
    known.column = place.column;
  }
  if (known.item.empty()) known.item = place.item;
  if (!known.x) {
    known.x = place.x;
    known.y = place.y;
  }
  return error;
}

}  // namespace dobra::base
