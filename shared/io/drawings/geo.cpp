#include "shared/io/drawings/geo.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/base/text.h"
#include "shared/io/drawings/geo_expressions.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

// 1. The text becomes tokens (geo_tokens.h). 2. Statements are carried out as they come; For goes back, If leaps.
// 3. Expressions: geo_expressions.h. 4. At the end every tag that was used must be there.

namespace dobra::io::drawings {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

class Parser : private GeoExpressions {
 public:
  Parser(std::vector<GeoToken> tokens, std::string file) : GeoExpressions(std::move(tokens), std::move(file)) {}

  Result<GeoFile> run() {
    while (token().kind != Kind::End) DOBRA_TRY_VOID(statement());
    if (!loops_.empty()) return error_at(tokens_[loops_.back().start], "this For has no EndFor");
    if (open_ifs_ > 0) return error("an If has no EndIf");
    DOBRA_TRY_VOID(check());
    return std::move(geo_);
  }

 private:
  // --- statements
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
    if (word == "Function" || word == "Macro") return define(start);
    if (word == "Call") return call();
    if (word == "Return") return return_from(start);
    constexpr std::array ignored{"Transfinite", "Recombine", "SetFactory", "Coherence",         "Color",
                                 "Hide",        "Show",      "Printf",     "Geometry.Tolerance"};
    if (std::find(ignored.begin(), ignored.end(), word) != ignored.end() || word.starts_with("Mesh.") ||
        word.starts_with("General.") || word.starts_with("Geometry.")) {
      if (word == "SetFactory" && is("(") && token(1).text == "OpenCASCADE")
        return error_at(start,
                        "the OpenCASCADE kernel is not supported; use SetFactory(\"Built-in\") or export the mesh");
      return leave_out(start);
    }
    if (is("[") && !is("]", 1)) return assign_item(start);
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
                                       "Transfinite, variables, For, If, macros",
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

  /// "list[i] = value;": a list grows to hold it.
  Result<void> assign_item(const GeoToken& name) {
    DOBRA_TRY_VOID(expect("["));
    DOBRA_TRY(const double number, expression());
    DOBRA_TRY_VOID(expect("]"));
    const bool adds = is("+=");
    if (!take("+=")) DOBRA_TRY_VOID(expect("="));
    DOBRA_TRY(const double value, expression());
    constexpr double most = 1e6;
    if (!(number >= 0.0) || number >= most || number != std::floor(number))
      return error_at(name, "the number of an item of a list is a whole one from 0 on");
    auto& list = lists_[name.text];
    const auto i = static_cast<std::size_t>(number);
    if (i >= list.size()) DOBRA_TRY_VOID(spend(number));
    if (i >= list.size()) list.resize(i + 1, 0.0);
    list[i] = adds ? list[i] + value : value;
    if (!std::isfinite(list[i])) return error_at(name, "the item has no finite value");
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

  // --- macros
  struct Call {
    std::size_t back;  ///< Token behind it.
    std::size_t loops, ifs;
  };

  /// "Function name ... Return" or "Macro ...": carried out where it is called.
  Result<void> define(const GeoToken& start) {
    if (token().kind != Kind::Word && token().kind != Kind::Text)
      return error(fmt::format("the name of a macro is due here, not {}", found()));
    const std::string name = token().text;
    macros_[name] = ++at_;
    while (!is("Return") && token().kind != Kind::End) ++at_;
    if (!take("Return")) return error_at(start, fmt::format("this {} has no Return", start.text));
    return {};
  }

  Result<void> call() {
    const GeoToken name = token();
    ++at_;
    DOBRA_TRY_VOID(expect(";"));
    const auto macro = macros_.find(name.text);
    if (macro == macros_.end()) {
      std::vector<std::string> names;
      for (const auto& [own, begin] : macros_) names.push_back(own);
      return error_at(name,
                      fmt::format("there is no macro {}{}", shown(name.text), base::did_you_mean(name.text, names)));
    }
    if (calls_.size() >= deepest) return error_at(name, "macros call each other too deeply");
    calls_.push_back({at_, loops_.size(), open_ifs_});
    at_ = macro->second;
    return {};
  }

  Result<void> return_from(const GeoToken& start) {
    if (calls_.empty()) return error_at(start, "this Return has no Function or Macro");
    const Call own = calls_.back();
    if (loops_.size() < own.loops || open_ifs_ < own.ifs)
      return error_at(start, "this macro ends a For or an If that began outside it");
    at_ = own.back;
    loops_.erase(loops_.begin() + static_cast<std::ptrdiff_t>(own.loops), loops_.end());
    open_ifs_ = own.ifs;
    calls_.pop_back();
    return {};
  }

  // --- at the end
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

  std::map<std::string, std::size_t> macros_;  ///< First token of each.
  std::vector<Call> calls_;
  std::vector<Loop> loops_;
  std::size_t open_ifs_ = 0;
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

}  // namespace dobra::io::drawings
