#include "shared/gui/layer_tree.h"

#include <gtest/gtest.h>

#include "tests/shared/gui/fake_program.h"

namespace dobra::gui {
namespace {

scene::Picture waves() {
  const scenario::Program program = test::fake_program();
  return program.picture_of(scenario::make_state(test::Waves{100.0, 3, 50.0, true}));
}

bool visible(const scene::Picture& picture, const std::string& panel_key, const std::string& layer_key) {
  for (const scene::Panel& panel : picture.panels) {
    for (const scene::Layer& layer : panel.layers) {
      if (panel.key == panel_key && layer.key == layer_key) return layer.visible;
    }
  }
  ADD_FAILURE() << "no layer " << panel_key << "/" << layer_key;
  return false;
}

TEST(LayerTree, ListsPanelsAndTheirLayers) {
  LayerTree tree;
  tree.show_picture(waves());
  ASSERT_EQ(tree.topLevelItemCount(), 2);
  EXPECT_EQ(tree.topLevelItem(0)->childCount(), 3);
  EXPECT_EQ(tree.topLevelItem(0)->child(1)->text(0), "offset curves");
  EXPECT_EQ(tree.topLevelItem(0)->checkState(0), Qt::Checked);
}

TEST(LayerTree, ChoiceIsToldOnceAndKeptWhenThePictureIsMadeAnew) {
  LayerTree tree;
  tree.show_picture(waves());
  int told = 0;
  QObject::connect(&tree, &LayerTree::visibility_changed,
                   [&](const std::string& panel, const std::string& layer, bool on) {
                     ++told;
                     EXPECT_EQ(panel + "/" + layer, "after/bed");
                     EXPECT_FALSE(on);
                   });
  EXPECT_TRUE(tree.set_layer_visible("after/bed", false));
  EXPECT_EQ(told, 1);
  tree.show_picture(waves());
  EXPECT_FALSE(visible(tree.chosen(waves()), "after", "bed"));
  EXPECT_TRUE(visible(tree.chosen(waves()), "before", "bed"));
  EXPECT_EQ(told, 1);
}

TEST(LayerTree, UncheckingAPanelHidesAllItsLayers) {
  LayerTree tree;
  tree.show_picture(waves());
  tree.topLevelItem(1)->setCheckState(0, Qt::Unchecked);
  for (const char* layer : {"bed", "stack", "top"}) {
    EXPECT_FALSE(visible(tree.chosen(waves()), "after", layer));
    EXPECT_TRUE(visible(tree.chosen(waves()), "before", layer));
  }
}

TEST(LayerTree, UnknownLayerIsNotFound) {
  LayerTree tree;
  tree.show_picture(waves());
  EXPECT_FALSE(tree.set_layer_visible("nothing", true));
}

}  // namespace
}  // namespace dobra::gui
