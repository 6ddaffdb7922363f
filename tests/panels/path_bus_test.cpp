// The path of controllers of one axis each on a bus: any two of them, in one panel for all.
#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

Catalog dmx_at(int id) {
  Catalog c = *find_device_type("dmx-k-sa")->make_catalog({});
  c.address = id;
  c.axes[0].name = c.id();
  return c;
}

class PathBusTest : public testing::Test {
 protected:
  ConsoleStage s;
  const Language& language = find_device_type("dmx-k-sa")->language();
  Example& a = s.add(dmx_at(1), &language);
  Example& b = s.add(dmx_at(2), &language);
  Example& c = s.add(dmx_at(3), &language);
  void SetUp() override {
    for (Example* e : {&a, &b, &c})
      for (auto& p : e->now.params) p.known = true;
    s.console.join({a.tab, b.tab, c.tab}, "DMX 01-03");
    s.run(0.1);
    MUST(s.hand.click("tab/path"));
    s.run(0.1);
  }
  void goes(Example& e, const char* text) { e.tab->desk().programs.texts.set_text(0, text); }
};

TEST_F(PathBusTest, TwoOfItsAxesAreRehearsedTogether) {
  goes(a, "HSPD=5000\nLSPD=100\nACC=100\nINC\nX400\nWAITX\nEND\n");
  goes(b, "HSPD=5000\nLSPD=100\nACC=100\nINC\nX300\nWAITX\nEND\n");
  s.run(0.1);
  MUST(s.hand.click("path/simulate"));
  s.run(0.3);
  EXPECT_THAT(s.value("path/size"), HasSubstr("400")) << s.value("path/size");
  EXPECT_THAT(s.value("path/size"), HasSubstr("300 pulses"));
  MUST(s.hand.click("path/up"));
  MUST(s.hand.click("path/up/03"));
  s.run(0.3);
  EXPECT_THAT(s.value("path/size"), HasSubstr("400"));
  EXPECT_THAT(s.value("path/size"), testing::Not(HasSubstr("300"))) << "the third stands";
}

TEST_F(PathBusTest, OnePanelServesWhicheverIsChosen) {
  MUST(s.hand.click("path/up"));
  MUST(s.hand.click("path/up/03"));
  s.run(0.1);
  EXPECT_EQ(s.value("path/up"), "03");
  MUST(s.hand.click("bus/02"));
  s.run(0.1);
  if (!s.stage.find("path/up")) MUST(s.hand.click("tab/path"));
  s.run(0.1);
  EXPECT_EQ(s.value("path/up"), "03");
}

TEST_F(PathBusTest, WhereTheyHaveBeenIsOneWay) {
  for (int n = 1; n <= 30; ++n) {
    a.now.axes[0].position = Steps(n * 10), b.now.axes[0].position = Steps(n * 20);
    s.run(0.05);
  }
  EXPECT_EQ(s.value("path/view/here"), "300 pulses, 600 pulses");
  MUST(s.hand.click("path/fit"));
  s.run(0.2);
  const gui::Rect r = s.stage.find("path/view")->rect;
  const ImVec2 middle = r.centre();
  s.stage.push(gui::InputEvent::mouse_move(middle.x, middle.y, s.stage.now_s));
  s.run(0.1);
  s.stage.push(gui::InputEvent::mouse_button(0, true, middle, s.stage.now_s));
  s.run(0.05);
  s.stage.push(gui::InputEvent::mouse_button(0, false, middle, s.stage.now_s));
  s.run(0.1);
  EXPECT_THAT(s.value("path/hit"),
              testing::MatchesRegex("01 1[0-9]+ pulses, 02 [23][0-9]+ pulses.*was there.*"));
}

}  // namespace
}  // namespace hw::panels
