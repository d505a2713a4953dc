// Objects one after another; of a TSurf the header gives the name, the coordinate system what z and the unit mean, then
// vertices and triangles of all its parts.
#include "shared/io/meshes/tsurf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_map>

#include "shared/base/text.h"
#include "shared/io/axis_units.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

std::string small(std::string_view text) {
  std::string made(text);
  for (char& c : made) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return made;
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\"") - first + 1));
}

class TSurfReader {
 public:
  TSurfReader(std::string_view text, const std::string& file) : records_(text, file) {}

  /// What run() took to metres.
  [[nodiscard]] const std::vector<Remark>& remarks() const { return remarks_; }

  Result<std::vector<TSurf>> run() {
    while (records_.next()) {
      const std::string key = small(records_.word(0));
      if (key == "gocad") {
        const std::string type = records_.size() > 1 ? small(records_.word(1)) : "";
        begin(type == "tsurf");
      } else if (key == "end") {
        finish();
      } else if (inside_) {
        DOBRA_TRY_VOID(line(key));
      }
    }
    if (inside_) return error_at_end("the file ends before END; it may have been cut short");
    if (found_.empty()) return error_at_end("there is no triangle surface in the file ('GOCAD TSurf 1')");
    return std::move(found_);
  }

 private:
  [[nodiscard]] Error error_at_end(std::string message) const {
    return {ErrorCode::BadFormat, std::move(message),
            base::Place{.file = records_.file(), .line = records_.line_number()}};
  }
  void begin(bool surface) {
    inside_ = surface;
    current_ = {};
    numbers_.clear();
    units_ = {1.0, 1.0, 1.0};
    depth_ = in_header_ = false;
  }
  void finish() {
    if (!inside_) return;
    for (geom::Point3& p : current_.mesh.points) {
      p = {p.x * units_[0], p.y * units_[1], p.z * units_[2] * (depth_ ? -1.0 : 1.0)};
    }
    // Depths make a left-handed system of a right-handed one.
    if (depth_) {
      for (auto& face : current_.mesh.faces) std::reverse(face.begin(), face.end());
    }
    found_.push_back(std::move(current_));
    inside_ = false;
  }

  Result<void> line(const std::string& key) {
    if (in_header_ || key == "header" || key.starts_with("header{")) {
      header(records_.line());
    } else if (key == "vrtx" || key == "pvrtx") {
      DOBRA_TRY(const double x, records_.number(2, "x"));
      DOBRA_TRY(const double y, records_.number(3, "y"));
      DOBRA_TRY(const double z, records_.number(4, "z"));
      return vertex({x, y, z});
    } else if (key == "atom" || key == "patom") {
      DOBRA_TRY(const std::uint32_t same, corner(2));
      const geom::Point3 at = current_.mesh.points[same];
      return vertex(at);
    } else if (key == "trgl") {
      std::vector<std::uint32_t> face;
      for (std::size_t k = 1; k <= 3; ++k) {
        DOBRA_TRY(const std::uint32_t c, corner(k));
        face.push_back(c);
      }
      current_.mesh.faces.push_back(std::move(face));
    } else if (key == "geological_type" && records_.size() > 1) {
      current_.kind = small(records_.word(1));
      if (current_.kind == "top") current_.kind = "horizon";
    } else if (key == "zpositive" && records_.size() > 1) {
      const std::string_view up = records_.word(1);
      if (small(up) != "elevation" && small(up) != "depth")
        return records_.error(1, fmt::format("ZPOSITIVE {} is neither Elevation nor Depth", shown(up)));
      depth_ = small(up) == "depth";
    } else if (key == "axis_unit") {
      return axis_unit();
    }
    return {};
  }

  /// No unit at all, as in three pairs of quotes, states none.
  Result<void> axis_unit() {
    const AxisUnits units = axis_units(records_.line().substr(records_.line().find_first_not_of(" \t") + key_length));
    if (!units.unknown.empty()) {
      return records_.error(
          1, fmt::format("AXIS_UNIT {} is not m, km or ft; write the surface in one of them", shown(units.unknown)));
    }
    if (units.metres.empty()) return {};
    if (units.metres.size() != units_.size()) return records_.error(1, "AXIS_UNIT needs a unit each of x, y and z");
    std::copy(units.metres.begin(), units.metres.end(), units_.begin());
    if (units_ == std::array{1.0, 1.0, 1.0}) return {};
    remarks_.push_back({fmt::format("x, y and z of this surface are in {}, {} and {}: they are taken to m",
                                    name_of_unit(units_[0]), name_of_unit(units_[1]), name_of_unit(units_[2])),
                        {.file = records_.file(), .line = records_.line_number()}});
    return {};
  }
  static constexpr std::size_t key_length = std::string_view("AXIS_UNIT").size();

