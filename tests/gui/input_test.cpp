// The input queue and the keyboard's map: taps between frames are kept, what begins something waits for its
// turn, what ends something does not.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "gui/input/input_queue.h"
#include "gui/input/keyboard.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/touch.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

TEST(InputQueue, AReleaseWaitsForTheFrameAfterItsPress) {
  InputQueue queue;
  ImGuiIO io;
  queue.push(InputEvent::key(GLFW_KEY_ENTER, true, 0));
  queue.push(InputEvent::key(GLFW_KEY_ENTER, false, 0));
  EXPECT_TRUE(queue.feed(io)) << "more is waiting";
  EXPECT_TRUE(io.KeysDown[GLFW_KEY_ENTER]);
  EXPECT_FALSE(queue.feed(io));
  EXPECT_FALSE(io.KeysDown[GLFW_KEY_ENTER]);
}

TEST(InputQueue, FastTypingNeedsOneFrame) {
  std::string text;
  Stage stage(in_window([&](Ui& ui) { text_field(ui, "f", "field", text); }));
  ASSERT_TRUE(stage.hand.click("f"));
  for (const char c : std::string("I1M")) {
    stage.push(InputEvent::key(GLFW_KEY_LEFT_SHIFT, true, 0));
    stage.push(InputEvent::key(c, true, 0));
    stage.push(InputEvent::text(static_cast<unsigned>(c), 0));
    stage.push(InputEvent::key(c, false, 0));
    stage.push(InputEvent::key(GLFW_KEY_LEFT_SHIFT, false, 0));
  }
  stage.frames(1);
  EXPECT_EQ(text, "I1M");
}

TEST(InputQueue, AShortcutComesAfterWhatWasTypedBeforeIt) {
  std::string text, seen;
  Stage stage(in_window([&](Ui& ui) { text_field(ui, "f", "field", text); }));
  ASSERT_TRUE(stage.hand.click("f"));
  stage.surface.screen().keyboard().on_edge = [&](const CommandEdge&) { seen = text; };
  for (const char c : std::string("I1M-300")) stage.push(InputEvent::text(static_cast<unsigned>(c), 0));
  stage.push(InputEvent::key(GLFW_KEY_LEFT_CONTROL, true, 0));
  stage.push(InputEvent::key(GLFW_KEY_ENTER, true, 0));
  EXPECT_EQ(seen, "") << "not before its turn";
  stage.frames(6);
  EXPECT_EQ(seen, "I1M-300");
}

TEST(InputQueue, NothingBeginsAfterAnEscThatCameLater) {
  int begun = 0, stops = 0;
  Stage stage(in_window([&](Ui& ui) { button(ui, "go", "Go"); }));
  stage.surface.screen().keyboard().on_edge = [&](const CommandEdge& e) {
    if (e.command == Command::stop_all)
      ++stops;
    else if (e.down)
      ++begun;
  };
  stage.push(InputEvent::key(GLFW_KEY_F5, true, 0));
  stage.push(InputEvent::key(GLFW_KEY_RIGHT, true, 0));
  stage.push(InputEvent::key(GLFW_KEY_ESCAPE, true, 0));
  EXPECT_EQ(stops, 1) << "at once, before any frame";
  stage.frames(6);
  EXPECT_EQ(begun, 0);
}

TEST(InputQueue, AnArrowRightAfterEnterBelongsToTheFieldThatKeepsTheKeyboard) {
  std::string text;
  int jogs = 0;
  FieldOptions options;
  options.keep_focus = true;
  Stage stage(in_window([&](Ui& ui) {
    if (text_field(ui, "f", "field", text, options).entered) text.clear();
  }));
  ASSERT_TRUE(stage.hand.click("f"));
  stage.surface.screen().keyboard().on_edge = [&](const CommandEdge&) { ++jogs; };
  stage.push(InputEvent::text('a', 0));
  for (const int key : {GLFW_KEY_ENTER, GLFW_KEY_UP}) {
    stage.push(InputEvent::key(key, true, 0));
    stage.push(InputEvent::key(key, false, 0));
  }
  stage.push(InputEvent::text('b', 0));
  stage.frames(20);
  EXPECT_EQ(jogs, 0);
  EXPECT_EQ(text, "b") << "and nothing that is typed meanwhile is lost";
}

