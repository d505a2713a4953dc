// The camera of VTK stands where the picture's does, and its projection is given as a matrix, so that a point comes to
// the same pixel as in the layout, whatever the projection is.
#include "shared/render/vtk_space.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCullerCollection.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shared/base/check.h"
#include "shared/render/vtk_marks.h"
#include "shared/render/vtk_parts.h"
#include "shared/render/vtk_scene.h"
#include "shared/render/vtk_space_layers.h"

namespace dobra::render {
namespace {

namespace space = scene::space;
using Actor = vtkSmartPointer<vtkActor>;

std::size_t cost_of(vtkActor& actor) {
  vtkPolyData* data = static_cast<vtkPolyDataMapper*>(actor.GetMapper())->GetInput();
  return data == nullptr ? 0 : static_cast<std::size_t>(data->GetNumberOfCells());
}

}  // namespace

class VtkSpace::Impl {
 public:
  Impl(vtkRenderWindow& window, const scene::LayoutOptions& options) : window_(window), options_(options) {
    prepare(window, 3);
    background_ = add_renderer(window, 0);
    renderer_ = add_renderer(window, 1);
    front_ = add_renderer(window, 2);
    marks_ = std::make_unique<VtkMarks>(*front_);
    renderer_->GetCullers()->RemoveAllItems();
    light_->SetLightTypeToCameraLight();
    renderer_->AddLight(light_);
  }

  void set_picture(const space::SpacePicture& picture) {
    drop();
    picture_ = picture;
    picture_.layers = space::unrolled(picture);
    shown_ = space::extent(picture_);
    reached_ = space::reach(picture_);
    const bool near = geom::distance(origin_, shown_.centre()) <= 10.0 * shown_.diagonal() && !drawn_.empty();
    if (!near) origin_ = shown_.centre();
    const bool same_light = std::exchange(light_of_, picture.light) == picture.light;
    std::vector<Drawn> old = std::exchange(drawn_, {});
    for (const space::Layer& layer : picture_.layers) {
      const auto known = std::find_if(old.begin(), old.end(), [&](const Drawn& d) { return d.layer.key == layer.key; });
      Drawn drawn;
      if (near && known != old.end()) {
        const bool alike = same_light && known->layer.style == layer.style && draws_alike(known->layer, layer);
        drawn.actors = std::exchange(known->actors, {});
        drawn.ticket = alike ? known->ticket : nullptr;
      }
      drawn.layer = layer;
      drawn_.push_back(std::move(drawn));
    }
    arrange();
  }

  void set_overlay(const std::vector<space::Layer>& layers) {
    if (layers.empty() && overlay_layers_.empty()) return;
    overlay_layers_ = layers;
    overlay_.clear();
    for (const space::Layer& layer : layers)
      overlay_.push_back(make_actors(layer, make_data(layer, origin_), origin_, picture_.light, ground_));
    arrange();
  }

  void set_ground(const scene::Ground& ground) {
    if (std::exchange(ground_, ground) == ground) return;
    for (Drawn& drawn : drawn_) drawn.ticket = nullptr;
    const std::vector<space::Layer> overlay = std::exchange(overlay_layers_, {});
    set_overlay(overlay);
    drop();
    arrange();
  }

  void arrange() {
    end_parts(Parts::Unfinished);
    if (width_ <= 0 || height_ <= 0 || released_) return;
    ++arrangements_;
    if (!measure_ || measured_ratio_ != ratio_) {
      measure_ = vtk_text_measure(ratio_);
      measured_ratio_ = ratio_;
    }
    layout_ = space::layout(picture_, shown_, look_, {width_ / ratio_, height_ / ratio_}, measure_, options_);
    for (vtkRenderer* renderer : {background_.Get(), renderer_.Get(), front_.Get()})
      renderer->SetBackground(ground_.paper.red / 255.0, ground_.paper.green / 255.0, ground_.paper.blue / 255.0);
    refresh();
    put_actors();
    aim();
    std::vector<scene::Mark> marks = layout_.page.marks;
    for (scene::Mark& mark : marks) mark = scene::on_ground(std::move(mark), ground_);
    marks_->show(marks, height_, ratio_);
  }

  [[nodiscard]] std::size_t cost() const {
    std::size_t sum = 0;
    for (const Drawn& drawn : drawn_) {
      if (!is_visible(drawn.layer.key)) continue;
      for (const Actor& actor : drawn.actors.full) sum += cost_of(*actor);
    }
    return sum;
  }

  void hold_frame() {
    if (std::exchange(held_, true)) return;
    put_actors();
    scale_actors();
  }
  bool drop() {
    end_parts(Parts::Unfinished);
    return std::exchange(held_, false);
  }

