#include "shared/cli/remarks.h"

#include <gtest/gtest.h>

namespace dobra::cli {
namespace {

using Lines = std::vector<std::string>;

Lines stops(int count, const std::string& fault) {
  Lines lines;
  for (int i = 0; i < count; ++i) {
    lines.push_back("horizon 'A (" + std::to_string(i) + ")' stops " + std::to_string(17 * i) + " m short of fault '" +
                    fault + "' at (" + std::to_string(-1.5 * i) + ", 1e-05)");
  }
  return lines;
}

TEST(ShortenedRemarks, ManyOfOneKindAreThreeAndTheirNumber) {
  Lines remarks = stops(70, "F1");
  remarks.insert(remarks.begin() + 40, "balanced: the greatest change is 0.5 %");
  const Lines lines = shortened(remarks);
  ASSERT_EQ(lines.size(), 5U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(lines[i], remarks[i]);
  EXPECT_EQ(lines[3].rfind("... and 67 more like these", 0), 0U);
  EXPECT_EQ(lines[4], remarks[40]);
}

TEST(ShortenedRemarks, FaultsAreToldApartAndWhatIsFewIsWhole) {
  Lines remarks = stops(6, "F1");
  for (const std::string& line : stops(5, "F2")) remarks.push_back(line);
  remarks.push_back("fault 'F2' isn't crossed");
  const Lines lines = shortened(remarks);
  ASSERT_EQ(lines.size(), 4U + 5U + 1U);
  EXPECT_EQ(lines[3].rfind("... and 3 more", 0), 0U);
  EXPECT_EQ(Lines(lines.begin() + 4, lines.end()), Lines(remarks.begin() + 6, remarks.end()));
}

TEST(ShortenedRemarks, OtherWordsMakeAnotherKind) {
  const Lines remarks{"a 1", "b 1", "c 1", "d 1", "e 1", "f 1", "g 1", "it's 5", "5", ""};
  EXPECT_EQ(shortened(remarks), remarks);
}

}  // namespace
}  // namespace dobra::cli
