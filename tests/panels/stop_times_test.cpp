// The time of a stop counts from the press of the mouse itself, however late the frame that hears of it.
#include <cstdio>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "panels/panel_list.h"
#include "tests/gui/stage.h"
#include "transports/open.h"

namespace hw::panels {
namespace {

class StopTimesTest : public testing::TestWithParam<const char*> {
 protected:
  IoContext io;
  VirtualScheduler time{io};
  gui::Console console{panel_list(), gui::Outside(time, make_wire_opener(), [] {})};
  gui::Stage stage{[this](gui::Ui& ui) {
    time.run_until(Instant(from_seconds(stage.now_s)));
    console.draw(ui);
  }};

  void SetUp() override {
    console.attach(stage.surface.screen().keyboard());
    const auto opened = console.open("pmx-4ex-sa@emulator");
    ASSERT_TRUE(opened) << opened.error().sentence();
    run(3);
    tab().send(intent::SetPower(-1, true));
    run(1);
  }
  ~StopTimesTest() override {
    console.close_all();
    time.run_until(time.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  void run(double seconds) { stage.frames(static_cast<int>(seconds * 60 + 0.5)); }
  gui::Tab& tab() { return *console.tabs().front(); }
  /// Of the last stop, in ms.
  double first_byte_after() {
    const std::string& words = tab().desk().records.stop_times.words();
    double ms = -1;
    std::sscanf(words.c_str(), "Last stop: first byte after %lf", &ms);
    return ms;
  }
};

INSTANTIATE_TEST_SUITE_P(EachStop, StopTimesTest, testing::Values("stop_all", "jog/stop"),
                         [](const auto& info) { return info.index == 0 ? "All" : "OfTheController"; });

TEST_P(StopTimesTest, CountFromThePress) {
  tab().send(intent::MoveBy({{AxisId{0}, Steps(20'000)}}));
  run(1);
  ASSERT_TRUE(tab().now().axis_moves(0));
  const gui::Widget* stop = stage.find(GetParam());
  ASSERT_TRUE(stop);
  const ImVec2 at = stop->rect.centre();
  stage.push(gui::InputEvent::mouse_move(at.x, at.y, stage.now_s));
  run(0.1);
  constexpr double frame_is_late_by_s = 0.12;
  const double pressed_at_s = stage.now_s;
  stage.now_s += frame_is_late_by_s;
  stage.push(gui::InputEvent::mouse_button(0, true, at, pressed_at_s));
  stage.frame();
  stage.push(gui::InputEvent::mouse_button(0, false, at, stage.now_s));
  run(4);
  ASSERT_FALSE(tab().now().axis_moves(0));
  EXPECT_GE(first_byte_after(), 1000 * frame_is_late_by_s) << tab().desk().records.stop_times.words();
  EXPECT_LE(first_byte_after(), 1000 * frame_is_late_by_s + 60) << tab().desk().records.stop_times.words();
}

TEST_P(StopTimesTest, CountFromTheKeyThatPressesTheFocusedStop) {
  tab().send(intent::MoveBy({{AxisId{0}, Steps(20'000)}}));
  run(1);
  ASSERT_TRUE(tab().now().axis_moves(0));
  stage.surface.screen().focus().move_to(GetParam());
  run(0.1);
  constexpr double frame_is_late_by_s = 0.12;
  const double pressed_at_s = stage.now_s;
  stage.now_s += frame_is_late_by_s;
  stage.push(gui::InputEvent::key(GLFW_KEY_ENTER, true, pressed_at_s));
  stage.frame();
  stage.push(gui::InputEvent::key(GLFW_KEY_ENTER, false, stage.now_s));
  run(4);
  ASSERT_FALSE(tab().now().axis_moves(0));
  EXPECT_GE(first_byte_after(), 1000 * frame_is_late_by_s) << tab().desk().records.stop_times.words();
  EXPECT_LE(first_byte_after(), 1000 * frame_is_late_by_s + 60) << tab().desk().records.stop_times.words();
}

}  // namespace
}  // namespace hw::panels
