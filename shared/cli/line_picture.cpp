#include "shared/cli/line_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "shared/base/text.h"
#include "shared/cli/pictures.h"

namespace dobra::cli {
namespace {

constexpr double points_per_metre = 72.0 / 0.0254;
constexpr double largest_page = 20.0;  ///< m; beyond, PDF readers and printers give up

constexpr double long_section = 10000.0;   ///< m; from here on axes are in kilometres
constexpr std::size_t most_of_a_kind = 3;  ///< faults, or points, with entries of their own in the legend

bool is_bed(const io::lines::Feature& feature) {
  return feature.type == io::lines::FeatureType::Lines && (feature.kind.empty() || feature.kind == "horizon");
}

/// What the features of a file are drawn as: all pieces of a unit, or of a horizon, are one layer.
class LinePicture {
 public:
  explicit LinePicture(const io::formats::LineWork& work) : work_(work), wholes_(work.features.size()) {
    name([](const io::lines::Feature& f) { return f.type == io::lines::FeatureType::Polygons; });
    name(is_bed);
    const auto other = [](const io::lines::Feature& f) {
      return f.type != io::lines::FeatureType::Polygons && !is_bed(f);
    };
    name(other);
    numbers_.resize(work.features.size());
    number([](const io::lines::Feature& f) { return f.type == io::lines::FeatureType::Polygons; });
    number(is_bed);
  }

  [[nodiscard]] scene::Panel panel() const {
    scene::Panel panel;
    panel.key = "section";
    // Areas lie beneath lines, lines beneath points.
    for (const auto type :
         {io::lines::FeatureType::Polygons, io::lines::FeatureType::Lines, io::lines::FeatureType::Points}) {
      for (std::size_t i = 0; i < work_.features.size(); ++i) {
        if (work_.features[i].type == type) add(i, panel);
      }
    }
    const bool in_kilometres = scene::extent(panel).width() >= long_section;
    panel.axes = {base::translated("x [m]"), base::translated("z [m]")};
    if (in_kilometres) panel.axes = {base::translated("x [km]"), base::translated("z [km]")};
    if (in_kilometres) panel.axes.unit = 1000.0;
    add_names(panel);
    return panel;
  }

 private:
  [[nodiscard]] std::string own_name(std::size_t i) const {
    const std::string& name = work_.features[i].name;
    return name.empty() ? fmt::format("{}", i + 1) : name;
  }

  template <class Which>
  void name(const Which& which) {
    std::vector<std::string> names;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < wholes_.size(); ++i) {
      if (!which(work_.features[i])) continue;
      names.push_back(own_name(i));
      places.push_back(i);
    }
    const bool areas = !places.empty() && work_.features[places[0]].type == io::lines::FeatureType::Polygons;
    const std::vector<std::string> wholes = areas ? scene::whole_names(names) : names;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::string said = io::lines::stated_unit(work_.features[places[k]]);
      wholes_[places[k]] = said.empty() ? wholes[k] : said;
    }
  }

