#include "shared/cli/pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "shared/base/text.h"
#include "shared/render/cairo.h"
#include "shared/render/space_file.h"
#include "shared/render/vtk_offscreen.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;

const std::array<std::string, 5> kind_names = {"svg", "pdf", "png", "vtk", "none"};

constexpr const char* vtk_ending = ".png";

}  // namespace

base::Result<std::set<PictureKind>> picture_kinds(const std::string& list) {
  std::set<PictureKind> kinds;
  if (list == "none") return kinds;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    const auto name = std::find(kind_names.begin(), kind_names.end() - 1, word);
    if (name == kind_names.end() - 1) {
      std::string hint = base::did_you_mean(word, kind_names);
      if (hint.empty()) hint = "; give any of svg,pdf,png,vtk, or none";
      return Error{ErrorCode::BadUsage, fmt::format("--pictures: unknown kind '{}'{}", word, hint)};
    }
    kinds.insert(static_cast<PictureKind>(name - kind_names.begin()));
    begin = end + 1;
  }
  return kinds;
}

std::string picture_file_name(PictureKind kind) {
  switch (kind) {
    case PictureKind::Svg:
      return "picture.svg";
    case PictureKind::Pdf:
      return "picture.pdf";
    case PictureKind::Png:
      return "picture.png";
    case PictureKind::Vtk:
      return "picture_vtk.png";
  }
  return {};
}

scene::Picture picture_of(const scenario::Program& program, const scenario::Document& document,
                          const scenario::State& state) {
  return scenario::titled(program.picture_of(state), document);
}

std::string picture_endings(const char* last) {
  const auto& all = render::picture_endings;
  return fmt::format("{} {} {}", fmt::join(all.begin(), all.end() - 1, ", "), last, all.back());
}

base::Result<void> check_ending(const std::filesystem::path& file, Drawer drawer) {
  const std::string ending = file.extension().string();
  const auto& all = render::picture_endings;
  if (ending == vtk_ending || (drawer == Drawer::Cairo && std::find(all.begin(), all.end(), ending) != all.end()))
    return {};
  const bool cairo = drawer == Drawer::Cairo;
  return Error{ErrorCode::BadUsage, fmt::format("{}: {} writes files that end in {}", file.string(),
                                                cairo ? "cairo" : "vtk", cairo ? picture_endings() : vtk_ending)};
}

base::Result<void> draw(const scene::Picture& picture, const std::filesystem::path& file, Drawer drawer,
                        std::optional<double> width) {
  DOBRA_TRY_VOID(check_ending(file, drawer));
  std::optional<scene::PageSize> page;
  if (width) page = scene::suggested_page(picture, *width, render::cairo_text_measure());
  return drawer == Drawer::Cairo ? render::write_picture(picture, file, page)
                                 : render::write_png_vtk(picture, file, page);
}

base::Result<void> draw(const scene::space::SpacePicture& picture, const std::filesystem::path& file, Drawer drawer) {
  DOBRA_TRY_VOID(check_ending(file, drawer));
  return drawer == Drawer::Cairo ? render::write_picture(picture, file) : render::write_png_vtk(picture, file);
}

std::string space_file_name(PictureKind kind) {
  return "space" + picture_file_name(kind).substr(std::string("picture").size());
}

}  // namespace dobra::cli
