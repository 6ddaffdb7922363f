#include "core/base/shown_text.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

TEST(ShownText, TextOfAnyLanguageStaysAsItIs) {
  for (const char* text : {"", "a.vxm", "Ma\u00DFstab 45\u00B0", "\u4E2D\u6587", "\U0001F529"})
    EXPECT_EQ(shown_text(text, 100), text);
}

TEST(ShownText, ControlCharactersAndInvalidBytesAreEscaped) {
  const std::pair<const char*, const char*> cases[] = {
      {"a\x1B[2Jb", "a\\x1B[2Jb"},
      {"a\nb\tc", "a\\x0Ab\\x09c"},
      {"a\x7F", "a\\x7F"},
      {"a\u0085b", "a\\u0085b"},
      {"a\u202Etxt", "a\\u202Etxt"},
      {"a\u2028b", "a\\u2028b"},
      {"a\u2066b", "a\\u2066b"},
      {"a\xFF", "a\\xFF"},
      {"a\xC3", "a\\xC3"},
      {"\xE0\x80\x9B", "\\x1B"},
      {"\xF8\x88\x80\x80\x80", "\\xF8\\x88\\x80\\x80\\x80"},
  };
  for (const auto& [text, shown] : cases) EXPECT_EQ(shown_text(text, 100), shown);
}

TEST(ShownText, LineEndsStayWhereTheyAreWanted) {
  EXPECT_EQ(shown_text("a\n  b\tc\r\x1B", 100, LineEnds::kept), "a\n  b\tc\\x0D\\x1B");
}

TEST(ShownText, LongTextIsCutBetweenCharactersAndTheRestCounted) {
  EXPECT_EQ(shown_text(std::string(10'000'000, 'U'), 5), "UUUUU... (9999995 bytes more)");
  EXPECT_EQ(shown_text("ab\u00DFc", 3), "ab\u00DF... (1 bytes more)");
  EXPECT_EQ(shown_text("abc", 3), "abc");
}

}  // namespace
}  // namespace hw
