#pragma once
// PNG files as numbers.

#include <cairo.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

namespace dobra::test {

struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> rgb;  ///< Row by row from the top, 0xRRGGBB.
  [[nodiscard]] std::array<double, 3> at(int x, int y) const {
    const std::uint32_t p =
        rgb.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {static_cast<double>(p >> 16U & 255U), static_cast<double>(p >> 8U & 255U), static_cast<double>(p & 255U)};
  }
};

inline Pixels read_png(const std::filesystem::path& path) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
      cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
  if (cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("not a PNG file: " + path.string());
  Pixels pixels{cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()), {}};
  const unsigned char* data = cairo_image_surface_get_data(image.get());
  for (int y = 0; y < pixels.height; ++y) {
    for (int x = 0; x < pixels.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, data + static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(image.get()) + 4 * x,
                  4);
      pixels.rgb.push_back(pixel & 0xFFFFFFU);
    }
  }
  return pixels;
}

/// Mean colours of columns x rows equal parts of an image, row by row.
inline std::vector<std::array<double, 3>> coarse(const Pixels& pixels, int columns, int rows) {
  std::vector<std::array<double, 3>> means;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      std::array<double, 3> sum{};
      int count = 0;
      for (int y = row * pixels.height / rows; y < (row + 1) * pixels.height / rows; ++y) {
        for (int x = column * pixels.width / columns; x < (column + 1) * pixels.width / columns; ++x, ++count) {
          const std::array<double, 3> pixel = pixels.at(x, y);
          for (std::size_t k = 0; k < 3; ++k) sum[k] += pixel[k];
        }
      }
      for (double& value : sum) value /= count;
      means.push_back(sum);
    }
  }
  return means;
}

/// A folder of its own for one test, gone afterwards.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dobra_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

}  // namespace dobra::test
