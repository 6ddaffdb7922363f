// Program memory, saved memory, reset (p.16, 19, 24, 30; App. O).
#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

void fill(Rig& rig, int bytes) {
  for (; bytes >= 4; bytes -= 4) rig.send("I1M1,");
  for (; bytes > 0; --bytes) rig.send("LM0,");
}

void save(Rig& rig) {
  rig.send("rsm");
  ASSERT_TRUE(rig.run_until_output("^"));
  rig.output();
}

bool flashing(Rig& rig, bool (Rig::*lamp)() const) {
  bool seen[2] = {false, false};
  for (int i = 0; i < 200; ++i) {
    seen[(rig.*lamp)()] = true;
    rig.run_for(10ms);
  }
  return seen[0] && seen[1];
}

}  // namespace

TEST(VxmMemory, FiveProgramsOf256Bytes) {
  Rig rig = Rig::online();
  for (const char program : {'0', '1', '2', '3', '4'}) {
    rig.send(std::string("PM") + program + ",");
    EXPECT_EQ(rig.ask("M"), "256\r");
    fill(rig, 256);
    EXPECT_EQ(rig.ask("M"), "0\r");
  }
  EXPECT_EQ(rig.output(), "");
}

TEST(VxmMemory, ACommandThatDoesNotFitRaisesEM) {
  Rig rig = Rig::online();
  fill(rig, 254);
  rig.send("P0,");
  EXPECT_EQ(rig.output(), "EM");
  EXPECT_EQ(rig.ask("V"), "") << "everything but K and res is dropped (V34)";
  EXPECT_EQ(rig.ask("P0,I1M4,C,R,X,lst"), "") << "sent once";
  EXPECT_TRUE(flashing(rig, &Rig::power_lamp)) << "p.30";
  EXPECT_TRUE(flashing(rig, &Rig::online_lamp));
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_EQ(rig.ask("V"), "R");
  EXPECT_EQ(rig.ask("M"), "2\r") << "the program stays";
  EXPECT_FALSE(flashing(rig, &Rig::power_lamp));
  EXPECT_TRUE(rig.power_lamp());
  EXPECT_TRUE(rig.online_lamp());
  rig.send("U5,");
  EXPECT_EQ(rig.ask("M"), "0\r") << "what fits is stored";
  rig.send("L0,");
  EXPECT_EQ(rig.output(), "EM");
  EXPECT_EQ(rig.ask("res"), "");
  EXPECT_EQ(rig.ask("V"), "J") << "res leaves the error too";
}

TEST(VxmMemory, SettingsTakeNoProgramMemory) {
  Rig rig = Rig::online();
  fill(rig, 256);
  EXPECT_EQ(rig.ask("setM1M3,setj1M5,B1,O1,PM0,setI7,"), "");
  EXPECT_EQ(rig.ask("V"), "R");
}

TEST(VxmMemory, RsmSavesProgramsAndSettings) {
  Rig rig = Rig::online();
  rig.send("I1M400,PM4,P10,L0,PM2,");
  rig.send(
      "setM1M3,setj1M5,setJ2M50,setjA1M2,setJA2M3,setL1M-2,setP1M4,setPA9,setI133,setDM3,setDA50,B7,O3,");
  save(rig);
  rig.power_cycle();
  rig.send("F");
  EXPECT_EQ(rig.ask("PM,"), "0\r") << "the default program (p.16)";
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
  rig.send("PM4,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM4 M252<cr>P10<cr>L0<cr>");
  for (const auto& [query, value] : {std::pair{"getM1M", "3"},
                                     {"getj1M", "5"},
                                     {"getJ2M", "50"},
                                     {"getjA1M", "2"},
                                     {"getJA2M", "3"},
                                     {"getL1M", "-2"},
                                     {"getP1M", "4"},
                                     {"getPA", "9"},
                                     {"getI", "133"},
                                     {"getDM", "3"},
                                     {"getDA", "50"},
                                     {"B,", "7"},
                                     {"O,", "3"}})
    EXPECT_EQ(rig.ask(query), std::string(value) + "\r") << query;
}

TEST(VxmMemory, WithoutRsmAPowerCycleForgets) {
  Rig rig = Rig::online();
  rig.send("I1M400,setM1M3,setI3,B5,");
  rig.run_program();
  EXPECT_EQ(rig.position(1), 400);
  rig.power_cycle();
  rig.send("F");
  EXPECT_EQ(rig.ask("M"), "256\r");
  EXPECT_EQ(rig.ask("getM1M"), "0\r");
  EXPECT_EQ(rig.ask("getI"), "7\r");
  EXPECT_EQ(rig.ask("B,"), "0\r");
  EXPECT_EQ(rig.ask("X"), "+0000000\r") << "where it stands becomes zero (p.17)";
  EXPECT_EQ(rig.load(1), 400) << "but nothing moved";
}

