// WAIT, and what moves together with the axis that is waited for (AMB-114).
#include <gtest/gtest.h>

#include "fake_controller.h"

namespace hw::arcus::language {
namespace {

using namespace std::chrono_literals;

Workbench at_work(const std::string& text) {
  Workbench bench(pmx_4ex_sa());
  bench.load(text);
  bench.start();
  return bench;
}

TEST(VmWait, WaitingForOneAxisOfALinearMoveSeesTheErrorOfAnother) {
  Workbench bench = at_work("X1000Y1000\nWAITY\nV1=1\nEND");
  bench.run_ms(20);
  bench.host.error[0] = true;
  bench.run_for(60s);
  EXPECT_EQ(bench.vm.state(0), ThreadState::error);
  EXPECT_EQ(bench.vm.trouble(0), Trouble::axis_in_error);
  EXPECT_EQ(bench.vm.variable(1), 0);
}

TEST(VmWait, AMoveOfItsOwnEndsWhatAnAxisHadInCommon) {
  Workbench bench = at_work("X1000Y1000\nWAITX\nX0\nWAITY\nV1=1\nEND");
  bench.run_for(60s);
  bench.vm.set_variable(1, 0);
  bench.start();
  while (bench.vm.variable(1) == 0 && bench.source_line(0) < 4) bench.run_ms(1);
  bench.host.error[0] = true;
  bench.run_for(60s);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

TEST(VmWait, AnErrorSubroutineWaitsForItsOwnAxis) {
  Workbench bench = at_work("X1000Y1000\nWAITX\nEND\nSUB 31\nWAITX\nECLEARY\nV2=1\nSR0=0\nENDSUB");
  bench.run_ms(20);
  bench.host.error[1] = true;
  bench.run_for(60s);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

}  // namespace
}  // namespace hw::arcus::language
