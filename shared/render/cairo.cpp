#include "shared/render/cairo.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "shared/io/file.h"
#include "shared/render/cairo_painter.h"

namespace dobra::render {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int count) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), count);
  return CAIRO_STATUS_SUCCESS;
}

scene::Layout layout_of(const scene::Picture& picture, const std::optional<scene::PageSize>& page) {
  const scene::TextMeasure measure = cairo_text_measure();
  const double width = scene::usual_width(picture);
  return scene::layout(picture, page ? *page : scene::suggested_page(picture, width, measure), {}, measure);
}

/// The pages of a document. Those on paper have its format, also where a picture by itself would be lower.
std::vector<scene::Layout> pages_of(const scene::Picture& picture, const std::optional<scene::PageSize>& page) {
  if (picture.paper == scene::Paper::ToContent) return {layout_of(picture, page)};
  const scene::TextMeasure measure = cairo_text_measure();
  scene::LayoutOptions options;
  options.long_tables = scene::LongTables::NextPages;
  const double width = page ? page->width : scene::a4_landscape.width;
  const scene::PageSize paper{width, width / scene::a4_landscape.width * scene::a4_landscape.height};
  std::vector<scene::Layout> pages{scene::layout(picture, paper, {}, measure, options)};
  if (!pages.front().tables_on_next_pages) return pages;
  for (scene::Layout& further : scene::table_pages(picture, paper, measure, options))
    pages.push_back(std::move(further));
  return pages;
}

/// Paints the first page with the picture, and further ones, and ends the surface; the status of whatever failed first.
cairo_status_t paint_on(const Surface& surface, const Drawn& drawn, TextAs text) {
  const Context context(cairo_create(surface.get()), cairo_destroy);
  for (const scene::Layout& page : drawn.pages) {
    paint(context.get(), &page == &drawn.pages.front() ? drawn.picture : scene::Picture{}, page, text, drawn.paper);
    cairo_show_page(context.get());
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_status(context.get());
  return status == CAIRO_STATUS_SUCCESS ? cairo_surface_status(surface.get()) : status;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

/// cairo writes glyphs as outlines; real text is smaller, can be searched, edited and read aloud. textLength keeps its
/// place where a viewer has no DejaVu Sans.
std::string svg_text(const scene::TextMark& mark) {
  const double down = 0.5 * (mark.size.ascent - mark.size.descent);
  const bool up = mark.turn == scene::TextMark::Turn::Up;
  return fmt::format(
      "<text{} x=\"{:.3f}\" y=\"{:.3f}\" text-anchor=\"middle\" textLength=\"{:.3f}\" "
      "lengthAdjust=\"spacingAndGlyphs\" "
      "font-size=\"{:g}\"{} fill=\"#{:02x}{:02x}{:02x}\">{}</text>\n",
      up ? fmt::format(" transform=\"translate({:.3f} {:.3f}) rotate(-90)\"", mark.at.x, mark.at.y) : "",
      up ? 0.0 : mark.at.x, up ? down : mark.at.y + down, mark.size.width, mark.font.size,
      mark.font.weight == scene::Weight::Bold ? " font-weight=\"bold\"" : "", mark.color.red, mark.color.green,
      mark.color.blue, escaped(mark.text));
}

/// cairo numbers surfaces through the life of the process; numbered within the file, the same picture gives the same
/// bytes.
std::string with_own_numbers(const std::string& svg) {
  static const std::string word = "surface";
  std::vector<std::string> seen;
  std::string out;
  std::size_t begin = 0;
  for (std::size_t at = svg.find(word); at != std::string::npos; at = svg.find(word, begin)) {
    const std::size_t number = at + word.size();
    const std::size_t end = std::min(svg.find_first_not_of("0123456789", number), svg.size());
    out.append(svg, begin, number - begin);
    begin = end;
    if (end == number) continue;
    const auto known = std::find(seen.begin(), seen.end(), svg.substr(number, end - number));
    out += std::to_string(known - seen.begin() + 1);
    if (known == seen.end()) seen.push_back(svg.substr(number, end - number));
  }
  return out + svg.substr(begin);
}

void add_svg_text(const scene::Layout& layout, std::string& svg) {
  std::string texts = "<g font-family=\"'DejaVu Sans',Verdana,sans-serif\">\n";
  for (const scene::Mark& mark : layout.marks) {
    if (const auto* text = std::get_if<scene::TextMark>(&mark)) texts += svg_text(*text);
  }
  texts += "</g>\n";
  const std::size_t end = svg.rfind("</svg>");
  if (end != std::string::npos) svg.insert(end, texts);
}

}  // namespace

base::Error cannot_draw(const std::filesystem::path& path, const std::string& why) {
  base::Error error{base::ErrorCode::CannotDraw, "cannot draw the picture: " + why};
  error.place = base::Place{};
  error.place->file = path.string();
  return error;
}

base::Result<void> write_png_surface(cairo_surface_t* surface, const std::filesystem::path& path) {
  std::string bytes;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append, &bytes);
  if (status != CAIRO_STATUS_SUCCESS) return cannot_draw(path, cairo_status_to_string(status));
  return io::write_file(path, bytes);
}