  /// "HEADER {name:top}" in one line or in several.
  void header(std::string_view text) {
    in_header_ = text.find('}') == std::string_view::npos;
    const auto open = text.find('{');
    if (open != std::string_view::npos) text = text.substr(open + 1);
    text = text.substr(0, text.find('}'));
    std::string key = trimmed(text);
    if (key.starts_with('*')) key = key.substr(1);
    const auto mark = key.find_first_of(":=");
    if (mark != std::string::npos && small(trimmed(key.substr(0, mark))) == "name")
      current_.name = trimmed(key.substr(mark + 1));
  }

  Result<void> vertex(geom::Point3 p) {
    DOBRA_TRY(const std::int64_t number, records_.integer(1, "the number of the vertex"));
    if (current_.mesh.points.size() >= most_items) return records_.error(1, "too many vertices");
    numbers_[number] = static_cast<std::uint32_t>(current_.mesh.points.size());
    current_.mesh.points.push_back(p);
    return {};
  }
  Result<std::uint32_t> corner(std::size_t word) {
    DOBRA_TRY(const std::int64_t number, records_.integer(word, "the number of a vertex"));
    const auto found = numbers_.find(number);
    if (found == numbers_.end()) return records_.error(word, fmt::format("there is no vertex {}", number));
    return found->second;
  }

  Records records_;
  std::vector<TSurf> found_;
  std::vector<Remark> remarks_;
  TSurf current_;
  std::unordered_map<std::int64_t, std::uint32_t> numbers_;
  bool inside_ = false, in_header_ = false, depth_ = false;
  std::array<double, 3> units_{1.0, 1.0, 1.0};  ///< Of the axes, in metres.
};

/// As a header can hold it and as it is read again.
std::string name_text(const std::string& name) {
  std::string made = name;
  for (char& c : made) {
    if (c == '{' || c == '}' || c == '#' || static_cast<unsigned char>(c) < 0x20U) c = '_';
  }
  return trimmed(made);
}

}  // namespace

Result<std::vector<TSurf>> parse_tsurfs(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return TSurfReader(text, file).run();
}

std::vector<Remark> tsurf_remarks(std::string_view text, const std::string& file) {
  TSurfReader reader(text, file);
  static_cast<void>(reader.run());
  return reader.remarks();
}

Result<mesh::PolygonMesh> parse_tsurf(std::string_view text, const std::string& file) {
  DOBRA_TRY(const std::vector<TSurf> surfaces, parse_tsurfs(text, file));
  mesh::PolygonMesh all;
  for (const TSurf& surface : surfaces) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), surface.mesh.points.begin(), surface.mesh.points.end());
    for (auto face : surface.mesh.faces) {
      for (std::uint32_t& c : face) c += first;
      all.faces.push_back(std::move(face));
    }
  }
  return all;
}

std::string tsurfs_text(std::span<const TSurf> surfaces) {
  std::string text;
  for (const TSurf& surface : surfaces) {
    text += fmt::format("GOCAD TSurf 1\nHEADER {{\nname:{}\n}}\n", name_text(surface.name));
    text +=
        "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT \"m\" \"m\" \"m\"\n"
        "ZPOSITIVE Elevation\nEND_ORIGINAL_COORDINATE_SYSTEM\n";
    if (!surface.kind.empty())
      text += fmt::format("GEOLOGICAL_TYPE {}\n", surface.kind == "horizon" ? "top" : surface.kind);
    text += "TFACE\n";
    for (std::size_t i = 0; i < surface.mesh.points.size(); ++i) {
      const geom::Point3 p = surface.mesh.points[i];
      text += fmt::format("VRTX {} {} {} {}\n", i + 1, base::number_text(p.x), base::number_text(p.y),
                          base::number_text(p.z));
    }
    for (const auto& face : surface.mesh.faces) {
      for (std::size_t k = 2; k < face.size(); ++k)
        text += fmt::format("TRGL {} {} {}\n", face[0] + 1, face[k - 1] + 1, face[k] + 1);
    }
    text += "END\n";
  }
  return text;
}

}  // namespace dobra::io::meshes
