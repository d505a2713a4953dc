#include "shared/base/shared.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dobra::base {
namespace {

using Words = Shared<std::vector<std::string>>;

TEST(Shared, CopiesAreOneListUntilOneIsChanged) {
  Words words{"a", "b"};
  Words copy = words;
  EXPECT_TRUE(copy.is(words));
  EXPECT_EQ(copy.data(), words.data());
  copy.push_back("c");
  EXPECT_FALSE(copy.is(words));
  EXPECT_EQ(words.get(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(copy.get(), (std::vector<std::string>{"a", "b", "c"}));
  // Alone, it changes in its place.
  const void* where = &copy.edit();
  copy.edit()[0] = "z";
  EXPECT_EQ(&copy.edit(), where);
  EXPECT_EQ(copy.front(), "z");
  EXPECT_EQ(words.front(), "a");
}

TEST(Shared, EqualListsAreEqualWithoutBeingOne) {
  EXPECT_EQ(Words({"a"}), Words({"a"}));
  EXPECT_FALSE(Words({"a"}).is(Words({"a"})));
  EXPECT_FALSE(Words({"a"}) == Words({"b"}));
  EXPECT_EQ(Words(), Words(std::vector<std::string>{}));
  EXPECT_TRUE(Words().empty());
  Words none;
  none.push_back("a");
  EXPECT_EQ(none, Words({"a"}));
}

}  // namespace
}  // namespace dobra::base
