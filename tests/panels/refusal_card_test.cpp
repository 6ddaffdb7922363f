// What was refused, on a card: over nothing that moves metal or stops it, and gone when it is closed.
#include "panels/refusal_card.h"

#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class RefusalCardTest : public testing::Test {
 protected:
  void open(int width, int height, const char* panel = "program") {
    s = std::make_unique<ConsoleStage>(width, height);
    Catalog c = test::full_catalog();
    example = &s->add(std::move(c));
    example->tab->panels.in_front = panel;
    s->run(0.2);
  }
  void refuse(const char* axis) {
    MUST(s->hand.type(std::string("goto/") + axis, "999999999\n"));
    s->run(0.2);
  }
  [[nodiscard]] const Widget* find(const char* id) { return s->stage.find(id); }
  /// On the card of X lies nothing but its own.
  void expect_clear(const char* where) {
    const Rect card = find("goto/X/refused")->rect;
    for (const Widget& w : s->stage.surface.screen().registry().widgets()) {
      const bool own = w.id == "goto/X/nearest";
      const Rect& r = w.rect;
      const bool over =
          r.min.x < card.max.x && card.min.x < r.max.x && r.min.y < card.max.y && card.min.y < r.max.y;
      const bool pressed_by_hands = (w.moving || w.stops) && !own && w.in_view();
      EXPECT_FALSE(pressed_by_hands && over) << where << ": " << w.id;
    }
  }

  std::unique_ptr<ConsoleStage> s;
  Example* example = nullptr;
};

TEST_F(RefusalCardTest, LiesOverTheCentreBesideItsRow) {
  open(1440, 900);
  refuse("X");
  const Rect card = find("goto/X/refused")->rect, row = find("goto/X")->rect;
  EXPECT_GE(card.min.x, 304);
  EXPECT_LT(card.min.y, row.centre().y);
  EXPECT_GT(card.max.y, row.centre().y);
  EXPECT_TRUE(find("goto/X/nearest"));
}

TEST_F(RefusalCardTest, LiesOnNothingThatMovesOrStops) {
  for (const char* panel : {"program", "control", "list", "setup"})
    for (const auto& [width, height] : {std::pair(1440, 900), std::pair(1280, 780), std::pair(1024, 700)}) {
      open(width, height, panel);
      refuse("X");
      expect_clear(panel);
    }
}

TEST_F(RefusalCardTest, IsABarOverTheStatusLineInANarrowWindow) {
  open(720, 450, "jog");
  refuse("X");
  EXPECT_EQ(find("goto/X/refused")->rect.min.y, find("status/text")->rect.min.y);
  MUST(s->hand.click("goto/X/refused/close"));
  s->run(0.1);
  EXPECT_FALSE(find("goto/X/refused"));
}

TEST_F(RefusalCardTest, EachRowHasItsOwnAndNoneLiesOnAnother) {
  open(1440, 900);
  MUST(s->hand.click("goto/axis"));
  MUST(s->hand.click("goto/axis/All axes"));
  s->run(0.2);
  refuse("X");
  refuse("U");
  const Rect x = find("goto/X/refused")->rect, u = find("goto/U/refused")->rect;
  EXPECT_TRUE(x.max.y <= u.min.y || u.max.y <= x.min.y || x.max.x <= u.min.x || u.max.x <= x.min.x);
  MUST(s->hand.click("goto/X/refused/close"));
  s->run(0.1);
  EXPECT_FALSE(find("goto/X/refused"));
  EXPECT_TRUE(find("goto/U/refused"));
}

TEST_F(RefusalCardTest, AButtonOnTheCardTakesNoPressThatWasUnderWay) {
  open(1440, 900);
  refuse("X");
  const ImVec2 at = find("goto/X/nearest")->rect.centre();
  MUST(s->hand.click("goto/X/refused/close"));
  MUST(s->hand.type("goto/X", "999999999"));
  example->sent.clear();
  MUST(s->hand.click("goto/X/go"));  // the card comes, and a second press comes with it
  s->stage.push(InputEvent::mouse_move(at.x, at.y, s->stage.now_s));
  s->stage.push(InputEvent::mouse_button(0, true, at, s->stage.now_s));
  s->stage.frames(2);
  s->stage.push(InputEvent::mouse_button(0, false, at, s->stage.now_s));
  s->stage.frames(2);
  ASSERT_TRUE(find("goto/X/nearest"));
  EXPECT_TRUE(find("goto/X/nearest")->press_ignored);
  EXPECT_EQ(example->count<intent::MoveTo>(), 0);
  MUST(s->hand.click("goto/X/nearest"));
  EXPECT_EQ(example->count<intent::MoveTo>(), 1);
}

TEST_F(RefusalCardTest, OfAFormPushesNoOtherForm) {
  open(1440, 900, "control");
  const auto places = [&] {
    std::vector<float> all;
    for (const Widget& w : s->stage.surface.screen().registry().widgets())
      if (w.moving) all.push_back(w.rect.min.y);
    return all;
  };
  MUST(s->hand.type("action/change_speed/speed", "0"));
  MUST(s->hand.click("action/change_speed/go"));
  s->run(0.2);
  ASSERT_TRUE(find("action/change_speed/refused"));
  const auto with_card = places();
  MUST(s->hand.click("action/change_speed/refused/close"));
  s->run(0.2);
  ASSERT_FALSE(find("action/change_speed/refused"));
  EXPECT_EQ(places(), with_card);
}

}  // namespace
}  // namespace hw::panels
