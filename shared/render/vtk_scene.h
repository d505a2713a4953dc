#pragma once
// A picture in a VTK render window: one renderer a panel for its layers, one over them for the page's marks, from the
// same layout as the files. Panning and zooming move a camera; what is drawn of a layer stays through pictures whose
// layer of that key is the same, and is made to the detail that can be seen. The window belongs to the caller, who also
// calls its Render(). No Qt here; VTK's headers stay in the .cpp files.

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "shared/scene/ground.h"
#include "shared/scene/layout.h"

class vtkActor;
class vtkRenderWindow;

namespace dobra::render {

/// How large VTK draws text at so many pixels a page unit (it knows only whole pixels).
scene::TextMeasure vtk_text_measure(double pixels_per_point);

/// What smooths edges; the caller may take less while the view moves.
inline constexpr int samples_a_pixel = 4;

enum class KeepViews { No, Yes };

class VtkScene {
 public:
  /// Adds its renderers to `window`, which must outlive this object (or be told release() first). By default the plots
  /// fill the window, with text of a size for screens.
  explicit VtkScene(vtkRenderWindow& window,
                    const scene::LayoutOptions& options = {scene::Plots::FillPage, 10.0, 11.0});
  ~VtkScene();
  VtkScene(const VtkScene&) = delete;
  VtkScene& operator=(const VtkScene&) = delete;

  /// @param keep  Yes: panels that were there under the same key go on looking where they did.
  /// @cost  O(layers), and that of their shapes: of all that changed, O(n log n) for n points; with make_later only
  ///        those of few points.
  void set_picture(scene::Picture picture, KeepViews keep = KeepViews::No);
  [[nodiscard]] const scene::Picture& picture() const;

  /// What the picture is drawn on from now on; white paper at the beginning. @cost that of a new picture.
  void set_ground(const scene::Ground& ground);

  /// Shows or hides the layers of that key in the panels of that key. @cost O(layout).
  void set_layer_visible(std::string_view panel_key, std::string_view layer_key, bool visible);

  /// Draws `layers` above all of a panel, out of its legend, until the next overlay or picture. @cost that of `layers`.
  /// @pre panel < number of panels
  void set_overlay(std::size_t panel, const std::vector<scene::Layer>& layers);

  /// What draws a layer: the same actors as long as the layer stays as it is. @pre panel < number of panels
  [[nodiscard]] std::vector<const vtkActor*> actors_of(std::size_t panel, std::string_view layer_key) const;

  /// How the page is laid out from now on. @cost O(layout).
  void set_options(const scene::LayoutOptions& options);
  [[nodiscard]] const scene::LayoutOptions& options() const;

  /// One a panel; nothing fits the whole panel. @cost O(layout + dashes in sight), not of the geometry.
  void set_views(std::vector<std::optional<scene::View>> views);
  /// What each panel shows now.
  [[nodiscard]] std::vector<scene::View> views() const;

  /// A part of the work of a picture. It may be called on any thread; what it returns is to be called on that of the
  /// scene, and shows what was made.
  using Work = std::function<std::function<void()>()>;
  /// Shapes of many points are no longer made at once: their making goes to `later`, and until it is done what was
  /// there before is shown. Whoever has shown some of them calls arrive().
  void make_later(std::function<void(Work)> later);
  /// Takes notice of what has been shown since.
  void arrive();
  /// Shapes are still being made.
  [[nodiscard]] bool is_waiting() const;

  /// From the frame that was drawn last to let_go(), plots show that frame, moved and scaled as the view is, and not
  /// their layers. A new picture, another visibility or size lets go. @pre a frame has been drawn, the context is
  /// current.
  void hold_frame();
  void let_go();
  [[nodiscard]] bool holds_frame() const;

  /// Points and cells of the layers that are shown, also where a held frame stands for them.
  [[nodiscard]] std::size_t cost() const;
  /// From here to end_parts(), each Render() of the window draws a part of the layers over the parts before it, so that
  /// a frame of many points leaves room for other things between its parts. A held frame is out of sight meanwhile.
  /// Whatever changes the scene ends the parts, as Unfinished. @pre nothing else draws into the window meanwhile
  void begin_parts();
  /// The next Render() draws up to so many points and cells, and what is over the layers with the last of them.
  /// @return whether it is the last. @pre draws_parts()
  bool next_part(std::size_t cost);
  enum class Parts { Finished, Unfinished };
  /// Render() draws all again. Unfinished: plots show the held frame again, if there was one; else it is let go.
  void end_parts(Parts parts);
  [[nodiscard]] bool draws_parts() const;

  /// What is changed as long as one of these lives is laid out once, at its end.
  class Changes {
   public:
    explicit Changes(VtkScene& scene);
    ~Changes();
    Changes(const Changes&) = delete;
    Changes& operator=(const Changes&) = delete;

   private:
    VtkScene& scene_;
  };
  /// How often the page was laid out.
  [[nodiscard]] std::size_t arrangements() const;

  /// Size of the window in its own pixels; page units are `device_pixel_ratio` pixels each.
  void resize(int width, int height, double device_pixel_ratio);

  /// Page coordinates of a mouse event are its pixels divided by device_pixel_ratio, from the upper left corner.
  [[nodiscard]] const scene::Layout& layout() const;
  /// The panel whose plot is at a page point.
  [[nodiscard]] std::optional<std::size_t> panel_at(geom::Point page) const;

  /// Takes the renderers out of the window and frees what they hold on the graphics card; call it while the context is
  /// current, before the window or its context goes.
  void release();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dobra::render
