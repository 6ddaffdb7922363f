#include "transports/watchdog/will_message.h"

#include <gtest/gtest.h>

namespace hw::watchdog {
namespace {

Message will() {
  Message message;
  message.kind = Kind::will;
  message.id = 7;
  message.how = WireShare::How::dial;
  message.base = 0xF000;
  message.place = std::string("\x02\0\x0F", 3);
  message.words = {{0, "~\r"}, {50, "@01STOPX\r"}};
  return message;
}

TEST(WillMessage, ComesOutAsItWentIn) {
  const auto read = decode(encode(will()));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->kind, Kind::will);
  EXPECT_EQ(read->id, 7u);
  EXPECT_EQ(read->how, WireShare::How::dial);
  EXPECT_EQ(read->base, 0xF000u);
  EXPECT_EQ(read->place, will().place);
  EXPECT_EQ(read->words, will().words);
}

TEST(WillMessage, OfOneByteAreLifeAndDeath) {
  EXPECT_EQ(encode(Message()).size(), 1u);
  EXPECT_EQ(decode("A")->kind, Kind::alive);
  EXPECT_EQ(decode("D")->kind, Kind::dying);
}

TEST(WillMessage, CutShortIsNone) {
  const std::string whole = encode(will());
  const std::size_t until_words = 1 + 4 + 4 + 4 + 4 + 3;
  const std::size_t first = 4 + 4 + 2, second = 4 + 4 + 9;
  ASSERT_EQ(whole.size(), until_words + first + second);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const bool ends_between = length == until_words || length == until_words + first;
    EXPECT_EQ(decode(whole.substr(0, length)).has_value(), ends_between) << length;
  }
}

TEST(WillMessage, OfAnotherKindIsNone) {
  EXPECT_FALSE(decode(""));
  EXPECT_FALSE(decode("Z"));
  EXPECT_FALSE(decode("Ax"));
  std::string odd = encode(will());
  odd[5] = 9;  // a way to a wire that there is not
  EXPECT_FALSE(decode(odd));
}

}  // namespace
}  // namespace hw::watchdog
