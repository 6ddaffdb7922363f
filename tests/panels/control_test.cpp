// Readouts and actions, drawn from a catalog: what is shown, what is sent, what is watched.
#include "panels/control/control.h"

#include "core/devices/pmx_4ex_sa/catalog.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct ControlTest : ::testing::Test {
  ControlTest() {
    s.now.axis_count = 4;
    s.stage.frames(2);
  }
  void set_readout(const char* id, std::int64_t value) {
    const auto i = static_cast<std::size_t>(s.catalog.find_readout(id));
    s.now.readouts[i] = value;
    s.now.readouts_known[i] = true;
    s.now.readouts_seen_at[i] = Instant(from_seconds(s.stage.now_s));
    s.stage.frames(2);
  }
  const intent::Act& act(const char* id) {
    const auto* found = s.last<intent::Act>();
    EXPECT_TRUE(found);
    static const intent::Act none(-1, {});
    if (!found) return none;
    EXPECT_EQ(s.catalog.actions[static_cast<std::size_t>(found->action)].id, id);
    return *found;
  }
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, test::full_catalog()};
};

TEST_F(ControlTest, ValuesAreShownInWordsAndTheirAgeIsNotHidden) {
  EXPECT_EQ(s.value("readout/MM"), "?");
  set_readout("MM", 1);
  EXPECT_EQ(s.value("readout/MM"), "incremental");
  set_readout("TR", 1284);
  EXPECT_EQ(s.value("readout/TR"), "1284 ms");
  set_readout("SLSY", 10);
  EXPECT_EQ(s.value("readout/SLSY"), "stalled");
  s.stage.frames(60 * 4);
  EXPECT_EQ(s.value("readout/MM"), "incremental?");
}

TEST_F(ControlTest, OnlyGroupsInSightAreWatched) {
  const auto* watch = s.last<intent::Watch>();
  ASSERT_TRUE(watch);
  EXPECT_EQ(watch->groups, 0b110111u) << "all but the variables";
  const std::size_t sent = s.sent.size();
  s.stage.frames(60);
  EXPECT_EQ(s.sent.size(), sent) << "said once";
}

