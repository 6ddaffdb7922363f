#pragma once
// The blocks of one controller in a window of their own.
#include <string>
#include <utility>

#include "core/device/registry.h"
#include "panels/blocks/blocks.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels::test_blocks {

struct BlocksStage : ::testing::Test {
  explicit BlocksStage(const char* model = "pmx-4ex-sa", void (*with)(Catalog&) = nullptr)
      : type(*find_device_type(model)),
        s(panel, 864, 1200, 1, gui::Tier::wide, true, catalog_of(type, with), &type.language()) {
    s.now.axis_count = static_cast<int>(std::min<std::size_t>(4, s.catalog.axes.size()));
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  static Catalog catalog_of(const DeviceType& type, void (*with)(Catalog&)) {
    Catalog catalog = *type.make_catalog({});
    if (with) with(catalog);
    return catalog;
  }
  std::string text() { return s.value("blocks/text"); }
  std::string value(const std::string& id) { return s.value(id.c_str()); }
  void key(const char* chord) {
    EXPECT_TRUE(s.stage.hand.key(chord));
    s.stage.frames(3);
  }
  /// With Shift held down.
  void shift_click(const char* id) {
    constexpr int left_shift = 340;
    s.stage.push(gui::InputEvent::key(left_shift, true, s.stage.now_s));
    s.stage.frames(1);
    s.click_at(s.stage.find(id)->rect.centre());
    s.stage.push(gui::InputEvent::key(left_shift, false, s.stage.now_s));
    s.stage.frames(2);
  }
  sequence::Editor& editor() { return s.tab.desk().blocks.editor; }
  void load(sequence::StepList steps) {
    sequence::Sequence all = sequence::frame_of(editor().sequence());
    all.steps = std::move(steps);
    editor().load(std::move(all));
    s.stage.frames(6);
  }
  const DeviceType& type;
  Blocks panel;
  hw::test::PanelStage s;
};

}  // namespace hw::panels::test_blocks
