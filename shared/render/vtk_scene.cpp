#include "shared/render/vtk_scene.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shared/base/check.h"
#include "shared/render/vtk_layers.h"
#include "shared/render/vtk_marks.h"
#include "shared/render/vtk_parts.h"

namespace dobra::render {
namespace {

constexpr int background_level = 0;
constexpr int panel_level = 1;
constexpr int mark_level = 2;

}  // namespace

class VtkScene::Impl {
 public:
  Impl(vtkRenderWindow& window, const scene::LayoutOptions& options) : window_(window), options_(options) {
    prepare(window, 3);
    background_ = add_renderer(window, background_level);
    front_ = add_renderer(window, mark_level);
    marks_ = std::make_unique<VtkMarks>(*front_);
  }

  /// Actors of layers that are as they were in `before`, and lie as deep, are taken over.
  void build(const scene::Picture& before) {
    std::vector<Panel> old = std::exchange(panels_, {});
    for (const scene::Panel& panel : picture_.panels) {
      const auto same = [&](const scene::Panel& other) { return other.key == panel.key; };
      const auto at = std::find_if(before.panels.begin(), before.panels.end(), same) - before.panels.begin();
      const bool known = at < std::ssize(old) && old[at].renderer != nullptr;
      panels_.push_back(rebuilt(panel, known ? std::move(old[at]) : Panel{}, known ? &before.panels[at] : nullptr));
    }
    for (const Panel& panel : old) {
      if (panel.renderer != nullptr) window_.RemoveRenderer(panel.renderer);
    }
  }

  void set_ground(const scene::Ground& ground) {
    if (std::exchange(ground_, ground) == ground) return;
    set_background(*background_);
    set_background(*front_);
    for (const Panel& panel : panels_) window_.RemoveRenderer(panel.renderer);
    panels_.clear();
    held_ = false;
    build({});
    arrange();
  }

  void overlay(std::size_t number, const std::vector<scene::Layer>& layers) {
    DOBRA_CHECK(number < panels_.size());
    Panel& panel = panels_[number];
    if (panel.above.empty() && layers.empty()) return;
    for (const LayerActors& layer : panel.above) take_out(panel, layer);
    panel.above.clear();
    double depth = static_cast<double>(panel.layers.size());
    for (const scene::Layer& layer : layers) panel.above.push_back(make_actors(layer, panel.origin, depth++, ground_));
    for (const LayerActors& layer : panel.above) put_in(panel, layer);
    arrange();
  }

  [[nodiscard]] std::vector<const vtkActor*> actors_of(std::size_t panel, std::string_view layer_key) const {
    std::vector<const vtkActor*> actors;
    const std::vector<scene::Layer>& layers = picture_.panels.at(panel).layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
      if (layers[i].key != layer_key) continue;
      for (const auto& actor : panels_[panel].layers[i].now.actors) actors.push_back(actor);
    }
    return actors;
  }

  void arrange() {
    end_parts(Parts::Unfinished, Arranged::No);
    if (changes_ > 0) {
      stale_ = true;
      return;
    }
    stale_ = false;
    lay_out();
  }

  void lay_out() {
    if (width_ <= 0 || height_ <= 0) return;
    ++arrangements_;
    const scene::PageSize page{width_ / ratio_, height_ / ratio_};
    if (!measure_ || measured_ratio_ != ratio_) {
      measure_ = vtk_text_measure(ratio_);
      measured_ratio_ = ratio_;
    }
    layout_ = scene::layout(picture_, page, views_, measure_, options_);
    left_ = later_ ? at_once : std::numeric_limits<std::size_t>::max();
    waiting_ = false;
    for (std::size_t i = 0; i < panels_.size(); ++i) aim(panels_[i], layout_.panels[i], picture_.panels[i]);
    std::vector<scene::Mark> marks = layout_.marks;
    if (shows_held_frame()) std::erase_if(marks, [&](const scene::Mark& mark) { return is_in_held_frame(mark); });
    for (scene::Mark& mark : marks) mark = scene::on_ground(std::move(mark), ground_);
    marks_->show(marks, height_, ratio_);
  }

