#include "shared/io/geo.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/geo_tokens.h"
#include "shared/io/scan.h"

// 1. The text becomes tokens (geo_tokens.h). 2. Statements are carried out as they come; For goes back, If leaps.
// 3. Expressions by recursive descent: ?: || && == < + * unary ^. 4. At the end every tag that was used must be there.

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

using Kind = GeoToken::Kind;
using List = std::vector<double>;

constexpr double most_steps = 1e7;
constexpr std::size_t deepest = 200;

const std::map<std::string, double (*)(double)>& functions() {
  static const std::map<std::string, double (*)(double)> table = {
      {"Sin", std::sin},     {"Cos", std::cos},     {"Tan", std::tan},    {"Asin", std::asin}, {"Acos", std::acos},
      {"Atan", std::atan},   {"Sinh", std::sinh},   {"Cosh", std::cosh},  {"Tanh", std::tanh}, {"Exp", std::exp},
      {"Log", std::log},     {"Log10", std::log10}, {"Sqrt", std::sqrt},  {"Fabs", std::fabs}, {"Abs", std::fabs},
      {"Floor", std::floor}, {"Ceil", std::ceil},   {"Round", std::round}};
  return table;
}

class Parser {
 public:
  Parser(std::vector<GeoToken> tokens, std::string file) : tokens_(std::move(tokens)), file_(std::move(file)) {}

  Result<GeoFile> run() {
    while (token().kind != Kind::End) DOBRA_TRY_VOID(statement());
    if (!loops_.empty()) return error_at(tokens_[loops_.back().start], "this For has no EndFor");
    if (open_ifs_ > 0) return error("an If has no EndIf");
    DOBRA_TRY_VOID(check());
    return std::move(geo_);
  }

