#pragma once
// What a window needs of whatever draws into its render window: frames that take long are drawn in parts, between which
// the window hears of other things, and while the view moves something quicker stands in for them.

#include <cstddef>
#include <functional>

#include "shared/scene/ground.h"

namespace dobra::render {

/// What smooths edges; the caller may take less while the view moves.
inline constexpr int samples_a_pixel = 4;

class VtkStage {
 public:
  virtual ~VtkStage() = default;

  /// What the picture is drawn on from now on; white paper at the beginning. @cost that of a new picture.
  virtual void set_ground(const scene::Ground& ground) = 0;
  /// Size of the window in its own pixels; page units are `device_pixel_ratio` pixels each.
  virtual void resize(int width, int height, double device_pixel_ratio) = 0;

  /// A part of the work of a picture. It may be called on any thread; what it returns is to be called on that of the
  /// scene, and shows what was made.
  using Work = std::function<std::function<void()>()>;
  /// Shapes of many points are no longer made at once: their making goes to `later`, and until it is done what was
  /// there before is shown. Whoever has shown some of them calls arrive().
  virtual void make_later(std::function<void(Work)> later) = 0;
  /// Takes notice of what has been shown since.
  virtual void arrive() = 0;
  /// Shapes are still being made.
  [[nodiscard]] virtual bool is_waiting() const = 0;

  /// From here to let_go(), something quick to draw stands in for the layers: of the plane the frame that was drawn
  /// last, moved and scaled as the view is, in space surfaces of fewer triangles. A new picture, another visibility or
  /// size lets go. @pre a frame has been drawn, the context is current.
  virtual void hold_frame() = 0;
  virtual void let_go() = 0;
  [[nodiscard]] virtual bool holds_frame() const = 0;

  /// Points and cells of the layers that are shown, also where something stands in for them.
  [[nodiscard]] virtual std::size_t cost() const = 0;
  /// From here to end_parts(), each Render() of the window draws a part of the layers over the parts before it, so that
  /// a frame of many points leaves room for other things between its parts. What stands in is out of sight meanwhile.
  /// Whatever changes the scene ends the parts, as Unfinished. @pre nothing else draws into the window meanwhile
  virtual void begin_parts() = 0;
  /// The next Render() draws up to so many points and cells, and what is over the layers with the last of them.
  /// @return whether it is the last. @pre draws_parts()
  virtual bool next_part(std::size_t cost) = 0;
  enum class Parts { Finished, Unfinished };
  /// Render() draws all again. Unfinished: what stood in for the layers does so again; else it is let go.
  virtual void end_parts(Parts parts) = 0;
  [[nodiscard]] virtual bool draws_parts() const = 0;

  /// How often the page was laid out.
  [[nodiscard]] virtual std::size_t arrangements() const = 0;

  /// Takes the renderers out of the window and frees what they hold on the graphics card; call it while the context is
  /// current, before the window or its context goes.
  virtual void release() = 0;
};

}  // namespace dobra::render
