#include "shared/io/drawings/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "shared/base/text.h"
#include "shared/io/drawings/svg_path.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

// 1. Tags one after the other; comments, declarations and texts are passed over. 2. Groups keep their transforms on a
// stack; what is only defined (defs, symbol, clipPath, ...) is passed over. 3. A shape becomes path data, path data
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

struct Tag {
  std::string name;  ///< Without a namespace.
  std::map<std::string, std::string> attributes;
  bool closing = false;
  bool empty = false;
  std::size_t at = 0;  ///< Byte of the text.
};

class Reader {
 public:
  Reader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  Result<SvgFile> run() {
    // y down becomes y up.
    std::vector<Open> open{{"", {1, 0, 0, -1, 0, 0}, false}};
    constexpr std::size_t deepest = 1000;
    while (true) {
      DOBRA_TRY(const bool more, next());
      if (!more) break;
      if (tag_.closing) {
        if (open.size() == 1 || open.back().name != tag_.name)
          return error(fmt::format("</{}> closes nothing that is open", tag_.name));
        open.pop_back();
        continue;
      }
      Open inner = open.back();
      inner.name = tag_.name;
      if (only_defines()) {
        if (!inner.hidden) ++left_out_[tag_.name];
        inner.hidden = true;
      }
      if (const auto given = tag_.attributes.find("transform"); given != tag_.attributes.end() && !inner.hidden) {
        auto own = transform_of(given->second);
        if (!own) return located(own.error(), place());
        inner.transform = inner.transform.after(*own);
      }
      if (!inner.hidden) DOBRA_TRY_VOID(shape(inner.transform));
      if (!tag_.empty) open.push_back(std::move(inner));
      if (open.size() > deepest) return error("elements are nested too deeply");
    }
    if (open.size() > 1) return error(fmt::format("<{}> is not closed", open.back().name));
    for (const auto& [name, count] : left_out_)
      svg_.remarks.push_back(fmt::format("{}: {} <{}> left out: only outlines are read", file_, count, name));
    if (svg_.paths.empty())
      return Error{ErrorCode::BadFormat, "there is no outline in the file: draw paths, or turn objects into paths",
                   Place{.file = file_}};
    return std::move(svg_);
  }

 private:
  struct Open {
    std::string name;
    Affine transform;
    bool hidden = false;
  };

  [[nodiscard]] Place place() const { return place_of_byte(text_, tag_.at, file_); }
  [[nodiscard]] Error error(std::string message) const { return {ErrorCode::BadFormat, std::move(message), place()}; }

  [[nodiscard]] bool only_defines() const {
    static const std::set<std::string> names{"defs",           "symbol", "clipPath", "mask",   "marker",
                                             "pattern",        "text",   "image",    "use",    "linearGradient",
                                             "radialGradient", "filter", "style",    "script", "foreignObject"};
    return names.contains(tag_.name);
  }

  bool skip_to(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    return found != std::string_view::npos;
  }

  /// The next tag. @return false at the end of the file.
  Result<bool> next() {
    while (true) {
      at_ = text_.find('<', at_);
      if (at_ == std::string_view::npos) return false;
      tag_ = {};
      tag_.at = at_;
      const std::string_view rest = text_.substr(at_);
      const auto pass = [&](std::string_view begin, std::string_view end) {
        return rest.starts_with(begin) ? skip_to(end) ? 1 : -1 : 0;
      };
      int passed = pass("<!--", "-->");
      if (passed == 0) passed = pass("<![CDATA[", "]]>");
      if (passed == 0) passed = pass("<?", "?>");
      if (passed == 0 && rest.starts_with("<!")) passed = skip_declaration() ? 1 : -1;
      if (passed < 0) return error("this markup does not end");
      if (passed == 0) break;
    }
    ++at_;
    tag_.closing = at_ < text_.size() && text_[at_] == '/';
    if (tag_.closing) ++at_;
    const auto name_end = [&](std::size_t from) {
      return std::min(text_.find_first_of(" \t\r\n/>=", from), text_.size());
    };
    const std::size_t end = name_end(at_);
    tag_.name = without_namespace(text_.substr(at_, end - at_));
    at_ = end;
    if (tag_.name.empty()) return error("a name is due after '<'");
    while (true) {
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
      if (at_ == text_.size()) return error(fmt::format("the tag <{}> does not end", tag_.name));
      if (text_[at_] == '>') {
        ++at_;
        return true;
      }
      if (text_[at_] == '/') {
        tag_.empty = true;
        ++at_;
        continue;
      }
      const std::size_t stop = name_end(at_);
      const std::string name(text_.substr(at_, stop - at_));
      at_ = std::min(text_.find_first_not_of(" \t\r\n", stop), text_.size());
      if (name.empty() || at_ == text_.size() || text_[at_] != '=')
        return error(fmt::format("an attribute of <{}> has no value", tag_.name));
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_ + 1), text_.size());
      const char quote = at_ < text_.size() ? text_[at_] : '\0';
      const std::size_t close = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string_view::npos;
      if (close == std::string_view::npos)
        return error(fmt::format("the value of {} is not between quotes", shown(name)));
      tag_.attributes[name] = std::string(text_.substr(at_ + 1, close - at_ - 1));
      at_ = close + 1;
    }
  }

  /// <!DOCTYPE ... [ ... ] >
  bool skip_declaration() {
    int brackets = 0;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '[') ++brackets;
      if (text_[at_] == ']') --brackets;
      if (text_[at_] == '>' && brackets <= 0) {
        ++at_;
        return true;
      }
    }
    return false;
  }

  static std::string without_namespace(std::string_view name) { return std::string(name.substr(name.find(':') + 1)); }

  /// An attribute as a length; units other than px are refused, since what they are depends on the viewer.
  Result<double> length(const char* name) {
    const auto found = tag_.attributes.find(name);
    if (found == tag_.attributes.end()) return 0.0;
    SvgScanner scan(found->second);
    auto value = scan.number();
    if (!value) return located(value.error(), place());
    if (!scan.at_end() && scan.rest() != "px")
      return error(fmt::format("{} = {}: give lengths without a unit", name, shown(found->second)));
    return *value;
  }

  /// The element as path data; empty if it is no outline.
  Result<std::string> path_data() {
    const std::string& name = tag_.name;
    const auto attribute = [&](const char* key) {
      const auto found = tag_.attributes.find(key);
      return found == tag_.attributes.end() ? std::string() : found->second;
    };
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

  Result<void> shape(const Affine& transform) {
    DOBRA_TRY(const std::string data, path_data());
    if (data.find_first_not_of(" \t\r\n") == std::string::npos) return {};
    auto read = svg_subpaths(data);
    if (!read) return located(read.error(), place());
    const auto id = tag_.attributes.find("id");
    std::size_t number = 0;
    for (SvgPath& path : *read) {
      ++number;
      path.name = id == tag_.attributes.end() || id->second.empty() ? fmt::format("path {}", svg_.paths.size() + 1)
                  : number == 1                                     ? id->second
                                                                    : fmt::format("{} ({})", id->second, number);
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

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  Tag tag_;
  std::map<std::string, std::size_t> left_out_;
  SvgFile svg_;
};

}  // namespace

Result<SvgFile> parse_svg(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return Reader(text, file).run();
}

Result<SvgFile> read_svg(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_svg(text, path);
}

}  // namespace dobra::io::drawings
