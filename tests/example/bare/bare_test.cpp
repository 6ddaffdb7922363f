// A controller with the least that a DeviceType may have: no emulator, no language, no explanations, no
// probe, no bench. Its wire leads to a Twin that the console takes for a real one. The whole console is
// opened on it, each of its panels is drawn and pressed, and a script drives it.
#include <gmock/gmock.h>

#include "core/device/driver.h"
#include "core/emulation/emulator.h"
#include "core/script/runner.h"
#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "panels/panel_list.h"
#include "tests/core/device/loopback.h"
#include "tests/example/twin.h"
#include "tests/gui/stage.h"

namespace hw {
namespace {

using testing::HasSubstr;

constexpr std::string_view model = "bare";

DeviceType bare_type() {
  DeviceType t{};
  t.model = model;
  t.make_catalog = [](const DeviceOptions& options) {
    auto catalog = twin::make_catalog(options);
    catalog->model = model;
    return catalog;
  };
  t.make_driver = twin::make_driver;
  return t;
}

/// A wire to a Twin that no bench shows.
WireOpener opener(test::Loopback& loop) {
  return [&loop](Scheduler&, Address, std::shared_ptr<BenchAccess>) -> Task<Result<Wire>> {
    Wire wire;
    wire.stream = loop.plug();
    co_return wire;
  };
}

struct Rig {
  IoContext io;
  VirtualScheduler clock{io};
  test::Loopback loop{clock, *twin::make_emulator({}), false};
  gui::Console console{panels::panel_list(), gui::Outside{clock, opener(loop), [] {}}};
  gui::Stage stage{[this](gui::Ui& ui) {
    clock.run_until(Instant(from_seconds(stage.now_s)));
    console.draw(ui);
  }};
  Rig() {
    const auto opened = console.open("bare@tcp:rack:4001");
    EXPECT_TRUE(opened) << opened.error().sentence();
    run(2);
  }
  ~Rig() {
    console.close_all();
    clock.run_until(clock.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  void run(double seconds) {
    for (int n = static_cast<int>(seconds * 60 + 0.5); n > 0; --n) stage.frame();
  }
  gui::Tab& tab() { return *console.tabs().at(0); }
};

TEST(Bare, TheConsoleOpensItAndMovesIt) {
  Rig s;
  ASSERT_TRUE(s.tab().now().link.connected()) << s.tab().now().link.sentence.view();
  EXPECT_FALSE(s.tab().bench().present);
  s.tab().send_followed(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  s.run(2);
  EXPECT_EQ(s.tab().now().axes[0].position, Steps(400));
  EXPECT_THAT(s.tab().messages.complaints(), testing::IsEmpty());
}

/// Whether a press on it may leave the panel or the controller.
bool leads_elsewhere(std::string_view id) {
  for (const std::string_view other : {"tab/", "menu", "help", "stop", "file/", "close", "add"})
    if (id.find(other) != id.npos) return true;
  return false;
}

TEST(Bare, EachPanelIsDrawnAndItsButtonsTakeAPress) {
  Rig s;
  int pressed = 0;
  for (const gui::PanelEntry& entry : s.console.list().panels) {
    s.console.show_panel(entry.id);
    s.run(0.1);
    for (const auto& w : s.stage.hand.list()) {
      if (w.kind != "button" || !w.enabled || w.moving || leads_elsewhere(w.id)) continue;
      if (s.stage.hand.click(w.id)) ++pressed;
      (void)s.stage.hand.key("Escape");
      ASSERT_EQ(s.console.tabs().size(), 1u) << w.id;
      s.console.show_panel(entry.id);
    }
  }
  EXPECT_GT(pressed, 10);
  s.run(1);
  EXPECT_TRUE(s.tab().now().link.connected());
}

/// What a script without a window does with it, and what is said where a part is missing.
std::string printed(const std::string& text) {
  IoContext io{1};
  HybridScheduler time(io, false);
  test::Loopback loop{time, *twin::make_emulator({}), false};
  std::string out;
  script::RunOptions options;
  options.path = "bare.lua";
  options.opener = opener(loop);
  options.print = [&](std::string_view line) { return out += line, Result<>(); };
  options.log = [](std::string_view) {};
  script::Runner runner(time, std::move(options));
  const auto ran = runner.run("local c = hw.open('bare@tcp:rack:4001')\n" + text);
  return out + (ran ? "" : ran.error().what);
}

TEST(Bare, AScriptMovesIt) {
  EXPECT_EQ(printed("c:move_to{A = 250} c:wait() print(c:position('A'))"), "250\n");
}

TEST(Bare, AScriptIsRefusedWhatTheDeviceLacks) {
  EXPECT_THAT(printed("print(c:run(0))"), HasSubstr("Twin has no programs."));
  EXPECT_THAT(printed("print(c:load('x', 0))"), HasSubstr("Twin has no programs."));
  EXPECT_THAT(printed("print(c:program(0))"), HasSubstr("Twin has no programs."));
  EXPECT_THAT(printed("print(c:rehearse('x'))"), HasSubstr("Twin has no programs."));
  EXPECT_THAT(printed("c.bench:power_cycle()"), HasSubstr("so it has no bench"));
}

}  // namespace
}  // namespace hw

int main(int argc, char** argv) {
  hw::add_device_type(hw::bare_type());
  testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