TEST(InputQueue, AnEarlierPlaceOfTheMouseDoesNotSlipUnderALaterPress) {
  InputQueue queue;
  ImGuiIO io;
  queue.push(InputEvent::mouse_move(10, 10, 0));
  queue.push(InputEvent::mouse_button(0, true, ImVec2(10, 10), 0));
  queue.push(InputEvent::mouse_move(90, 90, 0));
  EXPECT_TRUE(queue.feed(io));
  EXPECT_EQ(io.MousePos.x, 10);
  EXPECT_TRUE(io.MouseDown[0]);
  queue.feed(io);
  EXPECT_EQ(io.MousePos.x, 90);
}

TEST(InputQueue, APressCountsWhereItIsWithoutAMoveBeforeIt) {
  int clicks = 0;
  Stage stage(in_window([&](Ui& ui) { clicks += button(ui, "go", "Go").clicked; }));
  ASSERT_TRUE(stage.hand.click("go"));
  const ImVec2 at = stage.find("go")->rect.centre();
  for (int n = 0; n < 2; ++n) {
    stage.hand.lose_focus();  // and it comes back to a pointer that rests
    stage.push(InputEvent::mouse_button(0, true, at, stage.now_s));
    stage.push(InputEvent::mouse_button(0, false, at, stage.now_s));
    stage.frames(4);
  }
  EXPECT_EQ(clicks, 3);
}

TEST(InputQueue, ModifiersCountAsTheyAreWithEachPress) {
  InputQueue queue;
  ImGuiIO io;
  queue.push(InputEvent::key(GLFW_KEY_A, true, 0).with({.ctrl = true}));
  queue.feed(io);
  EXPECT_TRUE(io.KeyCtrl) << "it went down in another window";
  queue.push(InputEvent::mouse_button(0, true, ImVec2(1, 1), 0).with({.shift = true}));
  queue.feed(io);
  EXPECT_FALSE(io.KeyCtrl) << "and up in another one";
  EXPECT_TRUE(io.KeyShift);
  queue.push(InputEvent::key(GLFW_KEY_LEFT_SHIFT, false, 0).with({.shift = true}));
  queue.feed(io);
  EXPECT_FALSE(io.KeyShift) << "told of its release, the window system says how it was before";
}

TEST(InputQueue, TextKeepsItsOrderWithEditingKeys) {
  std::string text;
  Stage stage(in_window([&](Ui& ui) { text_field(ui, "f", "field", text); }));
  ASSERT_TRUE(stage.hand.click("f"));
  for (const char c : std::string("ab")) stage.push(InputEvent::text(static_cast<unsigned>(c), 0));
  for (const int key : {GLFW_KEY_BACKSPACE, GLFW_KEY_BACKSPACE}) {
    stage.push(InputEvent::key(key, true, 0));
    stage.push(InputEvent::key(key, false, 0));
  }
  stage.push(InputEvent::text('c', 0));
  stage.frames(12);
  EXPECT_EQ(text, "c");
}

TEST(InputQueue, FocusLossLetsGoOfEverything) {
  InputQueue queue;
  ImGuiIO io;
  queue.push(InputEvent::mouse_button(0, true, ImVec2(10, 10), 0));
  queue.feed(io);
  queue.push(InputEvent::key(GLFW_KEY_HOME, true, 0));
  queue.feed(io);
  queue.push(InputEvent::focus_lost(0));
  queue.feed(io);
  EXPECT_FALSE(io.MouseDown[0]);
  EXPECT_FALSE(io.KeysDown[GLFW_KEY_HOME]);
}

