// Random bytes, times and hands, always the same: nothing a host sends may break the emulator, and K then res
// always bring it back. The fuzzer in tests/fuzz looks deeper; this runs with every test and every sanitizer.
#include <array>
#include <random>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

// Half of what is sent are forms of the language, so that programs come about and run.
constexpr std::array<std::string_view, 64> words = {"F",
                                                    "E",
                                                    "G",
                                                    "R",
                                                    "K",
                                                    "C",
                                                    "D",
                                                    "H",
                                                    "I1M400,",
                                                    "I2M-30,",
                                                    "IA1M0,",
                                                    "IA2M-0,",
                                                    "I1M0,",
                                                    "I1M-0,",
                                                    "I3M5,",
                                                    "IA4M9,",
                                                    "S1M6000",
                                                    "S1M-12,",
                                                    "A1M127,",
                                                    "PM1,",
                                                    "PM-2,",
                                                    "PM0,",
                                                    "PMA1,",
                                                    "L0,",
                                                    "LM0,",
                                                    "L3,",
                                                    "L-2,",
                                                    "LA-3,",
                                                    "LM-2,",
                                                    "LM-3,",
                                                    "J1,",
                                                    "JM2,",
                                                    "JM-1,",
                                                    "P1,",
                                                    "P-5,",
                                                    "PA0,",
                                                    "U0,",
                                                    "U1,",
                                                    "U6,",
                                                    "U7,",
                                                    "U77,",
                                                    "U8,",
                                                    "U9,",
                                                    "U91,",
                                                    "U92,",
                                                    "U99,",
                                                    "U13,",
                                                    "U23,",
                                                    "U50,",
                                                    "U2,",
                                                    "setI255,",
                                                    "setP1M1,",
                                                    "setL1M-2,",
                                                    "B9,",
                                                    "O3,",
                                                    "res",
                                                    "rsm",
                                                    "lst",
                                                    "del",
                                                    "[I1M4,]",
                                                    "(I3M8,I1M4,)",
                                                    "Q",
                                                    "!",
                                                    "N"};

void do_something(Rig& rig, std::mt19937& random) {
  const auto pick = [&](unsigned n) { return static_cast<int>(random() % n); };
  switch (pick(10)) {
    case 0: {
      std::string noise(static_cast<std::size_t>(pick(20)), '\0');
      for (char& c : noise) c = static_cast<char>(random());
      rig.send(noise);
      break;
    }
    case 1: rig.run_for(Duration(random())); break;
    case 2: rig.run_for(std::chrono::microseconds(pick(1000))); break;
    case 3: rig.input(1 + pick(4), pick(2) == 0); break;
    case 4: rig.click(pick(2) == 0 ? "Run" : "1+", 30ms); break;
    case 5: rig.limit(1 + pick(2), pick(2) == 0 ? '+' : '-', pick(4) == 0); break;
    default: rig.send(words[static_cast<std::size_t>(pick(words.size()))]); break;
  }
}

class VxmRandomSeed : public ::testing::TestWithParam<unsigned> {};

}  // namespace

TEST_P(VxmRandomSeed, NothingBreaksIt) {
  std::mt19937 random(GetParam());
  Rig rig = GetParam() % 2 == 0 ? Rig::with_slave() : Rig();
  rig.send("F");
  for (int i = 0; i < 1500; ++i) {
    do_something(rig, random);
    if (i % 16 == 0) {
      rig.output();
      const auto next = rig.emulator().next_event();
      EXPECT_GE(next.value_or(Instant::max()), Instant(rig.elapsed())) << "what is due has happened";
    }
  }
  for (int input = 1; input <= 4; ++input) rig.input(input, false);
  rig.send("\r]\r,K,res");  // out of a remark, a bracket, a number
  rig.run_for(10s);
  rig.send("F");
  rig.output();
  EXPECT_EQ(rig.ask("V").substr(0, 1), "R") << "seed " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Seeds, VxmRandomSeed, ::testing::Range(1u, 25u));

TEST(VxmRandom, TheSameHistoryTwice) {
  std::string out[2];
  for (std::string& o : out) {
    std::mt19937 random(99);
    Rig rig = Rig::with_slave();
    rig.send("F");
    for (int i = 0; i < 1000; ++i) {
      do_something(rig, random);
      o += rig.output();
    }
    o += rig.emulator().save_memory();
    for (const TriggerPulse& p : rig.pulses()) o += std::to_string(p.at.time_since_epoch().count()) + ",";
  }
  EXPECT_EQ(out[0], out[1]);
}

TEST(VxmRandom, HowTimeIsCutMakesNoDifference) {
  const std::string program = "S1M3000,U8,I1M700,I1M300,U9,P1,I2M-500,LA-3,";
  Rig coarse = Rig::online(), fine = Rig::online();
  for (Rig* rig : {&coarse, &fine}) rig->send("setP2M7," + program + "R");
  coarse.run_for(30s);
  for (int i = 0; i < 30'000; ++i) fine.run_for(1ms);
  EXPECT_EQ(coarse.output(), fine.output());
  EXPECT_EQ(coarse.ask("XY"), fine.ask("XY"));
  ASSERT_EQ(coarse.pulses().size(), fine.pulses().size());
  for (std::size_t i = 0; i < coarse.pulses().size(); ++i) {
    EXPECT_EQ(coarse.pulses()[i].at, fine.pulses()[i].at);
    EXPECT_EQ(coarse.pulses()[i].position, fine.pulses()[i].position);
  }
}

}  // namespace hw::vxm::proof
