// Threads, turns and errors of the interpreter, as somebody at the controller would notice them.
#include <gtest/gtest.h>

#include "fake_controller.h"

namespace hw::arcus::language {
namespace {

using namespace std::chrono_literals;

Workbench running(const std::string& text, const Dialect& dialect = pmx_4ex_sa()) {
  Workbench bench(dialect);
  bench.load(text);
  bench.start();
  return bench;
}

TEST(VmTurns, OneStatementPerThreadAndMillisecond) {
  Workbench bench(pmx_4ex_sa());
  bench.load("PRG 0\nV0=1\nV0=2\nV0=3\nEND\nPRG 1\nV1=1\nV1=2\nV1=3\nEND");
  bench.start(0);
  bench.start(1);
  // A heading costs no turn (AMB-127): the assignments run at 0, 1 and 2 ms.
  for (int ms = 0; ms <= 2; ++ms) {
    bench.run_for(std::chrono::milliseconds(ms) - bench.now.time_since_epoch());
    EXPECT_EQ(bench.vm.variable(0), ms + 1);
    EXPECT_EQ(bench.vm.variable(1), ms + 1);
  }
}

TEST(VmTurns, ProgramZeroGoesFirst) {
  Workbench bench(pmx_4ex_sa());
  bench.load("PRG 1\nV2=V1\nEND\nPRG 0\nV1=5\nEND");  // the order of the text does not matter
  bench.start(1);
  bench.start(0);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(2), 5);
}

TEST(VmTurns, AProgramStartedByAnotherBeginsInTheNextTurn) {
  Workbench bench(pmx_4ex_sa());
  bench.load("PRG 0\nSR1=1\nV3=V1\nV4=V1\nEND\nPRG 1\nV1=7\nEND");
  bench.start(0);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(3), 0);  // program 1 runs V1=7 after program 0 in this turn
  EXPECT_EQ(bench.vm.variable(4), 7);
  EXPECT_EQ(bench.vm.variable(1), 7);
}

TEST(VmTurns, TurnsStandOnWholeMilliseconds) {
  Workbench bench(pmx_4ex_sa());
  bench.load("V1=1\nDELAY=10\nV2=1\nEND");
  bench.run_for(2500us);
  bench.start();
  EXPECT_EQ(bench.vm.next_turn(bench.now, bench.host), Instant(3ms));
  bench.run_for(1600us);  // 4.1 ms: DELAY has run
  EXPECT_EQ(bench.vm.next_turn(bench.now, bench.host), Instant(14ms));
  bench.run_ms(9);
  EXPECT_EQ(bench.vm.variable(2), 0);
  EXPECT_EQ(bench.vm.line(0, bench.now), 1) << "it stands in the DELAY until that is over";
  bench.run_ms(1);
  EXPECT_EQ(bench.vm.variable(2), 1);
  EXPECT_GT(bench.vm.line(0, bench.now), 1);
}

