// libFuzzer target: every reader of lines. Byte 0 chooses the format, byte 1 the options and repairs, the rest is the
// file (a Shapefile: a byte that says how many of the rest are .shx, in 255ths, then .shx and .shp). Whatever the
// bytes: an error of one line, or finite features; and what is written of them in a format of our own reads back to the
// same text.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shared/io/formats/line_files.h"

namespace {

using dobra::io::formats::Format;
using dobra::io::formats::LineOptions;
using dobra::io::formats::LineWork;
using dobra::io::formats::Use;

/// In memory where the system has such a place.
std::string file_of(const std::string& ending) {
  static const std::string folder =
      std::filesystem::exists("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path().string();
  return folder + "/dobra_lines_fuzz_" + std::to_string(::getpid()) + ending;
}

void write_all(const std::string& path, std::string_view bytes) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return;
  std::fwrite(bytes.data(), 1, bytes.size(), file);
  std::fclose(file);
}

LineOptions options_of(std::uint8_t bits) {
  LineOptions options;
  if ((bits & 1U) != 0) options.y_direction = dobra::io::lines::YDirection::Down;
  if ((bits & 2U) != 0) options.text.columns = {"1", "2", "3"};
  if ((bits & 4U) != 0) options.coordinates = dobra::io::formats::Coordinates::Section;
  if ((bits & 8U) != 0) options.plane_tolerance = 1e9;
  if ((bits & 16U) != 0) options.unit = 0.3048;
  if ((bits & 32U) != 0) options.repair.order = dobra::io::formats::PointOrder::AlongTheCurve;
  if ((bits & 64U) != 0) options.repair.gaps = options.repair.snap = 1.0;
  if ((bits & 128U) != 0) options.repair.duplicates = options.repair.slivers = 0.5;
  return options;
}

dobra::base::Result<LineWork> read(const Format& format, std::string_view bytes, const LineOptions& options) {
  if (format.name == "geopackage") {
    const std::string path = file_of(".gpkg");
    write_all(path, bytes);
    auto made = dobra::io::formats::read_any_lines(path, options);
    std::filesystem::remove(path);
    return made;
  }
  if (format.name == "shapefile") {
    const std::size_t index = bytes.empty() ? 0 : (bytes.size() - 1) * static_cast<unsigned char>(bytes[0]) / 255;
    write_all(file_of(".shx"), bytes.substr(bytes.empty() ? 0 : 1, index));
    write_all(file_of(".shp"), bytes.substr(bytes.empty() ? 0 : 1 + index));
    auto made = dobra::io::formats::read_any_lines(file_of(".shp"), options);
    std::filesystem::remove(file_of(".shp"));
    std::filesystem::remove(file_of(".shx"));
    return made;
  }
  LineOptions chosen = options;
  chosen.format = &format;
  return dobra::io::formats::parse_any_lines(bytes, "f", chosen);
}

void check_finite(const LineWork& work) {
  if (work.features.empty()) std::abort();
  for (const auto& feature : work.features) {
    if (!feature.heights.empty()) std::abort();
    for (const auto& part : feature.parts) {
      for (const auto p : part.points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) std::abort();
      }
    }
  }
}

/// `work` as text of the format; on the plane y = 0, where the same bits come back.
std::string text_of(LineWork work, const Format& format) {
  std::vector<std::string> remarks;
  work.trace.reset();
  auto text = dobra::io::formats::lines_text(work, {.format = &format}, remarks);
  if (!text.ok()) std::abort();
  return *std::move(text);
}

/// All points over one place of the map have no plane.
bool over_one_place(const LineWork& work) {
  dobra::geom::Box box;
  for (const auto& feature : work.features) {
    for (const auto& part : feature.parts) box.add(part.box());
  }
  return !(box.width() > 0.0);
}

/// Lines that come back to their first point are polygons in MOVE files.
bool has_rings(const LineWork& work) {
  for (const auto& feature : work.features) {
    for (const auto& part : feature.parts) {
      if (!part.closed && part.points.size() > 2 && part.points.front() == part.points.back()) return true;
    }
  }
  return false;
}

/// What is written reads back as what gives the same text. What MOVE and GOCAD cannot hold is changed on writing,
/// aloud. A property of GeoJSON takes one type for all features when it is read, so there the second text is compared.
void check_round_trip(const LineWork& work, const Format& format) {
  const bool json = format.name == "geojson";
  if (over_one_place(work) && !json) return;
  LineOptions options;
  options.format = &format;
  options.coordinates = json ? dobra::io::formats::Coordinates::Section : dobra::io::formats::Coordinates::Map;
  std::string text = text_of(work, format);
  auto again = dobra::io::formats::parse_any_lines(text, "f", options);
  const bool changed = json || (format.name == "move" && has_rings(work));
  if (changed && !json && !again.ok()) return;  // a polygon without area
  if (changed && again.ok()) {
    text = text_of(*again, format);
    again = dobra::io::formats::parse_any_lines(text, "f", options);
  }
  if (again.ok() && text_of(*again, format) == text) return;
  std::fprintf(stderr, "--- text\n%s--- again\n%s\n", text.c_str(),
               again.ok() ? text_of(*again, format).c_str() : again.error().message.c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  std::vector<const Format*> of_lines;
  for (const Format& format : dobra::io::formats::all_formats()) {
    if (is_for(format, Use::ReadLines)) of_lines.push_back(&format);
  }
  const Format& format = *of_lines[data[0] % of_lines.size()];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 2, size - 2);
  const auto work = read(format, bytes, options_of(data[1]));
  if (!work.ok()) {
    const std::string& message = work.error().message;
    if (message.empty() || message.find('\n') != std::string::npos) std::abort();
    return 0;
  }
  check_finite(*work);
  for (const char* const own : {"move", "gocad", "geojson"})
    check_round_trip(*work, *dobra::io::formats::format_named(own, Use::WriteLines));
  return 0;
}
