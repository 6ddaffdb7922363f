// The gamepad through the input queue: what its entries begin and what ends that. No gamepad of metal is
// behind any of these tests; GLFW's own reading of one is not tried here.
#define GLFW_INCLUDE_NONE
#include "gui/input/gamepad.h"

#include <vector>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "gui/input/gamepad_source.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

constexpr int left_x = GLFW_GAMEPAD_AXIS_LEFT_X, left_y = GLFW_GAMEPAD_AXIS_LEFT_Y;
constexpr int lb = GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, b = GLFW_GAMEPAD_BUTTON_B;

class GamepadTest : public testing::Test {
 protected:
  std::vector<CommandEdge> edges;
  Stage stage{in_window([](Ui&) {})};
  Gamepad& pad = stage.surface.screen().gamepad();
  PadState state;
  PadChanges changes;

  void SetUp() override {
    stage.surface.screen().keyboard().on_edge = [this](const CommandEdge& e) { edges.push_back(e); };
    pad.came("Example Pad");
    pad.arm(0);
    look();
  }
  /// As the window does, 60 times a second.
  void look() {
    changes.report(state, stage.now_s, [this](const InputEvent& e) { stage.push(e); });
  }
  void run(double seconds) {
    for (int n = static_cast<int>(seconds * 60 + 0.5); n > 0; --n) {
      stage.frame();
      look();
    }
    stage.frame();
  }
  void push_stick(int axis, float place) {
    state.axes[static_cast<std::size_t>(axis)] = place;
    run(0.05);
  }
  void hold(int button, bool down) {
    state.buttons[static_cast<std::size_t>(button)] = down;
    run(0.05);
  }
  /// "+left" and "-left" for what was pressed and let go, "x" for what was taken away.
  std::string reported() {
    std::string all;
    for (const CommandEdge& e : edges) {
      EXPECT_TRUE(e.by_pad);
      all += all.empty() ? "" : " ";
      all += e.down ? "+" : e.cut_off ? "x" : "-";
      all += e.command == Command::stop_all           ? "stop"
             : e.command == Command::jog_left         ? "left"
             : e.command == Command::jog_right        ? "right"
             : e.command == Command::jog_up           ? "up"
             : e.command == Command::jog_down         ? "down"
             : e.command == Command::jog_page_up      ? "third+"
             : e.command == Command::jog_fourth_plus  ? "fourth+"
             : e.command == Command::jog_chosen_plus  ? "chosen+"
             : e.command == Command::jog_chosen_minus ? "chosen-"
                                                      : "?";
    }
    edges.clear();
    return all;
  }
};

TEST_F(GamepadTest, AStickJogsWhileTheDeadManButtonIsHeld) {
  push_stick(left_x, 1);
  EXPECT_EQ(reported(), "") << "not without it";
  push_stick(left_x, 0);
  hold(lb, true);
  push_stick(left_x, 1);
  EXPECT_EQ(reported(), "+right");
  push_stick(left_x, 0.1f);
  EXPECT_EQ(reported(), "-right");
  push_stick(left_x, -1);
  hold(lb, false);
  EXPECT_EQ(reported(), "+left xleft");
}

TEST_F(GamepadTest, EveryStickAndTheDPadHasItsAxis) {
  hold(lb, true);
  const auto one = [&](int axis, float place) {
    push_stick(axis, place);
    push_stick(axis, 0);
    return reported();
  };
  EXPECT_EQ(one(left_y, -1), "+up -up") << "up is plus";
  EXPECT_EQ(one(left_y, 1), "+down -down");
  EXPECT_EQ(one(GLFW_GAMEPAD_AXIS_RIGHT_X, 1), "+third+ -third+");
  EXPECT_EQ(one(GLFW_GAMEPAD_AXIS_RIGHT_Y, -1), "+fourth+ -fourth+");
  EXPECT_EQ(one(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER, 1), "");
  hold(GLFW_GAMEPAD_BUTTON_DPAD_UP, true);
  hold(GLFW_GAMEPAD_BUTTON_DPAD_UP, false);
  hold(GLFW_GAMEPAD_BUTTON_DPAD_LEFT, true);
  hold(GLFW_GAMEPAD_BUTTON_DPAD_LEFT, false);
  EXPECT_EQ(reported(), "+chosen+ -chosen+ +chosen- -chosen-");
}

