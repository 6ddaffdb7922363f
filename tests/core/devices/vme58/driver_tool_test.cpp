// A tool at an auxiliary output, which a recorded contour switches on its way: off at each kind of end.
#include "core/device/language.h"
#include "core/device/pieces.h"
#include "core/device/registry.h"
#include "core/devices/vme58/catalog.h"
#include "core/sequence/sequence.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using test::Seconds;
using testing::HasSubstr;

class Vme58Tool : public test::Vme58Rig {
 protected:
  static constexpr int output = vme58::first_auxiliary + 2;

  static seq::Step to(double x, double y) {
    seq::Move m;
    m.to[0] = x, m.to[1] = y;
    return {m};
  }
  /// Along X with the tool on, to `length`; then off, and a way back.
  static seq::Sequence contour(double length) {
    seq::Sequence s;
    s.axes = {{"X"}, {"Y"}};
    s.pen_up = {{seq::Output{output, false}}};
    s.pen_down = {{seq::Output{output, true}}};
    seq::Contour c;
    c.x = 200, c.lead_in = 200, c.own = seq::Speeds{1000};
    c.steps = {{seq::Output{output, true}}, to(length, 0), {seq::Output{output, false}}, to(length + 50, 0)};
    s.steps = {{seq::Pen{false}}, {seq::Speed{{2000}}}, {c}, {seq::WaitMotion{}},
               to(0, 0),          {seq::WaitMotion{}}};
    return s;
  }
  [[nodiscard]] bool is_on() const {
    BenchView view;
    session->bench()->look(view);
    return (view.outputs >> session->catalog().find_output(output) & 1u) != 0;
  }
  void load(double length) {
    const auto written = find_device_type("vme58")->language().write(contour(length), session->catalog());
    ASSERT_TRUE(written) << written.error().sentence();
    ASSERT_THAT(written->text, testing::AllOf(HasSubstr("Tool off: output 16 off"), HasSubstr("AN2;")));
    ASSERT_EQ(perform(intent::LoadProgram(0, written->text)).state, IntentState::done);
  }
  void begin(double length) {
    load(length);
    ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
    run(Millis(100));
    ASSERT_TRUE(run_until(
        [this] { return is_on() && now().any_axis_moving() && now().axes[0].position > Steps(500); },
        Seconds(10)));
    run(Seconds(1));
    ASSERT_TRUE(is_on());
  }
  void expect_off_at_rest() {
    ASSERT_TRUE(becomes_idle());
    EXPECT_TRUE(run_until([this] { return !is_on(); }, Millis(500)));
    run(Seconds(3));
    EXPECT_FALSE(is_on());
    EXPECT_FALSE(now().any_axis_moving());
  }
};

TEST_F(Vme58Tool, IsOffAfterAStopInAContour) {
  begin(20'000);
  session->send(intent::Stop());
  expect_off_at_rest();
  EXPECT_LT(axis().position, Steps(10'000));
}

TEST_F(Vme58Tool, IsOffAfterAnAbortInAContour) {
  begin(20'000);
  session->send(intent::Abort());
  expect_off_at_rest();
}

TEST_F(Vme58Tool, IsOffAfterALimitInAContour) {
  AxisPlace travel;
  travel.minus = Steps(-50'000), travel.plus = Steps(4'000);
  operate(bench::Place(AxisId{0}, travel));
  begin(20'000);
  expect_off_at_rest();
}

TEST_F(Vme58Tool, IsOffWhenTheLinkIsBack) {
  begin(6'000);
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return !now().link.connected(); }, Seconds(20)));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.connected(); }, Seconds(60)));
  expect_off_at_rest();
}

TEST_F(Vme58Tool, IsOffAfterACommandThatTheBoardRejectsInMidDrawing) {
  std::string text = "# Tool off: output 8 off\nAA VL2000,2000; AC200000,200000;\nMT100,0; GO\nWA\nBL8\n";
  for (int i = 0; i < 1000; ++i)  // more than its queues hold: it is drawing when the bad one comes
    text += "MT" + std::to_string(100 + 20 * i) + ",0; GO\n";
  text += "LE\nMT0,9000; GO\nWA\nBH8\n";
  Pieces pieces;
  pieces.tool = {{8, false}};
  pieces.drawing = 7;
  pieces.all.resize(2);
  for (Piece& piece : pieces.all)
    piece.does = {{intent::LoadProgram(0, text), {}}, {intent::RunProgram(0), {}}};
  const auto lit = [this] {
    BenchView view;
    session->bench()->look(view);
    return (view.outputs >> session->catalog().find_output(8) & 1u) != 0;
  };
  ASSERT_EQ(perform(intent::RunInPieces(std::make_shared<const Pieces>(pieces))).state, IntentState::done);
  ASSERT_TRUE(run_until([&] { return lit(); }, Seconds(10))) << reported();
  ASSERT_TRUE(run_until([&] { return !now().pieces.running; }, Seconds(60)));
  EXPECT_TRUE(run_until([&] { return !lit() && !now().any_axis_moving(); }, Seconds(1)));
  run(Seconds(5));
  EXPECT_FALSE(lit());
  EXPECT_EQ(now().pieces.done, 0);
  EXPECT_THAT(reported(), testing::AllOf(HasSubstr("rejected"), HasSubstr("all axes were stopped")));
  EXPECT_LT(axis(1).position, Steps(10)) << "what stands behind it is not carried out";
}

TEST_F(Vme58Tool, IsUnknownWhileAProgramSwitchesItAndKnownBehindIt) {
  begin(3'000);
  const std::uint32_t mask = 1u << session->catalog().find_output(output);
  EXPECT_EQ(now().outputs_known & mask, 0u);
  ASSERT_TRUE(becomes_idle());
  run(Seconds(3));
  EXPECT_EQ(now().outputs_known & mask, mask);
  EXPECT_EQ(now().outputs & mask, 0u);
  EXPECT_FALSE(is_on());
  EXPECT_EQ(reported().find("tool"), std::string::npos) << "it has switched it off itself";
  EXPECT_EQ(axis().position, Steps(0));
}

TEST_F(Vme58Tool, IsUnknownOnceTheContourIsPlayedAgainByHand) {
  begin(3'000);
  const std::uint32_t mask = 1u << session->catalog().find_output(output);
  ASSERT_TRUE(becomes_idle());
  run(Seconds(3));
  ASSERT_EQ(now().outputs_known & mask, mask);
  ASSERT_TRUE(query("AA CX"));
  EXPECT_EQ(now().outputs_known & mask, 0u) << "the contour switches it on its way";
}

}  // namespace
}  // namespace hw