TEST(VxmMemory, SpeedsAreNotSaved) {
  Rig rig = Rig::online();
  rig.run("S1M500,A1M9,");
  save(rig);
  rig.power_cycle();
  rig.send("F");
  EXPECT_TRUE(same_time(rig.run("I1M4000,"), index_time(4000))) << "V57";
}

TEST(VxmMemory, ResIsAPowerCycleByWire) {
  Rig rig = Rig::online();
  rig.send("I1M400,");
  save(rig);
  rig.send("CI1M7,U5,U15,");
  rig.run_program();
  EXPECT_TRUE(rig.out(1));
  EXPECT_EQ(rig.ask("res"), "");
  EXPECT_FALSE(rig.out(1));
  rig.run_for(10s);
  EXPECT_EQ(rig.ask("V"), "J");
  rig.send("F");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
}

TEST(VxmMemory, PowerOffIsSilence) {
  Rig rig = Rig::online();
  rig.send("I1M100000,R");
  rig.run_for(3s);
  rig.operate(bench::Power(false));
  EXPECT_EQ(rig.ask("VXK"), "");
  EXPECT_FALSE(rig.power_lamp());
  const auto stands = rig.load(1);
  rig.run_for(1h);
  EXPECT_EQ(rig.load(1), stands);
  rig.operate(bench::Power(true));
  EXPECT_EQ(rig.ask("V"), "J");
  rig.run_for(10s);
  EXPECT_EQ(rig.output(), "");
  EXPECT_TRUE(rig.power_lamp());
}

TEST(VxmMemory, SavedMemoryTravelsAsText) {
  Rig one = Rig::online();
  one.send("I1M400,U5,PM3,LM0,L-7,setL1M-1,setM2M6,");
  save(one);
  const std::string text = one.emulator().save_memory();
  Rig other;
  ASSERT_TRUE(other.emulator().load_memory(text).has_value());
  other.power_cycle();
  other.send("F");
  EXPECT_EQ(visible(other.ask("lst")), "PM0 M250<cr>I1M400<cr>U5<cr>");
  other.send("PM3,");
  EXPECT_EQ(visible(other.ask("lst")), "PM3 M252<cr>LM0<cr>L-7<cr>");
  EXPECT_EQ(other.ask("getL1M"), "-1\r");
  EXPECT_EQ(other.ask("getM2M"), "6\r");
  EXPECT_EQ(other.emulator().save_memory(), text) << "round trip";
}

TEST(VxmMemory, TheWriteCountIsKept) {
  Rig rig = Rig::online();
  const std::string fresh = rig.emulator().save_memory();
  save(rig);
  const std::string once = rig.emulator().save_memory();
  save(rig);
  const std::string twice = rig.emulator().save_memory();
  EXPECT_NE(fresh, once);
  EXPECT_NE(once, twice) << "nothing but the count differs";
}

TEST(VxmMemory, NonsenseIsRefusedWithASentenceAndChangesNothing) {
  Rig rig = Rig::online();
  rig.send("I1M400,");
  save(rig);
  const std::string good = rig.emulator().save_memory();
  for (const std::string& bad : {std::string("no memory at all"), std::string("\0\xFF\x80", 3),
                                 std::string(100'000, '['), std::string("x = 99999999999999999999999")}) {
    const auto loaded = rig.emulator().load_memory(bad);
    ASSERT_FALSE(loaded.has_value()) << visible(bad).substr(0, 40);
    EXPECT_GT(loaded.error().sentence().size(), 10u);
    EXPECT_EQ(rig.emulator().save_memory(), good);
  }
}

TEST(VxmMemory, AClonesLifeIsItsOwn) {
  Rig rig = Rig::online();
  rig.send("I1M4000,R");
  rig.run_for(500ms);
  auto copy = rig.emulator().clone();
  copy->advance_to(Instant(rig.elapsed()) + 10s);
  std::string out;
  copy->take_output(out);
  EXPECT_EQ(out, "^");
  EXPECT_EQ(rig.ask("V"), "B");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(1), 4000);
}

TEST(VxmMemory, DelTakesTheNewestCommandAndAPairAsOne) {
  Rig rig = Rig::online_with_slave();
  rig.send("I1M1,(I3M8,I1M4,)");
  EXPECT_EQ(rig.used_bytes(), 14);
  rig.send("del");
  EXPECT_EQ(rig.used_bytes(), 4);
}

}  // namespace hw::vxm::proof
