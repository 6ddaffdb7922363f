// The VME58's window in bytes and texts, against the data sheet and the facts of the wire.
#include "core/devices/vme58/codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hw::vme58 {
namespace {

using testing::ElementsAre;

TEST(Vme58Ring, CountsCellsThatWrap) {
  EXPECT_EQ(waiting(0, 0), 0);
  EXPECT_EQ(waiting(5, 250), 11);
  EXPECT_EQ(room(0, 0), 255);
  EXPECT_EQ(room(255, 0), 0) << "255 characters fit";
  EXPECT_EQ(advanced(250, 10), 4);
  EXPECT_TRUE(is_index(255));
  EXPECT_FALSE(is_index(256));
  EXPECT_FALSE(is_index(0xFFFF));
}

TEST(Vme58Ring, TextGoesIntoTheLowBytesOfCellsAndIsReadBack) {
  std::vector<BusCycle> cycles;
  append_text(cycles, "AX", 255);
  ASSERT_EQ(cycles.size(), 4u);
  EXPECT_EQ(cycles[0].offset, 0x804 + 2 * 255);
  EXPECT_EQ(cycles[0].value, 0x41u);
  EXPECT_EQ(cycles[1].offset, 0x804) << "cut by the end of the buffer";
  EXPECT_EQ(cycles[1].value, 0x58u);
  EXPECT_EQ(cycles[2].offset, cycles[0].offset);
  EXPECT_EQ(cycles[3].offset, cycles[1].offset);
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    EXPECT_EQ(cycles[i].write, i < 2);
    EXPECT_EQ(cycles[i].width, 2);
  }
}

TEST(Vme58Ring, MailIsALetterInEachHalfAndThenTheInterrupt) {
  std::vector<BusCycle> cycles;
  append_mail(cycles, "SA", 0x90);
  ASSERT_EQ(cycles.size(), 3u);
  EXPECT_EQ(cycles[0].offset, 3976);
  EXPECT_EQ(cycles[0].value, static_cast<std::uint32_t>('S'));
  EXPECT_EQ(cycles[1].offset, 3978);
  EXPECT_EQ(cycles[1].value, static_cast<std::uint32_t>('A'));
  EXPECT_EQ(cycles[2].offset, 0xFE1);
  EXPECT_EQ(cycles[2].width, 1);
  EXPECT_EQ(cycles[2].value, 0xB0u) << "interrupt enables are kept";
}

TEST(Vme58Reply, BothFramesOfDecisionM01) {
  std::string in = "\n\r0,1200\n\r\n\r\rPNNN\n\r\r\n\rVME58 ver 2.24-8S\n\r";
  EXPECT_EQ(take_reply(in), "0,1200");
  EXPECT_EQ(take_reply(in), "PNNN");
  EXPECT_EQ(take_reply(in), "VME58 ver 2.24-8S");
  EXPECT_EQ(take_reply(in), std::nullopt);
}

TEST(Vme58Reply, AnUnfinishedOneWaits) {
  std::string in = "\n\r12";
  EXPECT_EQ(take_reply(in), std::nullopt);
  in += "00\n";
  EXPECT_EQ(take_reply(in), std::nullopt);
  in += "\r";
  EXPECT_EQ(take_reply(in), "1200");
  EXPECT_EQ(in, "");
}

TEST(Vme58Reply, Values) {
  EXPECT_THAT(*decode_numbers("0,-400,12"), ElementsAre(0, -400, 12));
  EXPECT_THAT(*decode_numbers("+0,  200, -0012,  +0007 "), ElementsAre(0, 200, -12, 7)) << "decision M99";
  for (const char* none : {"0,,1", "", " ", "+", "+-5", "-+5", "1 2", "++1"})
    EXPECT_FALSE(decode_numbers(none)) << none;
  EXPECT_FALSE(decode_numbers("PNNN"));
  EXPECT_EQ(decode_hex("3F00"), 0x3F00u);
  EXPECT_EQ(decode_hex("  +3F00"), 0x3F00u);
  EXPECT_FALSE(decode_hex("3F0G"));
  EXPECT_FALSE(decode_hex(" "));
  const auto greeting = decode_greeting("VME58 ver 2.24-4S4");
  ASSERT_TRUE(greeting);
  EXPECT_EQ(greeting->model, "VME58");
  EXPECT_EQ(greeting->version, "2.24");
  EXPECT_EQ(greeting->variant, "4S4");
  EXPECT_FALSE(decode_greeting("0"));
}

TEST(Vme58Reply, FourLettersOfAnAxis) {
  const auto flags = decode_flags("MDLH");
  ASSERT_TRUE(flags);
  EXPECT_FALSE(flags->plus);
  EXPECT_TRUE(flags->done && flags->limit && flags->home);
  EXPECT_FALSE(decode_flags("PNN"));
  EXPECT_FALSE(decode_flags("PNNX"));
  EXPECT_EQ(decode_all_flags("PNNN,MNLN").size(), 2u);
}

TEST(Vme58Command, ListsLeaveOutWhatIsNotMeant) {
  std::array<std::optional<std::int64_t>, most_axes> places{};
  places[0] = 1000;
  places[2] = -5;
  EXPECT_EQ(encode_list("MA", places), "MA1000,,-5;");
  EXPECT_EQ(encode_number(1250, 2), "12.5");
  EXPECT_EQ(encode_number(-5, 2), "-0.05");
  EXPECT_EQ(encode_number(700, 2), "7");
}

TEST(Vme58DataArea, StandsWhereTheDataSheetPutsIt) {
  std::vector<BusCycle> cycles;
  append_axis_reads(cycles, 7, 3);
  ASSERT_EQ(cycles.size(), 3u);
  EXPECT_EQ(cycles[0].offset, 1920);
  EXPECT_EQ(cycles[2].offset, 1928);
  EXPECT_EQ(cycles[0].width, 4);
}

}  // namespace
}  // namespace hw::vme58
