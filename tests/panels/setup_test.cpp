#include "panels/setup/setup.h"

#include <optional>

#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/vme58/catalog.h"
#include "panels/control/shown_unit.h"
#include "tests/core/session/folder.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct SetupTest : ::testing::Test {
  SetupTest() { s.stage.frames(2); }
  panels::Setup panel;
  test::PanelStage s{panel};
};

TEST_F(SetupTest, EditedValueGoesOutWithWriteOnly) {
  s.type("setup/j1M", "100\n");
  EXPECT_TRUE(s.sent.empty());
  EXPECT_EQ(s.value("setup/j1M"), "100");
  EXPECT_THAT(s.value("setup/state"), HasSubstr("1 edited, not written yet."));
  ASSERT_TRUE(s.stage.find("setup/j1M/was"));
  s.click("setup/write");
  ASSERT_TRUE(s.last<intent::SetParam>());
  EXPECT_EQ(s.last<intent::SetParam>()->mnemonic, "j1M");
  EXPECT_EQ(s.last<intent::SetParam>()->value, 100);
  s.now.params[1].value = 100;
  s.settle(IntentState::done);
  EXPECT_THAT(s.toast(), HasSubstr("1 value written and read back."));
  EXPECT_THAT(s.reason("setup/write"), HasSubstr("No value here differs"));
}

TEST_F(SetupTest, AParameterInStepsIsTypedInTheUnitOfItsAxis) {
  Catalog catalog;
  {
    auto made = pmx_4ex_sa::make_catalog({});
    ASSERT_TRUE(made);
    catalog = std::move(*made);
  }
  catalog.units = {{"screw", "mm", 0.0025, 4}};
  panels::Setup fresh;
  test::PanelStage other(fresh, 864, 700, 1, gui::Tier::wide, true, catalog);
  const auto i = static_cast<std::size_t>(catalog.find_param("HSX"));
  other.now.params[i].known = true;
  other.now.params[i].value = 1000;
  other.tab.settings.profile.unit = "real";
  other.tab.settings.profile.axes[0].unit_choice = "screw";
  other.tab.settings.edited();
  other.type("setup/filter", "HSX");
  other.stage.frames(4);
  EXPECT_EQ(other.value("setup/HSX"), "2.5000");
  other.type("setup/HSX", "5\n");
  EXPECT_EQ(other.stage.find("setup/HSX/was")->label, "was 2.5000");
  other.click("setup/write");
  ASSERT_TRUE(other.last<intent::SetParam>());
  EXPECT_EQ(other.last<intent::SetParam>()->value, 2000) << "the controller is told pulses";
}

