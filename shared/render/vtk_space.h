#pragma once
// A picture in space in a VTK render window: one renderer for its layers, one over them for the page's marks, from the
// same layout as the files. Turning, panning and zooming move a camera; what is drawn of a layer stays through pictures
// whose layer of that key is the same. The window belongs to the caller, who also calls its Render(). No Qt here.

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "shared/render/vtk_stage.h"
#include "shared/scene/space/layout.h"

class vtkRenderWindow;

namespace dobra::render {

class VtkSpace : public VtkStage {
 public:
  /// Adds its renderers to `window`, which must outlive this object (or be told release() first).
  explicit VtkSpace(vtkRenderWindow& window,
                    const scene::LayoutOptions& options = {scene::Plots::FillPage, 10.0, 11.0});
  ~VtkSpace() override;
  VtkSpace(const VtkSpace&) = delete;
  VtkSpace& operator=(const VtkSpace&) = delete;

  /// How it is looked at does not change. @cost O(n log n) for n triangles that changed; with make_later only those of
  /// small layers
  void set_picture(const scene::space::SpacePicture& picture);
  /// As given, its curtains unrolled. @cost O(1)
  [[nodiscard]] const scene::space::SpacePicture& picture() const;
  [[nodiscard]] const geom::Box3& shown() const;

  void set_look(const scene::space::Look& look);
  [[nodiscard]] const scene::space::Look& look() const;
  void set_exaggeration(double exaggeration);
  void set_layer_visible(std::string_view layer, bool visible);
  /// Draws `layers` with those of the picture, out of its legend, until the next overlay.
  void set_overlay(const std::vector<scene::space::Layer>& layers);

  /// Where points of space come to stand, in page units. @pre resize was called
  [[nodiscard]] const scene::space::SpaceLayout& layout() const;

  void set_ground(const scene::Ground& ground) override;
  void resize(int width, int height, double device_pixel_ratio) override;
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
  [[nodiscard]] std::size_t arrangements() const override;
  void release() override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dobra::render
