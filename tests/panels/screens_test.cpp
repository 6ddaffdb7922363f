// Every panel in every window, theme and state: what must be there is there, and says what is true.
#include <cstdlib>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"

namespace hw::panels {
namespace {

using namespace gui;

struct Window {
  const char* name;
  int width, height;
  float scale;
};
constexpr Window windows[] = {
    {"wide", 1440, 900, 1}, {"medium", 1024, 700, 1}, {"double", 1440, 900, 2}, {"triple", 1440, 900, 3}};

void keep_picture(ConsoleStage& s, const std::string& name) {
  if (const char* folder = std::getenv("HW_PICTURES")) {
    const auto written = s.hand.screenshot(fmt::format("{}/{}.png", folder, name));
    EXPECT_TRUE(written.has_value()) << written.error().sentence();
  }
}

class Screens : public testing::TestWithParam<std::tuple<Window, bool>> {
 protected:
  Window window = std::get<0>(GetParam());
  bool dark = std::get<1>(GetParam());
  // Sizes are logical where the stage makes the surface; the double one is what 1440 x 900 pixels give at 200
  // %.
  ConsoleStage s{static_cast<int>(static_cast<float>(window.width) / window.scale),
                 static_cast<int>(static_cast<float>(window.height) / window.scale), window.scale, dark};
  std::string picture(const char* what) const {
    return fmt::format("{}-{}-{}", what, window.name, dark ? "dark" : "light");
  }
  /// What a hand may press and what it reads of an axis.
  void expect_apart(int axes) {
    std::vector<const Widget*> seen;
    for (const Widget& w : s.stage.surface.screen().registry().widgets()) {
      const bool of_hands =
          w.id.starts_with("jog/") || w.id.starts_with("goto/") || w.id.starts_with("home/");
      const bool of_axis = w.id.ends_with("/position") || w.id.ends_with("/state") ||
                           w.id == "dro/emulated" || w.id.starts_with("io/limit/");
      if ((of_hands || of_axis) && w.in_view() && w.rect.width() > 0) seen.push_back(&w);
    }
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (std::size_t j = i + 1; j < seen.size(); ++j) {
        const Rect &p = seen[i]->rect, &q = seen[j]->rect;
        const bool over =
            p.min.x + 1 < q.max.x && q.min.x + 1 < p.max.x && p.min.y + 1 < q.max.y && q.min.y + 1 < p.max.y;
        EXPECT_FALSE(over) << axes << " axes: " << seen[i]->id << " and " << seen[j]->id;
      }
  }
  void expect(std::initializer_list<const char*> ids) {
    for (const char* id : ids) {
      // In less than the smallest window of the look the status line tells of the link.
      if (window.scale > 2 && std::string_view(id) == "link/health") continue;
      const Widget* w = s.stage.find(id);
      ASSERT_TRUE(w) << id;
      EXPECT_GT(w->rect.width(), 0) << id;
    }
  }
};

INSTANTIATE_TEST_SUITE_P(All, Screens, testing::Combine(testing::ValuesIn(windows), testing::Bool()),
                         [](const auto& info) {
                           return fmt::format("{}_{}", std::get<0>(info.param).name,
                                              std::get<1>(info.param) ? "dark" : "light");
                         });

TEST_P(Screens, WithoutController) {
  s.run(0.1);
  expect({"stop_all", "connect/address", "connect/demo", "status/text", "link/health"});
  keep_picture(s, picture("connect"));
}

TEST_P(Screens, Typical) {
  Example& a = s.add();
  a.tab->settings.profile.name = "Stage";
  a.tab->settings.profile.axes[0].name = "across";
  a.tab->settings.profile.unit = "real";
  a.tab->settings.profile.axes[0].unit_choice = a.tab->settings.profile.axes[1].unit_choice = "screw of 1 mm";
  a.tab->settings.profile.jog_step = Steps(40);
  a.tab->settings.edited();
  a.now.axes[0].position = Steps(3120);
  a.now.axes[0].activity = Activity::moving;
  a.now.axes[0].direction = 1;
  a.now.axes[0].has_target = true;
  a.now.axes[0].target = Steps(4800);
  a.now.axes[0].speed = Pps(2000);
  a.now.axes[1].position = Steps(-60000);
  a.now.outputs = 2;
  a.now.unsaved_setup = true;
  s.run(0.2);
  expect({"stop_all", "dro/1/position", "dro/1/state", "dro/2/steps", "dro/emulated", "io/limit/1/+",
          "io/limit/2/-", "status/text", "status/unsaved", "link/health"});
  EXPECT_EQ(s.value("dro/1/position"), "7.800");
  EXPECT_EQ(s.value("dro/2/position"), "-150.000");
  EXPECT_EQ(s.value("dro/1/state"), "MOVING +");
  EXPECT_EQ(s.value("status/text"), "Motor 1 moves to 12.000 mm. Esc stops everything.");
  keep_picture(s, picture("typical"));
}

TEST_P(Screens, Lost) {
  Example& a = s.add();
  s.run(0.5);
  s.stale = true;
  a.now.axes[0].position = Steps(36560);
  a.now.axes[0].trust.doubt(Doubt::power_cut, {});
  a.now.link.state = LinkState::lost;
  a.now.link.lost_at = s.scheduler.now();
  a.now.link.next_attempt = s.scheduler.now() + Millis(8000);
  a.now.link.attempts = 4;
  a.now.link.sentence = "The cable of /dev/ttyUSB0 was pulled. No command was repeated.";
  s.run(2);
  expect({"stop_all", "dro/1/position", "fault/try_now", "fault/report", "io/limit/1/+"});
  EXPECT_EQ(s.value("dro/1/state"), "LOST");
  EXPECT_EQ(s.value("stop_all"), "does not reach Example");
  EXPECT_NE(s.value("status/text").find("use its power switch"), std::string::npos);
  keep_picture(s, picture("lost"));
  const auto tried = s.hand.click("fault/try_now");
  ASSERT_TRUE(tried.has_value()) << tried.error().sentence();
  EXPECT_TRUE(a.last<intent::Reconnect>());
}

TEST_P(Screens, FourAxes) {
  Example& a = s.add(example_catalog(4));
  a.now.axes[3].position = Steps(-8388608);
  a.now.axes[2].limit_minus = true;
  s.run(0.2);
  for (int i = 1; i <= 4; ++i)
    for (const char* id : {"dro/{}/position", "dro/{}/state", "io/limit/{}/+"}) {
      const Widget* w = s.stage.find(fmt::format(fmt::runtime(id), i));
      ASSERT_TRUE(w) << id << i;
      EXPECT_TRUE(w->in_view()) << id << i;
    }
  EXPECT_EQ(s.value("dro/3/state"), "LIMIT -");
  EXPECT_EQ(s.value("dro/4/position"), "-8388608");
  keep_picture(s, picture("four"));
}

TEST_P(Screens, EightAxes) {
  Example& a = s.add(example_catalog(8));
  a.now.axes[3].position = Steps(-1'000'000);
  a.now.axes[4].limit_minus = true;
  a.now.axes[5].activity = Activity::moving;
  a.now.axes[5].direction = 1;
  a.now.axes[5].speed = Pps(2000);
  s.run(0.2);
  for (int i = 1; i <= 8; ++i)
    for (const char* id : {"dro/{}/position", "dro/{}/state", "io/limit/{}/+"}) {
      const Widget* w = s.stage.find(fmt::format(fmt::runtime(id), i));
      if (window.scale > 2) continue;  // smaller than the look asks for
      ASSERT_TRUE(w) << id << i;
      EXPECT_TRUE(w->in_view()) << id << i;
    }
  EXPECT_EQ(s.value("dro/4/position"), "-1000000");
  EXPECT_EQ(s.value("dro/5/state"), "LIMIT -");
  keep_picture(s, picture("eight"));
}

TEST_P(Screens, NothingLiesOverAnother) {
  for (const int axes : {1, 2, 4, 8}) {
    Example& a = s.add(example_catalog(axes));
    for (int i = 0; i < axes; ++i) {
      AxisState& axis = a.now.axes[static_cast<std::size_t>(i)];
      axis.position = Steps(-1'234'567 * i);
      axis.activity = i % 2 ? Activity::moving : Activity::idle;
      axis.direction = -1;
      axis.speed = Pps(5999);
      a.tab->settings.profile.axes[static_cast<std::size_t>(i)].name = "a long name of an axis";
    }
    s.run(0.2);
    expect_apart(axes);
    if (s.hand.click("tab/jog").has_value()) s.run(0.2);
    expect_apart(axes);
  }
}

TEST_P(Screens, NothingKnownYet) {
  Example& a = s.add();
  a.now = Snapshot();
  a.now.axis_count = 2;
  a.bench = BenchView();
  s.stale = true;
  s.run(0.2);
  EXPECT_EQ(s.value("dro/1/position"), "-");
  EXPECT_EQ(s.value("dro/1/state"), "CONNECTING");
  EXPECT_EQ(s.value("io/limit/1/+"), "?");
  keep_picture(s, picture("nothing"));
}

TEST_P(Screens, BeforeTheFirstMoveTheMotorTypeIsAskedFor) {
  Example& a = s.add();
  a.now.params[0].value = 0;
  s.run(0.2);
  const bool in_banner = s.stage.find("fault/unset") != nullptr;
  if (window.scale == 1.0f) expect({"fault/unset", "fault/setup", "fault/unset_read"});
  EXPECT_EQ(s.value("status/text").starts_with("No type is chosen for motor 1."), !in_banner)
      << "one of them says it, not both: " << s.value("status/text");
  keep_picture(s, picture("unset"));
}

TEST_P(Screens, Help) {
  s.add();
  s.run(0.1);
  EXPECT_EQ(s.stage.find("help") != nullptr, window.scale == 1.0f) << "in a narrow window it is in the menu";
  const auto pressed = s.hand.key("?");
  ASSERT_TRUE(pressed.has_value());
  s.run(0.1);
  expect({"help/1", "help/close", "dro/1/position", "stop_all"});
  keep_picture(s, picture("help"));
  ASSERT_TRUE(s.hand.key("?").has_value());
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("help/close"));
}

TEST(ScreensOnce, StopAllAndStatusNeverLeaveTheWindow) {
  for (const auto& [w, h] : {std::pair{640, 400}, {720, 450}, {1024, 700}, {1440, 900}, {2560, 1440}}) {
    ConsoleStage s(w, h);
    s.add(example_catalog(4));
    s.run(0.1);
    for (const char* id : {"stop_all", "status/text", "dro/4/position", "dro/4/state"}) {
      const Widget* widget = s.stage.find(id);
      ASSERT_TRUE(widget) << id;
      EXPECT_GE(widget->rect.min.x, 0) << id << w;
      EXPECT_LE(widget->rect.max.x, w) << id << w;
      EXPECT_GE(widget->rect.min.y, 0) << id << w;
      EXPECT_LE(widget->rect.max.y, h) << id << w;
    }
  }
}

TEST(ScreensOnce, EverydayControlsNeedNoScrolling) {
  for (const int axes : {1, 2, 3, 4}) {
    Catalog c = example_catalog(axes);
    c.can.interpolates = true;
    for (AxisInfo& axis : c.axes) axis.switchable = axis.encoder = true;
    ConsoleStage s;
    Example& a = s.add(c);
    for (AxisState& axis : a.now.axes) axis.has_encoder = axis.enabled = true;
    const auto expect_all = [&](const char* when) {
      s.run(0.2);
      for (int i = 1; i <= axes; ++i)
        for (const char* id : {"dro/{}/position", "dro/{}/encoder", "dro/{}/power", "jog/{}/+", "jog/{}/-",
                               "goto/{}", "goto/{}/go", "home/{}/-", "home/{}/+"}) {
          const bool of_chosen = id[0] == 'g' || id[0] == 'h';
          if (axes > 2 && i > 1 && of_chosen) continue;
          const Widget* w = s.stage.find(fmt::format(fmt::runtime(id), i));
          ASSERT_TRUE(w) << id << i << " of " << axes;
          EXPECT_TRUE(w->in_view()) << id << i << " of " << axes << ' ' << when;
        }
      for (const char* id : {"jog/stop", "jog/step/10", "jog/speed", axes > 2 ? "goto/axis" : "goto/zero",
                             "goto/speed", "places"}) {
        const Widget* w = s.stage.find(id);
        ASSERT_TRUE(w) << id;
        EXPECT_TRUE(w->in_view()) << id << " of " << axes << ' ' << when;
      }
    };
    expect_all("at rest");
    const Rect stop = s.stage.find("jog/stop")->rect;
    a.now.program.run = RunState::running;
    a.now.program.owned = true;
    expect_all("while a program runs");
    EXPECT_EQ(s.stage.find("jog/stop")->rect.min.y, stop.min.y) << "what a hand is about to press stays";
  }
}

TEST(ScreensOnce, OfManyAxesTheChosenOneGoes) {
  ConsoleStage s;
  Example& a = s.add(example_catalog(8));
  s.run(0.1);
  EXPECT_TRUE(s.hand.exists("goto/1"));
  EXPECT_FALSE(s.hand.exists("goto/7"));
  ASSERT_TRUE(s.hand.click("axis/7").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.type("goto/7", "400\n").has_value());
  s.run(0.1);
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.at(0).axis, AxisId{6});
  ASSERT_TRUE(s.hand.press("jog/5/-").has_value());
  s.run(0.5);
  ASSERT_TRUE(a.last<intent::JogStart>());
  EXPECT_EQ(a.last<intent::JogStart>()->axis, AxisId{4});
  ASSERT_TRUE(s.hand.release("jog/5/-").has_value());
  ASSERT_TRUE(s.hand.click("goto/axis").has_value());
  ASSERT_TRUE(s.hand.click("goto/axis/All axes").has_value());
  s.run(0.1);
  EXPECT_TRUE(s.hand.exists("goto/1"));
  EXPECT_TRUE(s.hand.exists("goto/8"));
  ASSERT_TRUE(s.hand.click("goto/all").has_value());
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("goto/1"));
  EXPECT_TRUE(s.hand.exists("goto/7"));
}

