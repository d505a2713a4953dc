#include "shared/gui/stage/space_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/canvas/entry.h"
#include "shared/canvas/rounding.h"
#include "shared/gui/words/words.h"
#include "shared/render/vtk_space.h"

namespace dobra::gui::stage {

namespace {

namespace space = scene::space;

constexpr double found_within = 8.0;     ///< Pixels round the cursor.
constexpr double nearer_a_notch = 1.2;   ///< Of the wheel.
constexpr double degrees_a_pixel = 0.4;  ///< Of turning.
constexpr double degrees_a_key = 10.0;
constexpr double moved_a_key = 0.1;          ///< Of the plot.
constexpr double click_reach = 4.0;          ///< Pixels that a hand may move in a click.
constexpr std::size_t thinned_from = 40000;  ///< Cells: so many are stood in for while the view moves.
constexpr double unmoved = 1e-6;             ///< Of a pixel: rounding.
constexpr double least_zoom = 1e-6;          ///< Of what is shown at all, a pixel.
constexpr double most_zoom = 1.0;
const scene::Color moving_color{0xd0, 0x10, 0x10};

geom::Point point_of(QPointF pixel) { return {pixel.x(), pixel.y()}; }

/// In few digits; along axes that go away from the viewer a place stays what it was.
geom::Point3 short_place(geom::Point3 to, geom::Point3 from, double pixel) {
  const auto one = [pixel](double value, double before) {
    return std::abs(value - before) <= unmoved * pixel ? before : canvas::rounded(value, pixel);
  };
  return {one(to.x, from.x), one(to.y, from.y), one(to.z, from.z)};
}

}  // namespace

SpaceWidget::SpaceWidget(QWidget* parent) : VtkFrames(parent) {
  setMouseTracking(true);
  setAccessibleName(text("Picture in space"));
  setAccessibleDescription(
      text("Arrow keys turn, with Shift they move; + and - zoom, F shows all, 1 to 8 look from the usual sides."));
  setMinimumSize(240, 200);
  handle_ = new SectionHandle(this, [this] { return space_ != nullptr ? &space_->layout().sheet : nullptr; });
  connect(this, &SpaceWidget::view_changed, handle_, qOverload<>(&QWidget::update));
  show_cursor();
  connect(&bench_, &frames::Bench::arrived, this, [this] {
    if (const auto pixel = std::exchange(waiting_click_, std::nullopt)) click(*pixel);
  });
}

SpaceWidget::~SpaceWidget() {
  bench_.clear();
  shut();
}

std::unique_ptr<render::VtkStage> SpaceWidget::make_stage(vtkRenderWindow& window) {
  auto made = std::make_unique<render::VtkSpace>(window);
  space_ = made.get();
  return made;
}

void SpaceWidget::stage_made() {
  space_->set_ground(theme::canvas_colors(canvas_).ground);
  show_picture();
}

void SpaceWidget::set_picture(space::SpacePicture picture, Looking looking) {
  picture.layers = space::unrolled(picture);
  if (looking == Looking::AtAll) look_ = {picture.camera, std::nullopt};
  if (!look_.view) held_.reset();
  picture_ = std::move(picture);
  cut_picture();
  if (!has_marker()) end_gesture();
  make_picker();
  show_picture();
}

bool SpaceWidget::has_marker() const {
  if (!marker_) return false;
  return std::any_of(picture_.layers.begin(), picture_.layers.end(), [&](const space::Layer& layer) {
    const auto* markers = std::get_if<space::Markers>(&layer.content);
    if (markers == nullptr || layer.key != marker_->pick.layer) return false;
    for (std::size_t i = 0; i < markers->points.size(); ++i) {
      if (space::id_of(markers->ids, i) == marker_->pick.id) return true;
    }
    return false;
  });
}

void SpaceWidget::cut_picture() {
  shown_ = picture_;
  if (section_ && !picture_.layers.empty()) {
    const geom::Box3 box = space::extent(picture_);
    const space::CutPlane plane = space::plane_of(*section_, box);
    shown_ = space::cut(picture_, plane);
    shown_.extent = box;  // what the plane goes by stays, whatever is hidden
    if (caps_) add_caps(plane);
  }
  show_handle();
}

void SpaceWidget::add_caps(const space::CutPlane& plane) {
  for (space::Layer& cap : caps_(plane)) {
    for (const space::Layer& layer : picture_.layers) {
      if (layer.key != space::known_key(cap.key)) continue;
      cap.visible = layer.visible;
      shown_.layers.push_back(std::move(cap));
      break;
    }
  }
}

void SpaceWidget::show_handle() {
  const bool is_cut = section_ && shown_.extent && !shown_.layers.empty();
  handle_->show_section(is_cut ? section_ : std::nullopt, shown_.extent.value_or(geom::Box3{}),
                        picture_.vertical_exaggeration * exaggeration_);
}

void SpaceWidget::set_section(const std::optional<space::Section>& section) {
  if (std::exchange(section_, section) == section) return;
  cut_picture();
  make_picker();
  show_picture();
}

space::CutPlane SpaceWidget::section_plane() const { return space::plane_of(*section_, space::extent(picture_)); }

void SpaceWidget::move_section(const space::Section& section) {
  set_section(section);
  emit section_dragged(section);
}

void SpaceWidget::make_picker() {
  picker_ = nullptr;
  waiting_click_.reset();
  bench_.clear();
  bench_.post([this, picture = shown_]() -> std::function<void()> {
    auto made = std::make_shared<space::Picker>(picture);
    return [this, made] {
      picker_ = made;
      for (const space::Layer& layer : picture_.layers) picker_->set_visible(layer.key, layer.visible);
    };
  });
}

void SpaceWidget::show_picture() {
  if (space_ == nullptr) return;
  give_way();
  makeCurrent();
  hurry();
  space::SpacePicture shown = shown_;
  if (section_ && shown.extent) {
    space::Layer frame;
    frame.key = "space.section";
    frame.style = {.line = section_color, .line_width = 1.2, .dash = scene::Dash::Dashed};
    frame.in_legend = scene::InLegend::No;
    space::Lines line;
    line.lines = {handle_->rim()};
    frame.content = std::move(line);
    shown.layers.push_back(std::move(frame));
  }
  shown.vertical_exaggeration *= exaggeration_;
  space_->set_look(held_look());
  relayout();
  space_->set_picture(shown);
  doneCurrent();
  show_marks();
  redraw();
  emit view_changed();
}

void SpaceWidget::set_canvas(theme::Canvas canvas) {
  canvas_ = canvas;
  handle_->set_canvas(canvas);
  if (space_ == nullptr) return;
  makeCurrent();
  space_->set_ground(theme::canvas_colors(canvas_).ground);
  doneCurrent();
  forget_frame();
  redraw();
}

void SpaceWidget::set_exaggeration(double exaggeration) {
  if (std::exchange(exaggeration_, exaggeration) == exaggeration) return;
  show_handle();
  if (space_ == nullptr) return;
  if (section_) return show_picture();  // its frame goes by the exaggeration
  makeCurrent();
  hurry();
  space_->set_exaggeration(picture_.vertical_exaggeration * exaggeration_);
  doneCurrent();
  forget_frame();
  redraw();
  emit view_changed();
}

void SpaceWidget::set_layer_visible(const std::string& key, bool visible) {
  for (space::SpacePicture* each : {&picture_, &shown_}) {
    for (space::Layer& layer : each->layers) {
      if (space::known_key(layer.key) == key) layer.visible = visible;
    }
  }
  if (picker_) picker_->set_visible(key, visible);
  if (space_ == nullptr) return;
  if (!look_.view) return show_picture();  // what comes into sight is to be seen
  makeCurrent();
  space_->set_layer_visible(key, visible);
  doneCurrent();
  forget_frame();
  redraw();
}

void SpaceWidget::look_moved() {
  if (space_ == nullptr) return;
  makeCurrent();
  hurry();
  space_->set_look(held_look());
  seen_ = look_.view ? look_.view->world_per_point * plot().size() : QSizeF();
  if (space_->cost() > thinned_from) space_->hold_frame();
  doneCurrent();
  redraw();
  emit view_changed();
}

/// What was in sight stays so, in a window of any size.
void SpaceWidget::resized() {
  handle_->resize(size());
  const QSizeF room = plot().size();
  if (space_ == nullptr || !look_.view || seen_.isEmpty() || room.isEmpty()) return;
  look_.view->world_per_point = std::max(seen_.width() / room.width(), seen_.height() / room.height());
  space_->set_look(held_look());
  emit view_changed();
}

void SpaceWidget::look_from(space::StandardView view) {
  look_ = {space::camera_of(view), std::nullopt};
  held_.reset();
  look_moved();
}

void SpaceWidget::fit() {
  look_.view = std::nullopt;
  held_.reset();
  look_moved();
}

/// Other pictures, and more layers, stand from now on where this one does.
void SpaceWidget::hold() {
  if (space_ == nullptr) return;
  if (!look_.view) look_.view = space_->layout().view;
  if (!held_) held_ = look_.camera.target.value_or(space_->shown().centre());
}

space::Look SpaceWidget::held_look() const {
  space::Look look = look_;
  if (held_) look.camera.target = held_;
  return look;
}

/// The picture turns as if the hand took hold of it.
void SpaceWidget::orbit(QPointF by) {
  hold();  // its scale stays: what is shown at all is wider from some sides than from others
  look_.camera = space::orbited(look_.camera, base::Angle::from_degrees(-degrees_a_pixel * by.x()),
                                base::Angle::from_degrees(degrees_a_pixel * by.y()));
  look_moved();
}

void SpaceWidget::pan(QPointF by) {
  if (space_ == nullptr) return;
  hold();
  look_.view = scene::pan(space_->layout().view, {by.x(), by.y()});
  look_moved();
}

void SpaceWidget::zoom(double factor, QPointF at) {
  if (space_ == nullptr) return;
  const space::SpaceLayout& layout = space_->layout();
  const double size = std::max(space_->shown().diagonal(), 1e-300);
  const double wanted = layout.view.world_per_point / factor;
  if (wanted < least_zoom * size || wanted > most_zoom * size) return;
  hold();
  look_.view = scene::zoom_at(layout.view, layout.sheet.page.to_world(point_of(at)), factor);
  look_moved();
}

std::optional<space::SpacePick> SpaceWidget::pick_at(QPointF pixel) {
  if (space_ == nullptr || !plot().contains(pixel)) return std::nullopt;
  if (!picker_ && space_->cost() <= thinned_from) {
    picker_ = std::make_shared<space::Picker>(shown_);
    bench_.clear();
  }
  if (!picker_) return std::nullopt;
  return picker_->pick(space_->layout().sheet, point_of(pixel), found_within);
}

void SpaceWidget::mark(const std::optional<scene::Pick>& pick) {
  if (!pick && !marked_) return;
  marked_ = pick;
  show_marks();
}

void SpaceWidget::show_marks() {
  if (space_ == nullptr) return;
  std::vector<space::Layer> layers;
  if (marked_) layers = space::highlight(shown_, *marked_);
  const auto add_marker = [&](const char* key, geom::Point3 at, double size) {
    space::Layer marker;
    marker.key = key;
    marker.style.line = moving_color;
    marker.style.marker_size = size;
    marker.content = space::Markers{{at}, {}};
    layers.push_back(std::move(marker));
  };
  if (marker_) add_marker("space.moving", marker_at_, 11.0);
  if (place_) add_marker("space.place", *place_, 13.0);
  makeCurrent();
  space_->set_overlay(layers);
  doneCurrent();
  forget_frame();
  redraw();
}

void SpaceWidget::show_place(const std::optional<geom::Point3>& place) {
  if (std::exchange(place_, place) == place) return;
  show_marks();
}

QString SpaceWidget::words_of(const space::SpacePick& pick) const {
  const auto is_it = [&](const space::Layer& layer) { return layer.key == pick.pick.layer; };
  const auto layer = std::find_if(shown_.layers.begin(), shown_.layers.end(), is_it);
  const bool known = layer != shown_.layers.end();
  const std::string title = known && !layer->title.empty() ? layer->title : pick.pick.layer;
  const std::string name = known && pick.pick.id < layer->names.size() ? layer->names[pick.pick.id] : std::string();
  const double unit = picture_.axes.unit;
  const double scale = space_ != nullptr ? space_->layout().view.world_per_point : 1.0;
  // As many decimals as a pixel can tell apart.
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(scale / unit))), 0, 12);
  const auto number = [&](const std::string& axis, double value) {
    return QString("%1 = %2").arg(
        QString::fromStdString(axis.substr(0, axis.find(" ["))),
        QString::fromStdString(canvas::with_decimal_mark(QString::number(value / unit, 'f', decimals).toStdString())));
  };
  const space::Axes& axes = picture_.axes;
  const QString what = QString::fromStdString(title);
  return (name.empty() ? text("%1, item %2").arg(what).arg(pick.pick.id)
                       : QString("%1, %2").arg(what, QString::fromStdString(name))) +
         ":   " + number(axes.x_title, pick.place.x) + "   " + number(axes.y_title, pick.place.y) + "   " +
         number(axes.z_title, pick.place.z);
}

