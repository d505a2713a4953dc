#include "shared/gui/layer_tree.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include "shared/gui/text.h"
#include "shared/gui/theme/icons.h"
#include "shared/scene/color_map.h"
#include "shared/scene/ground.h"

namespace dobra::gui {

namespace {

constexpr int key_role = Qt::UserRole;

QColor to_color(const scene::Color& color) { return {color.red, color.green, color.blue, color.alpha}; }

/// Lines as they are seen on the background of the list.
QIcon swatch_of(const scene::Layer& layer, const QColor& back) {
  const auto part = [](int value) { return static_cast<std::uint8_t>(value); };
  const scene::Ground ground{{part(back.red()), part(back.green()), part(back.blue())}};
  const QColor line = to_color(scene::line_on(layer.style.line, ground));
  if (std::holds_alternative<scene::Labels>(layer.content)) return theme::letter_swatch(line);
  if (std::holds_alternative<scene::Lines>(layer.content) || std::holds_alternative<scene::Markers>(layer.content)) {
    return theme::swatch(line, line);
  }
  const auto* mesh = std::get_if<scene::Mesh>(&layer.content);
  if (mesh != nullptr && mesh->values_at != scene::ValuesAt::None) {
    QLinearGradient colors(0.0, 0.0, 28.0, 0.0);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
      colors.setColorAt(t, to_color(scene::color_at(mesh->scale.map, t)));
    return theme::swatch(colors, line);
  }
  return theme::swatch(layer.style.fill ? to_color(*layer.style.fill) : QColor(Qt::transparent), line);
}

QString title_of(const std::string& title, const std::string& key) {
  return QString::fromStdString(title.empty() ? key : title);
}

std::string key_of(const QTreeWidgetItem* item) { return item->data(0, key_role).toString().toStdString(); }

}  // namespace

std::vector<LayerTree::Entry> LayerTree::entries_of(const scene::Picture& picture) {
  std::vector<Entry> entries;
  for (const scene::Panel& panel : picture.panels) {
    entries.push_back({panel.key, panel.title, {}, {}, true});
    for (const scene::Layer& layer : panel.layers) {
      const auto* mesh = std::get_if<scene::Mesh>(&layer.content);
      const bool values = mesh != nullptr && mesh->values_at != scene::ValuesAt::None;
      const std::string kind = std::to_string(layer.content.index()) +
                               (values ? "v" + std::to_string(static_cast<int>(mesh->scale.map)) : std::string());
      entries.push_back({layer.key, layer.title, kind, layer.style, layer.visible});
    }
  }
  return entries;
}

LayerTree::LayerTree(QWidget* parent) : QTreeWidget(parent) {
  setHeaderHidden(true);
  setColumnCount(1);
  setIndentation(14);
  setSelectionMode(QAbstractItemView::SingleSelection);  // so that the keyboard's place shows
  setAccessibleName(text("Layers"));
  connect(this, &QTreeWidget::itemChanged, this, &LayerTree::take_change);
}

void LayerTree::show_picture(const scene::Picture& picture) {
  const scene::Picture wanted = chosen(picture);
  std::vector<Entry> entries = entries_of(wanted);
  const QColor back = palette().color(QPalette::Base);
  if (entries == shown_ && back == back_) return;  // a run that changes places leaves the tree as it is
  back_ = back;
  shown_ = std::move(entries);
  const QSignalBlocker quiet(this);
  clear();
  for (const scene::Panel& panel : wanted.panels) {
    // In no tree while it is filled: there, each leaf would ask all others what their branch is to show.
    auto* branch = new QTreeWidgetItem(QStringList(title_of(panel.title, panel.key)));
    branch->setData(0, key_role, QString::fromStdString(panel.key));
    branch->setToolTip(0, branch->text(0));
    branch->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate);
    for (const scene::Layer& layer : panel.layers) {
      auto* leaf = new QTreeWidgetItem(branch, {title_of(layer.title, layer.key)});
      leaf->setData(0, key_role, QString::fromStdString(layer.key));
      leaf->setToolTip(0, QString::fromStdString(layer.key));
      leaf->setIcon(0, swatch_of(layer, back));
      leaf->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
      leaf->setCheckState(0, layer.visible ? Qt::Checked : Qt::Unchecked);
    }
    addTopLevelItem(branch);
    branch->setExpanded(true);
  }
}

scene::Picture LayerTree::chosen(scene::Picture picture) const {
  for (scene::Panel& panel : picture.panels) {
    for (scene::Layer& layer : panel.layers) {
      const auto choice = choices_.find({panel.key, layer.key});
      if (choice != choices_.end()) layer.visible = choice->second;
    }
  }
  return picture;
}

bool LayerTree::set_layer_visible(const std::string& key, bool visible) {
  bool found = false;
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const QTreeWidgetItem* branch = topLevelItem(i);
    for (int j = 0; j < branch->childCount(); ++j) {
      QTreeWidgetItem* leaf = branch->child(j);
      if (key_of(leaf) != key && key_of(branch) + "/" + key_of(leaf) != key) continue;
      leaf->setCheckState(0, visible ? Qt::Checked : Qt::Unchecked);
      found = true;
    }
  }
  return found;
}

std::vector<LayerTree::Listed> LayerTree::listed() const {
  std::vector<Listed> all;
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const QTreeWidgetItem* branch = topLevelItem(i);
    for (int j = 0; j < branch->childCount(); ++j) {
      const QTreeWidgetItem* leaf = branch->child(j);
      all.push_back(
          {key_of(branch) + "/" + key_of(leaf), leaf->text(0), branch->text(0), leaf->checkState(0) == Qt::Checked});
    }
  }
  return all;
}

void LayerTree::take_change(QTreeWidgetItem* item) {
  if (item->parent() == nullptr) return;  // Its layers tell of themselves.
  const bool visible = item->checkState(0) == Qt::Checked;
  const Key key{key_of(item->parent()), key_of(item)};
  const auto before = choices_.find(key);
  if (before != choices_.end() && before->second == visible) return;
  choices_[key] = visible;
  shown_.clear();  // the next picture tells all of it
  emit visibility_changed(key.first, key.second, visible);
}

}  // namespace dobra::gui
