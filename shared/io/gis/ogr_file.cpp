#include "shared/io/gis/ogr_file.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <vector>

#include "shared/io/gis/gdal.h"
#include "shared/io/gis/ogr_features.h"
#include "shared/io/scan.h"

namespace dobra::io::gis {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

constexpr std::array<lines::FeatureType, 3> all_types{lines::FeatureType::Lines, lines::FeatureType::Polygons,
                                                      lines::FeatureType::Points};

void register_vector_drivers() {
  static std::once_flag registered;
  std::call_once(registered, [] {
    RegisterOGRShape();
    RegisterOGRGeoPackage();
  });
}

bool is_empty(const lines::Feature& feature) { return feature.parts.empty() || feature.parts[0].points.empty(); }

bool has_heights(std::span<const lines::Feature> features) {
  return std::any_of(features.begin(), features.end(), [](const lines::Feature& f) { return !f.heights.empty(); });
}

const char* layer_name(lines::FeatureType type) {
  return type == lines::FeatureType::Lines ? "lines" : type == lines::FeatureType::Polygons ? "polygons" : "points";
}

// A layer's geometry type. A Shapefile has no Multi forms: one record takes any number of parts.
OGRwkbGeometryType ogr_type(lines::FeatureType type, bool shapefile, bool three_dimensional) {
  OGRwkbGeometryType made = wkbMultiPoint;
  if (type == lines::FeatureType::Lines) made = shapefile ? wkbLineString : wkbMultiLineString;
  if (type == lines::FeatureType::Polygons) made = shapefile ? wkbPolygon : wkbMultiPolygon;
  return three_dimensional ? wkbSetZ(made) : made;
}

template <class Curve>
Curve curve_of(const lines::Feature& feature, std::size_t part) {
  Curve curve;
  const geom::Polyline& line = feature.parts[part];
  const std::size_t count = line.points.size() + (line.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = i == line.points.size() ? 0 : i;
    if (feature.heights.empty())
      curve.addPoint(line.points[k].x, line.points[k].y);
    else
      curve.addPoint(line.points[k].x, line.points[k].y, feature.heights[part][k]);
  }
  return curve;
}

std::unique_ptr<OGRGeometry> geometry_of(const lines::Feature& feature) {
  if (feature.type == lines::FeatureType::Points) {
    auto points = std::make_unique<OGRMultiPoint>();
    const OGRLineString all = curve_of<OGRLineString>(feature, 0);
    for (int i = 0; i < all.getNumPoints(); ++i) {
      OGRPoint point;
      all.getPoint(i, &point);
      points->addGeometry(&point);
    }
    return points;
  }
  if (feature.type == lines::FeatureType::Lines) {
    auto lines = std::make_unique<OGRMultiLineString>();
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
      const OGRLineString line = curve_of<OGRLineString>(feature, i);
      lines->addGeometry(&line);
    }
    return lines;
  }
  auto polygons = std::make_unique<OGRMultiPolygon>();
  for (const auto& [first, last] : lines::polygons_of(feature)) {
    OGRPolygon polygon;
    for (std::size_t i = first; i < last; ++i) {
      OGRLinearRing ring = curve_of<OGRLinearRing>(feature, i);
      polygon.addRing(&ring);
    }
    polygons->addGeometry(&polygon);
  }
  return polygons;
}

OGRFieldType field_type(const lines::PropertyValue& value) {
  if (std::holds_alternative<double>(value)) return OFTReal;
  if (std::holds_alternative<std::string>(value)) return OFTString;
  return OFTInteger64;  // whole numbers, true and false
}

struct FieldPlan {
  std::string key;
  OGRFieldType type;
};

// Every property of the features, in order of appearance; text where they disagree about the type.
std::vector<FieldPlan> fields_of(std::span<const lines::Feature> features, lines::FeatureType type) {
  std::vector<FieldPlan> plan{{"name", OFTString}, {"kind", OFTString}};
  for (const lines::Feature& feature : features) {
    if (feature.type != type) continue;
    for (const auto& [key, value] : feature.properties) {
      const auto known = std::find_if(plan.begin(), plan.end(), [&k = key](const FieldPlan& f) { return f.key == k; });
      if (known == plan.end())
        plan.push_back({key, field_type(value)});
      else if (known->type != field_type(value))
        known->type = OFTString;
    }
  }
  return plan;
}

