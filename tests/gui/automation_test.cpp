// Hands of scripts: they do what a person could do, and say why not when one could not.
#include "gui/surface/automation.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text_field.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

TEST(Automation, UnknownAndDisabledAreRefusedWithASentence) {
  Stage stage(
      in_window([](Ui& ui) { button(ui, "program/run", "Run", {.disabled = "The program is empty."}); }));
  auto r = stage.hand.click("program/fly");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().what, "There is no widget 'program/fly' on the screen.");
  r = stage.hand.click("program/run");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().what, "'program/run' is disabled: The program is empty.");
  EXPECT_FALSE(stage.hand.type("program/run", "x"));
  EXPECT_FALSE(stage.hand.release("program/run"));
}

TEST(Automation, DrawsNoFrameMoreOnceTheRunIsOver) {
  Stage stage(in_window([](Ui& ui) { button(ui, "program/run", "Run"); }));
  int left = 3;
  Automation hand(
      stage.surface,
      [&] {
        --left;
        stage.frame();
      },
      [&] { return stage.now_s; }, [&] { return left == 0; });
  hand.frame(1000);
  EXPECT_EQ(left, 0);
  EXPECT_TRUE(hand.key("Escape"));
  EXPECT_EQ(left, 0);
}

TEST(Automation, ScrollsIntoView) {
  int clicked = 0;
  Stage stage(in_window([&](Ui& ui) {
    ImGui::BeginChild("list", ImVec2(300, 200));
    for (int i = 0; i < 40; ++i)
      if (button(ui, "row/" + std::to_string(i), "Row").clicked) clicked = i;
    ImGui::EndChild();
  }));
  ASSERT_TRUE(stage.hand.click("row/33"));
  EXPECT_EQ(clicked, 33);
  ASSERT_TRUE(stage.hand.click("row/2"));
  EXPECT_EQ(clicked, 2);
}

TEST(Automation, FollowsWhatHasNotComeToRest) {
  int drawn = 0, moves_at = 0, clicked = 0;
  Stage stage(in_window([&](Ui& ui) {
    ImGui::SetCursorScreenPos(ImVec2(20, drawn++ < moves_at ? 20 : 200));
    if (button(ui, "row", "Row").clicked) ++clicked;
  }));
  moves_at = drawn + 1;
  stage.frame();
  moves_at = drawn + 1;  // under the pointer on its way
  ASSERT_TRUE(stage.hand.click("row"));
  EXPECT_EQ(clicked, 1);
}

TEST(Automation, ListsKindLabelPlaceAndState) {
  std::string text = "12.5";
  Stage stage(in_window([&](Ui& ui) {
                button(ui, "go", "Go", {.width = 64, .moving = true});
                text_field(ui, "goto/1", "target", text, {.width = 104});
              }),
              800, 600, 2);
  stage.frames(2);
  const auto all = stage.hand.list();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].id, "go");
  EXPECT_EQ(all[0].kind, "button");
  EXPECT_EQ(all[0].label, "Go");
  EXPECT_TRUE(all[0].moving);
  EXPECT_EQ(all[0].width, 64) << "logical pixels at any scale";
  EXPECT_EQ(all[1].kind, "field");
  EXPECT_EQ(all[1].value, "12.5");
}

TEST(Automation, ValuesArePlainAscii) {
  Stage stage(in_window([](Ui& ui) {
    button(ui, "b", "x");
    Widget w;
    w.id = "dro/1/position";
    w.value =
        "\xE2\x88\x92"
        "57\xE2\x80\x89"
        "000 \xC2\xB5m";
    w.kind = Kind::text;
    ui.registry.add(w);
  }));
  EXPECT_EQ(*stage.hand.value("dro/1/position"), "-57000 um");
}

TEST(Automation, TypeReplacesAndEnterEnters) {
  std::string text = "old";
  int entered = 0;
  Stage stage(in_window([&](Ui& ui) { entered += text_field(ui, "f", "field", text).entered; }));
  ASSERT_TRUE(stage.hand.type("f", "new text"));
  EXPECT_EQ(text, "new text");
  EXPECT_EQ(entered, 0);
  ASSERT_TRUE(stage.hand.type("f", "model@tcp:1\n"));
  EXPECT_EQ(text, "model@tcp:1");
  EXPECT_EQ(entered, 1);
  ASSERT_TRUE(stage.hand.type("f", ""));
  EXPECT_EQ(text, "");
}

