// What a pump decides is logged with its reason: --log pump=debug.
#include <gmock/gmock.h>

#include "tests/core/base/log_reader.h"
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using ::testing::HasSubstr;

class DriverLog : public DriverTest {
 protected:
  DriverLog() { start(); }
  test::LogReader log;
};

TEST_F(DriverLog, AStopFromItsAskingToItsEnd) {
  post(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000)));
  hold(5);
  post(intent::Stop());
  ASSERT_TRUE(wait_idle());
  for (const char* line : {"requested; waiting commands are dropped, and the command under way ends",
                           "is sent, time 1", "is over"})
    EXPECT_THAT(log.text(), HasSubstr(line));
}

TEST_F(DriverLog, AJogWithoutKeepAlives) {
  post(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000)));
  hold(3);
  run(1);
  EXPECT_THAT(log.text(), HasSubstr("pump: vxm: the jog was not kept alive for 250 ms"));
}

TEST_F(DriverLog, ARefusalAndWhatWasDropped) {
  EXPECT_NE(perform(intent::Home(AxisId{7}, Sign::plus)), "");
  EXPECT_THAT(log.text(), HasSubstr("not done: "));
  post(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000)));
  post(intent::Store());
  post(intent::Stop());
  run(2);
  EXPECT_THAT(log.text(), HasSubstr("the waiting commands are dropped: "));
}

TEST_F(DriverLog, ALossAndTheNextAttempt) {
  port_missing = true;
  loop->pull();
  run(3);
  EXPECT_THAT(log.text(), HasSubstr("pump: vxm: lost: "));
  EXPECT_THAT(log.text(), HasSubstr("pump: vxm: the next attempt to connect is in "));
  port_missing = false;
}

}  // namespace
}  // namespace hw::vxm