TEST_F(ControlTest, AnActionTakesItsFields) {
  s.type("action/arc/centre_x", "-1500");
  s.type("action/arc/centre_y", "2000");
  s.type("action/arc/end_angle", "22.5");
  s.click("action/arc/go");
  EXPECT_THAT(act("arc").values, ElementsAre(-1500, 2000, 22'500));
}

TEST_F(ControlTest, ChoicesAreSentAsTheirValues) {
  s.click("action/latch/axis");
  s.click("action/latch/axis/Z");
  s.click("action/latch/on");
  s.click("action/latch/on/off");
  s.click("action/latch/go");
  EXPECT_THAT(act("latch").values, ElementsAre(2, 0));
  s.click("action/clear/go");
  EXPECT_THAT(act("clear").values, ElementsAre(-1)) << "all axes, as the catalog begins with";
}

TEST_F(ControlTest, AButtonWithoutFieldsIsSentAtOnce) {
  s.click("action/incremental/go");
  EXPECT_TRUE(act("incremental").values.empty());
}

TEST_F(ControlTest, AWrongNumberSendsNothingAndReportsWhy) {
  const std::size_t sent = s.sent.size();
  s.type("action/arc/end_angle", "99999");
  s.click("action/arc/go");
  EXPECT_EQ(s.sent.size(), sent);
  EXPECT_THAT(s.value("action/arc/refused"), HasSubstr("End angle: -3600 to 3600"));
}

TEST_F(ControlTest, AUnitIsThatOfTheAxisThatIsChosen) {
  s.now.axes[1].in_counts = true;
  s.type("action/change_speed/speed", "0");
  s.click("action/change_speed/go");
  EXPECT_THAT(s.value("action/change_speed/refused"), HasSubstr("pulses/s"));
  s.click("action/change_speed/axis");
  s.click("action/change_speed/axis/Y");
  s.click("action/change_speed/go");
  EXPECT_THAT(s.value("action/change_speed/refused"), HasSubstr("counts/s"));
  s.type("action/arc/centre_x", "999999999");
  s.click("action/arc/go");
  EXPECT_THAT(s.value("action/arc/refused"), HasSubstr("pulses"));
  s.type("action/arc/centre_x", "0");
  s.type("action/arc/centre_y", "999999999");
  s.click("action/arc/go");
  EXPECT_THAT(s.value("action/arc/refused"), HasSubstr("counts"));
}

TEST_F(ControlTest, ARefusalStandsWhereItWasAsked) {
  s.click("action/arc/go");
  s.settle(IntentState::refused, "An arc needs absolute mode.");
  EXPECT_EQ(s.value("action/arc/refused"), "An arc needs absolute mode.");
}

TEST_F(ControlTest, MovesWaitForAProgramButAChangeUnderWayDoesNot) {
  s.now.program.owned = true;
  s.now.program.run = RunState::running;
  s.now.program.slot = 0;
  s.stage.frames(2);
  EXPECT_THAT(s.reason("action/arc/go"), HasSubstr("is running"));
  EXPECT_EQ(s.reason("action/change_speed/go"), "");
  EXPECT_EQ(s.reason("action/latch/go"), "");
}

TEST(ControlBesideARail, TheJoysticksInputsHaveLiveBars) {
  for (const gui::Tier tier : {gui::Tier::medium, gui::Tier::wide}) {
    Control panel;
    test::PanelStage s{panel, 864, 1400, 1, tier, true, test::full_catalog()};
    s.now.axis_count = 4;
    s.now.analog[2] = 1840;
    s.now.analog_known = 0xFF;
    s.stage.frames(4);
    if (tier == gui::Tier::medium)
      EXPECT_EQ(s.value("control/analog/3"), "1840");
    else
      EXPECT_FALSE(s.stage.find("control/analog/3")) << "they stand in the right column";
  }
}

Catalog with_tables() {
  Catalog c = test::full_catalog();
  AxisColumn arm{AxisColumn::Shows::action, "latch", ""};
  arm.state = "LTS*", arm.verb_on = "Arm", arm.verb_off = "Disarm";
  AxisColumn change{AxisColumn::Shows::action, "change_speed", "speed"};
  change.verb_on = "Change", change.while_moving = true;
  c.axis_tables = {{"Motion", "", {{AxisColumn::Shows::motion, "clear", "what it does"}, change}},
                   {"Latch", "", {{AxisColumn::Shows::readout, "LTS*", "state"}, arm}}};
  return c;
}

struct ControlTablesTest : ::testing::Test {
  ControlTablesTest() {
    s.now.axis_count = 4;
    for (AxisState& a : s.now.axes) {
      a.activity = Activity::idle;
      a.position_known = true;
    }
    s.stage.frames(2);
  }
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, with_tables()};
};

TEST_F(ControlTablesTest, ARowHasTheActionOfItsAxisAndTheVerbOfItsState) {
  const auto state = static_cast<std::size_t>(s.catalog.find_readout("LTSY"));
  s.now.readouts_known[state] = true;
  s.stage.frames(2);
  EXPECT_EQ(s.stage.find("action/latch/Y/go")->label, "Arm");
  s.click("action/latch/Y/go");
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_THAT(s.last<intent::Act>()->values, ElementsAre(1, 1));
  s.now.readouts[state] = 1;
  s.stage.frames(2);
  EXPECT_EQ(s.stage.find("action/latch/Y/go")->label, "Disarm");
  s.click("action/latch/Y/go");
  EXPECT_THAT(s.last<intent::Act>()->values, ElementsAre(1, 0));
  EXPECT_FALSE(s.stage.find("action/latch/go")) << "nothing stands twice";
}

TEST_F(ControlTablesTest, AChangeUnderWayIsThereOnlyWhileTheAxisMoves) {
  EXPECT_FALSE(s.stage.find("action/change_speed/X/go"));
  s.now.axes[0].activity = Activity::moving;
  s.stage.frames(60);
  s.type("action/change_speed/X/speed", "2500");
  s.click("action/change_speed/X/go");
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_EQ(s.last<intent::Act>()->values[0], 0);
  EXPECT_EQ(s.last<intent::Act>()->values[1], 2500);
  EXPECT_FALSE(s.stage.find("action/change_speed/Y/go"));
}

TEST_F(ControlTablesTest, AnErrorIsClearedWhereItIsShown) {
  EXPECT_FALSE(s.stage.find("action/clear/Z/go"));
  s.now.axes[2].activity = Activity::error;
  s.now.axes[2].error = AxisError::alarm;
  s.stage.frames(2);
  EXPECT_EQ(s.value("control/Z/does"), "ended by alarm");
  s.click("action/clear/Z/go");
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_THAT(s.last<intent::Act>()->values, ElementsAre(2));
}

Catalog with_units() {
  Catalog c = with_tables();
  c.units = {{"screw", "mm", 0.0025, 4}, {"table", "\u00b0", 0.1, 1}};
  c.axis_tables[1].columns.insert(c.axis_tables[1].columns.begin() + 1,
                                  {AxisColumn::Shows::readout, "LTP*", "place"});
  AxisColumn clear{AxisColumn::Shows::action, "clear", ""};
  clear.state = "SLS*", clear.verb_on = "Clear";
  c.axis_tables.push_back({"StepNLoop", "", {{AxisColumn::Shows::readout, "SLS*", "does"}, clear}});
  return c;
}

struct ControlUnitsTest : ::testing::Test {
  ControlUnitsTest() {
    s.now.axis_count = 4;
    for (AxisState& a : s.now.axes) a.activity = Activity::moving;
    s.tab.settings.profile.unit = "real";
    for (AxisProfile& axis : s.tab.settings.profile.axes) axis.unit_choice = "screw";
    s.tab.settings.profile.axes[3].unit_choice = "table";
    s.tab.settings.edited();
    s.stage.frames(60);
  }
  void set_readout(const char* id, std::int64_t value) {
    const auto i = static_cast<std::size_t>(s.catalog.find_readout(id));
    s.now.readouts[i] = value;
    s.now.readouts_known[i] = true;
    s.now.readouts_seen_at[i] = Instant(from_seconds(s.stage.now_s));
    s.stage.frames(2);
  }
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, with_units()};
};