  void begin_parts() {
    end_parts(Parts::Unfinished);
    parted_ = true;
    put_actors();
    scale_actors();
    queue_.clear();
    for (vtkCollectionSimpleIterator it = start(); vtkProp* prop = renderer_->GetViewProps()->GetNextProp(it);) {
      auto* actor = vtkActor::SafeDownCast(prop);
      if (actor->GetVisibility() == 0) continue;
      actor->VisibilityOff();
      queue_.emplace_back(actor);
    }
    front_->DrawOff();
    begin_ = at_ = 0;
  }

  bool next_part(std::size_t most) {
    DOBRA_CHECK(parted_);
    if (at_ > 0) {  // the first one clears what was there; depths stay with colours
      background_->EraseOff();
      renderer_->EraseOff();
      renderer_->PreserveDepthBufferOn();
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

  void end_parts(Parts parts) {
    if (!std::exchange(parted_, false)) return;
    for (const Actor& actor : std::exchange(queue_, {})) actor->VisibilityOn();
    begin_ = at_ = 0;
    background_->EraseOn();
    renderer_->EraseOn();
    renderer_->PreserveDepthBufferOff();
    front_->DrawOn();
    if (parts == Parts::Finished) held_ = false;
    put_actors();
    scale_actors();
  }

  void release() {
    if (std::exchange(released_, true)) return;
    end_parts(Parts::Unfinished);
    renderer_->RemoveAllViewProps();
    for (vtkRenderer* renderer : {front_.Get(), renderer_.Get(), background_.Get()}) window_.RemoveRenderer(renderer);
    drawn_.clear();
    overlay_.clear();
  }

  vtkRenderWindow& window_;
  scene::LayoutOptions options_;
  space::SpacePicture picture_;
  geom::Box3 shown_ = space::extent(space::SpacePicture{});
  geom::Box3 reached_ = shown_;  ///< Round what is drawn.
  space::Look look_;
  space::SpaceLayout layout_;
  int width_ = 0;
  int height_ = 0;
  double ratio_ = 1.0;
  std::function<void(Work)> later_;
  bool held_ = false;
  bool parted_ = false;
  bool waiting_ = false;
  std::size_t arrangements_ = 0;

 private:
  /// What is made for a layer, once it is there.
  struct Ticket {
    std::optional<SpaceData> data;
    bool shown = false;
  };
  struct Drawn {
    space::Layer layer;
    SpaceActors actors;  ///< Of the layer, or of the one before as long as its own data are not made.
    std::shared_ptr<Ticket> ticket;
  };

  /// Apart from whether they are shown.
  static bool draws_alike(const space::Layer& a, const space::Layer& b) {
    const auto equal = [&](const auto& one) {
      using Content = std::decay_t<decltype(one)>;
      if constexpr (std::is_same_v<Content, space::Curtain>) {
        return false;
      } else {
        const auto* other = std::get_if<Content>(&b.content);
        return other != nullptr && *other == one;
      }
    };
    return std::visit(equal, a.content);
  }

  vtkCollectionSimpleIterator start() {
    vtkCollectionSimpleIterator iterator;
    renderer_->GetViewProps()->InitTraversal(iterator);
    return iterator;
  }

  /// Makes the data of layers that are another now, or has them made; shows those that have come.
  void refresh() {
    std::size_t left = later_ ? at_once : std::numeric_limits<std::size_t>::max();
    waiting_ = false;
    for (Drawn& drawn : drawn_) {
      if (drawn.ticket == nullptr) {
        drawn.ticket = std::make_shared<Ticket>();
        const std::size_t size = size_of(drawn.layer);
        if (size <= left) {
          left -= size;
          drawn.ticket->data = make_data(drawn.layer, origin_);
        } else {
          later_([waiting = std::weak_ptr(drawn.ticket), layer = drawn.layer,
                  origin = origin_]() -> std::function<void()> {
            if (waiting.expired()) return [] {};  // another layer is there by now
            auto made = std::make_shared<SpaceData>(make_data(layer, origin));
            return [waiting, made] {
              if (const auto ticket = waiting.lock()) ticket->data = std::move(*made);
            };
          });
        }
      }
      if (drawn.ticket->data && !drawn.ticket->shown) {
        drawn.actors = make_actors(drawn.layer, *drawn.ticket->data, origin_, picture_.light, ground_);
        drawn.ticket->data = SpaceData{};
        drawn.ticket->shown = true;
      }
      waiting_ = waiting_ || !drawn.ticket->shown;
    }
  }

  void put_actors() {
    renderer_->GetViewProps()->RemoveAllItems();
    const bool thin = held_ && !parted_;
    const auto put = [&](const SpaceActors& actors) {
      for (const Actor& actor : thin ? actors.thinned : actors.full) renderer_->AddViewProp(actor);
    };
    for (const Drawn& drawn : drawn_) {
      if (is_visible(drawn.layer.key)) put(drawn.actors);
    }
    for (const SpaceActors& actors : overlay_) put(actors);
  }

  [[nodiscard]] bool is_visible(const std::string& key) const {
    const auto layer = std::find_if(picture_.layers.begin(), picture_.layers.end(),
                                    [&](const space::Layer& other) { return other.key == key; });
    return layer != picture_.layers.end() && layer->visible;
  }

  void scale_actors() {
    const auto follow = [&](const SpaceActors& actors) {
      for (const std::vector<Actor>* list : {&actors.full, &actors.thinned}) {
        for (const Actor& actor : *list) actor->SetScale(1.0, 1.0, picture_.vertical_exaggeration);
      }
      for (const auto& tell : actors.on_view) tell(layout_.sheet, ratio_);
    };
    for (const Drawn& drawn : drawn_) follow(drawn.actors);
    for (const SpaceActors& actors : overlay_) follow(actors);
  }

  void aim() {
    const geom::Box& plot = layout_.sheet.plot;
    const double left = std::clamp(std::round(plot.low.x * ratio_), 0.0, width_ - 1.0);
    const double right = std::clamp(std::round(plot.high.x * ratio_), left + 1.0, static_cast<double>(width_));
    const double top = std::clamp(std::round(plot.low.y * ratio_), 0.0, height_ - 1.0);
    const double bottom = std::clamp(std::round(plot.high.y * ratio_), top + 1.0, static_cast<double>(height_));
    renderer_->SetViewport(left / width_, 1.0 - bottom / height_, right / width_, 1.0 - top / height_);
    const geom::Point low = layout_.sheet.page.to_world(geom::Point{left / ratio_, bottom / ratio_});
    const geom::Point high = layout_.sheet.page.to_world(geom::Point{right / ratio_, top / ratio_});
    const space::Frame& frame = layout_.sheet.frame;
    const space::Camera& own = frame.camera;
    const geom::Vector3 to_viewer = space::towards_viewer(own);
    const geom::Point3 focus{frame.target.x - origin_.x, frame.target.y - origin_.y,
                             frame.target.z - frame.exaggeration * origin_.z};
    const double off = std::max(shown_.diagonal(), 1e-300);  // any will do: the matrix takes it away again
    vtkCamera& camera = *renderer_->GetActiveCamera();
    camera.SetFocalPoint(focus.x, focus.y, focus.z);
    const geom::Point3 eye = focus + off * to_viewer;
    camera.SetPosition(eye.x, eye.y, eye.z);
    camera.SetViewUp(own.up.x, own.up.y, own.up.z);
    camera.SetParallelProjection(frame.distance == 0.0);
    camera.SetClippingRange(0.01 * off, 10.0 * off);
    set_projection(camera, low, high, off);
    const geom::Vector3& from = picture_.light.from;
    light_->SetPosition(from.x, from.y, from.z);
    light_->SetFocalPoint(0.0, 0.0, 0.0);
    scale_actors();
  }

  /// From VTK's coordinates of the view (right, up, towards the viewer, the camera at `off`) to clip coordinates.
  void set_projection(vtkCamera& camera, geom::Point low, geom::Point high, double off) {
    const space::Frame& frame = layout_.sheet.frame;
    const auto [near, far] = depths(frame);
    const double sx = 2.0 / (high.x - low.x);
    const double sy = 2.0 / (high.y - low.y);
    const geom::Point middle = geom::midpoint(low, high);
    const double sz = 2.0 / (far - near);
    // Clip x is sx (x - middle w), clip z is sz (depth - mean depth w): both rows take w times something off.
    const space::Matrix4 clip{{{{sx, 0.0, 0.0, -sx * middle.x},
                                {0.0, sy, 0.0, -sy * middle.y},
                                {0.0, 0.0, sz, -sz * 0.5 * (near + far)},
                                {0.0, 0.0, 0.0, 1.0}}}};
    space::Matrix4 projection;
    if (frame.camera.projection == space::Projection::Oblique) {
      const double angle = frame.camera.depth_angle.radians();
      projection =
          space::shear(frame.camera.depth_factor * std::cos(angle), frame.camera.depth_factor * std::sin(angle));
    } else if (frame.distance > 0.0) {
      projection = space::perspective(frame.distance);
    }
    const space::Matrix4 from_view{{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, -off}, {0, 0, 0, 1}}}};
    const space::Matrix4 all = clip * projection * from_view;
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k)
        matrix->SetElement(i, k, all.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
    }
    camera.SetExplicitProjectionTransformMatrix(matrix);
    camera.UseExplicitProjectionTransformMatrixOn();
  }