TEST(VmTurns, WaitingForAnAxisCostsNone) {
  Workbench bench = running("X1000000\nWAITX\nV1=1\nEND");  // 1000 s
  bench.run_for(999s);
  EXPECT_EQ(bench.turns, 2);
  EXPECT_FALSE(bench.vm.next_turn(bench.now, bench.host));
  bench.run_for(2s);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

TEST(VmTurns, AnHourOfDelayIsOneTurn) {
  Workbench bench = running("DELAY=3600000\nV1=1\nEND");
  bench.run_for(3599s);
  EXPECT_EQ(bench.turns, 1);
  bench.run_for(2s);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

TEST(VmTurns, AnEmptyControllerNeverAsksForOne) {
  Workbench bench(dmx_k_sa());
  EXPECT_FALSE(bench.vm.next_turn(bench.now, bench.host));
  bench.start();
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
  EXPECT_FALSE(bench.vm.next_turn(bench.now, bench.host));
}

// Loops that only look.

TEST(VmIdleLoop, CostsNothingUntilAnInputChanges) {
  Workbench bench = running("WHILE 1=1\nIF DI1=1\nV1=V1+1\nDELAY=100\nENDIF\nENDWHILE\nEND");
  bench.run_for(3600s);
  EXPECT_LT(bench.turns, 20);
  EXPECT_EQ(bench.vm.variable(1), 0);
  bench.host.set("DI1", 1);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

/// A loop of the same length that cannot idle sees the change at the same millisecond.
TEST(VmIdleLoop, WakesAtTheStatementWhereItWouldBe) {
  const std::string steady = "WHILE 1=1\nIF DI1=1\nV1=1\nSR0=0\nENDIF\nV5=DI2\nDELAY=2\nENDWHILE\nEND";
  const std::string unsteady = "WHILE 1=1\nIF DI1=1\nV1=1\nSR0=0\nENDIF\nV5=PSX\nDELAY=2\nENDWHILE\nEND";
  for (int ms = 20; ms < 40; ++ms) {
    std::array<Instant, 2> seen{};
    for (int which = 0; which < 2; ++which) {
      Workbench bench = running(which == 0 ? steady : unsteady);
      bench.run_for(std::chrono::milliseconds(ms) + 300us);
      bench.host.set("DI1", 1);
      while (bench.vm.variable(1) == 0 && bench.now < Instant(1s)) bench.run_for(100us);
      seen[which] = bench.now;
    }
    EXPECT_EQ(seen[0], seen[1]) << "input changed at " << ms << " ms";
  }
}

TEST(VmIdleLoop, AVariableFromOutsideWakesIt) {
  Workbench bench = running("WHILE V1=0\nENDWHILE\nV2=1\nEND");
  bench.run_for(60s);
  EXPECT_LT(bench.turns, 10);
  bench.vm.set_variable(1, 4);
  bench.run_ms(5);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

TEST(VmIdleLoop, AVariableThatItKeepsWritingIsPutRight) {
  Workbench bench = running("WHILE 1=1\nV1=DI1\nENDWHILE\nEND");
  bench.run_for(60s);
  bench.vm.set_variable(1, 4);
  bench.run_ms(5);
  EXPECT_EQ(bench.vm.variable(1), 0);
}

TEST(VmIdleLoop, AnotherThreadWakesIt) {
  Workbench bench(pmx_4ex_sa());
  bench.load("PRG 0\nWHILE V1=0\nENDWHILE\nV2=1\nEND\nPRG 1\nDELAY=5000\nV1=1\nEND");
  bench.start(0);
  bench.start(1);
  bench.run_for(4990ms);
  EXPECT_LT(bench.turns, 20);
  bench.run_ms(30);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

TEST(VmIdleLoop, LooksThatChangeWithTimeKeepItAwake) {
  Workbench bench = running("WHILE PX<500\nENDWHILE\nV1=PX\nEND");
  bench.run_ms(100);
  EXPECT_GT(bench.turns, 90);
}

TEST(VmIdleLoop, PauseAndContinueWithinIt) {
  Workbench bench = running("WHILE DI1=0\nENDWHILE\nV1=1\nEND");
  bench.run_for(1s);
  bench.vm.control(0, 2, bench.now);
  bench.host.set("DI1", 1);
  bench.run_for(1s);
  EXPECT_EQ(bench.vm.variable(1), 0);
  bench.vm.control(0, 3, bench.now);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

/// Where a loop that idles is told to be, against one of the same length that cannot idle.
TEST(VmIdleLoop, ReportsTheLineWhereItWouldBe) {
  const std::string steady = "WHILE 1=1\nV5=DI2\nIF DI1=1\nV1=1\nENDIF\nDELAY=7\nENDWHILE\nEND";
  const std::string unsteady = "WHILE 1=1\nV5=PSX\nIF DI1=1\nV1=1\nENDIF\nDELAY=7\nENDWHILE\nEND";
  Workbench idles = running(steady), works = running(unsteady);
  idles.run_for(50us);  // between two turns
  works.run_for(50us);
  for (int tenth_ms = 0; tenth_ms < 600; ++tenth_ms) {
    EXPECT_EQ(idles.source_line(0), works.source_line(0)) << tenth_ms / 10.0 << " ms";
    idles.run_for(100us);
    works.run_for(100us);
  }
}

TEST(VmIdleLoop, StandsInItsDelayForHoursWithoutTurns) {
  Workbench bench = running("WHILE DI1=0\nDELAY=200\nENDWHILE\nEND");
  int in_delay = 0;
  for (int i = 0; i < 1000; ++i) {
    bench.run_for(7919ms);
    in_delay += bench.source_line(0) == 2;
  }
  EXPECT_GT(in_delay, 950);
  EXPECT_LT(bench.turns, 20);
}

TEST(VmIdleLoop, HeldInItsDelayItStaysThere) {
  Workbench bench = running("WHILE DI1=0\nDELAY=200\nENDWHILE\nV1=1\nEND");
  bench.run_for(60s + 50ms);
  ASSERT_EQ(bench.source_line(0), 2);
  bench.vm.control(0, 2, bench.now);
  bench.run_for(1s);
  EXPECT_EQ(bench.source_line(0), 2);
  bench.host.set("DI1", 1);
  bench.vm.control(0, 3, bench.now);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

// States (AMB-115).

TEST(VmStates, RunOnARunningProgramChangesNothing) {
  Workbench bench = running("V1=V1+1\nDELAY=100\nV2=1\nEND");
  bench.run_ms(50);
  bench.start();
  bench.run_ms(60);
  EXPECT_EQ(bench.vm.variable(1), 1);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

TEST(VmStates, PauseContinueStopRun) {
  Workbench bench = running("V1=1\nDELAY=10\nV1=2\nDELAY=10\nV1=3\nEND");
  bench.run_ms(5);
  bench.vm.control(0, 3, bench.now);  // continue: not paused, no effect
  EXPECT_EQ(bench.vm.state(0), ThreadState::running);
  bench.vm.control(0, 2, bench.now);
  EXPECT_EQ(bench.vm.state(0), ThreadState::paused);
  bench.run_ms(100);
  EXPECT_EQ(bench.vm.variable(1), 1);
  bench.vm.control(0, 3, bench.now);
  bench.run_ms(5);
  EXPECT_EQ(bench.vm.variable(1), 2);
  bench.vm.control(0, 0, bench.now);
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
  bench.vm.control(0, 2, bench.now);  // pause: not running, no effect
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
  bench.start();
  bench.run_ms(2);
  EXPECT_EQ(bench.vm.variable(1), 1);
  bench.run_ms(100);
  EXPECT_EQ(bench.vm.variable(1), 3);
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
}

TEST(VmStates, StopEndsTheProgramAndNotTheMotion) {
  Workbench bench = running("X1000\nWAITX\nV1=1\nEND");
  bench.run_ms(10);
  bench.vm.control(0, 0, bench.now);
  bench.run_for(2s);
  EXPECT_EQ(bench.host.position(0), 1000);
  EXPECT_EQ(bench.vm.variable(1), 0);
}

TEST(VmStates, AProgramCanStopAndPauseItself) {
  Workbench bench(pmx_4ex_sa());
  bench.load("PRG 0\nSR0=2\nV1=1\nSR0=0\nV1=2\nEND");
  bench.start();
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.state(0), ThreadState::paused);
  EXPECT_EQ(bench.vm.variable(1), 0);
  bench.vm.control(0, 3, bench.now);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

TEST(VmStates, TheProgramCounterNamesTheLineToCome) {
  Workbench bench = running("V1=1\nX100Y100\nWAITX\nV1=2\nEND");
  EXPECT_EQ(bench.vm.line(0, bench.now), 0);
  bench.run_ms(50);
  EXPECT_EQ(bench.vm.line(0, bench.now), 3);  // WAITX behind the two lines of the move
  EXPECT_EQ(bench.source_line(0), 3);
}

TEST(VmStates, LoadingStopsEverythingAndKeepsVariables) {
  Workbench bench = running("V1=5\nWHILE 1=1\nENDWHILE\nEND");
  bench.run_ms(10);
  bench.load("V2=V1\nEND");
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
  bench.start();
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(2), 5);
}

// Subroutines over the wire (AMB-046).

TEST(VmCall, RunsBesideThePrograms) {
  Workbench bench = running("WHILE 1=1\nV1=V1+1\nENDWHILE\nEND\nSUB 4\nV2=1\nDELAY=50\nV2=2\nENDSUB");
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.call(4, bench.now), Vm::Call::started);
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.call(4, bench.now), Vm::Call::busy);
  EXPECT_EQ(bench.vm.call_state(), ThreadState::running);
  EXPECT_EQ(bench.vm.variable(2), 1);
  bench.run_ms(60);
  EXPECT_EQ(bench.vm.variable(2), 2);
  EXPECT_EQ(bench.vm.call_state(), ThreadState::stopped);
  EXPECT_EQ(bench.vm.state(0), ThreadState::running);
  EXPECT_EQ(bench.vm.call(5, bench.now), Vm::Call::undefined);
  EXPECT_EQ(bench.vm.call(32, bench.now), Vm::Call::undefined);
  EXPECT_EQ(bench.vm.call(4, bench.now), Vm::Call::started);
}

TEST(VmCall, MayNestEightGosubs) {
  std::string text = "END\n";
  for (int i = 0; i < 8; ++i)
    text += "SUB " + std::to_string(i) + "\nGOSUB " + std::to_string(i + 1) + "\nENDSUB\n";
  Workbench bench(pmx_4ex_sa());
  bench.load(text + "SUB 8\nV1=1\nENDSUB");
  bench.vm.call(0, bench.now);
  bench.run_ms(50);
  EXPECT_EQ(bench.vm.variable(1), 1);
  EXPECT_EQ(bench.vm.call_state(), ThreadState::stopped);
}

// Errors (AMB-117, 118).

constexpr const char* with_handler = "V1=V1+1\nX100\nWAITX\nV2=1\nEND\nSUB 31\nV3=V3+1\nECLEARX\nENDSUB";

TEST(VmErrors, TheHandlerReturnsToTheLineThatFailed) {
  Workbench bench = running(with_handler);
  bench.run_ms(20);
  bench.host.error[0] = true;
  bench.run_ms(200);
  EXPECT_EQ(bench.vm.variable(3), 1);
  EXPECT_EQ(bench.vm.variable(2), 1);
  EXPECT_EQ(bench.vm.variable(1), 1);
  EXPECT_EQ(bench.vm.trouble(0), Trouble::axis_in_error);
}

TEST(VmErrors, OrToTheFirstLineWhenSoConfigured) {
  Workbench bench = running(with_handler);
  bench.host.returns_to_start = true;
  bench.run_ms(20);
  bench.host.error[0] = true;
  bench.run_ms(300);
  EXPECT_EQ(bench.vm.variable(3), 1);
  EXPECT_EQ(bench.vm.variable(1), 2);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

TEST(VmErrors, ReturningToTheStartForgetsTheCalls) {
  Workbench bench = running(
      "V1=V1+1\nIF V1=1\nGOSUB 1\nENDIF\nV2=1\nEND\nSUB 1\nX100\nWAITX\nV4=1\nENDSUB\n"
      "SUB 31\nECLEARX\nENDSUB");
  bench.host.returns_to_start = true;
  bench.run_ms(20);
  bench.host.error[0] = true;
  bench.run_ms(300);
  EXPECT_EQ(bench.vm.variable(1), 2);
  EXPECT_EQ(bench.vm.variable(2), 1);
  EXPECT_EQ(bench.vm.variable(4), 0);
  EXPECT_EQ(bench.vm.state(0), ThreadState::stopped);
}

TEST(VmErrors, WithoutAHandlerTheProgramStopsWhereItFailed) {
  Workbench bench = running("V1=1\nX100\nWAITX\nV2=1\nEND");
  bench.run_ms(20);
  bench.host.error[0] = true;
  bench.run_ms(20);
  EXPECT_EQ(bench.vm.state(0), ThreadState::error);
  EXPECT_EQ(bench.source_line(0), 3);
  EXPECT_EQ(bench.vm.variable(2), 0);
  bench.host.error[0] = false;
  bench.start();  // from the first line
  bench.run_for(1s);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

TEST(VmErrors, AnErrorWithinTheHandlerEndsInError) {
  Workbench bench = running("X100\nWAITX\nEND\nSUB 31\nV1=1\nX0\nV2=1\nENDSUB");
  bench.host.error[0] = true;
  bench.run_ms(50);
  EXPECT_EQ(bench.vm.variable(1), 1);
  EXPECT_EQ(bench.vm.variable(2), 0);
  EXPECT_EQ(bench.vm.state(0), ThreadState::error);
  EXPECT_EQ(bench.source_line(0), 6);
}

TEST(VmErrors, OnlyTheThreadThatNeedsTheAxisJumps) {
  Workbench bench(pmx_4ex_sa());
  bench.load("PRG 0\nX100\nWAITX\nEND\nPRG 1\nY100\nWAITY\nV1=1\nEND\nSUB 31\nV2=V2+1\nDELAY=1000\nENDSUB");
  bench.start(0);
  bench.start(1);
  bench.run_ms(10);
  bench.host.error[0] = true;
  bench.run_ms(200);
  EXPECT_EQ(bench.vm.variable(1), 1);
  EXPECT_EQ(bench.vm.variable(2), 1);
}

TEST(VmErrors, ARefusedMoveIsAProgramError) {
  Workbench bench(pmx_4ex_sa());
  bench.load("X100\nV1=1\nEND");
  bench.host.refuses_moves = true;
  bench.start();
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.state(0), ThreadState::error);
  EXPECT_EQ(bench.vm.trouble(0), Trouble::refused);
}

TEST(VmErrors, AValueOutOfRangeInAVariableIsAProgramError) {
  Workbench bench = running("V1=0-5\nHSPD=V1\nV2=1\nEND");
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.state(0), ThreadState::error);
  EXPECT_EQ(bench.vm.variable(2), 0);
}

TEST(VmErrors, ABusyControllerHoldsTheStatement) {
  Workbench bench(pmx_4ex_sa());
  bench.load("X100\nV1=1\nEND");
  bench.host.busy = true;
  bench.start();
  bench.run_ms(100);
  EXPECT_EQ(bench.vm.variable(1), 0);
  bench.host.busy = false;
  bench.run_ms(5);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

TEST(VmErrors, AnInterpolatedMoveWaitsForEachOfItsAxes) {
  Workbench bench = running("Y100\nX10Y20\nV1=1\nEND");
  bench.run_ms(90);
  EXPECT_EQ(bench.vm.variable(1), 0);
  bench.run_ms(20);
  EXPECT_EQ(bench.vm.variable(1), 1);
}

TEST(VmErrors, LinesThatMeanNothingStopTheThread) {
  Workbench bench(pmx_4ex_sa());
  bench.vm.load(std::make_shared<const Program>(decode({"SET,V1,1", "HELLO", "END"}, pmx_4ex_sa())));
  bench.start();
  bench.run_ms(10);
  EXPECT_EQ(bench.vm.variable(1), 1);
  EXPECT_EQ(bench.vm.state(0), ThreadState::error);
  EXPECT_EQ(bench.vm.line(0, bench.now), 1);
  EXPECT_EQ(bench.vm.trouble(0), Trouble::bad_line);
}

TEST(Vm, ACopyGoesItsOwnWay) {
  Workbench bench = running("WHILE V1<100\nV1=V1+1\nENDWHILE\nEND");
  bench.run_ms(30);
  const Vm saved = bench.vm;
  const int then = saved.variable(1);
  bench.run_ms(1000);
  EXPECT_EQ(bench.vm.variable(1), 100);
  EXPECT_EQ(saved.variable(1), then);
}

}  // namespace
}  // namespace hw::arcus::language
