#include "panels/terminal.h"

#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct TerminalTest : ::testing::Test {
  void wire(Way way, TrafficKind kind, const char* bytes) {
    TrafficEntry e;
    e.at = s.tab.clock(), e.way = way, e.kind = kind, e.bytes = bytes;
    s.tab.desk().records.traffic.append(e);
  }
  Terminal panel;
  test::PanelStage s{panel, 864, 300};
};

TEST_F(TerminalTest, EnterSendsWhatWasTypedAndKeepsItInTheHistory) {
  s.type("terminal/command", "S1M500\n");
  ASSERT_TRUE(s.last<intent::SendText>());
  EXPECT_EQ(s.last<intent::SendText>()->text, "S1M500");
  EXPECT_EQ(s.value("terminal/command"), "");
  s.type("terminal/command", "R");
  ASSERT_TRUE(s.stage.hand.key("Up"));
  s.stage.frames(2);
  EXPECT_EQ(s.value("terminal/command"), "S1M500");
  ASSERT_TRUE(s.stage.hand.key("Down"));
  s.stage.frames(2);
  EXPECT_EQ(s.value("terminal/command"), "R") << "what was being typed is not lost";
  EXPECT_EQ(s.sent.size(), 1u);
}

TEST_F(TerminalTest, SendButtonDoesTheSame) {
  s.type("terminal/command", "rsm");
  s.click("terminal/send");
  ASSERT_TRUE(s.last<intent::SendText>());
  EXPECT_EQ(s.last<intent::SendText>()->text, "rsm");
}

TEST_F(TerminalTest, SendWearsTheEdgeOfMotionWhenItWouldMove) {
  s.type("terminal/command", "rsm");
  EXPECT_FALSE(s.stage.find("terminal/send")->moving);
  s.type("terminal/command", "I1M400,R");
  EXPECT_TRUE(s.stage.find("terminal/send")->moving) << "and so it takes no press before it has stood still";
}

TEST_F(TerminalTest, WithoutLinkNothingIsSentAndTheTextStays) {
  s.now.link.state = LinkState::lost;
  s.type("terminal/command", "S1M500\n");
  EXPECT_TRUE(s.sent.empty());
  EXPECT_EQ(s.value("terminal/command"), "S1M500");
  EXPECT_THAT(s.toast(), HasSubstr("Nothing was sent; what you typed stays here."));
  EXPECT_THAT(s.reason("terminal/send"), HasSubstr("There is no link."));
}