TEST(ScreensOnce, EightAxesJogInANarrowWindowToo) {
  ConsoleStage s(720, 450);
  Example& a = s.add(example_catalog(8));
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("tab/jog").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.press("jog/8/+").has_value());
  s.run(0.5);
  EXPECT_EQ(a.count<intent::JogStart>(), 1);
  ASSERT_TRUE(s.hand.release("jog/8/+").has_value());
}

TEST(ScreensOnce, TheConnectionPageKnowsWhatIsOpen) {
  ConsoleStage s;
  s.add();
  s.console.show_page("connect");
  s.run(0.1);
  EXPECT_EQ(s.value("status/text"),
            "One controller is open. Plug in another controller, type its address, or start an emulator.");
}

TEST(ScreensOnce, AConnectionByItsPartsFitsEachWindow) {
  for (const auto& [width, height] : {std::pair{1440, 900}, {1024, 700}}) {
    ConsoleStage s(width, height);
    s.run(0.1);
    for (const DeviceType& type : device_types()) {
      const auto catalog = type.make_catalog({});
      ASSERT_TRUE(s.hand.click("connect/form/model").has_value());
      s.run(0.1);
      ASSERT_TRUE(s.hand.click("connect/form/model/" + catalog->short_name).has_value()) << type.model;
      s.run(0.1);
      const Widget* last = s.stage.find("connect/look");
      ASSERT_TRUE(last);
      for (const Widget& w : s.stage.surface.screen().registry().widgets()) {
        if (!w.id.starts_with("connect/form/") && !w.id.starts_with("connect/search")) continue;
        EXPECT_LE(w.rect.max.x, last->rect.max.x + 1) << w.id << " of " << type.model << " at " << width;
        EXPECT_LE(w.rect.max.y, height - 36) << w.id << " of " << type.model << " at " << width;
      }
    }
  }
}

