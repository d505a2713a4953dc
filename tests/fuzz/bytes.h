#pragma once
// What a fuzz target makes its input from; 0 once the bytes are used up.

#include <cstddef>
#include <cstdint>
#include <cstring>

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
    unsigned char bits[sizeof(double)];
    for (unsigned char& b : bits) b = byte();
    double value = 0;
    std::memcpy(&value, bits, sizeof value);
    return value;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

}  // namespace dobra::fuzz