  void hold_frame() {
    if (held_ || panels_.empty() || layout_.panels.size() != panels_.size()) return;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      Panel& panel = panels_[i];
      if (panel.renderer->GetDraw() == 0) continue;
      const scene::PanelLayout& place = layout_.panels[i];
      const Pixels seen = pixels_of(place.plot);
      vtkNew<vtkUnsignedCharArray> rgb;
      window_.GetPixelData(seen.left, seen.bottom, seen.right - 1, seen.top - 1, 0, rgb, 0);
      const int width = seen.right - seen.left;
      const int height = seen.top - seen.bottom;
      if (rgb->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height) continue;
      vtkNew<vtkImageData> image;
      image->SetDimensions(width, height, 1);
      image->GetPointData()->SetScalars(rgb);
      const geom::Point low{seen.left / ratio_, (height_ - seen.bottom) / ratio_};
      const geom::Point high{seen.right / ratio_, (height_ - seen.top) / ratio_};
      geom::Box box;
      box.add(place.transform.to_world(low));
      box.add(place.transform.to_world(high));
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(textured_box(box, panel.origin, 0.0));
      panel.frame = vtkSmartPointer<vtkActor>::New();
      panel.frame->SetMapper(mapper);
      panel.frame->SetTexture(smooth_texture(image));
      panel.frame->GetProperty()->LightingOff();
      panel.frame->SetScale(1.0, panel.exaggeration, 1.0);
      panel.renderer->AddViewProp(panel.frame);
      held_ = true;
    }
    if (held_) arrange();
  }

  [[nodiscard]] std::size_t cost() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const std::vector<scene::Layer>& layers = picture_.panels[i].layers;
      for (std::size_t k = 0; k < layers.size(); ++k) {
        if (!layers[k].visible) continue;
        for (const auto& actor : panels_[i].layers[k].seen().actors) sum += cost_of(*actor);
      }
    }
    return sum;
  }

  void begin_parts() {
    end_parts(Parts::Unfinished, Arranged::No);
    parted_ = true;
    lay_out();  // with the layers in place of a held frame
    for (Panel& panel : panels_) {
      if (panel.frame != nullptr) panel.frame->VisibilityOff();
      for (const Drawn& drawn : panel.layers) queue(drawn.seen());
      for (const LayerActors& layer : panel.above) queue(layer);
    }
    front_->DrawOff();
    at_ = 0;
  }

  bool next_part(std::size_t most) {
    DOBRA_CHECK(parted_);
    if (at_ > 0) {  // the first one clears what was there
      background_->EraseOff();
      for (const Panel& panel : panels_) panel.renderer->EraseOff();
    }
    for (std::size_t i = begin_; i < at_; ++i) queue_[i]->VisibilityOff();
    begin_ = at_;
    std::size_t cost = 0;
    while (at_ < queue_.size() && (at_ == begin_ || cost + cost_of(*queue_[at_]) <= most)) {
      cost += cost_of(*queue_[at_]);
      queue_[at_++]->VisibilityOn();
    }
    const bool last = at_ == queue_.size();
    front_->SetDraw(last);
    return last;
  }

  enum class Arranged { Yes, No };
  void end_parts(Parts parts, Arranged arranged) {
    if (!std::exchange(parted_, false)) return;
    for (const auto& actor : std::exchange(queue_, {})) actor->VisibilityOn();
    begin_ = at_ = 0;
    background_->EraseOn();
    front_->DrawOn();
    for (const Panel& panel : panels_) {
      panel.renderer->EraseOn();
      if (panel.frame != nullptr) panel.frame->VisibilityOn();
    }
    if (parts == Parts::Finished) {
      drop_frame();
    } else if (held_ && arranged == Arranged::Yes) {
      arrange();
    }
  }
  [[nodiscard]] bool draws_parts() const { return parted_; }

  void begin_changes() { ++changes_; }
  void end_changes() {
    if (--changes_ == 0 && stale_) arrange();
  }
  [[nodiscard]] std::size_t arrangements() const { return arrangements_; }

  /// @return whether there was a frame.
  bool drop_frame() {
    end_parts(Parts::Unfinished, Arranged::No);
    for (Panel& panel : panels_) {
      if (panel.frame != nullptr) panel.renderer->RemoveViewProp(panel.frame);
      panel.frame = nullptr;
    }
    return std::exchange(held_, false);
  }

  [[nodiscard]] bool holds_frame() const { return held_; }
  [[nodiscard]] bool is_waiting() const { return waiting_; }

  vtkRenderWindow& window_;
  scene::LayoutOptions options_;
  scene::Picture picture_;
  std::vector<std::optional<scene::View>> views_;
  scene::Layout layout_;
  int width_ = 0;
  int height_ = 0;
  double ratio_ = 1.0;
  bool released_ = false;
  std::function<void(Work)> later_;
  scene::TextMeasure measure_;  ///< For measured_ratio_; keeps what it has measured.
  double measured_ratio_ = 0.0;

  void release() {
    if (released_) return;
    released_ = true;
    end_parts(Parts::Unfinished, Arranged::No);
    for (const Panel& panel : panels_) window_.RemoveRenderer(panel.renderer);
    window_.RemoveRenderer(front_);
    window_.RemoveRenderer(background_);
    panels_.clear();
  }

 private:
  /// A layer, with what was there before as long as its own shapes are not made.
  struct Drawn {
    LayerActors now;
    std::optional<LayerActors> before;
    [[nodiscard]] const LayerActors& seen() const { return before ? *before : now; }
    [[nodiscard]] bool is_made() const {
      return std::all_of(now.shapes.begin(), now.shapes.end(), [](const auto& shape) { return shape->made_for; });
    }
  };
  struct Panel {
    vtkSmartPointer<vtkRenderer> renderer;
    geom::Point origin;  ///< Taken off all coordinates.
    double exaggeration = 1.0;
    std::vector<Drawn> layers;
    std::vector<LayerActors> above;             ///< The overlay.
    vtkSmartPointer<vtkActor> frame = nullptr;  ///< What was drawn last, while it is held.
  };

  static std::size_t cost_of(vtkActor& actor) {
    const vtkPolyData* data = static_cast<vtkPolyDataMapper*>(actor.GetMapper())->GetInput();
    return data == nullptr ? 0 : static_cast<std::size_t>(const_cast<vtkPolyData*>(data)->GetNumberOfCells());
  }

  void queue(const LayerActors& layer) {
    for (const auto& actor : layer.actors) {
      if (actor->GetVisibility() == 0) continue;
      actor->VisibilityOff();
      queue_.push_back(actor);
    }
  }

  [[nodiscard]] bool shows_held_frame() const { return held_ && !parted_; }

  void set_background(vtkRenderer& renderer) const {
    const scene::Color& c = ground_.paper;
    renderer.SetBackground(c.red / 255.0, c.green / 255.0, c.blue / 255.0);
  }

  static void take_out(Panel& panel, const LayerActors& layer) {
    for (const auto& actor : layer.actors) panel.renderer->RemoveViewProp(actor);
  }

  static void put_in(Panel& panel, const LayerActors& layer) {
    for (const auto& actor : layer.actors) {
      actor->SetScale(1.0, panel.exaggeration, 1.0);
      panel.renderer->AddViewProp(actor);
    }
  }

  /// The actors of a panel, out of what it was before where that is known.
  Panel rebuilt(const scene::Panel& panel, Panel old, const scene::Panel* before) {
    const geom::Box box = scene::extent(panel);
    const geom::Point middle = box.empty() ? geom::Point{} : box.centre();
    Panel made;
    made.renderer = old.renderer != nullptr ? old.renderer : add_renderer(window_, panel_level);
    set_background(*made.renderer);
    // One that is not far off leaves the coordinates their digits.
    const bool near = before != nullptr && geom::distance(old.origin, middle) <= 10.0 * box.diagonal();
    made.origin = near ? old.origin : middle;
    made.exaggeration = panel.vertical_exaggeration;
    for (std::size_t i = 0; i < panel.layers.size(); ++i) {
      const scene::Layer& layer = panel.layers[i];
      if (near && i < before->layers.size() && draws_alike(layer, before->layers[i])) {
        made.layers.push_back(std::exchange(old.layers[i], {}));
        continue;
      }
      Drawn& drawn = made.layers.emplace_back();
      drawn.now = make_actors(layer, made.origin, static_cast<double>(i), ground_);
      if (!near || !later_) continue;
      const auto same_key = [&](const scene::Layer& other) { return other.key == layer.key; };
      const auto known = std::find_if(before->layers.begin(), before->layers.end(), same_key);
      if (known == before->layers.end()) continue;
      Drawn& was = old.layers[static_cast<std::size_t>(known - before->layers.begin())];
      if (was.now.actors.empty()) continue;  // stays, or is another's already
      drawn.before = was.is_made() ? std::move(was.now) : std::exchange(was.before, std::nullopt);
      was = {};
    }
    for (const LayerActors& layer : old.above) take_out(old, layer);
    for (const Drawn& gone : old.layers) {
      take_out(old, gone.now);
      if (gone.before) take_out(old, *gone.before);
    }
    // In the order of the layers, which what is translucent is drawn in; those that stay keep what is on the card.
    made.renderer->GetViewProps()->RemoveAllItems();
    for (const Drawn& drawn : made.layers) {
      if (drawn.before) put_in(made, *drawn.before);
      put_in(made, drawn.now);
    }
    return made;
  }

  /// Apart from whether they are shown. Lists that are equal without being the same are compared: whoever makes
  /// pictures of many points shares those (scene::share_with).
  static bool draws_alike(const scene::Layer& a, const scene::Layer& b) {
    return a.key == b.key && a.style == b.style && a.content == b.content;
  }

  /// Puts a panel's viewport on its plot, in whole pixels, and its camera so that the world stands where the layout
  /// says.
  void aim(Panel& panel, const scene::PanelLayout& place, const scene::Panel& described) {
    const double left = std::round(place.plot.low.x * ratio_);
    const double right = std::max(std::round(place.plot.high.x * ratio_), left + 1.0);
    const double top = std::round(place.plot.low.y * ratio_);
    const double bottom = std::max(std::round(place.plot.high.y * ratio_), top + 1.0);
    const bool in_window = left < width_ && top < height_ && right > 0.0 && bottom > 0.0;
    panel.renderer->SetDraw(in_window);
    panel.renderer->SetViewport(std::max(left / width_, 0.0), std::max(1.0 - bottom / height_, 0.0),
                                std::min(right / width_, 1.0), std::min(1.0 - top / height_, 1.0));
    const double seen_right = std::min<double>(right, width_);
    const double seen_bottom = std::min<double>(bottom, height_);
    const geom::Point page_middle{0.5 * (std::max(left, 0.0) + seen_right) / ratio_,
                                  0.5 * (std::max(top, 0.0) + seen_bottom) / ratio_};
    const geom::Point middle = place.transform.to_world(page_middle);
    const double x = middle.x - panel.origin.x;
    const double y = (middle.y - panel.origin.y) * panel.exaggeration;
    const double reach = static_cast<double>(panel.layers.size() + panel.above.size()) + 10.0;
    vtkCamera& camera = *panel.renderer->GetActiveCamera();
    camera.ParallelProjectionOn();
    camera.SetFocalPoint(x, y, 0.0);
    camera.SetPosition(x, y, reach);
    camera.SetViewUp(0.0, 1.0, 0.0);
    camera.SetParallelScale(0.5 * (seen_bottom - std::max(top, 0.0)) / ratio_ / place.transform.points_per_x);
    camera.SetClippingRange(1.0, 2.0 * reach);
    for (std::size_t i = 0; i < panel.layers.size(); ++i)
      settle(panel, panel.layers[i], described.layers[i].visible, place);
    for (LayerActors& layer : panel.above) {
      refresh(layer, place);
      for (const auto& follow : layer.on_view) follow(place, ratio_);
    }
  }

  /// Shows or hides a layer, with its shapes as the view wants them.
  void settle(Panel& panel, Drawn& drawn, bool visible, const scene::PanelLayout& place) {
    const bool shown = visible && (panel.frame == nullptr || parted_);
    if (shown) refresh(drawn.now, place);
    if (drawn.before && (!visible || drawn.is_made())) {
      take_out(panel, *drawn.before);
      drawn.before.reset();
    }
    if (drawn.before) {
      for (const auto& actor : drawn.before->actors) actor->SetVisibility(shown);
    }
    for (const auto& actor : drawn.now.actors) actor->SetVisibility(shown && !drawn.before);
    if (!shown) return;
    for (const auto& follow : drawn.now.on_view) follow(place, ratio_);
    if (!drawn.before) return;
    for (const auto& actor : drawn.now.actors) actor->SetVisibility(false);
  }

  /// Makes the shapes of a layer that no longer serve, or has them made.
  void refresh(LayerActors& layer, const scene::PanelLayout& place) {
    const Look look = look_at(place, ratio_, layer.points);
    for (const std::shared_ptr<Shape>& shape : layer.shapes) {
      if (shape->serves(look)) {
        shape->wanted = 0;  // what is being made for another view is not needed
        continue;
      }
      if (layer.points <= left_) {
        left_ -= layer.points;
        shape->wanted = 0;
        shape->show(shape->make(look), look);
        continue;
      }
      waiting_ = true;
      if (shape->wanted != 0 && shape->wanted_for.serves(look, shape->follows)) continue;
      shape->wanted_for = look;
      const std::uint64_t number = shape->wanted = ++requests_;
      later_([shape, look, number]() -> std::function<void()> {
        if (shape->wanted != number) return [] {};
        return [shape, look, number, made = shape->make(look)] {
          if (shape->wanted != number) return;
          shape->wanted = 0;
          shape->show(made, look);
        };
      });
    }
  }

  struct Pixels {
    int left = 0, right = 0, bottom = 0, top = 0;  ///< From the lower left corner of the window.
  };
  [[nodiscard]] Pixels pixels_of(const geom::Box& plot) const {
    const auto whole = [](double value, int most) { return std::clamp(static_cast<int>(std::round(value)), 0, most); };
    return {whole(plot.low.x * ratio_, width_), whole(plot.high.x * ratio_, width_),
            height_ - whole(plot.high.y * ratio_, height_), height_ - whole(plot.low.y * ratio_, height_)};
  }

  /// What stands within a plot is part of the frame that is held there.
  [[nodiscard]] bool is_in_held_frame(const scene::Mark& mark) const {
    const geom::Point middle = scene::box_of(mark).centre();
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const geom::Box& plot = layout_.panels[i].plot;
      if (panels_[i].frame != nullptr && plot.grown(-2.0).contains(middle) &&
          scene::box_of(mark).width() < 0.9 * plot.width())  // not the frame of the plot
        return true;
    }
    return false;
  }

  scene::Ground ground_;
  std::vector<Panel> panels_;
  vtkSmartPointer<vtkRenderer> background_;
  vtkSmartPointer<vtkRenderer> front_;
  std::unique_ptr<VtkMarks> marks_;
  std::size_t left_ = 0;  ///< Points whose shapes may yet be made at once.
  std::uint64_t requests_ = 0;
  bool waiting_ = false;
  bool held_ = false;
  bool parted_ = false;
  std::vector<vtkSmartPointer<vtkActor>> queue_;  ///< What the parts draw, one after the other.
  std::size_t begin_ = 0, at_ = 0;                ///< The part that is drawn next.
  int changes_ = 0;                               ///< Those under way,
  bool stale_ = false;                            ///< and whether they have changed anything.
  std::size_t arrangements_ = 0;
};

