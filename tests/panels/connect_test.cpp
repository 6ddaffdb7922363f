// The connection page with ports in every state: what it says of each, and the test of a port.
#include <cstdlib>
#include <filesystem>
#include <tuple>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "core/base/log.h"
#include "gui/shell/device_finder.h"
#include "tests/core/session/folder.h"
#include "tests/panels/console_stage.h"

namespace hw::panels {
namespace {

using gui::FoundPort;
using gui::Widget;

class Ports final : public gui::PortFinder {
 public:
  std::vector<FoundPort> list;
  std::vector<std::string> asked;
  bool looking = false;
  const std::vector<FoundPort>& ports() override { return list; }
  void look() override { looking = true; }
  void watch(bool) override {}
  void ask(const std::string& path) override { asked.push_back(path); }
  [[nodiscard]] bool busy() const override { return looking; }
};

FoundPort port(std::string path, FoundPort::State state, std::string sentence = {}) {
  FoundPort p;
  p.path = std::move(path);
  p.hardware = "FTDI FT232R, A10K2LQX";
  p.state = state;
  p.sentence = std::move(sentence);
  return p;
}

FoundPort silent_after_test() {
  using Is = FoundPort::Check::Result;
  FoundPort p = port("/dev/ttyS0", FoundPort::State::silent, "It was asked at 9600, 19200 and 38400 baud.");
  p.hardware = "serial port on the board";
  const auto check = [&](Is result, const char* what, const char* found) {
    FoundPort::Check c;
    c.result = result, c.what = what, c.found = found;
    p.checks.push_back(c);
  };
  check(Is::good, "Port opens", "no other program uses it");
  check(Is::good, "Bytes leave", "3 speeds");
  check(Is::bad, "Bytes return", "none came back");
  check(Is::not_reached, "Reply understood", "not reached");
  p.advice = {
      "The supply. Is the controller's green lamp lit?",
      "The cable. It must be straight through; try it with RX and TX swapped (a null-modem adapter).",
      "The port. Is the cable plugged into this port? Unplug it and watch which port leaves this list."};
  return p;
}

class Devices final : public gui::DeviceFinder {
 public:
  std::vector<std::string> started;
  gui::DeviceSearchState now;
  void start(const std::string& path, int baud, int first, int last) override {
    started.push_back(fmt::format("{} {} {}-{}", path.empty() ? "every port" : path, baud, first, last));
    now.running = true;
  }
  void cancel() override { now.running = false, now.cancelled = true; }
  const gui::DeviceSearchState& state() override { return now; }
};

struct Page {
  IoContext io;
  VirtualScheduler scheduler{io};
  Ports ports;
  Devices devices;
  gui::Console console{panel_list(), outside()};
  gui::Stage stage;

