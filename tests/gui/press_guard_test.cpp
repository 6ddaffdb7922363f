// A press that starts motion counts only on a button that has stood still.
#include "gui/input/press_guard.h"

#include <gtest/gtest.h>

#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/message.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

/// A moving button, a plain one and a jog button in one line, where the test wants them.
class PressGuardTest : public testing::Test {
 protected:
  ImVec2 at{100, 100};
  std::string_view off;
  bool shown = true, ask = false;
  float scrolled = -1;  ///< how far, in a part that scrolls; -1: in none
  int gone = 0, plain = 0, started = 0, ended = 0;
  Stage stage{in_window([this](Ui& ui) { draw(ui); }), 640, 400};

  void draw(Ui& ui) {
    if (shown) draw_buttons(ui);
    if (dialog(ui, "ask", ask, {.title = "Run it", .sentences = "It moves.", .yes = "Run", .moving = true}) ==
        Answer::yes)
      ++gone;
  }
  void draw_buttons(Ui& ui) {
    if (scrolled >= 0) {
      ImGui::BeginChild("part", ImVec2(400, 200));
      ImGui::SetScrollY(scrolled);
      ImGui::Dummy(ImVec2(1, 100));
    } else {
      ImGui::SetCursorScreenPos(at);
    }
    gone += button(ui, "go", "Go", {.disabled = off, .width = 80, .moving = true}).clicked;
    ImGui::SameLine();
    plain += button(ui, "plain", "Copy", {.width = 80}).clicked;
    ImGui::SameLine();
    const Hold hold = hold_button(ui, "jog", "+", {});
    started += hold.started;
    ended += hold.ended;
    if (scrolled < 0) return;
    ImGui::Dummy(ImVec2(1, 400));
    ImGui::EndChild();
  }
  /// As a hand does it, at once.
  void press(const char* id) {
    const ImVec2 where = stage.find(id)->rect.centre();
    stage.push(InputEvent::mouse_move(where.x, where.y, stage.now_s));
    stage.push(InputEvent::mouse_button(0, true, where, stage.now_s));
    stage.frames(2);
  }
  void let_go() {
    stage.push(InputEvent::mouse_button(0, false, stage.surface.screen().input().pointer(), stage.now_s));
    stage.frames(2);
  }
  void click(const char* id) {
    press(id);
    let_go();
  }
  void wait(double seconds) { stage.frames(static_cast<int>(seconds * 60 + 0.5)); }
  void go_is_not_taken_before_it_has_stood() {
    click("go");
    EXPECT_EQ(gone, 0);
    EXPECT_TRUE(shows_not_taken("go"));
    wait(0.3);
    click("go");
    EXPECT_EQ(gone, 1);
    EXPECT_FALSE(shows_not_taken("go"));
  }
  [[nodiscard]] bool shows_not_taken(const char* id) { return stage.find(id)->press_ignored; }
};

TEST_F(PressGuardTest, AButtonThatJustAppearedTakesNoPress) {
  wait(0.1);
  go_is_not_taken_before_it_has_stood();
}

TEST_F(PressGuardTest, AButtonThatMovedUnderTheHandTakesNoPress) {
  wait(1);
  at.y += 1;
  stage.frame();
  click("go");
  EXPECT_EQ(gone, 0);
  EXPECT_TRUE(shows_not_taken("go"));
}

TEST_F(PressGuardTest, ItIsShownForAWhileOnly) {
  wait(0.1);
  click("go");
  wait(1.5);
  EXPECT_TRUE(shows_not_taken("go"));
  wait(1);
  EXPECT_FALSE(shows_not_taken("go"));
}

TEST_F(PressGuardTest, ThreeTenthsOfASecondAreEnough) {
  wait(1);
  at.x += 50;
  stage.frame();
  wait(0.31);
  click("go");
  EXPECT_EQ(gone, 1);
}

TEST_F(PressGuardTest, HoldingItDoesNotMakeItCountAndLettingGoNeither) {
  wait(0.1);
  press("jog");
  wait(1);
  EXPECT_EQ(started, 0);
  let_go();
  EXPECT_EQ(started + ended, 0);
  press("jog");
  EXPECT_EQ(started, 1);
  at.y += 30;  // it moves under a hand that holds it: letting go counts wherever
  stage.frame();
  let_go();
  EXPECT_EQ(ended, 1);
}

TEST_F(PressGuardTest, AButtonThatMovesNothingTakesAPressAtOnce) {
  stage.frames(2);
  click("plain");
  EXPECT_EQ(plain, 1);
}

TEST_F(PressGuardTest, ComingAliveIsAChange) {
  off = "A program runs.";
  wait(1);
  off = {};
  stage.frame();
  go_is_not_taken_before_it_has_stood();
}

TEST_F(PressGuardTest, GoneForAFrameIsForgotten) {
  wait(1);
  shown = false;
  stage.frame();
  shown = true;
  stage.frame();
  click("go");
  EXPECT_EQ(gone, 0);
}

TEST_F(PressGuardTest, ScrollingMovesIt) {
  scrolled = 0;
  wait(1);
  scrolled = 60;
  stage.frames(2);
  click("go");
  EXPECT_EQ(gone, 0);
  wait(0.4);
  click("go");
  EXPECT_EQ(gone, 1);
}

TEST_F(PressGuardTest, AFramelessRestIsStandingStill) {
  wait(1);
  stage.now_s += 100;  // at rest nothing is drawn
  click("go");
  EXPECT_EQ(gone, 1);
}

TEST_F(PressGuardTest, ADialogThatStartsMotionWaitsAndWhatItCoveredToo) {
  wait(1);
  ask = true;
  stage.frames(3);
  click("ask/yes");
  EXPECT_EQ(gone, 0);
  EXPECT_TRUE(shows_not_taken("ask/yes"));
  click("ask/no");
  ASSERT_FALSE(ask);
  click("go");
  EXPECT_EQ(gone, 0) << "it had been under the dialog";
  wait(0.4);
  click("go");
  EXPECT_EQ(gone, 1);
}

TEST_F(PressGuardTest, TheKeyboardMeansItByName) {
  stage.frames(2);
  ASSERT_TRUE(stage.hand.key("Tab").has_value());
  at.y += 40;
  ASSERT_TRUE(stage.hand.key("Enter").has_value());
  at.y += 40;
  ASSERT_TRUE(stage.hand.key("Enter").has_value());
  EXPECT_EQ(gone, 1);
}

TEST_F(PressGuardTest, TheHandOfAScriptWaitsForWhatADialogHasJustUncovered) {
  wait(1);
  ask = true;
  stage.frames(3);
  ask = false;
  stage.frame();
  ASSERT_TRUE(stage.hand.click("go").has_value());
  EXPECT_EQ(gone, 1);
}

TEST_F(PressGuardTest, TheHandOfAScriptWaitsByItself) {
  stage.frames(2);
  ASSERT_TRUE(stage.hand.click("go").has_value());
  EXPECT_EQ(gone, 1);
  at.y += 30;
  stage.frame();
  ASSERT_TRUE(stage.hand.press("jog").has_value());
  EXPECT_EQ(started, 1);
  ASSERT_TRUE(stage.hand.release("jog").has_value());
}

}  // namespace
}  // namespace hw::gui
