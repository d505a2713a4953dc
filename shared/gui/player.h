#pragma once
// Watching an operation at work: shows it after so many steps, one picture after the other, by running the document
// with the parameter that stops it there (scenario::Operation::stop_after). The document itself stays as it is, so that
// nothing of this is in its history.

#include <QObject>
#include <QTimer>

#include "shared/gui/session.h"

namespace dobra::gui {

class Player : public QObject {
  Q_OBJECT

 public:
  /// @pre `session` outlives the player.
  explicit Player(Session& session, QObject* parent = nullptr);

  /// Whether the operation of a part of the document can be watched: it stops where asked, and there is an input.
  [[nodiscard]] bool can_watch(std::size_t part) const;
  [[nodiscard]] bool playing() const { return playing_; }
  /// A picture of unfinished work is shown, or on its way.
  [[nodiscard]] bool watching() const { return steps_ > 0; }
  [[nodiscard]] std::size_t steps() const { return steps_; }

  /// From where it stands to the end, an eighth more steps a picture. @pre can_watch(part)
  void play(std::size_t part);
  void pause();
  /// `count` steps more. @pre can_watch(part)
  void step(std::size_t part, std::size_t count = 1);
  /// Back to the document as it is.
  void stop();

 signals:
  void changed();

 private:
  void show(std::size_t part, std::size_t steps);
  void go_on();
  void forget();

  Session& session_;
  QTimer pause_;
  std::size_t part_ = 0;
  documents::DocumentPtr asked_;  ///< Whose outcome is waited for.
  std::size_t steps_ = 0;         ///< 0: nothing is watched.
  bool playing_ = false;
};

}  // namespace dobra::gui
