#pragma once
// The panels and layers of the picture with a check box each. What the user hides or shows stays so, by key, however
// often the picture is made anew.

#include <QColor>
#include <QTreeWidget>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "shared/scene/layer.h"

namespace dobra::gui {

class LayerTree : public QTreeWidget {
  Q_OBJECT

 public:
  explicit LayerTree(QWidget* parent = nullptr);

  /// Lists the layers of the picture. Panels with the same key and layer keep the user's choice.
  void show_picture(const scene::Picture& picture);

  /// The picture as the user wants to see it: `visible` of each layer set by choice.
  [[nodiscard]] scene::Picture chosen(scene::Picture picture) const;

  /// Shows or hides all layers of that key, or "panel/layer" only that one. @return whether there is any.
  bool set_layer_visible(const std::string& key, bool visible);

  struct Listed {
    std::string key;  ///< "panel/layer"
    QString title;
    QString panel;  ///< Its title.
    bool visible = true;
  };
  /// All layers, from the top of the list.
  [[nodiscard]] std::vector<Listed> listed() const;

  void forget_choices() { choices_.clear(); }

 signals:
  void visibility_changed(const std::string& panel, const std::string& layer, bool visible);

 private:
  using Key = std::pair<std::string, std::string>;
  /// What a line of the tree tells.
  struct Entry {
    std::string key;
    std::string title;
    std::string kind;
    scene::Style style;
    bool visible = true;
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  static std::vector<Entry> entries_of(const scene::Picture& picture);
  void take_change(QTreeWidgetItem* item);

  std::map<Key, bool> choices_;
  QColor back_;  ///< Behind the icons.
  std::vector<Entry> shown_;
};

}  // namespace dobra::gui
