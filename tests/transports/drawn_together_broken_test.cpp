// Two emulated controllers of one axis each draw together, the tool on an output of the first, and something
// ends it for one of them in the middle of a line: the other one stops too, and the tool goes off. Seen on
// the emulators, not by what the console says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/emulation/emulator.h"
#include "core/session/session_group.h"
#include "core/time/virtual_scheduler.h"
#include "transports/open.h"

namespace hw {
namespace {

namespace seq = sequence;

constexpr AxisId its_axis{0};
constexpr double bus_steps_per_mm = 100, first_line = 30, last_line = 600;

seq::Step line_to(double x, double y) {
  seq::Move move;
  move.to[0] = x, move.to[1] = y;
  return {move};
}

/// A line of the first one alone, then a long one of both.
seq::Sequence two_lines() {
  seq::Sequence drawing;
  drawing.axes = {{"01", bus_steps_per_mm}, {"02", bus_steps_per_mm}};
  drawing.pen_down = {{seq::Output{1, true}}};
  drawing.pen_up = {{seq::Output{1, false}}};
  drawing.steps = {{seq::Pen{false}}, {seq::Speed{{20, 1, 100}}}, line_to(0, 0),
                   {seq::Pen{true}},  line_to(first_line, 0),     line_to(last_line, last_line / 2),
                   {seq::Pen{false}}};
  return drawing;
}

class DrawingOfTwo : public testing::Test {
 protected:
  DrawingOfTwo() {
    group = *SessionGroup::open(time, *Address::parse("dmx-k-sa@emulator,id=01-02,wire=real"),
                                make_wire_opener(), [] {});
    run(5);
    for (const auto& member : group->members())
      for (const char* text : {"SL=0", "EO=1"}) member->send_text(text, false);
    run(5);
  }
  ~DrawingOfTwo() override {
    bool closed = false;  // one that answers no more is waited for
    asio::co_spawn(time.executor(), group->close(),
                   [&closed](std::exception_ptr, auto&&...) { closed = true; });
    EXPECT_TRUE(time.run_until(time.now() + std::chrono::minutes(1), [&closed] { return closed; }));
    run(1);
  }
  void run(double s) { time.run_for(from_seconds(s)); }
  [[nodiscard]] Session& member(std::size_t n) const { return *group->members()[n]; }
  void operate(std::size_t n, const BenchCommand& command) {
    ASSERT_TRUE(member(n).bench()->operate(command));
  }

  // ---- what the machines do
  [[nodiscard]] bool tool_is_on() const {
    BenchView view;
    member(0).bench()->emulator().look(view);
    return (view.outputs & 1u) != 0;
  }
  [[nodiscard]] MachineTruth truth(std::size_t n) const {
    MachineTruth truth;
    member(n).bench()->emulator().report_truth(truth);
    return truth;
  }
  [[nodiscard]] bool moves(std::size_t n) const { return truth(n).moving() != 0; }
  [[nodiscard]] double place(std::size_t n) const {
    return static_cast<double>(truth(n).axes[0].position.value) / bus_steps_per_mm;
  }

  void begin() {
    asio::co_spawn(time.executor(), group->run_together(two_lines(), 0),
                   [](std::exception_ptr, const Result<>& begun) { EXPECT_TRUE(begun); });
  }
  void begin_and_come_to_the_long_line() {
    begin();
    ASSERT_TRUE(time.run_until(time.now() + std::chrono::minutes(1),
                               [this] { return tool_is_on() && moves(0) && moves(1); }));
    run(1);
    ASSERT_TRUE(tool_is_on());
  }
  void expect_end_within(double s) {
    EXPECT_TRUE(time.run_until(time.now() + from_seconds(s),
                               [this] { return !tool_is_on() && !moves(0) && !moves(1); }))
        << "tool " << tool_is_on() << ", 01 " << moves(0) << ", 02 " << moves(1);
    EXPECT_LT(place(0), last_line - first_line) << "it has not only come to its end";
    const double x = place(0), y = place(1);
    run(20);
    EXPECT_FALSE(tool_is_on());
    EXPECT_EQ(place(0), x);
    EXPECT_EQ(place(1), y);
    for (const std::size_t n : {0, 1}) EXPECT_FALSE(member(n).known().pieces.running) << n;
  }

  IoContext io{1};
  VirtualScheduler time{io};
  std::shared_ptr<SessionGroup> group;
};

class EitherOfTwo : public DrawingOfTwo, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Each, EitherOfTwo, testing::Values(0, 1),
                         [](const auto& info) { return info.param == 0 ? "WithTheTool" : "WithoutTheTool"; });

TEST_P(EitherOfTwo, ALimitOfOneEndsBothWithTheToolOff) {
  ASSERT_NO_FATAL_FAILURE(begin_and_come_to_the_long_line());
  operate(GetParam(), bench::Limit(its_axis, Sign::plus, true));
  expect_end_within(2);
}

TEST_P(EitherOfTwo, OneThatAnswersNoMoreEndsBothWithTheToolOff) {
  ASSERT_NO_FATAL_FAILURE(begin_and_come_to_the_long_line());
  operate(GetParam(), bench::Power(false));
  expect_end_within(6);
}

TEST_P(EitherOfTwo, AStopOfOneEndsBothWithTheToolOff) {
  ASSERT_NO_FATAL_FAILURE(begin_and_come_to_the_long_line());
  member(GetParam()).send(intent::Stop());
  expect_end_within(2);
}

/// Its move has begun, or not: nobody knows.
TEST_P(EitherOfTwo, AMoveThatOneDoesNotAnswerEndsBothWithTheToolOff) {
  begin();
  ASSERT_TRUE(time.run_until(time.now() + std::chrono::minutes(1),
                             [this] { return tool_is_on() && place(0) >= first_line && moves(GetParam()); }));
  operate(GetParam(), bench::Drop(20));
  expect_end_within(3);
}

/// It has come to a limit while only the other one had to move, and so refuses the next line.
TEST_F(DrawingOfTwo, AMoveThatOneRefusesEndsBothWithTheToolOff) {
  begin();
  ASSERT_TRUE(time.run_until(time.now() + std::chrono::minutes(1),
                             [this] { return tool_is_on() && moves(0) && !moves(1); }));
  operate(1, bench::Limit(its_axis, Sign::plus, true));
  member(1).send_text("J+", false);
  run(0.5);
  operate(1, bench::Limit(its_axis, Sign::plus, false));
  ASSERT_TRUE(tool_is_on() && moves(0) && !moves(1)) << "the other one is still at its line";
  ASSERT_TRUE(
      time.run_until(time.now() + std::chrono::minutes(1), [this] { return place(0) >= first_line; }));
  expect_end_within(2);
  std::string reported;
  member(1).notices().drain([&](const Notice& n) { reported += n.text + "\n"; });
  EXPECT_THAT(reported, testing::HasSubstr("limit"));
  EXPECT_LT(place(1), 1) << "it has not moved";
}

TEST_F(DrawingOfTwo, ACableThatIsPulledIsMadeUpForAsSoonAsItIsBack) {
  ASSERT_NO_FATAL_FAILURE(begin_and_come_to_the_long_line());
  operate(0, bench::Unplug(true));
  operate(1, bench::Unplug(true));
  run(4);
  operate(0, bench::Unplug(false));
  operate(1, bench::Unplug(false));
  expect_end_within(6);
}

}  // namespace
}  // namespace hw
