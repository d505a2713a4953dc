#include "shared/io/gis/raster.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "tests/support/tiff.h"

namespace dobra::io::gis {
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

/// A GeoTIFF of 4 x 3 grey pixels, 10, 20, ... row by row, written by GDAL itself.
struct GeoTiff {
  std::array<double, 6> transform = {1000, 50, 0, -100, 0, -25};
  bool tie_points = false;  ///< Three ground control points instead of the transform.
  const char* pixel_is = "Area";
};

void write(const std::string& path, const GeoTiff& wanted) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  ASSERT_NE(driver, nullptr);
  GDALDataset* data = driver->Create(path.c_str(), 4, 3, 1, GDT_Byte, nullptr);
  ASSERT_NE(data, nullptr);
  data->SetMetadataItem("AREA_OR_POINT", wanted.pixel_is);
  std::array<double, 6> transform = wanted.transform;
  std::array<GDAL_GCP, 3> points{};
  if (wanted.tie_points) {
    GDALInitGCPs(3, points.data());
    const double pixels[3][2] = {{0, 0}, {4, 0}, {0, 3}};
    for (std::size_t i = 0; i < 3; ++i) {
      points[i].dfGCPPixel = pixels[i][0];
      points[i].dfGCPLine = pixels[i][1];
      points[i].dfGCPX = 1000 + 50 * pixels[i][0] + static_cast<double>(i);
      points[i].dfGCPY = -100 - 25 * pixels[i][1];
    }
    EXPECT_EQ(data->SetGCPs(3, points.data(), ""), CE_None);
    GDALDeinitGCPs(3, points.data());
  } else {
    EXPECT_EQ(data->SetGeoTransform(transform.data()), CE_None);
  }
  std::array<std::uint8_t, 12> pixels{};
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(10 * (i + 1));
  EXPECT_EQ(data->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 4, 3, pixels.data(), 4, 3, GDT_Byte, 0, 0, nullptr),
            CE_None);
  GDALClose(data);
}

TEST_F(Raster, TheTagsOfAGeoTiffSayWhereItLies) {
  const std::string file = (root_ / "geo.tif").string();
  for (const char* pixel_is : {"Area", "Point"}) {  // the tags differ by half a pixel, the place does not
    write(file, {.pixel_is = pixel_is});
    EXPECT_FALSE(std::filesystem::exists(root_ / "geo.tfw"));
    const auto read = read_raster(file);
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_TRUE(read->box);
    EXPECT_EQ(read->box->low, (geom::Point{1000, -175})) << pixel_is;
    EXPECT_EQ(read->box->high, (geom::Point{1200, -100})) << pixel_is;
    EXPECT_EQ(read->pixels.rgba[0], 10);
  }
}

TEST_F(Raster, RowsFromTheBottomAndColumnsFromTheRightComeInTheOrderOfTheAxes) {
  const std::string file = (root_ / "geo.tif").string();
  write(file, {.transform = {1200, -50, 0, -175, 0, 25}});
  const auto read = read_raster(file);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->box->low, (geom::Point{1000, -175}));
  EXPECT_EQ(read->box->high, (geom::Point{1200, -100}));
  EXPECT_EQ(read->pixels.rgba[0], 120);  // both: turned by half a turn
  EXPECT_EQ(read->pixels.rgba[4 * 11], 10);
  write(file, {.transform = {1000, 50, 0, -175, 0, 25}});
  EXPECT_EQ(read_raster(file)->pixels.rgba[0], 90);
}

TEST_F(Raster, AGeoTiffThatIsTurnedOrHasControlPointsOnlyIsRefused) {
  const std::string file = (root_ / "geo.tif").string();
  write(file, {.transform = {1000, 50, 5, -100, 5, -25}});
  const auto turned = read_raster(file);
  ASSERT_FALSE(turned);
  EXPECT_EQ(turned.error().code, base::ErrorCode::BadFormat);
  EXPECT_NE(to_string(turned.error()).find("geo.tif"), std::string::npos);
  EXPECT_NE(turned.error().message.find("turn it upright first"), std::string::npos);
  write(file, {.tie_points = true});
  const auto tied = read_raster(file);
  ASSERT_FALSE(tied);
  EXPECT_NE(tied.error().message.find("3 control points only; rectify it first"), std::string::npos);
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
}  // namespace dobra::io::gis
