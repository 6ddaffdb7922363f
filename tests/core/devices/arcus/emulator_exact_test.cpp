// Switches, latches, index marks and sync points act at the exact pulse; next_event() tells the true events.
#include <cmath>
#include <ctime>
#include <random>

#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

/// Time at which pulse `n` of a start from rest comes.
Duration time_of_pulse(double n, double high, double low, double accel_ms) {
  const double slope = (high - low) / (accel_ms / 1000), ramp = (high + low) / 2 * accel_ms / 1000;
  if (n > ramp) return from_seconds(accel_ms / 1000 + (n - ramp) / high);
  return from_seconds((std::sqrt(low * low + 2 * slope * n) - low) / slope);
}

TEST(ArcusExact, ALimitStopsOnItsPulse) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.plus = Steps(777);
  rig.place(0, place);
  rig.ok("X5000");
  EXPECT_TRUE(same_time(rig.run_to_rest(), time_of_pulse(777, 1000, 100, 300)));
  EXPECT_EQ(rig.ask("PX"), "777");
  EXPECT_EQ(rig.ask("MSTX"), "144");
  EXPECT_EQ(rig.ask("X0"), "?LIMIT");
  rig.ok("CLRX"), rig.ok("X0");
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("MSTX"), "0");
}

// The limit polarity of X counts for all axes (decision AMB-089).
TEST(ArcusExact, ALimitActsWhateverThePolarityOfItsOwnAxis) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.plus = Steps(777);
  rig.place(1, place);
  rig.ok("POY=3"), rig.ok("Y5000");
  rig.run_to_rest(1);
  EXPECT_EQ(rig.ask("PY"), "777");
}

TEST(ArcusExact, ALimitInAnInterpolatedMoveStopsAllOfIt) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.minus = Steps(-100);
  rig.place(1, place);
  rig.ok("X900Y-300U600");
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("PY"), "-100");
  EXPECT_NEAR(rig.number("PX"), 300, 2);
  EXPECT_NEAR(rig.number("PU"), 200, 1);
  EXPECT_EQ(rig.ask("MST"), "0:288:0:0:0:0:0:36:0") << "latched on Y alone";
}

TEST(ArcusExact, AMoveThatEndsOnTheSwitchHasRunIntoIt) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.plus = Steps(500);
  rig.place(0, place);
  rig.ok("X500");
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("MSTX"), "144");
  EXPECT_EQ(rig.ask("PX"), "500");
}

TEST(ArcusExact, BacklashIsTakenUpBeforeTheSwitch) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.minus = Steps(-100), place.backlash = Steps(30);
  rig.place(0, place);
  rig.ok("X-5000");
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("PX"), "-130");
  EXPECT_EQ(rig.load(0), -100);
  EXPECT_EQ(rig.ask("EX"), "-100");
}

TEST(ArcusExact, SyncPulsesComeAtTheirPosition) {
  Rig rig(Which::pmx);
  rig.ok("SYNXP=400"), rig.ok("SYNXT=5"), rig.ok("SYNXO");
  rig.ok("X1000");
  rig.run_to_rest();
  rig.ok("X0");
  rig.run_to_rest();
  const auto& pulses = rig.emulator().pulses();
  ASSERT_EQ(pulses.size(), 2u);
  EXPECT_EQ(pulses[0].position[0], Steps(400));
  EXPECT_EQ(pulses[1].position[0], Steps(400));
  EXPECT_TRUE(same_time(pulses[0].at.time_since_epoch(), time_of_pulse(400, 1000, 100, 300)));
  EXPECT_EQ(pulses[0].width, Duration(5ms));
}

TEST(ArcusExact, AnEncoderThatStepsOverThePositionMeetsIt) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.counts_per_step = 4;
  rig.place(0, place);
  rig.ok("SYNXP=402"), rig.ok("SYNXT=1"), rig.ok("SYNXO");
  rig.ok("X200");
  rig.run_to_rest();
  ASSERT_EQ(rig.emulator().pulses().size(), 1u);
  EXPECT_EQ(rig.emulator().pulses()[0].position[0], Steps(101));
  EXPECT_EQ(rig.ask("SYNXS"), "2");
}

