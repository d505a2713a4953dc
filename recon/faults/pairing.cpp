#include "recon/faults/pairing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon::faults {

namespace {

/// For each of `fewer` its partner among `more`: rising, with the least sum of costs.
template <class Cost>
std::vector<std::size_t> cheapest(std::size_t fewer, std::size_t more, const Cost& cost) {
  const std::size_t spare = more - fewer;  // the i-th has its partner among i .. i + spare
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> least(fewer + 1, std::vector<double>(spare + 1, nowhere));
  least[0].assign(spare + 1, 0.0);  // least[i][k]: the first i, their partners among the first i + k
  for (std::size_t i = 1; i <= fewer; ++i) {
    for (std::size_t k = 0; k <= spare; ++k) {
      const double taken = least[i - 1][k] + cost(i - 1, i - 1 + k);
      least[i][k] = k > 0 ? std::min(taken, least[i][k - 1]) : taken;
    }
  }
  std::vector<std::size_t> partners(fewer);
  for (std::size_t i = fewer, k = spare; i > 0; --i) {
    while (k > 0 && least[i][k - 1] <= least[i][k] * (1.0 + 1e-9)) --k;  // of equally good ones the upper
    partners[i - 1] = i - 1 + k;
  }
  return partners;
}

}  // namespace

void ExpectedSeparation::learn_from(const WallCutoffs& walls) {
  if (walls.hanging.size() != 1 || walls.foot.size() != 1 || walls.hanging.front().passes) return;
  known_.emplace_back(walls.hanging.front().arc, walls.foot.front().arc - walls.hanging.front().arc);
}

double ExpectedSeparation::at(double arc) const {
  const auto nearer = [&](const auto& a, const auto& b) { return std::abs(a.first - arc) < std::abs(b.first - arc); };
  const auto nearest = std::min_element(known_.begin(), known_.end(), nearer);
  return nearest == known_.end() ? 0.0 : nearest->second;
}

std::vector<Partners> partners_of(const WallCutoffs& walls, const ExpectedSeparation& expected) {
  std::vector<Partners> partners;
  std::vector<Cutoff> hanging = walls.hanging, foot = walls.foot;
  std::erase_if(hanging, [&](const Cutoff& h) {
    const auto same = [&](const Cutoff& f) { return f.passes && f.piece == h.piece && f.at == h.at; };
    const auto at = h.passes ? std::find_if(foot.begin(), foot.end(), same) : foot.end();
    if (at == foot.end()) return false;
    partners.emplace_back(h, *at);
    foot.erase(at);
    return true;
  });
  const bool hanging_fewer = hanging.size() <= foot.size();
  const std::vector<Cutoff>& few = hanging_fewer ? hanging : foot;
  const std::vector<Cutoff>& many = hanging_fewer ? foot : hanging;
  const auto cost = [&](std::size_t i, std::size_t j) {
    const Cutoff& h = hanging_fewer ? few[i] : many[j];
    const Cutoff& f = hanging_fewer ? many[j] : few[i];
    return std::abs(f.arc - h.arc - expected.at(h.arc));
  };
  const auto add = [&](std::optional<Cutoff> from_few, std::optional<Cutoff> from_many) {
    if (hanging_fewer) {
      partners.emplace_back(std::move(from_few), std::move(from_many));
    } else {
      partners.emplace_back(std::move(from_many), std::move(from_few));
    }
  };
  const std::vector<std::size_t> taken = cheapest(few.size(), many.size(), cost);
  for (std::size_t i = 0; i < few.size(); ++i) add(few[i], many[taken[i]]);
  for (std::size_t j = 0; j < many.size(); ++j) {
    if (!std::binary_search(taken.begin(), taken.end(), j)) add(std::nullopt, many[j]);
  }
  return partners;
}

}  // namespace recon::faults
