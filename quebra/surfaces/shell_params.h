#pragma once
// The step `shell`: thickness, material, supports and loads of the last mesh of surfaces, for analysis elsewhere.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "shared/scenario/field.h"

namespace quebra::surfaces {

struct ShellMaterialParams {
  std::string region = {};
  double young = 0.0, poisson = 0.3, thickness = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field(
        "region", &ShellMaterialParams::region,
        {.title = "Region", .help = "A surface or a part with a name; empty: all that have no material of their own."});
    d.field("young", &ShellMaterialParams::young,
            {.title = "Young's modulus", .unit = "Pa", .above = 0, .presence = dobra::scenario::Presence::Required});
    d.field("poisson", &ShellMaterialParams::poisson, {.title = "Poisson's ratio", .above = -1, .at_most = 0.499});
    d.field("thickness", &ShellMaterialParams::thickness,
            {.title = "Thickness",
             .help = "The surface is its middle.",
             .unit = "m",
             .above = 0,
             .presence = dobra::scenario::Presence::Required});
  }
};

struct ShellSupportParams {
  std::string where = {};
  std::optional<double> x = {}, y = {}, z = {};
  std::optional<dobra::base::Angle> turn_x = {}, turn_y = {}, turn_z = {};

  template <class D>
  static void describe(D& d) {
    d.field("where", &ShellSupportParams::where,
            {.title = "Where",
             .help = "A set of sides or nodes: a trim, a point, a side of a chart NAME_left, NAME_right, NAME_bottom, "
                     "NAME_top.",
             .presence = dobra::scenario::Presence::Required});
    d.field("x", &ShellSupportParams::x,
            {.title = "Along x", .help = "Prescribed displacement; 0 holds, nothing leaves free.", .unit = "m"});
    d.field("y", &ShellSupportParams::y, {.title = "Along y", .unit = "m"});
    d.field("z", &ShellSupportParams::z, {.title = "Along z", .unit = "m"});
    d.field("turn_x", &ShellSupportParams::turn_x,
            {.title = "About x", .help = "Prescribed rotation; 0 holds, nothing leaves free.", .unit = "deg"});
    d.field("turn_y", &ShellSupportParams::turn_y, {.title = "About y", .unit = "deg"});
    d.field("turn_z", &ShellSupportParams::turn_z, {.title = "About z", .unit = "deg"});
  }
};

enum class ShellLoadKind { Area, Pressure, Body, Edge, Force };

struct ShellLoadParams {
  std::string where = {};
  ShellLoadKind kind = ShellLoadKind::Area;
  std::optional<double> x = std::nullopt, y = std::nullopt, z = std::nullopt, value = std::nullopt;
  static constexpr const char* by_kind = "Pa, N/m3 if kind = body, N/m if kind = edge, N if kind = force";

  template <class D>
  static void describe(D& d) {
    d.field("where", &ShellLoadParams::where,
            {.title = "Where",
             .help = "A region (area, pressure, body; empty: all), a set of sides (edge), a set of nodes (force)."});
    d.choice("kind", &ShellLoadParams::kind, {"area", "pressure", "body", "edge", "force"},
             {.title = "Kind",
              .help = "area: x, y, z on each unit of the surface; pressure: value, against the normal of the elements; "
                      "body: x, y, z on each unit of volume, such as the weight; edge: x, y, z on each unit of length; "
                      "force: x, y, z at each node."});
    d.field("x", &ShellLoadParams::x, {.title = "x", .unit = by_kind, .when = "kind in area, body, edge, force"});
    d.field("y", &ShellLoadParams::y, {.title = "y", .unit = by_kind, .when = "kind in area, body, edge, force"});
    d.field("z", &ShellLoadParams::z, {.title = "z", .unit = by_kind, .when = "kind in area, body, edge, force"});
    d.field("value", &ShellLoadParams::value, {.title = "Value", .unit = "Pa", .when = "kind = pressure"});
  }
};

struct ShellParams {
  std::vector<ShellMaterialParams> materials;
  std::vector<ShellSupportParams> supports;
  std::vector<ShellLoadParams> loads;

  template <class D>
  static void describe(D& d) {
    d.tables("material", &ShellParams::materials, {.title = "Materials"});
    d.tables("support", &ShellParams::supports, {.title = "Supports"});
    d.tables("load", &ShellParams::loads, {.title = "Loads"});
  }
};

}  // namespace quebra::surfaces