  /// Areas by their names, beds from the top down: in the order of the file.
  template <class Which>
  void number(const Which& which) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < wholes_.size(); ++i) {
      if (which(work_.features[i])) names.push_back(wholes_[i]);
    }
    std::vector<std::size_t> numbers = scene::numbers_of(names);
    std::size_t next = 0;
    for (std::size_t i = 0; i < wholes_.size(); ++i) {
      if (which(work_.features[i])) numbers_[i] = numbers[next++];
    }
  }

  [[nodiscard]] scene::Style style_of(std::size_t i) const {
    const io::lines::Feature& feature = work_.features[i];
    scene::Style style;
    style.line = {40, 40, 48, 255};
    style.line_width = 1.2;
    if (is_bed(feature)) style.line = scene::unit_style(numbers_[i]).line;
    if (feature.kind == "fault") style.line = {176, 44, 36, 255};
    if (feature.type == io::lines::FeatureType::Polygons) {
      const scene::UnitStyle unit = scene::unit_style(numbers_[i]);
      style.fill = unit.fill;
      style.pattern = unit.pattern;
      style.line_width = 0.6;
    }
    return style;
  }

  /// To the layer of its unit, or to a new one.
  void add(std::size_t i, scene::Panel& panel) const {
    const io::lines::Feature& feature = work_.features[i];
    const bool area = feature.type == io::lines::FeatureType::Polygons;
    if (area || is_bed(feature)) {
      for (scene::Layer& layer : panel.layers) {
        if (layer.title != wholes_[i] || std::holds_alternative<scene::Regions>(layer.content) != area) continue;
        if (area) add_regions(feature, std::get<scene::Regions>(layer.content));
        if (auto* lines = std::get_if<scene::Lines>(&layer.content); lines != nullptr && layer.legend.empty()) {
          std::vector<geom::Polyline>& all = lines->lines.edit();
          all.insert(all.end(), feature.parts.begin(), feature.parts.end());
        } else if (!area) {
          continue;
        }
        return;
      }
    }
    scene::Layer layer{.key = fmt::format("feature_{}", i + 1),
                       .title = wholes_[i],
                       .style = style_of(i),
                       .content = scene::Lines{feature.parts, {}}};
    if (feature.type == io::lines::FeatureType::Points) layer.content = scene::Markers{feature.parts[0].points, {}};
    if (area) {
      scene::Regions regions;
      add_regions(feature, regions);
      layer.content = std::move(regions);
    } else if (!is_bed(feature)) {
      layer.legend = common_name(feature);
    }
    panel.layers.push_back(std::move(layer));
  }

  /// What many faults, or points, are called together.
  [[nodiscard]] std::string common_name(const io::lines::Feature& feature) const {
    const auto same = [&](const io::lines::Feature& f) { return f.type == feature.type && f.kind == feature.kind; };
    const auto count = static_cast<std::size_t>(std::count_if(work_.features.begin(), work_.features.end(), same));
    if (count <= most_of_a_kind) return {};
    if (feature.type == io::lines::FeatureType::Points) return base::translated("Markers");
    return feature.kind == "fault" ? base::translated("Faults") : feature.kind;
  }

  static void add_regions(const io::lines::Feature& feature, scene::Regions& regions) {
    for (const auto& [first, last] : io::lines::polygons_of(feature)) {
      const auto begin = feature.parts.begin();
      regions.regions.push_back(
          {{begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)}});
    }
  }

  /// Names of beds beside their right ends.
  void add_names(scene::Panel& panel) const {
    for (std::size_t i = panel.layers.size(); i-- > 0;) {
      const auto* lines = std::get_if<scene::Lines>(&panel.layers[i].content);
      if (lines == nullptr || !panel.layers[i].legend.empty()) continue;
      std::optional<geom::Point> right;
      for (const geom::Polyline& line : lines->lines) {
        for (const geom::Point end : {line.points.front(), line.points.back()}) {
          if (!right || end.x > right->x) right = end;
        }
      }
      if (!right) continue;
      scene::Style style;
      style.line = panel.layers[i].style.line;
      style.text_size = 8.0;
      const std::string title = panel.layers[i].title;
      panel.layers.push_back({.key = "name_" + panel.layers[i].key,
                              .title = title,
                              .style = style,
                              .content = scene::Labels{{{*right, title, scene::Anchor::Right}}},
                              .in_legend = scene::InLegend::No});
    }
  }

  const io::formats::LineWork& work_;
  std::vector<std::string> wholes_;
  std::vector<std::size_t> numbers_;
};

}  // namespace

std::vector<std::string> drawn_names(const io::formats::LineWork& work) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < work.features.size(); ++i) {
    const io::lines::Feature& feature = work.features[i];
    const std::string said = io::lines::stated_unit(feature);
    names.push_back(!said.empty() ? said : feature.name.empty() ? fmt::format("{}", i + 1) : feature.name);
  }
  return names;
}

scene::Picture line_picture(const io::formats::LineWork& work) {
  scene::Picture picture;
  picture.paper = scene::Paper::A4Landscape;
  picture.panels.push_back(LinePicture(work).panel());
  if (work.trace) {
    std::tie(picture.panels[0].left_end, picture.panels[0].right_end) =
        io::lines::ends_of(io::lines::azimuth_of(*work.trace));
  }
  return picture;
}

base::Result<void> draw_lines(const io::formats::LineWork& work, const std::filesystem::path& file,
                              const LineDrawing& drawing) {
  scene::Picture picture = line_picture(work);
  picture.title = drawing.title;
  if (drawing.ends) std::tie(picture.panels[0].left_end, picture.panels[0].right_end) = *drawing.ends;
  if (drawing.colors) scene::paint(picture, *drawing.colors);
  const std::optional<double>& scale = drawing.scale;
  if (scale) {
    const geom::Box box = scene::extent(picture.panels[0]);
    const double metres = std::max(box.width(), box.height()) / *scale;
    if (metres > largest_page) {
      return base::Error{base::ErrorCode::CannotDraw,
                         fmt::format("at 1:{:g} the page would be {:.3g} m wide; give --scale 1:{:.0f} or smaller",
                                     *scale, metres, std::ceil(*scale * metres / largest_page))};
    }
    picture.points_per_unit = points_per_metre / *scale;
    picture.paper = scene::Paper::ToContent;  // a true scale has the page that it needs
    picture.title += fmt::format("{}1:{:g}", picture.title.empty() ? "" : "   ", *scale);
  }
  return draw(picture, file, Drawer::Cairo);
}

}  // namespace dobra::cli