TEST_F(GamepadTest, AStickPushedBeforeTheDeadManButtonMovesNothing) {
  push_stick(left_x, 1);  // it lies on its stick
  hold(lb, true);
  EXPECT_EQ(reported(), "");
  push_stick(left_x, 0);
  push_stick(left_x, 1);
  EXPECT_EQ(reported(), "+right");
}

TEST_F(GamepadTest, AStickPushedBeforeArmingMovesNothing) {
  pad.disarm(stage.now_s);
  state.axes[left_x] = 1;
  state.buttons[lb] = true;
  changes.forget();
  pad.arm(stage.now_s);
  run(0.5);
  EXPECT_EQ(reported(), "");
}

TEST_F(GamepadTest, AStickIsOnOrOffAndDoesNotFlicker) {
  hold(lb, true);
  for (const float place : {0.3f, 0.5f, 0.59f}) push_stick(left_x, place);
  EXPECT_EQ(reported(), "");
  for (const float place : {0.61f, 0.5f, 0.4f, 0.6f, 0.36f}) push_stick(left_x, place);
  EXPECT_EQ(reported(), "+right");
  push_stick(left_x, 0.34f);
  EXPECT_EQ(reported(), "-right");
}

TEST_F(GamepadTest, OneAxisAtATimeTheOneThatIsPushedMost) {
  hold(lb, true);
  state.axes[left_x] = 0.7f;
  state.axes[left_y] = -0.9f;
  run(0.05);
  EXPECT_EQ(reported(), "+up");
  push_stick(left_x, 1);
  EXPECT_EQ(reported(), "") << "hardly more";
  push_stick(left_y, -0.7f);
  EXPECT_EQ(reported(), "-up +right");
}

TEST_F(GamepadTest, BStopsOnArrivalAndNothingBeginsBeforeTheSticksWereLetGo) {
  hold(lb, true);
  push_stick(left_x, 1);
  reported();
  stage.push(InputEvent::pad_button(b, true, stage.now_s));
  EXPECT_EQ(reported(), "+stop xright") << "before any frame, and the stop first";
  state.buttons[b] = true;
  run(0.2);
  EXPECT_EQ(reported(), "") << "it is down already";
  hold(b, false);
  hold(b, true);
  EXPECT_EQ(reported(), "+stop") << "again: at once";
  push_stick(left_y, 1);
  push_stick(left_x, 0.5f);
  EXPECT_EQ(reported(), "");
  push_stick(left_x, 0);
  push_stick(left_y, 0);
  push_stick(left_y, 1);
  EXPECT_EQ(reported(), "+down");
}

TEST_F(GamepadTest, NothingBeginsAfterAnEscThatCameLater) {
  hold(lb, true);
  state.axes[left_x] = 1;
  look();
  stage.push(InputEvent::key(GLFW_KEY_ESCAPE, true, stage.now_s));
  edges.clear();  // Esc's own
  run(0.5);
  EXPECT_EQ(reported(), "");
}

TEST_F(GamepadTest, AStickHalfWayBackIsNotLetGo) {
  const auto trembles = [this] {
    for (const float place : {0.5f, 0.65f, 0.5f, 0.4f, 1.0f}) push_stick(left_x, place);
  };
  const auto let_go_and_push = [this] {
    push_stick(left_x, 0.3f);
    reported();
    push_stick(left_x, 0.65f);
    return reported();
  };
  hold(lb, true);
  push_stick(left_x, 0.7f);
  push_stick(left_x, 0.5f);
  reported();
  stage.push(InputEvent::key(GLFW_KEY_ESCAPE, true, stage.now_s));
  edges.clear();  // Esc's own
  trembles();
  EXPECT_EQ(reported(), "") << "after Esc";
  stage.push(InputEvent::key(GLFW_KEY_ESCAPE, false, stage.now_s));
  EXPECT_EQ(let_go_and_push(), "+right");
  push_stick(left_x, 0.5f);
  hold(b, true);
  hold(b, false);
  EXPECT_EQ(reported(), "+stop xright");
  trembles();
  EXPECT_EQ(reported(), "") << "after B";
  EXPECT_EQ(let_go_and_push(), "+right");
  hold(lb, false);
  push_stick(left_x, 0.5f);
  hold(lb, true);
  reported();
  trembles();
  EXPECT_EQ(reported(), "") << "after the dead-man button";
  EXPECT_EQ(let_go_and_push(), "+right");
}

