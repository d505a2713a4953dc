#include "shared/base/error.h"

#include <gtest/gtest.h>

namespace dobra::base {
namespace {

TEST(Error, TextHoldsThePartsThatAreKnown) {
  EXPECT_EQ(to_string({ErrorCode::BadValue, "wrong"}), "wrong");
  Place place;
  place.file = "a.toml";
  EXPECT_EQ(to_string({ErrorCode::BadValue, "wrong", place}), "a.toml: wrong");
  place.line = 3;
  EXPECT_EQ(to_string({ErrorCode::BadValue, "wrong", place}), "a.toml:3: wrong");
  place.column = 7;
  place.item = "step 2";
  EXPECT_EQ(to_string({ErrorCode::BadValue, "wrong", place}), "a.toml:3:7: step 2: wrong");
  place.x = 1.5;
  EXPECT_EQ(to_string({ErrorCode::BadValue, "wrong", place}), "a.toml:3:7: step 2: wrong");  // half a point is none
  place.y = -2;
  EXPECT_EQ(to_string({ErrorCode::BadValue, "wrong", place}), "a.toml:3:7: step 2: wrong (at 1.5, -2)");
}

TEST(Error, ExitCodesTellUsageInputAndComputationApart) {
  EXPECT_EQ(exit_code(ErrorCode::Cancelled), 130);
  EXPECT_EQ(exit_code(ErrorCode::BadUsage), 2);
  for (const ErrorCode code :
       {ErrorCode::NotFinite, ErrorCode::DegenerateCurve, ErrorCode::InvalidOption, ErrorCode::FileNotFound,
        ErrorCode::BadFormat, ErrorCode::BadSyntax, ErrorCode::UnknownKey, ErrorCode::BadSection, ErrorCode::BadDomain,
        ErrorCode::SelfIntersection, ErrorCode::OutsideDomain}) {
    EXPECT_EQ(exit_code(code), 3) << static_cast<int>(code);
  }
  for (const ErrorCode code :
       {ErrorCode::CannotInsert, ErrorCode::OffsetFailed, ErrorCode::CannotMesh, ErrorCode::TooManyElements,
        ErrorCode::CannotDraw, ErrorCode::CannotWrite, ErrorCode::CannotRestore}) {
    EXPECT_EQ(exit_code(code), 4) << static_cast<int>(code);
  }
}

TEST(Error, LocatedFillsOnlyWhatIsUnknown) {
  Place outer;
  outer.file = "a.toml";
  outer.line = 3;
  outer.item = "step 2";
  outer.x = 1;
  outer.y = 1;
  EXPECT_EQ(located({ErrorCode::BadValue, "wrong"}, outer).place->item, "step 2");
  Place inner;
  inner.item = "horizon 'top'";
  inner.x = 5;
  inner.y = 6;
  const Error error = located({ErrorCode::BadValue, "wrong", inner}, outer);
  EXPECT_EQ(to_string(error), "a.toml:3: horizon 'top': wrong (at 5, 6)");
  Place other_file;
  other_file.file = "b.dxf";
  const Error kept = located({ErrorCode::BadValue, "wrong", other_file}, outer);
  EXPECT_EQ(kept.place->file, "b.dxf");
  EXPECT_EQ(kept.place->line, 0U);  // the line of another file would be wrong
}

}  // namespace
}  // namespace dobra::base
