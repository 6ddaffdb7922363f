// What a stop of the VME58 ends, and what it leaves alone.
#include "core/devices/vme58/facts.h"
#include "tests/transports/vme58_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;

class Vme58Stops : public test::Vme58Rig {
 protected:
  void hold_jog(int tenths) {
    for (int i = 0; i < tenths; ++i) {
      run(Millis(100));
      session->send(intent::JogKeepAlive());
    }
  }
  void expect_stays(int i, Duration how_long = Seconds(5)) {
    const Steps there = axis(i).position;
    run(how_long);
    EXPECT_EQ(axis(i).position, there);
    EXPECT_EQ(axis(i).speed.value, 0);
  }
};

TEST_F(Vme58Stops, AJogBesideAnothersCommandErrorDoesNotOutliveItsHand) {
  ASSERT_TRUE(query("AX VL2000 AY VL2000 HF"));
  run(Seconds(2));
  int failed = 0;
  for (int before_ms = 10; before_ms < 360; before_ms += 50) {
    perform(intent::SendText("AY WT350 MR100 GO WQ"));  // MR is rejected at its turn, and WQ holds the ring
    run(Millis(before_ms));
    const IntentId jog = session->send(intent::JogStart(AxisId{0}, Sign::plus));
    hold_jog(9);
    failed += now().fate_of(jog)->fate == Fate::failed;
    session->send(intent::JogStop());
    run(Seconds(1));
    expect_stays(0);
  }
  EXPECT_GT(failed, 0);
}

}  // namespace
}  // namespace hw
