// Widgets through real frames, by the hands of a script: what a person would see happen.
#include <gtest/gtest.h>

#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/digits.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

TEST(Button, ClickIsOneClick) {
  int clicks = 0;
  Stage stage(
      in_window([&](Ui& ui) { clicks += button(ui, "program/run", "Run", {.moving = true}).clicked; }));
  ASSERT_TRUE(stage.hand.click("program/run"));
  EXPECT_EQ(clicks, 1);
}

TEST(Button, LettingGoElsewhereIsNoClick) {
  int clicks = 0;
  Stage stage(in_window([&](Ui& ui) { clicks += button(ui, "a", "A").clicked; }));
  ASSERT_TRUE(stage.hand.press("a"));
  stage.push(InputEvent::mouse_move(900, 600, stage.now_s));
  ASSERT_TRUE(stage.hand.release("a"));
  EXPECT_EQ(clicks, 0);
}

TEST(Button, FocusLossWhilePressedIsNoClick) {
  int clicks = 0;
  Stage stage(in_window([&](Ui& ui) { clicks += button(ui, "a", "A").clicked; }));
  ASSERT_TRUE(stage.hand.press("a"));
  stage.hand.lose_focus();
  EXPECT_EQ(clicks, 0);
}

TEST(Text, CutTextIsShownWholeUnderTheMouse) {
  std::string reported;
  Stage stage(in_window([&](Ui& ui) {
    draw_text_line(ui, 20, 120, 40, Face::body, ui[Tone::ink], "a sentence that is far too long for it");
    draw_text_line(ui, 20, 400, 80, Face::body, ui[Tone::ink], "short");
    reported = ui.cut();
  }));
  stage.push(InputEvent::mouse_move(60, 80, 0));
  stage.frames(3);
  EXPECT_EQ(reported, "");
  stage.push(InputEvent::mouse_move(60, 40, 0));
  stage.frames(3);
  EXPECT_EQ(reported, "a sentence that is far too long for it");
}

/// The highest and the lowest line of pixels that is not the ground, from `top` to `bottom`.
std::pair<int, int> inked(Stage& stage, int top, int bottom) {
  stage.surface.render();
  const ImU32 ground = stage.surface.pixel(600, top);
  std::pair<int, int> found{bottom, top};
  for (int y = top; y < bottom; ++y)
    for (int x = 0; x < 420; ++x)
      if (stage.surface.pixel(x, y) != ground) found = {std::min(found.first, y), std::max(found.second, y)};
  return found;
}

TEST(Text, ASentenceThatIsTooLongForItsLineTakesTwoSmallOnes) {
  std::string sentence = "short", reported;
  Stage stage(in_window([&](Ui& ui) {
    draw_text_in_two_lines(ui, 20, 400, 60, Face::body, ui[Tone::ink], sentence);
    reported = ui.cut();
  }));
  stage.push(InputEvent::mouse_move(60, 68, 0));
  stage.frames(3);
  const auto one = inked(stage, 30, 90);
  EXPECT_LT(one.second - one.first, 16);
  sentence = "No answer from Two since 14:20:08. Stop does not reach it: use its power switch.";
  stage.frames(3);
  const auto two = inked(stage, 30, 90);
  EXPECT_LT(two.first, 56) << "a line above the middle";
  EXPECT_GT(two.second, 64) << "and one below";
  EXPECT_LT(two.second - two.first, 36) << "both within a status line";
  EXPECT_EQ(reported, "") << "nothing had to be cut";
  sentence += " The cable of /dev/ttyUSB0 was pulled. No command was repeated.";
  stage.frames(3);
  EXPECT_NE(reported, "") << "what even two lines cannot hold is told under the mouse";
}

TEST(Text, AWidgetsOwnTipGoesFirst) {
  std::string reported;
  Stage stage(in_window([&](Ui& ui) {
    button(ui, "a", "a label that is far too long for it", {.tip = "Its tip.", .width = 60});
    reported = ui.cut();
  }));
  stage.frames(2);
  const ImVec2 at = stage.find("a")->rect.centre();
  stage.push(InputEvent::mouse_move(at.x, at.y, 0));
  stage.frames(3);
  EXPECT_EQ(reported, "");
}

