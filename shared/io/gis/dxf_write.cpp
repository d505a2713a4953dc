#include <fmt/format.h>

#include <algorithm>

#include "shared/base/text.h"
#include "shared/io/gis/dxf.h"
#include "shared/io/scan.h"

namespace dobra::io::gis {

using base::Result;

namespace {

std::string layer_property(const lines::Feature& feature) {
  for (const auto& [key, value] : feature.properties) {
    if (const auto* text = std::get_if<std::string>(&value); key == "layer" && text != nullptr) return *text;
  }
  return {};
}

}  // namespace

std::string dxf_layer(const lines::Feature& feature) {
  // A reader numbers further lines of a layer ("TOP 2") and keeps the layer as a property.
  const std::string read = layer_property(feature);
  const bool numbered = !read.empty() && feature.name.starts_with(read + ' ') &&
                        feature.name.find_first_not_of("0123456789", read.size() + 1) == std::string::npos &&
                        feature.name.size() > read.size() + 1;
  std::string layer = numbered ? read : feature.name;
  for (char& c : layer) {
    if (static_cast<unsigned char>(c) < 0x20U ||
        std::string_view("<>/\\\":;?*|=,`").find(c) != std::string_view::npos) {
      c = '_';
    }
  }
  layer.erase(0, layer.find_first_not_of(' '));
  layer.erase(layer.find_last_not_of(' ') + 1);
  return layer.empty() ? "0" : layer;
}

namespace {

void append_coordinates(std::string& text, geom::Point point, double height) {
  for (const auto& [code, value] : {std::pair{10, point.x}, std::pair{20, point.y}, std::pair{30, height}}) {
    text += fmt::format("{}\n", code);
    base::append_number(text, value);
    text += '\n';
  }
}

void append_part(std::string& text, const lines::Feature& feature, std::size_t part, const std::string& layer) {
  const geom::Polyline& line = feature.parts[part];
  const bool flat = feature.heights.empty();
  const auto height = [&](std::size_t i) { return flat ? 0.0 : feature.heights[part][i]; };
  if (feature.type == lines::FeatureType::Points) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      text += fmt::format("0\nPOINT\n8\n{}\n", layer);
      append_coordinates(text, line.points[i], height(i));
    }
    return;
  }
  // OGR takes a 3D polyline as closed where its ends stand over one place, and then leaves out the flag's last side: in
  // space the first point is repeated instead.
  text += fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n70\n{}\n", layer, flat ? (line.closed ? 1 : 0) : 8);
  append_coordinates(text, {}, 0.0);
  for (std::size_t k = 0; k < line.points.size() + (line.closed && !flat ? 1 : 0); ++k) {
    const std::size_t i = k == line.points.size() ? 0 : k;
    text += fmt::format("0\nVERTEX\n8\n{}\n", layer);
    append_coordinates(text, line.points[i], height(i));
    if (!flat) text += "70\n32\n";
  }
  text += fmt::format("0\nSEQEND\n8\n{}\n", layer);
}

std::string tables(std::span<const lines::Feature> features) {
  std::vector<std::string> layers{"0"};
  for (const lines::Feature& feature : features) {
    const std::string layer = dxf_layer(feature);
    if (std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
  }
  std::string text = fmt::format(
      "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n0\nLTYPE\n2\nCONTINUOUS\n70\n64\n3\nSolid "
      "line\n72\n65\n73\n0\n"
      "40\n0\n0\nENDTAB\n0\nTABLE\n2\nLAYER\n70\n{}\n",
      layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    text += fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", layers[i], i == 0 ? 7 : 1 + (i - 1) % 6);
  }
  return text + "0\nENDTAB\n0\nENDSEC\n";
}

std::string header(std::optional<double> unit) {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n";
  for (const auto& [code, metres] : dxf_units) {
    if (unit == metres) text += fmt::format("9\n$INSUNITS\n70\n{}\n", code);
  }
  return text + "0\nENDSEC\n";
}

}  // namespace

Result<std::string> dxf(std::span<const lines::Feature> given, std::optional<double> unit) {
  const std::vector<lines::Feature> features = lines::rings_apart(given);
  std::string text = header(unit) + tables(features) + "0\nSECTION\n2\nENTITIES\n";
  for (std::size_t i = 0; i < features.size(); ++i) {
    const std::string layer = dxf_layer(features[i]);
    for (std::size_t part = 0; part < features[i].parts.size(); ++part) {
      DOBRA_TRY_VOID(check_finite(features[i].parts[part].points, lines::item_of(i + 1, features[i])));
      append_part(text, features[i], part, layer);
    }
  }
  return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace dobra::io::gis
