#pragma once
// Pictures as pixels: PNG, JPEG and TIFF through GDAL, with the place that they say they have (GeoTIFF, or
// a world file beside them). Source: [gdal].

#include <optional>
#include <string>

#include "shared/base/result.h"
#include "shared/scene/layer.h"

namespace dobra::io::gis {

struct Raster {
  scene::Pixels pixels;
  /// What it covers, in the coordinates of the file; nothing if it does not say. The first row of pixels is at the
  /// greatest y, the first column at the least x, however the file has them.
  std::optional<geom::Box> box;
};

struct RasterOptions {
  enum class Place { AsTheFileSays, GivenByTheCaller };
  Place place = Place::AsTheFileSays;   ///< GivenByTheCaller: what the file says is not asked, rows stay as they are.
  std::size_t most_pixels = 4'000'000;  ///< A larger picture is read coarser.
};

/// Grey, palette and colour pictures, with transparency where they have it.
/// @error FileNotFound; BadFormat: no picture, not eight bits a channel, or turned against the axes.
base::Result<Raster> read_raster(const std::string& path, const RasterOptions& options = {});

/// The last row first.
void turn_upside_down(scene::Pixels& pixels);

}  // namespace dobra::io::gis