struct HoldCount {
  int started = 0, held = 0, ended = 0;
  double lasted_s = 0;
  void take(const Hold& h) {
    started += h.started;
    held += h.held;
    ended += h.ended;
    if (h.ended) lasted_s = h.released_at_s - h.pressed_at_s;
  }
};

TEST(HoldButton, StartsHoldsAndEnds) {
  HoldCount count;
  Stage stage(in_window([&](Ui& ui) { count.take(hold_button(ui, "jog/1/+", "1+")); }));
  ASSERT_TRUE(stage.hand.press("jog/1/+"));
  stage.frames(30);
  EXPECT_EQ(count.started, 1);
  EXPECT_GE(count.held, 30);
  EXPECT_EQ(count.ended, 0);
  ASSERT_TRUE(stage.hand.release("jog/1/+"));
  EXPECT_EQ(count.ended, 1);
  EXPECT_NEAR(count.lasted_s, 31.0 / 60, 0.03);
}

TEST(HoldButton, LeavingWithTheMouseGoesOnLettingGoEnds) {
  HoldCount count;
  Stage stage(in_window([&](Ui& ui) { count.take(hold_button(ui, "j", "1+")); }));
  ASSERT_TRUE(stage.hand.press("j"));
  stage.push(InputEvent::mouse_move(1000, 700, stage.now_s));
  stage.frames(5);
  EXPECT_EQ(count.ended, 0);
  ASSERT_TRUE(stage.hand.release("j"));
  EXPECT_EQ(count.ended, 1);
}

TEST(HoldButton, FocusLossEnds) {
  HoldCount count;
  Stage stage(in_window([&](Ui& ui) { count.take(hold_button(ui, "j", "1+")); }));
  ASSERT_TRUE(stage.hand.press("j"));
  stage.hand.lose_focus();
  EXPECT_EQ(count.ended, 1);
}

TEST(HoldButton, BecomingDisabledWhileHeldEnds) {
  HoldCount count;
  std::string_view disabled;
  Stage stage(in_window([&](Ui& ui) { count.take(hold_button(ui, "j", "1+", {.disabled = disabled})); }));
  ASSERT_TRUE(stage.hand.press("j"));
  disabled = "Link lost.";
  stage.frames(1);
  EXPECT_GE(count.ended, 1);
}

TEST(HoldButton, ATapBetweenTwoFramesStartsAndEnds) {
  HoldCount count;
  Stage stage(in_window([&](Ui& ui) { count.take(hold_button(ui, "j", "1+")); }));
  stage.frames(2);
  const ImVec2 at = stage.find("j")->rect.centre();
  stage.push(InputEvent::mouse_move(at.x, at.y, 1.0));
  stage.frames(2);
  for (int tap = 0; tap < 5; ++tap) {
    stage.push(InputEvent::mouse_button(0, true, at, 1.0));
    stage.push(InputEvent::mouse_button(0, false, at, 1.004));
  }
  stage.frames(12);
  EXPECT_EQ(count.started, 5);
  EXPECT_EQ(count.ended, 5);
  EXPECT_NEAR(count.lasted_s, 0.004, 1e-9);
}

TEST(NumberField, CommaAndPointBothRead) {
  EXPECT_EQ(read_number("12,5"), 12.5);
  EXPECT_EQ(read_number("12.5"), 12.5);
  EXPECT_EQ(read_number("\xE2\x88\x92"
                        "3"),
            -3.0);
  EXPECT_EQ(read_number("57\xE2\x80\x89"
                        "000"),
            57000.0);
  EXPECT_EQ(read_number(" +7 "), 7.0);
  for (const char* bad : {"", "1.2.3", "1,2.3", "x", "1e5", "--1", "1-2", "inf", "nan"})
    EXPECT_FALSE(read_number(bad)) << bad;
}

TEST(NumberField, ShowsTheRangeInWords) {
  const NumberRange range{1, 6000, 0, ""};
  EXPECT_EQ(range_sentence("8000", range), "1 to 6000 only");
  EXPECT_EQ(range_sentence("6000", range), "");
  EXPECT_EQ(range_sentence("1.5", range), "Whole numbers only");
  EXPECT_EQ(range_sentence("12a", range), "This is not a number.");
}