 private:
  // --- tokens
  // ---------------------------------------------------------------------------------------------------------
  [[nodiscard]] const GeoToken& token(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  [[nodiscard]] bool is(std::string_view text, std::size_t ahead = 0) const {
    return (token(ahead).kind == Kind::Word || token(ahead).kind == Kind::Sign) && token(ahead).text == text;
  }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  [[nodiscard]] base::Place place(const GeoToken& token) const {
    base::Place place;
    place.file = file_;
    place.line = token.line;
    place.column = token.column;
    return place;
  }
  [[nodiscard]] Error error_at(const GeoToken& token, std::string message) const {
    return {ErrorCode::BadFormat, std::move(message), place(token)};
  }
  [[nodiscard]] Error error(std::string message) const { return error_at(token(), std::move(message)); }
  [[nodiscard]] std::string found() const {
    return token().kind == Kind::End ? "the end of the file" : shown(token().text);
  }
  Result<void> expect(std::string_view text) {
    if (take(text)) return {};
    return error(fmt::format("'{}' is due here, not {}", text, found()));
  }

  // --- expressions
  // ----------------------------------------------------------------------------------------------------
  Result<double> expression() {
    if (++depth_ > deepest) return error("the expression is nested too deeply");
    auto value = conditional();
    --depth_;
    if (value && !std::isfinite(*value)) return error("the expression has no finite value");
    return value;
  }

  Result<double> conditional() {
    DOBRA_TRY(const double condition, binary(0));
    if (!take("?")) return condition;
    DOBRA_TRY(const double yes, expression());
    DOBRA_TRY_VOID(expect(":"));
    DOBRA_TRY(const double no, expression());
    return condition != 0.0 ? yes : no;
  }

  struct Operator {
    std::string_view sign;
    int level;
    double (*value)(double, double);
  };
  static const std::vector<Operator>& operators() {
    static const std::vector<Operator> table = {
        {"||", 0, [](double a, double b) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; }},
        {"&&", 1, [](double a, double b) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; }},
        {"==", 2, [](double a, double b) { return a == b ? 1.0 : 0.0; }},
        {"!=", 2, [](double a, double b) { return a != b ? 1.0 : 0.0; }},
        {"<=", 3, [](double a, double b) { return a <= b ? 1.0 : 0.0; }},
        {">=", 3, [](double a, double b) { return a >= b ? 1.0 : 0.0; }},
        {"<", 3, [](double a, double b) { return a < b ? 1.0 : 0.0; }},
        {">", 3, [](double a, double b) { return a > b ? 1.0 : 0.0; }},
        {"+", 4, [](double a, double b) { return a + b; }},
        {"-", 4, [](double a, double b) { return a - b; }},
        {"*", 5, [](double a, double b) { return a * b; }},
        {"/", 5, [](double a, double b) { return a / b; }},
        {"%", 5, [](double a, double b) { return std::fmod(a, b); }}};
    return table;
  }

  Result<double> binary(int level) {
    if (level > 5) return unary();
    DOBRA_TRY(double value, binary(level + 1));
    while (token().kind == Kind::Sign) {
      const auto& all = operators();
      const auto op = std::find_if(all.begin(), all.end(),
                                   [&](const Operator& o) { return o.level == level && o.sign == token().text; });
      if (op == all.end()) break;
      ++at_;
      DOBRA_TRY(const double right, binary(level + 1));
      value = op->value(value, right);
    }
    return value;
  }

  Result<double> unary() {
    if (++depth_ > deepest) return error("the expression is nested too deeply");
    auto value = signed_power();
    --depth_;
    return value;
  }

  Result<double> signed_power() {
    if (take("+")) return unary();
    if (take("-")) {
      DOBRA_TRY(const double value, unary());
      return -value;
    }
    if (take("!")) {
      DOBRA_TRY(const double value, unary());
      return value == 0.0 ? 1.0 : 0.0;
    }
    DOBRA_TRY(const double base, primary());
    if (!take("^")) return base;
    DOBRA_TRY(const double exponent, unary());
    return std::pow(base, exponent);
  }

  Result<double> primary() {
    if (token().kind == Kind::Number) return tokens_[at_++].value;
    if (take("(")) {
      DOBRA_TRY(const double value, expression());
      DOBRA_TRY_VOID(expect(")"));
      return value;
    }
    if (take("#")) {
      const GeoToken name = token();
      ++at_;
      if (!take("[")) DOBRA_TRY_VOID(expect("("));
      if (!take("]")) DOBRA_TRY_VOID(expect(")"));
      const auto list = lists_.find(name.text);
      if (list == lists_.end()) return error_at(name, fmt::format("there is no list {}", shown(name.text)));
      return static_cast<double>(list->second.size());
    }
    if (token().kind != Kind::Word) return error(fmt::format("a number or a name is due here, not {}", found()));
    return named();
  }

  Result<double> named() {
    const GeoToken name = token();
    ++at_;
    if (name.text == "Pi") return std::numbers::pi;
    if (name.text == "newp") return next_tag(geo_.points);
    if (name.text == "newl" || name.text == "newc") return next_tag(geo_.curves);
    if (name.text == "newll" || name.text == "newcl") return next_tag(loop_curves_);
    if (name.text == "news") return next_tag(geo_.surfaces);
    if (name.text == "newreg") {
      return std::max({next_tag(geo_.curves), next_tag(loop_curves_), next_tag(geo_.surfaces),
                       static_cast<double>(last_group_ + 1)});
    }
    if (is("(") || is("[")) {
      const auto function = functions().find(name.text);
      const std::string closing = is("(") ? ")" : "]";
      ++at_;
      DOBRA_TRY(const double first, expression());
      if (take(",")) {
        DOBRA_TRY(const double second, expression());
        DOBRA_TRY_VOID(expect(closing));
        if (name.text == "Atan2") return std::atan2(first, second);
        if (name.text == "Hypot") return std::hypot(first, second);
        if (name.text == "Fmod" || name.text == "Modulo") return std::fmod(first, second);
        if (name.text == "Min") return std::min(first, second);
        if (name.text == "Max") return std::max(first, second);
        return error_at(name, fmt::format("there is no function {} of two numbers", shown(name.text)));
      }
      DOBRA_TRY_VOID(expect(closing));
      if (function != functions().end()) return function->second(first);
      const auto list = lists_.find(name.text);
      if (list == lists_.end()) return error_at(name, unknown("function or list", name.text));
      if (!(first >= 0.0) || first >= static_cast<double>(list->second.size())) {
        return error_at(name, fmt::format("the list {} has no element {}", shown(name.text), first));
      }
      return list->second[static_cast<std::size_t>(first)];
    }
    const auto variable = variables_.find(name.text);
    if (variable == variables_.end()) return error_at(name, unknown("variable", name.text));
    return variable->second;
  }

  [[nodiscard]] std::string unknown(const char* what, const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& [known, value] : variables_) names.push_back(known);
    for (const auto& [known, value] : functions()) names.push_back(known);
    return fmt::format("there is no {} {}{}", what, shown(name), base::did_you_mean(name, names));
  }

  template <class T>
  static double next_tag(const std::map<std::int64_t, T>& items) {
    return items.empty() ? 1.0 : static_cast<double>(items.rbegin()->first) + 1.0;
  }

  /// "{a, b:c, list[]}" or a single value.
  Result<List> list() {
    List values;
    if (!take("{")) {
      DOBRA_TRY_VOID(list_item(values));
      return values;
    }
    while (!take("}")) {
      DOBRA_TRY_VOID(list_item(values));
      if (!is("}")) DOBRA_TRY_VOID(expect(","));
    }
    return values;
  }

  /// Work of `count` steps; an error once a file asks for more than any geometry needs.
  Result<void> spend(double count) {
    steps_ += count;
    if (steps_ > most_steps) return error("the loops and lists of this file are too long");
    return {};
  }

  Result<void> list_item(List& values) {
    const bool minus = is("-") && token(1).kind == Kind::Word && lists_.contains(token(1).text);
    const std::size_t name = minus ? 1 : 0;
    const bool whole = token(name).kind == Kind::Word && lists_.contains(token(name).text) &&
                       ((is("[", name + 1) && is("]", name + 2)) || (is("(", name + 1) && is(")", name + 2)));
    if (whole) {
      const List& list = lists_.at(token(name).text);
      DOBRA_TRY_VOID(spend(static_cast<double>(list.size())));
      for (const double value : list) values.push_back(minus ? -value : value);
      at_ += name + 3;
      return {};
    }
    DOBRA_TRY(const double first, expression());
    if (!take(":")) {
      values.push_back(first);
      return {};
    }
    DOBRA_TRY(const double last, expression());
    double step = last >= first ? 1.0 : -1.0;
    if (take(":")) {
      DOBRA_TRY(step, expression());
    }
    const double count = std::floor((last - first) / step + 1e-9);
    if (!(count >= 0.0) || count > 1e6) return error("this range is empty or too long");
    DOBRA_TRY_VOID(spend(count));
    for (double i = 0.0; i <= count; ++i) values.push_back(first + i * step);
    return {};
  }

  Result<std::int64_t> tag_of(double value) const {
    if (value != std::floor(value) || std::abs(value) > 1e15 || value == 0.0)
      return error(fmt::format("{} is not a tag: tags are whole numbers, not 0", value));
    return static_cast<std::int64_t>(value);
  }
  Result<std::vector<std::int64_t>> tags() {
    DOBRA_TRY(const List values, list());
    std::vector<std::int64_t> result;
    for (const double value : values) {
      DOBRA_TRY(const std::int64_t tag, tag_of(value));
      result.push_back(tag);
    }
    return result;
  }
  /// "(expression)"
  Result<std::int64_t> own_tag() {
    DOBRA_TRY_VOID(expect("("));
    DOBRA_TRY(const double value, expression());
    DOBRA_TRY_VOID(expect(")"));
    return tag_of(value);
  }

  // --- statements
  // -----------------------------------------------------------------------------------------------------
  Result<void> statement() {
    DOBRA_TRY_VOID(spend(1.0));
    if (take(";")) return {};
    if (token().kind != Kind::Word) return error(fmt::format("a statement is due here, not {}", found()));
    const GeoToken start = token();
    ++at_;
    const std::string& word = start.text;
    if (word == "Point") return is("{") ? embed(0) : point();
    if (word == "Line" || word == "Curve") {
      if (take("Loop")) return loop();
      return is("{") ? embed(1) : curve(start, GeoCurveKind::Line);
    }
    if (word == "Circle") return curve(start, GeoCurveKind::Circle);
    if (word == "Ellipse" || word == "Ellipsis") return curve(start, GeoCurveKind::Ellipse);
    if (word == "Spline" || word == "CatmullRom") return curve(start, GeoCurveKind::Spline);
    if (word == "BSpline") return curve(start, GeoCurveKind::BSpline);
    if (word == "Bezier") return curve(start, GeoCurveKind::Bezier);
    if (word == "Plane" || word == "Surface" || word == "Ruled") {
      if (word != "Surface") DOBRA_TRY_VOID(expect("Surface"));
      return surface();
    }
    if (word == "Physical") return physical();
    if (word == "Characteristic") {
      DOBRA_TRY_VOID(expect("Length"));
      return sizes();
    }
    if (word == "MeshSize") return sizes();
    if (word == "Transfinite" && (is("Line") || is("Curve"))) return transfinite();
    if (word == "For") return begin_for(start);
    if (word == "EndFor") return end_for(start);
    if (word == "If") return begin_if();
    if (word == "Else" || word == "ElseIf" || word == "EndIf") return end_branch(start);
    constexpr std::array ignored{"Transfinite", "Recombine", "SetFactory", "Coherence",         "Color",
                                 "Hide",        "Show",      "Printf",     "Geometry.Tolerance"};
    if (std::find(ignored.begin(), ignored.end(), word) != ignored.end() || word.starts_with("Mesh.") ||
        word.starts_with("General.") || word.starts_with("Geometry.")) {
      if (word == "SetFactory" && is("(") && token(1).text == "OpenCASCADE")
        return error_at(start,
                        "the OpenCASCADE kernel is not supported; use SetFactory(\"Built-in\") or export the mesh");
      return leave_out(start);
    }
    if (is("=") || is("+=") || is("-=") || is("*=") || is("/=") || ((is("[") || is("(")) && (is("]", 1) || is(")", 1))))
      return assign(start);
    if (is("++") || is("--")) {
      auto& value = variables_[word];
      value += is("++") ? 1.0 : -1.0;
      ++at_;
      return expect(";");
    }
    return error_at(start, fmt::format("the statement {} is not supported; what is read: points, curves, loops, plane "
                                       "surfaces, physical groups, sizes, "
                                       "Transfinite, variables, For, If",
                                       shown(word)));
  }

  Result<void> leave_out(const GeoToken& start) {
    geo_.remarks.push_back(fmt::format("{}:{}: {} left out", file_, start.line, shown(start.text)));
    while (!is(";") && token().kind != Kind::End) ++at_;
    return expect(";");
  }

  Result<void> assign(const GeoToken& name) {
    const bool is_list = is("[") || is("(");
    if (is_list) at_ += 2;
    const std::string op = token().text;
    if (!take("=") && !take("+=") && !take("-=") && !take("*=") && !take("/="))
      return error(fmt::format("'=' is due here, not {}", found()));
    // gmsh's constants with a form for the user: DefineConstant is left out, so a text cannot be used later.
    if (token().kind == Kind::Text) return error("texts are not supported as values");
    if (is_list || is("{")) {
      DOBRA_TRY(const List values, list());
      auto& target = lists_[name.text];
      if (op == "=") target.clear();
      if (op != "=" && op != "+=") return error_at(name, "a list can only be set or added to");
      target.insert(target.end(), values.begin(), values.end());
      return expect(";");
    }
    DOBRA_TRY(const double value, expression());
    const auto old = variables_.find(name.text);
    if (op != "=" && old == variables_.end()) return error_at(name, unknown("variable", name.text));
    double& target = variables_[name.text];
    if (op == "=") target = value;
    if (op == "+=") target += value;
    if (op == "-=") target -= value;
    if (op == "*=") target *= value;
    if (op == "/=") target /= value;
    if (!std::isfinite(target)) return error_at(name, "the variable has no finite value");
    return expect(";");
  }

  Result<void> point() {
    const GeoToken start = token();
    DOBRA_TRY(const std::int64_t tag, own_tag());
    DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(const List values, list());
    if (values.size() < 3 || values.size() > 4) return error_at(start, "a point has x, y, z and possibly a size");
    if (values[2] != 0.0) return error_at(start, "the point lies outside the plane z = 0; only plane geometry is read");
    if (!geo_.points
             .try_emplace(tag, GeoPoint{{values[0], values[1]}, values.size() > 3 ? std::max(0.0, values[3]) : 0.0})
             .second) {
      return error_at(start, fmt::format("point {} is given twice", tag));
    }
    return expect(";");
  }

  Result<void> curve(const GeoToken& start, GeoCurveKind kind) {
    DOBRA_TRY(const std::int64_t tag, own_tag());
    DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(std::vector<std::int64_t> points, tags());
    const std::size_t count = points.size();
    const bool good = kind == GeoCurveKind::Circle    ? count == 3
                      : kind == GeoCurveKind::Ellipse ? count == 3 || count == 4
                                                      : count >= 2;
    if (!good) return error_at(start, fmt::format("{} points do not make this curve", count));
    for (const std::int64_t p : points) {
      if (!geo_.points.contains(p)) return error_at(start, fmt::format("there is no point {}", p));
    }
    if (kind == GeoCurveKind::Ellipse && count == 3) points.insert(points.begin() + 1, points[1]);
    if (!geo_.curves.try_emplace(tag, GeoCurve{kind, std::move(points), 0, 1.0, place(start)}).second) {
      return error_at(start, fmt::format("curve {} is given twice", tag));
    }
    return expect(";");
  }

  Result<void> loop() {
    const GeoToken start = token();
    DOBRA_TRY(const std::int64_t tag, own_tag());
    DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(std::vector<std::int64_t> curves, tags());
    for (const std::int64_t c : curves) {
      if (!geo_.curves.contains(std::abs(c))) return error_at(start, fmt::format("there is no curve {}", std::abs(c)));
    }
    loop_curves_[tag] = std::move(curves);
    return expect(";");
  }

  Result<void> surface() {
    const GeoToken start = token();
    DOBRA_TRY(const std::int64_t tag, own_tag());
    DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(const std::vector<std::int64_t> loops, tags());
    auto& surface = geo_.surfaces[tag];
    surface.clear();
    for (const std::int64_t l : loops) {
      const auto found_loop = loop_curves_.find(std::abs(l));
      if (found_loop == loop_curves_.end()) return error_at(start, fmt::format("there is no loop {}", std::abs(l)));
      surface.push_back(found_loop->second);
    }
    if (surface.empty()) return error_at(start, "a surface needs a loop");
    return expect(";");
  }

  Result<void> physical() {
    GeoGroup group;
    const GeoToken what = token();
    if (take("Point")) {
      group.dimension = 0;
    } else if (take("Line") || take("Curve")) {
      group.dimension = 1;
    } else if (take("Surface")) {
      group.dimension = 2;
    } else {
      return error_at(what, fmt::format("physical groups are of points, curves and surfaces, not {}", found()));
    }
    DOBRA_TRY_VOID(expect("("));
    if (token().kind == Kind::Text) {
      group.name = token().text;
      ++at_;
      group.tag = last_group_ + 1;
      if (take(",")) {
        DOBRA_TRY(const double value, expression());
        DOBRA_TRY(group.tag, tag_of(value));
      }
    } else {
      DOBRA_TRY(const double value, expression());
      DOBRA_TRY(group.tag, tag_of(value));
    }
    DOBRA_TRY_VOID(expect(")"));
    if (!take("=")) DOBRA_TRY_VOID(expect("+="));
    DOBRA_TRY(const std::vector<std::int64_t> entities, tags());
    for (const std::int64_t entity : entities) group.entities.push_back(std::abs(entity));
    last_group_ = std::max(last_group_, group.tag);
    group_places_.push_back(what);
    geo_.groups.push_back(std::move(group));
    return expect(";");
  }

  Result<void> sizes() {
    const GeoToken start = token();
    DOBRA_TRY(const std::vector<std::int64_t> points, tags());
    DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(const double size, expression());
    for (const std::int64_t p : points) {
      const auto at = geo_.points.find(p);
      if (at == geo_.points.end()) return error_at(start, fmt::format("there is no point {}", p));
      at->second.size = std::max(0.0, size);
    }
    return expect(";");
  }

  Result<void> transfinite() {
    const GeoToken start = token();
    ++at_;
    DOBRA_TRY(const std::vector<std::int64_t> curves, tags());
    DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(const double nodes, expression());
    double progression = 1.0;
    if (take("Using")) {
      if (!take("Progression")) return error("only Progression is supported");
      DOBRA_TRY(progression, expression());
    }
    if (!(nodes >= 2.0) || nodes > 1e6 || !(progression > 0.0))
      return error_at(start, "a division needs two nodes at least and a progression above 0");
    for (const std::int64_t c : curves) {
      const auto curve = geo_.curves.find(std::abs(c));
      if (curve == geo_.curves.end()) return error_at(start, fmt::format("there is no curve {}", std::abs(c)));
      curve->second.segments = static_cast<int>(nodes) - 1;
      curve->second.ratio = std::pow(c > 0 ? progression : 1.0 / progression, curve->second.segments - 1);
      if (!(curve->second.ratio > 0.0) || !std::isfinite(curve->second.ratio))
        return error_at(start, "the progression is too steep for so many nodes");
    }
    return expect(";");
  }

  /// "Point{..} In Surface{..};"
  Result<void> embed(std::int64_t dimension) {
    const GeoToken start = token();
    DOBRA_TRY(const std::vector<std::int64_t> entities, tags());
    DOBRA_TRY_VOID(expect("In"));
    DOBRA_TRY_VOID(expect("Surface"));
    DOBRA_TRY(const std::vector<std::int64_t> surfaces, tags());
    for (const std::int64_t entity : entities) {
      const bool known =
          dimension == 0 ? geo_.points.contains(std::abs(entity)) : geo_.curves.contains(std::abs(entity));
      if (!known)
        return error_at(start, fmt::format("there is no {} {}", dimension == 0 ? "point" : "curve", std::abs(entity)));
      geo_.embedded.push_back({dimension, std::abs(entity)});
    }
    return expect(";");
  }

  // --- loops and branches
  // ---------------------------------------------------------------------------------------------
  struct Loop {
    std::size_t start;  ///< Token after the head.
    std::string variable;
    List values;
    std::size_t done = 1;
  };

  Result<void> begin_for(const GeoToken& start) {
    Loop loop;
    if (take("(")) {  // For (a : b : c)
      DOBRA_TRY_VOID(list_item(loop.values));
      DOBRA_TRY_VOID(expect(")"));
    } else {
      loop.variable = token().text;
      ++at_;
      DOBRA_TRY_VOID(expect("In"));
      DOBRA_TRY(loop.values, list());
    }
    loop.start = at_;
    if (loop.values.empty()) return error_at(start, "this For has no values");
    if (loops_.size() >= deepest) return error_at(start, "loops are nested too deeply");
    if (!loop.variable.empty()) variables_[loop.variable] = loop.values[0];
    loops_.push_back(std::move(loop));
    return {};
  }

  Result<void> end_for(const GeoToken& start) {
    if (loops_.empty()) return error_at(start, "this EndFor has no For");
    Loop& loop = loops_.back();
    if (loop.done == loop.values.size()) {
      loops_.pop_back();
      return {};
    }
    if (!loop.variable.empty()) variables_[loop.variable] = loop.values[loop.done];
    ++loop.done;
    at_ = loop.start;
    return {};
  }

  Result<double> condition() {
    DOBRA_TRY_VOID(expect("("));
    DOBRA_TRY(const double value, expression());
    DOBRA_TRY_VOID(expect(")"));
    return value;
  }

  Result<void> begin_if() {
    ++open_ifs_;
    DOBRA_TRY(double holds, condition());
    while (holds == 0.0) {
      DOBRA_TRY(const std::string stop, skip_branch());
      if (stop == "ElseIf") {
        DOBRA_TRY(holds, condition());
        continue;
      }
      if (stop == "EndIf") --open_ifs_;
      return {};
    }
    return {};
  }

  /// A branch that was carried out is over: the others are passed over.
  Result<void> end_branch(const GeoToken& start) {
    if (open_ifs_ == 0) return error_at(start, fmt::format("this {} has no If", start.text));
    std::string stop = start.text;
    while (stop != "EndIf") {
      DOBRA_TRY(stop, skip_branch());
    }
    --open_ifs_;
    return {};
  }

  /// Passes over statements to the Else, ElseIf or EndIf of this level, which is taken and returned.
  Result<std::string> skip_branch() {
    std::size_t level = 0;
    for (; token().kind != Kind::End; ++at_) {
      if (token().kind != Kind::Word) continue;
      const std::string word = token().text;
      if (word == "If") ++level;
      const bool ends = word == "EndIf" || (level == 0 && (word == "Else" || word == "ElseIf"));
      if (ends && level == 0) {
        ++at_;
        return word;
      }
      if (word == "EndIf") --level;
    }
    return error("an If has no EndIf");
  }

  // --- at the end
  // -----------------------------------------------------------------------------------------------------
  Result<void> check() const {
    if (geo_.curves.empty()) return error("the file holds no curve");
    for (std::size_t i = 0; i < geo_.groups.size(); ++i) {
      const GeoGroup& group = geo_.groups[i];
      for (const std::int64_t entity : group.entities) {
        const bool known = group.dimension == 0   ? geo_.points.contains(entity)
                           : group.dimension == 1 ? geo_.curves.contains(entity)
                                                  : geo_.surfaces.contains(entity);
        constexpr std::array names{"point", "curve", "surface"};
        if (!known)
          return error_at(group_places_[i], fmt::format("the physical group refers to {} {}, which does not exist",
                                                        names[static_cast<std::size_t>(group.dimension)], entity));
      }
    }
    return {};
  }

  std::vector<GeoToken> tokens_;
  std::string file_;
  std::size_t at_ = 0;
  double steps_ = 0.0;
  std::size_t depth_ = 0;
  GeoFile geo_;
  std::map<std::int64_t, std::vector<std::int64_t>> loop_curves_;
  std::map<std::string, double> variables_;
  std::map<std::string, List> lists_;
  std::vector<Loop> loops_;
  std::size_t open_ifs_ = 0;
  std::int64_t last_group_ = 0;
  std::vector<GeoToken> group_places_;
};

}  // namespace

Result<GeoFile> parse_geo(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  DOBRA_TRY(std::vector<GeoToken> tokens, geo_tokens(text, file));
  return Parser(std::move(tokens), file).run();
}

Result<GeoFile> read_geo(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_geo(text, path);
}

}  // namespace dobra::io
