#include "core/base/fixed_text.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

TEST(FixedText, TextThatFitsIsKeptUnchanged) {
  EXPECT_EQ(FixedText<8>("12345678").view(), "12345678");
  EXPECT_TRUE(FixedText<8>("").empty());
}

TEST(FixedText, ALongSentenceEndsAfterAWholeWord) {
  const FixedText<24> sentence("Check the cable, the supply and the baud rate.");
  EXPECT_EQ(sentence.view(), "Check the cable, the\u2026");
}

TEST(FixedText, OneLongWordIsCutBetweenCharacters) {
  EXPECT_EQ(FixedText<4>("abc\u2212\u2212").view(), "abc");
  EXPECT_EQ(FixedText<6>("abcdefgh").view(), "abcdef");
}

}  // namespace
}  // namespace hw
