#include "shared/io/drawings/svg_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/io/scan.h"

namespace dobra::io::drawings {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Vector;

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_relative(char command) { return command >= 'a' && command <= 'z'; }
char upper(char command) { return is_relative(command) ? static_cast<char>(command - 'a' + 'A') : command; }

}  // namespace

bool SvgScanner::at_end() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  return at_ == text_.size();
}

void SvgScanner::skip_comma() {
  if (!at_end() && text_[at_] == ',') ++at_;
}

bool SvgScanner::take(char c) {
  if (at_end() || text_[at_] != c) return false;
  ++at_;
  return true;
}

bool SvgScanner::at_number() {
  if (at_end()) return false;
  const char c = text_[at_];
  return is_digit(c) || c == '+' || c == '-' || c == '.';
}

Result<double> SvgScanner::number() {
  const bool ended = at_end();
  const std::size_t begin = at_;
  const auto pass = [&](auto accepts) {
    while (at_ < text_.size() && accepts(text_[at_])) ++at_;
  };
  if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
  pass(is_digit);
  if (at_ < text_.size() && text_[at_] == '.') {
    ++at_;
    pass(is_digit);
  }
  if (at_ + 1 < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
    const std::size_t sign = text_[at_ + 1] == '+' || text_[at_ + 1] == '-' ? 2 : 1;
    if (at_ + sign < text_.size() && is_digit(text_[at_ + sign])) {
      at_ += sign;
      pass(is_digit);
    }
  }
  std::string_view word = text_.substr(begin, at_ - begin);
  if (word.empty()) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("a number is due here, not {}", ended ? "the end" : shown(text_.substr(begin, 8)))};
  }
  if (word.front() == '+') word.remove_prefix(1);
  std::string digits(word);
  // ".5" and "5." are numbers of SVG.
  if (const auto dot = digits.find('.'); dot != std::string::npos) {
    if (dot + 1 == digits.size() || !is_digit(digits[dot + 1])) digits.insert(dot + 1, "0");
    if (dot == 0 || !is_digit(digits[dot - 1])) digits.insert(dot, "0");
  }
  DOBRA_TRY(const double value, finite_number(digits, "the number"));
  skip_comma();
  return value;
}

Result<double> SvgScanner::flag() {
  if (at_end() || (text_[at_] != '0' && text_[at_] != '1')) {
    return Error{ErrorCode::BadFormat, "a flag of an arc is 0 or 1"};
  }
  const double value = text_[at_++] == '1' ? 1.0 : 0.0;
  skip_comma();
  return value;
}

namespace {

/// Notation: the current point is `at_`; `handle_` is the last control point, for S and T.
class PathReader {
 public:
  explicit PathReader(std::string_view data) : scan_(data) {}

  Result<std::vector<SvgPath>> run() {
    char command = 0;
    while (!scan_.at_end()) {
      if (!scan_.at_number()) {
        command = scan_.take();
        if (command == 'Z' || command == 'z') {
          if (current_.pieces.empty() && !moved_) return wrong("Z closes nothing");
          close();
          command = 0;
          continue;
        }
      } else if (command == 0) {
        return wrong("a command is due here, not a number");
      } else if (command == 'M' || command == 'm') {
        command = command == 'M' ? 'L' : 'l';  // Further pairs are lines.
      }
      DOBRA_TRY_VOID(carry_out(command));
    }
    finish();
    return std::move(paths_);
  }

 private:
  static Error wrong(std::string message) { return {ErrorCode::BadFormat, std::move(message)}; }

  Result<Point> pair(char command) {
    DOBRA_TRY(const double x, scan_.number());
    DOBRA_TRY(const double y, scan_.number());
    return is_relative(command) ? at_ + Vector{x, y} : Point{x, y};
  }