struct OneNumber {
  NumberField field;
  double value = 10;
  int commits = 0;
  void draw(Ui& ui) {
    NumberOptions options;
    options.range = {1, 6000, 1, "mm"};
    options.width = 104;
    const NumberEvent e = number_field(ui, "setup/S", "speed", value, field, options);
    if (e.committed) {
      value = e.value;
      ++commits;
    }
    button(ui, "other", "Other");
  }
};

TEST(NumberField, TypedAndEnteredIsCommittedOnce) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.type("setup/S", "12,5\n"));
  EXPECT_EQ(one.value, 12.5);
  EXPECT_EQ(one.commits, 1);
  EXPECT_EQ(*stage.hand.value("setup/S"), "12.5");
}

TEST(NumberField, LeavingCommitsToo) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.type("setup/S", "77"));
  EXPECT_EQ(one.commits, 0);
  ASSERT_TRUE(stage.hand.click("other"));
  EXPECT_EQ(one.value, 77);
  EXPECT_EQ(one.commits, 1);
}

TEST(NumberField, OutOfRangeIsNotReportedAndStaysTyped) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.type("setup/S", "8000\n"));
  EXPECT_EQ(one.commits, 0);
  EXPECT_EQ(one.field.sentence, "1 to 6000 mm only");
  EXPECT_EQ(*stage.hand.value("setup/S"), "8000");
  ASSERT_TRUE(stage.hand.type("setup/S", "60\n"));
  EXPECT_EQ(one.value, 60);
  EXPECT_TRUE(one.field.sentence.empty());
}

TEST(NumberField, AValueFromTheControllerIsNotTakenForTyped) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.click("setup/S"));
  one.value = 20;
  stage.frames(2);
  EXPECT_EQ(*stage.hand.value("setup/S"), "20.0");
  ASSERT_TRUE(stage.hand.click("other"));
  EXPECT_EQ(one.commits, 0) << "nobody has typed";
  EXPECT_EQ(one.value, 20);
}

TEST(NumberField, AValueSetOverATypedNumberSurvivesUndo) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.type("setup/S", "2.5"));
  one.field.set(1000, 0);  // the same in steps
  stage.frames(2);
  EXPECT_EQ(*stage.hand.value("setup/S"), "1000");
  ASSERT_TRUE(stage.hand.key("Ctrl+Z"));
  EXPECT_EQ(*stage.hand.value("setup/S"), "1000") << "what was typed was meant otherwise";
  stage.push(InputEvent::text('5', stage.now_s));
  stage.frames(2);
  EXPECT_EQ(*stage.hand.value("setup/S"), "10005");
}

TEST(NumberField, ANumberThatIsChosenWholeStaysSoWhenItChanges) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.click("setup/S"));
  ASSERT_TRUE(stage.hand.key("Ctrl+A"));
  one.value = 2000;
  stage.push(InputEvent::text('5', stage.now_s));  // in the same frame
  stage.frames(2);
  EXPECT_EQ(*stage.hand.value("setup/S"), "5");
}

TEST(NumberField, WheelChangesNothing) {
  OneNumber one;
  Stage stage(in_window([&](Ui& ui) { one.draw(ui); }));
  ASSERT_TRUE(stage.hand.click("setup/S"));
  stage.push(InputEvent::wheel(0, -3, stage.now_s));
  stage.frames(3);
  EXPECT_EQ(*stage.hand.value("setup/S"), "10.0");
}

TEST(NumberField, ADoubleClickChoosesTheNumberWithItsSignAndDecimals) {
  NumberField field;
  NumberOptions options;
  options.range = {-6000, 6000, 1, "mm"};
  options.width = 104;
  Stage stage(in_window([&](Ui& ui) { number_field(ui, "goto/1", "to", -1234.5, field, options); }));
  stage.frames(2);
  ASSERT_TRUE(stage.hand.type("goto/1", "-1234,5"));
  const Rect r = stage.find("goto/1")->rect;
  for (const float x : {r.min.x + 30, r.min.x + 44, r.max.x - 38}) {
    stage.now_s += 2;
    for (int n = 0; n < 2; ++n) {
      stage.push(InputEvent::mouse_button(0, true, ImVec2(x, r.centre().y), stage.now_s));
      stage.push(InputEvent::mouse_button(0, false, ImVec2(x, r.centre().y), stage.now_s));
      stage.frames(3);
    }
    ImGui::SetClipboardText("");
    ASSERT_TRUE(stage.hand.key("Ctrl+C"));
    EXPECT_EQ(std::string(ImGui::GetClipboardText()), field.text) << "at " << x - r.min.x;
    stage.push(InputEvent::mouse_button(0, true, ImVec2(r.max.x + 300, r.max.y + 300), stage.now_s));
    stage.push(InputEvent::mouse_button(0, false, ImVec2(r.max.x + 300, r.max.y + 300), stage.now_s));
    stage.frames(3);
  }
}

