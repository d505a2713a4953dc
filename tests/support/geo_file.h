#pragma once
// Contours of gmsh geometry files, as far as the corpus needs them: assignments, Point, Line, Circle (arcs below half a
// turn, drawn with chords) and Line Loop; every other statement is passed over. For tests only.

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "shared/geom/polyline.h"

namespace dobra::test {

class GeoFile {
 public:
  /// Closed contours, one a Line Loop, in file order; nothing if the file cannot be read or a statement makes no sense.
  static std::optional<std::vector<geom::Polyline>> contours(const std::string& path) {
    std::ifstream in(path);
    if (!in) return std::nullopt;
    std::string text;
    for (std::string line; std::getline(in, line);) text += line.substr(0, line.find("//")) + ' ';
    GeoFile file;
    std::istringstream statements(text);
    for (std::string statement; std::getline(statements, statement, ';');) {
      if (!file.run(statement)) return std::nullopt;
    }
    return file.loops_;
  }

 private:
  using Numbers = std::vector<double>;

  static std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
  }
  bool run(const std::string& raw) {
    const std::string statement = trimmed(raw);
    const auto equals = statement.find('=');
    if (statement.empty()) return true;
    if (equals == std::string::npos) return false;
    const std::string left = trimmed(statement.substr(0, equals));
    const std::string right = trimmed(statement.substr(equals + 1));
    const auto bracket = left.find('(');
    if (bracket == std::string::npos) {
      if (left.find_first_of(" {") != std::string::npos) return true;  // Characteristic Length and the like
      const auto value = expression(right);
      if (value) names_[left] = *value;
      return value.has_value();
    }
    const std::string what = trimmed(left.substr(0, bracket));
    if (what != "Point" && what != "Line" && what != "Circle" && what != "Line Loop") return true;
    const auto id = expression(left.substr(bracket + 1, left.size() - bracket - 2));
    const auto values = list(right);
    return id && values && add(what, static_cast<int>(*id), *values);
  }
  bool add(const std::string& what, int id, const Numbers& v) {
    if (what == "Point") {
      if (v.size() < 3) return false;
      points_[id] = {v[0], v[1]};
    } else if (what == "Line") {
      if (v.size() != 2 || !points_.contains(int(v[0])) || !points_.contains(int(v[1]))) return false;
      edges_[id] = {points_[int(v[0])], points_[int(v[1])]};
    } else if (what == "Circle") {
      if (v.size() != 3) return false;
      for (const double p : v) {
        if (!points_.contains(int(p))) return false;
      }
      edges_[id] = arc(points_[int(v[0])], points_[int(v[1])], points_[int(v[2])]);
    } else {
      return loop(v);
    }
    return true;
  }
  static std::vector<geom::Point> arc(geom::Point from, geom::Point centre, geom::Point to) {
    const geom::Vector u = from - centre;
    const geom::Vector v = to - centre;
    const double angle = std::atan2(geom::cross(u, v), geom::dot(u, v));
    const int parts = std::max(1, int(std::ceil(std::abs(angle) / (std::numbers::pi / 32))));
    std::vector<geom::Point> points{from};
    for (int k = 1; k < parts; ++k) {
      const double t = angle * k / parts;
      points.push_back(centre + (std::cos(t) * u + std::sin(t) * geom::left_of(u)));
    }
    points.push_back(to);
    return points;
  }
  bool loop(const Numbers& edges) {
    geom::Polyline contour{{}, true};
    for (const double e : edges) {
      if (!edges_.contains(std::abs(int(e)))) return false;
      std::vector<geom::Point> points = edges_[std::abs(int(e))];
      if (e < 0) std::reverse(points.begin(), points.end());
      if (!contour.points.empty() && contour.points.back() != points.front()) return false;
      contour.points.insert(contour.points.end(), points.begin() + (contour.points.empty() ? 0 : 1), points.end());
    }
    if (contour.points.size() < 4 || contour.points.front() != contour.points.back()) return false;
    contour.points.pop_back();
    loops_.push_back(std::move(contour));
    return true;
  }
  std::optional<Numbers> list(const std::string& text) {
    if (text.size() < 2 || text.front() != '{' || text.back() != '}') return std::nullopt;
    Numbers values;
    std::istringstream words(text.substr(1, text.size() - 2));
    for (std::string word; std::getline(words, word, ',');) {
      const auto value = expression(word);
      if (!value) return std::nullopt;
      values.push_back(*value);
    }
    return values;
  }

  // sum = product {+- product}; product = factor {*/ factor}; factor = number | name | -factor | (sum)
  std::optional<double> expression(const std::string& text) {
    at_ = text.c_str();
    const auto value = sum();
    return value && next() == '\0' ? value : std::nullopt;
  }
  char next() {
    while (std::isspace(static_cast<unsigned char>(*at_))) ++at_;
    return *at_;
  }
  std::optional<double> sum() {
    auto value = product();
    while (value && (next() == '+' || next() == '-')) {
      const char sign = *at_++;
      const auto other = product();
      if (!other) return std::nullopt;
      *value += sign == '+' ? *other : -*other;
    }
    return value;
  }
  std::optional<double> product() {
    auto value = factor();
    while (value && (next() == '*' || next() == '/')) {
      const char sign = *at_++;
      const auto other = factor();
      if (!other) return std::nullopt;
      *value = sign == '*' ? *value * *other : *value / *other;
    }
    return value;
  }
  std::optional<double> factor() {
    if (next() == '-') {
      ++at_;
      const auto value = factor();
      return value ? std::optional(-*value) : std::nullopt;
    }
    if (*at_ == '(') {
      ++at_;
      const auto value = sum();
      return value && next() == ')' ? (++at_, value) : std::nullopt;
    }
    if (std::isalpha(static_cast<unsigned char>(*at_))) {
      std::string name;
      while (std::isalnum(static_cast<unsigned char>(*at_)) || *at_ == '_') name += *at_++;
      return names_.contains(name) ? std::optional(names_[name]) : std::nullopt;
    }
    char* end = nullptr;
    const double value = std::strtod(at_, &end);
    if (end == at_) return std::nullopt;
    at_ = end;
    return value;
  }

  std::map<std::string, double> names_;
  std::map<int, geom::Point> points_;
  std::map<int, std::vector<geom::Point>> edges_;
  std::vector<geom::Polyline> loops_;
  const char* at_ = nullptr;
};

}  // namespace dobra::test