  Result<void> carry_out(char command) {
    const char what = upper(command);
    if (what != 'M' && !moved_) return wrong("a path begins with M");
    const char before = std::exchange(last_, what);
    switch (what) {
      case 'M': {
        DOBRA_TRY(const Point p, pair(command));
        finish();
        moved_ = true;
        start_ = at_ = p;
        return {};
      }
      case 'L': {
        DOBRA_TRY(const Point p, pair(command));
        line(p);
        return {};
      }
      case 'H':
      case 'V': {
        DOBRA_TRY(const double value, scan_.number());
        const Point base = is_relative(command) ? at_ : Point{};
        line(what == 'H' ? Point{base.x + value, at_.y} : Point{at_.x, base.y + value});
        return {};
      }
      case 'C':
      case 'S': {
        const bool smooth = before == 'C' || before == 'S';
        Point first = smooth ? at_ + (at_ - handle_) : at_;
        if (what == 'C') {
          DOBRA_TRY(first, pair(command));
        }
        DOBRA_TRY(const Point second, pair(command));
        DOBRA_TRY(const Point to, pair(command));
        cubic(first, second, to, second);
        return {};
      }
      case 'Q':
      case 'T': {
        Point control = before == 'Q' || before == 'T' ? at_ + (at_ - handle_) : at_;
        if (what == 'Q') {
          DOBRA_TRY(control, pair(command));
        }
        DOBRA_TRY(const Point to, pair(command));
        cubic(geom::interpolate(at_, control, 2.0 / 3.0), geom::interpolate(to, control, 2.0 / 3.0), to, control);
        return {};
      }
      case 'A':
        return arc(command);
      default:
        return wrong(fmt::format("there is no path command {}", shown(std::string(1, command))));
    }
  }

  void add(SvgPiece piece) {
    piece.from = at_;
    current_.pieces.push_back(piece);
    at_ = piece.to;
  }
  void line(Point to) {
    if (to == at_) return;
    SvgPiece piece;
    piece.to = to;
    add(piece);
  }
  void cubic(Point first, Point second, Point to, Point handle) {
    SvgPiece piece;
    piece.kind = SvgPieceKind::Cubic;
    piece.control = {first, second};
    piece.to = to;
    if (to != at_ || first != at_ || second != at_) add(piece);
    handle_ = handle;
  }

  /// From ends and radii to the centre: appendix F.6 of the standard.
  Result<void> arc(char command) {
    DOBRA_TRY(double rx, scan_.number());
    DOBRA_TRY(double ry, scan_.number());
    DOBRA_TRY(const double degrees, scan_.number());
    DOBRA_TRY(const double large, scan_.flag());
    DOBRA_TRY(const double clockwise, scan_.flag());
    DOBRA_TRY(const Point to, pair(command));
    rx = std::abs(rx);
    ry = std::abs(ry);
    if (rx == 0.0 || ry == 0.0 || to == at_) {
      line(to);
      return {};
    }
    const double turn = degrees * std::numbers::pi / 180.0;
    const Vector along{std::cos(turn), std::sin(turn)};
    const Vector across = geom::left_of(along);
    const Vector half = 0.5 * (at_ - to);
    double x = geom::dot(half, along) / rx;
    double y = geom::dot(half, across) / ry;
    const double reach = std::hypot(x, y);
    if (!std::isfinite(reach) || reach == 0.0) return wrong("the radii of this arc are too small or too large");
    if (reach > 1.0) {  // No ellipse of this size passes both ends: the least one that does.
      rx *= reach;
      ry *= reach;
      x /= reach;
      y /= reach;
    }
    const double away = std::sqrt(std::max(0.0, 1.0 / (x * x + y * y) - 1.0)) * (large == clockwise ? -1.0 : 1.0);
    SvgPiece piece;
    piece.kind = SvgPieceKind::Arc;
    piece.to = to;
    piece.u = rx * along;
    piece.v = ry * across;
    const double cx = away * y;
    const double cy = -away * x;
    piece.centre = geom::midpoint(at_, to) + cx * piece.u + cy * piece.v;
    piece.start = std::atan2(y - cy, x - cx);
    piece.sweep = std::atan2(-y - cy, -x - cx) - piece.start;
    if (clockwise != 0.0 && piece.sweep < 0.0) piece.sweep += 2.0 * std::numbers::pi;
    if (clockwise == 0.0 && piece.sweep > 0.0) piece.sweep -= 2.0 * std::numbers::pi;
    add(piece);
    return {};
  }

  void close() {
    line(start_);
    current_.closed = true;
    finish();
    at_ = start_;
    last_ = 'Z';
  }
  void finish() {
    if (!current_.pieces.empty()) {
      current_.closed = current_.closed || current_.pieces.front().from == current_.pieces.back().to;
      paths_.push_back(std::move(current_));
    }
    current_ = {};
  }

  SvgScanner scan_;
  std::vector<SvgPath> paths_;
  SvgPath current_;
  Point start_;
  Point at_;
  Point handle_;
  char last_ = 0;
  bool moved_ = false;
};

}  // namespace

Result<std::vector<SvgPath>> svg_subpaths(std::string_view data) { return PathReader(data).run(); }

}  // namespace dobra::io::drawings
