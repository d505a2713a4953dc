#include "shared/base/id.h"

#include <gtest/gtest.h>

#include <sstream>
#include <type_traits>
#include <unordered_set>

namespace dobra::base {
namespace {

struct VertexTag {
  static constexpr const char* prefix = "v";
};
struct FaceTag {
  static constexpr const char* prefix = "f";
};
using VertexId = Id<VertexTag>;
using FaceId = Id<FaceTag>;

static_assert(!std::is_convertible_v<std::size_t, VertexId>);
static_assert(!std::is_convertible_v<FaceId, VertexId>);
static_assert(!std::is_constructible_v<VertexId, FaceId>);

template <class T>
std::string text(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(Id, DefaultOneIsNone) {
  EXPECT_FALSE(VertexId().valid());
  EXPECT_TRUE(VertexId(0).valid());
  EXPECT_NE(VertexId(), VertexId(0));
  EXPECT_EQ(VertexId(), VertexId());
}

TEST(Id, PrintsItsKindAndIndex) {
  EXPECT_EQ(text(VertexId(12)), "v12");
  EXPECT_EQ(text(FaceId()), "fnone");
}

TEST(Id, IsOrderedByIndexWithNoneLastAndHashes) {
  EXPECT_LT(VertexId(1), VertexId(2));
  EXPECT_LT(VertexId(2), VertexId());
  const std::unordered_set<VertexId> ids{VertexId(1), VertexId(2), VertexId(1)};
  EXPECT_EQ(ids.size(), 2U);
}

}  // namespace
}  // namespace dobra::base