TEST_F(GamepadTest, LosingTheWindowDisarms) {
  hold(lb, true);
  push_stick(left_x, 1);
  reported();
  stage.push(InputEvent::focus_lost(stage.now_s));
  EXPECT_EQ(reported(), "xright");
  EXPECT_FALSE(pad.armed());
  EXPECT_NE(pad.take_words().find("lost the keyboard"), std::string::npos);
  EXPECT_EQ(pad.take_words(), "") << "told once";
  run(0.5);
  EXPECT_EQ(reported(), "");
}

TEST_F(GamepadTest, OneThatIsPulledOutStopsAndIsDisarmed) {
  hold(lb, true);
  push_stick(left_x, 1);
  reported();
  changes.report(std::nullopt, stage.now_s, [this](const InputEvent& e) { stage.push(e); });
  EXPECT_EQ(reported(), "xright");
  EXPECT_FALSE(pad.armed());
  EXPECT_FALSE(pad.present());
  EXPECT_NE(pad.take_words().find("gone"), std::string::npos);
}

TEST_F(GamepadTest, OneThatIsPulledOutAtRestHasStoppedNothing) {
  changes.report(std::nullopt, stage.now_s, [this](const InputEvent& e) { stage.push(e); });
  EXPECT_EQ(reported(), "");
  EXPECT_FALSE(pad.armed());
  const std::string words = pad.take_words();
  EXPECT_NE(words.find("gone"), std::string::npos);
  EXPECT_EQ(words.find("stopped"), std::string::npos) << words;
}

TEST_F(GamepadTest, OneThatDoesNotAnswerStopsAndIsDisarmed) {
  hold(lb, true);
  push_stick(left_x, 1);
  reported();
  const double from = stage.now_s;
  while (pad.armed() && stage.now_s < from + 1) stage.frame();  // nobody looks
  EXPECT_LT(stage.now_s - from, 0.25);
  EXPECT_EQ(reported(), "xright");
  EXPECT_NE(pad.take_words().find("had not answered"), std::string::npos);
}

TEST_F(GamepadTest, OneOnWhichNothingChangesIsTakenForLeftAlone) {  // out of reach, it keeps its last state
  const auto is_left_alone = [this](const std::string& jog) {
    reported();
    run(1.8);
    EXPECT_EQ(reported(), "");
    run(0.3);
    EXPECT_EQ(reported(), "x" + jog);
    EXPECT_NE(pad.take_words().find("had changed for 2 s"), std::string::npos);
    run(5);
    EXPECT_EQ(reported(), "") << "it must be let go first";
  };
  hold(lb, true);
  push_stick(left_x, 0.8f);
  is_left_alone("right");
  push_stick(left_x, 0);
  push_stick(left_x, 1);
  is_left_alone("right");
  push_stick(left_x, 0);
  hold(GLFW_GAMEPAD_BUTTON_DPAD_UP, true);
  is_left_alone("chosen+");
  EXPECT_TRUE(pad.armed()) << "a hand that is there goes on";
}

TEST_F(GamepadTest, AStickInAHandIsNeverStill) {
  hold(lb, true);
  push_stick(left_x, 1);
  reported();
  for (int n = 0; n < 20; ++n) {
    push_stick(left_y, n % 2 ? 0.01f : 0.02f);  // across, it is not at its end
    run(0.5);
  }
  EXPECT_EQ(reported(), "");
}

TEST_F(GamepadTest, AtRestItWantsNoFrames) {
  hold(lb, true);
  for (int n = 0; n < 60; ++n) {
    state.axes[left_x] = n % 2 ? 0.02f : 0.01f;  // no stick is quiet
    look();
    ASSERT_FALSE(stage.surface.screen().more_input());
  }
}

TEST_F(GamepadTest, NotArmedItIsNothing) {
  pad.disarm(stage.now_s);
  hold(lb, true);
  push_stick(left_x, 1);
  hold(b, true);
  EXPECT_EQ(reported(), "");
}

}  // namespace
}  // namespace hw::gui
