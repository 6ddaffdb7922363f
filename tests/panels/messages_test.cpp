// Where the console's messages stand: beside the terminal's title, or in the status line, and over nothing.
#include <gmock/gmock.h>

#include "tests/panels/console_stage.h"

namespace hw::panels {
namespace {

struct MessageShape {
  int width, height;
  bool events;  ///< the list of events is in front
};

const gui::Rect* strip_of(ConsoleStage& s) {
  const gui::Widget* strip = s.stage.find("message/strip");
  return strip ? &strip->rect : nullptr;
}

bool lie_over_each_other(const gui::Rect& a, const gui::Rect& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// What can be pressed or read under the strip, by name.
std::string under_the_strip(ConsoleStage& s) {
  const gui::Rect strip = *strip_of(s);
  std::string names;
  for (const gui::Widget& w : s.stage.surface.screen().registry().widgets()) {
    if (w.id.starts_with("message/") || w.id.starts_with("toast/")) continue;
    const gui::Rect seen{ImVec2(std::max(w.rect.min.x, w.clip.min.x), std::max(w.rect.min.y, w.clip.min.y)),
                         ImVec2(std::min(w.rect.max.x, w.clip.max.x), std::min(w.rect.max.y, w.clip.max.y))};
    // In the lowest windows the banner of a lost link lies over the status line already.
    const gui::Widget* banner = s.stage.find("fault/lost");
    const bool status = w.id == "status/text" && !(banner && lie_over_each_other(banner->rect, w.rect));
    const bool matters = w.usable() || status || w.id == "fault/lost";
    if (matters && lie_over_each_other(seen, strip)) names += std::string(w.id) + " ";
  }
  return names;
}

void show_events(ConsoleStage& s, bool events) {
  if (!s.stage.find("terminal/view/happened")) return;
  ASSERT_TRUE(s.hand.click(events ? "terminal/view/happened" : "terminal/view/log").has_value());
}

TEST(MessagePlace, IsBesideTheTitleWhereItHasRoom) {
  ConsoleStage s;
  s.add();
  s.run(0.1);
  show_events(s, true);
  s.console.toast(gui::Severity::fault, "The home switch is not there.");
  s.run(0.2);
  ASSERT_TRUE(strip_of(s));
  const gui::Rect strip = *strip_of(s), copy = s.stage.find("happened/copy")->rect;
  EXPECT_GT(strip.min.x, copy.max.x);
  EXPECT_EQ(strip.centre().y, copy.centre().y);
  EXPECT_EQ(strip.max.x, 1440 - 272 - 16);
  EXPECT_EQ(s.value("toast/1"), "The home switch is not there.");
}

// The tools of the traffic give up their words for it, and stay where they are when it comes.
TEST(MessagePlace, IsBesideTheTitleOfTheTrafficToo) {
  const std::initializer_list<const char*> tools = {"terminal/decoded", "terminal/fold", "terminal/hex",
                                                    "terminal/filter",  "terminal/copy", "terminal/clear",
                                                    "terminal/save"};
  for (const int width : {1440, 1920}) {
    ConsoleStage s(width, 900);
    s.add();
    s.run(0.1);
    std::vector<gui::Rect> before;
    for (const char* tool : tools) {
      ASSERT_TRUE(s.stage.find(tool)) << tool;
      before.push_back(s.stage.find(tool)->rect);
    }
    s.console.toast(gui::Severity::fault, "The home switch is not there.");
    s.run(0.2);
    ASSERT_TRUE(strip_of(s));
    const gui::Rect strip = *strip_of(s), title = s.stage.find("terminal/view/log")->rect;
    EXPECT_EQ(strip.centre().y, title.centre().y) << width;
    EXPECT_EQ(strip.max.x, static_cast<float>(width) - 272 - 16);
    EXPECT_GE(strip.width(), 280);
    std::size_t i = 0;
    for (const char* tool : tools) {
      const gui::Rect now = s.stage.find(tool)->rect;
      EXPECT_EQ(now.min.x, before[i].min.x) << tool;
      EXPECT_EQ(now.max.x, before[i++].max.x) << tool;
      EXPECT_LE(now.max.x, strip.min.x) << tool;
    }
  }
}

TEST(MessagePlace, IsBesideTheTitleInASmallWindowWithATallTerminal) {
  ConsoleStage s(1024, 900);
  s.console.splitters.below_medium = 240;
  s.add();
  s.run(0.1);
  ASSERT_TRUE(s.stage.find("terminal/view/log"));
  s.console.toast(gui::Severity::fault, "The home switch is not there.");
  s.run(0.2);
  ASSERT_TRUE(strip_of(s));
  EXPECT_EQ(strip_of(s)->centre().y, s.stage.find("terminal/view/log")->rect.centre().y);
  EXPECT_GE(strip_of(s)->min.x, s.stage.find("terminal/save")->rect.max.x);
}

TEST(MessagePlace, IsBesideTheTitleOnALaptopAlsoWithTheRightColumnUnfolded) {
  for (const bool unfolded : {false, true}) {
    ConsoleStage s(1366, 768);
    s.add();
    s.console.right_open = unfolded;
    s.run(0.1);
    s.console.toast(gui::Severity::fault, "The home switch is not there.");
    s.run(0.2);
    ASSERT_TRUE(s.stage.find("terminal/view/log"));
    ASSERT_TRUE(strip_of(s));
    EXPECT_EQ(strip_of(s)->centre().y, s.stage.find("terminal/view/log")->rect.centre().y) << unfolded;
    EXPECT_EQ(under_the_strip(s), "") << unfolded;
  }
}

// At 1024x700 the terminal has three rows, and its menu for a title.
TEST(MessagePlace, IsBesideTheMenuThatIsTheTitle) {
  ConsoleStage s(1024, 700);
  s.add();
  s.run(0.1);
  ASSERT_FALSE(s.stage.find("terminal/view/log"));
  const gui::Rect menu = s.stage.find("terminal/log_menu")->rect, send = s.stage.find("terminal/send")->rect;
  EXPECT_EQ(s.stage.find("terminal/log_menu")->label, "Terminal");
  s.console.toast(gui::Severity::fault, "The home switch is not there.");
  s.run(0.2);
  ASSERT_TRUE(strip_of(s));
  EXPECT_EQ(strip_of(s)->centre().y, menu.centre().y);
  EXPECT_LE(strip_of(s)->max.x, menu.min.x);
  EXPECT_GE(strip_of(s)->min.x, s.stage.find("terminal/command")->rect.max.x);
  EXPECT_GE(s.stage.find("terminal/command")->rect.width(), 220);
  EXPECT_EQ(s.stage.find("terminal/log_menu")->rect.min.x, menu.min.x) << "nothing but the field gives way";
  EXPECT_EQ(s.stage.find("terminal/send")->rect.min.x, send.min.x);
  ASSERT_TRUE(s.hand.click("toast/1"));
  s.run(0.1);
  EXPECT_TRUE(s.stage.find("message/list/1")) << "a press shows it whole";
}

void expect_in_status_line(ConsoleStage& s) {
  ASSERT_TRUE(strip_of(s));
  EXPECT_GE(strip_of(s)->centre().y, s.stage.find("status/text")->rect.min.y);
  EXPECT_GE(strip_of(s)->min.x, s.stage.find("status/text")->rect.max.x) << "not over its sentence";
}

TEST(MessagePlace, IsInTheStatusLineWhereTheTerminalIsCoveredOrInATab) {
  for (const bool narrow : {false, true}) {
    ConsoleStage s(narrow ? 720 : 1024, narrow ? 450 : 700);
    s.add();
    s.console.right_open = !narrow;
    s.run(0.1);
    s.console.toast(gui::Severity::fault, "The home switch is not there.");
    s.run(0.2);
    expect_in_status_line(s);
  }
}

// A banner that covers the status line shows the number of messages only where the terminal shows none.
TEST(MessagePlace, IsInOnePlaceBesideABannerToo) {
  ConsoleStage s(1024, 700);
  Example& a = s.add();
  a.now.link.state = LinkState::lost;
  s.run(0.1);
  ASSERT_TRUE(s.stage.find("fault/lost"));
  s.console.toast(gui::Severity::fault, "The home switch is not there.");
  s.run(0.2);
  int strips = 0;
  for (const gui::Widget& w : s.stage.surface.screen().registry().widgets())
    strips += w.id == "message/strip";
  EXPECT_EQ(strips, 1);
}

TEST(MessagePlace, CoversNothingInAnySize) {
  for (const MessageShape shape :
       {MessageShape{1920, 1080, false}, MessageShape{1440, 900, true}, MessageShape{1440, 900, false},
        MessageShape{1366, 768, true}, MessageShape{1024, 700, true}, MessageShape{720, 450, false}})
    for (const bool lost : {false, true}) {
      ConsoleStage s(shape.width, shape.height);
      Example& a = s.add();
      if (lost) a.now.link.state = LinkState::lost;
      s.run(0.1);
      show_events(s, shape.events);
      s.console.toast(gui::Severity::fault, "The home switch is not there.");
      s.console.toast(gui::Severity::warn, "It is hot.");
      s.run(0.2);
      ASSERT_TRUE(strip_of(s)) << shape.width;
      EXPECT_EQ(under_the_strip(s), "") << shape.width << " x " << shape.height << (lost ? ", lost" : "");
      EXPECT_TRUE(s.stage.find("toast/1")) << shape.width;
      EXPECT_EQ(s.value("toast/2"), "It is hot.") << shape.width;
    }
}

TEST(MessagePlace, OnAPageItIsInTheStatusLine) {
  ConsoleStage s;
  s.run(0.1);
  s.console.toast(gui::Severity::fault, "The disk is full.");
  s.run(0.2);
  ASSERT_TRUE(strip_of(s));
  EXPECT_GE(strip_of(s)->min.y, 900 - 36);
  ASSERT_TRUE(s.hand.click("toast/1").has_value());
  s.run(0.1);
  EXPECT_EQ(s.value("message/list/1"), "The disk is full.");
  ASSERT_TRUE(s.hand.click("message/list/1/close").has_value());
  s.run(0.1);
  EXPECT_FALSE(s.stage.find("message/strip"));
}

TEST(MessagePlace, AMessageAboutALostLinkGoesWhenTheLinkIsBack) {
  ConsoleStage s;
  Example& a = s.add();
  a.now.link.state = LinkState::lost;
  s.run(0.1);
  ASSERT_TRUE(s.hand.type("terminal/command", "R\n").has_value());
  s.run(7);
  ASSERT_TRUE(s.hand.type("terminal/command", "R\n").has_value());
  s.run(0.2);
  EXPECT_NE(s.value("toast/2").find("There is no link."), std::string::npos);
  a.now.link.state = LinkState::good;
  s.run(0.2);
  EXPECT_FALSE(s.stage.find("toast/2"));
}

TEST(MessagePlace, MessagesOfAClosedControllerGoWithIt) {
  ConsoleStage s;
  s.add();
  Example& b = s.add();
  b.now.link.state = LinkState::lost;
  s.run(0.1);
  ASSERT_TRUE(s.hand.type("terminal/command", "R\n").has_value());
  s.console.toast(gui::Severity::fault, "The disk is full.");
  s.run(0.2);
  ASSERT_EQ(s.console.toasts().list().size(), 2u);
  s.console.close(*b.tab);
  s.run(0.2);
  ASSERT_EQ(s.console.toasts().list().size(), 1u);
  EXPECT_EQ(s.console.toasts().list()[0].text, "The disk is full.") << "that is still so";
}

TEST(MessagePlace, ABannerLeavesARowOfTraffic) {
  for (const int width : {1024, 1366}) {
    ConsoleStage s(width, width == 1024 ? 700 : 768);
    Example& a = s.add();
    s.run(0.2);
    a.now.link.state = LinkState::lost;
    s.run(0.2);
    EXPECT_TRUE(s.stage.find("fault/lost"));
    EXPECT_GE(s.stage.find("terminal/log")->rect.height(), 20) << width;
    EXPECT_TRUE(s.hand.click("fault/try_now").has_value()) << width;
  }
}

TEST(MessagePlace, ABannerCoversNoStatusLine) {
  for (const bool lost : {false, true}) {
    ConsoleStage s(1024, 700);
    Example& a = s.add();
    a.now.params[0].value = 0;
    if (lost) a.now.link.state = LinkState::lost;
    s.run(0.2);
    const gui::Widget* banner = s.stage.find(lost ? "fault/lost" : "fault/unset");
    ASSERT_TRUE(banner);
    EXPECT_LE(banner->rect.max.y, s.stage.find("status/text")->rect.min.y);
  }
}

TEST(MessagePlace, ABannerThatWasUnfoldedCanBeFoldedInAnyWindow) {
  int folded = 0;
  for (int height = 640; height <= 780; height += 10) {
    ConsoleStage s(1024, height);
    Example& a = s.add();
    s.run(0.1);
    a.now.link.state = LinkState::lost;
    s.run(0.1);
    if (!s.stage.find("fault/fold")) continue;
    ++folded;
    ASSERT_TRUE(s.hand.click("fault/fold").has_value()) << height;
    s.run(0.1);
    ASSERT_TRUE(s.hand.click("fault/fold").has_value()) << height;
    s.run(0.1);
    EXPECT_TRUE(s.stage.find("fault/fold")) << height;
  }
  EXPECT_GT(folded, 0);
}

TEST(MessagePlace, AFoldedBannerKeepsWhatMattersAndCanBeUnfolded) {
  ConsoleStage s(1440, 900);
  Example& a = s.add();
  a.now.axes[0].activity = Activity::moving;
  s.run(0.2);
  a.now.link.state = LinkState::lost;
  s.run(0.2);
  ASSERT_TRUE(s.hand.click("fault/fold").has_value());
  s.run(0.2);
  EXPECT_FALSE(s.stage.find("fault/report")) << "its words need the room";
  EXPECT_TRUE(s.stage.find("fault/try_now"));
  EXPECT_EQ(s.stage.find("fault/fold")->label, "Unfold");
  EXPECT_LE(s.stage.find("fault/lost")->rect.height(), 36) << "one line";
  ASSERT_TRUE(s.hand.click("fault/fold").has_value());
  s.run(0.2);
  EXPECT_EQ(s.stage.find("fault/fold")->label, "Fold");
}

}  // namespace
}  // namespace hw::panels
