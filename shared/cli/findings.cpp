#include "shared/cli/findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/scenario/units.h"

namespace dobra::cli {

namespace {

/// The name of a code, for scripts.
const char* name_of(base::ErrorCode code) {
  switch (code) {
    case base::ErrorCode::Cancelled:
      return "cancelled";
    case base::ErrorCode::NotFinite:
      return "not_finite";
    case base::ErrorCode::DegenerateCurve:
      return "degenerate_curve";
    case base::ErrorCode::InvalidOption:
      return "invalid_option";
    case base::ErrorCode::CannotInsert:
      return "cannot_insert";
    case base::ErrorCode::NotInSubdivision:
      return "not_in_subdivision";
    case base::ErrorCode::OffsetFailed:
      return "offset_failed";
    case base::ErrorCode::SelfIntersection:
      return "self_intersection";
    case base::ErrorCode::OutsideDomain:
      return "outside_domain";
    case base::ErrorCode::CannotMesh:
      return "cannot_mesh";
    case base::ErrorCode::TooManyElements:
      return "too_many_elements";
    case base::ErrorCode::CannotSolve:
      return "cannot_solve";
    case base::ErrorCode::NotSupported:
      return "not_supported";
    case base::ErrorCode::BadCrack:
      return "bad_crack";
    case base::ErrorCode::CannotDraw:
      return "cannot_draw";
    case base::ErrorCode::FileNotFound:
      return "file_not_found";
    case base::ErrorCode::NotAFile:
      return "not_a_file";
    case base::ErrorCode::CannotRead:
      return "cannot_read";
    case base::ErrorCode::EmptyFile:
      return "empty_file";
    case base::ErrorCode::BadFormat:
      return "bad_format";
    case base::ErrorCode::CannotWrite:
      return "cannot_write";
    case base::ErrorCode::UnknownFormat:
      return "unknown_format";
    case base::ErrorCode::Unclear:
      return "unclear";
    case base::ErrorCode::BadSyntax:
      return "bad_syntax";
    case base::ErrorCode::UnknownKey:
      return "unknown_key";
    case base::ErrorCode::MissingKey:
      return "missing_key";
    case base::ErrorCode::BadValue:
      return "bad_value";
    case base::ErrorCode::UnknownOperation:
      return "unknown_operation";
    case base::ErrorCode::UnknownQuantity:
      return "unknown_quantity";
    case base::ErrorCode::WrongProgram:
      return "wrong_program";
    case base::ErrorCode::BadUsage:
      return "bad_usage";
    case base::ErrorCode::BadSection:
      return "bad_section";
    case base::ErrorCode::CannotRestore:
      return "cannot_restore";
    case base::ErrorCode::BadDomain:
      return "bad_domain";
    case base::ErrorCode::NotClosed:
      return "not_closed";
  }
  return "error";
}

nlohmann::ordered_json place_json(const base::Place& place, const scenario::UnitSystem& units) {
  nlohmann::ordered_json json;
  if (!place.item.empty()) json["item"] = place.item;
  if (!place.file.empty()) json["file"] = place.file;
  if (place.line > 0) json["line"] = place.line;
  if (place.x && place.y) {
    json["point"] = {units.from_si(*place.x, "m"), units.from_si(*place.y, "m"),
                     units.from_si(place.z.value_or(0.0), "m")};
  }
  if (place.u && place.v) json["uv"] = {*place.u, *place.v};
  return json;
}

}  // namespace

nlohmann::ordered_json findings_json(const std::vector<base::Finding>& findings, const scenario::UnitSystem& units) {
  auto json = nlohmann::ordered_json::array();
  for (const base::Finding& finding : findings) {
    json.push_back({{"code", finding.code},
                    {"message", scenario::message_in_units(finding.message, units)},
                    {"place", place_json(finding.place, units)}});
  }
  return json;
}

base::Finding finding_of(const base::Error& error) {
  return {name_of(error.code), error.message, error.place.value_or(base::Place{})};
}

base::Result<void> print_json(const nlohmann::ordered_json& json) {
  return print(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

base::Result<void> tell_refusal(Session& session, const base::Error& error) {
  if (session.options.format != OutputFormat::Json || error.code == base::ErrorCode::Cancelled) return {};
  nlohmann::ordered_json json;
  json["findings"] = findings_json({finding_of(error)}, {});
  return print_json(json);
}

base::Result<void> tell(Session& session, const nlohmann::ordered_json& json,
                        const std::vector<base::Finding>& findings) {
  if (session.options.format == OutputFormat::Json) return print_json(json);
  for (const auto& finding : findings) session.note(finding.message);
  if (session.options.verbosity == Verbosity::Quiet) return {};
  const auto is_line = [](const auto& value) { return value.is_number() || value.is_string(); };
  std::size_t width = 0;
  for (const auto& [name, value] : json.items()) width = is_line(value) ? std::max(width, name.size()) : width;
  std::string text;
  for (const auto& [name, value] : json.items()) {
    if (is_line(value)) text += fmt::format("{:<{}} {}\n", name, width + 1, value.dump());
  }
  return print(text);
}

}  // namespace dobra::cli