TEST(SetupFacts, LargeNumbersAreGroupedAsInTheirField) {
  ParamInfo p;
  p.maximum = 1'044'000;
  const ShownUnit own;
  EXPECT_EQ(text_in(own, p, 200'000), "200\u2009000");
  EXPECT_EQ(range_in(own, p), "0 to 1\u2009044\u2009000");
  p.prefix = "4EX", p.digits = 2;
  EXPECT_EQ(text_in(own, p, 7), "4EX07");
}

TEST_F(SetupTest, OutOfRangeIsReportedAndNotTaken) {
  s.type("setup/j1M", "9000\n");
  EXPECT_THAT(s.reason("setup/write"), HasSubstr("No value here differs"));
  EXPECT_EQ(s.value("setup/j1M"), "9000") << "what was typed stays to be mended";
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(SetupTest, WasBringsTheOldValueBack) {
  s.type("setup/j1M", "100\n");
  s.click("setup/j1M/was");
  EXPECT_EQ(s.value("setup/j1M"), "2000");
  EXPECT_FALSE(s.stage.find("setup/j1M/was"));
}

TEST_F(SetupTest, WarningIsConfirmedBeforeItIsWritten) {
  s.click("setup/M1M");
  s.click("setup/M1M/2: big");
  EXPECT_EQ(s.value("setup/M1M"), "2: big");
  s.click("setup/write");
  EXPECT_TRUE(s.sent.empty());
  ASSERT_TRUE(s.stage.find("setup/confirm/yes"));
  s.click("setup/confirm/no");
  EXPECT_TRUE(s.sent.empty());
  s.click("setup/write");
  s.click("setup/confirm/yes");
  ASSERT_TRUE(s.last<intent::SetParam>());
  EXPECT_TRUE(s.last<intent::SetParam>()->confirmed);
  EXPECT_EQ(s.last<intent::SetParam>()->value, 2);
}

TEST_F(SetupTest, BitsAreBoxes) {
  EXPECT_EQ(s.value("setup/I"), "7");
  EXPECT_EQ(s.value("setup/I/4"), "off");
  s.click("setup/I/4");
  EXPECT_EQ(s.value("setup/I"), "23");
  s.click("setup/I/4");
  EXPECT_EQ(s.value("setup/I"), "7");
}

TEST_F(SetupTest, SearchAndShowNarrowTheList) {
  s.type("setup/filter", "jog speed");
  EXPECT_TRUE(s.stage.find("setup/j1M"));
  EXPECT_FALSE(s.stage.find("setup/M1M"));
  s.type("setup/filter", "");
  s.click("setup/show/Not factory");
  EXPECT_FALSE(s.stage.find("setup/j1M"));
  s.now.params[1].value = 55;
  s.stage.frames(2);
  EXPECT_TRUE(s.stage.find("setup/j1M"));
}

TEST_F(SetupTest, StoreShowsHowManyWritesWereUsed) {
  s.click("setup/store");
  ASSERT_TRUE(s.last<intent::Store>());
  s.now.store_count = 13;
  s.settle(IntentState::done);
  EXPECT_EQ(s.toast(), "Stored in the controller. 13 of 100000 writes used.");
}

TEST_F(SetupTest, WhyItWasNotStoredGoesWithTheNextAttempt) {
  s.click("setup/store");
  s.settle(IntentState::refused, "An axis moves. Nothing was stored.");
  EXPECT_EQ(s.toast(), "An axis moves. Nothing was stored.");
  s.click("setup/store");
  EXPECT_EQ(s.toast(), "");
  s.settle(IntentState::done);
  EXPECT_EQ(s.console.toasts().list().size(), 1u);
}

TEST_F(SetupTest, ARefusedWriteReportsWhyAndKeepsTheValue) {
  s.type("setup/j1M", "100\n");
  s.click("setup/write");
  s.settle(IntentState::refused, "A program runs. Nothing was sent.");
  EXPECT_THAT(s.toast(), HasSubstr("j1M: A program runs."));
  EXPECT_EQ(s.value("setup/j1M"), "100");
}

TEST_F(SetupTest, WithoutLinkNothingCanBeWritten) {
  s.now.link.state = LinkState::lost;
  s.stage.frames(2);
  EXPECT_THAT(s.reason("setup/write"), HasSubstr("no link"));
  EXPECT_THAT(s.reason("setup/j1M"), HasSubstr("no link"));
}

TEST_F(SetupTest, UnknownValuesAreReadOnce) {
  panels::Setup fresh;
  test::PanelStage other(fresh);
  other.now.params[1].known = false;
  other.stage.frames(3);
  ASSERT_EQ(other.sent.size(), 1u);
  EXPECT_TRUE(other.last<intent::ReadParams>());
  EXPECT_THAT(other.value("setup/state"), HasSubstr("1 not read yet."));
}

TEST_F(SetupTest, EveryParameterCanBeReachedInEachTier) {
  for (const auto& [width, height, tier] :
       {std::tuple{864, 700, gui::Tier::wide}, std::tuple{704, 400, gui::Tier::medium},
        std::tuple{720, 300, gui::Tier::narrow}}) {
    panels::Setup fresh;
    test::PanelStage other(fresh, width, height, 1, tier);
    other.stage.frames(3);
    for (const ParamInfo& p : other.catalog.params) {
      const gui::Widget* w = other.stage.find("setup/" + p.mnemonic);
      ASSERT_TRUE(w) << p.mnemonic;
      EXPECT_GE(w->rect.min.x, 0);
      EXPECT_LE(w->rect.max.x, width);
    }
  }
}

TEST_F(SetupTest, AllFieldsBeginAndEndOnOneEdge) {
  std::optional<gui::Rect> first;
  for (const ParamInfo& p : s.catalog.params) {
    if (!p.bits.empty()) continue;
    const gui::Widget* w = s.stage.find("setup/" + p.mnemonic);
    ASSERT_TRUE(w) << p.mnemonic;
    if (!first) first = w->rect;
    EXPECT_EQ(w->rect.min.x, first->min.x) << p.mnemonic;
    EXPECT_EQ(w->rect.max.x, first->max.x) << p.mnemonic;
  }
}

TEST_F(SetupTest, TheFormerValueStandsBesideAChangeInANarrowPanel) {
  panels::Setup fresh;
  test::PanelStage other(fresh, 440, 700, 1, gui::Tier::narrow);
  other.stage.frames(3);
  other.type("setup/j1M", "100\n");
  EXPECT_TRUE(other.stage.find("setup/j1M/was"));
}

std::vector<std::string> listed(const Catalog& c, std::string_view title) {
  SetupList list;
  std::vector<std::string> names;
  for (const SetupList::Section& section : list.sections(c))
    if (section.title == title)
      for (const std::size_t i : section.params) names.push_back(c.params[i].mnemonic);
  return names;
}

TEST(SetupListTest, StepNLoopIsListedByAxisAndInTheOrderOfItsUse) {
  const auto pmx = pmx_4ex_sa::make_catalog({});
  ASSERT_TRUE(pmx);
  const auto names = listed(*pmx, "StepNLoop");
  ASSERT_EQ(names.size(), 20u);
  EXPECT_EQ(std::vector(names.begin(), names.begin() + 6),
            (std::vector<std::string>{"SLRX", "SLTX", "SLEX", "SLAX", "SLX", "SLRY"}));
}

TEST(SetupListTest, AHeadingStandsOnceAndNamesItsAxis) {
  const auto pmx = pmx_4ex_sa::make_catalog({});
  const auto board = vme58::make_catalog({});
  ASSERT_TRUE(pmx && board);
  EXPECT_EQ(listed(*pmx, "Speed").front(), "HS");
  EXPECT_EQ(listed(*pmx, "Speed").back(), "SSPDMU");
  EXPECT_EQ(listed(*board, "Speeds and ramps of X"), (std::vector<std::string>{"VLX", "ACX", "VBX"}));
  EXPECT_EQ(listed(*board, "Speeds and ramps"), (std::vector<std::string>{"PN", "CV"})) << "of no axis";
  for (const Catalog* c : {&*pmx, &*board}) {
    SetupList list;
    std::size_t all = 0;
    for (const SetupList::Section& section : list.sections(*c)) all += section.params.size();
    EXPECT_EQ(all, c->params.size());
  }
}

}  // namespace
}  // namespace hw::panels