TEST(ScreensOnce, EachEmulatorOffersItsOptions) {
  ConsoleStage s;
  s.run(0.1);
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    ASSERT_TRUE(catalog.has_value());
    EXPECT_FALSE(catalog->options.empty()) << type.model;
    for (const OptionInfo& option : catalog->options)
      EXPECT_TRUE(s.stage.find(fmt::format("connect/emulator/{}/{}", type.model, option.key))) << type.model;
  }
}

TEST(ScreensOnce, TheFormOffersTheOptionsOfABoard) {
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    ASSERT_TRUE(catalog.has_value());
    if (!catalog->can.window) continue;
    ConsoleStage s;
    s.run(0.1);
    const auto click = [&](const std::string& id) {
      const auto done = s.hand.click(id);
      ASSERT_TRUE(done.has_value()) << id << ": " << done.error().sentence();
      s.run(0.1);
    };
    click("connect/form/model");
    click("connect/form/model/" + catalog->short_name);
    for (const OptionInfo& option : catalog->options) {
      click("connect/form/" + option.key);
      click("connect/form/" + option.key + "/" + option.choices[1].second);
      const std::string wanted = "," + option.key + "=" + option.choices[1].first;
      EXPECT_NE(s.stage.find("connect/form/address")->value.find(wanted), std::string::npos) << wanted;
    }
  }
}