VtkScene::VtkScene(vtkRenderWindow& window, const scene::LayoutOptions& options)
    : impl_(std::make_unique<Impl>(window, options)) {}

VtkScene::~VtkScene() { VtkScene::release(); }

void VtkScene::set_picture(scene::Picture picture, KeepViews keep) {
  std::vector<std::optional<scene::View>> views(picture.panels.size());
  for (std::size_t i = 0; keep == KeepViews::Yes && i < picture.panels.size(); ++i) {
    const auto& old = impl_->picture_.panels;
    const auto same =
        std::find_if(old.begin(), old.end(), [&](const scene::Panel& p) { return p.key == picture.panels[i].key; });
    if (same != old.end()) views[i] = impl_->views_[static_cast<std::size_t>(same - old.begin())];
  }
  const scene::Picture before = std::exchange(impl_->picture_, std::move(picture));
  impl_->drop_frame();
  impl_->views_ = std::move(views);
  impl_->build(before);
  impl_->arrange();
}

void VtkScene::set_ground(const scene::Ground& ground) { impl_->set_ground(ground); }

const scene::Picture& VtkScene::picture() const { return impl_->picture_; }

void VtkScene::set_layer_visible(std::string_view panel_key, std::string_view layer_key, bool visible) {
  for (scene::Panel& panel : impl_->picture_.panels) {
    if (panel.key != panel_key) continue;
    for (scene::Layer& layer : panel.layers) {
      if (layer.key == layer_key) layer.visible = visible;
    }
  }
  impl_->drop_frame();
  impl_->arrange();
}