std::optional<QPointF> SpaceWidget::pixel_of(geom::Point3 at) const {
  if (space_ == nullptr) return std::nullopt;
  const auto seen = space::project(space_->layout().sheet, at);
  if (!seen) return std::nullopt;
  return QPointF(seen->at.x, seen->at.y);
}

QRectF SpaceWidget::plot() const {
  if (space_ == nullptr) return {};
  const geom::Box& box = space_->layout().sheet.plot;
  return {box.low.x, box.low.y, box.width(), box.height()};
}

void SpaceWidget::mousePressEvent(QMouseEvent* event) {
  if (gesture_ != Gesture::None) return;
  const bool left = event->button() == Qt::LeftButton;
  if (!left && event->button() != Qt::MiddleButton) return;
  button_ = event->button();
  pressed_ = last_ = event->position();
  gesture_ = !left || hand_ ? Gesture::Pan : Gesture::Press;
  if (gesture_ == Gesture::Press && !handle_->press(pressed_) && !draggable_.empty()) {
    const auto found = pick_at(pressed_);
    if (found && std::find(draggable_.begin(), draggable_.end(), found->pick.layer) != draggable_.end())
      marker_ = found;
  }
  show_cursor();
}

void SpaceWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (gesture_ == Gesture::Press && (at - pressed_).manhattanLength() > click_reach) {
    gesture_ = marker_ ? Gesture::Marker : handle_->is_held() ? Gesture::Section : Gesture::Orbit;
    if (marker_) drag_marker(MarkerDrag::Begins, pressed_);
    show_cursor();
  }
  if (gesture_ == Gesture::Orbit) orbit(at - last_);
  if (gesture_ == Gesture::Pan) pan(at - last_);
  if (gesture_ == Gesture::Marker) drag_marker(MarkerDrag::Moves, at);
  if (gesture_ == Gesture::Section && handle_->is_held()) move_section(handle_->drag(at));
  last_ = at;
  if (gesture_ == Gesture::None) tell_cursor(at);
}

void SpaceWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != button_) return;
  const Gesture gesture = gesture_;
  if (gesture == Gesture::Marker) drag_marker(MarkerDrag::Ends, event->position());
  end_gesture();
  if (gesture == Gesture::Section) tell_cursor(event->position());
  if (gesture == Gesture::Press) click(event->position());
}

void SpaceWidget::click(QPointF pixel) {
  const auto found = pick_at(pixel);
  if (!picker_) {
    waiting_click_ = pixel;
    return;
  }
  mark(found ? std::optional(found->pick) : std::nullopt);
  emit clicked(found);
}

/// The marker goes with the hand in the plane of the screen.
void SpaceWidget::drag_marker(MarkerDrag phase, QPointF pixel) {
  if (space_ == nullptr || !marker_) return;
  const space::Sheet& sheet = space_->layout().sheet;
  if (phase == MarkerDrag::Begins) {  // pictures that arrive on the way stand where this one does
    hold();
    look_moved();
  }
  // From where it was taken hold of, which is not always its middle.
  const auto begin = space::project(sheet, marker_->place);
  if (!begin) return;
  marker_at_ =
      phase == MarkerDrag::Begins || phase == MarkerDrag::IsTakenBack
          ? marker_->place
          : short_place(space::in_plane_of(sheet, begin->at + (point_of(pixel) - point_of(pressed_)), marker_->place),
                        marker_->place, space_->layout().view.world_per_point);
  show_marks();
  space::SpacePick here = *marker_;
  here.place = marker_at_;
  emit cursor_moved(words_of(here));
  emit dragged(phase, *marker_, marker_at_);
}