TEST(ScreensOnce, TheFormOffersTheWaysThatAControllerHas) {
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    ASSERT_TRUE(catalog.has_value());
    ConsoleStage s;
    s.run(0.1);
    const auto click = [&](const std::string& id) {
      const auto done = s.hand.click(id);
      ASSERT_TRUE(done.has_value()) << id << ": " << done.error().sentence();
      s.run(0.1);
    };
    click("connect/form/model");
    click("connect/form/model/" + catalog->short_name);
    click("connect/form/way");
    const bool board = catalog->can.window;
    for (const char* way : {"serial", "tcp", "RFC 2217"})
      EXPECT_EQ(s.stage.find(fmt::format("connect/form/way/{}", way)) != nullptr, !board)
          << way << type.model;
    EXPECT_EQ(s.stage.find("connect/form/way/USB") != nullptr, catalog->can.usb) << type.model;
    EXPECT_EQ(s.stage.find("connect/form/way/VME") != nullptr, board) << type.model;
    if (board) continue;
    click("connect/form/way/RFC 2217");
    EXPECT_TRUE(s.value("connect/form/address")
                    .starts_with(std::string(type.model) + "@rfc2217:127.0.0.1:4001,baud=9600"))
        << s.value("connect/form/address");
  }
}

TEST(ScreensOnce, NarrowWindowHasJogAndSignalsAsTabs) {
  ConsoleStage s(720, 450);
  Example& a = s.add();
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("tab/jog").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.press("jog/1/+").has_value());
  s.run(0.5);
  EXPECT_EQ(a.count<intent::JogStart>(), 1);
  ASSERT_TRUE(s.hand.release("jog/1/+").has_value());
  ASSERT_TRUE(s.hand.click("tab/io").has_value());
  s.run(0.1);
  EXPECT_TRUE(s.hand.exists("io/out/1"));
}