void VtkScene::set_overlay(std::size_t panel, const std::vector<scene::Layer>& layers) {
  impl_->overlay(panel, layers);
}

std::vector<const vtkActor*> VtkScene::actors_of(std::size_t panel, std::string_view layer_key) const {
  return impl_->actors_of(panel, layer_key);
}

void VtkScene::set_options(const scene::LayoutOptions& options) {
  impl_->options_ = options;
  impl_->arrange();
}

const scene::LayoutOptions& VtkScene::options() const { return impl_->options_; }

void VtkScene::set_views(std::vector<std::optional<scene::View>> views) {
  DOBRA_CHECK(views.size() == impl_->picture_.panels.size());
  impl_->views_ = std::move(views);
  impl_->arrange();
}

std::vector<scene::View> VtkScene::views() const {
  std::vector<scene::View> views;
  for (const scene::PanelLayout& panel : impl_->layout_.panels) views.push_back(panel.view);
  return views;
}

void VtkScene::resize(int width, int height, double device_pixel_ratio) {
  impl_->width_ = width;
  impl_->height_ = height;
  impl_->ratio_ = device_pixel_ratio;
  impl_->drop_frame();
  impl_->window_.SetSize(width, height);
  impl_->arrange();
}

const scene::Layout& VtkScene::layout() const { return impl_->layout_; }