TEST(Automation, KeysByName) {
  for (const char* good :
       {"Escape", "Ctrl+Enter", "F5", "Left", "PageUp", "Ctrl+Shift+Tab", "a", "?", "Ctrl+S", "+"})
    EXPECT_TRUE(read_chord(good)) << good;
  for (const char* bad : {"", "Hyper+A", "F13", "Entr", "Ctrl+"}) EXPECT_FALSE(read_chord(bad)) << bad;
}

TEST(Automation, EscapeReachesTheStopBeforeAnything) {
  int stops = 0;
  std::string text;
  Stage stage(in_window([&](Ui& ui) { text_field(ui, "f", "field", text); }));
  stage.surface.screen().keyboard().on_edge = [&](const CommandEdge& e) {
    stops += e.command == Command::stop_all;
  };
  ASSERT_TRUE(stage.hand.click("f"));
  ASSERT_TRUE(stage.hand.key("Escape"));
  EXPECT_EQ(stops, 1);
}

TEST(Automation, StopAllWorksUnderADialogOnThePress) {
  bool open = true;
  int stops = 0;
  Stage stage(in_window([&](Ui& ui) {
    stops += stop_button(ui, ui.px(200, 56)).clicked;
    dialog(ui, "confirm", open, {"Store?", "Two writes are used.", "Store", "Cancel"});
  }));
  stage.frames(3);
  ASSERT_TRUE(stage.hand.press("stop_all"));
  EXPECT_EQ(stops, 1) << "before letting go";
  ASSERT_TRUE(stage.hand.release("stop_all"));
  EXPECT_EQ(stops, 1);
  EXPECT_TRUE(open);
}

TEST(Automation, ADialogCoversAndItsAnswersCome) {
  bool open = true;
  int below = 0;
  Answer answer = Answer::none;
  Stage stage(in_window([&](Ui& ui) {
    below += button(ui, "below", "Below").clicked;
    const Answer a =
        dialog(ui, "confirm", open, {"Set motor type?", "A wrong type can burn the motor.", "Set", "Cancel"});
    if (a != Answer::none) answer = a;
  }));
  stage.frames(3);
  EXPECT_FALSE(stage.hand.click("below"));
  EXPECT_EQ(below, 0);
  ASSERT_TRUE(stage.hand.key("Enter"));
  EXPECT_EQ(answer, Answer::no) << "the focus stands on Cancel";
  EXPECT_FALSE(open);
  open = true;
  stage.frames(3);
  ASSERT_TRUE(stage.hand.click("confirm/yes"));
  EXPECT_EQ(answer, Answer::yes);
  ASSERT_TRUE(stage.hand.click("below"));
  EXPECT_EQ(below, 1);
}

TEST(Automation, ASecondDialogWaitsForItsTurn) {
  bool first = true, second = false, first_drawn = true;
  int below = 0;
  Stage stage(in_window([&](Ui& ui) {
    below += button(ui, "below", "Below").clicked;
    dialog(ui, "second", second, {"And this?", "It came later.", "Yes", "No"});
    if (first_drawn) dialog(ui, "first", first, {"This?", "It came first.", "Yes", "No"});
  }));
  stage.frames(3);
  second = true;
  for (int i = 0; i < 20; ++i) {
    stage.frame();
    EXPECT_TRUE(stage.find("first/yes")) << "frame " << i;
    EXPECT_FALSE(stage.find("second/yes")) << "frame " << i;
  }
  ASSERT_TRUE(stage.hand.click("first/yes"));
  stage.frames(3);
  EXPECT_TRUE(second) << "one answer is for one question";
  ASSERT_TRUE(stage.hand.click("second/no"));
  stage.frames(3);
  ASSERT_TRUE(stage.hand.click("below"));
  EXPECT_EQ(below, 1);
  first = true;
  stage.frames(3);
  ASSERT_TRUE(stage.find("first/yes"));
  second = true, first_drawn = false;
  stage.frames(3);
  EXPECT_TRUE(stage.find("second/yes")) << "what is drawn no more is not waited for";
}

struct Page {
  std::string text;
  int plain = 0, moved = 0;
  void draw(Ui& ui) {
    plain += button(ui, "a", "A").clicked;
    button(ui, "off", "Off", {.disabled = "Not now."});
    text_field(ui, "f", "field", text);
    moved += button(ui, "go", "Go", {.moving = true}).clicked;
  }
};