scene::TextMeasure cairo_text_measure() {
  const std::shared_ptr<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1),
                                                 cairo_surface_destroy);
  const std::shared_ptr<cairo_t> context(cairo_create(surface.get()), cairo_destroy);
  return [surface, context](std::string_view text, const scene::Font& font) {
    select_font(context.get(), font);
    cairo_text_extents_t ink;
    cairo_font_extents_t line;
    cairo_text_extents(context.get(), std::string(text).c_str(), &ink);
    cairo_font_extents(context.get(), &line);
    return scene::TextSize{ink.x_advance, line.ascent, line.descent};
  };
}

base::Result<void> write_svg(const Drawn& drawn, const std::filesystem::path& path) {
  const scene::PageSize& size = drawn.pages.front().page;
  std::string bytes;
  const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, size.width, size.height),
                        cairo_surface_destroy);
  const cairo_status_t status = paint_on(surface, drawn, TextAs::NotDrawn);
  if (status != CAIRO_STATUS_SUCCESS) return cannot_draw(path, cairo_status_to_string(status));
  bytes = with_own_numbers(bytes);
  add_svg_text(drawn.pages.front(), bytes);
  return io::write_file(path, bytes);
}

base::Result<void> write_pdf(const Drawn& drawn, const std::filesystem::path& path) {
  const scene::PageSize& size = drawn.pages.front().page;
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, size.width, size.height),
                        cairo_surface_destroy);
  // cairo puts the time of day here by itself; the same picture must give the same bytes.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  if (!drawn.picture.title.empty()) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawn.picture.title.c_str());
  }
  const cairo_status_t status = paint_on(surface, drawn, TextAs::Glyphs);
  if (status != CAIRO_STATUS_SUCCESS) return cannot_draw(path, cairo_status_to_string(status));
  return io::write_file(path, bytes);
}

base::Result<void> write_png(const Drawn& drawn, const std::filesystem::path& path, double pixels_per_point) {
  const scene::Layout& layout = drawn.pages.front();
  const double width = std::ceil(layout.page.width * pixels_per_point);
  const double height = std::ceil(layout.page.height * pixels_per_point);
  constexpr double most = 32767.0;  // cairo's limit
  if (!(width >= 1.0 && height >= 1.0 && width <= most && height <= most)) {
    return cannot_draw(path,
                       fmt::format("{:g} x {:g} pixels are asked for, {:g} at most are possible on a side; lower the "
                                   "page size or the resolution",
                                   width, height, most));
  }
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)),
      cairo_surface_destroy);
  {
    const Context context(cairo_create(surface.get()), cairo_destroy);
    cairo_set_source_rgb(context.get(), drawn.paper.red / 255.0, drawn.paper.green / 255.0, drawn.paper.blue / 255.0);
    cairo_paint(context.get());
    cairo_scale(context.get(), pixels_per_point, pixels_per_point);
    paint(context.get(), drawn.picture, layout, TextAs::Glyphs, drawn.paper);
    const cairo_status_t status = cairo_status(context.get());
    if (status != CAIRO_STATUS_SUCCESS) return cannot_draw(path, cairo_status_to_string(status));
  }
  return write_png_surface(surface.get(), path);
}

base::Result<void> write_svg(const scene::Picture& picture, const std::filesystem::path& path,
                             const std::optional<scene::PageSize>& page) {
  return write_svg({picture, {layout_of(picture, page)}}, path);
}

base::Result<void> write_pdf(const scene::Picture& picture, const std::filesystem::path& path,
                             const std::optional<scene::PageSize>& page) {
  return write_pdf({picture, pages_of(picture, page)}, path);
}

base::Result<void> write_png(const scene::Picture& picture, const std::filesystem::path& path,
                             const std::optional<scene::PageSize>& page, double pixels_per_point) {
  return write_png({picture, {layout_of(picture, page)}}, path, pixels_per_point);
}

base::Error not_a_picture(const std::filesystem::path& path) {
  base::Error error{
      base::ErrorCode::UnknownFormat,
      fmt::format("'{}' is not a kind of picture; use {}", path.extension().string(), fmt::join(picture_endings, " "))};
  error.place = base::Place{};
  error.place->file = path.string();
  return error;
}

base::Result<void> write_picture(const scene::Picture& picture, const std::filesystem::path& path,
                                 const std::optional<scene::PageSize>& page) {
  const std::string extension = path.extension().string();
  if (extension == ".svg") return write_svg(picture, path, page);
  if (extension == ".pdf") return write_pdf(picture, path, page);
  if (extension == ".png") return write_png(picture, path, page);
  return not_a_picture(path);
}

}  // namespace dobra::render