TEST(Touch, WhereThereIsNoRoomNothingBreaks) {
  bool drawn = false;
  Stage stage(in_window([&](Ui& ui) {
    touch(ui, {"none", Kind::button, "None", {}, {}, false, {}}, ImVec2(0, -8));
    drawn = true;
  }));
  stage.frames(2);
  EXPECT_TRUE(drawn);
}

struct Recorder {
  Keyboard keyboard;
  std::vector<std::pair<Command, bool>> edges;
  Recorder() {
    keyboard.on_edge = [this](const CommandEdge& e) { edges.emplace_back(e.command, e.down); };
  }
  bool see(const InputEvent& event) { return keyboard.on_arrival(event) || keyboard.in_turn(event); }
  bool key(int code, bool down) { return see(InputEvent::key(code, down, 0)); }
  using Edges = std::vector<std::pair<Command, bool>>;
};

TEST(Keyboard, EscStopsAlsoWhileTyping) {
  Recorder r;
  r.keyboard.set_typing(true);
  EXPECT_TRUE(r.key(GLFW_KEY_ESCAPE, true)) << "ImGui must not see it";
  EXPECT_EQ(r.edges, (Recorder::Edges{{Command::stop_all, true}}));
}

TEST(Keyboard, EscStopsWithAnyModifier) {
  Recorder r;
  r.key(GLFW_KEY_LEFT_CONTROL, true);
  EXPECT_TRUE(r.key(GLFW_KEY_ESCAPE, true));
  EXPECT_EQ(r.edges.size(), 1u);
}

TEST(Keyboard, JogKeysHoldAndLetGoOnce) {
  Recorder r;
  EXPECT_TRUE(r.key(GLFW_KEY_RIGHT, true));
  EXPECT_TRUE(r.key(GLFW_KEY_RIGHT, true)) << "a repeat";
  EXPECT_TRUE(r.keyboard.held(Command::jog_right));
  EXPECT_TRUE(r.key(GLFW_KEY_RIGHT, false));
  EXPECT_FALSE(r.keyboard.held(Command::jog_right));
  EXPECT_EQ(r.edges, (Recorder::Edges{{Command::jog_right, true}, {Command::jog_right, false}}));
}

TEST(Keyboard, ArrowsBelongToTheTextWhileTyping) {
  Recorder r;
  r.keyboard.set_typing(true);
  EXPECT_FALSE(r.key(GLFW_KEY_RIGHT, true));
  EXPECT_FALSE(r.key(GLFW_KEY_RIGHT, false));
  EXPECT_TRUE(r.edges.empty());
}

TEST(Keyboard, AJogThatBeganGoesOnUntilItsKeyIsUp) {
  Recorder r;
  r.key(GLFW_KEY_UP, true);
  r.keyboard.set_typing(true);
  EXPECT_TRUE(r.key(GLFW_KEY_UP, false));
  EXPECT_EQ(r.edges.back(), (std::pair{Command::jog_up, false}));
}

TEST(Keyboard, FocusLossReleasesHeldJogs) {
  Recorder r;
  r.key(GLFW_KEY_LEFT, true);
  r.see(InputEvent::focus_lost(1));
  EXPECT_EQ(r.edges.back(), (std::pair{Command::jog_left, false}));
  EXPECT_FALSE(r.keyboard.held(Command::jog_left));
}

TEST(Keyboard, ModifiersMakeTheDifference) {
  Recorder r;
  EXPECT_FALSE(r.key(GLFW_KEY_ENTER, true));
  r.key(GLFW_KEY_ENTER, false);
  r.key(GLFW_KEY_LEFT_CONTROL, true);
  EXPECT_TRUE(r.key(GLFW_KEY_ENTER, true));
  EXPECT_TRUE(r.key(GLFW_KEY_TAB, true));
  EXPECT_FALSE(r.key(GLFW_KEY_LEFT, true)) << "Ctrl+Left does not jog";
  EXPECT_EQ(r.edges, (Recorder::Edges{{Command::run, true}, {Command::next_controller, true}}));
}

