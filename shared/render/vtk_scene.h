#pragma once
// A picture in a VTK render window: one renderer a panel for its layers, one over them for the page's marks, from the
// same layout as the files. Panning and zooming move a camera; what is drawn of a layer stays through pictures whose
// layer of that key is the same, and is made to the detail that can be seen. The window belongs to the caller, who also
// calls its Render(). No Qt here; VTK's headers stay in the .cpp files.

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "shared/render/vtk_stage.h"
#include "shared/scene/layout.h"

class vtkActor;
class vtkRenderWindow;

namespace dobra::render {

/// How large VTK draws text at so many pixels a page unit (it knows only whole pixels).
scene::TextMeasure vtk_text_measure(double pixels_per_point);

enum class KeepViews { No, Yes };

class VtkScene : public VtkStage {
 public:
  /// Adds its renderers to `window`, which must outlive this object (or be told release() first). By default the plots
  /// fill the window, with text of a size for screens.
  explicit VtkScene(vtkRenderWindow& window,
                    const scene::LayoutOptions& options = {scene::Plots::FillPage, 10.0, 11.0});
  ~VtkScene() override;
  VtkScene(const VtkScene&) = delete;
  VtkScene& operator=(const VtkScene&) = delete;

  /// @param keep  Yes: panels that were there under the same key go on looking where they did.
  /// @cost  O(layers), and that of their shapes: of all that changed, O(n log n) for n points; with make_later only
  ///        those of few points.
  void set_picture(scene::Picture picture, KeepViews keep = KeepViews::No);
  [[nodiscard]] const scene::Picture& picture() const;

  void set_ground(const scene::Ground& ground) override;

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

  void make_later(std::function<void(Work)> later) override;
  void arrive() override;
  [[nodiscard]] bool is_waiting() const override;
  void hold_frame() override;
  void let_go() override;
  [[nodiscard]] bool holds_frame() const override;
  [[nodiscard]] std::size_t cost() const override;
  void begin_parts() override;
  bool next_part(std::size_t cost) override;
  void end_parts(Parts parts) override;
  [[nodiscard]] bool draws_parts() const override;

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
  [[nodiscard]] std::size_t arrangements() const override;

  void resize(int width, int height, double device_pixel_ratio) override;

  /// Page coordinates of a mouse event are its pixels divided by device_pixel_ratio, from the upper left corner.
  [[nodiscard]] const scene::Layout& layout() const;
  /// The panel whose plot is at a page point.
  [[nodiscard]] std::optional<std::size_t> panel_at(geom::Point page) const;

  void release() override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dobra::render
