// The gamepad on the whole console: its switch, and what reaches the wires of real drivers and emulators.
// Its entries are pushed into the input queue as the window pushes them; no gamepad of metal is behind them.
#include <filesystem>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <gmock/gmock.h>

#include "gui/input/gamepad_source.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/must.h"
#include "transports/open.h"

namespace hw::panels {
namespace {

using namespace gui;
using testing::HasSubstr;
using testing::Not;

constexpr int lb = GLFW_GAMEPAD_BUTTON_LEFT_BUMPER;
constexpr int left_x = GLFW_GAMEPAD_AXIS_LEFT_X, left_y = GLFW_GAMEPAD_AXIS_LEFT_Y;

/// The hand on it, and the window that looks at it with each frame.
struct PadHand {
  Stage& stage;
  Gamepad& pad = stage.surface.screen().gamepad();
  PadState state{};
  PadChanges changes{};
  bool answers = true, there = true;

  void plug_in() { pad.came("Example Pad"); }
  void run(double seconds) {
    for (int n = static_cast<int>(seconds * 60 + 0.5); n > 0; --n) {
      if (pad.armed() && answers)
        changes.report(there ? std::optional(state) : std::nullopt, stage.now_s,
                       [this](const InputEvent& e) { stage.push(e); });
      stage.frame();
    }
  }
  void stick(int axis, float place) { state.axes[static_cast<std::size_t>(axis)] = place; }
  void button(int which, bool down) { state.buttons[static_cast<std::size_t>(which)] = down; }
};

// ---- its switch

class GamepadSwitch : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add();
  PadHand hand{s.stage};
  void SetUp() override { s.run(0.5); }
};

TEST_F(GamepadSwitch, IsThereWithAGamepadOnlyAndMovesNothing) {
  EXPECT_FALSE(s.stage.find("jog/gamepad"));
  const Rect jog = s.stage.find("jog/1/+")->rect, stop = s.stage.find("jog/stop")->rect;
  hand.plug_in();
  s.run(0.1);
  ASSERT_TRUE(s.stage.find("jog/gamepad"));
  EXPECT_EQ(s.value("jog/gamepad"), "off, Example Pad");
  EXPECT_EQ(s.stage.find("jog/1/+")->rect.min.y, jog.min.y);
  EXPECT_EQ(s.stage.find("jog/stop")->rect.max.x, stop.max.x);
  MUST(s.hand.click("jog/gamepad"));
  EXPECT_EQ(s.value("jog/gamepad"), "armed, Example Pad");
  MUST(s.hand.click("jog/gamepad"));
  EXPECT_EQ(s.value("jog/gamepad"), "off, Example Pad");
}

TEST_F(GamepadSwitch, HasAPlaceOfItsOwnInEveryWindow) {
  hand.plug_in();
  const auto check = [&](ConsoleStage& on, const std::string& what) {
    on.stage.surface.screen().gamepad().came("Example Pad");
    if (on.hand.exists("tab/jog")) MUST(on.hand.click("tab/jog"));
    on.run(0.2);
    const Widget* mine = on.stage.find("jog/gamepad");
    ASSERT_TRUE(mine) << what;
    for (const Widget& w : on.stage.surface.screen().registry().widgets()) {
      if (w.id == mine->id || !w.id.starts_with("jog/") || w.kind == Kind::text) continue;
      const bool apart = w.rect.max.x <= mine->rect.min.x || mine->rect.max.x <= w.rect.min.x ||
                         w.rect.max.y <= mine->rect.min.y || mine->rect.max.y <= w.rect.min.y;
      EXPECT_TRUE(apart) << what << ": " << w.id;
    }
  };
  for (const int axes : {1, 2, 3, 4, 8})
    for (const auto& [width, height, scale] :
         {std::tuple(1440, 900, 1.0f), {1024, 700, 1.0f}, {640, 400, 1.0f}, {1440, 900, 2.0f}}) {
      ConsoleStage on(width, height, scale);
      on.add(example_catalog(axes));
      on.run(0.3);
      check(on, fmt::format("{} axes, {} x {} at {}", axes, width, height, scale));
    }
}

TEST_F(GamepadSwitch, LettingGoStopsAlsoWhereAnotherAxisHasBeenChosenSince) {
  constexpr int up = GLFW_GAMEPAD_BUTTON_DPAD_UP;
  hand.plug_in();
  MUST(s.hand.click("jog/gamepad"));
  hand.run(0.1);
  hand.button(lb, true);
  hand.run(0.1);
  hand.button(up, true);
  hand.run(0.5);
  ASSERT_EQ(a.count<intent::JogStart>(), 1);
  a.tab->view.chosen_axis = AxisId{1};
  hand.button(up, false);
  hand.run(0.03);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
}

TEST_F(GamepadSwitch, AnythingElseThatEndsItsJogKeepsItFromGoingOn) {
  hand.plug_in();
  MUST(s.hand.click("jog/gamepad"));
  hand.run(0.1);
  hand.button(lb, true);
  hand.run(0.1);
  hand.stick(left_x, 1);
  hand.run(0.5);
  ASSERT_EQ(a.count<intent::JogStart>(), 1);
  s.console.show_page("connect");  // another page: nobody sees the axis
  hand.run(0.1);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
  s.console.activate(*a.tab);
  hand.stick(left_y, 1);
  hand.run(1);
  EXPECT_EQ(a.count<intent::JogStart>(), 1) << "the stick was never let go";
  hand.stick(left_x, 0);
  hand.stick(left_y, 0);
  hand.run(0.1);
  hand.stick(left_y, -1);
  hand.run(0.5);
  ASSERT_EQ(a.count<intent::JogStart>(), 2);
  EXPECT_EQ(a.last<intent::JogStart>()->axis.index, 1);
  EXPECT_EQ(a.last<intent::JogStart>()->sign, Sign::plus);
}

TEST_F(GamepadSwitch, AStickHasNoTapsAndTheDPadHas) {
  hand.plug_in();
  MUST(s.hand.click("jog/gamepad"));
  hand.run(0.1);
  hand.button(lb, true);
  hand.run(0.1);
  hand.stick(left_x, 1);
  hand.run(0.1);
  hand.stick(left_x, 0);
  hand.run(0.5);
  EXPECT_TRUE(a.sent.empty());
  hand.button(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, true);
  hand.run(0.1);
  hand.button(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, false);
  hand.run(0.1);
  EXPECT_EQ(a.count<intent::MoveBy>(), 1);
  hand.button(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, true);
  hand.run(0.1);
  hand.button(lb, false);
  hand.run(0.5);
  EXPECT_EQ(a.count<intent::MoveBy>(), 1) << "the dead-man button ended it: that was no tap";
  EXPECT_EQ(a.count<intent::JogStart>(), 0);
}

TEST_F(GamepadSwitch, ADialogIsAnsweredFirst) {
  hand.plug_in();
  MUST(s.hand.click("jog/gamepad"));
  hand.run(0.1);
  hand.button(lb, true);
  MUST(s.hand.click("menu"));
  hand.run(0.2);
  hand.stick(left_x, 1);
  hand.run(0.5);
  EXPECT_TRUE(a.sent.empty());
}

TEST_F(GamepadSwitch, ADialogThatOpensEndsItsJog) {
  hand.plug_in();
  MUST(s.hand.click("jog/gamepad"));
  hand.run(0.1);
  hand.button(lb, true);
  hand.run(0.1);
  hand.stick(left_x, 1);
  hand.run(0.5);
  ASSERT_EQ(a.count<intent::JogStart>(), 1);
  ASSERT_EQ(a.count<intent::JogStop>(), 0);
  const ImVec2 menu = s.stage.find("menu")->rect.centre();
  s.stage.push(InputEvent::mouse_move(menu.x, menu.y, s.stage.now_s));
  hand.run(0.05);
  for (const bool down : {true, false}) {
    s.stage.push(InputEvent::mouse_button(0, down, menu, s.stage.now_s));
    hand.run(0.1);
  }
  ASSERT_GT(s.stage.surface.screen().registry().top_layer(), 0);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
  EXPECT_TRUE(hand.pad.armed());
  s.stage.push(InputEvent::key(GLFW_KEY_ESCAPE, true, s.stage.now_s));
  s.stage.push(InputEvent::key(GLFW_KEY_ESCAPE, false, s.stage.now_s));
  hand.run(1);
  EXPECT_EQ(a.count<intent::JogStart>(), 1) << "the stick was never let go";
}

TEST_F(GamepadSwitch, ADialogThatOpensEndsTheJogOfAKeyToo) {
  s.stage.push(InputEvent::key(GLFW_KEY_RIGHT, true, s.stage.now_s));
  hand.run(0.5);
  ASSERT_EQ(a.count<intent::JogStart>(), 1);
  MUST(s.hand.click("menu"));
  hand.run(0.1);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
  hand.run(0.5);
  EXPECT_EQ(a.count<intent::JogStart>(), 1);
}

TEST_F(GamepadSwitch, TheHelpShowsIt) {
  MUST(s.hand.click("help"));
  s.run(0.1);
  std::string all;
  for (const Widget& w : s.stage.surface.screen().registry().widgets())
    if (w.id.starts_with("help/")) all += std::string(w.label) + ": " + std::string(w.value) + "\n";
  EXPECT_THAT(all, HasSubstr("Left stick: Across jogs axis 1, up and down axis 2"));
  EXPECT_THAT(all, HasSubstr("B: Stop all controllers"));
}

// To be looked at: build/pictures/gamepad-*.png
TEST(GamepadSwitchLook, Pictures) {
  const std::filesystem::path folder = HW_BINARY_DIR "/pictures";
  std::filesystem::create_directories(folder);
  struct Shape {
    int width, height, axes;
    float scale;
    bool dark;
  };
  for (const Shape& shape :
       {Shape{1440, 900, 2, 1, true}, Shape{1440, 900, 4, 1, false}, Shape{1024, 700, 4, 1, true},
        Shape{1024, 700, 8, 1, false}, Shape{1440, 900, 4, 2, true}}) {
    ConsoleStage s(shape.width, shape.height, shape.scale, shape.dark);
    s.add(example_catalog(shape.axes));
    PadHand hand{s.stage};
    hand.plug_in();
    hand.run(0.5);
    if (s.hand.exists("tab/jog")) MUST(s.hand.click("tab/jog"));
    hand.run(0.1);
    const auto shoot = [&](const char* name) {
      const std::string file = fmt::format("gamepad-{}-{}-{}x{}-{}.png", name, shape.axes, shape.width,
                                           shape.scale, shape.dark ? "dark" : "light");
      EXPECT_TRUE(s.stage.surface.screenshot((folder / file).string()));
    };
    shoot("off");
    MUST(s.hand.click("jog/gamepad"));
    hand.run(0.2);
    shoot("armed");
  }
}

// ---- on the wire

struct PadRig {
  IoContext io;
  VirtualScheduler clock{io};
  Console console{panel_list(), outside(clock)};
  Stage stage{[this](Ui& ui) {
    clock.run_until(Instant(from_seconds(stage.now_s)));
    console.draw(ui);
  }};
  PadHand hand{stage};