TEST_F(TerminalTest, TabCompletesAndShowsTheList) {
  s.type("terminal/command", "setD");
  ASSERT_TRUE(s.stage.hand.key("Tab"));
  s.stage.frames(2);
  EXPECT_EQ(s.value("terminal/command"), "setDM");
  s.type("terminal/command", "set");
  ASSERT_TRUE(s.stage.hand.key("Tab"));
  s.stage.frames(2);
  ASSERT_TRUE(s.stage.find("terminal/offer/setDMx"));
  EXPECT_EQ(s.value("terminal/offer/setDMx"), "set the mode");
  s.click("terminal/offer/setDMx");
  EXPECT_EQ(s.value("terminal/command"), "setDM");
  EXPECT_FALSE(s.stage.find("terminal/offer/setDMx"));
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(TerminalTest, TheListClosesByAClickOutsideOfIt) {
  s.type("terminal/command", "set");
  ASSERT_TRUE(s.stage.hand.key("Tab"));
  s.stage.frames(2);
  ASSERT_TRUE(s.stage.find("terminal/offer/setDMx"));
  s.click("terminal/decoded");
  s.stage.frames(2);
  EXPECT_FALSE(s.stage.find("terminal/offer/setDMx"));
  EXPECT_EQ(s.value("terminal/command"), "set");
}

TEST_F(TerminalTest, LogShowsTheTrafficAndFilters) {
  wire(Way::sent, TrafficKind::intent, "M\r");
  wire(Way::received, TrafficKind::intent, "229\r");
  s.stage.frames(2);
  EXPECT_THAT(s.value("terminal/log"), HasSubstr("< 229<cr>"));
  s.type("terminal/filter", "229");
  EXPECT_THAT(s.value("terminal/log"), Not(HasSubstr("> M<cr>")));
  EXPECT_THAT(s.value("terminal/log"), HasSubstr("229"));
  s.type("terminal/filter", "");
  s.click("terminal/hex");
  EXPECT_THAT(s.value("terminal/log"), HasSubstr("32 32 39 0D"));
  s.click("terminal/clear");
  EXPECT_EQ(s.value("terminal/log"), "");
}

TEST_F(TerminalTest, PollsThatAreShownAreDrawnWhileTheyComeAndFoldedOnesAreNot) {
  s.stage.frames(4);
  EXPECT_GT(s.stage.surface.screen().wake_in_s(), 10);
  s.click("terminal/fold");
  s.stage.frames(4);
  EXPECT_LE(s.stage.surface.screen().wake_in_s(), 0.25);
}

TEST_F(TerminalTest, PollsFoldAndOpen) {
  for (int i = 0; i < 3; ++i) {
    wire(Way::sent, TrafficKind::poll, "X");
    wire(Way::received, TrafficKind::poll, "+0000400\r");
  }
  s.stage.frames(2);
  EXPECT_THAT(s.value("terminal/log"), HasSubstr("3 polls of X folded."));
  EXPECT_THAT(s.value("terminal/log"), Not(HasSubstr("+0000400")));
  s.click("terminal/fold/0");
  EXPECT_THAT(s.value("terminal/log"), HasSubstr("+0000400"));
}

TEST_F(TerminalTest, ChosenLinesAreCopied) {
  wire(Way::sent, TrafficKind::intent, "first");
  wire(Way::sent, TrafficKind::intent, "second");
  s.stage.frames(2);
  s.click("terminal/copy");
  EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr("first"));
  EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr("second"));
  const gui::Widget* log = s.stage.find("terminal/log");
  ASSERT_TRUE(log);
  const float x = log->rect.min.x + 60, y = log->rect.min.y + 4 + 10;
  s.stage.push(gui::InputEvent::mouse_move(x, y, s.stage.now_s));
  s.stage.push(gui::InputEvent::mouse_button(0, true, ImVec2(x, y), s.stage.now_s));
  s.stage.frames(2);
  s.stage.push(gui::InputEvent::mouse_button(0, false, ImVec2(x, y), s.stage.now_s));
  s.stage.frames(2);
  ASSERT_TRUE(s.stage.hand.key("Ctrl+C"));
  s.stage.frames(2);
  EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr("first"));
  EXPECT_THAT(ImGui::GetClipboardText(), Not(HasSubstr("second")));
}

TEST_F(TerminalTest, EventsStandInTheirPlaceAndCanBeFilteredAndCopied) {
  s.type("terminal/command", "I1M400,R\n");
  s.tab.desk().records.events.add({gui::LoggedEvent::Mark::limit, true, s.tab.clock(), "1",
                                   "motion ended on its + limit, at 400 steps", 0.4});
  s.click("terminal/view/happened");
  EXPECT_FALSE(s.stage.find("terminal/log"));
  EXPECT_THAT(s.value("happened/log"), HasSubstr("1 motion ended on its + limit, at 400 steps (0.4 s)"));
  EXPECT_THAT(s.value("happened/log"), HasSubstr("I1M400,R was sent"));
  s.click("happened/filter");
  s.click("happened/filter/trouble");
  EXPECT_THAT(s.value("happened/log"), Not(HasSubstr("was sent")));
  s.click("happened/copy");
  EXPECT_THAT(s.toast(), HasSubstr("copied"));
  EXPECT_EQ(ImGui::GetClipboardText(), s.value("happened/log")) << "those that are shown, with their times";
  EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr("ended on its + limit, at 400 steps (0.4 s)"));
  EXPECT_THAT(ImGui::GetClipboardText(), Not(HasSubstr("was sent")));
  s.type("terminal/command", "V\n");
  ASSERT_TRUE(s.last<intent::SendText>()) << "the line is there in both";
  s.click("terminal/view/log");
  EXPECT_TRUE(s.stage.find("terminal/log"));
}

TEST_F(TerminalTest, ThreeRowsAreEnoughToBeDrawn) {
  test::PanelStage small(panel, 704, 116, 1, gui::Tier::medium);
  small.stage.frames(3);
  EXPECT_TRUE(small.stage.find("terminal/command"));
  EXPECT_TRUE(small.stage.find("terminal/log"));
}

}  // namespace
}  // namespace hw::panels
