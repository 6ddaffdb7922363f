// A program that is sent to places by a count that cannot be trusted: what can be done stands beside Run.
#include <algorithm>
#include <memory>

#include "core/device/registry.h"
#include "panels/program/program.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct RunDoubtTest : ::testing::Test {
  RunDoubtTest() {
    s.now.axis_count = 2;
    s.now.slot_bytes_used.fill(0);
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.now.axes[0].trust.doubt(Doubt::power_cut, Instant());
    sequence::Sequence q;
    q.axes = {{"1"}};
    sequence::Move move;
    move.to[0] = 400;
    q.steps.push_back({move});
    SequenceText written;
    written.text = "IA1M400";
    s.tab.desk().programs.source.put({std::make_shared<const sequence::Sequence>(q), written});
    s.tab.desk().programs.texts.set_text(0, written.text);
    s.stage.frames(2);
  }
  /// A program that sends two motors to places, the second of them too.
  void put_two() {
    sequence::Sequence q;
    q.axes = {{"1"}, {"2"}};
    sequence::Move move;
    move.to[0] = 400, move.to[1] = 300;
    q.steps.push_back({move});
    SequenceText written;
    written.text = "IA1M400,IA2M300";
    s.tab.desk().programs.source.put({std::make_shared<const sequence::Sequence>(q), written});
    s.tab.desk().programs.texts.set_text(0, written.text);
    s.stage.frames(2);
  }
  void agree_and_load() {
    s.click("program/run");
    s.click("program/doubt/once");
    ASSERT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
  }
  template <class T>
  int count() const {
    return static_cast<int>(std::count_if(s.sent.begin(), s.sent.end(), [](const IntentBody& body) {
      return std::holds_alternative<T>(body);
    }));
  }

  const DeviceType& vxm = *find_device_type("vxm");
  Program panel;
  test::PanelStage s{panel, 1440, 900, 1, gui::Tier::wide, true, *vxm.make_catalog({}), &vxm.language()};
};

TEST_F(RunDoubtTest, RunIsHeldBackAndGoesOnForThisOnce) {
  s.click("program/run");
  EXPECT_EQ(count<intent::LoadProgram>(), 0) << "nothing was sent";
  EXPECT_THAT(s.value("program/doubt/refused"), HasSubstr("The position of motor 1 cannot be trusted"));
  s.click("program/doubt/once");
  EXPECT_FALSE(s.stage.find("program/doubt/refused"));
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  EXPECT_TRUE(s.last<intent::RunProgram>()->despite_doubt);
  s.settle(IntentState::done);
  s.click("program/run");
  EXPECT_TRUE(s.stage.find("program/doubt/refused")) << "it was for this once";
  EXPECT_EQ(count<intent::RunProgram>(), 1);
}

TEST_F(RunDoubtTest, ItIsHomedOrDeclaredToStandWhereItCounts) {
  s.now.axes[0].position = s.now.axes[0].command = Steps(70);
  s.click("program/run");
  s.click("program/doubt/home/-");
  ASSERT_TRUE(s.last<intent::Home>());
  EXPECT_EQ(s.last<intent::Home>()->axis, AxisId{0});
  s.click("program/doubt/stands");
  ASSERT_TRUE(s.last<intent::TrustPosition>());
  EXPECT_EQ(s.last<intent::TrustPosition>()->axis, AxisId{0});
  EXPECT_TRUE(s.stage.find("program/doubt/refused")) << "until the controller has it so";
  s.now.axes[0].trust.settle(Trust::set, Instant());
  s.stage.frames(2);
  EXPECT_FALSE(s.stage.find("program/doubt/refused"));
}

TEST_F(RunDoubtTest, AnAxisThatBecomesDoubtfulMeanwhileIsReportedOf) {
  s.now.axes[1].position = s.now.axes[1].command = Steps(5);
  put_two();
  s.click("program/run");
  ASSERT_THAT(s.value("program/doubt/refused"), HasSubstr("The position of motor 1 cannot be trusted"));
  EXPECT_THAT(s.value("program/doubt/refused"), Not(HasSubstr("motor 2")));
  s.now.axes[1].trust.doubt(Doubt::another, Instant());
  s.stage.frames(2);
  EXPECT_THAT(s.value("program/doubt/refused"), HasSubstr("motor 2"));
  s.now.axes[0].trust.settle(Trust::set, Instant());
  s.stage.frames(2);
  EXPECT_THAT(s.value("program/doubt/refused"), HasSubstr("The position of motor 2 cannot be trusted"));
}

// Loading may take minutes: what was agreed to before it is not what is true behind it.
TEST_F(RunDoubtTest, AFurtherAxisThatBecomesDoubtfulWhileItIsLoadedIsNotAgreedTo) {
  put_two();
  agree_and_load();
  s.now.axes[1].trust.doubt(Doubt::power_cut, Instant());
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::RunProgram>(), 0);
  EXPECT_THAT(s.toast(), HasSubstr("was not started. Meanwhile the position of motor 2 has become doubtful"));
  s.click("program/run");
  EXPECT_THAT(s.value("program/doubt/refused"), HasSubstr("motor 2")) << "it is asked for both";
  s.click("program/doubt/once");
  ASSERT_TRUE(s.last<intent::RunProgram>()) << "it is there already";
  EXPECT_TRUE(s.last<intent::RunProgram>()->despite_doubt);
}

