// The sheet of help: where it lies, and the manual that it reads.
#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "panels/help/manual_pages.h"
#include "panels/help/manual_text.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;
using ::testing::HasSubstr;

// ---- reading

TEST(ManualText, ALineIsTakenApart) {
  const ManualLine line = read_manual_line("Press *Store*, `id=01`; see [benches](emulators.md#benches).");
  ASSERT_EQ(line.size(), 7u);
  EXPECT_EQ(line[1].kind, SpanKind::strong);
  EXPECT_EQ(line[1].text, "Store");
  EXPECT_EQ(line[3].kind, SpanKind::code);
  EXPECT_EQ(line[3].text, "id=01");
  EXPECT_EQ(line[5].kind, SpanKind::link);
  EXPECT_EQ(line[5].text, "benches");
  EXPECT_EQ(line[5].target, "emulators.md#benches");
  EXPECT_EQ(line[6].text, ".");
}

TEST(ManualText, AStarBetweenBlanksIsAStar) {
  const ManualLine line = read_manual_line("3 * 4 is 12");
  ASSERT_EQ(line.size(), 1u);
  EXPECT_EQ(line[0].text, "3 * 4 is 12");
}

TEST(ManualText, BlocksOfAPage) {
  const ManualText page = read_manual(
      "# A page\n\nWords that\ngo on.\n\n- one\n  goes on\n- two\n\n1. first\n\n```\n# no heading\n\nx\n```\n"
      "| a | b |\n|---|---|\n| `x|y` | z |\n\n## Holding a jog, and leaving\n");
  EXPECT_EQ(page.title, "A page");
  ASSERT_EQ(page.blocks.size(), 8u);
  EXPECT_EQ(page.blocks[1].line[0].text, "Words that go on.");
  EXPECT_EQ(page.blocks[2].kind, BlockKind::item);
  EXPECT_EQ(page.blocks[2].line[0].text, "one goes on");
  EXPECT_EQ(page.blocks[4].mark, "1.");
  EXPECT_EQ(page.blocks[5].code, (std::vector<std::string>{"# no heading", "", "x"}));
  ASSERT_EQ(page.blocks[6].rows.size(), 2u);
  EXPECT_EQ(page.blocks[6].rows[1][0][0].text, "x|y");
  EXPECT_EQ(page.blocks[7].mark, "holding-a-jog-and-leaving");
}

TEST(ManualText, EveryLinkOfTheManualLeadsToAHeadingOfIt) {
  const auto anchors_of = [](std::string_view name) {
    std::vector<std::string> anchors{""};
    for (const ManualPage& page : manual_pages())
      if (page.name == name)
        for (const ManualBlock& block : read_manual(page.markdown).blocks)
          if (block.kind == BlockKind::heading) anchors.push_back(block.mark);
    return anchors;
  };
  ASSERT_GT(manual_pages().size(), 10u);
  for (const ManualPage& page : manual_pages()) {
    const ManualText text = read_manual(page.markdown);
    EXPECT_FALSE(text.title.empty()) << page.name;
    for (const ManualBlock& block : text.blocks)
      for (const ManualSpan& span : block.line) {
        if (span.kind != SpanKind::link || span.target.find("..") == 0) continue;
        const auto hash = span.target.find('#');
        std::string to = span.target.substr(0, hash);
        if (to.ends_with(".md")) to.resize(to.size() - 3);
        const std::string anchor = hash == std::string::npos ? "" : span.target.substr(hash + 1);
        EXPECT_THAT(anchors_of(to.empty() ? page.name : std::string_view(to)), testing::Contains(anchor))
            << page.name << ": " << span.target;
      }
  }
}

// ---- the sheet

TEST(HelpSheet, CoversNoPositionAndNothingThatMovesMetal) {
  for (const auto& [width, height] : {std::pair{1440, 900}, {1366, 768}, {1024, 700}}) {
    ConsoleStage s(width, height);
    s.add(*find_device_type("vme58")->make_catalog({}));
    s.run(0.1);
    MUST(s.hand.key("?"));
    s.run(0.1);
    const Widget* close = s.stage.find("help/close");
    const Widget* title = s.stage.find("help/title");
    ASSERT_TRUE(close && title) << width;
    const Rect sheet{title->rect.min, ImVec2(close->rect.max.x, static_cast<float>(height))};
    for (const Widget& w : s.stage.surface.screen().registry().widgets()) {
      const bool kept = w.id.starts_with("dro/") || w.id.starts_with("jog/") || w.id.starts_with("goto/") ||
                        w.id.starts_with("io/limit/") || w.id == "stop_all";
      if (!kept || w.rect.width() <= 0) continue;
      EXPECT_TRUE(w.rect.max.x <= sheet.min.x || w.rect.min.x >= sheet.max.x || w.rect.max.y <= sheet.min.y)
          << width << ": " << w.id;
    }
  }
}

