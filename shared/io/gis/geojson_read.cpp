// 1. A strict JSON pass finds syntax errors with their line and column (GDAL is lenient and tells neither).
// 2. GDAL/OGR reads the features from memory, its messages collected instead of printed.
// 3. Each OGR feature becomes a Feature; anything GDAL reported as a failure on the way is our error.

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "shared/io/file.h"
#include "shared/io/gis/gdal.h"
#include "shared/io/gis/geojson.h"
#include "shared/io/gis/ogr_features.h"
#include "shared/io/scan.h"

namespace dobra::io::gis {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

// Walks the JSON without keeping it and remembers the first error.
struct SyntaxCheck : nlohmann::json_sax<nlohmann::json> {
  explicit SyntaxCheck(std::size_t text_size) : size(text_size) {}
  std::size_t size;
  int objects = 0;  // that are open
  int arrays = 0;
  std::size_t ids = 0;         // of features
  bool at_system = false;      // behind the key "crs" of the root
  bool has_system = false;     // which may be null: none can be assumed
  bool states_system = false;  // else OGR takes longitudes and latitudes
  bool in_system = false;
  bool at_name = false;
  std::string system_name;
  std::size_t offset = 0;  // of the word that offends
  bool at_end = false;
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t& word) override {
    if (in_system && at_name) system_name = word;
    return true;
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    states_system = states_system || at_system;
    in_system = in_system || at_system;
    at_system = false;
    return ++objects, true;
  }
  bool key(string_t& word) override {
    // A feature lies in the array of the root, or is the root.
    at_system = objects == 1 && word == "crs";
    has_system = has_system || at_system;
    at_name = word == "name";
    if (word == "id" && (objects == 1 || (objects == 2 && arrays == 1))) ++ids;
    return true;
  }
  bool end_object() override {
    --objects;
    in_system = in_system && objects > 1;
    return true;
  }
  bool start_array(std::size_t) override { return ++arrays, true; }
  bool end_array() override { return --arrays, true; }
  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::detail::exception&) override {
    // A number out of range is refused behind its last digit; the place is its first one.
    const bool number = last_token.find_first_not_of("0123456789+-.eE") == std::string::npos;
    offset = position - std::min(position, number ? last_token.size() : 1);
    at_end = position > size;
    return false;
  }
};

Result<SyntaxCheck> check_syntax(std::string_view text, const std::string& file) {
  SyntaxCheck check(text.size());
  if (nlohmann::json::sax_parse(text.begin(), text.end(), &check)) return check;
  const Place place = place_of_byte(text, check.at_end ? text.size() : check.offset, file);
  if (check.at_end) {
    return Error{ErrorCode::BadFormat, "not valid JSON: the file ends too early; it may have been cut short", place};
  }
  return Error{ErrorCode::BadFormat,
               fmt::format("not valid JSON at {}; correct the file",
                           shown(text.substr(check.offset, text.find_first_of("\r\n", check.offset) - check.offset))),
               place};
}

/// Where OGR does not know the name of a system, it takes longitudes and latitudes.
bool is_known(const std::string& system) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  OGRSpatialReference named;
  const bool known = system.empty() || named.SetFromUserInput(system.c_str()) == OGRERR_NONE;
  CPLPopErrorHandler();
  return known;
}

/// Metres are what GeoJSON is taken in anyway.
void note_stated_system(OGRLayer& layer, const std::string& name, lines::StatedConvention& stated) {
  stated.system = reference_system(layer.GetSpatialRef());
  if (!is_known(name)) return;
  lines::StatedConvention said;
  note_system(layer.GetSpatialRef(), said);
  if (said.unit && *said.unit != 1.0) stated.unit = said.unit;
  std::move(said.questions.begin(), said.questions.end(), std::back_inserter(stated.questions));
}

