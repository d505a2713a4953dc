#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/formats/line_files.h"
#include "shared/io/lines/section_plane.h"
#include "shared/io/scan.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

// --- what a format cannot hold

/// The layer of a drawing that the name of its line begins with.
bool layer_is_in_name(const lines::Feature& feature, const lines::PropertyValue& value) {
  const auto* layer = std::get_if<std::string>(&value);
  return layer != nullptr && feature.name.starts_with(*layer);
}

/// Features whose names or kinds are lost: "'A' (horizon)".
std::vector<std::string> unnamed_in(const LineRow& row, std::span<const lines::Feature> features) {
  std::vector<std::string> lost;
  for (const lines::Feature& feature : features) {
    const bool kind_kept = row.kind == nullptr || row.kind(feature) == feature.kind;
    const std::string kind = feature.kind.empty() || kind_kept ? "" : fmt::format("({})", feature.kind);
    const bool name_lost = !row.keeps_names && !feature.name.empty();
    if (!name_lost && kind.empty()) continue;
    const std::string name = feature.name.empty() ? "one without a name" : shown(feature.name);
    lost.push_back(kind.empty() ? name : name + ' ' + kind);
  }
  return lost;
}

/// Up to ten of them, and how many there are in all.
std::string up_to_ten(const std::vector<std::string>& all) {
  constexpr std::size_t most = 10;
  if (all.size() <= most) return fmt::format("{}", fmt::join(all, ", "));
  return fmt::format("{}, ... ({} in all)", fmt::join(all.begin(), all.begin() + most, ", "), all.size());
}

/// Names and kinds.
void remark_names(std::span<const lines::Feature> features, const Format& format, std::vector<std::string>& remarks) {
  const LineRow& row = *format.lines;
  if (const auto lost = unnamed_in(row, features); !lost.empty()) {
    remarks.push_back(row.keeps_names
                          ? fmt::format("kinds are not kept in {}: {}; on reading, --kind 'NAME*=KIND' "
                                        "gives them",
                                        format.name, up_to_ten(lost))
                          : fmt::format("names and kinds are not kept in {}: {}", format.name, up_to_ten(lost)));
  }
  std::vector<std::string> renamed;
  for (const lines::Feature& feature : features) {
    if (row.name == nullptr) break;
    if (std::string name = row.name(feature); name != feature.name)
      renamed.push_back(fmt::format("{} becomes {}", shown(feature.name), shown(name)));
  }
  if (renamed.empty()) return;
  remarks.push_back(fmt::format("{} names hold what {} cannot, {}: {}", renamed.size(), format.name, row.not_in_names,
                                up_to_ten(renamed)));
}

void remark_losses(std::span<const lines::Feature> features, const Format& format, std::vector<std::string>& remarks) {
  const LineRow& row = *format.lines;
  std::size_t properties = 0;
  std::size_t holes = 0;
  std::size_t points = 0;
  for (const lines::Feature& feature : features) {
    for (const auto& [key, value] : feature.properties) {
      const bool own = std::find(row.own_properties.begin(), row.own_properties.end(), key) != row.own_properties.end();
      properties += own || (key == "layer" && layer_is_in_name(feature, value)) ? 0 : 1;
    }
    for (const geom::Polyline& part : feature.parts) holes += part.closed && geom::signed_area(part) < 0.0 ? 1 : 0;
    points += feature.type == lines::FeatureType::Points ? 1 : 0;
  }
  remark_names(features, format, remarks);
  if (!row.keeps_properties && properties > 0)
    remarks.push_back(fmt::format("{} properties are not kept in {}", properties, format.name));
  if (!row.keeps_holes && holes > 0)
    remarks.push_back(fmt::format("{} holes become closed lines in {}", holes, format.name));
  if (!row.keeps_points && points > 0)
    remarks.push_back(fmt::format("{} features of points cannot be read back from {}", points, format.name));
}

// The features as they are written.
Result<std::vector<lines::Feature>> prepared(const LineWork& work, const Format& format,
                                             const LineWriteOptions& options) {
  const LineRow& row = *format.lines;
  const bool map = options.coordinates == Coordinates::Map ||
                   (options.coordinates == Coordinates::Detect && row.written_as == WrittenAs::MapOnly);
  if (options.coordinates == Coordinates::Section && row.written_as == WrittenAs::MapOnly) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} files have three coordinates; leave out --to-coordinates", format.title)};
  }
  if (map && row.written_as == WrittenAs::SectionOnly) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} is written with section coordinates only; choose another format", format.title)};
  }
  return map ? lines::out_of_plane(work.features, work.trace.value_or(lines::Trace{})) : work.features;
}

}  // namespace

Result<std::string> lines_text(const LineWork& work, const LineWriteOptions& options,
                               std::vector<std::string>& remarks) {
  const Format* format = options.format != nullptr ? options.format : work.format;
  if (format == nullptr) format = format_named("text", Use::WriteLines);
  if (format->lines->text == nullptr) return Error{ErrorCode::InvalidOption, "this format is not text"};
  DOBRA_TRY(const std::vector<lines::Feature> features, prepared(work, *format, options));
  remark_losses(work.features, *format, remarks);
  return format->lines->text(features, options);
}

Result<void> write_any_lines(const std::string& path, const LineWork& work, const LineWriteOptions& options,
                             std::vector<std::string>& remarks) {
  LineWriteOptions chosen = options;
  if (chosen.format == nullptr) {
    DOBRA_TRY(chosen.format, line_format_of(path));
  }
  const LineRow& row = *chosen.format->lines;
  if (row.write == nullptr) {
    auto text = lines_text(work, chosen, remarks);
    if (!text) return base::located(text.error(), Place{.file = path});
    return write_file(path, *text);
  }
  DOBRA_TRY(const std::vector<lines::Feature> features, prepared(work, *chosen.format, chosen));
  DOBRA_TRY(const std::vector<std::string> told, row.write(path, features, chosen));
  remarks.insert(remarks.end(), told.begin(), told.end());
  return {};
}

}  // namespace dobra::io::formats