std::string text_of(const lines::PropertyValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  return std::get<bool>(value) ? "true" : "false";
}

void set_field(OGRFeature& made, int field, const lines::PropertyValue& value) {
  const OGRFieldType type = made.GetFieldDefnRef(field)->GetType();
  if (type == OFTReal)
    made.SetField(field, std::get<double>(value));
  else if (type == OFTString)
    made.SetField(field, text_of(value).c_str());
  else if (const auto* integer = std::get_if<std::int64_t>(&value))
    made.SetField(field, static_cast<GIntBig>(*integer));
  else
    made.SetField(field, std::get<bool>(value) ? 1 : 0);
}

void write_layer(GDALDataset& data, const std::string& name, std::span<const lines::Feature> features,
                 lines::FeatureType type, bool shapefile, const lines::ReferenceSystem* stated,
                 std::vector<std::string>& remarks) {
  // A GeoPackage layer without a system would be taken for one in degrees.
  OGRSpatialReference system;
  const bool known = stated != nullptr && system.importFromWkt(stated->wkt.c_str()) == OGRERR_NONE;
  if (!known) system.SetLocalCS("Undefined Cartesian SRS");
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer* layer = data.CreateLayer(name.c_str(), shapefile && !known ? nullptr : &system,
                                     ogr_type(type, shapefile, has_heights(features)));
  if (layer == nullptr) return;  // the reason is in the messages
  const std::vector<FieldPlan> plan = fields_of(features, type);
  for (const FieldPlan& field : plan) {
    OGRFieldDefn definition(field.key.c_str(), field.type);
    if (field.type == OFTReal && shapefile) definition.SetWidth(24), definition.SetPrecision(15);
    if (layer->CreateField(&definition) != OGRERR_NONE) return;
    const OGRFeatureDefn& made = *layer->GetLayerDefn();
    const std::string written = made.GetFieldDefn(made.GetFieldCount() - 1)->GetNameRef();
    if (written != field.key) remarks.push_back(fmt::format("field {} is called {}", shown(field.key), shown(written)));
  }
  for (const lines::Feature& feature : features) {
    if (feature.type != type || is_empty(feature)) continue;
    const OGRFeatureUniquePtr made(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    if (!feature.name.empty()) made->SetField(0, feature.name.c_str());
    if (!feature.kind.empty()) made->SetField(1, feature.kind.c_str());
    for (const auto& [key, value] : feature.properties) {
      const auto field = std::find_if(plan.begin(), plan.end(), [&k = key](const FieldPlan& f) { return f.key == k; });
      set_field(*made, static_cast<int>(field - plan.begin()), value);
    }
    made->SetGeometry(geometry_of(feature).get());
    if (layer->CreateFeature(made.get()) != OGRERR_NONE) return;
  }
}

Result<void> check_features(std::span<const lines::Feature> features) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    for (const geom::Polyline& part : features[i].parts) {
      DOBRA_TRY_VOID(check_finite(part.points, lines::item_of(i + 1, features[i])));
    }
  }
  return {};
}

// A folder beside the target that goes away with the object.
class Aside {
 public:
  explicit Aside(const std::filesystem::path& target)
      : folder_(target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), ::getpid())) {
    std::error_code ignored;
    std::filesystem::create_directory(folder_, ignored);
  }
  ~Aside() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