TEST(ScreensOnce, RailUnfoldsOverTheCentre) {
  ConsoleStage s(1024, 700);
  s.add();
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("io/out/1"));
  ASSERT_TRUE(s.hand.click("rail/open").has_value());
  s.run(0.1);
  const auto clicked = s.hand.click("io/out/1");
  EXPECT_TRUE(clicked) << clicked.error().sentence();
}

TEST(ScreensOnce, ControllersAreRenamedAndClosed) {
  ConsoleStage s;
  s.add();
  s.add();
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("menu").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("menu/names").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.type("names/controller", "Stage").has_value());
  ASSERT_TRUE(s.hand.type("names/1", "across").has_value());
  ASSERT_TRUE(s.hand.click("names/ok").has_value());
  s.run(0.1);
  EXPECT_EQ(s.console.tabs()[1]->name(), "Stage");
  EXPECT_EQ(s.console.tabs()[1]->settings.profile.axes[0].name, "across");
  ASSERT_TRUE(s.hand.click("menu").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("menu/close").has_value());
  s.run(0.1);
  ASSERT_EQ(s.console.tabs().size(), 1u);
  EXPECT_EQ(s.console.active(), s.console.tabs()[0].get());
}

TEST(ScreensOnce, ClosingWhatMovesAsksFirst) {
  ConsoleStage s;
  Example& a = s.add();
  a.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("menu").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("menu/close").has_value());
  s.run(0.1);
  EXPECT_EQ(s.console.tabs().size(), 1u);
  ASSERT_TRUE(s.hand.click("close/stop").has_value());
  s.run(0.1);
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  EXPECT_TRUE(s.console.tabs().empty());
  EXPECT_EQ(s.console.page(), "connect");
}

