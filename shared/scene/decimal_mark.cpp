#include "shared/scene/decimal_mark.h"

#include <atomic>
#include <cctype>

namespace dobra::scene {

namespace {

std::atomic<DecimalMark> current_mark{DecimalMark::Point};

}  // namespace

void set_decimal_mark(DecimalMark mark) { current_mark = mark; }
DecimalMark decimal_mark() { return current_mark; }

std::string with_decimal_mark(std::string text) {
  if (decimal_mark() == DecimalMark::Point) return text;
  const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(text[i])) != 0; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '.' && digit(i - 1) && digit(i + 1)) text[i] = ',';
  }
  return text;
}

}  // namespace dobra::scene