Result<std::vector<std::string>> write_with(const char* driver_name, const std::string& path,
                                            std::span<const lines::Feature> features,
                                            const std::vector<lines::FeatureType>& types,
                                            const lines::ReferenceSystem* system) {
  DOBRA_TRY_VOID(check_features(features));
  register_vector_drivers();
  const std::filesystem::path target(path);
  const Aside aside(target);
  const GdalMessages messages;
  const auto failed = [&](const std::string& why) {
    return Error{ErrorCode::CannotWrite, "cannot be written: " + why, Place{.file = path}};
  };
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  const std::string file = (aside.folder() / target.filename()).string();
  std::vector<std::string> remarks;
  {
    const GDALDatasetUniquePtr data(driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!data) return failed(messages.failure.value_or("no reason was given"));
    const bool shapefile = std::string_view(driver_name) == "ESRI Shapefile";
    for (const lines::FeatureType type : types) {
      write_layer(*data, shapefile ? target.stem().string() : layer_name(type), features, type, shapefile, system,
                  remarks);
    }
  }  // closed here: only then is everything written
  if (messages.failure) return failed(*messages.failure);
  for (const auto& entry : std::filesystem::directory_iterator(aside.folder())) {
    std::error_code problem;
    std::filesystem::rename(entry.path(), target.parent_path() / entry.path().filename(), problem);
    if (problem) return failed(problem.message());
  }
  return remarks;
}

std::vector<lines::FeatureType> types_in(std::span<const lines::Feature> features) {
  std::vector<lines::FeatureType> types;
  for (const lines::FeatureType type : all_types) {
    const auto is = [type](const lines::Feature& f) { return f.type == type && !is_empty(f); };
    if (std::any_of(features.begin(), features.end(), is)) types.push_back(type);
  }
  return types;
}

}  // namespace

Result<lines::Features> read_ogr_file(const std::string& path, lines::Faulty faulty) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return Error{ErrorCode::FileNotFound, "there is no such file", Place{.file = path}};
  }
  register_vector_drivers();
  const GdalMessages messages;
  const auto not_read = [&] {
    return Error{ErrorCode::BadFormat,
                 fmt::format("the file cannot be read{}", messages.failure ? ": " + *messages.failure : std::string{}),
                 Place{.file = path}};
  };
  const char* const drivers[] = {"ESRI Shapefile", "GPKG", nullptr};
  const GDALDatasetUniquePtr data(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers));
  if (!data || messages.failure) return not_read();
  lines::Features result;
  std::size_t number = 0;
  std::vector<std::optional<lines::ReferenceSystem>> systems;
  const bool numbered = EQUAL(data->GetDriverName(), "GPKG");  // the records of a Shapefile have places, no numbers
  for (OGRLayer* layer : data->GetLayers()) {
    note_system(layer->GetSpatialRef(), result.stated);
    systems.push_back(reference_system(layer->GetSpatialRef()));
    layer->ResetReading();
    while (const OGRFeatureUniquePtr source{layer->GetNextFeature()}) {
      if (messages.failure) break;
      const std::size_t before = result.features.size();
      DOBRA_TRY_VOID(add_ogr_feature(*source, ++number, path, lines::Heights::Keep, faulty, result));
      if (numbered && result.features.size() > before) result.features.back().id = source->GetFID();
    }
  }
  if (!systems.empty() && std::all_of(systems.begin(), systems.end(), [&](const auto& s) { return s == systems[0]; }))
    result.stated.system = systems[0];
  if (messages.failure) return not_read();
  for (const std::string& warning : messages.warnings) result.remarks.push_back(fmt::format("{}: {}", path, warning));
  return result;
}

Result<std::vector<std::string>> write_shapefile(const std::string& path, std::span<const lines::Feature> features,
                                                 const lines::ReferenceSystem* system) {
  const std::vector<lines::FeatureType> types = types_in(features);
  if (types.size() > 1) {
    return Error{ErrorCode::InvalidOption,
                 "a Shapefile holds either lines, or polygons, or points, and there is more than one of these; write "
                 "them one by one (--only lines), or a GeoPackage",
                 Place{.file = path}};
  }
  return write_with("ESRI Shapefile", path, features, types.empty() ? std::vector{lines::FeatureType::Polygons} : types,
                    system);
}

Result<std::vector<std::string>> write_geopackage(const std::string& path, std::span<const lines::Feature> features,
                                                  const lines::ReferenceSystem* system) {
  const std::vector<lines::FeatureType> types = types_in(features);
  return write_with("GPKG", path, features, types.empty() ? std::vector{lines::FeatureType::Polygons} : types, system);
}

}  // namespace dobra::io::gis