  explicit Page(int width = 1440, int height = 900, float scale = 1, bool dark = true)
      : stage([this](gui::Ui& ui) { console.draw(ui); }, width, height, scale, dark) {
    FoundPort answers = port("/dev/ttyUSB0", FoundPort::State::answers, "answers at 9600 baud in 11 ms");
    answers.title = "Example Controller";
    answers.address = "example@serial:/dev/ttyUSB0,baud=9600";
    ports.list = {answers, port("/dev/ttyUSB1", FoundPort::State::asking),
                  port("/dev/ttyUSB2", FoundPort::State::busy,
                       "minicom (process 4182) holds it. Close it there first."),
                  port("/dev/ttyUSB3", FoundPort::State::forbidden,
                       "It may not be opened. Type: sudo usermod -aG dialout $USER, and log in anew."),
                  silent_after_test()};
    stage.frames(3);
  }
  gui::Outside outside() {
    gui::Outside o(scheduler, WireOpener(), [] {});
    o.ports = &ports;
    o.devices = &devices;
    return o;
  }
  std::string label(const char* id) {
    const Widget* w = stage.find(id);
    return w ? std::string(w->label) : "(absent)";
  }
};

TEST(ConnectPage, EachPortHasItsWayOn) {
  Page p;
  EXPECT_EQ(p.label("connect/port/0"), "Connect");
  EXPECT_EQ(p.label("connect/port/2"), "Identify");
  EXPECT_EQ(p.label("connect/port/3"), "Identify");
  const Widget* asking = p.stage.find("connect/port/1");
  ASSERT_TRUE(asking);
  EXPECT_FALSE(asking->enabled);
  EXPECT_EQ(p.stage.hand.value("status/text").value_or(""),
            "1 controller answers on 5 ports. Choose one, or start an emulator.");
}

TEST(ConnectPage, ShowsTheLogWhileNoControllerIsOpen) {
  for (const auto& [width, height, scale] : {std::tuple{1440, 900, 1.f}, std::tuple{1024, 700, 2.f}}) {
    Page p(width, height, scale);
    ASSERT_TRUE(p.stage.hand.click("connect/log")) << width;
    ::testing::internal::CaptureStderr();
    log::subject("link").add(log::Level::warning, "/dev/ttyUSB0 not opened: no permission");
    ::testing::internal::GetCapturedStderr();
    p.stage.frames(3);
    EXPECT_NE(p.stage.hand.value("decisions/log").value_or("").find("warning link: /dev/ttyUSB0 not opened"),
              std::string::npos);
    const Widget* level = p.stage.find("decisions/level");
    ASSERT_TRUE(level);
    EXPECT_LE(level->rect.max.x, static_cast<float>(width) * scale);
    EXPECT_FALSE(p.stage.find("connect/look"));
    ASSERT_TRUE(p.stage.hand.click("connect/log/close"));
    p.stage.frames(2);
    EXPECT_TRUE(p.stage.find("connect/look"));
  }
}

TEST(ConnectPage, APortIsTestedAndTheProgressIsShown) {
  Page p;
  ASSERT_TRUE(p.stage.hand.click("connect/port/4/test"));
  EXPECT_EQ(p.ports.asked, std::vector<std::string>{"/dev/ttyS0"});
  p.stage.frames(2);
  EXPECT_EQ(p.stage.hand.value("connect/port/4/check/1").value_or("(none)"),
            "good: no other program uses it");
  EXPECT_EQ(p.stage.hand.value("connect/port/4/check/3").value_or("(none)"), "bad: none came back");
  EXPECT_EQ(p.stage.hand.value("connect/port/4/check/4").value_or("(none)"), "not reached: not reached");
}

TEST(ConnectPage, ASearchGoesOverEveryPortAndReportsWhatItFinds) {
  Page p;
  const auto value = [&](const char* id) { return p.stage.hand.value(id).value_or("(none)"); };
  ASSERT_TRUE(p.stage.hand.click("connect/search"));
  p.stage.frames(2);
  EXPECT_EQ(p.devices.started, std::vector<std::string>{"every port 0 0-99"});
  p.devices.now.asked = 3, p.devices.now.of = 1500, p.devices.now.now = "/dev/ttyUSB1 at 9600 baud, id 02";
  p.stage.frames(2);
  EXPECT_EQ(value("connect/search/progress"), "3 of 1500: /dev/ttyUSB1 at 9600 baud, id 02");
  p.devices.now.found = {{"Arcus DMX-K-SA", "dmx-k-sa@serial:/dev/ttyUSB3,id=05", "with id 05 answers"},
                         {"/dev/ttyUSB2", "", "minicom holds it."}};
  p.devices.now.running = false, p.devices.now.asked = 1500;
  p.stage.frames(2);
  EXPECT_EQ(value("connect/search/found/0/text"), "Arcus DMX-K-SA, with id 05 answers");
  EXPECT_EQ(value("connect/search/found/1/text"), "/dev/ttyUSB2, minicom holds it.")
      << "a port that could not be asked is told";
  EXPECT_FALSE(p.stage.find("connect/search/found/1"));
  EXPECT_EQ(value("connect/search/progress"), "Done after 1500 of 1500 queries, 1 found.");
}

TEST(ConnectPage, LooksAgainOnce) {
  Page p;
  ASSERT_TRUE(p.stage.hand.click("connect/look"));
  EXPECT_TRUE(p.ports.looking);
  p.stage.frames(2);
  EXPECT_FALSE(p.stage.hand.click("connect/look")) << "while it looks, the button says so";
}

// To be looked at: build/pictures/connect-ports-*.png
TEST(ConnectPage, Pictures) {
  const std::filesystem::path folder = HW_BINARY_DIR "/pictures";
  std::filesystem::create_directories(folder);
  struct Shape {
    const char* name;
    int width, height;
    float scale;
    bool dark;
  };
  for (const Shape& shape :
       {Shape{"1440-dark", 1440, 900, 1, true}, Shape{"1440-light", 1440, 900, 1, false},
        Shape{"1024-dark", 1024, 700, 1, true}, Shape{"narrow200-dark", 720, 450, 2, true}}) {
    Page p(shape.width, shape.height, shape.scale, shape.dark);
    ASSERT_TRUE(p.stage.hand.click("connect/port/4/test"));
    p.stage.frames(3);
    EXPECT_TRUE(
        p.stage.surface.screenshot((folder / fmt::format("connect-ports-{}.png", shape.name)).string()));
  }
}

TEST(ConnectPage, ShowsWhenTheLastRunWasClosed) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  const auto closed_words = [&] {
    ConsoleStage s(1440, 900, 1, true, folders);
    s.console.show_page("connect");
    s.run(0.2);
    return s.value("connect/last_time");
  };
  {
    ConsoleStage s(1440, 900, 1, true, folders);
    ASSERT_TRUE(s.console.open("vxm@emulator"));
    s.run(0.2);
    s.console.close_all();
  }
  EXPECT_EQ(closed_words().substr(0, 13), "closed today ") << closed_words();
  EXPECT_EQ(closed_words().size(), std::string("closed today 09:48").size()) << closed_words();
  RecentConnections recent(folders);
  ASSERT_TRUE(recent.load());
  ASSERT_TRUE(recent.opened("vxm@emulator", ""));
  EXPECT_EQ(closed_words(), "") << "it broke off";
  ASSERT_TRUE(recent.ended({"2026-11-20", "18:02"}));
  EXPECT_EQ(closed_words(), "closed 2026-11-20 18:02");
}

TEST(ConnectEmulators, WhereNothingServesItTheSwitchNamesTheServer) {
  ConsoleStage s;
  s.run(0.2);
  const Widget* serve = s.stage.find("connect/emulator/vxm/serve");
  ASSERT_TRUE(serve);
  EXPECT_FALSE(serve->enabled);
  EXPECT_NE(serve->reason.find("handwheel emulate"), std::string_view::npos);
}

}  // namespace
}  // namespace hw::panels