/// Without "crs" GeoJSON is in longitudes and latitudes ([rfc7946], 4), or a plane section all the same. It looks like
/// the former where it is small, far from both axes, and a place on the globe.
void ask_for_degrees(lines::Features& read) {
  constexpr double small = 0.05;  // of the distance from an axis
  geom::Box box;
  for (const lines::Feature& feature : read.features) {
    for (const geom::Polyline& part : feature.parts) {
      for (const geom::Point p : part.points) box.add(p);
    }
  }
  const auto fits = [](double low, double high, double most) {
    const double nearest = std::min(std::abs(low), std::abs(high));
    return low * high > 0.0 && high > low && std::max(std::abs(low), std::abs(high)) <= most &&
           high - low < small * nearest;
  };
  if (!fits(box.low.x, box.high.x, 180.0) || !fits(box.low.y, box.high.y, 90.0)) return;
  read.stated.questions.push_back(
      {lines::Question::About::Coordinates,
       fmt::format(
           "the file states no \"crs\", which means degrees, and its coordinates look so (x {:.6g} to {:.6g}, y "
           "{:.6g} to {:.6g}); project the file first, or say that they are section coordinates: coordinates "
           "= section (--coordinates section)",
           box.low.x, box.high.x, box.low.y, box.high.y)});
}

Result<lines::Features> read_features(GDALDataset& data, const GdalMessages& messages, const std::string& file,
                                      lines::Heights heights, lines::Faulty faulty, const SyntaxCheck& syntax) {
  lines::Features result;
  std::size_t number = 0;
  for (OGRLayer* layer : data.GetLayers()) {
    if (syntax.states_system) note_stated_system(*layer, syntax.system_name, result.stated);
    // Words as ids are fields; OGR numbers what has no id.
    const bool numbered = layer->GetLayerDefn()->GetFieldIndex("id") < 0 &&
                          syntax.ids == static_cast<std::size_t>(layer->GetFeatureCount());
    layer->ResetReading();
    while (const OGRFeatureUniquePtr source{layer->GetNextFeature()}) {
      ++number;
      if (messages.failure) break;
      const std::size_t before = result.features.size();
      DOBRA_TRY_VOID(add_ogr_feature(*source, number, file, heights, faulty, result));
      if (numbered && result.features.size() > before) result.features.back().id = source->GetFID();
    }
  }
  if (messages.failure) {
    return Error{ErrorCode::BadFormat, fmt::format("not valid GeoJSON: {}", *messages.failure), Place{.file = file}};
  }
  if (!syntax.has_system) ask_for_degrees(result);
  for (const std::string& warning : messages.warnings) {
    if (warning.find("closed ring") == std::string::npos)  // open_rings tells those, with their names
      result.remarks.push_back(fmt::format("{}: {}", file, warning));
  }
  return result;
}

}  // namespace

Result<lines::Features> parse_geojson(std::string_view text, const std::string& file, lines::Heights heights,
                                      lines::Faulty faulty) {
  DOBRA_TRY_VOID(check_text(text, file));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  DOBRA_TRY(const SyntaxCheck syntax, check_syntax(text, file));
  static std::once_flag registered;
  std::call_once(registered, [] { RegisterOGRGeoJSON(); });
  const GdalMessages messages;
  const GdalMemoryFile memory(text, ".geojson");
  const char* const drivers[] = {"GeoJSON", nullptr};
  const char* const options[] = {"DATE_AS_STRING=YES", nullptr};
  const GDALDatasetUniquePtr data(
      GDALDataset::Open(memory.name(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers, options));
  if (!data) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("not GeoJSON: give a FeatureCollection, a Feature or a geometry{}",
                             messages.failure ? " (" + *messages.failure + ")" : std::string{}),
                 Place{.file = file}};
  }
  return read_features(*data, messages, file, heights, faulty, syntax);
}

Result<lines::Features> read_geojson(const std::string& path, lines::Heights heights) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_geojson(text, path, heights);
}

}  // namespace dobra::io::gis
