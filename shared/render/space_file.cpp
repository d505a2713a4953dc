#include "shared/render/space_file.h"

#include <string>
#include <utility>

#include "shared/render/cairo.h"
#include "shared/render/cairo_painter.h"
#include "shared/scene/space/display.h"

namespace dobra::render {

base::Result<void> write_picture(const scene::space::SpacePicture& picture, const std::filesystem::path& path,
                                 const SpaceFileOptions& options) {
  const std::string extension = path.extension().string();
  const geom::Box3 shown = scene::space::extent(picture);
  const scene::space::Look look{options.camera.value_or(picture.camera), std::nullopt};
  const scene::TextMeasure measure = cairo_text_measure();
  const scene::PageSize page =
      options.page ? *options.page : scene::space::suggested_page(picture, shown, look, measure);
  scene::space::SpaceLayout layout = scene::space::layout(picture, shown, look, page, measure);
  std::vector<scene::Mark> marks = scene::space::marks_of(picture, layout.sheet);
  marks.insert(marks.end(), layout.page.marks.begin(), layout.page.marks.end());
  for (scene::Mark& mark : marks) mark = scene::on_ground(std::move(mark), options.ground);
  layout.page.marks = std::move(marks);
  scene::Picture words;  // all is in the marks
  words.title = picture.title;
  const Drawn drawn{words, {std::move(layout.page)}, options.ground.paper};
  if (extension == ".svg") return write_svg(drawn, path);
  if (extension == ".pdf") return write_pdf(drawn, path);
  if (extension == ".png") return write_png(drawn, path, options.pixels_per_point);
  return not_a_picture(path);
}

}  // namespace dobra::render
