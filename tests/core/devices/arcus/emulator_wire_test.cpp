// The line: addresses, ends, blanks, broadcast, options (decisions AMB-001 to AMB-015).
#include "core/device/registry.h"
#include "core/devices/arcus/codec.h"
#include "core/devices/dmx_k_sa/emulator.h"
#include "core/devices/pmx_4ex_sa/emulator.h"
#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

TEST(ArcusWire, OnlyTheOwnAddressIsAnswered) {
  Rig pmx(Which::pmx, {{"id", "07"}});
  EXPECT_EQ(pmx.raw("@00PX\r"), "");
  EXPECT_EQ(pmx.raw("@07PX\r"), "0\r");
  EXPECT_EQ(pmx.raw("@7PX\r"), "") << "two digits";
  EXPECT_EQ(pmx.raw("PX\r"), "");
  EXPECT_EQ(pmx.ask("DN"), "4EX07");
  Rig dmx(Which::dmx, {{"id", "12"}});
  EXPECT_EQ(dmx.raw("@01PX\r"), "");
  EXPECT_EQ(dmx.raw("@12PX\r"), std::string("0\0", 2));
}

TEST(ArcusWire, BytesMayComeOneByOneOrManyCommandsAtOnce) {
  Rig rig(Which::pmx);
  for (const char c : std::string("@00HS=2000\r")) rig.emulator().receive(std::string(1, c));
  EXPECT_EQ(rig.output(), "OK\r");
  EXPECT_EQ(rig.raw("@00HS\r\n@00LS\r\n\r\n@00\r@00PX\r"), "2000\r100\r0\r");
}

// Hosts expect `?` and what they sent, never silence (decision AMB-007). What is cut off is not obeyed.
TEST(ArcusWire, ATextThatIsTooLongIsRefused) {
  Rig rig(Which::pmx);
  EXPECT_EQ(rig.raw("@00" + std::string(254, 'A') + "\r"), "?" + std::string(253, 'A') + "\r");
  EXPECT_EQ(rig.raw("@00HS=2" + std::string(300, ' ') + "5\r").substr(0, 6), "?HS=2 ");
  EXPECT_EQ(rig.ask("HS"), "1000");
  EXPECT_EQ(rig.raw("@01" + std::string(300, 'A') + "\r"), "") << "another's";
}

// What was on the wire when it went is the beginning of a command: X38 of X3822. What the console ends it
// with makes that mean nothing.
TEST(ArcusWire, TheBeginningOfACommandIsNotObeyed) {
  for (const Which which : {Which::pmx, Which::dmx}) {
    const DeviceType* type = find_device_type(which == Which::pmx ? "pmx-4ex-sa" : "dmx-k-sa");
    const Catalog catalog = type->make_catalog({}).value();
    for (const CommandInfo& command : catalog.commands) {
      if (command.example.starts_with("SA")) continue;  // any code is taken, and read back by who has sent it
      for (std::size_t length = 0; length <= command.example.size(); ++length) {
        Rig rig(which);
        const std::string memory = rig.emulator().save_memory();
        const std::string begun(command.example.substr(0, length));
        const std::string answer = rig.raw("@" + rig.address() + begun + std::string(cut_off));
        EXPECT_TRUE(answer.starts_with("?")) << begun << ": " << answer;
        MachineTruth truth;
        rig.emulator().report_truth(truth);
        EXPECT_EQ(truth.moving(), 0u) << begun;
        EXPECT_EQ(rig.emulator().save_memory(), memory) << begun;
      }
    }
  }
}

TEST(ArcusWire, BroadcastIsObeyedInSilenceByTheDmxOnly) {
  Rig dmx(Which::dmx);
  EXPECT_EQ(dmx.raw("@00INC\r@00MM\r@00FOO\r"), "");
  EXPECT_EQ(dmx.ask("MM"), "1");
  Rig pmx(Which::pmx, {{"id", "03"}});
  EXPECT_EQ(pmx.raw("@00INC\r"), "");
  EXPECT_EQ(pmx.ask("MST"), "0:0:0:0:0:0:0:36:0");
}

TEST(ArcusWire, TextWithoutAddressWhereThereIsOneListener) {
  Rig rig(Which::pmx, {{"unaddressed", "yes"}});
  EXPECT_EQ(rig.raw("PX\r@00PY\r@01PZ\r"), "0\r0\r");
}