TEST(TextField, HistoryAndCompletion) {
  std::string text;
  LineHelp help;
  help.history = [](std::string& line, int direction) {
    line = direction < 0 ? "older" : "newer";
    return true;
  };
  help.complete = [](std::string& line, std::size_t& cursor) {
    line += "M1";
    cursor = line.size();
    return true;
  };
  std::vector<std::string> sent;
  Stage stage(in_window([&](Ui& ui) {
    const Field f = text_field(ui, "terminal/command", "command", text, {.keep_focus = true, .help = &help});
    if (f.entered) {
      sent.push_back(text);
      text.clear();
    }
    button(ui, "after", "After");
  }));
  ASSERT_TRUE(stage.hand.type("terminal/command", "S1"));
  ASSERT_TRUE(stage.hand.key("Tab"));
  EXPECT_EQ(text, "S1M1");
  EXPECT_TRUE(stage.surface.screen().focus().is("terminal/command")) << "Tab completes, it does not leave";
  ASSERT_TRUE(stage.hand.key("Enter"));
  ASSERT_TRUE(stage.hand.key("Up"));
  EXPECT_EQ(text, "older");
  ASSERT_TRUE(stage.hand.key("Enter"));
  EXPECT_EQ(sent, (std::vector<std::string>{"S1M1", "older"}));
}

TEST(Choice, SegmentAndDropdown) {
  static const std::string_view names[] = {"mm", "steps", "inch"};
  int slot = 0, unit = 0;
  Stage stage(in_window([&](Ui& ui) {
    if (const int i = segment(ui, "program/slot", names, slot); i >= 0) slot = i;
    if (const int i = dropdown(ui, "dro/unit", "unit", names, unit); i >= 0) unit = i;
  }));
  ASSERT_TRUE(stage.hand.click("program/slot/inch"));
  EXPECT_EQ(slot, 2);
  ASSERT_TRUE(stage.hand.click("dro/unit"));
  ASSERT_TRUE(stage.hand.click("dro/unit/steps"));
  EXPECT_EQ(unit, 1);
  EXPECT_EQ(*stage.hand.value("dro/unit"), "steps");
  ASSERT_TRUE(stage.hand.click("dro/unit"));
  EXPECT_FALSE(stage.hand.click("program/slot/mm")) << "covered by the open list";
  ASSERT_TRUE(stage.hand.key("Down"));
  ASSERT_TRUE(stage.hand.key("Enter"));
  EXPECT_EQ(unit, 2);
}

TEST(Choice, AnEntryTooLongForItsFieldIsSmallerAndNotCut) {
  static const std::string_view names[] = {"4: Slo-Syn M063 (4.6 A), Vexta PK266 (3 A)", "0"};
  std::string reported;
  Stage stage(in_window([&](Ui& ui) {
    (void)dropdown(ui, "setup/M1M", "type", names, 0, {.width = 302});
    reported = ui.cut();
  }));
  stage.frames(2);
  const ImVec2 at = stage.find("setup/M1M")->rect.centre();
  stage.push(InputEvent::mouse_move(at.x, at.y, 0));
  stage.frames(3);
  EXPECT_EQ(reported, "");
}

TEST(ToggleLamp, AnUnknownStateIsNotDrawnAsOff) {
  std::size_t vertices = 0;
  ToggleOptions o;
  o.disabled = "There is no link.";
  o.word = "off?";
  Stage stage(in_window([&](Ui& ui) {
                toggle_lamp(ui, "out", "Out 1", o);
                vertices = static_cast<std::size_t>(ImGui::GetWindowDrawList()->VtxBuffer.Size);
              }),
              200, 100);
  stage.frames(2);
  const std::size_t off = vertices;
  o.state = ToggleState::stale;
  stage.frames(2);
  EXPECT_NE(vertices, off) << "a ring of dashes";
}

}  // namespace
}  // namespace hw::gui