TEST_F(ControlUnitsTest, ValuesTypedInTheAxisUnitAreSentInPulses) {
  s.type("action/change_speed/X/speed", "2.5");
  s.click("action/change_speed/X/go");
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_EQ(s.last<intent::Act>()->values[1], 1000);
  s.type("action/change_speed/U/speed", "50");
  s.click("action/change_speed/U/go");
  EXPECT_EQ(s.last<intent::Act>()->values[1], 500) << "degrees";
}

TEST_F(ControlUnitsTest, ARangeIsReportedInTheSameUnit) {
  s.type("action/change_speed/X/speed", "0");
  s.click("action/change_speed/X/go");
  EXPECT_THAT(s.value("action/change_speed/X/refused"), HasSubstr("0.0025 to 15000 mm/s"));
}

TEST_F(ControlUnitsTest, ANumberStaysWhatItIsWhenAnotherUnitIsChosen) {
  s.type("action/change_speed/X/speed", "2.5");
  s.tab.settings.profile.unit.clear();
  s.tab.settings.edited();
  s.stage.frames(4);
  EXPECT_EQ(s.value("action/change_speed/X/speed"), "1000");
}

TEST_F(ControlUnitsTest, PlacesAreReportedInTheUnitOfTheirAxis) {
  set_readout("LTPX", 46'914);
  EXPECT_EQ(s.value("readout/LTPX"), "117.2850");
  set_readout("LTPU", 46'914);
  EXPECT_EQ(s.value("readout/LTPU"), "4691.4");
}

TEST_F(ControlUnitsTest, AnActionThatClearsAStateIsOfferedOnlyInThatState) {
  EXPECT_FALSE(s.stage.find("action/clear/Y/go"));
  set_readout("SLSY", 10);
  EXPECT_FALSE(s.stage.find("action/clear/X/go"));
  s.click("action/clear/Y/go");
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_THAT(s.last<intent::Act>()->values, ElementsAre(1));
}

TEST(ControlOfPmx, AnUnusedFieldIsAWordAndNothingIsShownTwice) {
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, pmx_4ex_sa::make_catalog({}).value()};
  s.now.axis_count = 4;
  const auto rules = static_cast<std::size_t>(s.catalog.find_param("SYNXC"));
  s.now.params[rules].known = true;
  s.now.params[rules].value = 1;
  s.stage.frames(4);
  EXPECT_NE(s.value("control/SYNXT"), "while so") << "when equal its length counts";
  s.now.params[rules].value = 3;
  s.stage.frames(4);
  EXPECT_EQ(s.value("control/SYNXT"), "while so");
  EXPECT_FALSE(s.stage.find("action/clear_loop/go")) << "Clear in the row of the axis does it";
  s.type("action/timer/time", "250");
  s.click("action/timer/go");
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_THAT(s.last<intent::Act>()->values, ElementsAre(250));
}

// The second column of the settings stands under the second of two tables.
TEST(ControlOfPmx, ControlsUnderTheTablesAlignWithTheirEdges) {
  for (const float width : {864.0f, 1046.0f, 704.0f}) {
    Control panel;
    test::PanelStage s{panel,
                       static_cast<int>(width),
                       1600,
                       1,
                       width == 864 ? gui::Tier::wide : gui::Tier::medium,
                       true,
                       pmx_4ex_sa::make_catalog({}).value()};
    s.now.axis_count = 4;
    s.stage.frames(4);
    const gui::Rect ramp = s.stage.find("action/change_speed/accel")->rect;
    const gui::Rect choice = s.stage.find("action/absolute/go")->rect,
                    timer = s.stage.find("action/timer/time")->rect;
    EXPECT_EQ(ramp.min.x, timer.min.x) << width << ": the fields of the settings have one edge";
    EXPECT_EQ(choice.min.x, timer.min.x) << width;
    if (width < 800) continue;  // there each table has a band of its own
    const gui::Rect sync = s.stage.find("readout/SYNXS")->rect;
    EXPECT_NEAR(ramp.min.x - 128, sync.min.x - 20, 1) << width << ": under the table of the sync outputs";
  }
}

TEST(ControlOfPmx, SwitchesOfItsTablesAreReadOnceWithoutAVisitToTheSetUp) {
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, pmx_4ex_sa::make_catalog({}).value()};
  s.now.axis_count = 4;
  const auto asked = [&s] {
    return std::count_if(s.sent.begin(), s.sent.end(), [](const IntentBody& body) {
      return std::holds_alternative<intent::ReadParams>(body);
    });
  };
  s.stage.frames(4);
  EXPECT_EQ(asked(), 0) << "all is known";
  for (ParamState& p : s.now.params) p.known = false;
  s.stage.frames(4);
  EXPECT_EQ(asked(), 1);
  for (IntentId id = 1; id <= s.sent.size(); ++id)
    s.now.outcomes[id].id = id, s.now.outcomes[id].state = IntentState::done;
  s.stage.now_s += 10;
  s.stage.frames(4);
  EXPECT_EQ(asked(), 1) << "an older firmware does not answer them all";
}