TEST(ScreensOnce, AnAddressThatMakesNoSenseIsRefusedInWords) {
  ConsoleStage s;
  s.run(0.1);
  ASSERT_TRUE(s.hand.type("connect/address", "teapot@stove\n").has_value());
  s.run(0.1);
  EXPECT_NE(s.value("connect/refused").find("teapot"), std::string::npos);
  EXPECT_EQ(s.value("connect/address"), "teapot@stove");
}

TEST(ScreensOnce, AnUnwatchedRefusalIsReportedOnce) {
  ConsoleStage s;
  Example& a = s.add();
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("home/1/-").has_value());
  a.outcome(IntentState::refused, "The home switch is not there. Nothing was sent.");
  s.run(0.2);
  EXPECT_EQ(s.value("toast/1"), "The home switch is not there. Nothing was sent.");
  s.run(10);
  EXPECT_TRUE(s.hand.exists("toast/1")) << "a fault stays until it is read";
  ASSERT_TRUE(s.hand.click("message/close/1").has_value());
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("toast/1"));
}

TEST(ScreensOnce, AToastNamesItsControllerOverTheTabOfAnother) {
  ConsoleStage s;
  Example& a = s.add();
  a.tab->settings.profile.name = "Stage";
  s.console.toast(*a.tab, Severity::fault, "The home switch is not there.");
  s.run(0.2);
  EXPECT_EQ(s.value("toast/1"), "The home switch is not there.");
  s.add();
  s.run(0.2);
  ASSERT_NE(s.console.active(), a.tab);
  EXPECT_EQ(s.value("toast/1"), "Stage: The home switch is not there.");
}

TEST(ScreensOnce, MessagesAboutATextGoWhenTheTextChanges) {
  ConsoleStage s;
  Example& a = s.add();
  a.tab->panels.in_front = "program";
  a.tab->desk().programs.texts.set_text(0, "I1M400");
  s.run(0.1);
  s.console.toast(Severity::fault, "Nothing was sent. Line 1: BAD is no command.",
                  &a.tab->desk().programs.texts);
  s.console.toast(Severity::fault, "The home switch is not there.");
  s.run(0.2);
  ASSERT_TRUE(s.hand.exists("toast/1"));
  a.tab->desk().programs.texts.set_text(0, "I1M500");
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("toast/1"));
  EXPECT_TRUE(s.hand.exists("toast/2")) << "it spoke of something else";
  s.console.toast(Severity::fault, "Line 1: no.", &a.tab->desk().programs.texts);
  s.run(0.1);
  ASSERT_TRUE(s.hand.exists("toast/3"));
  a.now.program.started_at = s.scheduler.now();
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("toast/3")) << "a program was started";
}

TEST(ScreensOnce, ARefusedTargetIsBroughtIntoView) {
  ConsoleStage s(1024, 700);
  s.add(example_catalog(4));
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("goto/axis").has_value());
  ASSERT_TRUE(s.hand.click("goto/axis/All axes").has_value());
  s.run(0.1);
  ASSERT_TRUE(s.hand.type("goto/4", "99999999\n").has_value());
  s.run(0.2);
  const gui::Widget* refused = s.stage.find("goto/4/refused");
  ASSERT_TRUE(refused);
  EXPECT_TRUE(refused->in_view());
  ASSERT_TRUE(s.stage.find("goto/4/nearest"));
  EXPECT_TRUE(s.stage.find("goto/4/nearest")->in_view());
}

TEST(ScreensOnce, AnOutputHasRoomForTheNameOfItsDuty) {
  ConsoleStage s;
  Catalog c = example_catalog();
  c.outputs[0].duty = {"In position", {"type1"}};
  Example& a = s.add(std::move(c));
  a.now.params[0] = {0, true, true};
  s.run(0.1);
  const float free = s.stage.find("io/out/1")->rect.width();
  EXPECT_GT(free, 180) << "a line of its own";
  a.now.params[0].value = 1;
  s.run(0.1);
  EXPECT_EQ(s.stage.find("io/out/1")->label, "In position");
  EXPECT_EQ(s.stage.find("io/out/1")->rect.width(), free) << "its place does not change";
}

}  // namespace
}  // namespace hw::panels
