// 1. A desktop OpenGL 3.2 core context on no surface (EGL_PLATFORM_SURFACELESS_MESA), made current.
// 2. A vtkGenericOpenGLRenderWindow that draws into its own framebuffer there. A plain vtkRenderWindow would open an X
//    display, and abort without one.
// 3. Its pixels, through cairo, as a PNG.
#include "shared/render/vtk_offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <cairo.h>
#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "shared/render/cairo.h"
#include "shared/render/cairo_painter.h"
#include "shared/render/space_file.h"
#include "shared/render/vtk_scene.h"
#include "shared/render/vtk_space.h"

namespace dobra::render {
namespace {

/// A current OpenGL context without a surface, for as long as this object lives.
class EglContext {
 public:
  /// Empty if it worked, otherwise what did not.
  std::string open() {
    // The same display every time: EGL counts its initialisations and is not terminated, which Mesa does not survive
    // often.
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY) return "EGL has no surfaceless platform";
    if (eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) return "EGL cannot be started";
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return "EGL has no desktop OpenGL";
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display_, wanted, &config, 1, &count) != EGL_TRUE || count == 0)
      return "EGL has no configuration";
    const EGLint version[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) return "there is no OpenGL 3.2";
    return make_current() ? "" : "an OpenGL context without a surface cannot be used";
  }
  EglContext() = default;
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() {
    if (context_ == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  bool make_current() const { return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE; }
  [[nodiscard]] bool current() const { return eglGetCurrentContext() == context_; }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// A render window on an EGL context. Collects VTK's errors.
class OffscreenWindow {
 public:
  explicit OffscreenWindow(EglContext& context) : context_(context) {
    observe(vtkCommand::WindowMakeCurrentEvent,
            [](vtkObject*, unsigned long, void* self, void*) { of(self).context_.make_current(); });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      *static_cast<bool*>(answer) = of(self).context_.current();
    });
    observe(vtkCommand::ErrorEvent, [](vtkObject*, unsigned long, void* self, void* text) {
      const std::string message = text != nullptr ? static_cast<const char*>(text) : "";
      // GLEW asks for an X display and finds none; the functions it is there for are loaded all the same.
      if (message.find("GLEW could not be initialized") == std::string::npos) of(self).error_ += message;
    });
    window_->SetReadyForRendering(true);
    window_->SetOwnContext(0);
    window_->SetOffScreenRendering(true);
    window_->SetFrameBlitModeToNoBlit();
  }
  ~OffscreenWindow() { window_->Finalize(); }
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkGenericOpenGLRenderWindow& window() { return *window_; }
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  static OffscreenWindow& of(void* self) { return *static_cast<OffscreenWindow*>(self); }

  void observe(unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(answer);
    command->SetClientData(this);
    window_->AddObserver(event, command);
  }

  EglContext& context_;
  std::string error_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
};

/// What VTK's text holds of a message: its first line that says something.
std::string first_line(const std::string& message) {
  const std::size_t begin = message.find("): ");
  std::string text = begin == std::string::npos ? message : message.substr(begin + 3);
  return text.substr(0, text.find('\n'));
}

base::Result<void> write_pixels(vtkGenericOpenGLRenderWindow& window, int width, int height,
                                const std::filesystem::path& path) {
  vtkNew<vtkUnsignedCharArray> rgb;
  window.GetPixelData(0, 0, width - 1, height - 1, 0, rgb, 0);
  if (rgb->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height) {
    return cannot_draw(path, "OpenGL gave no pixels back");
  }
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  unsigned char* out = cairo_image_surface_get_data(surface.get());
  if (out == nullptr) return cannot_draw(path, "there is not enough memory for the image");
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < height; ++row) {
    const unsigned char* in = rgb->GetPointer(static_cast<vtkIdType>(height - 1 - row) * width * 3);
    for (int column = 0; column < width; ++column, in += 3) {
      const std::uint32_t pixel =
          static_cast<std::uint32_t>(in[0]) << 16U | static_cast<std::uint32_t>(in[1]) << 8U | in[2];
      std::memcpy(out + static_cast<std::ptrdiff_t>(row) * stride + 4 * column, &pixel, 4);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return write_png_surface(surface.get(), path);
}

/// A page drawn by what `stage_in` puts into a window of that size.
template <class StageIn>
base::Result<void> write_page(const scene::PageSize& size, double pixels_per_point, const std::filesystem::path& path,
                              const StageIn& stage_in) {
  const double width = std::ceil(size.width * pixels_per_point);
  const double height = std::ceil(size.height * pixels_per_point);
  constexpr double most = 16384.0;  // of OpenGL 4 hardware and of Mesa
  if (!(width >= 1.0 && height >= 1.0 && width <= most && height <= most)) {
    return cannot_draw(path,
                       fmt::format("{:g} x {:g} pixels are asked for, {:g} at most are possible on a side; lower the "
                                   "page size or the resolution",
                                   width, height, most));
  }
  EglContext context;
  if (const std::string why = context.open(); !why.empty()) {
    return cannot_draw(path, why + "; install libegl-mesa0, or use a .png without VTK");
  }
  OffscreenWindow offscreen(context);
  const auto stage = stage_in(offscreen.window(), static_cast<int>(width), static_cast<int>(height));
  offscreen.window().Render();
  if (!offscreen.error().empty()) return cannot_draw(path, first_line(offscreen.error()));
  return write_pixels(offscreen.window(), static_cast<int>(width), static_cast<int>(height), path);
}

}  // namespace

base::Result<void> write_png_vtk(const scene::Picture& picture, const std::filesystem::path& path,
                                 const std::optional<scene::PageSize>& page, double pixels_per_point) {
  const scene::TextMeasure measure = vtk_text_measure(pixels_per_point);
  const scene::PageSize asked = page ? *page : scene::suggested_page(picture, scene::usual_width(picture), measure);
  const scene::PageSize size = scene::layout(picture, asked, {}, measure).page;
  return write_page(size, pixels_per_point, path, [&](vtkRenderWindow& window, int width, int height) {
    auto scene = std::make_unique<VtkScene>(window, scene::LayoutOptions{scene::Plots::ToContent});
    scene->resize(width, height, pixels_per_point);
    scene->set_picture(picture);
    return scene;
  });
}

base::Result<void> write_png_vtk(const scene::space::SpacePicture& picture, const std::filesystem::path& path,
                                 const SpaceFileOptions& options) {
  const double ratio = options.pixels_per_point;
  const scene::TextMeasure measure = vtk_text_measure(ratio);
  const geom::Box3 shown = scene::space::extent(picture);
  const scene::space::Look look{options.camera.value_or(picture.camera), std::nullopt};
  const scene::PageSize asked =
      options.page ? *options.page : scene::space::suggested_page(picture, shown, look, measure);
  const scene::PageSize size = scene::space::layout(picture, shown, look, asked, measure).page.page;
  return write_page(size, ratio, path, [&](vtkRenderWindow& window, int width, int height) {
    auto stage = std::make_unique<VtkSpace>(window, scene::LayoutOptions{scene::Plots::ToContent});
    stage->set_ground(options.ground);
    stage->set_look(look);
    stage->resize(width, height, ratio);
    stage->set_picture(picture);
    return stage;
  });
}

}  // namespace dobra::render