  explicit PadRig(const std::string& address) {
    console.attach(stage.surface.screen().keyboard());
    EXPECT_TRUE(console.open(address));
    hand.run(8);
    for (std::size_t i = 0; i < tab().catalog().axes.size(); ++i)
      if (!tab().now().axes[i].enabled) tab().send(intent::SetPower(static_cast<int>(i), true));
    hand.run(2);
    hand.plug_in();
    stage.frames(3);
    EXPECT_TRUE(stage.hand.click("jog/gamepad"));
    hand.run(0.1);
    hand.button(lb, true);
    hand.run(0.1);
  }
  ~PadRig() {
    console.close_all();
    clock.run_until(clock.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  static Outside outside(Scheduler& scheduler) {
    return {scheduler, make_wire_opener(), [] {}};
  }
  Tab& tab() { return *console.tabs().front(); }
  /// What went out since the last call, without the questions of each round.
  std::string sent() {
    const TrafficLog& log = tab().desk().records.traffic;
    std::string all;
    for (; next < log.first_record() + log.records(); ++next) {
      const TrafficLog::Entry e = log.entry(next);
      if (e.way == Way::sent && e.kind != TrafficKind::poll) all += std::string(e.bytes) + " ";
    }
    return all;
  }
  bool at_rest() { return !tab().now().any_axis_moving(); }
  std::uint64_t next = 0;
};

struct PadWire {
  const char* address;
  std::string go, stop;  ///< of the first axis, +
};
void PrintTo(const PadWire& wire, std::ostream* out) { *out << wire.address; }

class GamepadWire : public testing::TestWithParam<PadWire> {
 protected:
  PadRig rig{GetParam().address};
  PadHand& hand = rig.hand;
  void jog() {
    rig.sent();
    hand.stick(left_x, 1);
    hand.run(1.5);
    EXPECT_THAT(rig.sent(), HasSubstr(GetParam().go));
    EXPECT_FALSE(rig.at_rest());
  }
  void expect_stopped() {
    EXPECT_THAT(rig.sent(), HasSubstr(GetParam().stop));
    hand.run(3);
    EXPECT_TRUE(rig.at_rest());
    EXPECT_THAT(rig.sent(), Not(HasSubstr(GetParam().go)));
  }
};

TEST_P(GamepadWire, LettingGoOfTheStickStops) {
  jog();
  hand.stick(left_x, 0);
  hand.run(0.2);
  expect_stopped();
  EXPECT_TRUE(hand.pad.armed());
}

TEST_P(GamepadWire, LettingGoOfTheDeadManButtonStops) {
  jog();
  hand.button(lb, false);
  hand.run(0.2);
  expect_stopped();
}

TEST_P(GamepadWire, LosingTheWindowStopsAndDisarms) {
  jog();
  rig.stage.push(InputEvent::focus_lost(rig.stage.now_s));
  hand.run(0.2);
  expect_stopped();
  EXPECT_FALSE(hand.pad.armed());
}

TEST_P(GamepadWire, BStopsEverything) {
  jog();
  hand.button(GLFW_GAMEPAD_BUTTON_B, true);
  hand.run(0.2);
  hand.run(3);
  EXPECT_TRUE(rig.at_rest());
  EXPECT_THAT(rig.sent(), Not(HasSubstr(GetParam().go))) << "the stick is still pushed";
}

TEST_P(GamepadWire, OneThatIsPulledOutStops) {
  jog();
  hand.there = false;
  hand.run(0.2);
  expect_stopped();
  EXPECT_FALSE(hand.pad.present());
  ASSERT_FALSE(rig.console.toasts().list().empty());
  EXPECT_THAT(rig.console.toasts().list().back().text, HasSubstr("it is gone"));
}

TEST_P(GamepadWire, OneThatDoesNotAnswerStops) {
  jog();
  hand.answers = false;
  hand.run(0.5);
  expect_stopped();
  EXPECT_FALSE(hand.pad.armed());
}

INSTANTIATE_TEST_SUITE_P(Controllers, GamepadWire,
                         testing::Values(PadWire{"vxm@emulator", "I1M", "D"},
                                         PadWire{"pmx-4ex-sa@emulator", "JX+", "STOPX"}));

}  // namespace
}  // namespace hw::panels