void SpaceWidget::end_gesture() {
  const bool had_marker = marker_.has_value();
  gesture_ = Gesture::None;
  button_ = Qt::NoButton;
  marker_.reset();
  handle_->let_go();
  if (had_marker) show_marks();
  show_cursor();
}

void SpaceWidget::tell_cursor(QPointF pixel) {
  handle_->hover(pixel);
  show_cursor();
  if (handle_->hovered()) return emit cursor_moved(handle_->hint());
  if (!picker_) return emit cursor_moved({});
  const auto found = pick_at(pixel);
  emit cursor_moved(found ? words_of(*found) : QString());
}

void SpaceWidget::show_cursor() {
  const bool is_free = gesture_ == Gesture::None && !hand_;
  if (handle_->hovered() && (is_free || gesture_ == Gesture::Section)) {
    const bool turns = gesture_ == Gesture::Section && handle_->hovered() == space::Grip::Rim;
    return setCursor(turns ? QCursor(Qt::ClosedHandCursor) : handle_->cursor_over());
  }
  const bool moves = gesture_ == Gesture::Pan || gesture_ == Gesture::Marker;
  setCursor(moves                        ? Qt::ClosedHandCursor
            : hand_                      ? Qt::OpenHandCursor
            : gesture_ == Gesture::Orbit ? Qt::SizeAllCursor
                                         : Qt::ArrowCursor);
}

void SpaceWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) return fit();
  mousePressEvent(event);
}

void SpaceWidget::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) zoom(std::pow(nearer_a_notch, notches), event->position());
  event->accept();
}

void SpaceWidget::leaveEvent(QEvent*) {
  handle_->hover(std::nullopt);
  emit cursor_moved({});
}

void SpaceWidget::keyPressEvent(QKeyEvent* event) {
  const QPointF middle = plot().center();
  const bool moves = event->modifiers().testFlag(Qt::ShiftModifier);
  const auto go = [&](int right, int down) {
    const QPointF part(moved_a_key * plot().width(), moved_a_key * plot().height());
    if (moves) return pan({-right * part.x(), -down * part.y()});
    const double pixels = degrees_a_key / degrees_a_pixel;
    orbit({right * pixels, down * pixels});
  };
  switch (event->key()) {
    case Qt::Key_Space:
      hand_ = true;
      return show_cursor();
    case Qt::Key_Escape:
      if (const auto began = handle_->let_go(); began && gesture_ == Gesture::Section) {
        end_gesture();
        return move_section(*began);
      }
      if (gesture_ != Gesture::Marker) return VtkFrames::keyPressEvent(event);
      drag_marker(MarkerDrag::IsTakenBack, pressed_);
      return end_gesture();
    case Qt::Key_Left:
      return go(-1, 0);
    case Qt::Key_Right:
      return go(1, 0);
    case Qt::Key_Up:
      return go(0, -1);
    case Qt::Key_Down:
      return go(0, 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(nearer_a_notch, middle);
    case Qt::Key_Minus:
      return zoom(1.0 / nearer_a_notch, middle);
    case Qt::Key_Home:
      return fit();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return click(middle);
    default:
      VtkFrames::keyPressEvent(event);
  }
}

void SpaceWidget::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return VtkFrames::keyReleaseEvent(event);
  if (event->isAutoRepeat()) return;
  hand_ = false;
  show_cursor();
}

void SpaceWidget::focusOutEvent(QFocusEvent* event) {
  hand_ = false;
  show_cursor();
  VtkFrames::focusOutEvent(event);
}

}  // namespace dobra::gui::stage
