#include "shared/io/drawings/svg.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "shared/base/text.h"
#include "shared/io/drawings/svg_display.h"
#include "shared/io/drawings/svg_path.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"
#include "shared/io/xml.h"

// 1. Elements one after the other, in the order of the file. 2. Groups keep their transforms on a stack; what is only
// defined (defs, symbol, clipPath, ...) or not displayed is passed over. 3. A shape becomes path data, path data
// becomes pieces, pieces are transformed.

namespace dobra::io::drawings {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;
using geom::Vector;

namespace {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;
  [[nodiscard]] Vector of(Vector v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  [[nodiscard]] Point of(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this.
  [[nodiscard]] Affine after(const Affine& inner) const {
    const Vector x = of(Vector{inner.a, inner.b});
    const Vector y = of(Vector{inner.c, inner.d});
    const Point origin = of(Point{inner.e, inner.f});
    return {x.x, x.y, y.x, y.y, origin.x, origin.y};
  }
};

Result<Affine> one_transform(const std::string& name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return Affine{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0.0};
  if (name == "scale" && (n == 1 || n == 2)) return Affine{v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
  const double angle = n == 0 ? 0.0 : v[0] * std::numbers::pi / 180.0;
  if (name == "rotate" && (n == 1 || n == 3)) {
    const Affine turn{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
    if (n == 1) return turn;
    return Affine{1, 0, 0, 1, v[1], v[2]}.after(turn).after({1, 0, 0, 1, -v[1], -v[2]});
  }
  if (name == "skewX" && n == 1) return Affine{1, 0, std::tan(angle), 1, 0, 0};
  if (name == "skewY" && n == 1) return Affine{1, std::tan(angle), 0, 1, 0, 0};
  return Error{ErrorCode::BadFormat, fmt::format("there is no transform {} of {} numbers", shown(name), n)};
}

Result<Affine> transform_of(std::string_view text) {
  Affine all;
  SvgScanner scan(text);
  while (!scan.at_end()) {
    if (scan.take(',')) continue;
    std::string name;
    while (!scan.at_end() && scan.rest().front() != '(') name += scan.take();
    if (!scan.take('(')) return Error{ErrorCode::BadFormat, "a transform has its numbers in round brackets"};
    std::vector<double> values;
    while (scan.at_number()) {
      DOBRA_TRY(const double value, scan.number());
      values.push_back(value);
    }
    if (!scan.take(')')) return Error{ErrorCode::BadFormat, "the bracket of this transform does not close"};
    DOBRA_TRY(const Affine one, one_transform(name, values));
    all = all.after(one);
  }
  return all;
}

/// Passes over what stands at any depth without recursion.
class Reader : private pugi::xml_tree_walker {
 public:
  explicit Reader(const Xml& xml) : xml_(xml), display_(xml) {}

  Result<SvgFile> run() {
    // y down becomes y up.
    open_.push_back({{1, 0, 0, -1, 0, 0}});
    if (!xml_.root().traverse(*this)) return *failed_;
    for (const auto& [name, count] : left_out_)
      svg_.remarks.push_back(fmt::format("{}: {} <{}> left out: only outlines are read", xml_.file(), count, name));
    if (unseen_ > 0) {
      svg_.remarks.push_back(fmt::format("{}: {} {} not displayed left out (hidden: {})", xml_.file(), unseen_,
                                         unseen_ == 1 ? "outline that is" : "outlines that are",
                                         fmt::join(hidden_by_, ", ")));
    }
    if (svg_.paths.empty()) {
      return Error{ErrorCode::BadFormat,
                   unseen_ > 0 ? "no outline of the file is displayed: show its layers and objects"
                               : "there is no outline in the file: draw paths, or turn objects into paths",
                   Place{.file = xml_.file()}};
    }
    return std::move(svg_);
  }

 private:
  /// What an element hands to those in it.
  struct Open {
    Affine transform;
    bool defined_only = false;
    bool displayed = true;
    bool visible = true;      ///< Elements in one that is not may be visible again.
    std::string hidden_by{};  ///< The name of the outermost element that is not displayed, or of the one not visible.
  };

  bool for_each(pugi::xml_node& node) override {
    if (node.type() != pugi::node_element) return true;
    element_ = node;
    const auto read = element();
    if (!read) failed_ = read.error();
    return read.ok();
  }

  Result<void> element() {
    constexpr std::size_t deepest = 1000;
    const auto above = static_cast<std::size_t>(depth()) + 1;
    if (above >= deepest) return error("elements are nested too deeply");
    open_.resize(above);
    Open inner = open_.back();
    const std::string name(local_name(element_));
    take_display(inner);
    const bool seen = inner.displayed && inner.visible;
    if (only_defines(name)) {
      if (!inner.defined_only && seen) ++left_out_[name];
      inner.defined_only = true;
    }
    if (const pugi::xml_attribute given = element_.attribute("transform");
        given && !inner.defined_only && inner.displayed) {
      auto own = transform_of(given.value());
      if (!own) return located(own.error(), place());
      inner.transform = inner.transform.after(*own);
    }
    if (!inner.defined_only && seen) DOBRA_TRY_VOID(shape(name, inner.transform));
    if (!inner.defined_only && !seen && is_outline(name)) {
      ++unseen_;
      hidden_by_.insert(inner.hidden_by);
    }
    open_.push_back(std::move(inner));
    return {};
  }

  void take_display(Open& inner) const {
    if (!inner.displayed) return;
    inner.displayed = display_.value(element_, "display") != "none";
    const std::string visibility = display_.value(element_, "visibility");
    if (!visibility.empty()) inner.visible = visibility == "visible";
    if (inner.displayed && visibility.empty()) return;
    for (const char* const name : {"inkscape:label", "id"}) {
      inner.hidden_by = element_.attribute(name).value();
      if (!inner.hidden_by.empty()) return;
    }
    inner.hidden_by = fmt::format("<{}>", element_.name());
  }

  static bool is_outline(const std::string& name) {
    static const std::set<std::string> names{"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
    return names.contains(name);
  }

  [[nodiscard]] Place place() const { return xml_.place(element_); }
  [[nodiscard]] Error error(std::string message) const { return {ErrorCode::BadFormat, std::move(message), place()}; }

  static bool only_defines(const std::string& name) {
    static const std::set<std::string> names{"defs",           "symbol", "clipPath", "mask",   "marker",
                                             "pattern",        "text",   "image",    "use",    "linearGradient",
                                             "radialGradient", "filter", "style",    "script", "foreignObject"};
    return names.contains(name);
  }

  /// An attribute as a length; units other than px are refused, since what they are depends on the viewer.
  Result<double> length(const char* name) {
    const pugi::xml_attribute found = element_.attribute(name);
    if (!found) return 0.0;
    SvgScanner scan(found.value());
    auto value = scan.number();
    if (!value) return located(value.error(), place());
    if (!scan.at_end() && scan.rest() != "px")
      return error(fmt::format("{} = {}: give lengths without a unit", name, shown(found.value())));
    return *value;
  }

  /// The element as path data; empty if it is no outline.
  Result<std::string> path_data(const std::string& name) {
    const auto attribute = [&](const char* key) { return std::string(element_.attribute(key).value()); };
    if (name == "path") return attribute("d");
    if (name == "polyline") return "M" + attribute("points");
    if (name == "polygon") return "M" + attribute("points") + "Z";
    std::map<std::string, double> v;
    static const std::map<std::string, std::vector<const char*>> used{
        {"line", {"x1", "y1", "x2", "y2"}},
        {"rect", {"x", "y", "width", "height", "rx", "ry"}},
        {"circle", {"cx", "cy", "r"}},
        {"ellipse", {"cx", "cy", "rx", "ry"}}};
    const auto shape = used.find(name);
    if (shape == used.end()) return std::string();
    for (const char* key : shape->second) {
      DOBRA_TRY(v[key], length(key));
    }
    const auto text = [](double value) { return base::number_text(value); };
    if (name == "line") return fmt::format("M{} {} {} {}", text(v["x1"]), text(v["y1"]), text(v["x2"]), text(v["y2"]));
    if (name == "rect") {
      if (v["rx"] != 0.0 || v["ry"] != 0.0) return error("a rect with round corners is not read: turn it into a path");
      if (!(v["width"] > 0.0) || !(v["height"] > 0.0)) return error("a rect needs a width and a height above 0");
      return fmt::format("M{} {}h{}v{}h{}z", text(v["x"]), text(v["y"]), text(v["width"]), text(v["height"]),
                         text(-v["width"]));
    }
    const double rx = name == "circle" ? v["r"] : v["rx"];
    const double ry = name == "circle" ? v["r"] : v["ry"];
    if (!(rx > 0.0) || !(ry > 0.0)) return error(fmt::format("<{}> needs radii above 0", name));
    return fmt::format("M{0} {1}A{2} {3} 0 0 1 {4} {1}A{2} {3} 0 0 1 {0} {1}z", text(v["cx"] + rx), text(v["cy"]),
                       text(rx), text(ry), text(v["cx"] - rx));
  }

  Result<void> shape(const std::string& element, const Affine& transform) {
    DOBRA_TRY(const std::string data, path_data(element));
    if (data.find_first_not_of(" \t\r\n") == std::string::npos) return {};
    auto read = svg_subpaths(data);
    if (!read) return located(read.error(), place());
    const std::string id = element_.attribute("id").value();
    std::size_t number = 0;
    for (SvgPath& path : *read) {
      ++number;
      path.name = id.empty()    ? fmt::format("path {}", svg_.paths.size() + 1)
                  : number == 1 ? id
                                : fmt::format("{} ({})", id, number);
      path.place = place();
      for (SvgPiece& piece : path.pieces) {
        for (Point* p : {&piece.from, &piece.to, &piece.control[0], &piece.control[1], &piece.centre})
          *p = transform.of(*p);
        piece.u = transform.of(piece.u);
        piece.v = transform.of(piece.v);
        const bool finite = geom::is_finite(piece.from) && geom::is_finite(piece.to) &&
                            geom::is_finite(piece.control[0]) && geom::is_finite(piece.control[1]) &&
                            geom::is_finite(piece.centre) && geom::is_finite(Point{} + piece.u) &&
                            geom::is_finite(Point{} + piece.v);
        if (!finite) return Error{ErrorCode::NotFinite, "a coordinate of this outline is too large", place()};
      }
      svg_.paths.push_back(std::move(path));
    }
    return {};
  }

  const Xml& xml_;
  SvgDisplay display_;
  std::vector<Open> open_;  ///< The elements that the current one stands in, outermost first.
  pugi::xml_node element_;
  std::optional<Error> failed_;
  std::map<std::string, std::size_t> left_out_;
  std::size_t unseen_ = 0;
  std::set<std::string> hidden_by_;
  SvgFile svg_;
};

}  // namespace

Result<SvgFile> parse_svg(std::string_view text, const std::string& file) {
  DOBRA_TRY(const Xml xml, Xml::parse(text, file));
  return Reader(xml).run();
}

Result<SvgFile> read_svg(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_svg(text, path);
}

}  // namespace dobra::io::drawings