TEST(Focus, TabGoesOverEnabledWidgetsInOrder) {
  Page page;
  Stage stage(in_window([&](Ui& ui) { page.draw(ui); }));
  stage.frames(2);
  const Focus& focus = stage.surface.screen().focus();
  for (const char* id : {"a", "f", "go", "a"}) {
    ASSERT_TRUE(stage.hand.key("Tab"));
    EXPECT_TRUE(focus.ring_on(id)) << id << " but is " << focus.id();
  }
  ASSERT_TRUE(stage.hand.key("Shift+Tab"));
  EXPECT_TRUE(focus.ring_on("go"));
}

TEST(Focus, TabIntoAFieldTypes) {
  Page page;
  Stage stage(in_window([&](Ui& ui) { page.draw(ui); }));
  stage.frames(2);
  ASSERT_TRUE(stage.hand.key("Tab"));
  ASSERT_TRUE(stage.hand.key("Tab"));
  for (char c : std::string("hello")) stage.push(InputEvent::text(static_cast<unsigned>(c), 0));
  stage.frames(3);
  EXPECT_EQ(page.text, "hello");
}

TEST(Focus, EnterPressesAndAMovingButtonNeedsASecond) {
  Page page;
  Stage stage(in_window([&](Ui& ui) { page.draw(ui); }));
  stage.frames(2);
  ASSERT_TRUE(stage.hand.key("Tab"));
  ASSERT_TRUE(stage.hand.key("Enter"));
  EXPECT_EQ(page.plain, 1);
  ASSERT_TRUE(stage.hand.key("Shift+Tab"));
  ASSERT_TRUE(stage.hand.key("Space"));
  EXPECT_EQ(page.moved, 0);
  stage.frames(30);
  ASSERT_TRUE(stage.hand.key("Space"));
  EXPECT_EQ(page.moved, 1);
  ASSERT_TRUE(stage.hand.key("Space"));
  EXPECT_EQ(page.moved, 1);
  stage.frames(150);
  ASSERT_TRUE(stage.hand.key("Space"));
  EXPECT_EQ(page.moved, 1) << "two seconds are over: this is a first press again";
}

TEST(Focus, AClickShowsNoRing) {
  Page page;
  Stage stage(in_window([&](Ui& ui) { page.draw(ui); }));
  ASSERT_TRUE(stage.hand.click("a"));
  EXPECT_TRUE(stage.surface.screen().focus().is("a"));
  EXPECT_FALSE(stage.surface.screen().focus().ring_on("a"));
}

TEST(Screen, AtRestNothingAsksForAFrame) {
  Page page;
  Stage stage(in_window([&](Ui& ui) { page.draw(ui); }));
  stage.frames(5);
  EXPECT_GT(stage.surface.screen().wake_in_s(), 1e6);
  EXPECT_FALSE(stage.surface.screen().more_input());
  ASSERT_TRUE(stage.hand.press("a"));
  ASSERT_TRUE(stage.hand.release("a"));
  EXPECT_GT(stage.surface.screen().wake_in_s(), 1e6);
}

TEST(Screen, AHeldJogAsksForFrames) {
  Stage stage(in_window([&](Ui& ui) { hold_button(ui, "jog/1/+", "1+"); }));
  ASSERT_TRUE(stage.hand.press("jog/1/+"));
  EXPECT_LE(stage.surface.screen().wake_in_s(), 0.1);
}

TEST(Automation, WindowThemeAndScreenshot) {
  Stage stage(in_window([](Ui& ui) { button(ui, "a", "A"); }));
  ASSERT_TRUE(stage.hand.window(1024, 700, 2));
  EXPECT_EQ(stage.surface.width_px(), 2048);
  EXPECT_FALSE(stage.hand.window(10, 10));
  ASSERT_TRUE(stage.hand.theme("light"));
  EXPECT_FALSE(stage.hand.theme("pink"));
  const auto path = std::filesystem::path(HW_BINARY_DIR) / "automation-test.png";
  ASSERT_TRUE(stage.hand.screenshot(path.string()));
  EXPECT_GT(std::filesystem::file_size(path), 1000u);
  const auto bad = stage.hand.screenshot("/no/such/folder/x.png");
  ASSERT_FALSE(bad);
  EXPECT_NE(bad.error().what.find("was not written"), std::string::npos);
  const auto full = stage.hand.screenshot("/dev/full");
  ASSERT_FALSE(full);
  EXPECT_NE(full.error().sentence().find("the disk is full"), std::string::npos) << full.error().sentence();
}

}  // namespace
}  // namespace hw::gui