TEST(HelpSheet, InANarrowWindowThePositionsStayAboveIt) {
  for (const char* type : {"vxm", "vme58"}) {
    ConsoleStage s(720, 450, 2);
    const Catalog catalog = *find_device_type(type)->make_catalog({});
    s.add(catalog);
    s.run(0.1);
    MUST(s.hand.key("?"));
    s.run(0.1);
    const Widget* title = s.stage.find("help/title");
    ASSERT_TRUE(title) << type;
    for (const AxisInfo& axis : catalog.axes) {
      const Widget* position = s.stage.find("dro/" + axis.name + "/position");
      ASSERT_TRUE(position) << axis.name;
      EXPECT_LE(position->rect.max.y, title->rect.min.y) << axis.name;
    }
  }
}

TEST(HelpSheet, TheDeskWorksBesideIt) {
  ConsoleStage s;
  Example& a = s.add();
  s.run(0.1);
  MUST(s.hand.click("help"));
  s.run(0.5);
  MUST(s.hand.press("jog/1/+"));
  s.run(0.5);
  EXPECT_EQ(a.count<intent::JogStart>(), 1);
  MUST(s.hand.release("jog/1/+"));
  s.run(0.1);
  MUST(s.hand.click("help/close"));
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("help/close"));
}

TEST(HelpSheet, ThePageOfTheControllerInFrontStandsFirst) {
  ConsoleStage s;
  s.add(*find_device_type("vxm")->make_catalog({}));
  s.run(0.1);
  MUST(s.hand.click("help"));
  s.run(0.1);
  MUST(s.hand.click("help/show/Manual"));
  s.run(0.1);
  const Widget* own = s.stage.find("help/page/vxm");
  ASSERT_TRUE(own);
  for (const Widget& w : s.stage.surface.screen().registry().widgets())
    if (w.id.starts_with("help/page/") && w.id != "help/page/vxm") {
      EXPECT_GT(w.rect.min.y, own->rect.max.y) << w.id;
    }
}

TEST(HelpSheet, LinksLeadFromPageToPageAndBack) {
  ConsoleStage s;
  s.add();
  s.run(0.1);
  MUST(s.hand.click("help"));
  s.run(0.1);
  MUST(s.hand.click("help/show/Manual"));
  s.run(0.1);
  MUST(s.hand.click("help/page/vxm"));
  s.run(0.1);
  EXPECT_EQ(s.value("help/title"), "Velmex VXM");
  // The first links are what the page holds.
  EXPECT_EQ(s.value("help/link/2"), "#programs");
  MUST(s.hand.click("help/link/2"));
  s.run(0.1);
  ASSERT_TRUE(s.stage.find("help/heading/programs"));
  EXPECT_TRUE(s.stage.find("help/heading/programs")->in_view());
  std::string to_benches;
  for (const Widget& w : s.stage.surface.screen().registry().widgets())
    if (w.id.starts_with("help/link/") && w.value == "emulators.md#benches") to_benches = w.id;
  ASSERT_FALSE(to_benches.empty());
  MUST(s.hand.click(to_benches));
  s.run(0.1);
  EXPECT_EQ(s.value("help/title"), "Emulators and benches");
  EXPECT_TRUE(s.stage.find("help/heading/benches")->in_view());
  MUST(s.hand.click("help/back"));
  s.run(0.1);
  EXPECT_EQ(s.value("help/title"), "Velmex VXM");
  MUST(s.hand.click("help/pages"));
  s.run(0.1);
  EXPECT_EQ(s.value("help/title"), "Manual");
  EXPECT_TRUE(s.stage.find("help/page/scripts"));
}

TEST(HelpSheet, EveryPageFitsItsColumn) {
  for (const auto& [width, height, scale] :
       {std::tuple{1440, 900, 1.0f}, {1024, 700, 1.0f}, {1024, 700, 2.0f}}) {
    ConsoleStage s(width, height, scale);
    s.add();
    s.run(0.1);
    MUST(s.hand.key("?"));
    s.run(0.1);
    MUST(s.hand.click("help/show/Manual"));
    s.run(0.1);
    const Widget* close = s.stage.find("help/close");
    ASSERT_TRUE(close);
    const float right = close->rect.max.x + 1;
    for (const ManualPage& page : manual_pages()) {
      MUST(s.hand.click("help/page/" + std::string(page.name)));
      s.run(0.1);
      for (const Widget& w : s.stage.surface.screen().registry().widgets())
        if (w.id.starts_with("help/link/")) {
          EXPECT_LE(w.rect.max.x, right) << page.name << ": " << w.id;
        }
      MUST(s.hand.click("help/pages"));
      s.run(0.1);
    }
  }
}

}  // namespace
}  // namespace hw::panels