TEST(ControlOfPmx, ARefusedReadingIsAskedForAgain) {
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, pmx_4ex_sa::make_catalog({}).value()};
  s.now.axis_count = 4;
  for (ParamState& p : s.now.params) p.known = false;
  s.stage.frames(4);
  std::vector<IntentId> asked;
  const auto look = [&] {
    asked.clear();
    for (std::size_t i = 0; i < s.sent.size(); ++i)
      if (std::holds_alternative<intent::ReadParams>(s.sent[i])) asked.push_back(i + 1);
    return asked.size();
  };
  ASSERT_EQ(look(), 1U);
  IntentOutcome& refused = s.now.outcomes[0];
  refused.id = asked[0], refused.state = IntentState::refused, refused.sentence = "A download is under way.";
  s.stage.frames(4);
  EXPECT_EQ(look(), 1U) << "not at once";
  s.stage.now_s += 4;
  s.stage.frames(4);
  EXPECT_EQ(look(), 2U);
  EXPECT_EQ(s.toast(), "") << "nobody has asked for it";
}

TEST(ControlOfPmx, TheBufferShowsHowManyPlacesAreFreeOfHowMany) {
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, pmx_4ex_sa::make_catalog({}).value()};
  s.now.axis_count = 4;
  const auto places = static_cast<std::size_t>(s.catalog.find_readout("BUFFREE"));
  s.now.readouts[places] = 30;
  s.now.readouts_known[places] = true;
  s.now.readouts_seen_at[places] = Instant(from_seconds(s.stage.now_s));
  s.stage.frames(4);
  EXPECT_EQ(s.value("readout/BUFFREE"), "30");
  const gui::Widget* cells = s.stage.find("readout/BUFFREE");
  ASSERT_TRUE(cells);
  EXPECT_GE(cells->rect.height(), 48) << "a row of cells under the words";
}

TEST(ControlOfPmx, AnArcWithoutARadiusIsNotDrawnAndReportsWhy) {
  Control panel;
  test::PanelStage s{panel, 864, 1400, 1, gui::Tier::wide, true, pmx_4ex_sa::make_catalog({}).value()};
  s.now.axis_count = 4;
  for (AxisState& a : s.now.axes) a.position_known = true;
  s.stage.frames(4);
  EXPECT_EQ(s.value("action/arc/path"), "Choose another centre: the axes stand at this one.");
  s.type("action/arc/centre_x", "1000");
  EXPECT_THAT(s.value("action/arc/path"), HasSubstr("Radius 1000 pulses"));
  EXPECT_LT(s.stage.find("action/arc/path")->rect.min.x, s.stage.find("action/timer/go")->rect.min.x)
      << "it begins the first column";
}

TEST_F(ControlTest, TheFirmwareAndTheConsoleVersionAreShown) {
  EXPECT_EQ(s.value("about/firmware"), "not told");
  s.now.identity.firmware = "V319";
  s.stage.frames(2);
  EXPECT_EQ(s.value("about/firmware"), "V319");
  EXPECT_THAT(s.value("about/console"), HasSubstr("Handwheel"));
}

TEST_F(ControlTest, SettingsThatAnOlderFirmwareLacksAreListed) {
  for (ParamState& p : s.now.params) p.known = false;
  s.stage.frames(2);
  EXPECT_EQ(s.value("about/older"), "not known: read the set-up first");
  for (ParamState& p : s.now.params) p.known = true;
  s.stage.frames(2);
  EXPECT_EQ(s.value("about/older"), "nothing: it supports every setting");
  std::size_t silent = 0;
  while (!s.catalog.params[silent].readable) ++silent;
  s.now.params[silent].known = false;
  s.stage.frames(2);
  EXPECT_EQ(s.value("about/older"), "1: " + s.catalog.params[silent].mnemonic);
}

}  // namespace
}  // namespace hw::panels
