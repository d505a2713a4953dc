#pragma once
// What a fuzz target makes its input from; 0 once the bytes are used up.

#include <bit>
#include <cstddef>
#include <cstdint>

namespace dobra::fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}
  [[nodiscard]] std::size_t left() const { return left_; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }
  int whole() { return static_cast<std::int8_t>(byte()); }
  double raw() {
    std::uint64_t bits = 0;
    for (int at = 0; at < 64; at += 8) bits |= std::uint64_t{byte()} << at;
    return std::bit_cast<double>(bits);
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

}  // namespace dobra::fuzz
