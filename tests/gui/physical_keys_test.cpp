// Which of the presses and repeats that a window is told of are those of a hand.
#include "gui/input/physical_keys.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

constexpr int right = 262, code = 114;  // GLFW's key, and the server's code of it
constexpr bool repeat = true, press = false;

struct Server {
  PhysicalKeys::KeyMap down{};
  PhysicalKeys keys{[this] { return std::optional(down); }};
  void set(bool is_down) {
    const int bit = 1 << code % 8;
    down[code / 8] = static_cast<char>(is_down ? bit : 0);
  }
};

TEST(PhysicalKeys, ARepeatIsNoPress) {
  Server s;
  s.set(true);
  EXPECT_TRUE(s.keys.is_press(right, code, press));
  EXPECT_FALSE(s.keys.is_press(right, code, repeat));
}

TEST(PhysicalKeys, AKeyThatWasHeldWhenTheKeyboardCameBackIsNoPressUntilItHasBeenUp) {
  Server s;
  s.set(true);
  EXPECT_TRUE(s.keys.is_press(right, code, press));
  s.keys.forget();
  s.keys.come_back();
  EXPECT_FALSE(s.keys.is_press(right, code, press)) << "as GLFW calls the first repeat then";
  EXPECT_FALSE(s.keys.is_press(right, code, repeat));
  EXPECT_TRUE(s.keys.any()) << "it is looked at until it is up";
  EXPECT_TRUE(s.keys.lost().empty());
  s.set(false);
  EXPECT_TRUE(s.keys.lost().empty()) << "nothing of ours was held";
  EXPECT_FALSE(s.keys.any());
  s.set(true);
  EXPECT_TRUE(s.keys.is_press(right, code, press));
}

TEST(PhysicalKeys, AReleaseThatIsReportedEndsThatToo) {
  Server s;
  s.set(true);
  s.keys.come_back();
  s.keys.release(right, code);
  EXPECT_TRUE(s.keys.is_press(right, code, press));
}

TEST(PhysicalKeys, ARepeatThatIsStillOnItsWayWhenTheKeyboardGoesIsNone) {
  Server s;
  s.set(true);
  EXPECT_TRUE(s.keys.is_press(right, code, press));
  s.keys.forget();
  EXPECT_FALSE(s.keys.is_press(right, code, repeat));
}

TEST(PhysicalKeys, APressBehindAReleaseThatWasTakenAwayIsOne) {
  Server s;
  s.set(true);
  EXPECT_TRUE(s.keys.is_press(right, code, press));
  EXPECT_TRUE(s.keys.lost().empty());
  s.set(false);
  EXPECT_TRUE(s.keys.lost().empty()) << "its release may be on its way";
  EXPECT_EQ(s.keys.lost(), std::vector{right});
  EXPECT_FALSE(s.keys.is_press(right, code, repeat)) << "that was under way when it came up";
  s.set(true);
  EXPECT_TRUE(s.keys.is_press(right, code, repeat)) << "as GLFW calls it, which knows of no release";
}

}  // namespace
}  // namespace hw::gui