TEST_F(RunDoubtTest, AnotherReasonWhileItIsLoadedIsNotAgreedTo) {
  agree_and_load();
  s.now.axes[0].trust.doubt(Doubt::killed, Instant());
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::RunProgram>(), 0);
  EXPECT_THAT(s.toast(), HasSubstr("it was stopped without a ramp at speed"));
}

TEST_F(RunDoubtTest, TheSameReasonOnceMoreWhileItIsLoadedIsNotAgreedTo) {
  agree_and_load();
  s.now.axes[0].trust.doubt(Doubt::power_cut, Instant(Millis(5000)));
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::RunProgram>(), 0);
}

TEST_F(RunDoubtTest, AnAxisThatItDoesNotMoveChangesNothing) {
  agree_and_load();
  s.now.axes[1].trust.doubt(Doubt::killed, Instant());
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>()) << s.toast();
  EXPECT_TRUE(s.last<intent::RunProgram>()->despite_doubt);
}

// No controller is asked about the first step of a program: it is judged here.
TEST_F(RunDoubtTest, ADoubtThatComesWhileItIsLoadedHoldsStepsBackToo) {
  s.now.axes[0].trust.settle(Trust::set, Instant());
  s.stage.frames(2);
  s.click("program/step");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  s.now.axes[0].trust.doubt(Doubt::power_cut, Instant());
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::SingleStep>(), 0);
  EXPECT_THAT(s.toast(), HasSubstr("was not started"));
}

TEST_F(RunDoubtTest, AClickOnWhatHasJustChangedIsNoConsent) {
  s.click("program/run");
  ASSERT_TRUE(s.stage.find("program/doubt/once"));
  const ImVec2 at = s.stage.find("program/doubt/once")->rect.centre();
  s.stage.push(gui::InputEvent::mouse_move(at.x, at.y, s.stage.now_s));
  s.stage.frames(20);
  s.stage.push(gui::InputEvent::mouse_button(0, true, at, s.stage.now_s));
  s.stage.frames(1);
  s.now.axes[0].trust.doubt(Doubt::killed, Instant());
  s.stage.push(gui::InputEvent::mouse_button(0, false, at, s.stage.now_s));
  s.stage.frames(1);
  EXPECT_EQ(count<intent::LoadProgram>(), 0);
  s.stage.frames(2);
  EXPECT_THAT(s.value("program/doubt/refused"), HasSubstr("without a ramp")) << "the new reason is told";
}

TEST_F(RunDoubtTest, AnotherTextIsAnotherMatter) {
  s.click("program/run");
  ASSERT_TRUE(s.stage.find("program/doubt/refused"));
  s.tab.desk().programs.texts.set_text(0, "I1M5");
  s.stage.frames(2);
  EXPECT_FALSE(s.stage.find("program/doubt/refused"));
}

TEST_F(RunDoubtTest, ATextThatWasTypedIsReadForItsPlaces) {
  s.tab.desk().programs.texts.set_text(0, "S1M1500\nIA1M250\nIA2M70\n");
  s.stage.frames(2);
  s.click("program/run");
  EXPECT_EQ(count<intent::LoadProgram>(), 0) << "nothing was sent";
  EXPECT_THAT(s.value("program/doubt/refused"), HasSubstr("The position of motor 1 cannot be trusted"));
  s.click("program/doubt/once");
  EXPECT_TRUE(s.last<intent::LoadProgram>());
}

TEST_F(RunDoubtTest, ATypedTextIsNotRunForDoubtsThatCameWhileItIsLoaded) {
  s.tab.desk().programs.texts.set_text(0, "S1M1500\nIA1M250\nIA2M70\n");
  s.stage.frames(2);
  agree_and_load();
  s.now.axes[1].trust.doubt(Doubt::power_cut, Instant());
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::RunProgram>(), 0);
  EXPECT_THAT(s.toast(), HasSubstr("Meanwhile the position of motor 2 has become doubtful"));
}

TEST_F(RunDoubtTest, ATypedTextIsNotSteppedThroughForDoubtsThatCameWhileItIsLoaded) {
  s.now.axes[0].trust.settle(Trust::set, Instant());
  s.tab.desk().programs.texts.set_text(0, "S1M1500\nIA1M250\n");
  s.stage.frames(2);
  s.click("program/step");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  s.now.axes[0].trust.doubt(Doubt::power_cut, Instant());
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::SingleStep>(), 0);
  EXPECT_THAT(s.toast(), HasSubstr("was not started"));
}

TEST_F(RunDoubtTest, OneThatGoesByDistancesOnlyIsNotHeldBack) {
  s.tab.desk().programs.texts.set_text(0, "I1M250\nIA2M70\n");
  s.stage.frames(2);
  s.click("program/run");
  EXPECT_FALSE(s.stage.find("program/doubt/refused"));
  EXPECT_TRUE(s.last<intent::LoadProgram>());
}

}  // namespace
}  // namespace hw::panels