std::optional<std::size_t> VtkScene::panel_at(geom::Point page) const {
  for (std::size_t i = 0; i < impl_->layout_.panels.size(); ++i) {
    if (impl_->layout_.panels[i].plot.contains(page)) return i;
  }
  return std::nullopt;
}

void VtkScene::release() { impl_->release(); }

void VtkScene::make_later(std::function<void(Work)> later) { impl_->later_ = std::move(later); }

void VtkScene::arrive() { impl_->arrange(); }

bool VtkScene::is_waiting() const { return impl_->is_waiting(); }

void VtkScene::hold_frame() { impl_->hold_frame(); }

void VtkScene::let_go() {
  if (impl_->drop_frame()) impl_->arrange();
}

bool VtkScene::holds_frame() const { return impl_->holds_frame(); }

std::size_t VtkScene::cost() const { return impl_->cost(); }

void VtkScene::begin_parts() { impl_->begin_parts(); }

bool VtkScene::next_part(std::size_t cost) { return impl_->next_part(cost); }

void VtkScene::end_parts(Parts parts) { impl_->end_parts(parts, Impl::Arranged::Yes); }

bool VtkScene::draws_parts() const { return impl_->draws_parts(); }

VtkScene::Changes::Changes(VtkScene& scene) : scene_(scene) { scene_.impl_->begin_changes(); }

VtkScene::Changes::~Changes() { scene_.impl_->end_changes(); }

std::size_t VtkScene::arrangements() const { return impl_->arrangements(); }

}  // namespace dobra::render
