#include "transports/byte_line.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

TEST(ByteLine, BytesFollowEachOtherAtTenBitTimes) {
  ByteLine line;
  EXPECT_EQ(line.due(), Instant::max());
  line.put("ab", 0, Instant(Millis(5)), 10000);
  EXPECT_EQ(line.due(), Instant(Millis(6)));
  EXPECT_EQ(line.first().value, 'a');
  line.pop(10000);
  line.put("c", 0, Instant(Millis(6)), 10000);
  EXPECT_EQ(line.due(), Instant(Millis(7)));
  line.pop(10000);
  EXPECT_EQ(line.first().value, 'c');
  EXPECT_EQ(line.due(), Instant(Millis(8)));
  line.pop(10000);
  EXPECT_TRUE(line.empty());
}

TEST(Misread, TheRightRateReadsRight) {
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_EQ(misread(static_cast<unsigned char>(byte), 9600, 9600), std::string(1, static_cast<char>(byte)));
}

TEST(Misread, AFewPercentOffStillReadsRight) {
  EXPECT_EQ(misread('V', 9600, 9700), "V");
  EXPECT_EQ(misread('V', 9800, 9600), "V");
}

// 'V' is 01010110: on the line 0 0110 1010 1. At a quarter of the rate the receiver sees the start bit, then
// samples 6 bit times in, where data bit 5 (0) stands, then idle.
TEST(Misread, ASlowReceiverMakesOneByteOfIt) { EXPECT_EQ(misread('V', 38400, 9600), std::string(1, '\xFE')); }

TEST(Misread, AFastReceiverMakesSeveral) {
  const std::string got = misread('V', 9600, 38400);
  EXPECT_GT(got.size(), 1u);
  EXPECT_EQ(got.find('V'), got.npos);
}

TEST(Misread, NeverHangsAndNeverReadsRightAtAnotherRate) {
  for (const int from : {9600, 19200, 38400, 57600, 115200})
    for (const int to : {9600, 19200, 38400, 57600, 115200})
      for (int byte = 'A'; byte <= 'Z' && from != to; ++byte)
        EXPECT_NE(misread(static_cast<unsigned char>(byte), from, to),
                  std::string(1, static_cast<char>(byte)));
}

TEST(Collided, NoOtherSenderMeansNoCollision) { EXPECT_EQ(collided("1234\r", ""), "1234\r"); }

TEST(Collided, EqualAnswersAreGarbledToo) {
  EXPECT_NE(collided("OK\r", "OK\r"), "OK\r");
  EXPECT_EQ(collided("OK\r", "OK\r").find("OK"), std::string::npos);
}

TEST(Collided, NeverReadsAsANumber) {
  for (int first = 0; first < 1000; ++first)
    for (const int second : {first, first + 1, 0}) {
      const std::string line = collided(std::to_string(first) + '\0', std::to_string(second) + '\0');
      const std::string text = line.substr(0, line.find('\0'));
      EXPECT_TRUE(text.empty() || text.find_first_not_of("-0123456789") != text.npos)
          << first << " " << second;
    }
}

}  // namespace
}  // namespace hw