// The window manager's, or a menu's: Alt+Left goes back elsewhere, and must move nothing here.
TEST(Keyboard, WithAltOrSuperAKeyIsNotOurs) {
  for (const int other : {GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER}) {
    Recorder r;
    r.key(other, true);
    for (const int key : {GLFW_KEY_RIGHT, GLFW_KEY_PAGE_UP, GLFW_KEY_F5}) {
      EXPECT_FALSE(r.key(key, true));
      EXPECT_FALSE(r.key(key, false));
    }
    EXPECT_TRUE(r.edges.empty());
    EXPECT_TRUE(r.key(GLFW_KEY_ESCAPE, true)) << "Esc stops with anything";
    r.key(GLFW_KEY_ESCAPE, false);
    r.key(other, false);
    EXPECT_TRUE(r.key(GLFW_KEY_RIGHT, true));
    r.key(other, true);
    EXPECT_TRUE(r.key(GLFW_KEY_RIGHT, false)) << "and one that began before ends";
    EXPECT_EQ(r.edges.back(), (std::pair{Command::jog_right, false}));
  }
}

TEST(Keyboard, AModifierIsForgottenWithTheFocus) {
  Recorder r;
  r.key(GLFW_KEY_LEFT_ALT, true);
  r.key(GLFW_KEY_LEFT_SUPER, true);
  r.see(InputEvent::focus_lost(1));
  EXPECT_TRUE(r.key(GLFW_KEY_RIGHT, true));
}

TEST(Keyboard, AModifierThatWentDownOrUpElsewhereCountsAsItIs) {
  Recorder r;
  EXPECT_FALSE(r.see(InputEvent::key(GLFW_KEY_RIGHT, true, 0).with({.alt = true})));
  EXPECT_TRUE(r.see(InputEvent::key(GLFW_KEY_ENTER, true, 0).with({.ctrl = true})));
  EXPECT_EQ(r.edges, (Recorder::Edges{{Command::run, true}}));
  r.key(GLFW_KEY_LEFT_ALT, true);
  EXPECT_TRUE(r.see(InputEvent::key(GLFW_KEY_LEFT, true, 0).with({})));
  EXPECT_EQ(r.edges.back(), (std::pair{Command::jog_left, true}));
}

TEST(Keyboard, TheMapOpensByTheCharacterOutsideOfText) {
  Recorder r;
  EXPECT_TRUE(r.see(InputEvent::text('?', 0)));
  r.keyboard.set_typing(true);
  EXPECT_FALSE(r.see(InputEvent::text('?', 0)));
  EXPECT_EQ(r.edges.size(), 1u);
}

TEST(Keyboard, BehindADialogOnlyStopAndTheSizesAct) {
  Recorder r;
  r.keyboard.set_typing(true);
  r.keyboard.set_covered(true);
  r.key(GLFW_KEY_LEFT_CONTROL, true);
  for (const int key : {GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER, GLFW_KEY_S, GLFW_KEY_O, GLFW_KEY_TAB}) {
    EXPECT_TRUE(r.key(key, true)) << "nor is it the Enter of the dialog";
    r.key(key, false);
  }
  EXPECT_TRUE(r.edges.empty());
  r.key(GLFW_KEY_EQUAL, true);
  r.key(GLFW_KEY_ESCAPE, true);
  EXPECT_EQ(r.edges, (Recorder::Edges{{Command::larger, true}, {Command::stop_all, true}}));
  r.key(GLFW_KEY_LEFT_CONTROL, false);
  EXPECT_FALSE(r.key(GLFW_KEY_ENTER, true)) << "a plain one is";
}

TEST(Keyboard, EachShortcutOfTheMapIsExplained) {
  for (const Shortcut& s : shortcuts()) EXPECT_EQ(s.keys.empty(), s.does.empty()) << s.keys;
}

}  // namespace
}  // namespace hw::gui
