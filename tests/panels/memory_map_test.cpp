// The memory window on the screen: what is decoded, what is marked, what is dimmed.
#include "panels/memory_map.h"

#include <imgui_internal.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/panel_stage.h"
#include "tests/panels/window_catalog.h"

namespace hw::panels {
namespace {

struct MemoryMapTest : ::testing::Test {
  MemoryMapTest() {
    s.now.axis_count = 3;
    s.now.window.known = true;
    seen();
  }
  void seen() {
    const Instant at(from_seconds(s.stage.now_s));
    s.now.io_seen_at = at;
    for (AxisState& a : s.now.axes) a.seen_at = at;
    s.stage.frames(2);
  }
  void poke(std::size_t offset, int width, std::uint32_t value) {
    s.now.window.put(offset, width, value);
    seen();
  }
  MemoryMap panel;
  test::PanelStage s{panel, 864, 900, 1, gui::Tier::wide, true, test::window_catalog()};
};

TEST_F(MemoryMapTest, RegistersAreTakenApartIntoTheirBits) {
  poke(0xFE3, 1, 0x12);
  EXPECT_EQ(s.value("register/0xFE3"), "12");
  EXPECT_EQ(s.value("register/0xFE3/bits"), "Initialized, Done");
  EXPECT_EQ(s.value("register/0xFE3/bit/4"), "set");
  EXPECT_EQ(s.value("register/0xFE3/bit/0"), "clear");
  EXPECT_EQ(s.value("register/0xFED/bits"), "none");
}

TEST_F(MemoryMapTest, AxisDataIsBigEndianAndSigned) {
  poke(0x400, 4, static_cast<std::uint32_t>(-123456));
  EXPECT_EQ(s.value("register/0x400"), "-123456");
  poke(0x000, 2, 0xFFFE);
  EXPECT_EQ(s.value("register/0x000"), "65534") << "an index has no sign";
}

TEST_F(MemoryMapTest, AChangedRegisterIsMarkedForAWhile) {
  EXPECT_FALSE(s.stage.find("register/0x480/changed"));
  poke(0x480, 4, 77);
  EXPECT_TRUE(s.stage.find("register/0x480/changed"));
  EXPECT_FALSE(s.stage.find("register/0x400/changed"));
  s.stage.frames(70);
  EXPECT_FALSE(s.stage.find("register/0x480/changed"));
}

TEST_F(MemoryMapTest, OldAndUnreadValuesAreMarked) {
  poke(0x400, 4, 5);
  s.stage.frames(60);
  EXPECT_EQ(s.value("register/0x400"), "5?");
  seen();
  EXPECT_EQ(s.value("register/0x400"), "5");
  s.now.link.state = LinkState::lost;
  s.stage.frames(2);
  EXPECT_EQ(s.value("register/0xFE3"), "00?");
}

TEST(MemoryMapUnread, NothingIsInvented) {
  MemoryMap panel;
  test::PanelStage s{panel, 864, 900, 1, gui::Tier::wide, true, test::window_catalog()};
  s.stage.frames(2);
  EXPECT_EQ(s.value("register/0xFE3"), "?");
  EXPECT_EQ(s.value("register/0xFE3/bits"), "not read yet");
  EXPECT_EQ(s.value("register/0xFE3/bit/1"), "?");
  EXPECT_EQ(s.value("ring/Commands"), "?");
}

TEST_F(MemoryMapTest, ARingShowsWhatWaitsInItAndItsNewestText) {
  s.now.window.rings_known = true;
  const std::string_view text = "AX MA100 GO";
  for (std::size_t i = 0; i < text.size(); ++i)
    s.now.window.put(0x804 + 2 * i, 2, static_cast<unsigned char>(text[i]));
  s.now.window.put(0x002, 2, 9);
  poke(0x800, 2, static_cast<std::uint32_t>(text.size()));
  EXPECT_EQ(s.value("ring/Commands"), "put 11, get 9, 2 waiting");
  EXPECT_TRUE(s.value("ring/Commands/text").ends_with("AX MA100 GO"));
}

TEST_F(MemoryMapTest, ItsRingsAreReadOnlyWhileItIsLookedAt) {
  ASSERT_TRUE(s.last<intent::Watch>());
  EXPECT_EQ(s.last<intent::Watch>()->groups, 1u << 1);
}

TEST(MemoryMapScrolled, HasOneScrollBar) {
  ConsoleStage s(720, 450, 2);
  s.add(test::window_catalog());
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("tab/memory"));
  s.run(0.1);
  int bars = 0;
  for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
    bars += w->Active && w->ScrollbarY && std::string_view(w->Name).starts_with("centre/");
  EXPECT_EQ(bars, 1);
}

}  // namespace
}  // namespace hw::panels
