// A board behind the in-process window: time, faults of the bus, interrupts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/time/virtual_scheduler.h"
#include "tests/transports/toy_board.h"
#include "transports/serve.h"

namespace hw {
namespace {

using test::ToyBoard;
using test::WindowEar;
using testing::ElementsAre;

class ServeBus : public testing::Test {
 protected:
  void SetUp() override {
    auto toy = std::make_unique<ToyBoard>();
    board = toy.get();
    HostOptions options;
    options.name = "toy board";
    host = *EmulatorHost::make(clock, std::move(toy), std::move(options));
    window = *host->plug_in_window();
  }
  static Task<> run_and_report(Window& window, std::vector<BusCycle>& cycles, Result<>& result, bool& ended) {
    result = co_await window.run(cycles);
    ended = true;
  }
  Result<> run(std::vector<BusCycle>& cycles) {
    Result<> result;
    bool ended = false;
    asio::co_spawn(io, run_and_report(*window, cycles, result, ended), asio::detached);
    clock.run_for(Duration::zero());
    EXPECT_TRUE(ended);
    return result;
  }
  std::uint32_t read(std::uint8_t bytes, std::uint16_t offset) {
    std::vector<BusCycle> one{BusCycle::read(bytes, offset)};
    EXPECT_TRUE(run(one));
    return one[0].value;
  }

  IoContext io{1};
  VirtualScheduler clock{io};
  ToyBoard* board = nullptr;
  std::shared_ptr<EmulatorHost> host;
  std::unique_ptr<Window> window;
};

TEST_F(ServeBus, RunsABurstInItsOrderAndPutsValuesInPlace) {
  std::vector<BusCycle> burst{BusCycle::store(2, 0x804, 0x41), BusCycle::read(2, 0x804),
                              BusCycle::store(1, 0x10, 7), BusCycle::read(1, 0x10)};
  ASSERT_TRUE(run(burst));
  EXPECT_EQ(burst[1].value, 0x41u);
  EXPECT_EQ(burst[3].value, 7u);
  EXPECT_THAT(board->cycles, ElementsAre("w16 804 0041", "r16 804", "w8 010 07", "r8 010"));
}

TEST_F(ServeBus, ThirtyTwoBitsAreTwoCyclesHighHalfFirst) {
  std::vector<BusCycle> burst{BusCycle::store(4, 0x400, 0xFFFEDCBA), BusCycle::read(4, 0x400)};
  ASSERT_TRUE(run(burst));
  EXPECT_EQ(burst[1].value, 0xFFFEDCBAu);
  EXPECT_THAT(board->cycles, ElementsAre("w16 400 FFFE", "w16 402 DCBA", "r16 400", "r16 402"));
}

TEST_F(ServeBus, ReadingARegisterClearsIt) {
  board->memory[ToyBoard::clearing] = 0x21;
  EXPECT_EQ(read(1, ToyBoard::clearing), 0x21u);
  EXPECT_EQ(read(1, ToyBoard::clearing), 0u);
}

TEST_F(ServeBus, AnInterruptReachesTheHostOnce) {
  WindowEar ear(*window);
  EXPECT_TRUE(window->reports_interrupts());
  std::vector<BusCycle> burst{BusCycle::store(1, ToyBoard::clearing, 0xB4)};
  ASSERT_TRUE(run(burst));
  clock.run_for(Millis(4));
  EXPECT_TRUE(ear.vectors.empty());
  clock.run_for(Millis(100));
  EXPECT_THAT(ear.vectors, ElementsAre(0xB4));
}

TEST_F(ServeBus, APulledCableClosesTheWindowAndOpensAgainAsTheSameBoard) {
  WindowEar ear(*window);
  board->memory[5] = 5;
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(true)));
  clock.run_for(Millis(1));
  ASSERT_TRUE(ear.gone);
  EXPECT_THAT(ear.gone->what, testing::HasSubstr("toy board was pulled"));
  std::vector<BusCycle> burst{BusCycle::read(1, 5)};
  EXPECT_FALSE(run(burst));
  EXPECT_FALSE(host->plug_in_window());
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(false)));
  auto again = host->plug_in_window();
  ASSERT_TRUE(again);
  Result<> result;
  bool ended = false;
  asio::co_spawn(io, run_and_report(**again, burst, result, ended), asio::detached);
  clock.run_for(Duration::zero());
  EXPECT_EQ(burst[0].value, 5u);
}

TEST_F(ServeBus, DroppedCyclesReadOnesAndGarbledOnesReadWrong) {
  board->memory[5] = 5;
  ASSERT_TRUE(host->bench()->operate(bench::Drop(1)));
  EXPECT_EQ(read(1, 5), 0xFFu);
  EXPECT_EQ(read(1, 5), 5u);
  ASSERT_TRUE(host->bench()->operate(bench::Garble(2)));
  EXPECT_NE(read(2, 4), 5u);
  EXPECT_EQ(read(2, 4), 5u);
}

}  // namespace
}  // namespace hw