  /// Nearest and farthest of what is drawn.
  [[nodiscard]] std::pair<double, double> depths(const space::Frame& frame) const {
    double near = std::numeric_limits<double>::infinity();
    double far = -near;
    for (int corner = 0; corner < 8; ++corner) {
      const geom::Point3 at{(corner & 1) != 0 ? reached_.high.x : reached_.low.x,
                            (corner & 2) != 0 ? reached_.high.y : reached_.low.y,
                            (corner & 4) != 0 ? reached_.high.z : reached_.low.z};
      const auto seen = space::project(frame, at);
      const double depth = seen ? seen->depth : -(1.0 - space::least_w) / space::least_w * frame.distance;
      near = std::min(near, depth);
      far = std::max(far, depth);
    }
    // With room for what stands round it, such as the frame of a section.
    const double room = 0.1 * std::max(far - near, std::max(reached_.diagonal(), 1e-300));
    return {near - room, far + room};
  }

  vtkSmartPointer<vtkRenderer> background_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderer> front_;
  std::unique_ptr<VtkMarks> marks_;
  vtkNew<vtkLight> light_;
  space::Light light_of_;
  scene::Ground ground_;
  geom::Point3 origin_;
  std::vector<Drawn> drawn_;
  std::vector<space::Layer> overlay_layers_;
  std::vector<SpaceActors> overlay_;
  std::vector<Actor> queue_;
  std::size_t begin_ = 0, at_ = 0;
  scene::TextMeasure measure_;
  double measured_ratio_ = 0.0;
  bool released_ = false;
};

