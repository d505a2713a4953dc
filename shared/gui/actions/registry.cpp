#include "shared/gui/actions/registry.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <utility>

#include "shared/base/check.h"
#include "shared/base/text.h"

namespace dobra::gui::actions {

QString shown(const std::string& source) {
  return source.empty() ? QString() : QString::fromStdString(base::translated(source.c_str()));
}

QString plain(QString words) {
  words.replace("&&", QChar(1)).remove('&');
  return words.replace(QChar(1), "&");
}

QString keys_text(const QList<QKeySequence>& keys) {
  QStringList all;
  for (const QKeySequence& each : keys) all << each.toString(QKeySequence::NativeText);
  return all.join(", ");
}

namespace {

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < path.size();) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    parts.push_back(path.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

QString tip_of(const Action& action) {
  const QString words = action.help.empty() ? plain(shown(action.text)).remove("...") : shown(action.help);
  return action.keys.isEmpty() ? words : QString("%1 (%2)").arg(words, keys_text(action.keys.mid(0, 1)));
}

}  // namespace

QString menu_path(const Action& action) {
  QStringList titles;
  for (const std::string& part : parts_of(action.menu)) titles << plain(shown(part));
  return titles.join(QString::fromUtf8(" › "));
}

Registry::Registry(QWidget& window) : QObject(&window), window_(window) {}

Registry::~Registry() = default;

QAction& Registry::add(Action action) {
  auto* made = new QAction(shown(action.text), &window_);
  if (action.symbol) made->setIcon(theme::icon(*action.symbol));
  if (action.icon != nullptr) made->setIcon(theme::icon(action.icon));
  if (action.checked) made->setCheckable(true);
  if (!action.choice.empty()) {
    QActionGroup*& group = choices_[action.choice];
    if (group == nullptr) group = new QActionGroup(this);
    group->addAction(made);
  }
  if (action.list) {
    auto* list = new QMenu(&window_);
    made->setMenu(list);
    connect(list, &QMenu::aboutToShow, this, [list, fill = action.list] {
      list->clear();
      fill(*list);
    });
  }
  made->setShortcuts(action.keys);
  if (action.scope != nullptr) made->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  (action.scope != nullptr ? action.scope : &window_)->addAction(made);
  made->setToolTip(tip_of(action));
  made->setStatusTip({});
  if (action.run) {
    connect(made, &QAction::triggered, this, [this, run = action.run] {
      run();
      refresh();
    });
  }
  keep(*made, std::move(action));
  return *made;
}

QAction& Registry::adopt(QAction& made, Action action) {
  window_.addAction(&made);
  keep(made, std::move(action));
  return made;
}

void Registry::keep(QAction& made, Action action) {
  DOBRA_CHECK(!by_id_.contains(action.id));
  for (const Entry& other : entries_) {
    for (const QKeySequence& keys : action.keys)
      DOBRA_CHECK(other.action.scope != action.scope || !other.action.keys.contains(keys));
  }
  made.setObjectName(QString::fromStdString(action.id));
  by_id_[action.id] = entries_.size();
  entries_.push_back({std::move(action), &made, {}});
}

QAction* Registry::find(const std::string& id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : entries_[found->second].made;
}

bool Registry::trigger(const std::string& id) {
  refresh();
  QAction* action = find(id);
  if (action == nullptr || !action->isEnabled()) return false;
  action->trigger();
  return true;
}

QMenu* Registry::menu(const std::string& path) const {
  const auto found = menus_.find(path);
  return found == menus_.end() ? nullptr : found->second;
}

QMenu& Registry::menu_at(QMenuBar& menus, const std::string& path) {
  QMenu* at = nullptr;
  std::string walked;
  for (const std::string& part : parts_of(path)) {
    walked += (walked.empty() ? "" : "/") + part;
    QMenu*& found = menus_[walked];
    if (found == nullptr) {
      found = at == nullptr ? menus.addMenu(shown(part)) : at->addMenu(shown(part));
      found->setToolTipsVisible(true);
      connect(found, &QMenu::aboutToShow, this, &Registry::refresh);
    }
    at = found;
  }
  return *at;
}

void Registry::fill(QMenuBar& menus) {
  for (; in_menus_ < entries_.size(); ++in_menus_) {
    const Entry& entry = entries_[in_menus_];
    if (entry.action.menu.empty()) continue;
    QMenu& menu = menu_at(menus, entry.action.menu);
    auto [last, is_first] = last_section_.try_emplace(&menu, entry.action.section);
    if (!is_first && last->second != entry.action.section) menu.addSeparator();
    last->second = entry.action.section;
    menu.addAction(entry.made);
  }
}

void Registry::fill(QToolBar& bar, const std::string& name) {
  for (const Entry& entry : entries_) {
    if (entry.action.bar != name || bar.actions().contains(entry.made)) continue;
    auto [last, is_first] = last_section_.try_emplace(&bar, entry.action.section);
    if (!is_first && last->second != entry.action.section) bar.addSeparator();
    last->second = entry.action.section;
    bar.addAction(entry.made);
  }
}

void Registry::refresh() {
  for (Entry& entry : entries_) {
    const Action& action = entry.action;
    if (action.enabled) entry.made->setEnabled(action.enabled());
    if (action.checked) entry.made->setChecked(action.checked());
    if (action.label) entry.made->setText(action.label());
    if (action.look) {
      const theme::Symbol symbol = action.look();
      if (std::exchange(entry.looks, symbol) != symbol) entry.made->setIcon(theme::icon(symbol));
    }
  }
}

}  // namespace dobra::gui::actions
