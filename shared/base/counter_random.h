#pragma once
// Random numbers as a function of (seed, where): no state, so that every draw of a parallel run is the same at any
// number of threads. Philox 4x32 with 10 rounds. Source: [salmon2011philox]

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace dobra::base {

using Counter = std::array<std::uint32_t, 4>;

/// Four independent words of 32 random bits for each counter.
inline Counter philox(Counter counter, std::uint64_t seed) {
  std::uint32_t key0 = static_cast<std::uint32_t>(seed);
  std::uint32_t key1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53U} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57U} * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key0, static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key1, static_cast<std::uint32_t>(a)};
    key0 += 0x9E3779B9U;
    key1 += 0xBB67AE85U;
  }
  return counter;
}

/// Two independent normal deviates of mean 0 and deviation 1 (Box, Muller).
inline std::array<double, 2> normal_pair(Counter counter, std::uint64_t seed) {
  const Counter bits = philox(counter, seed);
  const auto fraction = [](std::uint32_t high, std::uint32_t low) {  // in (0, 1)
    return (static_cast<double>((std::uint64_t{high} << 21) ^ (low >> 11)) + 0.5) * 0x1p-53;
  };
  const double radius = std::sqrt(-2.0 * std::log(fraction(bits[0], bits[1])));
  const double angle = 2.0 * std::numbers::pi * fraction(bits[2], bits[3]);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace dobra::base