VtkSpace::VtkSpace(vtkRenderWindow& window, const scene::LayoutOptions& options)
    : impl_(std::make_unique<Impl>(window, options)) {}

VtkSpace::~VtkSpace() { VtkSpace::release(); }

void VtkSpace::set_picture(const space::SpacePicture& picture) { impl_->set_picture(picture); }

const space::SpacePicture& VtkSpace::picture() const { return impl_->picture_; }

const geom::Box3& VtkSpace::shown() const { return impl_->shown_; }

void VtkSpace::set_look(const space::Look& look) {
  impl_->look_ = look;
  impl_->arrange();
}

const space::Look& VtkSpace::look() const { return impl_->look_; }

void VtkSpace::set_exaggeration(double exaggeration) {
  impl_->picture_.vertical_exaggeration = exaggeration;
  impl_->drop();
  impl_->arrange();
}

void VtkSpace::set_layer_visible(std::string_view key, bool visible) {
  for (space::Layer& layer : impl_->picture_.layers) {
    if (space::known_key(layer.key) == key) layer.visible = visible;
  }
  impl_->reached_ = space::reach(impl_->picture_);
  impl_->drop();
  impl_->arrange();
}

void VtkSpace::set_overlay(const std::vector<space::Layer>& layers) { impl_->set_overlay(layers); }

const space::SpaceLayout& VtkSpace::layout() const { return impl_->layout_; }

void VtkSpace::set_ground(const scene::Ground& ground) { impl_->set_ground(ground); }

void VtkSpace::resize(int width, int height, double device_pixel_ratio) {
  impl_->width_ = width;
  impl_->height_ = height;
  impl_->ratio_ = device_pixel_ratio;
  impl_->drop();
  impl_->window_.SetSize(width, height);
  impl_->arrange();
}

void VtkSpace::make_later(std::function<void(Work)> later) { impl_->later_ = std::move(later); }

void VtkSpace::arrive() { impl_->arrange(); }

bool VtkSpace::is_waiting() const { return impl_->waiting_; }

void VtkSpace::hold_frame() { impl_->hold_frame(); }

void VtkSpace::let_go() {
  if (impl_->drop()) impl_->arrange();
}

bool VtkSpace::holds_frame() const { return impl_->held_; }

std::size_t VtkSpace::cost() const { return impl_->cost(); }

void VtkSpace::begin_parts() { impl_->begin_parts(); }

bool VtkSpace::next_part(std::size_t cost) { return impl_->next_part(cost); }

void VtkSpace::end_parts(Parts parts) { impl_->end_parts(parts); }

bool VtkSpace::draws_parts() const { return impl_->parted_; }

std::size_t VtkSpace::arrangements() const { return impl_->arrangements_; }

void VtkSpace::release() { impl_->release(); }

}  // namespace dobra::render
