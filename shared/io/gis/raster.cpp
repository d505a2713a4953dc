#include "shared/io/gis/raster.h"

#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>

#include "shared/io/file.h"
#include "shared/io/gis/gdal.h"

namespace dobra::io::gis {
namespace {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

void register_raster_drivers() {
  static std::once_flag registered;
  std::call_once(registered, [] {
    GDALRegister_GTiff();
    GDALRegister_PNG();
    GDALRegister_JPEG();
  });
}

struct Close {
  void operator()(GDALDataset* data) const { GDALClose(data); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

Error bad(const std::string& path, std::string message) {
  return {ErrorCode::BadFormat, std::move(message), Place{.file = path}};
}

/// Where a channel of the picture (0 red, 1 green, 2 blue, 3 alpha) comes from: a band, from 1; 0: none.
int band_of(GDALDataset& data, int channel) {
  const int count = data.GetRasterCount();
  static constexpr GDALColorInterp wanted[] = {GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand};
  for (int band = 1; band <= count; ++band) {
    if (data.GetRasterBand(band)->GetColorInterpretation() == wanted[channel]) return band;
  }
  if (channel == 3) return 0;
  return count >= 3 ? channel + 1 : 1;
}

Result<void> read_channel(GDALDataset& data, const std::string& path, int channel, scene::Pixels& pixels) {
  const int band = band_of(data, channel);
  if (band == 0) return {};
  const auto width = static_cast<int>(pixels.width);
  const auto height = static_cast<int>(pixels.height);
  // Every fourth byte, beginning with the channel's.
  const CPLErr read = data.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, data.GetRasterXSize(), data.GetRasterYSize(),
                                                         pixels.rgba.data() + channel, width, height, GDT_Byte, 4,
                                                         static_cast<GSpacing>(4) * width, nullptr);
  if (read != CE_None) return bad(path, "the picture could not be read to its end; save it again");
  return {};
}

void apply_palette(const GDALColorTable& palette, scene::Pixels& pixels) {
  for (std::size_t i = 0; i < pixels.rgba.size(); i += 4) {
    const GDALColorEntry* entry = palette.GetColorEntry(pixels.rgba[i]);
    if (entry == nullptr) continue;
    pixels.rgba[i] = static_cast<std::uint8_t>(entry->c1);
    pixels.rgba[i + 1] = static_cast<std::uint8_t>(entry->c2);
    pixels.rgba[i + 2] = static_cast<std::uint8_t>(entry->c3);
    pixels.rgba[i + 3] = static_cast<std::uint8_t>(entry->c4);
  }
}

void mirror(scene::Pixels& pixels) {
  for (std::size_t row = 0; row < pixels.height; ++row) {
    for (std::size_t left = 0, right = pixels.width - 1; left < right; ++left, --right) {
      const auto pixel = [&](std::size_t column) { return pixels.rgba.begin() + 4 * (row * pixels.width + column); };
      std::swap_ranges(pixel(left), pixel(left) + 4, pixel(right));
    }
  }
}

/// Reads where the picture lies, and brings its pixels into the order of the axes.
Result<void> place(GDALDataset& data, const std::string& path, Raster& raster) {
  double t[6];
  if (data.GetGeoTransform(t) != CE_None) {
    if (data.GetGCPCount() == 0) return {};
    return bad(path,
               fmt::format("the picture is tied to the ground by {} control points only; rectify it first, or give "
                           "its corners and leave the control points out",
                           data.GetGCPCount()));
  }
  if (t[2] != 0.0 || t[4] != 0.0) {
    return bad(path, "the picture is turned against the axes of the section; turn it upright first");
  }
  const geom::Point corner{t[0], t[3]};
  const geom::Point opposite{t[0] + t[1] * data.GetRasterXSize(), t[3] + t[5] * data.GetRasterYSize()};
  if (!geom::is_finite(corner) || !geom::is_finite(opposite) || corner.x == opposite.x || corner.y == opposite.y) {
    return bad(path, "the place that the picture gives has no extent; give its corners");
  }
  raster.box.emplace();
  raster.box->add(corner);
  raster.box->add(opposite);
  if (t[5] > 0.0) turn_upside_down(raster.pixels);
  if (t[1] < 0.0) mirror(raster.pixels);
  return {};
}

}  // namespace

Result<Raster> read_raster(const std::string& path, const RasterOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return Error{ErrorCode::FileNotFound, "there is no such file; check the name", Place{.file = path}};
  }
  register_raster_drivers();
  const GdalMessages messages;
  const Dataset data(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
  if (!data || data->GetRasterCount() == 0) {
    return bad(path, "this is no picture that can be read; give a PNG, JPEG or TIFF");
  }
  for (int band = 1; band <= data->GetRasterCount(); ++band) {
    if (data->GetRasterBand(band)->GetRasterDataType() != GDT_Byte) {
      return bad(path, "the picture has not eight bits a channel; save it as an ordinary PNG, JPEG or TIFF");
    }
  }
  const double size = static_cast<double>(data->GetRasterXSize()) * data->GetRasterYSize();
  const double coarser = std::max(1.0, std::sqrt(size / static_cast<double>(options.most_pixels)));
  Raster raster;
  scene::Pixels& pixels = raster.pixels;
  pixels.width = static_cast<std::size_t>(std::max(1.0, std::floor(data->GetRasterXSize() / coarser)));
  pixels.height = static_cast<std::size_t>(std::max(1.0, std::floor(data->GetRasterYSize() / coarser)));
  pixels.rgba.assign(4 * pixels.width * pixels.height, 255);
  for (int channel = 0; channel < 4; ++channel) DOBRA_TRY_VOID(read_channel(*data, path, channel, pixels));
  if (const GDALColorTable* palette = data->GetRasterBand(1)->GetColorTable()) apply_palette(*palette, pixels);
  if (options.place == RasterOptions::Place::AsTheFileSays) DOBRA_TRY_VOID(place(*data, path, raster));
  return raster;
}

void turn_upside_down(scene::Pixels& pixels) {
  const std::size_t width = 4 * pixels.width;
  for (std::size_t row = 0; row < pixels.height / 2; ++row) {
    const auto upper = pixels.rgba.begin() + row * width;
    std::swap_ranges(upper, upper + width, pixels.rgba.end() - (row + 1) * width);
  }
}

}  // namespace dobra::io::gis
