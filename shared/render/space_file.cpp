#include "shared/render/space_file.h"

#include <string>
#include <utility>

#include "shared/base/check.h"
#include "shared/render/cairo.h"
#include "shared/render/cairo_painter.h"
#include "shared/scene/space/display.h"

namespace dobra::render {

namespace {

/// The picture with what stands round it, in marks alone.
scene::Layout drawn_page(const scene::space::SpacePicture& picture, const scene::space::Look& look,
                         const std::optional<scene::PageSize>& wanted, const scene::Ground& ground,
                         const scene::LayoutOptions& options) {
  const geom::Box3 shown = scene::space::extent(picture);
  const scene::TextMeasure measure = cairo_text_measure();
  const scene::PageSize page = wanted ? *wanted : scene::space::suggested_page(picture, shown, look, measure);
  scene::space::SpaceLayout layout = scene::space::layout(picture, shown, look, page, measure, options);
  std::vector<scene::Mark> marks = scene::space::marks_of(picture, layout.sheet);
  marks.insert(marks.end(), layout.page.marks.begin(), layout.page.marks.end());
  for (scene::Mark& mark : marks) mark = scene::on_ground(std::move(mark), ground);
  layout.page.marks = std::move(marks);
  return std::move(layout.page);
}

base::Result<void> write_marks(scene::Layout page, const std::string& title, const std::filesystem::path& path,
                               const SpaceFileOptions& options) {
  scene::Picture words;  // all is in the marks
  words.title = title;
  const Drawn drawn{words, {std::move(page)}, options.ground.paper};
  const std::string extension = path.extension().string();
  if (extension == ".svg") return write_svg(drawn, path);
  if (extension == ".pdf") return write_pdf(drawn, path);
  if (extension == ".png") return write_png(drawn, path, options.pixels_per_point);
  return not_a_picture(path);
}

}  // namespace

base::Result<void> write_picture(const scene::space::SpacePicture& picture, const std::filesystem::path& path,
                                 const SpaceFileOptions& options) {
  const scene::space::Look look{options.camera.value_or(picture.camera), std::nullopt};
  return write_marks(drawn_page(picture, look, options.page, options.ground, {}), picture.title, path, options);
}

base::Result<void> write_views(const scene::space::SpacePicture& picture, const std::vector<NamedView>& views,
                               std::size_t columns, const std::filesystem::path& path,
                               const SpaceFileOptions& options) {
  DOBRA_CHECK(columns > 0 && !views.empty());
  const scene::PageSize cell = options.page.value_or(scene::PageSize{240.0, 220.0});
  scene::LayoutOptions bare;
  bare.plots = scene::Plots::FillPage;
  bare.legend = scene::Legends::Off;
  bare.margin = 4.0;
  bare.text_size = 7.0;
  scene::Layout page;
  const std::size_t rows = (views.size() + columns - 1) / columns;
  page.page = {cell.width * static_cast<double>(columns), cell.height * static_cast<double>(rows)};
  for (std::size_t i = 0; i < views.size(); ++i) {
    scene::space::SpacePicture one = picture;
    one.title = views[i].title;
    one.tables.clear();
    one.notes.clear();
    const geom::Vector by{cell.width * static_cast<double>(i % columns),
                          cell.height * static_cast<double>(i / columns)};
    for (const scene::Mark& mark : drawn_page(one, {views[i].camera, std::nullopt}, cell, options.ground, bare).marks)
      page.marks.push_back(scene::moved(mark, by));
  }
  return write_marks(std::move(page), picture.title, path, options);
}

}  // namespace dobra::render
