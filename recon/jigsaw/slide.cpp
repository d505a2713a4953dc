#include "recon/jigsaw/slide.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "shared/base/disjoint_sets.h"

namespace recon::jigsaw {

namespace {

base::Result<void> refuse_unreached(const std::vector<std::string>& names, std::size_t pinned,
                                    const std::vector<Tie>& ties) {
  base::DisjointSets sets(names.size());
  for (const Tie& tie : ties) sets.join(tie.left, tie.right);
  std::vector<std::string> unreached;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (sets.root(i) != sets.root(pinned)) unreached.push_back(fmt::format("'{}'", names[i]));
  }
  if (unreached.empty()) return {};
  return base::Error{base::ErrorCode::CannotRestore,
                     fmt::format("no fault whose walls meet after unfolding joins {} to '{}', which is pinned, so that "
                                 "nothing says where to slide; extend the faults between them, take the other fit, or "
                                 "restore the block on its own (block)",
                                 fmt::join(unreached, ", "), names[pinned]),
                     base::Place{.item = "blocks"}};
}

}  // namespace

std::vector<double> solve_positive(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= i == j ? std::sqrt(a[i][j]) : a[j][j];
      if (i == j) a[j][j] = a[i][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

base::Result<std::vector<double>> slide(const std::vector<std::string>& names, std::size_t pinned,
                                        const std::vector<Tie>& ties) {
  DOBRA_TRY_VOID(refuse_unreached(names, pinned, ties));
  const std::size_t n = names.size() - 1;
  const auto row = [&](std::size_t block) { return block < pinned ? block : block - 1; };
  std::vector<std::vector<double>> a(n, std::vector<double>(n, 0.0));
  std::vector<double> b(n, 0.0);
  for (const Tie& tie : ties) {
    if (tie.left == tie.right) continue;
    for (const auto& [block, sign] : {std::pair(tie.right, 1.0), {tie.left, -1.0}}) {
      if (block == pinned) continue;
      a[row(block)][row(block)] += tie.weight;
      b[row(block)] += sign * tie.weight * tie.apart;
    }
    if (tie.left == pinned || tie.right == pinned) continue;
    a[row(tie.left)][row(tie.right)] -= tie.weight;
    a[row(tie.right)][row(tie.left)] -= tie.weight;
  }
  std::vector<double> shifts = solve_positive(std::move(a), std::move(b));
  shifts.insert(shifts.begin() + static_cast<std::ptrdiff_t>(pinned), 0.0);
  return shifts;
}

}  // namespace recon::jigsaw
