// Input that is wrong, through the whole console: what is said of it, and that the board goes on.
#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;

class Vme58BadInput : public test::Vme58Rig {
 protected:
  std::string refused(std::string text) {
    const auto reply = query(std::move(text));
    return reply ? "taken" : reply.error().sentence();
  }
  void works() {
    ASSERT_TRUE(query("AX VL5000 AC100000"));
    const Steps before = axis(0).position;
    ASSERT_EQ(perform(intent::MoveBy({AxisTarget{AxisId{0}, Steps(100)}})).state, IntentState::done);
    ASSERT_TRUE(becomes_idle());
    EXPECT_EQ(axis(0).position, before + Steps(100));
  }
};

TEST_F(Vme58BadInput, IndexesOutOfRange) {
  for (const std::uint32_t index : {256u, 0x1001u, 0xFFFFu}) {
    poke(2, vme58::at::input_get_index, index);
    run(Seconds(1));
    EXPECT_EQ(now().link.state, LinkState::good) << index;
    EXPECT_THAT(reported(), HasSubstr("command error"));
    EXPECT_EQ(query("RQ").value_or(""), "200") << "set right with the next text";
  }
  works();
}

TEST_F(Vme58BadInput, ACommandThatTheEndOfTheRingCutsInTwo) {
  for (int i = 0; peek(2, vme58::at::output_put_index) < 250 && i < 300; ++i) (void)query("IC");
  int before = static_cast<int>(peek(2, vme58::at::output_put_index));
  ASSERT_TRUE(query("AX LP1234567")) << "from cell " << before << " over the last one";
  EXPECT_LT(peek(2, vme58::at::output_put_index), 40u) << "it has begun again";
  run(Seconds(1));
  EXPECT_EQ(axis(0).position, Steps(1234567));
  EXPECT_EQ(query("RP").value_or(""), "1234567");
}

TEST_F(Vme58BadInput, AnUnknownCommandInTheMiddle) {
  EXPECT_THAT(refused("AX LP5 QQ7 LP9"), HasSubstr("\"QQ7\""));
  run(Seconds(1));
  EXPECT_EQ(axis(0).position, Steps(5)) << "what stood before it was carried out, nothing behind it";
  works();
}

TEST_F(Vme58BadInput, AContourOfThreeAxesWithAnArc) {
  ASSERT_EQ(perform(intent::LoadProgram(0, "AA\nCV1000\nCD0,0,0;\nMT10,10,10\nCR0,0,3.14\nCE\nCX\n")).state,
            IntentState::refused)
      << "an arc lies in two axes";
  ASSERT_TRUE(query("AA CV1000 CD0,0,0;"));
  EXPECT_THAT(refused("CR0,0,3.14"), HasSubstr("CR"));
  ASSERT_TRUE(query("CE"));
  (void)query("CX AX");
  run(Seconds(2));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(axis(i).position, Steps(0)) << i;
  works();
}

TEST_F(Vme58BadInput, GoWithoutAMove) {
  ASSERT_TRUE(query("AX GO"));
  run(Seconds(1));
  EXPECT_EQ(axis(0).position, Steps(0));
  EXPECT_EQ(axis(0).activity, Activity::idle);
  works();
}

TEST_F(Vme58BadInput, AWindowThatVanishesUnderWay) {
  perform(intent::MoveTo({{AxisId{0}, Steps(1'000'000)}}, Pps{1000}));
  run(Seconds(1));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(5)));
  EXPECT_THAT(std::string(now().link.sentence.view()), HasSubstr("pulled"));
  EXPECT_FALSE(axis(0).position_known);
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{1}, Steps(5)}})).state, IntentState::refused);
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20)));
  EXPECT_EQ(axis(1).position, Steps(0)) << "nothing is made up for";
  perform(intent::Stop());
  ASSERT_TRUE(becomes_idle());
  works();
}

}  // namespace
}  // namespace hw
