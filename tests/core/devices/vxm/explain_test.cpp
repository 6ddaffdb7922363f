#include "core/devices/vxm/explain.h"

#include <gtest/gtest.h>

#include "core/devices/vxm/catalog.h"

namespace hw::vxm {
namespace {

std::string sent(std::string_view bytes) { return explain(bytes, Way::sent, TrafficKind::intent, ""); }
std::string answer(std::string_view bytes, std::string_view asked) {
  return explain(bytes, Way::received, TrafficKind::poll, asked);
}
std::string unsolicited(std::string_view bytes) {
  return explain(bytes, Way::received, TrafficKind::unsolicited, "");
}

TEST(VxmExplain, SentCommandsAreExplained) {
  EXPECT_EQ(sent("PM-0\r"), "choose program 0 and empty it");
  EXPECT_EQ(sent("S1M2000\r"), "store: motor 1 at 2000 steps/s");
  EXPECT_EQ(sent("L-20\r"), "store: loop 20 times, motor 1 reverses each pass");
  EXPECT_EQ(sent("M"), "ask for free memory");
  EXPECT_EQ(sent("R"), "run the selected program");
  EXPECT_EQ(sent("X"), "ask where motor 1 is");
  EXPECT_EQ(sent("PM4\rI1M-400\rR"),
            "choose program 4; store: motor 1 moves by -400 steps; run the selected program");
  EXPECT_EQ(sent("P-500,PA5,U15\r"), "store: wait 50 ms; store: output 1 on for 0.5 s; store: output 2 on");
  EXPECT_EQ(sent("setM1M3\rgetj2M"), "set the type of motor 1 to 3; ask for the first jog speed of motor 2");
  EXPECT_EQ(sent("S2M8000\r"), "S2M8000 is out of range (1 to 6000 steps/s): the controller drops it");
  EXPECT_EQ(sent("%"), "not a command of the VXM: %");
  EXPECT_EQ(sent("\r"), "end of a command");
}

TEST(VxmExplain, RepliesAreExplained) {
  EXPECT_EQ(answer("229\r", "M"), "229 of 256 bytes free, 27 used");
  EXPECT_EQ(answer("+0003120\r", "X"), "motor 1 at 3120 steps");
  EXPECT_EQ(answer("-0000020\r", "Z"), "motor 3 at -20 steps");
  EXPECT_EQ(answer("B", "V"), "busy");
  EXPECT_EQ(answer("\xFD", "?"), "active: limit 1+");
  EXPECT_EQ(answer("\xBF", "~"), "low: In 3");
  EXPECT_EQ(answer(std::string_view("\0", 1), "$"), "on: no output");
  EXPECT_EQ(answer("512\r", "@"), "analog input at 512 of 1024");
  EXPECT_EQ(answer("3\r", "getM1M"), "the type of motor 1 is 3");
  EXPECT_EQ(answer("PM0 M252\rI1M400\r", "lst"), "program 0: 1 commands, 252 of 256 bytes free");
  EXPECT_EQ(answer("^", "rsm"), "ended");
  EXPECT_EQ(unsolicited("^"), "ended");
  EXPECT_EQ(unsolicited(":I1M400\r"), "the program holds before I1M400");
  EXPECT_EQ(unsolicited("EM").substr(0, 26), "The controller reports EM:");
  EXPECT_EQ(explain("\x91", Way::received, TrafficKind::unparsed, "X"), "not understood");
}

TEST(VxmExplain, EveryCommandOfTheCatalogHasAMeaning) {
  const Catalog catalog = make_catalog({{"motors", "4"}}).value();
  for (const CommandInfo& c : catalog.commands) {
    const std::string words = sent(c.example + "\r");
    EXPECT_GE(words.size(), 8u) << c.example;
    EXPECT_EQ(words.find("no command"), words.npos) << c.example << ": " << words;
    EXPECT_EQ(words.find("drops"), words.npos) << c.example << ": " << words;
    EXPECT_EQ(words.starts_with("store: "), c.stored) << c.example << ": " << words;
  }
}

}  // namespace
}  // namespace hw::vxm
