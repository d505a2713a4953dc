#include "shared/gui/importing/taken_in_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <filesystem>

#include "shared/gui/words/words.h"

namespace dobra::gui::importing {

TakenInBar::TakenInBar(QWidget* parent) : QFrame(parent), words_(new QLabel(this)), beside_(new QPushButton(this)) {
  setObjectName("taken_in_bar");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  words_->setObjectName("taken_in_bar.words");
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  beside_->setObjectName("taken_in_bar.beside");
  beside_->setText(text("Keep them in a file beside"));
  auto* undo = new QPushButton(text("Undo"), this);
  undo->setObjectName("taken_in_bar.undo");
  auto* close = new QPushButton(text("Close"), this);
  close->setObjectName("taken_in_bar.close");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 4, 4);
  row->addWidget(words_, 1);
  for (QPushButton* button : {beside_, undo, close}) {
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    row->addWidget(button);
  }
  connect(beside_, &QPushButton::clicked, this, &TakenInBar::beside_asked);
  connect(undo, &QPushButton::clicked, this, &TakenInBar::undo_asked);
  connect(close, &QPushButton::clicked, this, &QWidget::hide);
  hide();
}

void TakenInBar::say(const std::vector<std::string>& files, const scenario::Document& document) {
  QStringList names;
  for (const std::string& file : files)
    names.push_back(QString::fromStdString(std::filesystem::path(file).filename().string()));
  const bool beside = !document.lines_file.empty();
  const QString place = beside ? QString::fromStdString(document.lines_file) : text("the scenario");
  words_->setText(text("The lines of %1 are saved in %2 from now on; the file itself stays as it is.")
                      .arg(names.join(", "), place));
  beside_->setVisible(!beside);
  show();
}

QString TakenInBar::message() const { return isHidden() ? QString() : words_->text(); }

}  // namespace dobra::gui::importing
