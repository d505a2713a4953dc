#include "shared/scene/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dobra::scene {
namespace {

constexpr std::array<Color, 11> viridis{{{68, 1, 84},
                                         {72, 36, 117},
                                         {65, 68, 135},
                                         {53, 95, 141},
                                         {42, 120, 142},
                                         {33, 145, 140},
                                         {34, 168, 132},
                                         {68, 191, 112},
                                         {122, 209, 81},
                                         {189, 223, 38},
                                         {253, 231, 37}}};
constexpr std::array<Color, 10> cividis{{{0, 32, 77},
                                         {0, 51, 111},
                                         {57, 72, 107},
                                         {87, 92, 109},
                                         {112, 113, 115},
                                         {138, 135, 121},
                                         {166, 157, 117},
                                         {196, 181, 108},
                                         {228, 207, 91},
                                         {255, 234, 70}}};
constexpr std::array<Color, 9> cool_warm{{{59, 76, 192},
                                          {98, 130, 234},
                                          {141, 176, 254},
                                          {184, 208, 249},
                                          {221, 221, 221},
                                          {245, 196, 173},
                                          {244, 154, 123},
                                          {222, 96, 77},
                                          {180, 4, 38}}};
constexpr std::array<Color, 7> quality{
    {{178, 24, 43}, {233, 92, 71}, {253, 174, 97}, {254, 228, 144}, {186, 222, 190}, {90, 180, 172}, {1, 120, 120}}};
constexpr Color not_a_number{160, 160, 160};

std::span<const Color> table_of(ColorMapName map) {
  switch (map) {
    case ColorMapName::Viridis:
      return viridis;
    case ColorMapName::Cividis:
      return cividis;
    case ColorMapName::CoolWarm:
      return cool_warm;
    case ColorMapName::Quality:
      return quality;
  }
  return viridis;
}

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround((1.0 - t) * a + t * b));
}

}  // namespace

Color color_at(ColorMapName map, double fraction) {
  if (std::isnan(fraction)) return not_a_number;
  const std::span<const Color> table = table_of(map);
  const double position = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(position), table.size() - 2);
  const double t = position - static_cast<double>(i);
  const Color a = table[i];
  const Color b = table[i + 1];
  return {mix(a.red, b.red, t), mix(a.green, b.green, t), mix(a.blue, b.blue, t), 255};
}

double fraction_of(const Scale& scale, double value) {
  if (std::isnan(value)) return value;
  const double width = scale.high - scale.low;
  if (!(std::abs(width) > 0.0)) return 0.5;
  return std::clamp((value - scale.low) / width, 0.0, 1.0);
}

bool settle_constant(Mesh& mesh, double size) {
  if (mesh.values.empty()) return false;
  const auto [least, greatest] = std::minmax_element(mesh.values.begin(), mesh.values.end());
  const double rounding = rounding_part * std::abs(size);
  if (!(*greatest - *least <= rounding)) return false;
  const double middle = 0.5 * (*least + *greatest);
  const double value = std::abs(middle) <= rounding ? 0.0 : middle;
  std::ranges::fill(mesh.values.edit(), value);
  mesh.scale.low = mesh.scale.high = value;
  mesh.scale.least = mesh.scale.greatest = std::nullopt;
  return true;
}

Color color_of(const Scale& scale, double value) { return color_at(scale.map, fraction_of(scale, value)); }

}  // namespace dobra::scene
