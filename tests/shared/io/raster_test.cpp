#include "shared/io/raster.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/support/tiff.h"

namespace dobra::io {
namespace {

using test::tiff;

class Raster : public testing::Test {
 protected:
  Raster() {
    std::string pattern = (std::filesystem::temp_directory_path() / "dobra_raster_XXXXXX").string();
    root_ = mkdtemp(pattern.data());
  }
  ~Raster() override { std::filesystem::remove_all(root_); }
  [[nodiscard]] std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(root_ / name, std::ios::binary) << bytes;
    return (root_ / name).string();
  }
  std::filesystem::path root_;
};

const std::string four_pixels("\xFF\0\0\0\xFF\0\0\0\xFF\x10\x20\x30", 12);  // red, green; blue, dark

TEST_F(Raster, ColoursComeRowByRowFromTheTop) {
  const auto read = read_raster(put("a.tif", tiff(2, 2, 3, four_pixels)));
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->pixels.width, 2u);
  EXPECT_EQ(read->pixels.height, 2u);
  EXPECT_EQ(read->pixels.rgba,
            (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 16, 32, 48, 255}));
  EXPECT_FALSE(read->box);
}

TEST_F(Raster, GreyIsTheSameInEveryChannel) {
  const auto read = read_raster(put("a.tif", tiff(2, 1, 1, "\x40\x80")));
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->pixels.rgba, (std::vector<std::uint8_t>{64, 64, 64, 255, 128, 128, 128, 255}));
}

TEST_F(Raster, AWorldFileSaysWhereThePictureLies) {
  const std::string file = put("a.tif", tiff(2, 2, 3, four_pixels));
  (void)put("a.tfw", "50\n0\n0\n-25\n1025\n-112.5\n");  // middle of the upper left pixel
  const auto read = read_raster(file);
  ASSERT_TRUE(read) << to_string(read.error());
  ASSERT_TRUE(read->box);
  EXPECT_EQ(read->box->low, (geom::Point{1000, -150}));
  EXPECT_EQ(read->box->high, (geom::Point{1100, -100}));
  (void)put("a.tfw", "50\n3\n3\n-25\n1025\n-112.5\n");
  const auto turned = read_raster(file);
  ASSERT_FALSE(turned);
  EXPECT_NE(turned.error().message.find("turned"), std::string::npos);
}

TEST_F(Raster, ALargePictureIsReadCoarser) {
  const auto read = read_raster(put("a.tif", tiff(40, 20, 1, std::string(800, '\x55'))), {.most_pixels = 200});
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->pixels.width, 20u);
  EXPECT_EQ(read->pixels.height, 10u);
  EXPECT_EQ(read->pixels.rgba[0], 0x55);
}

TEST_F(Raster, WhatIsNoPictureIsRefusedWithTheFile) {
  const auto missing = read_raster((root_ / "none.png").string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, base::ErrorCode::FileNotFound);
  for (const std::string& bytes : {std::string("x,z\n0,0\n"), tiff(2, 2, 3, four_pixels).substr(0, 14)}) {
    const auto bad = read_raster(put("bad.tif", bytes));
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().code, base::ErrorCode::BadFormat);
    EXPECT_NE(to_string(bad.error()).find("bad.tif"), std::string::npos);
  }
}

}  // namespace
}  // namespace dobra::io
