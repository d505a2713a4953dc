#include "shared/gui/player.h"

#include <algorithm>

#include "shared/gui/documents/edit.h"

namespace dobra::gui {

namespace {
constexpr int between_pictures = 60;  ///< Milliseconds.
}

Player::Player(Session& session, QObject* parent) : QObject(parent), session_(session) {
  pause_.setSingleShot(true);
  pause_.setInterval(between_pictures);
  connect(&pause_, &QTimer::timeout, this, [this] { show(part_, steps_ + std::max<std::size_t>(1, steps_ / 8)); });
  connect(&session_, &Session::run_finished, this, &Player::go_on);
  connect(&session_, &Session::document_changed, this, [this] {
    if (watching()) {
      stop();
    } else {
      forget();
    }
  });
}

bool Player::can_watch(std::size_t part) const {
  const scenario::Document& document = session_.document();
  if (part == 0 || part > document.steps.size()) return false;
  if (documents::is_blank(document, session_.program())) return false;  // a step that waits for its input
  const scenario::Operation* operation = session_.program().find_operation(document.steps[part - 1].operation);
  return operation != nullptr && !operation->stop_after.empty();
}

void Player::play(std::size_t part) {
  playing_ = true;
  show(part, part == part_ ? steps_ + 1 : 1);
}

void Player::pause() {
  pause_.stop();
  playing_ = false;
  emit changed();
}

void Player::step(std::size_t part, std::size_t count) {
  pause();
  show(part, (part == part_ ? steps_ : 0) + count);
}

void Player::stop() {
  forget();
  session_.run();
}

void Player::show(std::size_t part, std::size_t steps) {
  part_ = part;
  steps_ = steps;
  scenario::Document document = session_.document();
  document.steps.resize(part);
  document.expects.clear();  // they speak of what is done
  scenario::Step& step = document.steps.back();
  step.params.set(session_.program().find_operation(step.operation)->stop_after, static_cast<std::int64_t>(steps));
  asked_ = session_.look_at(std::move(document));
  emit changed();
}

void Player::go_on() {
  const documents::OutcomePtr& outcome = session_.outcome();
  if (!watching() || !outcome || outcome->document != asked_) return;
  const scenario::Step& step = session_.document().steps[part_ - 1];
  const bool failed = !outcome->run.complete();
  const bool at_work =
      !failed && session_.program().find_operation(step.operation)->at_work(outcome->run.states.back());
  if (!at_work) {
    forget();
    // The rest of the document, now that its watched step is done.
    if (!failed) session_.run();
  } else if (playing_) {
    pause_.start();
  }
}

void Player::forget() {
  pause_.stop();
  part_ = 0;
  steps_ = 0;
  playing_ = false;
  emit changed();
}

}  // namespace dobra::gui
