// Running the rest of a program from a place on its path.
#include "panels/program/run_from.h"

#include <algorithm>

#include "core/device/registry.h"
#include "panels/path/tool_path.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

sequence::Move to(std::size_t axis, double place) {
  sequence::Move m;
  m.to[axis] = place;
  return m;
}

struct RunFromTest : ::testing::Test {
  RunFromTest() {
    s.now.axis_count = 2;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
    sequence::Sequence square;
    square.axes = {{"1", 1}, {"2", 1}};
    square.steps = {{sequence::Speed{{2000, 0, 0}}},
                    {sequence::Pen{false}},
                    {to(0, 0)},
                    {sequence::Pen{true}},
                    {to(0, 400)},
                    {to(1, 400)},
                    {to(0, 0)}};
    square.pen_up = {{sequence::Output{1, false}}};
    square.pen_down = {{sequence::Output{1, true}}};
    s.tab.desk().blocks.editor.load(square);
  }
  void rehearse(std::string text) {
    s.tab.desk().programs.texts.set_text(0, std::move(text));
    s.stage.frames(2);
    s.click("path/simulate");
    s.stage.frames(4);
  }
  std::string of_blocks() {
    const auto written = type.language().write(s.tab.desk().blocks.editor.sequence(), s.catalog);
    EXPECT_TRUE(written) << written.error().sentence();
    return written ? written->text : "";
  }
  /// On the side that goes up at the right.
  void click_on_second_side() {
    const gui::Rect r = s.stage.find("path/view")->rect;
    const auto half = static_cast<float>(200 / std::stod(s.value("path/view")));
    s.click_at(ImVec2(r.centre().x + half, r.centre().y));
  }
  const DeviceType& type = *find_device_type("vxm");
  ToolPath panel;
  test::PanelStage s{panel, 864, 620, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()};
};

TEST_F(RunFromTest, ShowsTheWayThereAndDoesNothingBeforeItIsAgreedTo) {
  rehearse(of_blocks());
  s.now.axes[0].position = Steps(250);
  s.stage.frames(2);
  s.click("path/fit");
  s.stage.frames(2);
  click_on_second_side();
  ASSERT_THAT(s.value("path/hit"), HasSubstr("IA2M400"));
  s.click("path/run_here");
  const std::string asked = s.value("path/run_from/says");
  EXPECT_THAT(asked, HasSubstr("Now: motor 1 at 250 steps"));
  EXPECT_THAT(asked, HasSubstr("First: Tool up. Speed 2000 steps/s. Move to 1: 400, 2: 0. Tool down."));
  EXPECT_THAT(asked, HasSubstr("Then step 6, Move to 2: 400, and everything after it."));
  EXPECT_THAT(asked, Not(HasSubstr("no step mentions a tool")));
  EXPECT_TRUE(s.sent.empty());
  const std::string before = s.tab.desk().programs.texts.text(0);
  s.click("path/run_from/no");
  EXPECT_TRUE(s.sent.empty());
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), before);
}

TEST_F(RunFromTest, RunsTheRestBehindTheWayThere) {
  rehearse(of_blocks());
  click_on_second_side();
  s.click("path/run_here");
  s.click("path/run_from/yes");
  s.stage.frames(4);
  const std::string& text = s.tab.desk().programs.texts.text(0);
  const auto up = text.find("U4"), there = text.find("IA1M400"), down = text.find("U5"),
             rest = text.find("IA2M400");
  EXPECT_TRUE(up < there && there < down && down < rest && rest != std::string::npos) << text;
  EXPECT_FALSE(s.sent.empty()) << "it is on its way into the controller";
  // And from a place in that again.
  s.stage.frames(4);
  s.sent.clear();
  s.tab.desk().programs.job.give_up();
  s.settle(IntentState::failed, "no");
  s.stage.frames(4);
  s.click("path/fit");
  s.stage.frames(2);
  click_on_second_side();
  EXPECT_THAT(s.reason("path/run_here"), Not(HasSubstr("of no blocks")));
}

