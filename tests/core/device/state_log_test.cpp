// What a driver has concluded about its controller is logged: --log driver.MODEL=debug.
#include "core/device/state_log.h"

#include <gmock/gmock.h>

#include "tests/core/base/log_reader.h"

namespace hw {
namespace {

using testing::HasSubstr;

class StateLogTest : public testing::Test {
 protected:
  StateLogTest() {
    catalog.model = "toy";
    catalog.axes.resize(2);
    catalog.axes[0].name = "X", catalog.axes[1].name = "Y";
    now.axis_count = 2;
  }
  Catalog catalog;
  Snapshot now;
};

TEST_F(StateLogTest, ReportsEachTurnOnce) {
  test::LogReader log;
  StateLog states(catalog);
  states.look(now);
  EXPECT_EQ(log.text(), "") << "nothing has turned yet";
  now.link.state = LinkState::good;
  now.restarts = 1;
  now.program.run = RunState::running, now.program.slot = 2;
  now.slots_torn = 4;
  now.unsaved_setup = true;
  now.jog_guard.state = JogGuard::State::installed;
  now.identity.model = "Toy", now.identity.firmware = "1.2";
  now.axes[1].trust.doubt(Doubt::power_cut, {});
  now.axes[0].activity = Activity::jogging;
  states.look(now);
  for (const char* line :
       {"driver.toy: toy: link good, was connecting\n", "toy: it has restarted, time 1\n",
        "toy: program 2 running, was idle\n", "toy: programs that differ from the text sent: bits 00000100\n",
        "toy: its set-up differs from what is stored\n", "toy: guard of held jogs installed\n",
        "toy: it names itself Toy, firmware 1.2\n", "is doubtful: its power was cut\n",
        "jogging, was unknown\n"})
    EXPECT_THAT(log.text(), HasSubstr(line));
  const std::string once = log.text();
  states.look(now);
  EXPECT_EQ(log.text(), once);
}

TEST_F(StateLogTest, LogsWhyAMotionAndAProgramEnded) {
  test::LogReader log;
  StateLog states(catalog);
  now.axes[0].activity = Activity::jogging;
  now.program.run = RunState::running, now.program.slot = 2;
  states.look(now);
  now.axes[0].activity = Activity::idle, now.axes[0].ended_by = EndedBy::limit;
  now.program.run = RunState::idle, now.program.ended_by = EndedBy::elsewhere;
  states.look(now);
  EXPECT_THAT(log.text(), HasSubstr("idle, was jogging, by a limit\n"));
  EXPECT_THAT(log.text(), HasSubstr("program 2 idle, was running, by another host or at the controller\n"));
}

TEST_F(StateLogTest, ReportsNothingFromBeforeItsListener) {
  StateLog states(catalog);
  states.look(now);
  now.restarts = 1;
  states.look(now);
  test::LogReader log;
  states.look(now);
  EXPECT_EQ(log.text(), "");
  now.restarts = 2;
  states.look(now);
  EXPECT_THAT(log.text(), HasSubstr("time 2"));
}

}  // namespace
}  // namespace hw