TEST(ArcusExact, LatchCatchesBothCountersAtItsInstant) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.counts_per_step = -2;
  rig.place(3, place);
  rig.ok("LTU=1"), rig.ok("U5000");
  rig.run_for(time_of_pulse(321, 1000, 100, 300) + 1us);
  rig.input(8, true);
  rig.run_to_rest(3);
  EXPECT_EQ(rig.ask("LTUP"), "321");
  EXPECT_EQ(rig.ask("LTUE"), "-642");
}

TEST(ArcusExact, ArcsKeepToTheCircle) {
  Rig rig(Which::pmx);
  rig.ok("HS=2000"), rig.ok("CIRP3000:0");
  double worst = 0;
  while (rig.number("MSTX") & 7) {
    const double x = static_cast<double>(rig.number("PX")) - 3000, y = static_cast<double>(rig.number("PY"));
    worst = std::max(worst, std::abs(std::hypot(x, y) - 3000));
    if (rig.elapsed() < 100ms) {
      EXPECT_GE(y, 0) << "clockwise from the left: upwards first";
    }
    rig.run_for(97ms);
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_EQ(rig.ask("PP"), "0:0:0:0");
  // 2 pi 3000 pulses at 2000 pulses/s, with ramps from 100 in 300 ms.
  EXPECT_TRUE(same_time(rig.elapsed(), trapezoid_time(2 * M_PI * 3000, 2000, 100, 300, 300), 97ms));
}

TEST(ArcusExact, ALimitOnAnArc) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.plus = Steps(2500);
  rig.place(0, place);
  rig.ok("CIRN1500:0");
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("PX"), "2500");
  EXPECT_NEAR(rig.number("PY"), -std::sqrt(1500.0 * 1500 - 1000 * 1000), 1.5)
      << "counter-clockwise: downwards first";
}

TEST(ArcusExact, NothingHappensBetweenTheEventsThatItReports) {
  // The same session, once from event to event and once in steps of a millisecond: the same in the end.
  const auto session = [](bool by_events) {
    Rig rig(Which::pmx);
    AxisPlace place;
    place.home_from = Steps(1500), place.home_to = Steps(1700), place.plus = Steps(4000);
    place.index_every = Steps(333);
    rig.place(0, place);
    rig.ok("SLZ=1"), rig.ok("HX+4"), rig.ok("Y1234"), rig.ok("Z-2000"), rig.ok("JU+");
    const Duration end = 20s;
    std::string seen;
    while (rig.elapsed() < end) {
      if (by_events) {
        const auto next = rig.emulator().next_event();
        const Duration until = next ? std::min(end, next->time_since_epoch()) : end;
        rig.run_for(std::max(until - rig.elapsed(), Duration(0)));
      } else {
        rig.run_for(1ms);
      }
    }
    return rig.ask("PP") + " " + rig.ask("PE") + " " + rig.ask("MST") + " " + rig.ask("SLSZ");
  };
  EXPECT_EQ(session(true), session(false));
}

TEST(ArcusExact, ACloneGoesOnByItself) {
  Rig rig(Which::dmx);
  rig.ok("X10000");
  rig.run_for(1s);
  auto clone = rig.emulator().clone();
  rig.ok("ABORT");
  clone->advance_to(Instant(60s));
  clone->receive("@01EX\r");
  std::string out;
  clone->take_output(out);
  EXPECT_EQ(out, std::string("10000\0", 6));
}

TEST(ArcusExact, AnHourOfMovesTakesMilliseconds) {
  Rig rig(Which::pmx);
  const char* program[] = {"PRG,0",  "SET,V1,0", "WHILE,8", "+TEST,V1,LT,1000,9", "MOVE,X,2000",
                           "WAIT,X", "MOVE,X,0", "WAIT,X",  "ENDWHILE,2",         "END"};
  int n = 0;
  for (const char* line : program) rig.ok("SA" + std::to_string(n++) + "=" + line);
  rig.ok("SR0=1");
  const std::clock_t begin = std::clock();  // of the processor: other work on the machine does not count
  rig.run_for(3600s);
  const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_EQ(rig.ask("SASTAT"), "1");
  EXPECT_LT(took, 1.0);
}

}  // namespace
}  // namespace hw::arcus::proof