TEST_F(RunFromTest, AnUnknownPositionKeepsTheRunFromBeginning) {
  rehearse(of_blocks());
  s.now.axes[1].position_known = false;
  s.stage.frames(2);
  click_on_second_side();
  s.click("path/run_here");
  EXPECT_THAT(s.toast(), HasSubstr("The position of motor 2 is not known. Nothing was started."));
  EXPECT_FALSE(s.stage.find("path/run_from/yes"));
  s.now.axes[1].position_known = true;
  s.now.axes[0].trust.doubt(Doubt::power_cut, {});
  s.stage.frames(2);
  s.click("path/run_here");
  EXPECT_THAT(s.toast(), HasSubstr("The position of motor 1 cannot be trusted: its power was cut."));
  EXPECT_FALSE(s.stage.find("path/run_from/yes"));
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(RunFromTest, AnAxisThatNoStepBeforeHasMovedComesToWhereTheRehearsalBegan) {
  sequence::Sequence only_second = s.tab.desk().blocks.editor.sequence();
  only_second.steps = {{sequence::Pen{true}}, {to(0, 400)}, {to(1, 400)}};
  s.tab.desk().blocks.editor.load(only_second);
  rehearse(of_blocks());
  s.now.axes[1].position = s.now.axes[1].command = Steps(70);
  s.stage.frames(2);
  click_on_second_side();
  s.click("path/run_here");
  const std::string asked = s.value("path/run_from/says");
  EXPECT_THAT(asked, HasSubstr("Now: motor 1 at 0 steps, motor 2 at 70 steps")) << s.toast();
  EXPECT_THAT(asked, HasSubstr("Move to 1: 400, 2: 0. Tool down.")) << "the line that is drawn begins there";
}

TEST_F(RunFromTest, ARunPastALimitIsRefusedWithTheDistance) {
  rehearse(of_blocks());
  s.now.axes[1].travel = {false, true, {}, Steps(300)};
  s.stage.frames(2);
  click_on_second_side();
  s.click("path/run_here");
  EXPECT_THAT(s.toast(), HasSubstr("400 steps lies 100 steps past the + limit of motor 2, 300 steps"));
  EXPECT_FALSE(s.stage.find("path/run_from/yes"));
}

TEST_F(RunFromTest, ATypedTextIsBegunWhereItsRehearsalCameTo) {
  s.now.axes[1].position = s.now.axes[1].command = Steps(50);
  s.stage.frames(2);
  rehearse("I1M400,\nI2M400,\nI1M-400,\n");
  s.now.axes[1].position = s.now.axes[1].command = Steps(70);
  s.stage.frames(2);
  click_on_second_side();
  ASSERT_THAT(s.value("path/hit"), HasSubstr("Line 2: I2M400"));
  s.click("path/run_here");
  s.stage.frames(3);
  const std::string asked = s.value("path/run_from/says");
  EXPECT_THAT(asked, HasSubstr("Now: motor 1 at 0 steps, motor 2 at 70 steps")) << s.toast();
  EXPECT_THAT(asked, HasSubstr("First: Move to 1: 400, 2: 50.")) << "where it was rehearsed";
  EXPECT_THAT(asked, HasSubstr("Then line 2, I2M400, and everything after it."));
  EXPECT_THAT(asked, HasSubstr("no step mentions a tool"));
  EXPECT_TRUE(s.sent.empty());
  s.click("path/run_from/yes");
  s.stage.frames(4);
  const std::string& text = s.tab.desk().programs.texts.text(0);
  const auto there = text.find("IA1M400"), rest = text.find("I2M400"), last = text.find("I1M-400");
  EXPECT_TRUE(there < rest && rest < last && last != std::string::npos) << text;
  EXPECT_THAT(text, HasSubstr("From line 2 on."));
  EXPECT_FALSE(s.sent.empty());
}

TEST_F(RunFromTest, OfALineOfSeveralCommandsTheOneThatWasClickedIsMeant) {
  rehearse("I1M400,I2M400,I1M-400");
  click_on_second_side();
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 1: I2M400"));
  s.click("path/run_here");
  s.stage.frames(3);
  EXPECT_THAT(s.value("path/run_from/says"), HasSubstr("First: Move to 1: 400, 2: 0.")) << s.toast();
}

TEST_F(RunFromTest, TheUnknownStateAfterATypedTextIsNamed) {
  rehearse("I1M400,\nU99,\nI2M400,\nI1M-400,\n");
  click_on_second_side();
  ASSERT_THAT(s.value("path/hit"), HasSubstr("Line 3"));
  s.click("path/run_here");
  s.stage.frames(3);
  EXPECT_THAT(s.toast(), HasSubstr("The state after \"U99"));
  EXPECT_THAT(s.toast(), HasSubstr("above line 3 is unknown."));
  EXPECT_FALSE(s.stage.find("path/run_from/yes"));
  EXPECT_TRUE(s.sent.empty());
}

/// Round and round to the right and upwards: its passes lie beside one another.
sequence::Sequence stairs(const sequence::Sequence& square) {
  sequence::Sequence looped = square;
  looped.steps.erase(looped.steps.begin() + 4, looped.steps.end());
  std::get<sequence::Move>(looped.steps[2].body).to[1] = 0;
  sequence::Move right = to(0, 100), up = to(1, 100);
  right.relative = up.relative = true;
  looped.steps.push_back({sequence::Repeat{4, {{right}, {up}}}});
  return looped;
}

TEST_F(RunFromTest, WithinALoopThePassThatWasClickedIsWrittenOut) {
  s.tab.desk().blocks.editor.load(stairs(s.tab.desk().blocks.editor.sequence()));
  rehearse(of_blocks());
  const gui::Rect r = s.stage.find("path/view")->rect;
  // From 200, 100 up to 200, 200: the second way upwards.
  s.click_at(ImVec2(r.centre().x, r.centre().y + static_cast<float>(50 / std::stod(s.value("path/view")))));
  ASSERT_THAT(s.value("path/hit"), HasSubstr("I2M100"));
  s.click("path/run_here");
  EXPECT_THAT(s.value("path/run_from/says"), HasSubstr("Then pass 2 of 4 of the loop of step 5, "))
      << s.toast();
  EXPECT_THAT(s.value("path/run_from/says"), HasSubstr("Move to 1: 200, 2: 100."));
  s.click("path/run_from/yes");
  s.stage.frames(4);
  EXPECT_THAT(s.tab.desk().programs.texts.text(0), HasSubstr("LA2")) << "two passes are left";
}

TEST_F(RunFromTest, ALoopLineThatWasNotClickedIsRefusedWithTheReason) {
  s.tab.desk().blocks.editor.load(stairs(s.tab.desk().blocks.editor.sequence()));
  const std::string text = of_blocks();
  rehearse(text);
  const auto before = text.find("I2M100");
  s.tab.desk().programs.caret_line =
      static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(before), '\n'));
  s.stage.frames(2);
  s.click("path/run_here");
  EXPECT_THAT(s.toast(), HasSubstr("the path does not show in which pass"));
  EXPECT_THAT(s.toast(), HasSubstr("Click the pass in the picture"));
  EXPECT_FALSE(s.stage.find("path/run_from/yes"));
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(RunFromTest, AStopWhileItIsAskedIsNotOverrun) {
  rehearse(of_blocks());
  click_on_second_side();
  s.click("path/run_here");
  s.tab.desk().stopped();
  s.click("path/run_from/yes");
  EXPECT_THAT(s.toast(), HasSubstr("A stop came first"));
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(RunFromTest, ARunningProgramIsNotReplaced) {
  rehearse(of_blocks());
  click_on_second_side();
  s.now.program.owned = true;
  s.now.program.run = RunState::running;
  s.stage.frames(2);
  EXPECT_THAT(s.reason("path/run_here"), HasSubstr("A program is running"));
}

}  // namespace
}  // namespace hw::panels
