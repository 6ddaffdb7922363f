// What is seen of the blocks where there is little room, and of a controller with one axis.
#include <algorithm>
#include <cmath>

#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

struct Room {
  const char* model;
  int width, height;
  float scale;
  gui::Tier tier;
  int blocks;  ///< wholly in view
};
std::ostream& operator<<(std::ostream& to, const Room& room) { return to << room.model << " " << room.width; }

/// The panel in a window of 1024x700, and in one of 1440x900 pixels at 200 %.
struct LittleRoom : ::testing::TestWithParam<Room> {
  LittleRoom() {
    sequence::Sequence all = sequence::frame_of(s.tab.desk().blocks.editor.sequence());
    all.steps = {{sequence::Speed{{1000, 0, 300}}},
                 {sequence::Delay{1}},
                 {sequence::Delay{2}},
                 {sequence::Delay{3}},
                 {sequence::Delay{4}}};
    s.tab.desk().blocks.editor.load(std::move(all));
    s.stage.frames(6);
  }
  [[nodiscard]] int in_view() {
    int count = 0;
    for (const gui::Widget& w : s.stage.surface.screen().registry().widgets())
      if (w.id.starts_with("blocks/") && w.kind == gui::Kind::button && w.id.size() == 8 &&
          w.wholly_in_view())
        ++count;
    return count;
  }
  const Room& room = GetParam();
  const DeviceType& type = *find_device_type(room.model);
  Blocks panel;
  hw::test::PanelStage s{
      panel, room.width, room.height, room.scale, room.tier, true, *type.make_catalog({}), &type.language()};
};

TEST_P(LittleRoom, TheBarIsOneRow) {
  const float y = s.stage.find("blocks/run")->rect.min.y;
  for (const char* id : {"blocks/hold", "blocks/step", "blocks/stop", "blocks/to_program", "blocks/from_text",
                         "blocks/undo", "blocks/redo", "blocks/aside", "blocks/open", "blocks/save"}) {
    const gui::Widget* w = s.stage.find(id);
    if (!w && std::string_view(id) == "blocks/step") continue;  // not of every controller
    ASSERT_TRUE(w) << id;
    EXPECT_EQ(w->rect.min.y, y) << id;
    EXPECT_LE(w->rect.max.x, static_cast<float>(room.width) * room.scale) << id;
    EXPECT_NE(w->label, "") << id << ": it has a name, if only an icon is drawn";
  }
}

TEST_P(LittleRoom, BlocksAreInViewBelowIt) { EXPECT_GE(in_view(), room.blocks); }

std::vector<Room> little_rooms() {
  std::vector<Room> all;
  for (const char* model : {"vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"}) {
    all.push_back({model, 704, 460, 1, gui::Tier::medium, 5});
    all.push_back({model, 720, 258, 2, gui::Tier::narrow, 3});
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Each, LittleRoom, ::testing::ValuesIn(little_rooms()));

struct BlocksOfOneAxis : test_blocks::BlocksStage {
  BlocksOfOneAxis() : BlocksStage("dmx-k-sa") {}
};
TEST_F(BlocksOfOneAxis, ItsPlaceIsDrawnOverTimeAndAClickOnItChoosesTheBlock) {
  sequence::Move there;
  there.to[0] = 4000;
  load({{sequence::Speed{{1000, 100, 300}}}, {there}});
  s.stage.frames(10);
  const gui::Widget* path = s.stage.find("blocks/path");
  ASSERT_TRUE(path);
  s.click_at(path->rect.centre());  // a ramp up, and the same down: it passes the middle
  s.stage.frames(4);
  EXPECT_TRUE(s.stage.find("blocks/2/to/X")) << "the move is open";
}

struct BlocksOfOtherAxes : test_blocks::BlocksStage {
  using BlocksStage::BlocksStage;
};
TEST_F(BlocksOfOtherAxes, AnAxisThatMovesAloneIsSeenOverTime) {
  sequence::Move there;
  there.to[2] = 4000;
  load({{sequence::Speed{{1000, 100, 300}}}, {there}});
  s.stage.frames(10);
  s.click_at(s.stage.find("blocks/path")->rect.centre());
  s.stage.frames(4);
  EXPECT_TRUE(s.stage.find("blocks/2/to/Z"));
}

}  // namespace
}  // namespace hw::panels