TEST(ArcusWire, UsbTransfersOfSixtyFourBytes) {
  Rig rig(Which::pmx, {{"framing", "usb"}});
  for (const std::string& request : {std::string("PX"), std::string("PX\0", 3),
                                     std::string("PX\0MST left over", 17) + std::string(47, 'x')}) {
    const std::string reply = rig.raw(request);
    ASSERT_EQ(reply.size(), 64u);
    EXPECT_EQ(reply, "0" + std::string(63, '\0'));
  }
  EXPECT_EQ(rig.raw(std::string(64, '\0')), "");
}

TEST(ArcusWire, RepliesOfTheDmxMayEndWithCr) {
  Rig rig(Which::dmx, {{"quirk", "reply-cr"}});
  EXPECT_EQ(rig.raw("@01ID\r"), "DriveMax-K-SA\r");
}

TEST(ArcusWire, BlanksAndCase) {
  Rig rig(Which::pmx);
  EXPECT_EQ(rig.ask("HS = 2000"), "OK");
  EXPECT_EQ(rig.ask("hs"), "?hs");
  EXPECT_EQ(rig.ask("H S"), "?H S");
  EXPECT_EQ(rig.ask("FOO=1"), "?FOO=1");
  EXPECT_EQ(rig.ask("HZFalse0"), "?HZFalse0");
  EXPECT_EQ(rig.ask("REL"), "?REL");
}

TEST(ArcusWire, OptionsThatMeanNothingAreRefusedWithASentence) {
  for (const Options& bad : std::vector<Options>{{{"id", "100"}},
                                                 {{"id", "x"}},
                                                 {{"motors", "2"}},
                                                 {{"baud", "300"}},
                                                 {{"quirk", "overrun"}},
                                                 {{"framing", "x"}},
                                                 {{"unaddressed", "1"}}}) {
    const auto made = pmx_4ex_sa::make_emulator(bad);
    ASSERT_FALSE(made.has_value());
    const auto& [key, value] = *bad.begin();
    const std::string named = key == "motors" ? key : value;
    EXPECT_NE(made.error().sentence().find(named), std::string::npos) << made.error().sentence();
  }
  EXPECT_FALSE(dmx_k_sa::make_emulator({{"id", "00"}}).has_value());
}

TEST(ArcusWire, OverlongAndBinaryLinesAreSurvived) {
  Rig rig(Which::dmx);
  EXPECT_EQ(rig.raw(std::string(5000, 'x') + "\r@01MM\r"), std::string("0\0", 2));
  EXPECT_EQ(rig.raw("@01" + std::string(1000, '9') + "\r@01MM\r"),
            "?" + std::string(253, '9') + std::string("\0000\0", 3));
}

TEST(ArcusWire, MemorySurvivesAsText) {
  Rig rig(Which::pmx);
  rig.ok("SLRX=0.8"), rig.ok("JL3=-55"), rig.ok("V77=-9"), rig.ok("SA3=END"), rig.ok("DN=4EX09"),
      rig.ok("STORE");
  const std::string memory = rig.emulator().save_memory();
  Rig other(Which::pmx);
  ASSERT_TRUE(other.emulator().load_memory(memory).has_value());
  EXPECT_EQ(other.emulator().save_memory(), memory);
  other.set_address("09");
  EXPECT_EQ(other.ask("SLRX"), "0.800");
  EXPECT_EQ(other.ask("JL3"), "-55");
  EXPECT_EQ(other.ask("V77"), "-9");
  EXPECT_EQ(other.ask("SA3"), "END");
  EXPECT_FALSE(other.emulator().load_memory("no memory at all").has_value());
  EXPECT_EQ(other.ask("SA3"), "END") << "it stays as it was";
  EXPECT_FALSE(other.emulator().load_memory("HSX=nonsense\nSLRX=0.7\n").has_value()) << "damaged";
  other.set_address("00");
  EXPECT_EQ(other.ask("SLRX"), "0.700") << "but what can be read is taken";
}

TEST(ArcusWire, MemoryVersionChangesWithAStore) {
  Rig rig(Which::dmx);
  const auto before = rig.emulator().memory_version();
  rig.ok("SLT=5");
  EXPECT_EQ(rig.emulator().memory_version(), before);
  rig.ok("STORE");
  const auto after = rig.emulator().memory_version();
  EXPECT_NE(after, before);
  rig.ok("SA0=END");
  EXPECT_NE(rig.emulator().memory_version(), after) << "written through";
}

}  // namespace
}  // namespace hw::arcus::proof
