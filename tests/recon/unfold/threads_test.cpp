// Built into threads_test too, for ThreadSanitizer.

#include <gtest/gtest.h>

#include "recon/unfold/restore.h"
#include "recon/unfold/target.h"
#include "shared/base/parallel.h"
#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

/// On a flat target.
std::vector<Restoration> with_threads(const section::Section& section, const GridParams& grid, RestoreMethod method,
                                      std::initializer_list<std::size_t> numbers) {
  RestoreParams how;
  how.method = method;
  std::vector<Restoration> runs;
  for (const std::size_t threads : numbers) {
    base::set_thread_count(threads);
    const auto source = make_source_grid(section, grid, {});
    const auto target = make_target(section, source.value(), {}, {}, {});
    runs.push_back(restore(section, source.value(), target.value(), how, {}).value());
  }
  base::set_thread_count(0);
  return runs;
}

TEST(Restore, TheSameBytesComeOutAtAnyNumberOfThreads) {
  const geom::Polyline top = test::cosine();
  const section::Section section = test::section_of({top, test::parallel(top, 0.3), {{{0, -3}, {12, -2.5}}, false}});
  GridParams grid;
  grid.count = 5;
  grid.distance = 0.2;
  const auto runs = with_threads(section, grid, RestoreMethod::Constant, {1, 4});
  for (std::size_t h = 0; h < 3; ++h) EXPECT_EQ(runs[0].lines[h].after, runs[1].lines[h].after);
}

TEST(Methods, TheSameBytesComeOutOfEveryMethodAtAnyNumberOfThreads) {
  const section::Section section = test::random_section(9);
  GridParams grid;
  grid.count = 1;
  for (const RestoreMethod method : {RestoreMethod::Constant, RestoreMethod::Variable, RestoreMethod::Proportional,
                                     RestoreMethod::Flexural, RestoreMethod::Shear, RestoreMethod::LineLength}) {
    const auto runs = with_threads(section, grid, method, {1, 3});
    for (std::size_t i = 0; i < runs[0].lines.size(); ++i) EXPECT_EQ(runs[0].lines[i].after, runs[1].lines[i].after);
    EXPECT_EQ(runs[0].ledger.field.values, runs[1].ledger.field.values);
  }
}

}  // namespace
}  // namespace recon::unfold
