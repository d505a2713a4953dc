#include "shared/gui/welcome/page.h"

#include <QBoxLayout>
#include <QCommandLinkButton>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>

#include "shared/gui/words/words.h"

namespace dobra::gui::welcome {

namespace {

constexpr int room_for_two_columns = 620;  ///< Pixels.

/// By its font alone: a style sheet would keep the colours of the theme before.
QLabel* heading(const QString& words, double points, QFont::Weight weight, QWidget* parent) {
  auto* made = new QLabel(words, parent);
  QFont font = made->font();
  if (points > 0.0) font.setPointSizeF(points);
  font.setWeight(weight);
  made->setFont(font);
  made->setWordWrap(true);
  made->setTextFormat(Qt::PlainText);
  return made;
}

QCommandLinkButton* button(const QString& title, const QString& line, const QString& name, QWidget* parent) {
  auto* made = new QCommandLinkButton(QString(title).replace("&", "&&"), line, parent);
  made->setObjectName(name);
  made->setAccessibleName(title);
  made->setAccessibleDescription(line);
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // words wrap rather than make the page wider
  policy.setHeightForWidth(true);
  made->setSizePolicy(policy);
  return made;
}

}  // namespace

Page::Page(const QString& title, const QString& about, const std::vector<Example>& examples, bool imports,
           QWidget* parent)
    : QScrollArea(parent) {
  setObjectName("welcome");
  setAccessibleName(text("Welcome"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  auto* content = new QWidget(this);
  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(24, 20, 24, 20);
  rows->addWidget(heading(title, 18.0, QFont::Bold, content));
  rows->addWidget(heading(about, 11.0, QFont::Normal, content));
  rows->addSpacing(12);
  columns_ = new QBoxLayout(QBoxLayout::LeftToRight);
  columns_->setSpacing(24);
  rows->addLayout(columns_);
  rows->addStretch(1);

  auto* files = new QVBoxLayout;
  files->addWidget(heading(text("Begin"), 0.0, QFont::Bold, content));
  auto* fresh = button(text("New"), text("An empty document"), "welcome.new", content);
  auto* open = button(text("Open..."), text("A scenario file"), "welcome.open", content);
  connect(fresh, &QAbstractButton::clicked, this, &Page::new_asked);
  connect(open, &QAbstractButton::clicked, this, &Page::open_asked);
  files->addWidget(fresh);
  files->addWidget(open);
  if (imports) {
    auto* import =
        button(text("Import..."), text("Lines of a text, GeoJSON, DXF or other file"), "welcome.import", content);
    connect(import, &QAbstractButton::clicked, this, &Page::import_asked);
    files->addWidget(import);
  }
  files->addSpacing(12);
  files->addWidget(heading(text("Recent files"), 0.0, QFont::Bold, content));
  recent_ = new QVBoxLayout;
  files->addLayout(recent_);
  files->addStretch(1);
  columns_->addLayout(files, 1);
  first_ = fresh;

  auto* shown = new QVBoxLayout;
  shown->addWidget(heading(text("Examples, opened as copies"), 0.0, QFont::Bold, content));
  for (const Example& example : examples) {
    auto* made = button(text(example.title.c_str()), text(example.line.c_str()),
                        "welcome.example." + QString::fromStdString(example.file), content);
    connect(made, &QAbstractButton::clicked, this, [this, file = example.file] { emit example_asked(file); });
    shown->addWidget(made);
  }
  shown->addStretch(1);
  columns_->addLayout(shown, 1);
  setWidget(content);
}

void Page::show_recent(const QStringList& files) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    item->widget()->hide();  // this may be within its own click
    item->widget()->deleteLater();
    delete item;
  }
  QWidget* before = widget()->findChild<QWidget*>("welcome.import");
  if (before == nullptr) before = widget()->findChild<QWidget*>("welcome.open");
  for (const QString& file : files) {
    const QFileInfo info(file);
    const QString folder = info.path();
    auto* made = button(info.fileName(), info.exists() ? folder : text("Missing from %1").arg(folder),
                        "welcome.recent." + file, widget());
    made->setToolTip(file);
    made->setEnabled(info.exists());
    connect(made, &QAbstractButton::clicked, this, [this, file] { emit recent_asked(file); });
    recent_->addWidget(made);
    setTabOrder(before, made);
    before = made;
  }
  if (files.isEmpty()) recent_->addWidget(heading(text("None yet"), 0.0, QFont::Normal, widget()));
}

void Page::take_focus() { first_->setFocus(Qt::OtherFocusReason); }

/// Escape is the page's own while it has the focus, whatever else waits for it.
bool Page::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
    event->accept();
  return QScrollArea::event(event);
}

void Page::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return emit left();
  QScrollArea::keyPressEvent(event);
}

void Page::resizeEvent(QResizeEvent* event) {
  columns_->setDirection(event->size().width() < room_for_two_columns ? QBoxLayout::TopToBottom
                                                                      : QBoxLayout::LeftToRight);
  QScrollArea::resizeEvent(event);
}

}  // namespace dobra::gui::welcome
